// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_SPLIT_SIMPLEX_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_SPLIT_SIMPLEX_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>

#include <array>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Splits the edge ab of the cell c by v, a vertex that is in no cell yet: two cells come in the place of each of those
// around the edge. If ab is on the hull, v has to be on it exactly, else it has to see the whole shell from inside.
//
// `editor` changes the mesh, see `Mesh_editor_3`: it tells visitors, which can carry data of the cells over, and can
// take the split back.
template <typename Editor>
void split_edge(Editor& editor, const typename Editor::Tr::Cell_handle c, const typename Editor::Tr::Vertex_handle a,
                const typename Editor::Tr::Vertex_handle b, const typename Editor::Tr::Vertex_handle v)
{
  typedef typename Editor::Tr Tr;
  const Shell_3<Tr> shell(editor.triangulation(), c, c->index(a), c->index(b));
  std::vector<std::array<typename Tr::Vertex_handle, 4> > tetrahedra;
  tetrahedra.reserve(2 * shell.degree());
  for(const typename Tr::Cell_handle cell : shell.cells())
  {
    tetrahedra.push_back(internal::with_exchanged_vertex(cell, a, v));
    tetrahedra.push_back(internal::with_exchanged_vertex(cell, b, v));
  }
  editor.replace(shell.cells(), tetrahedra);
}

// As above; an edge that is constrained is split among the constraints, too. Those that are marked in cells know an
// edge only as long as it is in the mesh.
template <typename Editor, typename Constraints>
void split_edge(Editor& editor, Constraints& constraints, const typename Editor::Tr::Cell_handle c,
                const typename Editor::Tr::Vertex_handle a, const typename Editor::Tr::Vertex_handle b,
                const typename Editor::Tr::Vertex_handle v)
{
  const bool is_constrained = constraints.is_constrained(a, b);
  internal::split_edge(editor, c, a, b, v);
  if(is_constrained)
    constraints.split(a, b, v);
}

// Splits the facet of the cell c with the given vertices by v, a vertex that is in no cell yet: three cells come in the
// place of each of both at it. v has to be in the interior of the facet, or, if that is not on the hull, of both cells.
//
// `editor` changes the mesh, see `Mesh_editor_3`: it tells visitors, which can carry data of the cells over, and can
// take the split back.
template <typename Editor>
void split_facet(Editor& editor, const typename Editor::Tr::Cell_handle c,
                 const std::array<typename Editor::Tr::Vertex_handle, 3>& facet,
                 const typename Editor::Tr::Vertex_handle v)
{
  typedef typename Editor::Tr Tr;
  const std::array<typename Tr::Cell_handle, 2> cells
    = {{ c, c->neighbor(internal::index_of_opposite_vertex(c, facet)) }};
  std::vector<std::array<typename Tr::Vertex_handle, 4> > tetrahedra;
  for(const typename Tr::Cell_handle cell : cells)
    for(const typename Tr::Vertex_handle replaced : facet)
      tetrahedra.push_back(internal::with_exchanged_vertex(cell, replaced, v));
  editor.replace(cells, tetrahedra);
}

// As above; a facet that is constrained is split among the constraints, too. Those that are marked in cells know a
// facet only as long as it is in the mesh.
template <typename Editor, typename Constraints>
void split_facet(Editor& editor, Constraints& constraints, const typename Editor::Tr::Cell_handle c,
                 const std::array<typename Editor::Tr::Vertex_handle, 3>& facet,
                 const typename Editor::Tr::Vertex_handle v)
{
  const bool is_constrained = constraints.is_constrained(facet[0], facet[1], facet[2]);
  internal::split_facet(editor, c, facet, v);
  if(is_constrained)
    constraints.split(facet[0], facet[1], facet[2], v);
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_SPLIT_SIMPLEX_H
