// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_VISIBILITY_KERNEL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_VISIBILITY_KERNEL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Origin.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/QP_options.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The visibility kernel of a polyhedron, the points that see all of its faces from inside, in floating point numbers:
 * an intersection of half spaces. It proposes points; the exact predicates judge them, once they are rounded to numbers
 * of the triangulation's kernel.
 *
 * Candidates are points on a ray into the polyhedron, found by bisection [CZZ+17, Alg. A.1], and the deepest point of
 * the kernel, the solution of a linear program. The first one for which `is_inside` returns true is the result.
 */
template <typename Tr>
class Visibility_kernel_3
{
public:
  typedef typename Tr::Vertex_handle             Vertex_handle;
  typedef Vertex_predicates_3<Tr>                Predicates;
  typedef std::array<Vertex_handle, 3>           Vertex_triple;
  typedef typename Predicates::Approximate_point Point;  // with coordinates of type `double`
  typedef Simple_cartesian<double>::Vector_3     Vector;

  // Each of the faces has the polyhedron on its positive side. The origin is a point near them.
  Visibility_kernel_3(const Predicates& predicates, const std::vector<Vertex_triple>& faces, const Point& origin)
    : m_predicates(predicates), m_origin(origin), m_units(binary_scales(sizes(faces)))
  {
    for(const Vertex_triple& f : faces)
      add_half_space(from_origin(f[0]), from_origin(f[1]), from_origin(f[2]));
    // The solver looks at the first ones first, so these are to be those that the origin violates most.
    std::stable_sort(m_half_spaces.begin(), m_half_spaces.end(), [](const Half_space& a, const Half_space& b)
    {
      return a.offset > b.offset;
    });
  }

  // A power of two for each axis, so that products of lengths do not leave the range of floating point numbers.
  const std::array<double, 3>& units() const { return m_units; }

  // A vector in the units.
  Vector in_units(const Vector& v) const { return Vector(v[0] / m_units[0], v[1] / m_units[1], v[2] / m_units[2]); }

  // In the units, and roughly.
  double diameter() const { return m_diameter; }

  // A point on the ray from the origin, which is in the closed kernel.
  template <typename Is_inside>
  std::optional<Point> point_on_ray(const Vector& direction, const Is_inside& is_inside) const
  {
    const Vector scaled = in_units_up_to_factor(direction);
    const double length = std::sqrt(scaled.squared_length());
    if(! (length > 0) || ! std::isfinite(length))
      return std::nullopt;
    const Vector d = scaled / length;
    double s = end_of_ray(d);
    for(int i = 0; i < max_number_of_bisections; ++i)
    {
      s /= 2;
      if(const std::optional<Point> p = point_if(s * d, is_inside))
        return p;
    }
    return std::nullopt;
  }

  // The center of the largest ball in the kernel: of the points x with normal * x - offset >= r for all half spaces,
  // that with the largest r. Or a point beside it, if there is such a ball.
  template <typename Is_inside>
  std::optional<Point> deepest_point(const Is_inside& is_inside) const
  {
    const std::optional<Deep_point> deepest = maximize(CGAL::NULL_VECTOR, 1);
    if(! deepest)
      return std::nullopt;
    if(const std::optional<Point> p = point_if(m_diameter * deepest->x, is_inside))
      return p;
    return deepest->depth > 0 ? sample(deepest->x, is_inside) : std::nullopt;
  }

private:
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

  // The largest distances from the origin along the axes.
  std::array<double, 3> sizes(const std::vector<Vertex_triple>& faces) const
  {
    std::array<double, 3> largest = {{ 0, 0, 0 }};
    for(const Vertex_triple& f : faces)
      for(const Vertex_handle v : f)
        internal::enlarge(largest, m_predicates.approximate_point(v) - m_origin);
    return largest;
  }

  Vector from_origin(const Vertex_handle v) const
  {
    return in_units(m_predicates.approximate_point(v) - m_origin);
  }

  // A direction, whose length is of no importance, may be far longer or shorter than the polyhedron.
  Vector in_units_up_to_factor(const Vector& d) const
  {
    const double unit = *std::max_element(m_units.begin(), m_units.end());
    return Vector(d[0] * (unit / m_units[0]), d[1] * (unit / m_units[1]), d[2] * (unit / m_units[2]));
  }

  // The one on the positive side of a triangle.
  void add_half_space(const Vector& p, const Vector& q, const Vector& r)
  {
    const Vector n = CGAL::cross_product(q - p, r - p);
    const double length = std::sqrt(n.squared_length());
    for(const Vector& v : { p, q, r })
      m_diameter = (std::max)(m_diameter, 2 * std::sqrt(v.squared_length()));
    if(! (length > 0))
      return; // too thin for floating point numbers; the exact test knows it
    const Vector normal = n / length;
    m_half_spaces.push_back({ normal, CGAL::scalar_product(normal, p) });
  }

