// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_VAIN_ATTEMPTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_VAIN_ATTEMPTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>

#include <CGAL/Unique_hash_map.h>

#include <cstddef>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The vertices at which an operation was tried in vain. What it does depends on the cells around the vertex only, so
 * until one of them changes, it would fail again, and many bad cells may have this vertex.
 */
template <typename Mesh>
class Vain_attempts_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;

  explicit Vain_attempts_3(const Bad_cells_3<Mesh>& bad_cells) : m_bad_cells(bad_cells), m_visits(never) { }

  // The operation has just failed.
  void add(const Vertex_handle v) { m_visits[v] = m_bad_cells.visit(); }

  bool contains(const Vertex_handle v) const
  {
    const auto& visits = m_visits;
    const std::size_t visit = visits[v];
    return visit != never && ! m_bad_cells.has_changed(v, visit);
  }

  // Something else counts as good enough from now on.
  void clear() { m_visits.clear(never); }

private:
  static constexpr std::size_t never = 0; // visits are counted from 1 on

  const Bad_cells_3<Mesh>& m_bad_cells;
  Unique_hash_map<Vertex_handle, std::size_t> m_visits; // for looking up only
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_VAIN_ATTEMPTS_3_H
