// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SUBDOMAIN_MESHING_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SUBDOMAIN_MESHING_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Constrained_edge_map_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Size_query_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Decomposition_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Divided_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Part_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Seams_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Task_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/for_each_task.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Explain_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Quality_improvement_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/sum_of_qualities.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Steps 6 and 7 in sub-domains [CZZ+17, Section 5.2.2]: a coarse background mesh is divided into parts, which are
 * filled at the same time; then the zones around their seams are, so that nothing is left of these; and the same again
 * for the improvement. Nothing has to be recovered: sub-domains are made of cells, and their walls are facets of the
 * background mesh, which stay until it is the turn of the seams.
 *
 * The mesh depends on the number of sub-domains, but not on the number of threads.
 */
template <typename Tr, typename SizingField, typename Recorder>
class Subdomain_meshing_3
{
public:
  typedef typename Tr::Cell_handle               Cell_handle;
  typedef Boundary_constrained_mesh_result_3<Tr> Result;

  Subdomain_meshing_3(Tr& tr, const SizingField& size, Recorder& recorder, Result& result)
    : m_tr(tr), m_size(size), m_recorder(recorder), m_task_visitor(recorder), m_result(result), m_decomposition(tr)
  { }

  // When the domain is filled, `improve_or_finish` is called with this object: it calls one of the members below.
  template <typename ImproveOrFinish>
  void operator()(const std::size_t number_of_subdomains, const std::size_t max_number_of_vertices,
                  const ImproveOrFinish& improve_or_finish)
  {
    const double start = m_recorder.seconds();
    if(! forecast(max_number_of_vertices))
      return;
    run(Meshing_phase::decomposition, [&] { decompose(number_of_subdomains); });
    if(m_result.filling)
      run(Meshing_phase::field_point_insertion, [&] { fill(max_number_of_vertices); });
    m_result.filling.seconds = m_recorder.seconds() - start;
    if(m_result.filling)
      improve_or_finish(*this);
    else
      finish();
  }

  template <typename Quality>
  void improve(const Quality& quality, const double min_dihedral_angle)
  {
    const double start = m_recorder.seconds();
    if(internal::is_possible_target(min_dihedral_angle))
      run(Meshing_phase::quality_improvement, [&] { improve_in_rounds(quality, min_dihedral_angle); });
    else
      m_result.improvement.status = Meshing_status::invalid_input;
    finish();
    measure(min_dihedral_angle);
    m_result.improvement.seconds = m_recorder.seconds() - start;
  }

  // Puts all into the triangulation.
  void finish()
  {
    m_decomposition.put_into_triangulation(m_mesh);
    m_mesh = Mesh();
    m_number_of_old_vertices = m_number_of_old_cells = 0;
  }

private:
  typedef Divided_mesh_3<Tr>                               Mesh;
  typedef Part_triangulation_3<Tr>                         Part_triangulation;
  typedef Seams_3<Tr>                                      Seams;
  typedef typename Seams::Zone                             Task;
  typedef Task_visitor_3<Recorder>                         Task_visitor;
  typedef Static_boolean_property_map<Cell_handle, true>   All_cells;
  typedef Selected_domain_3<Tr, All_cells, Constrained_edge_map_3<Tr> > Whole_domain;

  // What was divided has seams: walls that are on no surface, with nothing behind them.
  struct Domain
    : public Whole_domain
  {
    using Whole_domain::Whole_domain;

    static constexpr bool has_seams = true;

    static bool is_seam(const Cell_handle c, const int i)
    {
      typedef typename Whole_domain::Subdomain_index Region;
      return ! c->is_facet_on_surface(i) && c->neighbor(i)->subdomain_index() == Region();
    }
  };

  // Numbers with reference counts are not for several threads.
  typedef std::conditional_t<std::is_floating_point<typename Tr::Geom_traits::FT>::value,
                             Parallel_if_available_tag, Sequential_tag> Concurrency_tag;

  // See "Tuning constants" in the manual.
  static constexpr double background_coarseness = 8;
  static constexpr double background_cells_per_subdomain = 1000;
  static constexpr int layers_to_be_filled = 3;
  static constexpr int layers_to_be_improved = 2;

  static constexpr double angle_to_be_repaired = 20;
  static constexpr int layers_to_be_repaired = 4;

  static constexpr std::size_t number_of_rounds = Seams::last_round; // the parts, then seams

  // The sizes of the background mesh.
  struct Coarse_field
  {
    double operator()(const typename Tr::Geom_traits::Point_3& p, const int dimension, const int index) const
    {
      return factor * internal::size_of_field<typename Tr::Geom_traits>(field, p, dimension, index);
    }

    double grading() const { return factor * internal::grading_of_field<typename Tr::Geom_traits>(field); }

    const SizingField& field;
    double factor;
  };

  // Before it is divided, and when it is put together; without seams.
  Domain whole_domain() const
  {
    return domain(m_tr, Constrained_edge_map_3<Tr>(m_result.constrained_edges));
  }

