// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_CONSTRAINT_SEARCH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_CONSTRAINT_SEARCH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Looks for given constraints in the stars of vertices, each visited once for all the constraints that are looked for
 * there. Where these are many, the link of the vertex is indexed.
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
      const std::size_t n = m_edge_ranges[i + 1] - m_edge_ranges[i] + m_facet_ranges[i + 1] - m_facet_ranges[i];
      if(n <= max_number_of_scans)
        look_up(i, candidates, is_edge_lost, is_facet_lost, [this](const auto& s) { return this->is_in_star(s); });
      else
        look_up(i, candidates, is_edge_lost, is_facet_lost, Link(m_centers.keys()[i][0], m_star));
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
  // The simplices at a vertex, by their other vertices.
  class Link
  {
  public:
    Link(const Vertex_handle center, const std::vector<Cell_handle>& star) : m_center(center)
    {
      for(const Cell_handle c : star)
        for(int i = 0; i < 4; ++i)
          if(c->vertex(i) != center)
          {
            m_vertices.insert({{ c->vertex(i) }});
            for(int j = i + 1; j < 4; ++j)
              if(c->vertex(j) != center)
                m_edges.insert({{ c->vertex(i), c->vertex(j) }});
          }
    }

    bool operator()(const std::array<Vertex_handle, 2>& e) const
    {
      return m_vertices[{{ e[0] == m_center ? e[1] : e[0] }}] != m_vertices.none;
    }

    bool operator()(const std::array<Vertex_handle, 3>& f) const
    {
      const int i = f[0] == m_center ? 0 : f[1] == m_center ? 1 : 2;
      return m_edges[{{ f[(i + 1) % 3], f[(i + 2) % 3] }}] != m_edges.none;
    }

  private:
    const Vertex_handle m_center;
    Simplex_index_3<Vertex_handle, 1> m_vertices;
    Simplex_index_3<Vertex_handle, 2> m_edges;
  };

  // Answers for all that is in bucket i.
  template <typename Is_in_star>
  void look_up(const std::size_t i, const Lost_constraints& candidates, std::vector<char>& is_edge_lost,
               std::vector<char>& is_facet_lost, const Is_in_star& is_in_star) const
  {
    for(std::size_t k = m_edge_ranges[i]; k < m_edge_ranges[i + 1]; ++k)
      is_edge_lost[m_edges[k]] = ! is_in_star(m_constraints.edges()[candidates.edges[m_edges[k]]]);
    for(std::size_t k = m_facet_ranges[i]; k < m_facet_ranges[i + 1]; ++k)
      is_facet_lost[m_facets[k]] = ! is_in_star(m_constraints.facets()[candidates.facets[m_facets[k]]]);
  }

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

  // An index of the link takes as much time as so many scans of the star.
  static constexpr std::size_t max_number_of_scans = 32;

  const Tr& m_tr;
  const Constraints& m_constraints;
  Simplex_index_3<Vertex_handle, 1> m_centers;            // of the stars
  std::vector<std::size_t> m_edges, m_facets;             // positions among the candidates, sorted by center
  std::vector<std::size_t> m_edge_ranges, m_facet_ranges; // where each center begins
  std::vector<Cell_handle> m_star;
};

/*
 * Looks up constraints in the mesh.
 *
 * All of them: first the facets where the last sweep found them. If many have gone from there, another sweep over the
 * mesh facets finds them; a small filter spares most facets the look-up in the table. Edges are found with the facets.
 * What is not found so, and a given set of constraints, is looked for in the stars of vertices.
 *
 * Which of its two cells is the place of a facet depends on addresses; what is found does not.
 */
template <typename Tr>
class Constraint_search_3
{
public:
  typedef Constraints_3<Tr>                  Constraints;
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef typename Tr::Cell_handle           Cell_handle;

  Constraint_search_3(const Tr& tr, const Constraints& constraints) : m_tr(tr), m_constraints(constraints) { }

  // Those of all the constraints that are lost.
  Lost_constraints operator()()
  {
    m_places.resize(m_constraints.facets().size());
    leave_old_places();
    Lost_constraints candidates;
    candidates.facets = facets_without_place();
    if(min_number_of_facets_per_star * candidates.facets.size() <= m_places.size())
    {
      candidates.edges = edges_without_place();
      return (*this)(candidates);
    }
    sweep(candidates.facets);
    candidates.edges = edges_without_place();
    candidates.facets.clear();
    Lost_constraints lost = (*this)(candidates);
    lost.facets = facets_without_place();
    return lost;
  }

  // Those of the given constraints that are lost.
  Lost_constraints operator()(const Lost_constraints& candidates) const
  {
    return Constraint_star_search_3<Tr>(m_tr, m_constraints)(candidates);
  }

private:
  // Forgets where facets were, if they are not there any more. A cell that is gone may still have its vertices; the
  // container keeps its memory until it is cleared, assigned to or swapped.
  void leave_old_places()
  {
    for(std::size_t f = 0; f < m_places.size(); ++f)
      if(m_places[f] != Cell_handle() && ! (m_tr.tds().cells().is_used(m_places[f])
                                            && internal::has_vertices(m_places[f], m_constraints.facets()[f])))
        m_places[f] = Cell_handle();
  }

  std::vector<std::size_t> facets_without_place() const
  {
    std::vector<std::size_t> result;
    for(std::size_t f = 0; f < m_places.size(); ++f)
      if(m_places[f] == Cell_handle())
        result.push_back(f);
    return result;
  }

  // Those of which no facet has a place.
  std::vector<std::size_t> edges_without_place() const
  {
    std::vector<char> is_found(m_constraints.edges().size());
    for(std::size_t f = 0; f < m_places.size(); ++f)
      if(m_places[f] != Cell_handle())
        for(const std::size_t e : m_constraints.edges_of_facet(f))
          is_found[e] = true;
    std::vector<std::size_t> result;
    for(std::size_t e = 0; e < is_found.size(); ++e)
      if(! is_found[e])
        result.push_back(e);
    return result;
  }

  // Finds the places of those of the given constrained facets that are in the mesh.
  void sweep(const std::vector<std::size_t>& candidates)
  {
    Facet_filter_3<Vertex_handle> filter(candidates.size());
    for(const std::size_t f : candidates)
      filter.insert(m_constraints.facets()[f]);
    internal::find_facets(m_tr.all_cell_handles(), filter, m_constraints,
                          [this](const std::size_t f, const Cell_handle c, int) { m_places[f] = c; });
  }

  // A sweep takes less time than the stars if more than one facet of so many has no place.
  static constexpr std::size_t min_number_of_facets_per_star = 16;

  const Tr& m_tr;
  const Constraints& m_constraints;
  std::vector<Cell_handle> m_places; // a cell of each facet, where it was found last
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_CONSTRAINT_SEARCH_3_H
