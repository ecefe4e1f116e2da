// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SPLIT_FACETS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SPLIT_FACETS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Finds the parts of a facet that was split when some cells were replaced.
 *
 * It goes by combinatorics. A facet abc that is gone was split by a new vertex v if the facets abv, bcv and cav are
 * there; or if its edge ab is gone, and the facets avc and vbc are there. If cells around it were starred from a vertex
 * beside it, this may find the facets of a cone over it: they separate the same cells.
 */
template <typename Tr>
class Split_facets_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef std::array<Vertex_handle, 3>  Vertex_triple;

  // The new cells, and the vertices of the old ones.
  template <typename CellRange>
  Split_facets_3(const CellRange& new_cells, const Simplex_index_3<Vertex_handle, 1>& old_vertices)
  {
    for(const Cell_handle c : new_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_triple f = internal::facet_vertices(c, i);
        for(int j = 0; j < 3; ++j)
          add(f[j], f[(j + 1) % 3], f[(j + 2) % 3], old_vertices[{{ f[(j + 2) % 3] }}] == old_vertices.none);
      }
  }

  // The parts of a facet that is gone, oriented as it was; none if it was not split by one vertex.
  std::vector<Vertex_triple> operator()(const Vertex_triple& facet) const
  {
    std::vector<Vertex_triple> best;
    for(int i = 0; i < 3; ++i)
      for(const Vertex_handle v : new_vertices_at(facet[i], facet[(i + 1) % 3]))
      {
        const std::vector<Vertex_triple> parts = parts_at(facet, v);
        if(parts.size() > best.size())
          best = parts;
      }
    return best;
  }

private:
  // The facet uvw is there.
  void add(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w, const bool is_new)
  {
    const std::size_t e = m_edges.insert({{ u, v }}).first;
    if(e == m_new_vertices.size())
      m_new_vertices.emplace_back();
    if(is_new && ! internal::contains(m_new_vertices[e], w))
      m_new_vertices[e].push_back(w);
  }

  bool is_edge(const Vertex_handle u, const Vertex_handle v) const { return m_edges[{{ u, v }}] != m_edges.none; }

  // The new vertices w for which the facet uvw is there.
  const std::vector<Vertex_handle>& new_vertices_at(const Vertex_handle u, const Vertex_handle v) const
  {
    const std::size_t e = m_edges[{{ u, v }}];
    return e == m_edges.none ? m_nothing : m_new_vertices[e];
  }

  std::vector<Vertex_triple> parts_at(const Vertex_triple& facet, const Vertex_handle v) const
  {
    std::vector<Vertex_triple> parts;
    bool is_covered = true;
    for(int i = 0; i < 3; ++i)
    {
      Vertex_triple part = facet;
      part[i] = v;
      const Vertex_handle p = facet[(i + 1) % 3], q = facet[(i + 2) % 3];
      if(internal::contains(new_vertices_at(p, q), v))
        parts.push_back(part);
      else
        is_covered = is_covered && ! is_edge(p, q);
    }
    if(! is_covered || parts.size() < 2)
      parts.clear();
    return parts;
  }

  Simplex_index_3<Vertex_handle, 2> m_edges;
  std::vector<std::vector<Vertex_handle> > m_new_vertices; // at the edge with this number
  const std::vector<Vertex_handle> m_nothing;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SPLIT_FACETS_3_H
