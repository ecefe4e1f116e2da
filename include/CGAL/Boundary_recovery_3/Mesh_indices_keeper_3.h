// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_MESH_INDICES_KEEPER_3_H
#define CGAL_BOUNDARY_RECOVERY_3_MESH_INDICES_KEEPER_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_index_transfer_3.h>

#include <cstddef>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a visitor that keeps the indices of CGAL's mesh cells while cells are replaced.
 *
 * Each new cell gets the `subdomain_index()` of the place that it fills, and each facet of a new cell gets the
 * `surface_patch_index()` of the old facet that it is, or is a part of. Regions and marks of facets survive all changes
 * of the triangulation, as long as marked facets and facets between regions are constraints, which can be split, but
 * not destroyed:
 *
 * - A facet of the old cells that is still there keeps its mark, and the regions on both sides.
 * - If a vertex splits a facet, or an edge of it, the parts have the mark of the facet, and the regions on both sides.
 * - Cells without such facets have the region of the cells beside them.
 * - A new facet between two regions gets the mark of the facets between these regions that are gone, if these had the
 *   same mark.
 * - Infinite cells keep the region of infinite cells.
 *
 * If facets between regions are destroyed all the same, the old facets of a new cell may have different regions on its
 * side. The cell gets the region of most of these facets; of equally many, the region of the facet that comes first in
 * the old cells. A cell without old facets beside several regions gets the region that reaches it in the fewest steps
 * from the first of these cells. `number_of_ambiguous_cells()` counts both kinds.
 *
 * Cells that come by point insertion are not announced to visitors, and not treated. Data of vertices are not treated
 * either. The keeper is for functions that change the mesh by one thread.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`, or of a class derived from it, whose cell type is a model of
 * `MeshCellBase_3`, such as that of `CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3`
 *
 * \cgalModels{MeshingVisitor_3}
 */
template <typename Tr>
class Mesh_indices_keeper_3
  : public Default_meshing_visitor_3
{
public:
  typedef Tr Triangulation; ///< the triangulation type

  /// a visitor for the triangulation `tr`, which must outlive the visitor
  explicit Mesh_indices_keeper_3(const Tr& tr) : m_transfer(tr) { }

  /// remembers the indices of the old cells.
  template <typename CellRange>
  void before_cells_removal(const CellRange& cells) { m_transfer.collect(cells); }

  /// gives indices to the new cells.
  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { m_transfer.distribute(cells); }

  /// returns the number of new cells, up to now, with an ambiguous region.
  std::size_t number_of_ambiguous_cells() const { return m_transfer.number_of_ambiguous_cells(); }

private:
  internal::Mesh_index_transfer_3<Tr> m_transfer;
};

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_MESH_INDICES_KEEPER_3_H
