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

  std::size_t edge_end(const std::size_t node) const
  {
    return node + 1 < edge_begin.size() ? edge_begin[node + 1] : ends.size();
  }

  double weight() const { return std::accumulate(node_weights.begin(), node_weights.end(), 0.); }

  std::vector<double>      node_weights;
  std::vector<std::size_t> edge_begin; // of each node
  std::vector<std::size_t> ends;
  std::vector<int>         edge_weights;
};

// See "Tuning constants" in the manual.
constexpr std::size_t graph_nodes_per_part = 16;

// Makes heavy nodes lighter, until none has more than this share of all weights. There are more nodes than that.
inline void limit_weights(Weighted_graph& graph, const std::size_t least_number_of_shares)
{
  for(double largest = 0, limit = -1; largest > limit; )
  {
    limit = graph.weight() / static_cast<double>(least_number_of_shares);
    largest = *std::max_element(graph.node_weights.begin(), graph.node_weights.end());
    for(double& w : graph.node_weights)
      w = (std::min)(w, limit);
    limit *= 1 + 1e-3; // it need not be exact
  }
}

#ifdef CGAL_METIS_ENABLED

// The part of each node, by METIS, with a seed that does not change.
inline std::vector<std::size_t> parts_by_metis(Weighted_graph graph, const std::size_t number_of_parts)
{
  limit_weights(graph, graph_nodes_per_part / 4 * number_of_parts);
  const double scale = 1e8 / graph.weight(); // integers whose sum does not overflow
  std::vector<idx_t> weights, part(graph.node_weights.size()),
                     begin(graph.edge_begin.begin(), graph.edge_begin.end()),
                     ends(graph.ends.begin(), graph.ends.end()),
                     edge_weights(graph.edge_weights.begin(), graph.edge_weights.end());
  for(const double w : graph.node_weights)
    weights.push_back(1 + static_cast<idx_t>(scale * w));
  begin.push_back(static_cast<idx_t>(ends.size()));
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 0;
  idx_t number_of_nodes = static_cast<idx_t>(part.size()), number_of_constraints = 1, cut = 0,
        parts = static_cast<idx_t>(number_of_parts);
  const int status = METIS_PartGraphKway(&number_of_nodes, &number_of_constraints, begin.data(), ends.data(),
                                         weights.data(), nullptr, edge_weights.data(), &parts, nullptr, nullptr,
                                         options, &cut, part.data());
  if(status != METIS_OK) // the graph is one that METIS takes, so it is memory that is lacking
    throw std::bad_alloc();
  return std::vector<std::size_t>(part.begin(), part.end());
}

#else

// The part of each node: they are taken in breadth-first order, until a part is heavy enough.
inline std::vector<std::size_t> parts_by_search(const Weighted_graph& graph, const std::size_t number_of_parts)
{
  const std::size_t n = graph.node_weights.size();
  const double weight_of_part = graph.weight() / static_cast<double>(number_of_parts);
  std::vector<std::size_t> part(n, number_of_parts), queue;
  double done = 0;
  std::size_t first = 0;
  for(std::size_t root = 0; root < n; ++root)
  {
    if(part[root] == number_of_parts)
    {
      part[root] = 0;
      queue.push_back(root);
    }
    for( ; first < queue.size(); ++first)
    {
      const std::size_t u = queue[first];
      part[u] = (std::min)(number_of_parts - 1, static_cast<std::size_t>(done / weight_of_part));
      done += graph.node_weights[u];
      for(std::size_t k = graph.edge_begin[u]; k < graph.edge_end(u); ++k)
        if(part[graph.ends[k]] == number_of_parts)
        {
          part[graph.ends[k]] = 0; // it is in the queue
          queue.push_back(graph.ends[k]);
        }
    }
  }
  return part;
}

#endif // CGAL_METIS_ENABLED

/*
 * Returns the part, from 0 on, of each node, so that parts have about the same weight and few edges between them, as
 * few as METIS finds, if it is linked. There are fewer parts if the graph is small. METIS prints if a part gets no
 * node; so none is heavier than a fraction of a part.
 */
inline std::vector<std::size_t> partition_graph(const Weighted_graph& graph, const std::size_t number_of_parts)
{
  const std::size_t number = (std::min)(number_of_parts, graph.node_weights.size() / graph_nodes_per_part);
  if(number < 2)
    return std::vector<std::size_t>(graph.node_weights.size(), 0);
#ifdef CGAL_METIS_ENABLED
  return internal::parts_by_metis(graph, number);
#else
  return internal::parts_by_search(graph, number);
#endif
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PARTITION_GRAPH_H
