// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_CELL_BASE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_CELL_BASE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Triangulation_cell_base_3.h>

#include <array>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a cell base with what CGAL's mesh packages want to know of a cell, and nothing else: the region that it is
 * in, and for each of its facets the patch of the surface that it is on.
 *
 * The members have the names, and the meaning, that they have in `MeshCellBase_3`, so that the same code takes cells of
 * triangulations over CGAL's own bases. A cell has 88 bytes over `Exact_predicates_inexact_constructions_kernel`,
 * without threads.
 *
 * \tparam GT the geometric traits
 * \tparam Cb the cell base that it is derived from
 *
 * \cgalModels{TriangulationCellBase_3}
 */
template <typename GT, typename Cb = Triangulation_cell_base_3<GT> >
class Boundary_constrained_mesh_cell_base_3
  : public Cb
{
public:
  typedef typename GT::FT FT;      ///< the number type of qualities
  typedef int Subdomain_index;     ///< the type of the number of a region
  typedef int Surface_patch_index; ///< the type of the number of a patch

  /// rebinds it to a triangulation data structure.
  template <typename TDS>
  struct Rebind_TDS
  {
    /// the rebound type
    typedef Boundary_constrained_mesh_cell_base_3<GT, typename Cb::template Rebind_TDS<TDS>::Other> Other;
  };

  using Cb::Cb;

  /// returns the region that the cell is in; 0: outside.
  Subdomain_index subdomain_index() const { return m_subdomain; }

  /// sets the region.
  void set_subdomain_index(const Subdomain_index index) { m_subdomain = index; }

  /// returns the patch that the facet opposite to the vertex `i` is on; 0: none.
  Surface_patch_index surface_patch_index(const int i) const { return m_patches[i]; }

  /// sets the patch of the facet opposite to the vertex `i`.
  void set_surface_patch_index(const int i, const Surface_patch_index index) { m_patches[i] = index; }

  /// returns whether the facet opposite to the vertex `i` is on the surface.
  bool is_facet_on_surface(const int i) const { return m_patches[i] != 0; }

  /// \name Qualities
  /// CGAL's remeshing wants to remember the quality of cells, and computes it again where that is not possible, as here.
  /// @{

  /// returns `false`.
  bool is_cache_valid() const { return false; }

  /// returns 0.
  FT sliver_value() const { return FT(0); }

  /// does nothing.
  void set_sliver_value(const FT& /* quality */) { }

  /// does nothing.
  void reset_cache_validity() const { }

  /// @}

private:
  Subdomain_index m_subdomain = 0;
  std::array<Surface_patch_index, 4> m_patches = {{ 0, 0, 0, 0 }};
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_CELL_BASE_3_H