  Domain domain(Tr& tr, const Constrained_edge_map_3<Tr>& edges) const { return Domain(tr, All_cells(), edges); }

  template <typename Work>
  void run(const Meshing_phase phase, const Work& work)
  {
    const double start = m_recorder.seconds();
    m_recorder.on_phase_begin(phase);
    work();
    Meshing_phase_report report;
    report.phase = phase;
    report.number_of_vertices = m_tr.number_of_vertices() + m_mesh.vertices.size() - m_number_of_old_vertices;
    report.number_of_cells = m_tr.number_of_finite_cells() + m_mesh.number_of_cells() - m_number_of_old_cells;
    report.seconds = m_recorder.seconds() - start;
    m_recorder.on_phase_end(report);
  }

  bool forecast(const std::size_t max_number_of_vertices)
  {
    Domain whole = whole_domain();
    Field_point_insertion_3<Tr, Domain, SizingField, Recorder> insertion(m_tr, whole, m_size, m_recorder);
    m_result.filling = insertion.forecast_only(max_number_of_vertices, m_recorder.seconds_left());
    return bool(m_result.filling);
  }

  // The smaller sub-domains are, the finer the background mesh has to be: seams are about as thick as its cells.
  double coarseness(const std::size_t number_of_subdomains) const
  {
    const double number = background_cells_per_subdomain * static_cast<double>(number_of_subdomains);
    return (std::max)(1., (std::min)(background_coarseness, std::cbrt(m_result.filling.forecast_of_cells / number)));
  }

