// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_CELL_SHAPE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_CELL_SHAPE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/numbers/Double_pair.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace CGAL::Boundary_recovery_3::internal {

typedef std::array<Coordinates_3, 4> Cell_corners_3;

// Of two cells at once.
typedef std::array<std::array<Double_pair, 3>, 4> Cell_corners_pair_3;

inline Cell_corners_pair_3 paired(const Cell_corners_3& p, const Cell_corners_3& q)
{
  Cell_corners_pair_3 pair;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 3; ++j)
      pair[i][j] = Double_pair{ p[i][j], q[i][j] };
  return pair;
}

// The two vertices of each edge of a cell. Its facets at the edge k are opposite to the vertices of the edge 5 - k.
constexpr int edges_of_cell[6][2] = {{ 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 }};

/*
 * What angles of a tetrahedron are made of, in floating point numbers, and without a root: vectors along its edges, and
 * its normals, which are as long as twice the areas of the facets and point inwards if it is oriented positively. Of
 * one cell, where `Number` is `double`, or of two at once.
 */
template <typename Number>
struct Basic_cell_shape_3
{
  std::array<std::array<Number, 3>, 6> edges; // in the order of `edges_of_cell`
  std::array<std::array<Number, 3>, 4> normals;
  Number volume_times_6;

  explicit Basic_cell_shape_3(const std::array<std::array<Number, 3>, 4>& p)
    : edges({{ difference(p[1], p[0]), difference(p[2], p[0]), difference(p[3], p[0]),
               difference(p[2], p[1]), difference(p[3], p[1]), difference(p[3], p[2]) }})
    , normals({{ cross_product(edges[4], edges[3]), cross_product(edges[1], edges[2]),
                 cross_product(edges[2], edges[0]), cross_product(edges[0], edges[1]) }})
    , volume_times_6(dot_product(edges[2], normals[3]))
  { }

  // The cosine of the dihedral angle at the edge k, times the lengths of both normals.
  Number scaled_cosine(const int k) const
  {
    return - dot_product(normals[edges_of_cell[5 - k][0]], normals[edges_of_cell[5 - k][1]]);
  }
};

typedef Basic_cell_shape_3<double> Cell_shape_3;

// The vertices of the facet opposite to each one of a cell.
constexpr int facets_of_cell[4][3] = {{ 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 }};

// The volume, times 6, between the origin and the facet opposite to the corner i.
template <typename Number>
Number volume_at_facet(const std::array<std::array<Number, 3>, 4>& p, const int i)
{
  return dot_product(cross_product(p[facets_of_cell[i][0]], p[facets_of_cell[i][1]]), p[facets_of_cell[i][2]]);
}

/*
 * The parts into which a place divides a tetrahedron: the volumes, times 6, between the place and the facets opposite
 * to the corners, and their sum. The corners are seen from the place, around which numbers are the most precise ones.
 */
template <typename Number>
struct Parts_of_cell_3
{
  std::array<Number, 4> volumes;
  Number sum;

  explicit Parts_of_cell_3(const std::array<std::array<Number, 3>, 4>& p)
    : volumes({{ volume_at_facet(p, 0), volume_at_facet(p, 1), volume_at_facet(p, 2), volume_at_facet(p, 3) }})
    , sum(std::accumulate(volumes.begin(), volumes.end(), Number(0)))
  { }

  // The barycentric coordinates of the place; those of the nearest ones inside if it is outside by rounding errors.
  std::array<double, 4> coordinates() const
  {
    std::array<double, 4> weights;
    for(std::size_t i = 0; i < 4; ++i)
      weights[i] = (std::max)(0., CGAL::to_double(Number(volumes[i] / sum)));
    const double sum_of_weights = std::accumulate(weights.begin(), weights.end(), 0.);
    for(double& w : weights)
      w /= sum_of_weights;
    return weights;
  }
};

inline Cell_corners_3 multiplied(Cell_corners_3 p, const double factor)
{
  for(Coordinates_3& corner : p)
    for(double& x : corner)
      x *= factor;
  return p;
}

// The corners in a unit in which the longest edge is about 1. Nothing is rounded.
inline Cell_corners_3 scaled_corners(const Cell_corners_3& p)
{
  double largest = 0;
  for(int i = 1; i < 4; ++i)
    largest = (std::max)(largest, internal::largest_coordinate(difference(p[i], p[0])));
  return internal::multiplied(p, 1 / internal::binary_scale(largest));
}

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

// Of the lengths of the edges of a tetrahedron.
inline double sum_of_squares_of_edges(const Cell_corners_3& p)
{
  double sum = 0;
  for(const auto& edge : edges_of_cell)
    sum += internal::squared_distance(p[edge[1]], p[edge[0]]);
  return sum;
}

// The mean ratio of the volume and the edges of a tetrahedron: 1 if it is regular, 0 if it is flat, negative if it is
// inverted.
inline double mean_ratio(const double volume_times_6, const double sum_of_squares)
{
  return 12 * std::sqrt(3.) * volume_times_6 / (sum_of_squares * std::sqrt(sum_of_squares));
}

inline double tetrahedron_quality(const std::array<Coordinates_3, 4>& p)
{
  double sum = 0;
  for(const Tetrahedron_edge_3& e : tetrahedron_edges(p))
    sum += e.length * e.length;
  return internal::mean_ratio(internal::volume_times_6(p), sum);
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHAPE_CELL_SHAPE_3_H
