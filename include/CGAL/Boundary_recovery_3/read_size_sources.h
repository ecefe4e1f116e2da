// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_READ_SIZE_SOURCES_H
#define CGAL_BOUNDARY_RECOVERY_3_READ_SIZE_SOURCES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Size_source_3.h>

#include <array>
#include <cstddef>
#include <istream>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
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
 * \brief reads sources for a `Source_sizing_field_3` from a text: one source in a line, numbers and words separated by
 * blanks.
 *
 * ```
 * point    x y z                     size radius growth
 * segment  x y z  x y z              size radius growth
 * triangle x y z  x y z  x y z       size radius growth
 * box      x y z  x y z              size radius growth    # two opposite corners
 * ```
 * `growth` is either a number, by which the size grows per length beyond the radius, or the word `doubling` and the
 * distance from the source where the size has doubled, see `Size_growth`. A comment begins with `#` and ends with the
 * line. Lines may be empty. Numbers are written as in C++, with a point, whatever the locale is.
 *
 * \tparam GT the geometric traits
 *
 * \param in the stream
 * \param sources the sources are added here
 * \param message is set to what is wrong, with the number of the line, for instance `line 3: the radius is negative`
 *
 * \return whether all lines were understood, and all sources in them are valid. If not, `sources` is as before.
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

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_READ_SIZE_SOURCES_H
