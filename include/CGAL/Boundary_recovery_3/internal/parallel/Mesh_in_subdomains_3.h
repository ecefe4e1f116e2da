// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_IN_SUBDOMAINS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_IN_SUBDOMAINS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Decomposition_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Part_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Seams_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Work_on_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Explain_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Steps 6 and 7 in sub-domains [CZZ+17, Section 5.2.2]: a coarse background mesh is divided into parts, which are
 * filled at the same time; then the zones around their seams are, so that nothing is left of these; and the same again
 * for the improvement. Nothing has to be recovered: sub-domains are made of cells, and their walls are facets of the
 * background mesh, which stay until it is the turn of the seams.
 *
 * The mesh depends on the number of sub-domains, but not on the number of threads.
 */
template <typename Tr, typename Quality>
class Mesh_in_subdomains_3
{
public:
  typedef typename Tr::Cell_handle               Cell_handle;
  typedef Boundary_constrained_mesh_result_3<Tr> Result;
  typedef Size_field_3<typename Tr::Geom_traits::Point_3> Size_field;

  Mesh_in_subdomains_3(Tr& tr, const Size_field& size, const Quality& quality, const double min_dihedral_angle,
                       const Improvement_effort effort, const std::size_t max_number_of_vertices,
                       Recovery_context<Tr>& context, Result& result)
    : m_tr(tr), m_size(size), m_min_dihedral_angle(min_dihedral_angle),
      m_max_number_of_vertices(max_number_of_vertices),
      m_work(size, quality, min_dihedral_angle, effort), m_context(context), m_task_visitor(context.visitor()),
      m_result(result), m_decomposition(tr)
  { }

  void operator()(const std::size_t number_of_subdomains, const bool improve);

private:
  typedef Mesh_part_3<Tr>          Part;
  typedef Part_report_3<Tr>        Report;
  typedef Selected_domain_3<Tr>    Domain;
  typedef Seams_3<>                Seams;
  typedef Task_visitor_3<Tr>       Task_visitor;

  // The pieces of a zone, or a part, and the part that it will belong to.
  struct Task
  {
    std::size_t       part;
    std::vector<Part> pieces;
  };

  typedef Concurrency_tag_of<Tr> Concurrency_tag;

  Domain whole_domain() const { return internal::domain_with_edges(m_tr, m_result.constrained_edges); }

  template <typename Work>
  void run(const Phase phase, const Work& work)
  {
    m_context.run(phase, work, [this](Phase_report& report)
    {
      report.number_of_vertices = m_tr.number_of_vertices() + m_number_of_vertices - m_number_of_old_vertices;
      report.number_of_cells = internal::number_of_finite_cells(m_tr) + number_of_cells(m_parts)
                             - m_number_of_old_cells;
    });
  }

  bool forecast()
  {
    Domain whole = whole_domain();
    Field_point_insertion_3<Tr> insertion(m_tr, whole, m_size, m_context.visitor());
    m_result.filling = insertion.forecast_only(m_max_number_of_vertices, m_context.seconds_left());
    return bool(m_result.filling);
  }

  // It was too low, but the field is known better by now.
  void correct_forecast()
  {
    Domain whole = whole_domain();
    Field_point_insertion_3<Tr> insertion(m_tr, whole, m_size, m_context.visitor());
    const auto corrected = insertion.forecast_of_unfinished(m_result.filling.number_of_field_points);
    m_result.filling.forecast_of_cells = corrected.forecast_of_cells;
    m_result.filling.forecast_of_vertices = corrected.forecast_of_vertices;
  }

  void decompose(const std::size_t number_of_subdomains)
  {
    Domain whole = whole_domain();
    const Fill_background_3<Tr> fill(m_size, m_result.filling.forecast_of_cells, number_of_subdomains);
    note(fill(m_tr, whole, m_task_visitor, m_max_number_of_vertices, m_context.seconds_left()));
    m_parts = m_decomposition.divide(m_size, whole, m_result.constrained_edges, number_of_subdomains,
                                     m_result.recovery.vertices);
    m_number_of_vertices = m_number_of_old_vertices = m_decomposition.number_of_vertices();
    m_number_of_old_cells = number_of_cells(m_parts);
    m_number_of_vertices_in_mesh = m_tr.number_of_vertices();
    m_result.number_of_subdomains = m_parts.size();
  }

  void note(const Field_points_result_3<Tr>& filling)
  {
    m_result.filling.number_of_field_points += filling.number_of_field_points;
    if(m_result.filling)
    {
      m_result.filling.status = filling.status;
      m_result.filling.invalid_sizes = filling.invalid_sizes;
    }
  }

  void improve()
  {
    const double start = m_context.seconds();
    if(internal::is_possible_target(m_min_dihedral_angle))
      run(Phase::quality_improvement, [&] { do_rounds(true); });
    else
      m_result.improvement.status = Meshing_status::invalid_input;
    put_into_triangulation();
    measure();
    m_result.improvement.seconds = m_context.seconds() - start;
  }

