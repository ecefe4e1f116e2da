// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_REPRESENTABLE_POINT_IN_KERNEL_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_REPRESENTABLE_POINT_IN_KERNEL_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/numbers/Representable_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Appends planes that have the points with no coordinate farther than `radius` from that of the center on their
// negative sides.
template <typename Plane_3, typename Point_3>
void add_box(const Point_3& center, const double radius, std::vector<Plane_3>& planes)
{
  for(const int sign : { 1, -1 })
    for(int i = 0; i < 3; ++i)
      planes.emplace_back(i == 0 ? sign : 0, i == 1 ? sign : 0, i == 2 ? sign : 0,
                          Rational(- Rational(sign) * center[i] - Rational(radius)));
}

// Those through the faces, of which each has the polyhedron on its positive side, with the kernel on their negative
// sides.
template <typename Positions, typename FaceRange>
std::vector<typename Representable_point_3<Rational>::Plane_3>
planes_of_kernel(const Positions& positions, const FaceRange& faces)
{
  std::vector<typename Representable_point_3<Rational>::Plane_3> planes;
  for(const auto& f : faces)
    planes.emplace_back(positions(f[0]), positions(f[2]), positions(f[1]));
  return planes;
}

// Finds a point with coordinates of type `double` in the open visibility kernel of a polyhedron, with none of them
// farther than `radius` from that of `inside`, an exact point of the open kernel. Each of the faces has the polyhedron
// on its positive side. This is slow, but decides whether there is such a point, up to what `Representable_point_3`
// does not look at. With exact kernels, all points can be stored, and this is not to be called.
template <typename Positions, typename FaceRange>
std::optional<std::array<double, 3> >
representable_point_in_kernel(const Positions& positions, const FaceRange& faces,
                              const typename Positions::Exact_point_3& inside, const double radius)
{
  auto planes = internal::planes_of_kernel(positions, faces);
  if(std::isfinite(radius))
    internal::add_box(inside, radius, planes);
  return Representable_point_3<Rational>()(planes);
}

// Finds an exact point that is well inside the open visibility kernel of such a polyhedron.
template <typename Positions, typename FaceRange>
std::optional<typename Positions::Exact_point_3>
center_of_kernel(const Positions& positions, const FaceRange& faces)
{
  return Representable_point_3<Rational>().center(internal::planes_of_kernel(positions, faces));
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_REPRESENTABLE_POINT_IN_KERNEL_H
