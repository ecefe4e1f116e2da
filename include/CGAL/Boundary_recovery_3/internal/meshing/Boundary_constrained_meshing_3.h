// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_BOUNDARY_CONSTRAINED_MESHING_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_BOUNDARY_CONSTRAINED_MESHING_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Surface_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mark_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/regions_at_places.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_in_subdomains_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Part_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Keeps the vertices that the result of the recovery names true while the mesh is improved: those of the input stay
 * where they are, for which those that no facet has are corners in the meantime. Steiner points may move and go; then
 * they are no longer named.
 */
template <typename Tr>
class Hold_recovered_vertices_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Point             Point;
  typedef Boundary_recovery_result_3<Tr> Recovery;

  Hold_recovered_vertices_3(const Tr& tr, Recovery& recovery)
    : m_tr(tr), m_recovery(recovery)
  {
    for(const Vertex_handle v : recovery.vertices)
      if(v->in_dimension() == 3)
      {
        v->set_dimension(0);
        m_corners.push_back(v);
      }
    for(const Vertex_handle v : recovery.steiner_vertices)
      m_places.push_back(v->point());
  }

  Hold_recovered_vertices_3(const Hold_recovered_vertices_3&) = delete;
  Hold_recovered_vertices_3& operator=(const Hold_recovered_vertices_3&) = delete;

  ~Hold_recovered_vertices_3()
  {
    for(const Vertex_handle v : m_corners)
      v->set_dimension(3);
  }

  // A new vertex may have got the handle of one that went, but hardly its place, and then it is as good.
  void forget_lost_steiner_vertices()
  {
    std::vector<Vertex_handle>& vertices = m_recovery.steiner_vertices;
    if(vertices.empty())
      return;
    Unique_hash_map<Vertex_handle, std::size_t> position; // for looking up only
    for(std::size_t i = 0; i < vertices.size(); ++i)
      position[vertices[i]] = i;
    std::vector<char> is_there(vertices.size(), false);
    for(const Vertex_handle v : m_tr.finite_vertex_handles())
      if(position.is_defined(v))
        is_there[position[v]] = v->point() == m_places[position[v]];
    std::size_t number = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(is_there[i])
        vertices[number++] = vertices[i];
    vertices.resize(number);
  }

private:
  const Tr& m_tr;
  Recovery& m_recovery;
  std::vector<Vertex_handle> m_corners;
  std::vector<Point> m_places; // of the Steiner points
};

// What is asked of the mesher, beside the surface and the sizes, as make_boundary_constrained_mesh_3() documents it.
// The limits are those of all steps together.
struct Meshing_options
  : public Improvement_options
{
  double      grading = default_surface_grading;
  bool        improve_quality = true;
  std::size_t number_of_subdomains = 1;
};

template <typename Tr, typename NamedParameters>
Meshing_options meshing_options(const NamedParameters& np)
{
  Meshing_options options;
  static_cast<Improvement_options&>(options) = internal::improvement_options<Tr>(np);
  options.grading = parameter_or(np, internal::grading, options.grading);
  options.improve_quality = parameter_or(np, internal::improve_quality, options.improve_quality);
  options.number_of_subdomains = parameter_or(np, internal::number_of_subdomains, options.number_of_subdomains);
  return options;
}

// Whether sub-domains can be triangulations of this type, too: vertices keep the sizes, and the traits have no state.
template <typename Tr>
using Can_be_divided = std::conjunction<Has_meshing_info<typename Tr::Vertex>,
                                        std::is_default_constructible<typename Tr::Geom_traits> >;

// The surface, however it was passed.
template <typename Tr>
struct Surface_to_mesh_3
{
  typedef Boundary_recovery_result_3<Tr>                  Recovery;
  typedef typename Mark_domain_3<Tr>::Surface_patch_index Patch;
  typedef std::vector<typename Recovery::Surface_facet>   Facets;

  std::function<Recovery(Mesh_visitor_3<Tr>&)>     recover;
  std::function<std::vector<Patch>(const Facets&)> patches;           // of its facets, as the recovery lists them
  std::vector<std::array<std::size_t, 2> >         constrained_edges; // between points, beside those of the facets
  std::vector<typename Tr::Point>                  void_points;       // in regions that are to be empty
};

// The mesh edges that the constrained edges of the input consist of.
template <typename Tr>
struct Constrained_mesh_edges_3
{
  typedef std::array<typename Tr::Vertex_handle, 2> Vertex_pair;

