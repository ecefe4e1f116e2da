// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REDUCE_BALL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REDUCE_BALL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Shell_transformation_3.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The condition that no new edge ends at a given vertex.
 */
template <typename Tr>
class No_new_edge_at_vertex_3
  : public No_shell_validity_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;

  explicit No_new_edge_at_vertex_3(const Vertex_handle v) : m_v(v) { }

  bool is_valid_chord(const Shell_3<Tr>& s, const int i, const int j) const
  {
    return s.vertex(i) != m_v && s.vertex(j) != m_v;
  }

private:
  Vertex_handle m_v;
};

/*
 * Removes the edges at a vertex one after the other by recursive shell transformations, until its ball is small enough
 * for the vertex to go ("Christmas tree", [CZZ+17, Fig. 7]).
 */
template <typename Tr, typename Visitor, typename Constraints>
class Reduce_ball_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef typename Tr::Edge                    Edge;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Mesh_editor_3<Tr, Visitor>           Editor;

  Reduce_ball_3(Editor& editor, const Predicates& predicates, const Constraints& constraints)
    : m_tr(editor.triangulation()), m_constraints(constraints),
      m_transformation(m_tr, Quality(m_tr), editor, predicates)
  { }

  // Goes on as long as an edge can be removed, and `try_to_remove`, which is called with the cells around v after each
  // one, returns false. Returns whether it returned true in the end.
  template <typename Context, typename Try_to_remove>
  bool operator()(const Vertex_handle v, const int l_max, Context& context, const Try_to_remove& try_to_remove)
  {
    const Validity validity{ Kept(m_constraints), No_new_edge_at_vertex_3<Tr>(v) };
    collect_ball(v);
    for(bool is_changed = true; is_changed; )
    {
      is_changed = false;
      const std::vector<Vertex_handle> neighbors = internal::vertices_without(m_ball, v);
      for(const Vertex_handle x : neighbors)
      {
        if(! context.go_further())
          return false;
        Cell_handle c;
        int i, j;
        if(! m_tr.is_edge(v, x, c, i, j))
          continue;
        const bool is_removed = m_transformation.remove_edge(Edge(c, i, j), l_max, validity);
        collect_ball(v); // its cells may have been replaced even if the edge is still there
        if(! is_removed)
          continue;
        is_changed = true;
        if(try_to_remove(m_ball))
          return true;
      }
    }
    return false;
  }

  std::size_t number_of_transformations() const { return m_transformation.number_of_transformations(); }

private:
  typedef Kept_constraints_3<Constraints>                                   Kept;
  typedef Shell_validity_conjunction_3<Kept, No_new_edge_at_vertex_3<Tr> >  Validity;
  typedef Worst_element_quality_3<Tr>                                       Quality;

  void collect_ball(const Vertex_handle v)
  {
    m_ball.clear();
    m_tr.incident_cells(v, std::back_inserter(m_ball));
  }

  Tr& m_tr;
  const Constraints& m_constraints;
  Shell_transformation_3<Tr, Quality, Validity, Editor> m_transformation;
  std::vector<Cell_handle> m_ball;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REDUCE_BALL_3_H
