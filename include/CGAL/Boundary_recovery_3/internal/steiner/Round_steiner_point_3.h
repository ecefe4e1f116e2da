// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ROUND_STEINER_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ROUND_STEINER_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Gives Steiner points on constraints positions that the triangulation can store, beside the constraint if need be.
 */
template <typename Tr>
class Round_steiner_point_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Cell_handle       Cell_handle;
  typedef Vertex_predicates_3<Tr>        Predicates;
  typedef Exact_positions_3<Tr>          Positions;
  typedef typename Positions::Point_3    Point_3;

  // `predicates` know of `positions`.
  Round_steiner_point_3(const Tr& tr, const Predicates& predicates, Positions& positions)
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
    const auto faces = internal::faces_of_star(m_star, v);
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

/*
 * Gives a free Steiner point a position that the triangulation can store, and that sees its star: the nearest one, the
 * deepest one, any other; and where no number fits into the kernel of the star, one in a larger cavity.
 */
template <typename Tr>
class Round_free_point_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;

  explicit Round_free_point_3(Mesh& mesh) : m_mesh(mesh), m_move_into_kernel(mesh.predicates, mesh.positions) { }

  // Returns whether v has such a position then. Once stopped, only what is quick is tried.
  bool operator()(const Vertex_handle v)
  {
    if(! m_mesh.positions.contains(v))
      return true;
    internal::collect_star(m_mesh.tr, v, m_star);
    const auto faces = internal::faces_of_star(m_star, v);
    const typename Mesh::Exact_point exact = m_mesh.positions(v);
    m_mesh.positions.erase(v);
    if(m_move_into_kernel.is_in_kernel(v, faces) || m_move_into_kernel(v, faces)
       || (m_mesh.context.go_further() && m_move_into_kernel.move_near(v, faces, exact)) || star_from_nearby(v))
      return true;
    m_mesh.positions.set(v, exact);
    return false;
  }

  // Where v has no such position: moves it to the middle of the kernel of its star.
  void center(const Vertex_handle v)
  {
    if(! m_mesh.positions.contains(v))
      return;
    internal::collect_star(m_mesh.tr, v, m_star);
    m_move_into_kernel.center(v, internal::faces_of_star(m_star, v));
  }

private:
  typedef typename Mesh::Positions   Positions;
  typedef Cavity_3<Tr>               Cavity;

  // Where no number fits into the kernel of the star of v: moves v to the center of a cell nearby, and adds the cells
  // behind the faces of the star that it does not see from there, and so on. Of the centers for which this ends, that
  // with the fewest cells is taken. Returns whether there is one; all the cells around v are new then. If not, v is
  // somewhere.
  bool star_from_nearby(const Vertex_handle v)
  {
    typename Positions::Point_3 best_center;
    std::optional<Cavity> best;
    for(const Cell_handle c : cells_near_star(v))
    {
      if(! m_mesh.context.go_further())
        break;
      v->set_point(center(c));
      Cavity cavity(m_mesh.tr, m_mesh.constraints, m_star);
      const std::size_t max_number = best ? best->cells().size() - 1 : max_number_of_cells;
      if(! internal::grow_until_seen(cavity, v, m_mesh.predicates, max_number) || ! can_be_starred(cavity))
        continue;
      best.emplace(std::move(cavity));
      best_center = v->point();
    }
    if(! best)
      return false;
    v->set_point(best_center);
    internal::star_and_forget(m_mesh.editor, m_mesh.ledger, *best, v);
    return true;
  }

  // Of a cavity of which all faces are seen.
  bool can_be_starred(Cavity& cavity) const
  {
    std::vector<typename Cavity::Vertex_triple> faces;
    std::vector<Vertex_handle> inner_points;
    return cavity.collect_boundary(m_mesh.ledger.free_points(), faces, inner_points);
  }

  // The finite cells that share a vertex with the star of v.
  std::vector<Cell_handle> cells_near_star(const Vertex_handle v) const
  {
    Cavity result(m_mesh.tr, m_mesh.constraints); // it takes finite cells only, and each once
    std::vector<Cell_handle> star;
    for(const Vertex_handle w : internal::vertices_without(m_star, v))
    {
      star.clear();
      m_mesh.tr.incident_cells(w, std::back_inserter(star));
      for(const Cell_handle c : star)
        result.add(c);
    }
    return result.cells();
  }

  typename Positions::Point_3 center(const Cell_handle c) const
  {
    std::array<double, 3> x = {{ 0, 0, 0 }};
    for(int i = 0; i < 4; ++i)
      for(int k = 0; k < 3; ++k)
        x[k] += m_mesh.predicates.approximate_point(c->vertex(i))[k] / 4; // a sum may be out of range
    return typename Positions::Point_3(x[0], x[1], x[2]);
  }

  // Of a star that is enlarged until its vertex sees all, see "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_cells = 1000;

  Mesh& m_mesh;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  std::vector<Cell_handle> m_star;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_ROUND_STEINER_POINT_3_H
