// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_FREE_STAR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_FREE_STAR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Vertices of more cells are left alone where each neighbor is tried with each cell, which would take too long. See
// "Tuning constants" in the manual.
constexpr std::size_t usual_max_number_of_cells = 100;

/*
 * The cells around a vertex that is free: it may be moved, or removed, since it is inside of a region and on no
 * constraint.
 */
template <typename Mesh>
class Free_star_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef std::array<Vertex_handle, 3> Face;

  explicit Free_star_3(const Mesh& mesh, const std::size_t max_number_of_cells = usual_max_number_of_cells)
    : m_mesh(mesh), m_max_number_of_cells(max_number_of_cells)
  {
    m_cells.reserve(max_number_of_cells + 3); // so that nothing throws while cells are marked
    m_faces.reserve(max_number_of_cells + 3);
    m_neighbors.reserve(max_number_of_cells + 6);
  }

  // Returns false if the vertex is not free, or has too many cells.
  bool collect(const Vertex_handle v)
  {
    if(Mesh::is_on_constraint_by_dimension(v) || m_mesh.domain().is_beyond_border(v->cell())
       || ! m_mesh.domain().contains(v->cell()))
      return false;
    m_cells.clear();
    m_faces.clear();
    push(v->cell());
    const Face first_face = internal::facet_vertices(v->cell(), v->cell()->index(v));
    m_neighbors.assign(first_face.begin(), first_face.end());
    const Take_marks_away at_the_end{ m_cells };
    bool is_free = true;
    for(std::size_t k = 0; is_free && k < m_cells.size(); ++k)
      is_free = m_cells.size() <= m_max_number_of_cells && go_on_from(m_cells[k], v);
    return is_free;
  }

  const std::vector<Cell_handle>& cells() const { return m_cells; }

  // Those of the cells, opposite to the vertex, seen from it; in the order of the cells.
  const std::vector<Face>& faces() const { return m_faces; }

  // The other ends of the edges of the vertex, in the order in which they are met.
  const std::vector<Vertex_handle>& neighbors() const { return m_neighbors; }

private:
  // Also if a property map throws.
  struct Take_marks_away
  {
    const std::vector<Cell_handle>& cells;

    ~Take_marks_away()
    {
      for(const Cell_handle c : cells)
        c->tds_data().clear();
    }
  };

  // Adds the face of a cell and its neighbors at the vertex. Returns false if something is constrained there, or beyond
  // the border of a part.
  bool go_on_from(const Cell_handle c, const Vertex_handle v)
  {
    const int i = c->index(v);
    for(int k = 0; k < 4; ++k)
      if(k != i)
      {
        if(m_mesh.domain().is_wall(c, k) || m_mesh.domain().is_constrained_edge(v, c->vertex(k)))
          return false;
        if(c->neighbor(k)->tds_data().is_clear() && ! enter(c->neighbor(k), c))
          return false;
      }
    m_faces.push_back(internal::facet_vertices(c, i));
    return true;
  }

  // Only the vertex opposite to where the cell is entered may be new.
  bool enter(const Cell_handle c, const Cell_handle from)
  {
    if(m_mesh.domain().is_beyond_border(c))
      return false;
    push(c);
    const Vertex_handle apex = c->vertex(c->index(from));
    if(! internal::contains(m_neighbors, apex))
      m_neighbors.push_back(apex);
    return true;
  }

  void push(const Cell_handle c)
  {
    c->tds_data().mark_in_conflict();
    m_cells.push_back(c);
  }

  const Mesh& m_mesh;
  const std::size_t m_max_number_of_cells;
  std::vector<Cell_handle> m_cells;
  std::vector<Face> m_faces;
  std::vector<Vertex_handle> m_neighbors;
};

/*
 * The vertices at which an operation was tried in vain. What it does depends on the cells around the vertex only, so
 * until one of them changes, it would fail again, and many bad cells may have this vertex.
 */
template <typename Mesh>
class Vain_attempts_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;

  explicit Vain_attempts_3(const Mesh& mesh) : m_mesh(mesh), m_times(0) { }

  // The operation has just failed, or done what it can.
  void add(const Vertex_handle v) { m_times[v] = m_mesh.time(); }

  // Also something else may count as good enough since.
  bool contains(const Vertex_handle v) const
  {
    const auto& times = m_times;
    const std::size_t time = times[v];
    return time >= m_mesh.time_of_measure() && ! m_mesh.has_changed(v, time);
  }

private:
  const Mesh& m_mesh;
  Unique_hash_map<Vertex_handle, std::size_t> m_times; // in changes of the mesh; for looking up only
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_FREE_STAR_3_H