  void put_into_triangulation()
  {
    m_decomposition.put_into_triangulation(m_parts, m_number_of_vertices);
    m_parts.clear();
    m_number_of_old_vertices = m_number_of_vertices;
    m_number_of_old_cells = 0;
  }

  void measure()
  {
    const Domain whole = whole_domain();
    Recovery_context<Tr> context(m_context.visitor());
    context.set_maximum_running_time(m_context.seconds_left());
    Explain_bad_cells_3<Tr> explain(m_tr, whole, m_min_dihedral_angle);
    const auto after = Measure_quality_3<Tr>(m_tr, whole)(
      [&](const Cell_handle c, const Cell_angles_3& angles) { explain.add(c, angles); },
      [&context] { return context.can_finish_after_short_step(); });
    internal::set_last_figures(m_result.improvement, after);
    m_result.improvement.certificate = explain.certificate(bool(after));
    if(! after && m_result.improvement)
      m_result.improvement.status = Meshing_status::stopped;
  }

  // Those that fill, or those that improve.
  void do_rounds(const bool improving)
  {
    const std::vector<Subdomain_round> rounds = improving ? improving_rounds() : filling_rounds();
    for(std::size_t k = 0; k < rounds.size(); ++k)
    {
      std::vector<Task> tasks = rounds[k].works_on_parts() ? parts() : zones(rounds[k]);
      m_task_visitor.begin(improving ? Phase::quality_improvement : Phase::field_point_insertion,
                           k, rounds.size(), weight(tasks));
      if(! do_tasks(tasks, rounds[k]))
        return;
    }
  }

  std::vector<Task> parts()
  {
    std::vector<Task> tasks;
    for(std::size_t p = 0; p < m_parts.size(); ++p)
      if(m_parts[p].number_of_cells() > 0)
      {
        tasks.push_back(Task{ p, { } });
        tasks.back().pieces.push_back(std::move(m_parts[p]));
        m_parts[p] = Part();
      }
    return tasks;
  }

  // They are taken out of the parts.
  std::vector<Task> zones(const Subdomain_round& round)
  {
    std::vector<Seam_part_3> seam_parts;
    for(std::size_t p = 0; p < m_parts.size(); ++p)
      seam_parts.push_back(m_work.seam_part(p, m_parts[p], round));
    Seams seams(seam_parts, round.number_of_layers);
    const auto zones = seams.find_zones(round.number_of_parts, round.max_number_of_connected_vertices());
    std::vector<std::vector<typename Split_part_3<Tr>::Group> > pieces(m_parts.size());
    internal::for_each_task(weights_of_parts(), [&](const std::size_t p)
    {
      pieces[p] = Split_part_3<Tr>()(m_parts[p], seam_parts[p].zone_of_cell);
    }, Concurrency_tag());
    std::vector<Task> tasks;
    for(const auto& zone : zones)
      tasks.push_back(Task{ zone.owner, { } });
    for(auto& pieces_of_part : pieces)
      for(auto& [zone, piece] : pieces_of_part)
        tasks[zone].pieces.push_back(std::move(piece));
    return tasks;
  }

  std::vector<std::size_t> weights_of_parts() const
  {
    std::vector<std::size_t> weights;
    for(const Part& part : m_parts)
      weights.push_back(part.number_of_cells());
    return weights;
  }

  static std::size_t weight(const std::vector<Task>& tasks)
  {
    std::size_t sum = 0;
    for(const Task& task : tasks)
      sum += number_of_cells(task.pieces);
    return sum;
  }

  // Returns whether to go on.
  bool do_tasks(std::vector<Task>& tasks, const Subdomain_round& round)
  {
    std::vector<std::size_t> weights;
    for(const Task& task : tasks)
      weights.push_back(number_of_cells(task.pieces));
    std::vector<Part> results(tasks.size());
    std::vector<Report> reports(tasks.size());
    const std::vector<std::size_t> shares = internal::shares_of_vertices(number_left(), weights);
    std::vector<std::size_t> numbers_of_vertices(tasks.size());
    internal::for_each_task(weights, [&](const std::size_t k)
    {
      Join_parts_3<Tr> join;
      for(Part& piece : tasks[k].pieces)
        join.add(std::move(piece));
      tasks[k].pieces.clear();
      results[k] = join.joined();
      numbers_of_vertices[k] = results[k].vertices.size();
      reports[k] = work_on_copy(results[k], round, shares[k]);
      m_task_visitor.end_task(weights[k]);
    }, Concurrency_tag());
    for(std::size_t k = 0; k < tasks.size(); ++k)
      m_number_of_vertices_in_mesh += results[k].vertices.size() - numbers_of_vertices[k];
    work_with_what_is_left(round, results, reports);
    put_back(tasks, results);
    return note(reports, round);
  }

