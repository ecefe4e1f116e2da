// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_VISIT_QUALITIES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_VISIT_QUALITIES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>

#include <array>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Whether a model of CellQuality_3 knows how to compute the qualities of two cells at once.
template <typename Quality, typename = void>
struct Has_quality_of_two_cells : std::false_type { };

template <typename Quality>
struct Has_quality_of_two_cells<Quality, std::void_t<decltype(std::array<double, 2>(
                                           std::declval<const Quality&>().of_two_cells(
                                             std::declval<const Cell_corners_3&>(),
                                             std::declval<const Cell_corners_3&>())))> >
  : std::true_type
{ };

// At once if that is known, else one after the other.
template <typename Quality>
std::array<double, 2> qualities_of_two_cells(const Quality& quality, const Cell_corners_3& p, const Cell_corners_3& q)
{
  if constexpr(Has_quality_of_two_cells<Quality>::value)
    return quality.of_two_cells(p, q);
  else
    return {{ quality(p), quality(q) }};
}

// Calls `visit(item, quality)` for the cells of the items, in order, until it returns false; the corners of a cell are
// `corners(item)`. Since two qualities are computed at once, one may have been computed in vain. Returns whether all
// are visited.
template <typename Quality, typename Range, typename Corners, typename Visit>
bool visit_qualities(const Quality& quality, Range&& items, const Corners& corners, Visit&& visit)
{
  auto it = std::begin(items);
  for(auto rest = std::distance(it, std::end(items)); rest > 1; rest -= 2)
  {
    auto& first = *it++;
    auto& second = *it++;
    const std::array<double, 2> qualities = internal::qualities_of_two_cells(quality, corners(first), corners(second));
    if(! visit(first, qualities[0]) || ! visit(second, qualities[1]))
      return false;
  }
  return it == std::end(items) || visit(*it, quality(corners(*it)));
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_VISIT_QUALITIES_H
