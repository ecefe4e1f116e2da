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

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Vertex_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// The angles 5, 10, ..., 85 degrees as the squares of their cotangents. Fixed, so that cells with angles like 45
// degrees are counted the same way by all machines.
constexpr double squares_of_cotangents[17] = {
  130.6460956438599, 32.16343747752636, 13.928203230275509, 7.548632170413031, 4.59890993211339, 3,
  2.039606729161475, 1.4202766254612063, 1, 0.7040881910418474, 0.4902905965657022, 1. / 3,
  0.21744283205399903, 0.13247433143179424, 0.07179676972449082, 0.03109120412576338, 0.007654266245552346
};

/*
 * The inner edges of a domain, those in no wall, each in one of its cells. That cell is found without looking at the
 * others: there is a fixed direction, and exactly one cell around the edge is that way from it. That is the cell both
 * of whose facets at the edge face there.
 */
template <typename Tr>
class Inner_edges_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef Selected_domain_3<Tr>      Domain;

  // The domain must exist as long as this does.
  explicit Inner_edges_3(const Domain& domain) : m_domain(domain) { }

  // Calls `f(k)` for each edge of a cell, in the order of `edges_of_cell`, that is this cell's if it is an inner one.
  template <typename Function>
  void for_each_own_edge(const Cell_handle c, const Cell_shape_3& shape, const Function& f) const
  {
    const std::array<bool, 4> faces = facets_that_face(c, shape);
    for(int k = 0; k < 6; ++k)
      if(faces[edges_of_cell[5 - k][0]] && faces[edges_of_cell[5 - k][1]])
        f(k);
  }

  // Whether an edge is in no wall. Most cells need not look at their neighbors, which are far away in memory.
  bool is_inner(const Cell_handle c, const int k) const
  {
    if(! m_domain.has_selection() && (c->vertex(edges_of_cell[k][0])->in_dimension() == 3 ||
                                      c->vertex(edges_of_cell[k][1])->in_dimension() == 3))
      return true;
    Edge_walk_3<Tr> walk(c, edges_of_cell[5 - k][0], edges_of_cell[5 - k][1]);
    do
    {
      if(m_domain.is_wall(walk.cell(), walk.next_facet()))
        return false;
      ++walk;
    }
    while(walk.cell() != c);
    return true;
  }

private:
  typedef std::decay_t<decltype(std::declval<typename Tr::Point>().x())>                    FT;
  typedef std::conditional_t<std::is_floating_point<FT>::value, internal::Exact_float, FT>  Exact;

  // The one that facets may face: it is parallel to hardly any plane in a mesh.
  static constexpr double direction[3] = { 1, 1.4142135623730951, 1.7320508075688772 };

  // Whether the insides of the facets of a cell face the direction. Both cells at a facet must agree, so the answer is
  // exact; rounding errors hardly ever leave it open.
  static std::array<bool, 4> facets_that_face(const Cell_handle c, const Cell_shape_3& shape)
  {
    // The error is below 2^-48 times the square of the longest edge, which is at most twice as long as one of these.
    const double bound = 4e-14 * (dot_product(shape.edges[0], shape.edges[0]) +
                                  dot_product(shape.edges[1], shape.edges[1]) +
                                  dot_product(shape.edges[2], shape.edges[2]));
    std::array<bool, 4> result;
    for(int i = 0; i < 4; ++i)
    {
      const Coordinates_3& n = shape.normals[i];
      const double x = n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2];
      result[i] = std::is_floating_point<FT>::value && std::abs(x) > bound ? x > 0 : faces_exactly(c, i);
    }
    return result;
  }

  // If it is parallel to the direction, one beside it decides.
  static bool faces_exactly(const Cell_handle c, const int i)
  {
    const std::array<Vertex_handle, 3> v = internal::facet_vertices(c, i);
    const std::array<Exact, 3> p = exact_vector(v[0], v[1]), q = exact_vector(v[0], v[2]);
    std::array<Exact, 3> normal;
    for(int j = 0; j < 3; ++j)
      normal[j] = p[(j + 1) % 3] * q[(j + 2) % 3] - p[(j + 2) % 3] * q[(j + 1) % 3];
    const Exact x = normal[0] * Exact(direction[0]) + normal[1] * Exact(direction[1]) +
                    normal[2] * Exact(direction[2]);
    for(const Exact& y : { x, normal[0], normal[1], normal[2] })
      if(! CGAL::is_zero(y))
        return CGAL::is_positive(y);
    return false;
  }

  static std::array<Exact, 3> exact_vector(const Vertex_handle u, const Vertex_handle v)
  {
    const auto& p = u->point();
    const auto& q = v->point();
    return {{ Exact(q.x()) - Exact(p.x()), Exact(q.y()) - Exact(p.y()), Exact(q.z()) - Exact(p.z()) }};
  }

  const Domain& m_domain;
};

