// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The simplices of cells, constraints among them, cells in the place of others, and valid meshes: against definitions.

#undef NDEBUG

#include "tetrahedralizations_br3.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef std::vector<Vertex_handle>      Vertices;
typedef std::set<Vertex_handle>         Vertex_set;
typedef internal::Constraints_3<Tr>     Constraints;

template <typename Simplex>
Vertex_set set_of(const Simplex& s) { return Vertex_set(s.begin(), s.end()); }

Vertex_set vertices_of(const Cell_handle c)
{
  return { c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) };
}

// As many as there are, each as the set of its vertices.
std::multiset<Vertex_set> sets_of(const Tetrahedra& tetrahedra)
{
  std::multiset<Vertex_set> result;
  for(const Tetrahedron& t : tetrahedra)
    result.insert(set_of(t));
  return result;
}

// Three times the numbers of a small grid: the centers of facets are integers.
void insert_points(Tr& tr, const int n, std::mt19937& rng)
{
  for(int i = 0; i < n; ++i)
  {
    const Point p = random_point(rng, true);
    tr.insert(Point(3 * p.x(), 3 * p.y(), 3 * p.z()));
  }
  assert(tr.dimension() == 3);
}

void test_facets_of_cells(const Tr& tr)
{
  for(const Cell_handle c : tr.all_cell_handles())
    for(int i = 0; i < 4; ++i)
    {
      const Facet f = internal::facet_vertices(c, i);
      Vertex_set expected = vertices_of(c);
      expected.erase(c->vertex(i));
      assert(set_of(f) == expected);
      assert(tr.is_infinite(c) || volume({{ f[0], f[1], f[2], c->vertex(i) }}) > 0);
      assert(internal::has_vertices(c, f) && internal::index_of_opposite_vertex(c, f) == i);
      for(const Cell_handle other : tr.finite_cell_handles())
      {
        const Vertex_set vertices = vertices_of(other);
        assert(internal::has_vertices(other, f)
               == std::includes(vertices.begin(), vertices.end(), expected.begin(), expected.end()));
      }
    }
}

void test_numbers_of_cells(const Tr& tr)
{
  assert(internal::number_of_finite_cells(tr) == tr.number_of_finite_cells());
  assert(internal::number_of_finite_cells(Tr()) == 0);
}

// A half of the facets, and some that are in no cell, are looked for: what is found is what is there, each once.
void test_search_of_facets(const Tr& tr, std::mt19937& rng)
{
  internal::Simplex_index_3<Vertex_handle, 3> table;
  std::set<Vertex_set> all, expected;
  for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
  {
    const Facet facet = internal::facet_vertices(f->first, f->second);
    all.insert(set_of(facet));
    if(rng() % 2 == 0)
    {
      table.insert(facet);
      expected.insert(set_of(facet));
    }
  }
  const std::vector<Vertex_handle> vertices(tr.finite_vertex_handles().begin(), tr.finite_vertex_handles().end());
  for(std::size_t k = 2; k < vertices.size(); ++k)
  {
    const Facet facet = {{ vertices[k - 2], vertices[k - 1], vertices[k] }};
    if(all.count(set_of(facet)) == 0)
      table.insert(facet);
  }
  internal::Facet_filter_3<Vertex_handle> filter(table.size());
  for(const Facet& f : table.keys())
    filter.insert(f);
  std::set<Vertex_set> found;
  internal::find_facets(tr.all_cell_handles(), filter, table, [&](const std::size_t k, const Cell_handle c, const int i)
  {
    assert(set_of(internal::facet_vertices(c, i)) == set_of(table.keys()[k]));
    assert(found.insert(set_of(table.keys()[k])).second);
  });
  assert(found == expected && expected.size() > 10);
}

// The cells around a vertex, its neighbors, and the faces that it sees.
void test_balls(const Tr& tr)
{
  for(const Vertex_handle v : tr.finite_vertex_handles())
  {
    Cells star;
    tr.incident_cells(v, std::back_inserter(star));
    Vertices neighbors;
    tr.adjacent_vertices(v, std::back_inserter(neighbors));
    const Vertices found = internal::vertices_without(star, v);
    assert(found.size() == neighbors.size() && set_of(found) == set_of(neighbors));

    const auto faces = internal::faces_of_star(star, v);
    assert(faces.size() == star.size());
    for(std::size_t k = 0; k < star.size(); ++k)
    {
      Vertex_set expected = vertices_of(star[k]);
      expected.erase(v);
      assert(set_of(faces[k]) == expected);
      assert(tr.is_infinite(star[k]) || volume({{ faces[k][0], faces[k][1], faces[k][2], v }}) > 0);
    }
  }
}

