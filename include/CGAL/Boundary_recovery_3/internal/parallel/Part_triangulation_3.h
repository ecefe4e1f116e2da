// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PART_TRIANGULATION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PART_TRIANGULATION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Constrained_edge_map_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Puts an infinite cell beyond each facet of these cells that has no neighbor yet; the cells are all that there are of
 * a triangulation. Two infinite cells are neighbors if the cells between their facets turn around the same edge.
 */
template <typename Tr>
void create_infinite_cells(Tr& tr, const std::vector<typename Tr::Cell_handle>& cells)
{
  typedef typename Tr::Cell_handle Cell_handle;
  const auto infinite = tr.infinite_vertex();
  std::vector<std::pair<Cell_handle, int> > walls;
  for(const Cell_handle c : cells)
    for(int i = 0; i < 4; ++i)
      if(c->neighbor(i) == Cell_handle())
      {
        const auto f = internal::facet_vertices(c, i);
        const Cell_handle beyond = tr.tds().create_cell(f[1], f[0], f[2], infinite);
        tr.tds().set_adjacency(c, i, beyond, 3);
        beyond->set_surface_patch_index(3, c->surface_patch_index(i)); // new cells take it from the other side
        infinite->set_cell(beyond);
        walls.emplace_back(c, i);
      }
  // the one that is met first on a turn around the edge of c opposite to its edge from i to j, away from the facet i
  const auto beyond_next_wall = [&tr](const Cell_handle c, const int i, const int j)
  {
    Edge_walk_3<Tr> walk(c, j, i);
    while(! tr.is_infinite(walk.cell()->neighbor(walk.next_facet())))
      ++walk;
    return walk.cell()->neighbor(walk.next_facet());
  };
  for(const auto& [c, i] : walls)
    for(int j = 0; j < 4; ++j)
      if(j != i)
      {
        const Cell_handle beyond = c->neighbor(i);
        beyond->set_neighbor(beyond->index(c->vertex(j)), beyond_next_wall(c, i, j));
      }
}

/*
 * A triangulation of a part of a mesh, for one thread. What bounds the cells is a wall there, and its vertices stay;
 * those that no wall has, and that are on no constraint, are free.
 *
 * The cells may be any ones. Beyond each wall is an infinite cell. So that the cells around a vertex are always
 * connected by facets, there is a copy of the vertex for each set of cells that are. It is no triangulation of a convex
 * hull, but whoever stays inside does not notice.
 */
template <typename Tr>
class Part_triangulation_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef Mesh_part_3<Tr>              Part;
  typedef std::array<Vertex_handle, 2> Edge;

  explicit Part_triangulation_3(Part&& part)
    : m_old_vertices(std::move(part.vertices)), m_old_constrained_edges(std::move(part.constrained_edges))
  {
    m_tr.tds().clear();
    m_tr.tds().set_dimension(3);
    m_tr.set_infinite_vertex(m_tr.tds().create_vertex());
    create_finite_cells(part);
    find_constrained_edges(part);
    internal::create_infinite_cells(m_tr, m_cells);
    m_cells.clear();
    find_free_vertices();
  }

  Tr& triangulation() { return m_tr; }

  const std::vector<Edge>& constrained_edges() const { return m_constrained_edges; }

  // What the part has become. Vertices that were there have the numbers that they had; new ones have those of vertices
  // that are gone, and then numbers from `first_new_number` on.
  Part part(std::size_t first_new_number) const
  {
    Part part;
    part.tetrahedra.reserve(m_tr.tds().number_of_cells());
    part.cell_indices.reserve(m_tr.tds().number_of_cells());
    Unique_hash_map<Vertex_handle, std::uint32_t> positions(none, m_tr.number_of_vertices()); // for looking up only
    add_fixed_vertices(part, positions);
    auto number = m_free_numbers.begin();
    for(const Cell_handle c : m_tr.finite_cell_handles())
    {
      typename Part::Tetrahedron t;
      for(int i = 0; i < 4; ++i)
      {
        std::uint32_t& position = positions[c->vertex(i)];
        if(position == none)
        {
          position = static_cast<std::uint32_t>(part.vertices.size());
          part.vertices.emplace_back(number == m_free_numbers.end() ? first_new_number++ : *number++, *c->vertex(i));
        }
        t[static_cast<std::size_t>(i)] = position;
      }
      part.tetrahedra.push_back(t);
      part.cell_indices.emplace_back(*c);
    }
    return part;
  }

