// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_CAVITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_CAVITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Finite cells that are to be replaced together, in the order in which they were added; and what is around them.
 */
template <typename Tr>
class Cavity_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Constraints_3<Tr>                    Constraints;
  typedef std::array<Vertex_handle, 3>         Triangle;
  typedef std::vector<Vertex_handle>           Vertices;

  Cavity_3(const Tr& tr, const Constraints& constraints, const std::vector<Cell_handle>& cells)
    : m_tr(tr), m_constraints(constraints)
  {
    for(const Cell_handle c : cells)
      add(c);
  }

  const std::vector<Cell_handle>& cells() const { return m_cells; }

  // Adds a cell, if it is finite and not there yet.
  void add(const Cell_handle c)
  {
    if(! m_tr.is_infinite(c) && m_index.insert({{ c }}).second)
      m_cells.push_back(c);
  }

  // Adds the cells behind the faces that v does not see from inside, until it sees all. Returns false if a constraint
  // or the hull is in the way, or if there would be more cells than allowed.
  template <typename Predicates>
  bool grow_until_seen(const Vertex_handle v, const Predicates& predicates, const std::size_t max_number_of_cells)
  {
    for(std::size_t k = 0; k < m_cells.size(); ++k)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle n = m_cells[k]->neighbor(i);
        const Triangle f = internal::facet_vertices(m_cells[k], i);
        if(contains(n) || predicates.orientation(f[0], f[1], f[2], v) == POSITIVE)
          continue;
        if(m_tr.is_infinite(n) || is_constrained(f) || m_cells.size() >= max_number_of_cells)
          return false;
        add(n);
      }
    return true;
  }

  // The faces, seen from inside, and the vertices inside. Returns false if there is a constraint inside, or a vertex
  // that is none of the `points`.
  bool collect_boundary(const Vertices& points, std::vector<Triangle>& faces, Vertices& inner_points) const
  {
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Triangle f = internal::facet_vertices(c, i);
        if(! contains(c->neighbor(i)))
          faces.push_back(f);
        else if(is_constrained(f))
          return false;
      }
    return collect_inner_points(faces, points, inner_points) && ! has_constrained_edge_inside(faces);
  }

private:
  bool is_constrained(const Triangle& f) const { return m_constraints.is_constrained(f[0], f[1], f[2]); }

  bool contains(const Cell_handle c) const { return m_index[{{ c }}] != m_index.none; }

  bool collect_inner_points(const std::vector<Triangle>& faces, const Vertices& points, Vertices& inner_points) const
  {
    inner_points.clear();
    Simplex_index_3<Vertex_handle, 1> known;
    for(const Triangle& f : faces)
      for(const Vertex_handle v : f)
        known.insert({{ v }});
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle p = c->vertex(i);
        if(! known.insert({{ p }}).second)
          continue;
        if(! internal::contains(points, p))
          return false;
        inner_points.push_back(p);
      }
    return true;
  }

  bool has_constrained_edge_inside(const std::vector<Triangle>& faces) const
  {
    Simplex_index_3<Vertex_handle, 2> edges; // of the faces
    for(const Triangle& f : faces)
      for(int k = 0; k < 3; ++k)
        edges.insert({{ f[k], f[(k + 1) % 3] }});
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
        {
          const Vertex_handle u = c->vertex(i), v = c->vertex(j);
          if(m_constraints.is_constrained(u, v) && edges[{{ u, v }}] == edges.none)
            return true;
        }
    return false;
  }

  const Tr& m_tr;
  const Constraints& m_constraints;
  std::vector<Cell_handle> m_cells;
  Simplex_index_3<Cell_handle, 1> m_index; // of these
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_CAVITY_3_H
