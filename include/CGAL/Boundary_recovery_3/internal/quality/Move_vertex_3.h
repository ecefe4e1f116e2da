// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_VERTEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_VERTEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Places_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Vain_attempts_3.h>

#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Moves a free vertex to a place in its star. `Place` searches it:
 *
 *   bool find(Vertex_handle v, const Star& star) // whether there is a place that will do
 *   Coordinates_3 point()                        // the one that was found
 *
 * and tells how many cells the star may have. If it is for bad cells, it also has
 *
 *   bool is_for(Cell_handle c)                   // whether it helps cells that are as bad as c
 *   double gain()                                // by how much the cells are less bad if the vertex is there
 */
template <typename Mesh, typename Place>
class Move_vertex_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  explicit Move_vertex_3(Mesh& mesh)
    : m_mesh(mesh), m_star(mesh, Place::max_number_of_cells), m_place(mesh), m_vain_attempts(mesh)
  { }

  // Searches a place for one of the vertices of a bad cell, of those around which something has changed.
  bool find(const Cell_handle c)
  {
    if(m_place.is_for(c))
      for(int i = 0; i < 4; ++i)
        if(! m_vain_attempts.contains(c->vertex(i)))
        {
          if(find(c->vertex(i)))
            return true;
          m_vain_attempts.add(c->vertex(i));
        }
    return false;
  }

  // The same for a vertex.
  bool find(const Vertex_handle v)
  {
    m_vertex = v;
    return m_star.collect(v) && m_place.find(v, m_star);
  }

  double gain() const { return m_place.gain(); }

  // Moves the vertex. Returns false, and does nothing, if a cell would not be positively oriented.
  bool apply()
  {
    const bool is_moved = move();
    m_vain_attempts.add(m_vertex);
    return is_moved;
  }

  // Searches and moves, whatever was in vain. Returns whether the vertex was moved.
  bool operator()(const Vertex_handle v) { return find(v) && move(); }

  // The cells around the vertex.
  const std::vector<Cell_handle>& new_cells() const { return m_star.cells(); }

  void count(Quality_improvement_counts& counts) const { ++counts.number_of_moved_vertices; }

private:
  bool move() { return m_mesh.move(m_vertex, m_place.point(), m_star.cells(), m_star.faces()); }

  Mesh& m_mesh;
  Free_star_3<Mesh> m_star;
  Place m_place;
  Vain_attempts_3<Mesh> m_vain_attempts;
  Vertex_handle m_vertex;
};

template <typename Mesh>
using Smooth_vertex_3 = Move_vertex_3<Mesh, Least_bad_place_3<Mesh>>;

template <typename Mesh>
using Deepen_vertex_3 = Move_vertex_3<Mesh, Deepest_place_3<Mesh>>;

template <typename Mesh>
using Center_vertex_3 = Move_vertex_3<Mesh, Central_place_3<Mesh>>;

template <typename Mesh>
using Move_at_random_3 = Move_vertex_3<Mesh, Random_place_3<Mesh>>;

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MOVE_VERTEX_3_H
