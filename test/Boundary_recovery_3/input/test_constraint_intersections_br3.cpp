// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The intersections of constraints: named configurations, near misses, many constraints, and random soups against a
// linear program in integers.

#undef NDEBUG

#include "diagnosed_soup_br3.h"
#include "linear_program_br3.h"
#include "random_numbers_br3.h"
#include "stopping_visitor_br3.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Constraint_intersections_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Input_diagnosis_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace br3_test;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;

// An affine map with large integer entries; it keeps every coincidence, and floating point filters fail after it.
Coordinates mapped(const Coordinates& c)
{
  const double m[3][4] = { {  1048573, 524287,  -33331, 35184372088831. },
                           {  -262139, 999983,  777777, -8796093022207. },
                           {    65521, -31337, 1234567,  2199023255551. } };
  Coordinates result;
  for(int i = 0; i < 3; ++i)
    result[i] = m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2] + m[i][3];
  return result;
}

Soup mapped(Soup soup)
{
  for(Coordinates& c : soup.points)
    c = mapped(c);
  return soup;
}

// Checks a configuration of two constraints in all rotations and both orientations of both, and after the map.
template <typename K>
void check_pair(const std::string& name, const Soup& soup, const bool intersect)
{
  const std::size_t nf = soup.facets.size();
  assert(nf + soup.edges.size() == 2);
  const Strings expected = intersect ? Strings{ nf == 2 ? "f0 f1" : nf == 1 ? "e0 f0" : "e0 e1" } : Strings();
  for(int variant = 0; variant < 36; ++variant)
  {
    Soup s = soup;
    if(nf == 2 && variant % 2 == 1)
      std::swap(s.facets[0], s.facets[1]);
    if(nf == 0 && variant % 2 == 1)
      std::swap(s.edges[0], s.edges[1]);
    for(std::size_t i = 0; i < nf; ++i)
    {
      Facet& f = s.facets[i];
      std::rotate(f.begin(), f.begin() + (i == 0 ? variant / 2 : variant / 6) % 3, f.end());
      if((variant / 18 + i) % 2 == 1)
        std::reverse(f.begin(), f.end());
    }
    for(std::size_t i = 0; i < s.edges.size(); ++i)
      if((variant >> (i + 1)) % 2 == 1)
        std::reverse(s.edges[i].begin(), s.edges[i].end());
    expect(name, intersections<K>(s), expected);
    if(variant % 6 == 0)
      expect(name + ", mapped", intersections<K>(mapped(s)), expected);
  }
}

