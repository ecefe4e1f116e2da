// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INDEXED_INPUT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INDEXED_INPUT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

// The input in index form, and the few questions about it that every part of the diagnosis asks.

namespace CGAL::Boundary_recovery_3::internal {

/// the input in index form: what all overloads of `recover_boundary()` are turned into.
template <typename Point_3_>
struct Indexed_input_3
{
  typedef Point_3_                   Point_3;
  typedef std::array<std::size_t, 3> Facet;
  typedef std::array<std::size_t, 2> Edge;

  std::vector<Point_3> points;
  std::vector<Facet> facets; ///< as given by the caller; the position is the input index
  std::vector<Edge> edges;   ///< constrained edges that were given beside the facets
};

/// returns `true` iff no coordinate of `p` is NaN or infinite.
/// Looks at enclosures only: the exact value of a lazy number that was made from a NaN must never be asked for
/// (GMP ends the program). An enclosure that is unbounded on one side only is that of a huge, but finite number; one
/// that is unbounded on both sides may come from a NaN, so it is refused, though huge numbers may cancel out in it.
template <typename Point_3>
bool has_finite_coordinates(const Point_3& p)
{
  for(int i = 0; i < 3; ++i)
  {
    const auto enclosure = CGAL::to_interval(p[i]);
    if(! std::isfinite(enclosure.first) && ! std::isfinite(enclosure.second))
      return false;
  }
  return true;
}

/// returns `true` iff all vertices of `simplex` exist.
template <typename Point_3, typename Simplex>
bool is_in_range(const Indexed_input_3<Point_3>& input, const Simplex& simplex)
{
  return std::all_of(simplex.begin(), simplex.end(),
                     [&](const std::size_t v) { return v < input.points.size(); });
}

/// returns `true` iff all vertices of `simplex` exist and have finite coordinates: predicates may look at it.
template <typename Point_3, typename Simplex>
bool has_geometry(const Indexed_input_3<Point_3>& input, const Simplex& simplex)
{
  return is_in_range(input, simplex) &&
         std::all_of(simplex.begin(), simplex.end(),
                     [&](const std::size_t v) { return has_finite_coordinates(input.points[v]); });
}

/// returns `true` iff the vertices of the facet are collinear.
/// \pre `has_geometry(input, facet)`
template <typename GT>
bool is_degenerate(const Indexed_input_3<typename GT::Point_3>& input,
                   const std::array<std::size_t, 3>& facet, const GT& gt)
{
  return has_repeated_vertex(facet)
      || gt.collinear_3_object()(input.points[facet[0]], input.points[facet[1]], input.points[facet[2]]);
}

/// returns `true` iff both ends of the edge are at one point.
/// \pre `has_geometry(input, edge)`
template <typename GT>
bool is_degenerate(const Indexed_input_3<typename GT::Point_3>& input,
                   const std::array<std::size_t, 2>& edge, const GT& gt)
{
  return edge[0] == edge[1] || gt.equal_3_object()(input.points[edge[0]], input.points[edge[1]]);
}

/// calls `visit` with each constrained edge once, and its index: those given as edges, then the others of facets, which
/// have none.
template <typename Point_3, typename Visit>
void for_each_edge(const Indexed_input_3<Point_3>& input, const Visit& visit)
{
  typedef typename Indexed_input_3<Point_3>::Edge Edge;
  Simplex_index_3<std::size_t, 2> visited;
  const auto visit_once = [&](const std::size_t index, const Edge& e)
  {
    if(visited.insert(e).second)
      visit(index, e);
  };
  for(std::size_t e = 0; e < input.edges.size(); ++e)
    visit_once(e, input.edges[e]);
  for(const auto& f : input.facets)
    for(int i = 0; i < 3; ++i)
      visit_once(Input_simplex_3<Point_3>::no_index, {{ f[i], f[(i + 1) % 3] }});
}

/// returns the number of constrained edges, those of the facets included.
template <typename Point_3>
std::size_t number_of_edges(const Indexed_input_3<Point_3>& input)
{
  std::size_t n = 0;
  internal::for_each_edge(input, [&n](std::size_t, const auto&) { ++n; });
  return n;
}

/// returns, for each point, whether it is finite and is used by a facet or an edge whose indices are all in range.
template <typename Point_3>
std::vector<char> used_vertices(const Indexed_input_3<Point_3>& input)
{
  std::vector<char> used(input.points.size(), false);
  const auto use = [&](const auto& simplex)
  {
    if(is_in_range(input, simplex))
      for(const std::size_t v : simplex)
        used[v] = true;
  };
  std::for_each(input.facets.begin(), input.facets.end(), use);
  std::for_each(input.edges.begin(), input.edges.end(), use);

  for(std::size_t v = 0; v < used.size(); ++v)
    if(used[v] && ! has_finite_coordinates(input.points[v]))
      used[v] = false;
  return used;
}

/// of vertices in increasing order, makes the smallest one at each point the representative of the others. It hashes
/// coordinates of a floating-point type, which takes less than a tenth of the time of sorting. It sorts exact numbers:
/// what is known of them at once is an enclosure only, and may differ from that of an equal number.
template <typename GT>
void represent_equal_points(const Indexed_input_3<typename GT::Point_3>& input,
                            std::vector<std::size_t> vertices, const GT& gt,
                            std::vector<std::size_t>& representative)
{
  const std::vector<typename GT::Point_3>& points = input.points;
  typedef std::decay_t<decltype(points[0][0])> FT;
  if constexpr(std::is_floating_point<FT>::value)
  {
    const auto hash = [&](const std::size_t v)
    {
      const std::hash<FT> h;
      return internal::mixed_bits(h(points[v][0])
                                  + internal::mixed_bits(h(points[v][1]) + internal::mixed_bits(h(points[v][2]))));
    };
    const auto equal = gt.equal_3_object();
    const auto are_equal = [&](const std::size_t a, const std::size_t b) { return equal(points[a], points[b]); };
    Hash_index<std::size_t, decltype(hash), decltype(are_equal)> index(hash, are_equal);
    index.reserve(vertices.size());
    for(const std::size_t v : vertices)
      representative[v] = index.keys()[index.insert(v).first];
  }
  else
  {
    const auto compare = gt.compare_xyz_3_object();
    std::sort(vertices.begin(), vertices.end(), [&](const std::size_t a, const std::size_t b)
    {
      const Comparison_result c = (a == b) ? EQUAL : compare(points[a], points[b]);
      return c == SMALLER || (c == EQUAL && a < b);
    });
    for(std::size_t i = 1; i < vertices.size(); ++i)
      if(compare(points[vertices[i-1]], points[vertices[i]]) == EQUAL)
        representative[vertices[i]] = representative[vertices[i-1]];
  }
}

/// returns, for each vertex with `used[v]`, the smallest used vertex at the same point; for others the vertex itself.
template <typename GT>
std::vector<std::size_t> point_representatives(const Indexed_input_3<typename GT::Point_3>& input,
                                               const std::vector<char>& used, const GT& gt)
{
  std::vector<std::size_t> representative(input.points.size());
  std::vector<std::size_t> vertices;
  for(std::size_t v = 0; v < used.size(); ++v)
  {
    representative[v] = v;
    if(used[v])
      vertices.push_back(v);
  }
  represent_equal_points(input, std::move(vertices), gt, representative);
  return representative;
}

/// returns the description of a simplex for a report. The points are left out if one of them does not exist,
/// or is not finite: nothing useful can be done with such a point, and printing it ends the program with EPECK.
template <typename Point_3, typename Vertices>
Input_simplex_3<Point_3> describe_simplex(const Indexed_input_3<Point_3>& input,
                                          const std::size_t index, const Vertices& vertices)
{
  Input_simplex_3<Point_3> result;
  result.dimension = static_cast<int>(vertices.size()) - 1;
  result.index = index;
  result.vertices.assign(vertices.begin(), vertices.end());
  if(has_geometry(input, vertices))
    for(const std::size_t v : vertices)
      result.points.push_back(input.points[v]);
  return result;
}

template <typename Point_3>
Input_simplex_3<Point_3> describe_vertex(const Indexed_input_3<Point_3>& input, const std::size_t v)
{
  return describe_simplex(input, v, std::array<std::size_t, 1>{{ v }});
}

template <typename Point_3>
Input_simplex_3<Point_3> describe_edge(const Indexed_input_3<Point_3>& input, const std::size_t e)
{
  return describe_simplex(input, e, input.edges[e]);
}

template <typename Point_3>
Input_simplex_3<Point_3> describe_facet(const Indexed_input_3<Point_3>& input, const std::size_t f)
{
  return describe_simplex(input, f, input.facets[f]);
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_INDEXED_INPUT_3_H
