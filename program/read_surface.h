#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_SURFACE_H

#include "check_ply.h"
#include "normalize_text.h"
#include "read_binary_off.h"
#include "read_faulty_soup.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// A triangulated surface: the vertices that its faces use, each point once, and the faces as triples of indices.
// The faces keep the order of the file; the vertices too, but their numbers change, so the old ones are kept.
template <typename Point>
struct Surface
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > faces;
  std::vector<std::size_t> file_faces;         // the number in the file of each face, of which it may be a part
  std::vector<std::size_t> file_vertices;      // the number in the file of each point, the first one of equal points
  std::size_t number_of_vertices_in_file = 0;
  std::vector<std::string> notes;              // what the user has to know about the file

  // the number in the file of a face; of a face that does not exist there is none
  std::size_t file_face(const std::size_t f) const { return f < file_faces.size() ? file_faces[f] : f; }

  // the number in the file of a vertex that a face names, whether it exists or not
  std::size_t file_vertex(const std::size_t v) const
  {
    return v < points.size() ? file_vertices[v] : number_of_vertices_in_file + (v - points.size());
  }
};

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

inline std::string lower_case_extension(const std::string& file)
{
  const std::size_t dot = file.rfind('.');
  return dot == std::string::npos ? std::string() : lower_case(file.substr(dot));
}

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

// equal points are searched among finite ones only: NaN has no place in an order
template <typename Point>
bool has_finite_coordinates(const Point& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

template <typename Point>
bool is_lexicographically_smaller(const Point& p, const Point& q)
{
  if(p.x() != q.x()) return p.x() < q.x();
  if(p.y() != q.y()) return p.y() < q.y();
  return p.z() < q.z();
}

// for each vertex the first vertex at the same point, or the vertex itself
template <typename Point>
std::vector<std::size_t> first_at_same_point(const std::vector<Point>& points)
{
  std::vector<std::size_t> order, first(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    first[i] = i;
    if(has_finite_coordinates(points[i]))
      order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t i, const std::size_t j)
                   { return is_lexicographically_smaller(points[i], points[j]); });
  for(std::size_t k = 1; k < order.size(); ++k)
    if(! is_lexicographically_smaller(points[order[k - 1]], points[order[k]]))
      first[order[k]] = first[order[k - 1]];
  return first;
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

// makes a surface of a polygon soup: merges equal points, as STL needs it, and drops vertices that no face uses
template <typename Point, typename PolygonRange>
Surface<Point> make_surface(const std::vector<Point>& points, const PolygonRange& polygons)
{
  const std::vector<std::size_t> first = read_surface_internal::first_at_same_point(points);
  std::vector<bool> is_used(points.size(), false);
  for(const auto& polygon : polygons)
    for(const std::size_t v : polygon)
      if(v < points.size())
        is_used[first[v]] = true;

  Surface<Point> surface;
  surface.number_of_vertices_in_file = points.size();
  std::vector<std::size_t> number(points.size());
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    if(! is_used[v])
      continue;
    number[v] = surface.points.size();
    surface.points.push_back(points[v]);
    surface.file_vertices.push_back(v);
  }
  for(const auto& polygon : polygons)
  {
    surface.file_faces.push_back(surface.faces.size());
    surface.faces.emplace_back();
    for(const std::size_t v : polygon) // an index that is out of range stays so, see `Surface::file_vertex()`
      surface.faces.back().push_back(v < points.size() ? number[first[v]]
                                                       : surface.points.size() + (v - points.size()));
  }
  return surface;
}

// whether all faces are triangles with points that have coordinates: nothing else can be said without the recovery
template <typename Point>
bool is_triangle_soup(const Surface<Point>& surface)
{
  const std::size_t n = surface.points.size();
  return std::all_of(surface.points.begin(), surface.points.end(),
                     [](const Point& p) { return read_surface_internal::has_finite_coordinates(p); }) &&
         std::all_of(surface.faces.begin(), surface.faces.end(), [&](const auto& face)
                     { return face.size() == 3 && *std::max_element(face.begin(), face.end()) < n; });
}

// reads a surface from an .off, .ply, .stl or .obj file; returns `false` and says why if that fails
template <typename Point>
bool read_surface(const std::string& file, Surface<Point>& surface, std::string& message)
{
  namespace internal = read_surface_internal;
  const std::string extension = internal::lower_case_extension(file);
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
