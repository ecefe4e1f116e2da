// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_RECOVER_INDEXED_BOUNDARY_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_RECOVER_INDEXED_BOUNDARY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Input_diagnosis_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Vertex_location.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>
#include <CGAL/Constrained_boundary_recovery_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

struct Recovery_options
{
  Recovery_mode mode = Recovery_mode::constrained;
  Recovery_effort effort = Recovery_effort::more_time;
  int max_recursion_level = -1;                                               // negative: the default of the driver
  double maximum_running_time = std::numeric_limits<double>::infinity();      // seconds
  bool list_defects = false;
  std::size_t maximum_number_of_defects = 1000000;
};

// Counts the defects of a result, unless there are known to be more of them than it has, and cuts their list.
template <typename Tr>
void bound_defects(Boundary_recovery_result_3<Tr>& result, const std::size_t max_number)
{
  result.number_of_defects = (std::max)(result.number_of_defects, result.defects.size());
  if(result.defects.size() > max_number)
    result.defects.resize(max_number);
}

/*
 * The work behind all the overloads of recover_boundary(), on input in index form: it checks the input, finds or
 * inserts the vertices, runs the recovery, and writes the account in the caller's indices.
 */
template <typename Tr, typename GT>
class Recover_indexed_boundary
{
public:
  typedef typename Tr::Vertex_handle                Vertex_handle;
  typedef typename Tr::Geom_traits::Point_3         Point_3;
  typedef Indexed_input_3<Point_3>                  Input;
  typedef Boundary_recovery_result_3<Tr>            Result;
  typedef typename Result::Input_simplex            Simplex;
  typedef typename Result::Input_defect             Defect;

  Recover_indexed_boundary(Tr& tr, const Input& input, const GT& gt, const Recovery_options& options,
                           Mesh_visitor_3<Tr>& visitor)
    : m_tr(tr), m_input(input), m_gt(gt), m_options(options), m_context(visitor)
  {
    m_context.set_maximum_running_time(options.maximum_running_time);
  }

  // `vertices` are those of the input points where the caller knows them, else empty.
  Result operator()(std::vector<Vertex_handle> vertices);

private:
  typedef Constrained_boundary_recovery_3<Tr, Mesh_visitor_3<Tr> > Recovery;
  typedef Recovery_diagnosis<GT> Diagnosis;
  typedef typename Input::Edge Edge;

  // Where no defect may be listed, there may be some nevertheless.
  bool is_invalid() const { return m_result.number_of_defects > 0; }

  // `number` is larger than that of the defects if not all of them are there.
  void set_defects(std::vector<Defect> defects, const std::size_t number = 0)
  {
    m_result.defects = std::move(defects);
    m_result.number_of_defects = number;
    internal::bound_defects(m_result, m_options.maximum_number_of_defects);
  }

  Diagnosis diagnosis() const { return Diagnosis(m_input, m_gt, m_options.maximum_number_of_defects); }

  void list_intersections()
  {
    Diagnosis search = diagnosis();
    std::vector<Defect> found = search.intersecting_pairs(m_context);
    set_defects(std::move(found), search.number_of_defects());
  }

  // Once stopped, no points are inserted.
  void find_vertices()
  {
    const double start = m_context.seconds();
    const bool is_complete = locate_points();
    if(! is_complete && ! can_insert(m_tr))
      list_unknown_vertices();
    if(is_invalid() || m_context.is_stopped())
      return;
    m_context.run(Phase::insertion, [&]
    {
      if(! is_complete)
        m_result.number_of_inserted_vertices = insert_points(m_tr, m_input.points, m_result.vertices, m_context);
    },
    [&](Phase_report& report)
    {
      report.seconds = m_context.seconds() - start; // with the search for the points
      m_result.phases.push_back(report);
    });
  }

  // Looks for the points in the triangulation. Returns whether all of them are there.
  bool locate_points()
  {
    m_result.vertices.assign(m_input.points.size(), Vertex_handle());
    if(m_tr.number_of_vertices() == 0)
      return false;
    const Vertex_location<Tr> location(m_tr);
    for(std::size_t i = 0; i < m_input.points.size(); ++i)
      m_result.vertices[i] = location(m_input.points[i]);
    return is_every_point_known();
  }

  bool is_every_point_known() const
  {
    return std::find(m_result.vertices.begin(), m_result.vertices.end(), Vertex_handle()) == m_result.vertices.end();
  }

