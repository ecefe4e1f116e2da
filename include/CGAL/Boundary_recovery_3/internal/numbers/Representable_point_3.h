// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_REPRESENTABLE_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_REPRESENTABLE_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Origin.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Decides whether there is a point with coordinates of type `double` in an open convex polyhedron, and finds one. The
 * polyhedron may be far thinner than the distance between floating point numbers.
 *
 * Floating point numbers up to a bound are multiples of a power of two, so this is integer programming in three
 * dimensions, by the method of H. W. Lenstra (Integer programming with a fixed number of variables, 1983): a linear map
 * makes the polyhedron about as wide as long, and the basis of the lattice is reduced there. Then few lattice planes
 * meet the polyhedron if there is no lattice point in it, and all of them are searched, line by line.
 *
 * All is exact. What is not looked at are numbers closer to each other than at the largest coordinates of the
 * polyhedron, more lattice planes and lines than `max_number_of_visits`, and polyhedra with more than
 * `max_number_of_planes` faces, since the time is cubic in that number.
 */
template <typename Rational>
class Representable_point_3
{
public:
  typedef Simple_cartesian<Rational>           Kernel;
  typedef typename Kernel::Point_3             Point_3;
  typedef typename Kernel::Plane_3             Plane_3;
  typedef std::array<double, 3>                Coordinates;

  // The polyhedron is the intersection of the open negative sides of the planes, and is bounded.
  std::optional<Coordinates> operator()(std::vector<Plane_3> planes)
  {
    if(planes.size() > max_number_of_planes)
      return std::nullopt;
    make_integral(planes);
    collect_vertices(planes);
    find_spacings();
    if(! find_shape())
      return std::nullopt;
    reduce_basis();
    change_basis(planes);
    return search();
  }

  // The mean of the vertices of that polyhedron, which is inside; none if it has no volume.
  std::optional<Point_3> center(std::vector<Plane_3> planes)
  {
    if(planes.size() > max_number_of_planes)
      return std::nullopt;
    make_integral(planes);
    collect_vertices(planes);
    if(m_vertices.empty())
      return std::nullopt;
    Vector_3 sum = CGAL::NULL_VECTOR;
    for(const Vector_3& v : m_vertices)
      sum = sum + v;
    const Point_3 mean = CGAL::ORIGIN + sum / Rational(static_cast<int>(m_vertices.size()));
    for(const Plane_3& h : planes)
      if(! h.has_on_negative_side(mean)) // all the vertices are on that plane
        return std::nullopt;
    return mean;
  }

private:
  typedef typename Kernel::Vector_3            Vector_3;
  typedef std::array<Vector_3, 3>              Matrix; // three columns
  typedef std::pair<Rational, Rational>        Range;

  static Rational dot(const Vector_3& v, const Vector_3& w) { return CGAL::scalar_product(v, w); }

  static Vector_3 cross(const Vector_3& v, const Vector_3& w) { return CGAL::cross_product(v, w); }

  // The vectors that have the product one with one column, and zero with the others.
  static Matrix dual(const Matrix& m)
  {
    const Rational determinant = dot(m[0], cross(m[1], m[2]));
    return {{ cross(m[1], m[2]) / determinant, cross(m[2], m[0]) / determinant, cross(m[0], m[1]) / determinant }};
  }

  static Vector_3 products(const Matrix& m, const Vector_3& v)
  {
    return Vector_3(dot(m[0], v), dot(m[1], v), dot(m[2], v));
  }

  // Where only ratios matter, integers take a fraction of the time: other numbers are reduced to lowest terms at every
  // step.
  static void make_integral(std::vector<Plane_3>& planes)
  {
    for(Plane_3& h : planes)
    {
      const std::array<Rational, 4> numbers = {{ h.a(), h.b(), h.c(), h.d() }};
      const Rational w(internal::common_denominator(numbers));
      h = Plane_3(w * h.a(), w * h.b(), w * h.c(), w * h.d());
    }
  }

  static void make_integral(Matrix& m)
  {
    std::vector<Rational> numbers;
    for(const Vector_3& column : m)
      numbers.insert(numbers.end(), { column.x(), column.y(), column.z() });
    const Rational w(internal::common_denominator(numbers));
    for(Vector_3& column : m)
      column = w * column;
  }

