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
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Search_locally_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Improves the cells of a domain, step 7 of [CZZ+17, Section 4.1]: first all that are below the target, see
 * `Improve_bad_cells_3`.
 *
 * Then, only those cells count that are really bad, and others may get worse for them; for those that this leaves, a
 * few cells may become very bad, and the mesh is searched around each of them. Where that has changed something, all
 * cells below the target have another turn. At last, all the others get rounder, where that is for nothing.
 */
template <typename Tr, typename Domain, typename Quality, typename Visitor>
class Improve_domain_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;

  Improve_domain_3(Tr& tr, Domain& domain, const Quality& quality, Recovery_context<Visitor>& context)
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
    m_worst = (std::min)(m_worst, m_bad_cells.push(c));
  }

  // Nothing is tolerated. For a mesh that is improved several times: that would add up.
  void be_strict() { m_mesh.be_strict(); }

  // No vertices are inserted beyond that number.
  void set_max_number_of_vertices(const std::size_t number) { m_mesh.set_max_number_of_vertices(number); }

  // Whether one was not inserted for that.
  bool was_full() const { return m_mesh.was_full(); }

  // Improves the mesh until all cells are good, or nothing helps, or the context says stop.
  void operator()()
  {
    if(m_target > 0) // else nothing is bad
      improve();
    m_improve.finish();
  }

  // All of this in one.
  void operator()(const double min_dihedral_angle)
  {
    set_target(min_dihedral_angle);
    for_each_cell([&](const Cell_handle c) { add(c); });
    (*this)();
  }

  const Quality_improvement_counts& counts() const { return m_improve.counts(); }

private:
  typedef Improve_bad_cells_3<Tr, Domain, Quality, Visitor> Improve_bad_cells;
  typedef typename Improve_bad_cells::Mesh                  Mesh;
  typedef typename Improve_bad_cells::Bad_cell              Bad_cell;

  // See "Tuning constants" in the manual.
  static constexpr double really_bad_angle = 12;
  static constexpr double nearly_flat_angle = 0.1;

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

  void improve()
  {
    m_mesh.spread_lengths([this] { return m_context.go_further_after_short_step(); });
    open_accounts(m_effort);
    m_improve();
    if(m_target > really_bad_angle && ! m_mesh.is_strict() && m_context.go_further())
      improve_worst_cells();
    if(m_context.go_further())
      center_vertices();
  }

  void open_accounts(const Improvement_effort effort)
  {
    m_improve.open_accounts(effort, m_number_of_cells);
    m_search_locally.open_account(effort, m_number_of_cells);
  }

  // A mesh is as good as its worst cell, so nearly flat ones are worth any effort. There are few of them.
  void improve_worst_cells()
  {
    const std::size_t end_of_first_pass = m_mesh.time();
    improve_cells_below(nearly_flat_angle, Improvement_effort::high, end_of_first_pass);
    improve_cells_below(really_bad_angle, m_effort, end_of_first_pass);
    if(m_mesh.time() != end_of_first_pass)
      m_improve();
  }

  // As if all other cells were good. Afterwards, those below the target are in the list, as visited at that time.
  void improve_cells_below(const double angle, const Improvement_effort effort, const std::size_t time)
  {
    if(! is_any_below(angle))
      return;
    open_accounts(effort);
    set_enough(angle);
    m_improve.set_visits_only_changed(false);
    m_improve();
    improve_leniently();
    m_improve.set_visits_only_changed(true);
    m_search_locally(angle);
    set_enough(m_target);
    m_bad_cells.take(); // they were visited with another measure
    for_each_cell([&](const Cell_handle c) { m_bad_cells.push(c, time); });
  }

  bool is_any_below(const double angle)
  {
    const std::vector<Bad_cell>& cells = m_bad_cells.worst_first();
    return ! cells.empty() && cells.front().quality < m_quality.of_angle(angle);
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
    m_mesh.set_enough((std::max)(m_quality.of_angle(m_target), m_worst));
    m_mesh.note_no_more_changes();
    const auto all = m_mesh.triangulation().finite_vertex_handles();
    std::vector<Vertex_handle> vertices(all.begin(), all.end());
    internal::sort_in_space(vertices, &Mesh::coordinates, [this] { return m_context.go_further_after_short_step(); });
    for(const Vertex_handle v : vertices)
    {
      if(! m_context.go_further_after_long_step())
        break;
      m_improve.counts().number_of_moved_vertices += m_center(v);
    }
  }

  const Quality& m_quality;
  Recovery_context<Visitor>& m_context;
  Improve_bad_cells m_improve;
  Mesh& m_mesh;                   // its own
  Bad_cells_3<Mesh>& m_bad_cells; // the same
  Search_locally_3<Tr, Domain, Quality, Visitor> m_search_locally;
  Center_vertex_3<Mesh> m_center;
  double m_target = 0;
  Improvement_effort m_effort = Improvement_effort::normal;
  std::size_t m_number_of_cells = 0;
  double m_worst = std::numeric_limits<double>::infinity(); // of the qualities of all cells at first
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H
