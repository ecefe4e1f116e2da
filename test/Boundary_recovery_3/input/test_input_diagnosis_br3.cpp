// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The diagnosis of bad input: each kind of defect, near misses, soups with many defects, and the intersections of
// constraints against a linear program in integers.

#undef NDEBUG
#define CGAL_NO_ASSERTIONS // with assertions, CGAL itself refuses to make an EPECK number from a NaN

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Boundary_recovery_3/internal/input/Constraint_intersections_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Input_diagnosis_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

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
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = CGAL::Boundary_recovery_3::internal;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;

typedef std::array<double, 3>      Coordinates;
typedef std::array<std::size_t, 3> Facet;
typedef std::array<std::size_t, 2> Edge;
typedef std::vector<std::string>   Strings;

const double nan_value = std::numeric_limits<double>::quiet_NaN();
const double infinite_value = std::numeric_limits<double>::infinity();

// A kernel-free input.
struct Soup
{
  std::vector<Coordinates> points;
  std::vector<Facet> facets;
  std::vector<Edge> edges;
};

template <typename K>
internal::Indexed_input_3<typename K::Point_3> to_input(const Soup& soup)
{
  internal::Indexed_input_3<typename K::Point_3> input;
  for(const Coordinates& c : soup.points)
    input.points.emplace_back(c[0], c[1], c[2]);
  input.facets = soup.facets;
  input.edges = soup.edges;
  return input;
}

// "kind v0 e1 f2": the kind and the dimension and index of each simplex.
template <typename Defects>
Strings names(const Defects& defects)
{
  Strings result;
  for(const auto& defect : defects)
  {
    std::ostringstream os;
    os << to_string(defect.kind);
    for(const auto& simplex : defect.simplices)
      os << ' ' << "vef"[simplex.dimension] << simplex.index;
    result.push_back(os.str());
  }
  return result;
}

template <typename Defects>
std::string full_text(const Defects& defects)
{
  std::ostringstream os;
  for(const auto& defect : defects)
    os << defect << '\n';
  return os.str();
}

// Checks that the simplices carry the vertices and, unless one is missing or not finite, the points of the input.
template <typename Input, typename Defects>
void check_contents(const Input& input, const Defects& defects)
{
  const auto is_equal = [](const auto& a, const auto& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
  for(const auto& defect : defects)
    for(const auto& s : defect.simplices)
    {
      if(s.dimension == 0)
        assert(s.vertices == std::vector<std::size_t>(1, s.index));
      else if(s.dimension == 1)
        assert(is_equal(s.vertices, input.edges[s.index]));
      else
        assert(is_equal(s.vertices, input.facets[s.index]));

      const bool complete = std::all_of(s.vertices.begin(), s.vertices.end(), [&](std::size_t v)
        { return v < input.points.size() && internal::has_finite_coordinates(input.points[v]); });
      assert(s.points.size() == (complete ? s.vertices.size() : 0));
      for(std::size_t i = 0; i < s.points.size(); ++i)
        assert(s.points[i] == input.points[s.vertices[i]]);
    }
}

template <typename K>
Strings simple(const Soup& soup, const bool check_dimension = true)
{
  const auto input = to_input<K>(soup);
  const auto defects = internal::simple_defects(input, K(), check_dimension);
  check_contents(input, defects);
  assert(full_text(defects) == full_text(internal::simple_defects(to_input<K>(soup), K(), check_dimension)));
  return names(defects);
}

struct Stopping_visitor
{
  bool go_further() { return number_of_questions++ != last_question; }

  std::size_t number_of_questions = 0;
  std::size_t last_question = std::size_t(-1);
};

typedef internal::Recovery_context<Stopping_visitor> Context;

template <typename K, typename Input>
std::vector<BR3::Input_defect_3<typename K::Point_3> > intersecting_constraints(const Input& input)
{
  Stopping_visitor visitor;
  Context context(visitor);
  return internal::intersecting_constraints(input, K(), context);
}

// Asked for one constraint, the search has to say whether a defect names it.
template <typename K, typename Input, typename Defects>
void check_single_constraints(const Input& input, const Defects& defects)
{
  typedef internal::Constraint_intersections_3<K> Intersections;
  std::set<std::pair<int, std::size_t> > named;
  for(const auto& d : defects)
    for(const auto& s : d.simplices)
      named.emplace(s.dimension, s.index);

  const K kernel;
  const Intersections intersections(input, kernel);
  Stopping_visitor visitor;
  Context context(visitor);
  const auto check = [&](const typename Intersections::Simplex& s)
  {
    assert(intersections.have_defects({ s }, context) == (named.count({ s.dimension, s.index }) > 0));
  };
  std::vector<typename Intersections::Simplex> all;
  for(std::size_t f = 0; f < input.facets.size(); ++f)
    all.push_back(internal::describe_facet(input, f));
  for(std::size_t e = 0; e < input.edges.size(); ++e)
    all.push_back(internal::describe_edge(input, e));
  std::for_each(all.begin(), all.end(), check);
  assert(intersections.have_defects(all, context) == ! defects.empty());
  assert(! intersections.have_defects({}, context));
}

template <typename K>
Strings intersections(const Soup& soup)
{
  const auto input = to_input<K>(soup);
  const auto defects = intersecting_constraints<K>(input);
  check_contents(input, defects);
  check_single_constraints<K>(input, defects);
  assert(full_text(defects) == full_text(intersecting_constraints<K>(to_input<K>(soup))));

  Strings result;
  const std::string kind = "intersecting_constraints ";
  for(const std::string& name : names(defects))
  {
    assert(name.compare(0, kind.size(), kind) == 0);
    result.push_back(name.substr(kind.size()));
  }
  return result;
}

void expect(const std::string& what, const Strings& found, const Strings& expected)
{
  if(found == expected)
    return;
  std::cerr << what << ":\n";
  for(const std::string& s : found)
    std::cerr << "  found    " << s << '\n';
  for(const std::string& s : expected)
    std::cerr << "  expected " << s << '\n';
  assert(found == expected);
}

// --------------------------------------------------------------------------------------------------------------------
// simple defects

const std::vector<Coordinates> tetrahedron = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
const std::vector<Facet> tetrahedron_facets = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};

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

