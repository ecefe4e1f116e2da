// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_EXPLAIN_BAD_CELLS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_EXPLAIN_BAD_CELLS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * What is above a wall, as seen from the center of its inscribed circle, on the side of a cell that has it.
 *
 * Let a be the point at the height r tan(t) above the center, where r is the radius of the circle: seen from there, the
 * wall has the dihedral angle t at each of its edges. A cell with this wall whose angles at these edges are t or more
 * contains a, and all between a and the center. So if another wall crosses that segment, there is no such cell.
 */
template <typename Tr>
class Ceiling_of_wall_3
{
public:
  typedef typename Tr::Cell_handle Cell_handle;
  typedef typename Tr::Facet       Facet;
  typedef Selected_domain_3<Tr>    Domain;

  // The domain must exist as long as this does; the wall is one of a cell of it.
  Ceiling_of_wall_3(const Domain& domain, const Facet& wall, const double min_dihedral_angle)
    : m_domain(domain), m_wall(wall)
  {
    const auto vertices = internal::facet_vertices(wall.first, wall.second);
    std::array<Coordinates_3, 3> p = internal::corners(vertices);
    Axis_box_3 box;
    for(const Coordinates_3& corner : p)
      box.add(corner);
    m_frame = Unit_frame_3(box);
    for(Coordinates_3& corner : p)
      corner = m_frame.to_frame(corner);
    set_circle(p);
    m_limit = m_radius * std::tan((std::min)(min_dihedral_angle, largest_target) * (CGAL_PI / 180));
  }

  // Looks for the first wall above. Returns whether it is below the limit, and has no edge in common with this one.
  bool is_low()
  {
    if(! (m_limit > 0))
      return false;
    Facet entry = m_wall;
    for(int step = 0; step < max_number_of_steps; ++step)
    {
      const Facet face(entry.first, leave(entry));
      if(! (m_height < m_limit) || m_domain.is_wall(face.first, face.second))
      {
        m_ceiling = face;
        return m_height < m_limit && ! is_neighbor(face);
      }
      const Cell_handle next = face.first->neighbor(face.second);
      entry = Facet(next, next->index(face.first));
    }
    return false;
  }

  // Whether no vertex of the cell is farther from the plane of the wall than the limit.
  bool is_near(const Cell_handle c) const
  {
    const Cell_corners_3 p = scaled_corners(c);
    return std::all_of(p.begin(), p.end(), [&](const Coordinates_3& corner)
    {
      return std::abs(dot_product(difference(corner, m_center), m_normal)) < m_limit;
    });
  }

  // What is_low() found.
  const Facet& ceiling() const { return m_ceiling; }
  double height() const { return m_frame.from_frame(m_height); }

  // An upper bound of the smallest angle of all cells that have the wall, in degrees.
  double largest_angle() const { return std::atan2(m_height, m_radius) * (180 / CGAL_PI); }

private:
  // See "Tuning constants" in the manual.
  static constexpr double largest_target = 60;      // the limit is less than any edge of the wall is long
  static constexpr int max_number_of_steps = 1000;

  void set_circle(const std::array<Coordinates_3, 3>& p)
  {
    const Coordinates_3 lengths = {{ internal::distance(p[1], p[2]), internal::distance(p[2], p[0]),
                                     internal::distance(p[0], p[1]) }};
    const double perimeter = lengths[0] + lengths[1] + lengths[2];
    const Coordinates_3 normal = cross_product(difference(p[1], p[0]), difference(p[2], p[0]));
    const double length = std::sqrt(dot_product(normal, normal));
    m_radius = length / perimeter;
    for(int i = 0; i < 3; ++i)
    {
      m_center[i] = (lengths[0] * p[0][i] + lengths[1] * p[1][i] + lengths[2] * p[2][i]) / perimeter;
      m_normal[i] = normal[i] / length;
    }
  }

  Cell_corners_3 scaled_corners(const Cell_handle c) const
  {
    Cell_corners_3 p = internal::corners(c);
    for(Coordinates_3& corner : p)
      corner = m_frame.to_frame(corner);
    return p;
  }

  // The index of the facet through which the ray leaves the cell that it enters there, and sets the height of that.
  int leave(const Facet& entry)
  {
    const Cell_corners_3 p = scaled_corners(entry.first);
    const Cell_shape_3 shape(p);
    int facet = entry.second;
    m_height = std::numeric_limits<double>::infinity();
    for(int i = 0; i < 4; ++i)
    {
      const double outwards = - dot_product(shape.normals[i], m_normal);
      const double height = dot_product(shape.normals[i], difference(m_center, p[(i + 1) % 4])) / outwards;
      if(i == entry.second || ! (outwards > 0) || ! (height < m_height))
        continue;
      facet = i;
      m_height = height;
    }
    return facet;
  }

