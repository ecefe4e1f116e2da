// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The recovery in Delaunay triangulations.

#include <CGAL/Boundary_recovery_3/internal/input/Recover_indexed_boundary.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_by_points_3.h>

namespace CGAL::Boundary_recovery_3::internal {

template bool
Recover_by_points_3<Standard_delaunay>::operator()(Recovery_mode, int, std::size_t, Recovery_effort);

template Boundary_recovery_result_3<Standard_delaunay>
Recover_indexed_boundary<Standard_delaunay, Standard_kernel>::operator()(
  std::vector<Standard_delaunay::Vertex_handle>);

} // namespace CGAL::Boundary_recovery_3::internal
