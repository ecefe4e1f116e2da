// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SUPPRESS_FREE_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SUPPRESS_FREE_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Remove_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Shell_transformation_3.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

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
 * Removes the edges at a vertex one after the other by recursive shell transformations, until its star is small enough
 * for the vertex to go ("Christmas tree", [CZZ+17, Fig. 7]).
 */
template <typename Tr, typename Constraints>
class Reduce_star_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef typename Tr::Edge                    Edge;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Mesh_editor_3<Tr>           Editor;

  Reduce_star_3(Editor& editor, const Predicates& predicates, const Constraints& constraints)
    : m_tr(editor.triangulation()), m_constraints(constraints),
      m_transformation(m_tr, Quality(m_tr), editor, predicates)
  { }

  // Goes on as long as an edge can be removed, and `try_to_remove`, which is called with the cells around v after each
  // one, returns false. Gives up after too many shells: where it works, it needs few. Returns whether it returned true
  // in the end.
  template <typename Context, typename Try_to_remove>
  bool operator()(const Vertex_handle v, const int l_max, Context& context, const Try_to_remove& try_to_remove)
  {
    const Validity validity{ Kept(m_constraints), No_new_edge_at_vertex_3<Tr>(v) };
    const std::size_t start = m_transformation.number_of_shells();
    collect_star(v);
    for(bool is_changed = true; is_changed; )
    {
      is_changed = false;
      const std::vector<Vertex_handle> neighbors = internal::vertices_without(m_star, v);
      for(const Vertex_handle x : neighbors)
      {
        if(! context.go_further())
          return false;
        if(m_transformation.number_of_shells() - start > max_number_of_shells)
          return false;
        Cell_handle c;
        int i, j;
        if(! m_tr.is_edge(v, x, c, i, j))
          continue;
        const bool is_removed = m_transformation.remove_edge(Edge(c, i, j), l_max, validity);
        collect_star(v); // its cells may have been replaced even if the edge is still there
        if(! is_removed)
          continue;
        is_changed = true;
        if(try_to_remove(m_star))
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

  // In one call. See "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_shells = 4000;

  void collect_star(const Vertex_handle v)
  {
    m_star.clear();
    m_tr.incident_cells(v, std::back_inserter(m_star));
  }

  Tr& m_tr;
  const Constraints& m_constraints;
  Shell_transformation_3<Tr, Quality, Validity, Editor> m_transformation;
  std::vector<Cell_handle> m_star;
};

/*
 * The postprocessing of [CZZ+17, Section 4.3] for one Steiner point that is on no constraint: removes it, or moves it
 * to where it is least in the way.
 *
 * The vertex is dropped when its star can be covered without it: by collapsing an edge of it, or by small polyhedron
 * reconnection of the star. Until that works, the edges at the vertex are removed one after the other by recursive
 * shell transformations. In the end, the star and one layer more is tried.
 *
 * `Constraints` are the ledger's as long as there are points on constraints.
 */
template <typename Tr, typename Constraints>
class Suppress_free_point_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;

  Suppress_free_point_3(Mesh& mesh, const Constraints& constraints)
    : m_mesh(mesh), m_remove(mesh.editor, mesh.predicates, constraints),
      m_reduce_star(mesh.editor, mesh.predicates, constraints), m_move_into_kernel(mesh.predicates, mesh.positions)
  { }

  // Where points may be given up for time, no more than the star itself is tried.
  void set_effort(const Recovery_effort effort) { m_effort = effort; }

  // Returns whether v is gone. If it is on the hull, it is not.
  bool remove(const Vertex_handle v, const int l_max)
  {
    m_remove.forget(); // points may have moved since the last call
    if(! internal::collect_star(m_mesh.tr, v, m_star))
      return false;
    const auto try_to_remove = [this, v](const std::vector<Cell_handle>& star)
    {
      return m_remove.find(star, v) && drop(v);
    };
    if(try_to_remove(m_star) || m_reduce_star(v, l_max, m_mesh.context, try_to_remove))
      return true;
    return m_effort == Recovery_effort::more_time && m_mesh.context.go_further()
        && internal::collect_star(m_mesh.tr, v, m_star) && m_remove.find_with_layer(m_star, v) && drop(v);
  }

  // Moves v to the deepest point of the kernel of its star, from where more may be possible, if that can be stored.
  void relocate(const Vertex_handle v)
  {
    if(! internal::collect_star(m_mesh.tr, v, m_star))
      return;
    const auto faces = internal::faces_of_star(m_star, v);
    const auto exact = m_mesh.positions(v);
    const auto before = v->point();
    const bool is_exact = m_mesh.positions.contains(v);
    m_mesh.positions.erase(v);
    if(m_move_into_kernel(v, faces))
      return;
    v->set_point(before);
    if(is_exact)
      m_mesh.positions.set(v, exact);
  }

  std::size_t number_of_transformations() const { return m_reduce_star.number_of_transformations(); }

private:
  bool drop(const Vertex_handle v)
  {
    m_mesh.ledger.erase(v);
    m_remove(v);
    return true;
  }

  Mesh& m_mesh;
  Remove_vertex_3<Tr, Constraints> m_remove;
  Reduce_star_3<Tr, Constraints> m_reduce_star;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  Recovery_effort m_effort = Recovery_effort::more_time;
  std::vector<Cell_handle> m_star;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SUPPRESS_FREE_POINT_3_H
