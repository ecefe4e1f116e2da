// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_MESH_INTERPOLATION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_MESH_INTERPOLATION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Box_hierarchy_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/distances_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Numbers at the vertices of tetrahedra, between them interpolated linearly. The tetrahedra may be any: where several
 * of them are, the smallest value wins, and those without a volume are left out. Outside of them all, the value is that
 * of the nearest point of the facets that only one of them has.
 *
 * Values are always between those of the vertices. The function is one of the place alone, and can be called by several
 * threads.
 */
class Mesh_interpolation_3
{
public:
  typedef std::array<std::size_t, 4> Tetrahedron;

  // The indices of the tetrahedra are those of points.
  Mesh_interpolation_3(const std::vector<Coordinates_3>& points, const std::vector<Tetrahedron>& tetrahedra,
                       const std::vector<double>& values)
    : m_frame(box_of(points, tetrahedra)), m_values(values)
  {
    for(const Coordinates_3& p : points)
      m_points.push_back(m_frame.to_frame(p));
    for(const Tetrahedron& t : tetrahedra)
      add(t);
    find_facets();
    m_hierarchy = order(m_tetrahedra);
    m_facet_hierarchy = order(m_facets);
  }

  // Infinity if there is no tetrahedron.
  double operator()(const Coordinates_3& p) const
  {
    const Coordinates_3 q = m_frame.to_frame(p);
    double value = value_inside(q);
    if(value == infinity)
      value = value_nearly_inside(q);
    return value == infinity ? value_outside(q) : value;
  }

private:
  typedef std::array<std::size_t, 3> Facet;
  typedef Box_hierarchy_3<1>         Hierarchy;

  // the volumes of the tetrahedra between a point and the facets opposite to the vertices, times six, and their sum
  struct Parts
  {
    std::array<double, 4> volumes;
    double sum;
  };

  static Axis_box_3 box_of(const std::vector<Coordinates_3>& points, const std::vector<Tetrahedron>& tetrahedra)
  {
    Axis_box_3 box;
    for(const Tetrahedron& t : tetrahedra)
      for(const std::size_t v : t)
        box.add(points[v]);
    return box;
  }

  // The tetrahedra that are kept are positive.
  void add(Tetrahedron t)
  {
    const double volume = parts_of(t, m_points[t[0]]).sum;
    if(volume == 0 || ! std::isfinite(volume))
      return;
    if(volume < 0)
      std::swap(t[0], t[1]);
    m_tetrahedra.push_back(t);
  }

  // The volume between p, which is the origin, and the facet of t opposite to the vertex i.
  static double part(const std::array<Coordinates_3, 4>& t, const int i)
  {
    static constexpr int facets[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    return dot_product(cross_product(t[facets[i][0]], t[facets[i][1]]), t[facets[i][2]]);
  }

  // The vertices relative to p, around which numbers are the most precise ones.
  std::array<Coordinates_3, 4> seen_from(const Coordinates_3& p, const Tetrahedron& t) const
  {
    return {{ difference(m_points[t[0]], p), difference(m_points[t[1]], p), difference(m_points[t[2]], p),
              difference(m_points[t[3]], p) }};
  }

  Parts parts_of(const Tetrahedron& t, const Coordinates_3& p) const
  {
    const std::array<Coordinates_3, 4> q = seen_from(p, t);
    const Parts parts = { {{ part(q, 0), part(q, 1), part(q, 2), part(q, 3) }}, 0 };
    return Parts{ parts.volumes, std::accumulate(parts.volumes.begin(), parts.volumes.end(), 0.) };
  }

  // Whether p is inside or on the boundary. Most tetrahedra are refused by their first facets.
  bool has_inside(const Tetrahedron& t, const Coordinates_3& p) const
  {
    const std::array<Coordinates_3, 4> q = seen_from(p, t);
    for(int i = 0; i < 4; ++i)
      if(! (part(q, i) >= 0))
        return false;
    return true;
  }

  void find_facets()
  {
    std::vector<Facet> all;
    for(const Tetrahedron& t : m_tetrahedra)
      for(int i = 0; i < 4; ++i)
      {
        Facet f = {{ t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4] }};
        std::sort(f.begin(), f.end());
        all.push_back(f);
      }
    std::sort(all.begin(), all.end());
    for(std::size_t k = 0, next; k < all.size(); k = next)
    {
      for(next = k + 1; next < all.size() && all[next] == all[k]; )
        ++next;
      if(next == k + 1)
        m_facets.push_back(all[k]);
    }
  }

