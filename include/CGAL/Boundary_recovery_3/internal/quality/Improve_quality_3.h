// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_QUALITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_QUALITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Ordinary_scale_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Concurrency.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Explain_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL::Boundary_recovery_3::internal {

// See "Tuning constants" in the manual.
constexpr double default_min_dihedral_angle = 25;

// The largest angle that can be asked for: no cell has a larger smallest one than the regular tetrahedron.
constexpr double largest_possible_target = 70.53;

inline bool is_possible_target(const double degrees) { return degrees >= 0 && degrees <= largest_possible_target; }

// What is asked of the improvement, as improve_mesh_quality() documents it.
struct Improvement_options
{
  double             min_dihedral_angle = default_min_dihedral_angle;
  Improvement_effort effort = Improvement_effort::normal;
  std::size_t        max_number_of_vertices = (std::numeric_limits<std::size_t>::max)();
  double             maximum_running_time = std::numeric_limits<double>::infinity(); // seconds
  Concurrency        concurrency;
};

template <typename Tr, typename NamedParameters>
Improvement_options improvement_options(const NamedParameters& np)
{
  Improvement_options options;
  options.min_dihedral_angle = parameter_or(np, internal::min_dihedral_angle, options.min_dihedral_angle);
  options.effort = parameter_or(np, internal::improvement_effort, options.effort);
  options.max_number_of_vertices = parameter_or(np, internal::maximum_number_of_vertices,
                                                options.max_number_of_vertices);
  options.maximum_running_time = parameter_or(np, internal_np::maximum_running_time, options.maximum_running_time);
  options.concurrency = internal::concurrency<Tr>(np);
  return options;
}

// If there was no time for them, the result says so.
template <typename Tr>
void set_last_figures(Quality_improvement_result_3<Tr>& result, const std::optional<Mesh_quality_3>& figures)
{
  result.is_measured = bool(figures);
  if(figures)
    result.after = *figures;
}

/*
 * The work behind improve_mesh_quality(): the improvement between two measurements, the second of which also explains
 * what is still bad. If the work is stopped, there may be no time for them; if that is before the first change, the
 * first ones are the last ones.
 */
template <typename Tr, typename Quality>
class Improve_quality_3
{
public:
  typedef typename Tr::Cell_handle         Cell_handle;
  typedef Selected_domain_3<Tr>            Domain;
  typedef Quality_improvement_result_3<Tr> Result;

  Improve_quality_3(Tr& tr, Domain& domain, const Quality& quality, const std::size_t max_number_of_vertices,
                    Mesh_visitor_3<Tr>& visitor)
    : m_tr(tr), m_domain(domain), m_quality(quality), m_max_number_of_vertices(max_number_of_vertices),
      m_context(visitor)
  { }

  // To be called before the improvement; else nothing is divided.
  void set_concurrency(const Concurrency& concurrency) { m_concurrency = concurrency; }

  Result operator()(const double min_dihedral_angle, const Improvement_effort effort,
                    const double maximum_running_time);

private:
  typedef std::optional<Mesh_quality_3> Figures; // none if there was no time

  void improve(const double min_dihedral_angle, const Improvement_effort effort)
  {
    bool is_begun = false;
    const Figures before = change_mesh(min_dihedral_angle, effort, is_begun);
    const bool is_done = ! m_context.is_stopped();
    Explain_bad_cells_3<Tr> explain(m_tr, m_domain, min_dihedral_angle);
    typedef std::pair<Cell_handle, Cell_angles_3> Cell;
    const auto concerns = [&](const Cell_handle c, const Cell_angles_3& angles)
    {
      return explain.is_bad(angles) ? std::make_optional<Cell>(c, angles) : std::nullopt;
    };
    const Figures after = measure(concerns, [&](const Cell& cell) { explain.add(cell.first, cell.second); },
                                  [&](const Cell_handle c, const Cell_angles_3& angles) { explain.add(c, angles); });
    if(before)
      m_result.before = *before;
    internal::set_last_figures(m_result, after || is_begun ? after : before);
    m_result.certificate = explain.certificate(bool(after));
    m_result.status = is_done && after ? Meshing_status::meshed : Meshing_status::stopped;
  }

  // Returns the figures before the first change.
  Figures change_mesh(const double min_dihedral_angle, const Improvement_effort effort, bool& is_begun)
  {
    const Ordinary_scale_3<Tr> scale(m_tr);
    Improve_domain_3<Tr, Quality> improve_domain(m_tr, m_domain, m_quality, m_context);
    improve_domain.set_target(min_dihedral_angle);
    improve_domain.set_effort(effort);
    improve_domain.set_max_number_of_vertices(m_max_number_of_vertices);
    if(! m_domain.has_selection())
      improve_domain.set_number_of_parts(m_concurrency.number_of_parts(double(internal::number_of_finite_cells(m_tr)),
                                                                       m_max_number_of_vertices));
    typedef typename Improve_domain_3<Tr, Quality>::Bad_cell Bad_cell;
    const auto concerns = [&](const Cell_handle c, const Cell_angles_3&) { return improve_domain.concerns(c); };
    const Figures before = measure(concerns, [&](const Bad_cell& c) { improve_domain.add(c); },
                                   [&](const Cell_handle c, const Cell_angles_3&) { improve_domain.add(c); });
    if(before)
      improve_domain.set_number_of_cells(before->number_of_cells);
    is_begun = m_context.go_further();
    if(is_begun)
      improve_domain();
    m_result.counts = improve_domain.counts();
    return before;
  }

  // Either threads find what has to be examined, see `Measure_blocks_3`, or each cell is examined.
  template <typename Concerns, typename Examine, typename Examine_cell>
  Figures measure(const Concerns& concerns, const Examine& examine, const Examine_cell& examine_cell)
  {
    const auto goes_on = [this] { return m_context.can_finish_after_short_step(); };
    return m_concurrency.number_of_threads ? Measure_blocks_3<Tr>(m_tr, m_domain)(concerns, examine, goes_on)
                                           : Measure_quality_3<Tr>(m_tr, m_domain)(examine_cell, goes_on);
  }

  Tr& m_tr;
  Domain& m_domain;
  const Quality& m_quality;
  const std::size_t m_max_number_of_vertices;
  Concurrency m_concurrency;
  Recovery_context<Tr> m_context;
  Result m_result;
};

template <typename Tr, typename Quality>
Quality_improvement_result_3<Tr>
Improve_quality_3<Tr, Quality>::operator()(const double min_dihedral_angle, const Improvement_effort effort,
                                           const double maximum_running_time)
{
  m_context.set_maximum_running_time(maximum_running_time);
  if(is_possible_target(min_dihedral_angle))
  {
    const auto improve_with_threads = [&]
    {
      internal::with_threads(m_concurrency.number_of_threads.value_or(1), [&] { improve(min_dihedral_angle, effort); });
    };
    m_context.run(Phase::quality_improvement, improve_with_threads, [this](Phase_report& report)
    {
      report.number_of_vertices = m_tr.number_of_vertices();
      report.number_of_cells = internal::number_of_finite_cells(m_tr);
    });
  }
  else
    m_result.status = Meshing_status::invalid_input;
  m_result.seconds = m_context.seconds();
  return std::move(m_result);
}

#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

extern template Quality_improvement_result_3<Standard_mesh>
Improve_quality_3<Standard_mesh, Dihedral_angle_quality_3>::operator()(double, Improvement_effort, double);

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVE_QUALITY_3_H
