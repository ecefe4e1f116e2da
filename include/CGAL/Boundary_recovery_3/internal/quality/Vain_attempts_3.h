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

  explicit Vain_attempts_3(const Mesh& mesh) : m_mesh(mesh), m_times(0) { }

  // The operation has just failed, or done what it can.
  void add(const Vertex_handle v) { m_times[v] = m_mesh.time(); }

  // Also something else may count as good enough since.
  bool contains(const Vertex_handle v) const
  {
    const auto& times = m_times;
    const std::size_t time = times[v];
    return time >= m_mesh.time_of_measure() && ! m_mesh.has_changed(v, time);
  }

private:
  const Mesh& m_mesh;
  Unique_hash_map<Vertex_handle, std::size_t> m_times; // in changes of the mesh; for looking up only
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_VAIN_ATTEMPTS_3_H