  // The length of a ray from the origin in the kernel.
  double end_of_ray(const Vector& direction) const
  {
    double s = m_diameter;
    for(const Half_space& h : m_half_spaces)
    {
      const double slope = CGAL::scalar_product(h.normal, direction);
      if(slope < 0)
        s = (std::min)(s, (std::max)(h.offset / slope, m_diameter * std::numeric_limits<double>::epsilon()));
    }
    return s;
  }

  // The point x, relative to the origin and in the units, if it has finite coordinates and is inside.
  template <typename Is_inside>
  std::optional<Point> point_if(const Vector& x, const Is_inside& is_inside) const
  {
    const Point p = m_origin + Vector(m_units[0] * x[0], m_units[1] * x[1], m_units[2] * x[2]);
    const bool is_finite = std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
    return is_finite && is_inside(p) ? std::optional<Point>(p) : std::nullopt;
  }

  // A kernel thinner than the distance of floating point numbers contains many of them nevertheless, if it is wide and
  // not parallel to an axis: points in it, rounded, are inside now and then.
  template <typename Is_inside>
  std::optional<Point> sample(const Vector& deepest, const Is_inside& is_inside) const
  {
    const std::vector<Vector> extreme = extreme_points();
    std::minstd_rand random; // always the same numbers
    for(int k = 0; k < number_of_samples && ! extreme.empty(); ++k)
    {
      Vector x = deepest;
      for(const Vector& e : extreme)
      {
        const double t = static_cast<double>(random()) / random.max() / 2;
        x += t * (e - x);
      }
      if(const std::optional<Point> p = point_if(m_diameter * x, is_inside))
        return p;
    }
    return std::nullopt;
  }

  // The farthest ones in the directions of the axes, in units of the diameter.
  std::vector<Vector> extreme_points() const
  {
    std::vector<Vector> result;
    for(const Vector& axis : { Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1) })
      for(const Vector& objective : { axis, - axis })
        if(const std::optional<Deep_point> point = maximize(objective, 0))
          result.push_back(point->x);
    return result;
  }

  // Maximizes objective * x + r_max * r over the points x that are at least as deep as r, 0 <= r <= r_max, in units of
  // the diameter.
  //
  // The dual program is what is solved: its variables are the multipliers of the half spaces and of the bound on r. It
  // has four rows, however many faces there are, and the rows are what the solver's time grows with. The multipliers of
  // its own solution are x and - r.
  std::optional<Deep_point> maximize(const Vector& objective, const int r_max) const
  {
    typedef CGAL::Quadratic_program<double> Program;
    Program lp(CGAL::EQUAL, true, 0, false, 0);
    int column = 0;
    for(const Half_space& h : m_half_spaces)
    {
      for(int i = 0; i < 3; ++i)
        lp.set_a(column, i, h.normal[i]);
      lp.set_a(column, 3, 1);
      lp.set_c(column, - h.offset / m_diameter);
      ++column;
    }
    lp.set_a(column, 3, 1);
    lp.set_c(column, r_max);
    for(int i = 0; i < 3; ++i)
      lp.set_b(i, - objective[i]);
    lp.set_r(3, CGAL::LARGER);
    lp.set_b(3, r_max);
    CGAL::Quadratic_program_options options;
    options.set_pricing_strategy(CGAL::QP_BLAND); // which cannot cycle: all but one of the right-hand sides may be zero
    const CGAL::Quadratic_program_solution<Exact_float> solution
      = CGAL::solve_linear_program(lp, Exact_float(), options);
    if(! solution.is_optimal())
      return std::nullopt;
    const double denominator = CGAL::to_double(solution.variables_common_denominator());
    std::array<double, 4> values; // of the three coordinates and - r
    std::transform(solution.optimality_certificate_numerators_begin(), solution.optimality_certificate_numerators_end(),
                   values.begin(),
                   [&](const Exact_float& numerator) { return CGAL::to_double(numerator) / denominator; });
    return Deep_point{ Vector(values[0], values[1], values[2]), - m_diameter * values[3] };
  }

  static constexpr int max_number_of_bisections = 50;
  static constexpr int number_of_samples = 500;

  const Predicates& m_predicates;
  const Point m_origin;
  const std::array<double, 3> m_units; // of the half spaces and the diameter
  double m_diameter = 0;
  std::vector<Half_space> m_half_spaces;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_VISIBILITY_KERNEL_3_H
