// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_REMESH_CELLS_H
#define CGAL_REMESH_CELLS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Remesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/remesh_holes.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {

namespace Boundary_recovery_3 {
namespace internal {

template <typename Tr, typename SizingField, typename NamedParameters>
Cell_remeshing_result_3<Tr> remesh_cells_of_triangulation(Tr& tr, const SizingField& size, const NamedParameters& np)
{
  return Remesh_triangulation_3<Tr, NamedParameters>(tr, np)(size);
}

} // namespace internal
} // namespace Boundary_recovery_3

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief replaces the bad cells of a triangulation whose vertices were moved, and some cells around them; everything
 * else stays.
 *
 * The work is that of `remesh_holes()`, on a triangulation with the indices of CGAL's mesh packages, as
 * `make_boundary_constrained_mesh_3()` and CGAL's remeshing leave it. Since then, vertices were moved by
 * `Vertex::set_point()`, so that the triangulation is no longer valid. The result is valid if its hull is convex.
 *
 * Constrained are the facets for which `is_facet_on_surface()` holds, facets between cells of different
 * `subdomain_index()`, facets of the hull, and the edges of `constrained_edges`. Other vertices may go. Cells outside
 * of the domain, in the region 0, are bad only if they are flat, inverted or selected; the new cells there have no
 * field points. Cells outside of the holes, and vertices that stay, keep their handles. New cells and vertices get
 * regions, patches and dimensions.
 *
 * \tparam Triangulation an instance of `Triangulation_3`, or of a class derived from it, whose vertices are models of
 *         `MeshVertexBase_3`, and whose cells are models of `MeshCellBase_3` with an integer as `Subdomain_index`
 * \tparam SizingField a number type, or a model of `MeshDomainField_3`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation
 * \param size the lengths of new edges, as for `insert_field_points()`. Without this argument, sizes are those of the
 *        old mesh at the same place.
 * \param np an optional sequence of named parameters: `min_dihedral_angle`, `number_of_layers`, `improve_quality`,
 *        `maximum_running_time` and `visitor` of `remesh_holes()`, and those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{cell_is_selected_map}
 *     \cgalParamDescription{cells that are bad, whatever their shape}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `Triangulation::Cell_handle` as key type and `bool` as value
 *                    type}
 *     \cgalParamDefault{no cell}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{constrained_edges}
 *     \cgalParamDescription{edges that stay, in addition to the edges of constrained facets}
 *     \cgalParamType{a `ConstRange` whose value type is an array of two vertex handles}
 *     \cgalParamDefault{no edges}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the status and counts, see `remesh_holes()`. If the status is not `meshed`, the triangulation is unchanged.
 *
 * \pre the dimension of `tr` is 3, and its data structure is valid: `tr.tds().is_valid()`.
 */
#ifdef DOXYGEN_RUNNING
template <typename Triangulation, typename SizingField,
          typename NamedParameters = parameters::Default_named_parameters>
Cell_remeshing_result_3<Triangulation>
remesh_cells(Triangulation& tr, const SizingField& size,
             const NamedParameters& np = parameters::default_values());
#else
template <typename Triangulation, typename SizingField, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_sizes<SizingField>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
Cell_remeshing_result_3<Triangulation>
remesh_cells(Triangulation& tr, const SizingField& size, const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::remesh_cells_of_triangulation(tr, size, BR3::merge_all(nps...));
}
#endif

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief replaces the bad cells of a triangulation whose vertices were moved, with the sizes of the old mesh.
 *
 * See the overload with a size field.
 */
#ifdef DOXYGEN_RUNNING
template <typename Triangulation, typename NamedParameters = parameters::Default_named_parameters>
Cell_remeshing_result_3<Triangulation>
remesh_cells(Triangulation& tr, const NamedParameters& np = parameters::default_values());
#else
template <typename Triangulation, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
Cell_remeshing_result_3<Triangulation> remesh_cells(Triangulation& tr, const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::remesh_cells_of_triangulation(tr, BR3::Sizes_of_old_mesh(), BR3::merge_all(nps...));
}
#endif

} // namespace CGAL

#endif // CGAL_REMESH_CELLS_H
