// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVEMENT_PROGRESS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVEMENT_PROGRESS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/enumerations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Which share of an improvement is done. Nearly all of its time goes into evaluations of the quality of cells, so they
 * are the unit; where all cells or vertices are visited, memory is slow, and one counts as several. How many are to
 * come is estimated from how many cells stay bad: each of them costs far more than one that is improved at once.
 *
 * Nothing but reports depends on these estimates.
 */
class Improvement_progress
{
public:
  // The cells were measured, and some are bad. Later, they are measured again, and vertices are centered.
  void begin(const std::size_t number_of_cells, const std::size_t number_of_bad_cells,
             const std::size_t number_of_vertices, const Improvement_effort effort)
  {
    const double cells = double((std::max)(number_of_cells, std::size_t(1)));
    m_done = price_of_measuring * cells;
    m_last = measuring_again * cells;
    m_centering = price_of_centering * double(number_of_vertices);
    m_factor = effort == Improvement_effort::low ? low_factor : effort == Improvement_effort::high ? high_factor : 1;
    m_number_of_bad_cells = double(number_of_bad_cells);
    m_stubborn_share = double(number_of_bad_cells) / cells;
  }

  // The rounds that visit all bad cells: this is the round with that number, from 1 on.
  void begin_round(const int round, const std::size_t number_of_cells, const std::size_t evaluations)
  {
    m_number_of_visits = 0;
    m_number_of_failures = 0;
    m_evaluations = double(evaluations);
    m_number_of_cells = double(number_of_cells);
    m_round = (std::min)(static_cast<std::size_t>(round), prices.size()) - 1;
    if(round > 1)
      m_stubborn_share = 1;
  }

  // A cell of a round is visited; nothing helped it.
  void visit() { ++m_number_of_visits; }
  void fail() { ++m_number_of_failures; }

  // To be called from time to time in the rounds, and in the work on the worst cells.
  void work(const std::size_t evaluations)
  {
    if(m_works_on_worst_cells)
      work_on_worst_cells(evaluations);
    else
      work_on_round(evaluations);
    m_share = (std::max)(m_share, share(double(evaluations)));
  }

  // So much of the rounds, or of the centering, is done in parts of the mesh.
  void visit_in_parts(const double part) { tell_part(part, price_of_rounds(), m_centering); }
  void center_in_parts(const double part) { tell_part(part, m_centering, 0); }

  // That was all of it.
  void end_parts_of_rounds() { m_done += price_of_rounds(); }
  void end_parts_of_centering() { m_done += std::exchange(m_centering, 0); }

  // Now, the worst cells are looked at alone.
  void begin_worst_cells(const std::size_t number_of_worst_cells, const std::size_t number_of_bad_cells,
                         const std::size_t evaluations)
  {
    m_works_on_worst_cells = true;
    m_evaluations = double(evaluations);
    m_worst = m_factor * price_of_worst_cell * double(number_of_worst_cells) +
              price_of_second_turn * double(number_of_bad_cells);
    work(evaluations);
  }

  void center(const std::size_t number_of_vertices, const std::size_t total, const std::size_t evaluations)
  {
    const double part = double(number_of_vertices) / double((std::max)(total, std::size_t(1)));
    m_to_come = (1 - part) * m_centering;
    m_share = (std::max)(m_share, share(double(evaluations) + slow_part * part * m_centering));
  }

  // Never falls, nor is it 1.
  double share() const { return m_share; }

private:
  // See "Tuning constants" in the manual.
  static constexpr double price_of_measuring = 2.5;  // in evaluations, beside its own one
  static constexpr double measuring_again = 4;
  static constexpr double price_of_centering = 37;
  static constexpr double slow_part = 0.7;           // of it, beside evaluations
  static constexpr std::array<double, 4> prices = {{ 130, 250, 450, 200 }}; // of a visit, in each round
  static constexpr double price_of_stubborn_cell = 550; // after the rounds
  static constexpr double price_of_worst_cell = 600;
  static constexpr double price_of_second_turn = 50;
  static constexpr double least_sample = 0.1;        // of the cells of a round
  static constexpr double low_factor = 0.4;
  static constexpr double high_factor = 10;

  void work_on_round(const std::size_t evaluations)
  {
    const double first = least_sample * m_number_of_cells; // that count as expected
    const double visited = double(m_number_of_visits), left = (std::max)(0., m_number_of_cells - visited);
    const double price = price_in_round(m_round);
    const double spent = double(evaluations) - m_evaluations;
    const double stubborn = double(m_number_of_failures);
    double price_later = price_of_stubborn_cell;
    for(std::size_t r = m_round + 1; r < prices.size(); ++r)
      price_later += price_in_round(r);
    const double all_stubborn = stubborn + left * (stubborn + first * m_stubborn_share) / (visited + first);
    m_to_come = left * (spent + first * price) / (visited + first) + all_stubborn * price_later + m_centering;
  }

  // It may take more than was expected: then, less and less is told.
  void work_on_worst_cells(const std::size_t evaluations)
  {
    const double spent = double(evaluations) - m_evaluations;
    m_to_come = m_worst * std::exp(-2 * spent / (m_worst + 1)) + m_centering;
  }

  double price_of_rounds() const
  {
    double price = price_of_stubborn_cell * m_stubborn_share;
    for(std::size_t r = 0; r < 2; ++r)
      price += prices[r];
    return price * m_number_of_bad_cells;
  }

  void tell_part(const double part, const double price, const double price_later)
  {
    m_to_come = (1 - part) * price + price_later;
    m_share = (std::max)(m_share, share(part * price));
  }

  double price_in_round(const std::size_t round) const { return round < 2 ? prices[round] : m_factor * prices[round]; }

  double share(const double evaluations) const
  {
    const double done = m_done + evaluations;
    return done / (done + m_to_come + m_last);
  }

  double m_done = 0;        // beside evaluations
  double m_last = 1;
  double m_centering = 0;
  double m_factor = 1;
  double m_number_of_bad_cells = 0; // at first
  double m_stubborn_share = 0;
  double m_evaluations = 0; // before this round
  double m_number_of_cells = 0;
  std::size_t m_number_of_visits = 0;   // of this round
  std::size_t m_number_of_failures = 0; // of them, those that nothing helped
  bool m_works_on_worst_cells = false;
  std::size_t m_round = 0;
  double m_worst = 0;
  double m_to_come = 0;
  double m_share = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVEMENT_PROGRESS_H
