// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// What the named parameter `effort` changes, on inputs that need Steiner points: never what is recovered, only how many
// points are left; and nothing at all by default and in the mode `flips_only`.

#undef NDEBUG

#include "recover_and_judge_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <cassert>
#include <cstddef>
#include <iostream>
#include <optional>
#include <vector>

using br3_test::Plc;
using br3_test::Recovery_mode;
using br3_test::Recovery_status;
typedef CGAL::Boundary_recovery_3::Recovery_effort            Recovery_effort;
typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>                Tr;
typedef br3_test::Portrait<Tr>                                Portrait;

struct Outcome
{
  Portrait portrait;
  std::size_t number_of_points;
  Recovery_status status;
};

// None: the default.
Outcome recover(const Plc& plc, const Recovery_mode mode, const std::optional<Recovery_effort> effort)
{
  namespace params = CGAL::parameters;
  std::vector<Kernel::Point_3> points;
  for(const auto& c : plc.points)
    points.emplace_back(c[0], c[1], c[2]);
  Tr tr;
  const auto edges = params::constrained_edges(plc.edges);
  const auto result = effort
    ? CGAL::recover_boundary(tr, points, plc.triangles, params::recovery_mode(mode), edges, params::effort(*effort))
    : CGAL::recover_boundary(tr, points, plc.triangles, params::recovery_mode(mode), edges);
  br3_test::Brute_force_checker<Tr>(plc, br3_test::Expectation(plc), mode, tr, {}, result)();
  return { Portrait(tr), result.steiner_vertices.size(), result.status };
}

std::vector<Plc> hard_inputs()
{
  std::vector<Plc> result;
  for(std::size_t n = 3; n <= 12; ++n)
    result.push_back(br3_test::twisted_prism(n, .45, 1000, n % 2 == 0 ? 300 : 1500));
  for(const int n : { 1, 2, 3 })
    result.push_back(br3_test::Notched_box(n, 1).plc());
  for(unsigned seed = 0; seed < 24; ++seed)
    result.push_back(br3_test::Random_constraints(seed)(8 + static_cast<int>(seed) % 12, seed % 3 == 0 ? 5 : 60, 80,
                                                        60));
  return result;
}

int main()
{
  std::size_t least = 0, most = 0;
  for(const Plc& plc : hard_inputs())
  {
    const Outcome by_default = recover(plc, Recovery_mode::constrained, std::nullopt);
    const Outcome with_time = recover(plc, Recovery_mode::constrained, Recovery_effort::more_time);
    const Outcome with_points = recover(plc, Recovery_mode::constrained, Recovery_effort::more_points);
    assert(by_default.status == Recovery_status::recovered && with_points.status == Recovery_status::recovered);
    assert(by_default.portrait == with_time.portrait);
    assert(with_points.portrait
           == recover(plc, Recovery_mode::constrained, Recovery_effort::more_points).portrait);
    least += with_time.number_of_points;
    most += with_points.number_of_points;

    const Outcome flipped = recover(plc, Recovery_mode::flips_only, Recovery_effort::more_time);
    assert(flipped.portrait == recover(plc, Recovery_mode::flips_only, Recovery_effort::more_points).portrait);
    recover(plc, Recovery_mode::conforming, Recovery_effort::more_points);
  }
  std::cout << "points: " << least << ", " << most << std::endl;
  assert(least > 0 && least < most && most <= 4 * least);
}
