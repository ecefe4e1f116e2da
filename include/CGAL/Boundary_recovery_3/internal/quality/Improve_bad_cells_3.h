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
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Contract_bad_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Deepen_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Flip_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_into_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_into_shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_near_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Lift_layer_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Smooth_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Vain_attempts_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Work_account.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Works through the list of the bad cells of a mesh, again and again. What is cheap is done for all of them; the
 * expensive operations follow, for what that leaves. The worst one comes first, but at first, when there are many, that
 * is so in blocks of cells that are near each other, which is faster.
 *
 * An operation is tried at a cell as long as it pays, see `Work_account`, and not again where it failed, before
 * something around the cell has changed.
 *
 * No operation leaves a cell that is worse than the worst one of those that it changes, or than the measure of badness
 * tolerates, and each makes the sum of the badness of the cells smaller, or the worst one better by far, where that is
 * nearly flat. So the work ends, and the worst cell of the mesh does not get worse.
 */
template <typename Tr, typename Domain, typename Quality, typename Visitor>
class Improve_bad_cells_3
{
public:
  typedef Improved_mesh_3<Tr, Domain, Quality, Visitor> Mesh;
  typedef typename Tr::Vertex_handle                    Vertex_handle;
  typedef typename Tr::Cell_handle                      Cell_handle;
  typedef typename Bad_cells_3<Mesh>::Bad_cell          Bad_cell;

  Improve_bad_cells_3(Tr& tr, Domain& domain, const Quality& quality, Recovery_context<Visitor>& context)
    : m_quality(quality), m_context(context), m_mesh(tr, domain, quality, context.visitor()),
      m_bad_cells(m_mesh, [&context] { return context.go_further_after_short_step(); }),
      m_vain_contractions(m_bad_cells), m_vain_smoothings(m_bad_cells), m_vain_deepenings(m_bad_cells),
      m_vain_lifts(m_bad_cells), m_flip(m_mesh), m_contract(m_mesh), m_smooth(m_mesh), m_deepen(m_mesh),
      m_lift(m_mesh), m_insert(m_mesh), m_insert_into_shell(m_mesh), m_insert_near(m_mesh)
  { }

  Mesh& mesh() { return m_mesh; }
  Bad_cells_3<Mesh>& bad_cells() { return m_bad_cells; }
  Quality_improvement_counts& counts() { return m_counts; }
  const Quality_improvement_counts& counts() const { return m_counts; }

  // From now on, this is what is bad.
  void set_measure_of_badness(const Badness_3& badness)
  {
    m_mesh.set_measure_of_badness(badness);
    m_vain_contractions.clear();
    m_vain_smoothings.clear();
    m_vain_deepenings.clear();
    m_vain_lifts.clear();
  }

  // From now on, what operations cost is booked, against what they earn. A strict measure of badness and a lenient one
  // have accounts of their own, since they do not count in the same unit.
  void open_accounts(const Improvement_effort effort, const std::size_t number_of_cells)
  {
    for(Accounts& accounts : m_accounts)
      for(Work_account& account : accounts)
        account.open(effort, number_of_cells);
  }

  // Nothing is tolerated.
  void be_strict() { m_is_strict = true; }
  bool is_strict() const { return m_is_strict; }

  // Whether cells where nothing has changed are left out also in the first round.
  void set_visits_only_changed(const bool b) { m_visits_only_changed = b; }

  // Works until nothing helps or pays, or the context says stop.
  void operator()()
  {
    m_is_attempt = false;
    improve(no_limit);
  }

  // The same for an attempt, which has an account of its own: visits so many bad cells at most.
  void attempt(const std::size_t max_number_of_visits)
  {
    m_is_attempt = true;
    improve(m_number_of_visits + max_number_of_visits);
  }

  // Vertices were inserted.
  template <typename Insertion>
  void note_insertion(const Insertion& insertion)
  {
    ++m_counts.number_of_inserted_points;
    m_counts.number_of_removed_vertices += insertion.number_of_removed_vertices();
    m_bad_cells.push_changed(insertion.new_cells());
  }

  // No more visits are to come.
  void finish() { tell_progress(m_number_of_visits); }

private:
  // What can be done for a bad cell, and from which round on.
  struct Operation
  {
    bool (Improve_bad_cells_3::*apply_at)(Cell_handle);
    int first_round;
  };

  typedef std::array<Operation, 7> Operations;
  typedef std::array<Work_account, std::tuple_size<Operations>::value> Accounts;

