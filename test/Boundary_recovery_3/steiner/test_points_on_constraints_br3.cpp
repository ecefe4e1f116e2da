// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The ledger of Steiner points, against one that is kept in plain lists.

#undef NDEBUG

#include "random_numbers_br3.h"

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
using br3_test::random_int;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Vertex_handle                                   Vertex_handle;
typedef internal::Constraints_3<Tr>                         Constraints;
typedef internal::Steiner_ledger_3<Tr>                      Ledger;
typedef Ledger::Carrier                                     Carrier;
typedef std::vector<Vertex_handle>                          Vertices;
typedef std::set<Vertex_handle>                             Vertex_set;
typedef std::vector<std::size_t>                            Indices;

Vertex_set set_of(const Vertices& v) { return Vertex_set(v.begin(), v.end()); }

// Some facets and edges among a few vertices. Nothing here looks at cells or points.
class Account
{
public:
  explicit Account(std::mt19937& rng)
    : m_rng(rng), m_ledger(m_constraints)
  {
    for(int i = 0; i < 6; ++i)
      m_input.push_back(m_tr.tds().create_vertex());
    for(int k = 0; k < 10; ++k)
    {
      const int a = number_below(6), b = (a + 1 + number_below(5)) % 6, c = number_below(6);
      if(c == a || c == b)
        m_constraints.insert(m_input[index(a)], m_input[index(b)]);
      else
        m_constraints.insert(m_input[index(a)], m_input[index(b)], m_input[index(c)]);
    }
    for(const auto& e : m_constraints.edges())
      m_chains.push_back(Vertices(e.begin(), e.end()));
    m_interiors.resize(m_constraints.facets().size());
  }

  void insert_on_edge()
  {
    const std::size_t e = index(number_below(m_chains.size()));
    const std::size_t i = index(number_below(m_chains[e].size() - 1));
    const Vertex_handle v = new_vertex();
    m_ledger.insert_on_edge(e, m_chains[e][i], v);
    m_chains[e].insert(m_chains[e].begin() + static_cast<std::ptrdiff_t>(i) + 1, v);
    m_on_constraints.push_back(v);
    ++m_numbers[0];
  }

  void insert_in_facet()
  {
    if(m_interiors.empty())
      return;
    const std::size_t f = index(number_below(m_interiors.size()));
    const Vertex_handle v = new_vertex();
    m_ledger.insert_in_facet(f, v);
    m_interiors[f].push_back(v);
    m_on_constraints.push_back(v);
    ++m_numbers[0];
  }

  void insert_free()
  {
    const Vertex_handle v = new_vertex();
    m_origins[v] = Carrier{ 1 + number_below(2), index(number_below(9)) };
    m_ledger.insert_free(v, m_origins[v]);
    m_free.push_back(v);
    ++m_numbers[1];
  }

  // Any of those that may be erased.
  void erase()
  {
    Vertices candidates = m_on_constraints;
    candidates.insert(candidates.end(), m_free.begin(), m_free.end());
    if(! candidates.empty())
      erase(candidates[index(number_below(candidates.size()))]);
  }

  void settle()
  {
    while(! m_on_constraints.empty())
      erase(m_on_constraints.back());
    m_ledger.settle();
    m_settled.push_back({ m_free, Vertices(), m_numbers });
    m_free.clear();
  }

  void unsettle()
  {
    m_ledger.unsettle();
    const Settled last = m_settled.back();
    m_settled.pop_back();
    m_free.insert(m_free.begin(), last.points.begin(), last.points.end());
    if(! m_settled.empty())
      m_settled.back().new_vertices.insert(m_settled.back().new_vertices.end(), last.new_vertices.begin(),
                                           last.new_vertices.end());
  }

  void take_back()
  {
    new_vertex(); // one that did not get into the mesh
    m_ledger.take_back(m_settled.back().new_vertices);
    for(const Vertex_handle v : m_settled.back().new_vertices)
    {
      assert(! m_ledger.positions().contains(v) && ! m_ledger.is_free(v));
      forget(v);
    }
    m_numbers = m_settled.back().numbers;
    m_settled.back().new_vertices.clear();
  }

