// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_SIZE_SOURCE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_SIZE_SOURCE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <array>
#include <cmath>
#include <limits>
#include <ostream>

namespace CGAL {
namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// how the size around a source grows with the distance from it.
class Size_growth
{
public:
  /// beyond the radius `r`, the size at distance `d` is `size + grading * (d - r)`; `grading` has no unit, and may be
  /// 0.
  static Size_growth linear(const double grading) { return Size_growth(true, grading); }

  /// beyond the radius `r`, the size is \f$ size \cdot e^{\ln 2 (d - r) / (D - r)} \f$: it has doubled at the distance
  /// `D` from the source, and doubles again with each further length of `D - r`.
  static Size_growth doubling_at(const double D) { return Size_growth(false, D); }

  /// returns whether it is linear.
  bool is_linear() const { return m_is_linear; }

  /// returns the grading, or the distance where the size has doubled.
  double value() const { return m_value; }

private:
  Size_growth(const bool is_linear, const double value) : m_is_linear(is_linear), m_value(value) { }

  bool m_is_linear;
  double m_value;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a source of a size field: a point, a segment, a triangle, or a box, around which edges have a certain size.
 *
 * Within `radius` the size is `size`, beyond it grows. Distances are those from the nearest point of the source, and 0
 * within a box. Segments, triangles and boxes may be degenerate.
 *
 * \tparam GT the geometric traits
 */
template <typename GT>
class Size_source_3
{
public:
  typedef typename GT::Point_3 Point_3; ///< the point type

  /// the shapes of sources
  enum class Shape
  {
    point,    ///< a point
    segment,  ///< all points between two
    triangle, ///< all points between three
    box       ///< a box with sides parallel to the axes, given by two opposite corners
  };

  /// returns the name of a shape, as it is spelled in the enumeration.
  friend const char* to_string(const Shape shape)
  {
    switch(shape)
    {
      case Shape::point:    return "point";
      case Shape::segment:  return "segment";
      case Shape::triangle: return "triangle";
      case Shape::box:      return "box";
    }
    return "";
  }

  /// writes the name of a shape.
  friend std::ostream& operator<<(std::ostream& os, const Shape shape) { return os << to_string(shape); }

  /// makes a source of a point.
  static Size_source_3 point(const Point_3& p, const double size, const double radius, const Size_growth& growth)
  {
    return Size_source_3(Shape::point, {{ p, p, p }}, size, radius, growth);
  }

  /// makes a source of a segment.
  static Size_source_3 segment(const Point_3& p, const Point_3& q, const double size, const double radius,
                               const Size_growth& growth)
  {
    return Size_source_3(Shape::segment, {{ p, q, q }}, size, radius, growth);
  }

  /// makes a source of a triangle.
  static Size_source_3 triangle(const Point_3& p, const Point_3& q, const Point_3& r, const double size,
                                const double radius, const Size_growth& growth)
  {
    return Size_source_3(Shape::triangle, {{ p, q, r }}, size, radius, growth);
  }

  /// makes a source of a box; `p` and `q` are any two corners that are opposite to each other.
  static Size_source_3 box(const Point_3& p, const Point_3& q, const double size, const double radius,
                           const Size_growth& growth)
  {
    return Size_source_3(Shape::box, {{ p, q, q }}, size, radius, growth);
  }

  /// returns the shape.
  Shape shape() const { return m_shape; }

  /// returns the `i`-th of the points that the source was made of, the last one for all larger `i` up to 2.
  const Point_3& vertex(const int i) const { return m_points[i]; }

  /// returns the size within the radius.
  double size() const { return m_size; }

  /// returns the radius.
  double radius() const { return m_radius; }

  /// returns how the size grows beyond the radius.
  const Size_growth& growth() const { return m_growth; }

  /// returns whether the size is positive, the radius not negative, the grading not negative, or the distance where the
  /// size has doubled larger than the radius; and all of them finite.
  bool is_valid() const { return what_is_wrong()[0] == '\0'; }

  /// returns what is wrong if it is not valid, else nothing: `"the size is not a positive number"`, for instance.
  const char* what_is_wrong() const
  {
    const auto is_finite = [](const double x) { return std::abs(x) < std::numeric_limits<double>::infinity(); };
    if(! (m_size > 0 && is_finite(m_size)))
      return "the size is not a positive number";
    if(! (m_radius >= 0 && is_finite(m_radius)))
      return "the radius is negative";
    if(m_growth.is_linear() && ! (m_growth.value() >= 0 && is_finite(m_growth.value())))
      return "the growth is negative";
    if(! m_growth.is_linear() && ! (m_growth.value() > m_radius && is_finite(m_growth.value())))
      return "the distance where the size has doubled is not larger than the radius";
    return "";
  }

private:
  Size_source_3(const Shape shape, const std::array<Point_3, 3>& points, const double size, const double radius,
                const Size_growth& growth)
    : m_shape(shape), m_points(points), m_size(size), m_radius(radius), m_growth(growth)
  { }

  Shape m_shape;
  std::array<Point_3, 3> m_points;
  double m_size;
  double m_radius;
  Size_growth m_growth;
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_SIZE_SOURCE_3_H
