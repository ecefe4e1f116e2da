// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Where hundreds of edges stay lost, the flips do not go on for one or two edges more: each pass at the highest level,
// but for the last one, takes away a twentieth of what is lost, or more. By counts, not by a clock.

#undef NDEBUG

#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>                Tr;
typedef CGAL::Boundary_recovery_result_3<Tr>                  Result;
typedef CGAL::Boundary_recovery_3::Recursion_level_report     Level;
typedef CGAL::Boundary_recovery_3::Phase                      Phase;

static constexpr int highest_level = 30;

// Segments between random points, most of which are lost and cross many cells.
Result recover_segments(const unsigned seed, const std::size_t n)
{
  namespace params = CGAL::parameters;
  std::minstd_rand random(seed); // the same everywhere
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 2> > edges;
  for(std::size_t i = 0; i < 2 * n; ++i)
  {
    std::array<double, 3> x;
    for(double& c : x)
      c = static_cast<double>(random() % 100003);
    points.emplace_back(x[0], x[1], x[2]);
  }
  for(std::size_t i = 0; i < n; ++i)
    edges.push_back({{ 2 * i, 2 * i + 1 }});
  Tr tr;
  return CGAL::recover_boundary(tr, points, std::vector<std::array<std::size_t, 3> >(),
                                params::recovery_mode(CGAL::Boundary_recovery_3::Recovery_mode::flips_only),
                                params::constrained_edges(edges));
}

// What the calling of Algorithm 5 that this report is of wants to lower.
std::size_t measure(const Level& level)
{
  return level.phase == Phase::edge_recovery_brc1 || level.phase == Phase::facet_recovery_brc2 ? level.n1 : level.n2;
}

// Each pass at the highest level that another one of the same phase followed was worth it.
void check_passes(const std::vector<Level>& levels)
{
  for(std::size_t i = 1; i + 1 < levels.size(); ++i)
    if(levels[i].max_recursion_level == highest_level && levels[i + 1].phase == levels[i].phase)
      assert(20 * measure(levels[i]) < 19 * measure(levels[i - 1]));
}

int main()
{
  for(const unsigned seed : { 1, 2, 3, 4 })
  {
    const Result result = recover_segments(seed, 150);
    assert(result.missing_edges.size() > 50 && ! result.levels.empty()); // the flips did what they could
    check_passes(result.levels);
    std::cout << result.levels.size() << " reports, " << result.missing_edges.size() << " edges are lost" << std::endl;
  }
}