std::set<Vertex_set> outer_facets(const Cells& cells)
{
  std::map<Vertex_set, int> number_of_cells;
  for(const Cell_handle c : cells)
    for(int i = 0; i < 4; ++i)
    {
      Vertex_set f = vertices_of(c);
      f.erase(c->vertex(i));
      ++number_of_cells[f];
    }
  std::set<Vertex_set> result;
  for(const auto& f : number_of_cells)
    if(f.second == 1)
      result.insert(f.first);
  return result;
}

void test_outer_facets(const Cells& cells)
{
  std::set<Vertex_set> found;
  internal::for_each_outer_facet(cells, [&](const Cell_handle c, const int i)
  {
    assert(std::find(cells.begin(), cells.end(), c) != cells.end());
    assert(found.insert(set_of(internal::facet_vertices(c, i))).second);
  });
  assert(found == outer_facets(cells));
}

void test_exchanged_vertices(const Tr& tr)
{
  const Vertex_handle x = tr.infinite_vertex();
  for(const Cell_handle c : tr.finite_cell_handles())
    for(int i = 0; i < 4; ++i)
    {
      const Tetrahedron t = internal::with_exchanged_vertex(c, c->vertex(i), x);
      for(int k = 0; k < 4; ++k)
        assert(t[static_cast<std::size_t>(k)] == (k == i ? x : c->vertex(k)));
    }
}

// Against maps of what was inserted.
void test_constraints(const Tr& tr, std::mt19937& rng)
{
  Constraints constraints;
  std::map<Vertex_set, std::size_t> edges, facets;
  const Vertices vertices(tr.finite_vertex_handles().begin(), tr.finite_vertex_handles().end());
  const auto random_vertex = [&] { return vertices[random_int(rng, static_cast<int>(vertices.size()))]; };
  const auto expected_index = [](const std::map<Vertex_set, std::size_t>& simplices, const Vertex_set& s)
  {
    const auto it = simplices.find(s);
    return it == simplices.end() ? Constraints::none : it->second;
  };
  for(int k = 0; k < 500; ++k)
  {
    const Vertex_handle u = random_vertex(), v = random_vertex(), w = random_vertex();
    if(u == v || v == w || w == u)
      continue;
    assert(constraints.index(u, v) == expected_index(edges, { u, v }));
    assert(constraints.index(u, v, w) == expected_index(facets, { u, v, w }));
    assert(constraints.is_constrained(u, v) == (edges.count({ u, v }) == 1));
    assert(constraints.is_constrained(u, v, w) == (facets.count({ u, v, w }) == 1));
    if(k % 3 == 0)
    {
      const std::size_t f = facets.emplace(Vertex_set{ u, v, w }, facets.size()).first->second;
      for(const Edge& e : { Edge{{ u, v }}, Edge{{ v, w }}, Edge{{ w, u }} })
        edges.emplace(set_of(e), edges.size());
      assert(constraints.insert(u, v, w) == f);
      for(const std::size_t e : constraints.edges_of_facet(f))
        for(const Vertex_handle x : constraints.edges()[e])
          assert(x == u || x == v || x == w);
    }
    else if(k % 3 == 1)
      assert(constraints.insert(u, v) == edges.emplace(Vertex_set{ u, v }, edges.size()).first->second);
    assert(constraints.edges().size() == edges.size() && constraints.facets().size() == facets.size());
  }
  for(const auto& e : edges)
    assert(set_of(constraints.edges()[e.second]) == e.first);
  for(const auto& f : facets)
    assert(set_of(constraints.facets()[f.second]) == f.first);

  Edges found_edges;
  Facets found_facets;
  internal::collect_constraints(constraints, tr.all_cell_handles(), found_edges, found_facets);
  std::set<Vertex_set> in_mesh, found;
  for(const auto& e : tr.finite_edges())
    in_mesh.insert({ e.first->vertex(e.second), e.first->vertex(e.third) });
  for(const auto& f : tr.finite_facets())
    in_mesh.insert(set_of(internal::facet_vertices(f.first, f.second)));
  for(const Edge& e : found_edges)
    found.insert(set_of(e));
  for(const Facet& f : found_facets)
    found.insert(set_of(f));
  for(const Vertex_set& s : in_mesh)
    assert(found.count(s) == (s.size() == 2 ? edges : facets).count(s));
  assert(std::includes(in_mesh.begin(), in_mesh.end(), found.begin(), found.end()));
}

// Knows the cells of the mesh from what it is told.
struct Mirror
  : public CGAL::Default_meshing_visitor_3
{
  explicit Mirror(const Tr& tr) : cells(tr.all_cell_handles().begin(), tr.all_cell_handles().end()) { }

  template <typename CellRange>
  void before_cells_removal(const CellRange& removed)
  {
    for(const Cell_handle c : removed)
      assert(cells.erase(c) == 1);
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& created) { cells.insert(created.begin(), created.end()); }

  std::set<Cell_handle> cells;
};

