// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_SIZE_SOURCE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_SIZE_SOURCE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// the growth of the size around a source with the distance from the source.
class Size_growth
{
public:
  /// beyond the radius `r`, the size at distance `d` is `size + grading * (d - r)`; `grading` has no unit, and may be
  /// 0.
  static Size_growth linear(const double grading) { return Size_growth(true, grading); }

  /// beyond the radius `r`, the size is \f$ size \cdot e^{\ln 2 (d - r) / (D - r)} \f$: it doubles up to the distance
  /// `D` from the source, and again with each further length of `D - r`.
  static Size_growth doubling_at(const double D) { return Size_growth(false, D); }

  /// returns whether it is linear.
  bool is_linear() const { return m_is_linear; }

  /// returns the grading, or the distance `D` of the double size.
  double value() const { return m_value; }

private:
  Size_growth(const bool is_linear, const double value) : m_is_linear(is_linear), m_value(value) { }

  bool m_is_linear;
  double m_value;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a source of a size field: a point, a segment, a triangle, or a box, around which edges have a given size.
 *
 * Up to the distance `radius`, the size is `size`; beyond, it grows. Distances are measured from the nearest point of
 * the source, and are 0 inside a box. Segments, triangles and boxes may be degenerate.
 *
 * \tparam GT the geometric traits
 */
template <typename GT>
class Size_source_3
{
public:
  typedef typename GT::Point_3 Point_3; ///< the point type

  /// the shapes of sources
  enum class Shape
  {
    point,    ///< a point
    segment,  ///< all points between two
    triangle, ///< all points between three
    box       ///< a box with sides parallel to the axes, given by two opposite corners
  };

  /// returns the name of a shape, as it is spelled in the enumeration.
  friend const char* to_string(const Shape shape)
  {
    switch(shape)
    {
      case Shape::point:    return "point";
      case Shape::segment:  return "segment";
      case Shape::triangle: return "triangle";
      case Shape::box:      return "box";
    }
    return "";
  }

  /// writes the name of a shape.
  friend std::ostream& operator<<(std::ostream& os, const Shape shape) { return os << to_string(shape); }

  /// makes a source of a point.
  static Size_source_3 point(const Point_3& p, const double size, const double radius, const Size_growth& growth)
  {
    return Size_source_3(Shape::point, {{ p, p, p }}, size, radius, growth);
  }

  /// makes a source of a segment.
  static Size_source_3 segment(const Point_3& p, const Point_3& q, const double size, const double radius,
                               const Size_growth& growth)
  {
    return Size_source_3(Shape::segment, {{ p, q, q }}, size, radius, growth);
  }

  /// makes a source of a triangle.
  static Size_source_3 triangle(const Point_3& p, const Point_3& q, const Point_3& r, const double size,
                                const double radius, const Size_growth& growth)
  {
    return Size_source_3(Shape::triangle, {{ p, q, r }}, size, radius, growth);
  }

  /// makes a source of a box; `p` and `q` are any two opposite corners.
  static Size_source_3 box(const Point_3& p, const Point_3& q, const double size, const double radius,
                           const Size_growth& growth)
  {
    return Size_source_3(Shape::box, {{ p, q, q }}, size, radius, growth);
  }

  /// returns the shape.
  Shape shape() const { return m_shape; }

  /// returns the `i`-th point of the source; for larger `i` up to 2, the last point.
  const Point_3& vertex(const int i) const { return m_points[i]; }

  /// returns the size within the radius.
  double size() const { return m_size; }

  /// returns the radius.
  double radius() const { return m_radius; }

  /// returns how the size grows beyond the radius.
  const Size_growth& growth() const { return m_growth; }

  /// returns whether all numbers are finite and valid: the size is positive, the radius is not negative, and the
  /// grading is not negative or the distance of the double size is larger than the radius.
  bool is_valid() const { return what_is_wrong()[0] == '\0'; }

  /// returns the error of an invalid source, such as `"the size is not a positive number"`, or an empty string.
  const char* what_is_wrong() const
  {
    const auto is_finite = [](const double x) { return std::abs(x) < std::numeric_limits<double>::infinity(); };
    if(! (m_size > 0 && is_finite(m_size)))
      return "the size is not a positive number";
    if(! (m_radius >= 0 && is_finite(m_radius)))
      return "the radius is negative";
    if(m_growth.is_linear() && ! (m_growth.value() >= 0 && is_finite(m_growth.value())))
      return "the growth is negative";
    if(! m_growth.is_linear() && ! (m_growth.value() > m_radius && is_finite(m_growth.value())))
      return "the distance where the size has doubled is not larger than the radius";
    return "";
  }

private:
  Size_source_3(const Shape shape, const std::array<Point_3, 3>& points, const double size, const double radius,
                const Size_growth& growth)
    : m_shape(shape), m_points(points), m_size(size), m_radius(radius), m_growth(growth)
  { }

