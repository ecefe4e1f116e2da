// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_CAVITY_RECOVERY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_CAVITY_RECOVERY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Facet_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Cell_replacement.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Recovery of one lost constraint by small polyhedron reconnection of the cells that it crosses, then of these and
 * some layers more, as far as they can be searched. All the constraints inside that are in the mesh are kept.
 *
 * Where a cavity can be filled, a larger one can be, too, but its search takes longer and may give up. The sizes in
 * between are of no use.
 */
template <typename Tr, typename Visitor>
class Cavity_recovery_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Constraints_3<Tr>                    Constraints;
  typedef Small_polyhedron_reconnection_3<Tr>  Reconnection;
  typedef std::array<Vertex_handle, 2>         Edge;
  typedef std::array<Vertex_handle, 3>         Facet;

  static constexpr int number_of_layers = 3;

  Cavity_recovery_3(Tr& tr, const Predicates& predicates, const Constraints& constraints, Visitor& visitor)
    : m_tr(tr), m_constraints(constraints), m_visitor(visitor),
      m_segment_walk(tr, predicates), m_facet_walk(tr, predicates), m_reconnection(predicates)
  { }

  // Returns whether uv is a mesh edge in the end.
  bool operator()(const Edge& e)
  {
    typedef Segment_walk_3<Tr> Walk;
    const typename Walk::Outcome outcome = m_segment_walk(e[0], e[1]);
    if(outcome != Walk::CROSSED)
      return outcome == Walk::IS_EDGE;
    clear();
    for(const typename Walk::Crossing& crossing : m_segment_walk.crossings())
      if(crossing.dimension == 1)
        add_shell(crossing.cell, crossing.vertices[0], crossing.vertices[1]);
      else
        add_both_cells(crossing.cell, crossing.vertices);
    return reconnect(std::vector<Edge>(1, e), std::vector<Facet>());
  }

  // Returns whether the facet, whose edges are mesh edges, is a mesh facet in the end.
  bool operator()(const Facet& f)
  {
    typedef Facet_walk_3<Tr> Walk;
    int i, j;
    Cell_handle c;
    if(! m_tr.is_edge(f[0], f[1], c, i, j))
      return false;
    const typename Walk::Outcome outcome = m_facet_walk(f[0], f[1], f[2], c);
    if(outcome != Walk::CROSSED)
      return outcome == Walk::IS_FACET;
    clear();
    for(const typename Walk::Crossing& crossing : m_facet_walk.crossings())
      add_shell(crossing.cell, crossing.vertices[0], crossing.vertices[1]);
    return reconnect(std::vector<Edge>(), std::vector<Facet>(1, f));
  }

  std::size_t number_of_replacements() const { return m_number_of_replacements; }

private:
  void clear()
  {
    m_cells.clear();
    m_vertices.clear();
  }

  void add(const Cell_handle c)
  {
    if(internal::contains(m_cells, c))
      return;
    m_cells.push_back(c);
    for(int i = 0; i < 4; ++i)
      if(! internal::contains(m_vertices, c->vertex(i)))
        m_vertices.push_back(c->vertex(i));
  }

  void add_shell(const Cell_handle c, const Vertex_handle a, const Vertex_handle b)
  {
    const Shell_3<Tr> shell(m_tr, c, c->index(a), c->index(b));
    for(const Cell_handle cell : shell.cells())
      add(cell);
  }

  void add_both_cells(const Cell_handle c, const Facet& f)
  {
    add(c);
    add(c->neighbor(internal::index_of_opposite_vertex(c, f)));
  }

  // One more layer: the cells beyond the outer facets, the hull excepted, while there are few enough vertices.
  void add_layer()
  {
    const std::vector<Cell_handle> inner = m_cells;
    for(const Cell_handle c : inner)
      for(int i = 0; i < 4; ++i)
        if(! m_tr.is_infinite(c->neighbor(i)) && number_of_vertices_with(c->neighbor(i)) <= max_number_of_vertices)
          add(c->neighbor(i));
  }

  std::size_t number_of_vertices_with(const Cell_handle extra) const
  {
    std::size_t n = m_vertices.size();
    for(int i = 0; i < 4; ++i)
      if(! internal::contains(m_vertices, extra->vertex(i)))
        ++n;
    return n;
  }

  bool reconnect(const std::vector<Edge>& edges, const std::vector<Facet>& facets)
  {
    for(const Cell_handle c : m_cells)
      if(m_tr.is_infinite(c))
        return false; // the hull would have to change
    if(m_vertices.size() > max_number_of_vertices)
      return false;
    m_reconnection.forget();
    if(reconnect_cells(edges, facets))
      return true;
    const std::size_t before = m_cells.size();
    for(int layer = 0; layer < number_of_layers; ++layer)
      add_layer();
    return m_cells.size() != before && reconnect_cells(edges, facets);
  }

  bool reconnect_cells(std::vector<Edge> edges, std::vector<Facet> facets)
  {
    m_constraints.collect(m_cells, edges, facets);
    if(m_reconnection(m_cells, edges, facets) != Reconnection::FOUND)
      return false;
    m_replacement(m_tr, m_cells, m_reconnection.tetrahedra(), m_visitor);
    ++m_number_of_replacements;
    return true;
  }

  static constexpr std::size_t max_number_of_vertices = 22;

  Tr& m_tr;
  const Constraints& m_constraints;
  Visitor& m_visitor;
  Segment_walk_3<Tr> m_segment_walk;
  Facet_walk_3<Tr> m_facet_walk;
  Reconnection m_reconnection;
  Cell_replacement<Tr> m_replacement;
  std::vector<Cell_handle> m_cells;
  std::vector<Vertex_handle> m_vertices;
  std::size_t m_number_of_replacements = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_CAVITY_RECOVERY_3_H
