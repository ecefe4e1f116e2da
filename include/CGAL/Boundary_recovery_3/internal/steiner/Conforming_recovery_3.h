// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_CONFORMING_RECOVERY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_CONFORMING_RECOVERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recover_constraint_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Boundary_recovery_3/internal/operations/split_simplex.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Shell_transformation_3.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The main procedure of [CZZ+17, Section 4], first half: conforming recovery. Where a lost edge meets a mesh edge or
 * facet, and where a mesh edge meets a lost facet, that mesh entity is split by a Steiner point.
 *
 * It ends. An edge: parts of a chain that are in the mesh are kept by flips, and are never split, since no other
 * constraint crosses them. A split at a crossing leaves both parts with the other crossings between them, for splits at
 * a point of a line add nothing that crosses the line; flips for one part may add crossings to another, but the number
 * of splits that are followed by flips is bounded. A facet whose edges are chains: each split takes away one mesh
 * edge that pierces it and adds none, since all new edges end in its plane; flips add none either, by BRC2. Once no
 * edge pierces it, and no foreign vertex is in it, mesh facets tile it.
 *
 * Exact positions would grow from point to point if points on lines through points were crossed by lines again. So
 * each point is moved on its constraint, right after it was inserted, to where few bits describe it. As it stays on
 * the constraint, the new edges pierce nothing of that wherever it is.
 */
template <typename Tr>
class Conforming_recovery_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;
  typedef typename Mesh::Vertex_pair           Vertex_pair;
  typedef typename Mesh::Vertex_triple         Vertex_triple;

  explicit Conforming_recovery_3(Mesh& mesh)
    : m_mesh(mesh), m_walk(mesh.tr, mesh.predicates), m_edge_recovery(mesh.editor, mesh.predicates, mesh.ledger),
      m_edge_transformation(mesh.editor.triangulation(), Quality(mesh.tr), mesh.editor, mesh.predicates),
      m_facet_transformation(mesh.editor.triangulation(), Quality(mesh.tr), mesh.editor, mesh.predicates)
  { }

  // Makes the edge e a chain of mesh edges: what flips cannot recover is split at a crossing, and both parts are tried
  // again. Returns false if a foreign vertex is on it, or if the context wants to stop.
  bool recover_edge(const std::size_t e, const int l_max)
  {
    const Vertex_pair& edge = m_mesh.constraints.edges()[e];
    std::vector<Vertex_pair > parts(1, edge);
    std::size_t number_of_splits = 0;
    while(! parts.empty())
    {
      const Vertex_pair part = parts.back();
      if(! m_mesh.context.go_further())
        return false;
      parts.pop_back();
      const Edge_validity validity(Kept(m_mesh.ledger), BRC1<Tr>(m_mesh.predicates, part[0], part[1]));
      if(number_of_splits < max_number_of_splits_with_flips
         && m_edge_recovery(m_edge_transformation, part, validity, l_max, m_mesh.context))
        continue;
      const typename Walk::Outcome outcome = m_walk(part[0], part[1]);
      if(outcome == Walk::IS_EDGE)
        continue;
      if(outcome == Walk::BLOCKED)
        return false;
      ++number_of_splits;
      const Crossing crossing = m_walk.crossings()[m_walk.crossings().size() / 2];
      const FT t = parameter_on_edge(edge, crossing);
      const Vertex_handle v = create_vertex(point_on_edge(edge, t));
      if(crossing.dimension == 1)
        internal::split_edge(m_mesh.editor, crossing.cell, crossing.vertices[0], crossing.vertices[1], v);
      else
        internal::split_facet(m_mesh.editor, crossing.cell, crossing.vertices, v);
      simplify_position(v, [&](const int bits) { return point_on_edge(edge, rounded(t, bits)); });
      m_mesh.ledger.insert_on_edge(e, part[0], v);
      CGAL_expensive_assertion(internal::is_mesh_valid(m_mesh.tr, m_mesh.predicates));
      parts.push_back({{ v, part[1] }});
      parts.push_back({{ part[0], v }});
    }
    return true;
  }

  // Makes the facet f, whose edges are chains of mesh edges, a union of mesh facets.
  // Returns false if the context wants to stop.
  bool recover_facet(const std::size_t f, const int l_max)
  {
    const Vertex_triple& facet = m_mesh.constraints.facets()[f];
    const Facet_validity validity(Kept(m_mesh.ledger), BRC2<Tr>(m_mesh.predicates, facet[0], facet[1], facet[2]));
    for(find_piercing_edges(f); ! m_piercing_edges.empty(); find_piercing_edges(f))
      for(const Vertex_pair& e : m_piercing_edges)
      {
        if(! m_mesh.context.go_further())
          return false;
        Cell_handle c;
        int i, j;
        if(! m_mesh.tr.is_edge(e[0], e[1], c, i, j) || m_facet_transformation.remove_edge(Edge(c, i, j), l_max,
                                                                                          validity))
          continue;
        if(! m_mesh.tr.is_edge(e[0], e[1], c, i, j))
          continue;
        const std::array<FT, 2> weights = weights_in_facet(facet, e);
        const Vertex_handle v = create_vertex(point_in_facet(facet, weights));
        internal::split_edge(m_mesh.editor, c, e[0], e[1], v);
        simplify_position(v, [&](const int bits)
        {
          return point_in_facet(facet, {{ rounded(weights[0], bits), rounded(weights[1], bits) }});
        });
        m_mesh.ledger.insert_in_facet(f, v);
        CGAL_expensive_assertion(internal::is_mesh_valid(m_mesh.tr, m_mesh.predicates));
      }
    return true;
  }

  std::size_t number_of_transformations() const
  {
    return m_edge_recovery.number_of_stars() + m_edge_transformation.number_of_transformations()
         + m_facet_transformation.number_of_transformations();
  }

