// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_REMESH_HOLES_H
#define CGAL_REMESH_HOLES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Remesh_arrays_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/range/value_type.hpp>

#include <type_traits>

namespace CGAL {

namespace Boundary_recovery_3 {
namespace internal {

// The point type behind a range and the named parameter `point_map`.
template <typename PointRange, typename NamedParameters>
struct Point_of_range
{
  typedef typename boost::range_value<PointRange>::type Value;
  typedef std::decay_t<decltype(get(
    parameters::choose_parameter<Identity_property_map<Value> >(
      parameters::get_parameter(std::declval<const NamedParameters&>(), internal_np::point_map)),
    std::declval<const Value&>()))> type;
};

template <typename PointRange, typename TetrahedronRange, typename SizingField, typename NamedParameters>
auto remesh_holes_of_ranges(const PointRange& points, const TetrahedronRange& tetrahedra, const SizingField& size,
                            const NamedParameters& np)
{
  typedef typename Point_of_range<PointRange, NamedParameters>::type Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel                    Kernel;
  return Remesh_arrays_3<Kernel, NamedParameters>(np)(points, tetrahedra, size);
}

} // namespace internal
} // namespace Boundary_recovery_3

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief replaces the bad cells of a tetrahedral mesh whose vertices were moved, and some cells around the bad ones;
 * everything else stays.
 *
 * This is the local remeshing of [CZZ+17, Section 5.2.3]: a body moves through a mesh and deforms the mesh; now and
 * then, where cells have become bad, flat or inverted, holes are cut out and meshed anew. The function
 * 1. searches bad cells, and adds layers of cells around them. Each set of cells that facets connect is a hole;
 * 2. recovers the boundary of each hole, and the constrained facets and edges in it, see `recover_boundary()`. Where
 *    the boundary of a hole is not a valid surface, since neighbors are inverted or overlap, the hole grows by the
 *    cells there until its boundary is valid. A hole whose boundary cannot be recovered grows by a layer;
 * 3. inserts field points, see `insert_field_points()`, and improves the new cells, see `improve_mesh_quality()`. Where
 *    cells at the boundary of a hole are still bad, the hole grows once, and is meshed again;
 * 4. puts old and new cells together, and locates each new vertex in the old mesh.
 *
 * A mesh with inverted cells is no valid triangulation. Therefore input and output are arrays. Everything outside of
 * the holes is in the result bit for bit, in its order; new vertices and cells follow.
 *
 * Constrained are the facets and edges of the two named parameters, facets between cells of different regions, and
 * facets on the boundary of the mesh. These facets and edges stay, with their vertices, also inside holes. If a surface
 * was moved through another one, the result has the pairs of intersecting facets in holes.
 *
 * Nothing is printed, and nothing is thrown because of the input. The same input gives the same mesh, bit for bit,
 * unless time is limited. The time depends on the size of the holes; there are a few linear passes over the whole mesh.
 *
 * \tparam PointRange a model of `ConstRange` whose value type is a point of a CGAL kernel that is a model of
 *         `BoundaryRecoveryTraits_3`, unless `point_map` is given
 * \tparam TetrahedronRange a model of `ConstRange` whose value type is a model of `RandomAccessContainer` of four
 *         positions of points
 * \tparam SizingField a number type, or a model of `MeshDomainField_3`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param points the vertices, at their new places. Vertices without a tetrahedron stay, too.
 * \param tetrahedra the tetrahedra, each four positions of points. `orientation()` of a tetrahedron that is not
 *        inverted is `POSITIVE`. By the order of their vertices, two tetrahedra with a common facet are on different
 *        sides of the facet.
 * \param size the lengths of new edges, as for `insert_field_points()`, with the regions of `cell_region_map`. Without
 *        this argument, sizes are those of the old mesh at the same place.
 * \param np an optional sequence of named parameters among the ones listed below. The named parameters of this package
 *        start a chain; several chains are passed one after the other.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{cell_is_selected_map}
 *     \cgalParamDescription{cells that are bad, whatever their shape}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `std::size_t`, the position of a tetrahedron, as key type,
 *                    and `bool` as value type}
 *     \cgalParamDefault{no cell}
 *     \cgalParamExtra{Flat and inverted cells are bad in any case.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{min_dihedral_angle}
 *     \cgalParamDescription{cells with a smaller dihedral angle are bad, in degrees. An impossible angle, see
 *                           `improve_mesh_quality()`, is `invalid_input`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{10; or 0 if there is a `cell_is_selected_map`}
 *     \cgalParamExtra{New cells are improved up to this angle, or to 25 degrees if that is more.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_layers}
 *     \cgalParamDescription{the number of layers of cells around bad cells that are replaced, too. A layer has all
 *                           cells with a vertex of the cells inside}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{2}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{cell_region_map}
 *     \cgalParamDescription{the region of each tetrahedron}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `std::size_t`, the position of a tetrahedron, as key type,
 *                    and values that can be made an `int`}
 *     \cgalParamDefault{1 for all}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{constrained_facets}
 *     \cgalParamDescription{facets that stay: surfaces of bodies, sheets}
 *     \cgalParamType{a `ConstRange` whose value type is an array of three positions of points}
 *     \cgalParamDefault{no facets}
 *     \cgalParamExtra{Facets between regions, and facets on the boundary of the mesh, need not be given. The result has
 *                     the facets in the same order, so that patch numbers stay valid.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{constrained_edges}
 *     \cgalParamDescription{edges that stay, in addition to the edges of constrained facets}
 *     \cgalParamType{a `ConstRange` whose value type is an array of two positions of points}
 *     \cgalParamDefault{no edges}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{improve_quality}
 *     \cgalParamDescription{whether new cells are improved}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_running_time}
 *     \cgalParamDescription{the time in seconds after which the work stops soon, and the old mesh is returned}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{no limit}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor, which is told of phases and progress, and can stop the work}
 *     \cgalParamType{a model of `MeshingVisitor_3`}
 *     \cgalParamDefault{`Default_meshing_visitor_3`}
 *     \cgalParamExtra{Pass `std::ref(visitor)` to have the object itself called and not a copy.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{point_map}
 *     \cgalParamDescription{a property map from the elements of `points` to points}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`CGAL::Identity_property_map`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the new mesh, the old positions of its vertices and tetrahedra, and counts. The result converts to `true` iff
 *         the status is `meshed`, also if no cell is bad. Otherwise, the mesh is the old one. `invalid_input`: the
 *         arrays are no mesh, constrained facets intersect or are turned inside out, or the size field has no size at a
 *         place; the result has the defects. `too_large`: with a size field, new cells would not fit into the memory.
 *         `stopped`: by the visitor, or the time limit. `incomplete`: a hole could not be meshed, although it grew over
 *         all the mesh.
 */
#ifdef DOXYGEN_RUNNING
template <typename PointRange, typename TetrahedronRange, typename SizingField,
          typename NamedParameters = parameters::Default_named_parameters>
Hole_remeshing_result_3<Point_3>
remesh_holes(const PointRange& points, const TetrahedronRange& tetrahedra, const SizingField& size,
             const NamedParameters& np = parameters::default_values());
#else
template <typename PointRange, typename TetrahedronRange, typename SizingField, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_sizes<SizingField>* = nullptr,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
auto remesh_holes(const PointRange& points, const TetrahedronRange& tetrahedra, const SizingField& size,
                  const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::remesh_holes_of_ranges(points, tetrahedra, size, BR3::merge_all(nps...));
}
#endif

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief replaces the bad cells of a tetrahedral mesh whose vertices were moved, with the sizes of the old mesh.
 *
 * See the overload with a size field.
 */
#ifdef DOXYGEN_RUNNING
template <typename PointRange, typename TetrahedronRange,
          typename NamedParameters = parameters::Default_named_parameters>
Hole_remeshing_result_3<Point_3>
remesh_holes(const PointRange& points, const TetrahedronRange& tetrahedra,
             const NamedParameters& np = parameters::default_values());
#else
template <typename PointRange, typename TetrahedronRange, typename ... NPs,
          Boundary_recovery_3::internal::Enable_if_named_parameters<NPs...>* = nullptr>
auto remesh_holes(const PointRange& points, const TetrahedronRange& tetrahedra, const NPs& ... nps)
{
  namespace BR3 = Boundary_recovery_3::internal;
  return BR3::remesh_holes_of_ranges(points, tetrahedra, BR3::Sizes_of_old_mesh(), BR3::merge_all(nps...));
}
#endif

} // namespace CGAL

#endif // CGAL_REMESH_HOLES_H