template <typename K>
void test_facet_pairs()
{
  const Facet f = {{0, 1, 2}}, disjoint = {{3, 4, 5}}, one_common = {{0, 3, 4}}, two_common = {{0, 1, 3}};
  const auto check = [&](const std::string& name, const Facet& other,
                         const std::vector<Coordinates>& others, const bool yes)
  {
    Soup soup = { {{{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}}}, { f, other }, {} };
    soup.points.insert(soup.points.end(), others.begin(), others.end());
    check_pair<K>("facet pair: " + name, soup, yes);
  };

  check("far away",              disjoint, {{{9, 9, 9}}, {{8, 9, 9}}, {{9, 8, 9}}}, false);
  check("parallel",              disjoint, {{{0, 0, 1}}, {{4, 0, 1}}, {{0, 4, 1}}}, false);
  check("boxes overlap only",    disjoint, {{{3, 3, -1}}, {{3, 3, 1}}, {{5, 5, 0}}}, false);
  check("edge pierces interior", disjoint, {{{1, 1, -1}}, {{1, 1, 1}}, {{9, 9, 0}}}, true);
  check("linked edges",          disjoint, {{{1, 1, -2}}, {{1, 1, 2}}, {{-3, -3, 0}}}, true);
  check("edge through edge",     disjoint, {{{2, 0, -1}}, {{2, 0, 1}}, {{2, -5, 0}}}, true);
  check("edge misses edge",      disjoint, {{{2, -1, -1}}, {{2, -1, 1}}, {{2, -5, 0}}}, false);
  check("vertex in interior",    disjoint, {{{1, 1, 0}}, {{0, 0, 3}}, {{4, 0, 3}}}, true);
  check("vertex above interior", disjoint, {{{1, 1, 1}}, {{0, 0, 3}}, {{4, 0, 3}}}, false);
  check("vertex on edge",        disjoint, {{{2, 0, 0}}, {{0, 0, 3}}, {{4, 0, 3}}}, true);
  check("vertex beside edge",    disjoint, {{{2, -1, 0}}, {{0, -1, 3}}, {{4, -1, 3}}}, false);
  check("edge in interior",      disjoint, {{{1, 1, 0}}, {{1, 2, 0}}, {{1, 1, 3}}}, true);
  check("edge on edge",          disjoint, {{{1, 0, 0}}, {{2, 0, 0}}, {{1, 0, 3}}}, true);
  check("edge over edge",        disjoint, {{{-1, 0, 0}}, {{6, 0, 0}}, {{1, 0, 3}}}, true);
  check("coplanar, disjoint",    disjoint, {{{5, 0, 0}}, {{7, 0, 0}}, {{5, 4, 0}}}, false);
  check("coplanar, edges cross", disjoint, {{{-1, 1, 0}}, {{5, 1, 0}}, {{2, -2, 0}}}, true);
  check("coplanar, star",        disjoint, {{{3, 3, 0}}, {{-1, 3, 0}}, {{3, -1, 0}}}, true);
  check("coplanar, contained",   disjoint, {{{1, 1, 0}}, {{2, 1, 0}}, {{1, 2, 0}}}, true);
  check("coplanar, vertex on edge",  disjoint, {{{2, 2, 0}}, {{5, 2, 0}}, {{2, 5, 0}}}, true);
  check("coplanar, edges overlap",   disjoint, {{{1, 0, 0}}, {{3, 0, 0}}, {{2, -2, 0}}}, true);

  check("common vertex only",        one_common, {{{-1, 0, 1}}, {{0, -1, 1}}}, false);
  check("common vertex, above",      one_common, {{{4, 0, 1}}, {{0, 4, 1}}}, false);
  check("common vertex, crossing",   one_common, {{{3, 1, -1}}, {{3, 1, 1}}}, true);
  check("common vertex, piercing short", one_common, {{{1, 1, -1}}, {{1, 1, 1}}}, true);
  check("common vertex, vertex in interior",  one_common, {{{1, 1, 0}}, {{0, 0, 3}}}, true);
  check("common vertex, vertex on far edge",  one_common, {{{2, 2, 0}}, {{0, 0, 3}}}, true);
  check("common vertex, edge across and out", one_common, {{{5, 5, 0}}, {{0, 0, 3}}}, true);
  check("common vertex, edge along edge",     one_common, {{{2, 0, 0}}, {{0, 0, 3}}}, true);
  check("common vertex, edge beyond edge",    one_common, {{{6, 0, 0}}, {{0, 0, 3}}}, true);
  check("common vertex, edge away from edge", one_common, {{{-6, 0, 0}}, {{0, 0, 3}}}, false);
  check("common vertex, coplanar, apart",     one_common, {{{-1, 0, 0}}, {{0, -1, 0}}}, false);
  check("common vertex, coplanar, overlap",   one_common, {{{5, 1, 0}}, {{1, 5, 0}}}, true);
  check("common vertex, coplanar, overlap on one side", one_common, {{{5, 1, 0}}, {{5, -1, 0}}}, true);
  check("common vertex, coplanar, edges touch",         one_common, {{{2, 0, 0}}, {{1, -2, 0}}}, true);

  check("common edge, dihedral",           two_common, {{{0, 0, 4}}}, false);
  check("common edge, above the facet",    two_common, {{{1, 1, 1}}}, false);
  check("common edge, flat",               two_common, {{{0, -4, 0}}}, false);
  check("common edge, folded over",        two_common, {{{3, 3, 0}}}, true);
  check("common edge, folded, contained",  two_common, {{{1, 1, 0}}}, true);
  check("common edge, folded, on an edge", two_common, {{{0, 2, 0}}}, true);
  check("common edge, folded, beyond",     two_common, {{{0, 9, 0}}}, true);
  check("same vertices",                   f, {}, false); // a duplicate, not an intersection

  // Vertices at one point are one vertex; the constraints of a soup with unmerged vertices do not all intersect.
  const Coordinates a = {{0, 0, 0}}, b = {{4, 0, 0}}, c = {{0, 4, 0}};
  check("common vertex at two indices",       disjoint, { a, {{0, -1, 0}}, {{-1, -1, 2}} }, false);
  check("common edge at four indices",        disjoint, { b, a, {{1, 1, 2}} }, false);
  check("folded over at four indices",        disjoint, { b, a, {{1, 1, 0}} }, true);
  check("same facet at six indices",          disjoint, { c, b, a }, true);
}

