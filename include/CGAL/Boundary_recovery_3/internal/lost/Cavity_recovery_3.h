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
#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/grow_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Facet_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Cell_replacement.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/constraint_queries.h>

#include <algorithm>
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
  typedef std::array<Vertex_handle, 2>         Vertex_pair;
  typedef std::array<Vertex_handle, 3>         Vertex_triple;

  static constexpr int number_of_layers = 3;

  Cavity_recovery_3(Tr& tr, const Predicates& predicates, const Constraints& constraints, Visitor& visitor)
    : m_tr(tr), m_constraints(constraints), m_visitor(visitor),
      m_segment_walk(tr, predicates), m_facet_walk(tr, predicates), m_reconnection(predicates),
      m_cavity(tr, constraints)
  { }

  // Returns whether uv is a mesh edge in the end.
  bool operator()(const Vertex_pair& e)
  {
    typedef Segment_walk_3<Tr> Walk;
    const typename Walk::Outcome outcome = m_segment_walk(e[0], e[1]);
    if(outcome != Walk::CROSSED)
      return outcome == Walk::IS_EDGE;
    m_cavity.clear();
    for(const typename Walk::Crossing& crossing : m_segment_walk.crossings())
      if(! (crossing.dimension == 1 ? add_shell(crossing.cell, crossing.vertices[0], crossing.vertices[1])
                                    : add_both_cells(crossing.cell, crossing.vertices)))
        return false;
    return reconnect(std::vector<Vertex_pair>(1, e), std::vector<Vertex_triple>());
  }

  // Returns whether the facet, whose edges are mesh edges, is a mesh facet in the end.
  bool operator()(const Vertex_triple& f)
  {
    typedef Facet_walk_3<Tr> Walk;
    int i, j;
    Cell_handle c;
    if(! m_tr.is_edge(f[0], f[1], c, i, j))
      return false;
    const typename Walk::Outcome outcome = m_facet_walk(f[0], f[1], f[2], c);
    if(outcome != Walk::CROSSED)
      return outcome == Walk::IS_FACET;
    m_cavity.clear();
    for(const typename Walk::Crossing& crossing : m_facet_walk.crossings())
      if(! add_shell(crossing.cell, crossing.vertices[0], crossing.vertices[1]))
        return false;
    return reconnect(std::vector<Vertex_pair>(), std::vector<Vertex_triple>(1, f));
  }

  std::size_t number_of_replacements() const { return m_number_of_replacements; }

private:
  // Returns false if one of the cells is infinite: then the hull would have to change.
  bool add_shell(const Cell_handle c, const Vertex_handle a, const Vertex_handle b)
  {
    const Shell_3<Tr> shell(m_tr, c, c->index(a), c->index(b));
    return std::all_of(shell.cells().begin(), shell.cells().end(),
                       [this](const Cell_handle cell) { return m_cavity.add(cell); });
  }

  bool add_both_cells(const Cell_handle c, const Vertex_triple& f)
  {
    return m_cavity.add(c) && m_cavity.add(c->neighbor(internal::index_of_opposite_vertex(c, f)));
  }

  bool reconnect(const std::vector<Vertex_pair>& edges, const std::vector<Vertex_triple>& facets)
  {
    if(m_cavity.vertices().size() > max_number_of_vertices)
      return false;
    m_reconnection.forget();
    if(reconnect_cells(edges, facets))
      return true;
    const std::size_t before = m_cavity.cells().size();
    for(int layer = 0; layer < number_of_layers; ++layer)
      internal::add_layer(m_cavity, max_number_of_vertices);
    return m_cavity.cells().size() != before && reconnect_cells(edges, facets);
  }

  bool reconnect_cells(std::vector<Vertex_pair> edges, std::vector<Vertex_triple> facets)
  {
    internal::collect_constraints(m_constraints, m_cavity.cells(), edges, facets);
    if(m_reconnection(m_cavity.cells(), edges, facets) != Reconnection::FOUND)
      return false;
    m_replacement(m_tr, m_cavity.cells(), m_reconnection.tetrahedra(), m_visitor);
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
  Cavity_3<Tr, Constraints> m_cavity;
  std::size_t m_number_of_replacements = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_CAVITY_RECOVERY_3_H
