// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_INSERT_FIELD_POINTS_H
#define CGAL_INSERT_FIELD_POINTS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief inserts points into the regions of a domain until its cells have given sizes; the surface stays.
 *
 * This is step 6 of [CZZ+17, Section 4.1]. A cell is too large if its circumradius is longer than 0.75 times the size
 * at its centroid, so edges of other cells are shorter than 1.5 times the size. A cell that is too large gets a point
 * at its circumcenter, or else at its centroid, unless a vertex is nearer than 0.7 times the size. The point is
 * inserted by the Bowyer-Watson algorithm in the region of the cell: constrained facets and edges, and facets between
 * regions, are neither crossed nor split. Beside triangles of the surface that are larger than the size, cells are
 * larger, too. No points are inserted within 1.5 times the size of much larger triangles, since these points would make
 * flat cells. At the end, inner edges that are still far too long are removed, or get a point in the middle, unless a
 * vertex is nearer than 0.4 times the size.
 *
 * The triangulation may come from `mark_domain()`, from CGAL's remeshing, or, by `convert_to_triangulation_3()`, from
 * Mesh_3; the weights of points do not matter. Constrained are the facets for which `is_facet_on_surface()` holds,
 * facets between cells of different `subdomain_index()`, and the edges of `edge_is_constrained_map`. New cells get the
 * region of their place; new vertices get the dimension 3 and this region as index. If vertices have a member
 * `meshing_info()`, it has the sizes at the vertices afterwards, which are smaller beside finer walls.
 *
 * Nothing is printed. An exception of the size field is caught, and ends the work with the status `invalid_input`.
 *
 * \tparam Triangulation an instance of `Triangulation_3`, or of a class derived from it, whose cells are models of
 *         `MeshCellBase_3`
 * \tparam SizingField a number type, or a model of `MeshDomainField_3`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation
 * \param size the lengths of edges inside, in the unit of the coordinates: a number, or a function object that is
 *        called with a point, or with a point, the dimension 3 and the number of a region, and returns a positive
 *        number. An optional member function `grading()` returns the largest growth of sizes per length; with it, the
 *        field is called far more seldom. An optional member function `least_size_around(p, radius, index)`, `const`,
 *        returns a lower bound for the sizes within the distance `radius` of `p` in the region `index`. The bound must
 *        come near to the size at `p` when `radius` is small; 0 means that nothing is known. With one of these
 *        functions, small sizes between large ones are found, unless `grading()` is so large that the calls would have
 *        no end; `Field_points_result_3::is_field_resolved` tells. The field is called in the regions of the domain
 *        only, up to rounding. Where walls are finer than the size, edges are shorter, see
 *        \ref BR3_sizes.
 * \param np an optional sequence of named parameters among the ones listed below. `maximum_number_of_vertices` starts a
 *        chain; several chains are passed one after the other.
 *
 * \cgalNamedParamsBegin
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
 *     \cgalParamDescription{the largest number of vertices of the triangulation}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{no limit but that of the memory}
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
 *     \cgalParamDescription{the time in seconds after which the insertion stops soon, with a valid triangulation}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{no limit}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor, which is told of the phases `forecast` and `field_point_insertion`, of progress,
 *                           and of old and new cells, and can stop the insertion}
 *     \cgalParamType{a model of `MeshingVisitor_3`}
 *     \cgalParamDefault{`Default_meshing_visitor_3`}
 *     \cgalParamExtra{Pass `std::ref(visitor)` to have the object itself called and not a copy.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the status, the forecast, and counts. The result converts to `true` iff the status is `meshed`.
 *         `invalid_input`: the field had no positive finite size at a place, which is in the result; earlier points
 *         stay. `too_large`: the mesh needs more vertices than allowed, or more memory than there is; no point was
 *         inserted or, if the forecast was too low, as many points as allowed. `stopped`: earlier points stay.
 *
 * \pre `tr` is valid, and constrained facets or facets to other regions bound the cells of each region.
 */
template <typename Triangulation, typename SizingField, typename CGAL_NP_TEMPLATE_PARAMETERS>
Field_points_result_3<Triangulation>
insert_field_points(Triangulation& tr, const SizingField& size, const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace BR3 = Boundary_recovery_3::internal;
  auto domain = BR3::selected_domain(tr, np);
  auto visitor = BR3::mesh_visitor<Triangulation>(np);
  const auto max_number_of_vertices = BR3::parameter_or(np, BR3::maximum_number_of_vertices,
                                                        (std::numeric_limits<std::size_t>::max)());
  const auto maximum_running_time = BR3::parameter_or(np, internal_np::maximum_running_time,
                                                      std::numeric_limits<double>::infinity());
  const BR3::Any_size_field_3<typename Triangulation::Geom_traits, SizingField> any_size(size);
  BR3::Field_point_insertion_3<Triangulation> insert(tr, domain, any_size, visitor);
  insert.set_concurrency(BR3::concurrency<Triangulation>(np));
  return insert(max_number_of_vertices, maximum_running_time);
}

#ifndef DOXYGEN_RUNNING

// Several chains of named parameters, one after the other.
template <typename Triangulation, typename SizingField,
          typename T1, typename Tag1, typename Base1, typename T2, typename Tag2, typename Base2, typename ... NPs>
Field_points_result_3<Triangulation>
insert_field_points(Triangulation& tr, const SizingField& size,
                    const Named_function_parameters<T1, Tag1, Base1>& np1,
                    const Named_function_parameters<T2, Tag2, Base2>& np2, const NPs& ... nps)
{
  return insert_field_points(tr, size, Boundary_recovery_3::internal::merge_all(np1, np2, nps...));
}

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#endif // CGAL_INSERT_FIELD_POINTS_H
