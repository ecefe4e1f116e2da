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

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Finite cells that are to be replaced together, in the order in which they were added; their vertices, and what is
 * around them. How a cavity grows is told below, and in Growing_cavity_3.h.
 *
 * `Constraints` answers `is_constrained()` for two vertices of a cell and for three. Vertices and the boundary are only
 * brought up to date where somebody asks for them.
 */
template <typename Tr, typename Constraints_ = Constraints_3<Tr> >
class Cavity_3
{
public:
  typedef Constraints_                         Constraints;
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef std::array<Vertex_handle, 3>         Vertex_triple;
  typedef std::vector<Vertex_handle>           Vertices;

  // A face of the boundary, seen from inside, and the vertex of the cell behind it; none if it is closed: constrained,
  // or on the hull.
  struct Boundary_face
  {
    Vertex_triple face;
    Vertex_handle vertex_behind;
    Cell_handle cell, cell_behind;
  };

  Cavity_3(const Tr& tr, const Constraints& constraints) : m_tr(tr), m_constraints(constraints) { }

  Cavity_3(const Tr& tr, const Constraints& constraints, const std::vector<Cell_handle>& cells)
    : m_tr(tr), m_constraints(constraints)
  {
    for(const Cell_handle c : cells)
      add(c);
  }

  void clear()
  {
    m_cells.clear();
    m_numbers.clear();
    m_is_inside.clear();
    forget_surroundings();
  }

  // Adds a cell, if it is finite and not there yet. Returns whether it is there now.
  bool add(const Cell_handle c)
  {
    if(m_tr.is_infinite(c))
      return false;
    const auto inserted = m_numbers.insert({{ c }});
    if(inserted.second)
      m_is_inside.push_back(false);
    if(! m_is_inside[inserted.first])
    {
      m_is_inside[inserted.first] = true;
      m_cells.push_back(c);
    }
    return true;
  }

  // Takes out a cell that is there. The others keep their order. All that is known of the surroundings is forgotten, so
  // it is best to take out many before asking for these again.
  void remove(const Cell_handle c)
  {
    m_is_inside[m_numbers[{{ c }}]] = false;
    m_cells.erase(std::find(m_cells.begin(), m_cells.end(), c));
    forget_surroundings();
  }

  bool contains(const Cell_handle c) const
  {
    const std::size_t number = m_numbers[{{ c }}];
    return number != m_numbers.none && m_is_inside[number];
  }

  const std::vector<Cell_handle>& cells() const { return m_cells; }

  // Those of the cells, in the order in which they are met.
  const Vertices& vertices()
  {
    update_vertices();
    return m_vertices;
  }

  bool contains(const Vertex_handle v)
  {
    update_vertices();
    return m_index_of_vertex[{{ v }}] != m_index_of_vertex.none;
  }

  // In the order of the cells.
  const std::vector<Boundary_face>& boundary()
  {
    update_boundary();
    return m_boundary;
  }

  // The faces of the boundary alone.
  std::vector<Vertex_triple> faces()
  {
    std::vector<Vertex_triple> result;
    result.reserve(boundary().size());
    for(const Boundary_face& f : boundary())
      result.push_back(f.face);
    return result;
  }

  // Whether a cavity must not grow through the facet opposite to the vertex i of a cell. What is behind a constrained
  // face has nothing to do with what is in front of it.
  bool is_closed(const Cell_handle c, const int i) const
  {
    return m_tr.is_infinite(c->neighbor(i)) || is_constrained(internal::facet_vertices(c, i));
  }

  // The vertices that are on no face of the boundary, in order.
  Vertices inner_vertices()
  {
    Simplex_index_3<Vertex_handle, 1> outer;
    for(const Boundary_face& f : boundary())
      for(const Vertex_handle v : f.face)
        outer.insert({{ v }});
    Vertices result;
    for(const Vertex_handle v : vertices())
      if(outer[{{ v }}] == outer.none)
        result.push_back(v);
    return result;
  }

  // Whether an edge or a facet is constrained that is not on the boundary.
  bool has_constraint_inside() { return has_constraint_inside_beside(Vertex_handle()); }

