// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_BOUNDARY_CONSTRAINED_MESHING_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_BOUNDARY_CONSTRAINED_MESHING_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Constrained_edge_map_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/Surface_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mark_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Subdomain_meshing_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/improve_mesh_quality.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/mark_domain.h>
#include <CGAL/recover_boundary.h>

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Stands between the steps of the mesher and the caller's visitor: it collects what phases report, asks whether to go
 * on only until the answer is no, and knows the time that is left for all steps together.
 */
template <typename Visitor>
class Meshing_recorder_3
{
public:
  // `maximum_running_time` is in seconds, from now on.
  Meshing_recorder_3(Visitor& visitor, std::vector<Phase_report>& reports, const double maximum_running_time)
    : m_visitor(visitor), m_reports(reports), m_start(Clock::now()), m_maximum_running_time(maximum_running_time)
  { }

  void on_phase_begin(const Phase phase) { m_visitor.on_phase_begin(phase); }

  // What the recovery reports is in its own result.
  void on_phase_end(const Phase_report& report)
  {
    if(! internal::is_of_recovery(report.phase))
      m_reports.push_back(report);
    m_visitor.on_phase_end(report);
  }

  void on_progress(const Phase phase, const std::size_t done, const std::size_t total)
  {
    m_visitor.on_progress(phase, done, total);
  }

  bool go_further()
  {
    m_is_stopped = m_is_stopped || ! m_visitor.go_further();
    return ! m_is_stopped;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells) { m_visitor.before_cells_removal(cells); }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { m_visitor.after_cells_creation(cells); }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  // May be negative.
  double seconds_left() const { return m_maximum_running_time - seconds(); }

  // Whether neither the visitor nor the time limit ends the work.
  bool can_go_further() { return seconds_left() > 0 && go_further(); }

private:
  typedef std::chrono::steady_clock Clock;

  Visitor& m_visitor;
  std::vector<Phase_report>& m_reports;
  Clock::time_point m_start;
  double m_maximum_running_time;
  bool m_is_stopped = false;
};

/*
 * Keeps the vertices that the result of the recovery names true while the mesh is improved: those of the input stay
 * where they are, for which those that no facet has are corners in the meantime. Steiner points may move and go; then
 * they are no longer named.
 */
template <typename Tr>
class Hold_recovered_vertices_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Point             Point;
  typedef Boundary_recovery_result_3<Tr> Recovery;

  Hold_recovered_vertices_3(const Tr& tr, Recovery& recovery)
    : m_tr(tr), m_recovery(recovery)
  {
    for(const Vertex_handle v : recovery.vertices)
      if(v->in_dimension() == 3)
      {
        v->set_dimension(0);
        m_corners.push_back(v);
      }
    for(const Vertex_handle v : recovery.steiner_vertices)
      m_places.push_back(v->point());
  }

  Hold_recovered_vertices_3(const Hold_recovered_vertices_3&) = delete;
  Hold_recovered_vertices_3& operator=(const Hold_recovered_vertices_3&) = delete;

  ~Hold_recovered_vertices_3()
  {
    for(const Vertex_handle v : m_corners)
      v->set_dimension(3);
  }

  // A new vertex may have got the handle of one that went, but hardly its place, and then it is as good.
  void forget_lost_steiner_vertices()
  {
    std::vector<Vertex_handle>& vertices = m_recovery.steiner_vertices;
    if(vertices.empty())
      return;
    Unique_hash_map<Vertex_handle, std::size_t> position; // for looking up only
    for(std::size_t i = 0; i < vertices.size(); ++i)
      position[vertices[i]] = i;
    std::vector<char> is_there(vertices.size(), false);
    for(const Vertex_handle v : m_tr.finite_vertex_handles())
      if(position.is_defined(v))
        is_there[position[v]] = v->point() == m_places[position[v]];
    std::size_t number = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(is_there[i])
        vertices[number++] = vertices[i];
    vertices.resize(number);
  }

private:
  const Tr& m_tr;
  Recovery& m_recovery;
  std::vector<Vertex_handle> m_corners;
  std::vector<Point> m_places; // of the Steiner points
};

// In the place of a size field: the sizes come from the surface.
struct Sizes_from_surface { };

