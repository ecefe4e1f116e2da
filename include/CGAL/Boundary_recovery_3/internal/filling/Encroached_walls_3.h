// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_ENCROACHED_WALLS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_ENCROACHED_WALLS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Box_hierarchy_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The walls of a domain that are far larger than cells are to be beside them, and what encroaches on them. Walls are
 * not divided, so all cells at such a wall, or at such an edge of one, are as long as that, and a vertex that is near
 * it makes them flat. A point *encroaches* on
 *  - a wall that is nearer than a part of its smallest height;
 *  - an edge of a wall if it sees it at an angle that is nearly straight: if it is in the *diametral lens* of the edge;
 * but on none that is farther away than `largest_clearance` sizes: beside very large walls, sizes count more than
 * angles. Nor on one that is not large compared with the size at the point: there, the distances between vertices do.
 */
class Encroached_walls_3
{
public:
  typedef std::array<Coordinates_3, 3> Corners;

  struct Wall
  {
    Corners corners; // in the order in which they are seen from inside
    double  size;    // of the cells that are to be there, at least
  };

  Encroached_walls_3() = default;

  explicit Encroached_walls_3(const std::vector<Wall>& walls)
    : m_frame(box_of(walls))
  {
    Known_edges known;
    for(const Wall& w : walls)
      add(w, known);
    build();
  }

  // Whether edges, or heights of walls, are large. What has no large edge need not be told of.
  static bool is_large(const double length, const double size) { return length > least_length * size; }

  // `size` is the one at the point.
  bool are_encroached_by(const Coordinates_3& p, const double size) const
  {
    return ! m_shapes.empty() && most_encroached(m_frame.to_frame(p), m_frame.to_frame(size)) != nullptr;
  }

