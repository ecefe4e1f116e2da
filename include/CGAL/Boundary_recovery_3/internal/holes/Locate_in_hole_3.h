// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_LOCATE_IN_HOLE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_LOCATE_IN_HOLE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/walk_to.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Box_hierarchy_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/NT_converter.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Finds the old cell of a hole in which a place is.
 *
 * Old cells may be inverted, and overlap. But the boundary of the hole, and that of each region in it, is a valid
 * surface; so at each place inside there is one cell more that is positive than there are inverted ones, which fold
 * back: a positive cell of the region is there, and decided on by exact predicates.
 *
 * A walk from a cell nearby finds it, unless an inverted cell or the boundary is in the way. Then the cells nearby are
 * looked at, and, if that does not help, all cells around the place, of which the largest one is taken.
 */
template <typename Kernel>
class Locate_in_hole_3
{
public:
  typedef typename Kernel::Point_3     Point_3;
  typedef Moved_mesh_3<Point_3>        Mesh;
  typedef Old_mesh_location_3          Location;

  static constexpr std::size_t none = std::size_t(-1);

  // The hole is named by one of its cells.
  Locate_in_hole_3(const Mesh& mesh, const Tetrahedra_incidences_3& incidences, const Hole_cells_3& hole_cells,
                   const std::vector<std::size_t>& cells)
    : m_mesh(mesh), m_incidences(incidences), m_hole_cells(hole_cells), m_cells(cells)
  { }

  // A cell of the hole at an old vertex, to start from, or none.
  std::size_t cell_at(const std::size_t v) const
  {
    for(const std::size_t c : m_incidences.cells(v))
      if(is_in_hole(c))
        return c;
    return none;
  }

  // `region` is the caller's number, and `start` a cell of the hole, or none. If there is no such cell, the place is
  // not in that region of the hole.
  Location operator()(const Point_3& p, const int region, const std::size_t start)
  {
    std::size_t cell = start == none ? none : walk(p, region, start);
    if(cell == none && start != none)
      cell = look_around(p, region, start);
    return cell == none ? search(p, region) : Location{ cell, coordinates(cell, p) };
  }

private:
  typedef std::array<double, 4> Weights;

  static constexpr int max_number_of_steps = 50;
  static constexpr std::size_t max_number_of_neighbors = 100;
  static constexpr double least_volume = 1e-4;   // of a cell, in cubes of its edges, for floating point numbers
  static constexpr double least_number = 1e-200; // below it, and above its inverse, volumes may leave their range

  struct Best
  {
    std::size_t cell = none;
    double volume = 0;
  };

  bool is_in_hole(const std::size_t cell) const { return m_hole_cells.are_in_same_hole(cell, m_cells.front()); }

  // Whether it can be the cell of a place in that region, or be on the way there.
  bool is_passable(const std::size_t cell, const int region) const
  {
    return m_mesh.regions[cell] == region && m_mesh.is_positive(cell);
  }

  // None if the way is barred.
  std::size_t walk(const Point_3& p, const int region, const std::size_t start) const
  {
    if(! is_in_hole(start) || ! is_passable(start, region))
      return none;
    const auto cell_behind = [&](const std::size_t c, const int i) -> std::optional<std::size_t>
    {
      const std::size_t side = m_incidences.opposite(4 * c + static_cast<std::size_t>(i));
      if(side == none || ! is_in_hole(side / 4) || ! is_passable(side / 4, region))
        return std::nullopt;
      return side / 4;
    };
    return internal::walk_to(start, max_number_of_steps,
                             [&](const std::size_t c) { return facet_towards(p, c); }, cell_behind).value_or(none);
  }

  // Looks at the cells of the hole that are nearest to one of them, as steps go.
  std::size_t look_around(const Point_3& p, const int region, const std::size_t start) const
  {
    boost::container::small_vector<std::size_t, max_number_of_neighbors> cells;
    if(is_in_hole(start))
      cells.push_back(start);
    for(std::size_t k = 0; k < cells.size(); ++k)
    {
      const std::size_t c = cells[k];
      if(is_passable(c, region) && facet_towards(p, c) < 0)
        return c;
      for(std::size_t i = 0; i < 4 && cells.size() < max_number_of_neighbors; ++i)
      {
        const std::size_t side = m_incidences.opposite(4 * c + i);
        if(side != none && is_in_hole(side / 4) && ! internal::contains(cells, side / 4))
          cells.push_back(side / 4);
      }
    }
    return none;
  }

