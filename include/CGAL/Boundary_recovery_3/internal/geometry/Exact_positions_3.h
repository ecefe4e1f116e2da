// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POSITIONS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POSITIONS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/predicates/sign_of_determinant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <unordered_map>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * A point in numbers of a ring: numerators over a common positive denominator.
 *
 * The sign of a determinant is found much faster from these than from rational numbers, which are reduced after each
 * operation. Most positions are multiples of powers of two, so multi-precision floating point numbers have them without
 * a denominator.
 */
class Homogeneous_point_3
{
public:
  typedef Fraction_traits<Rational>  Fractions;
  typedef Fractions::Numerator_type  Integer;
  typedef Exact_float                RT;

  Homogeneous_point_3() { }

  // The point (x, y, z) of rational numbers.
  static Homogeneous_point_3 from_rationals(const Rational& x, const Rational& y, const Rational& z)
  {
    Homogeneous_point_3 p;
    const std::array<const Rational*, 3> coordinates = {{ &x, &y, &z }};
    std::array<Integer, 3> numerators, denominators;
    std::array<RT, 3> inverses;
    bool are_inverses_known = true;
    for(int i = 0; i < 3; ++i)
    {
      Fractions::Decompose()(*coordinates[i], numerators[i], denominators[i]);
      CGAL_assertion(CGAL::is_positive(denominators[i]));
      are_inverses_known = are_inverses_known && invert_power_of_two(denominators[i], inverses[i]);
    }
    const Integer w = are_inverses_known ? Integer(1)
                                         : internal::common_denominator(std::array<Rational, 3>{{ x, y, z }});
    p.m_w = ring_number(w);
    for(int i = 0; i < 3; ++i)
      p.m_xyz[i] = are_inverses_known ? RT(ring_number(numerators[i]) * inverses[i])
                 : ring_number(Integer(numerators[i] * CGAL::integral_division(w, denominators[i])));
    return p;
  }

  // The point (x, y, z) of finite numbers.
  static Homogeneous_point_3 from_doubles(const double x, const double y, const double z)
  {
    return Homogeneous_point_3({{ RT(x), RT(y), RT(z) }}, RT(1));
  }

  // The point p + s d, where the vector d goes from the origin of coordinates to the given point.
  static Homogeneous_point_3 on_ray(const Homogeneous_point_3& p, const Homogeneous_point_3& d, const RT& s)
  {
    Homogeneous_point_3 x;
    for(int i = 0; i < 3; ++i)
      x.m_xyz[i] = p.m_xyz[i] * d.m_w + s * d.m_xyz[i] * p.m_w;
    x.m_w = p.m_w * d.m_w;
    return x;
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
    const std::array<RT, 3> a = direction(*v[0], *v[1]), b = direction(*v[0], *v[2]), c = direction(*v[0], *v[3]);
    const Orientation o = CGAL::sign_of_determinant<RT>(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]);
    return is_odd ? - o : o;
  }

private:
  Homogeneous_point_3(const std::array<RT, 3>& xyz, const RT& w) : m_xyz(xyz), m_w(w) { }

  // Returns false unless n is a power of two below 2^1024, and sets its inverse.
  static bool invert_power_of_two(const Integer& n, RT& inverse)
  {
    const double d = CGAL::to_double(n);
    int exponent;
    if(! std::isfinite(d) || std::frexp(d, &exponent) != .5 || Integer(d) != n)
      return false;
    inverse = RT(std::ldexp(.5, 2 - exponent));
    return true;
  }

  // The same number.
  static RT ring_number(const Integer& n)
  {
    const double unit = std::ldexp(1., 900);
    if(CGAL::abs(n) > Integer(unit))
    {
      const Integer quotient = CGAL::div(n, Integer(unit));
      return ring_number(quotient) * RT(unit) + ring_number(Integer(n - quotient * Integer(unit)));
    }
    RT result(0);
    for(Integer rest(n); ! CGAL::is_zero(rest); ) // each step takes the leading bits away
    {
      const double d = CGAL::to_double(rest);
      result += RT(d);
      rest -= Integer(d);
    }
    return result;
  }

  // A positive multiple of q - p.
  static std::array<RT, 3> direction(const Homogeneous_point_3& p, const Homogeneous_point_3& q)
  {
    std::array<RT, 3> d;
    const bool have_same_denominator = p.m_w == q.m_w;
    for(int i = 0; i < 3; ++i)
      d[i] = have_same_denominator ? RT(q.m_xyz[i] - p.m_xyz[i]) : RT(q.m_xyz[i] * p.m_w - p.m_xyz[i] * q.m_w);
    return d;
  }

  std::array<RT, 3> m_xyz; // numerators
  RT m_w;
};

