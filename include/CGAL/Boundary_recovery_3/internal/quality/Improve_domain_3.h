// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/sort_in_space.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Center_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Contract_bad_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Deepen_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Flip_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_into_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_into_shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_near_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Lift_layer_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_at_random_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Reconnect_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Smooth_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Vain_attempts_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Walls_at_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Improves the cells of a domain, step 7 of [CZZ+17, Section 4.1]: works through the list of its bad cells, again and
 * again. What is cheap is done for all of them; the dear operations follow, for what that leaves. The worst one comes
 * first, but at first, when there are many, that is so in blocks of cells that are near each other, which is faster.
 *
 * No operation leaves a cell that is worse than the worst one of those that it changes, and each makes the sum of the
 * badness of the cells smaller, or the worst one better by far, where that is nearly flat. So the work ends, and the
 * worst cell of the mesh does not get worse.
 *
 * Then, only those cells count that are really bad, others may get worse for them, and all operations are tried. For
 * what that leaves, beside the thin triangles of a surface, a few cells may become very bad so that many are not; and a
 * few times, the mesh is perturbed, which the next operations make up for, or that is taken back. Those that are nearly
 * as bad, or the worst ones where these are few, are worked on afterwards, so that the worst ones have the choice. At
 * last, all the others get rounder, where that is for nothing.
 */
template <typename Tr, typename Domain, typename Quality, typename Visitor>
class Improve_domain_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;

  Improve_domain_3(Tr& tr, Domain& domain, const Quality& quality, Recovery_context<Visitor>& context)
    : m_quality(quality), m_context(context), m_mesh(tr, domain, quality, context.visitor()), m_bad_cells(m_mesh),
      m_vain_contractions(m_bad_cells), m_vain_smoothings(m_bad_cells), m_vain_deepenings(m_bad_cells),
      m_vain_lifts(m_bad_cells), m_flip(m_mesh), m_contract(m_mesh), m_smooth(m_mesh, quality),
      m_deepen(m_mesh, quality), m_lift(m_mesh), m_insert(m_mesh, quality), m_insert_into_shell(m_mesh, quality),
      m_insert_near(m_mesh, quality), m_reconnect(m_mesh), m_move_at_random(m_mesh),
      m_center(m_mesh), m_walls_at_edge(domain)
  { }

  // The dihedral angle, in degrees, that no cell is to be below. To be set before cells are added.
  void set_target(const double min_dihedral_angle)
  {
    m_target = min_dihedral_angle;
    set_enough(m_target);
  }

  // To be called for each cell of the domain.
  void add(const Cell_handle c)
  {
    m_mesh.add_lengths(c);
    m_worst = (std::min)(m_worst, m_bad_cells.push(c));
  }

  // Nothing is tolerated. For a mesh that is improved several times: that would add up.
  void be_strict() { m_is_strict = true; }

  // Improves the mesh until all cells are good, or nothing helps, or the context says stop.
  void operator()()
  {
    m_mesh.spread_lengths();
    improve(max_number_of_rounds, false);
    if(m_target > really_bad_angle)
    {
      set_enough(really_bad_angle);
      improve(max_number_of_last_rounds, true);
      if(! m_is_strict)
        improve_with_perturbations();
      improve_nearly_as_bad_cells();
    }
    if(m_target > 0)
      center_vertices();
    tell_progress(m_number_of_visits);
  }

  // All of this in one.
  void operator()(const double min_dihedral_angle)
  {
    set_target(min_dihedral_angle);
    for(const Cell_handle c : m_mesh.triangulation().finite_cell_handles())
      if(m_mesh.domain().contains(c))
        add(c);
    (*this)();
  }

  const Quality_improvement_counts& counts() const { return m_counts; }

