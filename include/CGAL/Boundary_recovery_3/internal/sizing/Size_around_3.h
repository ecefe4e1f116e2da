// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SIZE_AROUND_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SIZE_AROUND_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Size_source_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// The size at a distance from a source.
struct Size_around_3
{
  double size;
  double radius;
  bool is_linear;
  double rate; // the grading, or the length that doubles the size

  double at(const double distance) const
  {
    const double d = (std::max)(0., distance - radius);
    return is_linear ? size + rate * d : size * std::exp2(d / rate);
  }

  // At most the size there. The tangent of an exponential function is below it.
  double bound_at(const double distance) const
  {
    static constexpr double less_than_log_of_2 = 0.693;
    const double d = (std::max)(0., distance - radius);
    return is_linear ? size + rate * d : size * (1 + less_than_log_of_2 / rate * d);
  }

  // By how much it grows per length, as long as it is not larger than `largest`.
  double grading(const double largest) const
  {
    return is_linear ? rate : size < largest ? largest * std::log(2.) / rate : 0;
  }
};

// That of a valid source whose lengths are divided by the unit.
template <typename GT>
Size_around_3 size_around(const Size_source_3<GT>& source, const double unit)
{
  const Size_growth& growth = source.growth();
  return Size_around_3{ source.size() / unit, source.radius() / unit, growth.is_linear(),
                        growth.is_linear() ? growth.value() : (growth.value() - source.radius()) / unit };
}

// How far away sources are, at most, that make a size smaller.
class Reach_of_sources_3
{
public:
  void add(const Size_around_3& source)
  {
    Kind& kind = source.is_linear ? m_linear : m_doubling;
    kind.smallest_size = (std::min)(kind.smallest_size, source.size);
    kind.largest_radius = (std::max)(kind.largest_radius, source.radius);
    kind.longest = (std::max)(kind.longest, source.is_linear ? 1 / source.rate : source.rate);
  }

  // The square of the distance from a ball's center, with room for rounding errors; negative if no source does, however
  // near it is.
  double squared(const double size, const double radius) const
  {
    double reach = -1;
    if(m_linear.smallest_size < size)
      reach = m_linear.largest_radius + (size - m_linear.smallest_size) * m_linear.longest;
    if(m_doubling.smallest_size < size)
      reach = (std::max)(reach, m_doubling.largest_radius
                                  + std::log2(size / m_doubling.smallest_size) * m_doubling.longest);
    return reach < 0 ? reach : (reach + radius) * (reach + radius) * (1 + 1e-9);
  }

private:
  struct Kind
  {
    double smallest_size = std::numeric_limits<double>::infinity();
    double largest_radius = 0;
    double longest = 0; // the length that a size of 1 takes to grow by 1, or to double
  };

  Kind m_linear, m_doubling;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_SIZE_AROUND_3_H
