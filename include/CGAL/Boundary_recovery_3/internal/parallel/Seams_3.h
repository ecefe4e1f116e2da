// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SEAMS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SEAMS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/parallel/Seam_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// How processes exchange data if there is only one of them. If there are several, all call gather() at the same time.
struct No_exchange
{
  // Appends the elements of this array in all other processes. `T` is trivially copyable.
  template <typename T>
  void gather(std::vector<T>&) const { }
};

/*
 * Finds zones of cells around the *seams*, where the parts of a mesh meet. No cell is in two zones, so all zones can be
 * worked on at the same time. There are three rounds, after which hardly any seam is left:
 *  - zones around vertices of two parts, one for each pair of parts, without the cells at vertices of more parts;
 *  - the same for three parts;
 *  - zones around the vertices of four or more parts: vertices that are connected by edges, up to a number of them.
 * In further rounds, zones are around cells that are chosen by the caller, the *starts*.
 *
 * A zone has several layers of cells. One of the parts that have cells in the zone is its *owner*, and gets all of its
 * cells afterwards, so the next seams are elsewhere. Owners are chosen for the largest zone first: always the part that
 * has the fewest cells so far.
 *
 * A process looks only at its own parts, and exchanges data on shared vertices with the other processes. The zones
 * depend on the parts and on the numbers of the vertices, but not on which process has which part.
 */
template <typename Exchange = No_exchange>
class Seams_3
{
public:
  typedef Seam_part_3 Part;

  static constexpr std::size_t last_round = 4;
  static constexpr std::uint32_t none = Part::none;

  // See "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_connected_vertices = 512;

  struct Zone
  {
    std::vector<std::uint32_t> parts; // that have cells in it, in their order
    std::size_t number_of_cells;
    std::uint32_t owner;              // the one of them that it will belong to
  };

  Seams_3(std::vector<Part>& parts, const int number_of_layers, const Exchange& exchange = Exchange())
    : m_parts(parts), m_number_of_layers(number_of_layers), m_exchange(exchange), m_shared(parts, exchange)
  { }

  // Finds the zones of a round: the number of parts that meet, where `last_round` stands for this number and all larger
  // ones; 0 for zones around the starts. Sets `zone_of_cell` in the parts to positions in the returned list, or to
  // `none`. In round 0 and in the last one, a zone is around at most `max_number` vertices, which are connected.
  std::vector<Zone> find_zones(const std::size_t round, const std::size_t max_number = max_number_of_connected_vertices)
  {
    if(round == 0)
      start_at_starts(max_number);
    else if(round == last_round)
      start_at_connected_vertices(max_number);
    else
      start_at_vertices_of(round);
    return grow_zones(round == 0 || round == last_round ? std::size_t(-1) : round);
  }

private:
  void start_at_starts(const std::size_t max_number_of_vertices)
  {
    std::vector<std::array<std::size_t, 4> > cells;
    for(const Part& part : m_parts)
      for(const auto& start : part.starts)
        cells.push_back(start.numbers);
    m_exchange.gather(cells);
    const Components components(cells, max_number_of_vertices);
    for(Part& part : m_parts)
    {
      for(const auto& start : part.starts)
        for(std::size_t i = 0; i < 4; ++i)
          part.zone_of_vertex[part.tetrahedra[start.cell][i]] = components.find(start.numbers[i]);
      for(const auto& v : part.shared)
        part.zone_of_vertex[v.position] = components.find(v.number);
    }
  }

  // Connected components of vertices that are given by numbers: all vertices of a group are connected to each other. A
  // component that would have too many vertices is divided. Each component is denoted by the position of its first
  // vertex among the sorted numbers. The order of the groups makes no difference.
  class Components
  {
  public:
    template <std::size_t N>
    Components(const std::vector<std::array<std::size_t, N> >& groups, const std::size_t max_number_of_vertices)
      : m_max_number_of_vertices(max_number_of_vertices)
    {
      for(const auto& group : groups)
        m_numbers.insert(m_numbers.end(), group.begin(), group.end());
      std::sort(m_numbers.begin(), m_numbers.end());
      m_numbers.erase(std::unique(m_numbers.begin(), m_numbers.end()), m_numbers.end());
      m_components.assign(m_numbers.size(), none);
      const auto neighbors = find_neighbors(groups);
      for(std::uint32_t v = 0; v < m_numbers.size(); ++v)
        if(m_components[v] == none)
          form_component(v, neighbors);
    }

    // None if the vertex is in no group.
    std::uint32_t find(const std::size_t number) const
    {
      const std::size_t v = position(number);
      return v < m_numbers.size() && m_numbers[v] == number ? m_components[v] : none;
    }

  private:
    typedef std::vector<std::vector<std::uint32_t> > Neighbors;

