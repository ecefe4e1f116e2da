// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The recovery in triangulations that are meshed.

#include <CGAL/Boundary_recovery_3/internal/input/Recover_indexed_boundary.h>

namespace CGAL::Boundary_recovery_3::internal {

template Boundary_recovery_result_3<Standard_mesh>
Recover_indexed_boundary<Standard_mesh, Standard_kernel>::operator()(std::vector<Standard_mesh::Vertex_handle>);

} // namespace CGAL::Boundary_recovery_3::internal
