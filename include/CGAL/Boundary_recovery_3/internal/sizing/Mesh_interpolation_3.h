// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_MESH_INTERPOLATION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_MESH_INTERPOLATION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Box_hierarchy_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Numbers at the vertices of tetrahedra, between them interpolated linearly. The tetrahedra may be any: where several
 * of them are, the smallest value wins, and those without a volume are left out. Outside of them all, the value is that
 * of the nearest point of the facets that only one of them has.
 *
 * Values are always between those of the vertices. The function is one of the place alone, and can be called by several
 * threads.
 *
 * How small values get around a place is known, too: by the smallest one of the vertices of what is near, and by the
 * slope, which makes that precise where the neighborhood is small.
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
    m_least = least_values(m_hierarchy, m_tetrahedra);
    m_least_of_facets = least_values(m_facet_hierarchy, m_facets);
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

  // A number that no value within a distance of p is below.
  double least_around(const Coordinates_3& p, const double radius) const
  {
    const Coordinates_3 q = m_frame.to_frame(p);
    const double r = m_frame.to_frame(radius) + safety;
    const double least = least_inside(q, r);
    if(! m_has_hidden_boundary && ! is_near_boundary(q, r) && value_inside(q) < infinity)
      return least;
    return (std::min)(least, least_outside(q, r));
  }

