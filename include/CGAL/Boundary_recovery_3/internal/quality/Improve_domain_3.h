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
#include <CGAL/Boundary_recovery_3/internal/quality/Center_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_bad_cells_3.h>
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
 * Then, only those cells count that are really bad, others may get worse for them, and all operations are tried. For
 * what that leaves, beside the thin triangles of a surface, a few cells may become very bad so that many are not; and a
 * few times, the mesh is perturbed, which the next operations make up for, or that is taken back. Those that are nearly
 * as bad have a turn of the same kind before the last one of the very bad ones. Then they, or the worst cells where
 * these are few, are worked on strictly again. At last, all the others get rounder, where that is for nothing.
 */
template <typename Tr, typename Domain, typename Quality, typename Visitor>
class Improve_domain_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;

  Improve_domain_3(Tr& tr, Domain& domain, const Quality& quality, Recovery_context<Visitor>& context)
    : m_quality(quality), m_context(context), m_improve(tr, domain, quality, context), m_mesh(m_improve.mesh()),
      m_bad_cells(m_improve.bad_cells()), m_search_locally(m_improve, domain, quality, context), m_center(m_mesh)
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
  void be_strict() { m_improve.be_strict(); }

  // No vertices are inserted beyond that number.
  void set_max_number_of_vertices(const std::size_t number) { m_mesh.set_max_number_of_vertices(number); }

  // Whether one was not inserted for that.
  bool was_full() const { return m_mesh.was_full(); }

  // Improves the mesh until all cells are good, or nothing helps, or the context says stop.
  void operator()()
  {
    m_mesh.spread_lengths([this] { return m_context.go_further_after_short_step(); });
    m_improve.try_most();
    if(m_target > really_bad_angle && m_context.go_further())
    {
      if(is_any_nearly_as_bad()) // else there is nothing to do, and the list is complete
      {
        improve_really_bad_cells();
        list_all_below(m_target);
      }
      improve_worst_cells();
    }
    if(m_target > 0 && m_context.go_further())
      center_vertices();
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
  static constexpr double very_bad_angle = 10.1;
  static constexpr double nearly_as_bad_angle = 16;
  static constexpr std::size_t cells_per_nearly_bad_cell = 1000; // so many are worked on above that angle
  static constexpr int number_of_perturbations = 2;
  static constexpr std::size_t max_number_of_perturbed_cells = 2500;
  static constexpr double tolerated_loss = 1;
  static constexpr std::size_t max_number_of_attempts = 6000; // of each search
  static constexpr std::size_t max_number_of_attempts_above = 1500; // for those that are only nearly as bad

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

  std::size_t number_of_cells()
  {
    std::size_t number = 0;
    for_each_cell([&](const Cell_handle) { ++number; });
    return number;
  }

  void set_enough(const double degrees) { m_improve.set_measure_of_badness(m_quality.of_angle(degrees)); }

  // Whether there is a cell below that target. All that are below the other one have to be in the list.
  bool is_any_nearly_as_bad()
  {
    const std::vector<Bad_cell>& cells = m_bad_cells.worst_first();
    return ! cells.empty() && cells.front().quality < m_quality.of_angle(nearly_as_bad_target());
  }

  double nearly_as_bad_target() const { return (std::min)(m_target, nearly_as_bad_angle); }

  void improve_really_bad_cells()
  {
    set_enough(really_bad_angle);
    m_improve.try_all();
    if(! m_improve.is_strict())
      improve_with_perturbations();
  }

  // They are what is bad from now on. While only worse ones were, the others were not in the list.
  void list_all_below(const double angle)
  {
    set_enough(angle);
    for_each_cell([&](const Cell_handle c) { m_bad_cells.push(c); });
  }

  // Those below an angle, and if these are few, the worst ones below the target.
  void improve_worst_cells()
  {
    const std::vector<Bad_cell>& cells = m_bad_cells.worst_first();
    const std::size_t number_of_few = number_of_cells() / cells_per_nearly_bad_cell;
    const double least = m_quality.of_angle(nearly_as_bad_target());
    if(number_of_few < cells.size())
      m_improve.set_measure_of_badness((std::max)(cells[number_of_few].quality, least));
    m_improve.try_all();
  }

  // Where nothing helps any more, vertices are inserted near the worst cells though that makes others bad, and all
  // operations have another turn. That gets out of states that no single operation makes better. At last, those that
  // are very bad may become better at the cost of the others.
  void improve_with_perturbations()
  {
    improve_leniently();
    m_improve.set_visits_only_changed(true);
    for(int k = 0; k < number_of_perturbations && m_context.go_further(); ++k)
    {
      perturb();
      set_enough(really_bad_angle);
      m_improve.try_all();
      improve_leniently();
    }
    m_search_locally(really_bad_angle, max_number_of_attempts);
    improve_nearly_as_bad_cells_leniently();
    set_enough(very_bad_angle);
    improve_leniently();
    m_search_locally(very_bad_angle, max_number_of_attempts);
    m_improve.set_visits_only_changed(false);
  }

  // None gets very bad. Where there are many, a search does not pay: the surface forces nearly all of them.
  void improve_nearly_as_bad_cells_leniently()
  {
    list_all_below(nearly_as_bad_target());
    m_improve.set_visits_only_changed(false); // most of them were not visited yet
    improve_leniently(m_quality.of_angle(very_bad_angle));
    m_improve.set_visits_only_changed(true);
    if(m_bad_cells.size() <= max_number_of_attempts_above)
      m_search_locally(nearly_as_bad_target(), max_number_of_attempts_above);
  }

  void perturb()
  {
    std::size_t number = 0;
    for(const Bad_cell& c : m_bad_cells.next_round())
    {
      if(! m_context.go_further_after_long_step())
        return;
      if(! m_bad_cells.contains(c.cell))
        continue;
      m_bad_cells.begin_visit();
      const bool is_turn = number++ < max_number_of_perturbed_cells;
      if(! is_turn || ! m_improve.insert_near(c.cell, tolerated_loss))
        m_bad_cells.put_back(c);
    }
  }

  // No cell gets worse than this quality, nor than the worst one is.
  void improve_leniently(const double least_quality = 0)
  {
    const std::vector<Bad_cell>& cells = m_bad_cells.worst_first();
    if(cells.empty())
      return;
    m_improve.set_measure_of_badness(Badness_3(m_mesh.enough(), (std::max)(least_quality, cells.front().quality)));
    m_improve.try_all();
  }

  // If all cells are better than asked for, none gets worse than the worst one was.
  void center_vertices()
  {
    m_mesh.set_enough((std::max)(m_quality.of_angle(m_target), m_worst));
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
  double m_worst = std::numeric_limits<double>::infinity(); // of the qualities of all cells at first
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_DOMAIN_3_H
