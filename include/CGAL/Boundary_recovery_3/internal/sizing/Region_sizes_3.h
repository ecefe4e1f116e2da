// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_REGION_SIZES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_REGION_SIZES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Vertex_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

struct Part_of_sizes { };

/*
 * The sizes that the filling asks for: sizes at points in cells, from the size field, and lower bounds of sizes, which
 * follow from the sizes at vertices without asking the field.
 *
 * In a cell, sizes grow from the sizes at its vertices by at most `largest_growth` per length, even if the sizes of the
 * field grow faster: a mesh with a larger grading has bad cells. Therefore `set_walls()` lowers the sizes at vertices
 * of walls to the size of the walls. `restore_sizes_of_field()` undoes this when the filling is done.
 */
template <typename Tr>
class Region_sizes_3
{
public:
  typedef typename Tr::Vertex_handle          Vertex_handle;
  typedef typename Tr::Cell_handle            Cell_handle;
  typedef typename Tr::Geom_traits::Point_3   Point_3;
  typedef Size_query_3<Tr>                    Query;

  // The size that the field asks for at a point, and the size that cells can have there, which is smaller if the sizes
  // at the vertices of the cell are. Both are NaN if the field has no size there.
  struct Size { double asked, possible; };

  Region_sizes_3(const Tr& tr, const Size_field_3<Point_3>& field) : m_query(field), m_at_vertices(tr) { }

  // The same sizes, for a part of the mesh; those of the whole may not change meanwhile.
  Region_sizes_3(const Region_sizes_3& whole, Part_of_sizes)
    : m_query(whole.m_query), m_whole(&whole), m_has_different_regions(whole.m_has_different_regions),
      m_constant(whole.m_constant)
  { }

  // Asks the field for the sizes at the vertices of these cells. At a vertex of several regions, it asks for the size
  // in each of them, and the smallest one counts. Returns false if the field has no size at one of the vertices.
  bool ask_at_vertices(const std::vector<Cell_handle>& cells)
  {
    Unique_hash_map<Vertex_handle, int> last_region(0);
    const bool is_one_region = std::all_of(cells.begin(), cells.end(), [&](const Cell_handle c)
    {
      return c->subdomain_index() == cells.front()->subdomain_index();
    });
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle v = c->vertex(i);
        if(m_at_vertices.is_known(v) && (is_one_region || last_region[v] == region(c)))
          continue;
        if(! is_one_region)
          last_region[v] = region(c);
        const double size = m_query(internal::bare_point<Point_3>(v->point()), 3, region(c));
        if(! is_valid())
          return false;
        set_at_vertex(v, size);
      }
    return true;
  }

  // Makes sizes at vertices of walls smaller where the walls' are.
  void set_walls(const Wall_sizes_3<Tr>& walls)
  {
    for(const Vertex_handle v : walls.vertices())
      if(walls[v] > 0)
      {
        if(m_between_regions.is_defined(v))
          m_between_regions[v] = walls[v];
        if(walls[v] < m_at_vertices[v])
        {
          m_lowered.emplace_back(v, m_at_vertices[v]);
          m_at_vertices.set(v, walls[v]);
        }
      }
  }

  // The whole has to take over what changes in a part.
  void take_over(const Region_sizes_3& part)
  {
    m_lowered.insert(m_lowered.end(), part.m_lowered.begin(), part.m_lowered.end());
    if(m_query.is_valid() && ! part.is_valid())
      m_query = part.m_query;
  }

  // At all vertices, old and new ones, the sizes are those of the field again.
  void restore_sizes_of_field()
  {
    for(const auto& [v, size] : m_lowered)
      m_at_vertices.set(v, size);
    m_lowered.clear();
  }

  // The size at a place in a cell.
  Size operator()(const Coordinates_3& p, const Cell_handle c)
  {
    const double asked = of_field(p, region(c));
    return Size{ asked, possible_size(asked, p, c) };
  }

  // What the field says about a place in a region; a number, what it said at the vertices.
  double of_field(const Coordinates_3& p, const int region)
  {
    return m_query.is_constant() ? m_constant : m_query(Point_3(p[0], p[1], p[2]), 3, region);
  }

  // A lower bound of the size at the centroid of a cell, 0 if none is known; `corners` are the corners of the cell.
  double least_size_at_centroid(const Cell_handle c, const std::array<Coordinates_3, 4>& corners) const
  {
    const Coordinates_3 center = internal::centroid(corners);
    const double least = known_least_size(c, corners, center, 0);
    return least > 0 ? possible_size(least, center, c) : 0;
  }

  // A lower bound of the field in a cell within the distance `radius` of `center`, a point of the cell; 0 if none is
  // known. It follows from the sizes at the vertices.
  double known_least_size(const Cell_handle c, const std::array<Coordinates_3, 4>& corners, const Coordinates_3& center,
                          const double radius) const
  {
    double least = 0;
    if(m_query.is_constant())
      least = m_constant;
    else if(m_query.grading() < std::numeric_limits<double>::infinity())
      for(int i = 0; i < 4; ++i)
        least = (std::max)(least, m_at_vertices[c->vertex(i)]
                                    - m_query.grading() * (internal::distance(corners[i], center) + radius));
    return least;
  }

  // The same, asked from the field.
  double least_size_around(const Coordinates_3& center, const double radius, const int region)
  {
    return m_query.least_size_around(Point_3(center[0], center[1], center[2]), radius, region);
  }

  // A size that is likely at the centroid of a cell, if the sizes of the field grow with `grading`.
  double likely_size_at_centroid(const Cell_handle c, const std::array<Coordinates_3, 4>& corners,
                                 const double grading) const
  {
    const Coordinates_3 center = internal::centroid(corners);
    double likely = std::numeric_limits<double>::infinity();
    for(int i = 0; i < 4; ++i)
      likely = (std::min)(likely, m_at_vertices[c->vertex(i)] + grading * internal::distance(corners[i], center));
    return likely;
  }

  // Sets the ratio of lengths in the mesh to lengths in the coordinates of the field, a power of two.
  void set_scale(const double scale) { m_query.set_scale(scale); }

  // By how much sizes grow per length, at most; maybe infinite.
  double grading() const { return m_query.grading(); }

  // The number that a field is told for the region of a cell.
  static int region(const Cell_handle c)
  {
    if constexpr(std::is_convertible<typename Tr::Cell::Subdomain_index, int>::value)
      return static_cast<int>(c->subdomain_index());
    else
      return 1;
  }

  // Whether the field had sizes everywhere.
  bool is_valid() const { return m_query.is_valid(); }

  const Query& query() const { return m_query; }

  // New vertices are pending until the cells around them were looked at.
  void set_pending(const Vertex_handle v, const Size& size)
  {
    m_at_vertices.set_pending(v, size.possible);
    if(size.possible < size.asked)
      m_lowered.emplace_back(v, size.asked);
  }

  bool is_pending(const Vertex_handle v) const { return m_at_vertices.is_pending(v); }
  void settle(const Vertex_handle v) { m_at_vertices.settle(v); }

