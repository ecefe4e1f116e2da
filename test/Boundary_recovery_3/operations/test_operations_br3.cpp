// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Local operations, and what is asked before them, against definitions: in meshes of points in general position and of
// degenerate ones, with and without exact positions, each alone and many in transactions that are taken back.

#undef NDEBUG

#include "changing_mesh_br3.h"

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/grow_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/constraint_queries.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Remove_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/collapse_edge.h>
#include <CGAL/Boundary_recovery_3/internal/operations/split_edge.h>
#include <CGAL/Boundary_recovery_3/internal/operations/split_facet.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
using br3_test::random_int;

typedef CGAL::Exact_predicates_inexact_constructions_kernel  K;
typedef CGAL::Exact_predicates_exact_constructions_kernel    EK;
typedef internal::Star_obstacle                              Star_obstacle;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

template <typename Items>
typename Items::value_type random_item(const Items& items, std::mt19937& rng)
{
  return items[static_cast<std::size_t>(random_int(rng, static_cast<int>(items.size())))];
}

// --- operations at random places -------------------------------------------------------------------------------------

template <typename Mesh>
class Random_change
{
public:
  Random_change(Mesh& mesh, std::mt19937& rng)
    : m(mesh), rng(rng), m_remove(mesh.editor, mesh.predicates, mesh.constraints)
  { }

  // Makes at most one change, and checks it. An interruption is handed on.
  void operator()()
  {
    switch(random_int(rng, 8))
    {
      case 0: split_edge(); break;
      case 1: split_facet(); break;
      case 2: collapse_edge(); break;
      case 3: case 4: star_cavity(); break;
      case 5: remove_vertex(); break;
      case 6: remove_vertex_with_layer(); break;
      case 7: move_vertex(); break;
    }
  }

  // What is only asked.
  void ask()
  {
    query_constraints();
    grow();
    shrink();
  }

  // Vertices moved, or came.
  void forget() { m_remove.forget(); }

private:
  typedef typename Mesh::Tr             Tr;
  typedef typename Mesh::Vertex_handle  Vertex_handle;
  typedef typename Mesh::Cell_handle    Cell_handle;
  typedef typename Mesh::Simplex        Simplex;
  typedef typename Mesh::Tetrahedron    Tetrahedron;
  typedef typename Mesh::Tetrahedra     Tetrahedra;
  typedef typename Mesh::Vertices       Vertices;
  typedef typename Mesh::Cells          Cells;
  typedef typename Mesh::Constraints    Constraints;
  typedef std::array<Vertex_handle, 2>  Vertex_pair;
  typedef std::array<Vertex_handle, 3>  Vertex_triple;
  typedef br3_test::Expected_change<Mesh>  Expected_change;

  // Operations take whatever answers is_constrained(): calls `work` with each kind of set that there is.
  template <typename Work>
  void for_each_kind_of_constraints(const Work& work) const
  {
    work(m.constraints);
    internal::Constraints_3<Tr> numbered;
    for(const Simplex& s : m.constraints.simplices)
    {
      const Vertices v(s.begin(), s.end());
      if(s.size() == 2)
        numbered.insert(v[0], v[1]);
      else
        numbered.insert(v[0], v[1], v[2]);
    }
    work(numbered);
  }

  static bool is_in(const Simplex& face, const Simplex& s)
  {
    return std::includes(s.begin(), s.end(), face.begin(), face.end());
  }

  bool is_any_constraint_at(const Vertex_handle v) const
  {
    return std::any_of(m.constraints.simplices.begin(), m.constraints.simplices.end(),
                       [&](const Simplex& s) { return s.count(v) == 1; });
  }

  Cell_handle random_finite_cell() const { return random_item(br3_test::finite_cells(m.tr), rng); }

  Vertex_handle random_vertex() const { return random_finite_cell()->vertex(random_int(rng, 4)); }

  // Inside the hull, with no constraint at it; none if a few trials find no such vertex.
  Vertex_handle random_free_vertex() const
  {
    for(int trial = 0; trial < 20; ++trial)
    {
      const Vertex_handle v = random_vertex();
      if(! m.is_any_infinite(m.cells_with({ v })) && ! is_any_constraint_at(v))
        return v;
    }
    return Vertex_handle();
  }

  Cells ball(const Vertex_handle v) const
  {
    Cells cells;
    const bool is_finite = internal::collect_ball(m.tr, v, cells);
    const Cells expected = m.cells_with({ v });
    assert(is_finite == ! m.is_any_infinite(expected));
    assert(std::set<Cell_handle>(cells.begin(), cells.end()) == std::set<Cell_handle>(expected.begin(), expected.end()));
    return cells;
  }

  // --- splits -------------------------------------------------------------------------------------------------------