  void check() const
  {
    check_points();
    Indices split_edges, split_facets;
    for(std::size_t e = 0; e < m_chains.size(); ++e)
    {
      assert(m_ledger.vertices_on_edge(e) == m_chains[e]);
      if(m_chains[e].size() > 2)
        split_edges.push_back(e);
      for(std::size_t i = 1; i + 1 < m_chains[e].size(); ++i)
        check_point_on_edge(e, i);
    }
    for(std::size_t f = 0; f < m_interiors.size(); ++f)
    {
      const Vertices found = m_ledger.vertices_on_facet(f);
      assert(set_of(found) == vertices_on_facet(f) && set_of(found).size() == found.size());
      if(found.size() > 3)
        split_facets.push_back(f);
      for(const Vertex_handle v : m_interiors[f])
        assert(m_ledger.carrier(v).dimension == 2 && m_ledger.carrier(v).index == f);
    }
    assert(m_ledger.split_edges() == split_edges && m_ledger.split_facets() == split_facets);
    check_parts();
  }

private:
  // The free points at a settle(), the vertices since then, and the numbers of points then.
  struct Settled
  {
    Vertices points, new_vertices;
    std::array<std::size_t, 2> numbers;
  };

  static std::size_t index(const int i) { return static_cast<std::size_t>(i); }

  template <typename Number>
  int number_below(const Number n) { return random_int(m_rng, static_cast<int>(n)); }

  Vertex_handle new_vertex()
  {
    const Vertex_handle v = m_tr.tds().create_vertex();
    m_ledger.positions().set(v, Ledger::Positions::Exact_point_3(1, 2, 3));
    if(! m_settled.empty())
      m_settled.back().new_vertices.push_back(v);
    return v;
  }

  void erase(const Vertex_handle v)
  {
    m_ledger.erase(v);
    assert(! m_ledger.positions().contains(v) && ! m_ledger.is_on_constraint(v) && ! m_ledger.is_free(v));
    forget(v);
  }

  void forget(const Vertex_handle v)
  {
    for(auto* lists : { &m_chains, &m_interiors })
      for(Vertices& list : *lists)
        list.erase(std::remove(list.begin(), list.end(), v), list.end());
    for(Vertices* list : { &m_on_constraints, &m_free })
      list->erase(std::remove(list->begin(), list->end(), v), list->end());
  }

  void check_points() const
  {
    assert(m_ledger.points_on_constraints() == m_on_constraints && m_ledger.free_points() == m_free);
    assert(m_ledger.number_of_constraint_points() == m_numbers[0] && m_ledger.number_of_free_points() == m_numbers[1]);
    Vertices all = m_on_constraints;
    for(const Settled& settled : m_settled)
      all.insert(all.end(), settled.points.begin(), settled.points.end());
    all.insert(all.end(), m_free.begin(), m_free.end());
    assert(m_ledger.points() == all);
    for(const Vertex_handle v : all)
    {
      const bool is_on_constraint = internal::contains(m_on_constraints, v);
      assert(m_ledger.is_on_constraint(v) == is_on_constraint);
      assert(m_ledger.is_free(v) == internal::contains(m_free, v)); // the settled ones are left alone
      assert(m_ledger.positions().contains(v));
    }
    for(const Vertex_handle v : m_free)
      assert(m_ledger.origin(v).dimension == m_origins.at(v).dimension
             && m_ledger.origin(v).index == m_origins.at(v).index);
  }

  // Those on the closed facet.
  Vertex_set vertices_on_facet(const std::size_t f) const
  {
    Vertex_set result(m_interiors[f].begin(), m_interiors[f].end());
    for(const std::size_t e : m_constraints.edges_of_facet(f))
      result.insert(m_chains[e].begin(), m_chains[e].end());
    return result;
  }