  // Brings simplices into the order of a hierarchy of their boxes.
  template <typename Simplex>
  Hierarchy order(std::vector<Simplex>& simplices) const
  {
    std::vector<Axis_box_3> boxes(simplices.size());
    for(std::size_t i = 0; i < simplices.size(); ++i)
      for(const std::size_t v : simplices[i])
        boxes[i].add(m_points[v]);
    Hierarchy hierarchy(boxes);
    std::vector<Simplex> ordered;
    ordered.reserve(simplices.size());
    for(const std::size_t i : hierarchy.order())
      ordered.push_back(simplices[i]);
    simplices.swap(ordered);
    hierarchy.forget_order();
    return hierarchy;
  }

  // Visits the tetrahedra whose boxes are around p.
  template <typename Visit>
  void visit_around(const Coordinates_3& p, const Visit& visit) const
  {
    const auto is_of_interest = [](const std::size_t, const double squared_distance) { return squared_distance <= 0; };
    m_hierarchy.search(p, is_of_interest, [&](const std::size_t i) { visit(m_tetrahedra[i]); });
  }

  // Infinity if p is not in a tetrahedron.
  double value_inside(const Coordinates_3& p) const
  {
    double value = infinity;
    visit_around(p, [&](const Tetrahedron& t)
    {
      if(has_inside(t, p))
        value = (std::min)(value, interpolate(t, parts_of(t, p)));
    });
    return value;
  }

  // If p is in no tetrahedron because of rounding errors, it is in that which it is least outside of.
  double value_nearly_inside(const Coordinates_3& p) const
  {
    double value = infinity, best = - tolerance;
    visit_around(p, [&](const Tetrahedron& t)
    {
      const Parts parts = parts_of(t, p);
      const double inside = *std::min_element(parts.volumes.begin(), parts.volumes.end()) / parts.sum;
      if(! (inside >= best))
        return;
      const double here = interpolate(t, parts);
      value = inside > best ? here : (std::min)(value, here);
      best = inside;
    });
    return value;
  }

  double value_outside(const Coordinates_3& p) const
  {
    double value = infinity, nearest = infinity;
    const auto is_of_interest = [&](const std::size_t, const double squared_distance)
    {
      return squared_distance <= nearest;
    };
    m_facet_hierarchy.search(p, is_of_interest, [&](const std::size_t i)
    {
      typedef std::array<Coordinates_3, 3> Vertices;
      const Facet& f = m_facets[i];
      const Near_triangle_3 triangle(Vertices{{ m_points[f[0]], m_points[f[1]], m_points[f[2]] }});
      const double distance = triangle.squared_distance(p);
      if(! (distance <= nearest))
        return;
      const double here = weighted_sum(f, triangle.nearest(p));
      value = distance < nearest ? here : (std::min)(value, here);
      nearest = distance;
    });
    return value;
  }

  double interpolate(const Tetrahedron& t, const Parts& parts) const
  {
    std::array<double, 4> weights;
    for(int i = 0; i < 4; ++i)
      weights[i] = (std::max)(0., parts.volumes[i] / parts.sum);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
    for(double& w : weights)
      w /= sum;
    return weighted_sum(t, weights);
  }

  // The weights have the sum 1, up to rounding errors.
  template <typename Simplex, typename Weights>
  double weighted_sum(const Simplex& simplex, const Weights& weights) const
  {
    double sum = 0, smallest = m_values[simplex[0]], largest = smallest;
    for(std::size_t i = 0; i < simplex.size(); ++i)
    {
      const double value = m_values[simplex[i]];
      sum += weights[i] * value;
      smallest = (std::min)(smallest, value);
      largest = (std::max)(largest, value);
    }
    return (std::min)((std::max)(sum, smallest), largest);
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double tolerance = 1e-6; // of shares of a volume

  Unit_frame_3 m_frame;
  std::vector<double> m_values;         // of the points
  std::vector<Coordinates_3> m_points;  // in the unit frame
  std::vector<Tetrahedron> m_tetrahedra;
  std::vector<Facet> m_facets;          // those that one tetrahedron has
  Hierarchy m_hierarchy;
  Hierarchy m_facet_hierarchy;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_MESH_INTERPOLATION_3_H
