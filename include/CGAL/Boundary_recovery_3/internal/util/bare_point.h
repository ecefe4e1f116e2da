// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BARE_POINT_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BARE_POINT_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <type_traits>

namespace CGAL::Boundary_recovery_3::internal {

// A point without its weight, if it has one, as those of Mesh_3 have.
template <typename Point_3, typename Point>
const Point_3& bare_point(const Point& p)
{
  if constexpr(std::is_same<Point, Point_3>::value)
    return p;
  else
    return p.point();
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BARE_POINT_H
