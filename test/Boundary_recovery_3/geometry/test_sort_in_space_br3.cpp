// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Items in an order in which neighbors come one after the other.

#undef NDEBUG

#include <CGAL/Boundary_recovery_3/internal/geometry/sort_in_space.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <numeric>
#include <random>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef std::array<double, 3> Place;

// The numbers of the places, sorted.
std::vector<std::size_t> sorted(const std::vector<Place>& places)
{
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  internal::sort_in_space(order, [&](const std::size_t k) { return places[k]; }, [] { return true; });
  return order;
}

// Whether each number is there once, and the order is the same whenever it is asked for.
bool is_order(const std::vector<std::size_t>& order, const std::vector<Place>& places)
{
  std::vector<std::size_t> numbers = order;
  std::sort(numbers.begin(), numbers.end());
  for(std::size_t k = 0; k < numbers.size(); ++k)
    if(numbers[k] != k)
      return false;
  return order.size() == places.size() && order == sorted(places);
}

double length_of_way(const std::vector<Place>& places, const std::vector<std::size_t>& order)
{
  double sum = 0;
  for(std::size_t k = 1; k < order.size(); ++k)
  {
    const Place &p = places[order[k - 1]], &q = places[order[k]];
    sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  return sum;
}

// Of n random places in a cube, the next one is not much farther away than the nearest one.
void test_random_places()
{
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for(const std::size_t n : { 1000, 20000 })
  {
    std::vector<Place> places(n);
    for(Place& p : places)
      p = {{ coordinate(rng), coordinate(rng), coordinate(rng) }};
    const std::vector<std::size_t> order = sorted(places);
    assert(is_order(order, places));
    assert(length_of_way(places, order) < 2 * static_cast<double>(n) * std::cbrt(1. / static_cast<double>(n)));
  }
}

// None, one, equal ones, and such as are in a plane or on a line.
void test_degenerate_places()
{
  assert(sorted({}).empty());
  assert(sorted({ {{ 1, 2, 3 }} }) == std::vector<std::size_t>{ 0 });
  for(const int dimension : { 0, 1, 2 })
  {
    std::vector<Place> places;
    for(int k = 0; k < 3000; ++k)
      places.push_back({{ 5, dimension > 0 ? 1. * (k % 50) : 5, dimension > 1 ? 1. * (k % 7) : 5 }});
    assert(is_order(sorted(places), places));
  }
}

// A no leaves them as they were.
void test_stop()
{
  std::vector<Place> places;
  for(int k = 0; k < 3000; ++k)
    places.push_back({{ 1. * (k % 7), 1. * (k % 50), 1. * (k % 11) }});
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<std::size_t> before = order;
  int number_of_questions = 0;
  internal::sort_in_space(order, [&](const std::size_t k) { return places[k]; },
                          [&] { return ++number_of_questions < 3; });
  assert(order == before && number_of_questions == 3);
}

int main()
{
  test_random_places();
  test_degenerate_places();
  test_stop();
  std::cout << "done" << std::endl;
  return 0;
}
