// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SPLIT_OFF_STEINER_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SPLIT_OFF_STEINER_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/operations/split_simplex.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Facet_fans_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Place_sector_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_free_point_3.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Triangulates the polygon of a fan without its center s. Ears are cut off so that s still sees what is left, the best
 * one first, until nothing is left. There is always one: the inner angles of a polygon are too small on average for all
 * corners to be reflex.
 */
template <typename Tr>
class Triangulate_fan_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef Vertex_predicates_3<Tr>        Predicates;
  typedef Half_facet_star_3<Tr>          Star;
  typedef Facet_fan_3<Tr>                Fan;

  Triangulate_fan_3(const Tr& tr, const Predicates& predicates) : m_tr(tr), m_predicates(predicates) { }

  // Sets the triangles of a fan in the star of s, and their normal. Returns false if that is not possible.
  bool operator()(const Star& star, Fan& fan)
  {
    m_s = star.center();
    find_scale(star);
    if(! find_apex(star, fan.facets.front()))
      return false;
    Vertices polygon = fan.polygon();
    while(polygon.size() > 3)
    {
      const std::size_t k = find_best_ear(polygon, fan.is_closed);
      if(k == polygon.size())
        return false;
      fan.triangles.push_back(corner(polygon, k));
      polygon.erase(polygon.begin() + k);
    }
    fan.triangles.push_back({{ polygon[0], polygon[1], polygon[2] }});
    for(const Vertex_triple& t : fan.triangles)
      fan.normal += normal(t);
    return orientation_in_plane(fan.triangles.back()) == POSITIVE;
  }

private:
  typedef std::vector<Vertex_handle>     Vertices;
  typedef typename Fan::Half_facet       Half_facet;
  typedef typename Fan::Vertex_triple    Vertex_triple;
  typedef typename Fan::Vector           Vector;

  static Vertex_triple corner(const Vertices& polygon, const std::size_t k)
  {
    const std::size_t n = polygon.size();
    return {{ polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n] }};
  }

  std::size_t find_best_ear(const Vertices& polygon, const bool is_closed) const
  {
    const std::size_t n = polygon.size();
    std::size_t best = n;
    double best_quality = -1;
    for(std::size_t k = is_closed ? 0 : 1; k < (is_closed ? n : n - 1); ++k)
    {
      const Vertex_triple t = corner(polygon, k);
      if(quality(t) > best_quality && orientation_in_plane(t) == POSITIVE
         && orientation_in_plane({{ m_s, t[0], t[2] }}) != NEGATIVE)
      {
        best = k;
        best_quality = quality(t);
      }
    }
    return best;
  }

  // The orientation in a plane is seen from a vertex beside it.
  bool find_apex(const Star& star, const Half_facet& h)
  {
    for(const Half_facet& g : star.half_facets())
      if(! m_tr.is_infinite(g.v))
      {
        m_apex = g.v;
        m_apex_side = m_predicates.orientation(m_s, h.v, h.w, g.v);
        if(m_apex_side != COPLANAR)
          return true;
      }
    return false;
  }

  Orientation orientation_in_plane(const Vertex_triple& t) const
  {
    return m_apex_side * m_predicates.orientation(t[0], t[1], t[2], m_apex);
  }

  // Area by square of the longest edge: only a choice depends on it.
  double quality(const Vertex_triple& t) const
  {
    double longest = 0;
    for(int i = 0; i < 3; ++i)
      longest = (std::max)(longest, difference(t[i], t[(i + 1) % 3]).squared_length());
    return longest > 0 ? std::sqrt(normal(t).squared_length()) / longest : 0;
  }

  Vector normal(const Vertex_triple& t) const
  {
    return CGAL::cross_product(difference(t[1], t[0]), difference(t[2], t[0]));
  }

  // In units of the size of the star.
  Vector difference(const Vertex_handle v, const Vertex_handle w) const
  {
    return m_scale * (m_predicates.approximate_point(v) - m_predicates.approximate_point(w));
  }

  void find_scale(const Star& star)
  {
    m_scale = 1;
    double largest = 0;
    for(const Half_facet& h : star.half_facets())
      if(! m_tr.is_infinite(h.v))
        largest = (std::max)(largest, largest_coordinate(difference(h.v, m_s)));
    m_scale = 1 / binary_scale(largest);
  }

  const Tr& m_tr;
  const Predicates& m_predicates;
  Vertex_handle m_s;
  Vertex_handle m_apex;
  Orientation m_apex_side;
  double m_scale;
};

