// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The constraints: edges and facets, numbered in the order in which they were given.
 *
 * The edges of constrained facets are constrained, too. What is constrained is never destroyed once it is in the mesh,
 * so asking whether a mesh simplex is a constraint is all that the flips have to do.
 *
 * Constraints can be erased, and split by a vertex on them. The others keep their numbers then; what is erased leaves a
 * gap in them, and is found by no question any more. (The searches for lost constraints take a gap for a lost one.)
 */
template <typename Tr>
class Constraints_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef std::array<Vertex_handle, 2>  Vertex_pair;
  typedef std::array<Vertex_handle, 3>  Vertex_triple;

  typedef boost::container::small_vector<std::size_t, 2> Facets_at_edge;

  static constexpr std::size_t none = std::size_t(-1);

  // `number_of_edges` does not include those of the facets.
  void reserve(const std::size_t number_of_edges, const std::size_t number_of_facets)
  {
    m_edges.reserve(number_of_edges + 3 * number_of_facets / 2);
    m_facets.reserve(number_of_facets);
    m_edges_of_facets.reserve(number_of_facets);
  }

  // Adds an edge, unless it is there already, and returns its index.
  std::size_t insert(const Vertex_handle u, const Vertex_handle v)
  {
    const std::size_t e = insert_edge(u, v);
    m_given_edges.insert(e);
    return e;
  }

  // Adds a facet with its edges, unless it is there already, and returns its index.
  std::size_t insert(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    const auto inserted = m_facets.insert({{ u, v, w }});
    if(! inserted.second)
      return inserted.first;
    m_edges_of_facets.push_back({{ insert_edge(u, v), insert_edge(v, w), insert_edge(w, u) }});
    if(m_is_adjacency_known)
      add_to_edges(inserted.first);
    return inserted.first;
  }

  // Erases an edge with all the facets at it.
  void erase(const Vertex_handle u, const Vertex_handle v)
  {
    const std::size_t e = index(u, v);
    if(e == none)
      return;
    m_given_edges.erase(e);
    if(facets_at_edge(e).empty())
      m_edges.erase({{ u, v }});
    for(const std::size_t f : Facets_at_edge(facets_at_edge(e)))
      erase_facet(f); // with the last one, the edge goes
  }

  // Erases a facet, and those of its edges that no other facet has, and that were not given by themselves.
  void erase(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    const std::size_t f = index(u, v, w);
    if(f != none)
      erase_facet(f);
  }

  // The edge uv becomes uw and wv, and each facet at it two, in its orientation; w is a vertex of none of these.
  void split(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    const std::size_t e = index(u, v);
    CGAL_precondition(e != none);
    const Facets_at_edge facets = facets_at_edge(e);
    const bool is_given = m_given_edges.count(e) != 0;
    for(const std::size_t f : facets)
    {
      const Vertex_triple facet = m_facets.keys()[f];
      insert(with_exchanged(facet, u, w));
      insert(with_exchanged(facet, v, w));
    }
    erase(u, v);
    if(is_given)
    {
      insert(u, w);
      insert(w, v);
    }
  }

  // The facet uvw becomes three, in its orientation.
  void split(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w, const Vertex_handle x)
  {
    const std::size_t f = index(u, v, w);
    CGAL_precondition(f != none);
    const Vertex_triple facet = m_facets.keys()[f];
    for(const Vertex_handle replaced : facet)
      insert(with_exchanged(facet, replaced, x));
    erase_facet(f);
  }

  // Whether the number is that of a constraint that is erased.
  bool is_edge_erased(const std::size_t e) const { return m_edges.is_erased(e); }
  bool is_facet_erased(const std::size_t f) const { return m_facets.is_erased(f); }

  const std::vector<Vertex_pair>& edges() const { return m_edges.keys(); }
  const std::vector<Vertex_triple>& facets() const { return m_facets.keys(); }

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

  // The indices of the facets at an edge, in increasing order. They are looked for once for all edges: only where
  // something is erased or split, or points are put on constraints, has it to be known. By one thread.
  const Facets_at_edge& facets_at_edge(const std::size_t e) const
  {
    find_facets_at_edges();
    return m_facets_at_edges[e];
  }

  // For each of the facets its index, or none.
  void look_up(const std::vector<Vertex_triple>& facets, std::vector<std::size_t>& indices) const
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

private:
  std::size_t insert_edge(const Vertex_handle u, const Vertex_handle v) { return m_edges.insert({{ u, v }}).first; }

  std::size_t insert(const Vertex_triple& f) { return insert(f[0], f[1], f[2]); }

  static Vertex_triple with_exchanged(Vertex_triple facet, const Vertex_handle replaced, const Vertex_handle v)
  {
    std::replace(facet.begin(), facet.end(), replaced, v);
    return facet;
  }

  void erase_facet(const std::size_t f)
  {
    find_facets_at_edges();
    for(const std::size_t e : m_edges_of_facets[f])
    {
      Facets_at_edge& facets = m_facets_at_edges[e];
      facets.erase(std::find(facets.begin(), facets.end(), f));
      if(facets.empty() && m_given_edges.count(e) == 0)
        m_edges.erase(m_edges.keys()[e]);
    }
    m_facets.erase(m_facets.keys()[f]);
  }

  void find_facets_at_edges() const
  {
    m_facets_at_edges.resize(m_edges.size());
    if(m_is_adjacency_known)
      return;
    m_is_adjacency_known = true;
    for(std::size_t f = 0; f < m_edges_of_facets.size(); ++f)
      add_to_edges(f);
  }

  void add_to_edges(const std::size_t f) const
  {
    m_facets_at_edges.resize(m_edges.size());
    for(const std::size_t e : m_edges_of_facets[f])
      m_facets_at_edges[e].push_back(f);
  }

  Simplex_index_3<Vertex_handle, 2> m_edges;
  Simplex_index_3<Vertex_handle, 3> m_facets;
  std::vector<std::array<std::size_t, 3> > m_edges_of_facets;
  std::unordered_set<std::size_t> m_given_edges; // those that were given by themselves; look-up only
  mutable bool m_is_adjacency_known = false;
  mutable std::vector<Facets_at_edge> m_facets_at_edges; // by edge, if it is known
};

// The constraints that are not in the mesh, by their indices in increasing order.
struct Lost_constraints
{
  std::vector<std::size_t> edges;
  std::vector<std::size_t> facets;
};

/*
 * What can be asked of any set of constraints that answers `is_constrained()` for two vertices of a cell and for three.
 */

// Appends the constraints that are edges or facets of the given cells. Some come more than once.
template <typename Constraints, typename CellRange, typename Vertex_handle>
void collect_constraints(const Constraints& constraints, const CellRange& cells,
                         std::vector<std::array<Vertex_handle, 2> >& edges,
                         std::vector<std::array<Vertex_handle, 3> >& facets)
{
  for(const auto c : cells)
    for(int i = 0; i < 4; ++i)
    {
      const std::array<Vertex_handle, 3> f = internal::facet_vertices(c, i);
      if(constraints.is_constrained(f[0], f[1], f[2]))
        facets.push_back(f);
      for(int j = i + 1; j < 4; ++j)
        if(constraints.is_constrained(c->vertex(i), c->vertex(j)))
          edges.push_back({{ c->vertex(i), c->vertex(j) }});
    }
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINTS_3_H
