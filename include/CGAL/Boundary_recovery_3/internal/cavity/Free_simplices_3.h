// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_SIMPLICES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_SIMPLICES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Polyhedron_obstacles_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

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

/*
 * The faces between vertices of a polyhedron of which all edges are free, and that no obstacle pierces: those that can
 * be in a tetrahedralization of it. They are ordered by their vertices abc, a < b < c.
 */
template <typename Tr>
class Free_faces_3
{
public:
  typedef Polyhedron_obstacles_3<Tr>    Obstacles;
  typedef typename Obstacles::Edge      Edge;
  typedef typename Obstacles::Face      Face;
  typedef std::uint32_t                 Number; // of a face or a vertex: there may be many, so memory counts

  explicit Free_faces_3(const Obstacles& obstacles) : m_obstacles(obstacles) { }

  // `greater_ends` are, for each vertex, the other ends of the free edges, if greater.
  void collect(const Bit_matrix& greater_ends)
  {
    m_first.assign(1, 0);
    m_thirds.clear();
    m_faces.assign(n() * n(), n());
    for(std::size_t a = 0; a < n(); ++a)
      for(std::size_t b = 0; b < n(); ++b)
      {
        if(greater_ends(a, b))
          greater_ends.for_each([&](const std::size_t w) { return greater_ends.word(a, w) & greater_ends.word(b, w); },
                                [&](const std::size_t c) { this->add_face({{ a, b, c }}); });
        m_first.push_back(static_cast<Number>(m_thirds.size()));
      }
  }

  std::size_t size() const { return m_thirds.size(); }

  Face operator[](const std::size_t i) const
  {
    const std::size_t e = std::upper_bound(m_first.begin(), m_first.end(), i) - m_first.begin() - 1;
    return {{ e / n(), e % n(), m_thirds[i] }};
  }

  // The position of a face in the list of all, or their number.
  std::size_t find(const Face& f) const
  {
    const std::size_t e = pair(f[0], f[1]);
    const auto begin = m_thirds.begin() + m_first[e], end = m_thirds.begin() + m_first[e + 1];
    const auto it = std::lower_bound(begin, end, f[2]);
    return it != end && *it == f[2] ? it - m_thirds.begin() : m_thirds.size();
  }

  // The faces abc for given a and b are those from the first position to the last one, which is excluded.
  Number begin_at(const std::size_t a, const std::size_t b) const { return m_first[pair(a, b)]; }
  Number end_at(const std::size_t a, const std::size_t b) const { return m_first[pair(a, b) + 1]; }

  // The greatest vertex of the face i.
  Number third(const std::size_t i) const { return m_thirds[i]; }

  // Calls `work` with each d > c that makes the faces abd, acd and bcd, for a < b < c, in increasing order.
  template <typename Work>
  void for_each_common_third(const std::size_t a, const std::size_t b, const std::size_t c, const Work& work) const
  {
    const auto thirds = [&](const std::size_t w)
    {
      return m_faces.word(pair(a, b), w) & m_faces.word(pair(a, c), w) & m_faces.word(pair(b, c), w);
    };
    m_faces.for_each(thirds, work);
  }

private:
  std::size_t n() const { return m_obstacles.number_of_vertices(); }
  std::size_t pair(const std::size_t a, const std::size_t b) const { return a * n() + b; }

  void add_face(const Face& f)
  {
    if(! is_free(f))
      return;
    m_thirds.push_back(static_cast<Number>(f[2]));
    m_faces.set(pair(f[0], f[1]), f[2]);
  }

  // Whether no obstacle pierces the face, of which all edges are free. Where a surface of obstacles passes through it,
  // this starts at one of its vertices, mostly, so it is enough to look there; what is overlooked, Face_matching finds.
  bool is_free(const Face& f) const
  {
    const Bit_matrix& stars = m_obstacles.sides().stars;
    for(int k = 0; k < 3; ++k)
    {
      const std::size_t v = f[k], b = f[(k + 1) % 3], c = f[(k + 2) % 3];
      const auto separating_faces = [&](const std::size_t w)
      {
        return stars.word(v, w) & m_obstacles.separating(b, c, w);
      };
      if(stars.any_of(separating_faces, [&](const std::size_t i) { return this->pierces_at_vertex(i, v, b, c); }))
        return false;
    }
    return std::none_of(m_obstacles.inner_edges().begin(), m_obstacles.inner_edges().end(),
                        [&](const Edge& e) { return this->pierces(e, f); });
  }

  // Whether the opposite edge of v in a face of the obstacles, which has b and c on opposite sides, pierces vbc.
  bool pierces_at_vertex(const std::size_t i, const std::size_t v, const std::size_t b, const std::size_t c) const
  {
    const Face& f = m_obstacles.faces()[i];
    const std::size_t k = std::find(f.begin(), f.end(), v) - f.begin();
    const Edge e = {{ f[(k + 1) % 3], f[(k + 2) % 3] }};
    const bool is_b_positive = m_obstacles.sides().positive(b, i); // the line of e passes b there, too
    return m_obstacles.orientation(e, b, c) == (is_b_positive ? POSITIVE : NEGATIVE)
        && m_obstacles.orientation({{ v, b, c }}, e[0]) * m_obstacles.orientation({{ v, b, c }}, e[1]) == NEGATIVE;
  }

  bool pierces(const Edge& e, const Face& f) const
  {
    const auto& v = m_obstacles.vertices();
    return m_obstacles.predicates().segment_pierces_triangle(v[e[0]], v[e[1]], v[f[0]], v[f[1]], v[f[2]]);
  }

  const Obstacles& m_obstacles;
  Bit_matrix m_faces;            // for each pair of vertices, the third ones of its faces, if greater
  std::vector<Number> m_first;   // of each pair of vertices, where its faces begin
  std::vector<Number> m_thirds;  // of the faces at one edge after the other, their greatest vertices
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_SIMPLICES_3_H
