// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_DEEPEN_VERTEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_DEEPEN_VERTEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/quality/Allowed_lengths_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Best_point_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/deepest_point.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Moves a free vertex that has nearly flat cells to the deepest point of the visibility kernel of its star, the one
 * farthest from the planes of all faces: the solution of a linear program.
 *
 * The recovery leaves such vertices: beside a strip of coplanar thin triangles that no other vertex sees, say, at a
 * distance of a millionth of its width. The kernel is so thin there that no step of smoothing stays in it, though other
 * vertices have come, and it is wide elsewhere. Those vertices have many cells, and edges that may be too long already.
 */
template <typename Mesh>
class Deepen_vertex_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  explicit Deepen_vertex_3(Mesh& mesh)
    : m_mesh(mesh), m_star(mesh, max_number_of_cells), m_best_point(mesh.quality())
  { }

  // Moves v. Returns whether the worst cell at v is better by far now; others may be worse than before, and edges have
  // any length. Otherwise, nothing is changed.
  bool operator()(const Vertex_handle v)
  {
    if(! m_star.collect(v))
      return false;
    const Coordinates_3 before = Mesh::coordinates(v);
    const auto deepest = internal::deepest_point(m_mesh.triangulation(), m_star.faces(), before);
    if(! deepest || ! Mesh::is_far_better(worst_quality(*deepest), worst_quality(before)))
      return false;
    Coordinates_3 p = *deepest;
    smooth(v, p);
    return m_mesh.move(v, p, m_star.cells(), m_star.faces());
  }

  // The cells around the vertex that was treated last.
  const std::vector<Cell_handle>& cells() const { return m_star.cells(); }

private:
  // See "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_cells = 1000;

  double worst_quality(const Coordinates_3& p) const
  {
    double worst = 2;
    for(const auto& f : m_star.faces())
      worst = (std::min)(worst, m_mesh.quality(f, p));
    return worst;
  }

  // From p on, with a worst cell that does not get worse.
  void smooth(const Vertex_handle v, Coordinates_3& p)
  {
    m_best_point.clear(Badness_3(m_mesh.enough()));
    for(const auto& f : m_star.faces())
      m_best_point.add({{ Mesh::coordinates(f[0]), Mesh::coordinates(f[1]), Mesh::coordinates(f[2]) }});
    m_limits.assign(m_mesh.allowed_lengths(), v, m_star.neighbors());
    m_best_point.improve(p, m_limits);
  }

  Mesh& m_mesh;
  Free_star_3<Mesh> m_star;
  Best_point_in_star_3<typename Mesh::Quality> m_best_point;
  Allowed_places_3<typename Mesh::Triangulation> m_limits;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_DEEPEN_VERTEX_3_H
