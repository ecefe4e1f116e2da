// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_CANDIDATE_TETRAHEDRA_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_CANDIDATE_TETRAHEDRA_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Face_matching.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Free_simplices_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Polyhedron_obstacles_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The tetrahedra between the vertices of a polyhedron that can be in a tetrahedralization of it, and the sides of faces
 * at which they are, as Face_matching wants them.
 *
 * The polyhedron is a set of cells of the mesh. First come the edges that cross no obstacle and are inside, then the
 * faces between these, then the tetrahedra between those. So the number of tetrahedra depends on how many vertices see
 * each other, which are few where there are many constraints. (What is outside is left out early, for it is nine of ten
 * tetrahedra around holes and notches.)
 */
template <typename Tr>
class Candidate_tetrahedra_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef Vertex_predicates_3<Tr>       Predicates;
  typedef std::array<Vertex_handle, 3>  Vertex_triple;
  typedef std::array<Vertex_handle, 4>  Tetrahedron;
  typedef Face_matching::Side           Side;
  typedef Face_matching::Sides          Sides;

  explicit Candidate_tetrahedra_3(const Predicates& predicates)
    : m_obstacles(predicates), m_edges(m_obstacles), m_faces(m_obstacles)
  { }

  Candidate_tetrahedra_3(const Candidate_tetrahedra_3&) = delete;
  Candidate_tetrahedra_3& operator=(const Candidate_tetrahedra_3&) = delete;

  // `cells` are finite cells whose union is a polyhedron; `edges` and `facets` are arrays of vertices of these cells,
  // of required simplices. Those of the `free_vertices` that are inside the polyhedron need not be used; `superfluous`
  // is not. Returns false if there are more than `max_number` tetrahedra.
  template <typename CellRange, typename EdgeRange, typename FacetRange>
  bool collect(const CellRange& cells, const EdgeRange& edges, const FacetRange& facets,
               const std::vector<Vertex_handle>& free_vertices, const Vertex_handle superfluous,
               const std::size_t max_number)
  {
    m_obstacles.assign(cells, edges, facets, superfluous);
    collect_inner_vertices(free_vertices);
    m_edges.collect(cells);
    m_faces.collect(m_edges.greater_ends());
    collect_boundary();
    return collect_tetrahedra(max_number);
  }

  std::size_t number_of_sides() const { return 2 * m_faces.size(); }

  // The inner sides of the faces on the boundary.
  const std::vector<Side>& boundary() const { return m_boundary; }

  // Of each tetrahedron, the sides at which it is.
  const std::vector<Sides>& tetrahedra() const { return m_tetrahedra; }

  // The vertices of a tetrahedron, positively oriented.
  Tetrahedron vertices_of_tetrahedron(const std::size_t t) const
  {
    const Vertex_triple f = vertices_of_side(m_tetrahedra[t][3]);
    return {{ f[0], f[1], f[2], vertices()[m_last_vertices[t]] }};
  }

  const std::vector<Vertex_handle>& vertices() const { return m_obstacles.vertices(); }

