// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_BINARY_SCALE_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_BINARY_SCALE_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Boundary_recovery_3::internal {

// The largest absolute value of the three coordinates of a vector or a point, approximately where they are exact.
template <typename Coordinates>
double largest_coordinate(const Coordinates& x)
{
  double largest = 0;
  for(int i = 0; i < 3; ++i)
    largest = (std::max)(largest, std::abs(CGAL::to_double(x[i])));
  return largest;
}

// Makes each of the numbers at least as large as the absolute value of the coordinate.
template <typename Coordinates>
void enlarge(std::array<double, 3>& largest, const Coordinates& x)
{
  for(int i = 0; i < 3; ++i)
    largest[i] = (std::max)(largest[i], std::abs(CGAL::to_double(x[i])));
}

// The largest power of two that is at most `size`, 1 for zero. Numbers of this size that are divided by it, or
// multiplied with its inverse, become about 1 without rounding errors, so that their products do not leave the range of
// floating point numbers. At the ends of the range the power stays within 2^-1000 and 2^1000.
inline double binary_scale(const double size)
{
  return size > 0 ? std::ldexp(1., (std::max)(-1000, (std::min)(1000, std::ilogb(size)))) : 1.;
}

// Powers of two by which the coordinates of vectors are divided that have these largest absolute values: the same one
// for all axes, so that angles stay what they are, unless the products of coordinates would leave the range of floating
// point numbers nevertheless, as one axis is by far longer than another.
inline std::array<double, 3> binary_scales(const std::array<double, 3>& sizes)
{
  static constexpr int max_difference = 256; // of exponents: four such numbers may be multiplied
  const double scale = binary_scale(*std::max_element(sizes.begin(), sizes.end()));
  std::array<double, 3> scales = {{ scale, scale, scale }};
  const auto is_short = [&](const double size) { return size > 0 && size < std::ldexp(scale, - max_difference); };
  if(std::any_of(sizes.begin(), sizes.end(), is_short))
    for(int i = 0; i < 3; ++i)
      if(sizes[i] > 0)
        scales[i] = binary_scale(sizes[i]);
  return scales;
}

// 2^exponent, or the smallest positive number if that is larger.
inline double binary_unit(const int exponent)
{
  typedef std::numeric_limits<double> Limits;
  return std::ldexp(1., (std::max)(exponent, Limits::min_exponent - Limits::digits));
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_BINARY_SCALE_H
