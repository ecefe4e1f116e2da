#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REMESH_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REMESH_SURFACE_H

#include "find_intersections.h"
#include "reference_surface.h"
#include "remesh_triangles.h"
#include "surface.h"
#include "surface_features.h"
#include "triangle_complex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// What a remeshing changed.
struct Remeshing_changes
{
  bool is_possible = false;       // the surface is valid
  bool is_remeshed = false;       // and so is the new one
  double tolerance = 0;           // how far from each other the surfaces may be
  double largest_edge = 0;        // how long edges may be
  std::array<std::size_t, 2> number_of_triangles = {{ 0, 0 }}; // before and after
  std::array<double, 2> smallest_angle = {{ 0, 0 }};           // of the triangles, in degrees, before and after
  std::array<double, 2> distances = {{ 0, 0 }};                // from the new surface to the old one, and back
  std::size_t number_of_attempts = 0;
  std::size_t number_of_kept_triangles = 0;                    // as anything else would intersect or be too far away
};

// Replaces the triangles of a surface by those of `Triangle_remesher`. The new surface is judged as a whole: where it
// intersects itself or is too far from the old one, the remeshing begins anew with a smaller tolerance, and with none in
// the end, by which the old triangles stay there.
template <typename Point>
class Surface_remesher
{
  typedef Reference_surface::Complex  Complex;
  typedef Reference_surface::Triangle Triangle;
  typedef Complex::Index              Index;
  typedef Reference_surface::Patches  Patches;

  static constexpr std::size_t max_number_of_attempts = 8;
  static constexpr double share_of_diagonal = 1e-3; // of the bounding box: the tolerance
  static constexpr double margin = 0.7;             // what is aimed at, in terms of the tolerance
  static constexpr double largest_share = 0.1;      // of the diagonal: the edges, if nobody says how long they may be

  Surface<Point>& m_surface;
  Remeshing_changes m_changes;
  double m_diagonal = 0;

public:
  explicit Surface_remesher(Surface<Point>& surface) : m_surface(surface) { }

  // Edges above `angle` degrees stay. Edges are not longer than `largest_edge`, if that is positive.
  Remeshing_changes operator()(const double angle, const double largest_edge)
  {
    m_changes.number_of_triangles = {{ m_surface.faces.size(), m_surface.faces.size() }};
    m_changes.is_possible = is_triangle_soup(m_surface) && ! m_surface.faces.empty() &&
                            diagnose(m_surface.points, m_surface.faces).number_of_defects == 0;
    if(! m_changes.is_possible)
      return m_changes;
    Complex complex = make_complex();
    m_diagonal = diagonal(complex.points);
    m_changes.tolerance = share_of_diagonal * m_diagonal;
    m_changes.largest_edge = largest_edge > 0 ? largest_edge : largest_share * m_diagonal;
    m_changes.smallest_angle.fill(smallest_angle(complex));
    const auto numbers = Feature_marker<Complex>(complex, m_surface.patches, angle)();
    Reference_surface reference(complex, numbers, margin * m_changes.tolerance);
    while(! m_changes.is_remeshed && m_changes.number_of_attempts < max_number_of_attempts)
      attempt(reference, numbers[0]);
    return m_changes;
  }

private:
  Complex make_complex() const
  {
    Complex complex;
    for(const Point& p : m_surface.points)
      complex.add_vertex(Reference_surface::Point(p.x(), p.y(), p.z()), Complex::Kind::free);
    for(const auto& f : m_surface.faces)
    {
      typename Complex::Face face;
      face.vertices = {{ f[0], f[1], f[2] }};
      complex.add_face(face);
    }
    return complex;
  }

