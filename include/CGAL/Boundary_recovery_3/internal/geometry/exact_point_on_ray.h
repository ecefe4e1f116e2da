// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POINT_ON_RAY_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POINT_ON_RAY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Is_in_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>

#include <CGAL/Origin.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// How many points on a ray are tried, each four times nearer to its origin: far beyond the range of `double`.
constexpr int max_number_of_points_on_ray = 2000;

// The number of points that `next` returns before one from which no face is hidden.
template <typename FaceRange, typename Next, typename Is_hidden>
int number_of_outer_points(const FaceRange& faces, const Next& next, const Is_hidden& is_hidden)
{
  const Is_none_hidden is_none_hidden;
  for(int i = 0; i < max_number_of_points_on_ray; ++i)
  {
    const auto x = next();
    if(is_none_hidden(faces, [&](const auto& f) { return is_hidden(f, x); }))
      return i;
  }
  return max_number_of_points_on_ray;
}

// The same for the points p + s d with s = start, start / 4, start / 16, ... There may be hundreds, and it takes much
// longer to compute them in exact Cartesian coordinates than to decide on them.
template <typename Positions, typename FaceRange>
int number_of_outer_points_on_ray(const Positions& positions, const FaceRange& faces,
                                  const typename Positions::Exact_point_3& p,
                                  const typename Positions::Exact_kernel::Vector_3& d, const double start)
{
  if constexpr(Positions::is_kernel_exact)
  {
    typename Positions::Exact_FT s(start);
    const auto next = [&]
    {
      const typename Positions::Exact_point_3 x = p + s * d;
      s /= 4;
      return x;
    };
    return number_of_outer_points(faces, next, [&](const auto& f, const auto& x)
    {
      return typename Positions::Exact_kernel::Orientation_3()(positions(f[0]), positions(f[1]), positions(f[2]), x)
             != POSITIVE;
    });
  }
  else
  {
    typedef typename Positions::Homogeneous_point Homogeneous_point;
    typedef typename Positions::Vertex_handle     Vertex_handle;
    const Homogeneous_point origin = Positions::to_homogeneous(p);
    const Homogeneous_point direction = Positions::to_homogeneous(CGAL::ORIGIN + d);
    const auto homogeneous = [&](const Vertex_handle v) { return Positions::homogeneous(v, positions.find(v)); };
    Exact_float s(start);
    const auto next = [&]
    {
      const Homogeneous_point x = Homogeneous_point::on_ray(origin, direction, s);
      s = s * Exact_float(.25);
      return x;
    };
    return number_of_outer_points(faces, next, [&](const auto& f, const Homogeneous_point& x)
    {
      return Homogeneous_point::orientation(homogeneous(f[0]), homogeneous(f[1]), homogeneous(f[2]), x) != POSITIVE;
    });
  }
}

// Finds a point in the open visibility kernel of a polyhedron on a ray from a point in its closed kernel, both exactly.
// For polyhedra that are too flat to have a floating point number inside. Each of the faces has the polyhedron on its
// positive side; `sizes` are about its diameters along the axes.
template <typename Positions, typename FaceRange>
std::optional<typename Positions::Exact_point_3>
exact_point_on_ray(const Positions& positions, const FaceRange& faces, const typename Positions::Exact_point_3& origin,
                   const typename Positions::Exact_kernel::Vector_3& direction, const std::array<double, 3>& sizes)
{
  if(direction == CGAL::NULL_VECTOR)
    return std::nullopt;
  double quotient = std::numeric_limits<double>::infinity();
  for(int i = 0; i < 3; ++i)
    quotient = (std::min)(quotient, sizes[i] / std::abs(CGAL::to_double(direction[i])));
  const double start = std::isfinite(quotient) && quotient > 0 ? quotient : 1.;
  const int n = internal::number_of_outer_points_on_ray(positions, faces, origin, direction, start);
  if(n == max_number_of_points_on_ray)
    return std::nullopt;
  typename Positions::Exact_FT s(start);
  for(int i = 0; i < n; ++i)
    s /= 4;
  return origin + s * direction;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POINT_ON_RAY_H
