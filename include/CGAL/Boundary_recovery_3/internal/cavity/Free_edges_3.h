// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_EDGES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_EDGES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Polyhedron_obstacles_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Bit_matrix.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The edges between vertices of a polyhedron that are inside and cross no obstacle: those that can be in a
 * tetrahedralization of it.
 */
template <typename Tr>
class Free_edges_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef Polyhedron_obstacles_3<Tr>    Obstacles;
  typedef typename Obstacles::Edge      Edge;
  typedef typename Obstacles::Face      Face;

  explicit Free_edges_3(const Obstacles& obstacles) : m_obstacles(obstacles) { }

  // `cells` are those that the obstacles are of.
  template <typename CellRange>
  void collect(const CellRange& cells)
  {
    const std::size_t n = m_obstacles.number_of_vertices();
    collect_cells_at_vertices(cells);
    m_edges.assign(n, n);
    for(std::size_t a = 0; a < n; ++a)
      for(std::size_t b = a + 1; b < n; ++b)
      {
        const Edge e = {{ a, b }};
        if(m_obstacles.has_edge(e) || is_inside_and_free(e))
          m_edges.set(a, b);
      }
  }

  // For each vertex, the other ends of its edges, if greater.
  const Bit_matrix& greater_ends() const { return m_edges; }

private:
  template <typename CellRange>
  void collect_cells_at_vertices(const CellRange& cells)
  {
    m_cells_at.assign(m_obstacles.number_of_vertices(), std::vector<Cell_handle>());
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
      {
        const std::size_t v = m_obstacles.position(c->vertex(i));
        if(v < m_cells_at.size()) // it may be the superfluous one
          m_cells_at[v].push_back(c);
      }
  }

  // For an edge that is no obstacle. One that crosses none is inside at both ends or at none; unless it passes through
  // a vertex, and then it may be kept, for it is in no tetrahedralization anyway.
  bool is_inside_and_free(const Edge& e) const
  {
    const Uncertain<bool> at_0 = starts_inside(e[0], e[1]), at_1 = starts_inside(e[1], e[0]);
    return CGAL::possibly(at_0) && CGAL::possibly(at_1) && is_free(e)
        && (CGAL::certainly(at_0) || CGAL::certainly(at_1) || is_inside_at_cells(e));
  }

  // Whether the ray from a to b starts inside the polyhedron, as far as the sides of the faces at a tell. The shortest
  // way from a direction to the boundary, seen from a, ends at a face that has it on its inner side if it comes from
  // inside, on its outer side if from outside. A ray along the boundary may be taken for either: such an edge overlaps
  // or crosses one of the boundary, and is not wanted.
  Uncertain<bool> starts_inside(const std::size_t a, const std::size_t b) const
  {
    const auto is_any = [&](const Bit_matrix& side)
    {
      return side.any_of([&](const std::size_t w) { return m_obstacles.sides().stars.word(a, w) & side.word(b, w); },
                         [](std::size_t) { return true; });
    };
    if(! m_obstacles.is_outer(a))
      return true;
    if(! is_any(m_obstacles.sides().inner))
      return false;
    return is_any(m_obstacles.sides().outer) ? Uncertain<bool>::indeterminate() : Uncertain<bool>(true);
  }

  // Whether an edge between vertices on the boundary starts inside the polyhedron, by the cells at one of them.
  bool is_inside_at_cells(const Edge& e) const
  {
    const bool is_first = m_cells_at[e[0]].size() <= m_cells_at[e[1]].size();
    const std::size_t a = e[is_first ? 0 : 1], b = e[is_first ? 1 : 0];
    return std::any_of(m_cells_at[a].begin(), m_cells_at[a].end(), [&](const Cell_handle c)
    {
      return this->starts_in(c, m_obstacles.vertex(a), m_obstacles.vertex(b));
    });
  }

  // Whether the ray from a, a vertex of the cell, to b starts in the closed cell.
  bool starts_in(const Cell_handle c, const Vertex_handle a, const Vertex_handle b) const
  {
    for(int i = 0; i < 4; ++i)
    {
      const auto t = internal::with_exchanged_vertex(c, c->vertex(i), b);
      if(c->vertex(i) != a && m_obstacles.predicates().orientation(t[0], t[1], t[2], t[3]) == NEGATIVE)
        return false;
    }
    return true;
  }

  // Whether no obstacle crosses the edge, which is none itself.
  bool is_free(const Edge& e) const
  {
    const Bbox_3 box = m_obstacles.bbox(e);
    const Bit_matrix& coplanar = m_obstacles.sides().coplanar;
    const auto separating_faces = [&](const std::size_t w) { return m_obstacles.separating(e[0], e[1], w); };
    const auto faces_in_plane = [&](const std::size_t w) { return coplanar.word(e[0], w) & coplanar.word(e[1], w); };
    const auto is_near = [&](const std::size_t i) { return CGAL::do_overlap(box, m_obstacles.box(i)); };
    return ! coplanar.any_of(separating_faces, [&](const std::size_t i)
           {
             return is_near(i) && this->crosses_through(e, m_obstacles.faces()[i]);
           })
        && ! coplanar.any_of(faces_in_plane, [&](const std::size_t i)
           {
             return is_near(i) && this->crosses_in_plane(e, i);
           })
        && std::none_of(m_obstacles.single_edges().begin(), m_obstacles.single_edges().end(),
                        [&](const Edge& f) { return this->cross(e, f); });
  }

  // Whether an edge in the plane of a face of the obstacles crosses one of its edges: seen from a vertex off the plane,
  // each has the ends of the other one on opposite sides.
  bool crosses_in_plane(const Edge& e, const std::size_t i) const
  {
    const Face& f = m_obstacles.faces()[i];
    const std::size_t x = m_obstacles.aside(i);
    const std::array<Orientation, 3> sides = {{ m_obstacles.orientation(e, x, f[0]),
                                                m_obstacles.orientation(e, x, f[1]),
                                                m_obstacles.orientation(e, x, f[2]) }};
    for(int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      const Edge g = {{ f[k], f[l] }};
      if(sides[k] * sides[l] == NEGATIVE
         && m_obstacles.orientation(g, x, e[0]) * m_obstacles.orientation(g, x, e[1]) == NEGATIVE)
        return true;
    }
    return false;
  }

  // Whether an edge with ends on both sides of the face pierces it or crosses one of its edges.
  bool crosses_through(const Edge& e, const Face& f) const
  {
    std::array<int, 3> number_of = {{ 0, 0, 0 }}; // of the edges of the face, by how the edge passes them
    for(int k = 0; k < 3; ++k)
    {
      ++number_of[m_obstacles.orientation(e, f[k], f[(k + 1) % 3]) + 1];
      if(number_of[0] * number_of[2] != 0 || number_of[1] == 2)
        return false;
    }
    return true;
  }

  bool cross(const Edge& e, const Edge& f) const
  {
    return m_obstacles.predicates().segments_cross(m_obstacles.vertex(e[0]), m_obstacles.vertex(e[1]),
                                                   m_obstacles.vertex(f[0]), m_obstacles.vertex(f[1]));
  }

  const Obstacles& m_obstacles;
  std::vector<std::vector<Cell_handle> > m_cells_at; // of each vertex, the cells of the polyhedron at it
  Bit_matrix m_edges;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_EDGES_3_H
