// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_SURFACE_SIZES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_SURFACE_SIZES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Cone_minimum_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Unit_frame_3.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// A surface as a size field sees it: the places of its vertices, and its edges, each once.
struct Surface_edges_3
{
  std::vector<Coordinates_3> points;
  std::vector<std::pair<std::size_t, std::size_t> > edges;

  void add_triangle(const std::array<std::size_t, 3>& t)
  {
    for(int i = 0; i < 3; ++i)
      edges.push_back(std::minmax(t[i], t[(i + 1) % 3]));
  }

  void remove_duplicates()
  {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }
};

// The region of a cell, 0 outside of the convex hull, whatever is written there.
template <typename Tr>
typename Tr::Cell::Subdomain_index region_of(const Tr& tr, const typename Tr::Cell_handle c)
{
  return tr.is_infinite(c) ? typename Tr::Cell::Subdomain_index() : c->subdomain_index();
}

// Those of facets that are marked, or are between two regions, and of other edges, given by pairs of vertices.
template <typename Tr, typename VertexPairRange>
Surface_edges_3 surface_edges_and(const Tr& tr, const VertexPairRange& edges)
{
  Surface_edges_3 surface;
  Unique_hash_map<typename Tr::Vertex_handle, std::size_t> numbers(tr.number_of_vertices());
  const auto number = [&](const typename Tr::Vertex_handle v)
  {
    if(! numbers.is_defined(v))
    {
      numbers[v] = surface.points.size();
      surface.points.push_back(coordinates_of(v->point()));
    }
    return numbers[v];
  };
  if(tr.dimension() == 3)
    for(const auto& f : tr.finite_facets())
    {
      const typename Tr::Cell_handle c = f.first, d = c->neighbor(f.second);
      if(! c->is_facet_on_surface(f.second) && region_of(tr, c) == region_of(tr, d))
        continue;
      std::array<std::size_t, 3> triangle;
      for(int i = 0; i < 3; ++i)
        triangle[i] = number(c->vertex(Tr::vertex_triple_index(f.second, i)));
      surface.add_triangle(triangle);
    }
  for(const auto& edge : edges)
  {
    const std::size_t first = number(edge[0]), second = number(edge[1]);
    surface.edges.push_back(std::minmax(first, second));
  }
  surface.remove_duplicates();
  return surface;
}

template <typename PointRange, typename TriangleRange>
Surface_edges_3 surface_edges(const PointRange& points, const TriangleRange& triangles)
{
  Surface_edges_3 surface;
  for(const auto& p : points)
    surface.points.push_back(coordinates_of(p));
  for(const auto& t : triangles)
    surface.add_triangle({{ std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]) }});
  surface.remove_duplicates();
  return surface;
}

// The size at each vertex is the mean length of the edges there.
inline std::vector<Cone_minimum_3::Site> sites_of_surface(const Surface_edges_3& surface)
{
  std::vector<std::size_t> degrees(surface.points.size());
  std::vector<double> sums(surface.points.size());
  for(const auto& edge : surface.edges)
  {
    const Coordinates_3 d = difference(surface.points[edge.second], surface.points[edge.first]);
    const double length = std::hypot(d[0], d[1], d[2]);
    for(const std::size_t i : { edge.first, edge.second })
      if(length > 0)
      {
        ++degrees[i];
        sums[i] += length;
      }
  }
  std::vector<Cone_minimum_3::Site> sites;
  for(std::size_t i = 0; i < degrees.size(); ++i)
    if(degrees[i] > 0)
      sites.push_back(Cone_minimum_3::Site{ surface.points[i], sums[i] / static_cast<double>(degrees[i]) });
  return sites;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_SURFACE_SIZES_H
