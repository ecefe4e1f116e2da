// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MEASURE_QUALITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MEASURE_QUALITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Mesh_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Vertex_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/filling/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Edge_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The figures of the cells of a domain, in one pass over them.
 */
template <typename Tr, typename Domain>
class Measure_quality_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;

  Measure_quality_3(const Tr& tr, const Domain& domain) : m_tr(tr), m_domain(domain) { }

  // `examine` gets each cell and its angles.
  template <typename Examine>
  Mesh_quality_3 operator()(const Examine& examine)
  {
    return *(*this)(examine, [] { return true; });
  }

  // The same as long as `goes_on`, which is asked for each cell, says so; else there are no figures.
  template <typename Examine, typename Question>
  std::optional<Mesh_quality_3> operator()(const Examine& examine, const Question& goes_on)
  {
    if(m_tr.dimension() == 3)
      for(const Cell_handle c : m_tr.finite_cell_handles())
      {
        if(! goes_on())
          return std::nullopt;
        if(m_domain.contains(c))
          measure(c, examine);
      }
    finish();
    return m_quality;
  }

private:
  template <typename Examine>
  void measure(const Cell_handle c, const Examine& examine)
  {
    const Cell_corners_3 corners = internal::corners(c);
    const Cell_angles_3 angles(corners);
    add_cell(angles);
    if constexpr(Has_meshing_info<typename Tr::Vertex>::value)
      add_edges(c, corners, angles);
    examine(c, angles);
  }

  void add_cell(const Cell_angles_3& angles)
  {
    const double smallest = angles.smallest(), largest = angles.largest(), ratio = angles.radius_ratio();
    for(int i = 0; i < 4; ++i)
      m_quality.numbers_of_cells_below[i] += smallest < 5 * (i + 1);
    for(int i = 0; i < 3; ++i)
      m_quality.numbers_of_cells_above[i] += largest > 150 + 10 * i;
    ++m_quality.histogram[(std::min)(17, static_cast<int>(smallest / 5))];
    if(m_quality.number_of_cells++ == 0)
    {
      m_quality.min_dihedral_angle = smallest;
      m_quality.max_dihedral_angle = largest;
      m_quality.min_radius_ratio = ratio;
    }
    m_quality.min_dihedral_angle = (std::min)(m_quality.min_dihedral_angle, smallest);
    m_quality.max_dihedral_angle = (std::max)(m_quality.max_dihedral_angle, largest);
    m_quality.min_radius_ratio = (std::min)(m_quality.min_radius_ratio, ratio);
    m_sum_of_radius_ratios += ratio;
  }

  void add_edges(const Cell_handle c, const Cell_corners_3& corners, const Cell_angles_3& angles)
  {
    const double factor = 1 / internal::binary_scale(size(c->vertex(0))); // squares would leave their range
    const Cell_corners_3 places = internal::multiplied(corners, factor);
    const std::array<double, 4> sizes = {{ factor * size(c->vertex(0)), factor * size(c->vertex(1)),
                                           factor * size(c->vertex(2)), factor * size(c->vertex(3)) }};
    for(int k = 0; k < 6; ++k)
    {
      const int u = edges_of_cell[k][0], v = edges_of_cell[k][1];
      if(! (sizes[u] > 0 && sizes[v] > 0))
        continue;
      const double part = part_of_inner_edge(c, k, angles);
      const double sum = sizes[u] + sizes[v], square = internal::squared_distance(places[u], places[v]);
      const double square_of_mean = sum * sum / 4;
      m_number_of_edges += part;
      m_number_of_edges_in_size += square >= 0.5 * square_of_mean && square <= 2 * square_of_mean ? part : 0;
    }
  }

  // 0 if it is not known. The filling keeps marks in the sign.
  static double size(const Vertex_handle v) { return std::abs(CGAL::to_double(v->meshing_info())); }

  // Parts that sum up to 1 over the cells around an edge, to 0 if it is in a wall. The dihedral angles around an inner
  // edge are a full turn together, so most cells need not look at their neighbors, which are far away in memory.
  double part_of_inner_edge(const Cell_handle c, const int k, const Cell_angles_3& angles) const
  {
    if constexpr(! Domain::has_selection)
      if(c->vertex(edges_of_cell[k][0])->in_dimension() == 3 || c->vertex(edges_of_cell[k][1])->in_dimension() == 3)
        return angles.part_of_turn(k);
    return is_first_at_inner_edge(c, k) ? 1 : 0;
  }

  // Whether the edge k of a cell is in no wall, and no other cell at it has a lesser address. Which cell that is does
  // not matter for the number. As the search goes both ways, the steps from all n cells at an edge are some n log n at
  // most, whatever the order of the addresses is.
  bool is_first_at_inner_edge(const Cell_handle c, const int k) const
  {
    const int* const others = edges_of_cell[5 - k];
    Edge_walk_3<Tr> there(c, others[0], others[1]), back(c, others[1], others[0]);
    do
    {
      if(m_domain.is_wall(there.cell(), there.next_facet()) || m_domain.is_wall(back.cell(), back.next_facet()))
        return false;
      ++there;
      ++back;
    }
    while(c < there.cell() && c < back.cell());
    return there.cell() == c;
  }

  void finish()
  {
    if(m_quality.number_of_cells > 0)
      m_quality.mean_radius_ratio = m_sum_of_radius_ratios / static_cast<double>(m_quality.number_of_cells);
    m_quality.number_of_sized_edges = static_cast<std::size_t>(std::llround(m_number_of_edges));
    if(m_quality.number_of_sized_edges > 0)
      m_quality.share_of_edges_in_size = m_number_of_edges_in_size / m_number_of_edges;
  }

  const Tr& m_tr;
  const Domain& m_domain;
  Mesh_quality_3 m_quality;
  double m_sum_of_radius_ratios = 0;
  double m_number_of_edges = 0; // of inner edges with known sizes
  double m_number_of_edges_in_size = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MEASURE_QUALITY_3_H
