// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_EDGE_RECOVERY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_EDGE_RECOVERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/Simplex_key_3.h>
#include <CGAL/Boundary_recovery_3/internal/Vertex_predicates_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Recovery of one lost edge: the body of the loop of [CZZ+17, Alg. 4].
 *
 * The mesh entities that cross the edge are removed one after the other, and collected again after each change. Only
 * the first and the last of them are tried: in a planar fan no other can be flipped away, and elsewhere attempts in the
 * middle make more mess than progress (on 24 telling surfaces, trying all left 23 % more edges lost in four times the
 * time).
 */
template <typename Tr>
class Edge_recovery_3
{
public:
  typedef typename Tr::Vertex_handle          Vertex_handle;
  typedef typename Tr::Cell_handle            Cell_handle;
  typedef typename Tr::Edge                   Edge;
  typedef typename Tr::Facet                  Facet;
  typedef Vertex_predicates_3<Tr>             Predicates;
  typedef Segment_walk_3<Tr>                  Walk;
  typedef typename Walk::Crossing             Crossing;

  Edge_recovery_3(const Tr& tr, const Predicates& predicates) : m_walk(tr, predicates) { }

  // Returns whether uv is a mesh edge in the end.
  template <typename Shell_transformation, typename Context>
  bool operator()(Shell_transformation& st, const std::array<Vertex_handle, 2>& uv, const int l_max, Context& context)
  {
    std::size_t fewest = std::size_t(-1);
    m_tried.clear();
    m_was_cut_off = false;
    while(context.go_further())
    {
      const typename Walk::Outcome outcome = m_walk(uv[0], uv[1]);
      if(outcome != Walk::CROSSED)
        return outcome == Walk::IS_EDGE;
      if(m_walk.crossings().size() < fewest)
      {
        fewest = m_walk.crossings().size();
        m_tried.clear();
      }
      if(! try_crossings(st, l_max))
        return false;
    }
    return false;
  }

  // The number of mesh entities that cross uv; 0 if it is a mesh edge.
  std::size_t number_of_crossings(const Vertex_handle u, const Vertex_handle v)
  {
    m_walk(u, v);
    return m_walk.crossings().size();
  }

  // Whether the recursion level or the bound on shells ended some removal in the last call.
  bool was_cut_off() const { return m_was_cut_off; }

  const Walk& walk() const { return m_walk; }

  // An edge counts as a facet with a vertex twice.
  static Simplex_key_3<3> key(const Crossing& crossing)
  {
    return simplex_key(crossing.vertices[0], crossing.vertices[1], crossing.vertices[crossing.dimension]);
  }

private:
  // Returns whether the mesh changed, so that the crossings have to be collected again.
  template <typename Shell_transformation>
  bool try_crossings(Shell_transformation& st, const int l_max)
  {
    for(const Crossing& crossing : { m_walk.crossings().front(), m_walk.crossings().back() })
    {
      if(m_tried.size() == max_number_of_attempts)
        return false;
      if(! is_new(crossing))
        continue;
      const std::size_t before = st.number_of_transformations();
      remove(st, crossing, l_max);
      m_was_cut_off |= st.was_cut_off();
      if(st.number_of_transformations() != before)
        return true;
    }
    return false;
  }

  template <typename Shell_transformation>
  static bool remove(Shell_transformation& st, const Crossing& crossing, const int l_max)
  {
    const Cell_handle c = crossing.cell;
    if(crossing.dimension == 1)
      return st.remove_edge(Edge(c, c->index(crossing.vertices[0]), c->index(crossing.vertices[1])), l_max);
    const int i = 6 - c->index(crossing.vertices[0]) - c->index(crossing.vertices[1]) - c->index(crossing.vertices[2]);
    return st.remove_facet(Facet(c, i), l_max);
  }

  // An entity is tried once between two decreases of the number of crossings.
  bool is_new(const Crossing& crossing)
  {
    if(std::find(m_tried.begin(), m_tried.end(), key(crossing)) != m_tried.end())
      return false;
    m_tried.push_back(key(crossing));
    return true;
  }

  // Entities tried between two decreases of the number of crossings.
  static constexpr std::size_t max_number_of_attempts = 8;

  Walk m_walk;
  std::vector<Simplex_key_3<3> > m_tried;
  bool m_was_cut_off = false;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_EDGE_RECOVERY_3_H
