// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_ISOLATED_EDGE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_ISOLATED_EDGE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Remove_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Conforming_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Split_off_steiner_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_free_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_steiner_points_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Removes a Steiner point from the chain of an edge of no constrained facet, and makes the two parts of the edge that
 * meet there one mesh edge: no point comes in its place, as it does if it comes off the edge.
 *
 * The star of the point is covered without it: by collapsing it onto one of its neighbors on the edge, or by small
 * polyhedron reconnection. Until that works, the other edges at the point are removed by flips.
 */
template <typename Tr>
class Remove_chain_point_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;
  typedef typename Mesh::Vertex_pair           Vertex_pair;

  explicit Remove_chain_point_3(Mesh& mesh)
    : m_mesh(mesh), m_reduce_star(mesh.editor, mesh.predicates, mesh.ledger), m_reconnection(mesh.predicates)
  { }

  // Returns whether s is gone. If it is on the hull, it is not.
  bool operator()(const Vertex_handle s, const int l_max)
  {
    m_reconnection.forget(); // points may have moved since the last call
    m_neighbors = m_mesh.ledger.neighbors_on_edge(s);
    if(! internal::collect_star(m_mesh.tr, s, m_star))
      return false;
    const auto try_to_remove = [this, s](const std::vector<Cell_handle>& star)
    {
      return collapse(star, s) || reconnect(star, s);
    };
    return try_to_remove(m_star) || m_reduce_star(s, l_max, m_mesh.context, try_to_remove);
  }

  std::size_t number_of_transformations() const { return m_reduce_star.number_of_transformations(); }

private:
  typedef typename Mesh::Ledger                Ledger;
  typedef typename Mesh::Vertex_triple         Vertex_triple;
  typedef Small_polyhedron_reconnection_3<Tr>  Reconnection;

  bool collapse(const std::vector<Cell_handle>& star, const Vertex_handle s)
  {
    const auto x = std::find_if(m_neighbors.begin(), m_neighbors.end(), [&](const Vertex_handle w)
    {
      return internal::is_star_seen(m_mesh.predicates, star, s, w);
    });
    if(x == m_neighbors.end())
      return false;
    m_mesh.ledger.erase(s);
    internal::collapse_edge(m_mesh.editor, star, s, *x);
    return true;
  }

  bool reconnect(const std::vector<Cell_handle>& star, const Vertex_handle s)
  {
    std::vector<Vertex_pair> edges;
    std::vector<Vertex_triple> facets;
    internal::collect_constraints(m_mesh.ledger, star, edges, facets);
    edges.erase(std::remove_if(edges.begin(), edges.end(), [s](const Vertex_pair& e)
    {
      return e[0] == s || e[1] == s;
    }), edges.end());
    edges.push_back(m_neighbors);
    if(m_reconnection(star, edges, facets, s) != Reconnection::FOUND)
      return false;
    m_mesh.ledger.erase(s);
    m_mesh.editor.replace(star, m_reconnection.tetrahedra(), std::array<Vertex_handle, 1>{{ s }});
    return true;
  }

  Mesh& m_mesh;
  Reduce_star_3<Tr, Ledger> m_reduce_star;
  Reconnection m_reconnection;
  std::vector<Cell_handle> m_star;
  Vertex_pair m_neighbors; // of the point, on its edge
};

/*
 * Recovers an edge of no constrained facet to the end: it becomes a chain, which loses as many of its points as can go
 * from it; the others come off it, some of them go, and the rest get positions that the triangulation can store.
 *
 * Where there are hundreds of such edges, this is done with one after the other. If all become chains first, the stars
 * of their points are cut up again and again before any point gets a position; in the end, there is no number in some
 * stars, and this is known only when all the work is done.
 */
template <typename Tr>
class Recover_isolated_edge_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef Suppress_steiner_points_3<Tr>   Suppression;

  explicit Recover_isolated_edge_3(Mesh& mesh)
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
  Conforming_recovery_3<Tr> m_conform;
  Remove_chain_point_3<Tr> m_shorten;
  Split_off_steiner_point_3<Tr> m_split;
  Suppress_free_point_3<Tr, typename Mesh::Constraints> m_remove;
  Suppression m_suppress;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_ISOLATED_EDGE_3_H
