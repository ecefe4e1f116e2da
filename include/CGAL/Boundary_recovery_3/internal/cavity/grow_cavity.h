// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_GROW_CAVITY_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_GROW_CAVITY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Ways in which a cavity grows and shrinks.
 */

// The number of vertices if the cell is added.
template <typename Cavity>
std::size_t number_of_vertices_with(Cavity& cavity, const typename Cavity::Cell_handle extra)
{
  std::size_t n = cavity.vertices().size();
  for(int i = 0; i < 4; ++i)
    if(! cavity.contains(extra->vertex(i)))
      ++n;
  return n;
}

// Adds one more layer: the cells beyond the boundary, the hull excepted, while there are few enough vertices.
template <typename Cavity>
void add_layer(Cavity& cavity, const std::size_t max_number_of_vertices = (std::numeric_limits<std::size_t>::max)())
{
  const std::vector<typename Cavity::Cell_handle> inner = cavity.cells();
  for(const auto c : inner)
    for(int i = 0; i < 4; ++i)
      if(internal::number_of_vertices_with(cavity, c->neighbor(i)) <= max_number_of_vertices)
        cavity.add(c->neighbor(i));
}

// Adds the cells behind the faces that v does not see from inside, until it sees all. Returns false if a constraint or
// the hull is in the way, or if there would be more cells than allowed.
template <typename Cavity, typename Predicates>
bool grow_until_seen(Cavity& cavity, const typename Cavity::Vertex_handle v, const Predicates& predicates,
                     const std::size_t max_number_of_cells)
{
  for(std::size_t k = 0; k < cavity.cells().size(); ++k) // it grows
    for(int i = 0; i < 4; ++i)
    {
      const auto c = cavity.cells()[k];
      const auto f = internal::facet_vertices(c, i);
      if(cavity.contains(c->neighbor(i)) || predicates.orientation(f[0], f[1], f[2], v) == POSITIVE)
        continue;
      if(cavity.is_closed(c, i) || cavity.cells().size() >= max_number_of_cells)
        return false;
      cavity.add(c->neighbor(i));
    }
  return true;
}

// Adds the cells that can be reached from those of the cavity through facets that are not closed, as far as they are
// wanted: `is_wanted` is asked for each cell behind such a facet.
template <typename Cavity, typename Is_wanted>
void grow_where(Cavity& cavity, const Is_wanted& is_wanted)
{
  for(std::size_t k = 0; k < cavity.cells().size(); ++k) // it grows
    for(int i = 0; i < 4; ++i)
    {
      const auto c = cavity.cells()[k];
      const auto n = c->neighbor(i);
      if(! cavity.contains(n) && ! cavity.is_closed(c, i) && is_wanted(n))
        cavity.add(n);
    }
}

// Takes out the cells at faces that v does not see from inside, until it sees all. The first cells, the seeds, have to
// stay: returns false if one of them is at such a face. Whatever the order, the same cells stay.
template <typename Cavity, typename Predicates>
bool shrink_until_seen(Cavity& cavity, const typename Cavity::Vertex_handle v, const Predicates& predicates,
                       const std::size_t number_of_seeds)
{
  typedef typename Cavity::Cell_handle Cell_handle;
  const auto is_at_hidden_face = [&](const Cell_handle c)
  {
    for(int i = 0; i < 4; ++i)
    {
      const auto f = internal::facet_vertices(c, i);
      if(! cavity.contains(c->neighbor(i)) && predicates.orientation(f[0], f[1], f[2], v) != POSITIVE)
        return true;
    }
    return false;
  };
  std::vector<Cell_handle> open = cavity.cells();
  const std::vector<Cell_handle> seeds(open.begin(), open.begin() + number_of_seeds);
  while(! open.empty())
  {
    const Cell_handle c = open.back();
    open.pop_back();
    if(! cavity.contains(c) || ! is_at_hidden_face(c))
      continue;
    if(internal::contains(seeds, c))
      return false;
    cavity.remove(c);
    for(int i = 0; i < 4; ++i)
      open.push_back(c->neighbor(i));
  }
  return true;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_GROW_CAVITY_H