void check_mesh(const Tr& tr, const Mirror& mirror)
{
  assert(tr.tds().is_valid());
  assert(std::set<Cell_handle>(tr.all_cell_handles().begin(), tr.all_cell_handles().end()) == mirror.cells);
}

// A new vertex is joined with all the faces of a cavity, and dropped when the cells come back. Returns false if the
// cavity is not made of cells each of which has one more vertex: such a cavity is certainly a ball.
bool test_replacement(Tr& tr, std::mt19937& rng)
{
  internal::Replace_cells<Tr> replace;
  Mirror mirror(tr);
  const Cells cells = random_cavity(tr, rng, 1 + random_int(rng, 12));
  const Tetrahedra before = tetrahedra_of(cells);
  const std::multiset<Vertex_set> all_before = sets_of(tetrahedra_of(finite_cells(tr)));
  const std::size_t number_of_vertices = tr.number_of_vertices();
  if(internal::vertices_without(cells, Vertex_handle()).size() != 3 + cells.size())
    return false;
  Tetrahedra cone;
  const Vertex_handle v = tr.tds().create_vertex();
  v->set_point(before[0][0]->point()); // the replacement does not look at points
  internal::for_each_outer_facet(cells, [&](const Cell_handle c, const int i)
  {
    cone.push_back(internal::with_exchanged_vertex(c, c->vertex(i), v));
  });
  replace(tr, cells, cone, mirror);
  check_mesh(tr, mirror);
  assert(replace.new_cells().size() == cone.size() && tr.number_of_vertices() == number_of_vertices + 1);
  for(std::size_t k = 0; k < cone.size(); ++k)
    for(int i = 0; i < 4; ++i)
      assert(replace.new_cells()[k]->vertex(i) == cone[k][i]);

  const Cells new_cells(replace.new_cells().begin(), replace.new_cells().end());
  replace(tr, new_cells, before, mirror, Vertices(1, v));
  check_mesh(tr, mirror);
  assert(tr.number_of_vertices() == number_of_vertices);
  assert(sets_of(tetrahedra_of(finite_cells(tr))) == all_before);
  return true;
}

// A mesh is valid iff its cells are positive and fill the convex hull, the cells of a triangulation that CGAL makes.
bool is_valid(const Tr& tr)
{
  Number sum = 0;
  Tr delaunay;
  for(const Cell_handle c : tr.finite_cell_handles())
  {
    const Number v = volume({{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }});
    if(v <= 0)
      return false;
    sum += v;
  }
  for(const Vertex_handle v : tr.finite_vertex_handles())
    delaunay.insert(v->point());
  return delaunay.dimension() == 3 && total_volume(tetrahedra_of(finite_cells(delaunay))) == sum;
}

// One vertex after the other is moved away, and back.
void test_validity(const Tr& tr, std::mt19937& rng, std::map<bool, int>& number_of)
{
  const Predicates predicates(tr);
  assert(internal::is_mesh_valid(tr, predicates) && is_valid(tr));
  for(const Vertex_handle v : tr.finite_vertex_handles())
  {
    const Point old = v->point();
    v->set_point(Point(old.x() + random_int(rng, 5) - 2, old.y() + random_int(rng, 5) - 2, old.z()));
    const bool expected = is_valid(tr);
    assert(internal::is_mesh_valid(tr, predicates) == expected);
    for(const Cell_handle c : tr.finite_cell_handles())
      assert(internal::is_positive(predicates, c) == (volume(tetrahedra_of(Cells(1, c))[0]) > 0));
    ++number_of[expected];
    v->set_point(old);
  }
}

int main()
{
  std::map<bool, int> number_of; // of valid and other meshes
  int number_of_replacements = 0;
  for(const unsigned seed : { 1u, 2u, 3u, 4u })
  {
    std::mt19937 rng(seed);
    Tr tr;
    insert_points(tr, 12 + 8 * static_cast<int>(seed), rng);
    test_facets_of_cells(tr);
    test_numbers_of_cells(tr);
    test_search_of_facets(tr, rng);
    test_balls(tr);
    for(int k = 0; k < 40; ++k)
    {
      test_outer_facets(random_cavity(tr, rng, 1 + k / 2));
      test_exchanged_vertices(tr);
      number_of_replacements += test_replacement(tr, rng);
    }
    test_constraints(tr, rng);
    test_validity(tr, rng, number_of);
  }
  assert(number_of_replacements > 40);
  assert(number_of[true] > 10 && number_of[false] > 10);
  std::cout << "done" << std::endl;
}
