// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Points with coordinates of type `double` in polyhedra that may be thinner than their distance. From 2^52 to 2^53,
// these numbers are the integers, so that small polyhedra there can be searched by brute force.

#undef NDEBUG

#include <CGAL/Boundary_recovery_3/internal/numbers/Representable_point_3.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <random>
#include <set>
#include <vector>

typedef CGAL::Exact_rational                                           Rational;
typedef CGAL::Boundary_recovery_3::internal::Representable_point_3<Rational> Representable_point_3;
typedef Representable_point_3::Point_3                                 Point_3;
typedef Representable_point_3::Plane_3                                 Plane_3;
typedef Representable_point_3::Kernel::Vector_3                        Vector_3;

bool is_inside(const std::vector<Plane_3>& planes, const Point_3& p)
{
  return std::all_of(planes.begin(), planes.end(), [&](const Plane_3& h) { return h.has_on_negative_side(p); });
}

// The plane through p with the normal (a, b, c).
Plane_3 plane(const Point_3& p, const Rational& a, const Rational& b, const Rational& c)
{
  return Plane_3(a, b, c, Rational(- (a * p.x() + b * p.y() + c * p.z())));
}

Point_3 translated(const Point_3& p, const Rational& x, const Rational& y, const Rational& z)
{
  return Point_3(Rational(p.x() + x), Rational(p.y() + y), Rational(p.z() + z));
}

void add_box(const Point_3& center, const Rational& radius, std::vector<Plane_3>& planes)
{
  planes.push_back(plane(translated(center, radius, 0, 0), 1, 0, 0));
  planes.push_back(plane(translated(center, - radius, 0, 0), -1, 0, 0));
  planes.push_back(plane(translated(center, 0, radius, 0), 0, 1, 0));
  planes.push_back(plane(translated(center, 0, - radius, 0), 0, -1, 0));
  planes.push_back(plane(translated(center, 0, 0, radius), 0, 0, 1));
  planes.push_back(plane(translated(center, 0, 0, - radius), 0, 0, -1));
}

bool contains_an_integer_point(const std::vector<Plane_3>& planes, const double corner, const int size)
{
  for(int x = 0; x < size; ++x)
    for(int y = 0; y < size; ++y)
      for(int z = 0; z < size; ++z)
        if(is_inside(planes, Point_3(corner + x, corner + y, corner + z)))
          return true;
  return false;
}

// Checks what was found, and returns whether something was.
bool is_found(const std::vector<Plane_3>& planes, const Point_3& inside)
{
  assert(is_inside(planes, inside));
  const auto found = Representable_point_3()(planes);
  assert(! found || is_inside(planes, Point_3((*found)[0], (*found)[1], (*found)[2])));
  return bool(found);
}

// Slabs and wedges of any width in boxes, compared with brute force.
void test_against_brute_force()
{
  const int size = 12;
  const double corner = std::ldexp(1., 52) + 1000;
  std::minstd_rand random(1);
  const auto number = [&random](const int n) { return static_cast<int>(random() % (2 * n + 1)) - n; };
  std::size_t found = 0, not_found = 0;
  for(int k = 0; k < 300; ++k)
  {
    const auto fraction = [&]
    {
      const double integer = corner + 3 + random() % 5;
      return Rational(Rational(integer) + Rational(random() % 97) / Rational(97));
    };
    const Rational x = fraction(), y = fraction(), z = fraction();
    const Point_3 inside(x, y, z);
    std::vector<Plane_3> planes;
    add_box(inside, Rational(3), planes);
    const int a = number(6), b = number(6), c = number(6);
    for(int side = 0; side < 2 + k % 3; ++side)
    {
      const int sign = side % 2 == 0 ? 1 : -1;
      const int numerator = 1 + random() % 20;
      const Rational distance = Rational(numerator) / Rational(100 + random() % 400);
      const int n[] = { sign * 100 * a + number(1 + k % 50), sign * 100 * b + number(1 + k % 50), sign * 100 * c + 1 };
      const Rational length(std::sqrt(double(n[0]) * n[0] + double(n[1]) * n[1] + double(n[2]) * n[2]));
      planes.push_back(plane(translated(inside, n[0] * distance / length, n[1] * distance / length,
                                        n[2] * distance / length), n[0], n[1], n[2]));
    }
    const bool is_there_one = contains_an_integer_point(planes, corner, size);
    assert(is_found(planes, inside) == is_there_one);
    ++(is_there_one ? found : not_found);
  }
  assert(found >= 50 && not_found >= 50);
}

// Far thinner than the distance of numbers, but long and wide: there is a number, unless the slab is parallel to planes
// with many numbers and between two of them.
void test_thin_slabs()
{
  const Rational tiny = Rational(1) / Rational(std::ldexp(1., 70));
  const Point_3 inside(Rational(1) / Rational(3), Rational(1) / Rational(7), Rational(1) / Rational(5));
  for(const bool is_parallel : { false, true })
  {
    std::vector<Plane_3> planes;
    add_box(inside, Rational(1) / Rational(16), planes);
    const Rational a(1), b(is_parallel ? 2.5 : 2.718281828459045), c(is_parallel ? -1.5 : -1.4142135623730951);
    planes.push_back(plane(translated(inside, tiny, 0, 0), a, b, c));
    planes.push_back(plane(translated(inside, - tiny, 0, 0), - a, - b, - c));
    assert(is_found(planes, inside) != is_parallel);
  }
}

