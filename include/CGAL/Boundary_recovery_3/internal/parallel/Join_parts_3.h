// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_JOIN_PARTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_JOIN_PARTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Makes one part of a mesh of several ones: the cells one after the other, each vertex once.
 */
template <typename Tr>
class Join_parts_3
{
public:
  typedef Mesh_part_3<Tr> Part;

  // Vertices with numbers from `first_new_number` on get numbers that are larger by `shift`.
  void add(Part&& part, const std::size_t first_new_number = 0, const std::size_t shift = 0)
  {
    for(auto& v : part.vertices)
      if(v.number >= first_new_number)
        v.number += shift;
    if(m_joined.number_of_cells() == 0)
    {
      m_joined = std::move(part);
      for(std::size_t v = 0; v < m_joined.vertices.size(); ++v)
        remember(m_joined.vertices[v], v);
    }
    else
      append(part);
  }

  Part joined() { return std::move(m_joined); }

private:
  // Only vertices that are marked can come again.
  void remember(const typename Part::Vertex& v, const std::size_t position)
  {
    if(! v.may_be_shared)
      return;
    m_shared.insert({{ v.number }});
    m_positions.push_back(static_cast<std::uint32_t>(position));
  }

  void append(const Part& part)
  {
    std::vector<std::uint32_t> positions;
    for(const auto& v : part.vertices)
    {
      const std::size_t k = v.may_be_shared ? m_shared[{{ v.number }}] : m_shared.none;
      positions.push_back(k != m_shared.none ? m_positions[k] : static_cast<std::uint32_t>(m_joined.vertices.size()));
      if(k == m_shared.none)
      {
        remember(v, m_joined.vertices.size());
        m_joined.vertices.push_back(v);
      }
    }
    for(const auto& t : part.tetrahedra)
      m_joined.tetrahedra.push_back({{ positions[t[0]], positions[t[1]], positions[t[2]], positions[t[3]] }});
    m_joined.cell_indices.insert(m_joined.cell_indices.end(), part.cell_indices.begin(), part.cell_indices.end());
    for(const auto& e : part.constrained_edges)
      m_joined.constrained_edges.push_back({{ positions[e[0]], positions[e[1]] }});
  }

  Part m_joined;
  Simplex_index_3<std::size_t, 1> m_shared; // numbers of vertices
  std::vector<std::uint32_t> m_positions;   // of these
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_JOIN_PARTS_3_H
