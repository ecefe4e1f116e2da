// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The exact number types, and the small tools for numbers: powers of two, nearest integers and nearest numbers, and
// pairs of numbers.

#undef NDEBUG

#include <CGAL/Boundary_recovery_3/internal/numbers/Double_pair.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_rational Rational;

void test_nearest_integer()
{
  const Rational tiny = Rational(1) / Rational(std::ldexp(1., 80)), half(.5), huge(std::ldexp(1., 1000));
  for(const double n : { -1e30, -3., -1., 0., 1., 2., 4503599627370496., 1e30 })
  {
    assert(internal::nearest_integer(Rational(n)) == n);
    assert(internal::nearest_integer(Rational(Rational(n) + half - tiny)) == n);
    assert(internal::nearest_integer(Rational(Rational(n) + half + tiny)) == Rational(n) + Rational(1));
    assert(internal::nearest_integer(Rational(Rational(n) - half + tiny)) == n);
    assert(internal::nearest_integer(Rational(Rational(n) - half - tiny)) == Rational(n) - Rational(1));
    const Rational large = huge * huge * huge + Rational(n);
    assert(internal::nearest_integer(Rational(large - tiny)) == large);
  }
}

// Numbers just beside the middle of two neighbors, of either sign and size.
void test_nearest_double()
{
  const Rational tiny = Rational(std::ldexp(1., -300)) * Rational(std::ldexp(1., -900));
  for(const double d : { 1., -1., .1, -3e200, 5e-300, 0., -1e-320, std::nextafter(2., 0.) })
  {
    const double next = std::nextafter(d, 2 * std::abs(d) + 1);
    const Rational middle = (Rational(d) + Rational(next)) / Rational(2);
    assert(internal::nearest_double(Rational(d)) == d);
    assert(internal::nearest_double(Rational(middle - tiny)) == d);
    assert(internal::nearest_double(Rational(middle + tiny)) == next);
    assert(internal::nearest_double(Rational(middle)) == d || internal::nearest_double(Rational(middle)) == next);
  }
  const double largest = std::numeric_limits<double>::max();
  assert(internal::nearest_double(Rational(largest)) == largest);
  assert(internal::nearest_double(Rational(Rational(- largest) + tiny)) == - largest);
}

// Fractions are in lowest terms, their denominators are positive, and the nearest floating point numbers on both sides
// are all that they are converted to.
void test_rational_numbers()
{
  typedef internal::Rational Exact;
  typedef CGAL::Fraction_traits<Exact> Fractions;
  std::minstd_rand random(3);
  for(int k = 0; k < 1000; ++k)
  {
    const int n = static_cast<int>(random() % 2001) - 1000, sign = k % 2 == 0 ? 1 : -1;
    const int d = sign * (1 + static_cast<int>(random() % 1000));
    const Exact x = Exact(n) / Exact(d);
    Fractions::Numerator_type numerator;
    Fractions::Denominator_type denominator;
    Fractions::Decompose()(x, numerator, denominator);
    assert(denominator == std::abs(d) / std::gcd(n, d) && numerator == sign * n / std::gcd(n, d));
    const double near = CGAL::to_double(x), infinity = std::numeric_limits<double>::infinity();
    assert(Exact(std::nextafter(near, - infinity)) < x && x < Exact(std::nextafter(near, infinity)));
  }
}

// No digit is lost.
void test_exact_floats()
{
  typedef internal::Exact_float Exact;
  const Exact large(std::ldexp(1., 1000)), small(std::ldexp(1., -1000)), sum = large + small;
  assert(sum - large == small && sum * sum - large * large == small * small + Exact(2));
  assert(CGAL::sign(Exact(sum - large - small)) == CGAL::ZERO && large < sum);
}

