// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_MOVED_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_MOVED_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * A mesh as arrays: what the caller of remesh_holes() has. Some of its tetrahedra may be flat or inverted, that is, the
 * order of their vertices is the only thing that tells on which side of a facet they are.
 */
template <typename Point_3_>
struct Moved_mesh_3
{
  typedef Point_3_                   Point_3;
  typedef std::array<std::size_t, 4> Tetrahedron;
  typedef std::array<std::size_t, 3> Facet;
  typedef std::array<std::size_t, 2> Edge;
  typedef Input_simplex_3<Point_3>   Simplex;

  std::vector<Point_3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<int> regions;  // of the tetrahedra
  std::vector<Facet> facets; // those that have to stay, beside those that bound regions
  std::vector<Edge> edges;   // those that have to stay, beside those of facets that do

  // In floating point numbers.
  std::array<Coordinates_3, 4> corners(const std::size_t cell) const
  {
    const Tetrahedron& t = tetrahedra[cell];
    return {{ internal::coordinates_of(points[t[0]]), internal::coordinates_of(points[t[1]]),
              internal::coordinates_of(points[t[2]]), internal::coordinates_of(points[t[3]]) }};
  }

  // Whether a cell is neither flat nor inverted.
  bool is_positive(const std::size_t cell) const
  {
    const Tetrahedron& t = tetrahedra[cell];
    const auto orientation = typename Kernel_traits<Point_3>::Kernel().orientation_3_object();
    return orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) == POSITIVE;
  }

  // A simplex in the caller's words, with the position in its range; without coordinates if some are not there.
  template <typename Vertices>
  Simplex describe(const std::size_t position, const Vertices& vertices) const
  {
    Simplex simplex;
    simplex.dimension = static_cast<int>(vertices.size()) - 1;
    simplex.index = position;
    simplex.vertices.assign(vertices.begin(), vertices.end());
    const auto is_good = [&](const std::size_t v) { return v < points.size() && has_finite_coordinates(points[v]); };
    if(std::all_of(vertices.begin(), vertices.end(), is_good))
      for(const std::size_t v : vertices)
        simplex.points.push_back(points[v]);
    return simplex;
  }

  Simplex describe_vertex(const std::size_t v) const { return describe(v, std::array<std::size_t, 1>{{ v }}); }
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_MOVED_MESH_3_H
