#ifndef BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

// a place, and the name of what is there
template <typename Point>
struct Named_place
{
  std::string name;
  Point place;
};

// What a file tells of its surface, beside points and faces.
template <typename Point>
struct Surface_notes
{
  std::size_t first_number = 0;             // of vertices and faces, as the format counts
  std::map<int, std::string> patch_names;   // of those patches that have one
  std::vector<Named_place<Point> > regions; // places in regions that have names
  std::vector<Point> voids;                 // places in regions that are to be empty
  std::vector<std::string> notes;           // what the user has to know about the file
};

// A triangulated surface: the vertices that its faces use, each point once, and the faces as triples of indices.
// The faces keep the order of the file; the vertices too, but their numbers change, so the old ones are kept.
//
// Patches are sets of faces that have a name or a number of their own, from 1; 0 is for faces that are in none.
template <typename Point>
struct Surface
  : public Surface_notes<Point>
{
  static constexpr std::size_t no_face = static_cast<std::size_t>(-1); // of a triangle that is not from the file

  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > faces;
  std::vector<std::size_t> file_faces;         // the position in the file of each face, of which it may be a part;
                                               // or `no_face`
  std::vector<std::size_t> file_vertices;      // the position in the file of each point, the first one of equal points
  std::size_t number_of_vertices_in_file = 0;
  std::vector<int> patches;                    // of each face

  // the position in the file of a face; of a face that does not exist there is none
  std::size_t file_face(const std::size_t f) const { return f < file_faces.size() ? file_faces[f] : f; }

  // the position in the file of a vertex that a face names, whether it exists or not
  std::size_t file_vertex(const std::size_t v) const
  {
    return v < points.size() ? file_vertices[v] : number_of_vertices_in_file + (v - points.size());
  }

  // the same as messages and files tell it
  std::size_t face_number(const std::size_t f) const { return number(file_face(f)); }
  std::size_t vertex_number(const std::size_t v) const { return number(file_vertex(v)); }

  bool has_patches() const
  {
    return std::any_of(patches.begin(), patches.end(), [](const int patch) { return patch != 0; });
  }

private:
  std::size_t number(const std::size_t position) const
  {
    return position == no_face ? no_face : position + this->first_number;
  }
};

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

// makes a surface of a polygon soup: merges equal points, as STL needs it, and drops vertices that no face uses
template <typename Point, typename PolygonRange>
Surface<Point> make_surface(const std::vector<Point>& points, const PolygonRange& polygons)
{
  const std::vector<std::size_t> first = first_at_same_point(points);
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
    surface.patches.push_back(0);
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
                     [](const Point& p) { return has_finite_coordinates(p); }) &&
         std::all_of(surface.faces.begin(), surface.faces.end(), [&](const auto& face)
                     { return face.size() == 3 && *std::max_element(face.begin(), face.end()) < n; });
}

// The angle in degrees that sharp edges differ from 180 by, at least, if nobody says another one.
constexpr double default_patch_angle = 40;

// four units in the last place that single precision has for the largest coordinate
template <typename Point>
double default_tolerance(const std::vector<Point>& points)
{
  double largest = 0;
  for(const Point& p : points)
    for(int i = 0; i < 3; ++i)
      largest = (std::max)(largest, std::abs(p[i]));
  return 4 * double(std::numeric_limits<float>::epsilon()) * largest;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_SURFACE_H
