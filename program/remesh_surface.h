#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REMESH_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REMESH_SURFACE_H

#include "find_intersections.h"
#include "reference_surface.h"
#include "remesh_triangles.h"
#include "remove_details.h"
#include "surface.h"
#include "surface_changes.h"
#include "surface_features.h"
#include "triangle_complex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Replaces the triangles of a surface by those of `Triangle_remesher`. The new surface is judged as a whole: where it
// intersects itself or is too far from the old one, the remeshing begins anew with a smaller tolerance, and with none
// in the end, by which the old triangles stay there.
template <typename Point>
class Surface_remesher
{
  typedef Reference_surface::Complex  Complex;
  typedef Reference_surface::Triangle Triangle;
  typedef Complex::Index              Index;
  typedef Reference_surface::Patches  Patches;

  static constexpr std::size_t max_number_of_attempts = 8, max_number_of_triangles = 10000000;
  static constexpr double share_of_diagonal = 1e-3; // of the bounding box: the tolerance
  static constexpr double detail = 0.25;            // what is too small to be kept, in terms of the tolerance
  static constexpr double margin = 0.6;             // what is aimed at after that
  static constexpr double tighter = 1. / 8;         // the share of that where it was not enough
  static constexpr double smallest_size = 0.5;      // of edges, in terms of the tolerance
  static constexpr double largest_share = 0.1;      // of the diagonal: the edges, if nobody says how long they may be

