// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_CONE_MINIMUM_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_CONE_MINIMUM_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Box_hierarchy_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The sizes at sites, carried from there into space: at p the smallest h + g |pq| of all sites q with sizes h.
 *
 * It is a function of p alone, up to rounding errors the one with that formula, and can be called by several threads.
 */
class Cone_minimum_3
{
public:
  // a place and its size
  struct Site
  {
    Coordinates_3 point;
    double size;
  };

  Cone_minimum_3() = default;

  // Sites that change nothing are left out: what others carry to them is smaller than their own size.
  Cone_minimum_3(const std::vector<Site>& sites, const double grading)
    : m_grading(grading), m_squared_grading(grading * grading), m_frame(box_of(sites))
  {
    std::vector<Site> scaled;
    for(const Site& q : sites)
      scaled.push_back(Site{ m_frame.to_frame(q.point), m_frame.to_frame(q.size) });
    keep_smallest_at_places(scaled);
    build(scaled);
    const auto is_useless = [&](const Site& q) { return minimum(q.point, 0) < q.size; };
    scaled.erase(std::remove_if(scaled.begin(), scaled.end(), is_useless), scaled.end());
    build(scaled);
  }

  double grading() const { return m_grading; }

  // The size at p, infinity if there are no sites.
  double operator()(const Coordinates_3& p) const { return m_frame.from_frame(minimum(m_frame.to_frame(p), 0)); }

  // The smallest size within a distance of p.
  double around(const Coordinates_3& p, const double radius) const
  {
    return m_frame.from_frame(minimum(m_frame.to_frame(p), m_grading * m_frame.to_frame(radius)));
  }

private:
  static constexpr std::size_t leaf_size = 16;

  // the sites of a leaf, those that are missing in the last one with infinite sizes
  struct Leaf
  {
    std::array<double, leaf_size> x, y, z, size;
  };

  static Axis_box_3 box_of(const std::vector<Site>& sites)
  {
    Axis_box_3 box;
    for(const Site& q : sites)
      box.add(q.point);
    return box;
  }

  // Where several sites are at one place, the smallest one counts: else each question near them would look at all of
  // them. If there are none, the order stays.
  static void keep_smallest_at_places(std::vector<Site>& sites)
  {
    std::vector<Site> sorted = sites;
    std::sort(sorted.begin(), sorted.end(), [](const Site& p, const Site& q)
    {
      return p.point != q.point ? p.point < q.point : p.size < q.size;
    });
    const auto are_at_one_place = [](const Site& p, const Site& q) { return p.point == q.point; };
    sorted.erase(std::unique(sorted.begin(), sorted.end(), are_at_one_place), sorted.end());
    if(sorted.size() < sites.size())
      sites.swap(sorted);
  }

  void build(const std::vector<Site>& sites)
  {
    std::vector<Axis_box_3> boxes(sites.size());
    for(std::size_t i = 0; i < sites.size(); ++i)
      boxes[i].add(sites[i].point);
    m_hierarchy = Box_hierarchy_3<leaf_size>(boxes);
    fill_leaves(sites);
    find_smallest_sizes(sites);
    m_hierarchy.forget_order();
  }

  void fill_leaves(const std::vector<Site>& sites)
  {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    m_leaves.assign(m_hierarchy.number_of_leaves(), Leaf());
    for(std::size_t k = 0; k < m_leaves.size() * leaf_size; ++k)
    {
      Leaf& leaf = m_leaves[k / leaf_size];
      const std::size_t i = k % leaf_size;
      const Site site = k < sites.size() ? sites[m_hierarchy.order()[k]] : Site{ {{ 0, 0, 0 }}, infinity };
      leaf.x[i] = site.point[0];
      leaf.y[i] = site.point[1];
      leaf.z[i] = site.point[2];
      leaf.size[i] = site.size;
    }
  }

  void find_smallest_sizes(const std::vector<Site>& sites)
  {
    m_smallest_sizes.assign(m_hierarchy.number_of_children(), 0);
    m_hierarchy.visit_children([&](const std::size_t child, const std::size_t first, const std::size_t last)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for(std::size_t k = first; k < last; ++k)
        smallest = (std::min)(smallest, sites[m_hierarchy.order()[k]].size);
      m_smallest_sizes[child] = smallest;
    });
  }

  // In the unit frame, with all sizes by `drop` smaller, but for those of the sites. Roots are drawn only of what may
  // become the minimum: h + g d <= m if (g d)^2 <= (m - h)^2.
  double minimum(const Coordinates_3& p, const double drop) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    const auto is_of_interest = [&](const std::size_t child, const double squared_distance)
    {
      const double rest = smallest + drop - m_smallest_sizes[child];
      return rest > 0 && m_squared_grading * squared_distance <= rest * rest;
    };
    m_hierarchy.search(p, is_of_interest, [&](const std::size_t leaf) { look_at(m_leaves[leaf], p, drop, smallest); });
    return smallest;
  }

  // Makes the number m smaller, if the sites of a leaf do. That h + g d <= m is written without comparisons and roots,
  // as (g d)^2 - (m - h) |m - h| <= 0: processors compute that for several sites at once.
  void look_at(const Leaf& leaf, const Coordinates_3& p, const double drop, double& smallest) const
  {
    std::array<double, leaf_size> squares, excess;
    const double limit = smallest + drop;
    for(std::size_t i = 0; i < leaf_size; ++i)
    {
      const double x = leaf.x[i] - p[0], y = leaf.y[i] - p[1], z = leaf.z[i] - p[2];
      const double rest = limit - leaf.size[i];
      squares[i] = x * x + y * y + z * z;
      excess[i] = m_squared_grading * squares[i] - rest * std::abs(rest);
    }
    for(std::size_t i = 0; i < leaf_size; ++i)
      if(excess[i] <= 0)
        smallest = (std::min)(smallest, leaf.size[i] + (std::max)(0., m_grading * std::sqrt(squares[i]) - drop));
  }

  double m_grading = 0;
  double m_squared_grading = 0;
  Unit_frame_3 m_frame;
  Box_hierarchy_3<leaf_size> m_hierarchy;
  std::vector<double> m_smallest_sizes; // of what is below the children of the hierarchy
  std::vector<Leaf> m_leaves;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_CONE_MINIMUM_3_H
