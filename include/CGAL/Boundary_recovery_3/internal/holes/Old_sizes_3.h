// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_OLD_SIZES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_OLD_SIZES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Mesh_interpolation_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Tetrahedra_incidences_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The sizes of the old mesh in a hole: at each vertex the mean length of the edges there, of those cells that are not
 * bad if there are any, and between vertices what the old cells have there.
 */
class Old_sizes_3
{
public:
  typedef std::array<std::size_t, 4> Tetrahedron;

  // `is_bad` has an entry for each tetrahedron of the mesh, `cells` are those of the hole.
  template <typename Point_3>
  Old_sizes_3(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
              const std::vector<char>& is_bad, const std::vector<std::size_t>& cells)
    : m_interpolation(make_interpolation(mesh, incidences, is_bad, cells, m_largest))
  { }

  // If all of the cells are flat, nothing is known but how long their edges are.
  double operator()(const Coordinates_3& p) const
  {
    const double size = m_interpolation(p);
    return size < std::numeric_limits<double>::infinity() ? size : m_largest;
  }

private:
  // The mean length of all edges, and that of the edges of good cells; each edge as often as there are cells at it.
  struct Mean_length
  {
    std::array<double, 2> sums = {{ 0, 0 }};
    std::array<std::size_t, 2> numbers = {{ 0, 0 }};

    void add(const double length, const bool is_good)
    {
      sums[is_good] += length;
      ++numbers[is_good];
    }

    double operator()() const
    {
      const std::size_t k = numbers[1] > 0 ? 1 : 0;
      return sums[k] / static_cast<double>(numbers[k]);
    }
  };

  template <typename Point_3>
  static Mesh_interpolation_3 make_interpolation(const Moved_mesh_3<Point_3>& mesh,
                                                 const Tetrahedra_incidences_3& incidences,
                                                 const std::vector<char>& is_bad,
                                                 const std::vector<std::size_t>& cells, double& largest)
  {
    std::vector<std::size_t> vertices;
    for(const std::size_t c : cells)
      vertices.insert(vertices.end(), mesh.tetrahedra[c].begin(), mesh.tetrahedra[c].end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

    std::vector<Coordinates_3> points;
    std::vector<double> sizes;
    for(const std::size_t v : vertices)
    {
      points.push_back(internal::coordinates_of(mesh.points[v]));
      sizes.push_back(mean_length(mesh, incidences, is_bad, v));
    }
    largest = *std::max_element(sizes.begin(), sizes.end());
    for(double& size : sizes) // of a vertex at whose place all its neighbors are
      size = size > 0 ? size : largest;

    std::vector<Tetrahedron> tetrahedra;
    for(const std::size_t c : cells)
    {
      Tetrahedron t = mesh.tetrahedra[c];
      for(std::size_t& v : t)
        v = static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
      tetrahedra.push_back(t);
    }
    return Mesh_interpolation_3(points, tetrahedra, sizes);
  }

  template <typename Point_3>
  static double mean_length(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
                            const std::vector<char>& is_bad, const std::size_t v)
  {
    const Coordinates_3 p = internal::coordinates_of(mesh.points[v]);
    Mean_length mean;
    for(const std::size_t c : incidences.cells(v))
      for(const std::size_t u : mesh.tetrahedra[c])
        if(u != v)
          mean.add(std::sqrt(internal::squared_distance(p, internal::coordinates_of(mesh.points[u]))), ! is_bad[c]);
    return mean();
  }

  double m_largest = 0;
  Mesh_interpolation_3 m_interpolation;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_OLD_SIZES_3_H
