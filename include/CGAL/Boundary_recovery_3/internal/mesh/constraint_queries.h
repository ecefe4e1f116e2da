// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINT_QUERIES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINT_QUERIES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * What can be asked of any set of constraints that answers `is_constrained()` for two vertices of a cell and for three.
 */

// Appends the constraints that are edges or facets of the given cells. Some come more than once.
template <typename Constraints, typename CellRange, typename Vertex_handle>
void collect_constraints(const Constraints& constraints, const CellRange& cells,
                         std::vector<std::array<Vertex_handle, 2> >& edges,
                         std::vector<std::array<Vertex_handle, 3> >& facets)
{
  for(const auto c : cells)
    for(int i = 0; i < 4; ++i)
    {
      const std::array<Vertex_handle, 3> f = internal::facet_vertices(c, i);
      if(constraints.is_constrained(f[0], f[1], f[2]))
        facets.push_back(f);
      for(int j = i + 1; j < 4; ++j)
        if(constraints.is_constrained(c->vertex(i), c->vertex(j)))
          edges.push_back({{ c->vertex(i), c->vertex(j) }});
    }
}

// Whether an edge or a facet at v is constrained; `ball` are the cells around v. If so, v must not be removed.
template <typename Constraints, typename CellRange, typename Vertex_handle>
bool has_constraint_at(const Constraints& constraints, const CellRange& ball, const Vertex_handle v)
{
  return std::any_of(ball.begin(), ball.end(), [&](const auto c)
  {
    for(int i = 0; i < 4; ++i)
    {
      const std::array<Vertex_handle, 3> f = internal::facet_vertices(c, i);
      if(c->vertex(i) != v && (constraints.is_constrained(c->vertex(i), v)
                               || constraints.is_constrained(f[0], f[1], f[2])))
        return true;
    }
    return false;
  });
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINT_QUERIES_H
