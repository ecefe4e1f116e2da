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

#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The size that cells should have at each vertex, where it is known; in the vertices themselves if they have a place
 * for it, else in a table.
 *
 * A vertex can be marked as pending, that is, the cells around it have not been looked at. That is kept in the sign.
 */
template <typename Tr, bool is_in_vertices = Has_meshing_info<typename Tr::Vertex>::value>
class Vertex_sizes_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_VERTEX_SIZES_3_H
