// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_VALIDITY_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_VALIDITY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Whether no hull facet beside that of an infinite cell is in front of it.
template <typename Tr, typename Predicates>
bool is_hull_convex_at(const Tr& tr, const Predicates& predicates, const typename Tr::Cell_handle c)
{
  const int infinite = c->index(tr.infinite_vertex());
  for(int i = 0; i < 4; ++i)
  {
    if(i == infinite)
      continue;
    std::array<typename Tr::Vertex_handle, 4> v = {{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }};
    v[infinite] = tr.mirror_vertex(c, i);
    if(predicates.orientation(v[0], v[1], v[2], v[3]) == POSITIVE)
      return false;
  }
  return true;
}

template <typename Predicates, typename Cell_handle>
bool is_positive(const Predicates& predicates, const Cell_handle c)
{
  return predicates.orientation(c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)) == POSITIVE;
}

// Whether a finite cell is positively oriented, or the convex hull is convex at the facet of an infinite one.
template <typename Tr, typename Predicates>
bool is_cell_valid(const Tr& tr, const Predicates& predicates, const typename Tr::Cell_handle c)
{
  return tr.is_infinite(c) ? internal::is_hull_convex_at(tr, predicates, c) : internal::is_positive(predicates, c);
}

// Whether a 3-dimensional triangulation is valid where vertices are at the positions that the predicates know, which
// `tr.is_valid()` does not. It looks at every cell: for expensive assertions.
template <typename Tr, typename Predicates>
bool is_mesh_valid(const Tr& tr, const Predicates& predicates)
{
  const auto cells = tr.all_cell_handles();
  return tr.tds().is_valid()
      && std::all_of(cells.begin(), cells.end(), [&](const typename Tr::Cell_handle c)
         {
           return internal::is_cell_valid(tr, predicates, c);
         });
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_VALIDITY_H
