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
#include <cmath>
#include <limits>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// The largest absolute value of the three coordinates of a vector or a point, approximately where they are exact.
template <typename Coordinates>
double largest_coordinate(const Coordinates& x)
{
  double largest = 0;
  for(int i = 0; i < 3; ++i)
    largest = (std::max)(largest, std::abs(CGAL::to_double(x[i])));
  return largest;
}

// The largest power of two that is at most `size`, 1 for zero. Numbers of this size that are divided by it, or
// multiplied with its inverse, become about 1 without rounding errors, so that their products do not leave the range of
// floating point numbers. At the ends of the range the power stays within 2^-1000 and 2^1000.
inline double binary_scale(const double size)
{
  return size > 0 ? std::ldexp(1., (std::max)(-1000, (std::min)(1000, std::ilogb(size)))) : 1.;
}

// 2^exponent, or the smallest positive number if that is larger.
inline double binary_unit(const int exponent)
{
  typedef std::numeric_limits<double> Limits;
  return std::ldexp(1., (std::max)(exponent, Limits::min_exponent - Limits::digits));
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_BINARY_SCALE_H
