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

#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

  // Those of the extreme angles. If the cell has no volume, they are infinite or not a number.
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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CELL_ANGLES_3_H
