// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FACET_TOWARDS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FACET_TOWARDS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

#include <array>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// A step of a walk, in floating point numbers: the facet of a cell that has the point most clearly behind it, of those
// for which `is_possible` holds; negative if there is none, as in the cell that contains the point.
template <typename Cell_handle, typename IsPossible>
int facet_towards(const Cell_handle c, const Coordinates_3& q, const IsPossible& is_possible)
{
  const std::array<Coordinates_3, 4> p = internal::corners(c);
  int facet = -1;
  double smallest_volume = 0;
  for(int i = 0; i < 4; ++i)
  {
    const double volume = internal::volume_times_6_with(p, i, q);
    if(volume < smallest_volume && is_possible(i))
    {
      smallest_volume = volume;
      facet = i;
    }
  }
  return facet;
}

template <typename Cell_handle>
int facet_towards(const Cell_handle c, const Coordinates_3& q)
{
  return internal::facet_towards(c, q, [](int) { return true; });
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_FACET_TOWARDS_H
