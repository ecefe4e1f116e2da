// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// What the search for a covering mesh consists of, each part against its definition: which elements are positive and
// valid, which rings can be triangulated and how well, and the best core, by looking at all triangulations and cores.

#undef NDEBUG

#include "reference_covering_mesh.h"

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Covering_mesh_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Ring_triangulations_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;
namespace internal = CGAL::Boundary_recovery_3::internal;
using namespace br3_test;
typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef Triangulations<K>::Delaunay                           Tr;
typedef BR::Shell_3<Tr>                                       Shell;
typedef internal::Vertex_predicates_3<Tr>                     Predicates;
typedef std::vector<Triangle>                                 Triangles;

constexpr int max_degree = 8;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

// A number below n that looks random, but depends on the vertices only, in any order.
int noise(const unsigned seed, const Shell& s, const std::initializer_list<int>& positions, const unsigned n)
{
  std::multiset<int> indices;
  for(const int i : positions)
    indices.insert(s.vertex(i)->info());
  unsigned x = seed;
  for(const int i : indices)
  {
    x = (x ^ static_cast<unsigned>(i + 2)) * 2654435761u;
    x ^= x >> 15;
  }
  return static_cast<int>(x % n);
}

// How often something was asked for each element; it does not matter which of its rotations.
typedef std::map<std::multiset<int>, int> Counts;

// A sum of small numbers, so that there are many ties.
template <bool is_first>
struct Noise_quality
{
  typedef int Value;
  static constexpr bool is_first_in_vector = is_first;

  Value best() const { return 0; }
  Value combine(const Value x, const Value y) const { return x + y; }
  Value of_triangle(const Shell& s, const int i, const int k, const int j) const
  {
    ++counts[{ i, k, j }];
    return - noise(seed, s, { i, k, j }, 3);
  }
  Value of_chord(const Shell& s, const int i, const int j) const { return - noise(seed + 1, s, { i, j }, 3); }
  Value of_core_edge(const Shell& s, const int i, const int j) const { return - noise(seed + 2, s, { i, j }, 3); }
  Value of_core_vertex(const Shell& s, const int i) const { return - noise(seed + 3, s, { i }, 2); }
  Value of_supporting_edge(const Shell&) const { return -1; }

  unsigned seed;
  mutable Counts counts = Counts();
};

// Some triangles and chords are not valid.
struct Noise_validity
  : public BR::No_shell_validity_3
{
  explicit Noise_validity(const unsigned seed) : seed(seed) { }

  bool is_valid_triangle(const Shell& s, const int i, const int k, const int j) const
  {
    ++counts[{ i, k, j }];
    return noise(seed + 4, s, { i, k, j }, 9) != 0;
  }

  bool is_valid_chord(const Shell& s, const int i, const int j) const
  {
    assert(i < j);
    ++counts[{ i, j }];
    return noise(seed + 5, s, { i, j }, 9) != 0;
  }

  unsigned seed;
  mutable Counts counts;
};

void check_asked_once(const Counts& counts)
{
  for(const auto& n : counts)
    assert(n.second == 1);
}

// All that is asked of one shell with one quality.
template <bool is_first>
class Tester
{
public:
  typedef Noise_quality<is_first>                                         Quality;
  typedef internal::Shell_positivity_3<Tr>                                Positivity;
  typedef internal::Shell_elements_3<Tr, Quality, Noise_validity>         Elements;
  typedef internal::Ring_triangulations_3<Tr, Quality, Noise_validity>    Rings;
  typedef internal::Core_search_3<Tr, Quality, Noise_validity>            Core_search;
  typedef typename Core_search::Candidate                                 Candidate;

  Tester(const Tr& tr, const Lattice_points& points, const Shell& shell, const unsigned seed)
    : m_predicates(tr), m_quality{ seed }, m_validity(seed), m_shell(shell), m(shell.degree()),
      m_positivity(m_shell, m_predicates), m_rings(m_predicates, m_quality, m_validity),
      m_search(m_predicates, m_quality, m_rings)
  {
    m_a = points[static_cast<std::size_t>(shell.a()->info())];
    m_b = points[static_cast<std::size_t>(shell.b()->info())];
    for(int i = 0; i < m; ++i)
      m_ring.push_back(i == shell.infinite_index() ? Lattice_point{ 0, 0, 0 }
                                                   : points[static_cast<std::size_t>(shell.vertex(i)->info())]);
  }

