#ifndef BOUNDARY_RECOVERY_3_PROGRAM_READ_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_READ_SURFACE_H

#include "check_ply.h"
#include "lower_case.h"
#include "normalize_text.h"
#include "polygon_soup.h"
#include "read_binary_off.h"
#include "read_faulty_soup.h"
#include "read_gmsh.h"
#include "read_medit.h"
#include "read_names.h"
#include "read_poly.h"
#include "surface.h"
#include "word_reader.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace read_surface_internal {

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

constexpr const char* known_input_formats = ".off, .ply, .stl, .obj, .msh, .msh2, .mesh, .poly, .smesh";

inline bool is_format_of_cgal(const std::string& extension)
{
  return extension == ".off" || extension == ".ply" || extension == ".stl" || extension == ".obj";
}

inline bool is_input_format(const std::string& extension)
{
  return is_format_of_cgal(extension) || extension == ".msh" || extension == ".msh2" || extension == ".mesh" ||
         extension == ".poly" || extension == ".smesh";
}

// reads what CGAL reads, and the names of faces; returns `false` if that fails
template <typename Point>
bool read_soup_with_names(const std::string& extension, std::string& text, Polygon_soup<Point>& soup)
{
  namespace internal = read_surface_internal;
  internal::normalize(extension, text, soup.notes);
  soup.points.bound = soup.polygons.bound = text.size();
  Ply_checker check_ply(text);
  if((extension == ".ply" && ! check_ply()) ||
     (! internal::read_soup(extension, text, soup.points, soup.polygons) &&
      ! internal::read_faulty_soup(extension, text, soup.points, soup.polygons)))
    return false;
  if(extension == ".ply")
    soup.set_patches_by_numbers(check_ply.patches(soup.notes), false);
  else if(extension == ".stl" && ! internal::is_binary(extension, text))
    internal::read_names_of_solids(text, soup);
  else if(extension == ".obj")
  {
    soup.first_number = 1;
    internal::Obj_name_reader<Point> read_names(soup);
    read_names(text);
  }
  return true;
}

// reads what meshers write; throws `Unreadable` if that fails
template <typename Point>
Polygon_soup<Point> read_soup_of_mesher(const std::string& extension, const std::string& file, const std::string& text)
{
  if(extension == ".msh" || extension == ".msh2")
    return Gmsh_reader<Point>(text)();
  if(extension == ".mesh")
    return Medit_reader<Point>(text)();
  std::string nodes;
  read_surface_internal::read_text(std::filesystem::path(file).replace_extension(".node").string(), nodes);
  return Poly_reader<Point>()(text, nodes, extension == ".smesh");
}

// makes a surface of what was read
template <typename Point>
Surface<Point> make_surface(Polygon_soup<Point>& soup)
{
  Surface<Point> surface = make_surface<Point>(soup.points, soup.polygons);
  if(! soup.positions.empty())
    surface.file_faces.swap(soup.positions);
  if(! soup.patches.empty())
    surface.patches.swap(soup.patches);
  static_cast<Surface_notes<Point>&>(surface) = std::move(soup);
  return surface;
}

// reads a surface; returns `false` and says why if that fails
template <typename Point>
bool read_surface(const std::string& file, Surface<Point>& surface, std::string& message)
{
  const std::string extension = lower_case_extension(file);
  std::string text;
  if(! is_input_format(extension))
    message = "unknown input format: " + file + " (known are " + known_input_formats + ')';
  else if(! read_surface_internal::read_text(file, text))
    message = "cannot read " + file;
  if(! message.empty())
    return false;

  Polygon_soup<Point> soup;
  try
  {
    if(! is_format_of_cgal(extension))
      soup = read_soup_of_mesher<Point>(extension, file, text);
    else if(! read_soup_with_names(extension, text, soup))
      throw Unreadable("it is damaged, truncated, or not in the format of its name");
  }
  catch(const Unreadable& reason)
  {
    message = "cannot read " + file + ": " + reason.what();
    return false;
  }
  surface = make_surface(soup);
  return true;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_READ_SURFACE_H
