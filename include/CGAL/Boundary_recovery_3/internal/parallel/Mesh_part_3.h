// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_PART_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_PART_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Some cells of a mesh that is divided into parts, as arrays. There are no handles in it, and it has all that it needs,
 * so parts can be worked on at the same time, or elsewhere. What parts have in common are the numbers of vertices.
 */
template <typename Tr>
struct Mesh_part_3
{
  typedef std::array<std::uint32_t, 4> Tetrahedron; // positions of vertices
  typedef std::array<std::uint32_t, 2> Edge;
  typedef internal::Cell_indices<typename Tr::Cell> Cell_indices;

  struct Vertex
  {
    Vertex(const std::size_t number, const typename Tr::Vertex& v)
      : number(number), point(v.point()), indices(v), size(v.meshing_info())
    { }

    void give_to(typename Tr::Vertex& v) const
    {
      v.set_point(point);
      indices.give_to(v);
      v.set_meshing_info(size);
    }

    std::size_t                         number; // in the whole mesh
    typename Tr::Point                  point;
    Vertex_indices<typename Tr::Vertex> indices;
    typename Tr::Geom_traits::FT        size; // of cells there; 0: not known
    bool                                may_be_shared = false; // by other parts
  };

  std::size_t number_of_cells() const { return tetrahedra.size(); }

  const Vertex& vertex(const std::size_t cell, const std::size_t i) const { return vertices[tetrahedra[cell][i]]; }

  std::array<Coordinates_3, 4> corners(const std::size_t cell) const
  {
    const auto corner = [&](const std::size_t i) { return internal::coordinates_of(vertex(cell, i).point); };
    return {{ corner(0), corner(1), corner(2), corner(3) }};
  }

  std::vector<Vertex>       vertices;
  std::vector<Tetrahedron>  tetrahedra;
  std::vector<Cell_indices> cell_indices;
  std::vector<Edge>         constrained_edges; // edges of its cells, some maybe more than once
};

template <typename PartRange>
std::size_t number_of_cells(const PartRange& parts)
{
  std::size_t sum = 0;
  for(const auto& part : parts)
    sum += part.number_of_cells();
  return sum;
}

/*
 * Takes groups of cells out of a part of a mesh, each of which is a part then. Vertices of more than one of them are
 * marked in each. The order of the cells stays.
 */
template <typename Tr>
class Split_part_3
{
public:
  typedef Mesh_part_3<Tr> Part;

  static constexpr std::uint32_t none = std::uint32_t(-1);

  // A group and its number.
  typedef std::pair<std::uint32_t, Part> Group;

  // Cells that are in the group `none` stay. The others are returned in ascending order of their groups.
  std::vector<Group> operator()(Part& part, const std::vector<std::uint32_t>& groups_of_cells)
  {
    std::map<std::uint32_t, std::vector<std::size_t> > cells;
    for(std::size_t k = 0; k < groups_of_cells.size(); ++k)
      cells[groups_of_cells[k]].push_back(k);
    mark_shared_vertices(part, groups_of_cells);
    m_position.assign(part.vertices.size(), none);
    std::vector<Group> groups;
    for(const auto& [group, cells_of_group] : cells)
      groups.emplace_back(group, extract(part, cells_of_group));
    part = Part();
    if(! groups.empty() && groups.back().first == none)
    {
      part = std::move(groups.back().second);
      groups.pop_back();
    }
    return groups;
  }

private:
  void mark_shared_vertices(Part& part, const std::vector<std::uint32_t>& groups_of_cells) const
  {
    std::vector<char> is_seen(part.vertices.size(), false);
    std::vector<std::uint32_t> groups(part.vertices.size());
    for(std::size_t k = 0; k < groups_of_cells.size(); ++k)
      for(const std::uint32_t v : part.tetrahedra[k])
      {
        if(is_seen[v] && groups[v] != groups_of_cells[k])
          part.vertices[v].may_be_shared = true;
        is_seen[v] = true;
        groups[v] = groups_of_cells[k];
      }
  }

