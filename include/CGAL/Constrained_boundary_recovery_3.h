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
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/Cavity_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/Conforming_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/Constraint_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/Edge_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/Facet_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/Intersection_table_3.h>
#include <CGAL/Boundary_recovery_3/internal/Mesh_snapshot_3.h>
#include <CGAL/Boundary_recovery_3/internal/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/Simplex_key_3.h>
#include <CGAL/Boundary_recovery_3/internal/Steiner_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/Steiner_splitting_3.h>
#include <CGAL/Boundary_recovery_3/internal/Steiner_suppression_3.h>
#include <CGAL/Boundary_recovery_3/internal/Vertex_predicates_3.h>
#include <CGAL/Shell_transformation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
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

  /// the maximal recursion level if none is set; no corpus surface made progress beyond 20.
  static constexpr int default_max_recursion_level = 30;

  /*!
   * \param tr the triangulation to change
   * \param visitor is told about progress and may stop the recovery. It has to outlive this object.
   *
   * \pre `tr.dimension() == 3`
   */
  Constrained_boundary_recovery_3(Tr& tr, Visitor& visitor)
    : m_tr(tr), m_steiner_points(m_constraints), m_parts(tr, m_steiner_points),
      m_predicates(tr, &m_steiner_points.positions()), m_context(visitor),
      m_edge_recovery(tr, m_predicates), m_facet_recovery(tr, m_predicates)
  {
    CGAL_precondition(tr.dimension() == 3);
  }

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
  std::size_t insert_constraint(const Vertex_handle u, const Vertex_handle v) { return m_constraints.insert(u, v); }

  /// adds the constrained facet `uvw` and its edges, unless they are there already, and returns the index of the facet.
  std::size_t insert_constraint(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
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
  std::vector<std::array<Vertex_handle, 2> > parts_of_edge(const std::size_t e) const { return m_parts.of_edge(e); }

  /// returns the mesh facets that the facet `f` consists of, in its orientation; none if it is not a union of mesh
  /// facets.
  std::vector<std::array<Vertex_handle, 3> > parts_of_facet(const std::size_t f) const { return m_parts.of_facet(f); }
  /// @}

  /// \name Settings
  /// @{

  /// sets the maximal recursion level.
  void set_max_recursion_level(const int l_max) { m_max_recursion_level = l_max; }

  /// sets the time after which the recovery stops, in seconds from the construction of this object.
  void set_maximum_running_time(const double seconds) { m_context.set_maximum_running_time(seconds); }
  /// @}

  /// \name Phases
  /// Each may be called on its own, after `search()`.
  /// @{

  /// runs all the phases of a mode. Returns whether every constraint is in the triangulation: as one simplex, or, in
  /// the mode `conforming`, as a union of simplices.
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
    remove_plainly();
    recover_edges_brc1();
    recover_edges_brc3();
    reconnect_edges();
    recover_facets_brc2();
    recover_facets_brc4();
    reconnect_facets();
    recount();
    return m_lost.edges.empty() && m_lost.facets.empty();
  }

  /// looks up every constraint.
  void search() { run(Phase::search, [&] { look_up(); }); }

  /// removes what crosses lost edges by complete removals of single shells: the cases that need neither
  /// quality nor recursion.
  void remove_plainly()
  {
    typedef Shell_transformation_3<Tr, No_quality, Edge_validity, Visitor> Transformation;
    if(m_lost.edges.empty())
      return;
    run(Phase::plain_removal, [&]
    {
      Transformation st(m_tr, No_quality(), edge_validity(m_constraints.edges().front()), m_context.visitor());
      m_hopeless_edges.assign(m_constraints.edges().size(), std::size_t(never));
      for(std::size_t before = 0; before != m_lost.edges.size() && ! m_lost.edges.empty(); )
      {
        before = m_lost.edges.size();
        edge_report(); // for the order
        edge_pass(Phase::plain_removal, st, 0);
      }
      m_number_of_transformations += st.number_of_transformations();
    });
  }

  /// is the first calling of [CZZ+17, Alg. 5]: under BRC1, with the vector [Q', Q'', Q_1].
  void recover_edges_brc1()
  {
    typedef Shell_transformation_3<Tr, Worst_element_quality, Edge_validity, Visitor> Transformation;
    if(m_lost.edges.empty())
      return;
    run(Phase::edge_recovery_brc1, [&]
    {
      Transformation st(m_tr, Worst_element_quality(m_tr), edge_validity(m_constraints.edges().front()),
                        m_context.visitor());
      raise_recursion_level(Phase::edge_recovery_brc1, m_lost.edges,
                            [&] { return edge_report(); },
                            [&](const int l_max) { edge_pass(Phase::edge_recovery_brc1, st, l_max); },
                            [](const Recursion_level_report& r) { return r.n1; });
      m_number_of_transformations += st.number_of_transformations();
    });
  }

  /// is the second calling of [CZZ+17, Alg. 5]: under BRC3, with the vector [Q_2, Q', Q''].
  void recover_edges_brc3()
  {
    typedef Boundary_recovery_3::internal::Intersection_table_3<Tr, 2> Table;
    typedef Boundary_recovery_3::Fewest_intersections_quality_3<Tr, Table> Quality;
    typedef Boundary_recovery_3::Shell_validity_conjunction_3<Kept, Boundary_recovery_3::BRC3<Tr, Table> > Validity;
    typedef Shell_transformation_3<Tr, Quality, Validity, Visitor> Transformation;
    if(m_lost.edges.empty())
      return;
    run(Phase::edge_recovery_brc3, [&]
    {
      Table table(m_tr);
      const Validity validity{ Kept(m_constraints), Boundary_recovery_3::BRC3<Tr, Table>(table) };
      Transformation st(m_tr, Quality(table), validity, m_context.visitor());
      raise_recursion_level(Phase::edge_recovery_brc3, m_lost.edges,
                            [&] { return edge_report(); },
                            [&](const int l_max)
                            {
                              table.set_constraints(simplices(m_lost.edges, m_constraints.edges()));
                              edge_pass(Phase::edge_recovery_brc3, st, l_max);
                            },
                            [](const Recursion_level_report& r) { return r.n2; });
      m_number_of_transformations += st.number_of_transformations();
    });
  }

  /// tries small polyhedron reconnection on the cells around each lost edge, as long as this helps.
  void reconnect_edges()
  {
    if(m_lost.edges.empty())
      return;
    run(Phase::edge_reconnection, [&] { reconnect(Phase::edge_reconnection, m_lost.edges, m_constraints.edges()); });
  }

  /// tries small polyhedron reconnection on the cells around each lost facet that has its edges, as long as this helps.
  void reconnect_facets()
  {
    find_treatable_facets();
    if(m_treatable_facets.empty())
      return;
    run(Phase::facet_reconnection, [&]
    {
      reconnect(Phase::facet_reconnection, m_treatable_facets, m_constraints.facets());
      look_up_lost();
    });
  }

  /// is the first calling for facets [CZZ+17, Section 4.2.2]: under BRC2.
  /// Facets are treated if their edges are in the triangulation.
  void recover_facets_brc2()
  {
    typedef Shell_transformation_3<Tr, Worst_element_quality, Facet_validity, Visitor> Transformation;
    if(m_lost.facets.empty())
      return;
    run(Phase::facet_recovery_brc2, [&]
    {
      look_up_lost(); // most facets came back with their edges
      find_treatable_facets();
      if(m_treatable_facets.empty())
        return;
      Transformation st(m_tr, Worst_element_quality(m_tr), facet_validity(m_constraints.facets().front()),
                        m_context.visitor());
      raise_recursion_level(Phase::facet_recovery_brc2, m_treatable_facets,
                            [&] { return facet_report(); },
                            [&](const int l_max) { facet_pass(Phase::facet_recovery_brc2, st, l_max); },
                            [](const Recursion_level_report& r) { return r.n1; });
      m_number_of_transformations += st.number_of_transformations();
      look_up_lost();
    });
  }

  /// is the second calling for facets [CZZ+17, Section 4.2.2]: under BRC4.
  void recover_facets_brc4()
  {
    typedef Boundary_recovery_3::internal::Intersection_table_3<Tr, 3> Table;
    typedef Boundary_recovery_3::Fewest_intersections_quality_3<Tr, Table> Quality;
    typedef Boundary_recovery_3::Shell_validity_conjunction_3<Kept, Boundary_recovery_3::BRC4<Tr, Table> > Validity;
    typedef Shell_transformation_3<Tr, Quality, Validity, Visitor> Transformation;
    find_treatable_facets();
    if(m_treatable_facets.empty())
      return;
    run(Phase::facet_recovery_brc4, [&]
    {
      Table table(m_tr);
      const Validity validity{ Kept(m_constraints), Boundary_recovery_3::BRC4<Tr, Table>(table) };
      Transformation st(m_tr, Quality(table), validity, m_context.visitor());
      raise_recursion_level(Phase::facet_recovery_brc4, m_treatable_facets,
                            [&] { return facet_report(); },
                            [&](const int l_max)
                            {
                              table.set_constraints(simplices(m_treatable_facets, m_constraints.facets()));
                              facet_pass(Phase::facet_recovery_brc4, st, l_max);
                            },
                            [](const Recursion_level_report& r) { return r.n2; });
      m_number_of_transformations += st.number_of_transformations();
    });
  }

  /// recovers what is lost by Steiner points: the main procedure and the postprocessing of [CZZ+17, Section 4]. In the
  /// mode `constrained`, they are taken off the constraints again, and as many of them as possible are removed; in the
  /// mode `conforming`, they stay there and get the nearest positions that the triangulation can store. In the mode
  /// `flips_only`, they are tried for a few lost edges, and accepted only if all of them could be removed. Returns
  /// whether this worked for all constraints; if not, the triangulation is as it was before.
  ///
  /// \pre the constraints do not intersect, and no other vertex is on them.
  bool recover_by_points(const Mode mode)
  {
    if(mode == Mode::flips_only && m_lost.edges.size() > max_number_of_edges_for_temporary_points)
      return false;
    if(! m_context.go_further())
      return false;
    const Snapshot snapshot(m_tr);
    recover_conforming();
    bool is_done = m_lost.edges.empty() && m_lost.facets.empty();
    if(is_done && mode == Mode::conforming)
      is_done = round_steiner_points();
    else if(is_done)
      is_done = split_steiner_points() && suppress_steiner_points();
    if(mode == Mode::flips_only && ! m_free_steiner_vertices.empty())
      is_done = false;
    if(! is_done)
      take_back(snapshot);
    recount();
    return m_lost.edges.empty() && m_lost.facets.empty();
  }

  /// is the first half of the main procedure of [CZZ+17, Section 4]: lost edges become chains of mesh edges, lost
  /// facets unions of mesh facets, by Steiner points on them.
  ///
  /// Until `round_steiner_points()`, or `split_steiner_points()` and `suppress_steiner_points()`, returned `true`,
  /// exact positions of Steiner points are known to this object only, and cells may be inverted by the rounded
  /// positions in the triangulation.
  void recover_conforming()
  {
    Boundary_recovery_3::internal::Conforming_recovery_3<Tr, Visitor>
      conform(m_tr, m_predicates, m_constraints, m_steiner_points, m_context.visitor());
    run(Phase::conforming_edge_recovery, [&]
    {
      remove_done(Phase::conforming_edge_recovery, m_lost.edges,
                  [&](const std::size_t e) { return conform.recover_edge(e, conforming_recursion_level, m_context); });
    });
    if(m_lost.edges.empty())
      run(Phase::conforming_facet_recovery, [&]
      {
        remove_done(Phase::conforming_facet_recovery, m_lost.facets, [&](const std::size_t f)
        {
          return conform.recover_facet(f, conforming_recursion_level, m_context);
        });
      });
    m_number_of_constraint_points = m_steiner_points.vertices().size();
    m_number_of_transformations += conform.number_of_transformations();
  }

  /// gives each Steiner point on a constraint the nearest position that the triangulation can store, where all the
  /// cells around it remain positively oriented. Returns whether this is so for all of them.
  bool round_steiner_points()
  {
    bool is_done = true;
    for(const Vertex_handle v : m_steiner_points.vertices())
      is_done = m_steiner_points.round(m_tr, m_predicates, v) && is_done;
    return is_done;
  }

  /// is the second half of the main procedure [CZZ+17, Alg. A.1 to A.5]: takes the Steiner points off the constraints.
  /// Returns whether none is left there.
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
          split(v);
          m_context.visitor().on_progress(Phase::steiner_splitting, ++done, before);
        }
      }
    });
    m_free_steiner_vertices.insert(m_free_steiner_vertices.end(), split.points().begin(), split.points().end());
    m_number_of_steiner_points += split.points().size();
    return m_steiner_points.vertices().empty();
  }

  /// is the postprocessing of [CZZ+17, Section 4.3]: removes Steiner points that are on no constraint, as long as it
  /// can. Returns whether the others have positions that the triangulation can store.
  bool suppress_steiner_points()
  {
    Boundary_recovery_3::internal::Steiner_suppression_3<Tr, Visitor>
      suppress(m_tr, m_predicates, m_constraints, m_steiner_points.positions(), m_free_steiner_vertices,
               m_context.visitor());
    run(Phase::steiner_suppression, [&]
    {
      do
      {
        while(suppress.remove_points(suppression_recursion_level, m_context))
          suppress.relocate_points(m_context);
      }
      while(suppress.merge_points(m_context));
    });
    const bool is_storable = suppress.round_points(m_context); // also if the recovery was stopped before
    m_number_of_transformations += suppress.number_of_transformations();
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

  /// returns the Steiner points that are in the triangulation, in the order in which they were created.
  std::vector<Vertex_handle> steiner_vertices() const
  {
    std::vector<Vertex_handle> result = m_steiner_points.vertices();
    result.insert(result.end(), m_free_steiner_vertices.begin(), m_free_steiner_vertices.end());
    return result;
  }

  /// returns the number of Steiner points that were put on constraints.
  std::size_t number_of_constraint_points() const { return m_number_of_constraint_points; }

  /// returns the number of Steiner points that came off the constraints, before any of them was removed.
  std::size_t number_of_steiner_points() const { return m_number_of_steiner_points; }

  /// returns the number of covering meshes that were replaced.
  std::size_t number_of_transformations() const { return m_number_of_transformations; }
  /// @}

private:
  typedef Boundary_recovery_3::internal::Constraints_3<Tr>    Constraints;
  typedef Boundary_recovery_3::internal::Lost_constraints     Lost_constraints;
  typedef Boundary_recovery_3::Kept_constraints_3<Constraints> Kept;
  typedef Boundary_recovery_3::No_shell_quality_3             No_quality;
  typedef Boundary_recovery_3::Worst_element_quality_3<Tr>    Worst_element_quality;
  typedef Boundary_recovery_3::Shell_validity_conjunction_3<Kept, Boundary_recovery_3::BRC1<Tr> > Edge_validity;
  typedef Boundary_recovery_3::Shell_validity_conjunction_3<Kept, Boundary_recovery_3::BRC2<Tr> > Facet_validity;

  typedef Boundary_recovery_3::internal::Mesh_snapshot_3<Tr>  Snapshot;

  // With more lost edges, the chance that no point is left is too small for the time that it takes.
  static constexpr std::size_t max_number_of_edges_for_temporary_points = 20;

  // Raising the level from 0, as for lost edges, left a few more points in twice the time.
  static constexpr int suppression_recursion_level = 4;
  static constexpr int conforming_recursion_level = 3;

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

  void take_back(const Snapshot& snapshot)
  {
    std::vector<Vertex_handle> vertices = m_steiner_points.vertices();
    for(const Vertex_handle v : vertices)
      m_steiner_points.erase(v);
    for(const Vertex_handle v : m_free_steiner_vertices)
      m_steiner_points.positions().erase(v);
    vertices.insert(vertices.end(), m_free_steiner_vertices.begin(), m_free_steiner_vertices.end());
    m_free_steiner_vertices.clear();
    m_number_of_constraint_points = m_number_of_steiner_points = 0;
    snapshot.restore(m_tr, vertices, m_context.visitor());
  }

  // Number of passes in a row without progress after which a calling of Alg. 5 ends.
  static constexpr int max_number_of_failures = 3;

  // From this recursion level on, every second one is left out: the bound on the number of shells counts there, not the
  // level. (On 170 surfaces: 1293 edges lost instead of 1341, but two surfaces lose edges that lost none before.)
  static constexpr int last_level_of_single_steps = 4;

  // Bound on the shells that one calling of Alg. 5 visits, for each constraint that is lost at its start. Only few
  // surfaces come near it: they have planar fans of hundreds of triangles, where recursion goes astray.
  static constexpr std::size_t max_number_of_shells_per_constraint = 1000;

  static constexpr std::size_t never = std::size_t(-1);

  template <typename Work>
  void run(const Phase phase, const Work& work)
  {
    const double start = m_context.seconds();
    m_context.visitor().on_phase_begin(phase);
    if(m_context.go_further() || phase == Phase::recount || phase == Phase::search)
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
    m_lost = Boundary_recovery_3::internal::Constraint_search_3<Tr>(m_tr, m_constraints)();
    if(m_steiner_points.vertices().empty())
      return;
    const auto is_edge_covered = [this](const std::size_t e) { return ! parts_of_edge(e).empty(); };
    const auto is_facet_covered = [this](const std::size_t f) { return ! parts_of_facet(f).empty(); };
    m_lost.edges.erase(std::remove_if(m_lost.edges.begin(), m_lost.edges.end(), is_edge_covered), m_lost.edges.end());
    m_lost.facets.erase(std::remove_if(m_lost.facets.begin(), m_lost.facets.end(), is_facet_covered),
                        m_lost.facets.end());
  }

  // What is in the mesh stays there, so only what was lost has to be looked up.
  void look_up_lost()
  {
    m_lost = Boundary_recovery_3::internal::Constraint_search_3<Tr>(m_tr, m_constraints)(Lost_constraints(m_lost));
  }

  // recvBndEdgesByST_Wrap of [CZZ+17, Alg. 5], for edges and for facets: raises the recursion level from pass to pass
  // until nothing is lost, or until three passes in a row did not improve the measure.
  template <typename Report, typename Pass, typename Measure>
  void raise_recursion_level(const Phase phase, const std::vector<std::size_t>& lost,
                             const Report& report, const Pass& pass, const Measure& measure)
  {
    m_hopeless_edges.assign(m_constraints.edges().size(), std::size_t(never));
    m_hopeless_facets.assign(m_constraints.facets().size(), std::size_t(never));
    m_max_number_of_shells = max_number_of_shells_per_constraint * (lost.size() + 20);
    std::size_t best = add_level(phase, -1, report(), measure);
    int number_of_failures = 0;
    for(int l_max = 0; l_max <= m_max_recursion_level && ! lost.empty() && m_context.go_further();
        l_max += l_max < last_level_of_single_steps ? 1 : 2)
    {
      pass(l_max);
      const std::size_t value = add_level(phase, l_max, report(), measure);
      number_of_failures = value < best ? 0 : number_of_failures + 1;
      best = (std::min)(best, value);
      if(number_of_failures == max_number_of_failures)
        return;
    }
  }

  template <typename Measure>
  std::size_t add_level(const Phase phase, const int l_max, Recursion_level_report report, const Measure& measure)
  {
    report.phase = phase;
    report.max_recursion_level = l_max;
    m_levels.push_back(report);
    return measure(report);
  }

  // recvBndEdgesByST of [CZZ+17, Alg. 4]. Edges with few crossings come first: they are back after a few flips, and
  // are then out of the way of the others. (On 112 surfaces: three more without any loss than in input order.) The
  // order was found out by edge_report().
  template <typename Transformation>
  void edge_pass(const Phase phase, Transformation& st, const int l_max)
  {
    std::size_t done = 0;
    const std::size_t total = m_lost.edges.size();
    m_lost.edges.clear();
    for(const auto& crossings_and_edge : m_edges_by_crossings)
    {
      const std::size_t e = crossings_and_edge.second;
      const std::array<Vertex_handle, 2>& edge = m_constraints.edges()[e];
      set_target(st, edge);
      if(! attempt(st, m_hopeless_edges[e], m_edge_recovery, edge, l_max))
        m_lost.edges.push_back(e);
      m_context.visitor().on_progress(phase, ++done, total);
    }
    std::sort(m_lost.edges.begin(), m_lost.edges.end());
  }

  // Does not repeat an attempt that changed nothing and was not cut off, until the mesh has changed; a higher
  // recursion level alone would lead it to the same end. `hopeless_since` is the state of the mesh in such a case.
  template <typename Transformation, typename Recovery, typename Simplex>
  bool attempt(Transformation& st, std::size_t& hopeless_since, Recovery& recovery, const Simplex& simplex,
               const int l_max)
  {
    const std::size_t before = st.number_of_transformations();
    if(hopeless_since == before || st.number_of_shells() > m_max_number_of_shells)
      return false;
    const bool is_recovered = recovery(st, simplex, l_max, m_context);
    const bool is_hopeless = ! is_recovered && st.number_of_transformations() == before && ! recovery.was_cut_off();
    hopeless_since = is_hopeless ? before : never;
    return is_recovered;
  }

  template <typename Transformation>
  void facet_pass(const Phase phase, Transformation& st, const int l_max)
  {
    std::size_t kept = 0, done = 0;
    const std::size_t total = m_treatable_facets.size();
    for(const std::size_t f : m_treatable_facets)
    {
      const std::array<Vertex_handle, 3>& facet = m_constraints.facets()[f];
      set_target(st, facet);
      if(! attempt(st, m_hopeless_facets[f], m_facet_recovery, facet, l_max))
        m_treatable_facets[kept++] = f;
      m_context.visitor().on_progress(phase, ++done, total);
    }
    m_treatable_facets.resize(kept);
  }

  // One success may clear the way for another constraint, so passes are repeated while they help. What failed is not
  // tried again in the same mesh.
  template <typename Simplex>
  void reconnect(const Phase phase, std::vector<std::size_t>& lost, const std::vector<Simplex>& simplices)
  {
    Boundary_recovery_3::internal::Cavity_recovery_3<Tr, Visitor>
      recover(m_tr, m_predicates, m_constraints, m_context.visitor());
    std::vector<std::size_t> hopeless_since(lost.size(), std::size_t(never)); // numbers of replacements
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

  // BRC1 and BRC2 are about the constraint that is being recovered, BRC3 and BRC4 about all of them.
  template <typename Quality>
  void set_target(Shell_transformation_3<Tr, Quality, Edge_validity, Visitor>& st,
                  const std::array<Vertex_handle, 2>& edge) const
  {
    st.validity() = edge_validity(edge);
  }

  template <typename Quality>
  void set_target(Shell_transformation_3<Tr, Quality, Facet_validity, Visitor>& st,
                  const std::array<Vertex_handle, 3>& facet) const
  {
    st.validity() = facet_validity(facet);
  }

  template <typename Transformation, typename Simplex>
  void set_target(Transformation&, const Simplex&) const { }

  Edge_validity edge_validity(const std::array<Vertex_handle, 2>& e) const
  {
    return Edge_validity(Kept(m_constraints), Boundary_recovery_3::BRC1<Tr>(m_tr, e[0], e[1]));
  }

  Facet_validity facet_validity(const std::array<Vertex_handle, 3>& f) const
  {
    return Facet_validity(Kept(m_constraints), Boundary_recovery_3::BRC2<Tr>(m_tr, f[0], f[1], f[2]));
  }

  template <typename Simplex>
  static std::vector<Simplex> simplices(const std::vector<std::size_t>& indices, const std::vector<Simplex>& all)
  {
    std::vector<Simplex> result;
    for(const std::size_t i : indices)
      result.push_back(all[i]);
    return result;
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

  // The state of the lost edges; n_4 counts the mesh entities that they cross, each once.
  Recursion_level_report edge_report()
  {
    Recursion_level_report report;
    report.n1 = m_lost.edges.size();
    Crossed_entities crossed;
    m_edges_by_crossings.clear();
    for(const std::size_t e : m_lost.edges)
    {
      const std::array<Vertex_handle, 2>& edge = m_constraints.edges()[e];
      m_edges_by_crossings.emplace_back(m_edge_recovery.number_of_crossings(edge[0], edge[1]), e);
      add_crossings(report, m_edges_by_crossings.back().first);
      for(const auto& crossing : m_edge_recovery.walk().crossings())
        crossed.insert(m_edge_recovery.key(crossing));
    }
    std::sort(m_edges_by_crossings.begin(), m_edges_by_crossings.end());
    report.n4 = crossed.size();
    return report;
  }

  Recursion_level_report facet_report()
  {
    Recursion_level_report report;
    report.n1 = m_treatable_facets.size();
    Crossed_entities crossed;
    for(const std::size_t f : m_treatable_facets)
    {
      const std::array<Vertex_handle, 3>& facet = m_constraints.facets()[f];
      add_crossings(report, m_facet_recovery.number_of_crossings(facet[0], facet[1], facet[2]));
      for(const auto& crossing : m_facet_recovery.walk().crossings())
        crossed.insert(m_facet_recovery.key(crossing));
    }
    report.n4 = crossed.size();
    return report;
  }

  static void add_crossings(Recursion_level_report& report, const std::size_t n)
  {
    report.n2 += n;
    report.n3 = (std::max)(report.n3, n);
  }

  typedef Boundary_recovery_3::internal::Simplex_index_3<3> Crossed_entities;

  Tr& m_tr;
  Constraints m_constraints;
  Boundary_recovery_3::internal::Steiner_points_3<Tr> m_steiner_points; // those on constraints
  Boundary_recovery_3::internal::Constraint_parts_3<Tr> m_parts;
  std::vector<Vertex_handle> m_free_steiner_vertices;                   // those that came off them
  std::size_t m_number_of_steiner_points = 0;
  std::size_t m_number_of_constraint_points = 0;
  Boundary_recovery_3::internal::Vertex_predicates_3<Tr> m_predicates;
  Boundary_recovery_3::internal::Recovery_context<Visitor> m_context;
  Boundary_recovery_3::internal::Edge_recovery_3<Tr> m_edge_recovery;
  Boundary_recovery_3::internal::Facet_recovery_3<Tr> m_facet_recovery;
  Lost_constraints m_lost;
  std::vector<std::pair<std::size_t, std::size_t> > m_edges_by_crossings; // the lost edges, in the order of treatment
  std::vector<std::size_t> m_treatable_facets; // lost facets whose edges are in the mesh
  std::vector<std::size_t> m_hopeless_edges, m_hopeless_facets; // numbers of transformations, or never; see attempt()
  std::vector<Phase_report> m_phases;
  std::vector<Recursion_level_report> m_levels;
  std::size_t m_number_of_transformations = 0;
  std::size_t m_max_number_of_shells = std::size_t(-1); // in one calling of Alg. 5
  int m_max_recursion_level = default_max_recursion_level;
};

} // namespace CGAL

#endif // CGAL_CONSTRAINED_BOUNDARY_RECOVERY_3_H
