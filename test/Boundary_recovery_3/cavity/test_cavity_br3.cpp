// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Sets of cells that are to be replaced, what is around them and how they grow, against definitions.

#undef NDEBUG

#include "tetrahedralizations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Growing_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

typedef BR::internal::Constraints_3<Tr>   Constraints;
typedef BR::internal::Cavity_3<Tr>        Cavity;
typedef std::vector<Vertex_handle>        Vertices;
typedef std::set<Vertex_handle>           Vertex_set;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

Cells star(const Tr& tr, const Vertex_handle v)
{
  Cells result;
  tr.incident_cells(v, std::back_inserter(result));
  return result;
}

Vertex_handle random_finite_vertex(const Tr& tr, std::mt19937& rng)
{
  auto v = tr.finite_vertices_begin();
  std::advance(v, random_int(rng, static_cast<int>(tr.number_of_vertices())));
  return v;
}

// About one of n facets of the mesh.
Constraints random_facets(const Tr& tr, const int n, std::mt19937& rng)
{
  Constraints constraints;
  for(const Cell_handle c : tr.finite_cell_handles()) // facets come in an order that depends on addresses
    for(int i = 0; i < 4; ++i)
      if(random_int(rng, 2 * n) == 0)
        constraints.insert(c->vertex((i + 1) % 4), c->vertex((i + 2) % 4), c->vertex((i + 3) % 4));
  return constraints;
}

// The facets of the cells that have none of them behind them, and the vertices behind those that are open.
std::map<std::set<Vertex_handle>, Vertex_handle> boundary(const Tr& tr, const Cells& cells,
                                                          const Constraints& constraints)
{
  std::map<std::set<Vertex_handle>, Vertex_handle> result;
  for(const Cell_handle c : cells)
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle n = c->neighbor(i);
      if(BR::internal::contains(cells, n))
        continue;
      const Facet f = {{ c->vertex((i + 1) % 4), c->vertex((i + 2) % 4), c->vertex((i + 3) % 4) }};
      const bool is_closed = tr.is_infinite(n) || constraints.is_constrained(f[0], f[1], f[2]);
      result[{ f[0], f[1], f[2] }] = is_closed ? Vertex_handle() : tr.mirror_vertex(c, i);
    }
  return result;
}

// Grows by random vertices, and compares with what that is by definition. Returns the number of these.
int test_spanned_cavity(const unsigned seed, const bool on_grid)
{
  std::mt19937 rng(seed);
  Tr tr;
  for(int i = 0; i < 80; ++i)
    tr.insert(random_point(rng, on_grid));
  const Constraints constraints = random_facets(tr, 6, rng);
  int number_of_additions = 0;
  Cavity cavity(tr, constraints);
  for(const Vertex_handle v : tr.finite_vertex_handles())
  {
    const Cells cells = star(tr, v);
    if(std::any_of(cells.begin(), cells.end(), [&](const Cell_handle c) { return tr.is_infinite(c); }))
      continue;
    std::set<Vertex_handle> vertices;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        vertices.insert(c->vertex(i));
    cavity.clear();
    for(const Cell_handle c : cells)
      cavity.add(c);
    BR::internal::add_spanned_cells(cavity);
    for(int step = 0; step < 5; ++step)
    {
      assert(std::set<Cell_handle>(cavity.cells().begin(), cavity.cells().end()).size() == cavity.cells().size());
      assert(cavity.vertices().size() == vertices.size());
      const auto expected = boundary(tr, cavity.cells(), constraints);
      assert(cavity.boundary().size() == expected.size());
      std::map<Vertex_handle, int> numbers;
      for(const auto& f : cavity.boundary())
      {
        assert(expected.at({ f.face[0], f.face[1], f.face[2] }) == f.vertex_behind);
        assert(cavity.contains(f.cell) && f.cell->has_neighbor(f.cell_behind) && ! cavity.contains(f.cell_behind));
        assert(vertices.count(f.vertex_behind) == 0); // else there was one more cell to add
        ++numbers[f.vertex_behind];
      }
      numbers.erase(Vertex_handle());
      const Vertices behind = BR::internal::vertices_behind(cavity);
      assert(behind.size() == numbers.size());
      assert(std::is_sorted(behind.begin(), behind.end(),
                            [&](const Vertex_handle x, const Vertex_handle y) { return numbers[x] > numbers[y]; }));
      for(const Cell_handle c : cavity.cells())
        for(int i = 0; i < 4; ++i)
          assert(vertices.count(c->vertex(i)) == 1);
      if(behind.empty())
        break;
      const Vertex_handle x = behind[random_int(rng, static_cast<int>(behind.size()))];
      vertices.insert(x);
      BR::internal::add_spanning_vertex(cavity, x);
      ++number_of_additions;
    }
  }
  return number_of_additions;
}

