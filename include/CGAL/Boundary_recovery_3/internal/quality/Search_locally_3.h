// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SEARCH_LOCALLY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SEARCH_LOCALLY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Walls_at_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Work_account.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * *Iterated local search* [LMS03]: the mesh is perturbed near one bad cell after the other, and all operations have a
 * turn there. If the cells are not less bad then, all of that is taken back.
 */
template <typename Tr, typename Domain, typename Quality, typename Visitor>
class Search_locally_3
{
public:
  typedef Improve_bad_cells_3<Tr, Domain, Quality, Visitor> Improve_bad_cells;
  typedef typename Improve_bad_cells::Mesh                  Mesh;
  typedef typename Improve_bad_cells::Bad_cell              Bad_cell;
  typedef typename Tr::Vertex_handle                        Vertex_handle;
  typedef typename Tr::Cell_handle                          Cell_handle;

  Search_locally_3(Improve_bad_cells& improve, const Domain& domain, Recovery_context<Visitor>& context)
    : m_improve(improve), m_context(context), m_mesh(improve.mesh()), m_bad_cells(improve.bad_cells()),
      m_walls_at_edge(domain), m_insert_near(m_mesh), m_move_at_random(m_mesh)
  { }

  void open_account(const Improvement_effort effort, const std::size_t number_of_cells)
  {
    m_account.open(effort, number_of_cells);
  }

  // For all bad cells but those that are forced to be below `angle`, in degrees, as long as attempts pay.
  void operator()(const double angle)
  {
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
  Recovery_context<Visitor>& m_context;
  Mesh& m_mesh;
  Bad_cells_3<Mesh>& m_bad_cells;
  Walls_at_edge_3<Tr, Domain> m_walls_at_edge;
  Insert_near_bad_cell_3<Mesh> m_insert_near;
  Move_at_random_3<Mesh> m_move_at_random;
  std::vector<Vertex_handle> m_vertices; // near the cell
  Work_account m_account;
  CGAL::Random m_random = CGAL::Random(0); // always the same numbers
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SEARCH_LOCALLY_3_H
