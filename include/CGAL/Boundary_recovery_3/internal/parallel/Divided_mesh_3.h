// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_DIVIDED_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_DIVIDED_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The cells of a domain as arrays, in parts: what sub-domains are taken from, and what comes back from them. There are
 * no handles in it, so parts can be worked on at the same time, or elsewhere.
 */
template <typename Tr>
struct Divided_mesh_3
{
  typedef std::array<std::size_t, 2> Edge;

  struct Vertex
  {
    explicit Vertex(const typename Tr::Vertex& v) : point(v.point()), indices(v), size(v.meshing_info()) { }

    void give_to(typename Tr::Vertex& v) const
    {
      v.set_point(point);
      indices.give_to(v);
      v.set_meshing_info(size);
    }

    typename Tr::Point                  point;
    Vertex_indices<typename Tr::Vertex> indices;
    typename Tr::Geom_traits::FT        size; // of cells there; 0: not known
  };

  struct Cell
  {
    std::array<std::size_t, 4>      vertices; // their numbers
    Cell_indices<typename Tr::Cell> indices;
  };

  typedef std::vector<Cell> Part;

  std::size_t number_of_cells() const
  {
    std::size_t sum = 0;
    for(const Part& part : parts)
      sum += part.size();
    return sum;
  }

  std::vector<Vertex> vertices; // maybe some that no cell has any more
  std::vector<Part>   parts;
  std::vector<Edge>   constrained_edges;
};

/*
 * What some cells of a divided mesh became. Vertices have the numbers that they had; new ones have those of vertices
 * that are gone, and then numbers from the number of vertices of the mesh on.
 */
template <typename Tr>
struct Changed_part_3
{
  typedef typename Divided_mesh_3<Tr>::Vertex Vertex;

  typename Divided_mesh_3<Tr>::Part            cells;
  std::vector<std::pair<std::size_t, Vertex> > vertices; // those that may be elsewhere, or new
  std::size_t                                  number_of_new_numbers = 0;
};

// Adds the cells to a part. All changes were made to the same mesh, of `old_number_of_vertices`.
template <typename Tr>
void put_back(Divided_mesh_3<Tr>& mesh, const std::size_t part, Changed_part_3<Tr>& change,
              const std::size_t old_number_of_vertices)
{
  const std::size_t shift = mesh.vertices.size() - old_number_of_vertices;
  const auto shifted = [&](const std::size_t v) { return v < old_number_of_vertices ? v : v + shift; };
  for(const auto& [v, vertex] : change.vertices)
    if(v < old_number_of_vertices)
      mesh.vertices[v] = vertex;
    else
      mesh.vertices.push_back(vertex);
  for(auto& c : change.cells)
    for(std::size_t& v : c.vertices)
      v = shifted(v);
  auto& cells = mesh.parts[part];
  if(cells.empty())
    cells.swap(change.cells);
  else
    cells.insert(cells.end(), change.cells.begin(), change.cells.end());
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_DIVIDED_MESH_3_H