template <typename K>
void test_edge_facet_pairs()
{
  const Edge disjoint = {{3, 4}}, common = {{0, 3}};
  const auto check = [&](const std::string& name, const Edge& e, const std::vector<Coordinates>& others, const bool yes)
  {
    Soup soup = { {{{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}}}, {{{0, 1, 2}}}, { e } };
    soup.points.insert(soup.points.end(), others.begin(), others.end());
    check_pair<K>("edge and facet: " + name, soup, yes);
  };

  check("pierces interior",        disjoint, {{{1, 1, -1}}, {{1, 1, 1}}}, true);
  check("stops above interior",    disjoint, {{{1, 1, 1}}, {{1, 1, 2}}}, false);
  check("ends in interior",        disjoint, {{{1, 1, 0}}, {{1, 1, 2}}}, true);
  check("passes beside",           disjoint, {{{3, 3, -1}}, {{3, 3, 1}}}, false);
  check("through edge",            disjoint, {{{2, 2, -1}}, {{2, 2, 1}}}, true);
  check("ends on edge",            disjoint, {{{2, 2, 0}}, {{2, 2, 1}}}, true);
  check("vertex inside edge",      disjoint, {{{0, 0, -1}}, {{0, 0, 1}}}, true);
  check("vertex at end, two indices", disjoint, {{{0, 0, 0}}, {{0, 0, 1}}}, false);
  check("coplanar, inside",        disjoint, {{{1, 1, 0}}, {{2, 1, 0}}}, true);
  check("coplanar, across",        disjoint, {{{-1, 1, 0}}, {{5, 1, 0}}}, true);
  check("coplanar, half way in",   disjoint, {{{1, 1, 0}}, {{5, 1, 0}}}, true);
  check("coplanar, past a vertex", disjoint, {{{-1, 1, 0}}, {{1, -1, 0}}}, true);
  check("coplanar, outside",       disjoint, {{{-1, 0, 0}}, {{0, -1, 0}}}, false);
  check("collinear with an edge, apart",   disjoint, {{{5, 0, 0}}, {{7, 0, 0}}}, false);
  check("collinear with an edge, part",    disjoint, {{{1, 0, 0}}, {{7, 0, 0}}}, true);
  check("collinear with an edge, inside",  disjoint, {{{1, 0, 0}}, {{2, 0, 0}}}, true);
  check("collinear with an edge, covers",  disjoint, {{{-1, 0, 0}}, {{7, 0, 0}}}, true);

  check("common vertex, leaves",           common, {{{1, 1, 1}}}, false);
  check("common vertex, leaves in plane",  common, {{{-1, 2, 0}}}, false);
  check("common vertex, ends in interior", common, {{{1, 1, 0}}}, true);
  check("common vertex, ends on far edge", common, {{{2, 2, 0}}}, true);
  check("common vertex, across and out",   common, {{{4, 4, 0}}}, true);
  check("common vertex, along an edge",    common, {{{2, 0, 0}}}, true);
  check("common vertex, beyond an edge",   common, {{{6, 0, 0}}}, true);
  check("common vertex, other direction",  common, {{{-6, 0, 0}}}, false);
  check("edge of the facet",               {{0, 1}}, {}, false);
  check("edge of the facet, four indices", disjoint, {{{4, 0, 0}}, {{0, 0, 0}}}, false);
}

