// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_BAD_CELLS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_BAD_CELLS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Contract_bad_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Flip_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improvement_progress.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Retriangulate_facets_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The account of an operation: what it costs and what it yields, for each kind of cell. An operation that does not pay
 * for a kind of cell is not tried at such cells any more.
 *
 * The price of a try is the number of qualities that it computes; its yield is by how much the sum of badness
 * decreases. Both are counted, and no time is measured, so the same input leads to the same mesh. Each account begins
 * with a credit that grows with the number of cells. Where bad cells are few, the credit is enough for any effort;
 * where they are many, an operation has to yield at least `m_least_rate` for each quality.
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

  // The kind of a cell of this quality; `enough` is the quality from which on a cell is good.
  static Kind kind(const double quality, const double enough)
  {
    return quality < very_bad * enough ? VERY_BAD : quality < half_bad * enough ? BAD : NEARLY_GOOD;
  }

  void open(const Improvement_effort effort, const std::size_t number_of_cells)
  {
    const double factor = factor_of(effort);
    const std::size_t number = (std::max)(number_of_cells, least_number_of_cells);
    m_credits.fill(factor * credit_per_cell * static_cast<double>(number));
    m_least_rate = least_rate / factor;
  }

  // The credit is a share of what a whole account has left.
  void open_part(const Work_account& whole, const double share)
  {
    for(const Kind kind : { VERY_BAD, BAD, NEARLY_GOOD })
      m_credits[kind] = share * (std::max)(0., whole.balance(kind));
    m_least_rate = whole.m_least_rate;
  }

  bool pays(const Kind kind) const { return balance(kind) >= 0; }

  void book(const Kind kind, const std::size_t price, const double yield)
  {
    m_prices[kind] += static_cast<double>(price + price_of_any_try);
    m_yields[kind] += yield;
  }

  // All that a part has booked.
  void book(const Work_account& part)
  {
    for(const Kind kind : { VERY_BAD, BAD, NEARLY_GOOD })
    {
      m_prices[kind] += part.m_prices[kind];
      m_yields[kind] += part.m_yields[kind];
    }
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

  double balance(const Kind kind) const
  {
    return m_credits[kind] + m_yields[kind] / m_least_rate - m_prices[kind];
  }

  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  std::array<double, 3> m_credits = {{ no_limit, no_limit, no_limit }};
  double m_least_rate = least_rate;
  std::array<double, 3> m_prices = {{ 0, 0, 0 }};
  std::array<double, 3> m_yields = {{ 0, 0, 0 }};
};

/*
 * Improves the bad cells of a mesh in rounds, each of which visits the list of bad cells. Cheap operations are tried
 * from the first round on, expensive ones only in later rounds, at the cells that are still bad. In each block of cells
 * that are near each other in space, the worst cell is visited first; without blocks, the work would be slower.
 *
 * An operation is tried at a cell as long as it pays, see `Work_account`. Where it has failed, it is not tried again
 * before something around the cell has changed.
 *
 * No new cell is worse than the worst of the old cells, or, if the measure of badness is lenient, than that measure
 * tolerates. Each operation decreases the sum of badness, or makes the worst cell far better, if this one is nearly
 * flat. So the worst cell of the mesh never gets worse. The rounds end when one of them decreases the sum of badness
 * too little.
 */
template <typename Tr, typename Quality>
class Improve_bad_cells_3
{
public:
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Selected_domain_3<Tr>                Domain;
  typedef Improved_mesh_3<Tr, Quality>         Mesh;
  typedef typename Bad_cells_3<Mesh>::Bad_cell Bad_cell;

  Improve_bad_cells_3(Tr& tr, Domain& domain, const Quality& quality, Recovery_context<Tr>& context)
    : m_context(context), m_mesh(tr, domain, quality, context.visitor()),
      m_bad_cells(m_mesh, [&context] { return context.go_further_after_short_step(); }),
      m_table(m_mesh)
  { }

  Mesh& mesh() { return m_mesh; }
  Bad_cells_3<Mesh>& bad_cells() { return m_bad_cells; }
  Quality_improvement_counts& counts() { return m_counts; }
  const Quality_improvement_counts& counts() const { return m_counts; }

  // Gives each operation its credit and its least rate; before that call, all operations pay. Accounts of the work on
  // nearly flat cells are apart, and are for high effort.
  void open_accounts(const Improvement_effort effort, const std::size_t number_of_cells)
  {
    for_each_entry([&](auto& entry)
    {
      for(std::size_t i = 0; i < entry.accounts.size(); ++i)
        entry.accounts[i].open(i < 2 ? effort : Improvement_effort::high, number_of_cells);
      return false;
    });
  }

  // The same for the work on a part of a mesh: a share of what the accounts of the whole mesh have left.
  void open_accounts_of_part(const Improve_bad_cells_3& whole, const double share)
  {
    for_each_account(whole, [share](Work_account& mine, const Work_account& all) { mine.open_part(all, share); });
  }

  // Books what was done for a part.
  void book(const Improve_bad_cells_3& part)
  {
    for_each_account(part, [](Work_account& mine, const Work_account& account) { mine.book(account); });
  }