// The facets of some cells, each with the number of cells that have it.
std::map<Vertex_set, int> facets_of(const Cells& cells)
{
  std::map<Vertex_set, int> result;
  for(const Cell_handle c : cells)
    for(int i = 0; i < 4; ++i)
      ++result[{ c->vertex((i + 1) % 4), c->vertex((i + 2) % 4), c->vertex((i + 3) % 4) }];
  return result;
}

// Whether some simplex that is inside the cells, and on none of their outer facets, is a constraint.
bool has_constraint_inside(const Cells& cells, const Constraints& constraints)
{
  Edges edges;
  Facets facets;
  BR::internal::collect_constraints(constraints, cells, edges, facets);
  const std::map<Vertex_set, int> number_of_cells = facets_of(cells);
  const auto is_inside = [&](const auto& simplex)
  {
    return std::none_of(number_of_cells.begin(), number_of_cells.end(), [&](const auto& f)
    {
      return f.second == 1 && std::all_of(simplex.begin(), simplex.end(),
                                          [&](const Vertex_handle v) { return f.first.count(v) == 1; });
    });
  };
  return std::any_of(edges.begin(), edges.end(), is_inside) || std::any_of(facets.begin(), facets.end(), is_inside);
}

// The boundary of random cells, with some of the vertices as points that may be inside.
void test_boundary(const Tr& tr, const Constraints& constraints, std::mt19937& rng)
{
  Cells cells = random_cavity(tr, rng, 1 + random_int(rng, 8));
  if(random_int(rng, 2) == 0)
    for(const Cell_handle c : star(tr, random_finite_vertex(tr, rng)))
      if(! tr.is_infinite(c) && ! BR::internal::contains(cells, c))
        cells.push_back(c);
  Cavity cavity(tr, constraints, cells);
  cavity.add(cells.back());
  cavity.add(tr.infinite_cell());
  assert(cavity.cells() == cells); // both were refused

  Vertex_set inside, points;
  for(const Cell_handle c : cells)
    for(int i = 0; i < 4; ++i)
      inside.insert(c->vertex(i));
  std::map<Vertex_set, int> expected = facets_of(cells);
  for(auto f = expected.begin(); f != expected.end(); )
    if(f->second == 1)
    {
      for(const Vertex_handle v : f->first)
        inside.erase(v);
      ++f;
    }
    else
      f = expected.erase(f);
  for(const Vertex_handle v : tr.finite_vertex_handles())
    if(random_int(rng, 2) == 0)
      points.insert(v);

  Facets faces;
  Vertices found;
  const bool is_found = cavity.collect_boundary(Vertices(points.begin(), points.end()), faces, found);
  const bool are_points_inside = std::includes(points.begin(), points.end(), inside.begin(), inside.end());
  const bool is_free = ! has_constraint_inside(cells, constraints);
  assert(is_found == (are_points_inside && is_free));
  ++number_of[is_found ? "boundary" : is_free ? "other vertex inside" : "constraint inside"];
  if(! is_found)
    return;
  assert(faces.size() == expected.size() && Vertex_set(found.begin(), found.end()) == inside);
  assert(found.size() == inside.size());
  number_of["vertex inside"] += ! inside.empty();
  for(const Facet& f : faces)
    assert(expected.count({ f[0], f[1], f[2] }) == 1);
}

// Until a vertex sees all the faces from inside: it starts with a cell, and the point is anywhere.
void test_growth(Tr& tr, const Constraints& constraints, std::mt19937& rng)
{
  const Predicates predicates(tr);
  const std::size_t max_number_of_cells = 1 + random_int(rng, 30);
  Cavity cavity(tr, constraints, random_cavity(tr, rng, 1 + random_int(rng, 3)));
  const Cells start = cavity.cells();
  const Vertex_handle v = tr.tds().create_vertex();
  v->set_point(CGAL::midpoint(start[0]->vertex(0)->point(), random_finite_vertex(tr, rng)->point()));
  const bool is_seen = BR::internal::grow_until_seen(cavity, v, predicates, max_number_of_cells);
  assert(std::equal(start.begin(), start.end(), cavity.cells().begin()));
  assert(cavity.cells().size() <= (std::max)(max_number_of_cells, start.size()));
  bool sees_all = true, is_end_found = false; // where growth ends
  for(const Cell_handle c : cavity.cells())
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle n = c->neighbor(i);
      if(BR::internal::contains(cavity.cells(), n))
        continue;
      Tetrahedron t = {{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }};
      t[static_cast<std::size_t>(i)] = v;
      const bool is_face_seen = volume(t) > 0;
      sees_all = sees_all && is_face_seen;
      const Facet f = {{ c->vertex((i + 1) % 4), c->vertex((i + 2) % 4), c->vertex((i + 3) % 4) }};
      const bool is_end = tr.is_infinite(n) || constraints.is_constrained(f[0], f[1], f[2])
                       || cavity.cells().size() >= max_number_of_cells;
      is_end_found = is_end_found || (! is_face_seen && is_end);
    }
  assert(is_seen == sees_all && (is_seen || is_end_found));
  ++number_of[is_seen ? "seen" : "not seen"];
  number_of["seen after growth"] += is_seen && cavity.cells().size() > start.size();
  tr.tds().delete_vertex(v);
}

