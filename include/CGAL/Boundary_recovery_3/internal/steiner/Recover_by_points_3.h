// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_BY_POINTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_BY_POINTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_state_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Conforming_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Constraint_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_isolated_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_planar_edges_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Round_steiner_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Split_off_steiner_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_steiner_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The recovery by Steiner points: the main procedure and the postprocessing of [CZZ+17, Section 4].
 *
 * The phases can be run one by one. operator() runs them all as a transaction: if they do not lead to what the mode
 * wants, the mesh is put back, and other points are tried. Where many edges are of no facet, these are recovered one by
 * one before, each as a transaction of its own.
 */
template <typename Tr>
class Recover_by_points_3
{
public:
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef Recovery_state_3<Tr>      State;
  typedef Steiner_ledger_3<Tr>               Ledger;
  typedef Recovery_mode                      Mode;

  // Of the flips that are tried for each part of an edge.
  static constexpr int default_recursion_level = 3;

  // Up to so many edges of no facet, it is quicker to put points on all of them first, and leads to fewer points.
  static constexpr std::size_t max_number_of_edges_at_once = 100;

  // `state` has predicates that know the exact positions of the ledger. Both have to outlive this object.
  Recover_by_points_3(State& state, Ledger& ledger)
    : m_state(state), m_ledger(ledger), m_parts(state.tr, ledger), m_editor(state.tr, state.context.visitor()),
      m_mesh(m_editor, state.predicates, state.constraints, ledger, state.context)
  { }

  const Constraint_parts_3<Tr>& parts() const { return m_parts; }

  // The constraints for which a Steiner point was needed, on them or beside them, that has no position that the
  // triangulation can store, in the last attempt.
  const Lost_constraints& unrepresentable() const { return m_unrepresentable; }

  // Looks up all constraints, which may be unions of simplices.
  void look_up()
  {
    m_state.look_up_all();
    m_parts.take_out_unions(m_state.lost);
  }

  void recount() { m_state.run(Phase::recount, [this] { look_up(); }); }

  // Recovers what is lost, as far as the mode wants it. Returns whether that worked for all constraints; if not, or if
  // the visitor or the kernel throws, the mesh is as it was before. If the mode is `constrained`, and more than
  // `max_number_at_once` edges of no facet are lost, these are recovered one by one.
  bool operator()(const Mode mode, const int max_recursion_level,
                  const std::size_t max_number_at_once = max_number_of_edges_at_once,
                  const Recovery_effort effort = Recovery_effort::more_time);

  // Recovers edges that are tangled in planes. Where too few of them come back for the points that are left beside
  // them, or in the mode `flips_only` a point is left, what was done there is taken back.
  void recover_planar_edges(const Mode mode)
  {
    Recover_planar_edges_3<Tr> recover(m_mesh);
    const auto groups = recover.find(m_state.lost.edges);
    if(groups.empty())
      return;
    m_state.run(Phase::planar_edge_recovery, [&]
    {
      for(const auto& edges : groups)
        transact([&] { return recover(edges) && (mode != Mode::flips_only || m_ledger.free_points().empty()); });
      m_state.look_up_lost();
    });
    m_state.number_of_transformations += recover.number_of_transformations();
  }

  // The first half of the main procedure: lost edges become chains of mesh edges, then lost facets unions of mesh
  // facets.
  void recover_conforming(const int l_max)
  {
    recover_conforming(l_max, [] { });
  }

  // In the mode `conforming`, the points stay on the constraints. Returns whether all have positions that the
  // triangulation can store.
  bool round_points()
  {
    Round_steiner_point_3<Tr> round(m_state.tr, m_state.predicates, m_ledger.positions());
    bool is_done = true;
    for(const Vertex_handle v : m_ledger.points_on_constraints())
      if(! round(v, is_done && m_state.context.go_further()))
      {
        is_done = false;
        add_unrepresentable(m_ledger.carrier(v));
      }
    return is_done && m_ledger.positions().empty();
  }

  // The second half of the main procedure [CZZ+17, Alg. A.1 to A.5]: points come off the constraints. Returns whether
  // none is left there.
  bool split_points()
  {
    Split_off_steiner_point_3<Tr> split(m_mesh);
    m_state.run(Phase::steiner_splitting, [&]
    {
      for(std::size_t before = 0; before != m_ledger.points_on_constraints().size(); )
      {
        const std::vector<Vertex_handle> points = m_ledger.points_on_constraints();
        before = points.size();
        for(std::size_t i = 0; i < before && m_state.context.go_further(); ++i)
        {
          split(points[i]);
          m_state.context.visitor().on_progress(Phase::steiner_splitting, i + 1, before);
        }
      }
    });
    m_state.number_of_transformations += split.number_of_transformations();
    for(const Vertex_handle v : m_ledger.points_on_constraints())
      add_unrepresentable(m_ledger.carrier(v));
    return m_ledger.points_on_constraints().empty();
  }