private:
  typedef std::array<std::size_t, 4> Tetrahedron;

  static constexpr std::uint32_t none = std::uint32_t(-1);

  void create_finite_cells(const Part& part)
  {
    std::vector<Tetrahedron> tetrahedra;
    tetrahedra.reserve(part.number_of_cells());
    for(const auto& t : part.tetrahedra)
      tetrahedra.push_back({{ t[0], t[1], t[2], t[3] }});
    const Tetrahedra_incidences_3 incidences(m_old_vertices.size(), tetrahedra);
    const std::vector<std::size_t> copies = create_vertices(tetrahedra, incidences);
    m_cells.reserve(tetrahedra.size());
    for(std::size_t c = 0; c < tetrahedra.size(); ++c)
    {
      const auto v = [&](const std::size_t i) { return m_vertices[copies[4 * c + i]].first; };
      m_cells.push_back(m_tr.tds().create_cell(v(0), v(1), v(2), v(3)));
      part.cell_indices[c].give_to(*m_cells.back());
      for(std::size_t i = 0; i < 4; ++i)
        v(i)->set_cell(m_cells.back());
    }
    for(std::size_t side = 0; side < 4 * tetrahedra.size(); ++side)
      if(incidences.opposite(side) != incidences.none)
        m_cells[side / 4]->set_neighbor(static_cast<int>(side % 4), m_cells[incidences.opposite(side) / 4]);
  }

  // Creates copies of the vertices. Returns which of them each corner of the tetrahedra has.
  std::vector<std::size_t> create_vertices(const std::vector<Tetrahedron>& tetrahedra,
                                           const Tetrahedra_incidences_3& incidences)
  {
    constexpr std::size_t no_copy = std::size_t(-1);
    std::vector<std::size_t> copies(4 * tetrahedra.size(), no_copy), stack;
    for(std::size_t first = 0; first < copies.size(); ++first)
    {
      if(copies[first] != no_copy)
        continue;
      const std::size_t v = tetrahedra[first / 4][first % 4], copy = create_vertex(v);
      copies[first] = copy;
      stack.assign(1, first);
      while(! stack.empty())
      {
        const std::size_t corner = stack.back();
        stack.pop_back();
        for(std::size_t i = 0; i < 4; ++i)
        {
          const std::size_t opposite = i == corner % 4 ? incidences.none : incidences.opposite(corner / 4 * 4 + i);
          if(opposite == incidences.none)
            continue;
          const Tetrahedron& t = tetrahedra[opposite / 4];
          const std::size_t next = opposite / 4 * 4
                                 + static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin());
          if(copies[next] == no_copy)
          {
            copies[next] = copy;
            stack.push_back(next);
          }
        }
      }
    }
    return copies;
  }

  std::size_t create_vertex(const std::size_t position)
  {
    const Vertex_handle v = m_tr.tds().create_vertex();
    m_old_vertices[position].give_to(*v);
    m_vertices.emplace_back(v, static_cast<std::uint32_t>(position));
    return m_vertices.size() - 1;
  }

  void find_constrained_edges(const Part& part)
  {
    if(m_old_constrained_edges.empty())
      return;
    Simplex_index_3<std::size_t, 2> edges;
    for(const auto& e : m_old_constrained_edges)
      edges.insert({{ e[0], e[1] }});
    for(std::size_t c = 0; c < part.number_of_cells(); ++c)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
        {
          const auto& t = part.tetrahedra[c];
          if(edges[{{ t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)] }}] != edges.none)
            m_constrained_edges.push_back({{ m_cells[c]->vertex(i), m_cells[c]->vertex(j) }});
        }
  }

  void find_free_vertices()
  {
    Unique_hash_map<Vertex_handle, bool> is_at_wall(false); // for looking up only
    for(auto c = m_tr.tds().cells_begin(); c != m_tr.tds().cells_end(); ++c)
      if(m_tr.is_infinite(c))
        for(int i = 0; i < 4; ++i)
          is_at_wall[c->vertex(i)] = true;
    for(const auto& [v, position] : m_vertices)
      if(is_at_wall[v] || v->in_dimension() != 3)
        m_fixed_vertices.emplace_back(v, position);
      else
        m_free_numbers.push_back(m_old_vertices[position].number);
    m_vertices.clear();
  }

  // They are as they were, and so are the constrained edges, which have no others.
  void add_fixed_vertices(Part& part, Unique_hash_map<Vertex_handle, std::uint32_t>& positions) const
  {
    std::vector<std::uint32_t> new_positions(m_old_vertices.size(), none);
    for(const auto& [v, old_position] : m_fixed_vertices)
    {
      std::uint32_t& position = new_positions[old_position];
      if(position == none)
      {
        position = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.push_back(m_old_vertices[old_position]);
      }
      positions[v] = position;
    }
    for(const auto& e : m_old_constrained_edges)
      part.constrained_edges.push_back({{ new_positions[e[0]], new_positions[e[1]] }});
  }

  const std::vector<typename Part::Vertex> m_old_vertices;
  const std::vector<typename Part::Edge> m_old_constrained_edges;
  Tr m_tr;
  std::vector<std::pair<Vertex_handle, std::uint32_t> > m_vertices;       // with their old positions
  std::vector<std::pair<Vertex_handle, std::uint32_t> > m_fixed_vertices;
  std::vector<std::size_t> m_free_numbers;
  std::vector<Cell_handle> m_cells; // finite ones, while the triangulation is made
  std::vector<Edge> m_constrained_edges;
};

// All cells of a triangulation that are in a region. Constrained edges are arrays of two vertex handles.
template <typename Tr, typename EdgeRange>
Selected_domain_3<Tr> domain_with_edges(const Tr& tr, const EdgeRange& constrained_edges)
{
  Selected_domain_3<Tr> domain(tr);
  if(! constrained_edges.empty())
    domain.constrain_edges(Constrained_edge_map_3<Tr>(constrained_edges));
  return domain;
}

// The same where the triangulation is one of a part of a mesh.
template <typename Tr, typename EdgeRange>
Selected_domain_3<Tr> domain_of_part(const Tr& tr, const EdgeRange& constrained_edges)
{
  Selected_domain_3<Tr> domain = internal::domain_with_edges(tr, constrained_edges);
  domain.set_has_seams();
  return domain;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PART_TRIANGULATION_3_H
