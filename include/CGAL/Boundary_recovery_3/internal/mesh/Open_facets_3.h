// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_OPEN_FACETS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_OPEN_FACETS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Glues the cells that fill a polyhedron to the cells around it and to each other, by means of a hash table of the
 * facets that were met once: for large polyhedra, and for those whose old cells go before new ones come.
 *
 * All the memory is allocated by the constructor.
 */
template <typename Tr>
class Open_facets_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;

  // So many cells are going to fill the place of the old ones, which are still there.
  template <typename CellRange>
  Open_facets_3(const CellRange& old_cells, const std::size_t number_of_new_cells)
  {
    internal::for_each_outer_facet(old_cells, [this](const Cell_handle c, const int i)
    {
      const Cell_handle n = c->neighbor(i);
      m_facets.push_back(Facet{ n, n->index(c) });
    });
    // each inner facet is one of two new cells
    const std::size_t n = m_facets.size() + 2 * number_of_new_cells;
    m_facets.reserve(n);
    m_index.reserve(n);
    for(const Facet& f : m_facets)
      m_index.insert(internal::facet_vertices(f.cell, f.index));
  }

  // Makes the facet i of the new cell c adjacent to that with the same vertices, or opens it.
  void glue(Tr& tr, const Cell_handle c, const int i)
  {
    const auto inserted = m_index.insert(internal::facet_vertices(c, i));
    if(inserted.second)
      m_facets.push_back(Facet{ c, i });
    else
    {
      const Facet& f = m_facets[inserted.first];
      tr.tds().set_adjacency(c, i, f.cell, f.index);
      ++m_number_of_adjacencies;
    }
  }

  // Whether no facet is open.
  bool empty() const { return m_number_of_adjacencies == m_facets.size(); }

private:
  struct Facet
  {
    Cell_handle cell;
    int index;
  };

  Simplex_index_3<Vertex_handle, 3> m_index;
  std::vector<Facet> m_facets; // by these numbers
  std::size_t m_number_of_adjacencies = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_OPEN_FACETS_3_H
