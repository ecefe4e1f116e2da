// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The constraints: edges and facets, numbered in the order in which they were given.
 *
 * The edges of constrained facets are constrained, too. What is constrained is never destroyed once it is in the mesh,
 * so asking whether a mesh simplex is a constraint is all that the flips have to do.
 */
template <typename Tr>
class Constraints_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef std::array<Vertex_handle, 2>  Edge;
  typedef std::array<Vertex_handle, 3>  Facet;

  static constexpr std::size_t none = std::size_t(-1);

  // `number_of_edges` does not include those of the facets.
  void reserve(const std::size_t number_of_edges, const std::size_t number_of_facets)
  {
    m_edges.reserve(number_of_edges + 3 * number_of_facets / 2);
    m_facets.reserve(number_of_facets);
    m_edges_of_facets.reserve(number_of_facets);
  }

  // Adds an edge, unless it is there already, and returns its index.
  std::size_t insert(const Vertex_handle u, const Vertex_handle v) { return m_edges.insert({{ u, v }}).first; }

  // Adds a facet with its edges, unless it is there already, and returns its index.
  std::size_t insert(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    const auto inserted = m_facets.insert({{ u, v, w }});
    if(inserted.second)
      m_edges_of_facets.push_back({{ insert(u, v), insert(v, w), insert(w, u) }});
    return inserted.first;
  }

  const std::vector<Edge>& edges() const { return m_edges.keys(); }
  const std::vector<Facet>& facets() const { return m_facets.keys(); }

  // The indices of the edges of a facet.
  const std::array<std::size_t, 3>& edges_of_facet(const std::size_t f) const { return m_edges_of_facets[f]; }

  std::size_t index(const Vertex_handle u, const Vertex_handle v) const
  {
    return m_edges[{{ u, v }}];
  }

  std::size_t index(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    return m_facets[{{ u, v, w }}];
  }

  // For each of the facets its index, or none.
  void look_up(const std::vector<Facet>& facets, std::vector<std::size_t>& indices) const
  {
    m_facets.look_up(facets, indices);
  }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const
  {
    return index(u, v) != none;
  }

  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    return index(u, v, w) != none;
  }

private:
  Simplex_index_3<Vertex_handle, 2> m_edges;
  Simplex_index_3<Vertex_handle, 3> m_facets;
  std::vector<std::array<std::size_t, 3> > m_edges_of_facets;
};

// The constraints that are not in the mesh, by their indices in increasing order.
struct Lost_constraints
{
  std::vector<std::size_t> edges;
  std::vector<std::size_t> facets;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_CONSTRAINTS_3_H
