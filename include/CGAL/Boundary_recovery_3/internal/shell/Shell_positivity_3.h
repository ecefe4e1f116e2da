// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_SHELL_POSITIVITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_SHELL_POSITIVITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>

#include <CGAL/enum.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Geometric validity of the elements that a partial triangulation of the skirt polygon of a shell stands for.
 *
 * The infinite vertex may be an ear of the skirt polygon only, and only if the two facets of the convex hull at ab are
 * coplanar and form a strictly convex quadrilateral: then exchanging its diagonals leaves the hull as it is.
 */
template <typename Tr>
class Shell_positivity_3
{
public:
  typedef Shell_3<Tr>              Shell;
  typedef Vertex_predicates_3<Tr>  Predicates;

  Shell_positivity_3(const Shell& shell, const Predicates& predicates)
    : m_shell(shell), m_predicates(predicates)
  { }

  // Whether conv(t,a) and conv(t,b) are positive for t = p_i p_k p_j.
  bool is_triangle_positive(const int i, const int k, const int j) const
  {
    const int h = m_shell.infinite_index();
    if(h == i || h == k || h == j)
      return (h == k && is_hull_ear(i, h, j)) || (h == i && is_hull_ear(j, h, k)) || (h == j && is_hull_ear(k, h, i));
    return m_predicates.orientation(m_shell.vertex(i), m_shell.vertex(k), m_shell.vertex(j), m_shell.b()) == POSITIVE
        && m_predicates.orientation(m_shell.vertex(i), m_shell.vertex(k), m_shell.vertex(j), m_shell.a()) == NEGATIVE;
  }

  // Whether the tetrahedron a b p_i p_j of a core is positive.
  bool is_core_edge_positive(const int i, const int j) const
  {
    if(j == m_shell.next(i))
      return true;
    const int h = m_shell.infinite_index();
    return h != i && h != j
        && m_predicates.orientation(m_shell.a(), m_shell.b(), m_shell.vertex(i), m_shell.vertex(j)) == POSITIVE;
  }

private:
  bool is_hull_ear(const int i, const int h, const int j) const
  {
    return m_shell.next(i) == h && m_shell.next(h) == j
        && m_predicates.segments_cross(m_shell.a(), m_shell.b(), m_shell.vertex(i), m_shell.vertex(j));
  }

  const Shell& m_shell;
  const Predicates& m_predicates;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_SHELL_POSITIVITY_3_H
