// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOMOGENEOUS_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOMOGENEOUS_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/MP_Float.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/predicates/sign_of_determinant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * A point in integers: numerators over a common positive denominator.
 *
 * The sign of a determinant is found much faster from integers than from rational numbers, which are reduced after
 * each operation. `Rational` is a type of fractions of integers.
 */
template <typename Rational>
class Homogeneous_point_3
{
public:
  typedef Fraction_traits<Rational>                Fractions;
  typedef typename Fractions::Numerator_type       Integer;

  Homogeneous_point_3() { }

  // The point (x, y, z) of rational numbers.
  static Homogeneous_point_3 from_rationals(const Rational& x, const Rational& y, const Rational& z)
  {
    Homogeneous_point_3 p;
    const std::array<const Rational*, 3> coordinates = {{ &x, &y, &z }};
    std::array<Integer, 3> denominators;
    p.m_w = Integer(1);
    for(int i = 0; i < 3; ++i)
    {
      typename Fractions::Decompose()(*coordinates[i], p.m_xyz[i], denominators[i]);
      const Integer common = typename Fractions::Common_factor()(p.m_w, denominators[i]);
      p.m_w *= CGAL::integral_division(denominators[i], common); // their least common multiple, to have few digits
    }
    for(int i = 0; i < 3; ++i)
      p.m_xyz[i] *= CGAL::integral_division(p.m_w, denominators[i]);
    return p;
  }

  // The point (x, y, z) of finite numbers. The denominator is a power of two.
  static Homogeneous_point_3 from_doubles(const double x, const double y, const double z)
  {
    if constexpr(std::is_same<Integer, MP_Float>::value) // without other libraries; these have exponents themselves
      return Homogeneous_point_3({{ Integer(x), Integer(y), Integer(z) }}, Integer(1));
    else
      return from_mantissas(x, y, z);
  }

  // Sign of the volume of the tetrahedron pqrs.
  static Orientation orientation(const Homogeneous_point_3& p, const Homogeneous_point_3& q,
                                 const Homogeneous_point_3& r, const Homogeneous_point_3& s)
  {
    // The denominator of the point that is taken for the origin gets into all the rows of the matrix: take a small one.
    std::array<const Homogeneous_point_3*, 4> v = {{ &p, &q, &r, &s }};
    const auto smallest = std::min_element(v.begin(), v.end(), [](const auto* a, const auto* b)
    {
      return a->m_w < b->m_w;
    });
    const bool is_odd = smallest != v.begin();
    std::iter_swap(v.begin(), smallest);
    const std::array<Integer, 3> a = direction(*v[0], *v[1]), b = direction(*v[0], *v[2]), c = direction(*v[0], *v[3]);
    const Orientation o = CGAL::sign_of_determinant<Integer>(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]);
    return is_odd ? - o : o;
  }

private:
  Homogeneous_point_3(const std::array<Integer, 3>& xyz, const Integer& w) : m_xyz(xyz), m_w(w) { }

  static Homogeneous_point_3 from_mantissas(const double x, const double y, const double z)
  {
    constexpr int bits = std::numeric_limits<double>::digits;
    Homogeneous_point_3 p;
    const std::array<double, 3> coordinates = {{ x, y, z }};
    std::array<int, 3> exponents;
    int smallest = 0;
    for(int i = 0; i < 3; ++i)
    {
      p.m_xyz[i] = Integer(std::ldexp(std::frexp(coordinates[i], &exponents[i]), bits)); // an integer, even if tiny
      exponents[i] = coordinates[i] == 0 ? 0 : exponents[i] - bits;
      smallest = (std::min)(smallest, exponents[i]);
    }
    for(int i = 0; i < 3; ++i)
      p.m_xyz[i] <<= static_cast<unsigned long>(exponents[i] - smallest);
    p.m_w = Integer(1);
    p.m_w <<= static_cast<unsigned long>(- smallest);
    return p;
  }

  // A positive multiple of q - p.
  static std::array<Integer, 3> direction(const Homogeneous_point_3& p, const Homogeneous_point_3& q)
  {
    std::array<Integer, 3> d;
    const bool have_same_denominator = p.m_w == q.m_w; // often, among points of floating point numbers
    for(int i = 0; i < 3; ++i)
    {
      d[i] = q.m_xyz[i];
      if(have_same_denominator)
        d[i] -= p.m_xyz[i];
      else
      {
        d[i] *= p.m_w;
        d[i] -= p.m_xyz[i] * q.m_w;
      }
    }
    return d;
  }

  std::array<Integer, 3> m_xyz; // numerators
  Integer m_w;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOMOGENEOUS_POINT_3_H
