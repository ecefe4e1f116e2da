// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_ROUNDING_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_ROUNDING_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Gives Steiner points on constraints positions that the triangulation can store, beside the constraint if need be.
 */
template <typename Tr>
class Steiner_rounding_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Cell_handle       Cell_handle;
  typedef Vertex_predicates_3<Tr>        Predicates;
  typedef Exact_positions_3<Tr>          Positions;
  typedef typename Positions::Point_3    Point_3;

  // `predicates` know of `positions`.
  Steiner_rounding_3(const Tr& tr, const Predicates& predicates, Positions& positions)
    : m_tr(tr), m_predicates(predicates), m_positions(positions), m_move_into_kernel(predicates, positions)
  { }

  // Moves v to the point next to its exact position that the triangulation can store, or else to one of those around
  // it, or else, if v is not on the hull and it may take time, to one up to 2^10 times as far away as numbers are from
  // each other at the largest coordinate; such that all the cells around v are positively oriented and the hull is
  // convex. Returns false if none will do.
  bool operator()(const Vertex_handle v, const bool may_take_time)
  {
    if(! m_positions.contains(v))
      return true;
    const typename Positions::Exact_point_3 exact = m_positions(v);
    const Point_3 nearest = v->point();
    m_star.clear();
    m_tr.incident_cells(v, std::back_inserter(m_star));
    m_positions.erase(v);
    for(int number_of_moves = 0; number_of_moves <= 3; ++number_of_moves)
      for(const Moves& moves : moves_of_coordinates(number_of_moves))
      {
        v->set_point(moved(nearest, moves));
        if(is_star_valid())
          return true;
      }
    if(may_take_time && move_near(v, exact))
      return true;
    v->set_point(nearest);
    m_positions.set(v, exact);
    return false;
  }

private:
  typedef std::array<int, 3> Moves; // of the coordinates: to the next number below, none, or to the next above

  static std::vector<Moves> moves_of_coordinates(const int number_of_moves)
  {
    std::vector<Moves> result;
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
          if(x * x + y * y + z * z == number_of_moves)
            result.push_back({{ x, y, z }});
    return result;
  }

  static Point_3 moved(const Point_3& p, const Moves& moves)
  {
    std::array<double, 3> x;
    for(int i = 0; i < 3; ++i)
    {
      x[i] = CGAL::to_double(p[i]);
      if(moves[i] != 0)
        x[i] = std::nextafter(x[i], moves[i] * std::numeric_limits<double>::infinity());
    }
    return Point_3(x[0], x[1], x[2]);
  }

  bool move_near(const Vertex_handle v, const typename Positions::Exact_point_3& exact)
  {
    if(std::any_of(m_star.begin(), m_star.end(), [this](const Cell_handle c) { return m_tr.is_infinite(c); }))
      return false;
    const auto faces = internal::faces_of_ball(m_star, v);
    const double largest = (std::max)({ std::abs(CGAL::to_double(exact.x())), std::abs(CGAL::to_double(exact.y())),
                                        std::abs(CGAL::to_double(exact.z())) });
    const double spacing = largest - std::nextafter(largest, 0.);
    for(const int exponent : { 2, 6, 10 })
      if(m_move_into_kernel.move_near(v, faces, exact, std::ldexp(spacing, exponent)))
        return true;
    return false;
  }

  bool is_star_valid() const
  {
    return std::all_of(m_star.begin(), m_star.end(), [this](const Cell_handle c)
    {
      return internal::is_cell_valid(m_tr, m_predicates, c);
    });
  }

  const Tr& m_tr;
  const Predicates& m_predicates;
  Positions& m_positions;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  std::vector<Cell_handle> m_star;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_ROUNDING_3_H
