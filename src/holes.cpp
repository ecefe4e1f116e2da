// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The remeshing of holes.

#include <CGAL/Boundary_recovery_3/internal/holes/Remesh_holes_3.h>

namespace CGAL::Boundary_recovery_3::internal {

template void Remesh_holes_3<Standard_kernel>::operator()();

} // namespace CGAL::Boundary_recovery_3::internal