  // Anywhere on an edge, or near one that is not on the hull.
  void split_edge()
  {
    const Cell_handle finite = random_finite_cell();
    const int i = random_int(rng, 4), j = (i + 1 + random_int(rng, 3)) % 4;
    const Vertex_handle a = finite->vertex(i), b = finite->vertex(j);
    const Cells shell = m.cells_with({ a, b });
    const Cell_handle c = random_item(shell, rng);
    const bool is_on_edge = random_int(rng, 3) > 0;
    const Vertices support = is_on_edge ? Vertices{ a, b } : Vertices{ a, a, a, b, b, b, random_vertex() };
    const Vertex_handle v = m.create_vertex(support, rng);
    if(v == Vertex_handle())
      return;
    Tetrahedra halves;
    for(const Cell_handle cell : shell)
      for(const Vertex_handle end : { a, b })
        halves.push_back(Mesh::with_exchanged(cell, end, v));
    const bool is_seen = m.are_positive(halves);
    assert(internal::is_shell_seen(m.tr, m.predicates, c, a, b, v) == is_seen && (is_seen || ! is_on_edge));
    ++number_of[! is_seen ? "shell not seen" : is_on_edge ? "shell seen from the edge" : "shell seen from elsewhere"];
    const bool is_on_hull = m.is_any_infinite(shell), is_constrained = m.constraints.is_constrained(a, b);
    if(! is_seen || (! is_on_edge && (is_on_hull || is_constrained)))
    {
      m.delete_vertex(v);
      return;
    }
    Constraints constraints = m.constraints;
    if(is_constrained)
      constraints.split(a, b, v);
    Expected_change(m, shell, halves).make([&]
    {
      if(is_constrained || random_int(rng, 2) == 0)
        internal::split_edge(m.editor, m.constraints, c, a, b, v);
      else
        internal::split_edge(m.editor, c, a, b, v);
    });
    assert(m.constraints.simplices == constraints.simplices);
    ++number_of[is_on_hull ? "edge split on the hull" : "edge split"];
    number_of["constrained edge split"] += is_constrained;
    forget();
  }

  // Anywhere on a facet, or near one that is not on the hull.
  void split_facet()
  {
    Cell_handle c = random_finite_cell();
    const int i = random_int(rng, 4);
    const Vertex_handle apex = c->vertex(i);
    const Simplex facet = without(Mesh::vertices_of(c), apex);
    const Cells cells = m.cells_with(facet);
    assert(cells.size() == 2);
    c = random_item(cells, rng);
    const bool is_on_facet = random_int(rng, 3) > 0;
    Vertices support(facet.begin(), facet.end());
    if(! is_on_facet)
      support = { support[0], support[0], support[1], support[1], support[2], support[2], apex };
    const Vertex_handle v = m.create_vertex(support, rng);
    if(v == Vertex_handle())
      return;
    Tetrahedra thirds;
    for(const Cell_handle cell : cells)
      for(const Vertex_handle w : facet)
        thirds.push_back(Mesh::with_exchanged(cell, w, v));
    Vertex_triple f;
    std::copy(facet.begin(), facet.end(), f.begin());
    std::rotate(f.begin(), f.begin() + random_int(rng, 3), f.end());
    const bool is_on_hull = m.is_any_infinite(cells), is_constrained = m.constraints.is_constrained(f[0], f[1], f[2]);
    if(! m.are_positive(thirds) || (! is_on_facet && (is_on_hull || is_constrained)))
    {
      m.delete_vertex(v);
      return;
    }
    Constraints constraints = m.constraints;
    if(is_constrained)
      constraints.split(f[0], f[1], f[2], v);
    Expected_change(m, cells, thirds).make([&]
    {
      if(is_constrained || random_int(rng, 2) == 0)
        internal::split_facet(m.editor, m.constraints, c, f, v);
      else
        internal::split_facet(m.editor, c, f, v);
    });
    assert(m.constraints.simplices == constraints.simplices);
    ++number_of[is_on_hull ? "facet split on the hull" : is_on_facet ? "facet split" : "facet split from elsewhere"];
    number_of["constrained facet split"] += is_constrained;
    forget();
  }

  // --- removal of vertices ------------------------------------------------------------------------------------------

  // The ball of v without the cells at x, starred from x.
  static Tetrahedra collapsed(const Cells& ball, const Vertex_handle v, const Vertex_handle x)
  {
    Tetrahedra result;
    for(const Cell_handle c : ball)
      if(Mesh::vertices_of(c).count(x) == 0)
        result.push_back(Mesh::with_exchanged(c, v, x));
    return result;
  }

  // Those neighbors of v onto which it can be collapsed, in the order in which they are met.
  Vertices seeing_neighbors(const Cells& ball, const Vertex_handle v) const
  {
    Vertices result;
    Simplex known = { v };
    for(const Cell_handle c : ball)
      for(const Vertex_handle x : Mesh::tetrahedron(c))
        if(known.insert(x).second)
        {
          const bool is_seen = m.are_positive(collapsed(ball, v, x));
          assert(internal::is_ball_seen(m.predicates, ball, v, x) == is_seen);
          ++number_of[is_seen ? "ball seen" : "ball not seen"];
          if(is_seen)
            result.push_back(x);
        }
    return result;
  }

