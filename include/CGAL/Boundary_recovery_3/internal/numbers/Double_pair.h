// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_DOUBLE_PAIR_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_DOUBLE_PAIR_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Double_pair: two floating point numbers as one. Whatever is computed is computed of the first ones, and of the second
 * ones, and each result is rounded as it would be alone, so it is the very same. Processors need hardly more time for
 * that than for one number; compilers that have a type for it know the arithmetic already.
 *
 * Formulas are written as templates, for one number or two. Since conditions on pairs are no truth values, formulas
 * choose by the functions below.
 */
#if defined(__GNUC__) || defined(__clang__)

typedef double Double_pair __attribute__((vector_size(2 * sizeof(double))));

// u where a < b, else v.
inline Double_pair if_less(const Double_pair a, const Double_pair b, const Double_pair u, const Double_pair v)
{
  return a < b ? u : v;
}

#else

struct Double_pair
{
  double values[2];

  double operator[](const int i) const { return values[i]; }

  friend Double_pair operator-(const Double_pair& a) { return {{ - a[0], - a[1] }}; }
  friend Double_pair operator+(const Double_pair& a, const Double_pair& b) { return {{ a[0] + b[0], a[1] + b[1] }}; }
  friend Double_pair operator-(const Double_pair& a, const Double_pair& b) { return {{ a[0] - b[0], a[1] - b[1] }}; }
  friend Double_pair operator*(const Double_pair& a, const Double_pair& b) { return {{ a[0] * b[0], a[1] * b[1] }}; }
  friend Double_pair operator/(const Double_pair& a, const Double_pair& b) { return {{ a[0] / b[0], a[1] / b[1] }}; }
  friend Double_pair operator*(const double a, const Double_pair& b) { return {{ a * b[0], a * b[1] }}; }
};

inline Double_pair if_less(const Double_pair& a, const Double_pair& b, const Double_pair& u, const Double_pair& v)
{
  return {{ a[0] < b[0] ? u[0] : v[0], a[1] < b[1] ? u[1] : v[1] }};
}

#endif

inline double smaller(const double a, const double b) { return (std::min)(a, b); }
inline Double_pair smaller(const Double_pair& a, const Double_pair& b) { return if_less(b, a, b, a); }

inline double square_root(const double x) { return std::sqrt(x); }
inline Double_pair square_root(const Double_pair& x) { return Double_pair{ std::sqrt(x[0]), std::sqrt(x[1]) }; }

// u where x is negative, else v. Of single numbers, one is looked up, for signs that nobody can predict.
inline double if_negative(const double x, const double u, const double v)
{
  const double values[2] = { v, u };
  return values[x < 0];
}

inline Double_pair if_negative(const Double_pair& x, const double u, const double v)
{
  return if_less(x, Double_pair{ 0, 0 }, Double_pair{ u, u }, Double_pair{ v, v });
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_DOUBLE_PAIR_H
