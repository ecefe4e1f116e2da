// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SPANNED_CAVITY_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SPANNED_CAVITY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Cavities that contain the cells of the mesh that their vertices span: those behind faces of the cavity that have no
 * other vertices, as long as there are such. What is behind a constrained face has nothing to do with what is in front
 * of it, so the cavity does not grow through these, nor through the hull.
 */

// Adds the cells that the vertices span behind those from the given one on.
template <typename Cavity>
void add_spanned_cells(Cavity& cavity, const std::size_t first_new = 0)
{
  for(std::size_t k = first_new; k < cavity.cells().size(); ++k) // it grows
    for(int i = 0; i < 4; ++i)
    {
      const auto c = cavity.cells()[k];
      const auto n = c->neighbor(i);
      if(! cavity.contains(n) && cavity.contains(n->vertex(n->index(c))) && ! cavity.is_closed(c, i))
        cavity.add(n);
    }
}

// Adds a vertex that is behind a face, with all the cells that it brings.
template <typename Cavity>
void add_spanning_vertex(Cavity& cavity, const typename Cavity::Vertex_handle x)
{
  std::vector<typename Cavity::Cell_handle> cells;
  for(const auto& f : cavity.boundary())
    if(f.vertex_behind == x)
      cells.push_back(f.cell_behind);
  const std::size_t before = cavity.cells().size();
  for(const auto c : cells)
    cavity.add(c);
  internal::add_spanned_cells(cavity, before);
}

// The vertices behind faces that are not closed, those behind the largest number of such faces first.
template <typename Cavity>
typename Cavity::Vertices vertices_behind(Cavity& cavity)
{
  typedef typename Cavity::Vertex_handle Vertex_handle;
  Simplex_index_3<Vertex_handle, 1> known;
  std::vector<std::pair<std::size_t, Vertex_handle> > counts;
  for(const auto& f : cavity.boundary())
  {
    if(f.vertex_behind == Vertex_handle())
      continue;
    const auto inserted = known.insert({{ f.vertex_behind }});
    if(inserted.second)
      counts.push_back({ 0, f.vertex_behind });
    ++counts[inserted.first].first;
  }
  std::stable_sort(counts.begin(), counts.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  typename Cavity::Vertices result;
  for(const auto& c : counts)
    result.push_back(c.second);
  return result;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_SPANNED_CAVITY_H