private:
  typedef Polyhedron_obstacles_3<Tr>      Obstacles;
  typedef typename Obstacles::Outer_face  Outer_face;
  typedef typename Obstacles::Face        Face;
  typedef Free_faces_3<Tr>                Free_faces;
  typedef typename Free_faces::Number     Number;

  std::size_t n() const { return m_obstacles.number_of_vertices(); }

  // The vertices of a face such that the tetrahedra at that side are on the positive side.
  Vertex_triple vertices_of_side(const Side s) const
  {
    const Face f = m_faces[s / 2];
    Vertex_triple result = {{ vertices()[f[0]], vertices()[f[1]], vertices()[f[2]] }};
    if(s % 2 != 0)
      std::swap(result[0], result[1]);
    return result;
  }

  // Those that have to be used and are on no face of the boundary, which make sure of themselves.
  void collect_inner_vertices(const std::vector<Vertex_handle>& free_vertices)
  {
    m_inner_vertices.clear();
    for(std::size_t v = 0; v < n(); ++v)
      if(! m_obstacles.is_outer(v) && ! internal::contains(free_vertices, vertices()[v]))
        m_inner_vertices.push_back(v);
  }

  void collect_boundary()
  {
    CGAL_assertion(number_of_sides() < (std::numeric_limits<Number>::max)());
    m_boundary.clear();
    m_is_outer_side.assign(number_of_sides(), false);
    for(const Outer_face& f : m_obstacles.outer_faces())
    {
      CGAL_assertion(m_faces.find(f.face) != m_faces.size());
      m_boundary.push_back(side(m_faces.find(f.face), f.inner_side));
      m_is_outer_side[Face_matching::opposite(m_boundary.back())] = true;
    }
  }

  // The positive sides are even.
  static Side side(const std::size_t face, const Orientation o)
  {
    return static_cast<Side>(2 * face + (o == POSITIVE ? 0 : 1));
  }

  bool collect_tetrahedra(const std::size_t max_number)
  {
    m_tetrahedra.clear();
    m_last_vertices.clear();
    m_faces_at_vertex.resize(n() * n());
    for(std::size_t a = 0; a < n(); ++a)
    {
      for(std::size_t b = a + 1; b < n(); ++b)
        for(Number i = m_faces.begin_at(a, b); i < m_faces.end_at(a, b); ++i)
          m_faces_at_vertex[b * n() + m_faces.third(i)] = i;
      for(std::size_t b = a + 1; b < n(); ++b)
      {
        for(Number i = m_faces.begin_at(a, b); i < m_faces.end_at(a, b); ++i)
          add_tetrahedra(a, b, i);
        if(m_tetrahedra.size() > max_number)
          return false;
      }
    }
    return true;
  }

  // Those at the face i, which is at the edge ab, that have their greatest vertex off it.
  void add_tetrahedra(const std::size_t a, const std::size_t b, const std::size_t i)
  {
    const std::size_t c = m_faces.third(i);
    m_faces.for_each_common_third(a, b, c, [&](const std::size_t d)
    {
      const Orientation o = m_obstacles.orientation({{ a, b, c }}, d);
      if(o == COPLANAR || this->contains_inner_vertex({{ a, b, c, d }}, o))
        return;
      const Sides sides = {{ side(m_faces.find({{ b, c, d }}), -o), side(m_faces_at_vertex[c * this->n() + d], o),
                             side(m_faces_at_vertex[b * this->n() + d], -o), side(i, o) }};
      if(std::any_of(sides.begin(), sides.end(), [this](const Side s) { return m_is_outer_side[s]; }))
        return;
      m_tetrahedra.push_back(sides);
      m_last_vertices.push_back(static_cast<Number>(d));
    });
  }

  // In the interior or on the boundary, and not as one of its own vertices; o is the orientation.
  bool contains_inner_vertex(const std::array<std::size_t, 4>& t, const Orientation o) const
  {
    return std::any_of(m_inner_vertices.begin(), m_inner_vertices.end(), [&](const std::size_t v)
    {
      for(int i = 0; i < 4; ++i)
      {
        std::array<std::size_t, 4> p = t;
        p[i] = v;
        if(t[i] == v || m_obstacles.orientation({{ p[0], p[1], p[2] }}, p[3]) == -o)
          return false;
      }
      return true;
    });
  }

  Obstacles m_obstacles;
  Free_edges_3<Tr> m_edges;
  Free_faces m_faces;
  std::vector<std::size_t> m_inner_vertices; // those that are not on the boundary, and have to be used
  std::vector<Number> m_faces_at_vertex;     // of each pair, the position of its face with the vertex in hand
  std::vector<Side> m_boundary;
  std::vector<char> m_is_outer_side;         // of each side, whether it is on the boundary, outside
  std::vector<Sides> m_tetrahedra;           // the side opposite to the greatest vertex is last
  std::vector<Number> m_last_vertices;       // of the tetrahedra, their greatest vertices
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_CANDIDATE_TETRAHEDRA_3_H