  void operator()(std::mt19937& rng)
  {
    check_positivity();
    check_elements();
    internal::Positions kept = 0;
    for(int i = 0; i < m; ++i)
      if(random_int(rng, 8) == 0)
        kept |= internal::bit(i);
    m_quality.counts.clear();
    m_validity.counts.clear();
    m_rings.assign(m_shell, kept);
    m_rings.fill_in_straight_rings();
    m_rings.fill_in_wrapped_rings();
    check_asked_once(m_validity.counts);
    for(int i = 0; i < m; ++i)
      for(int j = 0; j < m; ++j)
        if(i != j)
          check_ring(i, j, kept);
    check_asked_once(m_quality.counts);
    for(const bool keeps_edge : { true, false })
      for(const bool only_if_done : { true, false })
        check_core(random_int(rng, m + 1) - 1, keeps_edge || ! is_first, only_if_done);
  }

private:
  const Lattice_point& point(const int i) const { return m_ring[static_cast<std::size_t>(i)]; }

  // --- elements -----------------------------------------------------------------------------------------------------

  // Of a triangle with the infinite vertex: the two facets of the hull are exchanged for the two others of the same
  // planar quadrilateral.
  bool is_triangle_positive(std::array<int, 3> t) const
  {
    const int h = m_shell.infinite_index();
    if(std::find(t.begin(), t.end(), h) == t.end())
      return volume(point(t[0]), point(t[1]), point(t[2]), m_b) > 0
          && volume(point(t[0]), point(t[1]), point(t[2]), m_a) < 0;
    const int before = m_shell.previous(h), after = m_shell.next(h);
    while(t[1] != h)
      std::rotate(t.begin(), t.begin() + 1, t.end());
    return t[0] == before && t[2] == after && do_cross(m_a, m_b, point(before), point(after));
  }

  bool is_core_edge_positive(const int i, const int j) const
  {
    const int h = m_shell.infinite_index();
    return j == m_shell.next(i) || (i != h && j != h && volume(m_a, m_b, point(i), point(j)) > 0);
  }

  void check_positivity() const
  {
    for(int i = 0; i < m; ++i)
      for(int j = 0; j < m; ++j)
      {
        if(i == j)
          continue;
        assert(m_positivity.is_core_edge_positive(i, j) == is_core_edge_positive(i, j));
        for(int k = 0; k < m; ++k)
          if(k != i && k != j)
          {
            const bool is_positive = m_positivity.is_triangle_positive(i, k, j);
            assert(is_positive == is_triangle_positive({{ i, k, j }}));
            number_of["positive triangle with the infinite vertex"]
              += is_positive && (i == m_shell.infinite_index() || k == m_shell.infinite_index());
          }
      }
  }

  bool is_valid_triangle(const int i, const int k, const int j) const
  {
    return is_triangle_positive({{ i, k, j }}) && m_validity.is_valid_triangle(m_shell, i, k, j);
  }

  bool is_valid_chord(const int i, const int j) const
  {
    return m_validity.is_valid_chord(m_shell, (std::min)(i, j), (std::max)(i, j));
  }

  // Each is known in all three rotations once one of them was asked for.
  void check_elements() const
  {
    Elements elements(m_predicates, m_quality, m_validity);
    elements.assign(m_shell);
    for(int i = 0; i < m; ++i)
      for(int k = i + 1; k < m; ++k)
        for(int j = k + 1; j < m; ++j)
        {
          m_validity.counts.clear();
          m_quality.counts.clear();
          const bool is_valid = elements.is_valid_triangle(k, j, i);
          assert(elements.is_valid_triangle(i, k, j) == is_valid && elements.is_valid_triangle(j, i, k) == is_valid);
          check_asked_once(m_validity.counts);
          assert(is_valid == is_valid_triangle(i, k, j));
          if(! is_valid)
            continue;
          const int value = elements.triangle_value(j, i, k);
          assert(elements.triangle_value(i, k, j) == value && elements.triangle_value(k, j, i) == value);
          check_asked_once(m_quality.counts);
          assert(value == m_quality.of_triangle(m_shell, i, k, j));
        }
    for(int i = 0; i < m; ++i)
      for(int j = i + 1; j < m; ++j)
      {
        m_validity.counts.clear();
        const bool is_valid = elements.is_valid_chord(i, j);
        assert(elements.is_valid_chord(i, j) == is_valid);
        check_asked_once(m_validity.counts);
        assert(is_valid == is_valid_chord(i, j));
      }
  }

