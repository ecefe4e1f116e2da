// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_TRIANGULATE_FAN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_TRIANGULATE_FAN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Facet_fans_3.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

  // In units of the size of the ball.
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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_TRIANGULATE_FAN_3_H