  // The ends of the edges. (To compile `CGAL::halfspace_intersection_3()` takes as long as half of this package.)
  void collect_vertices(const std::vector<Plane_3>& planes)
  {
    std::vector<Point_3> points;
    for(std::size_t i = 0; i < planes.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        add_edge(planes, planes[i], planes[j], points);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    m_vertices.clear();
    for(const Point_3& p : points)
      m_vertices.push_back(p - CGAL::ORIGIN);
  }

  // Adds the ends of what is left of the line in which p and q meet, after it is cut off at all the planes.
  static void add_edge(const std::vector<Plane_3>& planes, const Plane_3& p, const Plane_3& q,
                       std::vector<Point_3>& points)
  {
    const Vector_3 u = p.orthogonal_vector(), v = q.orthogonal_vector(), direction = cross(u, v);
    if(direction == CGAL::NULL_VECTOR)
      return;
    const Vector_3 weighted = p.d() * cross(direction, v) + q.d() * cross(u, direction);
    const Rational weight = dot(direction, direction);
    if(const std::optional<Range> range = part_of_line(planes, weighted, direction, weight))
      for(const Rational& t : { range->first, range->second })
        points.push_back(CGAL::ORIGIN + (weighted + t * direction) / weight);
  }

  // Those multiples of the direction that lead from `start`, both divided by `weight`, to points on no positive side of
  // a plane, of which some bound it on both sides; none if there are no such points.
  static std::optional<Range> part_of_line(const std::vector<Plane_3>& planes, const Vector_3& start,
                                           const Vector_3& direction, const Rational& weight)
  {
    std::optional<Rational> first, last;
    for(const Plane_3& h : planes)
    {
      const Rational slope = dot(h.orthogonal_vector(), direction);
      const Rational height = dot(h.orthogonal_vector(), start) + weight * h.d();
      if(slope == 0 && height > 0)
        return std::nullopt;
      if(slope == 0)
        continue;
      const Rational t = - height / slope;
      if(slope > 0 && (! last || t < *last))
        last = t;
      else if(slope < 0 && (! first || t > *first))
        first = t;
      if(first && last && *first > *last)
        return std::nullopt;
    }
    return Range(*first, *last);
  }

  // From here on, the spacing of the numbers in each coordinate is the unit there.
  void find_spacings()
  {
    for(int i = 0; i < 3; ++i)
    {
      Rational largest(0);
      for(const Vector_3& v : m_vertices)
        largest = (std::max)(largest, Rational(CGAL::abs(v[i])));
      const double approximate = CGAL::to_double(largest);
      int exponent = approximate > 0 ? std::ilogb(approximate) : -1074;
      if(! (largest > Rational(std::ldexp(1., exponent))))
        --exponent; // all the numbers inside are less than the power of two
      m_spacings[i] = binary_unit(exponent - 52);
    }
    for(Vector_3& v : m_vertices)
      v = Vector_3(v.x() / Rational(m_spacings[0]), v.y() / Rational(m_spacings[1]), v.z() / Rational(m_spacings[2]));
  }

  // Finds three edges of a large simplex of vertices. In affine coordinates with respect to it, the polyhedron is in
  // a cube that is not much larger. Returns false if there is no volume.
  bool find_shape()
  {
    if(m_vertices.size() < 4)
      return false;
    const Vector_3 first = m_vertices.front();
    const auto farthest = [&](const auto& size)
    {
      Vector_3 result = CGAL::NULL_VECTOR;
      Rational largest(0);
      for(const Vector_3& v : m_vertices)
      {
        const Vector_3 d = v - first;
        const Rational s = size(d);
        if(s > largest)
        {
          largest = s;
          result = d;
        }
      }
      return result;
    };
    m_shape[0] = farthest([](const Vector_3& d) { return dot(d, d); });
    m_shape[1] = farthest([&](const Vector_3& d) { const Vector_3 n = cross(d, m_shape[0]); return dot(n, n); });
    const Vector_3 normal = cross(m_shape[0], m_shape[1]);
    m_shape[2] = farthest([&](const Vector_3& d) { return Rational(CGAL::abs(Rational(dot(d, normal)))); });
    return m_shape[2] != CGAL::NULL_VECTOR;
  }

  // Makes a basis of the integer vectors short in the affine coordinates: as long as a multiple of one, or the sum or
  // the difference of both others, can be taken off one so that this becomes shorter. The longest comes first then.
  void reduce_basis()
  {
    m_basis = {{ Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1) }};
    const Matrix forms = dual(m_shape);
    Matrix images;
    for(int i = 0; i < 3; ++i)
      images[i] = products(forms, m_basis[i]);
    make_integral(images);
    Rational g[3][3]; // the scalar products of the images; the images themselves are not needed any more
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        g[i][j] = dot(images[i], images[j]);
    for(bool is_changed = true; is_changed; )
    {
      is_changed = false;
      const auto subtract = [&](const int i, const Rational& q, const int j, const Rational& r, const int k)
      {
        const Rational off_j = q * g[j][j] + r * g[j][k], off_k = q * g[j][k] + r * g[k][k];
        const Rational change = q * (off_j - 2 * g[i][j]) + r * (off_k - 2 * g[i][k]); // of the squared length
        if(! (change < 0))
          return;
        g[i][i] += change;
        g[i][j] = g[j][i] = g[i][j] - off_j;
        g[i][k] = g[k][i] = g[i][k] - off_k;
        m_basis[i] = m_basis[i] - q * m_basis[j] - r * m_basis[k];
        is_changed = true;
      };
      for(int i = 0; i < 3; ++i)
      {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        subtract(i, nearest_integer(Rational(g[i][j] / g[j][j])), j, Rational(0), k);
        subtract(i, nearest_integer(Rational(g[i][k] / g[k][k])), k, Rational(0), j);
        for(const int q : { -1, 1 })
          for(const int r : { -1, 1 })
            subtract(i, Rational(q), j, Rational(r), k);
      }
    }
    Rational longest = g[0][0];
    for(int i = 1; i < 3; ++i)
      if(g[i][i] > longest)
      {
        longest = g[i][i];
        std::swap(m_basis[0], m_basis[i]);
      }
  }

