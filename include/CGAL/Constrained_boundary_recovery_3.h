// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_CONSTRAINED_BOUNDARY_RECOVERY_3_H
#define CGAL_CONSTRAINED_BOUNDARY_RECOVERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_recovery_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Cavity_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recursive_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_snapshot_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Conforming_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Constraint_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_rounding_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_splitting_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_suppression_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief recovers constrained edges and facets in a triangulation, by recursive shell transformations first, and by
 * Steiner points where these are not enough.
 *
 * It holds the constraints and runs the phases of [CZZ+17, Section 4]; each phase can be called on its own.
 * Constraints that are in the triangulation are never destroyed.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`, or of a class derived from it, with a model of
 *         `BoundaryRecoveryTraits_3` as geometric traits
 * \tparam Visitor a model of `BoundaryRecoveryVisitor_3`
 *
 * \sa `CGAL::recover_boundary()`
 */
template <typename Tr, typename Visitor_ = Default_boundary_recovery_visitor_3>
class Constrained_boundary_recovery_3
{
public:
  typedef Tr       Triangulation;                         ///< the triangulation type
  typedef Visitor_ Visitor;                               ///< the visitor type
  typedef typename Tr::Vertex_handle Vertex_handle;       ///< the vertex handle of the triangulation
  typedef Boundary_recovery_3::Recovery_phase Phase;      ///< the phases
  typedef Boundary_recovery_3::Recovery_mode Mode;        ///< the modes
  typedef Boundary_recovery_3::Phase_report Phase_report; ///< the counts of a phase
  typedef Boundary_recovery_3::Recursion_level_report Recursion_level_report; ///< the counts of a pass

  /// the maximal recursion level if none is set.
  static constexpr int default_max_recursion_level = 30;

  /// the maximal recursion level of the flips while Steiner points are put on constraints.
  static constexpr int default_conforming_recursion_level = 3;

  /*!
   * \param tr the triangulation to change. As long as this object is used, it must not be cleared, assigned to or
   *        swapped, and vertices of constraints must not be removed.
   * \param visitor is told about progress and may stop the recovery. It has to outlive this object.
   *
   * \pre `tr.dimension() == 3`
   */
  Constrained_boundary_recovery_3(Tr& tr, Visitor& visitor)
    : m_tr(tr), m_steiner_points(m_constraints), m_parts(tr, m_steiner_points),
      m_predicates(tr, &m_steiner_points.positions()), m_context(visitor), m_search(tr, m_constraints),
      m_edge_recovery(tr, m_predicates, m_constraints, m_context, m_lost.edges, m_levels),
      m_facet_recovery(tr, m_predicates, m_constraints, m_context, m_treatable_facets, m_levels)
  {
    CGAL_precondition(tr.dimension() == 3);
  }

  /// as above, with a visitor that does nothing.
  explicit Constrained_boundary_recovery_3(Tr& tr) : Constrained_boundary_recovery_3(tr, m_no_visitor) { }

  Constrained_boundary_recovery_3(const Constrained_boundary_recovery_3&) = delete;
  Constrained_boundary_recovery_3& operator=(const Constrained_boundary_recovery_3&) = delete;

  /// \name Constraints
  /// @{

  /// allocates memory for so many constrained edges, those of the facets not counted, and facets.
  void reserve(const std::size_t number_of_edges, const std::size_t number_of_facets)
  {
    m_constraints.reserve(number_of_edges, number_of_facets);
  }

  /// adds the constrained edge `uv`, unless it is there already, and returns its index.
  ///
  /// \pre `u` and `v` are different finite vertices of the triangulation.
  std::size_t insert_constraint(const Vertex_handle u, const Vertex_handle v)
  {
    CGAL_precondition(u != v);
    return m_constraints.insert(u, v);
  }

  /// adds the constrained facet `uvw` and its edges, unless they are there already, and returns the index of the facet.
  ///
  /// \pre `u`, `v` and `w` are different finite vertices of the triangulation and not collinear.
  std::size_t insert_constraint(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    CGAL_precondition(u != v && v != w && w != u);
    return m_constraints.insert(u, v, w);
  }

  /// returns the constrained edges by their indices, a range of arrays of two vertex handles.
  const std::vector<std::array<Vertex_handle, 2> >& constrained_edges() const { return m_constraints.edges(); }

  /// returns the constrained facets by their indices, a range of arrays of three vertex handles.
  const std::vector<std::array<Vertex_handle, 3> >& constrained_facets() const { return m_constraints.facets(); }

  /// returns the index of the constrained edge `uv`, or `std::size_t(-1)`.
  std::size_t index(const Vertex_handle u, const Vertex_handle v) const { return m_constraints.index(u, v); }

  /// returns the indices of the edges that were lost when last looked for, in increasing order.
  const std::vector<std::size_t>& lost_edges() const { return m_lost.edges; }

  /// returns the indices of the facets that were lost when last looked for, in increasing order.
  const std::vector<std::size_t>& lost_facets() const { return m_lost.facets; }

  /// returns the indices of the edges with Steiner points on them, in increasing order.
  std::vector<std::size_t> split_edges() const { return m_steiner_points.split_edges(); }

  /// returns the indices of the facets with Steiner points on them or on their edges, in increasing order.
  std::vector<std::size_t> split_facets() const { return m_steiner_points.split_facets(); }

  /// returns the mesh edges that the edge `e` consists of, from its first vertex to its second; none if it is not a
  /// union of mesh edges.
  ///
  /// \pre `e < constrained_edges().size()`
  std::vector<std::array<Vertex_handle, 2> > parts_of_edge(const std::size_t e) const { return m_parts.of_edge(e); }

  /// returns the mesh facets that the facet `f` consists of, in its orientation; none if it is not a union of mesh
  /// facets.
  ///
  /// \pre `f < constrained_facets().size()`
  std::vector<std::array<Vertex_handle, 3> > parts_of_facet(const std::size_t f) const { return m_parts.of_facet(f); }
  /// @}

  /// \name Settings
  /// @{

  /// sets the maximal recursion level; 30 by default.
  ///
  /// \pre `l_max >= 0`
  void set_max_recursion_level(const int l_max)
  {
    CGAL_precondition(l_max >= 0);
    m_max_recursion_level = l_max;
  }

  /// sets the time after which the recovery stops, in seconds from the construction of this object; no limit by
  /// default.
  void set_maximum_running_time(const double seconds) { m_context.set_maximum_running_time(seconds); }
  /// @}

  /// \name Phases
  /// Each may be called on its own, after `search()`. Those without points must not be called while there are Steiner
  /// points on constraints.
  /// @{

  /// runs all the phases of a mode. Returns whether every constraint is in the triangulation: as one simplex, or, in
  /// the mode `conforming`, as a union of simplices.
  ///
  /// \param mode how far the recovery goes
  ///
  /// \pre the constraints do not intersect, and no other vertex is on them.
  bool operator()(const Mode mode = Mode::constrained)
  {
    return recover_by_flips() || recover_by_points(mode);
  }

  /// runs the phases that add no points. Returns whether every constraint is in the triangulation.
  bool recover_by_flips()
  {
    search();
    if(is_nothing_lost())
      return true; // nothing is going to change, so there is nothing to recount
    remove_plainly();
    recover_edges_brc1();
    recover_edges_brc3();
    reconnect_edges();
    recover_facets_brc2();
    recover_facets_brc4();
    reconnect_facets();
    recount();
    return is_nothing_lost();
  }

  /// looks up every constraint.
  void search() { run(Phase::search, [&] { look_up(); }); }

  /// removes what crosses lost edges by complete removals of single shells: the cases that need neither
  /// quality nor recursion.
  void remove_plainly()
  {
    if(m_lost.edges.empty())
      return;
    run_flips(Phase::plain_removal, [&]
    {
      m_number_of_transformations += m_edge_recovery.remove_plainly(Phase::plain_removal);
    });
  }

  /// is the first calling of [CZZ+17, Alg. 5]: under BRC1, with the vector [Q', Q'', Q_1].
  void recover_edges_brc1()
  {
    if(m_lost.edges.empty())
      return;
    run_flips(Phase::edge_recovery_brc1, [&]
    {
      m_number_of_transformations += m_edge_recovery.first_calling(Phase::edge_recovery_brc1, m_max_recursion_level);
    });
  }

  /// is the second calling of [CZZ+17, Alg. 5]: under BRC3, with the vector [Q_2, Q', Q''].
  void recover_edges_brc3()
  {
    if(m_lost.edges.empty())
      return;
    run_flips(Phase::edge_recovery_brc3, [&]
    {
      m_number_of_transformations += m_edge_recovery.second_calling(Phase::edge_recovery_brc3, m_max_recursion_level);
    });
  }

  /// tries small polyhedron reconnection on the cells around each lost edge, as long as this helps.
  void reconnect_edges()
  {
    if(m_lost.edges.empty())
      return;
    run_flips(Phase::edge_reconnection, [&]
    {
      reconnect(Phase::edge_reconnection, m_lost.edges, m_constraints.edges());
    });
  }

  /// tries small polyhedron reconnection on the cells around each lost facet that has its edges, as long as this helps.
  void reconnect_facets()
  {
    find_treatable_facets();
    if(m_treatable_facets.empty())
      return;
    run_flips(Phase::facet_reconnection, [&]
    {
      reconnect(Phase::facet_reconnection, m_treatable_facets, m_constraints.facets());
    });
  }

  /// is the first calling for facets [CZZ+17, Section 4.2.2]: under BRC2.
  /// Facets are treated if their edges are in the triangulation.
  void recover_facets_brc2()
  {
    find_treatable_facets();
    if(m_treatable_facets.empty())
      return;
    run_flips(Phase::facet_recovery_brc2, [&]
    {
      m_number_of_transformations += m_facet_recovery.first_calling(Phase::facet_recovery_brc2, m_max_recursion_level);
    });
  }

  /// is the second calling for facets [CZZ+17, Section 4.2.2]: under BRC4.
  void recover_facets_brc4()
  {
    find_treatable_facets();
    if(m_treatable_facets.empty())
      return;
    run_flips(Phase::facet_recovery_brc4, [&]
    {
      m_number_of_transformations += m_facet_recovery.second_calling(Phase::facet_recovery_brc4, m_max_recursion_level);
    });
  }

  /// recovers what is lost by Steiner points: the main procedure and the postprocessing of [CZZ+17, Section 4]. In the
  /// mode `constrained`, they are taken off the constraints again, and as many of them as possible are removed; in the
  /// mode `conforming`, they stay there and get the nearest positions that the triangulation can store. In the mode
  /// `flips_only`, they are tried for a few lost edges, and accepted only if all of them could be removed. If some
  /// position cannot be stored, or points are left that must not be, the triangulation is put back and other points are
  /// tried, up to six times in all. Steiner points that were there before stay. Returns whether this worked for all
  /// constraints; if not, the triangulation is as it was before, also if the visitor or the kernel throws.
  ///
  /// \pre the constraints do not intersect, no other vertex is on them, and no Steiner point is on a constraint.
  bool recover_by_points(const Mode mode)
  {
    CGAL_precondition(m_steiner_points.vertices().empty());
    if(is_nothing_lost())
      return true;
    if(mode == Mode::flips_only && m_lost.edges.size() > max_number_of_edges_for_temporary_points)
      return false;
    if(! m_context.go_further())
      return false;
    Earlier_state earlier{ Snapshot(m_tr), {}, m_number_of_constraint_points, m_number_of_steiner_points };
    earlier.points.swap(m_free_steiner_vertices);
    try {
      try_points(mode, earlier);
    } catch(...) {
      // Cells may be inverted now, or missing. Whoever threw, maybe the visitor, is not called again.
      Default_boundary_recovery_visitor_3 no_visitor;
      take_back(earlier, no_visitor);
      look_up();
      m_free_steiner_vertices.swap(earlier.points);
      throw;
    }
    m_free_steiner_vertices.insert(m_free_steiner_vertices.begin(), earlier.points.begin(), earlier.points.end());
    if(mode == Mode::flips_only || m_context.is_stopped())
      m_unrepresentable = Lost_constraints(); // points are not wanted, or the last attempt was not finished
    return is_nothing_lost();
  }

  /// is the first half of the main procedure of [CZZ+17, Section 4]: lost edges become chains of mesh edges, lost
  /// facets unions of mesh facets, by Steiner points on them.
  ///
  /// Until `round_steiner_points()`, or `split_steiner_points()` and `suppress_steiner_points()`, returned `true`,
  /// exact positions of Steiner points are known to this object only, and cells may be inverted by the rounded
  /// positions in the triangulation.
  ///
  /// \param l_max the maximal recursion level of the flips that are tried for each part of an edge, not negative
  ///
  /// \pre lost constraints were looked for after the last change of the triangulation.
  void recover_conforming(const int l_max = default_conforming_recursion_level)
  {
    const std::size_t before = m_steiner_points.vertices().size();
    Boundary_recovery_3::internal::Conforming_recovery_3<Tr, Visitor>
      conform(m_tr, m_predicates, m_constraints, m_steiner_points, m_context.visitor());
    run(Phase::conforming_edge_recovery, [&]
    {
      remove_done(Phase::conforming_edge_recovery, m_lost.edges,
                  [&](const std::size_t e) { return conform.recover_edge(e, l_max, m_context); });
    });
    if(m_lost.edges.empty())
      run(Phase::conforming_facet_recovery, [&]
      {
        remove_done(Phase::conforming_facet_recovery, m_lost.facets, [&](const std::size_t f)
        {
          return conform.recover_facet(f, l_max, m_context);
        });
      });
    m_number_of_constraint_points += m_steiner_points.vertices().size() - before;
    m_number_of_transformations += conform.number_of_transformations();
  }

  /// gives each Steiner point on a constraint the nearest position that the triangulation can store, or one that is at
  /// most 2^10 times as far away as numbers are from each other at its largest coordinate, such that all the cells
  /// around it remain positively oriented. Returns whether this is so for all of them, and no point that came off a
  /// constraint is without such a position.
  bool round_steiner_points()
  {
    Boundary_recovery_3::internal::Steiner_rounding_3<Tr> round(m_tr, m_predicates, m_steiner_points.positions());
    bool is_done = true;
    for(const Vertex_handle v : m_steiner_points.vertices())
      if(! round(v, is_done && m_context.go_further()))
      {
        is_done = false;
        add_unrepresentable(m_steiner_points.carrier(v));
      }
    return is_done && m_steiner_points.positions().empty();
  }

  /// is the second half of the main procedure [CZZ+17, Alg. A.1 to A.5]: takes the Steiner points off the constraints.
  /// Returns whether none is left there.
  ///
  /// \pre all constraints are unions of mesh simplices.
  bool split_steiner_points()
  {
    Boundary_recovery_3::internal::Steiner_splitting_3<Tr, Visitor>
      split(m_tr, m_predicates, m_constraints, m_steiner_points, m_context.visitor());
    run(Phase::steiner_splitting, [&]
    {
      for(std::size_t before = 0; before != m_steiner_points.vertices().size(); )
      {
        before = m_steiner_points.vertices().size();
        const std::vector<Vertex_handle> vertices = m_steiner_points.vertices();
        std::size_t done = 0;
        for(const Vertex_handle v : vertices)
        {
          if(! m_context.go_further())
            break;
          const Carrier carrier = m_steiner_points.carrier(v);
          const std::size_t first = split.points().size();
          split(v);
          for(std::size_t i = first; i < split.points().size(); ++i)
            m_origins[&*split.points()[i]] = carrier;
          m_context.visitor().on_progress(Phase::steiner_splitting, ++done, before);
        }
      }
    });
    m_free_steiner_vertices.insert(m_free_steiner_vertices.end(), split.points().begin(), split.points().end());
    m_number_of_steiner_points += split.points().size();
    for(const Vertex_handle v : m_steiner_points.vertices())
      add_unrepresentable(m_steiner_points.carrier(v));
    return m_steiner_points.vertices().empty();
  }

  /// is the postprocessing of [CZZ+17, Section 4.3]: removes Steiner points that are on no constraint, as long as it
  /// can. Returns whether the others have positions that the triangulation can store.
  ///
  /// \pre no Steiner point is on a constraint
  bool suppress_steiner_points()
  {
    CGAL_precondition(m_steiner_points.vertices().empty());
    Boundary_recovery_3::internal::Steiner_suppression_3<Tr, Visitor>
      suppress(m_tr, m_predicates, m_constraints, m_steiner_points.positions(), m_free_steiner_vertices,
               m_context.visitor());
    run(Phase::steiner_suppression, [&] { suppress(m_max_recursion_level, m_context); });
    const bool is_storable = suppress.round_points(m_context); // also if the recovery was stopped before
    m_number_of_transformations += suppress.number_of_transformations();
    for(const Vertex_handle v : m_free_steiner_vertices)
      if(m_steiner_points.positions().contains(v))
        add_unrepresentable(m_origins.find(&*v)->second);
    return is_storable;
  }

  /// looks up every constraint again: only this tells what was recovered.
  void recount() { run(Phase::recount, [&] { look_up(); }); }
  /// @}

  /// \name Account
  /// @{

  /// returns whether the visitor or the time limit ended the recovery.
  bool is_stopped() const { return m_context.is_stopped(); }

  /// returns the counts of each phase that ran.
  const std::vector<Phase_report>& phases() const { return m_phases; }

  /// returns the counts of each pass, the rows of the tables of [CZZ+17, Section 5.1.2].
  const std::vector<Recursion_level_report>& levels() const { return m_levels; }

  /// returns the Steiner points that are in the triangulation: those on constraints, then the others, both in the order
  /// in which they were created.
  std::vector<Vertex_handle> steiner_vertices() const
  {
    std::vector<Vertex_handle> result = m_steiner_points.vertices();
    result.insert(result.end(), m_free_steiner_vertices.begin(), m_free_steiner_vertices.end());
    return result;
  }

  /// returns the indices of the edges for which a Steiner point was needed, on them or beside them, for which the
  /// triangulation can store no position, in increasing order. They are those of the last attempt, if
  /// `recover_by_points()` failed.
  const std::vector<std::size_t>& unrepresentable_edges() const { return m_unrepresentable.edges; }

  /// as above, the facets.
  const std::vector<std::size_t>& unrepresentable_facets() const { return m_unrepresentable.facets; }

  /// returns the number of Steiner points that were put on constraints.
  std::size_t number_of_constraint_points() const { return m_number_of_constraint_points; }

  /// returns the number of Steiner points that came off the constraints, before any of them was removed.
  std::size_t number_of_steiner_points() const { return m_number_of_steiner_points; }

  /// returns the number of replacements of cells by flips and reconnections, those that were taken back included.
  std::size_t number_of_transformations() const { return m_number_of_transformations; }
  /// @}

private:
  typedef Boundary_recovery_3::internal::Constraints_3<Tr>    Constraints;
  typedef Boundary_recovery_3::internal::Lost_constraints     Lost_constraints;
  typedef Boundary_recovery_3::internal::Mesh_snapshot_3<Tr>  Snapshot;
  typedef typename Boundary_recovery_3::internal::Steiner_points_3<Tr>::Carrier Carrier;

  // What there was before Steiner points were tried.
  struct Earlier_state
  {
    Snapshot snapshot;
    std::vector<Vertex_handle> points; // the Steiner points of earlier recoveries
    std::size_t number_of_constraint_points;
    std::size_t number_of_steiner_points;
  };

  // With more lost edges, the chance that no point is left is too small for the time that it takes.
  static constexpr std::size_t max_number_of_edges_for_temporary_points = 20;

  // Where one level leads to Steiner points that do not do, another may lead to some that do.
  static constexpr int conforming_recursion_levels[] = { default_conforming_recursion_level, 6, 1, 0, 2, 12 };

  bool is_nothing_lost() const { return m_lost.edges.empty() && m_lost.facets.empty(); }

  // Makes of the Steiner points on constraints what the mode wants. Returns whether this was possible.
  bool finish_points(const Mode mode)
  {
    if(mode == Mode::conforming)
      return round_steiner_points();
    return split_steiner_points() && suppress_steiner_points()
        && (mode == Mode::constrained || m_free_steiner_vertices.empty());
  }

  // Does something with each item of a list, and keeps those for which it failed.
  template <typename Item, typename Work>
  void remove_done(const Phase phase, std::vector<Item>& items, const Work& work)
  {
    const std::size_t total = items.size();
    std::size_t kept = 0, done = 0;
    for(const Item item : items)
    {
      if(! m_context.go_further() || ! work(item))
        items[kept++] = item;
      m_context.visitor().on_progress(phase, ++done, total);
    }
    items.resize(kept);
  }

  // Steiner points for all that is lost, with several recursion levels of the flips in between.
  void try_points(const Mode mode, const Earlier_state& earlier)
  {
    for(const int l_max : conforming_recursion_levels)
    {
      if(l_max > m_max_recursion_level)
        continue;
      m_unrepresentable = Lost_constraints();
      recover_conforming(l_max);
      const bool is_conforming = is_nothing_lost();
      const bool is_done = is_conforming && finish_points(mode);
      if(! is_done)
        take_back(earlier, m_context.visitor());
      recount();
      if(is_done || ! is_conforming || ! m_context.go_further())
        return;
    }
  }

  // The free Steiner points are new ones here. There may be others that are not in the lists yet.
  template <typename Any_visitor>
  void take_back(const Earlier_state& earlier, Any_visitor& visitor)
  {
    for(const Vertex_handle v : std::vector<Vertex_handle>(m_steiner_points.vertices()))
      m_steiner_points.erase(v);
    const std::vector<Vertex_handle> new_vertices = earlier.snapshot.new_vertices(m_tr);
    for(const Vertex_handle v : new_vertices)
      m_steiner_points.positions().erase(v);
    m_free_steiner_vertices.clear();
    m_number_of_constraint_points = earlier.number_of_constraint_points;
    m_number_of_steiner_points = earlier.number_of_steiner_points;
    earlier.snapshot.restore(m_tr, new_vertices, visitor);
  }

  // The constraint that a Steiner point is or was on gets into the account, unless there was no time to look for a
  // position.
  void add_unrepresentable(const Carrier& carrier)
  {
    if(m_context.is_stopped())
      return;
    std::vector<std::size_t>& indices = carrier.dimension == 1 ? m_unrepresentable.edges : m_unrepresentable.facets;
    const auto it = std::lower_bound(indices.begin(), indices.end(), carrier.index);
    if(it == indices.end() || *it != carrier.index)
      indices.insert(it, carrier.index);
  }

  // A phase that adds no points: what it recovered is looked up at its end.
  template <typename Work>
  void run_flips(const Phase phase, const Work& work)
  {
    CGAL_precondition(m_steiner_points.vertices().empty()); // what flips keep are the constraints, not their parts
    run(phase, [&] { work(); look_up_lost(); });
  }

  template <typename Work>
  void run(const Phase phase, const Work& work)
  {
    if(phase != Phase::recount && phase != Phase::search && ! m_context.go_further())
      return;
    const double start = m_context.seconds();
    m_context.visitor().on_phase_begin(phase);
    work();
    Phase_report report;
    report.phase = phase;
    report.lost_edges = m_lost.edges.size();
    report.lost_facets = m_lost.facets.size();
    report.seconds = m_context.seconds() - start;
    m_phases.push_back(report);
    m_context.visitor().on_phase_end(report);
  }

  // In the mode `conforming`, constraints may be unions of simplices.
  void look_up()
  {
    m_lost = m_search();
    if(m_steiner_points.vertices().empty())
      return;
    const auto is_edge_covered = [this](const std::size_t e) { return ! parts_of_edge(e).empty(); };
    const auto is_facet_covered = [this](const std::size_t f) { return ! parts_of_facet(f).empty(); };
    m_lost.edges.erase(std::remove_if(m_lost.edges.begin(), m_lost.edges.end(), is_edge_covered), m_lost.edges.end());
    m_lost.facets.erase(std::remove_if(m_lost.facets.begin(), m_lost.facets.end(), is_facet_covered),
                        m_lost.facets.end());
  }

  // What is in the mesh stays there, so only what was lost has to be looked up.
  void look_up_lost() { m_lost = m_search(m_lost); }

  // One success may clear the way for another constraint, so passes are repeated while they help. What failed is not
  // tried again in the same mesh.
  template <typename Simplex>
  void reconnect(const Phase phase, std::vector<std::size_t>& lost, const std::vector<Simplex>& simplices)
  {
    Boundary_recovery_3::internal::Cavity_recovery_3<Tr, Visitor>
      recover(m_tr, m_predicates, m_constraints, m_context.visitor());
    std::vector<std::size_t> hopeless_since(lost.size(), std::size_t(-1)); // numbers of replacements, or -1
    for(std::size_t before = 0; before != lost.size() && ! lost.empty(); )
    {
      before = lost.size();
      std::size_t kept = 0;
      for(std::size_t i = 0; i < before; ++i)
      {
        const std::size_t s = lost[i];
        const bool is_hopeless = hopeless_since[i] == recover.number_of_replacements();
        if(is_hopeless || ! m_context.go_further() || ! recover(simplices[s]))
        {
          hopeless_since[kept] = recover.number_of_replacements();
          lost[kept++] = s;
        }
        m_context.visitor().on_progress(phase, i + 1, before);
      }
      lost.resize(kept);
    }
    m_number_of_transformations += recover.number_of_replacements();
  }

  bool is_lost(const Vertex_handle u, const Vertex_handle v) const
  {
    return std::binary_search(m_lost.edges.begin(), m_lost.edges.end(), m_constraints.index(u, v));
  }

  // Facets can be treated once their edges are in the mesh.
  void find_treatable_facets()
  {
    m_treatable_facets.clear();
    for(const std::size_t f : m_lost.facets)
    {
      const std::array<Vertex_handle, 3>& facet = m_constraints.facets()[f];
      if(! is_lost(facet[0], facet[1]) && ! is_lost(facet[1], facet[2]) && ! is_lost(facet[2], facet[0]))
        m_treatable_facets.push_back(f);
    }
  }

  Tr& m_tr;
  // what the constructor without a visitor points to; other visitors need not be default constructible
  Default_boundary_recovery_visitor_3 m_no_visitor;
  Constraints m_constraints;
  Boundary_recovery_3::internal::Steiner_points_3<Tr> m_steiner_points; // those on constraints
  Boundary_recovery_3::internal::Constraint_parts_3<Tr> m_parts;
  std::vector<Vertex_handle> m_free_steiner_vertices;                   // those that came off them
  std::unordered_map<const void*, Carrier> m_origins;                   // of these; look-up only
  std::size_t m_number_of_steiner_points = 0;
  std::size_t m_number_of_constraint_points = 0;
  Boundary_recovery_3::internal::Vertex_predicates_3<Tr> m_predicates;
  Boundary_recovery_3::internal::Recovery_context<Visitor> m_context;
  Boundary_recovery_3::internal::Constraint_search_3<Tr> m_search;
  Lost_constraints m_lost;
  Lost_constraints m_unrepresentable;
  std::vector<std::size_t> m_treatable_facets; // lost facets whose edges are in the mesh
  std::vector<Phase_report> m_phases;
  std::vector<Recursion_level_report> m_levels;
  Boundary_recovery_3::internal::Recursive_recovery_3<Tr, 2, Visitor> m_edge_recovery;
  Boundary_recovery_3::internal::Recursive_recovery_3<Tr, 3, Visitor> m_facet_recovery;
  std::size_t m_number_of_transformations = 0;
  int m_max_recursion_level = default_max_recursion_level;
};

} // namespace CGAL

#endif // CGAL_CONSTRAINED_BOUNDARY_RECOVERY_3_H
