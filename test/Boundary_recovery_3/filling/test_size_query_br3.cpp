// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Size fields of all kinds are asked in the way that they want it, those of CGAL among them; what they return in vain,
// and what they throw, is noticed once.

#undef NDEBUG

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_constant_domain_field_3.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/Adaptive_remeshing_sizing_field.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/Uniform_sizing_field.h>
#include <CGAL/tetrahedral_remeshing.h>
#else
#include <CGAL/Tetrahedral_remeshing/Uniform_sizing_field.h>
#endif

#include <cassert>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace internal = CGAL::Boundary_recovery_3::internal;

template <typename GT, typename Field>
struct Any_field
{
  const internal::Any_size_field_3<GT, Field> field;
};

// What the mesher asks, with the field as it knows it. It stays where it is.
template <typename Tr, typename Field>
struct Query
  : private Any_field<typename Tr::Geom_traits, Field>
  , public internal::Size_query_3<Tr>
{
  typedef Any_field<typename Tr::Geom_traits, Field> Base;

  explicit Query(const Field& field)
    : Base{ internal::Any_size_field_3<typename Tr::Geom_traits, Field>(field) }
    , internal::Size_query_3<Tr>(Base::field)
  { }

  Query(const Query&) = delete;
};

template <typename Tr, typename Field>
Query<Tr, Field> make_query(const Field& field) { return Query<Tr, Field>(field); }

template <typename Point_3>
double height_plus_one(const Point_3& p) { return CGAL::to_double(p.z()) + 1; }

// an index that no number becomes unasked
struct Explicit_index
{
  explicit Explicit_index(const int i) : i(i) { }

  int i;
};

template <typename Point_3>
struct Field_with_explicit_index
{
  typedef Explicit_index Index;

  double operator()(const Point_3&, const int dimension, const Index& index) const
  {
    return 10 * dimension + index.i;
  }

  double grading() const { return .25; }
};

template <typename Tr>
void test_numbers()
{
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  const typename Tr::Geom_traits::FT exact(2.5);
  const double number = 2.5;
  const int integer = 3;
  const float single = .5f;
  auto query = make_query<Tr>(number);
  assert(query.is_constant() && ! query.tells_least_sizes());
  assert(query(Point_3(1, 2, 3), 3, 1) == 2.5 && query.grading() == 0 && query.is_valid());
  assert(make_query<Tr>(exact)(Point_3(1, 2, 3), 3, 1) == 2.5 && make_query<Tr>(integer)(Point_3(1, 2, 3), 3, 1) == 3);
  assert(make_query<Tr>(single)(Point_3(1, 2, 3), 3, 1) == .5);
}

template <typename Tr>
void test_functions()
{
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  typedef typename Tr::Geom_traits::FT FT;
  const Point_3 p(1, 2, 3);
  const auto of_point = [](const Point_3& q) { return q.y(); };
  const auto of_region = [](const Point_3& q, const int dimension, const int index)
  {
    return CGAL::to_double(q.x()) + dimension * index;
  };
  const auto of_both = [](const auto& q, const auto& ...) { return FT(q.z() / 2); };
  auto query = make_query<Tr>(of_point);
  assert(! query.is_constant() && ! query.tells_least_sizes());
  assert(query(p, 3, 1) == 2 && query(Point_3(0, 5, 0), 3, 1) == 5 && query.number_of_queries() == 2);
  assert(query.grading() == std::numeric_limits<double>::infinity());
  assert(make_query<Tr>(of_region)(p, 3, 7) == 22 && make_query<Tr>(of_both)(p, 3, 7) == 1.5);
  assert((Query<Tr, double(const Point_3&)>(height_plus_one<Point_3>)(p, 3, 1) == 4));
  assert(make_query<Tr>(&height_plus_one<Point_3>)(p, 3, 1) == 4);
  assert(make_query<Tr>(std::function<FT(const Point_3&)>(of_point))(p, 3, 1) == 2);
  assert(make_query<Tr>(std::cref(of_region))(p, 3, 7) == 22);
}