  Constrained_mesh_edges_3(const Boundary_recovery_result_3<Tr>& recovery,
                           const std::vector<std::array<std::size_t, 2> >& constrained_edges)
  {
    // parts of one constraint come one after the other
    Simplex_index_3<std::size_t, 2> index;
    std::vector<std::size_t> begin;
    const auto& parts = recovery.parts_of_edges;
    const auto ends = [&](const std::size_t p) -> std::array<std::size_t, 2>
    {
      return {{ parts[p].constraint.vertices[0], parts[p].constraint.vertices[1] }};
    };
    for(std::size_t p = 0; p < parts.size(); ++p)
      if(index.insert(ends(p)).second)
        begin.push_back(p);
    begin.push_back(parts.size());

    std::size_t number = 0;
    for(const auto& e : constrained_edges)
    {
      ++number;
      const std::size_t k = index[e];
      if(k == index.none)
        add({{ recovery.vertices[e[0]], recovery.vertices[e[1]] }}, number);
      else
        for(std::size_t p = begin[k]; p < begin[k + 1]; ++p)
          add({{ parts[p].vertices[0], parts[p].vertices[1] }}, number);
    }
  }

  std::vector<Vertex_pair> edges;
  std::vector<std::size_t> numbers; // of the constrained edges that they are parts of, from 1 on

private:
  void add(const Vertex_pair& edge, const std::size_t number)
  {
    edges.push_back(edge);
    numbers.push_back(number);
  }
};

/*
 * The work behind all the overloads of make_boundary_constrained_mesh_3(): one step after the other, as long as there
 * is something to do and time for it.
 */
template <typename Tr, typename Quality>
class Boundary_constrained_meshing_3
{
public:
  typedef Boundary_constrained_mesh_result_3<Tr>          Result;
  typedef Surface_to_mesh_3<Tr>                           Surface;
  typedef Size_field_3<typename Tr::Geom_traits::Point_3> Size_field;

  Boundary_constrained_meshing_3(Tr& tr, const Quality& quality, const Meshing_options& options,
                                 Mesh_visitor_3<Tr>& visitor)
    : m_tr(tr), m_quality(quality), m_options(options), m_visitor(visitor, m_result.phases), m_context(m_visitor)
  {
    m_context.set_maximum_running_time(options.maximum_running_time);
  }

  Boundary_constrained_meshing_3(const Boundary_constrained_meshing_3&) = delete;
  Boundary_constrained_meshing_3& operator=(const Boundary_constrained_meshing_3&) = delete;

  // Without a size field, the sizes come from the surface. To be called once.
  Result operator()(const Surface& surface, const Size_field* size);

private:
  static Meshing_status status(const Recovery_status status)
  {
    switch(status)
    {
      case Recovery_status::recovered:     return Meshing_status::meshed;
      case Recovery_status::incomplete:    return Meshing_status::incomplete;
      case Recovery_status::invalid_input: return Meshing_status::invalid_input;
      case Recovery_status::stopped:       return Meshing_status::stopped;
    }
    return Meshing_status::incomplete;
  }

  // It takes so little time that it is always done, so that a mesh that was stopped has its regions, too.
  void mark_domain(const Surface& surface)
  {
    m_context.run(Phase::domain_marking, [&]
    {
      const auto facets = m_result.recovery.surface_facets();
      const Constrained_mesh_edges_3<Tr> edges(m_result.recovery, surface.constrained_edges);
      m_result.number_of_regions = Mark_domain_3<Tr>(m_tr)(facets, surface.patches(facets), edges.edges,
                                                           edges.numbers);
      empty_regions(surface.void_points);
      m_result.constrained_edges = edges.edges;
    },
    [this](Phase_report& report)
    {
      report.number_of_vertices = m_tr.number_of_vertices();
      report.number_of_cells = internal::number_of_finite_cells(m_tr);
    });
  }

  void empty_regions(const std::vector<typename Tr::Point>& places)
  {
    if constexpr(std::is_same<typename Cell_indices<typename Tr::Cell>::Subdomain_index, int>::value)
      if(! places.empty() && m_result.number_of_regions > 0)
        m_result.number_of_regions = internal::empty_regions(m_tr, places, m_result.number_of_regions,
                                                             m_result.invalid_void_points);
  }

