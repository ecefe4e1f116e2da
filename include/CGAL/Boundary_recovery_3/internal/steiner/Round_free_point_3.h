// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ROUND_FREE_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ROUND_FREE_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Gives a free Steiner point a position that the triangulation can store, and that sees its ball: the nearest one, the
 * deepest one, any other; and where no number fits into the kernel of the ball, one in a larger cavity.
 */
template <typename Tr, typename Visitor>
class Round_free_point_3
{
public:
  typedef Steiner_mesh_3<Tr, Visitor>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;

  explicit Round_free_point_3(Mesh& mesh) : m_mesh(mesh), m_move_into_kernel(mesh.predicates, mesh.positions) { }

  // Returns whether v has such a position then. Once stopped, only what is quick is tried.
  bool operator()(const Vertex_handle v)
  {
    if(! m_mesh.positions.contains(v))
      return true;
    internal::collect_ball(m_mesh.tr, v, m_ball);
    const auto faces = internal::faces_of_ball(m_ball, v);
    const typename Mesh::Exact_point exact = m_mesh.positions(v);
    m_mesh.positions.erase(v);
    if(m_move_into_kernel.is_in_kernel(v, faces) || m_move_into_kernel(v, faces)
       || (m_mesh.context.go_further() && m_move_into_kernel.move_near(v, faces, exact)) || star_from_nearby(v))
      return true;
    m_mesh.positions.set(v, exact);
    return false;
  }

  // Where v has no such position: moves it to the middle of the kernel of its ball.
  void center(const Vertex_handle v)
  {
    if(! m_mesh.positions.contains(v))
      return;
    internal::collect_ball(m_mesh.tr, v, m_ball);
    m_move_into_kernel.center(v, internal::faces_of_ball(m_ball, v));
  }

private:
  typedef typename Mesh::Positions   Positions;
  typedef Cavity_3<Tr>               Cavity;

  // Where no number fits into the kernel of the ball of v: moves v to the center of a cell nearby, and adds the cells
  // behind the faces of the ball that it does not see from there, and so on. Of the centers for which this ends, that
  // with the fewest cells is taken. Returns whether there is one; all the cells around v are new then. If not, v is
  // somewhere.
  bool star_from_nearby(const Vertex_handle v)
  {
    typename Positions::Point_3 best_center;
    std::optional<Cavity> best;
    for(const Cell_handle c : cells_near_ball(v))
    {
      if(! m_mesh.context.go_further())
        break;
      v->set_point(center(c));
      Cavity cavity(m_mesh.tr, m_mesh.constraints, m_ball);
      const std::size_t max_number = best ? best->cells().size() - 1 : max_number_of_cells;
      if(! internal::grow_until_seen(cavity, v, m_mesh.predicates, max_number) || ! can_be_starred(cavity))
        continue;
      best.emplace(std::move(cavity));
      best_center = v->point();
    }
    if(! best)
      return false;
    v->set_point(best_center);
    internal::star_and_forget(m_mesh.editor, m_mesh.ledger, *best, v);
    return true;
  }

  // Of a cavity of which all faces are seen.
  bool can_be_starred(Cavity& cavity) const
  {
    std::vector<typename Cavity::Vertex_triple> faces;
    std::vector<Vertex_handle> inner_points;
    return cavity.collect_boundary(m_mesh.ledger.free_points(), faces, inner_points);
  }

  // The finite cells that share a vertex with the ball of v.
  std::vector<Cell_handle> cells_near_ball(const Vertex_handle v) const
  {
    Cavity result(m_mesh.tr, m_mesh.constraints); // it takes finite cells only, and each once
    std::vector<Cell_handle> star;
    for(const Vertex_handle w : internal::vertices_without(m_ball, v))
    {
      star.clear();
      m_mesh.tr.incident_cells(w, std::back_inserter(star));
      for(const Cell_handle c : star)
        result.add(c);
    }
    return result.cells();
  }

  typename Positions::Point_3 center(const Cell_handle c) const
  {
    std::array<double, 3> x = {{ 0, 0, 0 }};
    for(int i = 0; i < 4; ++i)
      for(int k = 0; k < 3; ++k)
        x[k] += m_mesh.predicates.approximate_point(c->vertex(i))[k] / 4; // a sum may be out of range
    return typename Positions::Point_3(x[0], x[1], x[2]);
  }

  // Of a ball that is enlarged until its vertex sees all, see "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_cells = 1000;

  Mesh& m_mesh;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  std::vector<Cell_handle> m_ball;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ROUND_FREE_POINT_3_H