template <typename Tr>
void test_domain_fields()
{
  typedef typename Tr::Geom_traits Traits;
  typedef typename Traits::Point_3 Point_3;
  typedef std::variant<int, std::pair<int, int> > Index;
  const Point_3 p(1, 2, 3);

  CGAL::Mesh_constant_domain_field_3<Traits, int> by_number(8);
  by_number.set_size(2, 3, 1);
  assert(make_query<Tr>(by_number)(p, 3, 1) == 2 && make_query<Tr>(by_number)(p, 3, 2) == 8);

  CGAL::Mesh_constant_domain_field_3<Traits, Index> by_index(8);
  by_index.set_size(2, 3, 1);
  by_index.set_size(4, 3, std::make_pair(1, 2));
  assert(make_query<Tr>(by_index)(p, 3, 1) == 2 && make_query<Tr>(by_index)(p, 3, 2) == 8);

  const CGAL::Uniform_sizing_field<Traits> uniform(3);
  assert(make_query<Tr>(uniform)(p, 3, 1) == 3);

  const Field_with_explicit_index<Point_3> explicit_index;
  auto query = make_query<Tr>(explicit_index);
  assert(query(p, 3, 4) == 34 && query.grading() == .25);
  assert(make_query<Tr>(std::ref(explicit_index)).grading() == .25);
}

// The field of the remeshing, which came with CGAL 6.0.
#if CGAL_VERSION_NR >= 1060000000
void test_adaptive_field()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel> Tr;
  Tr tr;
  for(int i = 0; i < 8; ++i)
    tr.insert(Kernel::Point_3(i & 1, (i >> 1) & 1, i >> 2));
  for(const auto c : tr.finite_cell_handles())
    c->set_subdomain_index(1);
  const auto field = CGAL::create_adaptive_remeshing_sizing_field(tr);
  const double size = make_query<Tr>(field)(Kernel::Point_3(.5, .5, .5), 3, 1);
  assert(size > .5 && size < 2);
}
#else
void test_adaptive_field() { }
#endif

template <typename Tr>
void test_invalid_sizes()
{
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  typedef std::numeric_limits<double> Limits;
  for(const double invalid : { 0., -0., -1., Limits::infinity(), - Limits::infinity(), Limits::quiet_NaN() })
  {
    int number_of_calls = 0;
    const auto field = [&](const Point_3& p) { ++number_of_calls; return p.x() < 2 ? 1. : invalid; };
    auto query = make_query<Tr>(field);
    assert(query(Point_3(1, 0, 0), 3, 1) == 1 && query.is_valid());
    assert(std::isnan(query(Point_3(2, 0, 7), 3, 1)) && ! query.is_valid());
    assert(std::isnan(query(Point_3(1, 0, 0), 3, 1)) && std::isnan(query(Point_3(3, 0, 0), 3, 1)));
    assert(number_of_calls == 2 && query.number_of_queries() == 2);
    assert(query.invalid_size().point == Point_3(2, 0, 7) && query.invalid_size().message.empty());
    assert(query.invalid_size().size == invalid || (std::isnan(invalid) && std::isnan(query.invalid_size().size)));
  }
  for(const double extreme : { Limits::denorm_min(), Limits::max() })
    assert(make_query<Tr>(extreme)(Point_3(1, 0, 0), 3, 1) == extreme);
}

template <typename Tr>
void test_exceptions()
{
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  const auto check = [](const auto& field, const std::string& message)
  {
    auto query = make_query<Tr>(field);
    assert(std::isnan(query(Point_3(2, 0, 7), 3, 1)) && ! query.is_valid() && query.number_of_queries() == 1);
    assert(std::isnan(query.invalid_size().size) && query.invalid_size().message == message);
    assert(query.invalid_size().point == Point_3(2, 0, 7));
  };
  check([](const Point_3&) -> double { throw std::runtime_error("no size"); }, "no size");
  check([](const Point_3&) -> double { throw 5; }, "");
  const std::function<double(const Point_3&)> empty;
  check(empty, std::bad_function_call().what());
}

template <typename Kernel>
void test_all()
{
  typedef typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Tr;
  test_numbers<Tr>();
  test_functions<Tr>();
  test_domain_fields<Tr>();
  test_invalid_sizes<Tr>();
  test_exceptions<Tr>();
}

int main()
{
  test_all<CGAL::Exact_predicates_inexact_constructions_kernel>();
  test_all<CGAL::Exact_predicates_exact_constructions_kernel>();
  test_adaptive_field();
  std::cout << "done" << std::endl;
  return 0;
}