  Part extract(const Part& part, const std::vector<std::size_t>& cells)
  {
    Part group;
    std::vector<std::uint32_t> vertices;
    group.tetrahedra.reserve(cells.size());
    group.cell_indices.reserve(cells.size());
    for(const std::size_t k : cells)
    {
      auto t = part.tetrahedra[k];
      for(std::uint32_t& v : t)
      {
        if(m_position[v] == none)
        {
          m_position[v] = static_cast<std::uint32_t>(vertices.size());
          vertices.push_back(v);
        }
        v = m_position[v];
      }
      group.tetrahedra.push_back(t);
      group.cell_indices.push_back(part.cell_indices[k]);
    }
    add_constrained_edges(part, group);
    group.vertices.reserve(vertices.size());
    for(const std::uint32_t v : vertices)
    {
      group.vertices.push_back(part.vertices[v]);
      m_position[v] = none;
    }
    return group;
  }

  // Those of which a cell of the group has both vertices.
  void add_constrained_edges(const Part& part, Part& group) const
  {
    if(part.constrained_edges.empty())
      return;
    Simplex_index_3<std::size_t, 2> edges;
    for(const auto& e : part.constrained_edges)
      if(m_position[e[0]] != none && m_position[e[1]] != none)
        edges.insert({{ m_position[e[0]], m_position[e[1]] }});
    std::vector<char> is_in_group(edges.size(), false);
    for(const auto& t : group.tetrahedra)
      for(std::size_t i = 0; i < 4; ++i)
        for(std::size_t j = 0; j < i; ++j)
        {
          const std::size_t e = edges[{{ t[i], t[j] }}];
          if(e != edges.none)
            is_in_group[e] = true;
        }
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(is_in_group[e])
        group.constrained_edges.push_back({{ static_cast<std::uint32_t>(edges.keys()[e][0]),
                                             static_cast<std::uint32_t>(edges.keys()[e][1]) }});
  }

  std::vector<std::uint32_t> m_position; // in the group, by vertex of the part
};

/*
 * Makes one part of a mesh of several ones: the cells one after the other, each vertex once.
 */
template <typename Tr>
class Join_parts_3
{
public:
  typedef Mesh_part_3<Tr> Part;

  // Vertices with numbers from `first_new_number` on get numbers that are larger by `shift`.
  void add(Part&& part, const std::size_t first_new_number = 0, const std::size_t shift = 0)
  {
    for(auto& v : part.vertices)
      if(v.number >= first_new_number)
        v.number += shift;
    if(m_joined.number_of_cells() == 0)
    {
      m_joined = std::move(part);
      for(std::size_t v = 0; v < m_joined.vertices.size(); ++v)
        remember(m_joined.vertices[v], v);
    }
    else
      append(part);
  }

  Part joined() { return std::move(m_joined); }

private:
  // Only vertices that are marked can come again.
  void remember(const typename Part::Vertex& v, const std::size_t position)
  {
    if(! v.may_be_shared)
      return;
    m_shared.insert({{ v.number }});
    m_positions.push_back(static_cast<std::uint32_t>(position));
  }

  void append(const Part& part)
  {
    std::vector<std::uint32_t> positions;
    for(const auto& v : part.vertices)
    {
      const std::size_t k = v.may_be_shared ? m_shared[{{ v.number }}] : m_shared.none;
      positions.push_back(k != m_shared.none ? m_positions[k] : static_cast<std::uint32_t>(m_joined.vertices.size()));
      if(k == m_shared.none)
      {
        remember(v, m_joined.vertices.size());
        m_joined.vertices.push_back(v);
      }
    }
    for(const auto& t : part.tetrahedra)
      m_joined.tetrahedra.push_back({{ positions[t[0]], positions[t[1]], positions[t[2]], positions[t[3]] }});
    m_joined.cell_indices.insert(m_joined.cell_indices.end(), part.cell_indices.begin(), part.cell_indices.end());
    for(const auto& e : part.constrained_edges)
      m_joined.constrained_edges.push_back({{ positions[e[0]], positions[e[1]] }});
  }

  Part m_joined;
  Simplex_index_3<std::size_t, 1> m_shared; // numbers of vertices
  std::vector<std::uint32_t> m_positions;   // of these
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_PART_3_H
