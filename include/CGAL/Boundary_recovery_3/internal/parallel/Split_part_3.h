// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SPLIT_PART_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SPLIT_PART_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SPLIT_PART_3_H
