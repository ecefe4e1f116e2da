// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_EXTERIOR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_EXTERIOR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The cells that no constrained facets separate from the infinite ones.
 */
template <typename Tr>
class Exterior_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;

  Exterior_3(const Tr& tr, const Constraints_3<Tr>& constraints)
    : m_number_of_other_cells(tr.tds().number_of_cells()), m_contains(false)
  {
    std::vector<Cell_handle> stack;
    add(tr.infinite_cell(), stack);
    while(! stack.empty())
    {
      const Cell_handle c = stack.back();
      stack.pop_back();
      for(int i = 0; i < 4; ++i)
      {
        if(contains(c->neighbor(i)))
          continue;
        const std::array<Vertex_handle, 3> f = internal::facet_vertices(c, i);
        if(tr.is_infinite(c, i) || ! constraints.is_constrained(f[0], f[1], f[2]))
          add(c->neighbor(i), stack);
      }
    }
  }

  bool contains(const Cell_handle c) const { return m_contains[c]; }

  // Whether there are no other cells.
  bool is_everything() const { return m_number_of_other_cells == 0; }

private:
  void add(const Cell_handle c, std::vector<Cell_handle>& stack)
  {
    m_contains[c] = true;
    --m_number_of_other_cells;
    stack.push_back(c);
  }

  std::size_t m_number_of_other_cells;
  Unique_hash_map<Cell_handle, bool> m_contains;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_EXTERIOR_3_H
