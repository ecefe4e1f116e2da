// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_SEGMENT_WALK_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_SEGMENT_WALK_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/walk_to.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// A mesh edge (dimension 1) or facet (dimension 2) that crosses a constraint, and a cell that has it.
template <typename Tr>
struct Crossing_3
{
  int dimension;
  std::array<typename Tr::Vertex_handle, 3> vertices; // the third one of an edge is the default handle
  typename Tr::Cell_handle cell;
};

// Appends the cells at the crossed edge or facet.
template <typename Tr>
void append_cells_at(const Tr& tr, const Crossing_3<Tr>& crossing, std::vector<typename Tr::Cell_handle>& cells)
{
  const typename Tr::Cell_handle c = crossing.cell;
  if(crossing.dimension == 1)
  {
    const Shell_3<Tr> shell(tr, c, c->index(crossing.vertices[0]), c->index(crossing.vertices[1]));
    cells.insert(cells.end(), shell.cells().begin(), shell.cells().end());
  }
  else
    cells.insert(cells.end(), { c, c->neighbor(internal::index_of_opposite_vertex(c, crossing.vertices)) });
}

// A place in the shell of an edge ab: the interior of the facet a b p_i, or of the cell a b p_i p_next(i).
struct Shell_wedge
{
  int index; // i
  bool is_facet;
};

// The wedge through which the half-plane from the line ab through v leaves ab. If v is a vertex of the shell, there is
// nothing to look for, and the index is Shell_3::none.
template <typename Tr>
Shell_wedge find_wedge(const Shell_3<Tr>& shell, const Vertex_predicates_3<Tr>& predicates,
                       const typename Tr::Vertex_handle v)
{
  const Shell_wedge none = { Shell_3<Tr>::none, false };
  if(shell.index(v) != Shell_3<Tr>::none)
    return none;
  const auto side_of = [&](const int i)
  {
    return i == shell.infinite_index() ? ZERO : predicates.orientation(shell.a(), shell.b(), shell.vertex(i), v);
  };
  Orientation side = side_of(0);
  for(int i = 0; i < shell.degree(); ++i)
  {
    if(i != shell.infinite_index() && side == COPLANAR
       && predicates.side_of_line(shell.a(), shell.b(), shell.vertex(i), v) == POSITIVE)
      return { i, true };
    const Orientation next_side = side_of(shell.next(i));
    if(side == POSITIVE && next_side == NEGATIVE)
      return { i, false };
    side = next_side;
  }
  CGAL_assertion(false);
  return none;
}

/*
 * An exact walk through the mesh along the segment between two vertices.
 *
 * The walk is always in one of three states: at the start vertex, in the interior of a mesh edge, or in the interior of
 * a mesh facet. It lists the edges and facets that it crosses, in their order along the segment. A facet in whose plane
 * the segment runs is not listed; its edges that are crossed are. It ends at the target, or at a vertex in the way.
 * It starts at the other vertex, and what it finds is turned around, if the start has so many cells that it takes long
 * to find the first one: else each edge of a fan costs as much as the fan has edges.
 */
template <typename Tr>
class Segment_walk_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef Vertex_predicates_3<Tr>      Predicates;
  typedef Shell_3<Tr>                  Shell;
  typedef Crossing_3<Tr>               Crossing;

  enum Outcome
  {
    IS_EDGE, // the segment is a mesh edge: nothing is crossed
    CROSSED, // the segment ends at the target after the crossings
    BLOCKED  // a vertex is in the interior of the segment
  };

  Segment_walk_3(const Tr& tr, const Predicates& predicates) : m_tr(tr), m_predicates(predicates) { }

  Outcome operator()(const Vertex_handle u, const Vertex_handle v)
  {
    m_u = u;
    m_v = v;
    m_crossings.clear();
    std::optional<Cell_handle> first = walk_around_start();
    if(first)
      return walk(*first);
    std::swap(m_u, m_v);
    first = walk_around_start();
    const Outcome outcome = first ? walk(*first) : BLOCKED;
    turn_around();
    return outcome == BLOCKED ? walk(search_star_of_start()) : outcome;
  }

  Outcome operator()(const std::array<Vertex_handle, 2>& uv) { return (*this)(uv[0], uv[1]); }

  const std::vector<Crossing>& crossings() const { return m_crossings; }

  // The vertex in the way, if the last walk was blocked.
  Vertex_handle blocking_vertex() const { return m_blocking_vertex; }

