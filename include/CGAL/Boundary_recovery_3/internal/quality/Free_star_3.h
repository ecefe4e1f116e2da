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
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <array>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

  explicit Free_star_3(const Mesh& mesh) : m_mesh(mesh) { }

  // Returns false if the vertex is not free.
  bool collect(const Vertex_handle v)
  {
    if(is_on_constraint_by_dimension(v))
      return false;
    m_cells.clear();
    m_faces.clear();
    m_mesh.triangulation().tds().incident_cells(v, std::back_inserter(m_cells));
    for(const Cell_handle c : m_cells)
    {
      const int i = c->index(v);
      if(! m_mesh.domain().contains(c) || has_constraint(c, i))
        return false;
      m_faces.push_back(internal::facet_vertices(c, i));
    }
    return true;
  }

  const std::vector<Cell_handle>& cells() const { return m_cells; }

  // Those of the cells, opposite to the vertex, seen from it; in the order of the cells.
  const std::vector<Face>& faces() const { return m_faces; }

  // The other ends of the edges of the vertex, in the order in which they are met.
  const std::vector<Vertex_handle>& neighbors()
  {
    m_neighbors.clear();
    for(const Face& f : m_faces)
      for(const Vertex_handle u : f)
        if(! internal::contains(m_neighbors, u))
          m_neighbors.push_back(u);
    return m_neighbors;
  }

private:
  static bool is_on_constraint_by_dimension(const Vertex_handle v)
  {
    if constexpr(Has_vertex_indices<typename Mesh::Triangulation::Vertex>::value)
      return v->in_dimension() >= 0 && v->in_dimension() < 3;
    else
      return false;
  }

  // Whether a facet or an edge at the vertex i of a cell is constrained.
  bool has_constraint(const Cell_handle c, const int i) const
  {
    for(int k = 0; k < 4; ++k)
      if(k != i && m_mesh.domain().is_wall(c, k))
        return true;
    if constexpr(Mesh::Domain::has_constrained_edges)
      for(int k = 0; k < 4; ++k)
        if(k != i && m_mesh.domain().is_constrained_edge(c->vertex(i), c->vertex(k)))
          return true;
    return false;
  }

  const Mesh& m_mesh;
  std::vector<Cell_handle> m_cells;
  std::vector<Face> m_faces;
  std::vector<Vertex_handle> m_neighbors;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_FREE_STAR_3_H