  Surface<Point>& m_surface;
  Remeshing_changes m_changes;
  Complex m_original;
  std::vector<double> m_tolerances;                 // of the faces

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
    m_original = make_complex();
    const double length = diagonal(m_original.points);
    m_changes.tolerance = share_of_diagonal * length;
    m_changes.largest_edge = largest_edge > 0 ? largest_edge : largest_share * length;
    m_changes.smallest_angle.fill(smallest_angle(m_original));
    const double smallest_area = m_changes.largest_edge * m_changes.largest_edge / 4;
    m_changes.is_too_fine = area() > smallest_area * double(max_number_of_triangles);
    if(m_changes.is_too_fine)
      return m_changes;
    m_tolerances.assign(m_original.faces.size(), margin * m_changes.tolerance);
    while(! m_changes.is_remeshed && m_changes.number_of_attempts < max_number_of_attempts)
      attempt(angle);
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
      face.source = complex.faces.size();
      complex.add_face(face);
    }
    return complex;
  }

  static double diagonal(const std::vector<Reference_surface::Point>& points)
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
    return std::hypot(box.x_span(), box.y_span(), box.z_span());
  }

  double area() const
  {
    double sum = 0;
    for(const Triangle& t : Reference_surface::triangles(m_original))
      sum += std::sqrt(t.squared_area());
    return sum;
  }

  static double smallest_angle(const Complex& complex)
  {
    double angle = 180;
    for(const Triangle& t : Reference_surface::triangles(complex))
      for(int i = 0; i < 3; ++i)
        angle = (std::min)(angle, angle_between(t[i + 1] - t[i], t[i + 2] - t[i]));
    return angle;
  }

  void attempt(const double angle)
  {
    ++m_changes.number_of_attempts;
    const Complex complex = remesh(angle);
    const Surface<Point> remeshed = make_surface_of(complex);
    std::vector<Index> bad = intersecting_faces(remeshed, complex);
    m_changes.distances = {{ 0, 0 }};
    measure(complex, m_original, 0, bad);
    measure(m_original, complex, 1, bad);
    if(! bad.empty())
      return tighten(bad);
    m_changes.is_remeshed = true;
    m_changes.number_of_triangles[1] = remeshed.faces.size();
    m_changes.smallest_angle[1] = smallest_angle(complex);
    m_changes.number_of_kept_triangles = std::count(m_tolerances.begin(), m_tolerances.end(), 0.);
    store(remeshed);
  }

  // the triangles know what they come from
  Complex remesh(const double angle) const
  {
    Complex complex = m_original;
    remove_details(complex, angle);
    const auto numbers = mark_features(complex, angle);
    std::vector<double> tolerances;
    for(const auto& face : complex.faces)
      tolerances.push_back(m_tolerances[face.source]);
    const Reference_surface reference(complex, numbers, margin * m_changes.tolerance, tolerances);
    Triangle_remesher(complex, reference, m_changes.largest_edge, smallest_size * m_changes.tolerance)();
    for(auto& face : complex.faces)
      face.source = reference.complex().faces[face_below(complex, face, reference)].source;
    complex.drop_removed_faces();
    return complex;
  }

  std::array<std::size_t, 2> mark_features(Complex& complex, const double angle) const
  {
    std::vector<int> labels;
    for(const auto& face : complex.faces)
      labels.push_back(m_surface.patches[face.source]);
    return Feature_marker<Complex>(complex, labels, angle)();
  }

  // only what is not sharp alone has to stay where it is
  void remove_details(Complex& complex, const double angle) const
  {
    static constexpr double any_angle = 180;
    std::vector<bool> is_sharp, is_kept;
    mark_features(complex, angle);
    for(const auto kind : complex.kinds)
      is_sharp.push_back(kind != Complex::Kind::free);
    clear_features(complex);
    mark_features(complex, any_angle);
    for(const double tolerance : m_tolerances)
      is_kept.push_back(tolerance < margin * m_changes.tolerance);
    Detail_remover<Complex>(complex, is_kept, is_sharp, detail * m_changes.tolerance, angle)();
    clear_features(complex);
  }

  static void clear_features(Complex& complex)
  {
    for(auto& face : complex.faces)
      face.curves.fill(Complex::none);
  }

  static Index face_below(const Complex& complex, const typename Complex::Face& face,
                          const Reference_surface& reference)
  {
    const auto& v = face.vertices;
    const auto& p = complex.points;
    return reference.closest_in_patch(CGAL::centroid(p[v[0]], p[v[1]], p[v[2]]), face.patch).number;
  }

  // Makes the tolerances of faces, and of those around them, smaller. Where that was done already, nothing is to be
  // changed at all.
  void tighten(const std::vector<Index>& faces)
  {
    std::vector<bool> is_near(m_tolerances.size(), false);
    for(const Index f : faces)
      for(const Index v : m_original.faces[f].vertices)
        for(const Index g : m_original.stars[v])
          is_near[g] = true;
    const double first = margin * m_changes.tolerance;
    for(Index f = 0; f < is_near.size(); ++f)
      if(is_near[f])
        m_tolerances[f] = m_tolerances[f] == first ? tighter * first : 0;
  }

  // The vertices that are where they were keep their numbers in the file.
  Surface<Point> make_surface_of(const Complex& complex) const
  {
    std::vector<Point> points;
    std::vector<std::array<std::size_t, 3> > faces;
    for(const auto& p : complex.points)
      points.emplace_back(p.x(), p.y(), p.z());
    for(const auto& face : complex.faces)
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
    for(std::size_t i = 0; i < complex.faces.size(); ++i)
    {
      result.file_faces[i] = m_surface.file_face(complex.faces[i].source);
      result.patches[i] = m_surface.patches[complex.faces[i].source];
    }
    return result;
  }

  static std::vector<Index> intersecting_faces(const Surface<Point>& surface, const Complex& complex)
  {
    std::vector<Index> faces;
    for(const auto& defect : diagnose(surface.points, surface.faces).defects)
      for(const auto& simplex : defect.simplices)
        if(simplex.dimension == 2 && simplex.index < complex.faces.size())
          faces.push_back(complex.faces[simplex.index].source);
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

  // measures the distance from one surface to the other, and adds the sources of what is too far away
  void measure(const Complex& from, const Complex& to, const int direction, std::vector<Index>& bad)
  {
    static constexpr double spacing = 5; // of samples, in terms of the tolerance
    const std::vector<Triangle> triangles = Reference_surface::triangles(from);
    const Patches all(Reference_surface::triangles(to), std::vector<Index>(to.faces.size(), 0), 1);
    for(Index f = 0; f < triangles.size(); ++f)
      for_samples(triangles[f], spacing * m_changes.tolerance, [&](const Reference_surface::Point& p)
      {
        const double d = std::sqrt(CGAL::squared_distance(p, all(p, 0).point));
        m_changes.distances[direction] = (std::max)(m_changes.distances[direction], d);
        if(d > m_changes.tolerance)
          bad.push_back(from.faces[f].source);
      });
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
