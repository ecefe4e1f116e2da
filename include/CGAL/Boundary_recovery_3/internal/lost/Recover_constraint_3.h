// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVER_CONSTRAINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVER_CONSTRAINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Facet_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Recovery of one lost constraint of dimension N - 1: an edge (N = 2), or a facet whose edges are mesh edges (N = 3).
 * The body of the loop of [CZZ+17, Alg. 4], and its counterpart for facets [CZZ+17, Section 4.2.2].
 *
 * The mesh entities that cross the constraint are removed one after the other, and collected again after each change.
 * Of those that cross an edge, only the first and the last are tried: in a planar fan no other can be flipped away, and
 * elsewhere attempts in the middle make more mess than progress, see "Tuning constants" in the manual. Those that
 * pierce a facet have no order; all are tried.
 *
 * What crosses an edge next to one of its ends gives way to the star of this end, if that can be extended: this is
 * quick, so recursion is for what is left, where other constraints are in the way. All new simplices are at an end of
 * the edge, so none crosses it.
 */
template <typename Tr, std::size_t N, typename Constraints = Constraints_3<Tr> >
class Recover_constraint_3
{
public:
  typedef typename Tr::Vertex_handle          Vertex_handle;
  typedef typename Tr::Cell_handle            Cell_handle;
  typedef typename Tr::Edge                   Edge;
  typedef typename Tr::Facet                  Facet;
  typedef Vertex_predicates_3<Tr>             Predicates;
  typedef Crossing_3<Tr>                      Crossing;
  typedef std::array<Vertex_handle, N>        Constraint;
  typedef std::conditional_t<N == 2, Segment_walk_3<Tr>, Facet_walk_3<Tr> > Walk;

  // Bound on the shells that one call visits, unless another one is set.
  static constexpr std::size_t default_max_number_of_shells = 256;

  // Edges and facets of `constraints` that are in the mesh are kept. All arguments have to outlive this object.
  Recover_constraint_3(Mesh_editor_3<Tr>& editor, const Predicates& predicates, const Constraints& constraints)
    : m_tr(editor.triangulation()), m_walk(m_tr, predicates), m_extend_star(editor, predicates, constraints)
  { }

  void set_max_number_of_shells(const std::size_t n) { m_max_number_of_shells = n; }

  // Returns whether the constraint is in the mesh in the end. The shell transformations obey `validity`, which has to
  // keep the constraints.
  template <typename Shell_transformation, typename Context>
  bool operator()(Shell_transformation& st, const Constraint& constraint,
                  const typename Shell_transformation::Validity& validity, const int l_max, Context& context)
  {
    const std::size_t start = st.number_of_shells();
    std::size_t fewest = std::size_t(-1);
    m_tried.clear();
    m_was_cut_off = false;
    while(context.go_further())
    {
      const std::size_t number_of_shells = st.number_of_shells() - start;
      if(number_of_shells >= m_max_number_of_shells)
      {
        m_was_cut_off = true;
        return false;
      }
      st.set_max_number_of_shells(m_max_number_of_shells - number_of_shells);
      const typename Walk::Outcome outcome = walk(constraint);
      if(outcome != Walk::CROSSED)
        return outcome != Walk::BLOCKED;
      if(m_walk.crossings().size() < fewest)
      {
        fewest = m_walk.crossings().size();
        m_tried.clear();
      }
      if(! star_from_ends(constraint) && ! try_crossings(st, validity, l_max))
        return false;
    }
    return false;
  }

  // The mesh entities that cross the constraint; none if it is in the mesh.
  const std::vector<Crossing>& crossings(const Constraint& constraint)
  {
    walk(constraint);
    return m_walk.crossings();
  }

  // Those that were collected last: after a call that failed, what was left then.
  const std::vector<Crossing>& crossings() const { return m_walk.crossings(); }

  // The crossings that were collected so far, those that were collected again included, and as many as take as long as
  // the stars: with the shells, a measure of the work.
  std::size_t work_in_crossings() const { return m_work_in_crossings; }

  // The stars of ends of edges that were extended so far: changes of the mesh beside the shell transformations.
  std::size_t number_of_stars() const { return m_extend_star.number_of_replacements(); }

  // Whether the recursion level or the bound on shells ended some removal in the last call.
  bool was_cut_off() const { return m_was_cut_off; }

private:
  typedef std::array<Vertex_handle, 3> Entity; // as Crossing_3::vertices

  typename Walk::Outcome walk(const Constraint& constraint)
  {
    const typename Walk::Outcome outcome = m_walk(constraint);
    m_work_in_crossings += m_walk.crossings().size();
    return outcome;
  }

  // Takes away the first or the last crossing of an edge, or more of them, by cells from the end next to it. Returns
  // whether that was possible; then there are fewer.
  bool star_from_ends(const Constraint& constraint)
  {
    return N == 2 && (star(m_walk.crossings().front(), constraint.front())
                      || star(m_walk.crossings().back(), constraint.back()));
  }

  bool star(const Crossing& crossing, const Vertex_handle v)
  {
    m_cells.clear();
    internal::append_cells_at(m_tr, crossing, m_cells);
    const bool is_done = m_extend_star(m_cells, v);
    m_work_in_crossings += crossings_per_cell_of_star * m_extend_star.number_of_cells();
    return is_done;
  }

  // Returns whether the mesh changed, so that the crossings have to be collected again.
  template <typename Shell_transformation, typename Validity>
  bool try_crossings(Shell_transformation& st, const Validity& validity, const int l_max)
  {
    const std::vector<Crossing>& crossings = m_walk.crossings();
    const std::size_t step = N == 2 && crossings.size() > 2 ? crossings.size() - 1 : 1; // from the first to the last
    for(std::size_t i = 0; i < crossings.size() && m_tried.size() < max_number_of_attempts; i += step)
    {
      if(! is_new(crossings[i]))
        continue;
      const std::size_t before = st.number_of_transformations();
      remove(st, crossings[i], validity, l_max);
      m_was_cut_off |= st.was_cut_off();
      if(st.number_of_transformations() != before)
        return true;
    }
    return false;
  }

  template <typename Shell_transformation, typename Validity>
  static bool remove(Shell_transformation& st, const Crossing& crossing, const Validity& validity, const int l_max)
  {
    const Cell_handle c = crossing.cell;
    if(crossing.dimension == 1)
      return st.remove_edge(Edge(c, c->index(crossing.vertices[0]), c->index(crossing.vertices[1])), l_max,
                            validity);
    return st.remove_facet(Facet(c, internal::index_of_opposite_vertex(c, crossing.vertices)), l_max, validity);
  }

  // An entity is tried once between two decreases of the number of crossings.
  bool is_new(const Crossing& crossing)
  {
    const auto is_same = [&](const Entity& other) { return internal::is_permutation(crossing.vertices, other); };
    if(std::any_of(m_tried.begin(), m_tried.end(), is_same))
      return false;
    m_tried.push_back(crossing.vertices);
    return true;
  }

  // A cell of a star takes about as long as to collect so many crossings.
  static constexpr std::size_t crossings_per_cell_of_star = 2;

  // Entities tried between two decreases of the number of crossings.
  static constexpr std::size_t max_number_of_attempts = N == 2 ? 8 : std::size_t(-1);

  const Tr& m_tr;
  Walk m_walk;
  Extend_star_3<Tr, Constraints> m_extend_star;
  std::vector<Cell_handle> m_cells;
  std::vector<Entity> m_tried;
  std::size_t m_max_number_of_shells = default_max_number_of_shells;
  bool m_was_cut_off = false;
  std::size_t m_work_in_crossings = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVER_CONSTRAINT_3_H