  // The index of a facet of a positive cell that has p behind it; negative if p is inside, or on the boundary.
  int facet_towards(const Point_3& p, const std::size_t cell) const
  {
    for(int i = 0; i < 4; ++i)
      if(orientation_with(p, cell, static_cast<std::size_t>(i)) == NEGATIVE)
        return i;
    return -1;
  }

  Location search(const Point_3& p, const int region)
  {
    if(! m_is_ordered)
      order_cells();
    Best best;
    const auto is_of_interest = [](const std::size_t, const double squared_distance) { return squared_distance <= 0; };
    const Coordinates_3 q = m_frame.to_frame(internal::coordinates_of(p));
    m_hierarchy.search(q, is_of_interest, [&](const std::size_t k) { look_at(m_positive_cells[k], p, region, best); });
    if(best.cell == none) // boxes are rounded, and so are coordinates if the kernel has better ones
      for(const std::size_t c : m_positive_cells)
        look_at(c, p, region, best);
    return best.cell == none ? Location() : Location{ best.cell, coordinates(best.cell, p) };
  }

  // Brings the positive cells into the order of a hierarchy of their boxes.
  void order_cells()
  {
    Axis_box_3 box;
    for(const std::size_t c : m_cells)
      if(m_mesh.is_positive(c))
      {
        m_positive_cells.push_back(c);
        for(const Coordinates_3& p : m_mesh.corners(c))
          box.add(p);
      }
    m_frame = Unit_frame_3(box);
    m_hierarchy = Box_hierarchy_3<1>(boxes());
    m_hierarchy.put_into_order(m_positive_cells);
    m_is_ordered = true;
  }

  std::vector<Axis_box_3> boxes() const
  {
    std::vector<Axis_box_3> boxes(m_positive_cells.size());
    for(std::size_t k = 0; k < boxes.size(); ++k)
      for(const Coordinates_3& p : m_mesh.corners(m_positive_cells[k]))
        boxes[k].add(m_frame.to_frame(p));
    return boxes;
  }

  void look_at(const std::size_t cell, const Point_3& p, const int region, Best& best) const
  {
    if(m_mesh.regions[cell] != region || facet_towards(p, cell) >= 0)
      return;
    const double volume = Cell_shape_3(m_mesh.corners(cell)).volume_times_6;
    if(best.cell == none || volume > best.volume || (volume == best.volume && cell < best.cell))
      best = Best{ cell, volume };
  }

  // That of the cell with p in the place of its vertex i.
  Orientation orientation_with(const Point_3& p, const std::size_t cell, const std::size_t i) const
  {
    std::array<const Point_3*, 4> q;
    for(std::size_t k = 0; k < 4; ++k)
      q[k] = k == i ? &p : &m_mesh.points[m_mesh.tetrahedra[cell][k]];
    return Kernel().orientation_3_object()(*q[0], *q[1], *q[2], *q[3]);
  }

  // By exact numbers if the cell is so thin that those seen from p are not precise enough.
  Weights coordinates(const std::size_t cell, const Point_3& p) const
  {
    const Cell_corners_3 t = m_mesh.corners(cell);
    const double volume = Cell_shape_3(t).volume_times_6;
    const bool is_ordinary = volume > least_number && volume < 1 / least_number &&
                             Cell_shape_3(internal::scaled_corners(t)).volume_times_6 >= least_volume;
    return is_ordinary ? parts<double>(cell, p).coordinates() : parts<Rational>(cell, p).coordinates();
  }

  template <typename Number>
  static Number to_number(const typename Kernel::FT& x)
  {
    if constexpr(std::is_same<Number, double>::value)
      return CGAL::to_double(x);
    else
      return NT_converter<typename Kernel::FT, Number>()(x);
  }

  template <typename Number>
  Parts_of_cell_3<Number> parts(const std::size_t cell, const Point_3& p) const
  {
    std::array<std::array<Number, 3>, 4> q;
    for(std::size_t k = 0; k < 4; ++k)
      for(int j = 0; j < 3; ++j)
        q[k][j] = to_number<Number>(m_mesh.points[m_mesh.tetrahedra[cell][k]][j]) - to_number<Number>(p[j]);
    return Parts_of_cell_3<Number>(q);
  }

  const Mesh& m_mesh;
  const Tetrahedra_incidences_3& m_incidences;
  const Hole_cells_3& m_hole_cells;
  const std::vector<std::size_t>& m_cells;   // of the hole
  bool m_is_ordered = false;                 // whether the following are there
  std::vector<std::size_t> m_positive_cells; // in the order of the hierarchy
  Unit_frame_3 m_frame;
  Box_hierarchy_3<1> m_hierarchy;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_LOCATE_IN_HOLE_3_H
