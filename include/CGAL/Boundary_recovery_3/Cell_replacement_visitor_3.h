// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_CELL_REPLACEMENT_VISITOR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_CELL_REPLACEMENT_VISITOR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a visitor of replacements of cells that does nothing; derive from it to carry over data that is attached to
 * cells.
 *
 * \cgalModels{CellReplacementVisitor_3}
 */
struct Default_cell_replacement_visitor_3
{
  /// is called before the cells in `cells`, a range of cell handles, are removed from the triangulation by a
  /// replacement; what point insertion replaces is not announced.
  template <typename CellRange>
  void before_cells_removal(const CellRange& /* cells */) { }

  /// is called after the cells in `cells`, a range of cell handles, came into the triangulation, which is valid then.
  /// They cover what the cells of the last `before_cells_removal()` covered.
  template <typename CellRange>
  void after_cells_creation(const CellRange& /* cells */) { }
};

} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_CELL_REPLACEMENT_VISITOR_3_H
