// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REGIONS_AT_PLACES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REGIONS_AT_PLACES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The cells that have a place: one, or those that share the facet, edge or vertex that it is on.
 */
template <typename Tr>
std::vector<typename Tr::Cell_handle> cells_at(const Tr& tr, const typename Tr::Point& place)
{
  typedef typename Tr::Cell_handle Cell_handle;
  typename Tr::Locate_type type;
  int i, j;
  const Cell_handle c = tr.locate(place, type, i, j);
  std::vector<Cell_handle> cells(1, c);
  if(type == Tr::FACET)
    cells.push_back(c->neighbor(i));
  else if(type == Tr::EDGE)
  {
    auto circulator = tr.incident_cells(c, i, j);
    const auto begin = circulator;
    while(++circulator != begin)
      cells.push_back(circulator);
  }
  else if(type == Tr::VERTEX)
  {
    cells.clear();
    tr.incident_cells(c->vertex(i), std::back_inserter(cells));
  }
  return cells;
}

/*
 * The region that a place is in, 0 outside of all. There is none if the place is on a facet between two regions.
 */
template <typename Tr>
std::optional<int> region_at(const Tr& tr, const typename Tr::Point& place)
{
  const auto cells = internal::cells_at(tr, place);
  const int region = cells[0]->subdomain_index();
  const bool is_inside = std::all_of(cells.begin(), cells.end(),
                                     [&](const auto c) { return c->subdomain_index() == region; });
  return is_inside ? std::optional<int>(region) : std::nullopt;
}

/*
 * Makes the regions that places are in a part of the outside, and numbers the others anew, in their order. Returns how
 * many are left; the positions of places that are in no region are added to a list.
 */
template <typename Tr>
int empty_regions(Tr& tr, const std::vector<typename Tr::Point>& places, const int number_of_regions,
                  std::vector<std::size_t>& not_in_region)
{
  std::vector<int> number(static_cast<std::size_t>(number_of_regions) + 1, 1);
  number[0] = 0;
  for(std::size_t i = 0; i < places.size(); ++i)
  {
    const int region = internal::region_at(tr, places[i]).value_or(0);
    number[static_cast<std::size_t>(region)] = 0;
    if(region == 0)
      not_in_region.push_back(i);
  }
  int left = 0;
  for(int& n : number)
    n = n == 0 ? 0 : ++left;
  for(const auto c : tr.finite_cell_handles())
    c->set_subdomain_index(number[static_cast<std::size_t>(c->subdomain_index())]);
  for(const auto v : tr.finite_vertex_handles())
    if(v->in_dimension() == 3)
      internal::set_vertex_indices(*v, 3, v->cell()->subdomain_index());
  return left;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REGIONS_AT_PLACES_H
