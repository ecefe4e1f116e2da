// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REMOVE_CHAIN_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REMOVE_CHAIN_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/constraint_queries.h>
#include <CGAL/Boundary_recovery_3/internal/operations/collapse_edge.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Reduce_ball_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Removes a Steiner point from the chain of an edge of no constrained facet, and makes the two parts of the edge that
 * meet there one mesh edge: no point comes in its place, as it does if it comes off the edge.
 *
 * The ball of the point is covered without it: by collapsing it onto one of its neighbors on the edge, or by small
 * polyhedron reconnection. Until that works, the other edges at the point are removed by flips.
 */
template <typename Tr, typename Visitor>
class Remove_chain_point_3
{
public:
  typedef Steiner_mesh_3<Tr, Visitor>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;
  typedef typename Mesh::Vertex_pair           Vertex_pair;

  explicit Remove_chain_point_3(Mesh& mesh)
    : m_mesh(mesh), m_reduce_ball(mesh.editor, mesh.predicates, mesh.ledger), m_reconnection(mesh.predicates)
  { }

  // Returns whether s is gone. If it is on the hull, it is not.
  bool operator()(const Vertex_handle s, const int l_max)
  {
    m_reconnection.forget(); // points may have moved since the last call
    m_neighbors = m_mesh.ledger.neighbors_on_edge(s);
    if(! internal::collect_ball(m_mesh.tr, s, m_ball))
      return false;
    const auto try_to_remove = [this, s](const std::vector<Cell_handle>& ball)
    {
      return collapse(ball, s) || reconnect(ball, s);
    };
    return try_to_remove(m_ball) || m_reduce_ball(s, l_max, m_mesh.context, try_to_remove);
  }

  std::size_t number_of_transformations() const { return m_reduce_ball.number_of_transformations(); }

private:
  typedef typename Mesh::Ledger                Ledger;
  typedef typename Mesh::Vertex_triple         Vertex_triple;
  typedef Small_polyhedron_reconnection_3<Tr>  Reconnection;

  bool collapse(const std::vector<Cell_handle>& ball, const Vertex_handle s)
  {
    const auto x = std::find_if(m_neighbors.begin(), m_neighbors.end(), [&](const Vertex_handle w)
    {
      return internal::is_ball_seen(m_mesh.predicates, ball, s, w);
    });
    if(x == m_neighbors.end())
      return false;
    m_mesh.ledger.erase(s);
    internal::collapse_edge(m_mesh.editor, ball, s, *x);
    return true;
  }

  bool reconnect(const std::vector<Cell_handle>& ball, const Vertex_handle s)
  {
    std::vector<Vertex_pair> edges;
    std::vector<Vertex_triple> facets;
    internal::collect_constraints(m_mesh.ledger, ball, edges, facets);
    edges.erase(std::remove_if(edges.begin(), edges.end(), [s](const Vertex_pair& e)
    {
      return e[0] == s || e[1] == s;
    }), edges.end());
    edges.push_back(m_neighbors);
    if(m_reconnection(ball, edges, facets, s) != Reconnection::FOUND)
      return false;
    m_mesh.ledger.erase(s);
    m_mesh.editor.replace(ball, m_reconnection.tetrahedra(), std::array<Vertex_handle, 1>{{ s }});
    return true;
  }

  Mesh& m_mesh;
  Reduce_ball_3<Tr, Visitor, Ledger> m_reduce_ball;
  Reconnection m_reconnection;
  std::vector<Cell_handle> m_ball;
  Vertex_pair m_neighbors; // of the point, on its edge
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_REMOVE_CHAIN_POINT_3_H
