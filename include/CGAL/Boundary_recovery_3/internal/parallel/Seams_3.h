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

#include <CGAL/Boundary_recovery_3/internal/parallel/Divided_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/for_each_task.h>

#include <CGAL/tags.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Where parts of a mesh meet, zones of cells are taken out of them, to be worked on at the same time, since no cell is
 * in two of them. In three rounds, no seam is left:
 *  - around the vertices of two parts, for each two of them, without the cells at vertices of more parts;
 *  - the same for three;
 *  - around the vertices of four or more, as far as these are connected by edges.
 *
 * Each zone has some layers of cells, and belongs to the first of its parts thereafter, so the next seam is elsewhere.
 * Which cells are in a zone depends on numbers only.
 */
template <typename Tr>
class Seams_3
{
public:
  typedef Divided_mesh_3<Tr>  Mesh;
  typedef typename Mesh::Part Part;

  static constexpr std::size_t last_round = 4;

  struct Zone
  {
    std::size_t part;
    Part cells;
  };

  Seams_3(Mesh& mesh, const int number_of_layers) : m_mesh(mesh), m_number_of_layers(number_of_layers) { }

  // The round is the number of the parts that meet: from 2 to `last_round`, which is for more of them, too.
  std::vector<Zone> take_out(const std::size_t round)
  {
    find_parts_of_vertices();
    m_zone_of_vertex.assign(m_mesh.vertices.size(), none);
    if(round == last_round)
      start_at_connected_vertices([this](const std::size_t v) { return number_of_parts(v) >= last_round; });
    else
      start_at_vertices_of(round);
    return zones(round == last_round ? std::size_t(-1) : round);
  }

