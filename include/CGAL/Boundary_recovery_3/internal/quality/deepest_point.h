// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_DEEPEST_POINT_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_DEEPEST_POINT_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Visibility_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>

#include <array>
#include <optional>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// The deepest point of the visibility kernel of a polyhedron, maybe outside if there is no kernel. Each of the faces
// has the polyhedron on its positive side; the origin is a point near them.
template <typename Tr>
std::optional<Coordinates_3> deepest_point(const Tr& tr,
                                           const std::vector<std::array<typename Tr::Vertex_handle, 3>>& faces,
                                           const Coordinates_3& origin)
{
  typedef typename Vertex_predicates_3<Tr>::Approximate_point Point;
  const Vertex_predicates_3<Tr> predicates(tr);
  const Visibility_kernel_3<Tr> kernel(predicates, faces, Point(origin[0], origin[1], origin[2]));
  const std::optional<Point> deepest = kernel.deepest_point([](const Point&) { return true; });
  if(! deepest)
    return std::nullopt;
  return Coordinates_3{{ deepest->x(), deepest->y(), deepest->z() }};
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_DEEPEST_POINT_H
