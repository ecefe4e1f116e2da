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

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/sort_in_space.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Owned_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * *Iterated local search* [LMS03]: the mesh is perturbed near one bad cell after the other, and all operations have a
 * turn there. If the cells are not less bad then, all of that is taken back.
 */
template <typename Tr, typename Quality>
class Search_locally_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Selected_domain_3<Tr>                Domain;
  typedef Improve_bad_cells_3<Tr, Quality>     Improve_bad_cells;
  typedef typename Improve_bad_cells::Mesh     Mesh;
  typedef typename Improve_bad_cells::Bad_cell Bad_cell;

  Search_locally_3(Improve_bad_cells& improve, const Domain& domain, Recovery_context<Tr>& context)
    : m_improve(improve), m_context(context), m_mesh(improve.mesh()), m_bad_cells(improve.bad_cells()),
      m_walls_at_edge(domain), m_insert_near(m_mesh), m_move_at_random(m_mesh)
  { }

  // For all bad cells but those that are forced to be below `angle`, in degrees, as long as attempts pay. Without an
  // account, all of them do.
  void operator()(const double angle, const Work_account& account = Work_account())
  {
    m_account = account;
    std::vector<Bad_cell> forced_cells;
    for(int k = 0; k < max_number_of_searches && pays() && m_context.go_further(); ++k)
    {
      std::vector<Bad_cell> cells;
      for(const Bad_cell& c : m_bad_cells.next_round())
      {
        if(! m_context.go_further_after_long_step())
          return;
        if(! m_bad_cells.contains(c.cell))
          continue;
        if(internal::is_forced(m_walls_at_edge, c.cell, angle))
          forced_cells.push_back(c);
        else if(pays())
        {
          attempt(c.cell);
          const std::vector<Bad_cell> around = m_bad_cells.take();
          cells.insert(cells.end(), around.begin(), around.end());
        }
        else
          cells.push_back(c);
      }
      m_bad_cells.put_back(cells);
    }
    m_bad_cells.put_back(forced_cells);
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr int max_number_of_searches = 60; // through all bad cells
  static constexpr std::size_t max_number_of_visits = 25; // in an attempt
  static constexpr double share_of_insertions = 0.25; // of the attempts
  static constexpr int max_number_of_tries = 5; // of an insertion, or a move
  static constexpr double tolerated_loss = 3;
  static constexpr double least_gain = 1e-6;

  // All of these cells are bad ones that nothing else helped.
  bool pays() const { return m_account.pays(Work_account::VERY_BAD); }

  // Afterwards, the bad cells that are new or back are in the list.
  void attempt(const Cell_handle c)
  {
    const std::size_t price_before = m_mesh.quality().number();
    const Quality_improvement_counts counts = m_improve.counts();
    m_mesh.begin_attempt();
    const bool is_perturbed = perturb_near(c);
    push_if_bad(c);
    if(is_perturbed)
      m_improve.attempt(max_number_of_visits);
    const double gain = m_mesh.gain_of_attempt();
    m_account.book(Work_account::VERY_BAD, m_mesh.quality().number() - price_before, (std::max)(0., gain));
    if(gain > least_gain)
      m_mesh.keep_attempt();
    else
    {
      m_bad_cells.take();
      m_bad_cells.push_all(m_mesh.undo_attempt());
      push_if_bad(c);
      m_improve.counts() = counts;
    }
  }

  // The cell itself may be gone, or not be one of those that are changed.
  void push_if_bad(const Cell_handle c)
  {
    if(m_bad_cells.contains(c))
      m_bad_cells.push(c);
  }

  // At random.
  bool perturb_near(const Cell_handle c)
  {
    set_vertices(c);
    const bool is_inserted = m_random.get_double() < share_of_insertions;
    for(int k = 0; k < max_number_of_tries; ++k)
      if(is_inserted ? insert_near(c) : move_any_vertex())
        return true;
    return false;
  }

  bool insert_near(const Cell_handle c)
  {
    return m_insert_near.find_any(c, tolerated_loss, m_random) && m_improve.apply(m_insert_near);
  }

  bool move_any_vertex()
  {
    const Vertex_handle v = m_vertices[m_random.uniform_int<std::size_t>(0, m_vertices.size() - 1)];
    return m_move_at_random.find(v) && m_improve.apply(m_move_at_random);
  }

  // Those of the cell, and of its neighbors.
  void set_vertices(const Cell_handle c)
  {
    m_vertices.clear();
    for(int i = 0; i < 4; ++i)
      add_vertex(c->vertex(i));
    for(int i = 0; i < 4; ++i)
      if(! m_mesh.domain().is_wall(c, i))
        add_vertex(c->neighbor(i)->vertex(c->neighbor(i)->index(c)));
  }

  void add_vertex(const Vertex_handle v)
  {
    if(! internal::contains(m_vertices, v))
      m_vertices.push_back(v);
  }

  Improve_bad_cells& m_improve;
  Recovery_context<Tr>& m_context;
  Mesh& m_mesh;
  Bad_cells_3<Mesh>& m_bad_cells;
  Walls_at_edge_3<Tr> m_walls_at_edge;
  Insert_near_bad_cell_3<Mesh> m_insert_near;
  Move_at_random_3<Mesh> m_move_at_random;
  std::vector<Vertex_handle> m_vertices; // near the cell
  Work_account m_account;
  CGAL::Random m_random = CGAL::Random(0); // always the same numbers
};

