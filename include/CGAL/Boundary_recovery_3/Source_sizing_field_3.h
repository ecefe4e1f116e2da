// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_SOURCE_SIZING_FIELD_3_H
#define CGAL_BOUNDARY_RECOVERY_3_SOURCE_SIZING_FIELD_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Size_source_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Box_hierarchy_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Boundary_recovery_3 {
namespace internal {

// The size at a distance from a source.
struct Size_around_3
{
  double size;
  double radius;
  bool is_linear;
  double rate; // the grading, or the length that doubles the size

  double at(const double distance) const
  {
    const double d = (std::max)(0., distance - radius);
    return is_linear ? size + rate * d : size * std::exp2(d / rate);
  }

  // At most the size there. The tangent of an exponential function is below it.
  double bound_at(const double distance) const
  {
    static constexpr double less_than_log_of_2 = 0.693;
    const double d = (std::max)(0., distance - radius);
    return is_linear ? size + rate * d : size * (1 + less_than_log_of_2 / rate * d);
  }

  // By how much it grows per length, as long as it is not larger than `largest`.
  double grading(const double largest) const
  {
    return is_linear ? rate : size < largest ? largest * std::log(2.) / rate : 0;
  }
};

// That of a valid source whose lengths are divided by the unit.
template <typename GT>
Size_around_3 size_around(const Size_source_3<GT>& source, const double unit)
{
  const Size_growth& growth = source.growth();
  return Size_around_3{ source.size() / unit, source.radius() / unit, growth.is_linear(),
                        growth.is_linear() ? growth.value() : (growth.value() - source.radius()) / unit };
}

// How far away sources are, at most, that make a size smaller.
class Reach_of_sources_3
{
public:
  void add(const Size_around_3& source)
  {
    Kind& kind = source.is_linear ? m_linear : m_doubling;
    kind.smallest_size = (std::min)(kind.smallest_size, source.size);
    kind.largest_radius = (std::max)(kind.largest_radius, source.radius);
    kind.longest = (std::max)(kind.longest, source.is_linear ? 1 / source.rate : source.rate);
  }

  // The square of the distance from a ball's center, with room for rounding errors; negative if no source does, however
  // near it is.
  double squared(const double size, const double radius) const
  {
    double reach = -1;
    if(m_linear.smallest_size < size)
      reach = m_linear.largest_radius + (size - m_linear.smallest_size) * m_linear.longest;
    if(m_doubling.smallest_size < size)
      reach = (std::max)(reach, m_doubling.largest_radius
                                  + std::log2(size / m_doubling.smallest_size) * m_doubling.longest);
    return reach < 0 ? reach : (reach + radius) * (reach + radius) * (1 + 1e-9);
  }

private:
  struct Kind
  {
    double smallest_size = std::numeric_limits<double>::infinity();
    double largest_radius = 0;
    double longest = 0; // the length that a size of 1 takes to grow by 1, or to double
  };

  Kind m_linear, m_doubling;
};

/*
 * The smallest size that one of many sources, or the background, has at a place. Equal sources count once.
 *
 * It can be called by several threads.
 */
template <typename GT>
class Source_minimum_3
{
public:
  typedef Size_source_3<GT>      Source;
  typedef typename Source::Shape Shape;

  // All sources are valid.
  Source_minimum_3(const std::vector<Source>& sources, const double background)
    : m_frame(box_of(sources)), m_background(m_frame.to_frame(background))
  {
    for(const Source& s : sources)
      m_places.push_back(place_of(s));
    remove_dominated(m_places);
    std::vector<Axis_box_3> boxes;
    for(const Place& place : m_places)
      boxes.push_back(place.box);
    m_hierarchy = Box_hierarchy_3<1>(boxes);
    m_hierarchy.put_into_order(m_places);
    find_reaches();
  }

  double operator()(const Coordinates_3& p) const { return m_frame.from_frame(minimum(m_frame.to_frame(p), 0)); }

  // The smallest size within a distance of p.
  double around(const Coordinates_3& p, const double radius) const
  {
    return m_frame.from_frame(minimum(m_frame.to_frame(p), m_frame.to_frame(radius)));
  }

  // By how much sizes grow per length, at most. Those that double do without bound, if there is no background.
  double grading() const
  {
    double largest = 0;
    for(const Place& place : m_places)
      largest = (std::max)(largest, place.around.grading(m_background));
    return largest;
  }

private:
  // where a source is in the unit frame, and the size around it
  struct Place
  {
    Shape shape;
    Near_triangle_3 triangle; // of the points of the source, some of which are the same unless it is a triangle
    Axis_box_3 box;
    Size_around_3 around;

    double squared_distance(const Coordinates_3& p) const
    {
      switch(shape)
      {
        case Shape::segment:  return squared_distance_to_segment(p, triangle.vertex(0), triangle.vertex(1));
        case Shape::triangle: return triangle.squared_distance(p);
        default:              return internal::squared_distance(p, box); // that of a point has no length
      }
    }
  };

  static Axis_box_3 box_of(const std::vector<Source>& sources)
  {
    Axis_box_3 box;
    for(const Source& s : sources)
      for(int i = 0; i < 3; ++i)
        box.add(coordinates_of(s.vertex(i)));
    return box;
  }