  void collapse_edge()
  {
    const Vertex_handle v = random_free_vertex();
    if(v == Vertex_handle())
      return;
    const Cells cells = ball(v);
    const Vertices neighbors = seeing_neighbors(cells, v);
    if(neighbors.empty())
      return;
    const Vertex_handle x = random_item(neighbors, rng);
    Expected_change(m, cells, collapsed(cells, v, x), { v }).make([&]
    {
      internal::collapse_edge(m.editor, cells, v, x);
    });
    ++number_of["edge collapsed"];
    number_of["edge collapsed next to a constraint"] += is_any_constraint_at(x);
  }

  void remove_vertex()
  {
    const Vertex_handle v = random_free_vertex();
    if(v == Vertex_handle())
      return;
    const Cells cells = ball(v);
    const Vertices neighbors = seeing_neighbors(cells, v);
    const bool is_found = m_remove.find(cells, v);
    assert(is_found || neighbors.empty());
    ++number_of[! neighbors.empty() ? "vertex removed by collapse" : is_found ? "vertex removed by reconnection"
                                                                              : "vertex not removed"];
    if(! is_found)
      return;
    assert(m_remove.cells() == cells);
    if(! neighbors.empty())
      assert(m_remove.tetrahedra() == collapsed(cells, v, neighbors.front()));
    Expected_change(m, cells, m_remove.tetrahedra(), { v }).make([&] { m_remove(v); });
  }

  void remove_vertex_with_layer()
  {
    const Vertex_handle v = random_free_vertex();
    if(v == Vertex_handle())
      return;
    const Cells cells = ball(v);
    std::set<Cell_handle> expected(cells.begin(), cells.end());
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(! m.tr.is_infinite(c->neighbor(i)))
          expected.insert(c->neighbor(i));
    const bool is_found = m_remove.find_with_layer(cells, v);
    ++number_of[is_found ? "vertex removed with a layer" : "vertex not removed with a layer"];
    if(! is_found)
      return;
    const Cells found = m_remove.cells();
    assert(found.size() == expected.size() && std::set<Cell_handle>(found.begin(), found.end()) == expected);
    Expected_change(m, found, m_remove.tetrahedra(), { v }).make([&] { m_remove(v); });
  }

  // --- other places for vertices ------------------------------------------------------------------------------------

