// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_SNAPSHOT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_SNAPSHOT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
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

  // The vertices that came into the triangulation since; no other may have gone.
  std::vector<Vertex_handle> new_vertices(const Tr& tr) const
  {
    Simplex_index_3<Vertex_handle, 1> old;
    for(const Tetrahedron& t : m_cells)
      for(const Vertex_handle v : t)
        old.insert({{ v }});
    std::vector<Vertex_handle> result;
    for(auto v = tr.tds().vertices().begin(); v != tr.tds().vertices().end(); ++v)
      if(old[{{ v }}] == old.none)
        result.push_back(v);
    return result;
  }

  // Makes the triangulation what it was, also if the data structure is not valid; `new_vertices` are those. What may
  // fail for want of memory comes first: the cells take the room of those that go.
  template <typename Visitor>
  void restore(Tr& tr, const std::vector<Vertex_handle>& new_vertices, Visitor& visitor) const
  {
    const std::vector<Adjacency> adjacencies = this->adjacencies();
    std::vector<Cell_handle> cells;
    cells.reserve((std::max)(tr.number_of_cells(), m_cells.size()));
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      cells.push_back(c);
    visitor.before_cells_removal(cells);
    for(const Cell_handle c : cells)
      tr.tds().delete_cell(c);
    for(const Vertex_handle v : new_vertices)
      tr.tds().delete_vertex(v);
    cells.clear();
    for(const Tetrahedron& v : m_cells)
    {
      cells.push_back(tr.tds().create_cell(v[0], v[1], v[2], v[3]));
      for(int i = 0; i < 4; ++i)
        v[i]->set_cell(cells.back());
    }
    for(const Adjacency& a : adjacencies)
      tr.tds().set_adjacency(cells[a[0].cell], a[0].index, cells[a[1].cell], a[1].index);
    visitor.after_cells_creation(cells);
  }

private:
  typedef std::array<Vertex_handle, 4> Tetrahedron;

  struct Facet
  {
    std::size_t cell; // position in `m_cells`
    int index;
  };

  typedef std::array<Facet, 2> Adjacency;

  std::vector<Adjacency> adjacencies() const
  {
    std::vector<Adjacency> result;
    result.reserve(2 * m_cells.size());
    Simplex_index_3<Vertex_handle, 3> facets;
    std::vector<Facet> seen_first; // by these numbers
    facets.reserve(2 * m_cells.size());
    seen_first.reserve(2 * m_cells.size());
    for(std::size_t c = 0; c < m_cells.size(); ++c)
      for(int i = 0; i < 4; ++i)
      {
        const Tetrahedron& v = m_cells[c];
        const auto inserted = facets.insert({{ v[(i + 1) & 3], v[(i + 2) & 3], v[(i + 3) & 3] }});
        if(inserted.second)
          seen_first.push_back(Facet{ c, i });
        else
          result.push_back({{ Facet{ c, i }, seen_first[inserted.first] }});
      }
    CGAL_postcondition(result.size() == facets.size());
    return result;
  }

  std::vector<Tetrahedron> m_cells;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_SNAPSHOT_3_H
