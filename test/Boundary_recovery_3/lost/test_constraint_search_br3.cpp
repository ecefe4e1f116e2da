// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The search for lost constraints, against the triangulation's own answers.

#undef NDEBUG

#include "random_triangulations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cassert>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Vertex_handle                                   Vertex_handle;
typedef K::Point_3                                          Point_3;

// So many that the search looks at the link of this vertex.
void insert_many_at_one_vertex(internal::Constraints_3<Tr>& constraints, const std::vector<Vertex_handle>& vertices)
{
  for(std::size_t i = 2; i < vertices.size(); ++i)
  {
    constraints.insert(vertices[0], vertices[i]);
    constraints.insert(vertices[i - 1], vertices[0], vertices[i]);
  }
}

// Facets that are in the mesh, in any order of their vertices, and edges and facets by chance.
internal::Constraints_3<Tr> random_constraints(const Tr& tr, const std::size_t vertices_per_lost_one, std::mt19937& rng)
{
  std::vector<Vertex_handle> vertices;
  for(const Vertex_handle v : tr.finite_vertex_handles())
    vertices.push_back(v);
  const auto random_vertex = [&]
  {
    return vertices[static_cast<std::size_t>(br3_test::random_int(rng, static_cast<int>(vertices.size())))];
  };
  internal::Constraints_3<Tr> constraints;
  for(const auto& f : tr.finite_facets())
    if(br3_test::random_int(rng, 4) == 0)
    {
      const int first = br3_test::random_int(rng, 3), step = 1 + br3_test::random_int(rng, 2);
      const auto v = internal::facet_vertices(f.first, f.second);
      constraints.insert(v[first], v[(first + step) % 3], v[(first + 2 * step) % 3]);
    }
  for(std::size_t i = 0; i < vertices.size(); i += vertices_per_lost_one)
  {
    const Vertex_handle u = random_vertex(), v = random_vertex(), w = random_vertex();
    if(u == v || v == w || w == u)
      continue;
    constraints.insert(u, v);
    if(i % 3 == 0)
      constraints.insert(u, v, w);
  }
  if(vertices_per_lost_one == 1)
    insert_many_at_one_vertex(constraints, vertices);
  return constraints;
}

// Against the triangulation's own answers: all constraints, and some of them.
void check_constraint_search(const Tr& tr, const internal::Constraints_3<Tr>& constraints,
                             internal::Constraint_search_3<Tr>& search, std::mt19937& rng)
{
  internal::Lost_constraints expected, some, expected_of_some;
  typedef std::vector<std::size_t> internal::Lost_constraints::* Kind;
  const auto expect = [&](const Kind kind, const auto& simplices, const auto& is_in_mesh)
  {
    for(std::size_t s = 0; s < simplices.size(); ++s)
    {
      const bool is_lost = ! is_in_mesh(simplices[s]), is_chosen = br3_test::random_int(rng, 2) == 0;
      if(is_lost)
        (expected.*kind).push_back(s);
      if(is_chosen)
        (some.*kind).push_back(s);
      if(is_lost && is_chosen)
        (expected_of_some.*kind).push_back(s);
    }
  };
  Tr::Cell_handle c;
  int i, j, k;
  expect(&internal::Lost_constraints::edges, constraints.edges(),
         [&](const auto& e) { return tr.is_edge(e[0], e[1], c, i, j); });
  expect(&internal::Lost_constraints::facets, constraints.facets(),
         [&](const auto& f) { return tr.is_facet(f[0], f[1], f[2], c, i, j, k); });
  for(int repetition = 0; repetition < 2; ++repetition)
  {
    const internal::Lost_constraints lost = search(), lost_of_some = search(some), lost_of_none = search({});
    assert(lost.edges == expected.edges && lost.facets == expected.facets);
    assert(lost_of_some.edges == expected_of_some.edges && lost_of_some.facets == expected_of_some.facets);
    assert(lost_of_none.edges.empty() && lost_of_none.facets.empty());
  }
}

// Flips edges and facets by chance.
void flip_some(Tr& tr, const int number_of_attempts, std::mt19937& rng)
{
  for(int k = 0; k < number_of_attempts; ++k)
  {
    auto c = tr.finite_cells_begin();
    std::advance(c, br3_test::random_int(rng, static_cast<int>(tr.number_of_finite_cells())));
    const int i = br3_test::random_int(rng, 4), j = (i + 1 + br3_test::random_int(rng, 3)) % 4;
    if(! tr.flip(c, i, j))
      tr.flip(c, i);
  }
}

// Facets stay, go, come and come back, few at a time or many, and constraints are added.
void test_constraint_search(const br3_test::Lattice_points& points, const std::size_t vertices_per_lost_one,
                            std::mt19937& rng)
{
  Tr tr;
  for(const auto& p : points)
    tr.insert(Point_3(p.x, p.y, p.z));
  if(tr.dimension() < 3)
    return;
  internal::Constraints_3<Tr> constraints = random_constraints(tr, vertices_per_lost_one, rng);
  internal::Constraint_search_3<Tr> search(tr, constraints);
  for(const int number_of_flips : { 0, 1, 3, 3, 300, 1, 0 })
  {
    flip_some(tr, number_of_flips, rng);
    check_constraint_search(tr, constraints, search, rng);
    const auto v = internal::facet_vertices(tr.all_cells_begin(), br3_test::random_int(rng, 4));
    if(! tr.is_infinite(v[0]) && ! tr.is_infinite(v[1]) && ! tr.is_infinite(v[2]))
      constraints.insert(v[0], v[1], v[2]);
  }
}

int main()
{
  for(const unsigned seed : { 1u, 2u, 3u, 4u, 5u, 6u })
  {
    std::mt19937 rng(seed);
    for(const std::size_t vertices_per_lost_one : { 1, 10, 1000 })
      test_constraint_search(br3_test::random_points(seed % 2 == 0 ? 300 : 20, seed % 3 == 0 ? 5 : 1000, rng),
                             vertices_per_lost_one, rng);
  }
  std::cout << "done" << std::endl;
}