  // A part that could do with more new vertices than that stays as it was.
  Report work_on_copy(Part& part, const Subdomain_round& round, const std::size_t max_number_of_new_vertices)
  {
    const bool is_limited = m_max_number_of_vertices < (std::numeric_limits<std::size_t>::max)();
    Part before = is_limited ? part : Part();
    const Report report = work_on(part, round, max_number_of_new_vertices);
    if(report.was_full)
      part = std::move(before);
    return report;
  }

  // If the work has been stopped, the part stays as it is.
  Report work_on(Part& part, const Subdomain_round& round, const std::size_t max_number_of_new_vertices)
  {
    if(! (m_context.seconds_left() > 0) || ! m_task_visitor.go_further())
      return m_work.stopped(round);
    return m_work(part, round, m_number_of_vertices, max_number_of_new_vertices, m_task_visitor,
                  m_context.seconds_left());
  }

  // Those whose share was too small come one after the other, so that the mesh does not depend on how many threads
  // there are, nor on the limit, if it is kept.
  void work_with_what_is_left(const Subdomain_round& round, std::vector<Part>& parts, std::vector<Report>& reports)
  {
    for(std::size_t k = 0; k < parts.size(); ++k)
      if(reports[k].was_full)
      {
        const std::size_t number_of_vertices = parts[k].vertices.size();
        reports[k] = work_on(parts[k], round, number_left());
        m_number_of_vertices_in_mesh += parts[k].vertices.size() - number_of_vertices;
      }
  }

  // Of vertices that may be inserted.
  std::size_t number_left() const
  {
    return m_max_number_of_vertices - (std::min)(m_max_number_of_vertices, m_number_of_vertices_in_mesh);
  }

  // New vertices get numbers in the order of the tasks.
  void put_back(const std::vector<Task>& tasks, std::vector<Part>& results)
  {
    const std::size_t first_new_number = m_number_of_vertices;
    std::vector<std::size_t> shifts;
    std::vector<std::vector<std::size_t> > tasks_of_part(m_parts.size());
    for(std::size_t k = 0; k < tasks.size(); ++k)
    {
      shifts.push_back(m_number_of_vertices - first_new_number);
      for(const auto& v : results[k].vertices)
        m_number_of_vertices += v.number >= first_new_number;
      tasks_of_part[tasks[k].part].push_back(k);
    }
    internal::for_each_task(weights_of_parts(), [&](const std::size_t p)
    {
      Join_parts_3<Tr> join;
      join.add(std::move(m_parts[p]));
      for(const std::size_t k : tasks_of_part[p])
        join.add(std::move(results[k]), first_new_number, shifts[k]);
      m_parts[p] = join.joined();
    }, Concurrency_tag());
  }

  bool note(const std::vector<Report>& reports, const Subdomain_round& round)
  {
    std::vector<Mesh_quality_3> qualities;
    bool is_stopped = false;
    for(const Report& report : reports)
    {
      note(report.filling);
      m_result.filling.is_field_resolved = m_result.filling.is_field_resolved && report.filling.is_field_resolved;
      if(report.before)
        qualities.push_back(*report.before);
      internal::add_counts(m_result.improvement.counts, report.counts);
      is_stopped = is_stopped || report.is_stopped;
    }
    if(! round.improves)
      return bool(m_result.filling);
    if(round.works_on_parts() && qualities.size() == reports.size())
      m_result.improvement.before = internal::sum_of_qualities(qualities);
    if(is_stopped || ! m_result.filling)
      m_result.improvement.status = m_result.filling ? Meshing_status::stopped : m_result.filling.status;
    return bool(m_result.improvement);
  }

  Tr& m_tr;
  const Size_field& m_size;
  const double m_min_dihedral_angle;
  const std::size_t m_max_number_of_vertices;
  const Work_on_part_3<Tr, Quality> m_work;
  Recovery_context<Tr>& m_context;
  Task_visitor m_task_visitor;
  Result& m_result;
  Decomposition_3<Tr> m_decomposition;
  std::vector<Part> m_parts;
  std::size_t m_number_of_vertices_in_mesh = 0;
  std::size_t m_number_of_vertices = 0;     // numbers from there on are free
  std::size_t m_number_of_old_vertices = 0; // in the place of which the mesh will be
  std::size_t m_number_of_old_cells = 0;
};

template <typename Tr, typename Quality>
void Mesh_in_subdomains_3<Tr, Quality>::operator()(const std::size_t number_of_subdomains, const bool improve)
{
  const double start = m_context.seconds();
  if(! forecast())
    return;
  run(Phase::decomposition, [&] { decompose(number_of_subdomains); });
  if(m_result.filling)
    run(Phase::field_point_insertion, [&] { do_rounds(false); });
  m_result.filling.seconds = m_context.seconds() - start;
  if(m_result.filling && improve)
    this->improve();
  else
    put_into_triangulation();
  if(m_result.filling.status == Meshing_status::too_large)
    correct_forecast();
}

#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

extern template void Mesh_in_subdomains_3<Standard_mesh, Dihedral_angle_quality_3>::operator()(std::size_t, bool);

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_IN_SUBDOMAINS_3_H
