// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Field points.

#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>

namespace CGAL::Boundary_recovery_3::internal {

template Field_points_result_3<Standard_mesh>
Field_point_insertion_3<Standard_mesh>::operator()(std::size_t, double);

} // namespace CGAL::Boundary_recovery_3::internal
