// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_POLYHEDRON_OBSTACLES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_POLYHEDRON_OBSTACLES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The vertices of a polyhedron, and its obstacles: the faces of its boundary, and edges and facets that are required
 * inside. What crosses one of them is in no tetrahedralization that has them.
 *
 * An edge inside the polyhedron, between two of its vertices, that nothing crosses is in every tetrahedralization; so
 * all that is required is.
 *
 * Vertices are given by their positions in the list of vertices, obstacles by the vertices in increasing order.
 */
template <typename Tr>
class Polyhedron_obstacles_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef Vertex_predicates_3<Tr>       Predicates;
  typedef std::array<std::size_t, 2>    Edge;
  typedef std::array<std::size_t, 3>    Face;

  // A face on the boundary, and on which side of it the polyhedron is.
  struct Outer_face
  {
    Face face;
    Orientation inner_side;
  };

  // For each vertex, the faces of the obstacles that are somewhere as seen from it.
  struct Sides
  {
    Bit_matrix positive, negative;  // those that have it on this side
    Bit_matrix coplanar;            // those that have it in their plane
    Bit_matrix stars;               // those at it, which are among these
    Bit_matrix inner, outer;        // those of the boundary that have it on this side
  };

  explicit Polyhedron_obstacles_3(const Predicates& predicates) : m_predicates(predicates) { }

  // `cells` are finite cells whose union is a polyhedron; `edges` and `facets` are arrays of vertices of these cells,
  // of required simplices. `superfluous` is a vertex that is left out.
  template <typename CellRange, typename EdgeRange, typename FacetRange>
  void assign(const CellRange& cells, const EdgeRange& edges, const FacetRange& facets,
              const Vertex_handle superfluous)
  {
    collect_vertices(cells, superfluous);
    collect_outer_faces(cells);
    collect_faces(facets);
    collect_edges(edges);
    collect_sides();
  }

  const Predicates& predicates() const { return m_predicates; }

  std::size_t number_of_vertices() const { return m_vertices.size(); }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }
  Vertex_handle vertex(const std::size_t v) const { return m_vertices[v]; }

  // m_positions.none if it is the superfluous one.
  std::size_t position(const Vertex_handle v) const { return m_positions[{{ v }}]; }

  const std::vector<Outer_face>& outer_faces() const { return m_outer_faces; }

  // Whether a vertex is on the boundary.
  bool is_outer(const std::size_t v) const { return m_is_outer[v]; }

  // All of them, in order.
  const std::vector<Face>& faces() const { return m_faces; }

  bool has_edge(const Edge& e) const { return std::binary_search(m_edges.begin(), m_edges.end(), e); }

  // Those edges that are not on the boundary, and those that are in none of the faces.
  const std::vector<Edge>& inner_edges() const { return m_inner_edges; }
  const std::vector<Edge>& single_edges() const { return m_single_edges; }

  // Around the face i.
  const Bbox_3& box(const std::size_t i) const { return m_boxes_of_faces[i]; }

  // A vertex that is not in the plane of the face i.
  std::size_t aside(const std::size_t i) const { return m_aside[i]; }

  const Sides& sides() const { return m_sides; }

  // The faces that have a and b on opposite sides, word by word.
  Bits separating(const std::size_t a, const std::size_t b, const std::size_t w) const
  {
    return (m_sides.positive.word(a, w) & m_sides.negative.word(b, w))
         | (m_sides.negative.word(a, w) & m_sides.positive.word(b, w));
  }

  Orientation orientation(const Face& f, const std::size_t v) const
  {
    return m_predicates.orientation(m_vertices[f[0]], m_vertices[f[1]], m_vertices[f[2]], m_vertices[v]);
  }

  // Zero if two of them are the same.
  Orientation orientation(const Edge& e, const std::size_t v, const std::size_t w) const
  {
    return m_predicates.orientation(m_vertices[e[0]], m_vertices[e[1]], m_vertices[v], m_vertices[w]);
  }

  template <std::size_t N>
  Bbox_3 bbox(const std::array<std::size_t, N>& simplex) const
  {
    Bbox_3 result;
    for(const std::size_t v : simplex)
      result += m_boxes[v];
    return result;
  }

