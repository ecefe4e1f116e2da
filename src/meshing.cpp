// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The mesher, undivided and in sub-domains.

#include <CGAL/Boundary_recovery_3/internal/meshing/Boundary_constrained_meshing_3.h>

namespace CGAL::Boundary_recovery_3::internal {

template void Mesh_in_subdomains_3<Standard_mesh, Dihedral_angle_quality_3>::operator()(std::size_t, bool);

template Boundary_constrained_mesh_result_3<Standard_mesh>
Boundary_constrained_meshing_3<Standard_mesh, Dihedral_angle_quality_3>::operator()(
  const Surface_to_mesh_3<Standard_mesh>&, const Size_field_3<Standard_kernel::Point_3>*);

} // namespace CGAL::Boundary_recovery_3::internal