/*
 * The figures of the cells of a domain, in one pass over them.
 */
template <typename Tr>
class Measure_quality_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef Selected_domain_3<Tr>      Domain;

  Measure_quality_3(const Tr& tr, const Domain& domain) : m_tr(tr), m_domain(domain), m_inner_edges(domain) { }

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
      for(const Cell_handle c : m_tr.all_cell_handles())
      {
        if(! goes_on())
          return std::nullopt;
        if(m_domain.contains(c))
          measure(c, examine);
      }
    finish();
    return m_quality;
  }

  // The same for those of some cells that are in the domain, as a part of the sum that `Sum_of_qualities_3` makes.
  template <typename CellRange, typename Examine>
  Mesh_quality_3 of_cells(const CellRange& cells, const Examine& examine)
  {
    for(const Cell_handle c : cells)
      if(m_domain.contains(c))
        measure(c, examine);
    finish();
    return m_quality;
  }

private:
  template <typename Examine>
  void measure(const Cell_handle c, const Examine& examine)
  {
    const Cell_corners_3 corners = internal::corners(c);
    const Cell_angles_3 angles(corners);
    add_angles(angles);
    add_radius_ratio(angles.radius_ratio());
    if constexpr(Has_meshing_info<typename Tr::Vertex>::value)
      m_inner_edges.for_each_own_edge(c, angles.shape(), [&](const int k) { add_edge(c, k, corners); });
    examine(c, angles);
  }

  // No angles are found but those that are extreme so far, and those of cells without volume. Figures that do not exist
  // yet are not numbers, and give way.
  void add_angles(const Cell_angles_3& angles)
  {
    const double largest = angles.square_of_largest_cotangent(), smallest = angles.square_of_smallest_cotangent();
    int bin = 0;
    for(const double square : squares_of_cotangents)
      bin += largest <= square;
    ++m_quality.histogram[bin];
    for(int i = 0; i < 3; ++i)
      m_quality.numbers_of_cells_above[i] += smallest < - squares_of_cotangents[5 - 2 * i];
    if(! (largest <= m_largest_square))
      m_quality.min_dihedral_angle = (std::min)(angles.smallest(), m_quality.min_dihedral_angle);
    if(! (smallest >= m_smallest_square))
      m_quality.max_dihedral_angle = (std::max)(angles.largest(), m_quality.max_dihedral_angle);
    m_largest_square = (std::max)(m_largest_square, largest);
    m_smallest_square = (std::min)(m_smallest_square, smallest);
  }

  void add_radius_ratio(const double ratio)
  {
    m_quality.min_radius_ratio = (std::min)(ratio, m_quality.min_radius_ratio);
    m_sum_of_radius_ratios += ratio;
    ++m_quality.number_of_cells;
  }

  void add_edge(const Cell_handle c, const int k, const Cell_corners_3& corners)
  {
    const int u = edges_of_cell[k][0], v = edges_of_cell[k][1];
    const double size_u = internal::vertex_size(*c->vertex(u)), size_v = internal::vertex_size(*c->vertex(v));
    if(! (size_u > 0 && size_v > 0 && m_inner_edges.is_inner(c, k)))
      return;
    ++m_quality.number_of_sized_edges;
    m_number_of_edges_in_size += is_in_size(difference(corners[u], corners[v]), size_u, size_v);
  }

  // See `Length_rules`.
  static bool is_in_size(Coordinates_3 edge, const double size_u, const double size_v)
  {
    const bool is_ordinary = size_u > 1e-100 && size_u < 1e100; // else squares would leave their range
    const double factor = is_ordinary ? 1 : 1 / internal::binary_scale(size_u);
    for(double& x : edge)
      x *= factor;
    const double sum = factor * size_u + factor * size_v, square = dot_product(edge, edge);
    return 8 * square >= sum * sum && 2 * square <= sum * sum; // the mean is half of the sum
  }

  void finish()
  {
    std::partial_sum(m_quality.histogram.begin(), m_quality.histogram.begin() + 4,
                     m_quality.numbers_of_cells_below.begin());
    if(m_quality.number_of_cells > 0)
      m_quality.mean_radius_ratio = m_sum_of_radius_ratios / static_cast<double>(m_quality.number_of_cells);
    if(m_quality.number_of_sized_edges > 0)
      m_quality.share_of_edges_in_size = static_cast<double>(m_number_of_edges_in_size) /
                                         static_cast<double>(m_quality.number_of_sized_edges);
  }

  const Tr& m_tr;
  const Domain& m_domain;
  const Inner_edges_3<Tr> m_inner_edges;
  Mesh_quality_3 m_quality;
  double m_largest_square = - std::numeric_limits<double>::infinity(); // of the cotangents of all cells
  double m_smallest_square = std::numeric_limits<double>::infinity();
  double m_sum_of_radius_ratios = 0;
  std::size_t m_number_of_edges_in_size = 0; // of the inner edges with known sizes
};

