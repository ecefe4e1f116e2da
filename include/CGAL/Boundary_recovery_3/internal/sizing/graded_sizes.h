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

#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Makes sizes at the vertices of a mesh smaller where they grow along an edge by more than `grading` times its length.
 * The smallest one of all sizes is final, and so on: each vertex is settled once, as in a search for shortest paths.
 */
inline void grade_sizes(const std::vector<Coordinates_3>& points,
                        const std::vector<std::array<std::size_t, 4> >& tetrahedra,
                        const double grading, std::vector<double>& sizes)
{
  typedef std::pair<double, std::size_t> Sized_vertex;
  const Tetrahedra_incidences_3 incidences(points.size(), tetrahedra);
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
    for(const std::size_t c : incidences.cells(v))
      for(const std::size_t w : tetrahedra[c])
      {
        const Coordinates_3 d = difference(points[v], points[w]);
        const double carried = size + grading * std::hypot(d[0], d[1], d[2]);
        if(carried < sizes[w])
          queue.emplace(sizes[w] = carried, w);
      }
  }
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_GRADED_SIZES_H