template <typename K>
void test_edge_pairs()
{
  const Edge disjoint = {{2, 3}}, common = {{0, 2}};
  const auto check = [&](const std::string& name, const Edge& e, const std::vector<Coordinates>& others, const bool yes)
  {
    Soup soup = { {{{0, 0, 0}}, {{4, 0, 0}}}, {}, { {{0, 1}}, e } };
    soup.points.insert(soup.points.end(), others.begin(), others.end());
    check_pair<K>("edge pair: " + name, soup, yes);
  };

  check("crossing",             disjoint, {{{2, -1, -1}}, {{2, 1, 1}}}, true);
  check("skew",                 disjoint, {{{2, -1, 1}}, {{2, 1, 1}}}, false);
  check("T",                    disjoint, {{{2, 0, 0}}, {{2, 1, 1}}}, true);
  check("short of a T",         disjoint, {{{2, 1, 1}}, {{2, 2, 2}}}, false);
  check("L, two indices",       disjoint, {{{4, 0, 0}}, {{2, 1, 1}}}, false);
  check("collinear, apart",     disjoint, {{{5, 0, 0}}, {{6, 0, 0}}}, false);
  check("collinear, overlap",   disjoint, {{{2, 0, 0}}, {{6, 0, 0}}}, true);
  check("collinear, contained", disjoint, {{{1, 0, 0}}, {{2, 0, 0}}}, true);
  check("parallel",             disjoint, {{{0, 1, 0}}, {{4, 1, 0}}}, false);
  check("common vertex",        common, {{{2, 1, 0}}}, false);
  check("common vertex, same direction, shorter", common, {{{2, 0, 0}}}, true);
  check("common vertex, same direction, longer",  common, {{{7, 0, 0}}}, true);
  check("common vertex, opposite direction",      common, {{{-7, 0, 0}}}, false);
  check("twice",                {{1, 0}}, {}, false);
  check("twice, four indices",  disjoint, {{{4, 0, 0}}, {{0, 0, 0}}}, false);
}

// One ulp decides.
template <typename K>
void test_near_misses()
{
  const double above_0 = std::numeric_limits<double>::denorm_min(), above_1 = std::nextafter(1., 2.);
  for(const bool touch : { true, false })
  {
    const double zero = touch ? 0. : above_0, one = touch ? 1. : above_1;
    const Strings ff = touch ? Strings{ "f0 f1" } : Strings();
    const Strings ef = touch ? Strings{ "e0 f0" } : Strings();
    const Strings ee = touch ? Strings{ "e0 e1" } : Strings();
    const Coordinates a = {{0, 0, 0}}, b = {{2, 0, 0}}, c = {{0, 2, 0}};

    expect("vertex and interior", intersections<K>({ { a, b, c, {{0.5, 0.5, zero}}, {{0, 0, 1}}, {{1, 0, 1}} },
                                                     {{{0, 1, 2}}, {{3, 4, 5}}}, {} }), ff);
    expect("fold", intersections<K>({ { a, b, c, {{0.5, 0.5, zero}} }, {{{0, 1, 2}}, {{0, 1, 3}}}, {} }), ff);
    expect("vertex and edge", intersections<K>({ { a, b, c, {{1, one, 0}}, {{3, 3, 0}}, {{3, 2, 0}} },
                                                 {{{0, 1, 2}}, {{3, 4, 5}}}, {} }), ff);
    expect("common vertex", intersections<K>({ { a, b, c, {{1, 1, zero}}, {{0, 0, 1}} },
                                               {{{0, 1, 2}}, {{0, 3, 4}}}, {} }), ff);
    expect("edge and edge of a facet", intersections<K>({ { a, b, c, {{1, one, -1}}, {{1, one, 1}} },
                                                          {{{0, 1, 2}}}, {{{3, 4}}} }), ef);
    expect("along an edge", intersections<K>({ { a, b, c, {{1, -zero, 0}} }, {{{0, 1, 2}}}, {{{0, 3}}} }), ef);
    expect("edges", intersections<K>({ { {{0, 0, 0}}, {{2, 2, 2}}, {{2, 0, 1}}, {{0, 2, one}} },
                                       {}, {{{0, 1}}, {{2, 3}}} }), ee);
    const double two = touch ? 2. : std::nextafter(2., 3.);
    expect("collinear edges", intersections<K>({ { {{1, 1, 1}}, {{4, 4, 4}}, {{2, 2, two}}, {{5, 5, 5}} },
                                                 {}, {{{0, 1}}, {{2, 3}}} }), ee);
  }
}

// Pairs of all three kinds in one soup, in order; what is said by a facet is not repeated by its edges.
template <typename K>
void test_order_of_pairs()
{
  Soup soup;
  soup.points = {{{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}}, {{1, 1, -1}},
                 {{1, 1, 1}}, {{9, 9, 0}}, {{1, 0, 0}}, {{1, 2, 0}}};
  soup.facets = {{{0, 1, 2}}, {{3, 4, 5}}};
  soup.edges = {{{6, 7}}, {{0, 1}}, {{4, 3}}, {{0, 4}}, {{7, 6}}, {{0, 5}}};
  expect("order", intersections<K>(soup), { "e0 e5", "e0 f0", "e0 f1", "e5 f0", "e5 f1", "f0 f1" });
}