  void fill_and_improve(const Size_field* size)
  {
    if(size)
      return mesh(*size);
    if(! (m_options.grading >= 0 && m_options.grading < std::numeric_limits<double>::infinity()))
      return refuse_grading();
    typedef Surface_sizing_field_3<Tr> Surface_size;
    const Surface_size surface_size(m_tr, m_options.grading, m_result.constrained_edges);
    mesh(Any_size_field_3<typename Tr::Geom_traits, Surface_size>(surface_size));
  }

  void mesh(const Size_field& size)
  {
    if constexpr(Can_be_divided<Tr>::value)
      if(m_options.number_of_subdomains > 1)
        return internal::with_threads(m_options.concurrency.number_of_threads.value_or(0),
                                      [&] { mesh_in_subdomains(size); });
    mesh_undivided(size);
  }

  void mesh_undivided(const Size_field& size)
  {
    Selected_domain_3<Tr> domain = internal::domain_with_edges(m_tr, m_result.constrained_edges);
    Field_point_insertion_3<Tr> insert_field_points(m_tr, domain, size, m_visitor);
    insert_field_points.set_concurrency(m_options.concurrency);
    m_result.filling = insert_field_points(m_options.max_number_of_vertices, m_context.seconds_left());
    m_result.status = m_result.improvement.status = m_result.filling.status;
    if(! m_result.filling || ! m_options.improve_quality)
      return;
    Hold_recovered_vertices_3<Tr> hold(m_tr, m_result.recovery);
    Improve_quality_3<Tr, Quality> improve(m_tr, domain, m_quality, m_options.max_number_of_vertices, m_visitor);
    improve.set_concurrency(m_options.concurrency);
    m_result.improvement = improve(m_options.min_dihedral_angle, m_options.effort, m_context.seconds_left());
    m_result.status = m_result.improvement.status;
    hold.forget_lost_steiner_vertices();
  }

  void mesh_in_subdomains(const Size_field& size)
  {
    Hold_recovered_vertices_3<Tr> hold(m_tr, m_result.recovery);
    Mesh_in_subdomains_3<Tr, Quality>(m_tr, size, m_quality, m_options.min_dihedral_angle, m_options.effort,
                                      m_options.max_number_of_vertices, m_context, m_result)(
      m_options.number_of_subdomains, m_options.improve_quality);
    hold.forget_lost_steiner_vertices();
    if(! m_result.filling)
      m_result.improvement.status = m_result.filling.status;
    m_result.status = m_result.improvement.status;
  }

  // It is no size, but what would make all of them.
  void refuse_grading()
  {
    m_result.status = m_result.filling.status = Meshing_status::invalid_input;
    m_result.filling.invalid_sizes.push_back({ m_tr.finite_vertices_begin()->point(), m_options.grading,
                                               "it is the grading, which has to be finite and not negative" });
  }

  Tr& m_tr;
  const Quality& m_quality;
  const Meshing_options& m_options;
  Result m_result;
  Recording_visitor_3<Tr> m_visitor;
  Recovery_context<Tr> m_context;
};

template <typename Tr, typename Quality>
Boundary_constrained_mesh_result_3<Tr>
Boundary_constrained_meshing_3<Tr, Quality>::operator()(const Surface& surface, const Size_field* size)
{
  m_result.recovery = surface.recover(m_visitor);
  m_result.status = status(m_result.recovery.status);
  if(m_result.recovery)
  {
    mark_domain(surface);
    if(! m_result.invalid_void_points.empty())
      m_result.status = Meshing_status::invalid_input;
    else if(m_result.number_of_regions == 0)
      m_result.status = Meshing_status::no_region;
    else if(! m_context.go_further())
      m_result.status = m_result.filling.status = m_result.improvement.status = Meshing_status::stopped;
    else
      fill_and_improve(size);
  }
  m_result.seconds = m_context.seconds();
  return std::move(m_result);
}

#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED

extern template Boundary_constrained_mesh_result_3<Standard_mesh>
Boundary_constrained_meshing_3<Standard_mesh, Dihedral_angle_quality_3>::operator()(
  const Surface_to_mesh_3<Standard_mesh>&, const Size_field_3<Standard_kernel::Point_3>*);

#endif // CGAL_BOUNDARY_RECOVERY_3_COMPILED

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_BOUNDARY_CONSTRAINED_MESHING_3_H
