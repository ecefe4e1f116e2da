// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_SHELL_VALIDITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_SHELL_VALIDITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>

#include <CGAL/enum.h>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a validity condition that allows everything; no edge and no facet is constrained.
 *
 * It is the base class of conditions that hide some of its members.
 *
 * \cgalModels{ShellValidity_3}
 */
struct No_shell_validity_3
{
  /// \name Conditions
  /// All of them hold.
  /// @{

  /// returns `true`.
  template <typename Shell> bool is_valid_triangle(const Shell&, int, int, int) const { return true; }

  /// returns `true`.
  template <typename Shell> bool is_valid_chord(const Shell&, int, int) const { return true; }

  /// returns `true`.
  template <typename Shell>
  bool is_valid_covering_mesh(const Shell&, const Partial_triangulation&) const { return true; }
  /// @}

  /// \name Constraints
  /// There are none.
  /// @{

  /// returns `false`.
  template <typename Vertex_handle> bool is_constrained(Vertex_handle, Vertex_handle) const { return false; }

  /// returns `false`.
  template <typename Vertex_handle>
  bool is_constrained(Vertex_handle, Vertex_handle, Vertex_handle) const { return false; }
  /// @}
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the conjunction of two validity conditions.
 *
 * \tparam Validity_1 a model of `ShellValidity_3`
 * \tparam Validity_2 a model of `ShellValidity_3`
 *
 * \cgalModels{ShellValidity_3}
 */
template <typename Validity_1, typename Validity_2>
class Shell_validity_conjunction_3
{
public:
  /// the conjunction of `v1` and `v2`
  Shell_validity_conjunction_3(const Validity_1& v1, const Validity_2& v2) : m_v1(v1), m_v2(v2) { }

  /// \name Conditions
  /// @{

  /// returns whether both allow the new face \f$ p_i p_k p_j \f$ of the shell `s`.
  template <typename Shell> bool is_valid_triangle(const Shell& s, const int i, const int k, const int j) const
  {
    return m_v1.is_valid_triangle(s, i, k, j) && m_v2.is_valid_triangle(s, i, k, j);
  }

  /// returns whether both allow the new edge \f$ p_i p_j \f$ and its faces.
  template <typename Shell> bool is_valid_chord(const Shell& s, const int i, const int j) const
  {
    return m_v1.is_valid_chord(s, i, j) && m_v2.is_valid_chord(s, i, j);
  }

  /// returns whether both allow the covering mesh of `k`.
  template <typename Shell> bool is_valid_covering_mesh(const Shell& s, const Partial_triangulation& k) const
  {
    return m_v1.is_valid_covering_mesh(s, k) && m_v2.is_valid_covering_mesh(s, k);
  }
  /// @}

  /// \name Constraints
  /// A simplex is constrained if one of the conditions says so.
  /// @{

  /// returns whether one of the conditions keeps the edge `uv`.
  template <typename Vertex_handle>
  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const
  {
    return m_v1.is_constrained(u, v) || m_v2.is_constrained(u, v);
  }

  /// returns whether one of the conditions keeps the facet `uvw`.
  template <typename Vertex_handle>
  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    return m_v1.is_constrained(u, v, w) || m_v2.is_constrained(u, v, w);
  }
  /// @}

private:
  Validity_1 m_v1;
  Validity_2 m_v2;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the condition that keeps given edges and facets.
 *
 * \tparam Constraints a class with the members `is_constrained(u, v)` and `is_constrained(u, v, w)` for vertex handles
 *
 * \cgalModels{ShellValidity_3}
 */
template <typename Constraints>
class Kept_constraints_3
  : public No_shell_validity_3
{
public:
  /// keeps the constraints in `constraints`, which must outlive this object
  explicit Kept_constraints_3(const Constraints& constraints) : m_constraints(&constraints) { }

  /// \name Constraints
  /// @{

  /// returns whether the edge `uv` is a constraint.
  template <typename Vertex_handle>
  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const
  {
    return m_constraints->is_constrained(u, v);
  }

  /// returns whether the facet `uvw` is a constraint.
  template <typename Vertex_handle>
  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    return m_constraints->is_constrained(u, v, w);
  }
  /// @}

private:
  const Constraints* m_constraints;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief condition BRC1 of [CZZ+17, Section 3.2]: no new mesh entity intersects a given segment.
 *
 * Intersections are transversal and in relative interiors: the segment crosses a new edge, or pierces a new face, in a
 * point inside both. A face in a plane with the segment does not count, but its edges do where the segment crosses
 * them.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`
 *
 * \cgalModels{ShellValidity_3}
 */
template <typename Tr>
class BRC1
  : public No_shell_validity_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle; ///< the vertex handle of the triangulation
  typedef Shell_3<Tr> Shell;                        ///< the shell type

  /// a condition for the triangulation `tr` and the segment from `u` to `v`
  BRC1(const Tr& tr, const Vertex_handle u, const Vertex_handle v) : m_predicates(tr), m_u(u), m_v(v) { }

#ifndef DOXYGEN_RUNNING
  // As above, with predicates that know the exact positions of some vertices.
  BRC1(const internal::Vertex_predicates_3<Tr>& predicates, const Vertex_handle u, const Vertex_handle v)
    : m_predicates(predicates), m_u(u), m_v(v)
  { }
#endif

  /// \name Conditions
  /// @{

  /// returns whether the segment does not pierce the new face \f$ p_i p_k p_j \f$.
  bool is_valid_triangle(const Shell& s, const int i, const int k, const int j) const
  {
    return i == s.infinite_index() || k == s.infinite_index() || j == s.infinite_index()
        || ! is_pierced(s.vertex(i), s.vertex(k), s.vertex(j));
  }

  /// returns whether the segment neither crosses the new edge \f$ p_i p_j \f$ nor pierces its faces with `a` and `b`.
  bool is_valid_chord(const Shell& s, const int i, const int j) const
  {
    const Vertex_handle p = s.vertex(i), q = s.vertex(j);
    if(p == m_u || p == m_v || q == m_u || q == m_v)
      return true;
    // either everything is in a plane, where only the edge can be crossed, or the edge is not
    const Orientation side = m_predicates.orientation(m_u, m_v, p, q);
    return side == COPLANAR ? ! m_predicates.coplanar_segments_cross(m_u, m_v, p, q)
                            : ! is_pierced(side, p, q, s.a()) && ! is_pierced(side, p, q, s.b());
  }
  /// @}

private:
  bool is_pierced(const Vertex_handle p, const Vertex_handle q, const Vertex_handle r) const
  {
    return m_predicates.segment_pierces_triangle(m_u, m_v, p, q, r);
  }

  // The same for a face whose edge pq is on this side of the segment, which starts and ends at neither p nor q.
  bool is_pierced(const Orientation side, const Vertex_handle p, const Vertex_handle q, const Vertex_handle r) const
  {
    return r != m_u && r != m_v && m_predicates.segment_pierces_triangle_beside(side, m_u, m_v, p, q, r);
  }

  internal::Vertex_predicates_3<Tr> m_predicates;
  Vertex_handle m_u, m_v;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief condition BRC2 of [CZZ+17, Section 3.2]: no new mesh entity intersects a given triangle.
 *
 * The edges of the triangle are edges of the mesh, so only mesh edges can intersect the triangle.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`
 *
 * \cgalModels{ShellValidity_3}
 */
template <typename Tr>
class BRC2
  : public No_shell_validity_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle; ///< the vertex handle of the triangulation
  typedef Shell_3<Tr> Shell;                        ///< the shell type

