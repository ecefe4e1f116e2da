// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_STANDARD_TYPES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_STANDARD_TYPES_H

#include <CGAL/license/Boundary_recovery_3.h>

// The target Boundary_recovery_3::compiled defines this macro. What is linked to it does not compile again what the
// library has for these types.
#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

// Both change what templates do.
#if defined(CGAL_LINKED_WITH_TBB) != defined(CGAL_BOUNDARY_RECOVERY_3_COMPILED_WITH_TBB) \
    || defined(CGAL_METIS_ENABLED) != defined(CGAL_BOUNDARY_RECOVERY_3_COMPILED_WITH_METIS)
#error "With Boundary_recovery_3::compiled, the TBB and METIS are to be used if, and only if, the library has them."
#endif

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace CGAL::Boundary_recovery_3::internal {

typedef Exact_predicates_inexact_constructions_kernel                    Standard_kernel;
typedef Delaunay_triangulation_3<Standard_kernel>                        Standard_delaunay;
typedef Boundary_constrained_mesh_triangulation_3<Standard_kernel>::type Standard_mesh;

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_STANDARD_TYPES_H
