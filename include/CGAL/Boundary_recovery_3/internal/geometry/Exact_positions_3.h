// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POSITIONS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POSITIONS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/numbers/Homogeneous_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/nearest_integer.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <type_traits>
#include <unordered_map>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The exact positions of vertices.
 *
 * A point on a constraint has no position in floating point numbers, in general. While a Steiner point is there, its
 * vertex has the rounded position in the triangulation and the exact one here, beside it. All other vertices are
 * exactly where the triangulation says. If the numbers of the kernel are exact, nothing is kept here.
 */
template <typename Tr>
class Exact_positions_3
{
public:
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef typename Tr::Geom_traits::Point_3  Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel Kernel;
  typedef typename Kernel::FT                FT;

  static constexpr bool is_kernel_exact = Algebraic_structure_traits<FT>::Is_exact::value;

  // Not lazy numbers: most positions are needed exactly at once.
  typedef std::conditional_t<is_kernel_exact, Kernel, Simple_cartesian<Rational> > Exact_kernel;
  typedef typename Exact_kernel::FT          Exact_FT;
  typedef typename Exact_kernel::Point_3     Exact_point_3;

  typedef Interval_nt<false>                 Interval;
  typedef Simple_cartesian<Interval>         Interval_kernel;
  typedef Interval_kernel::Point_3           Interval_point_3;

  typedef Homogeneous_point_3                Homogeneous_point;

  // A position that is not the one in the triangulation.
  struct Position
  {
    Exact_point_3 exact;
    Interval_point_3 box;          // around it, for filters
    Homogeneous_point homogeneous; // for orientations when filters fail
  };

  // Whether every vertex is where the triangulation says.
  bool empty() const { return m_positions.empty(); }

  bool contains(const Vertex_handle v) const { return find(v) != nullptr; }

  // The position of v, or none if v is where the triangulation says.
  const Position* find(const Vertex_handle v) const
  {
    const auto it = m_positions.find(&*v);
    return it == m_positions.end() ? nullptr : &it->second;
  }

  Exact_point_3 operator()(const Vertex_handle v) const
  {
    if constexpr(is_kernel_exact)
      return internal::bare_point<Point_3>(v->point());
    else
    {
      const Position* const position = find(v);
      const Cartesian_converter<Kernel, Exact_kernel> to_exact;
      return position == nullptr ? to_exact(internal::bare_point<Point_3>(v->point())) : position->exact;
    }
  }

  // The position of v as a box around it, for filters, and in homogeneous coordinates, for orientations when filters
  // fail; `position` is what find(v) returned. Not to be called with exact kernels, nor is to_homogeneous().
  static Interval_point_3 box(const Vertex_handle v, const Position* const position)
  {
    return position == nullptr ? box(internal::bare_point<Point_3>(v->point())) : position->box;
  }

  static Homogeneous_point homogeneous(const Vertex_handle v, const Position* const position)
  {
    if(position != nullptr)
      return position->homogeneous;
    const Point_3& p = internal::bare_point<Point_3>(v->point());
    return Homogeneous_point::from_doubles(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  static Homogeneous_point to_homogeneous(const Exact_point_3& p)
  {
    return Homogeneous_point::from_rationals(p.x(), p.y(), p.z());
  }

  void set(const Vertex_handle v, const Exact_point_3& p)
  {
    if constexpr(is_kernel_exact)
      v->set_point(p);
    else
    {
      v->set_point(Point_3(internal::nearest_double(p.x()), internal::nearest_double(p.y()),
                           internal::nearest_double(p.z())));
      m_positions[&*v] = { p, box(p), to_homogeneous(p) };
    }
  }

  // From now on, v is where the triangulation says.
  void erase(const Vertex_handle v) { m_positions.erase(&*v); }

private:
  template <typename Point>
  static Interval_point_3 box(const Point& p)
  {
    const Interval x = CGAL::to_interval(p.x()), y = CGAL::to_interval(p.y()), z = CGAL::to_interval(p.z());
    return Interval_point_3(x, y, z);
  }

  std::unordered_map<const void*, Position> m_positions; // look-up only
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_EXACT_POSITIONS_3_H
