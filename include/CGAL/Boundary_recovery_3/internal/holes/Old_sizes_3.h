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

#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Cone_minimum_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The sizes of the old mesh in a hole: at each vertex the mean length of the edges of the cells there, of those that
 * are not bad if there are any, carried from there into space.
 *
 * Lengths differ from one vertex to the next, and the smallest ones would win everywhere: a mesh that is remeshed again
 * and again would get finer and finer. Therefore all edges of these cells count, and not only those at the vertex.
 */
class Old_sizes_3
{
public:
  // See "Tuning constants" in the manual.
  static constexpr double grading = 0.3;
  static constexpr double size_per_mean_length = 0.95;

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
    Simplex_index_3<std::size_t, 1> known;
    std::vector<Site> result;
    for(const std::size_t c : cells)
      for(const std::size_t v : mesh.tetrahedra[c])
        if(known.insert({{ v }}).second)
        {
          const double length = mean_length(mesh, incidences, is_bad, v);
          if(length > 0) // else all of its neighbors are at its place
            result.push_back(Site{ internal::coordinates_of(mesh.points[v]), size_per_mean_length * length });
        }
    return result;
  }

  template <typename Point_3>
  static double mean_length(const Moved_mesh_3<Point_3>& mesh, const Tetrahedra_incidences_3& incidences,
                            const std::vector<char>& is_bad, const std::size_t v)
  {
    Mean mean;
    for(const std::size_t c : incidences.cells(v))
    {
      const std::array<Coordinates_3, 4> p = mesh.corners(c);
      for(const auto& e : edges_of_cell)
        mean.add(std::sqrt(internal::squared_distance(p[std::size_t(e[0])], p[std::size_t(e[1])])), ! is_bad[c]);
    }
    return mean();
  }

  Cone_minimum_3 m_cones;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_OLD_SIZES_3_H
