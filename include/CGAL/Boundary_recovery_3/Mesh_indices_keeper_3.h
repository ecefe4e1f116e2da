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
 * Each new cell gets the `subdomain_index()` of the place that it fills, and the facets of new cells get the
 * `surface_patch_index()` of the facets that they are, or are a part of. So regions and marked facets survive what
 * changes the triangulation, as long as the facets between regions, and the marked ones, are constraints, which are
 * split at most:
 *
 * - A facet of the old cells that is still there keeps its mark, and the regions on both sides.
 * - If an edge or a facet was split by a vertex, the parts of a facet have its mark, and the regions on both sides.
 * - Cells without such facets have the region of those beside them.
 * - A facet that is new between two regions gets the mark that all the facets between the two regions had that are
 *   gone, if that was the same one.
 * - Infinite cells have the region that infinite cells had.
 *
 * If facets between regions are destroyed otherwise, the old facets of a new cell may have different regions on its
 * side. It gets the region of most of them; if these are equally many, that of the facet that was first met in the old
 * cells. A cell without old facets that is beside several regions gets the one that reaches it in the fewest steps,
 * from the first of these cells. `number_of_ambiguous_cells()` counts them all.
 *
 * What comes by point insertion is not announced to visitors, and is not treated. Nor are the data of vertices.
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

  /// a visitor for the triangulation `tr`, which has to outlive it
  explicit Mesh_indices_keeper_3(const Tr& tr) : m_transfer(tr) { }

  /// remembers the indices of the cells that go.
  template <typename CellRange>
  void before_cells_removal(const CellRange& cells) { m_transfer.collect(cells); }

  /// gives them to the cells that come.
  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { m_transfer.distribute(cells); }

  /// returns how many new cells there were up to now whose region was not clear.
  std::size_t number_of_ambiguous_cells() const { return m_transfer.number_of_ambiguous_cells(); }

private:
  internal::Mesh_index_transfer_3<Tr> m_transfer;
};

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_MESH_INDICES_KEEPER_3_H
