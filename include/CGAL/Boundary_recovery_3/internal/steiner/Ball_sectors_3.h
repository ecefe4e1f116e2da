// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_BALL_SECTORS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_BALL_SECTORS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/flood_fill.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Facet_fans_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Half_facet_star_3.h>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The sectors into which fans cut the ball of a vertex: sets of cells, numbered in the order of the cells of the star.
 */
template <typename Tr>
class Ball_sectors_3
{
public:
  typedef typename Tr::Cell_handle       Cell_handle;
  typedef Half_facet_star_3<Tr>          Star;
  typedef Facet_fans_3<Tr>               Fans;
  typedef typename Fans::Fan             Fan;

  explicit Ball_sectors_3(const Tr& tr) : m_tr(tr) { }

  void label(const Star& star, const Fans& fans)
  {
    m_sector_of_cell.clear();
    m_is_infinite.clear();
    const auto is_open = [&](const Cell_handle c, const int i)
    {
      if(c->vertex(i) == star.center())
        return false;
      const Half_facet_3<Tr> h(star.center(), c, i);
      return ! fans.contains(h.v, h.w);
    };
    const auto add = [this](const Cell_handle c) { return m_sector_of_cell.emplace(&*c, size() - 1).second; };
    for(const Cell_handle c : star.cells())
      if(m_sector_of_cell.count(&*c) == 0)
      {
        m_is_infinite.push_back(m_tr.is_infinite(c));
        internal::flood_fill(c, is_open, add);
      }
  }

  std::size_t size() const { return m_is_infinite.size(); }

  // Whether the sector i is outside the hull.
  bool is_infinite(const std::size_t i) const { return m_is_infinite[i]; }

  // The sector that a cell of the star is in.
  std::size_t operator[](const Cell_handle c) const { return m_sector_of_cell.find(&*c)->second; }

  // Those on the positive and on the negative side of a fan.
  std::array<std::size_t, 2> sides(const Fan& fan) const
  {
    const auto& h = fan.facets.front();
    return {{ (*this)[h.cell], (*this)[h.cell->neighbor(h.cell->index(h.opposite))] }};
  }

private:
  const Tr& m_tr;
  std::unordered_map<const void*, std::size_t> m_sector_of_cell; // look-up only
  std::vector<bool> m_is_infinite;                               // by sector
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_BALL_SECTORS_3_H