  // Whether the accounts of the work on nearly flat cells are booked from now on.
  void set_works_on_nearly_flat_cells(const bool b) { m_works_on_nearly_flat_cells = b; }

  // Whether a cell is skipped in all rounds, if its last visit was before these rounds, and nothing around the cell has
  // changed since that visit.
  void set_visits_only_changed(const bool b) { m_visits_only_changed = b; }

  // Works until nothing helps or pays, or the context says stop.
  void operator()()
  {
    m_is_attempt = false;
    improve(no_limit);
  }

  // The same as a part of an attempt of `Search_locally_3`, which keeps one account for the attempt: operations need
  // not pay here. At most `max_number_of_visits` bad cells are visited.
  void attempt(const std::size_t max_number_of_visits)
  {
    m_is_attempt = true;
    improve(m_number_of_visits + max_number_of_visits);
  }

  // Makes the change that the operation has found. Returns false if it cannot be made.
  template <typename Operation>
  bool apply(Operation& operation)
  {
    if(! operation.apply())
      return false;
    operation.count(m_counts);
    m_bad_cells.push_all(operation.new_cells());
    return true;
  }

  Improvement_progress& progress() { return m_progress; }

  // Which share of the improvement is done.
  void tell_progress()
  {
    m_context.visitor().on_progress(Phase::quality_improvement,
                                    static_cast<std::size_t>(parts_of_progress * m_progress.share()),
                                    parts_of_progress);
  }

  // The bad cells of a part that nothing helped, where its border was in the way.
  const std::vector<Cell_handle>& cells_put_off() const { return m_cells_put_off; }

  // From now on, rounds are those of the work on the worst cells.
  void begin_worst_cells(const std::size_t number_of_worst_cells)
  {
    m_progress.begin_worst_cells(number_of_worst_cells, m_bad_cells.size(), m_mesh.quality().number());
  }

private:
  // What can be done for a bad cell:
  //
  //   bool find(Cell_handle c)                        // searches; returns whether that would help
  //   double gain()                                   // by how much the cells would be less bad
  //   bool apply()                                    // does it; returns false, and does nothing, if that is not valid
  //   new_cells()                                     // the cells that have come, or changed
  //   void count(Quality_improvement_counts& counts)
  //
  // An entry is such an operation, with the first round in which it is tried, how many times in a row it is applied at
  // most, at the cell and at the new cells, and its accounts.
  template <typename Operation, int first_round_, std::size_t max_number_in_a_row_ = 1>
  struct Entry
  {
    static constexpr int first_round = first_round_;
    static constexpr std::size_t max_number_in_a_row = max_number_in_a_row_;

    Operation operation;
    std::array<Work_account, 4> accounts; // of a strict and a lenient measure, which do not count in the same unit;
                                          // the last two for nearly flat cells

    Entry(Mesh& mesh) : operation(mesh) { } // also a conversion
  };

  // Each of them for the same mesh.
  template <typename... Entries>
  struct Table_of
  {
    std::tuple<Entries...> entries;

    explicit Table_of(Mesh& mesh) : entries(mesh_for<Entries>(mesh)...) { }

    template <typename>
    static Mesh& mesh_for(Mesh& mesh) { return mesh; }
  };

  static constexpr int first_expensive_round = 3;

  // In the order in which they are tried.
  typedef Table_of<
    Entry<Flip_bad_cell_3<Mesh>, 1, 50>,
    Entry<Retriangulate_facets_3<Mesh>, 1, 50>,
    Entry<Contract_bad_edge_3<Mesh>, 1>,
    Entry<Smooth_vertex_3<Mesh>, 2, 4>,
    Entry<Deepen_vertex_3<Mesh>, 2, 4>,
    Entry<Insert_into_bad_cell_3<Mesh>, first_expensive_round>,
    Entry<Insert_into_shell_3<Mesh>, first_expensive_round>,
    Entry<Insert_near_bad_cell_3<Mesh>, first_expensive_round> > Table;

  // See "Tuning constants" in the manual.
  static constexpr std::size_t cells_per_block = 4096;
  static constexpr double least_progress = 0.1;
  static constexpr std::size_t visits_per_report = 256;
  static constexpr std::size_t parts_of_progress = 1000;

  static constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();

  // One round after the other.
  void improve(const std::size_t last_visit)
  {
    double last_badness = 0;
    m_begin = m_mesh.time();
    for(m_round = 1; m_number_of_visits < last_visit && m_context.go_further(); ++m_round)
    {
      const std::vector<Bad_cell> cells = m_bad_cells.next_round_in_blocks(cells_per_block);
      const bool is_slow = ! (m_bad_cells.badness() < (1 - least_progress) * last_badness);
      if(cells.empty())
        break;
      if(m_round > first_expensive_round && is_slow)
      {
        m_bad_cells.put_back(cells);
        break;
      }
      last_badness = m_bad_cells.badness();
      ++m_counts.number_of_rounds;
      m_progress.begin_round(m_round, cells.size(), m_mesh.quality().number());
      visit(cells, last_visit);
    }
  }

