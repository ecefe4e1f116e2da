// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The defects of input that are seen without comparing constraints: each kind, near misses, and soups with many of
// them; and that what has them is not said to intersect.

#undef NDEBUG
#define CGAL_NO_ASSERTIONS // with assertions, CGAL itself refuses to make an EPECK number from a NaN

#include "diagnosed_soup_br3.h"

#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Input_diagnosis_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

using namespace br3_test;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;

const double nan_value = std::numeric_limits<double>::quiet_NaN();
const double infinite_value = std::numeric_limits<double>::infinity();

const std::vector<Coordinates> tetrahedron = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
const std::vector<Facet> tetrahedron_facets = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};

template <typename K>
Strings simple(const Soup& soup, const bool check_dimension = true)
{
  const auto input = to_input<K>(soup);
  const auto defects = internal::simple_defects(input, K(), check_dimension);
  check_contents(input, defects);
  assert(full_text(defects) == full_text(internal::simple_defects(to_input<K>(soup), K(), check_dimension)));
  return names(defects);
}

Soup with_point(Soup soup, const Coordinates& c)
{
  soup.points.push_back(c);
  return soup;
}

template <typename K>
void test_clean_input()
{
  const Soup soup = { tetrahedron, tetrahedron_facets, {} };
  expect("clean", simple<K>(soup), {});
  expect("clean", intersections<K>(soup), {});

  // An edge twice, in both directions, or beside its facet; vertices that no constraint uses, even at a used point.
  Soup harmless = { tetrahedron, {{{0, 1, 2}}}, {{{0, 1}}, {{1, 0}}, {{2, 3}}, {{3, 2}}} };
  harmless = with_point(with_point(harmless, {{1, 0, 0}}), {{1, 0, 0}});
  expect("harmless", simple<K>(harmless), {});
  expect("harmless", intersections<K>(harmless), {});

  // Edges alone are an input.
  expect("edges only", simple<K>({ tetrahedron, {}, {{{0, 1}}, {{2, 3}}} }), {});
}

template <typename K>
void test_empty_input()
{
  expect("nothing", simple<K>(Soup()), { "empty_input" });
  expect("points only", simple<K>({ tetrahedron, {}, {} }), { "empty_input" });
  expect("nothing", intersections<K>(Soup()), {});
  // The points of an empty input are looked at all the same.
  expect("bad points only", simple<K>({ {{{0, nan_value, 0}}}, {}, {} }),
         { "empty_input", "non_finite_coordinate v0" });
}

template <typename K>
void test_non_finite_coordinates()
{
  for(const double bad : { nan_value, -nan_value, infinite_value, -infinite_value })
    for(int i = 0; i < 3; ++i)
    {
      Soup soup = { tetrahedron, tetrahedron_facets, {{{2, 3}}} };
      soup.points[2][i] = bad;
      expect("used vertex", simple<K>(soup), { "non_finite_coordinate v2" });
      expect("used vertex", intersections<K>(soup), {});

      Coordinates unused = {{0, 0, 0}};
      unused[i] = bad;
      expect("unused vertex", simple<K>(with_point({ tetrahedron, tetrahedron_facets, {} }, unused)),
             { "non_finite_coordinate v4" });
    }

  // The report can be written; EPECK cannot write a NaN.
  Soup soup = { tetrahedron, tetrahedron_facets, {} };
  soup.points[0][0] = nan_value;
  soup.facets.push_back({{0, 1, 2}});
  assert(full_text(internal::simple_defects(to_input<K>(soup), K()))
         == "non_finite_coordinate: vertex 0\nduplicate_facet: facet 0 [0 2 1] and facet 4 [0 1 2]\n");

  // Huge and tiny is not infinite.
  const double huge = (std::numeric_limits<double>::max)(), tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<Coordinates> extremes = {{{-huge, 0, 0}}, {{huge, 0, 0}}, {{0, huge, 0}}, {{0, 0, tiny}}};
  expect("huge", simple<K>({ extremes, tetrahedron_facets, {} }), {});
}

