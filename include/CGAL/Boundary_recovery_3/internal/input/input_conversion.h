// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INPUT_CONVERSION_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INPUT_CONVERSION_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Recover_indexed_boundary.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

template <typename NamedParameters>
Recovery_options recovery_options(const NamedParameters& np)
{
  Recovery_options options;
  options.mode = parameter_or(np, internal::recovery_mode, options.mode);
  options.effort = parameter_or(np, internal::effort, options.effort);
  options.max_recursion_level = parameter_or(np, internal::max_recursion_level, options.max_recursion_level);
  options.maximum_running_time = parameter_or(np, internal_np::maximum_running_time, options.maximum_running_time);
  options.list_defects = parameter_or(np, internal::list_defects, options.list_defects);
  options.maximum_number_of_defects = parameter_or(np, internal::maximum_number_of_defects,
                                                   options.maximum_number_of_defects);
  return options;
}

// Runs the recovery of indexed input with the caller's traits and visitor.
template <typename Tr, typename NamedParameters>
Boundary_recovery_result_3<Tr>
recover_indexed_boundary(Tr& tr, const Indexed_input_3<typename Tr::Geom_traits::Point_3>& input,
                         std::vector<typename Tr::Vertex_handle> vertices, const NamedParameters& np)
{
  auto visitor = internal::mesh_visitor<Tr>(np);
  const auto traits = parameters::choose_parameter(parameters::get_parameter(np, internal_np::geom_traits),
                                                   tr.geom_traits());
  const Recovery_options options = recovery_options(np);
  typedef std::decay_t<decltype(traits)> GT;
  return Recover_indexed_boundary<Tr, GT>(tr, input, traits, options, visitor)(std::move(vertices));
}

// Edges that are no edges of facets: a range of arrays of two indices or handles, if it was given.
template <typename NamedParameters, typename Add>
void for_each_constrained_edge(const NamedParameters& np, const Add& add)
{
  if constexpr(! parameters::is_default_parameter<NamedParameters, internal::constrained_edges_t>::value)
  {
    const auto edges = parameters::get_parameter(np, internal::constrained_edges);
    for(const auto& e : edges)
      add(e[0], e[1]);
  }
}

// The size of a range that knows it, else 0. To be called with 0 as the second argument.
template <typename Range>
auto size_or_zero(const Range& range, int) -> decltype(static_cast<std::size_t>(range.size()))
{
  return static_cast<std::size_t>(range.size());
}

template <typename Range>
std::size_t size_or_zero(const Range&, long) { return 0; }

/*
 * Brings soups and surface meshes into index form.
 */
template <typename Tr>
class Input_conversion
{
public:
  typedef typename Tr::Geom_traits::Point_3      Point_3;
  typedef Boundary_recovery_result_3<Tr>         Result;

  void reserve(const std::size_t number_of_points, const std::size_t number_of_facets)
  {
    m_input.points.reserve(number_of_points);
    m_input.facets.reserve(number_of_facets);
  }

  void add_point(const Point_3& p) { m_input.points.push_back(p); }

  template <typename Face>
  void add_facet(const Face& face)
  {
    Vertices v;
    for(const auto i : face)
      v.push_back(static_cast<std::size_t>(i));
    add_vertices(v);
  }

  template <typename FaceListGraph, typename PointMap>
  void add_surface(const FaceListGraph& surface, const PointMap& point_map)
  {
    typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
    reserve(num_vertices(surface), num_faces(surface));
    std::unordered_map<vertex_descriptor, std::size_t> index; // look-up only
    for(const auto v : vertices(surface))
    {
      index.emplace(v, m_input.points.size());
      add_point(get(point_map, v));
    }
    for(const auto f : faces(surface))
    {
      Vertices v;
      for(const auto w : CGAL::vertices_around_face(halfedge(f, surface), surface))
        v.push_back(index[w]);
      add_vertices(v);
    }
  }