private:
  static constexpr double largest_growth = 0.9; // per length, see "Tuning constants" in the manual

  void set_at_vertex(const Vertex_handle v, const double size)
  {
    if(m_query.is_constant())
      m_constant = size;
    const double known = m_at_vertices.is_known(v) ? m_at_vertices[v] : size;
    if(known != size)
    {
      m_between_regions[v] = std::numeric_limits<double>::infinity();
      m_has_different_regions = true;
    }
    m_at_vertices.set(v, (std::min)(known, size));
  }

  // The size that the field asks for, or the largest size that the vertices of the cell allow, if that is smaller. NaN
  // stays NaN. The largest number means that no points are wanted, and stays, too.
  double possible_size(const double asked, const Coordinates_3& p, const Cell_handle c) const
  {
    return asked < (std::numeric_limits<double>::max)() ? (std::min)(asked, largest_size(p, c)) : asked;
  }

  // The largest size at a place in a cell that goes with the sizes at its vertices.
  double largest_size(const Coordinates_3& p, const Cell_handle c) const
  {
    double largest = std::numeric_limits<double>::infinity();
    for(int i = 0; i < 4; ++i)
    {
      const Vertex_handle v = c->vertex(i);
      const double distance = internal::distance(coordinates_of(v->point()), p);
      largest = (std::min)(largest, size_of_mesh(v) + largest_growth * distance);
    }
    return largest;
  }

  // The size at a vertex that limits the sizes in the cells around this vertex. At a vertex where the field has
  // different sizes by region, only the size of the walls counts: a small size on one side of a wall says nothing about
  // the other side.
  double size_of_mesh(const Vertex_handle v) const
  {
    const auto& between_regions = m_whole == nullptr ? m_between_regions : m_whole->m_between_regions;
    return m_has_different_regions && between_regions.is_defined(v) ? between_regions[v] : m_at_vertices[v];
  }

  Query m_query;
  Vertex_sizes_3<Tr> m_at_vertices;
  const Region_sizes_3* m_whole = nullptr; // where these are sizes of a part
  std::vector<std::pair<Vertex_handle, double> > m_lowered; // where sizes are smaller than the field's, and these
  Unique_hash_map<Vertex_handle, double> m_between_regions; // walls' sizes where the field has several; for looking up
  bool m_has_different_regions = false;
  double m_constant = 0; // if the field is a number, and was asked at a vertex
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_REGION_SIZES_3_H