/*
 * Adds an artificial fan, which is in no constrained facet, at a Steiner point s on a constrained edge. This is needed
 * if the edge has fewer than two fans, since the edge is isolated or belongs to one facet: a single fan does not cut
 * the star of s into sectors.
 *
 * The fan is in the half plane through the edge and a neighbor of s. Each mesh facet at s that is cut by this half
 * plane gets a new point, halfway between s and the boundary of the star. The neighbor with the fewest cut facets is
 * taken.
 */
template <typename Tr>
class Insert_artificial_fan_3
{
public:
  typedef Steiner_mesh_3<Tr>    Mesh;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Cell_handle     Cell_handle;
  typedef typename Mesh::Vertices        Vertices;
  typedef Half_facet_star_3<Tr>          Star;
  typedef Facet_fans_3<Tr>               Fans;

  explicit Insert_artificial_fan_3(Mesh& mesh) : m_mesh(mesh) { }

  // Adds the fan to `fans`, and updates the star of s. The new points are appended to `points`. Returns false if there
  // is no place for a fan; new points stay in the mesh then, too.
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

/*
 * Second half of the main procedure of [CZZ+17, Section 4]: takes a Steiner point s off its constraint, by Algorithms
 * A.1 to A.3 of the article.
 *
 * The mesh facets at s that are parts of one constrained facet form a *fan*, a planar polygon around s. The fan is
 * closed if s is in the interior of the constrained facet. If s is on an edge, the fan goes from one neighbor of s on
 * the edge to the other. The hull facets at s form fans, too. The fans cut the star of s into sectors. The star is
 * removed, and each fan is triangulated without s. Each sector gets a point s_i that sees all of its boundary, and
 * becomes the star of s_i. Here, A.1 (two sectors), A.2 and A.3 (as many sectors as facets at the edge) are one
 * algorithm. If an edge has fewer than two fans, artificial fans are added, see `Insert_artificial_fan_3`.
 */
template <typename Tr>
class Split_off_steiner_point_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;

  // All constraints are unions of mesh simplices.
  explicit Split_off_steiner_point_3(Mesh& mesh)
    : m_mesh(mesh), m_star(mesh.tr), m_fans(mesh.tr, mesh.predicates), m_insert_artificial_fan(mesh),
      m_sectors(mesh.tr), m_triangulate_fan(mesh.tr, mesh.predicates), m_sector_points(mesh),
      m_suppress(mesh, mesh.ledger)
  { }

  // Takes s off its constraint. The new points are free points of the ledger, and may have exact positions. Returns
  // false if a fan, its triangulation, or the position of a new point is not found: then s stays, and the points of
  // artificial fans stay as free points.
  bool operator()(const Vertex_handle s)
  {
    m_points_of_fans.clear();
    m_star.collect(s);
    const Carrier origin = m_mesh.ledger.carrier(s);
    const bool is_possible = collect_fans() && label_sectors() && triangulate_fans()
                          && m_sector_points(m_star, m_fans, m_sectors);
    if(is_possible)
      replace_star(origin);
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
    for(const std::size_t f : m_mesh.constraints.facets_at_edge(carrier.index))
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

  void replace_star(const Carrier& origin)
  {
    const Vertex_handle s = m_star.center();
    m_mesh.ledger.erase(s);
    m_mesh.editor.replace(m_star.cells(), m_sector_points.tetrahedra(), std::array<Vertex_handle, 1>{{ s }});
    for(const Vertex_handle v : m_sector_points.vertices())
      m_mesh.ledger.insert_free(v, origin);
  }

  // Removes the new points of a split with artificial fans, or moves them to the deepest point of the kernel of their
  // star. This is done before the star of the next Steiner point is cut: else stars get so thin that no floating point
  // numbers are inside.
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
  Insert_artificial_fan_3<Tr> m_insert_artificial_fan;
  Star_sectors_3<Tr> m_sectors;
  Triangulate_fan_3<Tr> m_triangulate_fan;
  Place_sector_points_3<Tr> m_sector_points;
  Suppress_free_point_3<Tr, typename Mesh::Ledger> m_suppress;
  Vertices m_points_of_fans; // of artificial ones
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SPLIT_OFF_STEINER_POINT_3_H
