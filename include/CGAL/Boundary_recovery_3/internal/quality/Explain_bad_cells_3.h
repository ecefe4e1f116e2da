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
#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Edge_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Walls_at_edge_3.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Makes the certificate: says of each cell with a dihedral angle below the target what makes it so.
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
    : m_tr(tr), m_domain(domain), m_walls_at_edge(domain)
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

  // The constrained facet with the smallest plane angle of those that were looked at, if that is below the target.
  struct Needle
  {
    Facet facet;
    double angle = std::numeric_limits<double>::infinity();
  };

  // One of the cell, or else one that has an edge of it, or else a vertex.
  void look_for_needle(Bad_cell& bad)
  {
    if(name(needle_of(bad.cell), bad))
      bad.reason = Bad_cell_reason::needle;
    else if(! name(needle_at_edges(bad.cell), bad))
      name(needle_at_vertices(bad.cell), bad);
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

  Needle needle_at_edges(const Cell_handle c) const
  {
    Needle needle;
    for(int k = 0; k < 6; ++k)
    {
      Edge_walk_3<Tr> walk(c, edges_of_cell[5 - k][0], edges_of_cell[5 - k][1]);
      do
      {
        if(m_domain.contains(walk.cell()))
          for(const int i : { walk.next_facet(), walk.cell()->index(walk.apex()) })
            look_at(walk.cell(), i, needle);
        ++walk;
      }
      while(walk.cell() != c);
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
  Walls_at_edge_3<Tr, Domain> m_walls_at_edge;
  Certificate m_certificate;
  CGAL::Unique_hash_map<Vertex_handle, Needle> m_needles; // of those that were asked for
  std::vector<Cell_handle> m_star;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_EXPLAIN_BAD_CELLS_3_H