/*
 * Improves the cells of a domain, step 7 of [CZZ+17, Section 4.1]: first all that are below the target, see
 * `Improve_bad_cells_3`.
 *
 * Then only nearly flat cells count, and after that only really bad ones: others may get worse for them, in the end a
 * few even very bad, and the mesh is searched around each cell that stays. Where that has changed something, all cells
 * below the target have another turn. At last, all the others get rounder, where that is for nothing.
 */
template <typename Tr, typename Quality>
class Improve_domain_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef Selected_domain_3<Tr>      Domain;
  typedef typename Improve_bad_cells_3<Tr, Quality>::Bad_cell Bad_cell;

  Improve_domain_3(Tr& tr, Domain& domain, const Quality& quality, Recovery_context<Tr>& context)
    : m_quality(quality), m_context(context), m_improve(tr, domain, quality, context), m_mesh(m_improve.mesh()),
      m_bad_cells(m_improve.bad_cells()), m_search_locally(m_improve, domain, context), m_center(m_mesh)
  { }

  // The dihedral angle, in degrees, that no cell is to be below. To be set before cells are added.
  void set_target(const double min_dihedral_angle)
  {
    m_target = min_dihedral_angle;
    set_enough(m_target);
  }

  // How much work an improvement is worth; `normal` if it is not set.
  void set_effort(const Improvement_effort effort) { m_effort = effort; }

  // To be called for each cell of the domain.
  void add(const Cell_handle c)
  {
    ++m_number_of_cells;
    m_mesh.add_lengths(c);
    note_quality(m_bad_cells.push(c));
  }

  // Instead: the number of cells, and only what this returns has to be added. It is called for all cells, maybe by
  // several threads, while one of them adds; so borders are marked later.
  void set_number_of_cells(const std::size_t number) { m_number_of_cells = number; }
  std::optional<Bad_cell> concerns(const Cell_handle c)
  {
    const double quality = m_quality(internal::corners(c));
    note_quality(quality);
    const bool is_added = quality < m_mesh.enough() || is_on_border(c)
                       || m_mesh.allowed_lengths().has_wall(m_mesh.domain(), c);
    return is_added ? std::make_optional(Bad_cell{ quality, c, 0 }) : std::nullopt;
  }
  void add(const Bad_cell& c)
  {
    if constexpr(Has_part<typename Tr::Vertex>::value)
      if(is_on_border(c.cell))
        m_cells_on_border.push_back(c.cell);
    m_mesh.add_lengths(c.cell);
    if(c.quality < m_mesh.enough())
      m_bad_cells.put_back(c);
  }

  // Nothing is tolerated. For a mesh that is improved several times: that would add up.
  void be_strict() { m_mesh.be_strict(); }

  // No vertices are inserted beyond that number.
  void set_max_number_of_vertices(const std::size_t number) { m_mesh.set_max_number_of_vertices(number); }

  // So many parts of the mesh are improved at the same time. The domain has no selection. To be called before cells are
  // added, among which the border of the first round is found.
  void set_number_of_parts(const std::size_t number)
  {
    m_number_of_parts = number;
    if constexpr(Has_part<typename Tr::Vertex>::value)
      if(number > 1)
        m_number_of_owners = Owned_parts_3<Tr>::divide(m_mesh.triangulation(), number, 0);
  }

  // Whether one was not inserted for that.
  bool was_full() const { return m_mesh.was_full(); }

  // Improves the mesh until all cells are good, or nothing helps, or the context says stop.
  void operator()();

  // All of this in one.
  void operator()(const double min_dihedral_angle)
  {
    set_target(min_dihedral_angle);
    for_each_cell([&](const Cell_handle c) { add(c); });
    (*this)();
  }

  const Quality_improvement_counts& counts() const { return m_improve.counts(); }

