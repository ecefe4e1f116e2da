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
 * Where parts of a mesh meet, zones of cells are taken out of them, to be worked on at the same time, since no cell is in
 * two of them. In three rounds, no seam is left:
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

  static constexpr std::size_t first_round = 2;
  static constexpr std::size_t last_round = 4;

  struct Zone
  {
    std::size_t part;
    Part cells;
  };

  Seams_3(Mesh& mesh, const int number_of_layers) : m_mesh(mesh), m_number_of_layers(number_of_layers) { }

  std::vector<Zone> take_out(const std::size_t round)
  {
    find_parts_of_vertices();
    m_zone_of_vertex.assign(m_mesh.vertices.size(), none);
    if(round < last_round)
      start_at_vertices_of(round);
    else
      start_at_crowded_vertices();
    const std::size_t blocked = round < last_round ? round : std::size_t(-1);
    m_zone_of_cell.clear();
    for(const Part& part : m_mesh.parts)
      m_zone_of_cell.emplace_back(part.size(), none);
    for(int layer = 0; layer < m_number_of_layers; ++layer)
      add_layer(blocked);
    return zones();
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

  void start_at_crowded_vertices()
  {
    const std::size_t n = m_mesh.vertices.size();
    boost::disjoint_sets_with_storage<> components(n);
    for(const Part& part : m_mesh.parts)
      for(const auto& c : part)
        for(int i = 1; i < 4; ++i)
          for(int j = 0; j < i; ++j)
            if(is_crowded(c.vertices[i]) && is_crowded(c.vertices[j]))
              components.union_set(c.vertices[i], c.vertices[j]);
    for(std::size_t v = 0; v < n; ++v)
      if(is_crowded(v))
        m_zone_of_vertex[v] = static_cast<std::uint32_t>(components.find_set(v));
  }

  bool is_crowded(const std::size_t v) const { return number_of_parts(v) >= last_round; }

  // The cells at the vertices of a zone come to it, then their vertices; the zone with the smallest number is first.
  // Cells at vertices of more than `blocked` parts stay.
  void add_layer(const std::size_t blocked)
  {
    for(std::size_t p = 0; p < m_mesh.parts.size(); ++p)
      for(std::size_t k = 0; k < m_mesh.parts[p].size(); ++k)
        if(m_zone_of_cell[p][k] == none)
          m_zone_of_cell[p][k] = zone_at(m_mesh.parts[p][k].vertices, blocked);
    std::vector<std::uint32_t> zone_of_vertex = m_zone_of_vertex;
    for(std::size_t p = 0; p < m_mesh.parts.size(); ++p)
      for(std::size_t k = 0; k < m_mesh.parts[p].size(); ++k)
        for(const std::size_t v : m_mesh.parts[p][k].vertices)
          if(m_zone_of_vertex[v] == none)
            zone_of_vertex[v] = (std::min)(zone_of_vertex[v], m_zone_of_cell[p][k]);
    m_zone_of_vertex.swap(zone_of_vertex);
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

  // In the order of their first cells.
  std::vector<Zone> zones()
  {
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
