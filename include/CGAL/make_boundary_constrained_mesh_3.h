// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_MAKE_BOUNDARY_CONSTRAINED_MESH_3_H
#define CGAL_MAKE_BOUNDARY_CONSTRAINED_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/meshing/Boundary_constrained_meshing_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/mark_domain.h>
#include <CGAL/recover_boundary.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/range/has_range_iterator.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {

namespace Boundary_recovery_3 {
namespace internal {

template <typename T>
struct Is_named_parameters : std::false_type { };

template <typename T, typename Tag, typename Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base> > : std::true_type { };

// Chains of named parameters, maybe none.
template <typename ... NPs>
using Enable_if_named_parameters = std::enable_if_t<std::conjunction<Is_named_parameters<NPs>...>::value>;

template <typename Range>
using Enable_if_range = std::enable_if_t<boost::has_range_const_iterator<Range>::value>;

template <typename Surface>
using Enable_if_surface = std::enable_if_t<! boost::has_range_const_iterator<Surface>::value>;

template <typename SizingField>
using Enable_if_sizes = std::enable_if_t<! Is_named_parameters<SizingField>::value
                                         && ! boost::has_range_const_iterator<SizingField>::value>;

inline auto merge_all() { return parameters::default_values(); }

// In the place of a size field: the sizes come from the surface.
struct Sizes_from_surface { };

// From here on, the types of named parameters, size fields and visitors are no matter.
template <typename Tr, typename SizingField, typename NamedParameters>
Boundary_constrained_mesh_result_3<Tr>
make_mesh(Tr& tr, Surface_to_mesh_3<Tr>& surface, const SizingField& size, const NamedParameters& np)
{
  internal::for_each_constrained_edge(np, [&](const std::size_t u, const std::size_t v)
  {
    surface.constrained_edges.push_back({{ u, v }});
  });
  if constexpr(! parameters::is_default_parameter<NamedParameters, internal::void_points_t>::value)
  {
    static_assert(std::is_same<typename Cell_indices<typename Tr::Cell>::Subdomain_index, int>::value,
                  "Regions that are to be empty need cells whose Subdomain_index is int.");
    const auto places = parameters::get_parameter(np, internal::void_points);
    surface.void_points.assign(std::begin(places), std::end(places));
  }
  static_assert(parameters::is_default_parameter<NamedParameters, internal::number_of_subdomains_t>::value
                || Can_be_divided<Tr>::value,
                "Sub-domains need vertices with meshing_info(), as those of "
                "CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type, and traits without a state.");
  const auto quality = parameters::choose_parameter<Dihedral_angle_quality_3>(
    parameters::get_parameter(np, internal::cell_quality));
  const Meshing_options options = internal::meshing_options<Tr>(np);
  auto visitor = internal::mesh_visitor<Tr>(np);
  Boundary_constrained_meshing_3<Tr, std::decay_t<decltype(quality)> > mesh(tr, quality, options, visitor);
  if constexpr(std::is_same<SizingField, Sizes_from_surface>::value)
    return mesh(surface, nullptr);
  else
  {
    const Any_size_field_3<typename Tr::Geom_traits, SizingField> any_size(size);
    return mesh(surface, &any_size);
  }
}

template <typename Tr, typename PointRange, typename TriangleRange, typename SizingField, typename NamedParameters>
Boundary_constrained_mesh_result_3<Tr>
make_mesh_of_soup(Tr& tr, const PointRange& points, const TriangleRange& triangles, const SizingField& size,
                  const NamedParameters& np)
{
  static_cast<void>(internal::Require_mesh_indices<Tr>());
  Surface_to_mesh_3<Tr> surface;
  surface.recover = [&](Mesh_visitor_3<Tr>& visitor)
  {
    return recover_boundary(tr, points, triangles, internal::merge(np, parameters::visitor(std::ref(visitor))));
  };
  surface.patches = [&](const auto& facets)
  {
    return internal::patches_of_facets<typename Surface_to_mesh_3<Tr>::Patch>(facets, np);
  };
  return internal::make_mesh(tr, surface, size, np);
}

template <typename Tr, typename FaceListGraph, typename SizingField, typename NamedParameters>
Boundary_constrained_mesh_result_3<Tr>
make_mesh_of_surface(Tr& tr, const FaceListGraph& surface, const SizingField& size, const NamedParameters& np)
{
  static_cast<void>(internal::Require_mesh_indices<Tr>());
  typedef typename Surface_to_mesh_3<Tr>::Patch Patch;
  Surface_to_mesh_3<Tr> to_mesh;
  to_mesh.recover = [&](Mesh_visitor_3<Tr>& visitor)
  {
    return recover_boundary(tr, surface, internal::merge(np, parameters::visitor(std::ref(visitor))));
  };
  to_mesh.patches = [&](const auto& facets)
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value)
      return internal::patches_of_facets<Patch>(facets, np);
    else
    {
      std::vector<Patch> patches;
      for(const auto f : faces(surface))
        patches.push_back(Patch(get(parameters::get_parameter(np, internal_np::face_patch), f)));
      return internal::patches_of_facets<Patch>(facets, parameters::face_patch_map(make_property_map(patches)));
    }
  };
  return internal::make_mesh(tr, to_mesh, size, np);
}

} // namespace internal
} // namespace Boundary_recovery_3

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief fills a surface with tetrahedra of given sizes; every triangle of the surface is a facet of the mesh.
 *
 * The function does all steps of [CZZ+17, Section 4.1]:
 * - the boundary is recovered, see `recover_boundary()` (steps 2 to 4);
 * - the domain is marked, see `mark_domain()` (step 5);
 * - field points are inserted, see `insert_field_points()` (step 6);
 * - the quality of the mesh is improved, see `improve_mesh_quality()` (step 7).
 *
 * The outside of the domain, up to the convex hull, stays in the triangulation as the region 0, and gets no points. The
 * resulting triangulation is a valid `Triangulation_3`, but no longer Delaunay, although its type may say so.
 *
 * Nothing is printed, and nothing is thrown because of the input. The same input gives the same mesh, bit for bit,
 * unless time is limited.
 *
 * \tparam Triangulation an instance of `Delaunay_triangulation_3`, or of a class derived from it, with a model of
 *         `BoundaryRecoveryTraits_3` as geometric traits, whose vertices and cells are models of `MeshVertexBase_3` and
 *         `MeshCellBase_3`: best `Boundary_constrained_mesh_triangulation_3::type`
 * \tparam PointRange a model of `ConstRange` whose value type is `Triangulation::Geom_traits::Point_3`, unless
 *         `point_map` is given
 * \tparam TriangleRange a model of `ConstRange` whose value type is a model of `RandomAccessContainer` of vertex
 *         indices
 * \tparam SizingField a number type, or a model of `MeshDomainField_3`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation. It may be empty; then the function does everything.
 * \param points the points
 * \param triangles the triangles, each three indices of points. As for `recover_boundary()`, they may be non-manifold,
 *        have sheets that end inside, and bound several regions, which are all meshed.
 *        `Boundary_recovery_3::label_regions()` has the rules for regions and voids.
 * \param size the lengths of edges inside, in the unit of the coordinates: a number, or a function object that is
 *        called with a point, a dimension (3) and the number of a region, as CGAL's fields are. The function object may
 *        have the members `grading()` and `least_size_around()`, see `insert_field_points()`; without them,
 *        `filling.is_field_resolved` is `false`. Without this argument, the sizes come from the surface, see
 *        `Boundary_recovery_3::Surface_sizing_field_3`. Where the surface is finer than the size, edges are shorter,
 *        see \ref BR3_sizes.
 * \param np an optional sequence of named parameters: those of `recover_boundary()`, and the ones listed below. The
 *        named parameters of this package start a chain; several chains are passed one after the other.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{grading}
 *     \cgalParamDescription{the growth of the size per length, away from the surface, if there is no `size`. A negative
 *                           or infinite number is `invalid_input`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{0.3}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{the patch of each triangle, see `mark_domain()`}
 *     \cgalParamType{a model of `ReadablePropertyMap` whose key type is `std::size_t`, the position of a triangle}
 *     \cgalParamDefault{the position of the triangle + 1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{void_points}
 *     \cgalParamDescription{one place in each region to be left empty. These regions become parts of the outside, and
 *                           the others are numbered anew, in their order. A place outside or on the surface is
 *                           `invalid_input`}
 *     \cgalParamType{a `ConstRange` whose value type is `Triangulation::Geom_traits::Point_3`}
 *     \cgalParamDefault{no places}
 *     \cgalParamExtra{The `Subdomain_index` of the cells has to be `int`.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{improve_quality}
 *     \cgalParamDescription{whether cells are improved after the field points are inserted}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{min_dihedral_angle}
 *     \cgalParamDescription{the target of the improvement, in degrees, see `improve_mesh_quality()`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{25}
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
 *   \cgalParamNBegin{maximum_number_of_vertices}
 *     \cgalParamDescription{the largest number of vertices of the triangulation. If the forecast is higher, no field
 *                           point is inserted. At the limit, the improvement works without further vertices}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{no limit but that of the memory}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_subdomains}
 *     \cgalParamDescription{the number of sub-domains into which the domain is divided, by METIS if
 *                           `CGAL_METIS_ENABLED` is defined. Sub-domains, and then the zones around their seams, are
 *                           filled and improved at the same time if `CGAL_LINKED_WITH_TBB` is defined and the number
 *                           type of the kernel is a built-in one. The mesh depends on this number, and not on the
 *                           number of threads. A domain with too few cells is divided into fewer sub-domains}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{1: the domain is not divided}
 *     \cgalParamExtra{With more than 1, several threads call the size field and the quality. One thread at a time calls
 *                     the visitor, which is not told of single cells.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{how many threads may work at the same time, if `CGAL_LINKED_WITH_TBB` is defined and the
 *                           number type of the kernel is a built-in one; 0: as many as there are. A mesh of some
 *                           hundred thousand cells or more is divided into parts, again and again in other ways. How
 *                           many parts there are follows from its size, so the mesh does not depend on the number of
 *                           threads. With `maximum_number_of_vertices`, nothing is divided}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{0 if the triangulation has the concurrency tag `CGAL::Parallel_tag`; else, nothing is divided
 *                       but into sub-domains}
 *     \cgalParamExtra{Several threads call the size field and the quality. One thread at a time calls the visitor;
 *                     meanwhile, others change other cells.}
 *     \cgalParamExtra{In a triangulation data structure of your own with the tag `CGAL::Parallel_tag`, the order of
 *                     cells depends on threads, and so does the mesh.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_running_time}
 *     \cgalParamDescription{the time in seconds, for all steps together, after which the work stops soon, with a valid
 *                           triangulation}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{no limit}
 *     \cgalParamExtra{With sub-domains, the parts are joined to one triangulation after that, which takes about a
 *                     second for each million cells.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor, which is told of the phases of all steps, and can stop the work}
 *     \cgalParamType{a model of `MeshingVisitor_3`}
 *     \cgalParamDefault{`Default_meshing_visitor_3`}
 *     \cgalParamExtra{Pass `std::ref(visitor)` to have the object itself called and not a copy.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the status, and the results of the steps. The result converts to `true` iff all is done. If the recovery did
 *         not succeed, the triangulation is as the recovery left it, and nothing is marked. If the status is `stopped`
 *         and `number_of_regions` is not 0, the domain is marked, and there may be field points.
 *         `improvement.certificate` lists the cells below the target, with the reasons.
 *
 * \pre `tr` is valid: `tr.is_valid()`.
 */
#ifdef DOXYGEN_RUNNING
template <typename Triangulation, typename PointRange, typename TriangleRange, typename SizingField,
          typename NamedParameters = parameters::Default_named_parameters>
Boundary_constrained_mesh_result_3<Triangulation>
make_boundary_constrained_mesh_3(Triangulation& tr, const PointRange& points, const TriangleRange& triangles,
                                 const SizingField& size, const NamedParameters& np = parameters::default_values());
#else
template <typename Triangulation, typename PointRange, typename TriangleRange, typename SizingField, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_range<PointRange>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_range<TriangleRange>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_sizes<SizingField>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
Boundary_constrained_mesh_result_3<Triangulation>
make_boundary_constrained_mesh_3(Triangulation& tr, const PointRange& points, const TriangleRange& triangles,
                                 const SizingField& size, const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::make_mesh_of_soup(tr, points, triangles, size, BR3::merge_all(nps...));
}
#endif

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief fills a triangle soup with tetrahedra whose sizes come from the surface.
 *
 * See the overload with a size field.
 */
#ifdef DOXYGEN_RUNNING
template <typename Triangulation, typename PointRange, typename TriangleRange,
          typename NamedParameters = parameters::Default_named_parameters>
Boundary_constrained_mesh_result_3<Triangulation>
make_boundary_constrained_mesh_3(Triangulation& tr, const PointRange& points, const TriangleRange& triangles,
                                 const NamedParameters& np = parameters::default_values());
#else
template <typename Triangulation, typename PointRange, typename TriangleRange, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_range<PointRange>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_range<TriangleRange>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
Boundary_constrained_mesh_result_3<Triangulation>
make_boundary_constrained_mesh_3(Triangulation& tr, const PointRange& points, const TriangleRange& triangles,
                                 const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::make_mesh_of_soup(tr, points, triangles, BR3::Sizes_from_surface(), BR3::merge_all(nps...));
}
#endif

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief fills a surface mesh with tetrahedra of given sizes; every face of the surface is a facet of the mesh.
 *
 * The work is that of the overload for soups. The named parameters are those of that overload, and of
 * `recover_boundary()` for surface meshes. The key type of `face_patch_map` is the face descriptor of the surface.
 *
 * \tparam FaceListGraph a model of `FaceListGraph`
 *
 * \param tr the triangulation. It may be empty.
 * \param surface the surface mesh, see `recover_boundary()`
 * \param size the size field, see the overload for soups
 * \param np an optional sequence of named parameters
 *
 * \return see the overload for soups
 */
#ifdef DOXYGEN_RUNNING
template <typename Triangulation, typename FaceListGraph, typename SizingField,
          typename NamedParameters = parameters::Default_named_parameters>
Boundary_constrained_mesh_result_3<Triangulation>
make_boundary_constrained_mesh_3(Triangulation& tr, const FaceListGraph& surface, const SizingField& size,
                                 const NamedParameters& np = parameters::default_values());
#else
template <typename Triangulation, typename FaceListGraph, typename SizingField, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_surface<FaceListGraph>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_sizes<SizingField>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
Boundary_constrained_mesh_result_3<Triangulation>
make_boundary_constrained_mesh_3(Triangulation& tr, const FaceListGraph& surface, const SizingField& size,
                                 const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::make_mesh_of_surface(tr, surface, size, BR3::merge_all(nps...));
}
#endif

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief fills a surface mesh with tetrahedra whose sizes come from the surface.
 *
 * See the overload with a size field.
 */
#ifdef DOXYGEN_RUNNING
template <typename Triangulation, typename FaceListGraph,
          typename NamedParameters = parameters::Default_named_parameters>
Boundary_constrained_mesh_result_3<Triangulation>
make_boundary_constrained_mesh_3(Triangulation& tr, const FaceListGraph& surface,
                                 const NamedParameters& np = parameters::default_values());
#else
template <typename Triangulation, typename FaceListGraph, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_surface<FaceListGraph>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
Boundary_constrained_mesh_result_3<Triangulation>
make_boundary_constrained_mesh_3(Triangulation& tr, const FaceListGraph& surface, const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::make_mesh_of_surface(tr, surface, BR3::Sizes_from_surface(), BR3::merge_all(nps...));
}
#endif

} // namespace CGAL

#endif // CGAL_MAKE_BOUNDARY_CONSTRAINED_MESH_3_H
