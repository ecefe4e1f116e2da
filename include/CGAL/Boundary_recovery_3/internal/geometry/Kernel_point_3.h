// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_KERNEL_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_KERNEL_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/Representable_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/nearest_integer.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Origin.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Finds a point in the open kernel of a polyhedron: one that sees all of its faces from inside.
 *
 * Candidates are computed with floating point numbers and rounded to those of the triangulation's kernel first; then
 * the exact predicates judge what will be in the triangulation. They are points on a ray into the polyhedron, found by
 * bisection [CZZ+17, Alg. A.1], and the deepest point of the kernel, the solution of a linear program.
 *
 * A polyhedron may be too flat to have a floating point number inside (a wall of a CAD model that is planar up to
 * rounding). Then the vertex gets an exact position on the ray, for the time being.
 */
template <typename Tr>
class Kernel_point_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Exact_positions_3<Tr>                Positions;
  typedef typename Positions::Point_3          Point_3;
  typedef std::array<Vertex_handle, 3>         Triangle;
  typedef typename Predicates::Approximate_point Point;  // with coordinates of type `double`
  typedef Simple_cartesian<double>::Vector_3   Vector;
  typedef typename Positions::Exact_point_3    Exact_point;
  typedef typename Positions::Exact_kernel::Vector_3 Exact_vector;

  Kernel_point_3(const Predicates& predicates, Positions& positions)
    : m_predicates(predicates), m_positions(positions)
  { }

  // Moves v to a point on a ray from `origin`, a point of the closed kernel, in one of the directions, or to the
  // deepest point. Each of the faces has the polyhedron on its positive side. v must have no exact position, but it
  // may get one.
  bool operator()(const Vertex_handle v, const std::vector<Triangle>& faces,
                  const Vertex_handle origin, const std::vector<Exact_vector>& directions)
  {
    set_up(faces, m_predicates.approximate_point(origin));
    if(any_of(directions, [&](const Exact_vector& d) { return find_on_ray(v, faces, approximate(d)); }))
      return true;
    if(! any_of(directions, [&](const Exact_vector& d) { return find_exactly_on_ray(v, faces, origin, d); }))
      return move_to_deepest_point(v, faces);
    const Vector offset = approximate(m_positions(v) - m_positions(origin));
    const double distance = std::hypot(offset[0] / m_unit, offset[1] / m_unit, offset[2] / m_unit);
    simplify_position(v, faces, distance);
    if(distance > thinnest * m_diameter) // else no number can be expected, and linear programs are slow there
      round_to_deepest_point(v, faces);
    return true;
  }

  // Moves v to the deepest point of the kernel, in numbers of the triangulation's kernel. v must have no exact
  // position.
  bool operator()(const Vertex_handle v, const std::vector<Triangle>& faces)
  {
    set_up(faces, m_predicates.approximate_point(v));
    return move_to_deepest_point(v, faces);
  }

  // Moves v to a point in numbers of the triangulation's kernel, with no coordinate farther than `radius` from that of
  // `inside`, an exact point of the open kernel. v must have no exact position. This is slow, but decides whether there
  // is such a point, up to what `Representable_point_3` does not look at.
  bool move_near(const Vertex_handle v, const std::vector<Triangle>& faces, const Exact_point& inside,
                 const double radius = std::numeric_limits<double>::infinity())
  {
    if constexpr(Positions::is_kernel_exact)
      return false;
    else
    {
      std::vector<Rational_plane> planes;
      for(const Triangle& f : faces) // with the kernel on their negative sides
        planes.emplace_back(m_positions(f[0]), m_positions(f[2]), m_positions(f[1]));
      if(std::isfinite(radius))
        add_box(inside, radius, planes);
      const auto found = Representable_point_3<Rational>()(planes);
      if(! found)
        return false;
      v->set_point(Point_3((*found)[0], (*found)[1], (*found)[2]));
      return is_kernel_point(v, faces);
    }
  }

  // Whether v sees all the faces.
  bool is_kernel_point(const Vertex_handle v, const std::vector<Triangle>& faces) const
  {
    return is_none_hidden(faces, [&](const Triangle& f)
    {
      return m_predicates.orientation(f[0], f[1], f[2], v) != POSITIVE;
    });
  }

