// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SMOOTH_VERTEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SMOOTH_VERTEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Allowed_lengths_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Best_point_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>

#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Moves a free vertex to where the cells around it are less bad, and none is worse than the worst one was: optimising
 * smoothing. Moves that hardly help are not made, so that it is the turn of other operations.
 */
template <typename Mesh>
class Smooth_vertex_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  explicit Smooth_vertex_3(Mesh& mesh) : m_mesh(mesh), m_star(mesh), m_best_point(mesh.quality()) { }

  // Moves v. Returns whether the cells at v are less bad now. Otherwise, nothing is changed.
  bool operator()(const Vertex_handle v)
  {
    if(! m_star.collect(v))
      return false;
    m_best_point.clear(m_mesh.measure_of_badness());
    for(const auto& f : m_star.faces())
      m_best_point.add(internal::corners(f));
    Coordinates_3 p = Mesh::coordinates(v);
    m_limits.assign(m_mesh.allowed_lengths(), v, m_star.neighbors());
    return m_best_point.improve(p, m_limits) >= least_progress && m_mesh.move(v, p, m_star.cells(), m_star.faces());
  }

  // The cells around the vertex that was treated last.
  const std::vector<Cell_handle>& cells() const { return m_star.cells(); }

private:
  // See "Tuning constants" in the manual.
  static constexpr double least_progress = 0.02;

  Mesh& m_mesh;
  Free_star_3<Mesh> m_star;
  Best_point_in_star_3<typename Mesh::Quality> m_best_point;
  Allowed_places_3<typename Mesh::Triangulation> m_limits;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SMOOTH_VERTEX_3_H