// The mesh edges that the constrained edges of the input consist of.
template <typename Tr>
struct Constrained_mesh_edges_3
{
  typedef std::array<typename Tr::Vertex_handle, 2> Vertex_pair;

  template <typename NamedParameters>
  Constrained_mesh_edges_3(const Boundary_recovery_result_3<Tr>& recovery, const NamedParameters& np)
  {
    // parts of one constraint come one after the other
    Simplex_index_3<std::size_t, 2> index;
    std::vector<std::size_t> begin;
    const auto& parts = recovery.parts_of_edges;
    const auto ends = [&](const std::size_t p) -> std::array<std::size_t, 2>
    {
      return {{ parts[p].constraint.vertices[0], parts[p].constraint.vertices[1] }};
    };
    for(std::size_t p = 0; p < parts.size(); ++p)
      if(index.insert(ends(p)).second)
        begin.push_back(p);
    begin.push_back(parts.size());

    std::size_t number = 0;
    internal::for_each_constrained_edge(np, [&](const std::size_t u, const std::size_t v)
    {
      ++number;
      const std::size_t k = index[{{ u, v }}];
      if(k == index.none)
        add({{ recovery.vertices[u], recovery.vertices[v] }}, number);
      else
        for(std::size_t p = begin[k]; p < begin[k + 1]; ++p)
          add({{ parts[p].vertices[0], parts[p].vertices[1] }}, number);
    });
  }

  std::vector<Vertex_pair> edges;
  std::vector<std::size_t> numbers; // of the constrained edges that they are parts of, from 1 on

private:
  void add(const Vertex_pair& edge, const std::size_t number)
  {
    edges.push_back(edge);
    numbers.push_back(number);
  }
};

/*
 * The work behind all the overloads of make_boundary_constrained_mesh_3(): one step after the other, as long as there
 * is something to do and time for it.
 */
template <typename Tr, typename NamedParameters>
class Boundary_constrained_meshing_3
{
public:
  typedef Boundary_constrained_mesh_result_3<Tr> Result;

  Boundary_constrained_meshing_3(Tr& tr, const NamedParameters& np) : m_tr(tr), m_np(np) { }

  // `recover` gets named parameters and returns the result of the recovery; `patches` gets the facets of the surface
  // and returns the patch of each.
  template <typename Recover, typename Patches, typename SizingField>
  Result operator()(const Recover& recover, const Patches& patches, const SizingField& size)
  {
    decltype(auto) visitor = internal::visitor_of(m_np);
    typedef Meshing_recorder_3<std::decay_t<decltype(visitor)> > Recorder;
    Result result;
    Recorder recorder(visitor, result.phases, maximum_running_time());

    result.recovery = recover(internal::merge(m_np, parameters::visitor(std::ref(recorder))));
    result.status = status(result.recovery.status);
    if(result.recovery)
    {
      mark_domain(patches, recorder, result);
      if(result.number_of_regions == 0)
        result.status = Meshing_status::no_region;
      else if(! recorder.can_go_further())
        result.status = result.filling.status = result.improvement.status = Meshing_status::stopped;
      else
        fill_and_improve(size, recorder, result);
    }
    result.seconds = recorder.seconds();
    return result;
  }

private:
  using Edges = Constrained_mesh_edges_3<Tr>;

  double maximum_running_time() const
  {
    return parameters::choose_parameter(parameters::get_parameter(m_np, internal_np::maximum_running_time),
                                        std::numeric_limits<double>::infinity());
  }

  static Meshing_status status(const Recovery_status status)
  {
    switch(status)
    {
      case Recovery_status::recovered:     return Meshing_status::meshed;
      case Recovery_status::incomplete:    return Meshing_status::incomplete;
      case Recovery_status::invalid_input: return Meshing_status::invalid_input;
      case Recovery_status::stopped:       return Meshing_status::stopped;
    }
    return Meshing_status::incomplete;
  }

