// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The improvement of quality.

#include <CGAL/Boundary_recovery_3/internal/quality/Improve_quality_3.h>

namespace CGAL::Boundary_recovery_3::internal {

template void Improve_domain_3<Standard_mesh, Dihedral_angle_quality_3>::operator()();

template Quality_improvement_result_3<Standard_mesh>
Improve_quality_3<Standard_mesh, Dihedral_angle_quality_3>::operator()(double, Improvement_effort, double);

} // namespace CGAL::Boundary_recovery_3::internal
