// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_FACET_FANS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_FACET_FANS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Origin.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// The side of a mesh facet s v w from which v and w are seen in counterclockwise order around s.
template <typename Tr>
struct Half_facet_3
{
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Cell_handle       Cell_handle;

  // The facet opposite to the vertex i of a cell that has s.
  Half_facet_3(const Vertex_handle s, const Cell_handle c, const int i)
    : cell(c), opposite(c->vertex(i))
  {
    const auto f = internal::facet_vertices(c, i);
    int k = 0;
    while(f[k] != s)
      ++k;
    v = f[(k + 1) % 3];
    w = f[(k + 2) % 3];
  }

  Vertex_handle v, w;
  Cell_handle cell;        // the one on this side
  Vertex_handle opposite;  // its fourth vertex
};

/*
 * The cells around a vertex, and the sides of all mesh facets at it. They are what they were when they were collected.
 */
template <typename Tr>
class Half_facet_star_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Cell_handle       Cell_handle;
  typedef Half_facet_3<Tr>               Half_facet;

  explicit Half_facet_star_3(const Tr& tr) : m_tr(tr) { }

  void collect(const Vertex_handle s)
  {
    m_center = s;
    m_cells.clear();
    m_half_facets.clear();
    m_tr.incident_cells(s, std::back_inserter(m_cells));
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        if(c->vertex(i) != s)
          m_half_facets.emplace_back(s, c, i);
  }

  Vertex_handle center() const { return m_center; }
  const std::vector<Cell_handle>& cells() const { return m_cells; }
  const std::vector<Half_facet>& half_facets() const { return m_half_facets; }

private:
  const Tr& m_tr;
  Vertex_handle m_center;
  std::vector<Cell_handle> m_cells;
  std::vector<Half_facet> m_half_facets;
};

/*
 * The mesh facets s v_i v_{i+1} of a planar polygon around a vertex s, and the triangles that come in their place when
 * s leaves it. The fan is closed if s is in the interior of the polygon, else s is on its boundary.
 */
template <typename Tr>
struct Facet_fan_3
{
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef Half_facet_3<Tr>                     Half_facet;
  typedef std::array<Vertex_handle, 2>         Vertex_pair;
  typedef std::array<Vertex_handle, 3>         Vertex_triple;
  typedef Simple_cartesian<double>::Vector_3   Vector;

  std::vector<Half_facet> facets;       // in their order around s, all on one side of the fan, its positive one
  bool is_closed;
  std::vector<Vertex_triple> triangles; // seen from the positive side
  Vector normal = NULL_VECTOR;          // of the triangles, approximately, and of any length

  // Whether the facet s v w is in the fan.
  bool contains(const Vertex_handle v, const Vertex_handle w) const
  {
    return std::any_of(facets.begin(), facets.end(), [&](const Half_facet& h)
    {
      return (h.v == v && h.w == w) || (h.v == w && h.w == v);
    });
  }

  // Whether v is a vertex of the polygon.
  bool has_vertex(const Vertex_handle v) const
  {
    return std::any_of(facets.begin(), facets.end(), [&](const Half_facet& h) { return h.v == v || h.w == v; });
  }

  // The vertices around s.
  std::vector<Vertex_handle> polygon() const
  {
    std::vector<Vertex_handle> result;
    for(const Half_facet& h : facets)
      result.push_back(h.v);
    if(! is_closed)
      result.push_back(facets.back().w);
    return result;
  }

  // The closed fan of these facets, which may be in any order; none if it is not closed.
  static std::optional<Facet_fan_3> closed(std::vector<Half_facet> facets)
  {
    if(facets.empty() || ! sort(facets) || facets.back().w != facets.front().v)
      return std::nullopt;
    return Facet_fan_3{ std::move(facets), true, std::vector<Vertex_triple>() };
  }

  // The open fan of these facets from one of the ends to the other, preferably from the first, if it is one.
  static std::optional<Facet_fan_3> open(std::vector<Half_facet> facets, const Vertex_pair& ends)
  {
    auto first = find(facets, 0, ends[0]);
    if(first == facets.end())
      first = find(facets, 0, ends[1]);
    if(first == facets.end())
      return std::nullopt;
    std::iter_swap(first, facets.begin());
    if(! sort(facets) || ! internal::contains(ends, facets.back().w))
      return std::nullopt;
    return Facet_fan_3{ std::move(facets), false, std::vector<Vertex_triple>() };
  }

private:
  static auto find(std::vector<Half_facet>& facets, const std::size_t from, const Vertex_handle v)
  {
    return std::find_if(facets.begin() + from, facets.end(), [&](const Half_facet& h) { return h.v == v; });
  }

  // Puts the facets in their order around s, from the first on. Returns false if each is not followed by another.
  static bool sort(std::vector<Half_facet>& facets)
  {
    for(std::size_t i = 1; i < facets.size(); ++i)
    {
      const auto next = find(facets, i, facets[i - 1].w);
      if(next == facets.end())
        return false;
      std::iter_swap(next, facets.begin() + i);
    }
    return true;
  }
};

