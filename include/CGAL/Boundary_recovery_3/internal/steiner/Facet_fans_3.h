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
#include <CGAL/Boundary_recovery_3/internal/steiner/Facet_fan_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Half_facet_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The fans at a Steiner point s, which cut its ball into sectors: mesh facets in the plane of a constrained facet, and
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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_FACET_FANS_3_H
