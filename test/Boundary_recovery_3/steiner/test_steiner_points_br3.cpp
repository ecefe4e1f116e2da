// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Inputs that need Steiner points, or many of them on the way, in all the modes with both kernels, each twice and
// judged by brute force; and the parts of constraints that the mode `conforming` reports.

#undef NDEBUG

#include "constraint_parts_checker_br3.h"
#include "recover_and_judge_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/recover_boundary.h>

#include <cassert>
#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using br3_test::Plc;
using br3_test::Recovery_mode;
using br3_test::Recovery_status;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;

std::size_t number_of_failures = 0;

// Counts, to tell in the end whether the inputs are hard.
struct Hardness
{
  std::size_t inputs = 0, with_points = 0, split_edges = 0, split_facets = 0;
};

template <typename K>
void check_parts(const Plc& plc, Hardness& hardness)
{
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  std::vector<typename K::Point_3> points;
  for(const auto& c : plc.points)
    points.emplace_back(c[0], c[1], c[2]);
  Tr tr;
  const auto result = CGAL::recover_boundary(tr, points, plc.triangles,
                                             CGAL::parameters::recovery_mode(Recovery_mode::conforming),
                                             CGAL::parameters::constrained_edges(plc.edges));
  br3_test::require(result.status == Recovery_status::recovered, "not recovered by points on constraints");
  br3_test::Result_parts_checker<Tr>(plc, tr, result)();
  hardness.with_points += ! result.steiner_vertices.empty();
  hardness.split_edges += ! result.parts_of_edges.empty();
  hardness.split_facets += ! result.parts_of_facets.empty();
}

void check(const std::string& name, const Plc& plc, Hardness& hardness)
{
  try {
    br3_test::Fuzz_case fuzz_case;
    fuzz_case.plc = plc;
    br3_test::require(br3_test::recover_and_judge(fuzz_case) == Recovery_status::recovered, "not recovered");
    Hardness of_other_kernel;
    check_parts<Epick>(plc, hardness);
    check_parts<Epeck>(plc, of_other_kernel);
  } catch(const std::exception& e) {
    std::cerr << name << ": " << e.what() << std::endl;
    ++number_of_failures;
  }
  ++hardness.inputs;
}

void test_meshes()
{
  Hardness hardness;
  for(const char* name : { "schoenhardt_br3.off", "cube_br3.off", "nested_cubes_br3.off", "two_cubes_br3.off",
                           "washer_br3.off", "gear_br3.off" })
  {
    std::vector<Epick::Point_3> points;
    Plc plc;
    assert(CGAL::IO::read_polygon_soup(CGAL::data_file_path(std::string("meshes/") + name), points, plc.triangles));
    for(const auto& p : points)
      plc.points.push_back({{ p.x(), p.y(), p.z() }});
    check(name, plc, hardness);
  }
  assert(hardness.with_points >= 1);
}

void test_twisted_prisms()
{
  Hardness hardness;
  for(std::size_t n = 3; n <= 12; ++n)
    for(const double turn : { .2, .45 })
      check("prism " + std::to_string(n) + ' ' + std::to_string(turn),
            br3_test::twisted_prism(n, turn, 1000, n % 2 == 0 ? 300 : 1500), hardness);
  assert(hardness.with_points >= hardness.inputs / 2);
}

void test_notched_boxes()
{
  Hardness hardness;
  for(const int n : { 1, 2, 3 })
    for(const int gap : { 1, 2 })
      check("notched box " + std::to_string(n) + ' ' + std::to_string(gap), br3_test::Notched_box(n, gap).plc(),
            hardness);
}

// Edges with no facets to four, among points that lie in the way.
void test_fans()
{
  Hardness hardness;
  for(std::size_t blades = 0; blades <= 4; ++blades)
    for(unsigned seed = 0; seed < 4; ++seed)
      check("fan " + std::to_string(blades) + ' ' + std::to_string(seed),
            br3_test::Random_constraints(seed).fan(blades, 16), hardness);
}

// Isolated edges and facets, sheets, and what else comes together.
void test_random_constraints()
{
  Hardness hardness;
  for(unsigned seed = 0; seed < 24; ++seed)
    check("random " + std::to_string(seed),
          br3_test::Random_constraints(seed)(8 + static_cast<int>(seed) % 12, seed % 3 == 0 ? 5 : 60, 80, 60),
          hardness);
  assert(hardness.with_points >= 6 && hardness.split_edges >= 3 && hardness.split_facets >= 3);
}

// Constraints on the hull have one side only.
void test_hull()
{
  Hardness hardness;
  for(unsigned diagonals = 0; diagonals < 64; diagonals += 3)
    check("box " + std::to_string(diagonals), br3_test::box(diagonals, diagonals % 2 == 0), hardness);
  for(unsigned seed = 0; seed < 6; ++seed)
    check("flat hull " + std::to_string(seed), br3_test::flat_hull(seed, 14), hardness);
}

int main()
{
  test_meshes();
  test_twisted_prisms();
  test_notched_boxes();
  test_fans();
  test_random_constraints();
  test_hull();
  assert(number_of_failures == 0);
  std::cout << "done" << std::endl;
}