/*
 * The fans at a Steiner point s, which cut its star into sectors: mesh facets in the plane of a constrained facet, and
 * hull facets at an edge of the hull, which are planar, for s is on a straight line or in a plane there.
 */
template <typename Tr>
class Facet_fans_3
{
public:
  typedef typename Tr::Vertex_handle                 Vertex_handle;
  typedef Vertex_predicates_3<Tr>                    Predicates;
  typedef Half_facet_star_3<Tr>                      Star;
  typedef Facet_fan_3<Tr>                            Fan;
  typedef typename Fan::Half_facet                   Half_facet;
  typedef typename Fan::Vertex_pair                  Vertex_pair;
  typedef typename Fan::Vertex_triple                Vertex_triple;
  typedef typename std::vector<Fan>::iterator        iterator;
  typedef typename std::vector<Fan>::const_iterator  const_iterator;

  Facet_fans_3(const Tr& tr, const Predicates& predicates) : m_tr(tr), m_predicates(predicates) { }

  // Forgets all the fans. Open fans that are added will go from one of the ends to the other.
  void clear(const Vertex_pair& ends = Vertex_pair())
  {
    m_ends = ends;
    m_fans.clear();
  }

  const Vertex_pair& ends() const { return m_ends; }

  // Adds the fan of the mesh facets at s between the given vertices, which are all in the plane of a triangle. Returns
  // false if they are no such fan.
  bool add_planar_fan(const Star& star, const std::vector<Vertex_handle>& vertices, const Vertex_triple& plane,
                      const bool is_closed)
  {
    std::vector<Half_facet> facets;
    for(const Half_facet& h : star.half_facets())
      if(internal::contains(vertices, h.v) && internal::contains(vertices, h.w) && is_above(h, plane))
        facets.push_back(h);
    return add(is_closed ? Fan::closed(std::move(facets)) : Fan::open(std::move(facets), m_ends));
  }

  // Adds those of the facets seen from outside the hull, from the first end to the second and from the second to the
  // first, that are not there yet. Returns false if there is something else.
  bool add_hull_fans(const Star& star)
  {
    std::vector<Half_facet> facets;
    for(const Half_facet& h : star.half_facets())
      if(m_tr.is_infinite(h.opposite))
        facets.push_back(h);
    if(facets.empty())
      return true;
    return std::all_of(m_ends.begin(), m_ends.end(), [&](const Vertex_handle start)
    {
      const std::vector<Half_facet> fan = from_end_to_end(facets, start);
      return ! fan.empty() && (contains(fan.front().v, fan.front().w) || add(Fan::open(fan, m_ends)));
    });
  }

  // Has to be called when cells around s were replaced, but no facets in fans: brings their cells up to date.
  void update(const Star& star)
  {
    for(Fan& fan : m_fans)
      for(Half_facet& g : fan.facets)
        for(const Half_facet& h : star.half_facets())
          if(h.v == g.v && h.w == g.w)
            g = h;
  }

  // Whether the facet s v w is in some fan.
  bool contains(const Vertex_handle v, const Vertex_handle w) const
  {
    return std::any_of(m_fans.begin(), m_fans.end(), [&](const Fan& fan) { return fan.contains(v, w); });
  }

  bool has_vertex(const Vertex_handle v) const
  {
    return std::any_of(m_fans.begin(), m_fans.end(), [&](const Fan& fan) { return fan.has_vertex(v); });
  }

  std::size_t size() const { return m_fans.size(); }
  iterator begin() { return m_fans.begin(); }
  iterator end() { return m_fans.end(); }
  const_iterator begin() const { return m_fans.begin(); }
  const_iterator end() const { return m_fans.end(); }

private:
  bool add(std::optional<Fan> fan)
  {
    if(fan)
      m_fans.push_back(*std::move(fan));
    return bool(fan);
  }

  // Whether the cell of a half facet in the plane of a triangle is on the positive side of it.
  bool is_above(const Half_facet& h, const Vertex_triple& plane) const
  {
    if(! m_tr.is_infinite(h.opposite))
      return m_predicates.orientation(plane[0], plane[1], plane[2], h.opposite) == POSITIVE;
    const Vertex_handle below = m_tr.mirror_vertex(h.cell, h.cell->index(h.opposite));
    return m_predicates.orientation(plane[0], plane[1], plane[2], below) == NEGATIVE;
  }

  // The facets one after the other from an end to the next end; nothing if they do not get there.
  std::vector<Half_facet> from_end_to_end(const std::vector<Half_facet>& facets, const Vertex_handle start) const
  {
    std::vector<Half_facet> result;
    for(Vertex_handle v = start; result.empty() || ! internal::contains(m_ends, v); v = result.back().w)
    {
      const auto it = std::find_if(facets.begin(), facets.end(), [&](const Half_facet& h) { return h.v == v; });
      if(it == facets.end())
        return std::vector<Half_facet>();
      result.push_back(*it);
    }
    return result;
  }

  const Tr& m_tr;
  const Predicates& m_predicates;
  Vertex_pair m_ends;
  std::vector<Fan> m_fans;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_FACET_FANS_3_H
