// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_PARTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_PARTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/sort_in_space.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Owned_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// What was changed elsewhere at the same time: there are as many rounds as where there are most.
inline void add_counts(Quality_improvement_counts& sum, const Quality_improvement_counts& counts)
{
  sum.number_of_rounds = (std::max)(sum.number_of_rounds, counts.number_of_rounds);
  sum.number_of_removed_edges += counts.number_of_removed_edges;
  sum.number_of_removed_facets += counts.number_of_removed_facets;
  sum.number_of_moved_vertices += counts.number_of_moved_vertices;
  sum.number_of_inserted_points += counts.number_of_inserted_points;
  sum.number_of_removed_vertices += counts.number_of_removed_vertices;
}

/*
 * Improves parts of a mesh at the same time, in rounds, each with other borders. What is bad at a border, or on it, is
 * left to the next round; what is left after the last one, to one thread. Bad cells that nothing helped are tried again
 * where a border was in the way, or where something has changed since.
 */
template <typename Tr, typename Quality>
class Improve_parts_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Improve_bad_cells_3<Tr, Quality>     Improve_bad_cells;
  typedef typename Improve_bad_cells::Mesh     Mesh;
  typedef typename Improve_bad_cells::Bad_cell Bad_cell;

  // What is improved is that of `improve`.
  Improve_parts_3(Improve_bad_cells& improve, const Quality& quality, Recovery_context<Tr>& context,
                  const std::size_t number_of_parts)
    : m_improve(improve), m_quality(quality), m_rounds(improve.mesh().triangulation(), context, least_share),
      m_number_of_parts(number_of_parts)
  { }

  // The bad cells; those that stay bad are in the list again. The accounts are those of `improve`. For the first round,
  // the vertices have so many owners already, and are marked where they are on the border.
  void improve(const std::size_t number_of_owners)
  {
    m_number_of_owners = number_of_owners;
    m_improve.set_visits_only_changed(true);
    std::vector<Bad_cell> cells = bad_cells().take();
    std::size_t number_of_waiting_cells = cells.size();
    for(int round = 0; m_rounds.pays(round, number_of_waiting_cells); ++round)
    {
      cells = improve_parts(round, cells, number_of_waiting_cells);
      number_of_waiting_cells = std::size_t(std::count_if(cells.begin(), cells.end(), is_waiting));
    }
    m_improve.progress().end_parts_of_rounds();
    bad_cells().put_back(cells);
    m_improve();
  }

  // Vertices, as `Center_vertex_3` does. Returns those that are left.
  std::vector<Vertex_handle> center(std::vector<Vertex_handle> vertices)
  {
    for(int round = 0; m_rounds.pays(round, vertices.size()); ++round)
      vertices = center_in_parts(round, vertices);
    m_improve.progress().end_parts_of_centering();
    return vertices;
  }

