// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MARKED_FACETS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MARKED_FACETS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <array>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The constraints that are marked in the cells of a triangulation: facets on a surface (`is_facet_on_surface()`) and
 * between two regions (`subdomain_index()`), the edges of both, and other edges that are listed.
 *
 * It answers what `Constraints_3` answers about mesh simplices, but nothing is stored twice: marks are carried over
 * when cells are replaced (by `Mesh_indices_keeper_3`), also where a facet is split.
 */
template <typename Tr>
class Marked_facets_3
{
public:
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef typename Tr::Cell_handle           Cell_handle;
  typedef Simplex_index_3<Vertex_handle, 2>  Edges;

  // `edges`, if given, has to outlive this object.
  explicit Marked_facets_3(const Tr& tr, Edges* const edges = nullptr) : m_tr(tr), m_edges(edges) { }

  // Whether uv is a mesh edge that is constrained.
  bool is_constrained(const Vertex_handle u, const Vertex_handle v) const
  {
    Cell_handle c;
    int i, j;
    if(! m_tr.is_edge(u, v, c, i, j))
      return false;
    if(m_edges != nullptr && (*m_edges)[{{ u, v }}] != m_edges->none)
      return true;
    const Shell_3<Tr> shell(m_tr, c, i, j);
    for(int k = 0; k < shell.degree(); ++k)
      if(is_marked(shell.cell(k), shell.cell(k)->index(shell.vertex(k))))
        return true;
    return false;
  }

  // Whether uvw is a mesh facet that is constrained.
  bool is_constrained(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w) const
  {
    Cell_handle c;
    int i, j, k;
    return m_tr.is_facet(u, v, w, c, i, j, k)
        && is_marked(c, internal::index_of_opposite_vertex(c, std::array<Vertex_handle, 3>{{ u, v, w }}));
  }

  // A constrained edge was split by w.
  void split(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    if(m_edges == nullptr || m_edges->erase({{ u, v }}) == m_edges->none)
      return;
    m_edges->insert({{ u, w }});
    m_edges->insert({{ w, v }});
  }

  // A constrained facet was split: its parts are marked.
  void split(const Vertex_handle, const Vertex_handle, const Vertex_handle, const Vertex_handle) { }

private:
  bool is_marked(const Cell_handle c, const int i) const
  {
    return c->is_facet_on_surface(i) || c->subdomain_index() != c->neighbor(i)->subdomain_index();
  }

  const Tr& m_tr;
  Edges* m_edges;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MARKED_FACETS_3_H