// --------------------------------------------------------------------------------------------------------------------
// intersections: named configurations

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

// --------------------------------------------------------------------------------------------------------------------
// intersections: random soups on a small grid, against a linear program

typedef long long               Integer;
typedef std::array<Integer, 3>  Grid_point;
typedef std::vector<Grid_point> Grid_simplex;

// Solves the system of 5 equations `sum x_j columns[j] = rhs` by fraction-free elimination. Returns false if the
// columns are dependent or there is no solution, else the solution as `x[j] / denominator`, positive denominator.
bool solve(const std::vector<std::array<Integer, 5> >& columns, const std::array<Integer, 5>& rhs,
           std::vector<Integer>& x, Integer& denominator)
{
  const std::size_t n = columns.size();
  std::array<std::vector<Integer>, 5> m;
  for(std::size_t i = 0; i < 5; ++i)
  {
    for(const auto& column : columns)
      m[i].push_back(column[i]);
    m[i].push_back(rhs[i]);
  }

  Integer previous = 1;
  for(std::size_t k = 0; k < n; ++k)
  {
    std::size_t pivot = k;
    while(pivot < 5 && m[pivot][k] == 0)
      ++pivot;
    if(pivot == 5)
      return false;
    std::swap(m[k], m[pivot]);
    for(std::size_t i = 0; i < 5; ++i)
      if(i != k)
      {
        const Integer factor = m[i][k];
        for(std::size_t j = 0; j <= n; ++j)
        {
          const Integer minor = m[k][k] * m[i][j] - factor * m[k][j];
          assert(minor % previous == 0);
          m[i][j] = minor / previous;
        }
      }
    previous = m[k][k];
  }
  for(std::size_t i = n; i < 5; ++i)
    if(m[i][n] != 0)
      return false;

  const Integer sign = previous < 0 ? -1 : 1;
  denominator = sign * previous;
  x.resize(n);
  for(std::size_t k = 0; k < n; ++k)
    x[k] = sign * m[k][n];
  return true;
}

