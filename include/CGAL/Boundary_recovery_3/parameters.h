// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_PARAMETERS_H
#define CGAL_BOUNDARY_RECOVERY_3_PARAMETERS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

// The named parameters that only this package has, beside those of CGAL. They can start a chain of CGAL's
// parameters, but not follow a dot (that list is closed); several packs are passed one after the other instead.

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

enum recovery_mode_t             { recovery_mode };
enum max_recursion_level_t       { max_recursion_level };
enum effort_t                    { effort };
enum constrained_edges_t         { constrained_edges };
enum list_defects_t              { list_defects };
enum maximum_number_of_defects_t { maximum_number_of_defects };
enum grading_t                   { grading };
enum maximum_number_of_vertices_t { maximum_number_of_vertices };
enum min_dihedral_angle_t        { min_dihedral_angle };
enum cell_quality_t              { cell_quality };
enum improve_quality_t           { improve_quality };
enum improvement_effort_t        { improvement_effort };
enum cell_region_map_t           { cell_region_map };
enum constrained_facets_t        { constrained_facets };
enum number_of_layers_t          { number_of_layers };
enum number_of_subdomains_t      { number_of_subdomains };
enum number_of_threads_t         { number_of_threads };
enum void_points_t               { void_points };

// A pack with all the parameters of both packs; those of the second win.
template <typename NP, typename T, typename Tag>
auto merge(const NP& a, const Named_function_parameters<T, Tag>& b)
{
  return Named_function_parameters<T, Tag, NP>(b.v, a);
}

template <typename NP, typename T, typename Tag, typename T2, typename Tag2, typename Base2>
auto merge(const NP& a,
           const Named_function_parameters<T, Tag, Named_function_parameters<T2, Tag2, Base2> >& b)
{
  const auto ab = merge(a, static_cast<const Named_function_parameters<T2, Tag2, Base2>&>(b));
  return Named_function_parameters<T, Tag, std::decay_t<decltype(ab)> >(b.v, ab);
}

template <typename NP>
NP merge_all(const NP& np) { return np; }

template <typename NP1, typename NP2, typename ... NPs>
auto merge_all(const NP1& np1, const NP2& np2, const NPs& ... nps)
{
  return merge_all(merge(np1, np2), nps...);
}

// The value of a named parameter, made one of the type of its default value.
template <typename NamedParameters, typename Tag, typename T>
T parameter_or(const NamedParameters& np, const Tag tag, const T& default_value)
{
  return static_cast<T>(parameters::choose_parameter(parameters::get_parameter(np, tag), default_value));
}

template <typename Visitor>
Visitor visitor_to_call(const Visitor& visitor) { return visitor; }

template <typename Visitor>
Visitor& visitor_to_call(const std::reference_wrapper<Visitor>& visitor) { return visitor; }

template <typename Visitor, typename = void>
struct Is_meshing_visitor : std::false_type { };

template <typename Visitor>
struct Is_meshing_visitor<Visitor, std::void_t<
  decltype(std::declval<Visitor&>().on_phase_begin(Phase())),
  decltype(std::declval<Visitor&>().on_phase_end(std::declval<const Phase_report&>())),
  decltype(std::declval<Visitor&>().on_progress(Phase(), std::size_t(), std::size_t())),
  decltype(static_cast<bool>(std::declval<Visitor&>().go_further()))> >
  : std::true_type
{ };

// The visitor itself if it was given by reference, else a copy that can be called. (`get_parameter_reference()` gives a
// constant object if it was given by value.)
template <typename NamedParameters>
decltype(auto) visitor_of(const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value)
    return Default_meshing_visitor_3();
  else
  {
    typedef decltype(internal::visitor_to_call(parameters::get_parameter(np, internal_np::visitor))) Visitor;
    static_assert(Is_meshing_visitor<std::remove_reference_t<Visitor> >::value,
                  "A visitor is a model of MeshingVisitor_3: derive it from CGAL::Default_meshing_visitor_3.");
    static_assert(! std::is_const<std::remove_reference_t<Visitor> >::value, "A visitor is not constant.");
    return internal::visitor_to_call(parameters::get_parameter(np, internal_np::visitor));
  }
}

} // namespace internal
} // namespace Boundary_recovery_3

