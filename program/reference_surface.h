#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REFERENCE_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REFERENCE_SURFACE_H

#include "aabb_trees.h"
#include "surface_features.h"
#include "triangle_complex.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

typedef CGAL::Simple_cartesian<double> Remeshing_kernel; // nothing that is decided with it has to be exact

// Finds what is closest to a point among triangles, or segments, of the same group. Those of a group stand together.
template <typename Primitive, typename Object>
class Grouped_trees
{
  typedef Remeshing_kernel::Point_3                   Point;
  typedef Aabb_traits<Remeshing_kernel, Primitive> Traits;
  typedef CGAL::AABB_tree<Traits>                     Tree;

  std::vector<std::size_t> m_numbers;
  std::vector<Object> m_objects;
  std::vector<std::unique_ptr<Tree> > m_trees;
  mutable std::vector<std::size_t> m_last; // the object that was found last: questions come close to each other

public:
  struct Closest
  {
    Point point;
    std::size_t number; // of the object
  };

  // the numbers of the objects are those of their groups in `groups`
  Grouped_trees(const std::vector<Object>& objects, const std::vector<std::size_t>& groups, const std::size_t n)
    : m_numbers(objects.size()), m_trees(n), m_last(n)
  {
    std::iota(m_numbers.begin(), m_numbers.end(), std::size_t(0));
    std::stable_sort(m_numbers.begin(), m_numbers.end(),
                     [&](const std::size_t i, const std::size_t j) { return groups[i] < groups[j]; });
    for(const std::size_t i : m_numbers)
      m_objects.push_back(objects[i]);
    for(std::size_t begin = 0, end = 0; begin < m_numbers.size(); begin = end)
    {
      const std::size_t group = groups[m_numbers[begin]];
      while(end < m_numbers.size() && groups[m_numbers[end]] == group)
        ++end;
      m_trees[group].reset(new Tree(m_objects.begin() + begin, m_objects.begin() + end));
      m_last[group] = begin;
    }
  }

  Closest operator()(const Point& p, const std::size_t group) const
  {
    typename Tree::Point_and_primitive_id found(last(p, group), m_objects.begin() + m_last[group]);
    if(found.first != p)
      found = m_trees[group]->closest_point_and_primitive(p, found);
    m_last[group] = found.second - m_objects.begin();
    return Closest{ found.first, m_numbers[m_last[group]] };
  }

  // a point that is not closer than that
  Point last(const Point& p, const std::size_t group) const
  {
    return Remeshing_kernel().construct_projected_point_3_object()(m_objects[m_last[group]], p);
  }
};

// A surface that another one has to stay close to: where its patches and curves are, how far from them the other one
// may be, and how long its edges may be for that.
class Reference_surface
{
public:
  typedef Remeshing_kernel::Point_3    Point;
  typedef Remeshing_kernel::Vector_3   Vector;
  typedef Remeshing_kernel::Triangle_3 Triangle;
  typedef Remeshing_kernel::Segment_3  Segment;
  typedef Triangle_complex<Point>      Complex;
  typedef Complex::Index               Index;

private:
  typedef std::vector<Triangle>::const_iterator                                   Triangle_iterator;
  typedef std::vector<Segment>::const_iterator                                    Segment_iterator;
  typedef Aabb_triangle_primitive<Remeshing_kernel, Triangle_iterator>      Triangle_primitive;
  typedef Aabb_segment_primitive<Remeshing_kernel, Segment_iterator>        Segment_primitive;

public:
  typedef Grouped_trees<Triangle_primitive, Triangle> Patches;
  typedef Grouped_trees<Segment_primitive, Segment>   Curves;
  typedef Patches::Closest                            Closest;

private:
  // the edges of curves, once each
  struct Curve_edges
  {
    std::vector<Segment> segments;
    std::vector<Index> curves, faces;

    explicit Curve_edges(const Complex& complex)
    {
      for(Index f = 0; f < complex.faces.size(); ++f)
        for(int i = 0; i < 3; ++i)
        {
          const auto& face = complex.faces[f];
          const Index v = face.vertices[(i + 1) % 3], w = face.vertices[(i + 2) % 3];
          if(face.is_removed || face.curves[i] == Complex::none || complex.faces_of_edge(v, w)[0] != f)
            continue;
          segments.emplace_back(complex.points[v], complex.points[w]);
          curves.push_back(face.curves[i]);
          faces.push_back(f);
        }
    }
  };

  const Complex m_complex;
  const Curve_edges m_curve_edges;
  const Patches m_patches;
  const Curves m_curves;
  const double m_tolerance;         // where nothing went wrong yet
  std::vector<double> m_sizes;      // at the vertices
  const std::vector<double> m_tolerances; // of the faces; 0 where nothing is to be changed
  const bool m_is_tightened;
  std::vector<Index> m_flat_faces;  // the largest face of each patch that is flat

public:
  // `numbers` are those of patches and curves; the tolerances of the faces are at most `tolerance`
  Reference_surface(const Complex& complex, const std::array<std::size_t, 2>& numbers, const double tolerance,
                    const std::vector<double>& tolerances)
    : m_complex(complex), m_curve_edges(complex),
      m_patches(triangles(complex), groups(complex), numbers[0]),
      m_curves(m_curve_edges.segments, m_curve_edges.curves, numbers[1]),
      m_tolerance(tolerance), m_sizes(complex.points.size(), (std::numeric_limits<double>::infinity)()),
      m_tolerances(tolerances),
      m_is_tightened(std::any_of(tolerances.begin(), tolerances.end(), [=](const double x) { return x < tolerance; }))
  {
    for(Index v = 0; v < complex.points.size(); ++v)
      set_size(v);
    find_flat_patches(numbers[0]);
  }

