// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_LABEL_REGIONS_H
#define CGAL_BOUNDARY_RECOVERY_3_LABEL_REGIONS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/flood_fill.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/Unique_hash_map.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Cuts the cells of a triangulation, the infinite ones included, into components that the given facets
// separate, and decides which components belong to the domain.
template <typename Tr>
class Region_labeller_3
{
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef typename Tr::Cell_handle           Cell_handle;
  typedef typename Tr::Facet                 Facet;
  typedef std::array<Vertex_handle, 3>       Vertex_triple;

  // a facet that separates: where it is in the triangulation, and how often it was given, with signs
  struct Wall
  {
    Vertex_triple vertices;     // as it was given first
    Facet facet;         // seen from this cell the three vertices turn as in `Tr::vertex_triple_index()`
    bool found = false;  // whether it is a facet of the triangulation
    long weight = 0;     // number of given facets that turn like it minus those that turn the other way; until it is
                         // found, like the first one
    bool odd = false;    // whether it was given an odd number of times
    bool agrees = true;  // whether the first one that was given turns like `facet`
  };

  // a way out of a component through a wall, and what it adds to the winding number
  struct Crossing
  {
    std::size_t target;
    long weight;
  };

  const Tr& m_tr;
  std::vector<Wall> m_walls;                               // in the order of the facets
  Simplex_index_3<Vertex_handle, 3> m_wall_index;
  Unique_hash_map<Cell_handle, std::size_t> m_cell_index;  // for looking up only
  std::vector<Cell_handle> m_cells;
  std::vector<unsigned char> m_closed;                     // bit i: facet i of the cell is a wall
  std::vector<std::size_t> m_component;                    // of each cell; 0 has the infinite cells
  std::size_t m_number_of_components = 0;

public:
  template <typename FacetRange>
  Region_labeller_3(const Tr& tr, const FacetRange& facets)
    : m_tr(tr)
  {
    for(const auto& facet : facets)
      add_wall(Vertex_triple{{facet[0], facet[1], facet[2]}});
    index_cells();
    find_walls();
    find_components();
  }

  template <typename CellRegionMap>
  int label(CellRegionMap region) const
  {
    int number_of_regions = 0;
    const std::vector<int> numbers = number_regions(components_of_domain(), number_of_regions);
    for(std::size_t i = 0; i < m_cells.size(); ++i)
      if(! m_tr.is_infinite(m_cells[i]))
        put(region, m_cells[i], numbers[m_component[i]]);
    return number_of_regions;
  }

private:
  // whether two triples of the same vertices turn alike
  static bool turn_alike(const Vertex_triple& s, const Vertex_triple& t)
  {
    const int i = s[0] == t[0] ? 0 : s[0] == t[1] ? 1 : 2;
    return s[1] == t[(i + 1) % 3];
  }

  void add_wall(const Vertex_triple& triple)
  {
    const auto inserted = m_wall_index.insert(triple);
    if(inserted.second)
    {
      m_walls.emplace_back();
      m_walls.back().vertices = triple;
    }
    Wall& wall = m_walls[inserted.first];
    wall.weight += turn_alike(wall.vertices, triple) ? 1 : -1;
    wall.odd = ! wall.odd;
  }

  void index_cells()
  {
    m_cells.reserve(m_tr.tds().number_of_cells());
    for(const Cell_handle c : m_tr.all_cell_handles())
    {
      m_cell_index[c] = m_cells.size();
      m_cells.push_back(c);
    }
    m_closed.assign(m_cells.size(), 0);
  }

  void close(const Facet& f)
  {
    m_closed[m_cell_index[f.first]] |= static_cast<unsigned char>(1 << f.second);
  }

  // one sweep over all facets of the triangulation, instead of one search in a star for each wall
  void find_walls()
  {
    for(auto it = m_tr.finite_facets_begin(); it != m_tr.finite_facets_end(); ++it)
    {
      const Facet f = *it;
      const Vertex_triple triple = internal::facet_vertices(f.first, f.second);
      const std::size_t index = m_wall_index[triple];
      if(index == Simplex_index_3<Vertex_handle, 3>::none)
        continue;

      Wall& wall = m_walls[index];
      wall.facet = f;
      wall.found = true;
      wall.agrees = turn_alike(wall.vertices, triple);
      if(! wall.agrees)
        wall.weight = -wall.weight;
      close(f);
      close(m_tr.mirror_facet(f));
    }
  }

  void find_components()
  {
    m_component.assign(m_cells.size(), std::size_t(-1));
    fill(m_tr.infinite_cell());
    for(std::size_t i = 0; i < m_cells.size(); ++i)
      if(m_component[i] == std::size_t(-1))
        fill(m_cells[i]);
  }

  // a new component
  void fill(const Cell_handle seed)
  {
    const auto is_open = [this](const Cell_handle c, const int i)
    {
      return ((m_closed[m_cell_index[c]] >> i) & 1) == 0;
    };
    const auto add = [this](const Cell_handle c)
    {
      std::size_t& component = m_component[m_cell_index[c]];
      if(component != std::size_t(-1))
        return false;
      component = m_number_of_components;
      return true;
    };
    internal::flood_fill(seed, is_open, add);
    ++m_number_of_components;
  }

