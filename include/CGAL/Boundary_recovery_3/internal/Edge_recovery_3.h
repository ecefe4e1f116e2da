// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_EDGE_RECOVERY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_EDGE_RECOVERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Constraint_recovery_3.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

template <typename Tr>
using Edge_recovery_3 = Constraint_recovery_3<Tr, 2>;

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_EDGE_RECOVERY_3_H