  // It takes so little time that it is always done, so that a mesh that was stopped has its regions, too.
  template <typename Patches, typename Recorder>
  void mark_domain(const Patches& patches, Recorder& recorder, Result& result)
  {
    const double start = recorder.seconds();
    recorder.on_phase_begin(Phase::domain_marking);
    const auto facets = result.recovery.surface_facets();
    const Edges edges(result.recovery, m_np);
    result.number_of_regions = Mark_domain_3<Tr>(m_tr)(facets, patches(facets), edges.edges, edges.numbers);
    result.constrained_edges = edges.edges;
    Phase_report report;
    report.phase = Phase::domain_marking;
    report.number_of_vertices = m_tr.number_of_vertices();
    report.number_of_cells = m_tr.number_of_finite_cells();
    report.seconds = recorder.seconds() - start;
    recorder.on_phase_end(report);
  }

  template <typename SizingField, typename Recorder>
  void fill_and_improve(const SizingField& size, Recorder& recorder, Result& result)
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, number_of_subdomains_t>::value)
      mesh(size, recorder, result);
    else
      mesh_in_subdomains(size, recorder, result);
  }

  template <typename Recorder>
  void fill_and_improve(const Sizes_from_surface&, Recorder& recorder, Result& result)
  {
    const double grading = get(internal::grading, internal::default_surface_grading);
    if(grading >= 0 && grading < std::numeric_limits<double>::infinity())
      fill_and_improve(Surface_sizing_field_3<Tr>(m_tr, grading, result.constrained_edges), recorder, result);
    else
      refuse_grading(grading, result);
  }

  template <typename SizingField, typename Recorder>
  void mesh(const SizingField& size, Recorder& recorder, Result& result)
  {
    result.filling = insert_field_points(m_tr, size, parameters_of_step(recorder, result));
    result.status = result.improvement.status = result.filling.status;
    if(! result.filling || ! get(internal::improve_quality, true))
      return;
    Hold_recovered_vertices_3<Tr> hold(m_tr, result.recovery);
    result.improvement = improve_mesh_quality(m_tr, parameters_of_step(recorder, result));
    result.status = result.improvement.status;
    hold.forget_lost_steiner_vertices();
  }

  template <typename SizingField, typename Recorder>
  void mesh_in_subdomains(const SizingField& size, Recorder& recorder, Result& result)
  {
    const std::size_t number = static_cast<std::size_t>(get(internal::number_of_subdomains, 1));
    if(number < 2)
      return mesh(size, recorder, result);
    const std::size_t max_number_of_vertices = static_cast<std::size_t>(
      get(internal::maximum_number_of_vertices, (std::numeric_limits<std::size_t>::max)()));
    const double min_dihedral_angle = get(internal::min_dihedral_angle, default_min_dihedral_angle);
    const Improvement_effort effort = get(internal::improvement_effort, Improvement_effort::normal);
    Hold_recovered_vertices_3<Tr> hold(m_tr, result.recovery);
    const auto quality = get(internal::cell_quality, Dihedral_angle_quality_3());
    Subdomain_meshing_3<Tr, SizingField, std::decay_t<decltype(quality)>, Recorder>(
      m_tr, size, quality, min_dihedral_angle, effort, max_number_of_vertices, recorder, result)(
      number, get(internal::improve_quality, true));
    hold.forget_lost_steiner_vertices();
    if(! result.filling)
      result.improvement.status = result.filling.status;
    result.status = result.improvement.status;
  }

  template <typename Tag, typename Default>
  auto get(const Tag tag, const Default& default_value) const
  {
    return parameters::choose_parameter(parameters::get_parameter(m_np, tag), default_value);
  }

  // Those of the caller, with the time that is left.
  template <typename Recorder>
  auto parameters_of_step(Recorder& recorder, const Result& result) const
  {
    return internal::merge_all(
      m_np, parameters::visitor(std::ref(recorder)), parameters::maximum_running_time(recorder.seconds_left()),
      parameters::edge_is_constrained_map(Constrained_edge_map_3<Tr>(result.constrained_edges)));
  }

  // It is no size, but what would make all of them.
  void refuse_grading(const double grading, Result& result) const
  {
    result.status = result.filling.status = Meshing_status::invalid_input;
    result.filling.invalid_sizes.push_back({ m_tr.finite_vertices_begin()->point(), grading,
                                             "it is the grading, which has to be finite and not negative" });
  }

  Tr& m_tr;
  const NamedParameters& m_np;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_BOUNDARY_CONSTRAINED_MESHING_3_H
