// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_WORK_ACCOUNT_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_WORK_ACCOUNT_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * What an operation costs where a mesh is improved, and what it earns there, by kind of cell. What does not pay is not
 * tried any more.
 *
 * The price of a try is the number of cell qualities that it asks for, its yield is by how much the cells are less bad
 * afterwards: both are counted, so the same input leads to the same mesh. Each account begins with a credit that grows
 * with the mesh. So where bad cells are few, all of them are worth any effort; where they are many, an operation has to
 * go on earning what it costs, at the least rate.
 */
class Work_account
{
public:
  enum Kind
  {
    VERY_BAD,
    BAD,
    NEARLY_GOOD
  };

  // That of a cell, by its quality as a part of what is enough.
  static Kind kind(const double quality, const double enough)
  {
    return quality < very_bad * enough ? VERY_BAD : quality < half_bad * enough ? BAD : NEARLY_GOOD;
  }

  void open(const Improvement_effort effort, const std::size_t number_of_cells)
  {
    const double factor = factor_of(effort);
    const std::size_t number = (std::max)(number_of_cells, least_number_of_cells);
    m_credit = factor * credit_per_cell * static_cast<double>(number);
    m_least_rate = least_rate / factor;
  }

  bool pays(const Kind kind) const { return m_prices[kind] <= m_credit + m_yields[kind] / m_least_rate; }

  void book(const Kind kind, const std::size_t price, const double yield)
  {
    m_prices[kind] += static_cast<double>(price + price_of_any_try);
    m_yields[kind] += yield;
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr double very_bad = 0.2;
  static constexpr double half_bad = 0.5;
  static constexpr double credit_per_cell = 5;
  static constexpr std::size_t least_number_of_cells = 1000;
  static constexpr double least_rate = 2e-4; // flat cells that become good, per quality that is asked for
  static constexpr std::size_t price_of_any_try = 10;
  static constexpr double low_factor = 0.25;
  static constexpr double high_factor = 40;

  static double factor_of(const Improvement_effort effort)
  {
    return effort == Improvement_effort::low ? low_factor : effort == Improvement_effort::high ? high_factor : 1;
  }

  double m_credit = std::numeric_limits<double>::infinity();
  double m_least_rate = least_rate;
  std::array<double, 3> m_prices = {{ 0, 0, 0 }};
  std::array<double, 3> m_yields = {{ 0, 0, 0 }};
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_WORK_ACCOUNT_H