  std::size_t component(const Facet& f) const { return m_component[m_cell_index[f.first]]; }

  // The walls are a cycle iff there are winding numbers: one for each component, such that crossing a wall changes
  // it by the weight of the wall. A wall with the same component on both sides, as in a sheet that ends inside,
  // separates nothing and has no say. Without such numbers the same is tried mod 2, where orientation does not
  // matter, and without these every component that is bounded belongs to the domain.
  std::vector<bool> components_of_domain() const
  {
    std::vector<long> winding;
    if(! assign_windings(false, winding) && ! assign_windings(true, winding))
    {
      winding.assign(m_number_of_components, 1);
      winding[0] = 0;
    }
    std::vector<bool> in_domain(m_number_of_components);
    for(std::size_t i = 0; i < winding.size(); ++i)
      in_domain[i] = winding[i] != 0;
    return in_domain;
  }

  std::vector<std::vector<Crossing> > crossings(const bool mod_2) const
  {
    std::vector<std::vector<Crossing> > result(m_number_of_components);
    for(const Wall& wall : m_walls)
    {
      if(! wall.found)
        continue;
      const std::size_t here = component(wall.facet);
      const std::size_t there = component(m_tr.mirror_facet(wall.facet));
      if(here == there)
        continue;
      const long weight = mod_2 ? long(wall.odd) : wall.weight;
      result[here].push_back(Crossing{there, weight});
      result[there].push_back(Crossing{here, mod_2 ? weight : -weight});
    }
    return result;
  }

  // returns whether the numbers are the same along every way from the infinite cells to a component
  bool assign_windings(const bool mod_2, std::vector<long>& winding) const
  {
    const std::vector<std::vector<Crossing> > graph = crossings(mod_2);
    std::vector<bool> is_known(m_number_of_components, false);
    std::vector<std::size_t> stack(1, 0);
    winding.assign(m_number_of_components, 0);
    is_known[0] = true;
    while(! stack.empty())
    {
      const std::size_t current = stack.back();
      stack.pop_back();
      for(const Crossing& crossing : graph[current])
      {
        const long w = mod_2 ? (winding[current] ^ crossing.weight) : winding[current] + crossing.weight;
        if(is_known[crossing.target])
        {
          if(winding[crossing.target] != w)
            return false;
          continue;
        }
        is_known[crossing.target] = true;
        winding[crossing.target] = w;
        stack.push_back(crossing.target);
      }
    }
    return true;
  }

  // the region of each component: 0 outside, else by the first facet that touches it, first the side
  // that an outward facet has inside
  std::vector<int> number_regions(const std::vector<bool>& in_domain, int& number_of_regions) const
  {
    std::vector<int> numbers(m_number_of_components, 0);
    const auto number = [&](const std::size_t i)
    {
      if(in_domain[i] && numbers[i] == 0)
        numbers[i] = ++number_of_regions;
    };
    for(const Wall& wall : m_walls)
    {
      if(! wall.found)
        continue;
      const std::size_t here = component(wall.facet), there = component(m_tr.mirror_facet(wall.facet));
      number(wall.agrees ? there : here); // a vertex triple turns such that its normal points into the cell
      number(wall.agrees ? here : there);
    }
    return numbers;
  }
};

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief labels each finite cell of a triangulation with the region that it is in, regions being separated by the
 * given facets.
 *
 * Region 0 is outside the domain. The regions of the domain are numbered 1, 2, ... in the order of the facets
 * that bound them: first the regions that touch the first facet, the one behind it (where an outward facet has
 * its inside) before the one in front of it.
 *
 * Which components belong to the domain is decided by integers only:
 * - whatever is connected to the infinite cells is outside; all of it is, where the surface has a gap;
 * - if the facets form an oriented cycle, components with winding number 0 are outside. Therefore a cube inside a
 *   cube is a void if its facets turn inward, and a second region if they turn outward;
 * - else, if every edge has an even number of facets, components that an even number of facets separates from the
 *   infinite cells are outside;
 * - else, as for regions that share facets, every bounded component belongs to the domain.
 *
 * A facet with the same component on both sides, as in a sheet that ends inside, separates nothing and does not
 * take part in this.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`, or of a class derived from it; no member is demanded of
 *            its cells
 * \tparam FacetRange a range of arrays of three `Tr::Vertex_handle`
 * \tparam CellRegionMap a model of `WritablePropertyMap` with `Tr::Cell_handle` as key type and `int` as value type
 *
 * \param tr the triangulation
 * \param facets the facets that separate, in the orientation of the input.
 *               Those that are not facets of `tr` are ignored.
 * \param region the region of each finite cell, which this function writes
 *
 * \return the number of regions of the domain; 0 if the dimension of `tr` is not 3, and nothing is written then.
 */
template <typename Tr, typename FacetRange, typename CellRegionMap>
int label_regions(const Tr& tr, const FacetRange& facets, CellRegionMap region)
{
  if(tr.dimension() < 3)
    return 0;
  return internal::Region_labeller_3<Tr>(tr, facets).label(region);
}

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_LABEL_REGIONS_H
