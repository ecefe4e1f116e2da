#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_FAULTY_SOUP_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_FAULTY_SOUP_H

#include <CGAL/IO/polygon_soup_io.h>

#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <limits>
#include <sstream>
#include <string>

// CGAL's readers refuse some files that are complete, but say nonsense: coordinates that are not finite, indices out of
// range. `recover_boundary()` can tell which vertex or face is at fault, so such files are read here, after
// CGAL's reader refused them.

namespace read_surface_internal {

// stands for a coordinate that is not finite while CGAL reads
constexpr double not_finite = (std::numeric_limits<double>::max)();

inline bool is_not_finite(const std::string& token)
{
  char* end = nullptr;
  const double x = std::strtod(token.c_str(), &end);
  return ! token.empty() && *end == '\0' && ! std::isfinite(x);
}

// a copy of the text with a number that CGAL reads in place of each word like `nan`, `-inf` or `1e999`
inline std::string replace_non_finite_words(const std::string& text)
{
  std::ostringstream number;
  number.precision(17);
  number << not_finite;
  std::string result, word;
  for(std::size_t i = 0; i <= text.size(); ++i)
  {
    if(i < text.size() && ! std::isspace(static_cast<unsigned char>(text[i])))
    {
      word += text[i];
      continue;
    }
    result += is_not_finite(word) ? number.str() : word;
    word.clear();
    if(i < text.size())
      result += text[i];
  }
  return result;
}

template <typename PointRange>
void restore_non_finite_coordinates(PointRange& points)
{
  typedef typename PointRange::value_type Point;
  const auto restore = [](const double x)
  { return x == not_finite ? std::numeric_limits<double>::quiet_NaN() : x; };
  for(Point& p : points)
    p = Point(restore(p.x()), restore(p.y()), restore(p.z()));
}

// a number of a list of vertices, which may be negative; `false` if the word is no integer
inline bool read_index(std::istream& is, std::size_t& index)
{
  long long i = 0;
  if(! (is >> i))
    return false;
  index = static_cast<std::size_t>(i); // -1 is as much out of range as the largest number
  return true;
}

// an OFF file without colors and the like, whatever its indices are; CGAL's reader stops at an index out of range
template <typename PointRange, typename PolygonRange>
bool read_OFF_with_any_index(std::istream& is, PointRange& points, PolygonRange& polygons)
{
  typedef typename PointRange::value_type Point;
  std::string keyword;
  std::size_t number_of_vertices = 0, number_of_faces = 0, number_of_edges = 0;
  if(! (is >> keyword >> number_of_vertices >> number_of_faces >> number_of_edges) || keyword != "OFF")
    return false;
  points.resize(number_of_vertices);
  polygons.resize(number_of_faces);
  for(Point& p : points)
  {
    double x, y, z;
    if(! (is >> x >> y >> z))
      return false;
    p = Point(x, y, z);
  }
  for(auto& polygon : polygons)
  {
    std::size_t degree = 0;
    if(! (is >> degree))
      return false;
    polygon.resize(degree);
    for(std::size_t& index : polygon)
      if(! read_index(is, index))
        return false;
    std::string rest_of_line;
    std::getline(is, rest_of_line);
  }
  return true;
}

inline std::string without_comments(const std::string& text)
{
  std::string result;
  bool in_comment = false;
  for(const char c : text)
  {
    in_comment = c != '\n' && (in_comment || c == '#');
    if(! in_comment)
      result += c;
  }
  return result;
}

// an OBJ file; CGAL's reader refuses most indices out of range, but only when it has seen the last line
template <typename PointRange, typename PolygonRange>
bool read_OBJ_with_any_index(std::istream& is, PointRange& points, PolygonRange& polygons)
{
  return CGAL::IO::read_OBJ(is, points, polygons) || (is.eof() && ! points.empty() && ! polygons.empty());
}

// reads a text file with coordinates that are not finite or with indices out of range
template <typename PointRange, typename PolygonRange>
bool read_faulty_soup(const std::string& extension, const std::string& text,
                      PointRange& points, PolygonRange& polygons)
{
  if(text.find('\0') != std::string::npos) // a binary file: CGAL's reader takes every number in it
    return false;
  const std::string finite = replace_non_finite_words(text);
  if(finite == text && extension != ".off" && extension != ".obj")
    return false;

  points.clear();
  polygons.clear();
  bool good = false;
  try
  {
    std::istringstream is(extension == ".off" ? without_comments(finite) : finite);
    good = extension == ".off" ? read_OFF_with_any_index(is, points, polygons)
         : extension == ".obj" ? read_OBJ_with_any_index(is, points, polygons)
         : extension == ".ply" ? CGAL::IO::read_PLY(is, points, polygons, CGAL::parameters::verbose(false))
                               : CGAL::IO::read_STL(is, points, polygons, CGAL::parameters::verbose(false));
  }
  catch(const std::exception&)
  { }
  restore_non_finite_coordinates(points);
  return good;
}

} // namespace read_surface_internal

#endif // BOUNDARY_RECOVERY_3_PROGRAM_READ_FAULTY_SOUP_H