/*
 * The exact positions of vertices.
 *
 * A point on a constraint has no position in floating point numbers, in general. While a Steiner point is there, its
 * vertex has the rounded position in the triangulation and the exact one here, beside it. All other vertices are
 * exactly where the triangulation says. If the numbers of the kernel are exact, nothing is kept here.
 */
template <typename Tr>
class Exact_positions_3
{
public:
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef typename Tr::Geom_traits::Point_3  Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel Kernel;
  typedef typename Kernel::FT                FT;

  static constexpr bool is_kernel_exact = Algebraic_structure_traits<FT>::Is_exact::value;

  // Not lazy numbers: most positions are needed exactly at once.
  typedef std::conditional_t<is_kernel_exact, Kernel, Simple_cartesian<Rational> > Exact_kernel;
  typedef typename Exact_kernel::FT          Exact_FT;
  typedef typename Exact_kernel::Point_3     Exact_point_3;

  typedef Interval_nt<false>                 Interval;
  typedef Simple_cartesian<Interval>         Interval_kernel;
  typedef Interval_kernel::Point_3           Interval_point_3;

  typedef Homogeneous_point_3                Homogeneous_point;

  // A position that is not the one in the triangulation.
  struct Position
  {
    Exact_point_3 exact;
    Interval_point_3 box;          // around it, for filters
    Homogeneous_point homogeneous; // for orientations when filters fail
  };

  // Whether every vertex is where the triangulation says.
  bool empty() const { return m_positions.empty(); }

  bool contains(const Vertex_handle v) const { return find(v) != nullptr; }

  // The position of v, or none if v is where the triangulation says.
  const Position* find(const Vertex_handle v) const
  {
    const auto it = m_positions.find(&*v);
    return it == m_positions.end() ? nullptr : &it->second;
  }

  Exact_point_3 operator()(const Vertex_handle v) const
  {
    if constexpr(is_kernel_exact)
      return internal::bare_point<Point_3>(v->point());
    else
    {
      const Position* const position = find(v);
      const Cartesian_converter<Kernel, Exact_kernel> to_exact;
      return position == nullptr ? to_exact(internal::bare_point<Point_3>(v->point())) : position->exact;
    }
  }

  // The position of v as a box around it, for filters, and in homogeneous coordinates, for orientations when filters
  // fail; `position` is what find(v) returned. Not to be called with exact kernels, nor is to_homogeneous().
  static Interval_point_3 box(const Vertex_handle v, const Position* const position)
  {
    return position == nullptr ? box(internal::bare_point<Point_3>(v->point())) : position->box;
  }

  static Homogeneous_point homogeneous(const Vertex_handle v, const Position* const position)
  {
    if(position != nullptr)
      return position->homogeneous;
    const Point_3& p = internal::bare_point<Point_3>(v->point());
    return Homogeneous_point::from_doubles(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  static Homogeneous_point to_homogeneous(const Exact_point_3& p)
  {
    return Homogeneous_point::from_rationals(p.x(), p.y(), p.z());
  }

  void set(const Vertex_handle v, const Exact_point_3& p)
  {
    if constexpr(is_kernel_exact)
      v->set_point(p);
    else
    {
      v->set_point(Point_3(internal::nearest_double(p.x()), internal::nearest_double(p.y()),
                           internal::nearest_double(p.z())));
      m_positions[&*v] = { p, box(p), to_homogeneous(p) };
    }
  }

  // From now on, v is where the triangulation says.
  void erase(const Vertex_handle v) { m_positions.erase(&*v); }

private:
  template <typename Point>
  static Interval_point_3 box(const Point& p)
  {
    const Interval x = CGAL::to_interval(p.x()), y = CGAL::to_interval(p.y()), z = CGAL::to_interval(p.z());
    return Interval_point_3(x, y, z);
  }

  std::unordered_map<const void*, Position> m_positions; // look-up only
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POSITIONS_3_H
