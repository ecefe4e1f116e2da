// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_AT_RANDOM_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_AT_RANDOM_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/filling/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Allowed_lengths_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Moves a vertex of a bad cell, or of one beside it, to a random place in its star. Mostly, that makes cells worse; but
 * none gets worse than what the mesh tolerates.
 */
template <typename Mesh>
class Move_at_random_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  explicit Move_at_random_3(Mesh& mesh) : m_mesh(mesh), m_star(mesh) { }

  // Returns whether a vertex was moved. Otherwise, nothing is changed.
  bool operator()(const Cell_handle c, CGAL::Random& random)
  {
    set_vertices(c);
    for(int k = 0; k < max_number_of_places; ++k)
      if(move(m_vertices[random.uniform_int<std::size_t>(0, m_vertices.size() - 1)], random))
        return true;
    return false;
  }

  // The cells around the vertex.
  const std::vector<Cell_handle>& cells() const { return m_star.cells(); }

private:
  typedef typename Free_star_3<Mesh>::Face Face;

  // See "Tuning constants" in the manual.
  static constexpr int max_number_of_places = 6;
  static constexpr double largest_step = 0.5; // as a part of the way to a face of the star

  // Those of the cell, and of its neighbors.
  void set_vertices(const Cell_handle c)
  {
    m_vertices.clear();
    for(int i = 0; i < 4; ++i)
      add(c->vertex(i));
    for(int i = 0; i < 4; ++i)
      if(! m_mesh.domain().is_wall(c, i))
        add(c->neighbor(i)->vertex(c->neighbor(i)->index(c)));
  }

  void add(const Vertex_handle v)
  {
    if(! internal::contains(m_vertices, v))
      m_vertices.push_back(v);
  }

  bool move(const Vertex_handle v, CGAL::Random& random)
  {
    if(! m_star.collect(v))
      return false;
    const Face& f = m_star.faces()[random.uniform_int<std::size_t>(0, m_star.faces().size() - 1)];
    const Coordinates_3 p = internal::point_between(Mesh::coordinates(v), random_point(f, random),
                                                    random.get_double(0, largest_step));
    m_places.assign(m_mesh.allowed_lengths(), v, m_star.neighbors());
    return m_places(p) && are_tolerated(p) && m_mesh.move(v, p, m_star.cells(), m_star.faces());
  }

  static Coordinates_3 random_point(const Face& f, CGAL::Random& random)
  {
    std::array<double, 3> weights;
    double sum = 0;
    for(double& w : weights)
      sum += w = random.get_double(least_weight, 1);
    Coordinates_3 p = {{ 0, 0, 0 }};
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        p[j] += weights[i] / sum * Mesh::coordinates(f[i])[j];
    return p;
  }

  // Whether the mesh may have the cells that there would be.
  bool are_tolerated(const Coordinates_3& p) const
  {
    double worst = std::numeric_limits<double>::infinity();
    for(const Face& f : m_star.faces())
      worst = (std::min)(worst, m_mesh.quality(f, p));
    return worst >= m_mesh.least_quality(m_mesh.account_of(m_star.cells()).worst);
  }

  static constexpr double least_weight = 0.01; // so that their sum is not 0

  Mesh& m_mesh;
  Free_star_3<Mesh> m_star;
  Allowed_places_3<typename Mesh::Triangulation> m_places;
  std::vector<Vertex_handle> m_vertices;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_AT_RANDOM_3_H
