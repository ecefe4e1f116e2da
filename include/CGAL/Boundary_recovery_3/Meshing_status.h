// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_MESHING_STATUS_H
#define CGAL_BOUNDARY_RECOVERY_3_MESHING_STATUS_H

#include <CGAL/license/Boundary_recovery_3.h>

namespace CGAL {
namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// how `CGAL::make_boundary_constrained_mesh_3()`, or one of its steps, ended.
enum class Meshing_status
{
  meshed,        ///< all that was asked for is done
  no_region,     ///< the surface is in the triangulation, but it bounds no region: there is nothing to be meshed
  incomplete,    ///< constraints are missing; they are listed in the result of the recovery. Nothing was meshed
  invalid_input, ///< the surface cannot be recovered by anybody, or a size is not a positive number, or an angle not
                 ///< possible; what is wrong is listed
  too_large,     ///< the mesh would take more vertices, or more memory, than allowed; the forecast tells how many. No
                 ///< field point was inserted, or if the first forecast was too low, no more than allowed
  stopped        ///< the visitor or the time limit ended the work early, with a valid mesh
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of a status, as it is spelled in the enumeration.
inline const char* to_string(const Meshing_status status)
{
  switch(status)
  {
    case Meshing_status::meshed:        return "meshed";
    case Meshing_status::no_region:     return "no_region";
    case Meshing_status::incomplete:    return "incomplete";
    case Meshing_status::invalid_input: return "invalid_input";
    case Meshing_status::too_large:     return "too_large";
    case Meshing_status::stopped:       return "stopped";
  }
  return "";
}

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_MESHING_STATUS_H