// Is there a common point of the simplices with a positive barycentric coordinate at a vertex of s that is none of t?
// Such a point is a feasible point of the linear program "sum l_i s_i = sum m_j t_j, sum l = sum m = 1, l, m >= 0".
// If there is one, one of the corners of that polytope is one; the corners are the nonnegative basic solutions.
bool intersect_by_linear_program(const Grid_simplex& s, const Grid_simplex& t)
{
  const std::size_t n = s.size() + t.size();
  std::array<Integer, 5> rhs = {{0, 0, 0, 1, 1}};
  for(unsigned subset = 1; subset < (1u << n); ++subset)
  {
    std::vector<std::array<Integer, 5> > columns;
    std::vector<bool> counts;
    for(std::size_t i = 0; i < n; ++i)
      if((subset >> i) & 1u)
      {
        const bool in_s = i < s.size();
        const Grid_point& p = in_s ? s[i] : t[i - s.size()];
        const Integer sign = in_s ? 1 : -1;
        columns.push_back({{ sign * p[0], sign * p[1], sign * p[2], in_s, ! in_s }});
        counts.push_back(in_s && std::find(t.begin(), t.end(), p) == t.end());
      }
    std::vector<Integer> x;
    Integer denominator;
    if(columns.size() > 5 || ! solve(columns, rhs, x, denominator) || *std::min_element(x.begin(), x.end()) < 0)
      continue;
    for(std::size_t i = 0; i < x.size(); ++i)
      if(counts[i] && x[i] > 0)
        return true;
  }
  return false;
}

struct Grid_constraint
{
  std::string name;
  Grid_simplex points;               // sorted
  std::vector<std::size_t> vertices; // sorted
};

bool is_degenerate(const Grid_simplex& s)
{
  if(s.size() == 2)
    return s[0] == s[1];
  Integer u[3], v[3];
  for(int i = 0; i < 3; ++i)
  {
    u[i] = s[1][i] - s[0][i];
    v[i] = s[2][i] - s[0][i];
  }
  return u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2];
}

template <typename Vertices>
Grid_constraint grid_constraint(const char letter, const std::size_t index, const Vertices& vertices,
                                const std::vector<Grid_point>& points)
{
  Grid_constraint result = { letter + std::to_string(index), {}, { vertices.begin(), vertices.end() } };
  for(const std::size_t v : vertices)
    result.points.push_back(points[v]);
  std::sort(result.points.begin(), result.points.end());
  std::sort(result.vertices.begin(), result.vertices.end());
  return result;
}

// All pairs, by definition: O(n^2) and no geometry but the linear program.
Strings intersections_by_linear_program(const Soup& soup, const std::vector<Grid_point>& points)
{
  std::vector<Grid_constraint> facets, constraints;
  for(std::size_t i = 0; i < soup.facets.size(); ++i)
    facets.push_back(grid_constraint('f', i, soup.facets[i], points));
  facets.erase(std::remove_if(facets.begin(), facets.end(),
                              [](const Grid_constraint& c) { return is_degenerate(c.points); }), facets.end());

  for(std::size_t i = 0; i < soup.edges.size(); ++i)
  {
    const Grid_constraint e = grid_constraint('e', i, soup.edges[i], points);
    const auto contains = [&](const Grid_constraint& c)
      { return std::includes(c.points.begin(), c.points.end(), e.points.begin(), e.points.end()); };
    if(! is_degenerate(e.points) && std::none_of(facets.begin(), facets.end(), contains) &&
       std::none_of(constraints.begin(), constraints.end(), contains))
      constraints.push_back(e);
  }
  constraints.insert(constraints.end(), facets.begin(), facets.end());

  Strings result;
  for(std::size_t i = 0; i < constraints.size(); ++i)
    for(std::size_t j = i + 1; j < constraints.size(); ++j)
    {
      const Grid_constraint& a = constraints[i];
      const Grid_constraint& b = constraints[j];
      // Equal point sets have a trivial program: no vertex is left to be positive at.
      if(a.points == b.points ? a.vertices != b.vertices : intersect_by_linear_program(a.points, b.points))
        result.push_back(a.name + ' ' + b.name);
    }
  return result;
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
  const std::size_t n = 50;
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
  for(std::size_t k = 0; k < 2 * n * n; k += 617)
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

  Stopping_visitor patient;
  Context context(patient);
  assert(intersections.defects(context).size() > 1);
  const std::size_t number_of_questions = patient.number_of_questions;
  assert(number_of_questions > 1 && ! context.is_stopped());
  assert(intersections.have_defects(cone, context));
  for(std::size_t k = 0; k < number_of_questions; ++k)
  {
    Stopping_visitor visitor;
    visitor.last_question = k;
    Context stopped_context(visitor);
    assert(intersections.defects(stopped_context).empty());
    assert(stopped_context.is_stopped());
    assert(! intersections.have_defects(cone, stopped_context));
  }
}

int main()
{
  test_point_representatives<CGAL::Simple_cartesian<float> >(2);
  test_point_representatives<CGAL::Simple_cartesian<long double> >(3);
  test<Epick>();
  test<Epeck>();
  test_exact_number_beyond_double();
  test_against_linear_program();
  test_stopped_search();
  std::cout << "done" << std::endl;
  return 0;
}
