// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_LOCAL_VERTICES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_LOCAL_VERTICES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The few vertices of a cavity, each once, in the order in which they come. To clear it costs nothing, whatever its
 * size, so it can serve millions of cavities, most of them small.
 */
template <typename Vertex_handle>
class Local_vertices
{
public:
  Local_vertices() : m_slots(64) { }

  void clear()
  {
    ++m_round;
    m_vertices.clear();
  }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  std::size_t size() const { return m_vertices.size(); }

  // Returns whether the vertex is new.
  bool insert(const Vertex_handle v)
  {
    if(2 * (m_vertices.size() + 1) > m_slots.size())
      enlarge();
    Slot& slot = m_slots[position(v)];
    if(slot.round == m_round)
      return false;
    slot = Slot{ m_round, v };
    m_vertices.push_back(v);
    return true;
  }

private:
  struct Slot
  {
    std::uint64_t round = 0; // when it was filled; it is empty in all other rounds
    Vertex_handle vertex;
  };

  std::size_t position(const Vertex_handle v) const
  {
    const std::size_t mask = m_slots.size() - 1;
    std::size_t i = static_cast<std::size_t>(internal::hash_share(v)) & mask;
    while(m_slots[i].round == m_round && m_slots[i].vertex != v)
      i = (i + 1) & mask;
    return i;
  }

  void enlarge()
  {
    m_slots.assign(2 * m_slots.size(), Slot());
    for(const Vertex_handle v : m_vertices)
      m_slots[position(v)] = Slot{ m_round, v };
  }

  std::vector<Slot> m_slots;
  std::vector<Vertex_handle> m_vertices;
  std::uint64_t m_round = 1;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_LOCAL_VERTICES_H
