// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CONSTRAINT_STAR_SEARCH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CONSTRAINT_STAR_SEARCH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/cell_simplices.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Looks for given constraints in the stars of vertices, each visited once for all the constraints that are looked for
 * there.
 */
template <typename Tr>
class Constraint_star_search_3
{
public:
  typedef Constraints_3<Tr>          Constraints;
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;

  Constraint_star_search_3(const Tr& tr, const Constraints& constraints) : m_tr(tr), m_constraints(constraints) { }

  // Those of the given constraints that are lost.
  Lost_constraints operator()(const Lost_constraints& candidates)
  {
    sort_by_vertex(candidates);
    std::vector<char> is_edge_lost(candidates.edges.size()), is_facet_lost(candidates.facets.size());
    for(std::size_t i = 0; i < m_centers.size(); ++i)
    {
      m_star.clear();
      m_tr.tds().incident_cells(m_centers.keys()[i][0], std::back_inserter(m_star));
      for(std::size_t k = m_edge_ranges[i]; k < m_edge_ranges[i + 1]; ++k)
        is_edge_lost[m_edges[k]] = ! is_in_star(m_constraints.edges()[candidates.edges[m_edges[k]]]);
      for(std::size_t k = m_facet_ranges[i]; k < m_facet_ranges[i + 1]; ++k)
        is_facet_lost[m_facets[k]] = ! is_in_star(m_constraints.facets()[candidates.facets[m_facets[k]]]);
    }
    Lost_constraints lost;
    for(std::size_t e = 0; e < is_edge_lost.size(); ++e)
      if(is_edge_lost[e])
        lost.edges.push_back(candidates.edges[e]);
    for(std::size_t f = 0; f < is_facet_lost.size(); ++f)
      if(is_facet_lost[f])
        lost.facets.push_back(candidates.facets[f]);
    return lost;
  }

private:
  template <std::size_t N>
  bool is_in_star(const std::array<Vertex_handle, N>& simplex) const
  {
    for(const Cell_handle c : m_star)
      if(internal::has_vertices(c, simplex))
        return true;
    return false;
  }

  // Buckets the constraints by one of their vertices each, in the order in which these come first: where possible by
  // one that has a bucket, for edges and facets are lost together, and each star costs.
  void sort_by_vertex(const Lost_constraints& candidates)
  {
    m_centers.clear();
    std::vector<std::size_t> edge_bucket, facet_bucket;
    for(const std::size_t e : candidates.edges)
      edge_bucket.push_back(bucket(m_constraints.edges()[e]));
    for(const std::size_t f : candidates.facets)
      facet_bucket.push_back(bucket(m_constraints.facets()[f]));
    count_sort(edge_bucket, m_edges, m_edge_ranges);
    count_sort(facet_bucket, m_facets, m_facet_ranges);
  }

  template <std::size_t N>
  std::size_t bucket(const std::array<Vertex_handle, N>& simplex)
  {
    for(const Vertex_handle v : simplex)
    {
      const std::size_t b = m_centers[{{ v }}];
      if(b != m_centers.none)
        return b;
    }
    return m_centers.insert({{ simplex[0] }}).first;
  }

  void count_sort(const std::vector<std::size_t>& buckets,
                  std::vector<std::size_t>& sorted, std::vector<std::size_t>& ranges) const
  {
    ranges.assign(m_centers.size() + 1, 0);
    for(const std::size_t b : buckets)
      ++ranges[b + 1];
    for(std::size_t i = 1; i < ranges.size(); ++i)
      ranges[i] += ranges[i - 1];
    sorted.resize(buckets.size());
    std::vector<std::size_t> next(ranges.begin(), ranges.end() - 1);
    for(std::size_t i = 0; i < buckets.size(); ++i)
      sorted[next[buckets[i]]++] = i;
  }

  const Tr& m_tr;
  const Constraints& m_constraints;
  Simplex_index_3<Vertex_handle, 1> m_centers;            // of the stars
  std::vector<std::size_t> m_edges, m_facets;             // positions among the candidates, sorted by center
  std::vector<std::size_t> m_edge_ranges, m_facet_ranges; // where each center begins
  std::vector<Cell_handle> m_star;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CONSTRAINT_STAR_SEARCH_3_H