void test_exact_number_beyond_double()
{
  const Epeck::FT ten_300 = 1e300;
  internal::Indexed_input_3<Epeck::Point_3> input = to_input<Epeck>({ tetrahedron, tetrahedron_facets, {} });
  input.points[1] = Epeck::Point_3(ten_300 * ten_300, 0, 0);
  input.points[2] = Epeck::Point_3(0, - ten_300 * ten_300, 0);
  assert(internal::simple_defects(input, Epeck()).empty());
  assert(intersecting_constraints<Epeck>(input).empty());

  // Exact coordinates that no double can tell from those of the facet they touch or miss.
  const Epeck::FT third = Epeck::FT(1) / 3, less = third - Epeck::FT(1e-200);
  for(const Epeck::FT& z : { third, less })
  {
    input = to_input<Epeck>({ {}, {{{0, 1, 2}}}, {{{3, 4}}} });
    input.points = { Epeck::Point_3(0, 0, third), Epeck::Point_3(3, 0, third), Epeck::Point_3(0, 3, third),
                     Epeck::Point_3(1, 1, z), Epeck::Point_3(1, 1, -1) };
    assert((intersecting_constraints<Epeck>(input).size() == 1) == (z == third));
  }
}

template <typename K>
void test_indices()
{
  const std::size_t none = std::size_t(-1);
  const Soup soup = { tetrahedron, {{{0, 1, 2}}, {{0, 1, 4}}, {{none, 0, 1}}}, {{{3, 2}}, {{0, 4}}, {{7, 8}}} };
  expect("out of range", simple<K>(soup), { "index_out_of_range e1", "index_out_of_range e2",
                                            "index_out_of_range f1", "index_out_of_range f2" });
  expect("out of range", intersections<K>(soup), {});

  // What is out of range is named once, however bad it is.
  expect("out of range only", simple<K>({ {}, {{{5, 5, 6}}, {{5, 6, 5}}}, {{{5, 5}}} }),
         { "index_out_of_range e0", "index_out_of_range f0", "index_out_of_range f1" });
}

template <typename K>
void test_degenerate_facets()
{
  Soup soup = { tetrahedron, tetrahedron_facets, {} };
  soup = with_point(with_point(soup, {{0.25, 0, 0}}), {{0.5, 0, 0}});
  soup.facets.insert(soup.facets.end(),
                     { {{0, 0, 1}}, {{0, 1, 0}}, {{1, 0, 0}}, {{3, 3, 3}}, {{0, 4, 5}}, {{5, 4, 1}} });
  expect("degenerate facets", simple<K>(soup),
         { "degenerate_facet f4", "degenerate_facet f5", "degenerate_facet f6", "degenerate_facet f7",
           "degenerate_facet f8", "degenerate_facet f9", "duplicate_facet f4 f5", "duplicate_facet f4 f6" });
  expect("degenerate facets", intersections<K>(soup), {});

  // One ulp off the line is enough.
  for(const double z : { 0., std::numeric_limits<double>::denorm_min() })
    expect("ulp", simple<K>({ {{{1, 1, 1}}, {{2, 2, 2}}, {{3, 3, 3 + z}}, {{1, 0, z}}, {{0, 0, 0}}, {{2, 0, 0}}},
                              {{{3, 4, 5}}, {{0, 3, 4}}}, {} }),
           z == 0 ? Strings{ "degenerate_facet f0", "dimension_less_than_3" } : Strings());
  const double above_3 = std::nextafter(3., 4.);
  const Soup oblique = { {{{1, 1, 1}}, {{2, 2, 2}}, {{3, 3, above_3}}, {{0, 1, 0}}}, {{{0, 1, 2}}, {{0, 1, 3}}}, {} };
  expect("ulp", simple<K>(oblique), {});

  // A repeated index is seen even where the coordinates are no help.
  soup = { tetrahedron, {{{0, 2, 2}}, {{0, 1, 2}}}, {{{2, 2}}} };
  soup.points[2][1] = nan_value;
  expect("repeated and not finite", simple<K>(soup),
         { "non_finite_coordinate v2", "degenerate_facet f0", "degenerate_edge e0" });
}