  void decompose(const std::size_t number_of_subdomains)
  {
    Domain whole = whole_domain();
    const Coarse_field field{ m_size, coarseness(number_of_subdomains) };
    note(Field_point_insertion_3<Tr, Domain, Coarse_field, Task_visitor>(m_tr, whole, field, m_task_visitor,
                                                                         Forecast_effort::none)
           ((std::numeric_limits<std::size_t>::max)(), m_recorder.seconds_left()));
    m_decomposition.divide(m_size, whole, m_result.constrained_edges, number_of_subdomains, m_mesh);
    m_number_of_old_vertices = m_mesh.vertices.size();
    m_number_of_old_cells = m_mesh.number_of_cells();
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

  void fill(const std::size_t max_number_of_vertices)
  {
    m_max_number_of_vertices = max_number_of_vertices;
    do_in_rounds(Meshing_phase::field_point_insertion, number_of_rounds, layers_to_be_filled,
                 [&](const std::size_t number_of_tasks, const auto& do_all)
    {
      std::vector<Field_points_result_3<Tr> > results(number_of_tasks);
      do_all([&](const std::size_t k, Tr& tr, Domain& domain) { results[k] = filled(tr, domain); });
      for(const auto& result : results)
        note(result);
      return bool(m_result.filling);
    });
  }

  Field_points_result_3<Tr> filled(Tr& tr, Domain& domain)
  {
    const std::size_t n = m_mesh.vertices.size();
    const std::size_t number_left = m_max_number_of_vertices - (std::min)(m_max_number_of_vertices, n);
    const std::size_t max_number = (std::max)(number_left, tr.number_of_vertices() + number_left); // no overflow
    typedef Field_point_insertion_3<Tr, Domain, SizingField, Task_visitor> Insertion;
    return Insertion(tr, domain, m_size, m_task_visitor, Forecast_effort::none)(max_number, m_recorder.seconds_left());
  }

  // In the end, what is bad is improved again, without anything near it that has to stay.
  template <typename Quality>
  void improve_in_rounds(const Quality& quality, const double min_dihedral_angle)
  {
    const auto improve_all = [&](const std::size_t number_of_tasks, const auto& do_all)
    {
      return improve_tasks(quality, min_dihedral_angle, number_of_tasks, do_all);
    };
    constexpr Meshing_phase phase = Meshing_phase::quality_improvement;
    if(! do_in_rounds(phase, number_of_rounds + 1, layers_to_be_improved, improve_all))
      return;
    const double enough = quality.of_angle((std::min)(angle_to_be_repaired, min_dihedral_angle));
    std::vector<Task> tasks = Seams(m_mesh, layers_to_be_repaired).take_out_around([&](const auto& c)
    {
      const auto corner = [&](const int i) { return coordinates_of(m_mesh.vertices[c.vertices[i]].point); };
      return quality({{ corner(0), corner(1), corner(2), corner(3) }}) < enough;
    });
    m_task_visitor.begin(phase, number_of_rounds, number_of_rounds + 1, weight(tasks));
    do_round(tasks, improve_all);
  }

  template <typename Quality, typename DoAll>
  bool improve_tasks(const Quality& quality, const double min_dihedral_angle, const std::size_t number_of_tasks,
                     const DoAll& do_all)
  {
    const bool is_first = m_result.improvement.before.number_of_cells == 0;
    std::vector<Field_points_result_3<Tr> > results(number_of_tasks);
    std::vector<Mesh_quality_3> qualities(number_of_tasks);
    std::vector<Quality_improvement_counts> counts(number_of_tasks);
    std::vector<char> is_stopped(number_of_tasks, false);
    do_all([&](const std::size_t k, Tr& tr, Domain& domain)
    {
      results[k] = filled(tr, domain); // what is left beside zones of seams that met
      if(is_first)
        qualities[k] = Measure_quality_3<Tr, Domain>(tr, domain)([](const Cell_handle, const Cell_angles_3&) { });
      Recovery_context<Task_visitor> context(m_task_visitor);
      context.set_maximum_running_time(m_recorder.seconds_left());
      Improve_domain_3<Tr, Domain, Quality, Task_visitor> improve_domain(tr, domain, quality, context);
      improve_domain(min_dihedral_angle);
      counts[k] = improve_domain.counts();
      is_stopped[k] = context.is_stopped();
    });
    if(is_first)
      m_result.improvement.before = internal::sum_of_qualities(qualities);
    for(const auto& result : results)
      note(result);
    for(const auto& c : counts)
      internal::add_counts(m_result.improvement.counts, c);
    const bool is_any_stopped = std::count(is_stopped.begin(), is_stopped.end(), true) > 0;
    if(is_any_stopped || ! m_result.filling)
      m_result.improvement.status = m_result.filling ? Meshing_status::stopped : m_result.filling.status;
    return bool(m_result.improvement);
  }

  void measure(const double min_dihedral_angle)
  {
    const Domain whole = whole_domain();
    Explain_bad_cells_3<Tr, Domain> explain(whole, min_dihedral_angle);
    m_result.improvement.after = Measure_quality_3<Tr, Domain>(m_tr, whole)(
      [&](const Cell_handle c, const Cell_angles_3& angles) { explain.add(c, angles); });
    m_result.improvement.certificate = explain.certificate();
  }

  // `work` gets the number of tasks, and a function that does all of them; it returns whether to go on, and so does
  // this. The phase may have more rounds.
  template <typename Work>
  bool do_in_rounds(const Meshing_phase phase, const std::size_t number_of_rounds_of_phase, const int number_of_layers,
                    const Work& work)
  {
    for(std::size_t round = 1; round <= number_of_rounds; ++round)
    {
      std::vector<Task> tasks = round == 1 ? parts() : Seams(m_mesh, number_of_layers).take_out(round);
      m_task_visitor.begin(phase, round - 1, number_of_rounds_of_phase, weight(tasks));
      if(! do_round(tasks, work))
        return false;
    }
    return true;
  }

  template <typename Work>
  bool do_round(std::vector<Task>& tasks, const Work& work)
  {
    return work(tasks.size(), [&](const auto& do_task) { this->do_tasks(tasks, do_task); });
  }

  static std::size_t weight(const std::vector<Task>& tasks)
  {
    std::size_t sum = 0;
    for(const Task& task : tasks)
      sum += task.cells.size();
    return sum;
  }

  std::vector<Task> parts()
  {
    std::vector<Task> tasks;
    for(std::size_t p = 0; p < m_mesh.parts.size(); ++p)
      if(! m_mesh.parts[p].empty())
      {
        tasks.push_back(Task{ p, { } });
        tasks.back().cells.swap(m_mesh.parts[p]);
      }
    return tasks;
  }

  template <typename Work>
  void do_tasks(std::vector<Task>& tasks, const Work& work)
  {
    std::vector<std::size_t> weights;
    for(const Task& task : tasks)
      weights.push_back(task.cells.size());
    std::vector<Changed_part_3<Tr> > changes(tasks.size());
    internal::for_each_task(weights, [&](const std::size_t k)
    {
      Part_triangulation triangulation(m_mesh, tasks[k].cells);
      typename Mesh::Part().swap(tasks[k].cells);
      Domain domain = this->domain(triangulation.triangulation(),
                                   Constrained_edge_map_3<Tr>(triangulation.constrained_edges()));
      work(k, triangulation.triangulation(), domain);
      changes[k] = triangulation.change();
      m_task_visitor.end_task(weights[k]);
    }, Concurrency_tag());
    const std::size_t old_number_of_vertices = m_mesh.vertices.size();
    for(std::size_t k = 0; k < tasks.size(); ++k)
      internal::put_back(m_mesh, tasks[k].part, changes[k], old_number_of_vertices);
  }

  Tr& m_tr;
  const SizingField& m_size;
  Recorder& m_recorder;
  Task_visitor m_task_visitor;
  Result& m_result;
  Decomposition_3<Tr> m_decomposition;
  Mesh m_mesh;
  std::size_t m_max_number_of_vertices = 0;
  std::size_t m_number_of_old_vertices = 0; // in the place of which the mesh will be
  std::size_t m_number_of_old_cells = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SUBDOMAIN_MESHING_3_H