  // In the ball of a vertex: if it does not see it from there, it is put back. Or into the kernel of the ball.
  void move_vertex()
  {
    const Vertex_handle v = random_free_vertex();
    if(v == Vertex_handle())
      return;
    const Cells cells = ball(v);
    const typename Mesh::Exact_point before = m.exact_point(v);
    const typename Mesh::Point rounded = v->point();
    const bool had_exact_position = m.positions.contains(v);
    bool is_seen = true;
    if(random_int(rng, 2) == 0)
    {
      m.editor.before_move(v);
      m.positions.erase(v);
      internal::Move_into_kernel_3<Tr> move(m.predicates, m.positions);
      is_seen = move(v, internal::faces_of_ball(cells, v));
      assert(! is_seen || are_seen_now(cells));
    }
    else
    {
      const auto p = m.random_point({ v, v, random_vertex() }, rng);
      m.positions.erase(v);
      m.editor.move(v, typename Mesh::Point(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])));
      is_seen = are_seen_now(cells);
    }
    ++number_of[is_seen ? "vertex moved" : "vertex not moved"];
    if(! is_seen)
    {
      m.positions.erase(v);
      v->set_point(rounded);
      if(had_exact_position)
        m.place(v, before);
    }
    assert(internal::is_mesh_valid(m.tr, m.predicates));
    forget();
  }

  bool are_seen_now(const Cells& cells) const
  {
    Tetrahedra tetrahedra;
    for(const Cell_handle c : cells)
      tetrahedra.push_back(Mesh::tetrahedron(c));
    return m.are_positive(tetrahedra);
  }

  // --- cavities -----------------------------------------------------------------------------------------------------

  struct Surroundings
  {
    std::set<Simplex> outer_faces;
    Tetrahedra star; // from v to these
    Simplex inner_vertices;
  };

  Surroundings surroundings(const Cells& cells, const Vertex_handle v) const
  {
    Surroundings result;
    for(const Cell_handle c : cells)
      for(const Vertex_handle w : Mesh::vertices_of(c))
        result.inner_vertices.insert(w);
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(std::count(cells.begin(), cells.end(), c->neighbor(i)) == 0)
        {
          result.outer_faces.insert(without(Mesh::vertices_of(c), c->vertex(i)));
          Tetrahedron t = Mesh::tetrahedron(c);
          t[static_cast<std::size_t>(i)] = v;
          result.star.push_back(t);
        }
    for(const Simplex& f : result.outer_faces)
      for(const Vertex_handle w : f)
        result.inner_vertices.erase(w);
    return result;
  }

  // Of what is constrained, whatever is a face of a cell, but of no outer face.
  bool is_any_constraint_inside(const Cells& cells, const Surroundings& around) const
  {
    return std::any_of(m.constraints.simplices.begin(), m.constraints.simplices.end(), [&](const Simplex& s)
    {
      return std::any_of(cells.begin(), cells.end(), [&](const Cell_handle c) { return is_in(s, Mesh::vertices_of(c)); })
          && std::none_of(around.outer_faces.begin(), around.outer_faces.end(),
                          [&](const Simplex& f) { return is_in(s, f); });
    });
  }

  Star_obstacle expected_obstacle(const Cells& cells, const Surroundings& around, const Vertex_handle v,
                                  const Vertices& droppable) const
  {
    if(! m.are_positive(around.star))
      return Star_obstacle::HIDDEN_FACE;
    if(is_any_constraint_inside(cells, around))
      return Star_obstacle::CONSTRAINT_INSIDE;
    for(const Vertex_handle w : around.inner_vertices)
      if(w != v && std::count(droppable.begin(), droppable.end(), w) == 0)
        return Star_obstacle::VERTEX_LOST;
    return Star_obstacle::NONE;
  }

  // A union of up to n cells that is connected by facets.
  Cells random_cells(const std::size_t n) const
  {
    Cells cells(1, random_finite_cell());
    for(int trial = 0; trial < 100 && cells.size() < n; ++trial)
    {
      const Cell_handle c = random_item(cells, rng)->neighbor(random_int(rng, 4));
      if(! m.tr.is_infinite(c) && std::count(cells.begin(), cells.end(), c) == 0)
        cells.push_back(c);
    }
    return cells;
  }

  // A few cells, and a vertex in the first one; or a ball, and a vertex near its center or that; and sometimes the
  // cells around them that have two faces in common with them.
  void star_cavity()
  {
    Cells cells;
    Vertices near;
    const Vertex_handle center = random_vertex();
    const bool is_ball = random_int(rng, 3) > 0 && ! m.is_any_infinite(ball(center));
    if(is_ball)
    {
      cells = ball(center);
      near = Vertices(7, center);
    }
    else
      cells = random_cells(static_cast<std::size_t>(1 + random_int(rng, 4)));
    for(const Vertex_handle w : Mesh::tetrahedron(cells.front()))
      near.push_back(w);
    const bool is_vertex_new = ! is_ball || random_int(rng, 2) == 0;
    const Vertex_handle v = is_vertex_new ? m.create_vertex(near, rng) : random_int(rng, 5) == 0 ? near.back() : center;
    if(v == Vertex_handle())
      return;
    if(random_int(rng, 2) == 0)
      add_seen_cells(cells, v);
    Vertices droppable;
    for(const Vertex_handle w : surroundings(cells, v).inner_vertices)
      if(random_int(rng, 3) > 0)
        droppable.push_back(w);
    if(! star(cells, v, droppable, is_vertex_new) && is_vertex_new)
      m.delete_vertex(v);
    forget();
  }

  // Cells beyond faces, as far as v sees all the others of theirs.
  void add_seen_cells(Cells& cells, const Vertex_handle v) const
  {
    const std::size_t n = cells.size();
    for(std::size_t k = 0; k < n; ++k)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle c = cells[k]->neighbor(i);
        if(m.tr.is_infinite(c) || std::count(cells.begin(), cells.end(), c) > 0)
          continue;
        cells.push_back(c);
        if(! m.are_positive(surroundings(cells, v).star))
          cells.pop_back();
      }
  }

  bool star(const Cells& cells, const Vertex_handle v, const Vertices& droppable, const bool is_vertex_new)
  {
    const Surroundings around = surroundings(cells, v);
    const Star_obstacle expected = expected_obstacle(cells, around, v, droppable);
    for_each_kind_of_constraints([&](const auto& constraints)
    {
      internal::Cavity_3<Tr, std::decay_t<decltype(constraints)> > cavity(m.tr, constraints, cells);
      assert(internal::find_obstacle_to_star(cavity, m.predicates, v, droppable) == expected);
      if(droppable.empty())
        assert(internal::find_obstacle_to_star(cavity, m.predicates, v) == expected);
    });
    const std::map<Star_obstacle, std::string> names = { { Star_obstacle::HIDDEN_FACE, "face hidden" },
      { Star_obstacle::CONSTRAINT_INSIDE, "constraint inside" }, { Star_obstacle::VERTEX_LOST, "vertex lost" },
      { Star_obstacle::NONE, "no obstacle" } };
    ++number_of[names.at(expected)];
    if(expected != Star_obstacle::NONE)
      return false;
    Simplex dropped = around.inner_vertices;
    dropped.erase(v);
    number_of["cavity starred, and vertices are gone"] += ! dropped.empty();
    ++number_of[is_vertex_new ? "cavity starred from a new vertex" : "cavity starred from a vertex inside"];
    internal::Cavity_3<Tr, Constraints> cavity(m.tr, m.constraints, cells);
    Expected_change(m, cells, around.star, Vertices(dropped.begin(), dropped.end())).make([&]
    {
      internal::star_cavity(m.editor, cavity, v);
    });
    return true;
  }

  static Simplex without(Simplex s, const Vertex_handle v)
  {
    s.erase(v);
    return s;
  }

  // As far as cells are wanted that are chosen at random, but never through a constrained facet.
  void grow()
  {
    std::set<Cell_handle> wanted;
    for(const Cell_handle c : br3_test::finite_cells(m.tr))
      if(random_int(rng, 4) > 0)
        wanted.insert(c);
    const Cells seeds = random_cells(2);
    std::set<Cell_handle> expected(seeds.begin(), seeds.end());
    Cells open = seeds;
    bool is_constraint_met = false;
    while(! open.empty())
    {
      const Cell_handle c = open.back();
      open.pop_back();
      for(int i = 0; i < 4; ++i)
      {
        const bool is_closed = m.constraints.simplices.count(without(Mesh::vertices_of(c), c->vertex(i))) == 1;
        is_constraint_met |= is_closed;
        if(! is_closed && wanted.count(c->neighbor(i)) == 1 && expected.insert(c->neighbor(i)).second)
          open.push_back(c->neighbor(i));
      }
    }
    for_each_kind_of_constraints([&](const auto& constraints)
    {
      internal::Cavity_3<Tr, std::decay_t<decltype(constraints)> > cavity(m.tr, constraints, seeds);
      internal::grow_where(cavity, [&](const Cell_handle c)
      {
        assert(! m.tr.is_infinite(c));
        return wanted.count(c) == 1;
      });
      assert(cavity.cells().size() == expected.size());
      assert(std::set<Cell_handle>(cavity.cells().begin(), cavity.cells().end()) == expected);
      assert(std::equal(seeds.begin(), seeds.end(), cavity.cells().begin()));
    });
    ++number_of[is_constraint_met ? "cavity grown as far as constraints" : "cavity grown"];
  }

  // The greatest subset of the cells all of whose outer faces v sees: all subsets are looked at.
  void shrink()
  {
    const Cells cells = random_cells(static_cast<std::size_t>(3 + random_int(rng, 8)));
    Vertices near;
    for(const Vertex_handle w : Mesh::tetrahedron(cells.front()))
      near.push_back(w);
    const Vertex_handle v = random_int(rng, 4) == 0 ? random_vertex() : m.create_vertex(near, rng);
    if(v == Vertex_handle())
      return;
    const std::vector<char> is_subset_seen = seen_subsets(cells, v);
    std::size_t greatest = 0;
    for(std::size_t subset = 0; subset < is_subset_seen.size(); ++subset)
      if(is_subset_seen[subset])
        greatest |= subset;
    assert(is_subset_seen[greatest]); // it is one, for the union of two is another one
    const std::size_t number_of_seeds = static_cast<std::size_t>(random_int(rng, 3));
    const std::size_t seeds = (std::size_t(1) << number_of_seeds) - 1;
    Cells expected, shuffled(cells.begin() + static_cast<std::ptrdiff_t>(number_of_seeds), cells.end());
    for(std::size_t k = shuffled.size(); k > 1; --k)
      std::swap(shuffled[k - 1], shuffled[static_cast<std::size_t>(random_int(rng, static_cast<int>(k)))]);
    shuffled.insert(shuffled.begin(), cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(number_of_seeds));
    for(const Cell_handle c : shuffled)
      if((greatest >> (std::find(cells.begin(), cells.end(), c) - cells.begin()) & 1) != 0)
        expected.push_back(c);

    internal::Cavity_3<Tr, Constraints> cavity(m.tr, m.constraints, shuffled);
    const bool is_seen = internal::shrink_until_seen(cavity, v, m.predicates, number_of_seeds);
    assert(is_seen == ((greatest & seeds) == seeds));
    assert(! is_seen || cavity.cells() == expected);
    ++number_of[! is_seen ? "cavity not shrunk" : expected.empty() ? "cavity shrunk to nothing"
                          : expected == shuffled ? "cavity seen" : "cavity shrunk"];
    if(m.cells_with({ v }).empty())
      m.delete_vertex(v);
    forget();
  }

  // By the bits of their cells.
  std::vector<char> seen_subsets(const Cells& cells, const Vertex_handle v) const
  {
    std::vector<std::vector<std::size_t> > behind_hidden_faces(cells.size()); // as bits; zero if it is none of them
    for(std::size_t k = 0; k < cells.size(); ++k)
      for(int i = 0; i < 4; ++i)
        if(! m.are_positive({ Mesh::with_exchanged(cells[k], cells[k]->vertex(i), v) }))
        {
          const auto n = std::find(cells.begin(), cells.end(), cells[k]->neighbor(i));
          behind_hidden_faces[k].push_back(n == cells.end() ? 0 : std::size_t(1) << (n - cells.begin()));
        }
    std::vector<char> result(std::size_t(1) << cells.size(), true);
    for(std::size_t subset = 0; subset < result.size(); ++subset)
      for(std::size_t k = 0; k < cells.size(); ++k)
        if((subset >> k & 1) != 0)
          for(const std::size_t behind : behind_hidden_faces[k])
            result[subset] = result[subset] && (subset & behind) != 0;
    return result;
  }

  // --- constraints --------------------------------------------------------------------------------------------------

  void query_constraints()
  {
    const Vertex_handle v = random_vertex();
    const Cells cells = m.cells_with({ v });
    const bool is_any_at_v = is_any_constraint_at(v);
    std::set<Simplex> expected;
    for(const Simplex& s : m.constraints.simplices)
      if(std::any_of(cells.begin(), cells.end(), [&](const Cell_handle c) { return is_in(s, Mesh::vertices_of(c)); }))
        expected.insert(s);
    for_each_kind_of_constraints([&](const auto& constraints)
    {
      assert(internal::has_constraint_at(constraints, cells, v) == is_any_at_v);
      std::vector<Vertex_pair> edges;
      std::vector<Vertex_triple> facets;
      internal::collect_constraints(constraints, cells, edges, facets);
      std::set<Simplex> found;
      for(const Vertex_pair& e : edges)
        found.insert(Simplex(e.begin(), e.end()));
      for(const Vertex_triple& f : facets)
        found.insert(Simplex(f.begin(), f.end()));
      assert(found == expected);
    });
    ++number_of[is_any_at_v ? "constraint at a vertex" : "no constraint at a vertex"];
  }

  Mesh& m;
  std::mt19937& rng;
  internal::Remove_vertex_3<Tr, br3_test::Change_recorder, Constraints> m_remove;
};