template <typename K>
void test_degenerate_edges()
{
  Soup soup = { tetrahedron, tetrahedron_facets, {{{1, 2}}, {{1, 1}}, {{4, 3}}} };
  expect("degenerate edges", simple<K>(with_point(soup, {{0, 0, 1}})),
         { "degenerate_edge e1", "degenerate_edge e2", "coincident_vertices v3 v4" });
  expect("no edge", intersections<K>(with_point(soup, {{0, 0, 1}})), {});
  expect("one ulp", simple<K>(with_point(soup, {{0, 0, std::nextafter(1., 2.)}})), { "degenerate_edge e1" });
}

template <typename K>
void test_duplicate_facets()
{
  Soup soup = { tetrahedron, tetrahedron_facets, {} };
  soup.facets.insert(soup.facets.end(), { {{3, 2, 1}}, {{0, 1, 3}}, {{2, 1, 3}}, {{2, 3, 1}} });
  expect("duplicates", simple<K>(soup), { "duplicate_facet f1 f5", "duplicate_facet f2 f4",
                                          "duplicate_facet f2 f6", "duplicate_facet f2 f7" });
  expect("duplicates", intersections<K>(soup), {});

  // equal sums of indices, and one out of range
  soup = with_point(with_point({ tetrahedron, {{{0, 1, 5}}, {{0, 2, 4}}, {{1, 2, 3}}, {{1, 2, 9}}, {{2, 9, 1}}}, {} },
                               {{3, 1, 2}}), {{-2, 5, 1}});
  expect("other facets", simple<K>(soup), { "index_out_of_range f3", "index_out_of_range f4" });
}

// By hashing and by sorting, against the definition.
template <typename K>
void test_point_representatives(const unsigned seed)
{
  std::mt19937 rng(seed);
  Soup soup;
  std::vector<char> used;
  for(int i = 0; i < 200; ++i)
  {
    Coordinates c;
    for(double& x : c)
      x = rng() % 3 == 0 ? -0. : static_cast<double>(rng() % 4) - 1.5;
    soup.points.push_back(c);
    used.push_back(rng() % 5 != 0);
  }
  const auto representatives = internal::point_representatives(to_input<K>(soup), used, K());
  for(std::size_t v = 0; v < used.size(); ++v)
  {
    std::size_t first = v;
    for(std::size_t w = 0; w < v && used[v] && first == v; ++w)
      if(used[w] && soup.points[w] == soup.points[v])
        first = w;
    assert(representatives[v] == first);
  }
}

template <typename K>
void test_coincident_vertices()
{
  Soup soup = { tetrahedron, tetrahedron_facets, {} };
  soup = with_point(with_point(with_point(soup, {{1, 0, 0}}), {{0, 0, 0}}), {{1, 0, 0}});
  expect("unused", simple<K>(soup), {});

  soup.edges = {{{3, 6}}, {{5, 2}}, {{3, 4}}};
  expect("coincident", simple<K>(soup),
         { "coincident_vertices v0 v5", "coincident_vertices v1 v4", "coincident_vertices v1 v6" });
  expect("the edges are edges of facets all the same", intersections<K>(soup), {});

  soup.points[4][0] = soup.points[6][0] = std::nextafter(1., 0.);
  soup.points[5][0] = -std::numeric_limits<double>::denorm_min();
  expect("one ulp", simple<K>(soup), { "coincident_vertices v4 v6" });

  // -0 is 0.
  soup.points[5][0] = -0.;
  expect("zeros", simple<K>(soup), { "coincident_vertices v0 v5", "coincident_vertices v4 v6" });
}

