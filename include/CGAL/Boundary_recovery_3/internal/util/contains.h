// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_CONTAINS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_CONTAINS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <algorithm>
#include <iterator>

namespace CGAL::Boundary_recovery_3::internal {

// Whether an item is in a small range, by linear search.
template <typename Range, typename Item>
bool contains(const Range& items, const Item& item)
{
  return std::find(std::begin(items), std::end(items), item) != std::end(items);
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_CONTAINS_H
