// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_LIFT_LAYER_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_LIFT_LAYER_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Moves several free vertices that are very near a wall away from its plane, all of them by the same factor.
 *
 * The recovery may leave a few vertices at the smallest possible distance from a plane, with cells between them and the
 * plane. None of them can move alone then, since each is above a facet of one of the others, and below another one.
 * But those cells keep their orientations if all distances grow by one factor.
 */
template <typename Mesh>
class Lift_layer_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  explicit Lift_layer_3(Mesh& mesh) : m_mesh(mesh), m_star(mesh, max_number_of_cells) { }

  // The quality of a cell of a layer, as a part of what is enough.
  static constexpr double flat = 1e-8;

  // Moves v, and the other free vertices of flat cells around it, and of those around these. Returns whether the worst
  // one of their cells is better by far now; others may be worse than before, and edges have any length. Otherwise,
  // nothing is changed.
  bool operator()(const Vertex_handle v)
  {
    if(! collect_layer(v))
      return false;
    set_heights();
    const double worst = worst_quality(1);
    double best = worst, best_factor = 1;
    for(int e = 1; e <= max_exponent; ++e)
    {
      const double factor = std::ldexp(1., e);
      const double q = worst_quality(factor);
      if(q > best)
      {
        best = q;
        best_factor = factor;
      }
    }
    return Mesh::is_far_better(best, worst) && move(best_factor);
  }

  // The cells that have a vertex of the layer that was treated last.
  const std::vector<Cell_handle>& cells() const { return m_cells; }

private:
  typedef Simple_cartesian<Rational>     Exact_kernel;
  typedef typename Exact_kernel::Point_3 Exact_point_3;

  // See "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_cells = 1000;
  static constexpr std::size_t max_number_of_vertices = 16;
  static constexpr int max_exponent = 60;

  // Returns false if there is only one vertex, or too much, or no wall.
  bool collect_layer(const Vertex_handle v)
  {
    m_layer.clear();
    m_cells.clear();
    m_wall.reset();
    m_candidates.assign(1, v);
    for(std::size_t k = 0; k < m_candidates.size() && ! is_too_large(); ++k)
      if(m_star.collect(m_candidates[k]))
      {
        m_layer.push_back(m_candidates[k]);
        for(const Cell_handle c : m_star.cells())
          if(! internal::contains(m_cells, c))
            add(c);
      }
    return m_wall && m_layer.size() > 1 && ! is_too_large();
  }

  bool is_too_large() const
  {
    return m_layer.size() > max_number_of_vertices || m_cells.size() > max_number_of_cells;
  }

  void add(const Cell_handle c)
  {
    m_cells.push_back(c);
    if(! (m_mesh.quality(c) < flat * m_mesh.enough()))
      return;
    for(int i = 0; i < 4; ++i)
    {
      if(! internal::contains(m_candidates, c->vertex(i)))
        m_candidates.push_back(c->vertex(i));
      if(! m_wall && m_mesh.domain().is_wall(c, i))
        m_wall = internal::facet_vertices(c, i);
    }
  }

  static Exact_point_3 exact_point(const Vertex_handle v)
  {
    const Coordinates_3 p = Mesh::coordinates(v);
    return Exact_point_3(Rational(p[0]), Rational(p[1]), Rational(p[2]));
  }

  // The vectors from the plane of the wall to the vertices, computed exactly: they may be as short as rounding errors.
  void set_heights()
  {
    const auto& [p, q, r] = *m_wall;
    const Exact_point_3 o = exact_point(p);
    const auto normal = CGAL::cross_product(exact_point(q) - o, exact_point(r) - o);
    m_heights.clear();
    for(const Vertex_handle v : m_layer)
    {
      const auto height = normal * Rational(CGAL::scalar_product(normal, exact_point(v) - o) / normal.squared_length());
      m_heights.push_back({{ CGAL::to_double(height.x()), CGAL::to_double(height.y()), CGAL::to_double(height.z()) }});
    }
  }

  // Where a vertex is if the heights of the layer are multiplied by a factor.
  Coordinates_3 place(const Vertex_handle v, const double factor) const
  {
    Coordinates_3 p = Mesh::coordinates(v);
    const auto it = std::find(m_layer.begin(), m_layer.end(), v);
    if(it != m_layer.end())
      for(int j = 0; j < 3; ++j)
        p[j] += (factor - 1) * m_heights[static_cast<std::size_t>(it - m_layer.begin())][j];
    return p;
  }

  double worst_quality(const double factor) const
  {
    double worst = 2;
    for(const Cell_handle c : m_cells)
      worst = (std::min)(worst, m_mesh.quality({{ place(c->vertex(0), factor), place(c->vertex(1), factor),
                                                  place(c->vertex(2), factor), place(c->vertex(3), factor) }}));
    return worst;
  }

  bool move(const double factor)
  {
    std::vector<Coordinates_3> places;
    for(const Vertex_handle v : m_layer)
      places.push_back(place(v, factor));
    return m_mesh.move_together(m_layer, places, m_cells);
  }

  Mesh& m_mesh;
  Free_star_3<Mesh> m_star;
  std::vector<Vertex_handle> m_layer, m_candidates;
  std::vector<Coordinates_3> m_heights; // of the vertices of the layer
  std::vector<Cell_handle> m_cells;
  std::optional<std::array<Vertex_handle, 3>> m_wall; // the first one that was met
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_LIFT_LAYER_3_H
