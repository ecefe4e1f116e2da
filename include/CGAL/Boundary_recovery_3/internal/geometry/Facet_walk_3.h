// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_FACET_WALK_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_FACET_WALK_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * An exact walk over a triangle uvw whose edges are edges of the mesh.
 *
 * Nothing but mesh edges that pierce the triangle can keep it from being a facet of the mesh: mesh facets cannot cut
 * its edges, and a vertex inside it is reported as being in the way. The mesh facets cut the triangle along segments
 * between such piercing points and the corners; the walk goes from a cell at uv to all others across these segments.
 */
template <typename Tr>
class Facet_walk_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef Vertex_predicates_3<Tr>      Predicates;
  typedef Shell_3<Tr>                  Shell;
  typedef Crossing_3<Tr>               Crossing;

  enum Outcome
  {
    IS_FACET, // the triangle is a mesh facet
    CROSSED,  // it is pierced by edges
    BLOCKED   // a vertex is in the interior of the triangle
  };

  Facet_walk_3(const Tr& tr, const Predicates& predicates) : m_tr(tr), m_predicates(predicates) { }

  // `c` is a cell that has the edge uv; vw and wu are mesh edges, too.
  Outcome operator()(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w, const Cell_handle c)
  {
    m_u = u;
    m_v = v;
    m_w = w;
    m_crossings.clear();
    m_crossed.clear();
    m_blocking_vertex = Vertex_handle();
    const Outcome outcome = find_first_crossing(c);
    for(std::size_t i = 0; i < m_crossings.size(); ++i)
      find_crossings_around(Crossing(m_crossings[i])); // a copy, for the list grows
    return m_blocking_vertex == Vertex_handle() ? outcome : BLOCKED;
  }

  // The same, where no such cell is known.
  Outcome operator()(const std::array<Vertex_handle, 3>& uvw)
  {
    int i, j;
    Cell_handle c;
    CGAL_assertion_code(const bool is_edge =)
    m_tr.is_edge(uvw[0], uvw[1], c, i, j);
    CGAL_assertion(is_edge);
    return (*this)(uvw[0], uvw[1], uvw[2], c);
  }

  // The mesh edges that pierce the triangle.
  const std::vector<Crossing>& crossings() const { return m_crossings; }

  // The vertex in the way, if the last walk was blocked.
  Vertex_handle blocking_vertex() const { return m_blocking_vertex; }

private:
  // The cell at uv that the triangle runs into has exactly one edge that pierces it or a vertex inside it.
  Outcome find_first_crossing(const Cell_handle c)
  {
    m_shell.assign(m_tr, c, c->index(m_u), c->index(m_v));
    const Shell_wedge wedge = internal::find_wedge(m_shell, m_predicates, m_w);
    if(wedge.index == Shell::none)
      return IS_FACET;
    const Vertex_handle p = m_shell.vertex(wedge.index), q = m_shell.vertex(m_shell.next(wedge.index));
    if(wedge.is_facet)
    {
      // uvp would have to cut uw or vw, unless p is inside or on the rim of the triangle
      m_blocking_vertex = p;
      return BLOCKED;
    }
    check(p, q, m_shell.cell(wedge.index));
    return CROSSED;
  }

  void find_crossings_around(const Crossing& crossing)
  {
    const Vertex_handle p = crossing.vertices[0], q = crossing.vertices[1];
    m_shell.assign(m_tr, crossing.cell, crossing.cell->index(p), crossing.cell->index(q));
    for(int i = 0; i < m_shell.degree(); ++i)
    {
      // a vertex inside the triangle need not be seen from uv, but some cell at a piercing edge has it
      if(m_blocking_vertex == Vertex_handle() && is_inside(m_shell.vertex(i)))
        m_blocking_vertex = m_shell.vertex(i);
      for(const Vertex_handle end : { p, q })
        check(end, m_shell.vertex(i), m_shell.cell(i));
    }
    for(int i = 0; i < m_shell.degree(); ++i)
      check(m_shell.vertex(i), m_shell.vertex(m_shell.next(i)), m_shell.cell(i));
  }

  // Whether a vertex of the mesh is in the triangle. It cannot be on its rim, which consists of mesh edges.
  bool is_inside(const Vertex_handle p) const
  {
    return p != m_u && p != m_v && p != m_w && ! m_tr.is_infinite(p)
        && m_predicates.orientation(m_u, m_v, m_w, p) == COPLANAR
        && m_predicates.side_of_line(m_u, m_v, p, m_w) == POSITIVE
        && m_predicates.side_of_line(m_v, m_w, p, m_u) == POSITIVE
        && m_predicates.side_of_line(m_w, m_u, p, m_v) == POSITIVE;
  }

  // Lists the mesh edge pq if it pierces the triangle and is not listed yet.
  void check(const Vertex_handle p, const Vertex_handle q, const Cell_handle c)
  {
    if(m_tr.is_infinite(p) || m_tr.is_infinite(q) || ! m_predicates.segment_pierces_triangle(p, q, m_u, m_v, m_w))
      return;
    if(m_crossed.insert({{ p, q }}).second)
      m_crossings.push_back({ 1, {{ p, q, Vertex_handle() }}, c });
  }

  const Tr& m_tr;
  const Predicates& m_predicates;
  Vertex_handle m_u, m_v, m_w;
  std::vector<Crossing> m_crossings;
  Simplex_index_3<Vertex_handle, 2> m_crossed;
  Vertex_handle m_blocking_vertex;
  Shell m_shell;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_FACET_WALK_3_H
