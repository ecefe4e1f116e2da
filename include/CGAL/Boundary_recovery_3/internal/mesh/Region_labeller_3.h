// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REGION_LABELLER_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REGION_LABELLER_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Numbers of cells, kept beside a triangulation that may have any cells, and is not to be changed.
template <typename Tr>
class Numbers_beside_cells_3
{
public:
  typedef typename Tr::Cell_handle Cell_handle;

  void set(const Cell_handle c, const std::size_t number) { m_numbers[c] = number; }

  std::size_t operator[](const Cell_handle c) const { return m_numbers[c]; }

private:
  Unique_hash_map<Cell_handle, std::size_t> m_numbers; // for looking up only
};

// Cuts the cells of a triangulation, the infinite ones included, into components that the given facets
// separate, and decides which components belong to the domain.
//
// `CellNumbers` remembers a number for each cell, as `Numbers_beside_cells_3` does.
template <typename Tr, typename CellNumbers = Numbers_beside_cells_3<Tr> >
class Region_labeller_3
{
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef typename Tr::Cell_handle           Cell_handle;
  typedef typename Tr::Facet                 Facet;
  typedef std::array<Vertex_handle, 3>       Vertex_triple;

public:
  // a facet that separates: where it is in the triangulation, and how often it was given, with signs
  struct Constrained_facet
  {
    Vertex_triple vertices; // as it was given first
    std::size_t index;   // position of that one in the given range
    Facet facet;         // seen from this cell the three vertices turn as in `Tr::vertex_triple_index()`
    bool found = false;  // whether it is a facet of the triangulation
    long weight = 0;     // number of given facets that turn like it minus those that turn the other way; until it is
                         // found, like the first one
    bool odd = false;    // whether it was given an odd number of times
    bool agrees = true;  // whether the first one that was given turns like `facet`
    std::size_t component = 0, component_behind = 0; // of `facet`, if it is found
  };

private:
  // a way out of a component through a constrained facet, and what it adds to the winding number
  struct Crossing
  {
    std::size_t target;
    long weight;
  };

  const Tr& m_tr;
  std::vector<Constrained_facet> m_facets;                 // in the order of the facets
  Simplex_index_3<Vertex_handle, 3> m_facet_index;
  CellNumbers m_cell_index;
  std::vector<Cell_handle> m_cells;
  std::vector<unsigned char> m_closed;                     // bit i: facet i of the cell is constrained
  std::vector<std::size_t> m_component;                    // of each cell; 0 has the infinite cells
  std::size_t m_number_of_components = 0;

public:
  template <typename FacetRange>
  Region_labeller_3(const Tr& tr, const FacetRange& facets)
    : m_tr(tr)
  {
    std::size_t i = 0;
    for(const auto& facet : facets)
      add_facet(Vertex_triple{{facet[0], facet[1], facet[2]}}, i++);
    index_cells();
    find_facets();
    find_components();
  }

  // Calls `set_region` with each cell, the infinite ones included, and its region. Returns the number of regions.
  template <typename SetRegion>
  int label(const SetRegion& set_region) const
  {
    int number_of_regions = 0;
    const std::vector<int> numbers = number_regions(components_of_domain(), number_of_regions);
    for(std::size_t i = 0; i < m_cells.size(); ++i)
      set_region(m_cells[i], numbers[m_component[i]]);
    return number_of_regions;
  }

  // Each given facet once, in the order in which they were given first.
  const std::vector<Constrained_facet>& facets() const { return m_facets; }

private:
  void add_facet(const Vertex_triple& triple, const std::size_t index)
  {
    const auto inserted = m_facet_index.insert(triple);
    if(inserted.second)
    {
      m_facets.emplace_back();
      m_facets.back().vertices = triple;
      m_facets.back().index = index;
    }
    Constrained_facet& f = m_facets[inserted.first];
    f.weight += is_rotation(f.vertices, triple) ? 1 : -1;
    f.odd = ! f.odd;
  }

  void index_cells()
  {
    m_cells.reserve(m_tr.tds().number_of_cells());
    for(const Cell_handle c : m_tr.all_cell_handles())
    {
      m_cell_index.set(c, m_cells.size());
      m_cells.push_back(c);
    }
    m_closed.assign(m_cells.size(), 0);
  }

  // one sweep over all facets of the triangulation, instead of one search in a star for each of them
  void find_facets()
  {
    Facet_filter_3<Vertex_handle> filter(m_facets.size());
    for(const Constrained_facet& f : m_facets)
      filter.insert(f.vertices);
    internal::find_facets(m_cells, filter, m_facet_index, [this](const std::size_t f, const Cell_handle c, const int i)
    {
      if(! m_tr.is_infinite(c, i))
        found(m_facets[f], Facet(c, i));
    });
  }

  void found(Constrained_facet& f, const Facet& facet)
  {
    f.facet = facet;
    f.found = true;
    f.agrees = is_rotation(f.vertices, internal::facet_vertices(facet.first, facet.second));
    if(! f.agrees)
      f.weight = -f.weight;
    close(facet);
    close(m_tr.mirror_facet(facet));
  }

  void close(const Facet& f) { m_closed[m_cell_index[f.first]] |= static_cast<unsigned char>(1 << f.second); }

  void find_components()
  {
    m_component.assign(m_cells.size(), std::size_t(-1));
    fill(m_tr.infinite_cell());
    for(std::size_t i = 0; i < m_cells.size(); ++i)
      if(m_component[i] == std::size_t(-1))
        fill(m_cells[i]);
    for(Constrained_facet& f : m_facets)
      if(f.found)
      {
        f.component = component(f.facet.first);
        f.component_behind = component(f.facet.first->neighbor(f.facet.second));
      }
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

  std::size_t component(const Cell_handle c) const { return m_component[m_cell_index[c]]; }

  // The constrained facets are a cycle iff there are winding numbers: one for each component, such that crossing a
  // facet changes it by the weight of the facet. One with the same component on both sides, as in a sheet that ends
  // inside, separates nothing and has no say. Without such numbers the same is tried mod 2, where orientation does not
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
    for(const Constrained_facet& f : m_facets)
    {
      if(! f.found)
        continue;
      const std::size_t here = f.component, there = f.component_behind;
      if(here == there)
        continue;
      const long weight = mod_2 ? long(f.odd) : f.weight;
      add(Crossing{there, weight}, result[here]);
      add(Crossing{here, mod_2 ? weight : -weight}, result[there]);
    }
    return result;
  }

  // most of them are like the last one
  static void add(const Crossing& crossing, std::vector<Crossing>& crossings)
  {
    if(crossings.empty() || crossings.back().target != crossing.target || crossings.back().weight != crossing.weight)
      crossings.push_back(crossing);
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
    for(const Constrained_facet& f : m_facets)
    {
      if(! f.found)
        continue;
      number(f.agrees ? f.component_behind : f.component); // the normal of a vertex triple points into the cell
      number(f.agrees ? f.component : f.component_behind);
    }
    return numbers;
  }
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_REGION_LABELLER_3_H
