// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The sizes around sources are those of the formulas, with distances that CGAL computes; text files are read as they
// are documented, and what is wrong in them is told.

#undef NDEBUG

#include "time_growth_br3.h"

#include <CGAL/Boundary_recovery_3/Size_source_3.h>
#include <CGAL/Boundary_recovery_3/Source_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using CGAL::Boundary_recovery_3::Size_growth;
using CGAL::Boundary_recovery_3::Size_source_3;
using CGAL::Boundary_recovery_3::Source_sizing_field_3;
using CGAL::Boundary_recovery_3::read_size_sources;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
typedef Kernel::Point_3 Point_3;
typedef Size_source_3<Kernel> Source;
typedef Source_sizing_field_3<Kernel> Field;

const double infinity = std::numeric_limits<double>::infinity();

// within 0 and 1
double random_number(std::mt19937& rng) { return rng() / 4294967296.; }

Point_3 random_place(std::mt19937& rng, const double size)
{
  return Point_3(size * random_number(rng), size * random_number(rng), size * random_number(rng));
}

Exact_kernel::Point_3 exact(const Point_3& p) { return Exact_kernel::Point_3(p.x(), p.y(), p.z()); }

// by CGAL, with exact numbers
double distance(const Source& s, const Point_3& p)
{
  const Exact_kernel::Point_3 a = exact(s.vertex(0)), b = exact(s.vertex(1)), c = exact(s.vertex(2)), q = exact(p);
  switch(s.shape())
  {
    case Source::Shape::point:
      return std::sqrt(CGAL::to_double(CGAL::squared_distance(a, q)));
    case Source::Shape::segment:
      return std::sqrt(CGAL::to_double(CGAL::squared_distance(Exact_kernel::Segment_3(a, b), q)));
    case Source::Shape::triangle:
      return std::sqrt(CGAL::to_double(CGAL::squared_distance(Exact_kernel::Triangle_3(a, b, c), q)));
    default:
    {
      Exact_kernel::FT sum = 0;
      for(int i = 0; i < 3; ++i)
      {
        const Exact_kernel::FT lower = (std::min)(a[i], b[i]), upper = (std::max)(a[i], b[i]);
        const Exact_kernel::FT d = q[i] < lower ? lower - q[i] : q[i] > upper ? q[i] - upper : Exact_kernel::FT(0);
        sum += d * d;
      }
      return std::sqrt(CGAL::to_double(sum));
    }
  }
}

// as it is documented; the smallest one within a distance of the point
double size_around(const Source& s, const Point_3& p, const double radius = 0)
{
  const double d = distance(s, p) - radius, beyond = (std::max)(0., d - s.radius());
  return s.growth().is_linear() ? s.size() + s.growth().value() * beyond
                                : s.size() * std::exp(std::log(2.) * beyond / (s.growth().value() - s.radius()));
}

double brute_force(const std::vector<Source>& sources, const double background, const Point_3& p,
                   const double radius = 0)
{
  double smallest = background;
  for(const Source& s : sources)
    smallest = (std::min)(smallest, size_around(s, p, radius));
  return smallest;
}

Source random_source(std::mt19937& rng, const double size)
{
  const Point_3 a = random_place(rng, size);
  const auto near = [&] { return a + .2 * (random_place(rng, size) - random_place(rng, size)); };
  const double s = size * std::pow(10., -1 - 3 * random_number(rng));
  const double r = rng() % 3 == 0 ? 0 : .05 * size * random_number(rng);
  const Size_growth growth = rng() % 2 == 0 ? Size_growth::linear(.5 * random_number(rng))
                                            : Size_growth::doubling_at(r + size * (.01 + random_number(rng)));
  switch(rng() % 4)
  {
    case 0:  return Source::point(a, s, r, growth);
    case 1:  return Source::segment(a, near(), s, r, growth);
    case 2:  return Source::triangle(a, near(), near(), s, r, growth);
    default: return Source::box(a, near(), s, r, growth);
  }
}

