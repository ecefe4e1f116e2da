// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_SPLITTING_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_SPLITTING_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_validity.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Ball_sectors_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Facet_fans_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Half_facet_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Insert_artificial_fan_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Sector_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_free_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Triangulate_fan_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The main procedure of [CZZ+17, Section 4], second half: takes a Steiner point s off its constraint
 * [CZZ+17, Alg. A.1 to A.3].
 *
 * The mesh facets at s that are parts of one constrained facet form a *fan*: a planar polygon around s, closed if s is
 * in the interior of the facet, and from one neighbor of s on the edge to the other if s is on an edge. So do the hull
 * facets at s. The fans cut the ball of s into sectors. The ball is removed, each fan is triangulated without s, and
 * each sector gets a point s_i that sees all of its boundary, and is starred from it. So A.1 (two sectors), A.2 and A.3
 * (as many as facets at the edge) are one algorithm here. An edge with less than two fans gets artificial ones.
 */
template <typename Tr, typename Visitor>
class Steiner_splitting_3
{
public:
  typedef Steiner_mesh_3<Tr, Visitor>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;

  // All constraints are unions of mesh simplices.
  explicit Steiner_splitting_3(Mesh& mesh)
    : m_mesh(mesh), m_star(mesh.tr), m_fans(mesh.tr, mesh.predicates), m_insert_artificial_fan(mesh),
      m_sectors(mesh.tr), m_triangulate_fan(mesh.tr, mesh.predicates), m_sector_points(mesh),
      m_suppress(mesh, mesh.ledger)
  { }

  // Takes s off its constraint. The points that come in its place are free points of the ledger, and may have exact
  // positions. Returns false if there is none for one of them; then s stays.
  bool operator()(const Vertex_handle s)
  {
    m_points_of_fans.clear();
    m_star.collect(s);
    const Carrier origin = m_mesh.ledger.carrier(s);
    const bool is_possible = collect_fans() && label_sectors() && triangulate_fans()
                          && m_sector_points(m_star, m_fans, m_sectors);
    if(is_possible)
      replace_ball(origin);
    for(const Vertex_handle v : m_points_of_fans) // they are in the mesh anyway
      m_mesh.ledger.insert_free(v, origin);
    if(is_possible && ! m_points_of_fans.empty())
      suppress_new_points();
    CGAL_expensive_postcondition(internal::is_mesh_valid(m_mesh.tr, m_mesh.predicates));
    return is_possible;
  }

  std::size_t number_of_transformations() const { return m_suppress.number_of_transformations(); }

private:
  typedef typename Mesh::Ledger::Carrier       Carrier;
  typedef typename Mesh::Vertices              Vertices;
  typedef Facet_fans_3<Tr>                     Fans;
  typedef typename Fans::Fan                   Fan;

  bool collect_fans()
  {
    const Vertex_handle s = m_star.center();
    const Carrier carrier = m_mesh.ledger.carrier(s);
    if(carrier.dimension == 2)
    {
      m_fans.clear();
      return add_fan_of_constraint(carrier.index, true);
    }
    m_fans.clear(m_mesh.ledger.neighbors_on_edge(s));
    for(const std::size_t f : m_mesh.ledger.facets_at_edge(carrier.index))
      if(! add_fan_of_constraint(f, false))
        return false;
    if(! m_fans.add_hull_fans(m_star))
      return false;
    while(m_fans.size() < 2)
      if(! m_insert_artificial_fan(m_star, m_fans, m_points_of_fans))
        return false;
    return true;
  }

  bool add_fan_of_constraint(const std::size_t f, const bool is_closed)
  {
    return m_fans.add_planar_fan(m_star, m_mesh.ledger.vertices_on_facet(f), m_mesh.constraints.facets()[f], is_closed);
  }

  // Returns false if there are not as many sectors as expected.
  bool label_sectors()
  {
    m_sectors.label(m_star, m_fans);
    const bool is_closed = m_fans.begin()->is_closed;
    return m_sectors.size() == (is_closed ? 2 : m_fans.size());
  }

  bool triangulate_fans()
  {
    return std::all_of(m_fans.begin(), m_fans.end(), [this](Fan& fan) { return m_triangulate_fan(m_star, fan); });
  }

  void replace_ball(const Carrier& origin)
  {
    const Vertex_handle s = m_star.center();
    m_mesh.ledger.erase(s);
    m_mesh.editor.replace(m_star.cells(), m_sector_points.tetrahedra(), std::array<Vertex_handle, 1>{{ s }});
    for(const Vertex_handle v : m_sector_points.vertices())
      m_mesh.ledger.insert_free(v, origin);
  }

  // An artificial fan brings many points at once. They go, or move to the middle of what room they have, before the
  // ball of the next Steiner point is cut up: else the balls get so thin that no number fits into them.
  void suppress_new_points()
  {
    Vertices points = m_sector_points.vertices();
    points.insert(points.end(), m_points_of_fans.begin(), m_points_of_fans.end());
    for(const Vertex_handle v : points)
      if(m_mesh.context.go_further())
        m_suppress.remove(v, recursion_level);
    for(const Vertex_handle v : points)
      if(m_mesh.ledger.is_free(v))
        m_suppress.relocate(v);
  }

  // See "Tuning constants" in the manual.
  static constexpr int recursion_level = 4;

  Mesh& m_mesh;
  Half_facet_star_3<Tr> m_star; // of the Steiner point
  Fans m_fans;
  Insert_artificial_fan_3<Tr, Visitor> m_insert_artificial_fan;
  Ball_sectors_3<Tr> m_sectors;
  Triangulate_fan_3<Tr> m_triangulate_fan;
  Sector_points_3<Tr, Visitor> m_sector_points;
  Suppress_free_point_3<Tr, Visitor, typename Mesh::Ledger> m_suppress;
  Vertices m_points_of_fans; // of artificial ones
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_SPLITTING_3_H
