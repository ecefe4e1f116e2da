// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_UNIT_FRAME_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_UNIT_FRAME_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Boundary_recovery_3::internal {

typedef std::array<double, 3> Coordinates_3;

// The nearest floating point numbers of the coordinates of a point, with or without a weight.
template <typename Point>
Coordinates_3 coordinates_of(const Point& p)
{
  return {{ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) }};
}

// The numbers of vectors are of one type: `double`, or pairs of them, for two vectors at once.
template <typename Number>
std::array<Number, 3> difference(const std::array<Number, 3>& p, const std::array<Number, 3>& q)
{
  return {{ p[0] - q[0], p[1] - q[1], p[2] - q[2] }};
}

template <typename Number>
Number dot_product(const std::array<Number, 3>& u, const std::array<Number, 3>& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <typename Number>
std::array<Number, 3> cross_product(const std::array<Number, 3>& u, const std::array<Number, 3>& v)
{
  return {{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] }};
}

// A box, empty at first, whose sides are parallel to the axes.
struct Axis_box_3
{
  Coordinates_3 lower = {{ infinity(), infinity(), infinity() }};
  Coordinates_3 upper = {{ - infinity(), - infinity(), - infinity() }};

  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }

  void add(const Coordinates_3& p)
  {
    for(int i = 0; i < 3; ++i)
    {
      lower[i] = (std::min)(lower[i], p[i]);
      upper[i] = (std::max)(upper[i], p[i]);
    }
  }

  void add(const Axis_box_3& box)
  {
    add(box.lower);
    add(box.upper);
  }

  bool is_empty() const { return ! (lower[0] <= upper[0]); }

  bool contains(const Coordinates_3& p) const
  {
    for(int i = 0; i < 3; ++i)
      if(p[i] < lower[i] || p[i] > upper[i])
        return false;
    return true;
  }

  Coordinates_3 center() const
  {
    Coordinates_3 c = {{ 0, 0, 0 }};
    for(int i = 0; i < 3 && ! is_empty(); ++i)
      c[i] = lower[i] / 2 + upper[i] / 2;
    return c;
  }
};

/*
 * Coordinates in which a box is about as large as the unit cube around the origin, so that squares of lengths, and
 * single precision, can express what is in it, wherever it is and however large.
 *
 * The unit is a power of two: lengths are multiplied, and divided by it, without rounding errors.
 */
class Unit_frame_3
{
public:
  Unit_frame_3() = default;

  explicit Unit_frame_3(const Axis_box_3& box)
    : m_origin(box.center())
  {
    double largest = 0;
    for(int i = 0; i < 3 && ! box.is_empty(); ++i)
      largest = (std::max)(largest, box.upper[i] / 2 - box.lower[i] / 2);
    m_unit = 2 * binary_scale(largest);
    m_inverse = 1 / m_unit;
  }

  Coordinates_3 to_frame(const Coordinates_3& p) const
  {
    return {{ (p[0] - m_origin[0]) * m_inverse, (p[1] - m_origin[1]) * m_inverse, (p[2] - m_origin[2]) * m_inverse }};
  }

  Coordinates_3 from_frame(const Coordinates_3& p) const
  {
    return {{ m_origin[0] + p[0] * m_unit, m_origin[1] + p[1] * m_unit, m_origin[2] + p[2] * m_unit }};
  }

  double to_frame(const double length) const { return length * m_inverse; }
  double from_frame(const double length) const { return length * m_unit; }

private:
  Coordinates_3 m_origin = {{ 0, 0, 0 }};
  double m_unit = 1;
  double m_inverse = 1;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_UNIT_FRAME_3_H