  static double diagonal(const std::vector<Reference_surface::Point>& points)
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
    return std::hypot(box.x_span(), box.y_span(), box.z_span());
  }

  static double smallest_angle(const Complex& complex)
  {
    double angle = 180;
    for(const Triangle& t : Reference_surface::triangles(complex))
      for(int i = 0; i < 3; ++i)
        angle = (std::min)(angle, angle_between(t[i + 1] - t[i], t[i + 2] - t[i]));
    return angle;
  }

  void attempt(Reference_surface& reference, const std::size_t number_of_patches)
  {
    ++m_changes.number_of_attempts;
    Complex complex = reference.complex();
    Triangle_remesher(complex, reference, m_changes.largest_edge, margin * m_changes.tolerance)();
    const Surface<Point> remeshed = make_surface_of(complex, reference);
    std::vector<Index> bad = intersecting_faces(remeshed, complex, reference);
    const Patches patches(Reference_surface::triangles(complex), Reference_surface::groups(complex), number_of_patches);
    m_changes.distances = {{ 0, 0 }};
    measure_to_reference(complex, reference, bad);
    measure_from_reference(patches, reference, bad);
    if(! bad.empty())
    {
      std::sort(bad.begin(), bad.end());
      bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
      reference.tighten(bad);
      return;
    }
    m_changes.is_remeshed = true;
    m_changes.number_of_triangles[1] = remeshed.faces.size();
    m_changes.smallest_angle[1] = smallest_angle(complex);
    m_changes.number_of_kept_triangles = reference.number_of_frozen_faces();
    store(remeshed);
  }

  // The vertices that are where they were keep their numbers in the file.
  Surface<Point> make_surface_of(const Complex& complex, const Reference_surface& reference) const
  {
    std::vector<Point> points;
    std::vector<std::array<std::size_t, 3> > faces;
    for(const auto& p : complex.points)
      points.emplace_back(p.x(), p.y(), p.z());
    for(const auto& face : complex.faces)
      if(! face.is_removed)
        faces.push_back(face.vertices);
    Surface<Point> result = make_surface(points, faces);
    const std::size_t n = m_surface.points.size();
    std::size_t number_of_new_vertices = 0;
    for(std::size_t i = 0; i < result.points.size(); ++i)
    {
      const std::size_t v = result.file_vertices[i];
      result.file_vertices[i] = v < n && points[v] == m_surface.points[v]
                                  ? m_surface.file_vertex(v)
                                  : m_surface.file_vertex(n + number_of_new_vertices++);
    }
    const std::vector<Index> sources = sources_of(complex, reference);
    for(std::size_t i = 0; i < sources.size(); ++i)
    {
      result.file_faces[i] = m_surface.file_face(sources[i]);
      result.patches[i] = m_surface.patches[sources[i]];
    }
    return result;
  }

  // the face below the middle of each triangle
  static std::vector<Index> sources_of(const Complex& complex, const Reference_surface& reference)
  {
    std::vector<Index> result;
    for(const auto& face : complex.faces)
      if(! face.is_removed)
      {
        const auto& v = face.vertices;
        const auto& p = complex.points;
        result.push_back(reference.closest_in_patch(CGAL::centroid(p[v[0]], p[v[1]], p[v[2]]), face.patch).number);
      }
    return result;
  }

  static std::vector<Index> intersecting_faces(const Surface<Point>& surface, const Complex& complex,
                                               const Reference_surface& reference)
  {
    const auto result = diagnose(surface.points, surface.faces);
    std::vector<Index> faces;
    if(result.number_of_defects == 0)
      return faces;
    const std::vector<Index> sources = sources_of(complex, reference);
    for(const auto& defect : result.defects)
      for(const auto& simplex : defect.simplices)
        if(simplex.dimension == 2 && simplex.index < sources.size())
          faces.push_back(sources[simplex.index]);
    return faces;
  }

  // calls a function for points of a triangle that are hardly farther from each other than `spacing`
  template <typename Function>
  static void for_samples(const Triangle& t, const double spacing, const Function& f)
  {
    static constexpr double max_number = 64;
    const double length = std::sqrt((std::max)({ CGAL::squared_distance(t[0], t[1]), CGAL::squared_distance(t[1], t[2]),
                                                 CGAL::squared_distance(t[2], t[0]) }));
    const int n = static_cast<int>((std::max)(2., (std::min)(max_number, std::ceil(length / spacing))));
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
        f(t[0] + (double(i) / n) * (t[1] - t[0]) + (double(j) / n) * (t[2] - t[0]));
  }

  double spacing() const { return 5 * m_changes.tolerance; }

  void measure_to_reference(const Complex& complex, const Reference_surface& reference, std::vector<Index>& bad)
  {
    for(const auto& face : complex.faces)
    {
      if(face.is_removed)
        continue;
      const auto& v = face.vertices;
      for_samples(Triangle(complex.points[v[0]], complex.points[v[1]], complex.points[v[2]]), spacing(),
                  [&](const Reference_surface::Point& p)
      {
        const auto below = reference.closest_in_patch(p, face.patch);
        note_distance(p, below.point, below.number, 0, bad);
      });
    }
  }

  void measure_from_reference(const Patches& patches, const Reference_surface& reference, std::vector<Index>& bad)
  {
    const std::vector<Triangle> triangles = Reference_surface::triangles(reference.complex());
    for(Index f = 0; f < triangles.size(); ++f)
      for_samples(triangles[f], spacing(), [&](const Reference_surface::Point& p)
      {
        note_distance(p, patches(p, reference.complex().faces[f].patch).point, f, 1, bad);
      });
  }

  void note_distance(const Reference_surface::Point& p, const Reference_surface::Point& q, const Index face,
                     const int direction, std::vector<Index>& bad)
  {
    const double d = std::sqrt(CGAL::squared_distance(p, q));
    m_changes.distances[direction] = (std::max)(m_changes.distances[direction], d);
    if(d > m_changes.tolerance)
      bad.push_back(face);
  }

  void store(const Surface<Point>& remeshed)
  {
    m_surface.points = remeshed.points;
    m_surface.faces = remeshed.faces;
    m_surface.file_faces = remeshed.file_faces;
    m_surface.file_vertices = remeshed.file_vertices;
    m_surface.patches = remeshed.patches;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_REMESH_SURFACE_H
