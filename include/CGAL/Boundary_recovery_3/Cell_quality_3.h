// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_CELL_QUALITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_CELL_QUALITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// The dihedral angle of the regular tetrahedron, in radians: no cell has a larger smallest angle.
constexpr double largest_min_dihedral_angle = 1.2309594173407747;

// An angle in radians, if it can be the smallest one of a cell, else the nearest that can.
inline double possible_min_dihedral_angle(const double degrees)
{
  return (std::max)(0., (std::min)(largest_min_dihedral_angle, degrees * (CGAL_PI / 180)));
}

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the quality of a cell is the smallest sine of its six dihedral angles, of which obtuse ones are counted as
 * worse than they are.
 *
 * The sine of an obtuse angle is multiplied by a factor, so that not only small angles count, but also large ones: with
 * the factor 0.6, an angle of 145 degrees is as bad as one of 20. All is divided by the sine of the dihedral angle of
 * the regular tetrahedron, whose quality is 1. The quality jumps where an angle exceeds 90 degrees, but far above of
 * what meshes are improved for.
 *
 * A cell that is at least as good as `of_angle()` tells has no dihedral angle below that one.
 *
 * \cgalModels{CellQuality_3}
 */
class Dihedral_angle_quality_3
{
public:
  /// \param obtuse_factor what sines of obtuse angles are multiplied by, a number from 0 to 1; 1: only the sine counts
  explicit Dihedral_angle_quality_3(const double obtuse_factor = 0.6)
    : m_squared_factors({{ 1, obtuse_factor * obtuse_factor }})
  { }

  /// returns the quality of the cell with these corners: at most 1, up to rounding; not positive if the cell is flat or
  /// not positively oriented.
  double operator()(const std::array<std::array<double, 3>, 4>& corners) const
  {
    const internal::Cell_shape_3 shape(corners);
    std::array<double, 4> squares; // of the lengths of the normals
    for(int i = 0; i < 4; ++i)
      squares[i] = internal::dot_product(shape.normals[i], shape.normals[i]);
    const double product = squares[0] * squares[1] * squares[2] * squares[3];
    if(! (product > least_product && product < 1 / least_product))
      return of_extreme_cell(corners);
    return quality(shape, squares, product);
  }

  /// returns the quality that a cell has at most if its smallest dihedral angle is `degrees`.
  double of_angle(const double degrees) const
  {
    return sine_factor * std::sin(internal::possible_min_dihedral_angle(degrees));
  }

  /// returns what sines of obtuse angles are multiplied by.
  double obtuse_factor() const { return std::sqrt(m_squared_factors[1]); }

private:
  static constexpr double sine_factor = 1.0606601717798212; // 1 / sin(largest_min_dihedral_angle) = 3 / sqrt(8)
  static constexpr double least_product = 1e-240; // below it, or above its inverse, numbers leave their range

  // The sine of an angle is the volume times 6, times the length of the edge, over the lengths of the normals at it.
  // Since edges and the products of normals at them are compared with each other, one division and one root are enough.
  double quality(const internal::Cell_shape_3& shape, const std::array<double, 4>& squares, const double product) const
  {
    double smallest = of_edge(shape, squares, 0);
    for(int k = 1; k < 6; ++k)
      smallest = (std::min)(smallest, of_edge(shape, squares, k));
    return sine_factor * shape.volume_times_6 * std::sqrt(smallest / product);
  }

  double of_edge(const internal::Cell_shape_3& shape, const std::array<double, 4>& squares, const int k) const
  {
    const int* const ends = internal::edges_of_cell[k];
    const double square = internal::dot_product(shape.edges[k], shape.edges[k]) * squares[ends[0]] * squares[ends[1]];
    return m_squared_factors[shape.scaled_cosine(k) < 0] * square;
  }

  // Of a cell that is tiny, huge, or has a facet without an area.
  double of_extreme_cell(const std::array<std::array<double, 3>, 4>& corners) const
  {
    const internal::Cell_shape_3 shape(internal::scaled_corners(corners));
    std::array<double, 4> squares;
    for(int i = 0; i < 4; ++i)
      squares[i] = internal::dot_product(shape.normals[i], shape.normals[i]);
    const double product = squares[0] * squares[1] * squares[2] * squares[3];
    return product > least_product ? quality(shape, squares, product) : 0;
  }

  std::array<double, 2> m_squared_factors; // of acute and of obtuse angles: looked up, since nobody can predict which
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the quality of a cell is its volume, over the cube of the root mean square of the lengths of its edges.
 *
 * It is scaled so that the regular tetrahedron has the quality 1. The quality is smooth, and zero only for cells
 * without a volume; not only angles count, but edges that are short beside others, too.
 *
 * A cell that is at least as good as `of_angle()` tells has no dihedral angle below that one.
 *
 * \cgalModels{CellQuality_3}
 */
class Volume_length_quality_3
{
public:
  /// returns the quality of the cell with these corners: at most 1, up to rounding; not positive if the cell is flat or
  /// not positively oriented.
  double operator()(const std::array<std::array<double, 3>, 4>& corners) const
  {
    const double square = mean_square(corners);
    const bool is_ordinary = square > least_square && square < 1 / least_square;
    return is_ordinary ? quality(corners, square) : of_extreme_cell(internal::scaled_corners(corners));
  }

  /// returns the quality that a cell has at most if its smallest dihedral angle is `degrees`.
  ///
  /// It is that of the cell where the edge at this angle and the one opposite to it are as long as is best:
  /// \f$ 2 \sqrt 2 \sin(\theta) / (3 - \cos(\theta)) \f$.
  double of_angle(const double degrees) const
  {
    const double angle = internal::possible_min_dihedral_angle(degrees);
    return 2 * root_of_2 * std::sin(angle) / (3 - std::cos(angle));
  }

private:
  static constexpr double root_of_2 = 1.4142135623730951;
  static constexpr double least_square = 1e-100; // below it, or above its inverse, numbers leave their range

  static double mean_square(const internal::Cell_corners_3& p)
  {
    double sum = 0;
    for(const auto& edge : internal::edges_of_cell)
    {
      const internal::Coordinates_3 d = internal::difference(p[edge[1]], p[edge[0]]);
      sum += internal::dot_product(d, d);
    }
    return sum * (1. / 6);
  }

  static double quality(const internal::Cell_corners_3& p, const double square)
  {
    using internal::difference;
    const internal::Coordinates_3 normal = internal::cross_product(difference(p[1], p[0]), difference(p[2], p[0]));
    return root_of_2 * internal::dot_product(difference(p[3], p[0]), normal) / (square * std::sqrt(square));
  }

  static double of_extreme_cell(const internal::Cell_corners_3& p)
  {
    const double square = mean_square(p);
    return square > 0 ? quality(p, square) : 0;
  }
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_CELL_QUALITY_3_H
