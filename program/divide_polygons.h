#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_POLYGONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_POLYGONS_H

#include "surface.h"
#include "triangulate_facet.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

// Divides the faces of a surface that are polygons into triangles, which have their numbers and patches. Polygons that
// are not flat, that cross or touch themselves, or that have holes stay as they are, so that they are refused by their
// numbers.
template <typename Point>
class Polygon_divider
{
  // polygons of one kind, by the number of the first one
  struct Kind
  {
    std::size_t number = 0, first = 0;

    void add(const std::size_t face)
    {
      if(number++ == 0)
        first = face;
    }
  };

  typedef std::vector<std::size_t> Polygon;

  Surface<Point>& m_surface;
  Surface<Point> m_divided; // faces only
  Kind m_good, m_bent, m_crossing;

public:
  explicit Polygon_divider(Surface<Point>& surface) : m_surface(surface) { }

  // Points may be as far from the plane of a polygon; by default, the rounding of single precision is allowed.
  void operator()(const bool are_bent_allowed)
  {
    if(std::all_of(m_surface.faces.begin(), m_surface.faces.end(), [](const Polygon& f) { return f.size() == 3; }))
      return;
    const double tolerance = are_bent_allowed ? (std::numeric_limits<double>::infinity)()
                                              : default_tolerance(m_surface.points);
    for(std::size_t f = 0; f < m_surface.faces.size(); ++f)
      divide(f, tolerance);
    m_surface.faces.swap(m_divided.faces);
    m_surface.file_faces.swap(m_divided.file_faces);
    m_surface.patches.swap(m_divided.patches);
    if(m_good.number > 0)
      note(m_good, "divided into triangles");
    if(m_bent.number > 0)
      note(m_bent, "not flat; --repair divides them all the same");
    if(m_crossing.number > 0)
      note(m_crossing, "with holes, or such that their edges cross or touch");
  }

private:
  void divide(const std::size_t f, const double tolerance)
  {
    const Polygon& face = m_surface.faces[f];
    const bool is_polygon = face.size() > 3 && std::all_of(face.begin(), face.end(), [&](const std::size_t v)
      { return v < m_surface.points.size() && has_finite_coordinates(m_surface.points[v]); });
    if(! is_polygon)
      return add(f, face);
    const std::vector<Polygon> polygons(1, face);
    const Facet_triangulation<Point> triangulate(m_surface.points, polygons);
    const bool is_flat = triangulate.is_flat(tolerance);
    const auto triangles = is_flat ? triangulate() : std::vector<typename Facet_triangulation<Point>::Triangle>();
    const bool is_divided = triangles.size() == face.size() - 2;
    (is_divided ? m_good : is_flat ? m_crossing : m_bent).add(m_surface.face_number(f));
    if(! is_divided)
      add(f, face);
    else
      for(const auto& t : triangles)
        add(f, Polygon(t.begin(), t.end()));
  }

  void add(const std::size_t f, const Polygon& face)
  {
    m_divided.faces.push_back(face);
    m_divided.file_faces.push_back(m_surface.file_face(f));
    m_divided.patches.push_back(m_surface.patches[f]);
  }

  void note(const Kind& kind, const std::string& what)
  {
    m_surface.notes.push_back("polygons " + what + ": " + std::to_string(kind.number) + ", the first one is face "
                              + std::to_string(kind.first));
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_POLYGONS_H
