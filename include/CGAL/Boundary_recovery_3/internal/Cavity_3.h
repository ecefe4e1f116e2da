// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/contains.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Finite cells that are to be replaced together, in the order in which they were added; and what is around them.
 * There are some hundreds of them at most, so all searches are linear.
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

  Cavity_3(const Tr& tr, const Constraints& constraints, std::vector<Cell_handle> cells)
    : m_tr(tr), m_constraints(constraints), m_cells(std::move(cells))
  { }

  const std::vector<Cell_handle>& cells() const { return m_cells; }

  void set_cells(std::vector<Cell_handle> cells) { m_cells = std::move(cells); }

  // Adds a cell, if it is finite and not there yet.
  void add(const Cell_handle c)
  {
    if(! m_tr.is_infinite(c) && ! internal::contains(m_cells, c))
      m_cells.push_back(c);
  }

  // Adds cells behind its faces that have no other vertices than these, as long as there are such. What is behind a
  // constrained face has nothing to do with what is in front of it.
  void add_cells_of(const Vertices& vertices)
  {
    for(std::size_t k = 0; k < m_cells.size(); ++k) // it grows
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle c = m_cells[k], n = c->neighbor(i);
        if(internal::contains(vertices, n->vertex(n->index(c))) && ! is_constrained(internal::facet_vertices(c, i)))
          add(n);
      }
  }

  // The finite cells behind faces that are not constrained.
  std::vector<Cell_handle> cells_around() const
  {
    std::vector<Cell_handle> result;
    for_each_open_face([&](const Cell_handle n, Vertex_handle)
    {
      if(! internal::contains(result, n))
        result.push_back(n);
    });
    return result;
  }

  // A face of the boundary, seen from inside, and the vertex of the cell behind it; none if it is constrained, or has
  // the exterior of the hull behind it.
  struct Boundary_face
  {
    Triangle face;
    Vertex_handle vertex_behind;
  };

  std::vector<Boundary_face> boundary() const
  {
    std::vector<Boundary_face> result;
    internal::for_each_outer_facet(m_cells, [&](const Cell_handle c, const int i)
    {
      result.push_back({ internal::facet_vertices(c, i), is_open(c, i) ? vertex_behind(c, i) : Vertex_handle() });
    });
    return result;
  }

  // The vertices behind faces that are not constrained, those behind the largest number of such faces first.
  Vertices vertices_behind() const
  {
    std::vector<std::pair<Vertex_handle, int> > counts;
    for_each_open_face([&](Cell_handle, const Vertex_handle x)
    {
      const auto it = std::find_if(counts.begin(), counts.end(), [x](const auto& c) { return c.first == x; });
      if(it == counts.end())
        counts.push_back({ x, 1 });
      else
        ++it->second;
    });
    std::stable_sort(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    Vertices result;
    for(const auto& c : counts)
      result.push_back(c.first);
    return result;
  }

  // The first of these; none if there is only the exterior of the hull behind those faces.
  Vertex_handle most_adjacent_vertex() const
  {
    const Vertices vertices = vertices_behind();
    return vertices.empty() ? Vertex_handle() : vertices.front();
  }

  // The faces, seen from inside, and the vertices inside. Returns false if there is a constraint inside, or a vertex
  // that is none of the `points`.
  bool collect_boundary(const Vertices& points, std::vector<Triangle>& faces, Vertices& inner_points) const
  {
    Vertices vertices; // of the faces
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Triangle f = internal::facet_vertices(c, i);
        if(internal::contains(m_cells, c->neighbor(i)))
        {
          if(is_constrained(f))
            return false;
          continue;
        }
        faces.push_back(f);
        vertices.insert(vertices.end(), f.begin(), f.end());
      }
    return collect_inner_points(vertices, points, inner_points) && ! has_constrained_edge_inside(faces);
  }

private:
  bool is_constrained(const Triangle& f) const { return m_constraints.is_constrained(f[0], f[1], f[2]); }

  // For each face that is not constrained and has a finite cell behind it, calls `visit` with that cell and its vertex
  // there.
  template <typename Visit>
  void for_each_open_face(const Visit& visit) const
  {
    internal::for_each_outer_facet(m_cells, [&](const Cell_handle c, const int i)
    {
      if(is_open(c, i))
        visit(c->neighbor(i), vertex_behind(c, i));
    });
  }

  bool is_open(const Cell_handle c, const int i) const
  {
    return ! m_tr.is_infinite(c->neighbor(i)) && ! is_constrained(internal::facet_vertices(c, i));
  }

  static Vertex_handle vertex_behind(const Cell_handle c, const int i)
  {
    return c->neighbor(i)->vertex(c->neighbor(i)->index(c));
  }

  bool collect_inner_points(const Vertices& outer_vertices, const Vertices& points, Vertices& inner_points) const
  {
    inner_points.clear();
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle p = c->vertex(i);
        if(internal::contains(outer_vertices, p) || internal::contains(inner_points, p))
          continue;
        if(! internal::contains(points, p))
          return false;
        inner_points.push_back(p);
      }
    return true;
  }

  bool has_constrained_edge_inside(const std::vector<Triangle>& faces) const
  {
    std::vector<std::array<Vertex_handle, 2> > edges; // of the faces, both ways
    for(const Triangle& f : faces)
      for(int k = 0; k < 3; ++k)
        edges.push_back({{ f[k], f[(k + 1) % 3] }});
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
        {
          const std::array<Vertex_handle, 2> e = {{ c->vertex(i), c->vertex(j) }};
          if(i != j && m_constraints.is_constrained(e[0], e[1]) && ! internal::contains(edges, e))
            return true;
        }
    return false;
  }

  const Tr& m_tr;
  const Constraints& m_constraints;
  std::vector<Cell_handle> m_cells;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_3_H