  Place place_of(const Source& s) const
  {
    std::array<Coordinates_3, 3> vertices;
    Axis_box_3 box;
    for(int i = 0; i < 3; ++i)
    {
      vertices[i] = m_frame.to_frame(coordinates_of(s.vertex(i)));
      box.add(vertices[i]);
    }
    return Place{ s.shape(), Near_triangle_3(vertices), box, size_around(s, m_frame.from_frame(1)) };
  }

  // Of sources of one shape at one place that grow in the same way, those are left out that are nowhere smaller than
  // another one. Equal ones, above all: wherever one of them is of interest, all would be.
  static void remove_dominated(std::vector<Place>& places)
  {
    const auto kind = [](const Place& p)
    {
      return std::make_tuple(p.shape, p.triangle.vertex(0), p.triangle.vertex(1), p.triangle.vertex(2),
                             p.around.is_linear, p.around.rate);
    };
    std::sort(places.begin(), places.end(), [&](const Place& p, const Place& q)
    {
      return std::make_tuple(kind(p), p.around.size, - p.around.radius)
           < std::make_tuple(kind(q), q.around.size, - q.around.radius);
    });
    const auto is_dominated = [&](const Place& p, const Place& q) // by p, which is before q
    {
      return kind(p) == kind(q) && p.around.radius >= q.around.radius;
    };
    places.erase(std::unique(places.begin(), places.end(), is_dominated), places.end());
  }

  void find_reaches()
  {
    m_reaches.resize(m_hierarchy.number_of_children());
    m_hierarchy.visit_children([&](const std::size_t child, const std::size_t first, const std::size_t last)
    {
      for(std::size_t k = first; k < last; ++k)
        m_reaches[child].add(m_places[k].around);
    });
  }

  // In the unit frame.
  double minimum(const Coordinates_3& p, const double radius) const
  {
    double smallest = m_background;
    const auto is_of_interest = [&](const std::size_t child, const double squared_distance)
    {
      return squared_distance <= m_reaches[child].squared(smallest, radius);
    };
    m_hierarchy.search(p, is_of_interest, [&](const std::size_t i) { look_at(m_places[i], p, radius, smallest); });
    return smallest;
  }

  // Makes the number smaller, if the source does.
  static void look_at(const Place& place, const Coordinates_3& p, const double radius, double& smallest)
  {
    if(! (place.around.size < smallest))
      return;
    const double distance = std::sqrt(place.squared_distance(p)) - radius;
    if(place.around.bound_at(distance) < smallest)
      smallest = (std::min)(smallest, place.around.at(distance));
  }

  Unit_frame_3 m_frame;
  double m_background; // in the unit frame
  Box_hierarchy_3<1> m_hierarchy;
  std::vector<Place> m_places;
  std::vector<Reach_of_sources_3> m_reaches; // of what is below the children of the hierarchy
};

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a size field of sources: the size at a point is the smallest size of all sources and of the background.
 *
 * Sources may be anywhere, also outside of the domain. If a source or the background is not valid, all sizes are NaN.
 * Without source and background, all sizes are infinite. No mesh can have such sizes.
 *
 * Sizes are computed in floating point numbers, and depend on the point only. Several threads may call the field at the
 * same time.
 *
 * \tparam GT the geometric traits
 *
 * \cgalModels{MeshDomainField_3}
 *
 * \sa `read_size_sources()`
 */
template <typename GT>
class Source_sizing_field_3
{
public:
  typedef double               FT;      ///< the number type of sizes
  typedef typename GT::Point_3 Point_3; ///< the point type
  typedef int                  Index;   ///< the type of the number of a region
  typedef Size_source_3<GT>    Source;  ///< the type of sources

  /*!
   * \brief makes the field of the given sources.
   *
   * \param sources the sources
   * \param background the largest size, in the unit of the coordinates; infinity: no limit
   */
  explicit Source_sizing_field_3(const std::vector<Source>& sources,
                                 const double background = std::numeric_limits<double>::infinity())
    : m_is_valid(background > 0 && std::all_of(sources.begin(), sources.end(),
                                               [](const Source& source) { return source.is_valid(); })),
      m_sizes(m_is_valid ? sources : std::vector<Source>(), background)
  { }

  /// returns whether all sources are valid, and the background is positive.
  bool is_valid() const { return m_is_valid; }

  /// returns the size at `p`.
  FT operator()(const Point_3& p) const
  {
    return m_is_valid ? m_sizes(internal::coordinates_of(p)) : std::numeric_limits<double>::quiet_NaN();
  }

  /// returns the size at `p`, which is the same for all dimensions and indices.
  template <typename AnyIndex>
  FT operator()(const Point_3& p, const int /* dimension */, const AnyIndex& /* index */) const { return (*this)(p); }

  /// returns a lower bound of the sizes within a distance `radius` of `p`: the smallest one.
  FT least_size_around(const Point_3& p, const double radius, const int /* index */) const
  {
    return m_is_valid ? m_sizes.around(internal::coordinates_of(p), radius) : std::numeric_limits<double>::quiet_NaN();
  }

  /// returns the largest growth of sizes per length; infinity if some sources double, and there is no background.
  double grading() const { return m_sizes.grading(); }

private:
  bool m_is_valid;
  internal::Source_minimum_3<GT> m_sizes;
};

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_SOURCE_SIZING_FIELD_3_H
