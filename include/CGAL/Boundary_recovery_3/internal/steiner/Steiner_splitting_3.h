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

#include <CGAL/Boundary_recovery_3/internal/geometry/Kernel_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Cell_replacement.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_validity.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Origin.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The main procedure of [CZZ+17, Section 4], second half: takes a Steiner point s off its constraint
 * [CZZ+17, Alg. A.1 to A.3].
 *
 * The mesh facets at s that are parts of one constrained facet form a *fan*: a planar polygon around s, closed if s is
 * in the interior of the facet, and from one neighbor of s on the edge to the other if s is on an edge. The fans cut
 * the ball of s into sectors. The ball is removed, each fan is triangulated without s, and each sector gets a point s_i
 * that sees all of its boundary, and is starred from it. So A.1 (two sectors), A.2 and A.3 (as many as facets at the
 * edge) are one algorithm here.
 *
 * - On the convex hull, the hull facets at s form fans, too. They are planar, for s is on a straight line or in a plane
 *   there. The sector outside has no s_i: its triangles go to the infinite vertex.
 * - An edge with less than two fans (isolated, or of one facet) gets artificial ones: along a half plane through the
 *   edge, points are put on the mesh facets at s that it cuts, halfway to the boundary of the ball.
 */
template <typename Tr, typename Visitor>
class Steiner_splitting_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Constraints_3<Tr>                    Constraints;
  typedef Steiner_points_3<Tr>                 Steiner_points;
  typedef std::vector<Vertex_handle>           Vertices;

  // `predicates` know of the positions in `steiner_points`. All constraints are unions of mesh simplices.
  Steiner_splitting_3(Tr& tr, const Predicates& predicates, const Constraints& constraints,
                      Steiner_points& steiner_points, Visitor& visitor)
    : m_tr(tr), m_predicates(predicates), m_constraints(constraints), m_steiner_points(steiner_points),
      m_visitor(visitor), m_kernel_point(predicates, steiner_points.positions())
  { }

  // Takes s off its constraint. The points that come in its place may have exact positions.
  // Returns false if there is none for one of them; then s stays.
  bool operator()(const Vertex_handle s)
  {
    m_s = s;
    m_free_points.clear();
    m_sector_points.clear();
    if(collect_fans() && label_sectors() && triangulate_fans() && place_points())
    {
      replace_ball();
      release_free_points();
      CGAL_expensive_postcondition(internal::is_mesh_valid(m_tr, m_predicates));
      return true;
    }
    m_points.insert(m_points.end(), m_free_points.begin(), m_free_points.end()); // they are in the mesh
    for(const Vertex_handle v : m_sector_points)
      if(v != Vertex_handle())
      {
        m_steiner_points.positions().erase(v);
        m_tr.tds().delete_vertex(v);
      }
    CGAL_expensive_postcondition(internal::is_mesh_valid(m_tr, m_predicates));
    return false;
  }

  // The points that came off the constraints, in the order of their creation.
  const Vertices& points() const { return m_points; }

