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

namespace CGAL::Boundary_recovery_3::internal {

// The property map of the places of what is sorted. `hilbert_sort()` cannot be stopped; the map throws to leave it, and
// `sort_in_space()` catches that.
template <typename Entry, typename Question>
struct Place_of_entry
{
  typedef Entry                          key_type;
  typedef typename Entry::first_type     value_type;
  typedef const value_type&              reference;
  typedef boost::lvalue_property_map_tag category;

  struct End_of_sort { };

  friend reference get(const Place_of_entry& map, const Entry& entry)
  {
    if(++*map.number_of_reads % 1024 == 0 && ! (*map.goes_on)())
      throw End_of_sort();
    return entry.first;
  }

  const Question* goes_on;
  std::size_t* number_of_reads;
};

/*
 * Sorts items along a Hilbert curve. Whoever works through them then finds in the cache what the last ones had around
 * them: in large meshes, that is most of the time. If `goes_on`, which is asked now and then, says no,
 * the items stay as they are.
 */
template <typename Item, typename CoordinatesOf, typename Question>
void sort_in_space(std::vector<Item>& items, const CoordinatesOf& coordinates_of, const Question& goes_on)
{
  typedef Simple_cartesian<double>         Kernel;
  typedef std::pair<Kernel::Point_3, Item> Entry;
  typedef Place_of_entry<Entry, Question>  Places;
  typedef Spatial_sort_traits_adapter_3<Kernel, Places> Traits;
  std::vector<Entry> entries;
  entries.reserve(items.size());
  for(const Item& item : items)
  {
    const std::array<double, 3> p = coordinates_of(item);
    entries.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), item);
  }
  std::size_t number_of_reads = 0;
  try {
    CGAL::hilbert_sort(entries.begin(), entries.end(), Traits(Places{ &goes_on, &number_of_reads }));
  } catch(const typename Places::End_of_sort&) {
    return;
  }
  for(std::size_t k = 0; k < items.size(); ++k)
    items[k] = entries[k].second;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_SORT_IN_SPACE_H
