// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NEAREST_INTEGER_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NEAREST_INTEGER_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// An integer that is as near to x as another, up to the precision of `to_double()`. x is of an exact field number type,
// and less than 2^1023. Each step takes the leading bits away, so there is no limit to their number.
template <typename FT>
FT nearest_integer(const FT& x)
{
  FT result(0), rest(x);
  for(double d = std::nearbyint(CGAL::to_double(rest)); d != 0; d = std::nearbyint(CGAL::to_double(rest)))
  {
    result += FT(d);
    rest = x - result;
  }
  return result;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NEAREST_INTEGER_H