  void check_point_on_edge(const std::size_t e, const std::size_t i) const
  {
    const Vertex_handle v = m_chains[e][i];
    assert(m_ledger.carrier(v).dimension == 1 && m_ledger.carrier(v).index == e);
    assert((m_ledger.neighbors_on_edge(v)
            == std::array<Vertex_handle, 2>{{ m_chains[e][i - 1], m_chains[e][i + 1] }}));
    Indices facets;
    for(std::size_t f = 0; f < m_interiors.size(); ++f)
      if(internal::contains(m_constraints.edges_of_facet(f), e))
        facets.push_back(f);
    const auto& found = m_constraints.facets_at_edge(e);
    assert(Indices(found.begin(), found.end()) == facets);
  }

  // All edges and triangles between the vertices, but for triangles with three vertices on one edge.
  void check_parts() const
  {
    Vertices all = m_input;
    all.insert(all.end(), m_on_constraints.begin(), m_on_constraints.end());
    if(! m_free.empty())
      all.push_back(m_free.back());
    for(const Vertex_handle u : all)
    {
      assert(m_ledger.is_on_constraint(u) == internal::contains(m_on_constraints, u));
      for(std::size_t f = 0; f < m_interiors.size(); ++f)
        assert(m_ledger.is_on_facet(u, f) == (vertices_on_facet(f).count(u) == 1));
      for(const Vertex_handle v : all)
        if(u != v)
        {
          assert(m_ledger.is_constrained(u, v) == (is_part(u, v) || m_constraints.is_constrained(u, v)));
          for(const Vertex_handle w : all)
            if(w != u && w != v && ! are_on_one_edge({ u, v, w }))
              assert(m_ledger.is_constrained(u, v, w) == are_on_one_facet({ u, v, w }));
        }
    }
  }

  bool is_part(const Vertex_handle u, const Vertex_handle v) const
  {
    for(const Vertices& chain : m_chains)
      for(std::size_t i = 1; i < chain.size(); ++i)
        if((chain[i - 1] == u && chain[i] == v) || (chain[i - 1] == v && chain[i] == u))
          return true;
    return false;
  }

  bool are_on_one_edge(const Vertex_set& vertices) const
  {
    return std::any_of(m_chains.begin(), m_chains.end(), [&](const Vertices& chain)
    {
      const Vertex_set on_edge = set_of(chain);
      return std::includes(on_edge.begin(), on_edge.end(), vertices.begin(), vertices.end());
    });
  }

  bool are_on_one_facet(const Vertex_set& vertices) const
  {
    for(std::size_t f = 0; f < m_interiors.size(); ++f)
    {
      const Vertex_set on_facet = vertices_on_facet(f);
      if(std::includes(on_facet.begin(), on_facet.end(), vertices.begin(), vertices.end()))
        return true;
    }
    return false;
  }

  std::mt19937& m_rng;
  Tr m_tr;
  Constraints m_constraints;
  Ledger m_ledger;
  Vertices m_input, m_on_constraints, m_free; // the Steiner points in the order in which they were inserted
  std::vector<Settled> m_settled;
  std::vector<Vertices> m_chains, m_interiors;
  std::map<Vertex_handle, Carrier> m_origins; // of free points
  std::array<std::size_t, 2> m_numbers = {{ 0, 0 }}; // of points that were put on constraints, and that came off
};

void change(Account& account, std::mt19937& rng)
{
  for(int step = 0; step < 15; ++step)
  {
    const int action = random_int(rng, 6);
    if(action < 2)
      account.insert_on_edge();
    else if(action == 2)
      account.insert_in_facet();
    else if(action == 3)
      account.insert_free();
    else
      account.erase();
    account.check();
  }
}

// Something that is taken back or not, with others inside of it.
void transact(Account& account, std::mt19937& rng, const int depth, const bool is_taken_back)
{
  account.settle();
  account.check();
  change(account, rng);
  for(int i = 0; i < depth; ++i)
    transact(account, rng, depth - 1, random_int(rng, 2) == 0);
  if(is_taken_back)
    account.take_back();
  account.check();
  account.unsettle();
  account.check();
  change(account, rng);
}

int main()
{
  std::mt19937 rng(1);
  for(int round = 0; round < 5; ++round)
  {
    Account account(rng);
    account.check();
    change(account, rng);
    for(const bool is_taken_back : { true, false, true })
      transact(account, rng, round % 3, is_taken_back);
  }
  std::cout << "done" << std::endl;
}
