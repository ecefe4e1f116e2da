// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_CONSTRAINT_SAMPLE_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_CONSTRAINT_SAMPLE_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>

#include <cstddef>
#include <random>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Chooses some constraints of many, at random, but the same ones in each run. No rule in the order of the input can
 * keep those that matter out of all samples.
 */
class Constraint_sample
{
public:
  // So many of the facets and edges with these indices of the input; some may come several times. All of them if they
  // are no more.
  template <typename Point_3>
  std::vector<Input_simplex_3<Point_3> > operator()(const Indexed_input_3<Point_3>& input, const Lost_constraints& from,
                                                    const std::size_t number)
  {
    const std::size_t n = from.facets.size() + from.edges.size();
    std::vector<Input_simplex_3<Point_3> > result;
    for(std::size_t k = 0; k < number && k < n; ++k)
    {
      const std::size_t i = n <= number ? k : m_random() % n;
      result.push_back(i < from.facets.size() ? describe_facet(input, from.facets[i])
                                              : describe_edge(input, from.edges[i - from.facets.size()]));
    }
    return result;
  }

private:
  std::minstd_rand m_random; // always the same numbers
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_INPUT_CONSTRAINT_SAMPLE_H
