// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_PARTIAL_TRIANGULATION_H
#define CGAL_BOUNDARY_RECOVERY_3_PARTIAL_TRIANGULATION_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <boost/container/small_vector.hpp>

#include <array>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a partial triangulation of the skirt polygon of a shell, by positions in the polygon.
 *
 * It stands for a covering mesh: each triangle `p_i p_k p_j` for its tetrahedra with `a` and with `b`, each edge
 * `p_i p_j` of the core for the tetrahedron `a b p_i p_j`. Source: [CZZ+17, Section 3.1.1, Eq. 1].
 */
struct Partial_triangulation
{
  /// the vertices of the core, in increasing order; empty if the supporting edge disappears
  boost::container::small_vector<int, 16> core;

  /// the triangles `(i, k, j)` outside the core, in the cyclic order of the skirt polygon
  boost::container::small_vector<std::array<int, 3>, 16> triangles;

  /// the degree of the covering mesh
  int core_size() const { return static_cast<int>(core.size()); }
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_PARTIAL_TRIANGULATION_H
