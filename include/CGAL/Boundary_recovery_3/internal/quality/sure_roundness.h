// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SURE_ROUNDNESS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SURE_ROUNDNESS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// The volume over the lengths of the edges that a cell with this dihedral angle, in radians, has at most, see
// Volume_length_quality_3::of_angle().
inline double largest_roundness(const double angle)
{
  return std::sqrt(8.) * std::sin(angle) / (3 - std::cos(angle));
}

// Cells of this volume over their edges, see Volume_length_quality_3, are sure to have the other quality, too: nothing
// is known of qualities in general.
template <typename Quality>
double sure_roundness(const Quality&, const double)
{
  return (std::numeric_limits<double>::infinity)();
}

// None of the angles can be so small, or so large, that the quality would be less.
inline double sure_roundness(const Dihedral_angle_quality_3& quality, const double least)
{
  const double sine = least * std::sin(largest_min_dihedral_angle); // the quality of this angle is 1
  const double sine_if_obtuse = sine / quality.obtuse_factor();
  if(! (sine < 1 && sine_if_obtuse < 1))
    return (std::numeric_limits<double>::infinity)();
  const double rounding = 1 + 1e-9;
  return rounding * (std::max)(largest_roundness(std::asin(sine)),
                               largest_roundness(CGAL_PI - std::asin(sine_if_obtuse)));
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SURE_ROUNDNESS_H
