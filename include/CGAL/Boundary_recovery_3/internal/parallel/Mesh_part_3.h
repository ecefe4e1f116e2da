// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_PART_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_PART_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Some cells of a mesh that is divided into parts, as arrays. There are no handles in it, and it has all that it needs,
 * so parts can be worked on at the same time, or elsewhere. What parts have in common are the numbers of vertices.
 */
template <typename Tr>
struct Mesh_part_3
{
  typedef std::array<std::uint32_t, 4> Tetrahedron; // positions of vertices
  typedef std::array<std::uint32_t, 2> Edge;
  typedef internal::Cell_indices<typename Tr::Cell> Cell_indices;

  struct Vertex
  {
    Vertex(const std::size_t number, const typename Tr::Vertex& v)
      : number(number), point(v.point()), indices(v), size(v.meshing_info())
    { }

    void give_to(typename Tr::Vertex& v) const
    {
      v.set_point(point);
      indices.give_to(v);
      v.set_meshing_info(size);
    }

    std::size_t                         number; // in the whole mesh
    typename Tr::Point                  point;
    Vertex_indices<typename Tr::Vertex> indices;
    typename Tr::Geom_traits::FT        size; // of cells there; 0: not known
    bool                                may_be_shared = false; // by other parts
  };

  std::size_t number_of_cells() const { return tetrahedra.size(); }

  std::vector<Vertex>       vertices;
  std::vector<Tetrahedron>  tetrahedra;
  std::vector<Cell_indices> cell_indices;
  std::vector<Edge>         constrained_edges; // edges of its cells, some maybe more than once
};

template <typename PartRange>
std::size_t number_of_cells(const PartRange& parts)
{
  std::size_t sum = 0;
  for(const auto& part : parts)
    sum += part.number_of_cells();
  return sum;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_MESH_PART_3_H
