// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SEAM_PART_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SEAM_PART_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// What has to be known of a part of a mesh where it meets others. The part itself need not be in memory.
struct Seam_part_3
{
  static constexpr std::uint32_t none = std::uint32_t(-1);
  static constexpr std::uint32_t blocked = none - 1;

  // A vertex that other parts have, too.
  struct Shared_vertex
  {
    std::size_t   number;   // in the whole mesh
    std::uint32_t position; // in the part
    std::uint32_t index;    // in the list of all such vertices
    bool          is_open;  // has no zone yet
  };

  // A cell around which there is to be a zone.
  struct Start
  {
    std::uint32_t              cell;
    std::array<std::size_t, 4> numbers; // of its vertices
  };

  template <typename Tr>
  Seam_part_3(const std::size_t index, const Mesh_part_3<Tr>& part)
    : index(static_cast<std::uint32_t>(index)), tetrahedra(part.tetrahedra),
      zone_of_vertex(part.vertices.size(), none), zone_of_cell(part.number_of_cells(), none)
  {
    for(std::size_t v = 0; v < part.vertices.size(); ++v)
      if(part.vertices[v].may_be_shared)
        shared.push_back({ part.vertices[v].number, static_cast<std::uint32_t>(v), none, true });
  }

  template <typename Tr>
  void add_start(const Mesh_part_3<Tr>& part, const std::size_t cell)
  {
    const auto number = [&](const std::size_t i) { return part.vertices[part.tetrahedra[cell][i]].number; };
    starts.push_back({ static_cast<std::uint32_t>(cell), {{ number(0), number(1), number(2), number(3) }} });
  }

  std::uint32_t index; // of the part
  std::vector<std::array<std::uint32_t, 4> > tetrahedra;
  std::vector<Shared_vertex> shared; // at first, those that may be
  std::vector<Start> starts;
  std::vector<std::uint32_t> zone_of_vertex;
  std::vector<std::uint32_t> zone_of_cell;
};

/*
 * The vertices that parts of a mesh share, in the order of their numbers. The parts that have a vertex are a set; sets
 * have numbers, too, in lexicographical order.
 *
 * `Exchange` is how processes tell each other about parts; see `No_exchange`.
 */
class Shared_vertices_3
{
public:
  // Of the parts here, and of those that other processes have. Those here are told the indices of the vertices, and
  // forget those that are not shared.
  template <typename Exchange>
  Shared_vertices_3(std::vector<Seam_part_3>& parts, const Exchange& exchange)
  {
    find_vertices(parts, exchange);
    for(Seam_part_3& part : parts)
    {
      for(auto& v : part.shared)
      {
        const auto found = std::lower_bound(m_numbers.begin(), m_numbers.end(), v.number);
        if(found != m_numbers.end() && *found == v.number)
          v.index = static_cast<std::uint32_t>(found - m_numbers.begin());
      }
      part.shared.erase(std::remove_if(part.shared.begin(), part.shared.end(),
                                       [](const auto& v) { return v.index == Seam_part_3::none; }), part.shared.end());
    }
  }

  std::size_t size() const { return m_numbers.size(); }
  std::uint32_t set(const std::size_t v) const { return m_set_of_vertex[v]; }
  std::size_t number_of_parts(const std::size_t v) const { return m_sizes_of_sets[m_set_of_vertex[v]]; }

private:
  struct Incidence
  {
    std::size_t   number; // of a vertex
    std::uint32_t part;

    bool operator<(const Incidence& other) const
    {
      return std::tie(number, part) < std::tie(other.number, other.part);
    }
  };

  template <typename Exchange>
  void find_vertices(const std::vector<Seam_part_3>& parts, const Exchange& exchange)
  {
    std::vector<Incidence> incidences;
    for(const Seam_part_3& part : parts)
      for(const auto& v : part.shared)
        incidences.push_back({ v.number, part.index });
    exchange.gather(incidences);
    std::sort(incidences.begin(), incidences.end());
    std::map<std::vector<std::uint32_t>, std::uint32_t> sets;
    std::vector<std::map<std::vector<std::uint32_t>, std::uint32_t>::iterator> set_of_vertex;
    std::vector<std::uint32_t> set;
    for(std::size_t k = 0; k < incidences.size(); )
    {
      set.clear();
      const std::size_t number = incidences[k].number;
      for(; k < incidences.size() && incidences[k].number == number; ++k)
        set.push_back(incidences[k].part);
      if(set.size() > 1)
      {
        m_numbers.push_back(number);
        set_of_vertex.push_back(sets.try_emplace(set, 0).first);
      }
    }
    for(auto& [parts_of_set, set_number] : sets)
    {
      set_number = static_cast<std::uint32_t>(m_sizes_of_sets.size());
      m_sizes_of_sets.push_back(parts_of_set.size());
    }
    for(const auto& found : set_of_vertex)
      m_set_of_vertex.push_back(found->second);
  }

  std::vector<std::size_t> m_numbers;          // in ascending order
  std::vector<std::uint32_t> m_set_of_vertex;  // by index
  std::vector<std::size_t> m_sizes_of_sets;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SEAM_PART_3_H
