// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SUBDOMAIN_ROUND_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SUBDOMAIN_ROUND_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/parallel/Seams_3.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// What is done at the same time: the parts, or zones of cells around their seams, are filled, and maybe improved.
struct Subdomain_round
{
  bool works_on_parts() const { return number_of_parts == 1; }
  bool repairs() const { return number_of_parts == 0; }

  // What is bad for good is better not cut.
  std::size_t max_number_of_connected_vertices() const
  {
    return repairs() && improves ? std::size_t(-1) : Seams_3<>::max_number_of_connected_vertices;
  }

  // Cells with smaller angles are improved once more in the end, and with longer edges, in sizes, they are filled once
  // more. See "Tuning constants" in the manual.
  static constexpr double angle_to_be_repaired = 20;
  static constexpr double length_to_be_repaired = 2;

  std::size_t number_of_parts; // that meet in a zone; 1: the parts themselves; 0: zones are around what is repaired
  int         number_of_layers;
  bool        improves;
};

// The parts, then their seams. In the end, what is not as it should be where parts or zones met is done again, without
// anything near it that has to stay; and so is what is not where the zones of that met.
inline std::vector<Subdomain_round> rounds_with_repairs(const int layers_at_seams, const int layers_of_repairs,
                                                        const bool improve)
{
  constexpr int number_of_repairs = 3;
  std::vector<Subdomain_round> rounds;
  for(std::size_t number_of_parts = 1; number_of_parts <= Seams_3<>::last_round; ++number_of_parts)
    rounds.push_back({ number_of_parts, layers_at_seams, improve });
  rounds.insert(rounds.end(), number_of_repairs, { 0, layers_of_repairs, improve });
  return rounds;
}

inline std::vector<Subdomain_round> filling_rounds()
{
  constexpr int layers_to_be_filled = 3;
  return rounds_with_repairs(layers_to_be_filled, layers_to_be_filled, false);
}

inline std::vector<Subdomain_round> improving_rounds()
{
  constexpr int layers_to_be_improved = 2;
  constexpr int layers_to_be_repaired = 4;
  return rounds_with_repairs(layers_to_be_improved, layers_to_be_repaired, true);
}

// How many new vertices each task of a round may have, so that all together are not more than `number`.
inline std::vector<std::size_t> shares_of_vertices(const std::size_t number, const std::vector<std::size_t>& weights)
{
  const std::size_t sum = std::accumulate(weights.begin(), weights.end(), std::size_t(0));
  std::vector<std::size_t> shares;
  for(const std::size_t weight : weights) // no overflow while the cells of all tasks times those of one are below 2^64
    shares.push_back(number / sum * weight + number % sum * weight / sum);
  return shares;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SUBDOMAIN_ROUND_H