  static std::vector<Triangle> triangles(const Complex& complex)
  {
    std::vector<Triangle> result;
    for(const auto& face : complex.faces)
      if(! face.is_removed)
        result.emplace_back(complex.points[face.vertices[0]], complex.points[face.vertices[1]],
                            complex.points[face.vertices[2]]);
    return result;
  }

  static std::vector<Index> groups(const Complex& complex)
  {
    std::vector<Index> result;
    for(const auto& face : complex.faces)
      if(! face.is_removed)
        result.push_back(face.patch);
    return result;
  }

  const Complex& complex() const { return m_complex; }

  Closest closest_in_patch(const Point& p, const Index patch) const { return m_patches(p, patch); }

  Point closest_on_curve(const Point& p, const Index curve) const { return m_curves(p, curve).point; }

  // whether a point is as close to a patch as it has to be
  bool is_close(const Point& p, const Index patch) const
  {
    return is_flat(patch) ||
           (! m_is_tightened && CGAL::squared_distance(p, m_patches.last(p, patch)) <= squared_tolerance()) ||
           is_close(p, closest_in_patch(p, patch));
  }

  bool is_close(const Point& p, const Closest& closest) const
  {
    const double d = m_tolerances[closest.number];
    return CGAL::squared_distance(p, closest.point) <= d * d;
  }

  bool is_close_to_curve(const Point& p, const Index curve) const
  {
    const auto closest = m_curves(p, curve);
    const double d = m_tolerances[m_curve_edges.faces[closest.number]];
    return CGAL::squared_distance(p, closest.point) <= d * d;
  }

  double squared_tolerance() const { return m_tolerance * m_tolerance; }

  // whether nothing that turns as the patch and keeps within its curves can leave it; one of its faces
  bool is_flat(const Index patch) const { return ! m_is_tightened && m_flat_faces[patch] != Complex::none; }
  Index flat_face(const Index patch) const { return m_flat_faces[patch]; }

  bool is_frozen(const Index f) const { return m_tolerances[f] == 0; }

  bool is_tightened() const { return m_is_tightened; }

  Vector normal(const Index f) const
  {
    const auto& v = m_complex.faces[f].vertices;
    return CGAL::normal(m_complex.points[v[0]], m_complex.points[v[1]], m_complex.points[v[2]]);
  }

  // the size at a point of a face; sizes grow by `growth` per length
  double size(const Point& p, const Index f, const double growth) const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for(const Index v : m_complex.faces[f].vertices)
      result = (std::min)(result, m_sizes[v] + growth * std::sqrt(CGAL::squared_distance(p, m_complex.points[v])));
    return result;
  }

private:
  // Where edges turn by an angle, a chord of that length is as far away as `distance`. Edges turn little by little
  // where they stand for a round surface, and the chord is long; or at once, and then the chord ends beside that edge.
  static double chord(const double angle, const double width, const double distance)
  {
    return angle == 0 ? (std::numeric_limits<double>::infinity)()
                      : (std::max)(4 * distance / angle, std::sqrt(6 * distance * width / angle));
  }

  void set_size(const Index v)
  {
    double distance = m_tolerance / 2;
    for(const Index f : m_complex.stars[v])
      if(m_tolerances[f] > 0)
        distance = (std::min)(distance, m_tolerances[f] / 2);
    for(const Index w : m_complex.neighbors(v))
    {
      const auto faces = m_complex.faces_of_edge(v, w);
      if(m_complex.faces[faces[0]].curve(v, w) == Complex::none)
        m_sizes[v] = (std::min)(m_sizes[v], size_at_edge(v, w, faces[0], faces[1], distance));
    }
    if(m_complex.kinds[v] == Complex::Kind::on_curve)
      m_sizes[v] = (std::min)(m_sizes[v], size_on_curve(v, distance));
  }

  void find_flat_patches(const std::size_t n)
  {
    static constexpr double share = 1e-3; // of the tolerance
    m_flat_faces.assign(n, Complex::none);
    for(Index f = 0; f < m_complex.faces.size(); ++f)
    {
      Index& largest = m_flat_faces[m_complex.faces[f].patch];
      if(largest == Complex::none || normal(f).squared_length() > normal(largest).squared_length())
        largest = f;
    }
    const std::vector<Index> largest = m_flat_faces;
    for(const auto& face : m_complex.faces)
    {
      const Index f = largest[face.patch];
      const Vector n = normal(f);
      const Point& origin = m_complex.points[m_complex.faces[f].vertices[0]];
      for(const Index v : face.vertices)
        if(std::abs((m_complex.points[v] - origin) * n) > share * m_tolerance * std::sqrt(n.squared_length()))
          m_flat_faces[face.patch] = Complex::none;
    }
  }

  static double radians(const double degrees) { return degrees * std::acos(-1.) / 180; }

  double size_at_edge(const Index v, const Index w, const Index f, const Index g, const double distance) const
  {
    const Vector n = normal(f), m = normal(g);
    const double length = std::sqrt(CGAL::squared_distance(m_complex.points[v], m_complex.points[w]));
    const double width = (std::sqrt(n.squared_length()) + std::sqrt(m.squared_length())) / (2 * length);
    return chord(radians(angle_between(n, m)), width, distance);
  }

  double size_on_curve(const Index v, const double distance) const
  {
    std::vector<Vector> edges;
    for(const Index w : m_complex.neighbors(v))
      if(m_complex.faces[m_complex.faces_of_edge(v, w)[0]].curve(v, w) != Complex::none)
        edges.push_back(m_complex.points[w] - m_complex.points[v]);
    const double width = (std::sqrt(edges[0].squared_length()) + std::sqrt(edges[1].squared_length())) / 2;
    return chord(radians(angle_between(edges[0], -edges[1])), width, distance);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_REFERENCE_SURFACE_H
