// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_WALK_TO_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_WALK_TO_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <optional>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * A walk from cell to cell to a place: always through a facet that has the place behind it, until no facet of the cell
 * has. Such a walk may run in circles where a mesh is not Delaunay, hence a bound on the number of steps.
 *
 * `facet_towards(c)` is the index of such a facet of the cell, negative if there is none; `cell_behind(c, i)` is the
 * cell behind a facet, if the walk may go there. There is no cell at the end if the way is barred or too long.
 */
template <typename Cell, typename FacetTowards, typename CellBehind>
std::optional<Cell> walk_to(const Cell start, const int max_number_of_steps, const FacetTowards& facet_towards,
                            const CellBehind& cell_behind)
{
  std::optional<Cell> c = start;
  for(int step = 0; step < max_number_of_steps && c; ++step)
  {
    const int i = facet_towards(*c);
    if(i < 0)
      return c;
    c = cell_behind(*c, i);
  }
  return std::nullopt;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_WALK_TO_H
