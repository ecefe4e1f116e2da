// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_MOVE_INTO_KERNEL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_MOVE_INTO_KERNEL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Visibility_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/points_in_kernel.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Moves a vertex into the open visibility kernel of a polyhedron, so that it sees all of its faces from inside.
 *
 * The exact predicates judge vertices, so each candidate is tried by putting the vertex there. If none will do, the
 * vertex is left at one of them.
 *
 * A polyhedron may be too flat to have a floating point number inside (a wall of a CAD model that is planar up to
 * rounding). Then the vertex may get an exact position, for the time being.
 */
template <typename Tr>
class Move_into_kernel_3
{
public:
  typedef typename Tr::Vertex_handle                   Vertex_handle;
  typedef Vertex_predicates_3<Tr>                      Predicates;
  typedef Exact_positions_3<Tr>                        Positions;
  typedef std::array<Vertex_handle, 3>                 Vertex_triple;
  typedef typename Positions::Point_3                  Point_3;
  typedef typename Positions::Exact_point_3            Exact_point;
  typedef typename Positions::Exact_kernel::Vector_3   Exact_vector;

  // `predicates` know of `positions`.
  Move_into_kernel_3(const Predicates& predicates, Positions& positions)
    : m_predicates(predicates), m_positions(positions), m_is_in_kernel(predicates)
  { }

  // Moves v to a point on a ray from `origin`, a point of the closed kernel, in one of the directions, or to the
  // deepest point. Each of the faces has the polyhedron on its positive side. v must have no exact position, but it
  // may get one. Returns whether it is in the kernel now.
  bool operator()(const Vertex_handle v, const std::vector<Vertex_triple>& faces,
                  const Vertex_handle origin, const std::vector<Exact_vector>& directions)
  {
    const Kernel kernel(m_predicates, faces, m_predicates.approximate_point(origin));
    const auto is_inside = is_inside_at(v, faces);
    for(const Exact_vector& d : directions)
      if(kernel.point_on_ray(approximate(d), is_inside))
        return true;
    const Exact_point start = m_positions(origin);
    std::array<double, 3> sizes = kernel.units();
    for(double& size : sizes)
      size *= kernel.diameter();
    for(const Exact_vector& d : directions)
      if(const auto p = exact_point_on_ray(m_positions, faces, start, d, sizes))
      {
        m_positions.set(v, *p);
        improve_exact_position(v, faces, kernel, start);
        return true;
      }
    return bool(kernel.deepest_point(is_inside));
  }

  // Moves v to the deepest point of the kernel, in numbers of the triangulation's kernel. v must have no exact
  // position.
  bool operator()(const Vertex_handle v, const std::vector<Vertex_triple>& faces)
  {
    const Kernel kernel(m_predicates, faces, m_predicates.approximate_point(v));
    return bool(kernel.deepest_point(is_inside_at(v, faces)));
  }

  // Moves v to a point in numbers of the triangulation's kernel, with no coordinate farther than `radius` from that of
  // `inside`, an exact point of the open kernel. v must have no exact position. This is slow, but hardly ever fails
  // where there is such a point.
  bool move_near(const Vertex_handle v, const std::vector<Vertex_triple>& faces, const Exact_point& inside,
                 const double radius = std::numeric_limits<double>::infinity())
  {
    if constexpr(Positions::is_kernel_exact)
      return false;
    else
    {
      const auto p = representable_point_in_kernel(m_positions, faces, inside, radius);
      if(! p)
        return false;
      v->set_point(Point_3((*p)[0], (*p)[1], (*p)[2]));
      return is_in_kernel(v, faces);
    }
  }

  // Moves v, which has an exact position inside, to one that is as far inside as the vertices of the kernel are in the
  // mean, roughly. Does nothing if there are too many faces.
  void center(const Vertex_handle v, const std::vector<Vertex_triple>& faces)
  {
    if constexpr(! Positions::is_kernel_exact)
      if(const auto p = center_of_kernel(m_positions, faces))
      {
        m_positions.set(v, *p);
        simplify_position(v, faces, {{ 1, 1, 1 }}, least_distance(*p, faces));
      }
  }