  // The same without the edges and facets at v that stay if the cavity is starred from v: those of which the vertex or
  // the edge opposite to v is on the boundary. (A vertex that is not is lost anyway.)
  bool has_constraint_inside_beside(const Vertex_handle v)
  {
    m_outer_edges.clear();
    for(const Boundary_face& f : boundary())
      for(int k = 0; k < 3; ++k)
        m_outer_edges.insert({{ f.face[k], f.face[(k + 1) % 3] }});
    return std::any_of(m_cells.begin(), m_cells.end(), [&](const Cell_handle c)
    {
      return this->has_constrained_edge_inside(c, v) || this->has_constrained_facet_inside(c, v);
    });
  }

  // The faces, seen from inside, and the vertices inside. Returns false if there is a constraint inside, or a vertex
  // that is none of the `points`.
  bool collect_boundary(const Vertices& points, std::vector<Vertex_triple>& faces, Vertices& inner_points)
  {
    if(has_constraint_inside())
      return false;
    faces = this->faces();
    inner_points = inner_vertices();
    return std::all_of(inner_points.begin(), inner_points.end(),
                       [&](const Vertex_handle v) { return internal::contains(points, v); });
  }

private:
  bool is_constrained(const Vertex_triple& f) const { return m_constraints.is_constrained(f[0], f[1], f[2]); }

  void forget_surroundings()
  {
    m_vertices.clear();
    m_index_of_vertex.clear();
    m_number_of_cells_with_vertices = 0;
    m_boundary.clear();
    m_number_of_cells_with_boundary = 0;
  }

  void update_vertices()
  {
    for(; m_number_of_cells_with_vertices < m_cells.size(); ++m_number_of_cells_with_vertices)
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle v = m_cells[m_number_of_cells_with_vertices]->vertex(i);
        if(m_index_of_vertex.insert({{ v }}).second)
          m_vertices.push_back(v);
      }
  }

  // Takes out what is inside now, and adds the faces of the cells that are new.
  void update_boundary()
  {
    if(m_number_of_cells_with_boundary == m_cells.size())
      return;
    m_boundary.erase(std::remove_if(m_boundary.begin(), m_boundary.end(),
                                    [this](const Boundary_face& f) { return this->contains(f.cell_behind); }),
                     m_boundary.end());
    for(; m_number_of_cells_with_boundary < m_cells.size(); ++m_number_of_cells_with_boundary)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle c = m_cells[m_number_of_cells_with_boundary];
        if(! contains(c->neighbor(i)))
          m_boundary.push_back(boundary_face(c, i));
      }
  }

  Boundary_face boundary_face(const Cell_handle c, const int i) const
  {
    const Cell_handle n = c->neighbor(i);
    return { internal::facet_vertices(c, i), is_closed(c, i) ? Vertex_handle() : n->vertex(n->index(c)), c, n };
  }

  bool is_inside(const Vertex_handle p, const Vertex_handle q) const
  {
    return m_outer_edges[{{ p, q }}] == m_outer_edges.none;
  }

  bool has_constrained_edge_inside(const Cell_handle c, const Vertex_handle v) const
  {
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < i; ++j)
      {
        const Vertex_handle p = c->vertex(i), q = c->vertex(j);
        if(p != v && q != v && is_inside(p, q) && m_constraints.is_constrained(p, q))
          return true;
      }
    return false;
  }

  bool has_constrained_facet_inside(const Cell_handle c, const Vertex_handle v) const
  {
    for(int i = 0; i < 4; ++i)
    {
      const Vertex_triple f = internal::facet_vertices(c, i);
      if(! contains(c->neighbor(i)) || ! is_constrained(f))
        continue;
      const auto at_v = std::find(f.begin(), f.end(), v);
      const std::size_t k = static_cast<std::size_t>(at_v - f.begin());
      if(at_v == f.end() || is_inside(f[(k + 1) % 3], f[(k + 2) % 3]))
        return true;
    }
    return false;
  }

  const Tr& m_tr;
  const Constraints& m_constraints;
  std::vector<Cell_handle> m_cells;
  Simplex_index_3<Cell_handle, 1> m_numbers; // of all that ever were among these
  std::vector<char> m_is_inside;             // by number, whether it still is
  Vertices m_vertices;
  Simplex_index_3<Vertex_handle, 1> m_index_of_vertex;
  std::size_t m_number_of_cells_with_vertices = 0; // of which the vertices are known; the first ones
  std::vector<Boundary_face> m_boundary;
  std::size_t m_number_of_cells_with_boundary = 0; // of which the faces of the boundary are
  Simplex_index_3<Vertex_handle, 2> m_outer_edges; // while it is asked for constraints inside; keeps its memory
};

