// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CELL_ANGLES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CELL_ANGLES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace CGAL::Boundary_recovery_3::internal {

// Decides like the cotangent of an angle, but needs no root: its square, with its sign. It falls from infinity to minus
// infinity while the angle grows from 0 to 180 degrees.
inline double signed_square(const double cotangent) { return cotangent * std::abs(cotangent); }

inline double signed_square_of_cotangent(const double degrees)
{
  const double angle = (std::max)(0., (std::min)(180., degrees)) * (CGAL_PI / 180);
  return internal::signed_square(std::cos(angle) / std::sin(angle));
}

/*
 * The dihedral angles of a tetrahedron, in degrees, and what else tells how good it is. For reports: what decides while
 * a mesh is improved is faster.
 *
 * An angle is found when it is asked for. Whoever compares the extreme ones with thresholds had better ask for the
 * squares of their cotangents.
 */
class Cell_angles_3
{
public:
  explicit Cell_angles_3(const Cell_corners_3& corners)
    : m_shape(is_ordinary(corners) ? corners : internal::scaled_corners(corners))
  {
    for(int k = 0; k < 6; ++k)
      m_squares[k] = internal::signed_square(m_shape.scaled_cosine(k)) / squared_length(m_shape.edges[k]);
    m_largest_square = m_smallest_square = m_squares[0];
    for(int k = 1; k < 6; ++k) // without branches, since nobody can predict them
    {
      m_largest_square = (std::max)(m_largest_square, m_squares[k]);
      m_smallest_square = (std::min)(m_smallest_square, m_squares[k]);
    }
  }

  const Cell_shape_3& shape() const { return m_shape; }

  // That of the angle at the edge k, and those of the extreme angles. If the cell has no volume, they are infinite or
  // not a number.
  double square_of_cotangent(const int k) const { return m_squares[k] / square_of_volume(); }
  double square_of_largest_cotangent() const { return m_largest_square / square_of_volume(); }
  double square_of_smallest_cotangent() const { return m_smallest_square / square_of_volume(); }

  // The edges with the extreme angles, in the order of `edges_of_cell`.
  int edge_of_smallest() const { return edge_of(m_largest_square); }
  int edge_of_largest() const { return edge_of(m_smallest_square); }

  double smallest() const { return (*this)[edge_of_smallest()]; }
  double largest() const { return (*this)[edge_of_largest()]; }

  // The angle at the edge k, well-conditioned also near 0 and 180.
  double operator[](const int k) const
  {
    const double sine = std::abs(m_shape.volume_times_6) * std::sqrt(squared_length(m_shape.edges[k]));
    return std::atan2(sine, m_shape.scaled_cosine(k)) * (180 / CGAL_PI);
  }

  // 3 times the radius of the inscribed sphere, over that of the circumscribed one: 3 (6 V / sum of |n|) / R, where
  // 12 V R is the length of a sum of normals.
  double radius_ratio() const
  {
    double sum_of_lengths = 0;
    for(const Coordinates_3& normal : m_shape.normals)
      sum_of_lengths += std::sqrt(squared_length(normal));
    std::array<double, 3> squares;
    for(int i = 0; i < 3; ++i)
      squares[i] = squared_length(m_shape.edges[i]);
    Coordinates_3 sum;
    for(int j = 0; j < 3; ++j)
      sum[j] = squares[0] * m_shape.normals[1][j] + squares[1] * m_shape.normals[2][j] +
               squares[2] * m_shape.normals[3][j];
    const double volume = m_shape.volume_times_6;
    return volume == 0 ? 0 : 6 * volume * volume / (sum_of_lengths * std::sqrt(squared_length(sum)));
  }

private:
  static double squared_length(const Coordinates_3& u) { return dot_product(u, u); }

  // Whether no square, and no product of them, leaves the range of floating point numbers.
  static bool is_ordinary(const Cell_corners_3& p)
  {
    const double square = squared_length(difference(p[1], p[0]));
    return square > 1e-40 && square < 1e40;
  }

  double square_of_volume() const { return m_shape.volume_times_6 * m_shape.volume_times_6; }

