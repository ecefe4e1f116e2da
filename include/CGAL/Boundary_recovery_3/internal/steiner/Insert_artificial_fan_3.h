// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_INSERT_ARTIFICIAL_FAN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_INSERT_ARTIFICIAL_FAN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/operations/split_facet.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Facet_fans_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Half_facet_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Adds a fan at a Steiner point s on an edge along no constrained facet: where an edge has less than two fans (it is
 * isolated, or of one facet), they cut the ball of s into less than two sectors.
 *
 * The fan is in a half plane through the edge and a neighbor of s. Points are put on the mesh facets at s that it cuts,
 * halfway to the boundary of the ball; the neighbor with the fewest of these is taken.
 */
template <typename Tr, typename Visitor>
class Insert_artificial_fan_3
{
public:
  typedef Steiner_mesh_3<Tr, Visitor>    Mesh;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Cell_handle     Cell_handle;
  typedef typename Mesh::Vertices        Vertices;
  typedef Half_facet_star_3<Tr>          Star;
  typedef Facet_fans_3<Tr>               Fans;

  explicit Insert_artificial_fan_3(Mesh& mesh) : m_mesh(mesh) { }

  // Adds the fan to those between the neighbors of s on its edge, and brings the star up to date. The points that come
  // into the mesh are appended to `points`. Returns false if there is no place for a fan.
  bool operator()(Star& star, Fans& fans, Vertices& points)
  {
    m_p = fans.ends()[0];
    m_q = fans.ends()[1];
    Vertex_handle best;
    std::vector<Cut> fewest;
    for(const Half_facet& h : star.half_facets())
    {
      const Vertex_handle x = h.v;
      if(m_mesh.tr.is_infinite(x) || x == m_p || x == m_q || x == best || fans.has_vertex(x))
        continue;
      std::vector<Cut> cuts = facets_cut_by_half_plane(star, x);
      if(best == Vertex_handle() || cuts.size() < fewest.size())
      {
        best = x;
        fewest.swap(cuts);
      }
    }
    return best != Vertex_handle() && insert(star, fans, best, fewest, points);
  }

private:
  typedef typename Mesh::Exact_point           Exact_point;
  typedef typename Mesh::Positions::Exact_FT   FT;
  typedef typename Star::Half_facet            Half_facet;
  typedef typename Mesh::Vertex_triple         Vertex_triple;

  // A mesh facet s v w that is cut by a half plane through the edge.
  typedef Half_facet Cut;

  // Each facet once, seen from the side where its v is below the plane and its w above.
  std::vector<Cut> facets_cut_by_half_plane(const Star& star, const Vertex_handle x) const
  {
    std::vector<Cut> cuts;
    for(const Half_facet& h : star.half_facets())
      if(! m_mesh.tr.is_infinite(h.v) && ! m_mesh.tr.is_infinite(h.w)
         && m_mesh.predicates.orientation(m_p, m_q, x, h.v) == NEGATIVE
         && m_mesh.predicates.orientation(m_p, m_q, x, h.w) == POSITIVE
         && m_mesh.predicates.orientation(m_p, m_q, h.v, h.w) == POSITIVE)
        cuts.push_back(h);
    return cuts;
  }

  // Whether v is in the half plane through p, q and x, but not on the line pq.
  bool is_in_half_plane(const Vertex_handle v, const Vertex_handle x) const
  {
    if(v == m_p || v == m_q || m_mesh.tr.is_infinite(v))
      return false;
    return v == x || (m_mesh.predicates.orientation(m_p, m_q, x, v) == COPLANAR
                      && m_mesh.predicates.side_of_line(m_p, m_q, x, v) == POSITIVE);
  }

  bool insert(Star& star, Fans& fans, const Vertex_handle x, const std::vector<Cut>& cuts, Vertices& points)
  {
    Vertices vertices = { m_p, m_q };
    for(const Half_facet& h : star.half_facets())
      if(is_in_half_plane(h.v, x))
        vertices.push_back(h.v);
    for(const Cut& cut : cuts)
    {
      points.push_back(split(star.center(), cut, x));
      vertices.push_back(points.back());
    }
    star.collect(star.center());
    fans.update(star);
    return fans.add_planar_fan(star, vertices, {{ m_p, m_q, x }}, false);
  }

  // Puts a point on the facet s v w, halfway between s and the point where vw meets the plane of p, q and x.
  Vertex_handle split(const Vertex_handle s, const Cut& cut, const Vertex_handle x)
  {
    const Exact_point p = m_mesh.positions(m_p), q = m_mesh.positions(m_q), r = m_mesh.positions(x);
    const Exact_point v = m_mesh.positions(cut.v), w = m_mesh.positions(cut.w);
    const FT at_v = CGAL::volume(p, q, r, v), at_w = CGAL::volume(p, q, r, w);
    const Exact_point end = v + (at_v / (at_v - at_w)) * (w - v);
    const Vertex_handle point = m_mesh.editor.create_vertex();
    m_mesh.positions.set(point, CGAL::midpoint(m_mesh.positions(s), end));
    // cells have changed since the cut was found
    Cell_handle c;
    int i = 0, j = 0, k = 0;
    CGAL_assertion_code(const bool is_facet =)
    m_mesh.tr.is_facet(s, cut.v, cut.w, c, i, j, k);
    CGAL_assertion(is_facet);
    internal::split_facet(m_mesh.editor, c, Vertex_triple{{ s, cut.v, cut.w }}, point);
    return point;
  }

  Mesh& m_mesh;
  Vertex_handle m_p, m_q; // the neighbors of s on its edge
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_INSERT_ARTIFICIAL_FAN_3_H
