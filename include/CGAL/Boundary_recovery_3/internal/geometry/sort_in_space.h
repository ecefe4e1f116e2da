// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_SORT_IN_SPACE_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_SORT_IN_SPACE_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Sorts items along a Hilbert curve. Whoever works through them then finds in the cache what the last ones had around
 * them: in large meshes, that is most of the time.
 */
template <typename Item, typename CoordinatesOf>
void sort_in_space(std::vector<Item>& items, const CoordinatesOf& coordinates_of)
{
  typedef Simple_cartesian<double>         Kernel;
  typedef std::pair<Kernel::Point_3, Item> Entry;
  typedef Spatial_sort_traits_adapter_3<Kernel, First_of_pair_property_map<Entry>> Traits;
  std::vector<Entry> entries;
  entries.reserve(items.size());
  for(const Item& item : items)
  {
    const std::array<double, 3> p = coordinates_of(item);
    entries.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), item);
  }
  CGAL::hilbert_sort(entries.begin(), entries.end(), Traits());
  for(std::size_t k = 0; k < items.size(); ++k)
    items[k] = entries[k].second;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_SORT_IN_SPACE_H