  // The zones around the cells that are to be repaired.
  template <typename IsToBeRepaired>
  std::vector<Zone> take_out_around(const IsToBeRepaired& is_to_be_repaired)
  {
    m_sets.assign(1, std::vector<std::uint32_t>());
    m_set_of_vertex.assign(m_mesh.vertices.size(), 0);
    m_zone_of_vertex.assign(m_mesh.vertices.size(), none);
    std::vector<char> is_marked(m_mesh.vertices.size(), false);
    for(const Part& part : m_mesh.parts)
      for(const auto& c : part)
        if(is_to_be_repaired(c))
          for(const std::size_t v : c.vertices)
            is_marked[v] = true;
    start_at_connected_vertices([&](const std::size_t v) { return is_marked[v] != 0; });
    return zones(0);
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  std::size_t number_of_parts(const std::size_t v) const { return m_sets[m_set_of_vertex[v]].size(); }

  // The parts that have a vertex are a set; sets have numbers.
  void find_parts_of_vertices()
  {
    m_sets.assign(1, std::vector<std::uint32_t>());
    m_set_of_vertex.assign(m_mesh.vertices.size(), 0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> larger; // by a set and the part that comes to it
    for(std::uint32_t p = 0; p < m_mesh.parts.size(); ++p)
      for(const auto& c : m_mesh.parts[p])
        for(const std::size_t v : c.vertices)
        {
          std::uint32_t& set = m_set_of_vertex[v];
          if(! m_sets[set].empty() && m_sets[set].back() == p)
            continue;
          const auto [it, is_new] = larger.try_emplace({ set, p }, static_cast<std::uint32_t>(m_sets.size()));
          if(is_new)
          {
            m_sets.push_back(m_sets[set]);
            m_sets.back().push_back(p);
          }
          set = it->second;
        }
  }

  void start_at_vertices_of(const std::size_t number)
  {
    for(std::size_t v = 0; v < m_mesh.vertices.size(); ++v)
      if(number_of_parts(v) == number)
        m_zone_of_vertex[v] = m_set_of_vertex[v];
  }

  template <typename IsStart>
  void start_at_connected_vertices(const IsStart& is_start)
  {
    boost::disjoint_sets_with_storage<> components(m_mesh.vertices.size());
    for(const Part& part : m_mesh.parts)
      for(const auto& c : part)
        for(int i = 1; i < 4; ++i)
          for(int j = 0; j < i; ++j)
            if(is_start(c.vertices[i]) && is_start(c.vertices[j]))
              components.union_set(c.vertices[i], c.vertices[j]);
    for(std::size_t v = 0; v < m_mesh.vertices.size(); ++v)
      if(is_start(v))
        m_zone_of_vertex[v] = static_cast<std::uint32_t>(components.find_set(v));
  }

  // The cells at the vertices of a zone come to it, then their vertices; the zone with the smallest number is first.
  // Cells at vertices of more than `blocked` parts stay.
  void add_layer(const std::size_t blocked)
  {
    std::vector<std::vector<std::size_t> > new_cells(m_mesh.parts.size());
    std::vector<std::size_t> weights;
    for(const Part& part : m_mesh.parts)
      weights.push_back(part.size());
    internal::for_each_task(weights, [&](const std::size_t p)
    {
      for(std::size_t k = 0; k < m_mesh.parts[p].size(); ++k)
        if(m_zone_of_cell[p][k] == none)
        {
          m_zone_of_cell[p][k] = zone_at(m_mesh.parts[p][k].vertices, blocked);
          if(m_zone_of_cell[p][k] != none)
            new_cells[p].push_back(k);
        }
    }, Parallel_if_available_tag());
    std::vector<std::pair<std::size_t, std::uint32_t> > new_vertices;
    for(std::size_t p = 0; p < new_cells.size(); ++p)
      for(const std::size_t k : new_cells[p])
        for(const std::size_t v : m_mesh.parts[p][k].vertices)
          if(m_zone_of_vertex[v] == none)
            new_vertices.emplace_back(v, m_zone_of_cell[p][k]);
    for(const auto& [v, zone] : new_vertices)
      m_zone_of_vertex[v] = (std::min)(m_zone_of_vertex[v], zone);
  }

  std::uint32_t zone_at(const std::array<std::size_t, 4>& vertices, const std::size_t blocked) const
  {
    std::uint32_t zone = none;
    for(const std::size_t v : vertices)
    {
      if(number_of_parts(v) > blocked)
        return none;
      zone = (std::min)(zone, m_zone_of_vertex[v]);
    }
    return zone;
  }

  // Of layers around the vertices that have one, in the order of their first cells.
  std::vector<Zone> zones(const std::size_t blocked)
  {
    m_zone_of_cell.clear();
    for(const Part& part : m_mesh.parts)
      m_zone_of_cell.emplace_back(part.size(), none);
    for(int layer = 0; layer < m_number_of_layers; ++layer)
      add_layer(blocked);
    std::vector<Zone> result;
    std::map<std::uint32_t, std::size_t> positions;
    for(std::size_t p = 0; p < m_mesh.parts.size(); ++p)
    {
      Part& part = m_mesh.parts[p];
      std::size_t number_left = 0;
      for(std::size_t k = 0; k < part.size(); ++k)
        if(m_zone_of_cell[p][k] == none)
          part[number_left++] = part[k];
        else
        {
          const auto [it, is_new] = positions.try_emplace(m_zone_of_cell[p][k], result.size());
          if(is_new)
            result.push_back(Zone{ p, Part() });
          result[it->second].cells.push_back(part[k]);
        }
      part.erase(part.begin() + static_cast<std::ptrdiff_t>(number_left), part.end());
    }
    return result;
  }

  Mesh& m_mesh;
  const int m_number_of_layers;
  std::vector<std::vector<std::uint32_t> > m_sets; // of parts, in their order
  std::vector<std::uint32_t> m_set_of_vertex;
  std::vector<std::uint32_t> m_zone_of_vertex;
  std::vector<std::vector<std::uint32_t> > m_zone_of_cell; // by part
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SEAMS_3_H
