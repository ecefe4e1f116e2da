// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_IMPROVE_MESH_QUALITY_H
#define CGAL_IMPROVE_MESH_QUALITY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_quality_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief improves the cells of a mesh until none has a dihedral angle below a target, or nothing helps; the surface
 * stays.
 *
 * This is step 7 of [CZZ+17, Section 4.1]. The worst cells come first: edges and facets are removed, vertices are
 * moved, inserted or removed. A change is made only if it improves the cells around it together, and leaves no cell
 * worse than the worst of them was. At the end, near the worst cells of the mesh, a few cells may get worse so that
 * others get better, but never worse than the worst cell of the mesh was.
 *
 * The triangulation may come from `insert_field_points()`, from CGAL's remeshing, or, by
 * `convert_to_triangulation_3()`, from Mesh_3. Constrained are the facets for which `is_facet_on_surface()` holds,
 * facets between cells of different `subdomain_index()`, and the edges of `edge_is_constrained_map`. These facets and
 * edges stay, with their vertices, and so do vertices whose `in_dimension()` is 0, 1 or 2. Other vertices may be moved
 * or removed. Handles of removed vertices and of cells become invalid.
 *
 * The result tells the reason for each cell that stays below the target: see
 * `Boundary_recovery_3::Quality_certificate_3`.
 *
 * Nothing is printed. The same input gives the same mesh, bit for bit, unless time is limited.
 *
 * \tparam Triangulation an instance of `Triangulation_3`, or of a class derived from it, whose vertices are models of
 *         `MeshVertexBase_3`, and whose cells are models of `MeshCellBase_3`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation
 * \param np an optional sequence of named parameters among the ones listed below. The named parameters of this package
 *        start a chain; several chains are passed one after the other.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{min_dihedral_angle}
 *     \cgalParamDescription{the target, in degrees: cells with a smaller dihedral angle are improved}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{25}
 *     \cgalParamExtra{The target has to be from 0 to 70.53, the angle of the regular tetrahedron. Above 25, many cells
 *                     will stay below it, and the work takes long.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{improvement_effort}
 *     \cgalParamDescription{the work that the improvement is worth}
 *     \cgalParamType{`CGAL::Boundary_recovery_3::Improvement_effort`}
 *     \cgalParamDefault{`Improvement_effort::normal`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{cell_quality}
 *     \cgalParamDescription{the measure of the quality of cells}
 *     \cgalParamType{a model of `CellQuality_3`}
 *     \cgalParamDefault{`Boundary_recovery_3::Dihedral_angle_quality_3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{cell_is_selected_map}
 *     \cgalParamDescription{the cells that may be replaced; the facets between them and others stay}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with `Triangulation::Cell_handle` as key type and `bool` as
 *                    value type}
 *     \cgalParamDefault{all cells in regions of the domain}
 *     \cgalParamExtra{The map is kept up to date: new cells are selected, and cells that go are not.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{edges that must stay, in addition to the edges of constrained facets}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `std::pair<Triangulation::Vertex_handle,
 *                    Triangulation::Vertex_handle>` as key type and `bool` as value type}
 *     \cgalParamDefault{no edge}
 *     \cgalParamExtra{It is asked for both orders of the vertices.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_number_of_vertices}
 *     \cgalParamDescription{the largest number of vertices of the triangulation: at the limit, the improvement works
 *                           without further vertices}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{no limit}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{how many threads may work at the same time, see `make_boundary_constrained_mesh_3()`}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{0, that is, as many as there are, if the triangulation has the concurrency tag
 *                       `CGAL::Parallel_tag`; else nothing is divided}
 *     \cgalParamExtra{Nothing is divided if cells are selected, or with `maximum_number_of_vertices`.
 *                     `edge_is_constrained_map` is read by several threads.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_running_time}
 *     \cgalParamDescription{the time in seconds after which the improvement stops soon, with a valid triangulation}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{no limit}
 *     \cgalParamExtra{The last figures and the certificate may take 0.15 seconds more. If they would take longer, they
 *                     are left out, and the result says so.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor, which is told of the phase `quality_improvement`, of progress, and of old and
 *                           new cells, and can stop the improvement}
 *     \cgalParamType{a model of `MeshingVisitor_3`}
 *     \cgalParamDefault{`Default_meshing_visitor_3`}
 *     \cgalParamExtra{Pass `std::ref(visitor)` to have the object itself called and not a copy.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the status, the quality before and after, the cells that are still below the target, and counts. The result
 *         converts to `true` iff the status is `meshed`. `invalid_input`: `min_dihedral_angle` is impossible; nothing
 *         was done. `stopped`: the improvement, or only its last measurements, were cut off; earlier changes stay, but
 *         the last figures and the certificate may be missing.
 *
 * \pre `tr` is valid.
 */
template <typename Triangulation, typename CGAL_NP_TEMPLATE_PARAMETERS>
Quality_improvement_result_3<Triangulation>
improve_mesh_quality(Triangulation& tr, const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace BR3 = Boundary_recovery_3::internal;

  auto domain = BR3::selected_domain(tr, np);
  auto visitor = BR3::mesh_visitor<Triangulation>(np);
  const auto quality = parameters::choose_parameter<Boundary_recovery_3::Dihedral_angle_quality_3>(
    parameters::get_parameter(np, BR3::cell_quality));
  const BR3::Improvement_options options = BR3::improvement_options<Triangulation>(np);
  BR3::Improve_quality_3<Triangulation, std::decay_t<decltype(quality)> >
    improve(tr, domain, quality, options.max_number_of_vertices, visitor);
  improve.set_concurrency(options.concurrency);
  return improve(options.min_dihedral_angle, options.effort, options.maximum_running_time);
}

#ifndef DOXYGEN_RUNNING

// Several chains of named parameters, one after the other.
template <typename Triangulation,
          typename T1, typename Tag1, typename Base1, typename T2, typename Tag2, typename Base2, typename ... NPs>
Quality_improvement_result_3<Triangulation>
improve_mesh_quality(Triangulation& tr, const Named_function_parameters<T1, Tag1, Base1>& np1,
                     const Named_function_parameters<T2, Tag2, Base2>& np2, const NPs& ... nps)
{
  return improve_mesh_quality(tr, Boundary_recovery_3::internal::merge_all(np1, np2, nps...));
}

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#endif // CGAL_IMPROVE_MESH_QUALITY_H