private:
  typedef typename Steiner_points::Positions            Positions;
  typedef typename Positions::Exact_point_3             Exact_point;
  typedef typename Positions::Exact_FT                  FT;
  typedef typename Kernel_point_3<Tr>::Exact_vector     Exact_vector;
  typedef typename Cell_replacement<Tr>::Tetrahedron    Tetrahedron;
  typedef typename Kernel_point_3<Tr>::Triangle         Triangle;
  typedef typename Kernel_point_3<Tr>::Vector           Vector;

  // The side of a mesh facet s v w from which v and w are seen in counterclockwise order around s.
  struct Half_facet
  {
    Vertex_handle v, w;
    Cell_handle cell;        // the one on this side
    Vertex_handle opposite;  // its fourth vertex
  };

  // The facets s v_i v_{i+1} of a polygon, and the triangles that come in their place.
  struct Fan
  {
    std::vector<Half_facet> facets;      // all on one side of the fan, its positive one
    bool is_closed;
    std::array<std::size_t, 2> sectors;  // on its positive and on its negative side
    std::vector<Triangle> triangles;     // seen from the positive side
  };

  Exact_point position(const Vertex_handle v) const { return m_steiner_points.positions()(v); }

  // --- fans ---------------------------------------------------------------------------------------------------------

  bool collect_fans()
  {
    m_fans.clear();
    collect_half_facets();
    const typename Steiner_points::Carrier carrier = m_steiner_points.carrier(m_s);
    if(carrier.dimension == 2)
      return add_fan_of_constraint(carrier.index, true);
    const std::array<Vertex_handle, 2> ends = m_steiner_points.neighbors_on_edge(m_s);
    m_p = ends[0];
    m_q = ends[1];
    for(const std::size_t f : m_steiner_points.facets_at_edge(carrier.index))
      if(! add_fan_of_constraint(f, false))
        return false;
    if(! add_hull_fans())
      return false;
    while(m_fans.size() < 2)
      if(! add_artificial_fan())
        return false;
    return true;
  }

  void collect_half_facets()
  {
    m_star.clear();
    m_tr.incident_cells(m_s, std::back_inserter(m_star));
    m_half_facets.clear();
    for(const Cell_handle c : m_star)
      for(int i = 0; i < 4; ++i)
      {
        if(c->vertex(i) == m_s)
          continue;
        int k = 0;
        while(c->vertex(Tr::vertex_triple_index(i, k)) != m_s)
          ++k;
        m_half_facets.push_back({ c->vertex(Tr::vertex_triple_index(i, (k + 1) % 3)),
                                  c->vertex(Tr::vertex_triple_index(i, (k + 2) % 3)), c, c->vertex(i) });
      }
  }

  bool add_fan_of_constraint(const std::size_t f, const bool is_closed)
  {
    return add_planar_fan(m_steiner_points.vertices_on_facet(f), m_constraints.facets()[f], is_closed);
  }

  // The mesh facets at s between the given vertices, which are all in the plane of a triangle.
  bool add_planar_fan(const Vertices& vertices, const Triangle& plane, const bool is_closed)
  {
    std::vector<Half_facet> facets;
    for(const Half_facet& h : m_half_facets)
      if(internal::contains(vertices, h.v) && internal::contains(vertices, h.w) && is_above(h, plane))
        facets.push_back(h);
    return add_fan(facets, is_closed);
  }

  // Whether the cell of a half facet in the plane of a triangle is on the positive side of it.
  bool is_above(const Half_facet& h, const Triangle& plane) const
  {
    if(! m_tr.is_infinite(h.opposite))
      return m_predicates.orientation(plane[0], plane[1], plane[2], h.opposite) == POSITIVE;
    const Vertex_handle below = m_tr.mirror_vertex(h.cell, h.cell->index(h.opposite));
    return m_predicates.orientation(plane[0], plane[1], plane[2], below) == NEGATIVE;
  }

  // The facets seen from outside the hull, from p to q and from q to p.
  bool add_hull_fans()
  {
    std::vector<Half_facet> facets;
    for(const Half_facet& h : m_half_facets)
      if(m_tr.is_infinite(h.opposite))
        facets.push_back(h);
    if(facets.empty())
      return true;
    for(const Vertex_handle start : { m_p, m_q })
    {
      std::vector<Half_facet> fan;
      for(Vertex_handle v = start; fan.empty() || (v != m_p && v != m_q); v = fan.back().w)
      {
        const auto it = std::find_if(facets.begin(), facets.end(), [&](const Half_facet& h) { return h.v == v; });
        if(it == facets.end())
          return false;
        fan.push_back(*it);
      }
      if(! is_in_fan(fan.front()) && ! add_fan(fan, false))
        return false;
    }
    return true;
  }

  bool is_in_fan(const Half_facet& h) const
  {
    for(const Fan& fan : m_fans)
      for(const Half_facet& g : fan.facets)
        if((g.v == h.v && g.w == h.w) || (g.v == h.w && g.w == h.v))
          return true;
    return false;
  }

  // Puts the facets in their order around s; an open fan starts at p or at q.
  bool add_fan(std::vector<Half_facet> facets, const bool is_closed)
  {
    const auto find = [&facets](const std::size_t from, const Vertex_handle v)
    {
      return std::find_if(facets.begin() + from, facets.end(), [&](const Half_facet& h) { return h.v == v; });
    };
    if(facets.empty())
      return false;
    if(! is_closed)
    {
      auto first = find(0, m_p);
      if(first == facets.end())
        first = find(0, m_q);
      if(first == facets.end())
        return false;
      std::swap(*first, facets.front());
    }
    for(std::size_t i = 1; i < facets.size(); ++i)
    {
      const auto next = find(i, facets[i - 1].w);
      if(next == facets.end())
        return false;
      std::swap(*next, facets[i]);
    }
    const Vertex_handle last = facets.back().w;
    if(is_closed ? last != facets.front().v : (last != m_p && last != m_q))
      return false;
    m_fans.push_back({ std::move(facets), is_closed, {{ 0, 0 }}, std::vector<Triangle>() });
    return true;
  }

  // --- artificial fans ----------------------------------------------------------------------------------------------

  // A mesh facet s v w that is cut by a half plane through the edge.
  typedef Half_facet Cut;

  bool add_artificial_fan()
  {
    Vertex_handle best;
    std::vector<Cut> fewest;
    for(const Half_facet& h : m_half_facets)
    {
      const Vertex_handle x = h.v;
      if(m_tr.is_infinite(x) || x == m_p || x == m_q || x == best || is_in_some_fan(x))
        continue;
      std::vector<Cut> cuts = facets_cut_by_half_plane(x);
      if(best == Vertex_handle() || cuts.size() < fewest.size())
      {
        best = x;
        fewest.swap(cuts);
      }
    }
    if(best == Vertex_handle())
      return false;
    Vertices vertices = { m_p, m_q };
    for(const Half_facet& h : m_half_facets)
      if(is_in_half_plane(h.v, best))
        vertices.push_back(h.v);
    for(const Cut& cut : fewest)
      vertices.push_back(insert_free_point(cut, best));
    collect_half_facets();
    refresh_fans();
    return add_planar_fan(vertices, {{ m_p, m_q, best }}, false);
  }

  bool is_in_some_fan(const Vertex_handle x) const
  {
    for(const Fan& fan : m_fans)
      for(const Half_facet& h : fan.facets)
        if(h.v == x || h.w == x)
          return true;
    return false;
  }

  // Whether v is in the half plane through p, q and x, but not on the line pq.
  bool is_in_half_plane(const Vertex_handle v, const Vertex_handle x) const
  {
    if(v == m_p || v == m_q || m_tr.is_infinite(v))
      return false;
    return v == x || (m_predicates.orientation(m_p, m_q, x, v) == COPLANAR
                      && m_predicates.side_of_line(m_p, m_q, x, v) == POSITIVE);
  }

  // Each facet once, seen from the side where its v is below the plane and its w above.
  std::vector<Cut> facets_cut_by_half_plane(const Vertex_handle x) const
  {
    std::vector<Cut> cuts;
    for(const Half_facet& h : m_half_facets)
      if(! m_tr.is_infinite(h.v) && ! m_tr.is_infinite(h.w)
         && m_predicates.orientation(m_p, m_q, x, h.v) == NEGATIVE
         && m_predicates.orientation(m_p, m_q, x, h.w) == POSITIVE
         && m_predicates.orientation(m_p, m_q, h.v, h.w) == POSITIVE)
        cuts.push_back(h);
    return cuts;
  }

  // Puts a point on the facet s v w, halfway between s and the point where vw meets the plane of p, q and x.
  Vertex_handle insert_free_point(const Cut& cut, const Vertex_handle x)
  {
    const Exact_point p = position(m_p), q = position(m_q), r = position(x), v = position(cut.v), w = position(cut.w);
    const FT at_v = CGAL::volume(p, q, r, v), at_w = CGAL::volume(p, q, r, w);
    const Exact_point end = v + (at_v / (at_v - at_w)) * (w - v);
    const Vertex_handle free_point = m_tr.tds().create_vertex();
    m_steiner_points.positions().set(free_point, CGAL::midpoint(position(m_s), end));
    m_free_points.push_back(free_point);
    // cells have changed since the cut was found
    Cell_handle c;
    int i = 0, j = 0, k = 0;
    CGAL_assertion_code(const bool is_facet =)
    m_tr.is_facet(m_s, cut.v, cut.w, c, i, j, k);
    CGAL_assertion(is_facet);
    const std::array<Cell_handle, 2> cells = {{ c, c->neighbor(6 - i - j - k) }};
    m_replacement(m_tr, cells, internal::split_facet(cells, Triangle{{ m_s, cut.v, cut.w }}, free_point), m_visitor);
    return free_point;
  }

  // The cells of the half facets of the fans may have been replaced.
  void refresh_fans()
  {
    for(Fan& fan : m_fans)
      for(Half_facet& g : fan.facets)
        for(const Half_facet& h : m_half_facets)
          if(h.v == g.v && h.w == g.w)
            g = h;
  }

  // --- sectors ------------------------------------------------------------------------------------------------------

  // Numbers the sectors, and finds those on both sides of each fan. Returns false if there are not as many as expected.
  bool label_sectors()
  {
    m_sector_of_cell.clear();
    m_is_infinite.clear();
    for(const Cell_handle c : m_star)
      if(m_sector_of_cell.count(&*c) == 0)
        fill_sector(c);
    for(Fan& fan : m_fans)
    {
      const Half_facet& h = fan.facets.front();
      fan.sectors = {{ sector(h.cell), sector(h.cell->neighbor(h.cell->index(h.opposite))) }};
    }
    const bool is_closed = m_fans.front().is_closed;
    return m_is_infinite.size() == (is_closed ? 2 : m_fans.size());
  }

  std::size_t sector(const Cell_handle c) const { return m_sector_of_cell.find(&*c)->second; }

  void fill_sector(const Cell_handle seed)
  {
    const std::size_t number = m_is_infinite.size();
    m_is_infinite.push_back(m_tr.is_infinite(seed));
    m_sector_of_cell[&*seed] = number;
    std::vector<Cell_handle> front(1, seed);
    while(! front.empty())
    {
      const Cell_handle c = front.back();
      front.pop_back();
      for(const Half_facet& h : m_half_facets)
      {
        if(h.cell != c || is_in_fan(h))
          continue;
        const Cell_handle n = c->neighbor(c->index(h.opposite));
        if(m_sector_of_cell.emplace(&*n, number).second)
          front.push_back(n);
      }
    }
  }

  // --- triangulation of the fans ------------------------------------------------------------------------------------

  bool triangulate_fans()
  {
    return std::all_of(m_fans.begin(), m_fans.end(), [this](Fan& fan) { return triangulate(fan); });
  }

  // Cuts ears off the polygon so that s still sees what is left, until nothing is left. There is always one: the inner
  // angles of a polygon are too small on average for all corners to be reflex.
  bool triangulate(Fan& fan)
  {
    Vertices polygon;
    for(const Half_facet& h : fan.facets)
      polygon.push_back(h.v);
    if(! fan.is_closed)
      polygon.push_back(fan.facets.back().w);
    find_scale();
    if(! find_apex(fan.facets.front()))
      return false;
    while(polygon.size() > 3)
    {
      const std::size_t k = find_best_ear(polygon, fan.is_closed);
      if(k == polygon.size())
        return false;
      fan.triangles.push_back(corner(polygon, k));
      polygon.erase(polygon.begin() + k);
    }
    fan.triangles.push_back({{ polygon[0], polygon[1], polygon[2] }});
    return orientation_in_plane(fan.triangles.back()) == POSITIVE;
  }

  static Triangle corner(const Vertices& polygon, const std::size_t k)
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
      const Triangle t = corner(polygon, k);
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
  bool find_apex(const Half_facet& h)
  {
    for(const Half_facet& g : m_half_facets)
      if(! m_tr.is_infinite(g.v))
      {
        m_apex = g.v;
        m_apex_side = m_predicates.orientation(m_s, h.v, h.w, g.v);
        if(m_apex_side != COPLANAR)
          return true;
      }
    return false;
  }

  Orientation orientation_in_plane(const Triangle& t) const
  {
    return m_apex_side * m_predicates.orientation(t[0], t[1], t[2], m_apex);
  }

  // Area by square of the longest edge: only a choice depends on it.
  double quality(const Triangle& t) const
  {
    double longest = 0;
    for(int i = 0; i < 3; ++i)
      longest = (std::max)(longest, difference(t[i], t[(i + 1) % 3]).squared_length());
    return longest > 0 ? std::sqrt(normal(t).squared_length()) / longest : 0;
  }

  // In units of the size of the ball.
  Vector difference(const Vertex_handle v, const Vertex_handle w) const
  {
    return m_scale * (m_predicates.approximate_point(v) - m_predicates.approximate_point(w));
  }

  // A power of two, so that products of lengths do not leave the range of floating point numbers.
  void find_scale()
  {
    m_scale = 1;
    double largest = 0;
    for(const Half_facet& h : m_half_facets)
      if(! m_tr.is_infinite(h.v))
        largest = (std::max)(largest, largest_coordinate(difference(h.v, m_s)));
    m_scale = 1 / binary_scale(largest);
  }

  Vector normal(const Triangle& t) const
  {
    return CGAL::cross_product(difference(t[1], t[0]), difference(t[2], t[0]));
  }

  // --- the points ---------------------------------------------------------------------------------------------------

  // Creates s_i for each finite sector, and finds a position for it.
  bool place_points()
  {
    m_faces.assign(m_is_infinite.size(), std::vector<Triangle>());
    m_directions.assign(m_is_infinite.size(), std::vector<Exact_vector>(1, CGAL::NULL_VECTOR));
    m_mean_directions.assign(m_is_infinite.size(), CGAL::NULL_VECTOR);
    m_sector_points.assign(m_is_infinite.size(), Vertex_handle());
    for(const Cell_handle c : m_star)
      m_faces[sector(c)].push_back(internal::facet_vertices(c, c->index(m_s)));
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      if(m_is_infinite[i])
        m_faces[i].clear(); // the infinite vertex is on the old ones
    for(const Fan& fan : m_fans)
      add_faces(fan);
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      if(! m_is_infinite[i])
      {
        m_directions[i].push_back(m_mean_directions[i]);
        m_directions[i].push_back(- m_mean_directions[i]);
        m_sector_points[i] = m_tr.tds().create_vertex();
        if(! m_kernel_point(m_sector_points[i], m_faces[i], m_s, m_directions[i]))
          return false;
      }
    return true;
  }

  // The new triangles, with the sector on their positive side, and directions into the sector that help: the sum of the
  // unit normals; where these cancel, the mean direction of both fans, or its opposite; and the exact normals.
  void add_faces(const Fan& fan)
  {
    Vector n = CGAL::NULL_VECTOR;
    for(const Triangle& t : fan.triangles)
    {
      m_faces[fan.sectors[0]].push_back(t);
      m_faces[fan.sectors[1]].push_back({{ t[0], t[2], t[1] }});
      n += normal(t);
    }
    const double length = std::sqrt(n.squared_length());
    const Exact_vector unit_normal = length > 0 ? Exact_vector(n[0] / length, n[1] / length, n[2] / length)
                                                : Exact_vector(CGAL::NULL_VECTOR);
    const Triangle& t = fan.triangles.front();
    const Exact_point p = position(t[0]), q = position(t[1]), r = position(t[2]);
    const Exact_vector exact_normal = CGAL::cross_product(q - p, r - p);
    const Exact_vector mean = CGAL::centroid(p, q, r) - position(m_s);
    for(int side = 0; side < 2; ++side)
    {
      std::vector<Exact_vector>& directions = m_directions[fan.sectors[side]];
      directions.front() = side == 0 ? directions.front() + unit_normal : directions.front() - unit_normal;
      directions.push_back(side == 0 ? exact_normal : - exact_normal);
      m_mean_directions[fan.sectors[side]] = m_mean_directions[fan.sectors[side]] + mean;
    }
  }

  void replace_ball()
  {
    m_tetrahedra.clear();
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      for(const Triangle& t : m_faces[i])
        m_tetrahedra.push_back({{ t[0], t[1], t[2], m_is_infinite[i] ? m_tr.infinite_vertex() : m_sector_points[i] }});
    m_steiner_points.erase(m_s);
    m_replacement(m_tr, m_star, m_tetrahedra, m_visitor, std::array<Vertex_handle, 1>{{ m_s }});
    for(const Vertex_handle v : m_sector_points)
      if(v != Vertex_handle())
        m_points.push_back(v);
  }

  // The points of artificial fans need not be exactly where they are any more.
  void release_free_points()
  {
    for(const Vertex_handle v : m_free_points)
    {
      m_star.clear();
      m_tr.incident_cells(v, std::back_inserter(m_star));
      const std::vector<Triangle> faces = internal::faces_of_ball(m_star, v);
      m_points.push_back(v);
      const Exact_point exact = position(v);
      m_steiner_points.positions().erase(v);
      if(! m_kernel_point.is_kernel_point(v, faces) && ! m_kernel_point(v, faces))
        m_steiner_points.positions().set(v, exact);
    }
  }

  Tr& m_tr;
  const Predicates& m_predicates;
  const Constraints& m_constraints;
  Steiner_points& m_steiner_points;
  Visitor& m_visitor;
  Kernel_point_3<Tr> m_kernel_point;
  Cell_replacement<Tr> m_replacement;
  Vertex_handle m_s, m_p, m_q; // the Steiner point, and its neighbors on its edge
  std::vector<Cell_handle> m_star;
  std::vector<Half_facet> m_half_facets;
  std::vector<Fan> m_fans;
  Vertex_handle m_apex;
  Orientation m_apex_side;
  std::unordered_map<const void*, std::size_t> m_sector_of_cell; // look-up only
  std::vector<bool> m_is_infinite;                               // by sector; so the next three
  std::vector<std::vector<Triangle> > m_faces;
  double m_scale;
  std::vector<std::vector<Exact_vector> > m_directions;
  std::vector<Exact_vector> m_mean_directions;
  Vertices m_sector_points;
  Vertices m_free_points; // of artificial fans
  Vertices m_points;
  std::vector<Tetrahedron> m_tetrahedra;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_SPLITTING_3_H