// Numbers of any size become about one; zero, infinity and the smallest numbers have a scale, too.
void test_binary_scale()
{
  for(const double x : { 1., 1.5, std::nextafter(2., 0.), .1, 3e200, 7e-200, 1e301, 1e-301 })
  {
    const double scale = internal::binary_scale(x);
    int exponent = 0;
    assert(std::frexp(scale, &exponent) == .5); // a power of two
    assert(scale <= x && x < 2 * scale);
    assert(x / scale == x * (1 / scale));
  }
  const double infinity = std::numeric_limits<double>::infinity();
  assert(internal::binary_scale(0) == 1);
  assert(internal::binary_scale(infinity) == std::ldexp(1., 1000));
  assert(internal::binary_scale(std::numeric_limits<double>::denorm_min()) == std::ldexp(1., -1000));
  assert(internal::binary_unit(3) == 8 && internal::binary_unit(-1074) == std::numeric_limits<double>::denorm_min());
  assert(internal::binary_unit(-5000) == std::numeric_limits<double>::denorm_min());
  typedef std::array<double, 3> Triple;
  assert(internal::largest_coordinate(Triple{{ 0, 0, 0 }}) == 0);
  assert(internal::largest_coordinate(Triple{{ -3, 2, 1 }}) == 3);
  assert(internal::largest_coordinate(Triple{{ 1, -infinity, 2 }}) == infinity);
}

// All the axes have the scale of the longest one, unless numbers of these sizes cannot be multiplied then.
void test_scales_of_axes()
{
  typedef std::array<double, 3> Triple;
  assert((internal::binary_scales({{ 5, 1, 0 }}) == Triple{{ 4, 4, 4 }}));
  assert((internal::binary_scales({{ 0, 0, 0 }}) == Triple{{ 1, 1, 1 }}));
  const double short_one = std::ldexp(1.5, -257), not_so_short = std::ldexp(1., -256);
  assert((internal::binary_scales({{ 1, not_so_short, .5 }}) == Triple{{ 1, 1, 1 }}));
  assert((internal::binary_scales({{ 1.5, short_one, 0 }}) == Triple{{ 1, std::ldexp(1., -257), 1 }}));
  assert((internal::binary_scales({{ 3e-300, 5e200, 1 }})
          == Triple{{ internal::binary_scale(3e-300), internal::binary_scale(5e200), 1 }}));
  Triple largest = {{ 1, 0, 2 }};
  internal::enlarge(largest, Triple{{ -3, 0, 1 }});
  assert((largest == Triple{{ 3, 0, 2 }}));
}

void check_pair(const internal::Double_pair& pair, const double first, const double second)
{
  assert(pair[0] == first && std::signbit(pair[0]) == std::signbit(first));
  assert(pair[1] == second && std::signbit(pair[1]) == std::signbit(second));
}

// What is done with a pair is done with both of its numbers.
void test_pairs()
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double numbers[] = { 0., -0., 1., -1., 0.1, -3.7, 1e-310, 1e200, -1e300, infinity };
  for(const double a : numbers)
    for(const double b : numbers)
    {
      const internal::Double_pair x = { a, 0.3 }, y = { b, 7. };
      check_pair(- x, - a, -0.3);
      check_pair(2.5 * x, 2.5 * a, 2.5 * 0.3);
      check_pair(internal::smaller(x, y), internal::smaller(a, b), 0.3);
      check_pair(internal::smaller(y, x), internal::smaller(b, a), 0.3);
      check_pair(internal::if_negative(x, 2, 3), internal::if_negative(a, 2, 3), 3);
      check_pair(internal::if_negative(- x, 2, 3), internal::if_negative(- a, 2, 3), 2);
      if(std::isfinite(a) && std::isfinite(b))
      {
        check_pair(x + y, a + b, 0.3 + 7.);
        check_pair(x - y, a - b, 0.3 - 7.);
        check_pair(x * y, a * b, 0.3 * 7.);
        if(b != 0)
          check_pair(x / y, a / b, 0.3 / 7.);
      }
      if(a >= 0)
        check_pair(internal::square_root(x), internal::square_root(a), std::sqrt(0.3));
    }
}

int main()
{
  test_pairs();
  test_scales_of_axes();
  test_rational_numbers();
  test_exact_floats();
  test_binary_scale();
  test_nearest_integer();
  test_nearest_double();
  std::cout << "done" << std::endl;
}
