// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_HOLD_RECOVERED_VERTICES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_HOLD_RECOVERED_VERTICES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>

#include <CGAL/Unique_hash_map.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Keeps the vertices that the result of the recovery names true while the mesh is improved: those of the input stay
 * where they are, for which those that no facet has are corners in the meantime. Steiner points may move and go; then
 * they are no longer named.
 */
template <typename Tr>
class Hold_recovered_vertices_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Point             Point;
  typedef Boundary_recovery_result_3<Tr> Recovery;

  Hold_recovered_vertices_3(const Tr& tr, Recovery& recovery)
    : m_tr(tr), m_recovery(recovery)
  {
    for(const Vertex_handle v : recovery.vertices)
      if(v->in_dimension() == 3)
      {
        v->set_dimension(0);
        m_corners.push_back(v);
      }
    for(const Vertex_handle v : recovery.steiner_vertices)
      m_places.push_back(v->point());
  }

  Hold_recovered_vertices_3(const Hold_recovered_vertices_3&) = delete;
  Hold_recovered_vertices_3& operator=(const Hold_recovered_vertices_3&) = delete;

  ~Hold_recovered_vertices_3()
  {
    for(const Vertex_handle v : m_corners)
      v->set_dimension(3);
  }

  // A new vertex may have got the handle of one that went, but hardly its place, and then it is as good.
  void forget_lost_steiner_vertices()
  {
    std::vector<Vertex_handle>& vertices = m_recovery.steiner_vertices;
    if(vertices.empty())
      return;
    Unique_hash_map<Vertex_handle, std::size_t> position; // for looking up only
    for(std::size_t i = 0; i < vertices.size(); ++i)
      position[vertices[i]] = i;
    std::vector<char> is_there(vertices.size(), false);
    for(const Vertex_handle v : m_tr.finite_vertex_handles())
      if(position.is_defined(v))
        is_there[position[v]] = v->point() == m_places[position[v]];
    std::size_t number = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(is_there[i])
        vertices[number++] = vertices[i];
    vertices.resize(number);
  }

private:
  const Tr& m_tr;
  Recovery& m_recovery;
  std::vector<Vertex_handle> m_corners;
  std::vector<Point> m_places; // of the Steiner points
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_HOLD_RECOVERED_VERTICES_3_H
