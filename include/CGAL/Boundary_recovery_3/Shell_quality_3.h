// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_SHELL_QUALITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_SHELL_QUALITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>

#include <algorithm>
#include <limits>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a quality for which all covering meshes are equal, so that the covering mesh of the smallest degree wins.
 *
 * \cgalModels{ShellQuality_3}
 */
struct No_shell_quality_3
{
  typedef bool Value;                              ///< there is only one value
  static constexpr bool is_first_in_vector = false; ///< the vector is \f$ [Q', Q'', Q] \f$

  /// \name Values
  /// All of them are equal.
  /// @{

  /// returns the value.
  Value best() const { return true; }

  /// returns the value.
  Value combine(Value, Value) const { return true; }

  /// returns the value.
  template <typename Shell> Value of_triangle(const Shell&, int, int, int) const { return true; }

  /// returns the value.
  template <typename Shell> Value of_chord(const Shell&, int, int) const { return true; }

  /// returns the value.
  template <typename Shell> Value of_core_edge(const Shell&, int, int) const { return true; }

  /// returns the value.
  template <typename Shell> Value of_core_vertex(const Shell&, int) const { return true; }

  /// returns the value.
  template <typename Shell> Value of_supporting_edge(const Shell&) const { return true; }
  /// @}
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the quality `Q_1` of [CZZ+17, Eq.\ 5]: the quality of the worst tetrahedron.
 *
 * The quality of a tetrahedron of volume \f$ V \f$ and edge lengths \f$ l_i \f$ is
 * \f$ 72 \sqrt{3} \, V / (\sum l_i^2)^{3/2} \f$, which is 1 for the regular tetrahedron, tends to 0 for flat
 * tetrahedra, and does not change with scale. It is computed with doubles: it ranks valid tetrahedra, and does not
 * decide on validity. Infinite cells do not count.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`
 *
 * \cgalModels{ShellQuality_3}
 */
template <typename Tr>
class Worst_element_quality_3
{
public:
  typedef double Value;                             ///< the value type
  typedef Shell_3<Tr> Shell;                        ///< the shell type
  typedef typename Tr::Vertex_handle Vertex_handle; ///< the vertex handle of the triangulation
  static constexpr bool is_first_in_vector = false; ///< the vector is \f$ [Q', Q'', Q_1] \f$

  /// a quality for the shells of `tr`
  explicit Worst_element_quality_3(const Tr& tr) : m_predicates(tr) { }

  /// the value of an empty mesh
  Value best() const { return (std::numeric_limits<double>::max)(); }

  /// the value of the union of two meshes
  Value combine(const Value x, const Value y) const { return (std::min)(x, y); }

  /// the value of the tetrahedra between the triangle `p_i p_k p_j` and the ends of the supporting edge
  Value of_triangle(const Shell& s, const int i, const int k, const int j) const
  {
    return combine(of_tetrahedron(s.vertex(i), s.vertex(k), s.vertex(j), s.b()),
                   of_tetrahedron(s.vertex(i), s.vertex(j), s.vertex(k), s.a()));
  }

  /// the value of the tetrahedron `a b p_i p_j`
  Value of_core_edge(const Shell& s, const int i, const int j) const
  {
    return of_tetrahedron(s.a(), s.b(), s.vertex(i), s.vertex(j));
  }

  /// \name Faces and Edges
  /// They do not count.
  /// @{

  /// returns `best()`.
  Value of_chord(const Shell&, int, int) const { return best(); }

  /// returns `best()`.
  Value of_core_vertex(const Shell&, int) const { return best(); }

  /// returns `best()`.
  Value of_supporting_edge(const Shell&) const { return best(); }
  /// @}

  /// the quality of the positively oriented tetrahedron `pqrs`; at least the smallest positive double
  Value of_tetrahedron(const Vertex_handle p, const Vertex_handle q,
                       const Vertex_handle r, const Vertex_handle s) const
  {
    if(m_predicates.is_infinite(p) || m_predicates.is_infinite(q) ||
       m_predicates.is_infinite(r) || m_predicates.is_infinite(s))
      return best();
    return of_points(m_predicates.approximate_point(p), m_predicates.approximate_point(q),
                     m_predicates.approximate_point(r), m_predicates.approximate_point(s));
  }

private:
  typedef typename internal::Vertex_predicates_3<Tr>::Approximate_point Point;

  static Value of_points(const Point& p, const Point& q, const Point& r, const Point& s)
  {
    const internal::Cell_corners_3 corners = {{ internal::coordinates_of(p), internal::coordinates_of(q),
                                                internal::coordinates_of(r), internal::coordinates_of(s) }};
    const double quality = internal::mean_ratio(internal::volume_times_6(corners),
                                                internal::sum_of_squares_of_edges(corners));
    return quality > 0 ? quality : (std::numeric_limits<double>::min)(); // rounding only: the element is valid
  }

  internal::Vertex_predicates_3<Tr> m_predicates;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the quality `Q_2` of [CZZ+17, Eq.\ 6]: the fewer intersections with lost constraints, the better.
 *
 * Intersections are counted once for each edge and face inside the shell. The paper divides the count of an edge or
 * face among its tetrahedra; the sums are the same.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`
 * \tparam Counter has member functions `number_of_crossings(u, v)` and `number_of_crossings(u, v, w)`, which return the
 *         number of lost constraints that cross the mesh edge `uv`, or the mesh face `uvw`, in relative interiors
 *
 * \cgalModels{ShellQuality_3}
 */
template <typename Tr, typename Counter>
class Fewest_intersections_quality_3
{
public:
  typedef int Value;                               ///< minus the number of intersections
  typedef Shell_3<Tr> Shell;                       ///< the shell type
  static constexpr bool is_first_in_vector = true; ///< the vector is \f$ [Q_2, Q', Q''] \f$

  /// a quality that counts with `counter`, which must outlive the quality
  explicit Fewest_intersections_quality_3(Counter& counter) : m_counter(&counter) { }

  /// the value of an empty mesh
  Value best() const { return 0; }

  /// the value of the union of two meshes
  Value combine(const Value x, const Value y) const { return x + y; }

  /// the value of the face `p_i p_k p_j`
  Value of_triangle(const Shell& s, const int i, const int k, const int j) const
  {
    if(i == s.infinite_index() || k == s.infinite_index() || j == s.infinite_index())
      return 0;
    return - m_counter->number_of_crossings(s.vertex(i), s.vertex(k), s.vertex(j));
  }

  /// the value of the edge `p_i p_j` and of its faces with `a` and with `b`
  Value of_chord(const Shell& s, const int i, const int j) const
  {
    return - m_counter->number_of_crossings(s.vertex(i), s.vertex(j))
           - m_counter->number_of_crossings(s.a(), s.vertex(i), s.vertex(j))
           - m_counter->number_of_crossings(s.b(), s.vertex(i), s.vertex(j));
  }

  /// tetrahedra have no intersections of their own
  Value of_core_edge(const Shell&, int, int) const { return 0; }

  /// the value of the face `a b p_i`
  Value of_core_vertex(const Shell& s, const int i) const
  {
    return i == s.infinite_index() ? 0 : - m_counter->number_of_crossings(s.a(), s.b(), s.vertex(i));
  }

  /// the value of the edge `ab`
  Value of_supporting_edge(const Shell& s) const { return - m_counter->number_of_crossings(s.a(), s.b()); }

private:
  Counter* m_counter;
};

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_SHELL_QUALITY_3_H
