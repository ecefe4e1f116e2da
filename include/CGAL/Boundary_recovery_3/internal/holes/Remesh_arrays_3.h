// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_REMESH_ARRAYS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_REMESH_ARRAYS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Remesh_holes_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/input_conversion.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// In the place of a size field: the sizes are those of the old mesh.
struct Sizes_of_old_mesh { };

// See "Tuning constants" in the manual.
constexpr double default_angle_of_bad_cells = 10;
constexpr std::size_t default_number_of_layers = 2;

/*
 * Takes the arguments of remesh_holes(), whatever types they have, and returns its result.
 */
template <typename Kernel, typename NamedParameters>
class Remesh_arrays_3
{
public:
  typedef typename Kernel::Point_3          Point_3;
  typedef Moved_mesh_3<Point_3>             Mesh;
  typedef Hole_remeshing_result_3<Point_3>  Result;
  typedef Hole_remeshing_options_3<Point_3> Options;

  explicit Remesh_arrays_3(const NamedParameters& np) : m_np(np) { }

  template <typename PointRange, typename TetrahedronRange, typename SizingField>
  Result operator()(const PointRange& points, const TetrahedronRange& tetrahedra, const SizingField& size) const
  {
    Options options;
    set_sizes(size, options);
    set_selection(options);
    return (*this)(mesh(points, tetrahedra), options);
  }

  // `options` has the sizes, the selection, and what named parameters cannot say.
  Result operator()(Mesh&& mesh, Options options) const
  {
    typedef Remesh_holes_3<Kernel> Hole_remeshing;
    // it is not told of the cells in holes, which are of another triangulation than the caller's
    auto visitor = internal::mesh_visitor<typename Hole_triangulation_3<Kernel>::Tr, false>(m_np);
    typename Hole_remeshing::Context context(visitor);
    context.set_maximum_running_time(parameter_or(m_np, internal_np::maximum_running_time,
                                                  std::numeric_limits<double>::infinity()));
    options.can_go_further = [&] { return context.go_further(); };
    Result result;
    if(set_options(options))
      Hole_remeshing(mesh, options, context, result)();
    else
      result.status = Meshing_status::invalid_input;
    if(! result)
      return_old_mesh(std::move(mesh), result);
    result.seconds = context.seconds();
    return result;
  }

  template <typename SizingField>
  static void set_sizes(const SizingField& size, Options& options)
  {
    options.size = [&size](const Point_3& p, const int region)
    {
      return internal::size_of_field<Kernel>(size, p, 3, region);
    };
    options.grading = internal::grading_of_field<Kernel, SizingField>(size);
  }

  static void set_sizes(const Sizes_of_old_mesh&, Options&) { }

private:
  static constexpr bool has_selection = ! parameters::is_default_parameter<NamedParameters,
                                                                           internal_np::cell_selector_t>::value;

  // Returns false if they are not possible.
  bool set_options(Options& options) const
  {
    options.min_dihedral_angle = parameter_or(m_np, internal::min_dihedral_angle,
                                              has_selection ? 0. : default_angle_of_bad_cells);
    options.target_angle = (std::max)(options.min_dihedral_angle, default_min_dihedral_angle);
    options.number_of_layers = parameter_or(m_np, internal::number_of_layers, default_number_of_layers);
    options.improve_quality = parameter_or(m_np, internal::improve_quality, true);
    return is_possible_target(options.min_dihedral_angle);
  }

  void set_selection(Options& options) const
  {
    if constexpr(has_selection)
      options.is_selected = [map = parameters::get_parameter(m_np, internal_np::cell_selector)](const std::size_t c)
      {
        using boost::get;
        return bool(get(map, c));
      };
    else
      options.is_selected = [](const std::size_t) { return false; };
  }

  template <typename PointRange, typename TetrahedronRange>
  Mesh mesh(const PointRange& points, const TetrahedronRange& tetrahedra) const
  {
    typedef std::decay_t<decltype(*std::begin(points))> Value;
    const auto point_map = parameters::choose_parameter<Identity_property_map<Value> >(
      parameters::get_parameter(m_np, internal_np::point_map));
    using boost::get;
    Mesh mesh;
    mesh.points.reserve(static_cast<std::size_t>(std::distance(std::begin(points), std::end(points))));
    for(const auto& p : points)
      mesh.points.push_back(get(point_map, p));
    mesh.tetrahedra.reserve(static_cast<std::size_t>(std::distance(std::begin(tetrahedra), std::end(tetrahedra))));
    for(const auto& t : tetrahedra)
      mesh.tetrahedra.push_back({{ std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]), std::size_t(t[3]) }});
    mesh.regions.assign(mesh.tetrahedra.size(), 1);
    if constexpr(! parameters::is_default_parameter<NamedParameters, cell_region_map_t>::value)
    {
      const auto region_map = parameters::get_parameter(m_np, internal::cell_region_map);
      for(std::size_t c = 0; c < mesh.regions.size(); ++c)
        mesh.regions[c] = static_cast<int>(get(region_map, c));
    }
    add_constraints(mesh);
    return mesh;
  }

  void add_constraints(Mesh& mesh) const
  {
    if constexpr(! parameters::is_default_parameter<NamedParameters, constrained_facets_t>::value)
    {
      const auto facets = parameters::get_parameter(m_np, internal::constrained_facets);
      for(const auto& f : facets)
        mesh.facets.push_back({{ std::size_t(f[0]), std::size_t(f[1]), std::size_t(f[2]) }});
    }
    internal::for_each_constrained_edge(m_np, [&](const std::size_t u, const std::size_t v)
    {
      mesh.edges.push_back({{ u, v }});
    });
  }

  static void return_old_mesh(Mesh&& mesh, Result& result)
  {
    result.points = std::move(mesh.points);
    result.tetrahedra = std::move(mesh.tetrahedra);
    result.regions = std::move(mesh.regions);
    result.facets = std::move(mesh.facets);
    result.edges = std::move(mesh.edges);
    result.old_vertices.resize(result.points.size());
    std::iota(result.old_vertices.begin(), result.old_vertices.end(), std::size_t(0));
    result.old_cells.resize(result.tetrahedra.size());
    std::iota(result.old_cells.begin(), result.old_cells.end(), std::size_t(0));
    result.number_of_kept_vertices = result.points.size();
    result.number_of_kept_cells = result.tetrahedra.size();
  }

  const NamedParameters& m_np;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_REMESH_ARRAYS_3_H