  Shape m_shape;
  std::array<Point_3, 3> m_points;
  double m_size;
  double m_radius;
  Size_growth m_growth;
};

namespace internal {

// Reads the sources in lines of text.
template <typename GT>
class Read_size_source
{
public:
  typedef Size_source_3<GT>        Source;
  typedef typename Source::Point_3 Point_3;
  typedef typename Source::Shape   Shape;

  // Adds the source in a line, if there is one. Returns whether all is well, else the message tells what is not.
  bool operator()(const std::string& line, std::vector<Source>& sources, std::string& message)
  {
    std::istringstream words(line.substr(0, line.find('#')));
    words.imbue(std::locale::classic());
    std::string name;
    if(! (words >> name))
      return true;
    message = read(name, words, sources);
    return message.empty();
  }

private:
  std::string read(const std::string& name, std::istream& words, std::vector<Source>& sources)
  {
    static const std::array<std::string, 4> names = {{ "point", "segment", "triangle", "box" }};
    static const std::array<int, 4> numbers_of_points = {{ 1, 2, 3, 2 }};
    std::size_t shape = 0;
    while(shape < names.size() && name != names[shape])
      ++shape;
    if(shape == names.size())
      return "'" + name + "' is not a source; sources are point, segment, triangle, and box";
    if(! read_points(words, numbers_of_points[shape]) || ! (words >> m_size >> m_radius) || ! read_growth(words))
      return "a " + name + " has " + std::to_string(3 * numbers_of_points[shape])
             + " coordinates, a size, a radius, and a growth: a number, or 'doubling' and a distance";
    std::string rest;
    if(words >> rest)
      return "'" + rest + "' behind the growth";
    sources.push_back(make_source(static_cast<Shape>(shape)));
    return sources.back().what_is_wrong();
  }

  bool read_points(std::istream& words, const int n)
  {
    for(int i = 0; i < n; ++i)
    {
      double x, y, z;
      if(! (words >> x >> y >> z))
        return false;
      m_points[i] = Point_3(x, y, z);
    }
    return true;
  }

  bool read_growth(std::istream& words)
  {
    const std::istream::pos_type place = words.tellg();
    std::string word;
    m_is_linear = ! (words >> word && word == "doubling");
    if(m_is_linear)
    {
      words.clear();
      words.seekg(place);
    }
    return static_cast<bool>(words >> m_growth);
  }

  Source make_source(const Shape shape) const
  {
    const Size_growth growth = m_is_linear ? Size_growth::linear(m_growth) : Size_growth::doubling_at(m_growth);
    switch(shape)
    {
      case Shape::point:    return Source::point(m_points[0], m_size, m_radius, growth);
      case Shape::segment:  return Source::segment(m_points[0], m_points[1], m_size, m_radius, growth);
      case Shape::triangle: return Source::triangle(m_points[0], m_points[1], m_points[2], m_size, m_radius, growth);
      default:              return Source::box(m_points[0], m_points[1], m_size, m_radius, growth);
    }
  }

  std::array<Point_3, 3> m_points;
  double m_size = 0;
  double m_radius = 0;
  bool m_is_linear = true;
  double m_growth = 0;
};

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief reads sources for a `Source_sizing_field_3` from a text: one source a line, with blanks between numbers and
 * words.
 *
 * ```
 * point    x y z                     size radius growth
 * segment  x y z  x y z              size radius growth
 * triangle x y z  x y z  x y z       size radius growth
 * box      x y z  x y z              size radius growth    # two opposite corners
 * ```
 *
 * `growth` is a number, the growth of the size per length beyond the radius, or the word `doubling` and the distance of
 * the double size from the source, see `Size_growth`. A comment begins with `#` and ends with the line. Lines may be
 * empty. Numbers are written as in C++, with a decimal point in all locales.
 *
 * \tparam GT the geometric traits
 *
 * \param in the stream
 * \param sources the sources are added here
 * \param message is set to the error, with the number of the line, for instance `line 3: the radius is negative`
 *
 * \return whether all lines were understood, and all their sources are valid. Otherwise, `sources` is unchanged.
 */
template <typename GT>
bool read_size_sources(std::istream& in, std::vector<Size_source_3<GT> >& sources, std::string& message)
{
  std::vector<Size_source_3<GT> > found;
  internal::Read_size_source<GT> read;
  std::string line, error;
  std::size_t number = 1;
  for(; std::getline(in, line); ++number)
    if(! read(line, found, error))
    {
      message = "line " + std::to_string(number) + ": " + error;
      return false;
    }
  if(in.bad() || ! in.eof())
  {
    message = "line " + std::to_string(number) + ": it cannot be read";
    return false;
  }
  sources.insert(sources.end(), found.begin(), found.end());
  return true;
}

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_SIZE_SOURCE_3_H