// --- transactions ----------------------------------------------------------------------------------------------------

// What a transaction that is taken back brings back, and what the caller has to.
template <typename Mesh>
struct State
{
  typedef typename Mesh::Vertex_handle  Vertex_handle;

  explicit State(const Mesh& mesh) : constraints(mesh.constraints)
  {
    for(const auto c : mesh.tr.all_cell_handles())
      cells.insert(Mesh::tetrahedron(c));
    for(auto v = mesh.tr.tds().vertices().begin(); v != mesh.tr.tds().vertices().end(); ++v)
      if(v != mesh.tr.infinite_vertex())
      {
        points.emplace(v, v->point());
        if(mesh.positions.contains(v))
          positions.emplace(v, mesh.exact_point(v));
      }
  }

  // Pairs of an old and a new handle.
  template <typename Vertex_pairs>
  void rename(const Vertex_pairs& pairs)
  {
    std::map<Vertex_handle, Vertex_handle> names;
    for(const auto& p : pairs)
      assert(names.emplace(p[0], p[1]).second);
    const auto name = [&](const Vertex_handle v) { return names.count(v) == 1 ? names.at(v) : v; };
    State old = *this;
    cells.clear();
    for(typename Mesh::Tetrahedron t : old.cells)
    {
      std::transform(t.begin(), t.end(), t.begin(), name);
      cells.insert(t);
    }
    constraints.simplices.clear();
    for(const auto& s : old.constraints.simplices)
    {
      typename Mesh::Simplex renamed;
      for(const Vertex_handle v : s)
        renamed.insert(name(v));
      constraints.simplices.insert(renamed);
    }
    points.clear();
    for(const auto& p : old.points)
      assert(points.emplace(name(p.first), p.second).second);
    positions.clear();
    for(const auto& p : old.positions)
      assert(positions.emplace(name(p.first), p.second).second);
  }

