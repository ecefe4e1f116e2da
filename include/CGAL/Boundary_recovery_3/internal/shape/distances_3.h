// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_DISTANCES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_DISTANCES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL::Boundary_recovery_3::internal {

// Nearest points of simple shapes, and squares of distances from them, in floating point numbers. Shapes may be
// degenerate.

inline double squared_distance(const Coordinates_3& p, const Coordinates_3& q)
{
  const Coordinates_3 d = difference(p, q);
  return dot_product(d, d);
}

inline double squared_distance(const Coordinates_3& p, const Axis_box_3& box)
{
  double sum = 0;
  for(int i = 0; i < 3; ++i)
  {
    const double d = (std::max)(0., (std::max)(box.lower[i] - p[i], p[i] - box.upper[i]));
    sum += d * d;
  }
  return sum;
}

// The point a + t (b - a).
inline Coordinates_3 point_between(const Coordinates_3& a, const Coordinates_3& b, const double t)
{
  return {{ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) }};
}

// Where on a segment the point next to p is, from 0 to 1.
inline double nearest_on_segment(const Coordinates_3& p, const Coordinates_3& a, const Coordinates_3& b)
{
  const Coordinates_3 ab = difference(b, a);
  const double length = dot_product(ab, ab), along = dot_product(difference(p, a), ab);
  return ! (along > 0) ? 0 : along >= length ? 1 : along / length;
}

inline double squared_distance_to_segment(const Coordinates_3& p, const Coordinates_3& a, const Coordinates_3& b)
{
  return squared_distance(p, point_between(a, b, nearest_on_segment(p, a, b)));
}

// A triangle that distances are asked from.
class Near_triangle_3
{
public:
  typedef std::array<double, 3> Weights; // of the vertices, none of them negative, and with the sum 1

  Near_triangle_3() = default;

  explicit Near_triangle_3(const std::array<Coordinates_3, 3>& vertices)
    : m_vertices(vertices)
  {
    const Coordinates_3 normal = cross_product(difference(vertices[1], vertices[0]),
                                               difference(vertices[2], vertices[0]));
    for(int i = 0; i < 3; ++i)
      m_inwards[i] = cross_product(normal, difference(vertices[(i + 2) % 3], vertices[(i + 1) % 3]));
  }

  const Coordinates_3& vertex(const int i) const { return m_vertices[i]; }

  // The weights whose point is next to p: if p is above the triangle, as large as the parts into which p divides it,
  // else on a side.
  Weights nearest(const Coordinates_3& p) const
  {
    Weights weights;
    for(int i = 0; i < 3; ++i)
      weights[i] = dot_product(m_inwards[i], difference(p, m_vertices[(i + 1) % 3]));
    const double sum = weights[0] + weights[1] + weights[2];
    if(! (sum > 0) || *std::min_element(weights.begin(), weights.end()) < 0)
      return nearest_on_sides(p);
    return {{ weights[0] / sum, weights[1] / sum, weights[2] / sum }};
  }

  // The point itself.
  Coordinates_3 nearest_point(const Coordinates_3& p) const
  {
    const Weights weights = nearest(p);
    Coordinates_3 q;
    for(int i = 0; i < 3; ++i)
      q[i] = weights[0] * m_vertices[0][i] + weights[1] * m_vertices[1][i] + weights[2] * m_vertices[2][i];
    return q;
  }

  double squared_distance(const Coordinates_3& p) const { return internal::squared_distance(p, nearest_point(p)); }

private:
  Weights nearest_on_sides(const Coordinates_3& p) const
  {
    Weights weights = {{ 0, 0, 0 }};
    double smallest = std::numeric_limits<double>::infinity();
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const double t = nearest_on_segment(p, m_vertices[i], m_vertices[j]);
      const double d = internal::squared_distance(p, point_between(m_vertices[i], m_vertices[j], t));
      if(! (d < smallest))
        continue;
      smallest = d;
      weights[i] = 1 - t;
      weights[j] = t;
      weights[(i + 2) % 3] = 0;
    }
    return weights;
  }

  std::array<Coordinates_3, 3> m_vertices;
  std::array<Coordinates_3, 3> m_inwards; // in the plane, across the side opposite to each vertex
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_DISTANCES_3_H
