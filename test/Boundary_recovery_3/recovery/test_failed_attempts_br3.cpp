// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Where many edges stay lost, a pass at the highest level does not repeat what failed in the pass before: most edges
// are left alone, for they still cross as much. By counts, not by a clock.

#undef NDEBUG

#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <functional>
#include <iostream>
#include <random>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>                Tr;
typedef CGAL::Boundary_recovery_result_3<Tr>                  Result;
typedef CGAL::Boundary_recovery_3::Recursion_level_report     Level;
typedef CGAL::Boundary_recovery_3::Phase                      Phase;

static constexpr int highest_level = 30;

struct Pass
{
  Phase phase;
  std::size_t number_of_edges = 0;
  std::size_t number_of_attempts = 0; // that changed the mesh, as all do at high levels, but for a few
};

// Counts the attempts of each pass.
struct Attempt_counter
  : public CGAL::Default_meshing_visitor_3
{
  template <typename Cells> void before_cells_removal(const Cells&) { is_changed = true; }

  void on_progress(const Phase phase, const std::size_t done, const std::size_t total)
  {
    if(done == 1)
      passes.push_back({ phase });
    passes.back().number_of_edges = total;
    if(is_changed)
      ++passes.back().number_of_attempts;
    is_changed = false;
  }

  bool is_changed = false;
  std::vector<Pass> passes;
};

// Segments between random points, most of which are lost and cross many cells.
Result recover_segments(const unsigned seed, const std::size_t n, Attempt_counter& counter)
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
                                params::constrained_edges(edges).visitor(std::ref(counter)));
}

bool is_recursive(const Phase phase)
{
  return phase == Phase::edge_recovery_brc1 || phase == Phase::edge_recovery_brc3;
}

// The passes of the recursive phases, and by what levels they were; the report of a start is of no pass.
void check_passes(std::vector<Pass> passes, std::vector<Level> levels)
{
  passes.erase(std::remove_if(passes.begin(), passes.end(), [](const Pass& p) { return ! is_recursive(p.phase); }),
               passes.end());
  levels.erase(std::remove_if(levels.begin(), levels.end(), [](const Level& l) { return l.max_recursion_level < 0; }),
               levels.end());
  assert(passes.size() == levels.size());
  std::size_t number_of_edges = 0, number_of_attempts = 0;
  for(std::size_t i = 1; i < passes.size(); ++i)
    if(levels[i].max_recursion_level == highest_level && levels[i - 1].max_recursion_level == highest_level)
    {
      number_of_edges += passes[i].number_of_edges;
      number_of_attempts += passes[i].number_of_attempts;
    }
  std::cout << number_of_attempts << " of " << number_of_edges << " edges are tried again" << std::endl;
  assert(number_of_edges > 100 && number_of_attempts < number_of_edges / 2);
}

int main()
{
  for(const unsigned seed : { 1, 2, 3, 4 })
  {
    Attempt_counter counter;
    const Result result = recover_segments(seed, 150, counter);
    assert(result.missing_edges.size() > 50); // the flips did what they could
    check_passes(counter.passes, result.levels);
  }
}
