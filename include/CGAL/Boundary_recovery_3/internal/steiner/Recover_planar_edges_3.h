// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_PLANAR_EDGES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_PLANAR_EDGES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recover_constraint_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Remove_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Shell_transformation_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Recovery of edges that are tangled in a plane: many of them, which cross many mesh edges there, as those of a fan of
 * cocircular points do.
 *
 * The cells at the plane have their other vertices where chance put them, and a mesh edge can only be flipped away if
 * few cells meet at it. So a point is put close to the plane on each side where there are cells, an apex. Its star has
 * the cells there whose circumspheres contain it, and where vertices are nearly cocircular, these are nearly all of
 * them. Two cells are at a mesh edge on that side then, and flips are those of a triangulation of the plane, which do
 * not get stuck. The apexes are free points of the ledger; those that can go at once do when the edges are back.
 */
template <typename Tr>
class Recover_planar_edges_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;
  typedef std::vector<std::size_t>             Indices;
  typedef std::vector<std::pair<std::size_t, std::size_t> > Edges; // how much each crosses, and its index; in order

  explicit Recover_planar_edges_3(Mesh& mesh)
    : m_mesh(mesh), m_walk(mesh.tr, mesh.predicates), m_recover(mesh.editor, mesh.predicates, mesh.constraints),
      m_transformation(mesh.editor.triangulation(), No_shell_quality_3(), mesh.editor, mesh.predicates),
      m_remove(mesh.editor, mesh.predicates, mesh.constraints)
  { }

  // The tangled edges among those that are lost, by groups: those that are connected by mesh edges that they cross, in
  // one plane as a rule.
  std::vector<Edges> find(const Indices& lost)
  {
    std::vector<Edges> result;
    if(lost.size() < min_number_of_edges)
      return result;
    std::vector<Edges> groups = find_groups(lost);
    std::copy_if(std::make_move_iterator(groups.begin()), std::make_move_iterator(groups.end()),
                 std::back_inserter(result), &is_tangled);
    return result;
  }

  // Recovers such edges. Returns whether that is worth the apexes that are left: each has to bring back as many edges
  // as are tangled at least. The ledger has no other free points.
  bool operator()(Edges edges)
  {
    const std::size_t number_of_edges = edges.size();
    insert_apexes(edges);
    for(std::size_t before = 0; before != edges.size() && m_mesh.context.go_further(); )
    {
      before = edges.size();
      recover(edges);
    }
    remove_apexes();
    return number_of_edges - edges.size() >= min_number_of_edges * m_mesh.ledger.free_points().size();
  }

  std::size_t number_of_transformations() const
  {
    return m_recover.number_of_stars() + m_transformation.number_of_transformations();
  }