template <typename K>
void test_dimension()
{
  const Strings flat = { "dimension_less_than_3" };
  Soup soup = { {{{0, 0, 0}}, {{1, 2, 3}}, {{3, 2, 1}}, {{4, 4, 4}}, {{1, 1, 2}}}, {{{0, 1, 2}}, {{1, 2, 3}}}, {} };
  expect("planar, but not a point that no constraint uses", simple<K>(soup), {});
  soup.points.pop_back();
  expect("planar", simple<K>(soup), flat);
  expect("planar, but not the triangulation", simple<K>(soup, false), {});
  soup.points[3][2] = std::nextafter(4., 5.);
  expect("one ulp off the plane", simple<K>(soup), {});

  expect("collinear", simple<K>({ {{{0, 0, 0}}, {{1, 1, 1}}, {{2, 2, 2}}}, {}, {{{0, 1}}, {{1, 2}}} }), flat);
  expect("a point", simple<K>({ tetrahedron, {}, {{{0, 0}}} }), { "degenerate_edge e0" });
  expect("one facet and a point", simple<K>({ tetrahedron, {{{1, 2, 3}}}, {} }), {});
  expect("a facet and an edge", simple<K>({ tetrahedron, {{{0, 1, 2}}}, {{{3, 0}}} }), {});

  // An unknown vertex may be off the plane.
  expect("out of range", simple<K>({ tetrahedron, {{{1, 2, 3}}, {{1, 2, 4}}}, {} }), { "index_out_of_range f1" });
  soup = { tetrahedron, tetrahedron_facets, {} };
  soup.points[3][0] = infinite_value;
  expect("not finite", simple<K>(soup), { "non_finite_coordinate v3" });
}

template <typename K>
void test_many_defects()
{
  Soup soup = { tetrahedron, tetrahedron_facets, {} };
  soup.points.insert(soup.points.end(), { {{nan_value, 0, 0}}, {{0, 0, 1}}, {{2, 0, 0}}, {{0, infinite_value, 0}} });
  soup.facets.insert(soup.facets.end(),
                     { {{3, 1, 0}}, {{0, 9, 1}}, {{0, 1, 6}}, {{5, 1, 0}}, {{4, 0, 1}}, {{1, 1, 2}} });
  soup.edges = {{{5, 5}}, {{8, 0}}, {{0, 6}}, {{7, 0}}, {{2, 6}}};
  expect("many", simple<K>(soup),
         { "non_finite_coordinate v4", "non_finite_coordinate v7", "index_out_of_range e1", "index_out_of_range f5",
           "degenerate_facet f6", "degenerate_facet f9", "degenerate_edge e0",
           "duplicate_facet f1 f4", "coincident_vertices v3 v5" });
  // The edge 0 6 runs along the edge 0 1 of facets; facet 7 is facet 1 and facet 4 with another vertex.
  expect("many", intersections<K>(soup), { "e2 f0", "e2 f1", "e2 f2", "e2 f4", "e2 f7", "f1 f7", "f4 f7" });
}

template <typename K>
void test()
{
  test_clean_input<K>();
  test_empty_input<K>();
  test_non_finite_coordinates<K>();
  test_indices<K>();
  test_degenerate_facets<K>();
  test_degenerate_edges<K>();
  test_duplicate_facets<K>();
  test_point_representatives<K>(1);
  test_coincident_vertices<K>();
  test_dimension<K>();
  test_many_defects<K>();
}

int main()
{
  test_point_representatives<CGAL::Simple_cartesian<float> >(2);
  test_point_representatives<CGAL::Simple_cartesian<long double> >(3);
  test<Epick>();
  test<Epeck>();
  test_exact_number_beyond_double();
  std::cout << "done" << std::endl;
}
