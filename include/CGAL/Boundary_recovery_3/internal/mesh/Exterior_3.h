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
#include <CGAL/Boundary_recovery_3/internal/mesh/flood_fill.h>

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>

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
    const auto is_open = [&](const Cell_handle c, const int i)
    {
      const std::array<Vertex_handle, 3> f = internal::facet_vertices(c, i);
      return tr.is_infinite(c, i) || ! constraints.is_constrained(f[0], f[1], f[2]);
    };
    internal::flood_fill(tr.infinite_cell(), is_open, [this](const Cell_handle c) { return this->add(c); });
  }

  bool contains(const Cell_handle c) const { return m_contains[c]; }

  // Whether there are no other cells.
  bool is_everything() const { return m_number_of_other_cells == 0; }

private:
  // Returns whether c is new.
  bool add(const Cell_handle c)
  {
    bool& is_known = m_contains[c];
    if(is_known)
      return false;
    is_known = true;
    --m_number_of_other_cells;
    return true;
  }

  std::size_t m_number_of_other_cells;
  Unique_hash_map<Cell_handle, bool> m_contains;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_EXTERIOR_3_H