// At zero, numbers are as near to each other as one wants.
void test_sizes()
{
  for(const int exponent : { -1000, -300, 0, 300, 1000 })
    for(const double at : { 0., 1. })
    {
      const Rational unit(std::ldexp(1., exponent));
      const Point_3 inside(Rational(unit * Rational(at)), Rational(unit * Rational(at) / Rational(3)), Rational(0));
      std::vector<Plane_3> planes;
      add_box(inside, Rational(unit / Rational(1000)), planes);
      assert(is_found(planes, inside));
    }
}

// Below a power of two, numbers are twice as close to each other as above.
void test_below_a_power_of_two()
{
  const double half_spacing = std::ldexp(1., -53);
  const Point_3 inside(Rational(1 - .75 * half_spacing), Rational(0), Rational(0));
  std::vector<Plane_3> planes;
  add_box(inside, Rational(.75 * half_spacing), planes); // x from 1 - 1.5 half_spacing to 1
  assert(is_found(planes, inside));
}

// An open polyhedron without volume is empty.
void test_no_volume()
{
  std::vector<Plane_3> planes;
  add_box(Point_3(0, 0, 0), Rational(1), planes);
  planes.push_back(plane(Point_3(0, 0, 0), 1, 2, 3));
  planes.push_back(plane(Point_3(0, 0, 0), -1, -2, -3));
  assert(! Representable_point_3()(planes) && ! Representable_point_3().center(planes));
  planes.push_back(plane(Point_3(-5, 0, 0), 1, 0, 0));
  assert(! Representable_point_3()(planes) && ! Representable_point_3().center(planes));
}

// The mean of all the points in which three planes meet and that no plane cuts off.
Point_3 mean_of_vertices(const std::vector<Plane_3>& planes)
{
  std::set<Point_3> vertices;
  for(std::size_t i = 0; i < planes.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      for(std::size_t k = 0; k < j; ++k)
      {
        const Vector_3 u = planes[i].orthogonal_vector(), v = planes[j].orthogonal_vector(),
                       w = planes[k].orthogonal_vector();
        const Rational determinant = CGAL::determinant(u, v, w);
        if(determinant == 0)
          continue;
        const Vector_3 sum = planes[i].d() * CGAL::cross_product(v, w) + planes[j].d() * CGAL::cross_product(w, u)
                           + planes[k].d() * CGAL::cross_product(u, v);
        const Point_3 p = CGAL::ORIGIN - sum / determinant;
        if(std::none_of(planes.begin(), planes.end(), [&](const Plane_3& h) { return h.has_on_positive_side(p); }))
          vertices.insert(p);
      }
  const Rational n(static_cast<int>(vertices.size()));
  Rational x(0), y(0), z(0);
  for(const Point_3& p : vertices)
  {
    x += p.x() / n;
    y += p.y() / n;
    z += p.z() / n;
  }
  return Point_3(x, y, z);
}

// In boxes that are cut by slabs of any width, some of them far thinner than numbers are from each other, and some of
// no width at all.
void test_center()
{
  std::minstd_rand random(2);
  const auto number = [&random](const int n) { return static_cast<int>(random() % (2 * n + 1)) - n; };
  for(int k = 0; k < 60; ++k)
  {
    const Rational third = Rational(1) / Rational(3);
    const Point_3 inside(Rational(number(100)) * third, Rational(number(100)) * third, Rational(number(100)) * third);
    std::vector<Plane_3> planes;
    add_box(inside, Rational(1), planes);
    const Rational width = k % 3 == 0 ? Rational(1) / Rational(3) : k % 3 == 1 ? Rational(1e-22) : Rational(0);
    const int number_of_slabs = 1 + k / 3 % 3;
    for(int slab = 0; slab < number_of_slabs; ++slab)
    {
      const int a = number(6), b = number(6), c = 1 + k % 5;
      const Point_3 other = translated(inside, Rational(number(9)) / Rational(9) * width, 0, width);
      planes.push_back(plane(translated(inside, 0, 0, - width), - a, - b, - c));
      if(slab == 0)
        planes.push_back(plane(translated(inside, 0, 0, width), a, b, c));
      else
        planes.push_back(plane(other, a, b, c + 20));
    }
    const std::optional<Point_3> center = Representable_point_3().center(planes);
    assert(bool(center) == (width > 0));
    assert(! center || (*center == mean_of_vertices(planes) && is_inside(planes, *center)));
  }
  std::vector<Plane_3> planes;
  for(int i = 0; i < 11; ++i)
    add_box(Point_3(0, 0, 0), Rational(1 + i), planes);
  assert(! Representable_point_3().center(planes)); // of too many faces
  planes.resize(60);
  assert(Representable_point_3().center(planes) == Point_3(0, 0, 0));
}

int main()
{
  test_below_a_power_of_two();
  test_no_volume();
  test_center();
  test_against_brute_force();
  test_thin_slabs();
  test_sizes();
  std::cout << "done" << std::endl;
}
