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
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_by_flips_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_state_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_by_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief recovers constrained edges and facets in a triangulation, by recursive shell transformations first, and by
 * Steiner points where these are not enough.
 *
 * An object holds the constraints, and runs the phases of [CZZ+17, Section 4]; each phase can be called on its own.
 * Constraints in the triangulation are never destroyed.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`, or of a class derived from it, with a model of
 *         `BoundaryRecoveryTraits_3` as geometric traits
 * \tparam Visitor a model of `MeshingVisitor_3`
 *
 * \sa `CGAL::recover_boundary()`
 */
template <typename Tr, typename Visitor_ = Default_meshing_visitor_3>
class Constrained_boundary_recovery_3
{
public:
  typedef Tr       Triangulation;                         ///< the triangulation type
  typedef Visitor_ Visitor;                               ///< the visitor type
  typedef typename Tr::Vertex_handle Vertex_handle;       ///< the vertex handle of the triangulation
  typedef Boundary_recovery_3::Phase Phase;               ///< the phases
  typedef Boundary_recovery_3::Recovery_mode Mode;        ///< the modes
  typedef Boundary_recovery_3::Recovery_effort Effort;    ///< what may be given up
  typedef Boundary_recovery_3::Phase_report Phase_report; ///< the duration and the counts of a phase
  typedef Boundary_recovery_3::Recursion_level_report Recursion_level_report; ///< the counts of a pass

  /// the maximal recursion level if none is set.
  static constexpr int default_max_recursion_level = 30;

  /// the maximal recursion level of the flips while Steiner points are put on constraints: 3. \hideinitializer
  static constexpr int default_conforming_recursion_level
    = Boundary_recovery_3::internal::Recover_by_points_3<Tr>::default_recursion_level;

  /*!
   * \param tr the triangulation to change. As long as this object is used, the triangulation must not be cleared,
   *        assigned to or swapped, and vertices of constraints must not be removed.
   * \param visitor the visitor, which is told about progress, and may stop the recovery. It must outlive this object.
   *
   * \pre `tr.dimension() == 3`
   */
  Constrained_boundary_recovery_3(Tr& tr, Visitor& visitor)
    : m_tr(tr), m_visitor(std::in_place, visitor), m_own_context(std::in_place, *m_visitor), m_context(*m_own_context)
  {
    CGAL_precondition(tr.dimension() == 3);
  }

  /// as above, with a visitor that does nothing.
  explicit Constrained_boundary_recovery_3(Tr& tr) : Constrained_boundary_recovery_3(tr, m_no_visitor) { }

#ifndef DOXYGEN_RUNNING
  // As above, with the context of the caller: one visitor, one clock, one deadline.
  Constrained_boundary_recovery_3(Tr& tr, Boundary_recovery_3::internal::Recovery_context<Tr>& context)
    : m_tr(tr), m_context(context)
  {
    CGAL_precondition(tr.dimension() == 3);
  }
#endif

  Constrained_boundary_recovery_3(const Constrained_boundary_recovery_3&) = delete;
  Constrained_boundary_recovery_3& operator=(const Constrained_boundary_recovery_3&) = delete;

  /// \name Constraints
  /// @{

  /// allocates memory for these numbers of constrained edges, without the edges of facets, and of constrained facets.
  void reserve(const std::size_t number_of_edges, const std::size_t number_of_facets)
  {
    m_constraints.reserve(number_of_edges, number_of_facets);
  }

  /// adds the constrained edge `uv`, unless it is known already, and returns its index.
  ///
  /// \pre `u` and `v` are different finite vertices of the triangulation.
  std::size_t insert_constraint(const Vertex_handle u, const Vertex_handle v)
  {
    CGAL_precondition(u != v);
    return m_constraints.insert(u, v);
  }

  /// adds the constrained facet `uvw` and its edges, unless they are known already, and returns the index of the facet.
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

  /// returns the indices of the edges that were lost at the last search, in increasing order.
  const std::vector<std::size_t>& lost_edges() const { return m_state.lost.edges; }

  /// returns the indices of the facets that were lost at the last search, in increasing order.
  const std::vector<std::size_t>& lost_facets() const { return m_state.lost.facets; }

  /// returns the indices of the edges with Steiner points on them, in increasing order.
  std::vector<std::size_t> split_edges() const { return m_ledger.split_edges(); }

  /// returns the indices of the facets with Steiner points on them or on their edges, in increasing order.
  std::vector<std::size_t> split_facets() const { return m_ledger.split_facets(); }

  /// returns the mesh edges that form the edge `e`, from its first vertex to its second; none if the edge is not a
  /// union of mesh edges.
  ///
  /// \pre `e < constrained_edges().size()`
  std::vector<std::array<Vertex_handle, 2> > parts_of_edge(const std::size_t e) const
  {
    return m_points.parts().of_edge(e);
  }

  /// returns the mesh facets that form the facet `f`, in the orientation of `f`; none if `f` is not a union of mesh
  /// facets.
  ///
  /// \pre `f < constrained_facets().size()`
  std::vector<std::array<Vertex_handle, 3> > parts_of_facet(const std::size_t f) const
  {
    return m_points.parts().of_facet(f);
  }
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

  /// sets what is given up, time or points; `Effort::more_time` by default. The effort chooses the phases of
  /// `recover_by_flips()`, and the work of the phases with Steiner points.
  void set_effort(const Effort effort) { m_effort = effort; }

  /// sets the time after which the recovery stops, in seconds from the construction of this object; no limit by
  /// default.
  void set_maximum_running_time(const double seconds) { m_context.set_maximum_running_time(seconds); }
  /// @}

  /// \name Phases
  /// Each phase may be called on its own, after `search()`. Phases without points must not be called while Steiner
  /// points are on constraints.
  /// @{

  /// runs all phases of a mode. Returns whether every constraint is in the triangulation: as one simplex, or, in the
  /// mode `conforming`, as a union of simplices.
  ///
  /// \param mode how far the recovery goes
  ///
  /// \pre the constraints do not intersect, and no other vertex is on them.
  bool operator()(const Mode mode = Mode::constrained)
  {
    return recover_by_flips(mode) || recover_by_points(mode);
  }

  /// runs the phases before those of `recover_by_points()`. With a mode other than `flips_only`, it may leave Steiner
  /// points beside planes. Returns whether every constraint is in the triangulation.
  ///
  /// \param mode how far the recovery goes; unless it is `flips_only`, Steiner points of `recover_planar_edges()` may
  ///        be left
  bool recover_by_flips(const Mode mode = Mode::flips_only)
  {
    search();
    if(m_state.is_nothing_lost())
      return true; // nothing is going to change, so there is nothing to recount
    recover_planar_edges(mode);
    remove_without_recursion();
    recover_edges_brc1();
    if(m_effort == Effort::more_time)
    {
      recover_edges_brc3();
      reconnect_edges();
    }
    recover_facets_brc2();
    recover_facets_brc4();
    reconnect_facets();
    recount();
    return m_state.is_nothing_lost();
  }

  /// looks up every constraint.
  void search() { m_state.run(Phase::search, [this] { m_points.look_up(); }); }

  /// recovers edges that are tangled in a plane. A group has at least 100 lost edges, which are connected by mesh edges
  /// in the plane that they cross, more than 4 each on average; a fan of cocircular points has such a group. A Steiner
  /// point is put close to the plane, on each side with cells. When the edges are back, the point is removed again
  /// where possible; otherwise it is in `steiner_vertices()`, and stays. The triangulation is taken back to its state
  /// before the group if fewer than 100 edges come back for each point that stays, if a point stays in the mode
  /// `flips_only`, or if the visitor or the kernel throws.
  ///
  /// \param mode how far the recovery goes
  ///
  /// \pre no Steiner point is on a constraint.
  void recover_planar_edges(const Mode mode = Mode::constrained) { m_points.recover_planar_edges(mode); }

  /// removes edges and facets that cross lost edges, by cells from an end of the lost edge, or by complete removals of
  /// single shells: the cases that need neither quality nor recursion.
  void remove_without_recursion() { flips().remove_without_recursion(); }

  /// is the first calling of [CZZ+17, Alg.\ 5]: under BRC1, with the vector [Q', Q'', Q_1].
  void recover_edges_brc1() { flips().recover_edges_brc1(m_max_recursion_level); }

  /// is the second calling of [CZZ+17, Alg.\ 5]: under BRC3, with the vector [Q_2, Q', Q''].
  void recover_edges_brc3() { flips().recover_edges_brc3(m_max_recursion_level); }

  /// tries small polyhedron reconnection on the cells around each lost edge, as long as it helps.
  void reconnect_edges() { flips().reconnect_edges(); }

  /// tries small polyhedron reconnection on the cells around each lost facet whose edges are in the triangulation, as
  /// long as it helps.
  void reconnect_facets() { flips().reconnect_facets(); }

  /// is the first calling for facets [CZZ+17, Section 4.2.2]: under BRC2.
  /// Facets are treated if their edges are in the triangulation.
  void recover_facets_brc2() { flips().recover_facets_brc2(m_max_recursion_level); }

  /// is the second calling for facets [CZZ+17, Section 4.2.2]: under BRC4.
  void recover_facets_brc4() { flips().recover_facets_brc4(m_max_recursion_level); }

  /// recovers lost constraints by Steiner points: the main procedure and the postprocessing of [CZZ+17, Section 4]. In
  /// the mode `constrained`, the points are taken off the constraints again, and as many as possible are removed. In
  /// the mode `conforming`, they stay on the constraints, and get the nearest positions that the triangulation can
  /// store. In the mode `flips_only`, they are tried for a few lost edges, and accepted only if all can be removed. If
  /// a position cannot be stored, or points stay that must not, the triangulation is taken back and other points are
  /// tried, up to six times in all. Earlier Steiner points stay. Returns whether all constraints were recovered. If
  /// not, or if the visitor or the kernel throws, the triangulation is as it was before.
  ///
  /// \pre the constraints do not intersect, no other vertex is on them, and no Steiner point is on a constraint.
  bool recover_by_points(const Mode mode)
  {
    return m_points(mode, m_max_recursion_level, Recovery_by_points::max_number_of_edges_at_once,
                    mode == Mode::flips_only ? Effort::more_time : m_effort);
  }

  /// is the first half of the main procedure of [CZZ+17, Section 4]: by Steiner points on the constraints, lost edges
  /// become chains of mesh edges, and lost facets unions of mesh facets.
  ///
  /// Only this object knows the exact positions of the Steiner points; the rounded positions in the triangulation may
  /// invert cells. This ends when `round_steiner_points()`, or `split_steiner_points()` and
  /// `suppress_steiner_points()`, has returned `true`.
  ///
  /// \param l_max the maximal recursion level of the flips that are tried for each part of an edge, not negative
  ///
  /// \pre lost constraints were searched after the last change of the triangulation.
  void recover_conforming(const int l_max = default_conforming_recursion_level) { m_points.recover_conforming(l_max); }

  /// gives each Steiner point on a constraint a position that the triangulation can store: the nearest one, or another
  /// one within 2^10 times the distance of neighboring numbers at its largest coordinate. All cells around the point
  /// remain positively oriented. Returns whether all these points, and all points that came off the constraints, have
  /// such positions.
  bool round_steiner_points() { return m_points.round_points(); }

  /// is the second half of the main procedure [CZZ+17, Alg.\ A.1 to A.5]: takes the Steiner points off the constraints.
  /// Returns whether no Steiner point is left on a constraint.
  ///
  /// \pre all constraints are unions of mesh simplices.
  bool split_steiner_points() { return m_points.split_points(); }

  /// is the postprocessing of [CZZ+17, Section 4.3]: removes Steiner points that are on no constraint, as far as
  /// possible. Returns whether the triangulation can store the positions of all others.
  ///
  /// \pre no Steiner point is on a constraint
  bool suppress_steiner_points() { return m_points.suppress_points(m_max_recursion_level, m_effort); }

  /// looks up every constraint again: only this phase tells which constraints were recovered.
  void recount() { m_points.recount(); }
  /// @}

  /// \name Account
  /// @{

  /// returns whether the visitor or the time limit ended the recovery.
  bool is_stopped() const { return m_context.is_stopped(); }

  /// returns the counts of each phase that ran.
  const std::vector<Phase_report>& phases() const { return m_state.phases; }

  /// returns the counts of each pass, the rows of the tables of [CZZ+17, Section 5.1.2].
  const std::vector<Recursion_level_report>& levels() const { return m_state.levels; }

  /// returns the Steiner points that are in the triangulation: those on constraints, then the others, both in the order
  /// in which they were created.
  std::vector<Vertex_handle> steiner_vertices() const { return m_ledger.points(); }

  /// returns the indices of the edges that need a Steiner point, on or beside the edge, at a position that the
  /// triangulation cannot store, in increasing order. If `recover_by_points()` failed, they are the edges of the last
  /// attempt.
  const std::vector<std::size_t>& unrepresentable_edges() const { return m_points.unrepresentable().edges; }

  /// as above, for facets.
  const std::vector<std::size_t>& unrepresentable_facets() const { return m_points.unrepresentable().facets; }

  /// returns the number of Steiner points that were put on constraints.
  std::size_t number_of_constraint_points() const { return m_ledger.number_of_constraint_points(); }

  /// returns the number of Steiner points that came off the constraints, before the first removal, plus the number of
  /// points of `recover_planar_edges()`.
  std::size_t number_of_steiner_points() const { return m_ledger.number_of_free_points(); }

  /// returns the number of replacements of cells by flips, stars and reconnections, with replacements that were taken
  /// back.
  std::size_t number_of_transformations() const { return m_state.number_of_transformations; }
  /// @}

private:
  typedef Boundary_recovery_3::internal::Recovery_context<Tr>            Context;
  typedef Boundary_recovery_3::internal::Any_visitor_3<Tr, Visitor&>     Any_visitor;
  typedef Boundary_recovery_3::internal::Constraints_3<Tr>               Constraints;
  typedef Boundary_recovery_3::internal::Steiner_ledger_3<Tr>            Ledger;
  typedef Boundary_recovery_3::internal::Vertex_predicates_3<Tr>         Predicates;
  typedef Boundary_recovery_3::internal::Recovery_state_3<Tr>            State;
  typedef Boundary_recovery_3::internal::Recovery_by_flips_3<Tr>         Recovery_by_flips;
  typedef Boundary_recovery_3::internal::Recover_by_points_3<Tr>        Recovery_by_points;

  // What flips keep are the constraints, not their parts.
  Recovery_by_flips& flips()
  {
    CGAL_precondition(m_ledger.points_on_constraints().empty());
    return m_flips;
  }

  Tr& m_tr;
  // what the constructor without a visitor points to; other visitors need not be default constructible
  Default_meshing_visitor_3 m_no_visitor;
  std::optional<Any_visitor> m_visitor; // none: the context has one
  std::optional<Context> m_own_context;
  Context& m_context;
  Constraints m_constraints;
  Ledger m_ledger{ m_constraints };
  Predicates m_predicates{ m_tr, &m_ledger.positions() };
  State m_state{ m_tr, m_predicates, m_constraints, m_context };
  Recovery_by_flips m_flips{ m_state };
  Recovery_by_points m_points{ m_state, m_ledger };
  int m_max_recursion_level = default_max_recursion_level;
  Effort m_effort = Effort::more_time;
};

} // namespace CGAL

#endif // CGAL_CONSTRAINED_BOUNDARY_RECOVERY_3_H
