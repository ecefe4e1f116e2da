// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_REMOVE_BAD_EDGE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_REMOVE_BAD_EDGE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/quality/Skirt_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The shell transformation that is led by quality alone, and removes the supporting edge [CZZ+17, Sections 1.3 and 2]:
 * the covering mesh of the shell is exchanged for the best complete triangulation of the skirt polygon.
 */
template <typename Mesh>
class Remove_bad_edge_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  explicit Remove_bad_edge_3(Mesh& mesh) : m_mesh(mesh), m_skirt(mesh) { }

  // Searches for the best way to remove the edge from the vertex i to the vertex j of a cell of the domain. Returns
  // whether the cells would be less bad then, by more than `least_gain`, and none worse than the worst one now.
  bool find(const Cell_handle c, const int i, const int j, const double least_gain)
  {
    const Vertex_handle u = c->vertex(i), v = c->vertex(j);
    return collect_shell(c, u, v)
        && m_skirt.find(least_gain, internal::distance(Mesh::coordinates(u), Mesh::coordinates(v)));
  }

  // By how much the cells would be less bad.
  double gain() const { return m_skirt.gain(); }

  // Removes the edge. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply() { return m_skirt.apply(); }

  const Cells& new_cells() const { return m_skirt.new_cells(); }

private:
  typedef typename Mesh::Triangulation Tr;

  // Returns false if the edge has to stay, or if there are too many cells around it.
  bool collect_shell(const Cell_handle c, const Vertex_handle u, const Vertex_handle v)
  {
    m_skirt.start(v, u);
    Cell_handle cell = c;
    do
    {
      const int k = Tr::next_around_edge(cell->index(u), cell->index(v));
      if(m_mesh.domain().is_wall(cell, k) || ! m_skirt.add_corner(cell->vertex(k)))
        return false;
      m_skirt.add_cell(cell);
      cell = cell->neighbor(k);
    }
    while(cell != c);
    if constexpr(Mesh::Domain::has_constrained_edges)
      return ! m_mesh.domain().is_constrained_edge(u, v);
    else
      return true;
  }

  Mesh& m_mesh;
  Skirt_triangulation_3<Mesh> m_skirt;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_REMOVE_BAD_EDGE_3_H
