// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_PLACES_NEAR_CELL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_PLACES_NEAR_CELL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>

#include <CGAL/Triangulation_utils_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Places where a vertex may make cells good that are beside the surface, above all beside thin triangles of it. With w,
 * the length of the shortest edge of such a cell, they are
 *
 * - around this edge,
 * - from there towards the opposite edge, in distances that double: cells are to become larger this way;
 * - beside the longest edge. Four consecutive points of a helix have dihedral angles of 30 to 120 degrees, however
 *   much it is stretched; so the cells between two thin triangles that have this edge in common are good if their other
 *   vertices are one or two w away from it;
 * - and beside the center of the cell: if it is flat, and fills the angle between two triangles that nearly are in a
 *   plane, a vertex above both of them is better.
 */
class Places_near_cell_3
{
public:
  // None if the cell has an edge without length.
  const std::vector<Coordinates_3>& operator()(const Cell_corners_3& p)
  {
    m_places.clear();
    const std::array<Tetrahedron_edge_3, 6> edges = internal::edges_from_long_to_short(p);
    if(edges.back().length > 0)
    {
      const Cell_shape_3 shape(p);
      add_around_shortest_edge(p, edges.back(), shape.normals);
      add_towards_opposite_edge(p, edges.back());
      add_along_longest_edge(p, edges.front(), edges.back().length, shape.normals);
      add_beside_center(p, edges.front().length, shape.normals);
    }
    return m_places;
  }

  // Those that were found last.
  const std::vector<Coordinates_3>& places() const { return m_places; }

private:
  // See "Tuning constants" in the manual.
  static constexpr double distance_in_shortest_edges = 2;
  static constexpr double growth_of_distances = 2;
  static constexpr double height_in_shortest_edges = 1.6;
  static constexpr double spacing_in_shortest_edges = 2;
  static constexpr double max_number_along_edge = 7;
  static constexpr double largest_ratio_along_edge = 128;
  static constexpr std::array<double, 2> heights_in_longest_edges = {{ 0.35, 0.7 }};

  typedef std::array<Coordinates_3, 4> Normals; // of the facets opposite to the corners, not of length 1

  // In both directions of the normals of the facets.
  void add_around_shortest_edge(const Cell_corners_3& p, const Tetrahedron_edge_3& e, const Normals& normals)
  {
    for(const Coordinates_3& n : normals)
      add_above_and_below(internal::midpoint(p[e.i], p[e.j]), n, distance_in_shortest_edges * e.length);
  }

  void add_towards_opposite_edge(const Cell_corners_3& p, const Tetrahedron_edge_3& e)
  {
    const int i = Triangulation_utils_3::next_around_edge(e.i, e.j);
    const int j = Triangulation_utils_3::next_around_edge(e.j, e.i);
    const Coordinates_3 from = internal::midpoint(p[e.i], p[e.j]), to = internal::midpoint(p[i], p[j]);
    const double length = internal::distance(from, to);
    for(double d = growth_of_distances * e.length; d < length; d *= growth_of_distances)
      m_places.push_back(internal::point_between(from, to, d / length));
  }

  // Above and below the two facets that have it in common. None if they would be too far from each other to help.
  void add_along_longest_edge(const Cell_corners_3& p, const Tetrahedron_edge_3& e, const double shortest,
                              const Normals& normals)
  {
    const double ratio = e.length / shortest;
    if(ratio > largest_ratio_along_edge)
      return;
    const int n = static_cast<int>((std::min)(max_number_along_edge, ratio / spacing_in_shortest_edges));
    for(int i = 0; i < 4; ++i)
      if(i != e.i && i != e.j)
        for(int k = 1; k <= n; ++k)
          add_above_and_below(internal::point_between(p[e.i], p[e.j], static_cast<double>(k) / (n + 1)), normals[i],
                              height_in_shortest_edges * shortest);
  }

  // Above and below the largest facet.
  void add_beside_center(const Cell_corners_3& p, const double longest, const Normals& normals)
  {
    const Coordinates_3& normal = *std::max_element(normals.begin(), normals.end(),
                                                    [](const Coordinates_3& n, const Coordinates_3& m)
                                                    { return dot_product(n, n) < dot_product(m, m); });
    for(const double height : heights_in_longest_edges)
      add_above_and_below(internal::centroid(p), normal, height * longest);
  }

  void add_above_and_below(const Coordinates_3& p, const Coordinates_3& normal, const double height)
  {
    const double length = std::sqrt(dot_product(normal, normal));
    if(length > 0)
      for(const double step : { - height / length, height / length })
        m_places.push_back({{ p[0] + step * normal[0], p[1] + step * normal[1], p[2] + step * normal[2] }});
  }

  std::vector<Coordinates_3> m_places;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_PLACES_NEAR_CELL_3_H