void test_cavities(const unsigned seed, const bool on_grid)
{
  std::mt19937 rng(seed);
  Tr tr;
  for(int i = 0; i < 50; ++i)
    tr.insert(random_point(rng, on_grid));
  const Constraints none, few = random_facets(tr, 20, rng);
  for(int k = 0; k < 300; ++k)
  {
    test_boundary(tr, k % 2 == 0 ? none : few, rng);
    test_growth(tr, k % 2 == 0 ? none : few, rng);
  }
}

bool is_constrained(const Constraints& constraints, const Vertex_set& simplex)
{
  const Vertices v(simplex.begin(), simplex.end());
  return v.size() == 2 ? constraints.is_constrained(v[0], v[1]) : constraints.is_constrained(v[0], v[1], v[2]);
}

// What is around and inside of a cavity, by definition.
void check_surroundings(Cavity& cavity, const Tr& tr, const Constraints& constraints)
{
  const auto expected = boundary(tr, cavity.cells(), constraints);
  assert(cavity.boundary().size() == expected.size());
  Vertex_set outer_vertices;
  std::set<Vertex_set > outer_simplices;
  for(const auto& f : cavity.boundary())
  {
    assert(expected.at({ f.face[0], f.face[1], f.face[2] }) == f.vertex_behind);
    outer_vertices.insert(f.face.begin(), f.face.end());
    outer_simplices.insert({ f.face[0], f.face[1], f.face[2] });
    for(int k = 0; k < 3; ++k)
      outer_simplices.insert({ f.face[k], f.face[(k + 1) % 3] });
  }
  Vertex_set vertices;
  bool has_constraint_inside = false;
  for(const Cell_handle c : cavity.cells())
    for(int mask = 1; mask < 15; ++mask) // the faces of a cell
    {
      Vertex_set face;
      for(int i = 0; i < 4; ++i)
        if((mask >> i & 1) != 0)
          face.insert(c->vertex(i));
      if(face.size() == 1)
        vertices.insert(*face.begin());
      else
        has_constraint_inside |= is_constrained(constraints, face) && outer_simplices.count(face) == 0;
    }
  assert(cavity.vertices().size() == vertices.size());
  assert(cavity.has_constraint_inside() == has_constraint_inside);
  const Vertices inner = cavity.inner_vertices();
  assert(inner.size() + outer_vertices.size() == vertices.size());
  for(const Vertex_handle v : inner)
    assert(outer_vertices.count(v) == 0);
  ++number_of[has_constraint_inside ? "constraint inside" : "no constraint inside"];
  number_of["inner vertex of a cavity"] += ! inner.empty();
}

// Cells are added and taken out again.
void test_shrinking_cavity()
{
  std::mt19937 rng(29);
  Tr tr;
  for(int i = 0; i < 60; ++i)
    tr.insert(random_point(rng, false));
  const Constraints constraints = random_facets(tr, 50, rng);
  for(int round = 0; round < 30; ++round)
  {
    Cavity cavity(tr, constraints, random_cavity(tr, rng, 3));
    const std::size_t max_number_of_vertices = 10 + random_int(rng, 50);
    for(int layer = 0; layer < 3; ++layer)
      BR::internal::add_layer(cavity, max_number_of_vertices);
    assert(cavity.vertices().size() <= max_number_of_vertices);
    Cells expected = cavity.cells();
    for(int step = 0; step < 20; ++step)
    {
      const Cell_handle c = expected[random_int(rng, static_cast<int>(expected.size()))];
      cavity.remove(c);
      assert(! cavity.contains(c));
      expected.erase(std::find(expected.begin(), expected.end(), c));
      if(step % 3 == 0 || expected.empty())
      {
        assert(cavity.add(c) && cavity.add(c) && cavity.contains(c));
        expected.push_back(c);
      }
      assert(cavity.cells() == expected);
      check_surroundings(cavity, tr, constraints);
    }
    assert(! cavity.add(tr.infinite_cell()) && cavity.cells() == expected);
  }
}

int main()
{
  for(const bool on_grid : { true, false })
  {
    test_cavities(7, on_grid);
    number_of["vertex added"] += test_spanned_cavity(on_grid ? 19 : 21, on_grid);
  }
  test_shrinking_cavity();
  for(const char* kind : { "boundary", "other vertex inside", "constraint inside", "no constraint inside",
                           "inner vertex of a cavity", "vertex inside", "seen", "not seen",
                           "seen after growth", "vertex added" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 10);
  }
  std::cout << "done" << std::endl;
}