private:
  typedef std::array<std::size_t, 3> Facet;
  typedef Box_hierarchy_3<1>         Hierarchy;
  typedef Parts_of_cell_3<double>    Parts;

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
    if(volume == 0 || ! std::isfinite(volume) || has_repeated_vertex(t))
      return;
    if(volume < 0)
      std::swap(t[0], t[1]);
    m_tetrahedra.push_back(t);
  }

  // The vertices relative to p.
  std::array<Coordinates_3, 4> seen_from(const Coordinates_3& p, const Tetrahedron& t) const
  {
    return {{ difference(m_points[t[0]], p), difference(m_points[t[1]], p), difference(m_points[t[2]], p),
              difference(m_points[t[3]], p) }};
  }

  Parts parts_of(const Tetrahedron& t, const Coordinates_3& p) const { return Parts(seen_from(p, t)); }

  // Whether p is inside or on the boundary. Most tetrahedra are refused by their first facets.
  bool has_inside(const Tetrahedron& t, const Coordinates_3& p) const
  {
    const std::array<Coordinates_3, 4> q = seen_from(p, t);
    for(int i = 0; i < 4; ++i)
      if(! (internal::volume_at_facet(q, i) >= 0))
        return false;
    return true;
  }

  // The order of the facets, and that of their vertices, do not depend on that of the tetrahedra.
  void find_facets()
  {
    const Tetrahedra_incidences_3 incidences(m_points.size(), m_tetrahedra);
    for(std::size_t side = 0; side < 4 * m_tetrahedra.size(); ++side)
      if(incidences.opposite(side) == incidences.none)
      {
        Facet f = incidences.facet(side);
        std::sort(f.begin(), f.end());
        m_facets.push_back(f);
      }
    std::sort(m_facets.begin(), m_facets.end());
    m_has_hidden_boundary = ! incidences.nonmanifold_facets().empty() || ! incidences.inconsistent_facets().empty();
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
    hierarchy.put_into_order(simplices);
    return hierarchy;
  }

  // The smallest one of what is below each child of a hierarchy.
  template <typename Simplex>
  std::vector<double> least_values(const Hierarchy& hierarchy, const std::vector<Simplex>& simplices) const
  {
    std::vector<double> least(hierarchy.number_of_children(), infinity);
    hierarchy.visit_children([&](const std::size_t child, const std::size_t first, const std::size_t last)
    {
      for(std::size_t k = first; k < last; ++k)
        least[child] = (std::min)(least[child], least_value(simplices[k]));
    });
    return least;
  }

  // At the vertices.
  template <typename Simplex>
  double least_value(const Simplex& simplex) const
  {
    double least = infinity;
    for(const std::size_t v : simplex)
      least = (std::min)(least, m_values[v]);
    return least;
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
      const Near_triangle_3 facet = triangle(m_facets[i]);
      const double distance = facet.squared_distance(p);
      if(! (distance <= nearest))
        return;
      const double here = weighted_sum(m_facets[i], facet.nearest(p));
      value = distance < nearest ? here : (std::min)(value, here);
      nearest = distance;
    });
    return value;
  }

  // --- around a place -----------------------------------------------------------------------------------------------

  // Of the values in tetrahedra.
  double least_inside(const Coordinates_3& p, const double radius) const
  {
    double least = infinity;
    const auto is_of_interest = [&](const std::size_t child, const double squared_distance)
    {
      return squared_distance <= radius * radius && m_least[child] < least;
    };
    m_hierarchy.search(p, is_of_interest, [&](const std::size_t i)
    {
      if(! is_apart(m_tetrahedra[i], p, radius))
        least = (std::min)(least, least_in(m_tetrahedra[i], p, radius));
    });
    return least;
  }

  // Whether a tetrahedron is farther from p than that, as the plane of a facet tells.
  bool is_apart(const Tetrahedron& t, const Coordinates_3& p, const double radius) const
  {
    const std::array<Coordinates_3, 4> q = seen_from(p, t);
    for(int i = 0; i < 4; ++i)
    {
      const auto& [a, b, c] = facets_of_cell[i];
      const double area = length(cross_product(difference(q[b], q[a]), difference(q[c], q[a])));
      const double error = safety * length(q[a]) * length(q[b]) * length(q[c]);
      if(internal::volume_at_facet(q, i) < - radius * area - error)
        return true;
    }
    return false;
  }

  // Of the values outside. Within `radius` of p, the nearest point of a facet is not farther from p than the nearest
  // one for p itself and twice the radius.
  double least_outside(const Coordinates_3& p, const double radius) const
  {
    const double reach = (distance_to_facets(p, infinity) + 2 * radius) * (1 + safety);
    double least = infinity;
    const auto is_of_interest = [&](const std::size_t child, const double squared_distance)
    {
      return squared_distance <= reach * reach && m_least_of_facets[child] < least;
    };
    m_facet_hierarchy.search(p, is_of_interest, [&](const std::size_t i)
    {
      const Coordinates_3 q = triangle(m_facets[i]).nearest_point(p);
      const double rest = reach * reach - squared_distance(p, q); // what is that near in a plane, or beside an edge
      if(! (rest < 0))
        least = (std::min)(least, least_in(m_facets[i], q, std::sqrt(rest)));
    });
    return least;
  }

  bool is_near_boundary(const Coordinates_3& p, const double radius) const
  {
    return distance_to_facets(p, radius) <= radius;
  }

  // If it is below the limit.
  double distance_to_facets(const Coordinates_3& p, const double limit) const
  {
    double nearest = limit * limit;
    const auto is_of_interest = [&](const std::size_t, const double squared_distance)
    {
      return squared_distance <= nearest;
    };
    m_facet_hierarchy.search(p, is_of_interest, [&](const std::size_t i)
    {
      nearest = (std::min)(nearest, triangle(m_facets[i]).squared_distance(p));
    });
    return std::sqrt(nearest);
  }

  Near_triangle_3 triangle(const Facet& f) const
  {
    return Near_triangle_3(std::array<Coordinates_3, 3>{{ m_points[f[0]], m_points[f[1]], m_points[f[2]] }});
  }

  // A number that no value in a simplex within a distance of p is below.
  template <typename Simplex>
  double least_in(const Simplex& simplex, const Coordinates_3& p, const double radius) const
  {
    const Slope slope = slope_in(simplex);
    const Coordinates_3 way = difference(p, m_points[simplex[0]]);
    const double far = length(way) + radius;
    const double least = m_values[simplex[0]] + dot_product(slope.gradient, way) - slope.error * far
                         - length(slope.gradient) * radius;
    return (std::max)(least_value(simplex), least); // the first one if the second one is not a number
  }

  // That of the linear function in a simplex, and by how much rounding errors may make it wrong: the more, the flatter
  // the simplex is.
  struct Slope
  {
    Coordinates_3 gradient;
    double error;
  };

  // Across a facet, there is none.
  template <typename Simplex>
  Slope slope_in(const Simplex& simplex) const
  {
    std::array<Coordinates_3, 3> edges;
    std::array<double, 3> differences = {{ 0, 0, 0 }};
    for(std::size_t k = 1; k < simplex.size(); ++k)
    {
      edges[k - 1] = difference(m_points[simplex[k]], m_points[simplex[0]]);
      differences[k - 1] = m_values[simplex[k]] - m_values[simplex[0]];
    }
    if(simplex.size() == 3)
      edges[2] = cross_product(edges[0], edges[1]);
    Slope slope = { {{ 0, 0, 0 }}, 0 };
    const double volume = dot_product(edges[0], cross_product(edges[1], edges[2]));
    for(int k = 0; k < 3; ++k)
    {
      const Coordinates_3 normal = cross_product(edges[(k + 1) % 3], edges[(k + 2) % 3]);
      for(int i = 0; i < 3; ++i)
        slope.gradient[i] += differences[k] * normal[i] / volume;
      slope.error += std::abs(differences[k]) * length(edges[(k + 1) % 3]) * length(edges[(k + 2) % 3]);
    }
    const double flatness = length(edges[0]) * length(edges[1]) * length(edges[2]) / volume;
    slope.error *= safety * std::abs(flatness / volume);
    return slope;
  }

  static double length(const Coordinates_3& v) { return std::sqrt(dot_product(v, v)); }

  // --- values -------------------------------------------------------------------------------------------------------

  double interpolate(const Tetrahedron& t, const Parts& parts) const { return weighted_sum(t, parts.coordinates()); }

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
  static constexpr double safety = 1e-13;   // for rounding errors, in the unit frame

  Unit_frame_3 m_frame;
  std::vector<double> m_values;         // of the points
  std::vector<Coordinates_3> m_points;  // in the unit frame
  std::vector<Tetrahedron> m_tetrahedra;
  std::vector<Facet> m_facets;          // those that one tetrahedron has
  Hierarchy m_hierarchy;
  Hierarchy m_facet_hierarchy;
  std::vector<double> m_least;          // at the vertices of what is below the children of the hierarchy
  std::vector<double> m_least_of_facets;
  bool m_has_hidden_boundary = false;   // of facets that several tetrahedra have, not one on each side
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_MESH_INTERPOLATION_3_H
