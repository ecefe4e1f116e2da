// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REPLACE_AND_FORGET_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REPLACE_AND_FORGET_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>

#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REPLACE_AND_FORGET_H
