// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The judge of the fuzz target has to see every kind of fault: good outcomes are spoilt in many ways.

#undef NDEBUG

#include "brute_force_checker_br3.h"
#include "recovery_of_oracles_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <cassert>
#include <iostream>
#include <string>
#include <vector>

using namespace br3_test;
typedef CGAL::Exact_predicates_exact_constructions_kernel K;
typedef K::Point_3                                        P;
typedef CGAL::Delaunay_triangulation_3<K>                 Tr;
typedef CGAL::Triangulation_3<K, Tr::Triangulation_data_structure> Base;
typedef Brute_force_checker<Tr>                           Checker;
typedef Checker::Mode                                     Mode;
typedef Checker::Status                                   Status;

// Two apices over and under a triangle, three facets of which are constraints.
Plc example()
{
  Plc plc;
  plc.points = { {{ 0, 0, 0 }}, {{ 6, 0, 0 }}, {{ 0, 6, 0 }}, {{ 1, 1, -1 }}, {{ 1, 1, 1 }} };
  plc.triangles = { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 4 } };
  return plc;
}

// Runs the checker on an outcome that f has spoilt, and returns its complaint.
template <typename F>
std::string complaint(const Mode mode, const F& f)
{
  const Plc plc = example();
  Tr tr;
  std::vector<P> points;
  for(const Coordinates& c : plc.points)
    points.emplace_back(c[0], c[1], c[2]);
  Checker::Earlier_vertices earlier;
  auto result = CGAL::recover_boundary(tr, points, plc.triangles,
                                       CGAL::parameters::recovery_mode(Mode::flips_only));
  f(tr, result, earlier);
  const Expectation expectation(plc);
  assert(! expectation.is_invalid());
  try {
    Checker(plc, expectation, mode, tr, earlier, result)();
  } catch(const Complaint& e) {
    return e.what();
  }
  return std::string();
}

void test_faults()
{
  const auto spoilt = [](const auto& f) { return complaint(Mode::constrained, f); };
  assert(spoilt([](auto&, auto&, auto&) { }).empty());
  assert(spoilt([](auto&, auto& r, auto&) { r.status = Status::incomplete; }) == "the status contradicts the lists");
  assert(spoilt([](auto&, auto& r, auto&) { r.status = Status::invalid_input; }) == "a valid input was refused");
  assert(spoilt([](auto&, auto& r, auto&)
  {
    r.missing_facets.emplace_back();
    r.missing_facets[0].dimension = 2;
    r.missing_facets[0].index = 0;
    r.missing_facets[0].vertices = { 0, 1, 2 };
  }) == "a constraint is there, but is listed as missing");
  assert(spoilt([](auto&, auto& r, auto&) { std::swap(r.vertices[0], r.vertices[1]); }) == "a vertex is elsewhere");
  assert(spoilt([](auto&, auto& r, auto&) { r.steiner_vertices.push_back(r.vertices[0]); })
         == "a Steiner vertex is an input vertex, or is listed twice");
  assert(spoilt([](auto&, auto& r, auto& e) { e.emplace_back(r.vertices[0], P(0, 0, 1)); })
         == "an earlier vertex has moved");
  assert(spoilt([](auto&, auto& r, auto&) { ++r.number_of_facets; }) == "constrained facets are miscounted");
  assert(spoilt([](auto&, auto& r, auto&) { ++r.number_of_edges; }) == "constrained edges are miscounted");
  assert(spoilt([](auto&, auto& r, auto&) { r.vertices[4]->set_point(P(1, 1, -9)); }) == "a cell is flat or inverted");
  assert(spoilt([](auto&, auto& r, auto&) { r.vertices[4]->set_point(P(1, 1, 2)); })
         == "the cells do not fill the convex hull");
  assert(spoilt([](auto& t, auto&, auto&) { t.insert(P(1, 2, 0)); })
         == "a vertex is neither an input vertex nor a listed Steiner vertex");
}

// A point inside the first triangle, which is inside the hull.
void test_steiner_points()
{
  const auto split = [](Tr& tr, auto& result, auto&)
  {
    Tr::Cell_handle c;
    int i, j, k;
    assert(tr.is_facet(result.vertices[0], result.vertices[1], result.vertices[2], c, i, j, k));
    Base& base = tr; // not by Delaunay insertion
    result.steiner_vertices.push_back(base.insert_in_facet(P(1, 2, 0), c, 6 - i - j - k));
  };
  assert(complaint(Mode::conforming, split).empty());
  assert(complaint(Mode::flips_only, split) == "a Steiner vertex without permission");
  assert(complaint(Mode::constrained, split) == "a constraint is not there, and is not listed as missing");
  assert(complaint(Mode::conforming, [&](Tr& tr, auto& result, auto& earlier)
  {
    split(tr, result, earlier);
    result.missing_facets.emplace_back();
    result.missing_facets[0].dimension = 2;
    result.missing_facets[0].index = 0;
    result.missing_facets[0].vertices = { 0, 1, 2 };
  }) == "a constraint is there, but is listed as missing");
}

int main()
{
  test_faults();
  test_steiner_points();
  std::cout << "done" << std::endl;
}