private:
  typedef Improved_mesh_3<Tr, Domain, Quality, Visitor> Mesh;
  typedef typename Bad_cells_3<Mesh>::Bad_cell          Bad_cell;

  // See "Tuning constants" in the manual.
  static constexpr double really_bad_angle = 12;
  static constexpr double flat_angle = 0.5;
  static constexpr double nearly_as_bad_angle = 16;
  static constexpr std::size_t cells_per_nearly_bad_cell = 1000; // so many are worked on above that angle
  static constexpr std::size_t cells_per_block = 4096;
  static constexpr int max_number_of_rounds = 6;
  static constexpr int max_number_of_last_rounds = 12;
  static constexpr int first_dear_round = 3;
  static constexpr double least_progress = 0.1;
  static constexpr int number_of_perturbations = 2;
  static constexpr std::size_t max_number_of_perturbed_cells = 2500;
  static constexpr double tolerated_loss = 1;
  static constexpr int max_number_of_searches = 60; // through all bad cells
  static constexpr std::size_t max_number_of_attempts = 3000;
  static constexpr std::size_t max_number_of_visits = 50; // in an attempt
  static constexpr double share_of_insertions = 0.25; // of the attempts
  static constexpr double tolerated_loss_of_attempt = 3;
  static constexpr double least_gain = 1e-6;
  static constexpr std::size_t max_number_of_flips = 50;
  static constexpr std::size_t visits_per_report = 2048;
  static constexpr std::size_t expected_number_of_visits = 3; // of each cell that is bad at first

  static constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();

  void set_enough(const double degrees) { set_measure_of_badness(m_quality.of_angle(degrees)); }

  void set_measure_of_badness(const Badness_3& badness)
  {
    m_mesh.set_measure_of_badness(badness);
    m_vain_contractions.clear();
    m_vain_smoothings.clear();
    m_vain_deepenings.clear();
    m_vain_lifts.clear();
  }

  void improve(const int max_number, const bool tries_all)
  {
    double last_badness = 0;
    for(m_round = 1; m_round <= max_number && m_number_of_visits < m_last_visit && m_context.go_further(); ++m_round)
    {
      const std::vector<Bad_cell> cells = tries_all ? m_bad_cells.next_round()
                                                    : m_bad_cells.next_round_in_blocks(cells_per_block);
      const bool is_slow = m_bad_cells.badness() > (1 - least_progress) * last_badness;
      if(cells.empty())
        break;
      if(m_round > first_dear_round && is_slow)
      {
        put_back(cells);
        break;
      }
      last_badness = m_bad_cells.badness();
      if(m_number_of_visits == 0)
        m_expected_visits = expected_number_of_visits * cells.size();
      m_tries_all = tries_all;
      ++m_counts.number_of_rounds;
      for(const Bad_cell& c : cells)
        if(m_number_of_visits >= m_last_visit)
          m_bad_cells.put_back(c);
        else if(m_bad_cells.contains(c.cell) && m_context.go_further_after_short_step())
          visit(c);
    }
  }

  // Those below an angle, and if these are few, the worst ones below the target. The list has only those that were bad
  // enough before.
  void improve_nearly_as_bad_cells()
  {
    set_enough(m_target);
    std::vector<double> qualities;
    for(const Cell_handle c : m_mesh.triangulation().finite_cell_handles())
      if(m_mesh.domain().contains(c))
        qualities.push_back(m_bad_cells.push(c));
    if(qualities.empty())
      return;
    const double least = m_quality.of_angle((std::min)(m_target, nearly_as_bad_angle));
    set_measure_of_badness(std::clamp(quality_of_few(qualities), least, m_quality.of_angle(m_target)));
    improve(max_number_of_last_rounds, true);
  }

  // The quality that only few of these are below.
  static double quality_of_few(std::vector<double>& qualities)
  {
    const auto few = qualities.begin() + static_cast<std::ptrdiff_t>(qualities.size() / cells_per_nearly_bad_cell);
    std::nth_element(qualities.begin(), few, qualities.end());
    return *few;
  }

  // Where nothing helps any more, vertices are inserted near the worst cells though that makes others bad, and all
  // operations have another turn. That gets out of states that no single operation makes better.
  void improve_with_perturbations()
  {
    improve_leniently();
    m_visits_only_changed = true;
    for(int k = 0; k < number_of_perturbations && m_context.go_further(); ++k)
    {
      perturb();
      set_enough(really_bad_angle);
      improve(max_number_of_last_rounds, true);
      improve_leniently();
    }
    search_locally();
    m_visits_only_changed = false;
  }

  void perturb()
  {
    std::size_t number = 0;
    for(const Bad_cell& c : m_bad_cells.next_round())
    {
      if(! m_bad_cells.contains(c.cell))
        continue;
      m_bad_cells.begin_visit();
      const bool is_turn = number++ < max_number_of_perturbed_cells && m_context.go_further_after_short_step();
      if(! is_turn || ! insert_near(c.cell, tolerated_loss))
        m_bad_cells.put_back(c);
    }
  }

  // No cell gets worse than the worst one is.
  void improve_leniently()
  {
    const std::vector<Bad_cell> cells = m_bad_cells.next_round();
    if(cells.empty())
      return;
    set_measure_of_badness(Badness_3(m_mesh.enough(), cells.front().quality));
    put_back(cells);
    improve(max_number_of_last_rounds, true);
  }

  void put_back(const std::vector<Bad_cell>& cells)
  {
    for(const Bad_cell& c : cells)
      m_bad_cells.put_back(c);
  }

  // *Iterated local search*: the mesh is perturbed near one bad cell after the other, and all operations have a turn
  // there. If the cells are not better then, all of that is taken back.
  void search_locally()
  {
    std::size_t number_of_attempts = 0;
    std::vector<Bad_cell> forced_cells;
    for(int k = 0; k < max_number_of_searches && m_context.go_further(); ++k)
    {
      std::vector<Bad_cell> cells;
      for(const Bad_cell& c : m_bad_cells.next_round())
      {
        if(! m_bad_cells.contains(c.cell))
          continue;
        if(internal::is_forced(m_walls_at_edge, c.cell, really_bad_angle))
          forced_cells.push_back(c);
        else if(number_of_attempts < max_number_of_attempts && m_context.go_further_after_short_step())
        {
          number_of_attempts += attempt(c.cell);
          const std::vector<Bad_cell> around = m_bad_cells.take();
          cells.insert(cells.end(), around.begin(), around.end());
        }
        else
          cells.push_back(c);
      }
      put_back(cells);
    }
    put_back(forced_cells);
  }

  // Afterwards, the bad cells that are new or back are in the list. Returns whether the mesh could be perturbed.
  bool attempt(const Cell_handle c)
  {
    const Quality_improvement_counts counts = m_counts;
    m_bad_cells.begin_visit();
    m_mesh.begin_attempt();
    const bool is_perturbed = perturb_near(c);
    if(is_perturbed)
    {
      m_last_visit = m_number_of_visits + max_number_of_visits;
      improve(max_number_of_last_rounds, true);
      m_last_visit = no_limit;
    }
    if(m_mesh.gain_of_attempt() > least_gain)
      m_mesh.keep_attempt();
    else
    {
      m_bad_cells.take();
      m_bad_cells.push_changed(m_mesh.undo_attempt());
      m_counts = counts;
    }
    if(! is_perturbed)
      m_bad_cells.push(c);
    return is_perturbed;
  }

  // At random.
  bool perturb_near(const Cell_handle c)
  {
    if(m_random.get_double() < share_of_insertions)
    {
      if(! m_insert_near.find_any(c, tolerated_loss_of_attempt, m_random))
        return false;
      m_insert_near.apply();
      note_insertion(m_insert_near);
    }
    else
    {
      if(! m_move_at_random(c, m_random))
        return false;
      ++m_counts.number_of_moved_vertices;
      m_bad_cells.push_changed(m_move_at_random.cells());
    }
    return true;
  }

  void visit(const Bad_cell& c)
  {
    if(++m_number_of_visits % visits_per_report == 0)
      tell_progress((std::max)(m_expected_visits, m_number_of_visits));
    m_bad_cells.begin_visit();
    const bool is_as_before = (m_round > 1 || m_visits_only_changed) && ! m_bad_cells.has_changed(c);
    if(is_as_before && (m_round > first_dear_round || m_visits_only_changed))
      m_bad_cells.put_back(c);
    else if(! improve(c.cell, ! is_as_before))
      m_bad_cells.push(c.cell);
  }

  // Flips would fail again where nothing has changed. Returns whether the cell was changed.
  bool improve(const Cell_handle c, const bool may_flip)
  {
    return (may_flip && flip(c)) || contract(c)
        || (m_round > 1 && (smooth(c) || (m_tries_all && deepen(c))))
        || (m_round >= first_dear_round && (insert(c) || (m_tries_all && (insert_into_shell(c) || reconnect(c)
                                                                          || insert_near(c)))));
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

  // If all cells are better than asked for, none gets worse than the worst one was.
  void center_vertices()
  {
    m_mesh.set_enough((std::max)(m_quality.of_angle(m_target), m_worst));
    const auto all = m_mesh.triangulation().finite_vertex_handles();
    std::vector<Vertex_handle> vertices(all.begin(), all.end());
    internal::sort_in_space(vertices, &Mesh::coordinates);
    for(const Vertex_handle v : vertices)
    {
      if(! m_context.go_further_after_short_step())
        break;
      m_counts.number_of_moved_vertices += m_center(v);
    }
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

  bool insert_near(const Cell_handle c, const double tolerated_loss = 0)
  {
    if(! m_insert_near.find(c, tolerated_loss))
      return false;
    m_insert_near.apply();
    note_insertion(m_insert_near);
    return true;
  }

  template <typename Insertion>
  void note_insertion(const Insertion& insertion)
  {
    ++m_counts.number_of_inserted_points;
    m_counts.number_of_removed_vertices += insertion.number_of_removed_vertices();
    m_bad_cells.push_changed(insertion.new_cells());
  }

  bool reconnect(const Cell_handle c)
  {
    if(! m_reconnect.find(c))
      return false;
    m_reconnect.apply();
    ++m_counts.number_of_reconnected_polyhedra;
    m_bad_cells.push_changed(m_reconnect.new_cells());
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
  Reconnect_bad_cell_3<Mesh> m_reconnect;
  Move_at_random_3<Mesh> m_move_at_random;
  Center_vertex_3<Mesh> m_center;
  Walls_at_edge_3<Tr, Domain> m_walls_at_edge;
  CGAL::Random m_random = CGAL::Random(0); // always the same numbers
  Quality_improvement_counts m_counts;
  std::vector<Cell_handle> m_stack;
  double m_target = 0;
  double m_worst = std::numeric_limits<double>::infinity(); // of the qualities of all cells at first
  int m_round = 0;
  bool m_tries_all = false; // operations, in the last stages
  bool m_visits_only_changed = false; // cells, also in the first rounds
  bool m_is_strict = false;
  std::size_t m_number_of_visits = 0;
  std::size_t m_last_visit = no_limit; // by number, in an attempt
  std::size_t m_expected_visits = 0;
  double m_told_share = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H
