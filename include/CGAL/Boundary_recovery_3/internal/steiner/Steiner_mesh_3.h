// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <array>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * What all that deals with Steiner points shares: the mesh and who changes it, the predicates, which know the exact
 * positions in the ledger, the constraints, the ledger, and the context of the run.
 */
template <typename Tr_>
struct Steiner_mesh_3
{
  typedef Tr_                              Tr;
  typedef typename Tr::Vertex_handle       Vertex_handle;
  typedef typename Tr::Cell_handle         Cell_handle;
  typedef std::array<Vertex_handle, 2>     Vertex_pair;
  typedef std::array<Vertex_handle, 3>     Vertex_triple;
  typedef std::vector<Vertex_handle>       Vertices;
  typedef Mesh_editor_3<Tr>                Editor;
  typedef Vertex_predicates_3<Tr>          Predicates;
  typedef Constraints_3<Tr>                Constraints;
  typedef Steiner_ledger_3<Tr>             Ledger;
  typedef Recovery_context<Tr>             Context;
  typedef Exact_positions_3<Tr>            Positions;
  typedef typename Positions::Exact_point_3 Exact_point;

  Steiner_mesh_3(Editor& editor, const Predicates& predicates, const Constraints& constraints, Ledger& ledger,
                 Context& context)
    : editor(editor), tr(editor.triangulation()), predicates(predicates), constraints(constraints), ledger(ledger),
      positions(ledger.positions()), context(context)
  { }

  Editor& editor;
  const Tr& tr;
  const Predicates& predicates;
  const Constraints& constraints;
  Ledger& ledger;
  Positions& positions; // those in the ledger
  Context& context;
};

// Replaces cells by tetrahedra, as `Mesh_editor_3` does. The Steiner points in `dropped` go with the cells, and are
// taken out of the ledger.
template <typename Editor, typename Ledger, typename TetrahedronRange>
void replace_and_forget(Editor& editor, Ledger& ledger, const std::vector<typename Editor::Tr::Cell_handle>& cells,
                        const TetrahedronRange& tetrahedra,
                        const std::vector<typename Editor::Tr::Vertex_handle>& dropped)
{
  for(const typename Editor::Tr::Vertex_handle v : dropped)
    ledger.erase(v);
  editor.replace(cells, tetrahedra, dropped);
}

// Stars a cavity from v, one of the points inside; the others, all of them free Steiner points, are gone then.
template <typename Editor, typename Ledger, typename Cavity>
void star_and_forget(Editor& editor, Ledger& ledger, Cavity& cavity, const typename Editor::Tr::Vertex_handle v)
{
  for(const typename Editor::Tr::Vertex_handle w : cavity.inner_vertices())
    if(w != v)
      ledger.erase(w);
  internal::star_cavity(editor, cavity, v);
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_MESH_3_H