  bool is_neighbor(const Facet& other) const
  {
    const auto v = internal::facet_vertices(m_wall.first, m_wall.second);
    const auto w = internal::facet_vertices(other.first, other.second);
    return std::count_if(v.begin(), v.end(), [&](const auto u) { return internal::contains(w, u); }) >= 2;
  }

  const Domain& m_domain;
  Facet m_wall, m_ceiling;
  Unit_frame_3 m_frame; // the members below are in it
  Coordinates_3 m_center, m_normal;
  double m_radius, m_limit, m_height = 0;
};

/*
 * Makes the certificate: says of each cell with a dihedral angle below the target what makes it so.
 *
 * Most of those that nothing explains are beside a needle. That proves nothing, but it tells where to look.
 */
template <typename Tr>
class Explain_bad_cells_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef typename Tr::Facet         Facet;
  typedef Selected_domain_3<Tr>      Domain;
  typedef Quality_certificate_3<Tr>  Certificate;
  typedef Bad_cell_3<Tr>             Bad_cell;

  Explain_bad_cells_3(const Tr& tr, const Domain& domain, const double min_dihedral_angle)
    : m_tr(tr), m_domain(domain), m_surely_good(internal::signed_square_of_cotangent(min_dihedral_angle + slack)),
      m_walls_at_edge(domain)
  {
    m_certificate.min_dihedral_angle = min_dihedral_angle;
  }

  // Whether a cell with these angles is bad.
  bool is_bad(const Cell_angles_3& angles) const
  {
    return ! (angles.square_of_largest_cotangent() < m_surely_good) && angles.smallest() < target();
  }

  // Lists the cell if it is bad.
  void add(const Cell_handle c, const Cell_angles_3& angles)
  {
    if(! is_bad(angles))
      return;
    const int* const ends = edges_of_cell[angles.edge_of_smallest()];
    Bad_cell bad;
    bad.cell = c;
    bad.min_dihedral_angle = angles.smallest();
    bad.edge = {{ c->vertex(ends[0]), c->vertex(ends[1]) }};
    bad.reason = Bad_cell_reason::not_improved;
    for(int k = 0; k < 6; ++k)
      if(angles[k] < target())
        look_for_walls(bad, k, angles[k]);
    if(bad.reason == Bad_cell_reason::not_improved)
      look_for_gap(bad);
    if(bad.reason == Bad_cell_reason::not_improved)
      look_for_needle(bad);
    m_certificate.cells.push_back(bad);
  }

  // It is empty, and says so, if not all cells were looked at.
  Certificate certificate(const bool is_complete = true)
  {
    m_certificate.is_complete = is_complete;
    if(! is_complete)
      m_certificate.cells.clear();
    std::stable_sort(m_certificate.cells.begin(), m_certificate.cells.end(), [](const Bad_cell& a, const Bad_cell& b)
    {
      return a.min_dihedral_angle < b.min_dihedral_angle;
    });
    return std::move(m_certificate);
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr double thinner_than_needle = 0.5;
  static constexpr int max_number_of_cells = 100;
  static constexpr double slack = 1e-6; // degrees

  double target() const { return m_certificate.min_dihedral_angle; }

  // Whether the angle at the edge k is between two walls that are less than the target apart.
  void look_for_walls(Bad_cell& bad, const int k, const double angle) const
  {
    const auto walls = m_walls_at_edge(bad.cell, k, angle, target());
    if(! walls || (bad.reason == Bad_cell_reason::forced && ! (walls->angle < bad.surface_angle)))
      return;
    bad.reason = Bad_cell_reason::forced;
    bad.facets = walls->facets;
    bad.surface_angle = walls->angle;
  }

  // Whether a wall of the cell is below another one, or if it has none of that kind, one at an edge of it.
  void look_for_gap(Bad_cell& bad) const
  {
    for(int i = 0; i < 4; ++i)
      if(m_domain.is_wall(bad.cell, i))
        look_above(bad, Facet(bad.cell, i));
    if(bad.reason == Bad_cell_reason::gap)
      return;
    for(int k = 0; k < 6; ++k)
    {
      const int* const others = edges_of_cell[5 - k];
      look_above_next_wall(bad, others[0], others[1]);
      look_above_next_wall(bad, others[1], others[0]);
    }
  }

  void look_above_next_wall(Bad_cell& bad, const int across, const int kept) const
  {
    Edge_walk_3<Tr> walk(bad.cell, across, kept);
    for(int step = 0; step < max_number_of_cells; ++step)
    {
      if(m_domain.is_wall(walk.cell(), walk.next_facet()))
      {
        if(step > 0)
          look_above(bad, Facet(walk.cell(), walk.next_facet()));
        return;
      }
      ++walk;
      if(walk.cell() == bad.cell)
        return;
    }
  }

  // Of several gaps, the narrowest one is named.
  void look_above(Bad_cell& bad, const Facet& wall) const
  {
    Ceiling_of_wall_3<Tr> ceiling(m_domain, wall, target());
    if((wall.first != bad.cell && ! ceiling.is_near(bad.cell)) || ! ceiling.is_low())
      return;
    if(bad.reason == Bad_cell_reason::gap && ! (ceiling.height() < bad.distance))
      return;
    bad.reason = Bad_cell_reason::gap;
    bad.facets = {{ wall, ceiling.ceiling() }};
    bad.surface_angle = ceiling.largest_angle();
    bad.distance = ceiling.height();
  }

  // The constrained facet with the smallest plane angle of those that were looked at, if that is below the target.
  struct Needle
  {
    Facet facet;
    double angle = std::numeric_limits<double>::infinity();
  };

  // One of the cell, if that is about as thin. Else what may be the cause is named: walls that the cell is flat on, or
  // a needle that has an edge of it, or a vertex.
  void look_for_needle(Bad_cell& bad)
  {
    const Needle needle = needle_of(bad.cell);
    if(thinner_than_needle * needle.angle < bad.min_dihedral_angle && name(needle, bad))
      bad.reason = Bad_cell_reason::needle;
    else if(! name_flat_walls(bad) && ! name(needle_at_edges(bad.cell), bad))
      name(needle_at_vertices(bad.cell), bad);
  }

  // Two walls of the cell that are nearly in a plane, so that it fills the angle between them.
  bool name_flat_walls(Bad_cell& bad) const
  {
    const Cell_angles_3 angles(internal::corners(bad.cell));
    for(int k = 0; k < 6; ++k)
    {
      const int* const facets = edges_of_cell[5 - k];
      if(angles[k] > 180 - target() && m_domain.is_wall(bad.cell, facets[0]) && m_domain.is_wall(bad.cell, facets[1]))
      {
        bad.facets = {{ Facet(bad.cell, facets[0]), Facet(bad.cell, facets[1]) }};
        bad.surface_angle = angles[k];
        return true;
      }
    }
    return false;
  }

  // Returns whether there is one.
  static bool name(const Needle& needle, Bad_cell& bad)
  {
    if(needle.facet == Facet())
      return false;
    bad.facets[0] = needle.facet;
    bad.surface_angle = needle.angle;
    return true;
  }

  Needle needle_of(const Cell_handle c) const
  {
    Needle needle;
    for(int i = 0; i < 4; ++i)
      look_at(c, i, needle);
    return needle;
  }

  // Where an edge has very many cells, some of them are looked at: a needle at it has its vertices, too.
  Needle needle_at_edges(const Cell_handle c) const
  {
    Needle needle;
    for(int k = 0; k < 6; ++k)
    {
      Edge_walk_3<Tr> walk(c, edges_of_cell[5 - k][0], edges_of_cell[5 - k][1]);
      int step = 0;
      do
      {
        if(m_domain.contains(walk.cell()))
          for(const int i : { walk.next_facet(), walk.cell()->index(walk.apex()) })
            look_at(walk.cell(), i, needle);
        ++walk;
      }
      while(walk.cell() != c && ++step < max_number_of_cells);
    }
    return needle;
  }

  Needle needle_at_vertices(const Cell_handle c)
  {
    Needle needle;
    for(int i = 0; i < 4; ++i)
    {
      const Needle& other = needle_at(c->vertex(i));
      if(other.angle < needle.angle)
        needle = other;
    }
    return needle;
  }

  // It is searched for once: there may be many bad cells at a vertex of many cells.
  const Needle& needle_at(const Vertex_handle v)
  {
    if(m_needles.is_defined(v))
      return m_needles[v];
    Needle needle;
    m_star.clear();
    m_tr.tds().incident_cells(v, std::back_inserter(m_star));
    for(const Cell_handle c : m_star)
      if(m_domain.contains(c))
        for(int i = 0; i < 4; ++i)
          if(c->vertex(i) != v)
            look_at(c, i, needle);
    return m_needles[v] = needle;
  }

  // The facet opposite to the vertex i of a cell of the domain.
  void look_at(const Cell_handle c, const int i, Needle& needle) const
  {
    if(! m_domain.is_wall(c, i))
      return;
    const double angle = internal::smallest_plane_angle(internal::corners(internal::facet_vertices(c, i)));
    if(angle < target() && angle < needle.angle)
      needle = Needle{ Facet(c, i), angle };
  }

  const Tr& m_tr;
  const Domain& m_domain;
  const double m_surely_good; // if the largest cotangent is less, no angle need be found
  Walls_at_edge_3<Tr> m_walls_at_edge;
  Certificate m_certificate;
  CGAL::Unique_hash_map<Vertex_handle, Needle> m_needles; // of those that were asked for
  std::vector<Cell_handle> m_star;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_EXPLAIN_BAD_CELLS_3_H