  // --- rings --------------------------------------------------------------------------------------------------------

  // The triangulations of R_ij that are allowed, each with its value.
  std::vector<std::pair<int, Triangles> > triangulations(const int i, const int j,
                                                         const internal::Positions kept) const
  {
    std::vector<std::pair<int, Triangles> > result;
    const int size = (j - i + m) % m + 1;
    for(const Triangles& triangulation : polygon_triangulations(size))
    {
      int value = 0;
      bool is_allowed = true;
      Triangles triangles;
      for(const Triangle& t : triangulation)
      {
        triangles.push_back({{ (t[0] + i) % m, (t[1] + i) % m, (t[2] + i) % m }});
        const Triangle& u = triangles.back();
        const bool is_chord = u[2] != m_shell.previous(u[0]); // the two other sides are those of other triangles
        is_allowed = is_allowed && is_valid_triangle(u[0], u[1], u[2]) && ! internal::has_bit(kept, u[1])
                  && (! is_chord || is_valid_chord(u[0], u[2]));
        value += m_quality.of_triangle(m_shell, u[0], u[1], u[2]);
        if(is_chord)
          value += m_quality.of_chord(m_shell, u[0], u[2]);
      }
      if(is_allowed)
        result.emplace_back(value, triangles);
    }
    return result;
  }

  void check_ring(const int i, const int j, const internal::Positions kept)
  {
    const Counts validity_counts = m_validity.counts, quality_counts = m_quality.counts; // not of what is done here
    const bool is_looked_for = i == 0 || j != m_shell.previous(i); // of the longest, a complete reduction needs one
    const auto all = triangulations(i, j, kept);
    m_validity.counts = validity_counts;
    m_quality.counts = quality_counts;
    assert(m_rings.has_ring(i, j) == (is_looked_for && ! all.empty()));
    ++number_of[m_rings.has_ring(i, j) ? "ring" : "no ring"];
    if(! m_rings.has_ring(i, j))
      return;
    int best = all[0].first, first_apex = m;
    for(const auto& t : all)
      best = (std::max)(best, t.first);
    for(const auto& t : all)
      if(t.first == best && ! t.second.empty())
        first_apex = (std::min)(first_apex, (t.second[0][1] - i + m) % m);
    assert(m_rings.value(i, j) == best);
    Triangles found;
    m_rings.triangulate(i, j, found);
    const std::set<Triangle> triangles(found.begin(), found.end());
    assert(std::any_of(all.begin(), all.end(), [&](const auto& t)
    {
      return t.first == best && std::set<Triangle>(t.second.begin(), t.second.end()) == triangles;
    }));
    if(found.empty())
      return;
    assert(found[0] == (Triangle{{ i, (i + first_apex) % m, j }}));
    number_of["ring with a choice"] += all.size() > 1;
    number_of["ring with kept positions"] += kept != 0;
  }

  // --- cores --------------------------------------------------------------------------------------------------------

  // What is greater is better. Those with the same vector are in the order of their cores.
  std::array<int, 3> vector_of(const Candidate& c) const
  {
    const int avoids = c.avoids ? 1 : 0;
    if(is_first)
      return {{ c.value, avoids, - c.core_size }};
    return {{ avoids, - c.core_size, c.value }};
  }

  // Of a core, if it is one.
  bool evaluate(const std::vector<int>& core, const int f, Candidate& c)
  {
    c.core_size = static_cast<int>(core.size());
    c.start = core[0];
    c.avoids = std::find(core.begin(), core.end(), f) == core.end();
    c.value = m_quality.of_supporting_edge(m_shell);
    for(std::size_t k = 0; k < core.size(); ++k)
    {
      const int i = core[k], j = core[(k + 1) % core.size()];
      if(! m_rings.has_ring(i, j) || ! is_core_edge_positive(i, j))
        return false;
      c.value += m_rings.value(i, j) + m_quality.of_core_edge(m_shell, i, j) + m_quality.of_core_vertex(m_shell, i);
    }
    return true;
  }

