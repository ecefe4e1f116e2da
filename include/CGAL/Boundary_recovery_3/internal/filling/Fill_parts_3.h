// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_PARTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_PARTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Encroached_walls_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Fill_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Owned_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <CGAL/Unique_hash_map.h>

#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Fills parts of a domain at the same time, in rounds, each with other borders. A point that would change something
 * beyond the border of a part is put off to the next round; what is left after the last one is done by one thread.
 *
 * The cells of a domain without points inside reach from one side of it to the other, and are inner to no part. So one
 * thread begins, with few points all over the domain.
 */
template <typename Tr>
class Fill_parts_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef std::vector<Cell_handle>   Cells;
  typedef Selected_domain_3<Tr>      Domain;
  typedef Region_sizes_3<Tr>         Sizes;
  typedef Fill_domain_3<Tr>          Fill_domain;

  // `fill` is that for the domain as a whole.
  Fill_parts_3(Tr& tr, Domain& domain, Sizes& sizes, Recovery_context<Tr>& context, Fill_domain& fill)
    : m_tr(tr), m_domain(domain), m_sizes(sizes), m_context(context), m_visitor(context.visitor()), m_fill(fill)
  { }

  // Fills the domain, which has these cells, see `Fill_domain_3`.
  void operator()(const Cells& cells, const std::size_t number_of_parts, const std::size_t expected_number)
  {
    const Encroached_walls_3 walls = m_fill.large_walls(cells);
    m_fill.begin(walls, m_tr.number_of_vertices(), no_limit, expected_number);
    Cells waiting = spread(cells);
    const std::size_t first_number = expected_number / points_per_first_point;
    while(! waiting.empty() && m_fill.vertices().size() < first_number && m_fill.can_go_on())
      waiting = m_fill.sweep(waiting, first_number);
    for(int round = 0; round < max_number_of_rounds && pays(waiting.size()); ++round)
      fill_parts(number_of_parts, round, expected_number, walls, waiting);
    m_fill.fill(waiting);
    m_fill.shorten_long_edges();
  }

private:
  typedef Owned_parts_3<Tr> Parts;

  static constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)(); // of the number of vertices

  // See "Tuning constants" in the manual.
  static constexpr std::size_t points_per_first_point = 30;
  static constexpr int max_number_of_rounds = 4;
  static constexpr double least_share = 0.15;  // of cells that wait in the number of vertices
  static constexpr double likely_growth = 0.2; // of sizes
  static constexpr std::size_t stride = 64;    // from one first cell to the next one

  // The work on one part, by a thread.
  struct Task
  {
    Task(typename Parts::Part& part, const Sizes& whole, Mesh_visitor_3<Tr>& visitor, const double seconds_left)
      : context(visitor), sizes(whole, Part_of_sizes()), fill(part.triangulation(), part.domain(), sizes, context)
    {
      context.set_maximum_running_time(seconds_left);
    }

    Recovery_context<Tr> context;
    Sizes sizes;
    Fill_domain fill;
  };

  // Cells that are beside each other are near each other, too. So that the first ones are all over the domain, most of
  // them are left out several times.
  static Cells spread(const Cells& cells)
  {
    Cells result;
    result.reserve(cells.size());
    for(std::size_t first = 0; first < stride; ++first)
      for(std::size_t k = first; k < cells.size(); k += stride)
        result.push_back(cells[k]);
    return result;
  }

  // Where little is left, one thread does it sooner than the mesh is divided.
  bool pays(const std::size_t number_of_cells)
  {
    return double(number_of_cells) > least_share * double(m_tr.number_of_vertices()) && m_fill.can_go_on();
  }

  // Looks at cells that wait; afterwards, those wait that have to be looked at in the next round.
  void fill_parts(const std::size_t number_of_parts, const int round, const std::size_t expected_number,
                  const Encroached_walls_3& walls, Cells& waiting)
  {
    const Unique_hash_map<Vertex_handle, double> work = round == 0 ? work_at_vertices(waiting)
                                                                   : Unique_hash_map<Vertex_handle, double>(1);
    Parts parts(m_tr, m_domain, number_of_parts, round, [&](const Vertex_handle v) { return work[v]; });
    parts.mark_border(m_domain);
    std::vector<Cells> cells(parts.size() + 1);
    for(const Cell_handle c : waiting)
      if(m_fill.is_there(c) && m_domain.contains(c))
        cells[parts.part_of(c)].push_back(c);
    waiting = std::move(cells.back());
    cells.pop_back();
    std::vector<std::size_t> amounts;
    std::deque<Task> tasks;
    for(std::size_t k = 0; k < parts.size(); ++k)
    {
      tasks.emplace_back(parts[k], m_sizes, m_visitor, m_context.seconds_left());
      tasks.back().fill.begin(walls, m_tr.number_of_vertices() / parts.size(), no_limit, 0);
      amounts.push_back(cells[k].size());
    }
    m_visitor.begin(Phase::field_point_insertion, m_fill.vertices().size(), expected_number);
    internal::for_each_task(amounts, [&](const std::size_t k)
    {
      tasks[k].fill.fill(cells[k]);
      m_visitor.end_task(tasks[k].fill.vertices().size());
    }, Concurrency_tag_of<Tr>());
    if(m_visitor.is_stopped())
      m_context.stop();
    for(const Task& task : tasks)
    {
      m_fill.take_over(task.fill);
      m_sizes.take_over(task.sizes);
      const Cells& put_off = task.fill.cells_put_off();
      waiting.insert(waiting.end(), put_off.begin(), put_off.end());
    }
  }

  // At each vertex, about how many points the cells that wait there are going to have. That is for the first round:
  // later on, borders would be where most of the work is.
  Unique_hash_map<Vertex_handle, double> work_at_vertices(const Cells& waiting) const
  {
    Unique_hash_map<Vertex_handle, double> work(0); // for looking up only
    for(const Cell_handle c : waiting)
      if(m_fill.is_there(c) && m_domain.contains(c))
      {
        const auto corners = internal::corners(c);
        const double size = m_sizes.likely_size_at_centroid(c, corners, likely_growth);
        const double number = 1 + std::abs(internal::volume_times_6(corners)) / (size * size * size);
        for(int i = 0; i < 4; ++i)
          work[c->vertex(i)] += number;
      }
    return work;
  }

  Tr& m_tr;
  Domain& m_domain;
  Sizes& m_sizes;
  Recovery_context<Tr>& m_context;
  Part_visitor_3<Tr> m_visitor;
  Fill_domain& m_fill;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_PARTS_3_H
