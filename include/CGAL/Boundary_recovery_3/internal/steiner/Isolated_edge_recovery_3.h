// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ISOLATED_EDGE_RECOVERY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ISOLATED_EDGE_RECOVERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/steiner/Conforming_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Remove_chain_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_splitting_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_suppression_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_free_point_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Recovers an edge of no constrained facet to the end: it becomes a chain, which loses as many of its points as can go
 * from it; the others come off it, some of them go, and the rest get positions that the triangulation can store.
 *
 * Where there are hundreds of such edges, this is done with one after the other. If all become chains first, the balls
 * of their points are cut up again and again before any point gets a position; in the end, there is no number in some
 * balls, and this is known only when all the work is done.
 */
template <typename Tr, typename Visitor>
class Isolated_edge_recovery_3
{
public:
  typedef Steiner_mesh_3<Tr, Visitor>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef Steiner_suppression_3<Tr, Visitor>   Suppression;

  explicit Isolated_edge_recovery_3(Mesh& mesh)
    : m_mesh(mesh), m_conform(mesh), m_shorten(mesh), m_split(mesh), m_remove(mesh, mesh.constraints), m_suppress(mesh)
  { }

  // Returns whether e is a mesh edge then, and all free points of the ledger have such positions; if not, the mesh is
  // something in between. Flips for parts of e have the recursion level l_max. Points for which there is no number make
  // room for each other in so many rounds. No point is on a constraint.
  bool operator()(const std::size_t e, const int l_max, const int max_recursion_level, const int number_of_rounds)
  {
    CGAL_precondition(m_mesh.ledger.points_on_constraints().empty());
    if(! m_conform.recover_edge(e, l_max))
      return false;
    shorten_chain(max_recursion_level);
    if(! split_points(e))
      return false;
    remove_points(max_recursion_level, 0);
    return m_suppress.round_points(max_recursion_level, number_of_rounds);
  }

  // Removes free points of edges that are recovered: some of them, or as many as go without much effort.
  void thin_out(const int max_recursion_level) { remove_points(max_recursion_level, 100); }
  void make_room(const int max_recursion_level) { remove_points(max_recursion_level, 1); }

  std::size_t number_of_transformations() const
  {
    return m_conform.number_of_transformations() + m_shorten.number_of_transformations()
         + m_split.number_of_transformations() + m_remove.number_of_transformations()
         + m_suppress.number_of_transformations();
  }

private:
  // Points that go from the chain need no others in their place, and leave more room for those that do. In rounds, as
  // long as one goes.
  void shorten_chain(const int max_recursion_level)
  {
    const int l_max = (std::min)(recursion_level, max_recursion_level);
    const auto& points = m_mesh.ledger.points_on_constraints();
    for(std::size_t before = 0; before != points.size(); )
    {
      before = points.size();
      for(const Vertex_handle v : std::vector<Vertex_handle>(points))
        if(m_mesh.context.go_further())
          m_shorten(v, l_max);
    }
  }

  // Returns whether no point is on the edge any more. The room around a new part of the edge is cut out of that around
  // the two parts before. If one end of a part went from point to point along the chain, it would be cut as often as
  // there are points, until no number fits into it; every second point at a time, it is cut as often as there are
  // rounds.
  bool split_points(const std::size_t e)
  {
    const auto& points = m_mesh.ledger.points_on_constraints();
    for(std::size_t before = 0; before != points.size(); )
    {
      before = points.size();
      for(const std::size_t first : { 1, 2 }) // those in between only if none of the others comes off
        if(before == points.size())
          split_every_second_point(e, first);
    }
    return points.empty();
  }

  void split_every_second_point(const std::size_t e, const std::size_t first)
  {
    const std::vector<Vertex_handle> chain = m_mesh.ledger.vertices_on_edge(e);
    for(std::size_t i = first; i + 1 < chain.size() && m_mesh.context.go_further(); i += 2)
      m_split(chain[i]);
  }

  // In rounds, as long as more than so many in a hundred go.
  void remove_points(const int max_recursion_level, const std::size_t percentage)
  {
    const int l_max = (std::min)(recursion_level, max_recursion_level);
    const auto& points = m_mesh.ledger.free_points();
    while(m_mesh.context.go_further())
    {
      const std::size_t before = points.size();
      for(const Vertex_handle v : std::vector<Vertex_handle>(points))
        if(m_mesh.ledger.is_free(v) && m_mesh.context.go_further())
          m_remove.remove(v, l_max);
      for(const Vertex_handle v : points)
        m_remove.relocate(v);
      if(100 * (before - points.size()) <= percentage * before)
        return;
    }
  }

  // See "Tuning constants" in the manual.
  static constexpr int recursion_level = 4;

  Mesh& m_mesh;
  Conforming_recovery_3<Tr, Visitor> m_conform;
  Remove_chain_point_3<Tr, Visitor> m_shorten;
  Steiner_splitting_3<Tr, Visitor> m_split;
  Suppress_free_point_3<Tr, Visitor, typename Mesh::Constraints> m_remove;
  Suppression m_suppress;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ISOLATED_EDGE_RECOVERY_3_H