void test_random_sources(const int n, const double size, const double background, const int number_of_queries)
{
  std::mt19937 rng(static_cast<unsigned>(n));
  std::vector<Source> sources;
  for(int i = 0; i < n; ++i)
    sources.push_back(random_source(rng, size));
  const Field field(sources, background);
  assert(field.is_valid());
  for(int k = 0; k < number_of_queries; ++k)
  {
    const Point_3 p = k % 4 == 0 ? random_place(rng, 10 * size) : k % 4 == 1 ? sources[rng() % n].vertex(0)
                                                                : random_place(rng, size);
    const double value = field(p), expected = brute_force(sources, background, p);
    assert(std::abs(value - expected) <= 1e-9 * expected || value == expected);
    assert(value == field(p) && value == field(p, 3, 1) && value <= background);
    const double radius = size * std::pow(random_number(rng), 3);
    const double least = field.least_size_around(p, radius, 1), right = brute_force(sources, background, p, radius);
    assert(std::abs(least - right) <= 1e-9 * right || least == right);
    assert(least <= value && field.least_size_around(p, 0, 1) == value);
  }
  if(background < infinity)
    for(int k = 0; k < 1000; ++k)
    {
      const Point_3 p = random_place(rng, size), q = p + random_number(rng) * (random_place(rng, size) - p);
      assert(std::abs(field(p) - field(q)) <= field.grading() * std::sqrt(CGAL::squared_distance(p, q)) * (1 + 1e-9));
    }
}

// Places right above, inside and beside shapes with and without an extent.
void test_shapes()
{
  const Size_growth growth = Size_growth::linear(1);
  const Point_3 a(0, 0, 0), b(4, 0, 0), c(0, 3, 0);
  std::vector<Source> shapes = { Source::point(a, 1, 0, growth), Source::segment(a, b, 1, 0, growth),
                                 Source::segment(a, a, 1, 0, growth), Source::triangle(a, b, c, 1, 0, growth),
                                 Source::triangle(c, b, a, 1, 0, growth), Source::box(a, b, 1, 0, growth),
                                 Source::box(b, Point_3(0, 3, -2), 1, 0, growth) };
  // CGAL 5.5 does not know the distance to triangles without an area: they are as the longest side
  const Source line = Source::triangle(a, b, Point_3(1, 0, 0), 1, 0, growth);
  const Source dot = Source::triangle(b, b, b, 1, 0, growth);
  for(int x = -1; x <= 5; ++x)
    for(int y = -1; y <= 5; ++y)
      for(int z = -3; z <= 2; ++z)
      {
        const Point_3 p(x, y, z);
        for(const Source& s : shapes)
          assert(std::abs(Field({ s })(p) - size_around(s, p)) <= 1e-14);
        assert(std::abs(Field({ line })(p) - size_around(shapes[1], p)) <= 1e-14);
        assert(std::abs(Field({ dot })(p) - 1 - std::sqrt(CGAL::squared_distance(p, b))) <= 1e-14);
      }
}

void test_formulas()
{
  const Source linear = Source::point(Point_3(1, 0, 0), .5, 2, Size_growth::linear(.25));
  const Source doubling = Source::point(Point_3(1, 0, 0), .5, 2, Size_growth::doubling_at(5));
  const Field lines({ linear }), powers({ doubling }), both({ linear, doubling }, .75);
  assert(lines(Point_3(1, 0, 0)) == .5 && lines(Point_3(1, 2, 0)) == .5 && lines(Point_3(1, 0, 6)) == 1.5);
  assert(powers(Point_3(1, 0, 0)) == .5 && powers(Point_3(-1, 0, 0)) == .5);
  assert(std::abs(powers(Point_3(1, 5, 0)) - 1) < 1e-14 && std::abs(powers(Point_3(1, 0, 11)) - 4) < 1e-14);
  assert(both(Point_3(1, 0, 100)) == .75);
  assert(lines.grading() == .25 && powers.grading() == infinity);
  assert(std::abs(both.grading() - .25) < 1e-14 && Field({ doubling }, .5).grading() == 0);
  assert(std::abs(Field({ doubling }, 6).grading() - 6 * std::log(2.) / 3) < 1e-14);
}

