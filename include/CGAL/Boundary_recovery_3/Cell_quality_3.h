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

#include <CGAL/Boundary_recovery_3/internal/numbers/Double_pair.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL::Boundary_recovery_3 {
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
 * \brief the quality of a cell is the smallest sine of its six dihedral angles, where obtuse angles count as worse.
 *
 * The sine of an obtuse angle is multiplied by a factor, so that large angles count, too: with the factor 0.6, an angle
 * of 145 degrees is as bad as an angle of 20 degrees. The result is divided by the sine of the dihedral angle of the
 * regular tetrahedron, so that the regular tetrahedron has the quality 1. The quality jumps where an angle exceeds 90
 * degrees, but such cells are far better than any target.
 *
 * A cell of at least the quality `of_angle(a)` has no dihedral angle below `a`.
 *
 * \cgalModels{CellQuality_3}
 */
class Dihedral_angle_quality_3
{
public:
  /// \param obtuse_factor the factor for the sines of obtuse angles, from 0 to 1; 1: only the sine counts
  explicit Dihedral_angle_quality_3(const double obtuse_factor = 0.6)
    : m_squared_obtuse_factor(obtuse_factor * obtuse_factor)
  { }

  /// returns the quality of the cell with these corners: at most 1, up to rounding; not positive if the cell is flat or
  /// not positively oriented.
  double operator()(const std::array<std::array<double, 3>, 4>& corners) const
  {
    const Measures<double> measures(corners);
    return is_ordinary(measures.product) ? quality(measures) : of_extreme_cell(corners);
  }

  /// returns the qualities of two cells, equal bit for bit to those of single calls, in hardly more time than one call
  /// takes.
  std::array<double, 2> of_two_cells(const std::array<std::array<double, 3>, 4>& first,
                                     const std::array<std::array<double, 3>, 4>& second) const
  {
    const Measures<internal::Double_pair> measures(internal::paired(first, second));
    if(! (is_ordinary(measures.product[0]) && is_ordinary(measures.product[1])))
      return {{ (*this)(first), (*this)(second) }};
    const internal::Double_pair qualities = quality(measures);
    return {{ qualities[0], qualities[1] }};
  }

  /// returns the largest quality of all cells whose smallest dihedral angle is `degrees`.
  double of_angle(const double degrees) const
  {
    return sine_factor * std::sin(internal::possible_min_dihedral_angle(degrees));
  }

  /// returns the factor for the sines of obtuse angles.
  double obtuse_factor() const { return std::sqrt(m_squared_obtuse_factor); }

private:
  static constexpr double sine_factor = 1.0606601717798212; // 1 / sin(largest_min_dihedral_angle) = 3 / sqrt(8)
  static constexpr double least_product = 1e-240; // below it, or above its inverse, numbers leave their range

  // Of one cell, or of two at once.
  template <typename Number>
  struct Measures
  {
    internal::Basic_cell_shape_3<Number> shape;
    std::array<Number, 4> squares; // of the lengths of the normals
    Number product;                // of them

    explicit Measures(const std::array<std::array<Number, 3>, 4>& corners)
      : shape(corners)
      , squares({{ square(0), square(1), square(2), square(3) }})
      , product(squares[0] * squares[1] * squares[2] * squares[3])
    { }

    Number square(const int i) const { return internal::dot_product(shape.normals[i], shape.normals[i]); }
  };

  static bool is_ordinary(const double product) { return product > least_product && product < 1 / least_product; }

  // The sine of an angle is the volume times 6, times the length of the edge, over the lengths of the normals at it.
  // Since edges and the products of normals at them are compared with each other, one division and one root are enough.
  template <typename Number>
  Number quality(const Measures<Number>& measures) const
  {
    Number smallest = of_edge(measures, 0);
    for(int k = 1; k < 6; ++k)
      smallest = internal::smaller(smallest, of_edge(measures, k));
    return sine_factor * measures.shape.volume_times_6 * internal::square_root(smallest / measures.product);
  }

  template <typename Number>
  Number of_edge(const Measures<Number>& measures, const int k) const
  {
    const auto& edge = measures.shape.edges[k];
    const int* const ends = internal::edges_of_cell[k];
    return internal::if_negative(measures.shape.scaled_cosine(k), m_squared_obtuse_factor, 1.) *
           (internal::dot_product(edge, edge) * measures.squares[ends[0]] * measures.squares[ends[1]]);
  }

  // Of a cell that is tiny, huge, or has a facet without an area.
  double of_extreme_cell(const std::array<std::array<double, 3>, 4>& corners) const
  {
    const Measures<double> measures(internal::scaled_corners(corners));
    return measures.product > least_product ? quality(measures) : 0;
  }

  double m_squared_obtuse_factor;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the quality of a cell is its volume, divided by the cube of the root mean square of its edge lengths.
 *
 * The scale is such that the regular tetrahedron has the quality 1. The quality is smooth, and zero only for cells
 * without a volume. Not only angles count, but also edges that are short beside others.
 *
 * A cell of at least the quality `of_angle(a)` has no dihedral angle below `a`.
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

  /// returns the largest quality of all cells whose smallest dihedral angle is `degrees`.
  ///
  /// The best cell with this angle \f$ \theta \f$ has the quality \f$ 2 \sqrt 2 \sin(\theta) / (3 - \cos(\theta)) \f$.
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
    return internal::sum_of_squares_of_edges(p) * (1. / 6);
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

namespace internal {

// Whether a model of CellQuality_3 knows how to compute the qualities of two cells at once.
template <typename Quality, typename = void>
struct Has_quality_of_two_cells : std::false_type { };

template <typename Quality>
struct Has_quality_of_two_cells<Quality, std::void_t<decltype(std::array<double, 2>(
                                           std::declval<const Quality&>().of_two_cells(
                                             std::declval<const Cell_corners_3&>(),
                                             std::declval<const Cell_corners_3&>())))> >
  : std::true_type
{ };

// At once if that is known, else one after the other.
template <typename Quality>
std::array<double, 2> qualities_of_two_cells(const Quality& quality, const Cell_corners_3& p, const Cell_corners_3& q)
{
  if constexpr(Has_quality_of_two_cells<Quality>::value)
    return quality.of_two_cells(p, q);
  else
    return {{ quality(p), quality(q) }};
}

// Calls `visit(item, quality)` for the cells of the items, in order, until it returns false; the corners of a cell are
// `corners(item)`. Since two qualities are computed at once, one may have been computed in vain. Returns whether all
// are visited.
template <typename Quality, typename Range, typename Corners, typename Visit>
bool visit_qualities(const Quality& quality, Range&& items, const Corners& corners, Visit&& visit)
{
  auto it = std::begin(items);
  for(auto rest = std::distance(it, std::end(items)); rest > 1; rest -= 2)
  {
    auto& first = *it++;
    auto& second = *it++;
    const std::array<double, 2> qualities = internal::qualities_of_two_cells(quality, corners(first), corners(second));
    if(! visit(first, qualities[0]) || ! visit(second, qualities[1]))
      return false;
  }
  return it == std::end(items) || visit(*it, quality(corners(*it)));
}

} // namespace internal
} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_CELL_QUALITY_3_H
