// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_SHELL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_SHELL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/tetrahedron_edges.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Edge_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Star_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/deepest_point.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Exchanges the shell of an edge of a nearly flat cell for the star of a new vertex, at the deepest point of its
 * visibility kernel.
 *
 * That is the way out where the cell fills the angle of nearly 180 degrees between two walls: it stays as long as the
 * edge opposite to theirs does, and all points of the cell are in the plane of the walls, so no cavity grows from them.
 */
template <typename Mesh>
class Insert_into_shell_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;
  typedef typename Mesh::Cells       Cells;

  explicit Insert_into_shell_3(Mesh& mesh) : m_mesh(mesh), m_cavity(mesh) { }

  // The quality of a nearly flat cell, as a part of what is enough.
  static constexpr double flat = 2e-3;

  // Searches the shell, among those of the edges with obtuse angles, and the point. Returns whether the worst cell
  // would be better by far; together, the cells may be worse than before.
  bool find(const Cell_handle c)
  {
    if(! m_mesh.has_room())
      return false;
    const Cell_corners_3 p = internal::corners(c);
    const Cell_angles_3 angles(p);
    for(int k = 0; k < 6; ++k)
    {
      const Coordinates_3 middle = internal::midpoint(p[edges_of_cell[k][0]], p[edges_of_cell[k][1]]);
      if(angles[k] > least_angle && take_shell(c, k, middle) && find_point(middle))
        return true;
    }
    return false;
  }

  // To be called once `find` returned true.
  void apply() { m_new_cells = &m_cavity.exchange(); }

  const Cells& new_cells() const { return *m_new_cells; }

  // Free vertices around which all cells are new.
  std::size_t number_of_removed_vertices() const { return m_cavity.number_of_vertices_inside(); }

private:
  typedef typename Mesh::Triangulation                Tr;
  typedef std::array<typename Mesh::Vertex_handle, 3> Vertex_triple;

  // See "Tuning constants" in the manual.
  static constexpr double least_angle = 120;
  static constexpr std::size_t max_number_of_cells = 100;
  static constexpr double tolerated_loss = 2;
  static constexpr double numerically_flat = 1e-9;

  // That of the edge k of a cell, with the new vertex at p. Returns false if a wall is at the edge, or the shell is too
  // large.
  bool take_shell(const Cell_handle c, const int k, const Coordinates_3& p)
  {
    m_cavity.start(c, p);
    Edge_walk_3<Tr> walk(c, edges_of_cell[5 - k][0], edges_of_cell[5 - k][1]);
    while(! m_mesh.domain().is_wall(walk.cell(), walk.next_facet()))
    {
      ++walk;
      if(walk.cell() == c)
        return true;
      if(m_cavity.cells().size() == max_number_of_cells)
        return false;
      m_cavity.take_in(walk.cell());
    }
    return false;
  }

  // From a point of the shell on.
  bool find_point(const Coordinates_3& p)
  {
    if(! m_cavity.has_only_free_vertices_inside())
      return false;
    std::vector<Vertex_triple> faces;
    for(const auto& f : m_cavity.faces())
      faces.push_back(f.vertices);
    const auto deepest = internal::deepest_point(m_mesh.triangulation(), faces, p);
    return deepest && Mesh::is_far_better(m_cavity.move_point_from(*deepest), m_cavity.worst_quality())
        && is_bearable() && m_cavity.is_star();
  }

  // Where a cell has no volume but for rounding errors, neither lengths of edges count nor the other cells.
  bool is_bearable()
  {
    const bool is_in_size = m_cavity.is_in_size(); // which also finds the size of the vertex
    return m_cavity.worst_quality() < numerically_flat || (is_in_size && m_cavity.gain() > - tolerated_loss);
  }

  Mesh& m_mesh;
  Star_cavity_3<Mesh> m_cavity;
  const Cells* m_new_cells = nullptr;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_SHELL_3_H
