// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FLOOD_FILL_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FLOOD_FILL_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Reaches cells from a seed over facets: `is_open` tells for a cell that was reached and the index of a facet whether
// to look behind it. `add` is called with the seed and with each cell that is found, maybe several times; it has to
// return whether the cell is new, and to remember it then. The order depends on the cells' neighbors only.
template <typename Cell_handle, typename Is_open, typename Add>
void flood_fill(const Cell_handle seed, const Is_open& is_open, const Add& add)
{
  std::vector<Cell_handle> front;
  const auto reach = [&](const Cell_handle c)
  {
    if(add(c))
      front.push_back(c);
  };
  reach(seed);
  while(! front.empty())
  {
    const Cell_handle c = front.back();
    front.pop_back();
    for(int i = 0; i < 4; ++i)
      if(is_open(c, i))
        reach(c->neighbor(i));
  }
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FLOOD_FILL_H