private:
  typedef Improve_bad_cells_3<Tr, Quality> Improve_bad_cells;
  typedef typename Improve_bad_cells::Mesh                  Mesh;

  // See "Tuning constants" in the manual.
  static constexpr double really_bad_angle = 12;
  static constexpr double nearly_flat_angle = 0.1;
  static constexpr std::size_t vertices_per_report = 1024;

  // Of the domain, unless the context says stop.
  template <typename Function>
  void for_each_cell(const Function& f)
  {
    for(const Cell_handle c : m_mesh.triangulation().finite_cell_handles())
    {
      if(! m_context.go_further_after_short_step())
        return;
      if(m_mesh.domain().contains(c))
        f(c);
    }
  }

  // Whether a cell is inner to no part of the first round.
  bool is_on_border([[maybe_unused]] const Cell_handle c) const
  {
    if constexpr(Has_part<typename Tr::Vertex>::value)
      return m_number_of_owners > 0 && internal::owner_of_cell(*c) == 0;
    return false;
  }

  void note_quality(const double quality)
  {
    double worst = m_worst;
    while(quality < worst && ! m_worst.compare_exchange_weak(worst, quality)) { }
  }

  void improve()
  {
    m_mesh.spread_lengths([this] { return m_context.go_further_after_short_step(); });
    m_improve.open_accounts(m_effort, m_number_of_cells);
    m_improve.progress().begin(m_number_of_cells, m_bad_cells.size(), m_mesh.triangulation().number_of_vertices(),
                               m_effort);
    improve_bad_cells();
    if(m_target > really_bad_angle && ! m_mesh.is_strict() && m_context.go_further())
      improve_worst_cells();
    if(m_context.go_further())
      center_vertices();
  }

  void improve_bad_cells()
  {
    if constexpr(Has_part<typename Tr::Vertex>::value)
      if(m_number_of_parts > 1)
      {
        for(const Cell_handle c : m_cells_on_border)
          internal::put_on_border(*c);
        m_cells_on_border.clear();
        Improve_parts_3<Tr, Quality> improve_parts(m_improve, m_quality, m_context, m_number_of_parts);
        return improve_parts.improve(m_number_of_owners);
      }
    m_improve();
  }

  // A mesh is as good as its worst cell, so nearly flat ones are worth any effort. There are few of them.
  void improve_worst_cells()
  {
    const std::size_t end_of_first_pass = m_mesh.time();
    m_improve.begin_worst_cells(number_of_bad_cells_below(really_bad_angle));
    m_improve.set_works_on_nearly_flat_cells(true);
    improve_cells_below(nearly_flat_angle, Improvement_effort::high, end_of_first_pass);
    m_improve.set_works_on_nearly_flat_cells(false);
    improve_cells_below(really_bad_angle, m_effort, end_of_first_pass);
    if(m_mesh.time() != end_of_first_pass)
      m_improve();
  }

  // As if all other cells were good. Afterwards, those below the target are in the list, as visited at that time.
  void improve_cells_below(const double angle, const Improvement_effort effort, const std::size_t time)
  {
    if(! is_any_below(angle))
      return;
    set_enough(angle);
    m_improve.set_visits_only_changed(false);
    m_improve();
    improve_leniently();
    m_improve.set_visits_only_changed(true);
    Work_account account;
    account.open(effort, m_number_of_cells);
    m_search_locally(angle, account);
    set_enough(m_target);
    m_bad_cells.take(); // they were visited with another measure
    if(m_number_of_parts > 1)
      find_bad_cells(time);
    else
      for_each_cell([&](const Cell_handle c) { m_bad_cells.push(c, time); });
  }

  // The same by several threads, so that nobody counts how many qualities are computed.
  void find_bad_cells(const std::size_t time)
  {
    const auto look_at = [&](const std::vector<Cell_handle>& cells)
    {
      std::vector<Bad_cell> bad;
      for(const Cell_handle c : cells)
        if(m_mesh.domain().contains(c))
          if(const double quality = m_quality(internal::corners(c)); quality < m_mesh.enough())
            bad.push_back(Bad_cell{ quality, c, time });
      return bad;
    };
    const auto take = [&](const std::vector<Bad_cell>& bad)
    {
      m_bad_cells.put_back(bad);
      return m_context.go_further();
    };
    internal::for_each_block(m_mesh.triangulation().all_cell_handles(), look_at, take, Concurrency_tag_of<Tr>());
  }

  bool is_any_below(const double angle) { return number_of_bad_cells_below(angle) > 0; }

  std::size_t number_of_bad_cells_below(const double angle)
  {
    const std::vector<Bad_cell>& cells = m_bad_cells.worst_first();
    const auto is_below = [quality = m_quality.of_angle(angle)](const Bad_cell& c) { return c.quality < quality; };
    return static_cast<std::size_t>(std::partition_point(cells.begin(), cells.end(), is_below) - cells.begin());
  }

  void set_enough(const double degrees) { m_mesh.set_enough(m_quality.of_angle(degrees)); }

  // No cell gets worse than the worst one is.
  void improve_leniently()
  {
    const std::vector<Bad_cell>& cells = m_bad_cells.worst_first();
    if(cells.empty())
      return;
    m_mesh.set_measure_of_badness(Badness_3(m_mesh.enough(), cells.front().quality));
    m_improve();
  }

  // If all cells are better than asked for, none gets worse than the worst one was.
  void center_vertices()
  {
    m_mesh.set_enough((std::max)(m_quality.of_angle(m_target), double(m_worst)));
    m_mesh.note_no_more_changes();
    const auto all = m_mesh.triangulation().finite_vertex_handles();
    std::vector<Vertex_handle> vertices(all.begin(), all.end());
    if constexpr(Has_part<typename Tr::Vertex>::value)
      if(m_number_of_parts > 1)
        vertices = Improve_parts_3<Tr, Quality>(m_improve, m_quality, m_context, m_number_of_parts).center(vertices);
    internal::sort_in_space(vertices, &Mesh::coordinates, [this] { return m_context.go_further_after_short_step(); });
    for(std::size_t i = 0; i < vertices.size() && m_context.go_further_after_long_step(); ++i)
    {
      m_improve.counts().number_of_moved_vertices += m_center(vertices[i]);
      if(i % vertices_per_report == 0)
      {
        m_improve.progress().center(i, vertices.size(), m_mesh.quality().number());
        m_improve.tell_progress();
      }
    }
  }

  const Quality& m_quality;
  Recovery_context<Tr>& m_context;
  Improve_bad_cells m_improve;
  Mesh& m_mesh;                   // its own
  Bad_cells_3<Mesh>& m_bad_cells; // the same
  Search_locally_3<Tr, Quality> m_search_locally;
  Center_vertex_3<Mesh> m_center;
  double m_target = 0;
  Improvement_effort m_effort = Improvement_effort::normal;
  std::size_t m_number_of_cells = 0;
  std::size_t m_number_of_parts = 1;
  std::size_t m_number_of_owners = 0; // of vertices, in the first round; 0: none
  std::vector<Cell_handle> m_cells_on_border; // of their parts
  std::atomic<double> m_worst{ std::numeric_limits<double>::infinity() }; // of the qualities of all cells at first
};

template <typename Tr, typename Quality>
void Improve_domain_3<Tr, Quality>::operator()()
{
  if(m_target > 0) // else nothing is bad
    improve();
}

#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

extern template void Improve_domain_3<Standard_mesh, Dihedral_angle_quality_3>::operator()();

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H