/*
 * Ways in which a cavity grows and shrinks.
 */

// The number of vertices if the cell is added.
template <typename Cavity>
std::size_t number_of_vertices_with(Cavity& cavity, const typename Cavity::Cell_handle extra)
{
  std::size_t n = cavity.vertices().size();
  for(int i = 0; i < 4; ++i)
    if(! cavity.contains(extra->vertex(i)))
      ++n;
  return n;
}

// Adds one more layer: the cells beyond the boundary, the hull excepted, while there are few enough vertices.
template <typename Cavity>
void add_layer(Cavity& cavity, const std::size_t max_number_of_vertices = (std::numeric_limits<std::size_t>::max)())
{
  const std::vector<typename Cavity::Cell_handle> inner = cavity.cells();
  for(const auto c : inner)
    for(int i = 0; i < 4; ++i)
      if(internal::number_of_vertices_with(cavity, c->neighbor(i)) <= max_number_of_vertices)
        cavity.add(c->neighbor(i));
}

// Adds the cells behind the faces that v does not see from inside, until it sees all but those that have it as a
// vertex. Returns false if a constraint or the hull is in the way, or if there would be more cells than allowed.
template <typename Cavity, typename Predicates>
bool grow_until_seen(Cavity& cavity, const typename Cavity::Vertex_handle v, const Predicates& predicates,
                     const std::size_t max_number_of_cells)
{
  for(std::size_t k = 0; k < cavity.cells().size(); ++k) // it grows
    for(int i = 0; i < 4; ++i)
    {
      const auto c = cavity.cells()[k];
      const auto f = internal::facet_vertices(c, i);
      if(cavity.contains(c->neighbor(i)) || internal::contains(f, v)
         || predicates.orientation(f[0], f[1], f[2], v) == POSITIVE)
        continue;
      if(cavity.is_closed(c, i) || cavity.cells().size() >= max_number_of_cells)
        return false;
      cavity.add(c->neighbor(i));
    }
  return true;
}

// Adds the cells that can be reached from those of the cavity through facets that are not closed, as far as they are
// wanted: `is_wanted` is asked for each cell behind such a facet.
template <typename Cavity, typename Is_wanted>
void grow_where(Cavity& cavity, const Is_wanted& is_wanted)
{
  for(std::size_t k = 0; k < cavity.cells().size(); ++k) // it grows
    for(int i = 0; i < 4; ++i)
    {
      const auto c = cavity.cells()[k];
      const auto n = c->neighbor(i);
      if(! cavity.contains(n) && ! cavity.is_closed(c, i) && is_wanted(n))
        cavity.add(n);
    }
}

// Takes out the cells at faces that v does not see from inside, until it sees all. The first cells, the seeds, have to
// stay: returns false if one of them is at such a face. Whatever the order, the same cells stay.
template <typename Cavity, typename Predicates>
bool shrink_until_seen(Cavity& cavity, const typename Cavity::Vertex_handle v, const Predicates& predicates,
                       const std::size_t number_of_seeds)
{
  typedef typename Cavity::Cell_handle Cell_handle;
  const auto is_at_hidden_face = [&](const Cell_handle c)
  {
    for(int i = 0; i < 4; ++i)
    {
      const auto f = internal::facet_vertices(c, i);
      if(! cavity.contains(c->neighbor(i)) && predicates.orientation(f[0], f[1], f[2], v) != POSITIVE)
        return true;
    }
    return false;
  };
  std::vector<Cell_handle> open = cavity.cells();
  const std::vector<Cell_handle> seeds(open.begin(), open.begin() + number_of_seeds);
  while(! open.empty())
  {
    const Cell_handle c = open.back();
    open.pop_back();
    if(! cavity.contains(c) || ! is_at_hidden_face(c))
      continue;
    if(internal::contains(seeds, c))
      return false;
    cavity.remove(c);
    for(int i = 0; i < 4; ++i)
      open.push_back(c->neighbor(i));
  }
  return true;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_CAVITY_3_H
