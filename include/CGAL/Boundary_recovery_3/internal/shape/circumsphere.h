// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_CIRCUMSPHERE_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_CIRCUMSPHERE_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Boundary_recovery_3::internal {

struct Sphere_3
{
  Coordinates_3 center;
  double squared_radius;
};

// The circumsphere of a tetrahedron, in floating point numbers; of a flat one, it is not finite.
inline Sphere_3 circumsphere(const std::array<Coordinates_3, 4>& p)
{
  const Coordinates_3 u = difference(p[1], p[0]), v = difference(p[2], p[0]), w = difference(p[3], p[0]);
  const Coordinates_3 vw = cross_product(v, w), wu = cross_product(w, u), uv = cross_product(u, v);
  const double uu = dot_product(u, u), vv = dot_product(v, v), ww = dot_product(w, w);
  const double scale = 0.5 / dot_product(u, vw);
  Coordinates_3 c;
  for(int k = 0; k < 3; ++k)
    c[k] = scale * (uu * vw[k] + vv * wu[k] + ww * uv[k]);
  return {{{ p[0][0] + c[0], p[0][1] + c[1], p[0][2] + c[2] }}, dot_product(c, c) };
}

// Whether the circumsphere of a positively oriented tetrahedron contains a point, in floating point numbers.
inline bool is_in_circumsphere(const std::array<Coordinates_3, 4>& p, const Coordinates_3& q)
{
  const Coordinates_3 a = difference(p[0], q), b = difference(p[1], q);
  const Coordinates_3 c = difference(p[2], q), d = difference(p[3], q);
  const Coordinates_3 ab = cross_product(a, b), cd = cross_product(c, d);
  const double bcd = dot_product(b, cd), acd = dot_product(a, cd), abd = dot_product(d, ab), abc = dot_product(c, ab);
  return dot_product(a, a) * bcd + dot_product(c, c) * abd > dot_product(b, b) * acd + dot_product(d, d) * abc;
}

inline Coordinates_3 centroid(const std::array<Coordinates_3, 4>& p)
{
  Coordinates_3 c;
  for(int k = 0; k < 3; ++k)
    c[k] = 0.25 * (p[0][k] + p[1][k] + p[2][k] + p[3][k]);
  return c;
}

inline double distance(const Coordinates_3& p, const Coordinates_3& q)
{
  return std::sqrt(squared_distance(p, q));
}

// Of a place and the corner of a tetrahedron that is farthest from it.
inline double largest_distance(const Coordinates_3& p, const std::array<Coordinates_3, 4>& corners)
{
  double largest = 0;
  for(const Coordinates_3& q : corners)
    largest = (std::max)(largest, squared_distance(p, q));
  return std::sqrt(largest);
}

template <typename Cell_handle>
std::array<Coordinates_3, 4> corners(const Cell_handle c)
{
  return {{ coordinates_of(c->vertex(0)->point()), coordinates_of(c->vertex(1)->point()),
            coordinates_of(c->vertex(2)->point()), coordinates_of(c->vertex(3)->point()) }};
}

template <typename Vertex_handle>
std::array<Coordinates_3, 3> corners(const std::array<Vertex_handle, 3>& triangle)
{
  return {{ coordinates_of(triangle[0]->point()), coordinates_of(triangle[1]->point()),
            coordinates_of(triangle[2]->point()) }};
}

template <typename Vertex_handle>
std::array<Coordinates_3, 4> corners(const std::array<Vertex_handle, 4>& tetrahedron)
{
  return {{ coordinates_of(tetrahedron[0]->point()), coordinates_of(tetrahedron[1]->point()),
            coordinates_of(tetrahedron[2]->point()), coordinates_of(tetrahedron[3]->point()) }};
}

// Six times the volume of a tetrahedron, in floating point numbers.
inline double volume_times_6(const std::array<Coordinates_3, 4>& p)
{
  return dot_product(difference(p[1], p[0]), cross_product(difference(p[2], p[0]), difference(p[3], p[0])));
}

// The same with q in the place of the corner i: not positive if the facet opposite to that corner hides q.
inline double volume_times_6_with(std::array<Coordinates_3, 4> p, const int i, const Coordinates_3& q)
{
  p[i] = q;
  return volume_times_6(p);
}

// A step of a walk, in floating point numbers: the facet of a cell that has the point most clearly behind it, of those
// for which `is_possible` holds; negative if there is none, as in the cell that contains the point.
template <typename Cell_handle, typename IsPossible>
int facet_towards(const Cell_handle c, const Coordinates_3& q, const IsPossible& is_possible)
{
  const std::array<Coordinates_3, 4> p = internal::corners(c);
  int facet = -1;
  double smallest_volume = 0;
  for(int i = 0; i < 4; ++i)
  {
    const double volume = internal::volume_times_6_with(p, i, q);
    if(volume < smallest_volume && is_possible(i))
    {
      smallest_volume = volume;
      facet = i;
    }
  }
  return facet;
}

template <typename Cell_handle>
int facet_towards(const Cell_handle c, const Coordinates_3& q)
{
  return internal::facet_towards(c, q, [](int) { return true; });
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_CIRCUMSPHERE_H