private:
  typedef typename Tr::Edge                             Edge;
  typedef typename Mesh::Ledger                         Ledger;
  typedef typename Mesh::Editor                         Editor;
  typedef Kept_constraints_3<Ledger>                    Kept;
  typedef Worst_element_quality_3<Tr>                   Quality;
  typedef Shell_validity_conjunction_3<Kept, BRC1<Tr> > Edge_validity;
  typedef Shell_validity_conjunction_3<Kept, BRC2<Tr> > Facet_validity;
  typedef Segment_walk_3<Tr>                            Walk;
  typedef typename Walk::Crossing                       Crossing;
  typedef typename Mesh::Positions                      Positions;
  typedef typename Positions::Exact_point_3             Exact_point;
  typedef typename Positions::Exact_FT                  FT;

  Exact_point position(const Vertex_handle v) const { return m_mesh.positions(v); }

  Exact_point point_on_edge(const Vertex_pair& edge, const FT& t) const
  {
    const Exact_point u = position(edge[0]);
    return u + t * (position(edge[1]) - u);
  }

  Exact_point point_in_facet(const Vertex_triple& facet, const std::array<FT, 2>& weights) const
  {
    const Exact_point u = position(facet[0]);
    return u + weights[0] * (position(facet[1]) - u) + weights[1] * (position(facet[2]) - u);
  }

  // --- where constraints and mesh entities meet ---------------------------------------------------------------------

  // The t for which u + t (v - u) is in the plane through p, q, r.
  static FT parameter_in_plane(const Exact_point& u, const Exact_point& v,
                               const Exact_point& p, const Exact_point& q, const Exact_point& r)
  {
    const FT at_u = CGAL::volume(p, q, r, u), at_v = CGAL::volume(p, q, r, v);
    return at_u / (at_u - at_v);
  }

  FT parameter_on_edge(const Vertex_pair& edge, const Crossing& crossing) const
  {
    const Vertex_handle p = crossing.vertices[0], q = crossing.vertices[1];
    Vertex_handle r = crossing.vertices[2];
    if(crossing.dimension == 1) // any plane through pq, but not the one that contains the edge
    {
      const Shell_3<Tr> shell(m_mesh.tr, crossing.cell, crossing.cell->index(p), crossing.cell->index(q));
      for(int i = 0; i < shell.degree(); ++i)
        if(i != shell.infinite_index() && m_mesh.predicates.orientation(p, q, edge[0], shell.vertex(i)) != COPLANAR)
          r = shell.vertex(i);
    }
    return parameter_in_plane(position(edge[0]), position(edge[1]), position(p), position(q), position(r));
  }

  // The (s, t) for which u + s (v - u) + t (w - u) is on the line of the edge.
  std::array<FT, 2> weights_in_facet(const Vertex_triple& facet,
                                     const Vertex_pair& edge) const
  {
    const Exact_point u = position(facet[0]), v = position(facet[1]), w = position(facet[2]);
    const Exact_point a = position(edge[0]), b = position(edge[1]);
    const FT t = parameter_in_plane(a, b, u, v, w);
    const Exact_point p = a + t * (b - a);
    // seen from a point off the plane, volumes are areas
    const FT all = CGAL::volume(u, v, w, a);
    return {{ CGAL::volume(u, p, w, a) / all, CGAL::volume(u, v, p, a) / all }};
  }

  // Mesh edges that pierce the facet: those of the cells around vertices on it. If there is none there, there is none
  // at all, for then mesh facets tile it around these vertices, and therefore everywhere.
  void find_piercing_edges(const std::size_t f)
  {
    const Vertex_triple& facet = m_mesh.constraints.facets()[f];
    m_piercing_edges.clear();
    for(const Vertex_handle v : m_mesh.ledger.vertices_on_facet(f))
    {
      m_star.clear();
      m_mesh.tr.incident_cells(v, std::back_inserter(m_star));
      for(const Cell_handle c : m_star)
        if(! m_mesh.tr.is_infinite(c))
          add_piercing_edges(c, facet);
    }
  }

  void add_piercing_edges(const Cell_handle c, const Vertex_triple& facet)
  {
    std::array<Orientation, 4> side;
    for(int i = 0; i < 4; ++i)
      side[i] = m_mesh.predicates.orientation(facet[0], facet[1], facet[2], c->vertex(i));
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const Vertex_handle p = c->vertex(i), q = c->vertex(j);
        if(side[i] * side[j] != NEGATIVE || is_listed(p, q))
          continue;
        if(m_mesh.predicates.segment_pierces_triangle(p, q, facet[0], facet[1], facet[2]))
          m_piercing_edges.push_back({{ p, q }});
      }
  }

  bool is_listed(const Vertex_handle p, const Vertex_handle q) const
  {
    return std::any_of(m_piercing_edges.begin(), m_piercing_edges.end(), [&](const Vertex_pair& e)
    {
      return (e[0] == p && e[1] == q) || (e[0] == q && e[1] == p);
    });
  }

  // --- splits -------------------------------------------------------------------------------------------------------

  Vertex_handle create_vertex(const Exact_point& p)
  {
    const Vertex_handle v = m_mesh.editor.create_vertex();
    m_mesh.positions.set(v, p);
    return v;
  }

  // Flips for one part of an edge may do harm to the next part. So that this ends, a long chain is finished without.
  static constexpr std::size_t max_number_of_splits_with_flips = 100;

  // --- simple positions ---------------------------------------------------------------------------------------------

  // Numbers of bits behind the binary point that are tried for the weights of a position, the fewest first.
  static constexpr std::array<int, 10> numbers_of_bits = {{ 3, 6, 10, 16, 24, 36, 52, 100, 200, 400 }};

  static FT rounded(const FT& t, const int bits)
  {
    return nearest_multiple(t, FT(std::ldexp(1., -bits)));
  }

  // `candidate` gives the position with weights of so many bits.
  template <typename Candidate>
  void simplify_position(const Vertex_handle s, const Candidate& candidate)
  {
    const Exact_point exact = position(s);
    for(const int bits : numbers_of_bits)
      if(move(s, candidate(bits)))
        return;
    m_mesh.positions.set(s, exact);
  }

  // Gives s a position, and returns whether all the cells around it are positively oriented so.
  // They fill the same polyhedron whatever the position is, so it is inside then.
  bool move(const Vertex_handle s, const Exact_point& p)
  {
    m_mesh.positions.set(s, p);
    m_star.clear();
    m_mesh.tr.incident_cells(s, std::back_inserter(m_star));
    return std::all_of(m_star.begin(), m_star.end(), [this](const Cell_handle c)
    {
      return m_mesh.tr.is_infinite(c) || internal::is_positive(m_mesh.predicates, c);
    });
  }

  Mesh& m_mesh;
  Walk m_walk;
  Recover_constraint_3<Tr, 2, Ledger> m_edge_recovery;
  Shell_transformation_3<Tr, Quality, Edge_validity, Editor> m_edge_transformation;
  Shell_transformation_3<Tr, Quality, Facet_validity, Editor> m_facet_transformation;
  std::vector<Cell_handle> m_star;
  std::vector<Vertex_pair> m_piercing_edges;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_CONFORMING_RECOVERY_3_H
