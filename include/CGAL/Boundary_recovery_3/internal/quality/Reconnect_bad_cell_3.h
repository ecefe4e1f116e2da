// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_RECONNECT_BAD_CELL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_RECONNECT_BAD_CELL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Small polyhedron reconnection that makes the worst cell the best: a bad cell and those around it are exchanged for
 * the tetrahedralization of their union, without further vertices, whose worst cell is the best.
 *
 * It is a search with a bound: only cells better than the worst one now take part; if there is a tetrahedralization of
 * these, its worst cell is the next bound, until there is none.
 */
template <typename Mesh>
class Reconnect_bad_cell_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  explicit Reconnect_bad_cell_3(Mesh& mesh)
    : m_mesh(mesh), m_predicates(mesh.triangulation()), m_search(m_predicates, Better_than{ &mesh, 0 })
  { }

  // Searches around a cell. Returns whether the cells would be less bad then, and none worse than the worst one now.
  bool find(const Cell_handle c)
  {
    if(! collect_polyhedron(c))
      return false;
    auto account = m_mesh.account_of(m_cells);
    const double badness_before = account.badness;
    m_tetrahedra.clear();
    m_search.forget(); // vertices may have moved
    for(int turn = 0; turn < max_number_of_turns && account.worst < m_mesh.enough(); ++turn)
    {
      m_search.filter().bound = account.worst;
      const std::array<std::array<Vertex_handle, 2>, 0> no_edges = {};
      const std::array<std::array<Vertex_handle, 3>, 0> no_facets = {};
      if(m_search(m_cells, no_edges, no_facets, Vertex_handle(), bounds) != Search::FOUND)
        break;
      m_tetrahedra = m_search.tetrahedra();
      account = m_mesh.account_of(m_tetrahedra);
    }
    double gain = badness_before;
    for(const auto& t : m_tetrahedra)
      gain -= m_mesh.badness(m_mesh.quality(t));
    return ! m_tetrahedra.empty() && gain > 0 && has_all_vertices() && are_edges_in_size();
  }

  // Exchanges the cells, whose orientations are known to be positive.
  void apply() { m_new_cells = &m_mesh.replace(m_cells, m_tetrahedra); }

  const Cells& new_cells() const { return *m_new_cells; }

private:
  typedef typename Mesh::Triangulation Tr;
  typedef Vertex_predicates_3<Tr>      Predicates;

  struct Better_than
  {
    const Mesh* mesh;
    double bound;

    bool operator()(const Vertex_handle p, const Vertex_handle q, const Vertex_handle r, const Vertex_handle s) const
    {
      return mesh->quality(typename Mesh::Tetrahedron{{ p, q, r, s }}) > bound;
    }
  };

  typedef Small_polyhedron_reconnection_3<Tr, Better_than> Search;
  typedef typename Search::Tetrahedron                     Tetrahedron;

  // See "Tuning constants" in the manual.
  static constexpr int max_number_of_turns = 6;
  static constexpr std::size_t max_number_of_vertices = 12;
  static constexpr typename Search::Bounds bounds = { max_number_of_vertices, 0, 300 };

  // Takes cells in as long as there are not too many vertices; those without a further vertex first, then the worst.
  bool collect_polyhedron(const Cell_handle c)
  {
    m_cells.assign(1, c);
    m_vertices.clear();
    for(int i = 0; i < 4; ++i)
      m_vertices.push_back(c->vertex(i));
    for(Cell_handle next = next_cell(); next != Cell_handle(); next = next_cell())
      m_cells.push_back(next);
    return m_cells.size() > 2 && is_no_constraint_inside();
  }

  Cell_handle next_cell()
  {
    Cell_handle worst;
    double quality = 2;
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle n = c->neighbor(i);
        if(m_mesh.domain().is_wall(c, i) || internal::contains(m_cells, n))
          continue;
        if(internal::contains(m_vertices, n->vertex(n->index(c))))
          return n;
        const double q = m_mesh.quality(n);
        if(q < quality)
        {
          quality = q;
          worst = n;
        }
      }
    if(worst == Cell_handle() || m_vertices.size() >= max_number_of_vertices)
      return Cell_handle();
    for(int i = 0; i < 4; ++i)
      if(! internal::contains(m_vertices, worst->vertex(i)))
        m_vertices.push_back(worst->vertex(i));
    return worst;
  }

  // No wall, no constrained edge, and no vertex: Euler's formula tells how many vertices the boundary has, which is to
  // be a sphere.
  bool is_no_constraint_inside() const
  {
    std::size_t number_of_faces = 0;
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        if(! internal::contains(m_cells, c->neighbor(i)))
          ++number_of_faces;
        else if(m_mesh.domain().is_wall(c, i))
          return false;
    if(2 * m_vertices.size() != number_of_faces + 4)
      return false;
    if constexpr(Mesh::Domain::has_constrained_edges)
      for(const Cell_handle c : m_cells)
        for(int i = 0; i < 4; ++i)
          for(int j = 0; j < i; ++j)
            if(m_mesh.domain().is_constrained_edge(c->vertex(i), c->vertex(j)))
              return false;
    return true;
  }

  // Vertices are not to be lost.
  bool has_all_vertices() const
  {
    return std::all_of(m_vertices.begin(), m_vertices.end(), [this](const Vertex_handle v)
    {
      return std::any_of(m_tetrahedra.begin(), m_tetrahedra.end(),
                         [&](const Tetrahedron& t) { return internal::contains(t, v); });
    });
  }

  // Edges of the old cells may be as they are.
  bool are_edges_in_size() const
  {
    const auto was_there = [&](const Vertex_handle u, const Vertex_handle v)
    {
      return std::any_of(m_cells.begin(), m_cells.end(),
                         [&](const Cell_handle c) { return c->has_vertex(u) && c->has_vertex(v); });
    };
    for(const auto& t : m_tetrahedra)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
          if(! m_mesh.is_edge_in_size(t[i], t[j]) && ! was_there(t[i], t[j]))
            return false;
    return true;
  }

  Mesh& m_mesh;
  Predicates m_predicates;
  Search m_search;
  std::vector<Cell_handle> m_cells;
  std::vector<Vertex_handle> m_vertices;
  std::vector<Tetrahedron> m_tetrahedra;
  const Cells* m_new_cells = nullptr;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_RECONNECT_BAD_CELL_3_H