private:
  template <std::size_t N>
  std::array<std::size_t, N> positions(const std::array<Vertex_handle, N>& simplex) const
  {
    std::array<std::size_t, N> result;
    std::transform(simplex.begin(), simplex.end(), result.begin(),
                   [this](const Vertex_handle v) { return this->position(v); });
    std::sort(result.begin(), result.end());
    return result;
  }

  template <typename CellRange>
  void collect_vertices(const CellRange& cells, const Vertex_handle superfluous)
  {
    m_vertices = internal::vertices_without(cells, superfluous);
    m_positions = Simplex_index_3<Vertex_handle, 1>();
    m_boxes.clear();
    for(const Vertex_handle v : m_vertices)
    {
      m_positions.insert({{ v }});
      m_boxes.push_back(m_predicates.bbox(v));
    }
  }

  template <typename CellRange>
  void collect_outer_faces(const CellRange& cells)
  {
    m_outer_faces.clear();
    m_is_outer.assign(number_of_vertices(), false);
    internal::for_each_outer_facet(cells, [this](const Cell_handle c, const int i)
    {
      const auto f = internal::facet_vertices(c, i); // the cell is on its positive side
      const Face p = {{ this->position(f[0]), this->position(f[1]), this->position(f[2]) }};
      const bool is_odd = ((p[0] > p[1]) != (p[0] > p[2])) != (p[1] > p[2]);
      m_outer_faces.push_back({ this->positions(f), is_odd ? NEGATIVE : POSITIVE });
      for(const std::size_t v : p)
        m_is_outer[v] = true;
    });
  }

  std::vector<Face> faces_of_boundary() const
  {
    std::vector<Face> result;
    for(const Outer_face& f : m_outer_faces)
      result.push_back(f.face);
    return result;
  }

  template <typename FacetRange>
  void collect_faces(const FacetRange& facets)
  {
    m_faces = faces_of_boundary();
    for(const auto& f : facets)
      m_faces.push_back(positions(f));
    make_unique(m_faces);
    m_boxes_of_faces.clear();
    for(const Face& f : m_faces)
      m_boxes_of_faces.push_back(bbox(f));
  }

  template <typename EdgeRange>
  void collect_edges(const EdgeRange& edges)
  {
    m_edges.clear();
    for(const auto& e : edges)
      m_edges.push_back(positions(e));
    make_unique(m_edges);
    const std::vector<Edge> edges_of_faces = edges_of(m_faces);
    m_single_edges = difference(m_edges, edges_of_faces);
    m_edges.insert(m_edges.end(), edges_of_faces.begin(), edges_of_faces.end());
    make_unique(m_edges);
    m_inner_edges = difference(m_edges, edges_of(faces_of_boundary()));
  }

  static std::vector<Edge> edges_of(const std::vector<Face>& faces)
  {
    std::vector<Edge> result;
    for(const Face& f : faces)
      result.insert(result.end(), { {{ f[0], f[1] }}, {{ f[0], f[2] }}, {{ f[1], f[2] }} });
    make_unique(result);
    return result;
  }

  static std::vector<Edge> difference(const std::vector<Edge>& a, const std::vector<Edge>& b)
  {
    std::vector<Edge> result;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
  }

  template <typename Simplex>
  static void make_unique(std::vector<Simplex>& simplices)
  {
    std::sort(simplices.begin(), simplices.end());
    simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  }

  void collect_sides()
  {
    for(Bit_matrix Sides::* const m : { &Sides::positive, &Sides::negative, &Sides::coplanar, &Sides::stars,
                                        &Sides::inner, &Sides::outer })
      (m_sides.*m).assign(number_of_vertices(), m_faces.size());
    m_aside.assign(m_faces.size(), number_of_vertices());
    const std::vector<Orientation> inner_sides = this->inner_sides();
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      for(std::size_t v = 0; v < number_of_vertices(); ++v)
        collect_side(i, v, inner_sides[i]);
  }

  void collect_side(const std::size_t i, const std::size_t v, const Orientation inner_side)
  {
    if(internal::contains(m_faces[i], v))
    {
      m_sides.stars.set(v, i);
      m_sides.coplanar.set(v, i);
      return;
    }
    const Orientation o = orientation(m_faces[i], v);
    (o == COPLANAR ? m_sides.coplanar : o == POSITIVE ? m_sides.positive : m_sides.negative).set(v, i);
    if(o == COPLANAR)
      return;
    m_aside[i] = v;
    if(inner_side != COPLANAR)
      (o == inner_side ? m_sides.inner : m_sides.outer).set(v, i);
  }

  // Of each face, the side on which the polyhedron is; COPLANAR if it is on both.
  std::vector<Orientation> inner_sides() const
  {
    std::vector<Orientation> result(m_faces.size(), COPLANAR);
    for(const Outer_face& f : m_outer_faces)
      result[std::lower_bound(m_faces.begin(), m_faces.end(), f.face) - m_faces.begin()] = f.inner_side;
    return result;
  }

  const Predicates& m_predicates;
  std::vector<Vertex_handle> m_vertices;
  Simplex_index_3<Vertex_handle, 1> m_positions; // of these
  std::vector<Bbox_3> m_boxes;                   // around these
  std::vector<Outer_face> m_outer_faces;
  std::vector<char> m_is_outer;                  // of each vertex, whether it is on the boundary
  std::vector<Face> m_faces;
  std::vector<Bbox_3> m_boxes_of_faces;
  std::vector<std::size_t> m_aside;              // of each face, a vertex that is not in its plane
  Sides m_sides;
  std::vector<Edge> m_edges;
  std::vector<Edge> m_inner_edges;
  std::vector<Edge> m_single_edges;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_POLYHEDRON_OBSTACLES_3_H
