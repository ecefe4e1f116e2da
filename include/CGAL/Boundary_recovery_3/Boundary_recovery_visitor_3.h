// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_RECOVERY_VISITOR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_RECOVERY_VISITOR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Cell_replacement_visitor_3.h>

#include <cstddef>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a visitor that does nothing; derive from it to watch or to stop a boundary recovery.
 *
 * Pass it with `CGAL::parameters::visitor(std::ref(v))`, else a copy of it is called.
 *
 * \cgalModels{BoundaryRecoveryVisitor_3}
 */
struct Default_boundary_recovery_visitor_3
  : public Default_cell_replacement_visitor_3
{
  /// is called before a phase starts.
  void on_phase_begin(Boundary_recovery_3::Recovery_phase /* phase */) { }

  /// is called after a phase ended.
  void on_phase_end(const Boundary_recovery_3::Phase_report& /* report */) { }

  /// is called inside a phase whenever one more item was treated: `done` of `total` lost constraints of the current
  /// pass, or of its Steiner points.
  void on_progress(Boundary_recovery_3::Recovery_phase /* phase */, std::size_t /* done */, std::size_t /* total */) { }

  /// is asked at a steady rate; once it returned `false`, the recovery stops soon, with a valid triangulation.
  bool go_further() { return true; }
};

} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_RECOVERY_VISITOR_3_H
