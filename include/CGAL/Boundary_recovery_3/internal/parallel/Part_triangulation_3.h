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

#include <CGAL/Boundary_recovery_3/internal/holes/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Divided_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * A triangulation of some cells of a divided mesh, for one thread. What bounds the cells is a wall there, and its
 * vertices stay; those that no wall has, and that are on no constraint, are free.
 *
 * The cells may be any ones. Beyond each wall is an infinite cell; two of these are neighbors if the cells between their
 * walls turn around the same edge. So that the cells around a vertex are always connected by facets, there is a copy of
 * the vertex for each set of cells that are. It is no triangulation of a convex hull, but whoever stays inside does not
 * notice.
 */
template <typename Tr>
class Part_triangulation_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef Divided_mesh_3<Tr>           Mesh;
  typedef typename Mesh::Part          Part;
  typedef std::array<Vertex_handle, 2> Edge;

  Part_triangulation_3(const Mesh& mesh, const Part& part) : m_mesh(mesh)
  {
    m_tr.tds().clear();
    m_tr.tds().set_dimension(3);
    m_tr.set_infinite_vertex(m_tr.tds().create_vertex());
    create_finite_cells(part);
    find_constrained_edges(part);
    create_infinite_cells();
    find_free_vertices();
  }

  Tr& triangulation() { return m_tr; }

  // The constrained edges of the mesh that are edges here.
  const std::vector<Edge>& constrained_edges() const { return m_constrained_edges; }

  // What the cells have become.
  Changed_part_3<Tr> change() const
  {
    Changed_part_3<Tr> change;
    Unique_hash_map<Vertex_handle, std::size_t> numbers; // for looking up only
    for(const auto& [v, number] : m_fixed_vertices)
      numbers[v] = number;
    const auto number_of = [&](const Vertex_handle v)
    {
      if(! numbers.is_defined(v))
      {
        const std::size_t k = change.vertices.size();
        numbers[v] = k < m_free_numbers.size() ? m_free_numbers[k]
                                               : m_mesh.vertices.size() + change.number_of_new_numbers++;
        change.vertices.emplace_back(numbers[v], typename Mesh::Vertex(*v));
      }
      return numbers[v];
    };
    for(const Cell_handle c : m_tr.finite_cell_handles())
      change.cells.push_back({ {{ number_of(c->vertex(0)), number_of(c->vertex(1)), number_of(c->vertex(2)),
                                  number_of(c->vertex(3)) }}, Cell_indices<typename Tr::Cell>(*c) });
    return change;
  }

