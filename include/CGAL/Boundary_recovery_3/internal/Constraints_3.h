// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CONSTRAINTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CONSTRAINTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/cell_simplices.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The constraints: edges and facets, numbered in the order in which they were given.
 *
 * The edges of constrained facets are constrained, too. What is constrained is never destroyed once it is in the mesh,
 * so asking whether a mesh simplex is a constraint is all that the flips have to do.
 */
template <typename Tr>
class Constraints_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef std::array<Vertex_handle, 2>  Edge;
  typedef std::array<Vertex_handle, 3>  Facet;

  static constexpr std::size_t none = std::size_t(-1);

  // `number_of_edges` does not include those of the facets.
  void reserve(const std::size_t number_of_edges, const std::size_t number_of_facets)
  {
    m_edges.reserve(number_of_edges + 3 * number_of_facets / 2);
    m_facets.reserve(number_of_facets);
    m_edges_of_facets.reserve(number_of_facets);
  }

  // Adds an edge, unless it is there already, and returns its index.
  std::size_t insert(const Vertex_handle u, const Vertex_handle v) { return m_edges.insert({{ u, v }}).first; }

  // Adds a facet with its edges, unless it is there already, and returns its index.
  std::size_t insert(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    const auto inserted = m_facets.insert({{ u, v, w }});
    if(inserted.second)
      m_edges_of_facets.push_back({{ insert(u, v), insert(v, w), insert(w, u) }});
    return inserted.first;
  }

  const std::vector<Edge>& edges() const { return m_edges.keys(); }
  const std::vector<Facet>& facets() const { return m_facets.keys(); }

  // The indices of the edges of a facet.
  const std::array<std::size_t, 3>& edges_of_facet(const std::size_t f) const { return m_edges_of_facets[f]; }

  std::size_t index(const Vertex_handle u, const Vertex_handle v) const
  {
    return m_edges[{{ u, v }}];
  }

  std::size_t index(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    return m_facets[{{ u, v, w }}];
  }

  // For each of the facets its index, or none.
  void look_up(const std::vector<Facet>& facets, std::vector<std::size_t>& indices) const
  {
    m_facets.look_up(facets, indices);
  }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const
  {
    return index(u, v) != none;
  }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    return index(u, v, w) != none;
  }

  // Appends the constraints that are edges or facets of the given cells. Some come more than once.
  template <typename CellRange>
  void collect(const CellRange& cells, std::vector<Edge>& edges, std::vector<Facet>& facets) const
  {
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
      {
        const Facet f = internal::facet_vertices(c, i);
        if(is_constrained(f[0], f[1], f[2]))
          facets.push_back(f);
        for(int j = i + 1; j < 4; ++j)
          if(is_constrained(c->vertex(i), c->vertex(j)))
            edges.push_back({{ c->vertex(i), c->vertex(j) }});
      }
  }

private:
  Simplex_index_3<Vertex_handle, 2> m_edges;
  Simplex_index_3<Vertex_handle, 3> m_facets;
  std::vector<std::array<std::size_t, 3> > m_edges_of_facets;
};

// The constraints that are not in the mesh, by their indices in increasing order.
struct Lost_constraints
{
  std::vector<std::size_t> edges;
  std::vector<std::size_t> facets;
};

/*
 * Looks up constraints in the mesh.
 *
 * All of them: by one sweep over the mesh facets, which finds the constrained facets and their edges; a small filter
 * spares most facets the look-up in the table. What is not found so, and a given set of constraints, is looked for in
 * the stars of vertices, each visited once for all the constraints that are looked for there.
 */
template <typename Tr>
class Constraint_search_3
{
public:
  typedef Constraints_3<Tr>                  Constraints;
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef typename Tr::Cell_handle           Cell_handle;
  typedef typename Constraints::Facet        Facet;

  Constraint_search_3(const Tr& tr, const Constraints& constraints) : m_tr(tr), m_constraints(constraints) { }

