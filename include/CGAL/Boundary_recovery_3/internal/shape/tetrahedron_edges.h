// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_TETRAHEDRON_EDGES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_TETRAHEDRON_EDGES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

struct Tetrahedron_edge_3
{
  double length;
  int i, j; // its corners
};

inline std::array<Tetrahedron_edge_3, 6> tetrahedron_edges(const std::array<Coordinates_3, 4>& p)
{
  std::array<Tetrahedron_edge_3, 6> edges;
  int n = 0;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < i; ++j)
      edges[n++] = Tetrahedron_edge_3{ internal::distance(p[i], p[j]), i, j };
  return edges;
}

// Equal ones in a fixed order.
inline std::array<Tetrahedron_edge_3, 6> edges_from_long_to_short(const std::array<Coordinates_3, 4>& p)
{
  std::array<Tetrahedron_edge_3, 6> edges = tetrahedron_edges(p);
  std::sort(edges.begin(), edges.end(), [](const Tetrahedron_edge_3& e, const Tetrahedron_edge_3& f)
  {
    return e.length > f.length || (e.length == f.length && 4 * e.i + e.j < 4 * f.i + f.j);
  });
  return edges;
}

inline Tetrahedron_edge_3 longest_edge(const std::array<Coordinates_3, 4>& p)
{
  const std::array<Tetrahedron_edge_3, 6> edges = tetrahedron_edges(p);
  return *std::max_element(edges.begin(), edges.end(), [](const Tetrahedron_edge_3& e, const Tetrahedron_edge_3& f)
  {
    return e.length < f.length;
  });
}

// The longest edge of the facet opposite to a corner.
inline double longest_edge_of_facet(const std::array<Coordinates_3, 4>& p, const int corner)
{
  double longest = 0;
  for(const Tetrahedron_edge_3& e : tetrahedron_edges(p))
    if(e.i != corner && e.j != corner)
      longest = (std::max)(longest, e.length);
  return longest;
}

inline Coordinates_3 midpoint(const Coordinates_3& p, const Coordinates_3& q)
{
  return {{ (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2 }};
}

// 1 for a regular tetrahedron, 0 for a flat one, negative for an inverted one.
inline double tetrahedron_quality(const std::array<Coordinates_3, 4>& p)
{
  double sum = 0;
  for(const Tetrahedron_edge_3& e : tetrahedron_edges(p))
    sum += e.length * e.length;
  return 12 * std::sqrt(3.) * internal::volume_times_6(p) / (sum * std::sqrt(sum));
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_TETRAHEDRON_EDGES_H