void test_validity()
{
  const Size_growth growth = Size_growth::linear(0);
  const Point_3 p(0, 0, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Source> invalid;
  for(const double x : { 0., -1., nan, infinity })
    invalid.push_back(Source::point(p, x, 1, growth));
  for(const double x : { -1., nan, infinity })
  {
    invalid.push_back(Source::point(p, 1, x, growth));
    invalid.push_back(Source::point(p, 1, 1, Size_growth::linear(x)));
    invalid.push_back(Source::point(p, 1, 1, Size_growth::doubling_at(x)));
  }
  invalid.push_back(Source::point(p, 1, 1, Size_growth::doubling_at(1)));
  for(const Source& s : invalid)
  {
    const Field field({ Source::point(p, 1, 0, growth), s });
    assert(! s.is_valid() && ! field.is_valid() && std::isnan(field(p)));
  }
  for(const double x : { 0., -1., nan })
    assert(! Field({ }, x).is_valid() && std::isnan(Field({ }, x)(p)));
  assert(Field({ }).is_valid() && Field({ })(p) == infinity && Field({ }, 2)(p) == 2 && Field({ }, 2).grading() == 0);
}

bool read(const std::string& text, std::vector<Source>& sources, std::string& message)
{
  std::istringstream in(text);
  message.clear();
  return read_size_sources(in, sources, message);
}

void test_reading()
{
  std::vector<Source> sources;
  std::string message;
  assert(read("# all kinds\n"
              "point 1 2 3 .5 .25 .125\r\n"
              "\n"
              "  segment\t1 2 3 4 5 6   1e-3 0 0 # behind it\n"
              "triangle 1 2 3 4 5 6 7 8 9 1 2 doubling 3\n"
              "box 1 2 3 -1 -2 -3 1 2 +3", sources, message));
  assert(message.empty() && sources.size() == 4);
  assert(sources[0].shape() == Source::Shape::point && sources[0].vertex(0) == Point_3(1, 2, 3));
  assert(sources[0].size() == .5 && sources[0].radius() == .25 && sources[0].growth().value() == .125);
  assert(sources[1].shape() == Source::Shape::segment && sources[1].vertex(1) == Point_3(4, 5, 6));
  assert(sources[1].size() == 1e-3 && sources[1].radius() == 0 && sources[1].growth().value() == 0);
  assert(sources[2].shape() == Source::Shape::triangle && sources[2].vertex(2) == Point_3(7, 8, 9));
  assert(! sources[2].growth().is_linear() && sources[2].growth().value() == 3 && sources[1].growth().is_linear());
  assert(sources[3].shape() == Source::Shape::box && sources[3].vertex(1) == Point_3(-1, -2, -3));

  // what others write with all digits, and nothing at all
  assert(read("point 0.10000000000000001 -0 1e+300 4.9406564584124654e-324 0 0.10000000000000001\n", sources, message));
  assert(sources.size() == 5 && sources[4].vertex(0).x() == .1);
  assert(read("", sources, message) && read("# nothing", sources, message) && sources.size() == 5);
}

void test_messages()
{
  const std::vector<std::vector<std::string> > cases =
    { { "sphere 1 2 3 1 0 0", "line 2: 'sphere' is not a source; sources are point, segment, triangle, and box" },
      { "point 1 2 3 1 0", "line 2: a point has 3 coordinates, a size, a radius, and a growth: a number, or 'doubling' "
                           "and a distance" },
      { "segment 1 2 3 1 0 0", "line 2: a segment has 6 coordinates" },
      { "triangle 1 2 3 1 0 0", "line 2: a triangle has 9 coordinates" },
      { "box 1 2 3 1 2 z 1 0 0", "line 2: a box has 6 coordinates" },
      { "point 1 2 3 1 0 doubling", "line 2: a point has 3" },
      { "point 1 2 3 1 0 growing 3", "line 2: a point has 3" },
      { "point 1 2 1e999 1 0 0", "line 2: a point has 3" },
      { "point 1 2 nan 1 0 0", "line 2: a point has 3" },
      { "point 1,5 2 3 1 0 0", "line 2: a point has 3" },
      { "point 1 2 3 1 0 0 0", "line 2: '0' behind the growth" },
      { "point 1 2 3 1 0 0x", "line 2: 'x' behind the growth" },
      { "point 1 2 3 1 0 doubling 2 m", "line 2: 'm' behind the growth" },
      { "point 1 2 3 0 0 0", "line 2: the size is not a positive number" },
      { "point 1 2 3 -1 0 0", "line 2: the size is not a positive number" },
      { "point 1 2 3 1 -1 0", "line 2: the radius is negative" },
      { "point 1 2 3 1 0 -1", "line 2: the growth is negative" },
      { "point 1 2 3 1 2 doubling 2", "line 2: the distance where the size has doubled is not larger than the "
                                      "radius" } };
  for(const auto& text : cases)
  {
    std::vector<Source> sources(1, Source::point(Point_3(0, 0, 0), 1, 0, Size_growth::linear(0)));
    std::string message;
    assert(! read("point 1 2 3 1 0 0\n" + text[0] + "\npoint 1 2 3 1 0 0\n", sources, message));
    assert(message.substr(0, text[1].size()) == text[1] && sources.size() == 1);
  }
  std::vector<Source> sources;
  std::string message;
  std::istringstream closed("point 1 2 3 1 0 0\n");
  closed.setstate(std::ios::badbit);
  assert(! read_size_sources(closed, sources, message) && message == "line 1: it cannot be read");
}

// The same place, with a growth of its own or not, and a size or a radius that is.
Source changed(const Source& s, const double size, const double radius, const Size_growth& growth)
{
  switch(s.shape())
  {
    case Source::Shape::point:    return Source::point(s.vertex(0), size, radius, growth);
    case Source::Shape::segment:  return Source::segment(s.vertex(0), s.vertex(1), size, radius, growth);
    case Source::Shape::triangle: return Source::triangle(s.vertex(0), s.vertex(1), s.vertex(2), size, radius, growth);
    default:                      return Source::box(s.vertex(0), s.vertex(1), size, radius, growth);
  }
}

// Sources that are at the same place as others, equal ones among them, count where they are smaller.
void test_sources_at_one_place()
{
  std::mt19937 rng(5);
  std::vector<Source> sources;
  for(int i = 0; i < 10; ++i)
  {
    const Source s = random_source(rng, 1);
    sources.insert(sources.end(), 3, s);
    for(const double size : { .5, 1., 2. })
      for(const double radius : { s.radius(), .3 * s.radius(), .2 })
      {
        sources.push_back(changed(s, size * s.size(), radius, s.growth()));
        sources.push_back(changed(s, size * s.size(), radius, Size_growth::linear(.1)));
        sources.push_back(changed(s, size * s.size(), radius, Size_growth::doubling_at(2)));
      }
  }
  std::shuffle(sources.begin(), sources.end(), rng);
  sources.erase(std::remove_if(sources.begin(), sources.end(), [](const Source& s) { return ! s.is_valid(); }),
                sources.end());
  assert(sources.size() > 250);
  const Field field(sources, .3);
  for(int k = 0; k < 2000; ++k)
  {
    const Point_3 p = random_place(rng, k % 2 == 0 ? 1 : 4);
    const double expected = brute_force(sources, .3, p);
    assert(std::abs(field(p) - expected) <= 1e-9 * expected);
  }
}

double time_of_questions(const std::vector<Source>& sources)
{
  const Field field(sources, 3);
  return br3_test::time_of([&]
  {
    for(int k = 0; k < 500; ++k)
      assert(field(Point_3(.01 * k, 1, 1)) <= 3);
  });
}

// Many sources at one place take no more time than one.
void test_time_of_sources_at_one_place()
{
  std::vector<Source> equal, different;
  for(int i = 0; i < 10000; ++i)
  {
    equal.push_back(Source::point(Point_3(1, 2, 3), .1, .2, Size_growth::linear(.2)));
    different.push_back(Source::point(Point_3(1, 2, 3), .1 + .0001 * (i % 1000), .0001 * (i % 77),
                                      Size_growth::doubling_at(2)));
  }
  for(const auto* const many : { &equal, &different })
  {
    const std::vector<Source> few(many->begin(), many->begin() + 10);
    assert(br3_test::exponent(time_of_questions(few), time_of_questions(*many), 1000) < .4);
  }
}

// Exact numbers are rounded to the nearest floating point numbers.
void test_exact_kernel()
{
  typedef Size_source_3<Exact_kernel> Exact_source;
  std::vector<Exact_source> sources;
  std::string message;
  std::istringstream in("point 1 2 3 1 0 .5");
  assert(read_size_sources(in, sources, message));
  const Source_sizing_field_3<Exact_kernel> field(sources);
  assert(field(Exact_kernel::Point_3(1, 2, 5)) == 2 && field(Exact_kernel::Point_3(1, 2, 5), 3, 1) == 2);
}

int main()
{
  for(const int n : { 1, 5, 8, 9, 40 })
    test_random_sources(n, 1, n % 2 == 0 ? .3 : infinity, 300);
  test_random_sources(300, 1, .3, 300);
  test_random_sources(20, 1e9, infinity, 200);
  test_random_sources(20, 1e-9, 1e-10, 200);
  test_sources_at_one_place();
  test_time_of_sources_at_one_place();
  test_shapes();
  test_formulas();
  test_validity();
  test_reading();
  test_messages();
  test_exact_kernel();
  std::cout << "done" << std::endl;
  return 0;
}
