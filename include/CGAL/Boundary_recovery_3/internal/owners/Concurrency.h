// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_CONCURRENCY_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_CONCURRENCY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Whether, and by how many threads, parts of a mesh are worked on at the same time. How many parts there are follows
 * from the size of the mesh, never from the number of threads, so that the mesh does not depend on the machine.
 */
struct Concurrency
{
  std::optional<std::size_t> number_of_threads; // 0: as many as the machine has; none: nothing is divided
  double                     cells_per_part = 150000; // see "Tuning constants" in the manual

  // Of a mesh with so many cells. A small one is not divided, nor one that may have no more vertices than a number: the
  // parts do not know of each other how many they have.
  std::size_t number_of_parts(const double number_of_cells, const std::size_t max_number_of_vertices) const
  {
    const double number = (std::min)(number_of_cells / cells_per_part, double(max_number_of_parts - 1));
    const bool is_limited = max_number_of_vertices < (std::numeric_limits<std::size_t>::max)();
    return number_of_threads && ! is_limited && number >= 2 ? static_cast<std::size_t>(number) : 1;
  }
};

// That of the named parameter `number_of_threads`. Triangulations that are not sequential are divided by default.
template <typename Tr, typename NamedParameters>
Concurrency concurrency(const NamedParameters& np)
{
  constexpr bool is_default = parameters::is_default_parameter<NamedParameters, internal::number_of_threads_t>::value;
  static_assert(is_default || Has_part<typename Tr::Vertex>::value,
                "Several threads need vertices with part(), as those of "
                "CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type.");
  Concurrency result;
  if constexpr(! is_default)
    result.number_of_threads = internal::parameter_or(np, internal::number_of_threads, std::size_t(0));
  else if(! std::is_same<typename Tr::Concurrency_tag, Sequential_tag>::value && Has_part<typename Tr::Vertex>::value)
    result.number_of_threads = 0;
  return result;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_CONCURRENCY_H
