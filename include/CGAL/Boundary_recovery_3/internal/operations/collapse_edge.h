// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_COLLAPSE_EDGE_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_COLLAPSE_EDGE_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Whether x, a neighbor of v, sees all of the ball of v from inside: then v can be collapsed onto x, if there is no
// constraint at v, see `has_constraint_at()`. `ball` are the cells around v, all of which are finite.
template <typename Predicates, typename CellRange, typename Vertex_handle>
bool is_ball_seen(const Predicates& predicates, const CellRange& ball, const Vertex_handle v, const Vertex_handle x)
{
  return std::all_of(ball.begin(), ball.end(), [&](const auto c)
  {
    if(c->has_vertex(x))
      return true;
    const std::array<Vertex_handle, 4> t = internal::with_exchanged_vertex(c, v, x);
    return predicates.orientation(t[0], t[1], t[2], t[3]) == POSITIVE;
  });
}

// The tetrahedra that fill the ball of v when v is collapsed onto x.
template <typename CellRange, typename Vertex_handle>
std::vector<std::array<Vertex_handle, 4> > collapsed_ball(const CellRange& ball, const Vertex_handle v,
                                                          const Vertex_handle x)
{
  std::vector<std::array<Vertex_handle, 4> > tetrahedra;
  for(const auto c : ball)
    if(! c->has_vertex(x))
      tetrahedra.push_back(internal::with_exchanged_vertex(c, v, x));
  return tetrahedra;
}

// Collapses the edge from v to x, which sees the ball of v: the ball is starred from x, and v is gone. It contains the
// 4-1 flip. `editor` changes the mesh, see `Mesh_editor_3`, and can take it back.
template <typename Editor, typename CellRange>
void collapse_edge(Editor& editor, const CellRange& ball, const typename Editor::Tr::Vertex_handle v,
                   const typename Editor::Tr::Vertex_handle x)
{
  editor.replace(ball, internal::collapsed_ball(ball, v, x),
                 std::array<typename Editor::Tr::Vertex_handle, 1>{{ v }});
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_COLLAPSE_EDGE_H
