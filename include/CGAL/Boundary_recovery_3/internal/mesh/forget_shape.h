// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FORGET_SHAPE_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FORGET_SHAPE_H

#include <CGAL/license/Boundary_recovery_3.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Cells of Mesh_3 and of the remeshing remember their circumcenters and qualities.
template <typename Cell>
auto forget_circumcenter(Cell& c, int) -> decltype(c.invalidate_weighted_circumcenter_cache())
{
  c.invalidate_weighted_circumcenter_cache();
}

template <typename Cell>
void forget_circumcenter(Cell&, long) { }

template <typename Cell>
auto forget_quality(Cell& c, int) -> decltype(c.reset_cache_validity())
{
  c.reset_cache_validity();
}

template <typename Cell>
void forget_quality(Cell&, long) { }

// To be called for each cell at a vertex that moved.
template <typename Cell>
void forget_shape(Cell& c)
{
  internal::forget_circumcenter(c, 0);
  internal::forget_quality(c, 0);
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FORGET_SHAPE_H
