// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_GRADED_SIZES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_GRADED_SIZES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// The ends of the edges of a mesh at each vertex.
class Edge_stars_3
{
public:
  Edge_stars_3(const std::size_t number_of_vertices, const std::vector<std::array<std::size_t, 4> >& tetrahedra)
    : m_first(number_of_vertices + 1)
  {
    std::vector<std::pair<std::size_t, std::size_t> > edges;
    edges.reserve(12 * tetrahedra.size());
    for(const auto& t : tetrahedra)
      for(const std::size_t v : t)
        for(const std::size_t w : t)
          if(v != w)
            edges.emplace_back(v, w);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    m_ends.reserve(edges.size());
    for(const auto& edge : edges)
    {
      ++m_first[edge.first + 1];
      m_ends.push_back(edge.second);
    }
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
  }

  // Calls `visit(w)` for all edges vw.
  template <typename Visit>
  void visit_edges(const std::size_t v, const Visit& visit) const
  {
    for(std::size_t k = m_first[v]; k < m_first[v + 1]; ++k)
      visit(m_ends[k]);
  }

private:
  std::vector<std::size_t> m_first; // where those of each vertex begin, and their end
  std::vector<std::size_t> m_ends;
};

/*
 * Makes sizes at the vertices of a mesh smaller where they grow along an edge by more than `grading` times its length.
 * The smallest one of all sizes is final, and so on: each vertex is settled once, as in a search for shortest paths.
 */
inline void grade_sizes(const std::vector<Coordinates_3>& points,
                        const std::vector<std::array<std::size_t, 4> >& tetrahedra,
                        const double grading, std::vector<double>& sizes)
{
  typedef std::pair<double, std::size_t> Sized_vertex;
  const Edge_stars_3 stars(points.size(), tetrahedra);
  std::vector<Sized_vertex> all;
  for(std::size_t v = 0; v < points.size(); ++v)
    all.emplace_back(sizes[v], v);
  std::priority_queue<Sized_vertex, std::vector<Sized_vertex>, std::greater<Sized_vertex> >
    queue(std::greater<Sized_vertex>(), std::move(all));
  while(! queue.empty())
  {
    const double size = queue.top().first;
    const std::size_t v = queue.top().second;
    queue.pop();
    if(size > sizes[v])
      continue; // it was made smaller meanwhile
    stars.visit_edges(v, [&](const std::size_t w)
    {
      const Coordinates_3 d = difference(points[v], points[w]);
      const double carried = size + grading * std::hypot(d[0], d[1], d[2]);
      if(carried < sizes[w])
        queue.emplace(sizes[w] = carried, w);
    });
  }
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_GRADED_SIZES_H
