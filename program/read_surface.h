#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_SURFACE_H

#include "check_ply.h"
#include "normalize_text.h"
#include "read_binary_off.h"
#include "read_faulty_soup.h"
#include "surface.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace read_surface_internal {

// A vector that refuses a size that no file of the given size can fill: what a damaged file asks for would
// exhaust the memory.
template <typename T>
struct Bounded_vector
  : public std::vector<T>
{
  std::size_t bound = 1u << 20;

  void resize(const std::size_t n)
  {
    if(n > bound)
      throw std::length_error("it announces more than it has");
    std::vector<T>::resize(n);
  }
};

typedef Bounded_vector<std::size_t> Face;

// the whole file; `false` if it cannot be read, as a directory cannot. It is opened once only: what comes through a
// pipe comes once.
inline bool read_text(const std::string& file, std::string& text)
{
  std::ifstream is(file, std::ios::binary);
  std::ostringstream os;
  if(! is || is.peek() == std::ifstream::traits_type::eof() || ! (os << is.rdbuf()))
    return false;
  text = os.str();
  return ! is.bad();
}

// as in a binary OFF file that was cut off, where CGAL takes the numbers of colors for faces
template <typename PolygonRange>
bool has_empty_face(const PolygonRange& polygons)
{
  return std::any_of(polygons.begin(), polygons.end(), [](const auto& polygon) { return polygon.empty(); });
}

// what CGAL's reader of the format says, without a word on the terminal
template <typename PointRange, typename PolygonRange>
bool read_soup_of_format(const std::string& extension, const std::string& text,
                         PointRange& points, PolygonRange& polygons)
{
  const auto silent = CGAL::parameters::verbose(false);
  std::istringstream is(text);
  if(extension == ".off")
    return CGAL::IO::read_OFF(is, points, polygons, silent);
  if(extension == ".obj")
    return CGAL::IO::read_OBJ(is, points, polygons, silent);
  CGAL::IO::set_mode(is, CGAL::IO::BINARY); // its readers find out whether it is text
  return extension == ".ply" ? CGAL::IO::read_PLY(is, points, polygons, silent)
                             : CGAL::IO::read_STL(is, points, polygons, silent);
}

// the same for any content of the file
template <typename PointRange, typename PolygonRange>
bool read_soup(const std::string& extension, const std::string& text, PointRange& points, PolygonRange& polygons)
{
  if(extension == ".stl" && text.size() < 84 && text.find("endsolid") == std::string::npos)
    return false; // CGAL takes it for an empty surface
  try
  {
    if(extension != ".off" || ! is_binary(extension, text))
      return read_soup_of_format(extension, text, points, polygons);
    return Binary_off_reader(text)(points, polygons) ||
           (read_soup_of_format(extension, text, points, polygons) && ! has_empty_face(polygons));
  }
  catch(const std::exception&) // an index or a size that the file cannot have
  {
    return false;
  }
}

} // namespace read_surface_internal

// reads a surface from an .off, .ply, .stl or .obj file; returns `false` and says why if that fails
template <typename Point>
bool read_surface(const std::string& file, Surface<Point>& surface, std::string& message)
{
  namespace internal = read_surface_internal;
  const std::string extension = lower_case_extension(file);
  if(extension != ".off" && extension != ".ply" && extension != ".stl" && extension != ".obj")
  {
    message = "unknown input format: " + file + " (known are .off, .ply, .stl, .obj)";
    return false;
  }
  std::string text;
  if(! internal::read_text(file, text))
  {
    message = "cannot read " + file;
    return false;
  }

  std::vector<std::string> notes;
  internal::normalize(extension, text, notes);

  internal::Bounded_vector<Point> points;
  internal::Bounded_vector<internal::Face> polygons;
  points.bound = polygons.bound = text.size();
  if((extension == ".ply" && ! Ply_checker(text)()) ||
     (! internal::read_soup(extension, text, points, polygons) &&
      ! internal::read_faulty_soup(extension, text, points, polygons)))
  {
    message = "cannot read " + file + ": it is damaged, truncated, or not in the format of its name";
    return false;
  }
  surface = make_surface<Point>(points, polygons);
  surface.notes = notes;
  return true;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_READ_SURFACE_H
