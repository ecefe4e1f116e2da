// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_POINTS_IN_KERNEL_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_POINTS_IN_KERNEL_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/Representable_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>

#include <CGAL/Origin.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Whether none of the faces of a polyhedron is hidden from a point. Where points are tried one after the other, the
// next one is likely to be on the wrong side of the same face, so this is asked for first.
class Is_none_hidden
{
public:
  template <typename FaceRange, typename Is_hidden>
  bool operator()(const FaceRange& faces, const Is_hidden& is_hidden) const
  {
    if(m_last_hidden < faces.size() && is_hidden(faces[m_last_hidden]))
      return false;
    const auto hidden = std::find_if(faces.begin(), faces.end(), is_hidden);
    m_last_hidden = static_cast<std::size_t>(hidden - faces.begin());
    return hidden == faces.end();
  }

private:
  mutable std::size_t m_last_hidden = 0; // the position of a face that the last point did not see
};

/*
 * Decides exactly whether a vertex is in the open visibility kernel of a polyhedron: whether it sees all the faces from
 * inside. Each of the faces has the polyhedron on its positive side.
 */
template <typename Tr>
class Is_in_kernel_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef Vertex_predicates_3<Tr>        Predicates;
  typedef std::array<Vertex_handle, 3>   Vertex_triple;

  explicit Is_in_kernel_3(const Predicates& predicates) : m_predicates(predicates) { }

  bool operator()(const Vertex_handle v, const std::vector<Vertex_triple>& faces) const
  {
    return m_is_none_hidden(faces, [&](const Vertex_triple& f)
    {
      return m_predicates.orientation(f[0], f[1], f[2], v) != POSITIVE;
    });
  }

private:
  const Predicates& m_predicates;
  Is_none_hidden m_is_none_hidden;
};

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

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_POINTS_IN_KERNEL_H