private:
  typedef typename Positions::Exact_FT              FT;
  typedef Representable_point_3<Rational>::Point_3  Rational_point;
  typedef Representable_point_3<Rational>::Plane_3  Rational_plane;

  // With the inside on their negative sides.
  static void add_box(const Rational_point& center, const double radius, std::vector<Rational_plane>& planes)
  {
    for(const int sign : { 1, -1 })
      for(int i = 0; i < 3; ++i)
        planes.emplace_back(i == 0 ? sign : 0, i == 1 ? sign : 0, i == 2 ? sign : 0,
                            Rational(- Rational(sign) * center[i] - Rational(radius)));
  }

  // The half space of the points x for which normal * x > offset; the origin of coordinates is the given origin.
  struct Half_space
  {
    Vector normal; // of length one
    double offset;
  };

  // A point relative to the origin, in units of the diameter, and its distance from the planes of the half spaces.
  struct Deep_point
  {
    Vector x;
    double depth;
  };

  // Along a ray, the next point is likely to be on the wrong side of the same face.
  template <typename Is_hidden>
  bool is_none_hidden(const std::vector<Triangle>& faces, const Is_hidden& is_hidden) const
  {
    if(m_last_hidden < faces.size() && is_hidden(faces[m_last_hidden]))
      return false;
    const auto hidden = std::find_if(faces.begin(), faces.end(), is_hidden);
    m_last_hidden = static_cast<std::size_t>(hidden - faces.begin());
    return hidden == faces.end();
  }

  template <typename Predicate>
  static bool any_of(const std::vector<Exact_vector>& directions, const Predicate& predicate)
  {
    return std::any_of(directions.begin(), directions.end(), predicate);
  }

  static Vector approximate(const Exact_vector& d)
  {
    return Vector(CGAL::to_double(d.x()), CGAL::to_double(d.y()), CGAL::to_double(d.z()));
  }

  void set_up(const std::vector<Triangle>& faces, const Point& origin)
  {
    m_origin = origin;
    m_half_spaces.clear();
    m_diameter = 0;
    find_unit(faces);
    for(const Triangle& f : faces)
    {
      const Vector p = from_origin(f[0]), q = from_origin(f[1]), r = from_origin(f[2]);
      const Vector n = CGAL::cross_product(q - p, r - p);
      const double length = std::sqrt(n.squared_length());
      for(const Vector& v : { p, q, r })
        m_diameter = (std::max)(m_diameter, 2 * std::sqrt(v.squared_length()));
      if(! (length > 0))
        continue; // too thin for floating point numbers; the exact test knows it
      const Vector normal = n / length;
      m_half_spaces.push_back({ normal, CGAL::scalar_product(normal, p) });
    }
  }

  void find_unit(const std::vector<Triangle>& faces)
  {
    double largest = 0;
    for(const Triangle& f : faces)
      for(const Vertex_handle v : f)
        largest = (std::max)(largest, largest_coordinate(m_predicates.approximate_point(v) - m_origin));
    m_unit = binary_scale(largest);
  }

  Vector from_origin(const Vertex_handle v) const
  {
    return (m_predicates.approximate_point(v) - m_origin) / m_unit;
  }

  bool find_on_ray(const Vertex_handle v, const std::vector<Triangle>& faces, const Vector& direction)
  {
    const double length = std::sqrt(direction.squared_length());
    if(! (length > 0) || ! std::isfinite(length))
      return false;
    const Vector d = direction / length;
    double s = m_diameter; // where the ray leaves the kernel
    for(const Half_space& h : m_half_spaces)
    {
      const double slope = CGAL::scalar_product(h.normal, d);
      if(slope < 0)
        s = (std::min)(s, (std::max)(h.offset / slope, m_diameter * std::numeric_limits<double>::epsilon()));
    }
    for(int i = 0; i < max_number_of_bisections; ++i)
    {
      s /= 2;
      if(move(v, s * d) && is_kernel_point(v, faces))
        return true;
    }
    return false;
  }

  bool find_exactly_on_ray(const Vertex_handle v, const std::vector<Triangle>& faces,
                           const Vertex_handle origin, const Exact_vector& direction)
  {
    if(direction == CGAL::NULL_VECTOR)
      return false;
    const Exact_point p = m_positions(origin);
    const Vector d = approximate(direction);
    const double quotient = m_diameter * m_unit / largest_coordinate(d);
    const double start = std::isfinite(quotient) && quotient > 0 ? quotient : 1.;
    FT s(start);
    int i = 0;
    for(const int first = first_on_ray(faces, origin, direction, start); i < first; ++i)
      s /= 4;
    for(; i < max_number_of_exact_bisections; ++i)
    {
      m_positions.set(v, p + s * direction);
      if(is_kernel_point(v, faces))
        return true;
      s /= 4;
    }
    m_positions.erase(v);
    return false;
  }

  // The first candidate of find_exactly_on_ray() that sees all the faces. There may be hundreds that do not, and it
  // takes much longer to store an exact position than to decide on it. With exact kernels, which have nothing to store
  // beside the triangulation, this is just the first of all.
  int first_on_ray(const std::vector<Triangle>& faces, const Vertex_handle origin, const Exact_vector& direction,
                   const double start) const
  {
    int i = 0;
    if constexpr(! Positions::is_kernel_exact)
    {
      typedef typename Positions::Homogeneous_point Homogeneous_point;
      const auto homogeneous = [this](const Vertex_handle v) { return Positions::homogeneous(v, m_positions.find(v)); };
      const Homogeneous_point p = homogeneous(origin), d = Positions::to_homogeneous(CGAL::ORIGIN + direction);
      for(Exact_float s(start); i < max_number_of_exact_bisections; s = s * Exact_float(.25), ++i)
      {
        const Homogeneous_point x = Homogeneous_point::on_ray(p, d, s);
        const auto is_hidden = [&](const Triangle& f)
        {
          return Homogeneous_point::orientation(homogeneous(f[0]), homogeneous(f[1]), homogeneous(f[2]), x) != POSITIVE;
        };
        if(is_none_hidden(faces, is_hidden))
          break;
      }
    }
    return i;
  }

  // Gives v, which has an exact position, another one near it that fewer bits describe, if this is in the kernel:
  // positions that are computed from positions would become longer and longer. The distance is in the unit.
  void simplify_position(const Vertex_handle v, const std::vector<Triangle>& faces, const double distance)
  {
    if(! std::isnormal(distance))
      return;
    const Exact_point exact = m_positions(v);
    for(const int bits : { 4, 16, 64 })
    {
      const FT unit = FT(binary_unit(std::ilogb(distance) - bits)) * FT(m_unit);
      m_positions.set(v, Exact_point(nearest_multiple(exact.x(), unit), nearest_multiple(exact.y(), unit),
                                     nearest_multiple(exact.z(), unit)));
      if(is_kernel_point(v, faces))
        return;
    }
    m_positions.set(v, exact);
  }

  // Moves v, which has an exact position, to the deepest point if this can be stored.
  void round_to_deepest_point(const Vertex_handle v, const std::vector<Triangle>& faces)
  {
    const Exact_point exact = m_positions(v);
    m_positions.erase(v);
    if(! move_to_deepest_point(v, faces))
      m_positions.set(v, exact);
  }

  // The center of the largest ball in the kernel: of the points x with normal * x - offset >= r for all half spaces,
  // that with the largest r.
  bool move_to_deepest_point(const Vertex_handle v, const std::vector<Triangle>& faces)
  {
    const std::optional<Deep_point> deepest = maximize(CGAL::NULL_VECTOR, 1);
    if(! deepest)
      return false;
    return (move(v, m_diameter * deepest->x) && is_kernel_point(v, faces))
        || (deepest->depth > 0 && sample(v, faces, deepest->x));
  }

  // A kernel thinner than the distance of floating point numbers contains many of them nevertheless, if it is wide and
  // not parallel to an axis: points in it, rounded, are inside now and then.
  bool sample(const Vertex_handle v, const std::vector<Triangle>& faces, const Vector& deepest)
  {
    std::vector<Vector> extreme;
    for(const Vector& axis : { Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1) })
      for(const Vector& objective : { axis, - axis })
        if(const std::optional<Deep_point> point = maximize(objective, 0))
          extreme.push_back(point->x);
    std::minstd_rand random; // always the same numbers
    for(int k = 0; k < number_of_samples && ! extreme.empty(); ++k)
    {
      Vector x = deepest;
      for(const Vector& e : extreme)
      {
        const double t = static_cast<double>(random()) / random.max() / 2;
        x += t * (e - x);
      }
      if(move(v, m_diameter * x) && is_kernel_point(v, faces))
        return true;
    }
    return false;
  }

  // Moves v to a point, relative to the origin and in the unit. Returns false if that has no finite coordinates.
  bool move(const Vertex_handle v, const Vector& x) const
  {
    const Point p = m_origin + m_unit * x;
    if(! std::isfinite(p.x()) || ! std::isfinite(p.y()) || ! std::isfinite(p.z()))
      return false;
    v->set_point(Point_3(p.x(), p.y(), p.z()));
    return true;
  }

  // Maximizes objective * x + r_max * r over the points x that are at least as deep as r, 0 <= r <= r_max, in units of
  // the diameter.
  std::optional<Deep_point> maximize(const Vector& objective, const int r_max) const
  {
    typedef CGAL::Quadratic_program<double> Program;
    Program lp(CGAL::LARGER, false, 0, false, 0);
    int row = 0;
    for(const Half_space& h : m_half_spaces)
    {
      for(int i = 0; i < 3; ++i)
        lp.set_a(i, row, h.normal[i]);
      lp.set_a(3, row, -1);
      lp.set_b(row, h.offset / m_diameter);
      ++row;
    }
    for(int i = 0; i < 3; ++i)
      lp.set_c(i, - objective[i]);
    lp.set_u(3, true, r_max);
    if(r_max == 0)
      lp.set_l(3, true, 0);
    lp.set_c(3, - r_max);
    // With CGAL's default pricing, which was never seen to cycle. Bland's rule, which cannot, gives the same points and
    // takes a quarter longer in all on polyhedra that need thousands of points.
    const CGAL::Quadratic_program_solution<Exact_float> solution
      = CGAL::solve_linear_program(lp, Exact_float());
    if(! solution.is_optimal())
      return std::nullopt;
    const double denominator = CGAL::to_double(solution.variables_common_denominator());
    std::array<double, 4> values; // of the three coordinates and r
    std::transform(solution.variable_numerators_begin(), solution.variable_numerators_end(), values.begin(),
                   [&](const Exact_float& numerator) { return CGAL::to_double(numerator) / denominator; });
    return Deep_point{ Vector(values[0], values[1], values[2]), m_diameter * values[3] };
  }

  static constexpr int max_number_of_bisections = 50;
  static constexpr int max_number_of_exact_bisections = 2000; // far beyond the range of double
  static constexpr int number_of_samples = 500;
  static constexpr double thinnest = 1e-30; // of the diameter; numbers have 16 digits

  const Predicates& m_predicates;
  Positions& m_positions;
  Point m_origin;
  double m_unit;     // of the half spaces and the diameter
  double m_diameter;
  std::vector<Half_space> m_half_spaces;
  mutable std::size_t m_last_hidden = 0; // the position of a face that the last point did not see
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_KERNEL_POINT_3_H