  std::multiset<typename Mesh::Tetrahedron> cells; // the order of their vertices counts
  std::map<Vertex_handle, typename Mesh::Point> points;
  std::map<Vertex_handle, typename Mesh::Exact_point> positions;
  typename Mesh::Constraints constraints;
};

// Random changes in nested transactions; the visitor throws now and then.
template <typename Mesh>
class Random_transaction
{
public:
  Random_transaction(Mesh& mesh, Random_change<Mesh>& change, std::mt19937& rng) : m(mesh), m_change(change), rng(rng) { }

  void operator()(const std::size_t depth = 1)
  {
    State<Mesh> before(m);
    m.editor.begin();
    assert(m.editor.journal().depth() == depth);
    const bool is_complete = make_changes(depth);
    number_of["transaction interrupted"] += ! is_complete;
    if(depth > 1 && is_complete && random_int(rng, 2) == 0)
    {
      m.editor.commit();
      ++number_of["transaction committed"];
    }
    else
      undo(before);
    assert(m.editor.journal().depth() == depth - 1);
  }

private:
  bool make_changes(const std::size_t depth)
  {
    try {
      for(int k = 0; k < 8; ++k)
      {
        if(depth < 3 && random_int(rng, 4) == 0)
          (*this)(depth + 1);
        m.recorder.number_of_calls_left = random_int(rng, 15) == 0 ? 1 + random_int(rng, 2) : 0;
        m_change();
        m.recorder.number_of_calls_left = 0;
      }
    } catch(const br3_test::Interruption&) {
      return false;
    }
    return true;
  }

  void undo(State<Mesh>& before)
  {
    for(auto v = m.tr.tds().vertices().begin(); v != m.tr.tds().vertices().end(); ++v)
      m.positions.erase(v);
    br3_test::Change_recorder other;
    const auto renamed = random_int(rng, 2) == 0 ? m.editor.undo() : m.editor.undo(other);
    before.rename(renamed);
    const State<Mesh> now(m);
    assert(now.cells == before.cells && now.points == before.points);
    m.constraints = before.constraints;
    for(const auto& p : before.positions)
      assert(m.place(p.first, p.second));
    assert(internal::is_mesh_valid(m.tr, m.predicates) && m.are_all_constraints_there());
    ++number_of["transaction taken back"];
    number_of["vertex renamed"] += ! renamed.empty();
    m_change.forget();
  }

