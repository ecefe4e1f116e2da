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

#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_star_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Tells most facets that are not in a set from those that may be: two bits for each facet of the set, both in one word
 * of a table that has 8 to 16 bits for each facet.
 */
template <typename Vertex_handle>
class Facet_filter_3
{
public:
  explicit Facet_filter_3(const std::size_t number_of_facets)
  {
    std::size_t size = 1;
    while(8 * size < number_of_facets)
      size *= 2;
    m_words.assign(size, 0);
  }

  void insert(const std::array<Vertex_handle, 3>& f)
  {
    const std::uint64_t sum = hash_share(f[0]) + hash_share(f[1]) + hash_share(f[2]);
    m_words[word(sum)] |= bits(sum);
  }

  // The facet is given by the sum over its vertices, which does not depend on their order.
  bool may_contain(const std::uint64_t sum) const { return (m_words[word(sum)] & bits(sum)) == bits(sum); }

private:
  std::size_t word(const std::uint64_t sum) const
  {
    return static_cast<std::size_t>(sum >> 13) & (m_words.size() - 1);
  }

  static std::uint64_t bits(const std::uint64_t sum)
  {
    return (std::uint64_t(1) << (sum & 63)) | (std::uint64_t(1) << (sum >> 6 & 63));
  }

  std::vector<std::uint64_t> m_words;
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
  typedef typename Constraints::Vertex_triple Vertex_triple;

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
    std::vector<Vertex_triple> facets; // looked up some at a time
    std::vector<Cell_handle> cells;
    for(auto c = m_tr.all_cells_begin(); c != m_tr.all_cells_end(); ++c)
    {
      unsigned bits = candidate_facets(c, filter);
      for(int i = 0; bits != 0; bits >>= 1, ++i)
        if((bits & 1) != 0)
        {
          facets.push_back(internal::facet_vertices(c, i));
          cells.push_back(c);
        }
      if(facets.size() < number_of_facets_at_a_time)
        continue;
      put_in_place(facets, cells);
      facets.clear();
      cells.clear();
    }
    put_in_place(facets, cells);
  }

  // Bit i is set if facet i may be a constraint, and if it is this one of its two cells that is asked. There are no
  // branches, for nobody could predict them.
  static unsigned candidate_facets(const Cell_handle c, const Facet_filter_3<Vertex_handle>& filter)
  {
    std::array<std::uint64_t, 4> h;
    for(int i = 0; i < 4; ++i)
      h[i] = hash_share(c->vertex(i));
    const std::uint64_t sum = h[0] + h[1] + h[2] + h[3];
    unsigned result = 0;
    for(int i = 0; i < 4; ++i)
    {
      const unsigned is_asked = std::less<const void*>()(&*c, &*c->neighbor(i));
      const unsigned is_candidate = filter.may_contain(sum - h[i]);
      result |= (is_asked & is_candidate) << i;
    }
    return result;
  }

  void put_in_place(const std::vector<Vertex_triple>& facets, const std::vector<Cell_handle>& cells)
  {
    std::vector<std::size_t> indices;
    m_constraints.look_up(facets, indices);
    for(std::size_t k = 0; k < indices.size(); ++k)
      if(indices[k] != Constraints::none)
        m_places[indices[k]] = cells[k];
  }

  // A sweep takes less time than the stars if more than one facet of so many has no place.
  static constexpr std::size_t min_number_of_facets_per_star = 16;

  static constexpr std::size_t number_of_facets_at_a_time = 1024;

  const Tr& m_tr;
  const Constraints& m_constraints;
  std::vector<Cell_handle> m_places; // a cell of each facet, where it was found last
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_CONSTRAINT_SEARCH_3_H