  // The first one where none compares equal, as numbers are missing.
  int edge_of(const double square) const
  {
    const auto k = std::find(m_squares.begin(), m_squares.end(), square);
    return k == m_squares.end() ? 0 : static_cast<int>(k - m_squares.begin());
  }

  Cell_shape_3 m_shape;
  std::array<double, 6> m_squares; // of the cotangents, with their sign, times the square of 6 times the volume
  double m_largest_square;
  double m_smallest_square;
};

// The smallest angle of a triangle, in degrees.
inline double smallest_plane_angle(const std::array<Coordinates_3, 3>& p)
{
  double smallest = 180;
  for(int i = 0; i < 3; ++i)
  {
    const Coordinates_3 u = difference(p[(i + 1) % 3], p[i]), v = difference(p[(i + 2) % 3], p[i]);
    const Coordinates_3 normal = cross_product(u, v);
    const double angle = std::atan2(std::sqrt(dot_product(normal, normal)), dot_product(u, v)) * (180 / CGAL_PI);
    smallest = (std::min)(smallest, angle);
  }
  return smallest;
}

/*
 * Finds the two walls that a cell is between at one of its edges, if the angle between them is small: all cells between
 * them have such an angle there, and so have those of any other mesh.
 */
template <typename Tr>
class Walls_at_edge_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef typename Tr::Facet         Facet;
  typedef Selected_domain_3<Tr>      Domain;

  struct Walls
  {
    std::array<Facet, 2> facets;
    double angle; // between them
  };

  // The domain must exist as long as this does.
  explicit Walls_at_edge_3(const Domain& domain) : m_domain(domain) { }

  // None if they are not less than `limit` degrees apart. The cell is known to have this angle at its edge k.
  std::optional<Walls> operator()(const Cell_handle c, const int k, const double angle, const double limit) const
  {
    const Vertex_handle u = c->vertex(edges_of_cell[k][0]), v = c->vertex(edges_of_cell[k][1]);
    const int* const others = edges_of_cell[5 - k];
    Edge_walk_3<Tr> there(c, others[0], others[1]), back(c, others[1], others[0]);
    double sum_of_angles = angle;
    if(! go_to_wall(there, u, v, sum_of_angles, limit) || ! go_to_wall(back, u, v, sum_of_angles, limit))
      return std::nullopt;
    const double between = angle_at_edge(u, v, there.apex(), back.apex());
    if(! (between < limit))
      return std::nullopt;
    return Walls{ {{ Facet(there.cell(), there.next_facet()), Facet(back.cell(), back.next_facet()) }}, between };
  }

private:
  static constexpr double slack = 1; // degrees by which sums of angles are allowed to be too large before all is known

  bool go_to_wall(Edge_walk_3<Tr>& walk, const Vertex_handle u, const Vertex_handle v, double& sum_of_angles,
                  const double limit) const
  {
    const Cell_handle start = walk.cell();
    while(! m_domain.is_wall(walk.cell(), walk.next_facet()))
    {
      ++walk;
      sum_of_angles += angle_at_edge(u, v, walk.cell()->vertex(walk.next_facet()), walk.apex());
      if(walk.cell() == start || sum_of_angles > limit + slack)
        return false;
    }
    return true;
  }

  static double angle_at_edge(const Vertex_handle u, const Vertex_handle v,
                              const Vertex_handle p, const Vertex_handle q)
  {
    const std::array<Vertex_handle, 4> tetrahedron = {{ u, v, p, q }};
    return Cell_angles_3(internal::corners(tetrahedron))[0]; // the first edge is that of the first two corners
  }

  const Domain& m_domain;
};

// Whether a cell has an angle below `limit` degrees that any mesh has: it is between two walls.
template <typename Tr>
bool is_forced(const Walls_at_edge_3<Tr>& walls_at_edge, const typename Tr::Cell_handle c, const double limit)
{
  const Cell_angles_3 angles(internal::corners(c));
  for(int k = 0; k < 6; ++k)
    if(angles[k] < limit && walls_at_edge(c, k, angles[k], limit))
      return true;
  return false;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CELL_ANGLES_3_H