  void list_unknown_vertices()
  {
    std::vector<Defect> unknown;
    for(std::size_t i = 0; i < m_input.points.size(); ++i)
      if(m_result.vertices[i] == Vertex_handle())
        unknown.push_back(Defect{ Input_defect_kind::unknown_vertex, { describe_vertex(m_input, i) } });
    set_defects(std::move(unknown));
  }

  // The checks that need all vertices.
  void check_triangulation()
  {
    if(is_invalid() || ! is_every_point_known())
      return;
    if(m_tr.dimension() < 3)
      set_defects(std::vector<Defect>(1, Defect{ Input_defect_kind::dimension_less_than_3, {} }));
    else if(m_options.list_defects && ! m_context.is_stopped())
      list_vertices_on(all_constraints());
  }

  void list_vertices_on(const std::vector<Simplex>& constraints)
  {
    Diagnosis search = diagnosis();
    std::vector<Defect> found = search.vertices_on_constraints(constraints, m_tr, m_result.vertices, m_context);
    set_defects(std::move(found), search.number_of_defects());
  }

  Result invalid_input()
  {
    m_result.status = Recovery_status::invalid_input;
    m_result.vertices.clear();
    m_result.number_of_edges = internal::number_of_edges(m_input);
    m_result.number_of_facets = m_input.facets.size();
    return std::move(m_result);
  }

  // The points are not all in the triangulation: nothing can be said about constraints but that they are missing.
  Result stopped_early()
  {
    m_result.status = Recovery_status::stopped;
    internal::for_each_edge(m_input, [this](const std::size_t index, const Edge& e)
    {
      m_result.missing_edges.push_back(describe_simplex(m_input, index, e));
    });
    for(std::size_t f = 0; f < m_input.facets.size(); ++f)
      m_result.missing_facets.push_back(describe_facet(m_input, f));
    m_result.number_of_edges = m_result.missing_edges.size();
    m_result.number_of_facets = m_result.missing_facets.size();
    list_facets();
    return std::move(m_result);
  }

  void recover()
  {
    Recovery recovery(m_tr, m_context);
    if(m_options.max_recursion_level >= 0)
      recovery.set_max_recursion_level(m_options.max_recursion_level);
    if(m_options.mode != Recovery_mode::flips_only)
      recovery.set_effort(m_options.effort);
    insert_constraints(recovery);
    examine_after_work([this, &recovery] { return indices_of_missing(recovery); });
    const bool is_recovered = m_context.is_stopped()
      ? is_nothing_lost(recovery)
      : recovery.recover_by_flips(m_options.mode) || recover_by_points(recovery);
    take_account(recovery);
    m_result.status = is_recovered             ? Recovery_status::recovered
                    : is_invalid()             ? Recovery_status::invalid_input
                    : m_context.is_stopped()   ? Recovery_status::stopped
                    : Recovery_status::incomplete;
    if(m_result.status == Recovery_status::invalid_input)
      m_result.vertices.clear(); // as for input that is refused at once
    else
      list_facets();
  }

  // Judges the input only now, for in most cases flips are enough, and prove it valid.
  bool recover_by_points(Recovery& recovery)
  {
    if(m_context.is_stopped())
      return false;
    if(! is_invalid())
      judge_missing_constraints(recovery);
    return ! is_invalid() && ! m_context.is_stopped() && recovery.recover_by_points(m_options.mode);
  }

  // Where constraints intersect, flips go on and on in vain. Valid input must hardly pay for the question, so it is
  // asked only after work that takes far longer than the answer. `missing` returns the indices of the constraints that
  // are missing then.
  template <typename Missing>
  void examine_after_work(const Missing& missing)
  {
    const std::size_t number = number_of_quick_constraints + m_input.facets.size() + m_input.edges.size();
    if(! m_options.list_defects) // else the answer is known
      examine_after(work_before_examination_per_constraint * number, number_of_examined_constraints, missing);
  }

  // Where flips are in vain, many of the missing constraints intersect others, so it is enough to look at some of them.
  // The question is asked again, for twice as many, after twice the work.
  template <typename Missing>
  void examine_after(const std::size_t work, const std::size_t number_of_constraints, const Missing& missing)
  {
    m_context.examine_after(work, [this, work, number_of_constraints, missing]
    {
      look_for_intersections(m_sample(m_input, missing(), number_of_constraints), work / work_per_box_pair);
      if(is_invalid())
        m_context.refute();
      else
        examine_after(2 * work, 2 * number_of_constraints, missing);
    });
  }

