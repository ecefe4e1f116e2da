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

#include <CGAL/Boundary_recovery_3/Quality_certificate_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Edge_walk_3.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Makes the certificate: says of each cell with a dihedral angle below the target what makes it so.
 *
 * All cells between two walls that meet at an edge at less than the target have such an angle there, and so have those
 * of any other mesh between them.
 *
 * Most of those that nothing explains are beside a needle. That proves nothing, but it tells where to look.
 */
template <typename Tr, typename Domain>
class Explain_bad_cells_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef typename Tr::Facet           Facet;
  typedef Quality_certificate_3<Tr>    Certificate;
  typedef Bad_cell_3<Tr>               Bad_cell;

  Explain_bad_cells_3(const Tr& tr, const Domain& domain, const double min_dihedral_angle)
    : m_tr(tr), m_domain(domain)
  {
    m_certificate.min_dihedral_angle = min_dihedral_angle;
  }

  // Lists the cell if it is bad.
  void add(const Cell_handle c, const Cell_angles_3& angles)
  {
    if(! (angles.smallest() < target()))
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
    if(bad.number_of_facets() == 0)
      look_for_needle(bad);
    if(bad.number_of_facets() == 0)
      look_for_needle_at_edges(bad);
    if(bad.number_of_facets() == 0)
      look_for_needle_at_vertices(bad);
    m_certificate.cells.push_back(bad);
  }

  Certificate certificate()
  {
    std::stable_sort(m_certificate.cells.begin(), m_certificate.cells.end(), [](const Bad_cell& a, const Bad_cell& b)
    {
      return a.min_dihedral_angle < b.min_dihedral_angle;
    });
    return std::move(m_certificate);
  }

private:
  static constexpr double slack = 1; // degrees by which sums of angles are allowed to be too large before all is known

  double target() const { return m_certificate.min_dihedral_angle; }

  // Whether the angle at the edge k is between two walls that are less than the target apart.
  void look_for_walls(Bad_cell& bad, const int k, double sum_of_angles) const
  {
    const Vertex_handle u = bad.cell->vertex(edges_of_cell[k][0]), v = bad.cell->vertex(edges_of_cell[k][1]);
    const int* const others = edges_of_cell[5 - k];
    Edge_walk_3<Tr> there(bad.cell, others[0], others[1]), back(bad.cell, others[1], others[0]);
    if(! go_to_wall(there, u, v, sum_of_angles) || ! go_to_wall(back, u, v, sum_of_angles))
      return;
    const double angle = angle_at_edge(u, v, there.apex(), back.apex());
    if(! (angle < target()) || (bad.reason == Bad_cell_reason::forced && ! (angle < bad.surface_angle)))
      return;
    bad.reason = Bad_cell_reason::forced;
    bad.facets = {{ Facet(there.cell(), there.next_facet()), Facet(back.cell(), back.next_facet()) }};
    bad.surface_angle = angle;
  }

  bool go_to_wall(Edge_walk_3<Tr>& walk, const Vertex_handle u, const Vertex_handle v, double& sum_of_angles) const
  {
    const Cell_handle start = walk.cell();
    while(! m_domain.is_wall(walk.cell(), walk.next_facet()))
    {
      ++walk;
      sum_of_angles += angle_at_edge(u, v, walk.cell()->vertex(walk.next_facet()), walk.apex());
      if(walk.cell() == start || sum_of_angles > target() + slack)
        return false;
    }
    return true;
  }

  static double angle_at_edge(const Vertex_handle u, const Vertex_handle v,
                              const Vertex_handle p, const Vertex_handle q)
  {
    const Cell_corners_3 corners = {{ coordinates_of(u->point()), coordinates_of(v->point()),
                                      coordinates_of(p->point()), coordinates_of(q->point()) }};
    return Cell_angles_3(corners)[0]; // the first edge is that of the first two corners
  }

  void look_for_needle(Bad_cell& bad) const
  {
    for(int i = 0; i < 4; ++i)
      if(m_domain.is_wall(bad.cell, i) && blame(bad, Facet(bad.cell, i)))
        bad.reason = Bad_cell_reason::needle;
  }

  // Needles that have an edge of the cell.
  void look_for_needle_at_edges(Bad_cell& bad) const
  {
    for(int k = 0; k < 6; ++k)
    {
      Edge_walk_3<Tr> walk(bad.cell, edges_of_cell[5 - k][0], edges_of_cell[5 - k][1]);
      do
      {
        const Cell_handle c = walk.cell();
        if(m_domain.contains(c))
          for(const int i : { walk.next_facet(), c->index(walk.apex()) })
            if(m_domain.is_wall(c, i))
              blame(bad, Facet(c, i));
        ++walk;
      }
      while(walk.cell() != bad.cell);
    }
  }

  void look_for_needle_at_vertices(Bad_cell& bad)
  {
    for(int i = 0; i < 4; ++i)
      if(const std::optional<Facet>& needle = sharpest_facet(bad.cell->vertex(i)))
        blame(bad, *needle);
  }

  // The constrained facet at a vertex with the smallest plane angle. It is searched for once: there may be many bad
  // cells at a vertex of many cells.
  const std::optional<Facet>& sharpest_facet(const Vertex_handle v)
  {
    if(m_sharpest_facets.is_defined(v))
      return m_sharpest_facets[v];
    m_star.clear();
    m_tr.tds().incident_cells(v, std::back_inserter(m_star));
    std::optional<Facet> sharpest;
    double smallest = 180;
    for(const Cell_handle c : m_star)
      for(int i = 0; i < 4 && m_domain.contains(c); ++i)
      {
        if(c->vertex(i) == v || ! m_domain.is_wall(c, i))
          continue;
        const double angle = plane_angle(Facet(c, i));
        if(angle < smallest)
        {
          smallest = angle;
          sharpest = Facet(c, i);
        }
      }
    return m_sharpest_facets[v] = sharpest;
  }

  // Names a constrained facet if it is a needle, and none with a smaller angle is named. Returns whether it did.
  bool blame(Bad_cell& bad, const Facet& f) const
  {
    const double angle = plane_angle(f);
    if(! (angle < target()) || angle >= bad.surface_angle)
      return false;
    bad.facets[0] = f;
    bad.surface_angle = angle;
    return true;
  }

  static double plane_angle(const Facet& f)
  {
    return internal::smallest_plane_angle(corners_of_facet(f.first, f.second));
  }

  static std::array<Coordinates_3, 3> corners_of_facet(const Cell_handle c, const int i)
  {
    std::array<Coordinates_3, 3> p;
    for(int j = 0; j < 3; ++j)
      p[j] = coordinates_of(c->vertex((i + j + 1) % 4)->point());
    return p;
  }

  const Tr& m_tr;
  const Domain& m_domain;
  Certificate m_certificate;
  CGAL::Unique_hash_map<Vertex_handle, std::optional<Facet> > m_sharpest_facets;
  std::vector<Cell_handle> m_star;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_EXPLAIN_BAD_CELLS_3_H
