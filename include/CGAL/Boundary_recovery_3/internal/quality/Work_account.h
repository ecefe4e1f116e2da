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
  // A cell is of one of these kinds, by its quality as a part of what is enough.
  static constexpr int number_of_kinds = 3;
  static int kind(const double quality, const double enough)
  {
    return quality < very_bad * enough ? 0 : quality < half_bad * enough ? 1 : 2;
  }

  void open(const Improvement_effort effort, const std::size_t number_of_cells)
  {
    const double factor = factor_of(effort);
    const std::size_t number = (std::max)(number_of_cells, least_number_of_cells);
    m_credit = factor * credit_per_cell * static_cast<double>(number);
    m_least_rate = least_rate / factor;
  }

  bool pays(const int kind) const { return m_prices[kind] <= m_credit + m_yields[kind] / m_least_rate; }

  void book(const int kind, const std::size_t price, const double yield)
  {
    m_prices[kind] += static_cast<double>(price + price_of_any_try);
    m_yields[kind] += yield;
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr double very_bad = 0.2;
  static constexpr double half_bad = 0.5;
  static constexpr double credit_per_cell = 10;
  static constexpr std::size_t least_number_of_cells = 1000;
  static constexpr double least_rate = 1e-4; // flat cells that become good, per quality that is asked for
  static constexpr std::size_t price_of_any_try = 10;

  static double factor_of(const Improvement_effort effort)
  {
    return effort == Improvement_effort::low ? 0.25 : effort == Improvement_effort::normal ? 1 : 15;
  }

  double m_credit = std::numeric_limits<double>::infinity();
  double m_least_rate = least_rate;
  std::array<double, number_of_kinds> m_prices = {{ 0, 0, 0 }};
  std::array<double, number_of_kinds> m_yields = {{ 0, 0, 0 }};
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_WORK_ACCOUNT_H
