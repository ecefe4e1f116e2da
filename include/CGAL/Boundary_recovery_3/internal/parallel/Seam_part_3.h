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

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_SEAM_PART_3_H