  // Those of all the constraints that are lost.
  Lost_constraints operator()()
  {
    std::vector<char> is_edge_found(m_constraints.edges().size()), is_facet_found(m_constraints.facets().size());
    find_facets(is_facet_found);
    std::vector<std::size_t> lost_facets;
    for(std::size_t f = 0; f < is_facet_found.size(); ++f)
      if(! is_facet_found[f])
        lost_facets.push_back(f);
      else
        for(const std::size_t e : m_constraints.edges_of_facet(f))
          is_edge_found[e] = true;
    Lost_constraints candidates;
    for(std::size_t e = 0; e < is_edge_found.size(); ++e)
      if(! is_edge_found[e])
        candidates.edges.push_back(e);
    Lost_constraints lost = (*this)(candidates);
    lost.facets = std::move(lost_facets);
    return lost;
  }

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
  void find_facets(std::vector<char>& is_found)
  {
    fill_in_filter();
    std::vector<Facet> facets; // looked up some at a time
    for(auto c = m_tr.all_cells_begin(); c != m_tr.all_cells_end(); ++c)
    {
      unsigned candidates = candidate_facets(c);
      for(int i = 0; candidates != 0; candidates >>= 1, ++i)
        if((candidates & 1) != 0)
          facets.push_back(internal::facet_vertices(c, i));
      if(facets.size() < number_of_facets_at_a_time)
        continue;
      look_up(facets, is_found);
      facets.clear();
    }
    look_up(facets, is_found);
  }

  // Bit i is set if facet i may be a constraint, and if it is this one of its two cells that is asked. There are no
  // branches, for nobody could predict them.
  unsigned candidate_facets(const Cell_handle c) const
  {
    std::array<std::uint64_t, 4> h;
    for(int i = 0; i < 4; ++i)
      h[i] = hash_share(c->vertex(i));
    const std::uint64_t sum = h[0] + h[1] + h[2] + h[3];
    unsigned result = 0;
    for(int i = 0; i < 4; ++i)
    {
      const unsigned is_asked = std::less<const void*>()(&*c, &*c->neighbor(i));
      const unsigned is_candidate = may_be_constrained(sum - h[i]);
      result |= (is_asked & is_candidate) << i;
    }
    return result;
  }

  void look_up(const std::vector<Facet>& facets, std::vector<char>& is_found)
  {
    m_constraints.look_up(facets, m_indices);
    for(const std::size_t f : m_indices)
      if(f != Constraints::none)
        is_found[f] = true;
  }

  // Two bits for each constrained facet, both in one word of a table that has 8 to 16 bits for each facet.
  void fill_in_filter()
  {
    std::size_t size = 1;
    while(8 * size < m_constraints.facets().size())
      size *= 2;
    m_filter.assign(size, 0);
    for(const auto& f : m_constraints.facets())
    {
      const std::uint64_t sum = hash_share(f[0]) + hash_share(f[1]) + hash_share(f[2]);
      m_filter[filter_word(sum)] |= filter_bits(sum);
    }
  }

  // The facet is given by the sum over its vertices, which does not depend on their order.
  bool may_be_constrained(const std::uint64_t sum) const
  {
    return (m_filter[filter_word(sum)] & filter_bits(sum)) == filter_bits(sum);
  }

  std::size_t filter_word(const std::uint64_t sum) const
  {
    return static_cast<std::size_t>(sum >> 13) & (m_filter.size() - 1);
  }

  static std::uint64_t filter_bits(const std::uint64_t sum)
  {
    return (std::uint64_t(1) << (sum & 63)) | (std::uint64_t(1) << (sum >> 6 & 63));
  }

  template <std::size_t N>
  bool is_in_star(const std::array<Vertex_handle, N>& simplex) const
  {
    for(const Cell_handle c : m_star)
    {
      std::size_t i = 0;
      while(i < N && c->has_vertex(simplex[i]))
        ++i;
      if(i == N)
        return true;
    }
    return false;
  }

  // Buckets the constraints by one of their vertices each, in the order in which these come first: where possible by
  // one that has a bucket, for edges and facets are lost together, and each star costs.
  void sort_by_vertex(const Lost_constraints& candidates)
  {
    m_centers = Simplex_index_3<Vertex_handle, 1>();
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

  static constexpr std::size_t number_of_facets_at_a_time = 1024;

  const Tr& m_tr;
  const Constraints& m_constraints;
  Simplex_index_3<Vertex_handle, 1> m_centers;            // of the stars
  std::vector<std::size_t> m_edges, m_facets;             // positions among the candidates, sorted by center
  std::vector<std::size_t> m_edge_ranges, m_facet_ranges; // where each center begins
  std::vector<Cell_handle> m_star;
  std::vector<std::uint64_t> m_filter;
  std::vector<std::size_t> m_indices;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CONSTRAINTS_3_H