  // Sets the defects if any of these constraints, which are missing, intersects another one. Gives up after so many
  // pairs of boxes that intersect.
  void look_for_intersections(const std::vector<Simplex>& missing,
                              const std::size_t max_number_of_box_pairs = std::size_t(-1))
  {
    Diagnosis search = diagnosis();
    std::vector<Defect> found = search.intersecting_pairs(missing, m_context, max_number_of_box_pairs);
    set_defects(std::move(found), search.number_of_defects());
  }

  static bool is_nothing_lost(Recovery& recovery)
  {
    recovery.search();
    return recovery.lost_edges().empty() && recovery.lost_facets().empty();
  }

  // The facets, then the edges, those of the facets included.
  std::vector<Simplex> all_constraints() const
  {
    std::vector<Simplex> constraints;
    for(std::size_t f = 0; f < m_input.facets.size(); ++f)
      constraints.push_back(describe_facet(m_input, f));
    internal::for_each_edge(m_input, [&](const std::size_t index, const Edge& e)
    {
      constraints.push_back(describe_simplex(m_input, index, e));
    });
    return constraints;
  }

  // Of the input, as all the indices that constraints are sampled from.
  Lost_constraints indices_of_all() const
  {
    Lost_constraints all;
    all.facets.resize(m_input.facets.size());
    all.edges.resize(m_input.edges.size());
    std::iota(all.facets.begin(), all.facets.end(), std::size_t(0));
    std::iota(all.edges.begin(), all.edges.end(), std::size_t(0));
    return all;
  }

  // Of an edge of facets that is missing, these are missing, too.
  Lost_constraints indices_of_missing(const Recovery& recovery) const
  {
    Lost_constraints missing;
    missing.facets = recovery.lost_facets(); // facets are all distinct, so they keep their indices
    for(const std::size_t e : recovery.lost_edges())
      if(e < m_edges.size())
        missing.edges.push_back(m_edges[e].index);
    return missing;
  }

  void insert_constraints(Recovery& recovery)
  {
    const std::vector<Vertex_handle>& v = m_result.vertices;
    recovery.reserve(m_input.edges.size(), m_input.facets.size());
    for(std::size_t i = 0; i < m_input.edges.size(); ++i)
    {
      const auto& e = m_input.edges[i];
      if(recovery.insert_constraint(v[e[0]], v[e[1]]) == m_edges.size())
        m_edges.push_back(describe_edge(m_input, i));
    }
    for(const auto& f : m_input.facets)
      recovery.insert_constraint(v[f[0]], v[f[1]], v[f[2]]);
  }

  void take_account(const Recovery& recovery)
  {
    m_result.number_of_edges = recovery.constrained_edges().size();
    m_result.number_of_facets = recovery.constrained_facets().size();
    m_result.number_of_shell_transformations = recovery.number_of_transformations();
    m_result.phases.insert(m_result.phases.end(), recovery.phases().begin(), recovery.phases().end());
    m_result.levels = recovery.levels();
    m_result.steiner_vertices = recovery.steiner_vertices();
    m_result.number_of_constraint_points = recovery.number_of_constraint_points();
    m_result.number_of_steiner_points = recovery.number_of_steiner_points();
    describe_missing(recovery);
    describe_parts(recovery);
    m_result.unrepresentable_constraints = describe_edges(recovery, recovery.unrepresentable_edges());
    for(const std::size_t f : recovery.unrepresentable_facets())
      m_result.unrepresentable_constraints.push_back(describe_facet(m_input, f));
  }

  void list_facets()
  {
    const std::vector<Vertex_handle>& v = m_result.vertices;
    m_result.facets.reserve(m_input.facets.size());
    for(const auto& f : m_input.facets)
      m_result.facets.push_back({{ v[f[0]], v[f[1]], v[f[2]] }});
  }

  // The parts of constraints with Steiner points on them.
  void describe_parts(const Recovery& recovery)
  {
    const std::vector<std::size_t> edges = recovery.split_edges();
    const std::vector<Simplex> described = describe_edges(recovery, edges);
    for(std::size_t k = 0; k < edges.size(); ++k)
      for(const auto& part : recovery.parts_of_edge(edges[k]))
        m_result.parts_of_edges.push_back({ { part[0], part[1] }, described[k] });
    for(const std::size_t f : recovery.split_facets())
      for(const auto& part : recovery.parts_of_facet(f))
        m_result.parts_of_facets.push_back({ { part[0], part[1], part[2] }, describe_facet(m_input, f) });
  }