  // Whether v sees all the faces.
  bool is_in_kernel(const Vertex_handle v, const std::vector<Vertex_triple>& faces) const
  {
    return m_is_in_kernel(v, faces);
  }

private:
  typedef Visibility_kernel_3<Tr>        Kernel;
  typedef typename Kernel::Point         Point;
  typedef typename Kernel::Vector        Vector;
  typedef typename Positions::Exact_FT   FT;

  static Vector approximate(const Exact_vector& d)
  {
    return Vector(CGAL::to_double(d.x()), CGAL::to_double(d.y()), CGAL::to_double(d.z()));
  }

  // Puts v at a point, and tells whether it is in the kernel there.
  auto is_inside_at(const Vertex_handle v, const std::vector<Vertex_triple>& faces) const
  {
    return [this, v, &faces](const Point& p)
    {
      v->set_point(Point_3(p.x(), p.y(), p.z()));
      return this->is_in_kernel(v, faces);
    };
  }

  // From the planes of the faces, roughly. Normal vectors are divided by their largest coordinate, since their squares
  // may be out of range.
  double least_distance(const Exact_point& p, const std::vector<Vertex_triple>& faces) const
  {
    double least = std::numeric_limits<double>::infinity();
    for(const Vertex_triple& f : faces)
    {
      const Exact_point q = m_positions(f[0]);
      const Exact_vector n = CGAL::cross_product(m_positions(f[1]) - q, m_positions(f[2]) - q);
      const FT largest = (std::max)({ FT(CGAL::abs(n.x())), FT(CGAL::abs(n.y())), FT(CGAL::abs(n.z())) });
      const Vector unit = approximate(n / largest);
      least = (std::min)(least, CGAL::to_double(FT(CGAL::scalar_product(n, p - q) / largest))
                                  / std::hypot(unit[0], unit[1], unit[2]));
    }
    return least;
  }

  // v was put exactly on a ray. Gives it a position that fewer bits describe, if possible one that can be stored.
  void improve_exact_position(const Vertex_handle v, const std::vector<Vertex_triple>& faces, const Kernel& kernel,
                              const Exact_point& origin)
  {
    const Vector offset = kernel.in_units(approximate(m_positions(v) - origin));
    const double distance = std::hypot(offset[0], offset[1], offset[2]);
    simplify_position(v, faces, kernel.units(), distance);
    if(distance > thinnest * kernel.diameter()) // else no number can be expected, and linear programs are slow there
      round_to_deepest_point(v, faces, kernel);
  }

  // Gives v another exact position near it that fewer bits describe, if this is in the kernel: positions that are
  // computed from positions would become longer and longer. The distance is in the units.
  void simplify_position(const Vertex_handle v, const std::vector<Vertex_triple>& faces,
                         const std::array<double, 3>& units, const double distance)
  {
    if(! std::isnormal(distance))
      return;
    const Exact_point exact = m_positions(v);
    for(const int bits : { 4, 16, 64 })
    {
      const FT step(binary_unit(std::ilogb(distance) - bits));
      m_positions.set(v, Exact_point(nearest_multiple(exact.x(), FT(step * FT(units[0]))),
                                     nearest_multiple(exact.y(), FT(step * FT(units[1]))),
                                     nearest_multiple(exact.z(), FT(step * FT(units[2])))));
      if(is_in_kernel(v, faces))
        return;
    }
    m_positions.set(v, exact);
  }

  // Moves v, which has an exact position, to the deepest point if this can be stored.
  void round_to_deepest_point(const Vertex_handle v, const std::vector<Vertex_triple>& faces, const Kernel& kernel)
  {
    const Exact_point exact = m_positions(v);
    m_positions.erase(v);
    if(! kernel.deepest_point(is_inside_at(v, faces)))
      m_positions.set(v, exact);
  }

  static constexpr double thinnest = 1e-30; // of the diameter; numbers have 16 digits

  const Predicates& m_predicates;
  Positions& m_positions;
  Is_in_kernel_3<Tr> m_is_in_kernel;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_MOVE_INTO_KERNEL_3_H