  // In the order in which they are tried.
  static const Operations& operations()
  {
    static const Operations table = {{
      { &Improve_bad_cells_3::flip, 1 },
      { &Improve_bad_cells_3::contract, 1 },
      { &Improve_bad_cells_3::smooth, 2 },
      { &Improve_bad_cells_3::deepen, 2 },
      { &Improve_bad_cells_3::insert, first_expensive_round },
      { &Improve_bad_cells_3::insert_into_shell, first_expensive_round },
      { &Improve_bad_cells_3::insert_near, first_expensive_round } }};
    return table;
  }

  // See "Tuning constants" in the manual.
  static constexpr double flat_angle = 0.5;
  static constexpr int max_number_of_rounds = 12;
  static constexpr std::size_t cells_per_block = 4096;
  static constexpr int first_expensive_round = 3;
  static constexpr double least_progress = 0.1;
  static constexpr std::size_t max_number_of_flips = 50;
  static constexpr std::size_t visits_per_report = 2048;
  static constexpr std::size_t expected_number_of_visits = 3; // of each cell that is bad at first

  static constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();

  // One round after the other.
  void improve(const std::size_t last_visit)
  {
    double last_badness = 0;
    m_first_visit = m_bad_cells.visit() + 1;
    for(m_round = 1; m_round <= max_number_of_rounds && m_number_of_visits < last_visit && m_context.go_further();
        ++m_round)
    {
      const std::vector<Bad_cell> cells = m_bad_cells.next_round_in_blocks(cells_per_block);
      const bool is_slow = m_bad_cells.badness() > (1 - least_progress) * last_badness;
      if(cells.empty())
        break;
      if(m_round > first_expensive_round && is_slow)
      {
        m_bad_cells.put_back(cells);
        break;
      }
      last_badness = m_bad_cells.badness();
      if(m_number_of_visits == 0)
        m_expected_visits = expected_number_of_visits * cells.size();
      ++m_counts.number_of_rounds;
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

  // Where nothing has changed since the last round, there is only what was not tried in it; or nothing, if only what
  // changed before is visited.
  void visit(const Bad_cell& c)
  {
    if(++m_number_of_visits % visits_per_report == 0)
      tell_progress((std::max)(m_expected_visits, m_number_of_visits));
    m_bad_cells.begin_visit();
    const bool is_as_before = (m_round > 1 || m_visits_only_changed) && ! m_bad_cells.has_changed(c);
    const bool was_left_out = m_visits_only_changed && c.visit < m_first_visit;
    if(is_as_before && (m_round > first_expensive_round || was_left_out))
      m_bad_cells.put_back(c);
    else if(! improve(c.cell, is_as_before ? m_round : 1))
      m_bad_cells.push(c.cell);
  }

  // By one of the operations from that round on. Returns whether the cell was changed.
  bool improve(const Cell_handle c, const int first_round)
  {
    const Work_account::Kind kind = Work_account::kind(m_mesh.quality(c), m_mesh.enough());
    auto account = m_accounts[m_mesh.measure_of_badness().is_lenient()].begin();
    for(const Operation& operation : operations())
    {
      if(operation.first_round >= first_round && operation.first_round <= m_round
         && try_at(c, operation, *account, kind))
        return true;
      ++account;
    }
    return false;
  }

  bool try_at(const Cell_handle c, const Operation& operation, Work_account& account, const Work_account::Kind kind)
  {
    if(m_is_attempt)
      return (this->*operation.apply_at)(c);
    if(! account.pays(kind))
      return false;
    const std::size_t price_before = m_mesh.quality().number();
    const double gain_before = m_mesh.total_gain();
    const bool is_done = (this->*operation.apply_at)(c);
    account.book(kind, m_mesh.quality().number() - price_before, m_mesh.total_gain() - gain_before);
    return is_done;
  }

  // Flips what comes from a cell, until that does not help any more.
  bool flip(const Cell_handle c)
  {
    m_stack.assign(1, c);
    std::size_t number_of_flips = 0;
    while(! m_stack.empty())
    {
      const Cell_handle d = m_stack.back();
      m_stack.pop_back();
      if(! m_bad_cells.contains(d))
        continue;
      if(number_of_flips < max_number_of_flips && m_flip(d))
      {
        ++number_of_flips;
        ++(m_flip.is_edge_removed() ? m_counts.number_of_removed_edges : m_counts.number_of_removed_facets);
        m_bad_cells.note_change(m_flip.new_cells());
        m_stack.insert(m_stack.end(), m_flip.new_cells().begin(), m_flip.new_cells().end());
      }
      else if(number_of_flips > 0)
        m_bad_cells.push(d);
    }
    return number_of_flips > 0;
  }

  // Contracts the edge at a vertex of the cell that helps most.
  bool contract(const Cell_handle c)
  {
    double gain = 0;
    int best = -1;
    for(int i = 0; i < 4; ++i)
    {
      const Vertex_handle v = c->vertex(i);
      if(m_vain_contractions.contains(v))
        continue;
      if(m_contract.find(v, gain))
      {
        gain = m_contract.gain();
        best = i;
      }
      else if(gain == 0)
        m_vain_contractions.add(v);
    }
    if(best < 0 || ! m_contract.find(c->vertex(best), 0) || ! m_contract.apply())
      return false;
    ++m_counts.number_of_removed_vertices;
    m_bad_cells.push_changed(m_contract.new_cells());
    return true;
  }

  bool smooth(const Cell_handle c) { return move_vertices(c, m_mesh.enough(), m_smooth, m_vain_smoothings); }

  // Moves the vertices of a nearly flat cell to where they see all around them best, whatever that does to the others.
  bool deepen(const Cell_handle c)
  {
    return ! m_is_strict
        && (move_vertices(c, m_quality.of_angle(flat_angle), m_deepen, m_vain_deepenings) ||
            move_vertices(c, Lift_layer_3<Mesh>::flat * m_mesh.enough(), m_lift, m_vain_lifts));
  }

  // Moves the vertices of the cell, until its quality is `enough`.
  template <typename Move>
  bool move_vertices(const Cell_handle c, const double enough, Move& move, Vain_attempts_3<Mesh>& vain_attempts)
  {
    bool is_changed = false;
    for(int i = 0; i < 4 && m_mesh.quality(c) < enough; ++i)
    {
      const Vertex_handle v = c->vertex(i);
      if(vain_attempts.contains(v))
        continue;
      if(move(v))
      {
        is_changed = true;
        ++m_counts.number_of_moved_vertices;
        m_bad_cells.push_changed(move.cells());
      }
      else
        vain_attempts.add(v);
    }
    return is_changed;
  }

  bool insert(const Cell_handle c)
  {
    if(! m_insert.find(c) || ! m_insert.apply())
      return false;
    note_insertion(m_insert);
    return true;
  }

  // If the cell is nearly flat, at a loss.
  bool insert_into_shell(const Cell_handle c)
  {
    const bool is_flat = m_mesh.quality(c) < Insert_into_shell_3<Mesh>::flat * m_mesh.enough();
    if(m_is_strict || ! is_flat || ! m_insert_into_shell.find(c))
      return false;
    m_insert_into_shell.apply();
    note_insertion(m_insert_into_shell);
    return true;
  }

  bool insert_near(const Cell_handle c)
  {
    if(! m_insert_near.find(c))
      return false;
    m_insert_near.apply();
    note_insertion(m_insert_near);
    return true;
  }

  // More visits may come to be expected; what was told does not fall for that.
  void tell_progress(const std::size_t expected_visits)
  {
    const double share = static_cast<double>(m_number_of_visits) / static_cast<double>(expected_visits);
    if(! (share >= m_told_share)) // nor is there anything to be told if nothing is bad
      return;
    m_told_share = share;
    m_context.visitor().on_progress(Meshing_phase::quality_improvement, m_number_of_visits, expected_visits);
  }

  const Quality& m_quality;
  Recovery_context<Visitor>& m_context;
  Mesh m_mesh;
  Bad_cells_3<Mesh> m_bad_cells;
  Vain_attempts_3<Mesh> m_vain_contractions, m_vain_smoothings, m_vain_deepenings, m_vain_lifts;
  Flip_bad_cell_3<Mesh> m_flip;
  Contract_bad_edge_3<Mesh> m_contract;
  Smooth_vertex_3<Mesh> m_smooth;
  Deepen_vertex_3<Mesh> m_deepen;
  Lift_layer_3<Mesh> m_lift;
  Insert_into_bad_cell_3<Mesh> m_insert;
  Insert_into_shell_3<Mesh> m_insert_into_shell;
  Insert_near_bad_cell_3<Mesh> m_insert_near;
  std::array<Accounts, 2> m_accounts; // of a strict and a lenient measure
  Quality_improvement_counts m_counts;
  std::vector<Cell_handle> m_stack;
  int m_round = 0;
  std::size_t m_first_visit = 0; // of these rounds
  bool m_is_attempt = false;
  bool m_visits_only_changed = false;
  bool m_is_strict = false;
  std::size_t m_number_of_visits = 0;
  std::size_t m_expected_visits = 0;
  double m_told_share = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_BAD_CELLS_3_H
