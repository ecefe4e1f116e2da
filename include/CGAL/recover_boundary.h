// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_RECOVER_BOUNDARY_H
#define CGAL_RECOVER_BOUNDARY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Recover_indexed_boundary.h>
#include <CGAL/Boundary_recovery_3/internal/input/input_conversion.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/range/has_range_iterator.hpp>

#include <cstddef>
#include <type_traits>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief recovers the faces of a triangle soup in a triangulation: every triangle becomes a facet of `tr`.
 *
 * The soup may be open, non-manifold, have sheets that end inside, and bound several regions. The function
 * 1. checks the input;
 * 2. finds the points among the vertices of `tr` by their exact coordinates, and inserts the missing ones;
 * 3. recovers lost edges, then lost facets, by recursive shell transformations [CZZ+17, Section 4.2] and small
 *    polyhedron reconnection, without points, unless 100 lost edges or more are tangled in a plane: see the phase
 *    `planar_edge_recovery`;
 * 4. recovers constraints that are still lost by Steiner points, unless constraints intersect. The points are first put
 *    on the constraints [CZZ+17, Section 4], then taken off the constraints, and removed where possible;
 * 5. looks up every constraint again.
 *
 * The triangulation is changed in place and is no longer Delaunay afterwards, although its type may say so: point
 * insertion, point location by conflicts, and nearest vertex queries are undefined from then on. The base
 * `Triangulation_3::is_valid()` holds. Vertices keep their handles and their coordinates, bit for bit. Cells are
 * replaced; data of cells are lost, unless a visitor carries them over. Give a later call on the same triangulation the
 * earlier constraints again, or it may flip them away. Steiner points of an earlier call are ordinary vertices: they
 * are not removed, and the parts of constraints with points on them must be given as constraints.
 *
 * Nothing is printed, and nothing is thrown because of the input.
 *
 * \tparam Triangulation an instance of `Delaunay_triangulation_3`, or of `Triangulation_3`, or of a class derived from
 *         one of them, with a model of `BoundaryRecoveryTraits_3` as geometric traits. A triangulation that is not
 *         Delaunay must have all points already.
 * \tparam PointRange a model of `ConstRange` whose value type is `Triangulation::Geom_traits::Point_3`, unless
 *         `point_map` is given
 * \tparam TriangleRange a model of `ConstRange` whose value type is a model of `RandomAccessContainer` of vertex
 *         indices
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation. It may be empty; then the function does everything.
 * \param points the points
 * \param triangles the triangles, each three indices of points
 * \param np an optional sequence of named parameters among the ones listed below. The parameters `recovery_mode`,
 *        `effort`, `max_recursion_level`, `constrained_edges`, `list_defects` and `maximum_number_of_defects`, start a
 *        chain; several chains are passed one after the other.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{recovery_mode}
 *     \cgalParamDescription{how far the recovery goes}
 *     \cgalParamType{`CGAL::Boundary_recovery_3::Recovery_mode`}
 *     \cgalParamDefault{`Recovery_mode::constrained`}
 *     \cgalParamExtra{If Steiner points cannot recover everything, because the kernel has no numbers for their
 *                     positions, or because time is up, the triangulation comes back as the flips left it, with points
 *                     of the phase `planar_edge_recovery`, if any.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{effort}
 *     \cgalParamDescription{what the recovery gives up, time or points}
 *     \cgalParamType{`CGAL::Boundary_recovery_3::Recovery_effort`}
 *     \cgalParamDefault{`Recovery_effort::more_time`}
 *     \cgalParamExtra{In the mode `flips_only`, it has no effect.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{max_recursion_level}
 *     \cgalParamDescription{the recursion level that is never exceeded; 0: no recursion}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{30}
 *     \cgalParamExtra{The first pass has the level 1, the others have this one, as long as they help.
 *                     A negative level means the default.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{constrained_edges}
 *     \cgalParamDescription{edges to recover, in addition to the edges of the triangles}
 *     \cgalParamType{a `ConstRange` whose value type is an array of two vertex indices}
 *     \cgalParamDefault{no edges}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_running_time}
 *     \cgalParamDescription{the time in seconds after which the recovery stops soon, with a valid triangulation}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{no limit}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor, which is told of phases, of progress, and of old and new cells, and can stop the
 *                           recovery}
 *     \cgalParamType{a model of `MeshingVisitor_3`}
 *     \cgalParamDefault{`Default_meshing_visitor_3`}
 *     \cgalParamExtra{Pass `std::ref(visitor)` to have the object itself called and not a copy.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{list_defects}
 *     \cgalParamDescription{whether intersections of constraints, and vertices of `tr` on constraints, are searched
 *                           first. If there are any, no cell is flipped}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`: the search comes only when constraints are missing in the end; for intersections also
 *                       earlier, when the flips have taken much longer than the search does}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_number_of_defects}
 *     \cgalParamDescription{the largest number of listed defects, the first ones in order; 0: only the number of
 *                           defects is in the result}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{1000000, which take about 0.4 GB}
 *     \cgalParamExtra{Two surfaces of n triangles may intersect in n^2 pairs. If there are more pairs than are listed,
 *                     `number_of_defects` is a lower bound, as it would take long to count them.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{point_map}
 *     \cgalParamDescription{a property map from the elements of `points` to points}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`CGAL::Identity_property_map`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{the traits for checking the input}
 *     \cgalParamType{a model of `BoundaryRecoveryTraits_3` with the point type of the triangulation}
 *     \cgalParamDefault{the traits of the triangulation}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the status, and lists of missing constraints and of defects, in the indices of points and triangles. The
 *         result converts to `true` iff every triangle and constrained edge is in the triangulation. If the status is
 *         `stopped`, defects that need a search are not known. If the work stopped before all points were inserted, all
 *         constraints are listed as missing, and the vertices of the missing points are default handles, also in
 *         `facets`. If the status is `invalid_input`, the triangulation is unchanged, with three exceptions. The points
 *         are inserted if they and all vertices of a triangulation of a dimension less than 3 turn out to be coplanar.
 *         The points are inserted if a constraint contains another vertex, which may be a vertex of the triangulation
 *         or a point without a constraint. Without `list_defects`, constraints that intersect are found only after
 *         points, perhaps not all, were inserted and cells were flipped.
 *
 * \pre `tr` is valid: `tr.is_valid()` as a `Triangulation_3`; it need not be Delaunay.
 */
template <typename Triangulation, typename PointRange, typename TriangleRange, typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<boost::has_range_const_iterator<TriangleRange>::value>* = nullptr
#endif
          >
Boundary_recovery_result_3<Triangulation>
recover_boundary(Triangulation& tr, const PointRange& points, const TriangleRange& triangles,
                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename Triangulation::Geom_traits::Point_3 Point_3;
  namespace BR3 = Boundary_recovery_3::internal;
  const auto point_map = parameters::choose_parameter<Identity_property_map<Point_3> >(
    parameters::get_parameter(np, internal_np::point_map));

  BR3::Input_conversion<Triangulation> conversion;
  conversion.reserve(BR3::size_or_zero(points, 0), BR3::size_or_zero(triangles, 0));
  for(const auto& p : points)
    conversion.add_point(get(point_map, p));
  for(const auto& t : triangles)
    conversion.add_facet(t);
  return conversion.recover(tr, np);
}

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief recovers the faces of a surface mesh in a triangulation: every face becomes a facet of `tr`.
 *
 * The work and the named parameters are those of the overload for soups, without `point_map`. The indices in
 * `constrained_edges` are positions in `vertices(surface)`.
 *
 * \tparam Triangulation see the other overload
 * \tparam FaceListGraph a model of `FaceListGraph`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation. It may be empty.
 * \param surface the surface mesh. It may be open and may have several components. Indices in the result are positions
 *        in `vertices(surface)` and in `faces(surface)`.
 * \param np an optional sequence of named parameters among those of the other overload and the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map from the vertices of `surface` to points}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_to_vertex_map}
 *     \cgalParamDescription{a property map that gets the vertex of `tr` for each vertex of `surface`, unless the input
 *                           is invalid}
 *     \cgalParamType{a model of `WritablePropertyMap` from vertex descriptors to `Triangulation::Vertex_handle`}
 *     \cgalParamDefault{unused}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return see the other overload
 */
template <typename Triangulation, typename FaceListGraph, typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<! boost::has_range_const_iterator<FaceListGraph>::value>* = nullptr
#endif
          >
Boundary_recovery_result_3<Triangulation>
recover_boundary(Triangulation& tr, const FaceListGraph& surface,
                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace BR3 = Boundary_recovery_3::internal;
  const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(CGAL::vertex_point, surface));
  BR3::Input_conversion<Triangulation> conversion;
  conversion.add_surface(surface, point_map);
  const Boundary_recovery_result_3<Triangulation> result = conversion.recover(tr, np);
  if constexpr(! parameters::is_default_parameter<CGAL_NP_CLASS, internal_np::vertex_to_vertex_map_t>::value)
  {
    auto vertex_map = parameters::get_parameter(np, internal_np::vertex_to_vertex_map);
    std::size_t i = 0;
    for(const auto v : vertices(surface))
      if(i < result.vertices.size())
        put(vertex_map, v, result.vertices[i++]);
  }
  return result;
}

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief recovers facets between vertices of a triangulation.
 *
 * The work and the named parameters are those of the overload for soups, without the insertion of points and without
 * `point_map`. The value type of `constrained_edges` is an array of two vertex handles.
 *
 * \tparam Triangulation see the other overload
 * \tparam FacetRange a model of `ConstRange` whose value type is an array of three vertex handles of `Triangulation`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation
 * \param facets the facets. Indices of facets in the result are positions in this range; indices of vertices count the
 *        vertices of the facets, then of the edges, in the order of their first appearance, and `vertices` of the
 *        result holds them.
 * \param np an optional sequence of named parameters
 *
 * \return see the other overload
 */
template <typename Triangulation, typename FacetRange, typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<boost::has_range_const_iterator<FacetRange>::value>* = nullptr
#endif
          >
Boundary_recovery_result_3<Triangulation>
recover_boundary(Triangulation& tr, const FacetRange& facets,
                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  Boundary_recovery_3::internal::Handle_conversion<Triangulation> conversion(tr);
  for(const auto& f : facets)
    conversion.add_facet(f);
  return conversion.recover(tr, np);
}

#ifndef DOXYGEN_RUNNING

// Several chains of named parameters, one after the other.

template <typename Triangulation, typename PointRange, typename TriangleRange,
          typename T1, typename Tag1, typename Base1, typename T2, typename Tag2, typename Base2, typename ... NPs>
Boundary_recovery_result_3<Triangulation>
recover_boundary(Triangulation& tr, const PointRange& points, const TriangleRange& triangles,
                 const Named_function_parameters<T1, Tag1, Base1>& np1,
                 const Named_function_parameters<T2, Tag2, Base2>& np2, const NPs& ... nps)
{
  return recover_boundary(tr, points, triangles, Boundary_recovery_3::internal::merge_all(np1, np2, nps...));
}

template <typename Triangulation, typename Boundary,
          typename T1, typename Tag1, typename Base1, typename T2, typename Tag2, typename Base2, typename ... NPs>
Boundary_recovery_result_3<Triangulation>
recover_boundary(Triangulation& tr, const Boundary& boundary,
                 const Named_function_parameters<T1, Tag1, Base1>& np1,
                 const Named_function_parameters<T2, Tag2, Base2>& np2, const NPs& ... nps)
{
  return recover_boundary(tr, boundary, Boundary_recovery_3::internal::merge_all(np1, np2, nps...));
}

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#endif // CGAL_RECOVER_BOUNDARY_H