  // The vertices and planes in coordinates with respect to the reduced basis.
  void change_basis(const std::vector<Plane_3>& planes)
  {
    const Matrix forms = dual(m_basis);
    for(Vector_3& v : m_vertices)
      v = products(forms, v);
    m_planes.clear();
    for(const Plane_3& p : planes)
    {
      const Vector_3 normal(p.a() * Rational(m_spacings[0]), p.b() * Rational(m_spacings[1]),
                            p.c() * Rational(m_spacings[2]));
      const Vector_3 n = products(m_basis, normal);
      m_planes.emplace_back(n.x(), n.y(), n.z(), p.d());
    }
  }

  // Visits the integers in the open interval from the middle outwards, until `visit` returns true.
  template <typename Visit>
  bool visit_integers(const Range& interval, const Visit& visit)
  {
    const auto visit_if_inside = [&](const Rational& x, bool& is_inside)
    {
      is_inside = interval.first < x && x < interval.second && ++m_number_of_visits <= max_number_of_visits;
      return is_inside && visit(x);
    };
    const Rational middle = nearest_integer(Rational((interval.first + interval.second) / Rational(2)));
    bool is_one_inside = true, is_other_inside = true;
    if(visit_if_inside(middle, is_one_inside))
      return true;
    for(int k = 1; is_one_inside || is_other_inside; ++k)
      if(visit_if_inside(Rational(middle + Rational(k)), is_one_inside)
         || visit_if_inside(Rational(middle - Rational(k)), is_other_inside))
        return true;
    return false;
  }

  std::optional<Coordinates> search()
  {
    m_number_of_visits = 0;
    Vector_3 found;
    const bool is_found = visit_integers(range_of_planes(), [&](const Rational& x)
    {
      return visit_integers(range_of_lines(x), [&](const Rational& y)
      {
        // the third coordinates where the first are x and y: the line meets the open polyhedron
        const Range range = *part_of_line(m_planes, Vector_3(x, y, 0), Vector_3(0, 0, 1), Rational(1));
        const Rational z = nearest_integer(Rational((range.first + range.second) / Rational(2)));
        found = x * m_basis[0] + y * m_basis[1] + z * m_basis[2];
        return range.first < z && z < range.second;
      });
    });
    if(! is_found)
      return std::nullopt;
    return Coordinates{{ m_spacings[0] * CGAL::to_double(found.x()), m_spacings[1] * CGAL::to_double(found.y()),
                         m_spacings[2] * CGAL::to_double(found.z()) }};
  }

  // The first coordinates of the polyhedron.
  Range range_of_planes() const
  {
    Range range(m_vertices.front().x(), m_vertices.front().x());
    for(const Vector_3& v : m_vertices)
      extend(range, v.x());
    return range;
  }

  // The second coordinates where the first is x.
  Range range_of_lines(const Rational& x) const
  {
    std::optional<Range> range;
    for(const Vector_3& v : m_vertices)
      for(const Vector_3& w : m_vertices)
        if(v.x() <= x && x < w.x())
        {
          const Rational y = v.y() + (x - v.x()) / (w.x() - v.x()) * (w.y() - v.y());
          if(range)
            extend(*range, y);
          else
            range.emplace(y, y);
        }
    return *range;
  }

  static void extend(Range& range, const Rational& x)
  {
    if(x < range.first)
      range.first = x;
    if(x > range.second)
      range.second = x;
  }

  static constexpr int max_number_of_visits = 200;
  static constexpr std::size_t max_number_of_planes = 64; // they take about 0.2 s

  std::vector<Vector_3> m_vertices;
  Coordinates m_spacings;
  Matrix m_shape;
  Matrix m_basis;
  std::vector<Plane_3> m_planes;
  int m_number_of_visits = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_NUMBERS_REPRESENTABLE_POINT_3_H