  /// a condition for the triangulation `tr` and the triangle `uvw`
  BRC2(const Tr& tr, const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
    : m_predicates(tr), m_u(u), m_v(v), m_w(w)
  { }

#ifndef DOXYGEN_RUNNING
  // As above, with predicates that know the exact positions of some vertices.
  BRC2(const internal::Vertex_predicates_3<Tr>& predicates,
       const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
    : m_predicates(predicates), m_u(u), m_v(v), m_w(w)
  { }
#endif

  /// \name Conditions
  /// @{

  /// returns whether the new edge \f$ p_i p_j \f$ does not pierce the triangle.
  bool is_valid_chord(const Shell& s, const int i, const int j) const
  {
    return ! m_predicates.segment_pierces_triangle(s.vertex(i), s.vertex(j), m_u, m_v, m_w);
  }
  /// @}

private:
  internal::Vertex_predicates_3<Tr> m_predicates;
  Vertex_handle m_u, m_v, m_w;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief conditions BRC3 and BRC4 of [CZZ+17, Section 3.2]: the number of intersections with all lost edges (BRC3) or
 * with all lost facets (BRC4) does not grow.
 *
 * The condition judges the best covering mesh as a whole. With `Fewest_intersections_quality_3` and the same counter,
 * the best covering mesh always meets the condition. With another quality, the transformation may be given up although
 * a worse covering mesh would meet the condition.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`
 * \tparam Counter as in `Fewest_intersections_quality_3`, for lost edges (BRC3) or for lost facets (BRC4)
 *
 * \cgalModels{ShellValidity_3}
 */
template <typename Tr, typename Counter>
class BRC3
  : public No_shell_validity_3
{
public:
  typedef Shell_3<Tr> Shell; ///< the shell type

  /// a condition that counts with `counter`, which must outlive this object
  explicit BRC3(Counter& counter) : m_quality(counter) { }

  /// \name Conditions
  /// @{

  /// returns whether the covering mesh of `k` has no more intersections than the present one.
  bool is_valid_covering_mesh(const Shell& s, const Partial_triangulation& k) const
  {
    return number_of_intersections(s, k) <= number_of_intersections(s);
  }
  /// @}

  /// the number of intersections inside the shell with its present covering mesh
  int number_of_intersections(const Shell& s) const
  {
    int q = m_quality.of_supporting_edge(s);
    for(int i = 0; i < s.degree(); ++i)
      q += m_quality.of_core_vertex(s, i);
    return - q;
  }

  /// the number of intersections inside the shell with the covering mesh `k`
  int number_of_intersections(const Shell& s, const Partial_triangulation& k) const
  {
    int q = k.core.empty() ? 0 : m_quality.of_supporting_edge(s);
    for(const int i : k.core)
      q += m_quality.of_core_vertex(s, i);
    for(const auto& t : k.triangles)
    {
      q += m_quality.of_triangle(s, t[0], t[1], t[2]);
      if(t[2] != s.previous(t[0])) // each ring but the whole skirt polygon is closed by a chord
        q += m_quality.of_chord(s, t[0], t[2]);
    }
    return - q;
  }

private:
  Fewest_intersections_quality_3<Tr, Counter> m_quality;
};

/// \ingroup PkgBoundaryRecovery3Classes
/// condition BRC4 is BRC3 with a counter of the intersections with lost facets.
template <typename Tr, typename Counter>
using BRC4 = BRC3<Tr, Counter>;

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_SHELL_VALIDITY_3_H