// The standard fixes the engine, but not the distributions.
std::size_t draw(std::mt19937& engine, const std::size_t n) { return engine() % n; }

void test_against_linear_program()
{
  std::mt19937 engine(20260101);
  std::map<std::string, std::size_t> count; // by the letters of the pair
  std::size_t number_of_pairs = 0;
  for(int round = 0; round < 1000; ++round)
  {
    const std::size_t grid = 2 + draw(engine, 4), nv = 4 + draw(engine, 20);
    const std::size_t nf = draw(engine, 14), ne = draw(engine, 12);
    Soup soup;
    std::vector<Grid_point> points;
    for(std::size_t i = 0; i < nv; ++i)
    {
      Grid_point p;
      for(int k = 0; k < 3; ++k)
        p[k] = static_cast<Integer>(draw(engine, k == 2 && round % 3 == 0 ? 1 + grid / 3 : grid)); // or rather flat
      points.push_back(p);
      soup.points.push_back({{ double(p[0]), double(p[1]), double(p[2]) }});
    }
    for(std::size_t i = 0; i < nf; ++i)
      soup.facets.push_back({{ draw(engine, nv), draw(engine, nv), draw(engine, nv) }});
    for(std::size_t i = 0; i < ne; ++i)
      soup.edges.push_back({{ draw(engine, nv), draw(engine, nv) }});

    const Strings expected = intersections_by_linear_program(soup, points);
    expect("EPICK", intersections<Epick>(soup), expected);
    expect("EPECK", intersections<Epeck>(soup), expected);
    expect("EPICK, mapped", intersections<Epick>(mapped(soup)), expected);
    expect("EPECK, mapped", intersections<Epeck>(mapped(soup)), expected);
    for(const std::string& pair : expected)
      ++count[std::string() + pair[0] + pair[pair.find(' ') + 1]];
    number_of_pairs += (nf + ne) * (nf + ne - 1) / 2;
  }
  std::cout << "linear program: " << number_of_pairs << " pairs; intersecting: " << count["ee"] << " edge-edge, "
            << count["ef"] << " edge-facet, " << count["ff"] << " facet-facet" << std::endl;
  assert(count["ee"] > 100 && count["ef"] > 500 && count["ff"] > 500);
  assert(number_of_pairs > 2 * (count["ee"] + count["ef"] + count["ff"]));
}

// A soup that is large enough for the divide and conquer of the box intersection: a terrain, pierced here and there.
template <typename K>
void test_large_soup()
{
  const std::size_t n = 25;
  Soup soup;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
      soup.points.push_back({{ double(i), double(j), double((i * 7 + j * 5) % 3) }});
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      const std::size_t v = i * (n + 1) + j;
      soup.facets.push_back({{ v, v + n + 1, v + 1 }});
      soup.facets.push_back({{ v + n + 2, v + 1, v + n + 1 }});
    }
  expect("terrain", intersections<K>(soup), {});

  Strings expected;
  for(std::size_t k = 0; k < 2 * n * n; k += 157)
  {
    const std::size_t i = k / (2 * n), j = k / 2 % n;
    const double offset = k % 2 == 0 ? 0.25 : 0.75;
    expected.push_back('e' + std::to_string(soup.edges.size()) + " f" + std::to_string(k));
    soup.edges.push_back({{ soup.points.size(), soup.points.size() + 1 }});
    soup.points.push_back({{ double(i) + offset, double(j) + offset, -1 }});
    soup.points.push_back({{ double(i) + offset, double(j) + offset, 5 }});
  }
  expect("pierced terrain", intersections<K>(soup), expected);
}

template <typename K>
void test()
{
  test_facet_pairs<K>();
  test_edge_facet_pairs<K>();
  test_edge_pairs<K>();
  test_near_misses<K>();
  test_order_of_pairs<K>();
  test_large_soup<K>();
}