private:
  typedef Owned_parts_3<Tr>     Parts;
  typedef Rounds_of_parts_3<Tr> Rounds;

  // See "Tuning constants" in the manual.
  static constexpr double least_share = 0.02; // of the vertices

  // The work on one part, by a thread.
  struct Task
  {
    Task(typename Parts::Part& part, const Mesh& whole, const Quality& quality, Rounds& rounds)
      : context(rounds), improve(part.triangulation(), part.domain(), quality, context)
    {
      improve.mesh().begin_part(whole);
    }

    typename Rounds::Task_context context;
    Improve_bad_cells improve;
  };

  Bad_cells_3<Mesh>& bad_cells() { return m_improve.bad_cells(); }

  Parts divide(const int round)
  {
    return Parts(m_improve.mesh().triangulation(), m_improve.mesh().domain(), m_number_of_parts, round);
  }

  // `work(task, k)` is done for each part; the numbers tell how much that is. `tell(part)` tells which part of it is
  // done.
  template <typename Work, typename Tell>
  void work_on(Parts& parts, const std::vector<std::size_t>& amounts, const Work& work, const Tell& tell,
               std::deque<Task>& tasks)
  {
    const std::size_t all = std::accumulate(amounts.begin(), amounts.end(), std::size_t(1));
    std::size_t done = 0;
    for(std::size_t k = 0; k < parts.size(); ++k)
      tasks.emplace_back(parts[k], m_improve.mesh(), m_quality, m_rounds);
    m_rounds(amounts, [&](const std::size_t k)
    {
      work(tasks[k], k);
      m_rounds.visitor().do_alone([&]
      {
        done += amounts[k];
        tell(double(done) / double(all));
        m_improve.tell_progress();
      });
    });
    for(Task& task : tasks)
    {
      internal::add_counts(m_improve.counts(), task.improve.counts());
      m_improve.mesh().end_part(task.improve.mesh());
    }
  }

  // Whether something may help: the cell was not visited yet, or something around it has changed since.
  static bool is_waiting(const Bad_cell& c) { return c.time == 0; }

  // Improves bad cells that are inner to a part. Returns all bad cells that are there then.
  std::vector<Bad_cell> improve_parts(const int round, const std::vector<Bad_cell>& bad,
                                      const std::size_t number_of_waiting_cells)
  {
    Parts parts = round == 0 ? Parts(m_improve.mesh().triangulation(), m_improve.mesh().domain(), m_number_of_owners)
                             : divide(round);
    if(round > 0)
      parts.mark_border(m_improve.mesh().domain());
    std::vector<std::vector<Bad_cell> > cells(parts.size() + 1); // the last ones are inner to none
    std::vector<std::size_t> amounts(parts.size() + 1, 0);
    const auto with_part = [&](const Bad_cell& c)
    {
      return bad_cells().is_in_domain(c.cell) ? std::make_optional(std::make_pair(parts.part_of(c.cell), c))
                                              : std::nullopt;
    };
    internal::take_each(bad, with_part, [&](const std::pair<std::size_t, Bad_cell>& c)
    {
      cells[c.first].push_back(c.second);
      amounts[c.first] += is_waiting(c.second);
    }, Concurrency_tag_of<typename Mesh::Triangulation>());
    amounts.pop_back();
    std::deque<Task> tasks;
    work_on(parts, amounts, [&](Task& task, const std::size_t k)
    {
      task.improve.open_accounts_of_part(m_improve, double(amounts[k]) / double(number_of_waiting_cells));
      task.improve.set_visits_only_changed(true);
      task.improve.bad_cells().put_back(std::exchange(cells[k], std::vector<Bad_cell>()));
      task.improve();
      add_bad_cells(task.improve, cells[k]);
    }, [&](const double part) { m_improve.progress().visit_in_parts(part); }, tasks);
    for(const Task& task : tasks)
      m_improve.book(task.improve);
    std::vector<Bad_cell> left = std::move(cells.back());
    cells.pop_back();
    for(const auto& cells_of_part : cells)
      left.insert(left.end(), cells_of_part.begin(), cells_of_part.end());
    return left;
  }

  // Those of a part. Its clock is not that of the whole mesh, where they are visited before all changes, or not at all.
  static void add_bad_cells(Improve_bad_cells& part, std::vector<Bad_cell>& cells)
  {
    for(const Cell_handle c : part.cells_put_off())
      cells.push_back(Bad_cell{ 0, c, 0 });
    for(const Bad_cell& c : part.bad_cells().take())
      if(part.bad_cells().contains(c.cell))
        cells.push_back(Bad_cell{ c.quality, c.cell, part.mesh().has_changed(c.cell, c.time) ? std::size_t(0) : 1 });
  }

  // No cell comes or goes, so the border is not marked: it is met where the cells of a vertex are looked at.
  std::vector<Vertex_handle> center_in_parts(const int round, const std::vector<Vertex_handle>& vertices)
  {
    Parts parts = divide(round);
    std::vector<std::vector<Vertex_handle> > lists(parts.size());
    for(const Vertex_handle v : vertices)
      lists[internal::owner(v) - std::size_t(1)].push_back(v);
    std::deque<Task> tasks;
    work_on(parts, sizes_of(lists), [&](Task& task, const std::size_t k) { center(task, lists[k]); },
            [&](const double part) { m_improve.progress().center_in_parts(part); }, tasks);
    std::vector<Vertex_handle> waiting;
    for(const auto& list : lists)
      waiting.insert(waiting.end(), list.begin(), list.end());
    return waiting;
  }

  // Those on the border are left in the list.
  static void center(Task& task, std::vector<Vertex_handle>& vertices)
  {
    const auto& domain = task.improve.mesh().domain();
    Center_vertex_3<Mesh> center(task.improve.mesh());
    internal::sort_in_space(vertices, &Mesh::coordinates,
                            [&task] { return task.context.go_further_after_short_step(); });
    std::vector<Vertex_handle> waiting;
    for(std::size_t i = 0; i < vertices.size() && task.context.go_further_after_long_step(); ++i)
    {
      domain.forget_border();
      if(center(vertices[i]))
        ++task.improve.counts().number_of_moved_vertices;
      else if(domain.is_border_met())
        waiting.push_back(vertices[i]);
    }
    vertices.swap(waiting);
  }

  template <typename Item>
  static std::vector<std::size_t> sizes_of(const std::vector<std::vector<Item> >& lists)
  {
    std::vector<std::size_t> sizes;
    for(const auto& list : lists)
      sizes.push_back(list.size());
    return sizes;
  }

  Improve_bad_cells& m_improve;
  const Quality& m_quality;
  Rounds m_rounds;
  const std::size_t m_number_of_parts;
  std::size_t m_number_of_owners = 0; // in the first round
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_PARTS_3_H