  // The point itself, or, if it encroaches, where it gets to when it is moved away from one wall after the other.
  // Between walls that are near each other, there may be no good place.
  Coordinates_3 place_beside(const Coordinates_3& p, const double size) const
  {
    Coordinates_3 q = m_frame.to_frame(p);
    const double scaled_size = m_frame.to_frame(size);
    for(int step = 0; step < max_number_of_steps; ++step)
    {
      const Shape* const shape = most_encroached(q, scaled_size);
      const Coordinates_3 foot = shape == nullptr ? q : shape->triangle.nearest_point(q);
      const double distance = internal::distance(foot, q);
      if(! (distance > 0))
        return step == 0 ? p : m_frame.from_frame(q);
      q = point_between(foot, q, step_beyond * shape->clearance_for(scaled_size) / distance);
    }
    return m_frame.from_frame(q);
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr double least_length = 2;         // of large edges, and heights of large walls, in sizes
  static constexpr double clearance_of_wall = 0.15; // as a part of its smallest height
  static constexpr double cosine_of_lens = -0.9659258262890683;    // of the angle of 165 degrees,
  static constexpr double half_width_of_lens = 0.0658262487936979; // and how wide that makes it, as a part of the edge
  static constexpr double largest_clearance = 1.5;  // in sizes
  static constexpr double least_difference = 0.125; // of the ends of two edges that count, as a part of the clearance
  static constexpr int max_number_of_steps = 8;
  static constexpr double step_beyond = 1 + 1e-6;   // the clearance, in view of rounding errors

  // A wall, or an edge of one, in the unit frame.
  struct Shape
  {
    double clearance_for(const double size) const { return (std::min)(clearance, largest_clearance * size); }

    // How near a point is, as a part of the clearance, squared; at least 1 if it does not encroach.
    double squared_nearness(const Coordinates_3& p, const double size) const
    {
      if(! is_large(length, size) || (is_edge && ! is_in_lens(p)))
        return 1;
      const double limit = clearance_for(size);
      return triangle.squared_distance(p) / (limit * limit);
    }

    bool is_in_lens(const Coordinates_3& p) const
    {
      const Coordinates_3 u = difference(triangle.vertex(0), p), v = difference(triangle.vertex(1), p);
      return dot_product(u, v) < cosine_of_lens * std::sqrt(dot_product(u, u) * dot_product(v, v));
    }

    Axis_box_3 box() const
    {
      Axis_box_3 result;
      for(int i = 0; i < 3; ++i)
        result.add(triangle.vertex(i));
      for(int i = 0; i < 3; ++i)
      {
        result.lower[i] -= clearance;
        result.upper[i] += clearance;
      }
      return result;
    }

    Near_triangle_3 triangle; // an edge is one whose last vertex is the first one
    double          length;   // of the edge, or the smallest height
    double          clearance;
    bool            is_edge;
  };

  static Axis_box_3 box_of(const std::vector<Wall>& walls)
  {
    Axis_box_3 box;
    for(const Wall& w : walls)
      for(const Coordinates_3& p : w.corners)
        box.add(p);
    return box;
  }

  typedef std::set<std::array<double, 7> > Known_edges; // by the step of a grid, and the places of both ends in it

  // Whether no edge was there that is nearly the same: they would be thousands at the tip of a cone, or around a
  // cylinder, all at the same places.
  static bool is_new(const Coordinates_3& q, const Coordinates_3& r, const double clearance, Known_edges& known)
  {
    const double step = std::exp2(std::floor(std::log2(least_difference * clearance)));
    std::array<double, 7> key = {{ step }};
    for(std::size_t i = 0; i < 3; ++i)
    {
      key[1 + i] = std::floor(q[i] / step);
      key[4 + i] = std::floor(r[i] / step);
    }
    return known.insert(key).second;
  }

  // Of the two walls at an edge, which see it in different directions, one adds it.
  void add(const Wall& wall, Known_edges& known)
  {
    Corners p;
    for(std::size_t i = 0; i < 3; ++i)
      p[i] = m_frame.to_frame(wall.corners[i]);
    const double size = m_frame.to_frame(wall.size);
    const double height = smallest_height(p);
    if(is_large(height, size))
      m_shapes.push_back(Shape{ Near_triangle_3(p), height, clearance_of_wall * height, false });
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Coordinates_3& q = p[i];
      const Coordinates_3& r = p[(i + 1) % 3];
      const double length = internal::distance(q, r);
      const double clearance = half_width_of_lens * length;
      if(q < r && is_large(length, size) && is_new(q, r, clearance, known))
        m_shapes.push_back(Shape{ Near_triangle_3(Corners{{ q, r, q }}), length, clearance, true });
    }
  }

  static double smallest_height(const Corners& p)
  {
    const Coordinates_3 normal = cross_product(difference(p[1], p[0]), difference(p[2], p[0]));
    return std::sqrt(dot_product(normal, normal) / (std::max)({ squared_distance(p[0], p[1]),
                                                                squared_distance(p[1], p[2]),
                                                                squared_distance(p[2], p[0]) }));
  }

  // Brings the shapes into the order of the hierarchy.
  void build()
  {
    std::vector<Axis_box_3> boxes;
    for(const Shape& shape : m_shapes)
      boxes.push_back(shape.box());
    m_hierarchy = Box_hierarchy_3<1>(boxes);
    m_hierarchy.put_into_order(m_shapes);
  }

  // None if the point encroaches on none. In the unit frame.
  const Shape* most_encroached(const Coordinates_3& p, const double size) const
  {
    const Shape* result = nullptr;
    double smallest = 1;
    const auto is_inside = [](std::size_t, const double squared_distance) { return ! (squared_distance > 0); };
    m_hierarchy.search(p, is_inside, [&](const std::size_t k)
    {
      const double nearness = m_shapes[k].squared_nearness(p, size);
      if(nearness < smallest)
      {
        smallest = nearness;
        result = &m_shapes[k];
      }
    });
    return result;
  }

  Unit_frame_3 m_frame;
  std::vector<Shape> m_shapes;
  Box_hierarchy_3<1> m_hierarchy; // of the boxes in which points can encroach
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_ENCROACHED_WALLS_3_H
