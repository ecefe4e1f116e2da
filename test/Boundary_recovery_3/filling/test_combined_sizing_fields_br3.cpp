// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Minima of size fields, bounds of them, and fields that differ between regions, made of fields of all kinds, and of
// each other.

#undef NDEBUG

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Combined_sizing_fields_3.h>
#include <CGAL/Boundary_recovery_3/Source_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_constant_domain_field_3.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

namespace Boundary_recovery_3 = CGAL::Boundary_recovery_3;

const double infinity = std::numeric_limits<double>::infinity();
const double nan_size = std::numeric_limits<double>::quiet_NaN();

// Sizes that grow along x, and say by how much.
template <typename GT>
struct Slope
{
  double operator()(const typename GT::Point_3& p) const { return 1 + slope * CGAL::to_double(p.x()); }

  double grading() const { return slope; }

  double slope;
};

// What the mesher gets from a field.
template <typename GT, typename Field>
double ask(const Field& field, const typename GT::Point_3& p, const int region)
{
  typedef typename CGAL::Boundary_constrained_mesh_triangulation_3<GT>::type Tr;
  const Boundary_recovery_3::internal::Any_size_field_3<GT, Field> any_field(field);
  return Boundary_recovery_3::internal::Size_query_3<Tr>(any_field)(p, 3, region);
}

template <typename GT>
void test_minimum()
{
  typedef typename GT::Point_3 Point_3;
  using Boundary_recovery_3::make_minimum_sizing_field;
  const Point_3 p(10, 0, 0), q(0, 0, 0);
  const Slope<GT> flat = { .1 }, steep = { .5 };
  const auto of_region = [](const Point_3&, int, const int region) { return double(region); };
  const auto field = make_minimum_sizing_field<GT>(5, flat, std::cref(steep), of_region);
  assert(ask<GT>(field, p, 1) == 1 && ask<GT>(field, p, 7) == 2 && ask<GT>(field, q, 7) == 1);
  assert(field.grading() == infinity && make_minimum_sizing_field<GT>(5, flat, std::cref(steep)).grading() == .5);
  assert(make_minimum_sizing_field<GT>(3.5).grading() == 0 && ask<GT>(make_minimum_sizing_field<GT>(3.5), p, 1) == 3.5);
  for(const double invalid : { 0., -1., nan_size, -infinity })
  {
    assert(std::isnan(ask<GT>(make_minimum_sizing_field<GT>(invalid, flat), p, 1)));
    assert(std::isnan(ask<GT>(make_minimum_sizing_field<GT>(flat, invalid, 3), p, 1)));
  }
  assert(ask<GT>(make_minimum_sizing_field<GT>(infinity, flat), p, 1) == 2);
  assert(make_minimum_sizing_field<GT>(5, std::cref(flat)).least_size_around(p, 3, 1) == ask<GT>(flat, p, 1) - .1 * 3);
  assert(make_minimum_sizing_field<GT>(5, flat).least_size_around(p, 1000, 1) == 0);
  assert(field.least_size_around(p, 0, 1) == 0); // the last one does not tell
}

template <typename GT>
void test_bounds()
{
  typedef typename GT::Point_3 Point_3;
  using Boundary_recovery_3::make_bounded_sizing_field;
  const auto size = [](const Point_3& p) { return p.x(); };
  const auto field = make_bounded_sizing_field<GT>(size, 2, 4);
  assert(ask<GT>(field, Point_3(1, 0, 0), 1) == 2 && ask<GT>(field, Point_3(3, 0, 0), 1) == 3);
  assert(ask<GT>(field, Point_3(9, 0, 0), 1) == 4 && field.grading() == infinity);
  assert(std::isnan(ask<GT>(field, Point_3(0, 0, 0), 1)) && std::isnan(ask<GT>(field, Point_3(-1, 0, 0), 1)));
  assert(ask<GT>(make_bounded_sizing_field<GT>(size, 0, infinity), Point_3(9, 0, 0), 1) == 9);
  const Slope<GT> slope = { .25 };
  assert(make_bounded_sizing_field<GT>(slope, 2, 4).grading() == .25);
  assert(make_bounded_sizing_field<GT>(std::cref(slope), 2, 4).grading() == .25);
  assert(make_bounded_sizing_field<GT>(slope, 2, 4).least_size_around(Point_3(9, 0, 0), .1, 1)
         == (std::min)((std::max)(ask<GT>(slope, Point_3(9, 0, 0), 1) - .25 * .1, 2.), 4.));
  assert(field.least_size_around(Point_3(3, 0, 0), .1, 1) == 0);
  // no size anywhere, but one that is allowed
  typedef Boundary_recovery_3::Source_sizing_field_3<GT> Sources;
  assert(ask<GT>(make_bounded_sizing_field<GT>(Sources({ }), 2, 4), Point_3(0, 0, 0), 1) == 4);
  assert(std::isnan(ask<GT>(make_bounded_sizing_field<GT>(Sources({ }, -1), 2, 4), Point_3(0, 0, 0), 1)));
}

template <typename GT>
void test_regions()
{
  typedef typename GT::Point_3 Point_3;
  typedef std::variant<int, std::pair<int, int> > Index;
  const Point_3 p(10, 0, 0);
  Boundary_recovery_3::Region_sizing_field_3<GT> field(8);
  assert(ask<GT>(field, p, 1) == 8 && field.grading() == 0);
  field.set_field(2, Slope<GT>{ .1 });
  field.set_field(3, .5);
  assert(ask<GT>(field, p, 1) == 8 && ask<GT>(field, p, 2) == 2 && ask<GT>(field, p, 3) == .5 && field.grading() == .1);
  assert(field(p, 3, 2) == 2 && field(p, 2, 2) == .5);
  assert(field.least_size_around(p, 2, 1) == 8 && field.least_size_around(p, 2, 2) == 2 - .1 * 2);
  CGAL::Mesh_constant_domain_field_3<GT, Index> of_cgal(4);
  of_cgal.set_size(3, 3, 2);
  field.set_field(2, of_cgal);
  assert(ask<GT>(field, p, 2) == 3 && field.grading() == infinity);

  // made of each other, and with exceptions, which get through
  const auto bounded = Boundary_recovery_3::make_bounded_sizing_field<GT>(field, 1, 5);
  const auto combined = Boundary_recovery_3::make_minimum_sizing_field<GT>(bounded, 4.5);
  assert(ask<GT>(combined, p, 1) == 4.5 && ask<GT>(combined, p, 2) == 3 && ask<GT>(combined, p, 3) == 1);
  field.set_field(3, [](const Point_3&) -> double { throw std::runtime_error("none"); });
  try
  {
    field(p, 3, 3);
    assert(false);
  }
  catch(const std::runtime_error&)
  { }
}

int main()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
  typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;
  test_minimum<Epick>();
  test_bounds<Epick>();
  test_regions<Epick>();
  test_minimum<Epeck>();
  test_bounds<Epeck>();
  test_regions<Epeck>();
  std::cout << "done" << std::endl;
  return 0;
}