  void describe_missing(const Recovery& recovery)
  {
    m_result.missing_edges = describe_edges(recovery, recovery.lost_edges());
    m_result.missing_facets.clear();
    for(const std::size_t f : recovery.lost_facets())
      m_result.missing_facets.push_back(describe_facet(m_input, f));
  }

  // Edges of facets have no index of their own in the input, only vertices.
  std::vector<Simplex> describe_edges(const Recovery& recovery, const std::vector<std::size_t>& edges) const
  {
    std::vector<Simplex> described(edges.size());
    if(edges.empty())
      return described;
    std::vector<std::size_t> position(recovery.constrained_edges().size(), std::size_t(-1));
    for(std::size_t k = 0; k < edges.size(); ++k)
      position[edges[k]] = k;
    for(const auto& f : m_input.facets)
      for(int i = 0; i < 3; ++i)
      {
        const std::array<std::size_t, 2> e = {{ f[i], f[(i + 1) % 3] }};
        const std::size_t k = position[recovery.index(m_result.vertices[e[0]], m_result.vertices[e[1]])];
        if(k != std::size_t(-1) && described[k].dimension < 0)
          described[k] = describe_simplex(m_input, Simplex::no_index, e);
      }
    for(std::size_t k = 0; k < edges.size(); ++k)
      if(edges[k] < m_edges.size())
        described[k] = m_edges[edges[k]];
    return described;
  }

  // Constraints that intersect cannot be in one triangulation; nor can one with a foreign vertex inside. Once stopped,
  // this is left open.
  void judge_missing_constraints(const Recovery& recovery)
  {
    const std::vector<Simplex> missing = missing_constraints(recovery);
    if(! m_options.list_defects && m_context.go_further()) // else there are none
      look_for_intersections(missing);
    if(! is_invalid() && m_context.go_further())
      list_vertices_on(missing);
  }

  // The facets, then the edges.
  std::vector<Simplex> missing_constraints(const Recovery& recovery)
  {
    describe_missing(recovery);
    std::vector<Simplex> missing = m_result.missing_facets;
    missing.insert(missing.end(), m_result.missing_edges.begin(), m_result.missing_edges.end());
    return missing;
  }

  // Work as Recovery_context counts it, see "Tuning constants" in the manual.
  static constexpr std::size_t work_before_examination_per_constraint = 200;
  static constexpr std::size_t number_of_quick_constraints = 100; // which are no reason for an examination
  static constexpr std::size_t number_of_examined_constraints = 16;
  static constexpr std::size_t work_per_box_pair = 200;

  Tr& m_tr;
  const Input& m_input;
  const GT& m_gt;
  const Recovery_options& m_options;
  Recovery_context<Tr> m_context;
  Result m_result;
  Constraint_sample m_sample;
  std::vector<Simplex> m_edges; // the constraints that were given as edges, by their indices in the recovery
};

template <typename Tr, typename GT>
Boundary_recovery_result_3<Tr>
Recover_indexed_boundary<Tr, GT>::operator()(std::vector<Vertex_handle> vertices)
{
  set_defects(simple_defects(m_input, m_gt, m_tr.number_of_vertices() == 0));
  if(! is_invalid() && m_options.list_defects)
    list_intersections();
  if(! is_invalid())
  {
    examine_after_work([this] { return indices_of_all(); });
    m_result.vertices = std::move(vertices);
    if(m_result.vertices.empty())
      find_vertices();
    check_triangulation();
  }
  if(is_invalid())
    return invalid_input();
  if(m_context.is_stopped() && ! is_every_point_known())
    return stopped_early();
  recover();
  return std::move(m_result);
}

#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

extern template Boundary_recovery_result_3<Standard_delaunay>
Recover_indexed_boundary<Standard_delaunay, Standard_kernel>::operator()(
  std::vector<Standard_delaunay::Vertex_handle>);

extern template Boundary_recovery_result_3<Standard_mesh>
Recover_indexed_boundary<Standard_mesh, Standard_kernel>::operator()(
  std::vector<Standard_mesh::Vertex_handle>);

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_RECOVER_INDEXED_BOUNDARY_H
