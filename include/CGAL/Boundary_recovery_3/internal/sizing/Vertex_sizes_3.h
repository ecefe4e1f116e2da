// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_VERTEX_SIZES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_VERTEX_SIZES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * How long edges may be, as parts of the sizes at their ends. All the rules are here, since each of them leaves to the
 * next one what that can do with: the filling leaves edges, the improvement may change them, and both are measured.
 *
 * See "Tuning constants" in the manual.
 */
struct Length_rules
{
  // The filling: the distance of a new point from the vertices of its cavity, and from those beside an edge that it
  // divides; edges inside that are left alone, and those that are removed, but not divided.
  static constexpr double smallest_distance = 0.7;
  static constexpr double smallest_distance_on_edge = 0.4;
  static constexpr double longest_edge = 1.6;
  static constexpr double longest_undivided_edge = 1.95;

  // The improvement makes no edge shorter or longer than that; nor is a longer one left between sub-domains.
  static constexpr double shortest = 0.5;
  static constexpr double longest = 2;

  // An edge is in size if it is between the root of 1/2 and the root of 2, see `Measure_quality_3`.
};

/*
 * The size that cells should have at each vertex, where it is known; in the vertices themselves if they have a place
 * for it, else in a table.
 *
 * A vertex can be marked as pending, that is, the cells around it have not been looked at. That is kept in the sign,
 * since it costs nothing there. Nobody else sees it but a visitor while the filling goes on: after that no vertex is
 * pending.
 */
template <typename Tr, bool is_in_vertices = Has_meshing_info<typename Tr::Vertex>::value>
class Vertex_sizes_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;

  // Those that are in the vertices.
  Vertex_sizes_3() = default;

  // None is known as yet.
  explicit Vertex_sizes_3(const Tr& tr)
  {
    for(const Vertex_handle v : tr.finite_vertex_handles())
      set_value(v, 0);
  }

  bool is_known(const Vertex_handle v) const { return value(v) != 0; }

  double operator[](const Vertex_handle v) const { return std::abs(value(v)); }

  void set(const Vertex_handle v, const double size) { set_value(v, size); }

  void set_pending(const Vertex_handle v, const double size) { set_value(v, -size); }

  bool is_pending(const Vertex_handle v) const { return value(v) < 0; }

  void settle(const Vertex_handle v) { set_value(v, std::abs(value(v))); }

private:
  double value(const Vertex_handle v) const
  {
    if constexpr(is_in_vertices)
      return CGAL::to_double(v->meshing_info());
    else
      return m_values.is_defined(v) ? m_values[v] : 0;
  }

  void set_value(const Vertex_handle v, const double x)
  {
    if constexpr(is_in_vertices)
      v->set_meshing_info(x);
    else
      m_values[v] = x;
  }

  Unique_hash_map<Vertex_handle, double> m_values; // for looking up only
};

/*
 * The sizes that the walls of a domain have at their vertices, which the mesh cannot change: the length of the shortest
 * edge of a wall there, or if the others are much longer, a part of the mean length. Else one needle would make them
 * tiny.
 */
template <typename Tr>
class Wall_sizes_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;

  // The cells are those of the domain.
  Wall_sizes_3(const std::vector<Cell_handle>& cells, const Selected_domain_3<Tr>& domain)
  {
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(domain.is_wall(c, i))
          add_facet(c, i);
  }

  // Of the walls, in the order in which the cells have them.
  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  // At one of these; 0 if all edges are that short.
  double operator[](const Vertex_handle v) const
  {
    const Edges& e = m_edges[v];
    return (std::max)(e.shortest, least_part_of_mean * e.sum / e.number);
  }

private:
  static constexpr double least_part_of_mean = 0.5; // see "Tuning constants" in the manual

  // Those that facets have at a vertex: an edge of two facets counts twice, as nearly all do.
  struct Edges
  {
    double number = 0;
    double sum = 0;
    double shortest = std::numeric_limits<double>::infinity();
  };

  void add_facet(const Cell_handle c, const int i)
  {
    const auto v = internal::facet_vertices(c, i);
    for(std::size_t j = 0; j < 3; ++j)
    {
      const std::size_t k = (j + 1) % 3;
      const double length = internal::distance(coordinates_of(v[j]->point()), coordinates_of(v[k]->point()));
      add_edge(v[j], length);
      add_edge(v[k], length);
    }
  }

  void add_edge(const Vertex_handle v, const double length)
  {
    Edges& e = m_edges[v];
    if(e.number == 0)
      m_vertices.push_back(v);
    e.number += 1;
    e.sum += length;
    e.shortest = (std::min)(e.shortest, length);
  }

  Unique_hash_map<Vertex_handle, Edges> m_edges; // for looking up only
  std::vector<Vertex_handle> m_vertices;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_VERTEX_SIZES_3_H
