// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BADNESS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BADNESS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * How bad cells are, by what their qualities lack of what is enough, and what operations may do for the sum of it.
 *
 * At first, the cubes count, and no new cell may be worse than the worst one of those that go. For what that leaves,
 * the lacks themselves count, so that one very bad cell is preferred to several bad ones; and a new cell may be worse
 * than all that go, by a factor, but never worse than the whole mesh was.
 */
class Badness_3
{
public:
  Badness_3(const double enough) : m_enough(enough), m_inverse(1 / enough) { } // also a conversion

  // No cell gets worse than this quality unless those that go are.
  Badness_3(const double enough, const double floor) : Badness_3(enough)
  {
    m_floor = floor;
    m_is_lenient = true;
  }

  double enough() const { return m_enough; }

  bool is_lenient() const { return m_is_lenient; }
  double floor() const { return m_floor; }

  // From 0, good enough, to 1, flat.
  double of_quality(const double quality) const
  {
    const double lack = 1 - quality * m_inverse;
    return lack > 0 ? of_lack(lack) : 0;
  }

  // `lack` is from 0 to 1, as the badness is; this grows with it.
  double of_lack(const double lack) const { return m_is_lenient ? lack : lack * lack * lack; }

  // What a cell counts where it matters how many are bad: hardly less if it is only a bit so.
  double weight(const double quality) const { return std::sqrt((std::max)(0., 1 - quality * m_inverse)); }

  // The derivative, up to a factor.
  double slope(const double lack) const { return m_is_lenient ? 1 : lack * lack; }

  // The quality that new cells have at least, if that is the one of the worst cell that goes.
  double least_quality(const double worst) const
  {
    return m_is_lenient ? (std::min)(worst, (std::max)(m_floor, tolerated_share * worst)) : worst;
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr double tolerated_share = 0.2;

  double m_enough;
  double m_inverse;
  double m_floor = std::numeric_limits<double>::infinity();
  bool m_is_lenient = false;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BADNESS_3_H
