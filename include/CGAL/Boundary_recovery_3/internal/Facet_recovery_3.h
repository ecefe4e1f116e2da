// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FACET_RECOVERY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FACET_RECOVERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Facet_walk_3.h>
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
 * Recovery of one lost facet whose edges are mesh edges [CZZ+17, Section 4.2.2]: the mesh edges that pierce it are
 * removed one after the other, and collected again after each removal.
 */
template <typename Tr>
class Facet_recovery_3
{
public:
  typedef typename Tr::Vertex_handle          Vertex_handle;
  typedef typename Tr::Cell_handle            Cell_handle;
  typedef typename Tr::Edge                   Edge;
  typedef Vertex_predicates_3<Tr>             Predicates;
  typedef Facet_walk_3<Tr>                    Walk;
  typedef typename Walk::Crossing             Crossing;

  Facet_recovery_3(const Tr& tr, const Predicates& predicates)
    : m_tr(tr), m_walk(tr, predicates)
  { }

  // Returns whether uvw is a mesh facet in the end.
  template <typename Shell_transformation, typename Context>
  bool operator()(Shell_transformation& st, const std::array<Vertex_handle, 3>& uvw, const int l_max, Context& context)
  {
    std::size_t fewest = std::size_t(-1);
    m_tried.clear();
    m_was_cut_off = false;
    while(context.go_further())
    {
      const typename Walk::Outcome outcome = walk_over(uvw[0], uvw[1], uvw[2]);
      if(outcome != Walk::CROSSED)
        return outcome == Walk::IS_FACET;
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

  // The number of mesh edges that pierce uvw; 0 if it is a mesh facet.
  std::size_t number_of_crossings(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    walk_over(u, v, w);
    return m_walk.crossings().size();
  }

  // Whether the recursion level or the bound on shells ended some removal in the last call.
  bool was_cut_off() const { return m_was_cut_off; }

  const Walk& walk() const { return m_walk; }

  // An edge counts as a facet with a vertex twice, as in Edge_recovery_3.
  static Simplex_key_3<3> key(const Crossing& crossing)
  {
    return simplex_key(crossing.vertices[0], crossing.vertices[1], crossing.vertices[1]);
  }

private:
  typename Walk::Outcome walk_over(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    int i, j;
    Cell_handle c;
    m_tr.is_edge(u, v, c, i, j);
    return m_walk(u, v, w, c);
  }

  // Returns whether the mesh changed, so that the crossings have to be collected again.
  template <typename Shell_transformation>
  bool try_crossings(Shell_transformation& st, const int l_max)
  {
    for(const Crossing& crossing : m_walk.crossings())
    {
      if(std::find(m_tried.begin(), m_tried.end(), key(crossing)) != m_tried.end())
        continue;
      m_tried.push_back(key(crossing));
      const std::size_t before = st.number_of_transformations();
      const Cell_handle c = crossing.cell;
      st.remove_edge(Edge(c, c->index(crossing.vertices[0]), c->index(crossing.vertices[1])), l_max);
      m_was_cut_off |= st.was_cut_off();
      if(st.number_of_transformations() != before)
        return true;
    }
    return false;
  }

  const Tr& m_tr;
  Walk m_walk;
  std::vector<Simplex_key_3<3> > m_tried;
  bool m_was_cut_off = false;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FACET_RECOVERY_3_H