    template <std::size_t N>
    Neighbors find_neighbors(const std::vector<std::array<std::size_t, N> >& groups) const
    {
      Neighbors neighbors(m_numbers.size());
      for(const auto& group : groups)
        for(const std::size_t u : group)
          for(const std::size_t v : group)
            if(u != v)
              neighbors[position(u)].push_back(static_cast<std::uint32_t>(position(v)));
      for(auto& n : neighbors)
      {
        std::sort(n.begin(), n.end());
        n.erase(std::unique(n.begin(), n.end()), n.end());
      }
      return neighbors;
    }

    // In the order of a breadth-first search.
    void form_component(const std::uint32_t first, const Neighbors& neighbors)
    {
      std::vector<std::uint32_t> component(1, first);
      m_components[first] = first;
      for(std::size_t k = 0; k < component.size(); ++k)
        for(const std::uint32_t v : neighbors[component[k]])
          if(m_components[v] == none && component.size() < m_max_number_of_vertices)
          {
            m_components[v] = first;
            component.push_back(v);
          }
    }

    std::size_t position(const std::size_t number) const
    {
      return static_cast<std::size_t>(std::lower_bound(m_numbers.begin(), m_numbers.end(), number)
                                      - m_numbers.begin());
    }

    const std::size_t m_max_number_of_vertices;
    std::vector<std::size_t> m_numbers; // in ascending order
    std::vector<std::uint32_t> m_components;
  };

  // What a part has of a zone.
  struct Piece
  {
    bool operator<(const Piece& other) const
    {
      return std::tie(part, first_cell) < std::tie(other.part, other.first_cell);
    }

    std::uint32_t part;
    std::uint32_t zone;
    std::size_t   first_cell;
    std::size_t   number_of_cells;
  };

  struct Zone_of_vertex
  {
    std::uint32_t vertex; // its index in the list of shared ones
    std::uint32_t zone;
  };

  template <typename Work>
  void for_each_part(const Work& work)
  {
    std::vector<std::size_t> weights;
    for(const Part& part : m_parts)
      weights.push_back(part.tetrahedra.size());
    internal::for_each_task(weights, work, Parallel_if_available_tag());
  }

  void start_at_vertices_of(const std::size_t number)
  {
    for(Part& part : m_parts)
      for(const auto& v : part.shared)
        if(m_shared.number_of_parts(v.index) == number)
          part.zone_of_vertex[v.position] = m_shared.set(v.index);
  }

  void start_at_connected_vertices(const std::size_t max_number_of_vertices)
  {
    std::vector<std::array<std::size_t, 2> > edges;
    for(const Part& part : m_parts)
      add_edges_of_starts(part, edges);
    m_exchange.gather(edges);
    const Components components(edges, max_number_of_vertices);
    for(Part& part : m_parts)
      for(const auto& v : part.shared)
        part.zone_of_vertex[v.position] = components.find(v.index);
  }

  void add_edges_of_starts(const Part& part, std::vector<std::array<std::size_t, 2> >& edges) const
  {
    std::vector<std::uint32_t> indices(part.zone_of_vertex.size(), none);
    for(const auto& v : part.shared)
      if(m_shared.number_of_parts(v.index) >= last_round)
      {
        indices[v.position] = v.index;
        edges.push_back({{ v.index, v.index }});
      }
    for(const auto& t : part.tetrahedra)
      for(std::size_t i = 1; i < 4; ++i)
        for(std::size_t j = 0; j < i; ++j)
          if(indices[t[i]] != none && indices[t[j]] != none)
            edges.push_back({{ indices[t[i]], indices[t[j]] }});
  }

  // Adds layers of cells around the vertices that have a zone, and returns the list of zones, in the order of their
  // first cells. Cells at vertices of more than `blocked` parts get no zone.
  std::vector<Zone> grow_zones(const std::size_t blocked)
  {
    for(Part& part : m_parts)
      for(auto& v : part.shared)
      {
        if(m_shared.number_of_parts(v.index) > blocked)
          part.zone_of_vertex[v.position] = Part::blocked;
        v.is_open = part.zone_of_vertex[v.position] == none;
      }
    for(int layer = 0; layer < m_number_of_layers; ++layer)
      add_layer();
    return list_zones();
  }

  // Adds the cells at the vertices of each zone to the zone, then the vertices of these cells. A cell or vertex that
  // several zones could get goes to the zone with the smallest number.
  void add_layer()
  {
    std::vector<std::vector<Zone_of_vertex> > found(m_parts.size());
    for_each_part([&](const std::size_t p) { add_layer(m_parts[p], found[p]); });
    std::vector<Zone_of_vertex> zones;
    for(const auto& z : found)
      zones.insert(zones.end(), z.begin(), z.end());
    m_exchange.gather(zones);
    std::vector<std::uint32_t> zone_of_shared(m_shared.size(), none);
    for(const Zone_of_vertex& z : zones)
      zone_of_shared[z.vertex] = (std::min)(zone_of_shared[z.vertex], z.zone);
    for(Part& part : m_parts)
      for(auto& v : part.shared)
        if(zone_of_shared[v.index] != none)
        {
          part.zone_of_vertex[v.position] = zone_of_shared[v.index];
          v.is_open = false;
        }
  }

