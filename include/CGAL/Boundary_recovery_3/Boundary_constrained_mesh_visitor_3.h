// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_VISITOR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_VISITOR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_recovery_visitor_3.h>

#include <cstddef>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a visitor that does nothing; derive from it to watch or to stop the making of a mesh.
 *
 * Pass it with `CGAL::parameters::visitor(std::ref(v))`, else a copy of it is called.
 *
 * \cgalModels{BoundaryConstrainedMeshVisitor_3}
 */
struct Default_boundary_constrained_mesh_visitor_3
  : public Default_boundary_recovery_visitor_3
{
  using Default_boundary_recovery_visitor_3::on_phase_begin;
  using Default_boundary_recovery_visitor_3::on_phase_end;
  using Default_boundary_recovery_visitor_3::on_progress;

  /// is called before a phase starts.
  void on_phase_begin(Boundary_recovery_3::Meshing_phase /* phase */) { }

  /// is called after a phase ended.
  void on_phase_end(const Boundary_recovery_3::Meshing_phase_report& /* report */) { }

  /// is called inside a phase from time to time: about `done` of `total` is done. The quotient never falls.
  void on_progress(Boundary_recovery_3::Meshing_phase /* phase */, std::size_t /* done */, std::size_t /* total */) { }
};

} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_VISITOR_3_H