  Mesh& m;
  Random_change<Mesh>& m_change;
  std::mt19937& rng;
};

// --- all of it in random meshes --------------------------------------------------------------------------------------

br3_test::Lattice_points points(const int kind, std::mt19937& rng)
{
  switch(kind)
  {
    case 0: return br3_test::random_points(25, 64, rng);
    case 1: return br3_test::grid_points(4, 3, 3, 80, rng);
    case 2: return br3_test::ring_points(12, false, false, rng);
    case 3: return br3_test::ring_points(12, true, true, rng); // cocircular, and coplanar
    default: return br3_test::grid_points(5, 4, 2, 100, rng);  // on the hull, all of them
  }
}

template <typename Mesh>
void test_random_changes(const unsigned seed, const int number_of_meshes)
{
  std::mt19937 rng(seed);
  for(int round = 0; round < number_of_meshes; ++round)
  {
    Mesh mesh(points(round % 5, rng), round % 3 == 0 ? 30 : 0, rng);
    if(round % 4 > 0)
      mesh.insert_random_constraints(round % 4 == 1 ? 60 : 20, rng);
    Random_change<Mesh> change(mesh, rng);
    Random_transaction<Mesh> transaction(mesh, change, rng);
    for(int k = 0; k < 30; ++k)
    {
      change();
      if(k % 3 == 0)
        change.ask();
      if(k % 10 == 9)
        transaction();
    }
  }
}

// --- insertion as in Delaunay triangulations -------------------------------------------------------------------------

template <typename Tr>
std::multiset<std::multiset<int> > indices_of_cells(const Tr& tr)
{
  std::multiset<std::multiset<int> > result;
  for(const auto c : tr.all_cell_handles())
    result.insert({ c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info() });
  return result;
}

// The cells whose spheres contain a new point, starred from it, are what the triangulation makes by itself.
template <typename Kernel>
void test_delaunay_insertion(const unsigned seed, const int number_of_meshes)
{
  typedef br3_test::Changing_mesh<Kernel, false>  Mesh;
  typedef typename Mesh::Vertex_handle            Vertex_handle;
  typedef typename Mesh::Cell_handle              Cell_handle;
  std::mt19937 rng(seed);
  for(int round = 0; round < number_of_meshes; ++round)
  {
    Mesh m(points(round % 4, rng), 0, rng);
    for(int k = 0; k < 10; ++k)
    {
      const Cell_handle c = random_item(br3_test::finite_cells(m.tr), rng);
      const int dimension = 1 + random_int(rng, 3);
      typename Mesh::Vertices support;
      for(int i = 0; i <= dimension; ++i)
        support.push_back(c->vertex(i));
      const typename Mesh::Cells cells = m.cells_with(typename Mesh::Simplex(support.begin(), support.end()));
      typename Mesh::Tr copy(m.tr);
      const Vertex_handle v = m.create_vertex(support, rng);
      if(v == Vertex_handle() || m.is_any_infinite(cells))
        continue;
      v->info() = 1000 + k;
      copy.insert(v->point())->info() = v->info();

      internal::Cavity_3<typename Mesh::Tr, typename Mesh::Constraints> cavity(m.tr, m.constraints, { random_item(cells, rng) });
      internal::grow_where(cavity, [&](const Cell_handle d)
      {
        return m.tr.side_of_sphere(d, v->point(), true) == CGAL::ON_BOUNDED_SIDE;
      });
      assert(internal::find_obstacle_to_star(cavity, m.predicates, v) == Star_obstacle::NONE);
      internal::star_cavity(m.editor, cavity, v);
      assert(m.tr.is_valid() && indices_of_cells(m.tr) == indices_of_cells(copy));
      ++number_of["Delaunay insertion"];
    }
  }
}

// --- special polyhedra -----------------------------------------------------------------------------------------------

typedef br3_test::Changing_mesh<K, false>                                     Plain_mesh;
typedef internal::Remove_vertex_3<Plain_mesh::Tr, br3_test::Change_recorder, Plain_mesh::Constraints>  Remove_vertex;

Plain_mesh::Tetrahedra positive(const Plain_mesh& mesh, Plain_mesh::Tetrahedra tetrahedra)
{
  for(Plain_mesh::Tetrahedron& t : tetrahedra)
    if(mesh.volume(t) < 0)
      std::swap(t[0], t[1]);
  return tetrahedra;
}

