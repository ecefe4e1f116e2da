// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PARTITION_GRAPH_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PARTITION_GRAPH_H

#include <CGAL/license/Boundary_recovery_3.h>

#ifdef CGAL_METIS_ENABLED
#include <metis.h>
#endif

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <new>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// A graph whose nodes and edges have weights; each edge is named at both of its ends.
struct Weighted_graph
{
  void begin_node(const double weight)
  {
    node_weights.push_back(weight);
    edge_begin.push_back(ends.size());
  }

  // Of the node that was begun last.
  void add_edge(const std::size_t end, const int weight)
  {
    ends.push_back(end);
    edge_weights.push_back(weight);
  }

  std::vector<double>      node_weights;
  std::vector<std::size_t> edge_begin; // of each node
  std::vector<std::size_t> ends;
  std::vector<int>         edge_weights;
};

#ifdef CGAL_METIS_ENABLED

/*
 * Returns the part, from 0 on, of each node, so that parts have about the same weight and few edges between them. It is
 * METIS that finds them, with a seed that does not change. Some parts may be empty.
 */
inline std::vector<std::size_t> partition_graph(const Weighted_graph& graph, const std::size_t number_of_parts)
{
  const std::size_t n = graph.node_weights.size();
  std::vector<idx_t> part(n, 0);
  if(number_of_parts > 1 && n > 1)
  {
    // integers whose sum does not overflow
    const double total = std::accumulate(graph.node_weights.begin(), graph.node_weights.end(), 0.);
    const double scale = 1e8 / (std::max)(total, 1.);
    std::vector<idx_t> weights, begin(graph.edge_begin.begin(), graph.edge_begin.end()),
                       ends(graph.ends.begin(), graph.ends.end()),
                       edge_weights(graph.edge_weights.begin(), graph.edge_weights.end());
    for(const double w : graph.node_weights)
      weights.push_back(1 + static_cast<idx_t>(scale * w));
    begin.push_back(static_cast<idx_t>(ends.size()));
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 0;
    options[METIS_OPTION_UFACTOR] = 30; // parts are at most 3 % heavier than the mean
    idx_t number_of_nodes = static_cast<idx_t>(n), number_of_constraints = 1, cut = 0,
          parts = static_cast<idx_t>((std::min)(number_of_parts, n));
    const int status = METIS_PartGraphKway(&number_of_nodes, &number_of_constraints, begin.data(), ends.data(),
                                           weights.data(), nullptr, edge_weights.data(), &parts, nullptr, nullptr,
                                           options, &cut, part.data());
    if(status == METIS_ERROR_MEMORY)
      throw std::bad_alloc();
    CGAL_assertion(status == METIS_OK);
  }
  return std::vector<std::size_t>(part.begin(), part.end());
}

#endif // CGAL_METIS_ENABLED

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PARTITION_GRAPH_H
