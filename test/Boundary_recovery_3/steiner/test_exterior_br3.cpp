// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The exterior of a mesh, against its definition.

#undef NDEBUG

#include "random_triangulations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_steiner_points_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cassert>
#include <cstddef>
#include <iostream>
#include <random>
#include <set>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef K::Point_3                                          Point_3;

// The definition, by iteration until nothing changes.
std::set<Tr::Cell_handle> cells_reached_from_infinity(const Tr& tr, const internal::Constraints_3<Tr>& constraints)
{
  std::set<Tr::Cell_handle> result;
  for(const auto c : tr.all_cell_handles())
    if(tr.is_infinite(c))
      result.insert(c);
  for(std::size_t before = 0; before != result.size(); )
  {
    before = result.size();
    for(const auto& f : tr.finite_facets())
    {
      const auto v = internal::facet_vertices(f.first, f.second);
      if(! constraints.is_constrained(v[0], v[1], v[2])
         && (result.count(f.first) == 1 || result.count(f.first->neighbor(f.second)) == 1))
      {
        result.insert(f.first);
        result.insert(f.first->neighbor(f.second));
      }
    }
  }
  return result;
}

// Facets are constrained at random, `tenths` of them. Returns whether there is more than the exterior.
bool test_exterior(const unsigned seed, const int tenths)
{
  std::mt19937 rng(seed);
  Tr tr;
  for(const auto& p : br3_test::random_points(40, 7, rng))
    tr.insert(Point_3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)));
  assert(tr.dimension() == 3);
  internal::Constraints_3<Tr> constraints;
  for(const auto& f : tr.finite_facets())
    if(br3_test::random_int(rng, 10) < tenths)
    {
      const auto v = internal::facet_vertices(f.first, f.second);
      constraints.insert(v[0], v[1], v[2]);
    }
  const std::set<Tr::Cell_handle> expected = cells_reached_from_infinity(tr, constraints);
  const internal::Exterior_3<Tr> exterior(tr, constraints);
  for(const auto c : tr.all_cell_handles())
    assert(exterior.contains(c) == (expected.count(c) == 1));
  assert(exterior.is_everything() == (expected.size() == tr.tds().number_of_cells()));
  return ! exterior.is_everything();
}

void test_exteriors()
{
  int number_of_domains = 0;
  for(const unsigned seed : { 1u, 2u, 3u, 4u })
    for(const int tenths : { 0, 3, 6, 9, 10 })
    {
      const bool is_domain = test_exterior(seed, tenths);
      assert(tenths != 0 || ! is_domain);
      assert(tenths != 10 || is_domain);
      number_of_domains += is_domain;
    }
  assert(number_of_domains > 8);
}

int main()
{
  test_exteriors();
  std::cout << "done" << std::endl;
}