// A cone, whose triangles all have overlapping boxes, and a triangle that cuts it: stopped after some of the many
// pairs, the search says nothing.
void test_stopped_search()
{
  const std::size_t n = 100;
  internal::Indexed_input_3<Epick::Point_3> input;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * CGAL_PI * static_cast<double>(i) / n;
    input.points.push_back(Epick::Point_3(std::cos(angle), std::sin(angle), 0));
    input.facets.push_back({{ i, (i + 1) % n, n }});
  }
  for(const double x : { 0, 3, -3 })
    input.points.push_back(Epick::Point_3(x, 0, x == 0 ? 100 : 50));
  input.points.push_back(Epick::Point_3(0, 3, 50));
  input.facets.push_back({{ n + 1, n + 2, n + 3 }});

  typedef internal::Constraint_intersections_3<Epick> Intersections;
  const Epick kernel;
  const Intersections intersections(input, kernel);
  std::vector<Intersections::Simplex> cone;
  for(std::size_t f = 0; f < n; ++f)
    cone.push_back(internal::describe_facet(input, f));

  Soup_visitor patient;
  Context context(patient);
  assert(all_defects(intersections, context).size() > 1);
  const std::size_t number_of_questions = patient.number_of_questions;
  assert(number_of_questions > 1 && ! context.is_stopped());
  assert(intersections.have_defects(cone, context, unlimited));
  for(std::size_t k = 0; k < number_of_questions; ++k)
  {
    Soup_visitor visitor;
    visitor.last_question = k;
    Context stopped_context(visitor);
    assert(all_defects(intersections, stopped_context).empty());
    assert(stopped_context.is_stopped());
    assert(! intersections.have_defects(cone, stopped_context, unlimited));
  }
}

// Of a bounded list, the pairs are the first ones of all. Whether there are more is known.
void test_bounded_list()
{
  internal::Indexed_input_3<Epick::Point_3> input;
  const std::size_t n = 40;
  for(std::size_t i = 0; i < 2 * n; ++i)
  {
    const double at = static_cast<double>(i % n) / n;
    for(const double x : { -9, 9 })
      input.points.push_back(i < n ? Epick::Point_3(x, at, -1) : Epick::Point_3(at, x, 1));
    input.points.push_back(i < n ? Epick::Point_3(0, at, 9) : Epick::Point_3(at, 0, -9));
    input.facets.push_back({{ 3 * i, 3 * i + 1, 3 * i + 2 }});
  }
  typedef internal::Constraint_intersections_3<Epick> Intersections;
  const Epick kernel;
  const Intersections intersections(input, kernel);
  Soup_visitor patient;
  Context context(patient);
  const auto all = all_defects(intersections, context);
  assert(all.size() == n * n);
  for(const std::size_t max_number : { std::size_t(0), std::size_t(1), n + 1, n * n - 1, n * n, n * n + 1 })
  {
    std::size_t number = 0;
    const auto first = intersections.defects(context, max_number, number);
    const std::size_t expected = (std::min)(max_number, n * n);
    assert(number >= expected && number <= n * n && (number > max_number) == (n * n > max_number));
    assert(full_text(first) == full_text(decltype(all)(all.begin(), all.begin() + expected)));
  }
}

// A question that is given up has no answer.
void test_search_that_is_given_up()
{
  internal::Indexed_input_3<Epick::Point_3> input;
  typedef internal::Constraint_intersections_3<Epick> Intersections;
  std::vector<Intersections::Simplex> some;
  const std::size_t n = 40;
  for(std::size_t i = 0; i < n; ++i) // triangles with a common corner, so that all boxes intersect
  {
    const double x = static_cast<double>(i);
    input.points.insert(input.points.end(), { Epick::Point_3(0, 0, 0), Epick::Point_3(1, x, x * x),
                                              Epick::Point_3(1, x + .5, x * x) });
    input.facets.push_back({{ 3 * i, 3 * i + 1, 3 * i + 2 }});
    some.push_back(internal::describe_facet(input, i));
  }
  const Epick kernel;
  Soup_visitor patient;
  Context context(patient);
  assert(! Intersections(input, kernel).have_defects(some, context, unlimited));
  input.points.insert(input.points.end(), { Epick::Point_3(.5, .1, -9), Epick::Point_3(.5, .1, 9) });
  input.edges.push_back({{ 3 * n, 3 * n + 1 }});
  const Intersections intersections(input, kernel);
  assert(intersections.have_defects(some, context, unlimited));
  assert(intersections.have_defects(some, context, 2 * (n + 1) * (n + 1)));
  assert(! intersections.have_defects(some, context, 1));
}

