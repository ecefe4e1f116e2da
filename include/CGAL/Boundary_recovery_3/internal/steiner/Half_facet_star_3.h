// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_HALF_FACET_STAR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_HALF_FACET_STAR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>

#include <iterator>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// The side of a mesh facet s v w from which v and w are seen in counterclockwise order around s.
template <typename Tr>
struct Half_facet_3
{
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Cell_handle       Cell_handle;

  // The facet opposite to the vertex i of a cell that has s.
  Half_facet_3(const Vertex_handle s, const Cell_handle c, const int i)
    : cell(c), opposite(c->vertex(i))
  {
    const auto f = internal::facet_vertices(c, i);
    int k = 0;
    while(f[k] != s)
      ++k;
    v = f[(k + 1) % 3];
    w = f[(k + 2) % 3];
  }

  Vertex_handle v, w;
  Cell_handle cell;        // the one on this side
  Vertex_handle opposite;  // its fourth vertex
};

/*
 * The cells around a vertex, and the sides of all mesh facets at it. They are what they were when they were collected.
 */
template <typename Tr>
class Half_facet_star_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Cell_handle       Cell_handle;
  typedef Half_facet_3<Tr>               Half_facet;

  explicit Half_facet_star_3(const Tr& tr) : m_tr(tr) { }

  void collect(const Vertex_handle s)
  {
    m_center = s;
    m_cells.clear();
    m_half_facets.clear();
    m_tr.incident_cells(s, std::back_inserter(m_cells));
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        if(c->vertex(i) != s)
          m_half_facets.emplace_back(s, c, i);
  }

  Vertex_handle center() const { return m_center; }
  const std::vector<Cell_handle>& cells() const { return m_cells; }
  const std::vector<Half_facet>& half_facets() const { return m_half_facets; }

private:
  const Tr& m_tr;
  Vertex_handle m_center;
  std::vector<Cell_handle> m_cells;
  std::vector<Half_facet> m_half_facets;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_HALF_FACET_STAR_3_H