  template <typename NamedParameters>
  Result recover(Tr& tr, const NamedParameters& np)
  {
    for_each_constrained_edge(np, [&](const std::size_t u, const std::size_t v)
    {
      m_input.edges.push_back({{ u, v }});
    });
    if(! m_not_triangles.empty())
      return report_other_faces(recovery_options(np).maximum_number_of_defects);
    return recover_indexed_boundary(tr, m_input, std::vector<typename Tr::Vertex_handle>(), np);
  }

private:
  typedef boost::container::small_vector<std::size_t, 4> Vertices;

  void add_vertices(const Vertices& v)
  {
    if(v.size() == 3)
      m_input.facets.push_back({{ v[0], v[1], v[2] }});
    else
      m_not_triangles.push_back(describe_simplex(m_input, m_input.facets.size() + m_not_triangles.size(), v));
  }

  Result report_other_faces(const std::size_t max_number_of_defects) const
  {
    Result result;
    result.status = Recovery_status::invalid_input;
    result.number_of_facets = m_input.facets.size() + m_not_triangles.size();
    result.number_of_edges = internal::number_of_edges(m_input);
    for(auto face : m_not_triangles)
    {
      face.dimension = 2;
      result.defects.push_back({ Input_defect_kind::not_a_triangle, { face } });
    }
    internal::bound_defects(result, max_number_of_defects);
    return result;
  }

  Indexed_input_3<Point_3> m_input;
  std::vector<Input_simplex_3<Point_3> > m_not_triangles;
};

/*
 * Brings facets and edges between vertex handles into index form.
 */
template <typename Tr>
class Handle_conversion
{
public:
  typedef typename Tr::Vertex_handle             Vertex_handle;
  typedef typename Tr::Geom_traits::Point_3      Point_3;
  typedef Boundary_recovery_result_3<Tr>         Result;

  explicit Handle_conversion(const Tr& tr) : m_tr(tr) { }

  template <typename Facet>
  void add_facet(const Facet& f) { m_input.facets.push_back({{ index(f[0]), index(f[1]), index(f[2]) }}); }

  template <typename NamedParameters>
  Result recover(Tr& tr, const NamedParameters& np)
  {
    for_each_constrained_edge(np, [&](const Vertex_handle u, const Vertex_handle v)
                                  { m_input.edges.push_back({{ index(u), index(v) }}); });
    if(! m_unknown.empty())
      return report_unknown_vertices(recovery_options(np).maximum_number_of_defects);
    return recover_indexed_boundary(tr, m_input, std::move(m_vertices), np);
  }

private:
  bool is_known(const Vertex_handle v) const
  {
    return v != Vertex_handle() && m_tr.tds().is_vertex(v) && ! m_tr.is_infinite(v);
  }

  std::size_t index(const Vertex_handle v)
  {
    const auto inserted = m_indices.emplace(v == Vertex_handle() ? nullptr : &*v, m_vertices.size());
    if(inserted.second)
    {
      m_vertices.push_back(v);
      m_input.points.push_back(is_known(v) ? v->point() : Point_3(ORIGIN));
      if(! is_known(v))
        m_unknown.push_back(m_vertices.size() - 1);
    }
    return inserted.first->second;
  }

  Result report_unknown_vertices(const std::size_t max_number_of_defects) const
  {
    Result result;
    result.status = Recovery_status::invalid_input;
    result.number_of_facets = m_input.facets.size();
    result.number_of_edges = internal::number_of_edges(m_input);
    for(const std::size_t v : m_unknown)
    {
      Input_simplex_3<Point_3> vertex;
      vertex.dimension = 0;
      vertex.index = v;
      vertex.vertices.assign(1, v);
      result.defects.push_back({ Input_defect_kind::unknown_vertex, { vertex } });
    }
    internal::bound_defects(result, max_number_of_defects);
    return result;
  }

  const Tr& m_tr;
  Indexed_input_3<Point_3> m_input;
  std::vector<Vertex_handle> m_vertices;
  std::vector<std::size_t> m_unknown;                          // indices of handles that are not of the triangulation
  std::unordered_map<const void*, std::size_t> m_indices; // look-up only
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INPUT_CONVERSION_H
