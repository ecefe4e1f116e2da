// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_DOMAIN_SOUP_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_DOMAIN_SOUP_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

typedef std::uint32_t Point_number; // half as long as std::size_t: a mesh has millions of them

// The tetrahedra of a domain as a soup: what is written to files.
template <typename Point>
struct Domain_soup_3
{
  // input vertices in their order, then Steiner points, then field points by their regions; only those that are used
  std::vector<Point> points;
  std::vector<std::array<Point_number, 4> > tetrahedra;
  std::vector<int> regions;                             // of each tetrahedron
  std::vector<std::array<Point_number, 3> > triangles;  // the input faces that are in the triangulation, or their parts
  std::vector<std::size_t> triangle_numbers;            // of each triangle: the number of its face
  std::size_t number_of_steiner_points = 0; // those at tetrahedra of the domain
  std::size_t number_of_field_points = 0;   // and what the improvement made of them
};

// Collects a domain from a triangulation after its boundary was recovered.
template <typename Tr>
class Domain_builder_3
{
  typedef typename Tr::Vertex_handle        Vertex_handle;
  typedef typename Tr::Cell_handle          Cell_handle;
  typedef typename Tr::Geom_traits::Point_3 Point;

  static constexpr Point_number is_unused = (std::numeric_limits<Point_number>::max)();
  static constexpr Point_number is_of_facet = is_unused - 1;
  static constexpr Point_number is_of_outside = is_unused - 2; // of tetrahedra of region 0, if these are taken, too
  static constexpr Point_number is_of_region = is_unused - 3;

  const Tr& m_tr;
  Domain_soup_3<Point> m_domain;
  Unique_hash_map<Vertex_handle, Point_number> m_number;

public:
  explicit Domain_builder_3(const Tr& tr) : m_tr(tr), m_number(is_unused, tr.number_of_vertices())
  {
    if(tr.number_of_vertices() >= is_of_region)
      throw std::length_error("the mesh has too many vertices to be written");
  }

  // `region` tells the region that a cell is in, 0 for the outside, a negative number if it is not to be taken
  template <typename Result, typename Facets, typename Region>
  Domain_soup_3<Point> operator()(const Result& result, const Facets& facets, const Region& region)
  {
    mark_vertices(facets, region);
    for(const Vertex_handle v : result.vertices)
      add_vertex(v);
    for(const Vertex_handle v : result.steiner_vertices)
    {
      m_domain.number_of_steiner_points += m_number[v] == is_of_region;
      add_vertex(v);
    }
    add_field_points(region);
    add_simplices(facets, region);
    return std::move(m_domain);
  }

private:
  template <typename Facets, typename Region>
  void mark_vertices(const Facets& facets, const Region& region)
  {
    for(const auto& facet : facets)
      for(const Vertex_handle v : facet)
        m_number[v] = is_of_facet;
    std::size_t number_of_cells = 0;
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(region(c) >= 0)
      {
        mark_vertices(c, region(c) > 0 ? is_of_region : is_of_outside);
        ++number_of_cells;
      }
    m_domain.tetrahedra.reserve(number_of_cells);
    m_domain.regions.reserve(number_of_cells);
  }

  void mark_vertices(const Cell_handle c, const Point_number mark)
  {
    for(int i = 0; i < 4; ++i)
    {
      Point_number& number = m_number[c->vertex(i)];
      number = (std::min)(number, mark);
    }
  }

  // Equal input points are one vertex.
  void add_vertex(const Vertex_handle v)
  {
    Point_number& number = m_number[v];
    if(number < is_of_region || number == is_unused)
      return;
    number = static_cast<Point_number>(m_domain.points.size());
    m_domain.points.push_back(internal::bare_point<Point>(v->point()));
  }

  // All the cells of a field point are in one region. Those of a region come together, as Gmsh's files have them.
  template <typename Region>
  void add_field_points(const Region& region)
  {
    std::vector<Vertex_handle> vertices;
    for(const Vertex_handle v : m_tr.finite_vertex_handles())
      if(m_number[v] == is_of_region)
        vertices.push_back(v);
    std::stable_sort(vertices.begin(), vertices.end(), [&](const Vertex_handle u, const Vertex_handle v)
                     { return region(u->cell()) < region(v->cell()); });
    for(const Vertex_handle v : vertices)
      add_vertex(v);
    m_domain.number_of_field_points = vertices.size();
  }

  template <typename Facets, typename Region>
  void add_simplices(const Facets& facets, const Region& region)
  {
    for(const Cell_handle c : m_tr.finite_cell_handles())
    {
      const int r = region(c);
      if(r < 0)
        continue;
      m_domain.tetrahedra.push_back({{ m_number[c->vertex(0)], m_number[c->vertex(1)],
                                       m_number[c->vertex(2)], m_number[c->vertex(3)] }});
      m_domain.regions.push_back(r);
    }
    for(const auto& facet : facets)
    {
      m_domain.triangles.push_back({{ m_number[facet[0]], m_number[facet[1]], m_number[facet[2]] }});
      m_domain.triangle_numbers.push_back(facet.index);
    }
  }
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_DOMAIN_SOUP_3_H