/*
 * The figures of a mesh whose cells are those of several meshes together. An edge that is in walls of these is an inner
 * one of none of them.
 */
class Sum_of_qualities_3
{
public:
  void add(const Mesh_quality_3& q)
  {
    if(q.number_of_cells == 0)
      return;
    // figures that do not exist yet are not numbers, and give way
    m_sum.min_dihedral_angle = (std::min)(q.min_dihedral_angle, m_sum.min_dihedral_angle);
    m_sum.max_dihedral_angle = (std::max)(q.max_dihedral_angle, m_sum.max_dihedral_angle);
    m_sum.min_radius_ratio = (std::min)(q.min_radius_ratio, m_sum.min_radius_ratio);
    m_sum.number_of_cells += q.number_of_cells;
    m_sum.number_of_sized_edges += q.number_of_sized_edges;
    add(m_sum.numbers_of_cells_below, q.numbers_of_cells_below);
    add(m_sum.numbers_of_cells_above, q.numbers_of_cells_above);
    add(m_sum.histogram, q.histogram);
    m_radius_ratios += q.mean_radius_ratio * static_cast<double>(q.number_of_cells);
    if(q.number_of_sized_edges > 0)
      m_edges_in_size += q.share_of_edges_in_size * static_cast<double>(q.number_of_sized_edges);
  }

  Mesh_quality_3 quality() const
  {
    Mesh_quality_3 sum = m_sum;
    if(sum.number_of_cells > 0)
      sum.mean_radius_ratio = m_radius_ratios / static_cast<double>(sum.number_of_cells);
    if(sum.number_of_sized_edges > 0)
      sum.share_of_edges_in_size = m_edges_in_size / static_cast<double>(sum.number_of_sized_edges);
    return sum;
  }

private:
  template <std::size_t n>
  static void add(std::array<std::size_t, n>& sum, const std::array<std::size_t, n>& numbers)
  {
    std::transform(sum.begin(), sum.end(), numbers.begin(), sum.begin(), std::plus<std::size_t>());
  }

  Mesh_quality_3 m_sum;
  double m_radius_ratios = 0;
  double m_edges_in_size = 0;
};

/*
 * The figures of a mesh by several threads. They are added up in the order of blocks of cells, so they do not depend on
 * the threads.
 */
template <typename Tr>
class Measure_blocks_3
{
public:
  typedef typename Tr::Cell_handle Cell_handle;
  typedef Selected_domain_3<Tr>    Domain;

  Measure_blocks_3(const Tr& tr, const Domain& domain) : m_tr(tr), m_domain(domain) { }

  // `concerns(c, angles)` is called by all threads for each cell. If it returns something, an optional value, one
  // thread at a time calls `examine(value)`. `goes_on` is asked now and then; if it says no, there are no figures.
  template <typename Concerns, typename Examine, typename Question>
  std::optional<Mesh_quality_3> operator()(const Concerns& concerns, const Examine& examine, const Question& goes_on)
  {
    typedef typename decltype(concerns(std::declval<Cell_handle>(), std::declval<Cell_angles_3>()))::value_type Value;
    typedef std::pair<Mesh_quality_3, std::vector<Value> > Block;
    Sum_of_qualities_3 sum;
    const auto measure = [&](const std::vector<Cell_handle>& cells)
    {
      Block block;
      const auto note = [&](const Cell_handle c, const Cell_angles_3& angles)
      {
        if(const auto value = concerns(c, angles))
          block.second.push_back(*value);
      };
      block.first = Measure_quality_3<Tr>(m_tr, m_domain).of_cells(cells, note);
      return block;
    };
    const auto take = [&](const Block& block)
    {
      sum.add(block.first);
      for(const Value& value : block.second)
        if(! goes_on())
          return false;
        else
          examine(value);
      return bool(goes_on());
    };
    const bool is_done = internal::for_each_block(m_tr.all_cell_handles(), measure, take, Concurrency_tag_of<Tr>());
    return is_done ? std::optional<Mesh_quality_3>(sum.quality()) : std::nullopt;
  }

private:
  const Tr& m_tr;
  const Domain& m_domain;
};

inline Mesh_quality_3 sum_of_qualities(const std::vector<Mesh_quality_3>& qualities)
{
  Sum_of_qualities_3 sum;
  for(const Mesh_quality_3& q : qualities)
    sum.add(q);
  return sum.quality();
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_MEASURE_QUALITY_3_H
