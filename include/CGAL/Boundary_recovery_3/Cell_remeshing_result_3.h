// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_CELL_REMESHING_RESULT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_CELL_REMESHING_RESULT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>

#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief what `CGAL::remesh_cells()` returns: the new mesh as arrays, too, with its vertices and cells in the
 * triangulation, and an account.
 *
 * Old positions are those in the order of `finite_vertex_handles()` and `finite_cell_handles()` before the call. The
 * arrays have all finite cells, those outside of the domain with the region 0.
 *
 * \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, or of a class derived from it
 */
template <typename Triangulation_>
struct Cell_remeshing_result_3
  : public Hole_remeshing_result_3<typename Triangulation_::Geom_traits::Point_3>
{
  typedef Triangulation_                         Triangulation; ///< the triangulation type
  typedef typename Triangulation::Vertex_handle  Vertex_handle; ///< its vertex handle
  typedef typename Triangulation::Cell_handle    Cell_handle;   ///< its cell handle

  std::vector<Vertex_handle> vertices; ///< the vertex of the triangulation for each one of `points`
  std::vector<Cell_handle> cells;      ///< the cell of the triangulation for each one of `tetrahedra`
};

} // namespace Boundary_recovery_3

using Boundary_recovery_3::Cell_remeshing_result_3;

} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_CELL_REMESHING_RESULT_3_H
