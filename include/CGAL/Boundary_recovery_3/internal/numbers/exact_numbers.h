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

#ifdef CGAL_USE_GMP
#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/Mpzf.h>
#else
#include <CGAL/MP_Float.h>
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_EXACT_NUMBERS_H
