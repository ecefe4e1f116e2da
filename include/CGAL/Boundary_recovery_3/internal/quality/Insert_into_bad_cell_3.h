// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_BAD_CELL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_BAD_CELL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Star_cavity_3.h>

#include <cstddef>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Inserts a vertex into a bad cell: the cell and some around it are exchanged for the star of a new vertex.
 *
 * The cavity grows where the star would have its worst cell, as long as that helps; then the point is moved to where
 * the cells are less bad; and so on in turns. Nothing is changed before the whole star is known to be better.
 */
template <typename Mesh>
class Insert_into_bad_cell_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  explicit Insert_into_bad_cell_3(Mesh& mesh) : m_mesh(mesh), m_cavity(mesh) { }

  // Searches for a point. Returns whether the cells would be less bad then, and none worse than the worst one now. The
  // first point is in the cell, so if that is flat and at a wall, it is in the plane of the wall.
  bool find(const Cell_handle c)
  {
    return m_mesh.has_room()
        && (find(c, true) || (m_mesh.quality(c) < nearly_flat * m_mesh.enough() && find(c, false)));
  }

  // Inserts the vertex. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply()
  {
    if(! m_cavity.is_star())
      return false;
    m_new_cells = &m_cavity.exchange();
    return true;
  }

  const Cells& new_cells() const { return *m_new_cells; }

  // Free vertices around which all cells are new.
  std::size_t number_of_removed_vertices() const { return m_cavity.number_of_vertices_inside(); }

private:
  typedef Star_cavity_3<Mesh>   Cavity;
  typedef typename Cavity::Face Face;

  // See "Tuning constants" in the manual.
  static constexpr int max_number_of_turns = 3;
  static constexpr std::size_t max_number_of_cells = 30;
  static constexpr double nearly_flat = 0.1;

  bool find(const Cell_handle c, const bool minds_walls)
  {
    const double enough = m_mesh.enough();
    m_cavity.start(c, internal::centroid(internal::corners(c)));
    double quality = m_cavity.worst_quality();
    for(int turn = 0; turn < max_number_of_turns; ++turn)
    {
      const bool has_grown = grow(enough, minds_walls);
      if(turn > 0 && ! has_grown)
        break;
      if(! m_cavity.has_only_free_vertices_inside())
        return false;
      quality = m_cavity.move_point();
      if(quality >= enough)
        break;
    }
    return quality > m_mesh.least_quality(m_cavity.worst_quality()) && m_cavity.gain() > 0 && m_cavity.is_in_size();
  }

  // Takes in the cell behind the worst face, again and again, until that is a wall, or all are good enough. If walls
  // are not minded, that is done at the other faces. Returns whether there was a cell.
  bool grow(const double enough, const bool minds_walls)
  {
    bool has_grown = false;
    while(m_cavity.cells().size() < max_number_of_cells)
    {
      double worst = enough;
      const Face* face = nullptr;
      for(const Face& f : m_cavity.faces())
        if(f.quality < worst && (minds_walls || ! m_cavity.is_wall(f)))
        {
          worst = f.quality;
          face = &f;
        }
      if(face == nullptr || m_cavity.is_wall(*face))
        break;
      m_cavity.take_in(face->cell->neighbor(face->index));
      has_grown = true;
    }
    return has_grown;
  }

  Mesh& m_mesh;
  Cavity m_cavity;
  const Cells* m_new_cells = nullptr;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_BAD_CELL_3_H