namespace parameters {

// The function that makes a pack of one parameter. A macro writes them, as in CGAL, since they differ in names only.
#define CGAL_BOUNDARY_RECOVERY_3_PARAMETER(X)                                       \
  template <typename K>                                                             \
  Named_function_parameters<K, Boundary_recovery_3::internal::X##_t> X(const K& k)  \
  {                                                                                 \
    return Named_function_parameters<K, Boundary_recovery_3::internal::X##_t>(k);   \
  }

/// \ingroup PkgBoundaryRecovery3Functions
/// how far the recovery goes: a value of `CGAL::Boundary_recovery_3::Recovery_mode`.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(recovery_mode)

/// \ingroup PkgBoundaryRecovery3Functions
/// the recursion level (`l_max` in [CZZ+17, Alg.\ 1]) that is never exceeded, an integer.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(max_recursion_level)

/// \ingroup PkgBoundaryRecovery3Functions
/// what the recovery gives up, time or points: a value of `CGAL::Boundary_recovery_3::Recovery_effort`.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(effort)

/// \ingroup PkgBoundaryRecovery3Functions
/// edges to be recovered beside the facets: a range of arrays of two vertex indices or vertex handles.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(constrained_edges)

/// \ingroup PkgBoundaryRecovery3Functions
/// whether intersections of constraints, and vertices on them, are searched before any cell is flipped, a Boolean.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(list_defects)

/// \ingroup PkgBoundaryRecovery3Functions
/// the largest number of defects that are listed, an integer.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(maximum_number_of_defects)

/// \ingroup PkgBoundaryRecovery3Functions
/// the largest growth of sizes per length, a number \f$ g \f$: \f$ h(p) \le h(q) + g |pq| \f$.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(grading)

/// \ingroup PkgBoundaryRecovery3Functions
/// the largest number of vertices of a mesh, an integer.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(maximum_number_of_vertices)

/// \ingroup PkgBoundaryRecovery3Functions
/// the target of the smallest dihedral angle of all cells, in degrees, a number.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(min_dihedral_angle)

/// \ingroup PkgBoundaryRecovery3Functions
/// the measure of the quality of cells: a model of `CellQuality_3`.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(cell_quality)

/// \ingroup PkgBoundaryRecovery3Functions
/// whether cells are improved after the field points are inserted, a Boolean.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(improve_quality)

/// \ingroup PkgBoundaryRecovery3Functions
/// the work that the improvement is worth: a value of `CGAL::Boundary_recovery_3::Improvement_effort`.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(improvement_effort)

/// \ingroup PkgBoundaryRecovery3Functions
/// the region of each tetrahedron of a mesh, a property map from positions to integers.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(cell_region_map)

/// \ingroup PkgBoundaryRecovery3Functions
/// facets of a mesh that stay: a range of arrays of three vertex indices.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(constrained_facets)

/// \ingroup PkgBoundaryRecovery3Functions
/// the number of layers of cells around bad cells that are remeshed, too, an integer.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(number_of_layers)

/// \ingroup PkgBoundaryRecovery3Functions
/// the number of sub-domains that are meshed at the same time, an integer.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(number_of_subdomains)

/// \ingroup PkgBoundaryRecovery3Functions
/// the largest number of threads that work on parts of a mesh at the same time, an integer; 0: as many as there are.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(number_of_threads)

/// \ingroup PkgBoundaryRecovery3Functions
/// one place in each region that is to be empty: a range of points.
CGAL_BOUNDARY_RECOVERY_3_PARAMETER(void_points)

#undef CGAL_BOUNDARY_RECOVERY_3_PARAMETER

} // namespace parameters
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_PARAMETERS_H
