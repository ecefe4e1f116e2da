// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_FACET_FAN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_FACET_FAN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/steiner/Half_facet_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Origin.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The mesh facets s v_i v_{i+1} of a planar polygon around a vertex s, and the triangles that come in their place when
 * s leaves it. The fan is closed if s is in the interior of the polygon, else s is on its boundary.
 */
template <typename Tr>
struct Facet_fan_3
{
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef Half_facet_3<Tr>                     Half_facet;
  typedef std::array<Vertex_handle, 2>         Vertex_pair;
  typedef std::array<Vertex_handle, 3>         Vertex_triple;
  typedef Simple_cartesian<double>::Vector_3   Vector;

  std::vector<Half_facet> facets;       // in their order around s, all on one side of the fan, its positive one
  bool is_closed;
  std::vector<Vertex_triple> triangles; // seen from the positive side
  Vector normal = NULL_VECTOR;          // of the triangles, approximately, and of any length

  // Whether the facet s v w is in the fan.
  bool contains(const Vertex_handle v, const Vertex_handle w) const
  {
    return std::any_of(facets.begin(), facets.end(), [&](const Half_facet& h)
    {
      return (h.v == v && h.w == w) || (h.v == w && h.w == v);
    });
  }

  // Whether v is a vertex of the polygon.
  bool has_vertex(const Vertex_handle v) const
  {
    return std::any_of(facets.begin(), facets.end(), [&](const Half_facet& h) { return h.v == v || h.w == v; });
  }

  // The vertices around s.
  std::vector<Vertex_handle> polygon() const
  {
    std::vector<Vertex_handle> result;
    for(const Half_facet& h : facets)
      result.push_back(h.v);
    if(! is_closed)
      result.push_back(facets.back().w);
    return result;
  }

  // The closed fan of these facets, which may be in any order; none if it is not closed.
  static std::optional<Facet_fan_3> closed(std::vector<Half_facet> facets)
  {
    if(facets.empty() || ! sort(facets) || facets.back().w != facets.front().v)
      return std::nullopt;
    return Facet_fan_3{ std::move(facets), true, std::vector<Vertex_triple>() };
  }

  // The open fan of these facets from one of the ends to the other, preferably from the first, if it is one.
  static std::optional<Facet_fan_3> open(std::vector<Half_facet> facets, const Vertex_pair& ends)
  {
    auto first = find(facets, 0, ends[0]);
    if(first == facets.end())
      first = find(facets, 0, ends[1]);
    if(first == facets.end())
      return std::nullopt;
    std::iter_swap(first, facets.begin());
    if(! sort(facets) || ! internal::contains(ends, facets.back().w))
      return std::nullopt;
    return Facet_fan_3{ std::move(facets), false, std::vector<Vertex_triple>() };
  }

private:
  static auto find(std::vector<Half_facet>& facets, const std::size_t from, const Vertex_handle v)
  {
    return std::find_if(facets.begin() + from, facets.end(), [&](const Half_facet& h) { return h.v == v; });
  }

  // Puts the facets in their order around s, from the first on. Returns false if each is not followed by another.
  static bool sort(std::vector<Half_facet>& facets)
  {
    for(std::size_t i = 1; i < facets.size(); ++i)
    {
      const auto next = find(facets, i, facets[i - 1].w);
      if(next == facets.end())
        return false;
      std::iter_swap(next, facets.begin() + i);
    }
    return true;
  }
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_FACET_FAN_3_H