private:
  Outcome walk(const Cell_handle first)
  {
    m_crossings.clear();
    m_blocking_vertex = Vertex_handle();
    Outcome outcome = CROSSED;
    bool is_finished = leave_start(first, outcome);
    while(! is_finished)
      is_finished = m_crossings.back().dimension == 2 ? leave_facet(outcome) : leave_edge(outcome);
    return outcome;
  }

  // What was found on the way from v to u, as if it were found on the way from u to v.
  void turn_around()
  {
    std::swap(m_u, m_v);
    std::reverse(m_crossings.begin(), m_crossings.end());
    for(Crossing& crossing : m_crossings)
      if(crossing.dimension == 2)
      {
        const Cell_handle c = crossing.cell;
        crossing.cell = c->neighbor(internal::index_of_opposite_vertex(c, crossing.vertices));
        std::swap(crossing.vertices[1], crossing.vertices[2]);
      }
  }

  // All of these return true when the walk has come to its end.

  bool leave_start(const Cell_handle c, Outcome& outcome)
  {
    if(c == Cell_handle())
    {
      outcome = IS_EDGE;
      return true;
    }
    // The direction to v is in the closed cone of c at u. The facets at u that contain it decide: a vertex is an end of
    // the crossed entity unless the direction is in the plane of the facet opposite to it.
    const int i = c->index(m_u);
    boost::container::small_vector<Vertex_handle, 3> ends;
    for(int k = 0; k < 3; ++k)
      if(m_start_sides[(k + 1) % 3] != COPLANAR)
        ends.push_back(c->vertex(Tr::vertex_triple_index(i, k)));
    return cross(ends, c, outcome);
  }

  // A cell at u whose closed cone contains the direction to v, or the default handle if uv is a mesh edge. A walk
  // around u settles nearly all cases in a few steps; it may run in circles where the mesh is not Delaunay, and take
  // long where many cells are at u. Then there is no answer.
  std::optional<Cell_handle> walk_around_start()
  {
    static constexpr int max_number_of_steps = 32;
    Cell_handle c = m_u->cell();
    if(m_tr.is_infinite(c))
      c = c->neighbor(c->index(m_tr.infinite_vertex()));
    const auto facet_towards = [this](const Cell_handle d) { return d->has_vertex(m_v) ? -1 : separating_facet(d); };
    const auto cell_behind = [&](const Cell_handle d, const int k) -> std::optional<Cell_handle>
    {
      CGAL_assertion(! m_tr.is_infinite(d->neighbor(k)));
      return d->neighbor(k);
    };
    const std::optional<Cell_handle> last = internal::walk_to(c, max_number_of_steps, facet_towards, cell_behind);
    return last && (*last)->has_vertex(m_v) ? Cell_handle() : last;
  }

  // The same for certain, in time that grows with the number of cells at u.
  Cell_handle search_star_of_start()
  {
    m_star.clear();
    m_tr.incident_cells(m_u, std::back_inserter(m_star));
    for(const Cell_handle s : m_star)
      if(s->has_vertex(m_v))
        return Cell_handle();
    for(const Cell_handle s : m_star)
      if(! m_tr.is_infinite(s) && separating_facet(s) < 0)
        return s;
    CGAL_assertion(false);
    return Cell_handle();
  }

  // The index in c of a facet at u that has v behind it, and not in its plane; -1 if there is none. Then
  // `m_start_sides` tells on which side of each of the three facets v is.
  int separating_facet(const Cell_handle c)
  {
    const int i = c->index(m_u);
    for(int k = 0; k < 3; ++k)
    {
      const Vertex_handle p = c->vertex(Tr::vertex_triple_index(i, k));
      const Vertex_handle q = c->vertex(Tr::vertex_triple_index(i, (k + 1) % 3));
      m_start_sides[k] = m_predicates.orientation(m_u, p, q, m_v);
      if(m_start_sides[k] == POSITIVE)
        return Tr::vertex_triple_index(i, (k + 2) % 3);
    }
    return -1;
  }

  // From the interior of a facet into the cell behind it.
  bool leave_facet(Outcome& outcome)
  {
    const Crossing from = m_crossings.back();
    const Cell_handle c = from.cell;
    const Vertex_handle s = c->vertex(internal::index_of_opposite_vertex(c, from.vertices));
    if(s == m_v)
      return true;
    // In the order in which the vertices of the facet go around uv, s comes within half a turn after the vertex k if
    // turn(k) is NEGATIVE, before it if POSITIVE. The segment leaves the cell opposite to s; two turns tell where.
    const std::array<Vertex_handle, 3>& f = from.vertices;
    const auto turn = [&](const int k) { return m_predicates.orientation(m_u, m_v, f[k], s); };
    const Orientation first = turn(0);
    const int k = first == NEGATIVE ? 2 : 1;
    const Orientation second = turn(k);
    if(first == COPLANAR && second != POSITIVE)
      return second == COPLANAR ? cross({ s }, c, outcome) : cross({ f[0], s }, c, outcome);
    if(second == COPLANAR)
      return cross({ f[k], s }, c, outcome);
    return second == NEGATIVE ? cross({ f[k - 1], f[k], s }, c, outcome)
                              : cross({ f[k], f[(k + 1) % 3], s }, c, outcome);
  }

  // From the interior of an edge into the cell or facet at it that the segment enters.
  bool leave_edge(Outcome& outcome)
  {
    const Crossing from = m_crossings.back();
    const Vertex_handle p = from.vertices[0], q = from.vertices[1];
    m_shell.assign(m_tr, from.cell, from.cell->index(p), from.cell->index(q));
    const Shell_wedge wedge = internal::find_wedge(m_shell, m_predicates, m_v);
    if(wedge.index == Shell::none) // v is opposite to the edge
      return true;
    const Vertex_handle r = m_shell.vertex(wedge.index), s = m_shell.vertex(m_shell.next(wedge.index));
    const Cell_handle c = m_shell.cell(wedge.index);
    return wedge.is_facet ? leave_edge_in_facet(p, q, r, c, outcome) : leave_edge_in_cell(p, q, r, s, c, outcome);
  }

  // The segment runs inside the facet pqr: it crosses pr or qr, or runs into r.
  bool leave_edge_in_facet(const Vertex_handle p, const Vertex_handle q, const Vertex_handle r,
                           const Cell_handle c, Outcome& outcome)
  {
    const Orientation side = m_predicates.side_of_line(m_u, m_v, p, r);
    if(side == COLLINEAR)
      return cross({ r }, c, outcome);
    return side == POSITIVE ? cross({ q, r }, c, outcome) : cross({ p, r }, c, outcome);
  }

  // The segment runs into the cell pqrs between its facets pqr and pqs.
  bool leave_edge_in_cell(const Vertex_handle p, const Vertex_handle q, const Vertex_handle r, const Vertex_handle s,
                          const Cell_handle c, Outcome& outcome)
  {
    const Orientation side = m_predicates.orientation(m_u, m_v, r, s);
    if(side == COPLANAR)
      return cross({ r, s }, c, outcome);
    const Vertex_handle x = m_predicates.orientation(m_u, m_v, p, r) == side ? p : q;
    return side == NEGATIVE ? cross({ x, r, s }, c, outcome) : cross({ x, s, r }, c, outcome);
  }

  typedef boost::container::small_vector<Vertex_handle, 3> Vertices;

  // Appends the entity of c with these vertices. For a facet, the cell behind it is stored, for that is where to go on,
  // and its vertices go around uv such that orientation(u, v, vertex k, vertex k + 1) is NEGATIVE.
  bool cross(const Vertices& vertices, const Cell_handle c, Outcome& outcome)
  {
    CGAL_assertion(! vertices.empty());
    if(vertices.size() == 1)
    {
      m_blocking_vertex = vertices[0];
      outcome = BLOCKED;
      return true;
    }
    Crossing crossing = { static_cast<int>(vertices.size()) - 1, {{ vertices[0], vertices[1], Vertex_handle() }}, c };
    if(vertices.size() == 3)
    {
      for(int k = 0; k < 3; ++k)
        CGAL_expensive_assertion(m_predicates.orientation(m_u, m_v, vertices[k], vertices[(k + 1) % 3]) == NEGATIVE);
      crossing.vertices[2] = vertices[2];
      crossing.cell = c->neighbor(internal::index_of_opposite_vertex(c, vertices));
    }
    m_crossings.push_back(crossing);
    return false;
  }

  const Tr& m_tr;
  const Predicates& m_predicates;
  Vertex_handle m_u, m_v;
  std::vector<Crossing> m_crossings;
  Vertex_handle m_blocking_vertex;
  std::array<Orientation, 3> m_start_sides;
  Shell m_shell;
  std::vector<Cell_handle> m_star;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_SEGMENT_WALK_3_H
