// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_MESHING_VISITOR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_MESHING_VISITOR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>

#include <cstddef>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a visitor that does nothing; derive from it to watch or to stop the work, or to carry over data of cells.
 *
 * Pass `CGAL::parameters::visitor(std::ref(v))` to have the visitor `v` itself called; otherwise a copy is called.
 *
 * \cgalModels{MeshingVisitor_3}
 */
struct Default_meshing_visitor_3
{
  /// is called before a phase starts.
  void on_phase_begin(Boundary_recovery_3::Phase /* phase */) { }

  /// is called after a phase ended.
  void on_phase_end(const Boundary_recovery_3::Phase_report& /* report */) { }

  /// is called inside a phase from time to time: `done` of `total` items are done.
  void on_progress(Boundary_recovery_3::Phase /* phase */, std::size_t /* done */, std::size_t /* total */) { }

  /// is asked again and again. After the first `false`, the work stops soon, with a valid triangulation.
  bool go_further() { return true; }

  /// is called before a replacement removes the cells in `cells`, a range of cell handles, from the triangulation.
  /// Replacements by point insertion are not announced.
  template <typename CellRange>
  void before_cells_removal(const CellRange& /* cells */) { }

  /// is called after a replacement has put the cells in `cells`, a range of cell handles, into the triangulation, which
  /// is valid then. They cover the same space as the cells of the last `before_cells_removal()` that came from the same
  /// thread.
  template <typename CellRange>
  void after_cells_creation(const CellRange& /* cells */) { }
};

} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_MESHING_VISITOR_3_H
