// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_EXACT_NUMBERS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_EXACT_NUMBERS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/Mpzf.h>
#else
#include <CGAL/MP_Float.h>
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <limits>
#endif

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The exact number types.
 *
 * `Rational` is a type of fractions in lowest terms with positive denominators, that are converted to one of the two
 * nearest floating point numbers. (Without GMP, CGAL's own type of fractions is none of that.)
 *
 * `Exact_float` is a type of floating point numbers of any length, for determinants and linear programs.
 */
#ifdef CGAL_USE_GMP
typedef CGAL::Exact_rational                Rational;
#else
typedef boost::multiprecision::cpp_rational Rational;
#endif

#if defined(CGAL_HAS_MPZF)
typedef CGAL::Mpzf     Exact_float;
#elif defined(CGAL_USE_GMP)
typedef CGAL::Gmpzf    Exact_float;
#else
typedef CGAL::MP_Float Exact_float;
#endif

// An integer that is as near to x as any other; x is of an exact field number type. Each step takes the leading bits
// away, so there is no limit to their number.
template <typename FT>
FT nearest_integer(const FT& x)
{
  if(! std::isfinite(CGAL::to_double(x)))
  {
    const FT unit(std::ldexp(1., 900));
    const FT leading = nearest_integer(FT(x / unit)) * unit;
    return leading + nearest_integer(FT(x - leading));
  }
  FT result(0), rest(x);
  for(double d = std::nearbyint(CGAL::to_double(rest)); std::abs(d) > 1; d = std::nearbyint(CGAL::to_double(rest)))
  {
    result += FT(d);
    rest = x - result;
  }
  const FT half(.5), one(1);
  for(; rest > half; rest -= one)
    result += one;
  for(; rest < - half; rest += one)
    result -= one;
  return result;
}

// The least positive integer that makes integers of all these rational numbers.
template <typename Numbers>
Fraction_traits<Rational>::Numerator_type common_denominator(const Numbers& numbers)
{
  typedef Fraction_traits<Rational>  Fractions;
  typedef Fractions::Numerator_type  Integer;
  Integer result(1);
  for(const Rational& x : numbers)
  {
    Integer numerator, denominator;
    Fractions::Decompose()(x, numerator, denominator);
    result *= CGAL::integral_division(denominator, Fractions::Common_factor()(result, denominator));
  }
  return result;
}

// The multiple of a unit that is next to x.
template <typename FT>
FT nearest_multiple(const FT& x, const FT& unit)
{
  return nearest_integer(FT(x / unit)) * unit;
}

// The floating point number that is next to x. to_double() has to give one of its two neighbors.
template <typename FT>
double nearest_double(const FT& x)
{
  const double d = CGAL::to_double(x);
  if(! std::isfinite(d))
    return d;
  const FT error = x - FT(d);
  if(CGAL::is_zero(error))
    return d;
  const double infinity = std::numeric_limits<double>::infinity();
  const double neighbor = std::nextafter(d, CGAL::is_positive(error) ? infinity : - infinity);
  return std::isfinite(neighbor) && CGAL::abs(FT(x - FT(neighbor))) < CGAL::abs(error) ? neighbor : d;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_EXACT_NUMBERS_H