// A sample is everything if that is not much, and else some of it. It is the same in each run, but not the same twice.
void test_samples()
{
  internal::Indexed_input_3<Epick::Point_3> input;
  const std::size_t n = 100;
  input.points.assign(n + 3, Epick::Point_3(0, 0, 0));
  internal::Lost_constraints from;
  for(std::size_t i = 0; i < n; ++i)
  {
    input.facets.push_back({{ i, i + 1, i + 2 }});
    input.edges.push_back({{ i, i + 3 }});
    if(i % 2 == 1)
      from.facets.push_back(i);
    if(i % 4 == 2)
      from.edges.push_back(i);
  }
  const std::size_t number_in_all = n / 2 + n / 4;
  internal::Constraint_sample sample, same_sample;
  for(const std::size_t number : { number_in_all, n })
    assert(sample(input, from, number).size() == number_in_all);
  assert(sample(input, internal::Lost_constraints(), n).empty() && sample(input, from, 0).empty());

  std::set<std::pair<int, std::size_t> > seen;
  std::set<std::vector<std::size_t> > samples;
  for(int k = 0; k < 50; ++k)
  {
    const auto some = sample(input, from, 16), same = same_sample(input, from, 16);
    assert(some.size() == 16);
    std::vector<std::size_t> indices;
    for(std::size_t i = 0; i < some.size(); ++i)
    {
      const auto& s = some[i];
      assert(s.index == same[i].index && s.dimension == same[i].dimension);
      assert(s.index % (s.dimension == 2 ? 2 : 4) == (s.dimension == 2 ? 1 : 2) && s.vertices[0] == s.index);
      seen.emplace(s.dimension, s.index);
      indices.push_back(s.index);
    }
    samples.insert(indices);
  }
  assert(seen.size() == number_in_all && samples.size() == 50);
}

// The pairs of boxes that intersect, against their definition, among all boxes and between some and the others.
void test_box_search(const unsigned seed, const std::size_t n)
{
  typedef std::set<std::pair<std::size_t, std::size_t> > Pairs;
  std::mt19937 rng(seed);
  std::vector<CGAL::Bbox_3> bboxes;
  std::vector<internal::Numbered_box_3> all, some, others;
  for(std::size_t i = 0; i < n; ++i)
  {
    std::array<double, 6> c; // boxes of integers touch each other now and then
    for(std::size_t k = 0; k < 3; ++k)
    {
      c[k] = random_int(rng, 30);
      c[k + 3] = c[k] + random_int(rng, 5);
    }
    bboxes.push_back(CGAL::Bbox_3(c[0], c[1], c[2], c[3], c[4], c[5]));
    all.emplace_back(bboxes[i], i);
    (i % 3 == 0 ? some : others).emplace_back(bboxes[i], i);
  }
  Pairs expected, expected_between;
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
      if(i != j && CGAL::do_overlap(bboxes[i], bboxes[j]))
      {
        if(i < j)
          expected.emplace(i, j);
        if(i % 3 == 0 && j % 3 != 0)
          expected_between.emplace(i, j);
      }

  Soup_visitor patient, impatient;
  Context context(patient), stopped_context(impatient);
  Pairs found;
  std::size_t max_number = n * n;
  const auto visit = [&](const std::size_t i, const std::size_t j)
  {
    assert(found.emplace(i, j).second);
    return found.size() < max_number;
  };
  const auto visit_sorted = [&](const std::size_t i, const std::size_t j)
  {
    return visit((std::min)(i, j), (std::max)(i, j));
  };
  internal::visit_intersecting_boxes(all, visit_sorted, context);
  assert(found == expected && expected.size() > 2048);
  found.clear();
  internal::visit_intersecting_boxes(some, others, visit, context);
  assert(found == expected_between && expected_between.size() > 20);

  max_number = 10;
  found.clear();
  internal::visit_intersecting_boxes(all, visit_sorted, context);
  assert(found.size() == max_number);
  found.clear();
  internal::visit_intersecting_boxes(some, others, visit, context);
  assert(found.size() == max_number && ! context.is_stopped());

  max_number = n * n;
  impatient.last_question = 1;
  found.clear();
  internal::visit_intersecting_boxes(all, visit_sorted, stopped_context);
  assert(found.size() == 2047 && stopped_context.is_stopped()); // short steps, of which each 1024th leads to a question
}

int main()
{
  test<Epick>();
  test<Epeck>();
  test_against_linear_program();
  test_stopped_search();
  test_bounded_list();
  test_search_that_is_given_up();
  test_samples();
  test_box_search(1, 3000);
  std::cout << "done" << std::endl;
}
