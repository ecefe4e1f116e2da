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

#include <CGAL/Boundary_recovery_3/internal/filling/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The dihedral angles of a tetrahedron, in degrees, and what else tells how good it is. For reports: what decides while
 * a mesh is improved is faster.
 */
class Cell_angles_3
{
public:
  explicit Cell_angles_3(const Cell_corners_3& corners)
    : m_shape(is_ordinary(corners) ? corners : internal::scaled_corners(corners))
  {
    // without branches, since nobody can predict them
    double least = cotangent(0), most = least;
    for(int k = 1; k < 6; ++k)
    {
      const double value = cotangent(k);
      m_smallest = value > most ? k : m_smallest;
      m_largest = value < least ? k : m_largest;
      most = (std::max)(most, value);
      least = (std::min)(least, value);
    }
    for(int i = 0; i < 4; ++i)
      m_lengths[i] = std::sqrt(squared_length(m_shape.normals[i]));
  }

  // The edges with the extreme angles, in the order of `edges_of_cell`.
  int edge_of_smallest() const { return m_smallest; }
  int edge_of_largest() const { return m_largest; }

  double smallest() const { return (*this)[m_smallest]; }
  double largest() const { return (*this)[m_largest]; }

  // The angle at the edge k, well-conditioned also near 0 and 180.
  double operator[](const int k) const
  {
    const double sine = std::abs(m_shape.volume_times_6) * std::sqrt(squared_length(m_shape.edges[k]));
    return std::atan2(sine, m_shape.scaled_cosine(k)) * (180 / CGAL_PI);
  }

  // The angle at the edge k as a part of a full turn, much faster, with an error below 1e-8: Formula 4.4.46 of
  // Abramowitz and Stegun, "Handbook of Mathematical Functions", for the inverse of the cosine.
  double part_of_turn(const int k) const
  {
    const int* const facets = edges_of_cell[5 - k];
    const double cosine = m_shape.scaled_cosine(k) / (m_lengths[facets[0]] * m_lengths[facets[1]]);
    const double x = (std::min)(1., std::abs(cosine));
    const double polynomial = 1.5707963050 + x * (-0.2145988016 + x * (0.0889789874 + x * (-0.0501743046 + x * (
      0.0308918810 + x * (-0.0170881256 + x * (0.0066700901 - x * 0.0012624911))))));
    const double part = std::sqrt(1 - x) * polynomial * (0.5 / CGAL_PI);
    return cosine < 0 ? 0.5 - part : part;
  }

  // 3 times the radius of the inscribed sphere, over that of the circumscribed one: 3 (6 V / sum of |n|) / R, where
  // 12 V R is the length of a sum of normals.
  double radius_ratio() const
  {
    const double sum_of_lengths = m_lengths[0] + m_lengths[1] + m_lengths[2] + m_lengths[3];
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

  // The square of the cotangent, with its sign, up to a factor that all six angles have in common: it falls while the
  // angle grows.
  double cotangent(const int k) const
  {
    const double cosine = m_shape.scaled_cosine(k);
    return cosine * std::abs(cosine) / squared_length(m_shape.edges[k]);
  }

  Cell_shape_3 m_shape;
  std::array<double, 4> m_lengths; // of the normals
  int m_smallest = 0;
  int m_largest = 0;
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