  // If the context says stop, the list is of no use any more.
  void visit(const std::vector<Bad_cell>& cells, const std::size_t last_visit)
  {
    for(const Bad_cell& c : cells)
      if(! m_context.go_further_after_long_step())
        return;
      else if(m_number_of_visits >= last_visit)
        m_bad_cells.put_back(c);
      else if(m_bad_cells.contains(c.cell))
        visit(c);
  }

  // If nothing around the cell has changed since its last visit, only those operations are tried that begin with this
  // round. If there are none, or if only changed cells are to be visited, the cell goes back to the list.
  void visit(const Bad_cell& c)
  {
    m_progress.visit();
    if(++m_number_of_visits % visits_per_report == 0)
      report();
    const bool is_as_before = c.time > 0 && (m_round > 1 || m_visits_only_changed)
                           && ! m_mesh.has_changed(c.cell, c.time);
    const bool was_left_out = m_visits_only_changed && c.time < m_begin;
    if(is_as_before && (m_round > first_expensive_round || was_left_out))
      m_bad_cells.put_back(c);
    else if(m_mesh.domain().is_at_border(c.cell))
      m_cells_put_off.push_back(c.cell);
    else if(! improve_unless_at_border(c.cell, is_as_before ? m_round : 1))
    {
      m_bad_cells.push(c.cell, m_mesh.time());
      m_progress.fail();
    }
  }

  // The same as `improve()`, but cells where nothing helped because of the border of a part are put off.
  bool improve_unless_at_border(const Cell_handle c, const int first_round)
  {
    m_mesh.domain().forget_border();
    if(improve(c, first_round))
      return true;
    if(m_mesh.domain().is_border_met())
      m_cells_put_off.push_back(c);
    return m_mesh.domain().is_border_met();
  }

  // Tries the operations whose first round is at least `first_round` and has come, until one of them changes the mesh.
  // Returns whether one did.
  bool improve(const Cell_handle c, const int first_round)
  {
    const Work_account::Kind kind = Work_account::kind(m_mesh.quality(c), m_mesh.enough());
    return for_each_entry([&](auto& entry)
    {
      return entry.first_round >= first_round && entry.first_round <= m_round && try_at(c, entry, kind);
    });
  }

  // Until one returns true. Returns whether one did.
  template <typename Function>
  bool for_each_entry(const Function& f)
  {
    return std::apply([&](auto&... entry) { return (f(entry) || ...); }, m_table.entries);
  }

  // Each account, with the same one of `other`.
  template <typename Function>
  void for_each_account(const Improve_bad_cells_3& other, const Function& f)
  {
    for_each_entry([&](auto& entry)
    {
      const auto& others = std::get<std::decay_t<decltype(entry)> >(other.m_table.entries).accounts;
      for(std::size_t i = 0; i < others.size(); ++i)
        f(entry.accounts[i], others[i]);
      return false;
    });
  }

  // As long as that pays.
  template <typename Entry_>
  bool try_at(const Cell_handle c, Entry_& entry, const Work_account::Kind kind)
  {
    if(m_is_attempt)
      return apply_at(c, entry) > 0;
    const bool is_lenient = m_mesh.measure_of_badness().is_lenient();
    Work_account& account = entry.accounts[2 * m_works_on_nearly_flat_cells + is_lenient];
    if(! account.pays(kind))
      return false;
    const std::size_t price_before = m_mesh.quality().number();
    m_gain = 0;
    const bool is_done = apply_at(c, entry) > 0;
    account.book(kind, m_mesh.quality().number() - price_before, m_gain);
    return is_done;
  }

  // Applies an operation at the cell, then at the new cells that are bad, at most `max_number_in_a_row` times. Returns
  // how many times it was applied.
  template <typename Entry_>
  std::size_t apply_at(const Cell_handle c, Entry_& entry)
  {
    m_stack.assign(1, c);
    std::size_t number = 0;
    while(! m_stack.empty() && number < entry.max_number_in_a_row)
    {
      const Cell_handle d = m_stack.back();
      m_stack.pop_back();
      if(! m_bad_cells.contains(d) || ! entry.operation.find(d) || ! apply(entry.operation))
        continue;
      ++number;
      m_gain += entry.operation.gain();
      m_stack.insert(m_stack.end(), entry.operation.new_cells().begin(), entry.operation.new_cells().end());
    }
    return number;
  }

  void report()
  {
    m_progress.work(m_mesh.quality().number());
    tell_progress();
  }

  Recovery_context<Tr>& m_context;
  Mesh m_mesh;
  Bad_cells_3<Mesh> m_bad_cells;
  Table m_table;
  Quality_improvement_counts m_counts;
  std::vector<Cell_handle> m_stack;
  std::vector<Cell_handle> m_cells_put_off;
  int m_round = 0;
  std::size_t m_begin = 0; // of these rounds, in changes of the mesh
  double m_gain = 0; // of an operation in a row
  bool m_is_attempt = false;
  bool m_visits_only_changed = false;
  bool m_works_on_nearly_flat_cells = false;
  std::size_t m_number_of_visits = 0;
  Improvement_progress m_progress;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_BAD_CELLS_3_H
