// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SNAPSHOT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SNAPSHOT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Simplex_key_3.h>

#include <CGAL/assertions.h>

#include <array>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The cells of a triangulation, remembered by their vertices, so that all later changes can be taken back.
 */
template <typename Tr>
class Mesh_snapshot_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;

  explicit Mesh_snapshot_3(const Tr& tr)
  {
    m_cells.reserve(tr.number_of_cells());
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      m_cells.push_back({{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }});
  }

  // Makes the triangulation what it was. `new_vertices` are those that came into it since; the others are still in it.
  template <typename VertexRange, typename Visitor>
  void restore(Tr& tr, const VertexRange& new_vertices, Visitor& visitor) const
  {
    std::vector<Cell_handle> cells;
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      cells.push_back(c);
    visitor.before_cells_removal(cells);
    for(const Cell_handle c : cells)
      tr.tds().delete_cell(c);
    for(const Vertex_handle v : new_vertices)
      tr.tds().delete_vertex(v);
    cells.clear();
    std::unordered_map<Simplex_key_3<3>, std::pair<Cell_handle, int>, Simplex_key_hash> open_facets; // look-up only
    for(const std::array<Vertex_handle, 4>& v : m_cells)
    {
      const Cell_handle c = tr.tds().create_cell(v[0], v[1], v[2], v[3]);
      cells.push_back(c);
      for(int i = 0; i < 4; ++i)
      {
        v[i]->set_cell(c);
        const Simplex_key_3<3> key = simplex_key(v[(i + 1) & 3], v[(i + 2) & 3], v[(i + 3) & 3]);
        const auto it = open_facets.find(key);
        if(it == open_facets.end())
          open_facets.emplace(key, std::make_pair(c, i));
        else
        {
          tr.tds().set_adjacency(c, i, it->second.first, it->second.second);
          open_facets.erase(it);
        }
      }
    }
    CGAL_postcondition(open_facets.empty());
    visitor.after_cells_creation(cells);
  }

private:
  std::vector<std::array<Vertex_handle, 4> > m_cells;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SNAPSHOT_3_H
