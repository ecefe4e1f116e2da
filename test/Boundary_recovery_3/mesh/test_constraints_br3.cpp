// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Sets of constraints that change: facets and edges are inserted, erased and split at random, and compared with a naive
// set.

#undef NDEBUG

#include "random_numbers_br3.h"

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
using br3_test::random_int;
typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel> Tr;
typedef Tr::Vertex_handle                                             Vertex_handle;
typedef internal::Constraints_3<Tr>                                   Constraints;
typedef std::set<Vertex_handle>                                       Simplex;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

// By definition: facets as cyclic orders of their vertices, and the edges that were given by themselves.
class Naive_constraints
{
public:
  void insert(const Vertex_handle u, const Vertex_handle v) { m_edges.insert({ u, v }); }

  void insert(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    m_facets.emplace(Simplex{ u, v, w }, std::array<Vertex_handle, 3>{{ u, v, w }});
  }

  void erase(const Vertex_handle u, const Vertex_handle v)
  {
    for(const auto& f : facets_at({ u, v }))
      m_facets.erase({ f[0], f[1], f[2] });
    m_edges.erase({ u, v });
  }

  void erase(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) { m_facets.erase({ u, v, w }); }

  void split(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    for(const auto& f : facets_at({ u, v }))
      for(const Vertex_handle end : { u, v })
        insert(f[0] == end ? w : f[0], f[1] == end ? w : f[1], f[2] == end ? w : f[2]);
    const bool is_given = m_edges.count({ u, v }) != 0;
    erase(u, v);
    if(is_given)
    {
      insert(u, w);
      insert(v, w);
    }
  }

  void split(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w, const Vertex_handle x)
  {
    const std::array<Vertex_handle, 3> f = m_facets.at({ u, v, w });
    m_facets.erase({ u, v, w });
    for(int k = 0; k < 3; ++k)
      insert(f[k], f[(k + 1) % 3], x);
  }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const
  {
    return m_edges.count({ u, v }) != 0 || ! facets_at({ u, v }).empty();
  }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    return m_facets.count({ u, v, w }) != 0;
  }

  const std::map<Simplex, std::array<Vertex_handle, 3> >& facets() const { return m_facets; }

private:
  std::vector<std::array<Vertex_handle, 3> > facets_at(const Simplex& edge) const
  {
    std::vector<std::array<Vertex_handle, 3> > result;
    for(const auto& f : m_facets)
      if(f.first.count(*edge.begin()) != 0 && f.first.count(*edge.rbegin()) != 0)
        result.push_back(f.second);
    return result;
  }

  std::set<Simplex> m_edges;
  std::map<Simplex, std::array<Vertex_handle, 3> > m_facets;
};

bool turn_alike(const std::array<Vertex_handle, 3>& f, const std::array<Vertex_handle, 3>& g)
{
  const int i = f[0] == g[0] ? 0 : f[0] == g[1] ? 1 : 2;
  return f[0] == g[i] && f[1] == g[(i + 1) % 3] && f[2] == g[(i + 2) % 3];
}

void check(const Constraints& constraints, const Naive_constraints& expected, const std::vector<Vertex_handle>& v)
{
  std::size_t number_of_edges = 0, number_of_facets = 0;
  for(std::size_t e = 0; e < constraints.edges().size(); ++e)
    number_of_edges += ! constraints.is_edge_erased(e);
  for(std::size_t f = 0; f < constraints.facets().size(); ++f)
    number_of_facets += ! constraints.is_facet_erased(f);
  for(std::size_t i = 0; i < v.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
    {
      assert(constraints.is_constrained(v[i], v[j]) == expected.is_constrained(v[j], v[i]));
      number_of_edges -= expected.is_constrained(v[i], v[j]);
      for(std::size_t k = 0; k < j; ++k)
        assert(constraints.is_constrained(v[i], v[j], v[k]) == expected.is_constrained(v[i], v[j], v[k]));
    }
  assert(number_of_edges == 0 && number_of_facets == expected.facets().size());
  for(const auto& f : expected.facets())
  {
    const auto& g = f.second;
    const std::size_t index = constraints.index(g[0], g[1], g[2]);
    assert(turn_alike(constraints.facets()[index], g));
    for(int k = 0; k < 3; ++k)
      assert(constraints.edges_of_facet(index)[k] == constraints.index(constraints.facets()[index][k],
                                                                       constraints.facets()[index][(k + 1) % 3]));
  }
}

void test_changes(const unsigned seed)
{
  std::mt19937 rng(seed);
  Tr tr;
  std::vector<Vertex_handle> v;
  for(int i = 0; i < 9; ++i)
    v.push_back(tr.tds().create_vertex());
  Constraints constraints;
  Naive_constraints expected;
  for(int step = 0; step < 400; ++step)
  {
    std::shuffle(v.begin(), v.end(), rng);
    const bool is_edge = expected.is_constrained(v[0], v[1]), is_facet = expected.is_constrained(v[0], v[1], v[2]);
    const int kind = random_int(rng, 12);
    if(kind < 3)
    {
      constraints.insert(v[0], v[1], v[2]);
      expected.insert(v[0], v[1], v[2]);
    }
    else if(kind == 3)
    {
      constraints.insert(v[0], v[1]);
      expected.insert(v[0], v[1]);
    }
    else if(kind == 4)
    {
      constraints.erase(v[0], v[1]);
      expected.erase(v[0], v[1]);
      ++number_of[is_edge ? "edge erased" : "no edge to erase"];
    }
    else if(kind < 7)
    {
      constraints.erase(v[0], v[1], v[2]);
      expected.erase(v[0], v[1], v[2]);
      ++number_of[is_facet ? "facet erased" : "no facet to erase"];
    }
    else if(kind < 9 && is_edge && ! expected.is_constrained(v[0], v[1], v[3])) // v[3] is new on the edge
    {
      constraints.split(v[0], v[1], v[3]);
      expected.split(v[0], v[1], v[3]);
      ++number_of["edge split"];
    }
    else if(is_facet)
    {
      constraints.split(v[0], v[1], v[2], v[3]);
      expected.split(v[0], v[1], v[2], v[3]);
      ++number_of["facet split"];
    }
    check(constraints, expected, v);
  }
}

int main()
{
  for(unsigned seed = 0; seed < 30; ++seed)
    test_changes(seed);
  for(const char* kind : { "edge erased", "no edge to erase", "facet erased", "no facet to erase", "edge split",
                           "facet split" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 10);
  }
  std::cout << "done" << std::endl;
}
