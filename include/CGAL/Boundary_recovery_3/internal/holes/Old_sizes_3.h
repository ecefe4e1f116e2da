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

#include <CGAL/Boundary_recovery_3/internal/filling/Cone_minimum_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Tetrahedra_incidences_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The sizes of the old mesh in a hole: at each vertex the mean length of the edges there, of those cells that are not
 * bad if there are any, carried from there into space.
 *
 * Lengths differ from one vertex to the next, and the smallest ones would win everywhere: a mesh that is remeshed again
 * and again would get finer and finer. Therefore each vertex takes the mean of what it and its neighbors have.
 */
class Old_sizes_3
{
public:
  // See "Tuning constants" in the manual.
  static constexpr double grading = 0.3;
  static constexpr double size_per_mean_length = 0.94;

  // `is_bad` has an entry for each tetrahedron of the mesh, `cells` are those of the hole.
  template <typename Point_3>
  Old_sizes_3(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
              const std::vector<char>& is_bad, const std::vector<std::size_t>& cells)
    : m_cones(sites(mesh, incidences, is_bad, cells), grading)
  { }

  double operator()(const Coordinates_3& p) const { return m_cones(p); }

private:
  typedef Cone_minimum_3::Site Site;

  // The mean length of all edges, and that of the edges of good cells; each edge as often as there are cells at it.
  struct Mean
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
      return numbers[k] > 0 ? sums[k] / static_cast<double>(numbers[k]) : 0;
    }
  };

  template <typename Point_3>
  static std::vector<Site> sites(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
                                 const std::vector<char>& is_bad, const std::vector<std::size_t>& cells)
  {
    std::vector<std::size_t> vertices;
    for(const std::size_t c : cells)
      vertices.insert(vertices.end(), mesh.tetrahedra[c].begin(), mesh.tetrahedra[c].end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

    std::vector<double> lengths;
    for(const std::size_t v : vertices)
      lengths.push_back(mean_length(mesh, incidences, is_bad, v));
    const std::vector<double> means = means_of_neighbors(mesh, is_bad, cells, vertices, lengths);
    std::vector<Site> result;
    for(std::size_t k = 0; k < vertices.size(); ++k)
      if(means[k] > 0) // else all of its neighbors are at its place
        result.push_back(Site{ internal::coordinates_of(mesh.points[vertices[k]]), size_per_mean_length * means[k] });
    return result;
  }

  template <typename Point_3>
  static double mean_length(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
                            const std::vector<char>& is_bad, const std::size_t v)
  {
    const Coordinates_3 p = internal::coordinates_of(mesh.points[v]);
    Mean mean;
    for(const std::size_t c : incidences.cells(v))
      for(const std::size_t u : mesh.tetrahedra[c])
        if(u != v)
          mean.add(std::sqrt(internal::squared_distance(p, internal::coordinates_of(mesh.points[u]))), ! is_bad[c]);
    return mean();
  }

  template <typename Point_3>
  static std::vector<double> means_of_neighbors(const Moved_mesh_3<Point_3>& mesh, const std::vector<char>& is_bad,
                                                const std::vector<std::size_t>& cells,
                                                const std::vector<std::size_t>& vertices,
                                                const std::vector<double>& lengths)
  {
    std::vector<Mean> means(vertices.size());
    for(const std::size_t c : cells)
    {
      std::array<std::size_t, 4> t = mesh.tetrahedra[c];
      double sum = 0;
      for(std::size_t& v : t)
      {
        v = static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
        sum += lengths[v] / 4;
      }
      for(const std::size_t v : t)
        means[v].add(sum, ! is_bad[c]);
    }
    std::vector<double> result;
    for(const Mean& mean : means)
      result.push_back(mean());
    return result;
  }

  Cone_minimum_3 m_cones;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_OLD_SIZES_3_H