  static void add_layer(Part& part, std::vector<Zone_of_vertex>& found)
  {
    std::vector<std::pair<std::uint32_t, std::uint32_t> > new_vertices;
    for(std::size_t k = 0; k < part.tetrahedra.size(); ++k)
    {
      if(part.zone_of_cell[k] != none)
        continue;
      part.zone_of_cell[k] = zone_at(part, part.tetrahedra[k]);
      if(part.zone_of_cell[k] == none)
        continue;
      for(const std::uint32_t v : part.tetrahedra[k])
        if(part.zone_of_vertex[v] == none)
          new_vertices.emplace_back(v, part.zone_of_cell[k]);
    }
    for(const auto& [v, zone] : new_vertices)
      part.zone_of_vertex[v] = (std::min)(part.zone_of_vertex[v], zone);
    for(const auto& v : part.shared)
      if(v.is_open && part.zone_of_vertex[v.position] != none)
        found.push_back({ v.index, part.zone_of_vertex[v.position] });
  }

  static std::uint32_t zone_at(const Part& part, const std::array<std::uint32_t, 4>& vertices)
  {
    std::uint32_t zone = none;
    for(const std::uint32_t v : vertices)
    {
      if(part.zone_of_vertex[v] == Part::blocked)
        return none;
      zone = (std::min)(zone, part.zone_of_vertex[v]);
    }
    return zone;
  }

  std::vector<Zone> list_zones()
  {
    std::vector<Piece> pieces;
    for(const Part& part : m_parts)
      add_pieces(part, pieces);
    m_exchange.gather(pieces);
    std::sort(pieces.begin(), pieces.end());
    std::vector<Zone> result;
    std::map<std::uint32_t, std::uint32_t> positions;
    for(const Piece& piece : pieces)
    {
      const auto [it, is_new] = positions.try_emplace(piece.zone, static_cast<std::uint32_t>(result.size()));
      if(is_new)
        result.push_back(Zone{ { }, 0, none });
      result[it->second].parts.push_back(piece.part);
      result[it->second].number_of_cells += piece.number_of_cells;
    }
    for_each_part([&](const std::size_t p)
    {
      for(std::uint32_t& zone : m_parts[p].zone_of_cell)
        if(zone != none)
          zone = positions.find(zone)->second;
    });
    find_owners(result);
    return result;
  }

  void find_owners(std::vector<Zone>& zones) const
  {
    std::vector<std::array<std::size_t, 2> > parts; // with the numbers of cells that are left of them
    for(const Part& part : m_parts)
      parts.push_back({{ part.index, static_cast<std::size_t>(std::count(part.zone_of_cell.begin(),
                                                                         part.zone_of_cell.end(), none)) }});
    m_exchange.gather(parts);
    std::map<std::uint32_t, std::size_t> numbers_of_cells;
    for(const auto& [part, number] : parts)
      numbers_of_cells[static_cast<std::uint32_t>(part)] = number;
    std::vector<std::size_t> order(zones.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](const std::size_t x, const std::size_t y)
                     { return zones[x].number_of_cells > zones[y].number_of_cells; });
    for(const std::size_t z : order)
    {
      const auto& candidates = zones[z].parts;
      zones[z].owner = *std::min_element(candidates.begin(), candidates.end(),
                                         [&](const std::uint32_t p, const std::uint32_t q)
                                         { return numbers_of_cells[p] < numbers_of_cells[q]; });
      numbers_of_cells[zones[z].owner] += zones[z].number_of_cells;
    }
  }

  static void add_pieces(const Part& part, std::vector<Piece>& pieces)
  {
    std::map<std::uint32_t, Piece> piece_of_zone;
    for(std::size_t k = 0; k < part.zone_of_cell.size(); ++k)
      if(part.zone_of_cell[k] != none)
        ++piece_of_zone.try_emplace(part.zone_of_cell[k], Piece{ part.index, part.zone_of_cell[k], k, 0 })
            .first->second.number_of_cells;
    for(const auto& [zone, piece] : piece_of_zone)
      pieces.push_back(piece);
  }

  std::vector<Part>& m_parts; // of this process
  const int m_number_of_layers;
  const Exchange& m_exchange;
  Shared_vertices_3 m_shared;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SEAMS_3_H
