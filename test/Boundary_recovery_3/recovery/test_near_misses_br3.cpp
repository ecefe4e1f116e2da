// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Constraints that touch are invalid, and one unit in the last place apart they are valid; vertices that are exactly on
// an isolated edge, and next to it; coordinates that are not finite.

#undef NDEBUG
#define CGAL_NO_ASSERTIONS // with assertions, CGAL itself refuses to make an EPECK number from a NaN

#include "recover_and_judge_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <vector>

using br3_test::Coordinates;
using br3_test::Fuzz_case;
using br3_test::Recovery_status;
typedef CGAL::Boundary_recovery_3::Input_defect_kind Kind;

const double infinity = std::numeric_limits<double>::infinity();

// Moves one coordinate of the last point by one ulp away from and into the others; `away` is the side that is free.
// The checker compares the list of pairs with its own.
void check_touch(Fuzz_case c, const int coordinate, const double away)
{
  double& x = c.plc.points.back()[coordinate];
  for(const bool is_list_wanted : { false, true })
  {
    c.is_list_of_defects_wanted = is_list_wanted;
    assert(br3_test::recover_and_judge(c) == Recovery_status::invalid_input);
    const double touching = x;
    x = std::nextafter(touching, away);
    assert(br3_test::recover_and_judge(c) != Recovery_status::invalid_input);
    x = std::nextafter(touching, -away);
    assert(br3_test::recover_and_judge(c) == Recovery_status::invalid_input);
    x = touching;
  }
}

Fuzz_case two_triangles(const Coordinates& p, const Coordinates& q, const Coordinates& r)
{
  Fuzz_case c;
  c.plc.points = { {{ 0, 0, 1 }}, {{ 4, 0, 1 }}, {{ 0, 4, 1 }}, p, q, r };
  c.plc.triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  return c;
}

void test_touching_triangles()
{
  check_touch(two_triangles({{ 3, 3, 4 }}, {{ 1, 2, 5 }}, {{ 1, 1, 1 }}), 2, infinity);        // a corner in a facet
  check_touch(two_triangles({{ 3, 3, -4 }}, {{ 1, 2, -5 }}, {{ 1, 1, 1 }}), 2, -infinity);     // from below
  check_touch(two_triangles({{ -3, 1, 4 }}, {{ -3, 2, -4 }}, {{ 0, 1, 1 }}), 0, -infinity);    // a corner on a rim
}

void test_touching_edges()
{
  Fuzz_case c;
  c.plc.points = { {{ 0, 0, 1 }}, {{ 4, 0, 1 }}, {{ 0, 4, 1 }}, {{ 1, 1, 5 }}, {{ 1, 1, 1 }} };
  c.plc.triangles = { { 0, 1, 2 } };
  c.plc.edges = { { 3, 4 } };
  check_touch(c, 2, infinity); // the end of an edge in a facet

  c.plc.points = { {{ 0, 0, 1 }}, {{ 4, 0, 1 }}, {{ 0, 4, 1 }}, {{ 2, -4, 5 }}, {{ 2, 0, 1 }} };
  check_touch(c, 1, -infinity); // the end of an edge on an edge of a facet; the step is the smallest double
}

// Two isolated edges that cross have to be in a plane, so that a step to either side parts them.
void test_crossing_edges()
{
  Fuzz_case c;
  c.plc.points = { {{ -2, 0, 1 }}, {{ 2, 0, 1 }}, {{ 0, 0, 9 }}, {{ 0, -2, 1 }}, {{ 0, 2, 1 }} };
  c.plc.edges = { { 0, 1 }, { 3, 4 } };
  assert(br3_test::recover_and_judge(c) == Recovery_status::invalid_input);
  for(const double to : { 0., infinity })
  {
    Fuzz_case near = c;
    near.plc.points.back()[2] = std::nextafter(1., to);
    assert(br3_test::recover_and_judge(near) != Recovery_status::invalid_input);
  }
}

// A vertex of the triangulation that is no input point, exactly on an isolated edge.
template <typename K>
void test_foreign_vertex_on_isolated_edge()
{
  typedef typename K::Point_3 P;
  const std::vector<P> points = { P(0, 0, 1), P(4, 2, 3), P(9, 0, 0), P(0, 9, 0), P(0, 0, 9) };
  const std::vector<std::vector<std::size_t> > no_triangles;
  const std::vector<std::vector<std::size_t> > edges = { { 2, 3 }, { 0, 1 } };
  for(const double z : { 2., std::nextafter(2., 0.), std::nextafter(2., 9.) })
  {
    CGAL::Delaunay_triangulation_3<K> tr;
    const auto foreign = tr.insert(P(2, 1, z));
    const auto result = CGAL::recover_boundary(tr, points, no_triangles, CGAL::parameters::constrained_edges(edges));
    assert((result.status == Recovery_status::invalid_input) == (z == 2));
    assert(foreign->point() == P(2, 1, z));
    if(z != 2)
      continue;
    assert(result.defects.size() == 1);
    const auto& defect = result.defects.front();
    assert(defect.kind == Kind::intersecting_constraints && defect.simplices.size() == 2);
    assert(defect.simplices[0].dimension == 0 && defect.simplices[0].index == std::size_t(-1));
    assert(defect.simplices[0].points.size() == 1 && defect.simplices[0].points[0] == foreign->point());
    assert(defect.simplices[1].dimension == 1 && defect.simplices[1].index == 1);
    assert(defect.simplices[1].vertices == edges[1]);
  }
}

// In any coordinate, used by a constraint or not, all such vertices are named and the triangulation is left alone.
template <typename K>
void test_non_finite_coordinates()
{
  typedef typename K::Point_3 P;
  const std::vector<std::vector<std::size_t> > triangles = { { 0, 1, 2 }, { 0, 1, 3 } };
  for(const double bad : { infinity, -infinity, std::numeric_limits<double>::quiet_NaN() })
    for(int i = 0; i < 3; ++i)
      for(const std::size_t v : { 0, 3, 4 })
      {
        std::vector<P> points = { P(0, 0, 0), P(4, 0, 0), P(0, 4, 0), P(0, 0, 4), P(9, 9, 9) };
        points[v] = P(i == 0 ? bad : 1., i == 1 ? bad : 1., i == 2 ? bad : 1.);
        CGAL::Delaunay_triangulation_3<K> tr;
        const auto result = CGAL::recover_boundary(tr, points, triangles);
        assert(result.status == Recovery_status::invalid_input && result.defects.size() == 1);
        assert(result.defects[0].kind == Kind::non_finite_coordinate && result.defects[0].simplices.size() == 1);
        assert(result.defects[0].simplices[0].dimension == 0 && result.defects[0].simplices[0].index == v);
        assert(tr.number_of_vertices() == 0);
      }
}

int main()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
  typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;
  test_touching_triangles();
  test_touching_edges();
  test_crossing_edges();
  test_foreign_vertex_on_isolated_edge<Epick>();
  test_foreign_vertex_on_isolated_edge<Epeck>();
  test_non_finite_coordinates<Epick>();
  test_non_finite_coordinates<Epeck>();
  std::cout << "done" << std::endl;
}