  // The postprocessing [CZZ+17, Section 4.3]: free points are removed, as far as possible. Returns whether the others
  // have positions that the triangulation can store.
  bool suppress_points(const int max_recursion_level, const Recovery_effort effort)
  {
    CGAL_precondition(m_ledger.points_on_constraints().empty());
    Suppress_steiner_points_3<Tr> suppress(m_mesh);
    m_state.run(Phase::steiner_suppression, [&] { suppress(max_recursion_level, effort); });
    const bool is_storable = suppress.round_points(max_recursion_level); // also if the recovery was stopped before
    m_state.number_of_transformations += suppress.number_of_transformations();
    for(const Vertex_handle v : m_ledger.free_points())
      if(m_ledger.positions().contains(v))
        add_unrepresentable(m_ledger.origin(v));
    return is_storable;
  }

private:
  typedef typename Ledger::Carrier Carrier;

  // With more lost edges, the chance that no point is left is too small for the time that it takes.
  static constexpr std::size_t max_number_of_edges_for_temporary_points = 20;

  // Where one level leads to Steiner points that do not do, another may lead to some that do.
  static constexpr int recursion_levels[] = { default_recursion_level, 6, 1, 0, 2, 12 };

  // See "Tuning constants" in the manual.
  static constexpr std::size_t least_number_to_thin_out = 170;

  // Steiner points for all that is lost, with several recursion levels of the flips in between.
  void try_points(const Mode mode, const int max_recursion_level, const Recovery_effort effort,
                  std::size_t max_number_at_once)
  {
    for(const int l_max : recursion_levels)
    {
      if(l_max > max_recursion_level)
        continue;
      m_unrepresentable = Lost_constraints();
      bool is_conforming = false;
      const bool is_done = transact([&]
      {
        recover_conforming(l_max, [&]
        {
          if(mode == Mode::constrained)
            recover_isolated_edges(max_recursion_level, max_number_at_once);
        });
        is_conforming = m_state.is_nothing_lost();
        if(! is_conforming || ! finish_points(mode, max_recursion_level, effort))
          return false;
        recount(); // the visitor may still throw
        return true;
      });
      if(is_done)
        return;
      recount();
      if(! is_conforming || ! m_state.context.go_further())
        return;
      max_number_at_once = 0; // it did not do to put points on all of them first
    }
  }

  // As above; `begin` may recover edges in another way.
  template <typename Begin>
  void recover_conforming(const int l_max, const Begin& begin)
  {
    Conforming_recovery_3<Tr> conform(m_mesh);
    m_state.run(Phase::conforming_edge_recovery, [&]
    {
      begin();
      take_out_recovered(Phase::conforming_edge_recovery, m_state.lost.edges, [&](const std::size_t e)
      {
        return conform.recover_edge(e, l_max);
      });
    });
    if(m_state.lost.edges.empty())
      m_state.run(Phase::conforming_facet_recovery, [&]
      {
        take_out_recovered(Phase::conforming_facet_recovery, m_state.lost.facets, [&](const std::size_t f)
        {
          return conform.recover_facet(f, l_max);
        });
      });
    m_state.number_of_transformations += conform.number_of_transformations();
  }

  // Recovers lost edges of no facet one by one, if they are more than that. Those that this fails for wait until all
  // others are done, and points that can go are gone: the mesh is another one then.
  void recover_isolated_edges(const int max_recursion_level, const std::size_t max_number_at_once)
  {
    std::vector<std::size_t> others, isolated;
    const std::vector<bool> is_of_facet = edges_of_facets();
    for(const std::size_t e : m_state.lost.edges)
      (is_of_facet[e] ? others : isolated).push_back(e);
    if(isolated.size() <= max_number_at_once)
      return;
    recover_one_by_one(isolated, max_recursion_level, 0);
    for(const int number_of_rounds : { 0, Suppress_steiner_points_3<Tr>::max_number_of_rounds })
      for(std::size_t before = 0; ! isolated.empty() && before != isolated.size(); )
      {
        before = isolated.size();
        remove_points_between([&](auto& recover) { recover.make_room(max_recursion_level); });
        recover_one_by_one(isolated, max_recursion_level, number_of_rounds);
      }
    m_state.lost.edges.clear();
    std::merge(others.begin(), others.end(), isolated.begin(), isolated.end(), std::back_inserter(m_state.lost.edges));
  }

  // Takes those out for which it worked. The more points there are, the harder are the edges that follow: each time
  // that they have become half as many again, some go.
  void recover_one_by_one(std::vector<std::size_t>& isolated, const int max_recursion_level, const int number_of_rounds)
  {
    const auto& points = m_ledger.free_points();
    std::size_t last_number = (std::max)(points.size(), least_number_to_thin_out);
    take_out_recovered(Phase::conforming_edge_recovery, isolated, [&](const std::size_t e)
    {
      if(! recover_isolated_edge(e, max_recursion_level, number_of_rounds))
        return false;
      if(2 * points.size() > 3 * last_number)
      {
        remove_points_between([&](auto& recover) { recover.thin_out(max_recursion_level); });
        last_number = points.size();
      }
      return true;
    });
  }

