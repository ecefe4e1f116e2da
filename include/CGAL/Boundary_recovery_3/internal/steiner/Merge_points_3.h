// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_MERGE_POINTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_MERGE_POINTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/replace_and_forget.h>

#include <iterator>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Makes one point of two free Steiner points that are neighbors, where one point sees the boundary of both balls.
 */
template <typename Tr, typename Visitor>
class Merge_points_3
{
public:
  typedef Steiner_mesh_3<Tr, Visitor>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;

  explicit Merge_points_3(Mesh& mesh) : m_mesh(mesh), m_move_into_kernel(mesh.predicates, mesh.positions) { }

  // Merges v, of which `ball` are the cells around it, with the first neighbor for which this is possible.
  void operator()(const Vertex_handle v, const std::vector<Cell_handle>& ball)
  {
    const auto before = v->point();
    for(const Vertex_handle w : internal::vertices_without(ball, v))
    {
      if(! m_mesh.ledger.is_free(w) || ! internal::collect_ball(m_mesh.tr, w, m_ball))
        continue;
      if(! m_mesh.context.go_further())
        return;
      Cavity_3<Tr> cavity(m_mesh.tr, m_mesh.constraints, ball);
      for(const Cell_handle c : m_ball)
        cavity.add(c);
      std::vector<Vertex_triple> faces;
      std::vector<Vertex_handle> inner_points;
      if(! m_mesh.positions.contains(v) && cavity.collect_boundary(m_mesh.ledger.free_points(), faces, inner_points)
         && m_move_into_kernel(v, faces))
      {
        internal::star_and_forget(m_mesh.editor, m_mesh.ledger, cavity, v);
        return;
      }
      v->set_point(before);
    }
  }

private:
  typedef typename Mesh::Vertex_triple Vertex_triple;

  Mesh& m_mesh;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  std::vector<Cell_handle> m_ball;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_MERGE_POINTS_3_H
