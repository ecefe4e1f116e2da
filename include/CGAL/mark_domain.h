// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_MARK_DOMAIN_H
#define CGAL_MARK_DOMAIN_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Mark_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {

namespace Boundary_recovery_3 {
namespace internal {

// The position of a facet in the input: that which it has with it, as `Surface_facet_3` does, or else that in its
// range.
template <typename Facet>
std::size_t input_position(const Facet& facet, std::size_t, int, decltype(facet.index)* = nullptr)
{
  return facet.index;
}

template <typename Facet>
std::size_t input_position(const Facet&, const std::size_t position, long) { return position; }

// The patch of each facet: what the caller's map says, or else its position in the input + 1.
template <typename Patch, typename FacetRange, typename NamedParameters>
std::vector<Patch> patches_of_facets(const FacetRange& facets, const NamedParameters& np)
{
  constexpr bool is_default = parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value;
  static_assert(! is_default || std::is_constructible<Patch, int>::value,
                "The patches of this triangulation are not numbers: a face_patch_map is needed.");
  std::vector<Patch> patches;
  std::size_t n = 0;
  for(const auto& facet : facets)
  {
    const std::size_t position = internal::input_position(facet, n++, 0);
    if constexpr(is_default)
      patches.push_back(Patch(static_cast<int>(position) + 1));
    else
      patches.push_back(Patch(get(parameters::get_parameter(np, internal_np::face_patch), position)));
  }
  return patches;
}

} // namespace internal
} // namespace Boundary_recovery_3

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief marks the regions that given facets bound in a triangulation, by the indices of CGAL's mesh packages [CZZ+17,
 * Section 4.1, step 5].
 *
 * The function writes
 * - the `subdomain_index()` of all cells: the region by the rules of `Boundary_recovery_3::label_regions()`, 1, 2, ...,
 *   and 0 for cells outside of the domain and for infinite cells;
 * - the `surface_patch_index()` of all facets, on both sides: a patch for each given facet, facets of sheets included,
 *   and 0 for all others;
 * - `in_dimension()` and `index()` of all finite vertices. A vertex of a constrained edge gets the dimension 1 and the
 *   position of the edge + 1; another vertex of a given facet gets the dimension 2 and the patch of the facet; all
 *   others get the dimension 3 and their region. Of several edges or facets, the first one counts.
 *
 * Nothing else in the triangulation is changed. Earlier marks are overwritten. The time is about linear.
 *
 * \tparam Triangulation an instance of `CGAL::Triangulation_3`, or of a class derived from it, such as
 *         `Boundary_constrained_mesh_triangulation_3::type`. Its vertices and cells are models of `MeshVertexBase_3`
 *         and `MeshCellBase_3`, whose `Subdomain_index` can be made from an `int`. An index whose type cannot be made
 *         from the number above gets its default value.
 * \tparam FacetRange a model of `ConstRange` whose value type is an array of three vertex handles. If the arrays have a
 *         member `index`, as the elements of `Boundary_recovery_result_3::surface_facets()` have, it is the position of
 *         the facet in the input; otherwise, the position in this range is.
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation
 * \param facets the facets, in the orientation of the input; `result.surface_facets()` of a boundary recovery, or
 *        `result.facets`. Triples that are no facets of `tr` are ignored. If a facet occurs several times, the first
 *        one decides on the patch.
 * \param np an optional sequence of named parameters among the ones listed below; `constrained_edges` starts a chain,
 *        and several chains are passed one after the other
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{the patch of each facet}
 *     \cgalParamType{a model of `ReadablePropertyMap` whose key type is `std::size_t`, the position of a facet in the
 *                    input, and whose values can be made a `Surface_patch_index`}
 *     \cgalParamDefault{the position of the facet in the input + 1}
 *     \cgalParamExtra{0 is no patch: CGAL's packages would lose the facet. All facets with the value 0 get one patch,
 *                     the smallest positive number that is no patch of another facet. If patches are no integers, the
 *                     default value of their type is not allowed.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{constrained_edges}
 *     \cgalParamDescription{constrained edges, in addition to the edges of the facets}
 *     \cgalParamType{a `ConstRange` whose value type is an array of two vertex handles}
 *     \cgalParamDefault{no edges}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the number of regions of the domain; 0 if the facets bound none, or if the dimension of `tr` is not 3: then
 *         nothing is written
 */
template <typename Triangulation, typename FacetRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
int mark_domain(Triangulation& tr, const FacetRange& facets, const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace BR3 = Boundary_recovery_3::internal;
  static_cast<void>(BR3::Require_mesh_indices<Triangulation>());
  typedef BR3::Mark_domain_3<Triangulation> Mark_domain;
  std::vector<typename Mark_domain::Vertex_pair> edges;
  if constexpr(! parameters::is_default_parameter<CGAL_NP_CLASS, BR3::constrained_edges_t>::value)
  {
    const auto constrained_edges = parameters::get_parameter(np, BR3::constrained_edges);
    for(const auto& e : constrained_edges)
      edges.push_back({{ e[0], e[1] }});
  }
  return Mark_domain(tr)(facets, BR3::patches_of_facets<typename Mark_domain::Surface_patch_index>(facets, np), edges);
}

#ifndef DOXYGEN_RUNNING

// Several chains of named parameters, one after the other.
template <typename Triangulation, typename FacetRange,
          typename T1, typename Tag1, typename Base1, typename T2, typename Tag2, typename Base2, typename ... NPs>
int mark_domain(Triangulation& tr, const FacetRange& facets, const Named_function_parameters<T1, Tag1, Base1>& np1,
                const Named_function_parameters<T2, Tag2, Base2>& np2, const NPs& ... nps)
{
  return mark_domain(tr, facets, Boundary_recovery_3::internal::merge_all(np1, np2, nps...));
}

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#endif // CGAL_MARK_DOMAIN_H