  // Points of edges that are recovered, in the way of those that are not.
  template <typename Work>
  void remove_points_between(const Work& work)
  {
    Recover_isolated_edge_3<Tr> recover(m_mesh);
    work(recover);
    m_state.number_of_transformations += recover.number_of_transformations();
  }

  // By number, which edges are edges of constrained facets.
  std::vector<bool> edges_of_facets() const
  {
    std::vector<bool> result(m_state.constraints.edges().size());
    for(std::size_t f = 0; f < m_state.constraints.facets().size(); ++f)
      for(const std::size_t e : m_state.constraints.edges_of_facet(f))
        result[e] = true;
    return result;
  }

  // Tries all levels; if points have no number then, they make room in so many rounds. If that fails, the mesh is as it
  // was before.
  bool recover_isolated_edge(const std::size_t e, const int max_recursion_level, const int number_of_rounds)
  {
    return std::any_of(std::begin(recursion_levels), std::end(recursion_levels), [&](const int l_max)
    {
      return l_max <= max_recursion_level && m_state.context.go_further() && transact([&]
      {
        Recover_isolated_edge_3<Tr> recover(m_mesh);
        const bool is_done = recover(e, l_max, max_recursion_level, number_of_rounds);
        m_state.number_of_transformations += recover.number_of_transformations();
        return is_done;
      });
    });
  }

  // Makes of the points on constraints what the mode wants. Returns whether this was possible.
  bool finish_points(const Mode mode, const int max_recursion_level, const Recovery_effort effort)
  {
    if(mode == Mode::conforming)
      return round_points();
    return split_points() && suppress_points(max_recursion_level, effort)
        && (mode == Mode::constrained || m_ledger.free_points().empty());
  }

  // Does some work, which returns whether it led to what it should. If not, or if something throws, the mesh and the
  // ledger are as they were before. Returns whether it did. Transactions may be nested.
  template <typename Work>
  bool transact(const Work& work)
  {
    m_ledger.settle();
    const std::size_t depth = m_editor.journal().depth();
    bool is_done = false;
    try {
      m_editor.begin();
      is_done = work();
      if(is_done)
        m_editor.commit();
      else
        take_back(depth, m_state.context.visitor());
    } catch(...) {
      // Cells may be inverted now. Whoever threw, maybe the visitor, is not called again.
      Mesh_visitor_3<Tr> no_visitor;
      take_back(depth, no_visitor);
      m_ledger.unsettle();
      throw;
    }
    m_ledger.unsettle();
    return is_done;
  }

  // Ends the transaction that began at that depth, if this is not done yet.
  void take_back(const std::size_t depth, Mesh_visitor_3<Tr>& visitor)
  {
    if(m_editor.journal().depth() == depth)
      return;
    m_ledger.take_back(m_editor.journal().change().new_vertices());
    m_editor.undo(visitor);
  }

  // Does something with each of the lost constraints, and keeps those in the list for which it failed.
  template <typename Work>
  void take_out_recovered(const Phase phase, std::vector<std::size_t>& lost, const Work& work)
  {
    const std::size_t total = lost.size();
    std::size_t kept = 0, done = 0;
    for(const std::size_t s : lost)
    {
      if(! m_state.context.go_further() || ! work(s))
        lost[kept++] = s;
      m_state.context.visitor().on_progress(phase, ++done, total);
    }
    lost.resize(kept);
  }

  // The constraint that a point is or was on gets into the account, unless there was no time to look for a position.
  void add_unrepresentable(const Carrier& carrier)
  {
    if(m_state.context.is_stopped())
      return;
    std::vector<std::size_t>& indices = carrier.dimension == 1 ? m_unrepresentable.edges : m_unrepresentable.facets;
    const auto it = std::lower_bound(indices.begin(), indices.end(), carrier.index);
    if(it == indices.end() || *it != carrier.index)
      indices.insert(it, carrier.index);
  }

  State& m_state;
  Ledger& m_ledger;
  Constraint_parts_3<Tr> m_parts;
  Mesh_editor_3<Tr> m_editor;
  Steiner_mesh_3<Tr> m_mesh;
  Lost_constraints m_unrepresentable;
};

template <typename Tr>
bool Recover_by_points_3<Tr>::operator()(const Mode mode, const int max_recursion_level,
                                         const std::size_t max_number_at_once, const Recovery_effort effort)
{
  CGAL_precondition(m_ledger.points_on_constraints().empty());
  if(m_state.is_nothing_lost())
    return true;
  if((mode == Mode::flips_only && m_state.lost.edges.size() > max_number_of_edges_for_temporary_points)
     || ! m_state.context.go_further())
    return false;
  try {
    try_points(mode, max_recursion_level, effort, max_number_at_once);
  } catch(...) {
    look_up();
    throw;
  }
  if(mode == Mode::flips_only || m_state.context.is_stopped())
    m_unrepresentable = Lost_constraints(); // points are not wanted, or the last attempt was not finished
  return m_state.is_nothing_lost();
}

#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

extern template bool
Recover_by_points_3<Standard_delaunay>::operator()(Recovery_mode, int, std::size_t, Recovery_effort);

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_BY_POINTS_3_H
