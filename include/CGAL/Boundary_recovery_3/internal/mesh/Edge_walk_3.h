// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_EDGE_WALK_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_EDGE_WALK_3_H

#include <CGAL/license/Boundary_recovery_3.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * A walk from cell to cell around an edge, in one of both directions.
 */
template <typename Tr>
class Edge_walk_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef typename Tr::Facet         Facet;

  // Of the vertices of the cell that are not on the edge, `across` is the one opposite to the facet that is crossed
  // first, and `kept` the other one.
  Edge_walk_3(const Cell_handle cell, const int across, const int kept)
    : m_cell(cell), m_across(across), m_kept(cell->vertex(kept))
  { }

  Cell_handle cell() const { return m_cell; }

  // The next facet, opposite to a vertex of the cell that is not on the edge.
  int next_facet() const { return m_across; }

  // The vertex of the next facet that is not on the edge.
  Vertex_handle apex() const { return m_kept; }

  void operator++()
  {
    const Cell_handle next = m_cell->neighbor(m_across);
    const Vertex_handle entered = next->vertex(next->index(m_cell));
    m_across = next->index(m_kept);
    m_kept = entered;
    m_cell = next;
  }

private:
  Cell_handle m_cell;
  int m_across;
  Vertex_handle m_kept;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_EDGE_WALK_3_H