  void check_core(const int f, const bool keeps_edge, const bool only_if_done)
  {
    Candidate best;
    if(! keeps_edge && m_rings.has_ring(0, m - 1))
    {
      best.core_size = 0;
      best.avoids = true;
      best.value = m_rings.value(0, m - 1);
    }
    const Candidate found = m_search(m_shell, f, best, only_if_done);
    std::vector<int> best_core;
    for(internal::Positions set = 1; set < internal::bit(m); ++set)
    {
      std::vector<int> core;
      internal::for_each_bit(set, [&](const int i) { core.push_back(i); });
      Candidate c;
      if(core.size() < 3 || ! evaluate(core, f, c) || (only_if_done && (f == Shell::none || ! c.avoids)))
        continue;
      if(best.core_size < 0 || vector_of(c) > vector_of(best) || (vector_of(c) == vector_of(best) && core < best_core))
      {
        best = c;
        best_core = core;
      }
    }
    if(best.core_size < 0 || best.core_size == m) // nothing, or what is there; then nobody wants to know more
    {
      assert(found.core_size == m || (only_if_done && found.core_size < 0));
      ++number_of["no better core"];
      return;
    }
    assert(found.core_size == best.core_size && found.avoids == best.avoids && found.value == best.value);
    if(best.core_size == 0)
    {
      ++number_of["complete reduction"];
      return;
    }
    std::vector<int> core;
    m_search.trace(core);
    assert(core == best_core);
    ++number_of[best.avoids && f != Shell::none ? "core that avoids a face" : "core"];
  }

  const Predicates m_predicates;
  const Quality m_quality;
  const Noise_validity m_validity;
  const Shell m_shell;
  const int m;
  const Positivity m_positivity;
  Rings m_rings;
  Core_search m_search;
  Lattice_point m_a, m_b;
  Lattice_points m_ring;
};

void test_shells(const Lattice_points& points, std::mt19937& rng)
{
  Tr tr;
  insert_points(tr, points);
  if(tr.dimension() < 3)
    return;
  for(const auto& e : tr.finite_edges())
  {
    const Shell shell(tr, e.first, e.second, e.third);
    if(shell.degree() > max_degree)
      continue;
    const unsigned seed = static_cast<unsigned>(random_int(rng, 1 << 20));
    Tester<true>(tr, points, shell, seed)(rng);
    Tester<false>(tr, points, shell, seed)(rng);
    ++number_of["degree " + std::to_string(shell.degree())];
  }
}

// Against sets and maps; what was there before a clear or an assignment does not matter.
void test_position_tables()
{
  std::mt19937 rng(41);
  internal::Position_pairs pairs;
  internal::Position_matrix<int> matrix;
  for(const int degree : { 5, 64, 17, 3 })
  {
    std::set<std::pair<int, int> > expected;
    std::map<std::pair<int, int>, int> values;
    const int number_of_rows = degree + random_int(rng, 3);
    pairs.clear(degree);
    matrix.assign(number_of_rows, degree);
    for(int k = 0; k < 200; ++k)
    {
      const int i = random_int(rng, degree), j = random_int(rng, degree), row = random_int(rng, number_of_rows);
      pairs.insert(i, j);
      expected.emplace(i, j);
      matrix(row, j) = values[{ row, j }] = k;
    }
    for(int i = 0; i < degree; ++i)
      for(int j = 0; j < degree; ++j)
      {
        assert(pairs.contains(i, j) == (expected.count({ i, j }) == 1));
        assert(internal::has_bit(pairs[i], j) == pairs.contains(i, j));
      }
    for(const auto& v : values)
      assert(matrix(v.first.first, v.first.second) == v.second);
  }
}

int main()
{
  test_position_tables();
  std::mt19937 rng(42);
  for(int k = 0; k < 6; ++k)
  {
    test_shells(random_points(14, 1000, rng), rng);
    test_shells(random_points(14, 5, rng), rng);
    test_shells(grid_points(3, 3, 2, 100, rng), rng);
    for(int size = 4; size <= max_degree; ++size)
      for(const bool is_flat : { true, false })
        test_shells(ring_points(size, is_flat, k % 2 == 0, rng), rng);
  }
  for(const auto& n : number_of)
    std::cout << n.second << " x " << n.first << std::endl;
  for(int degree = 3; degree <= max_degree; ++degree)
    assert(number_of["degree " + std::to_string(degree)] > 10);
  for(const char* kind : { "positive triangle with the infinite vertex", "ring", "no ring", "ring with a choice",
                           "ring with kept positions", "no better core", "complete reduction",
                           "core that avoids a face", "core" })
    assert(number_of[kind] > 50);
  std::cout << "done" << std::endl;
}
