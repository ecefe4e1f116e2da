// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_MERGE_POINTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_MERGE_POINTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/replace_and_forget.h>

#include <iterator>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Makes one point of two free Steiner points that are neighbors, where one point sees the boundary of both balls.
 */
template <typename Tr, typename Visitor>
class Merge_points_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Constraints_3<Tr>                    Constraints;
  typedef Steiner_ledger_3<Tr>                 Ledger;
  typedef Mesh_editor_3<Tr, Visitor>           Editor;

  Merge_points_3(Editor& editor, const Predicates& predicates, const Constraints& constraints, Ledger& ledger)
    : m_editor(editor), m_constraints(constraints), m_ledger(ledger), m_move_into_kernel(predicates, ledger.positions())
  { }

  // Merges v, of which `ball` are the cells around it, with the first neighbor for which this is possible.
  template <typename Context>
  void operator()(const Vertex_handle v, const std::vector<Cell_handle>& ball, Context& context)
  {
    const typename Ledger::Positions::Point_3 before = v->point();
    for(const Vertex_handle w : internal::vertices_without(ball, v))
    {
      if(! m_ledger.is_free(w) || ! internal::collect_ball(m_editor.triangulation(), w, m_ball))
        continue;
      if(! context.go_further())
        return;
      Cavity_3<Tr> cavity(m_editor.triangulation(), m_constraints, ball);
      for(const Cell_handle c : m_ball)
        cavity.add(c);
      std::vector<Vertex_triple> faces;
      std::vector<Vertex_handle> inner_points;
      if(! m_ledger.positions().contains(v) && cavity.collect_boundary(m_ledger.free_points(), faces, inner_points)
         && m_move_into_kernel(v, faces))
      {
        internal::star_and_forget(m_editor, m_ledger, cavity, v);
        return;
      }
      v->set_point(before);
    }
  }

private:
  typedef typename Move_into_kernel_3<Tr>::Vertex_triple Vertex_triple;

  Editor& m_editor;
  const Constraints& m_constraints;
  Ledger& m_ledger;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  std::vector<Cell_handle> m_ball;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_MERGE_POINTS_3_H
