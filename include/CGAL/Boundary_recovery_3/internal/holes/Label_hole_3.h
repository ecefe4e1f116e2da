// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_LABEL_HOLE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_LABEL_HOLE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/flood_fill.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Writes into a triangulation which cells are inside of a hole, and in which region: both sides of each facet of its
 * surface are known. Where they contradict each other, the surface bounds no such hole: it is turned inside out.
 */
template <typename Tr>
class Label_hole_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef std::array<Vertex_handle, 3> Facet;

  explicit Label_hole_3(Tr& tr) : m_tr(tr) { }

  // The facets are in the triangulation; `regions` has for each of them the region on its positive side, and that on
  // the other one, 0 being outside. Returns false if they contradict each other.
  bool operator()(const std::vector<Facet>& facets, const std::vector<std::array<int, 2> >& regions)
  {
    for(const Facet& f : facets)
      m_index.insert(f);
    std::vector<Cell_handle> seeds;
    for(const Cell_handle c : m_tr.all_cell_handles())
      c->set_subdomain_index(m_tr.is_infinite(c) ? 0 : int(unknown));
    for(const Cell_handle c : m_tr.all_cell_handles())
      if(! label_by_facets(c, facets, regions, seeds))
        return false;
    for(const Cell_handle c : seeds)
      if(! spread(c))
        return false;
    return true;
  }

private:
  static constexpr int unknown = -1;

  // A cell is on the positive side of its facets, as `facet_vertices()` has them. Each facet is looked up once.
  bool label_by_facets(const Cell_handle c, const std::vector<Facet>& facets,
                       const std::vector<std::array<int, 2> >& regions, std::vector<Cell_handle>& seeds)
  {
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle n = c->neighbor(i);
      if(n < c)
        continue;
      const Facet f = internal::facet_vertices(c, i);
      const std::size_t k = m_index[f];
      c->set_surface_patch_index(i, k == m_index.none ? 0 : 1);
      n->set_surface_patch_index(m_tr.mirror_index(c, i), k == m_index.none ? 0 : 1);
      if(k == m_index.none)
        continue;
      const int side = is_rotation(f, facets[k]) ? 0 : 1;
      if(! label(c, regions[k][side], seeds) || ! label(n, regions[k][1 - side], seeds))
        return false;
    }
    return true;
  }

  // Returns false if it has another region.
  static bool label(const Cell_handle c, const int region, std::vector<Cell_handle>& seeds)
  {
    if(c->subdomain_index() != unknown && c->subdomain_index() != region)
      return false;
    c->set_subdomain_index(region);
    seeds.push_back(c);
    return true;
  }

  // Whether the order of the same three vertices is the same.
  static bool is_rotation(const Facet& f, const Facet& g)
  {
    const int i = f[0] == g[0] ? 0 : f[0] == g[1] ? 1 : 2;
    return f[1] == g[(i + 1) % 3];
  }

  // Returns false if there is a cell of another region.
  bool spread(const Cell_handle seed)
  {
    const int region = seed->subdomain_index();
    bool is_consistent = true, is_first = true;
    const auto is_open = [](const Cell_handle c, const int i)
    {
      return ! c->is_facet_on_surface(i) && c->neighbor(i)->subdomain_index() != c->subdomain_index();
    };
    internal::flood_fill(seed, is_open, [&](const Cell_handle c)
    {
      is_consistent = is_consistent && (c->subdomain_index() == unknown || c->subdomain_index() == region);
      const bool is_new = is_first || c->subdomain_index() == unknown;
      is_first = false;
      if(is_new)
        c->set_subdomain_index(region);
      return is_new;
    });
    return is_consistent;
  }

  Tr& m_tr;
  Simplex_index_3<Vertex_handle, 3> m_index;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_LABEL_HOLE_3_H
