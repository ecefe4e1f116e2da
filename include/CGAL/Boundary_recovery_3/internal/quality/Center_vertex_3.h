// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CENTER_VERTEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CENTER_VERTEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/filling/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Allowed_lengths_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Moves a free vertex towards the mean of its neighbors, if that makes the cells around it rounder: smart Laplacian
 * smoothing, as in L. A. Freitag, "On combining Laplacian and optimization-based mesh smoothing techniques", 1997.
 *
 * It is cheap, and good for the mass of the cells, where optimising smoothing is for single bad ones. The few of these
 * do not get worse for it: bad cells must stay as good as the worst of them was, and be no worse in sum.
 */
template <typename Mesh>
class Center_vertex_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  explicit Center_vertex_3(Mesh& mesh) : m_mesh(mesh), m_star(mesh) { }

  // Moves v. Returns whether the cells at v are rounder now.
  bool operator()(const Vertex_handle v)
  {
    if(! m_star.collect(v))
      return false;
    set_corners(v);
    const double before = sum_of_roundness();
    const Coordinates_3 from = Mesh::coordinates(v), to = mean_of_corners();
    for(double step = 1; step > 0.4; step *= 0.5)
    {
      const Coordinates_3 p = internal::point_between(from, to, step);
      for(Cell_corners_3& c : m_corners)
        c[3] = p;
      if(sum_of_roundness() > before && are_as_good_as_cells() && are_edges_in_size(v, p))
        return m_mesh.move(v, p, m_star.cells(), m_star.faces());
    }
    return false;
  }

private:
  // The vertex is the last corner of each cell.
  void set_corners(const Vertex_handle v)
  {
    const Coordinates_3 p = Mesh::coordinates(v);
    m_corners.clear();
    for(const auto& f : m_star.faces())
      m_corners.push_back({{ Mesh::coordinates(f[0]), Mesh::coordinates(f[1]), Mesh::coordinates(f[2]), p }});
  }

  double sum_of_roundness()
  {
    double sum = 0;
    m_least_roundness = std::numeric_limits<double>::infinity();
    for(const Cell_corners_3& c : m_corners)
    {
      const double q = m_roundness(c);
      sum += q;
      m_least_roundness = (std::min)(m_least_roundness, q);
    }
    return sum;
  }

  // A neighbor counts once for each cell, and so does the vertex itself, which does not go too far for that.
  Coordinates_3 mean_of_corners() const
  {
    Coordinates_3 sum = {{ 0, 0, 0 }};
    for(const Cell_corners_3& c : m_corners)
    {
      const Coordinates_3 p = internal::centroid(c);
      for(int i = 0; i < 3; ++i)
        sum[i] += p[i];
    }
    for(double& x : sum)
      x /= static_cast<double>(m_corners.size());
    return sum;
  }

  // Whether the cells of the corners are as good as those of the star. Most stars have none that is bad, or nearly so.
  bool are_as_good_as_cells() const
  {
    if(m_least_roundness >= m_mesh.enough_roundness())
      return true;
    const auto after = m_mesh.account_of(m_corners);
    if(after.worst >= m_mesh.enough())
      return true;
    const auto before = m_mesh.account_of(m_star.cells());
    return after.worst >= before.worst && after.badness <= before.badness;
  }

  bool are_edges_in_size(const Vertex_handle v, const Coordinates_3& p)
  {
    m_places.assign(m_mesh.allowed_lengths(), v, m_star.neighbors());
    return m_places(p);
  }

  Mesh& m_mesh;
  Volume_length_quality_3 m_roundness;
  Free_star_3<Mesh> m_star;
  std::vector<Cell_corners_3> m_corners;
  double m_least_roundness = 0; // of the corners
  Allowed_places_3<typename Mesh::Triangulation> m_places;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CENTER_VERTEX_3_H