private:
  typedef std::array<std::size_t, 4> Tetrahedron;

  static constexpr std::size_t none = std::size_t(-1);

  void create_finite_cells(const Part& part)
  {
    std::vector<Tetrahedron> tetrahedra;
    tetrahedra.reserve(part.size());
    Simplex_index_3<std::size_t, 1> numbers;
    for(const auto& c : part)
    {
      Tetrahedron t;
      for(int i = 0; i < 4; ++i)
        t[i] = numbers.insert({{ c.vertices[i] }}).first;
      tetrahedra.push_back(t);
    }
    const Tetrahedra_incidences_3 incidences(numbers.size(), tetrahedra);
    const std::vector<std::size_t> copies = create_vertices(part, tetrahedra, incidences);
    m_cells.reserve(part.size());
    for(std::size_t c = 0; c < part.size(); ++c)
    {
      const auto v = [&](const std::size_t i) { return m_vertices[copies[4 * c + i]].first; };
      m_cells.push_back(m_tr.tds().create_cell(v(0), v(1), v(2), v(3)));
      part[c].indices.give_to(*m_cells.back());
      for(std::size_t i = 0; i < 4; ++i)
        v(i)->set_cell(m_cells.back());
    }
    for(std::size_t side = 0; side < 4 * part.size(); ++side)
      if(incidences.opposite(side) != none)
        m_cells[side / 4]->set_neighbor(static_cast<int>(side % 4), m_cells[incidences.opposite(side) / 4]);
  }

  // Creates copies of the vertices. Returns which of them each corner of the tetrahedra has.
  std::vector<std::size_t> create_vertices(const Part& part, const std::vector<Tetrahedron>& tetrahedra,
                                           const Tetrahedra_incidences_3& incidences)
  {
    std::vector<std::size_t> copies(4 * tetrahedra.size(), none), stack;
    for(std::size_t first = 0; first < copies.size(); ++first)
    {
      if(copies[first] != none)
        continue;
      const std::size_t v = tetrahedra[first / 4][first % 4], copy = create_vertex(part[first / 4].vertices[first % 4]);
      copies[first] = copy;
      stack.assign(1, first);
      while(! stack.empty())
      {
        const std::size_t corner = stack.back();
        stack.pop_back();
        for(std::size_t i = 0; i < 4; ++i)
        {
          const std::size_t opposite = i == corner % 4 ? none : incidences.opposite(corner / 4 * 4 + i);
          if(opposite == none)
            continue;
          const Tetrahedron& t = tetrahedra[opposite / 4];
          const std::size_t next = opposite / 4 * 4 + static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin());
          if(copies[next] == none)
          {
            copies[next] = copy;
            stack.push_back(next);
          }
        }
      }
    }
    return copies;
  }

  std::size_t create_vertex(const std::size_t number)
  {
    const Vertex_handle v = m_tr.tds().create_vertex();
    m_mesh.vertices[number].give_to(*v);
    m_vertices.emplace_back(v, number);
    return m_vertices.size() - 1;
  }

  void find_constrained_edges(const Part& part)
  {
    Simplex_index_3<std::size_t, 2> edges;
    for(const auto& e : m_mesh.constrained_edges)
      edges.insert(e);
    if(edges.size() == 0)
      return;
    for(std::size_t c = 0; c < part.size(); ++c)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
          if(edges[{{ part[c].vertices[i], part[c].vertices[j] }}] != none)
            m_constrained_edges.push_back({{ m_cells[c]->vertex(i), m_cells[c]->vertex(j) }});
  }

  void create_infinite_cells()
  {
    const Vertex_handle infinite = m_tr.infinite_vertex();
    std::vector<std::pair<Cell_handle, int> > walls;
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        if(c->neighbor(i) == Cell_handle())
        {
          const auto f = internal::facet_vertices(c, i);
          const Cell_handle beyond = m_tr.tds().create_cell(f[1], f[0], f[2], infinite);
          m_tr.tds().set_adjacency(c, i, beyond, 3);
          infinite->set_cell(beyond);
          walls.emplace_back(c, i);
        }
    m_cells.clear();
    for(const auto& [c, i] : walls)
      for(int j = 0; j < 4; ++j)
        if(j != i)
        {
          const Cell_handle beyond = c->neighbor(i);
          beyond->set_neighbor(beyond->index(c->vertex(j)), beyond_next_wall(c, i, j));
        }
  }

  // The infinite cell that is met first on a turn around the edge of c that is opposite to its edge from vertex i to
  // vertex j, away from the facet i.
  Cell_handle beyond_next_wall(Cell_handle c, const int i, const int j) const
  {
    Vertex_handle apex = c->vertex(i);
    int exit = j;
    while(! m_tr.is_infinite(c->neighbor(exit)))
    {
      const Cell_handle next = c->neighbor(exit);
      exit = next->index(apex);
      apex = next->vertex(next->index(c));
      c = next;
    }
    return c->neighbor(exit);
  }

  void find_free_vertices()
  {
    Unique_hash_map<Vertex_handle, bool> is_at_wall(false); // for looking up only
    for(auto c = m_tr.tds().cells_begin(); c != m_tr.tds().cells_end(); ++c)
      if(m_tr.is_infinite(c))
        for(int i = 0; i < 4; ++i)
          is_at_wall[c->vertex(i)] = true;
    for(const auto& [v, number] : m_vertices)
      if(is_at_wall[v] || v->in_dimension() != 3)
        m_fixed_vertices.emplace_back(v, number);
      else
        m_free_numbers.push_back(number);
    m_vertices.clear();
  }

  const Mesh& m_mesh;
  Tr m_tr;
  std::vector<std::pair<Vertex_handle, std::size_t> > m_vertices; // with their numbers
  std::vector<std::pair<Vertex_handle, std::size_t> > m_fixed_vertices;
  std::vector<std::size_t> m_free_numbers;
  std::vector<Cell_handle> m_cells; // finite ones, while the triangulation is made
  std::vector<Edge> m_constrained_edges;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PART_TRIANGULATION_3_H