private:
  typedef Segment_walk_3<Tr>                            Walk;
  typedef typename Walk::Crossing                       Crossing;
  typedef typename Mesh::Constraints                    Constraints;
  typedef Kept_constraints_3<Constraints>               Kept;
  typedef Shell_validity_conjunction_3<Kept, BRC1<Tr> > Validity;
  typedef Cavity_3<Tr>                                  Cavity;

  // See "Tuning constants" in the manual.
  static constexpr std::size_t min_number_of_edges = 100;
  static constexpr std::size_t min_number_of_crossings = 4; // of one edge, on an average

  // --- what is tangled ----------------------------------------------------------------------------------------------

  // The mesh edges that a lost edge crosses, each in a plane with it.
  std::vector<Crossing> crossed_edges(const std::size_t e)
  {
    m_walk(m_mesh.constraints.edges()[e]);
    std::vector<Crossing> result;
    std::copy_if(m_walk.crossings().begin(), m_walk.crossings().end(), std::back_inserter(result),
                 [](const Crossing& c) { return c.dimension == 1; });
    return result;
  }

  // What crosses what is not kept: all edges of a fan may cross all mesh edges. Empty if the context says stop.
  std::vector<Edges> find_groups(const Indices& lost)
  {
    typedef boost::vector_property_map<std::size_t> Map; // for a pointer, some headers of Boost.Graph hide get()
    boost::disjoint_sets<Map, Map> sets((Map(lost.size())), Map(lost.size()));
    for(std::size_t k = 0; k < lost.size(); ++k)
      sets.make_set(k);
    Simplex_index_3<Vertex_handle, 2> crossed;
    Indices first_crossing; // by number of a crossed mesh edge, the position of the first lost edge that does
    Edges edges;
    for(std::size_t i = 0; i < lost.size() && m_mesh.context.go_further_after_short_step(); ++i)
    {
      const std::vector<Crossing> crossings = crossed_edges(lost[i]);
      edges.emplace_back(crossings.size(), lost[i]);
      for(const Crossing& c : crossings)
      {
        const auto inserted = crossed.insert({{ c.vertices[0], c.vertices[1] }});
        if(inserted.second)
          first_crossing.push_back(i);
        else
          sets.union_set(i, first_crossing[inserted.first]);
      }
    }
    return edges.size() < lost.size() ? std::vector<Edges>() : groups_of(edges, sets);
  }

  // Groups may be empty; in a group, those that cross least come first.
  template <typename Disjoint_sets>
  static std::vector<Edges> groups_of(const Edges& edges, Disjoint_sets& sets)
  {
    std::vector<Edges> groups(edges.size());
    for(std::size_t i = 0; i < edges.size(); ++i)
      groups[sets.find_set(i)].push_back(edges[i]);
    for(Edges& group : groups)
      std::sort(group.begin(), group.end());
    return groups;
  }

  static bool is_tangled(const Edges& edges)
  {
    std::size_t n = 0;
    for(const auto& crossings_and_index : edges)
      n += crossings_and_index.first;
    return edges.size() >= min_number_of_edges && n > min_number_of_crossings * edges.size();
  }

  // --- apexes -------------------------------------------------------------------------------------------------------

  // Beside edges that cross much, where there are none as yet. Those that cross most come first: they are in the
  // middle. No more are tried than would be worth it if all edges came back, on both sides, for each may take a search
  // of the whole plane.
  void insert_apexes(const Edges& edges)
  {
    std::size_t number_left = 2 * (edges.size() / min_number_of_edges);
    for(auto it = edges.rbegin(); it != edges.rend() && it->first > min_number_of_crossings; ++it)
      for(const Orientation side : { POSITIVE, NEGATIVE })
      {
        if(number_left == 0)
          return;
        const std::vector<Crossing> crossed = crossed_edges(it->second);
        if(! m_mesh.context.go_further())
          return;
        if(crossed.empty())
          break;
        if(try_apex(it->second, crossed[crossed.size() / 2], side))
          --number_left;
      }
  }

  // On one side of the plane of a lost edge and a mesh edge that it crosses. Returns false if no place is left there.
  bool try_apex(const std::size_t e, const Crossing& crossed, const Orientation side)
  {
    const Cell_handle seed = cell_beside(m_mesh.constraints.edges()[e][0], crossed, side);
    if(seed == Cell_handle())
      return false;
    const Vertex_handle apex = m_mesh.editor.create_vertex(center(seed));
    Cavity cavity(m_mesh.tr, m_mesh.constraints);
    cavity.add(seed);
    internal::grow_where(cavity, [&](const Cell_handle c) { return is_in_conflict(c, apex); });
    if(internal::shrink_until_seen(cavity, apex, m_mesh.predicates, 1)
       && internal::find_obstacle_to_star(cavity, m_mesh.predicates, apex) == Star_obstacle::NONE)
    {
      internal::star_cavity(m_mesh.editor, cavity, apex);
      m_mesh.ledger.insert_free(apex, { 1, e });
    }
    else
      m_mesh.editor.delete_vertex(apex);
    return true;
  }

  // A finite cell at a mesh edge, on that side of the plane through it and u, with a facet in the plane if there is
  // such a one; none if there is an apex.
  Cell_handle cell_beside(const Vertex_handle u, const Crossing& crossed, const Orientation side) const
  {
    const Vertex_handle a = crossed.vertices[0], b = crossed.vertices[1];
    const Shell_3<Tr> shell(m_mesh.tr, crossed.cell, crossed.cell->index(a), crossed.cell->index(b));
    Cell_handle result;
    for(int i = 0; i < shell.degree(); ++i)
    {
      const Vertex_handle p = shell.vertex(i), q = shell.vertex(shell.next(i));
      if(m_mesh.tr.is_infinite(p) || m_mesh.tr.is_infinite(q))
        continue;
      const Orientation of_p = m_mesh.predicates.orientation(u, a, b, p);
      const Orientation of_q = m_mesh.predicates.orientation(u, a, b, q);
      if(of_p == -side || of_q == -side)
        continue;
      if(m_mesh.ledger.is_free(p) || m_mesh.ledger.is_free(q))
        return Cell_handle();
      if(result == Cell_handle() || of_p == COPLANAR || of_q == COPLANAR)
        result = shell.cell(i);
    }
    return result;
  }

  // Inside the circumsphere, at a quarter of the height; as near as numbers are.
  typename Mesh::Positions::Point_3 center(const Cell_handle c) const
  {
    std::array<double, 3> x = {{ 0, 0, 0 }};
    for(int i = 0; i < 4; ++i)
      for(int k = 0; k < 3; ++k)
        x[k] += m_mesh.predicates.approximate_point(c->vertex(i))[k] / 4; // a sum may be out of range
    return typename Mesh::Positions::Point_3(x[0], x[1], x[2]);
  }

  // In floating point numbers: a wrong answer makes another cavity, not an invalid one.
  bool is_in_conflict(const Cell_handle c, const Vertex_handle v) const
  {
    const auto point = [&](const Vertex_handle w) { return m_mesh.predicates.approximate_point(w); };
    const typename Simple_cartesian<double>::Side_of_oriented_sphere_3 side_of_oriented_sphere;
    return ! m_mesh.tr.is_infinite(c)
        && side_of_oriented_sphere(point(c->vertex(0)), point(c->vertex(1)), point(c->vertex(2)), point(c->vertex(3)),
                                   point(v)) == ON_POSITIVE_SIDE;
  }

  // Those that are in the way of nothing; in a large star, more takes long, and hardly ever helps.
  void remove_apexes()
  {
    std::vector<Cell_handle> star;
    for(const Vertex_handle v : std::vector<Vertex_handle>(m_mesh.ledger.free_points()))
    {
      m_remove.forget();
      if(! internal::collect_star(m_mesh.tr, v, star) || ! m_remove.find(star, v))
        continue;
      m_mesh.ledger.erase(v);
      m_remove(v);
    }
  }

  // --- flips --------------------------------------------------------------------------------------------------------

  // Takes out those that are back.
  void recover(Edges& edges)
  {
    std::size_t kept = 0;
    const std::size_t total = edges.size();
    for(std::size_t i = 0; i < total; ++i)
    {
      if(! recover_edge(edges[i].second))
        edges[kept++] = edges[i];
      m_mesh.context.visitor().on_progress(Phase::planar_edge_recovery, i + 1, total);
    }
    edges.resize(kept);
  }

  bool recover_edge(const std::size_t e)
  {
    const auto& edge = m_mesh.constraints.edges()[e];
    const Validity validity(Kept(m_mesh.constraints), BRC1<Tr>(m_mesh.predicates, edge[0], edge[1]));
    return m_recover(m_transformation, edge, validity, 0, m_mesh.context);
  }

  Mesh& m_mesh;
  Walk m_walk;
  Recover_constraint_3<Tr, 2> m_recover;
  Shell_transformation_3<Tr, No_shell_quality_3, Validity, typename Mesh::Editor> m_transformation;
  Remove_vertex_3<Tr, Constraints> m_remove;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_RECOVER_PLANAR_EDGES_3_H