// The ball of a vertex is the polyhedron of Schoenhardt: without it, there are no cells that fill it. With the cells
// next to it, there are, unless all three diagonals that make it are constrained.
void test_vertex_that_cannot_go(const std::size_t number_of_constraints)
{
  std::mt19937 rng(5);
  Plain_mesh m({ { 1000, 0, 0 }, { -500, 866, 0 }, { -500, -866, 0 },
                 { 866, 500, 1500 }, { -866, 500, 1500 }, { 0, -1000, 1500 } }, 0, rng);
  const Plain_mesh::Vertices p = br3_test::finite_vertices(m.tr);
  const Plain_mesh::Vertex_handle v = m.editor.create_vertex(Plain_mesh::Point(0, 0, 750));
  Plain_mesh::Tetrahedra tetrahedra = { {{ p[0], p[1], p[2], v }}, {{ p[3], p[4], p[5], v }} };
  for(std::size_t k = 0; k < 3; ++k)
  {
    const Plain_mesh::Vertex_handle a = p[k], b = p[(k + 1) % 3], c = p[3 + (k + 1) % 3], d = p[3 + k];
    tetrahedra.insert(tetrahedra.end(), { {{ a, b, c, d }}, {{ a, b, c, v }}, {{ a, c, d, v }} });
    if(k < number_of_constraints)
      m.constraints.insert({ a, c });
  }
  tetrahedra = positive(m, tetrahedra);
  const Plain_mesh::Cells cells = br3_test::finite_cells(m.tr);
  br3_test::Expected_change<Plain_mesh>(m, cells, tetrahedra).make([&] { m.editor.replace(cells, tetrahedra); });

  Remove_vertex remove(m.editor, m.predicates, m.constraints);
  const Plain_mesh::Cells ball = m.cells_with({ v });
  assert(ball.size() == 8 && ! remove.find(ball, v));
  for(const Plain_mesh::Vertex_handle x : p)
    assert(! internal::is_ball_seen(m.predicates, ball, v, x));
  const bool is_found = remove.find_with_layer(ball, v);
  assert(is_found == (number_of_constraints < 3));
  if(is_found)
    br3_test::Expected_change<Plain_mesh>(m, remove.cells(), remove.tetrahedra(), { v }).make([&] { remove(v); });
  ++number_of[is_found ? "Schoenhardt's polyhedron with a layer" : "Schoenhardt's polyhedron"];
}

// Of the two ways to fill a bipyramid, only the other one is left when its apex has moved.
void test_search_after_move()
{
  std::mt19937 rng(5);
  Plain_mesh m({ { 10, 0, 0 }, { -5, 9, 0 }, { -5, -9, 0 }, { 0, 0, 30 }, { 0, 0, -30 }, { 0, 0, 0 } }, 0, rng);
  const Plain_mesh::Vertices p = br3_test::finite_vertices(m.tr);
  const Plain_mesh::Cells ball = m.cells_with({ p[5] });
  assert(ball.size() == 6 && m.tr.number_of_finite_cells() == 6);
  Remove_vertex remove(m.editor, m.predicates, m.constraints);
  assert(remove.find_with_layer(ball, p[5]));
  const std::size_t number_of_tetrahedra = remove.tetrahedra().size();
  assert(number_of_tetrahedra == 2 || number_of_tetrahedra == 3);
  if(number_of_tetrahedra == 2)
  {
    m.editor.move(p[3], Plain_mesh::Point(0, 0, -2));
    m.editor.move(p[5], Plain_mesh::Point(0, 0, -5));
  }
  else
    m.editor.move(p[3], Plain_mesh::Point(30, 0, 30));
  remove.forget();
  assert(remove.find_with_layer(ball, p[5]));
  assert(remove.tetrahedra().size() == 5 - number_of_tetrahedra && m.are_positive(remove.tetrahedra()));
}

int main()
{
  test_random_changes<Plain_mesh>(1, 40);
  test_random_changes<br3_test::Changing_mesh<K, true> >(2, 20);
  test_random_changes<br3_test::Changing_mesh<EK, false> >(3, 5);
  test_delaunay_insertion<K>(4, 20);
  test_delaunay_insertion<EK>(5, 4);
  for(const std::size_t number_of_constraints : { 0, 1, 3 })
    test_vertex_that_cannot_go(number_of_constraints);
  test_search_after_move();

  for(const char* kind : { "shell not seen", "shell seen from the edge", "shell seen from elsewhere", "edge split",
                           "edge split on the hull", "constrained edge split", "facet split",
                           "facet split on the hull", "facet split from elsewhere", "constrained facet split",
                           "ball seen", "ball not seen", "edge collapsed", "edge collapsed next to a constraint",
                           "vertex removed by collapse", "vertex removed by reconnection", "vertex not removed",
                           "vertex removed with a layer", "vertex not removed with a layer", "vertex moved",
                           "vertex not moved", "face hidden", "constraint inside", "vertex lost", "no obstacle",
                           "cavity starred from a new vertex", "cavity starred from a vertex inside",
                           "cavity starred, and vertices are gone", "cavity grown as far as constraints",
                           "cavity grown", "cavity not shrunk", "cavity shrunk to nothing", "cavity seen",
                           "cavity shrunk", "constraint at a vertex", "no constraint at a vertex",
                           "transaction interrupted", "transaction committed", "transaction taken back",
                           "vertex renamed", "Delaunay insertion", "Schoenhardt's polyhedron",
                           "Schoenhardt's polyhedron with a layer" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 0);
  }
  std::cout << "done" << std::endl;
}
