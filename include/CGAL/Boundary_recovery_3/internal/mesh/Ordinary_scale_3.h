// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_ORDINARY_SCALE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_ORDINARY_SCALE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Brings a triangulation to another scale as long as this exists, if its coordinates are so large, or so small, that
 * products of a few lengths would leave the range of floating point numbers.
 *
 * Points, and the sizes that vertices carry, are multiplied by a power of two: without rounding errors, so predicates
 * find what they found before, and a mesh of 1e110 becomes the same as one of size 1.
 */
template <typename Tr>
class Ordinary_scale_3
{
public:
  explicit Ordinary_scale_3(Tr& tr) : m_tr(tr), m_factor(factor_of(tr)) { multiply_by(m_factor); }
  ~Ordinary_scale_3() { multiply_by(1 / m_factor); }

  Ordinary_scale_3(const Ordinary_scale_3&) = delete;
  Ordinary_scale_3& operator=(const Ordinary_scale_3&) = delete;

  // What lengths are multiplied by.
  double factor() const { return m_factor; }

private:
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  typedef typename Tr::Geom_traits::FT      FT;

  static constexpr int largest_exponent = 64; // see "Tuning constants" in the manual

  static double factor_of(const Tr& tr)
  {
    double largest = 0;
    for(const auto v : tr.finite_vertex_handles())
      largest = (std::max)(largest, internal::largest_coordinate(coordinates_of(v->point())));
    const double scale = internal::binary_scale(largest);
    return std::abs(std::ilogb(scale)) <= largest_exponent || ! is_exact(tr, 1 / scale) ? 1 : 1 / scale;
  }

  // Whether no coordinate gets so small that it is rounded: then there are some that are smaller by 2^500 than others.
  static bool is_exact(const Tr& tr, const double factor)
  {
    const FT there(factor), back(1 / factor);
    const auto vertices = tr.finite_vertex_handles();
    return std::all_of(vertices.begin(), vertices.end(), [&](const auto v)
    {
      const Point_3& p = internal::bare_point<Point_3>(v->point());
      return p.x() * there * back == p.x() && p.y() * there * back == p.y() && p.z() * there * back == p.z();
    });
  }

  void multiply_by(const double factor)
  {
    if(factor == 1)
      return;
    const FT f(factor);
    for(const auto v : m_tr.finite_vertex_handles())
    {
      const Point_3 p = internal::bare_point<Point_3>(v->point());
      v->set_point(typename Tr::Point(Point_3(p.x() * f, p.y() * f, p.z() * f)));
      if constexpr(Has_meshing_info<typename Tr::Vertex>::value)
        v->set_meshing_info(v->meshing_info() * f);
    }
    for(const auto c : m_tr.all_cell_handles())
      internal::forget_shape(*c);
  }

  Tr& m_tr;
  const double m_factor;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_ORDINARY_SCALE_3_H
