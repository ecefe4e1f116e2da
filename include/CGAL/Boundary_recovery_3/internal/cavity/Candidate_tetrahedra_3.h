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
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Bit_matrix.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The tetrahedra between the vertices of a polyhedron that can be in a tetrahedralization of it, and the sides of faces
 * at which they are, as Face_matching wants them.
 *
 * The polyhedron is a set of cells of the mesh. Its obstacles are its boundary, and edges and facets that are required
 * inside; what crosses one of them is in no tetrahedralization that has them. First come the edges that cross none and
 * are inside, then the faces between these, then the tetrahedra between those. So the number of tetrahedra depends on
 * how many vertices see each other, which are few where there are many constraints. (What is outside is left out early,
 * for it is nine of ten tetrahedra around holes and notches.)
 *
 * An edge inside the polyhedron, between two of its vertices, that nothing crosses is in every tetrahedralization; so
 * all that is required is.
 */
template <typename Tr>
class Candidate_tetrahedra_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef Vertex_predicates_3<Tr>       Predicates;
  typedef std::array<Vertex_handle, 3>  Triangle;
  typedef std::array<Vertex_handle, 4>  Tetrahedron;
  typedef Face_matching::Side           Side;
  typedef Face_matching::Sides          Sides;

  explicit Candidate_tetrahedra_3(const Predicates& predicates) : m_predicates(predicates) { }

  // `cells` are finite cells whose union is a polyhedron; `edges` and `facets` are arrays of vertices of these cells,
  // of required simplices. Those of the `free_vertices` that are inside the polyhedron need not be used; `superfluous`
  // is not. Returns false if there are more than `max_number` tetrahedra.
  template <typename CellRange, typename EdgeRange, typename FacetRange>
  bool collect(const CellRange& cells, const EdgeRange& edges, const FacetRange& facets,
               const std::vector<Vertex_handle>& free_vertices, const Vertex_handle superfluous,
               const std::size_t max_number)
  {
    collect_vertices(cells, superfluous);
    collect_outer_faces(cells);
    collect_obstacles(edges, facets);
    collect_inner_vertices(free_vertices);
    collect_cells_at_vertices(cells);
    collect_edges();
    collect_faces();
    collect_boundary();
    return collect_tetrahedra(max_number);
  }

  std::size_t number_of_sides() const { return 2 * m_thirds.size(); }

  // The inner sides of the faces on the boundary.
  const std::vector<Side>& boundary() const { return m_boundary; }

  // Of each tetrahedron, the sides at which it is.
  const std::vector<Sides>& tetrahedra() const { return m_tetrahedra; }

  // The vertices of a tetrahedron, positively oriented.
  Tetrahedron vertices_of_tetrahedron(const std::size_t t) const
  {
    const Triangle f = vertices_of_side(m_tetrahedra[t][3]);
    return {{ f[0], f[1], f[2], m_vertices[m_last_vertices[t]] }};
  }

  // The vertices of a face such that the tetrahedra at that side are on the positive side.
  Triangle vertices_of_side(const Side s) const
  {
    const std::size_t f = s / 2;
    const std::size_t e = std::upper_bound(m_first.begin(), m_first.end(), f) - m_first.begin() - 1;
    Triangle result = {{ m_vertices[e / n()], m_vertices[e % n()], m_vertices[m_thirds[f]] }};
    if(s % 2 != 0)
      std::swap(result[0], result[1]);
    return result;
  }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

private:
  typedef std::uint32_t Number; // of a face or a vertex: there may be many, so memory counts

  // By positions in the list of vertices, in increasing order.
  typedef std::array<std::size_t, 2> Edge;
  typedef std::array<std::size_t, 3> Face;

  // A face on the boundary, and on which side of it the polyhedron is.
  struct Outer_face
  {
    Face face;
    Orientation inner_side;
  };

  struct Obstacles
  {
    std::vector<Edge> edges;
    std::vector<Face> faces;
    std::vector<Bbox_3> boxes;      // of the faces
    std::vector<std::size_t> aside; // of each face, a vertex that is not in its plane
    Bit_matrix positive, negative;  // for each vertex, the faces that have it on this side
    Bit_matrix coplanar;            // for each vertex, the faces that have it in their plane
    Bit_matrix stars;               // for each vertex, the faces at it, which are among these
    Bit_matrix inner, outer;        // for each vertex, the faces of the boundary that have it on this side
    std::vector<Edge> inner_edges;  // those that are not on the boundary
    std::vector<Edge> single_edges; // those that are in none of the faces
  };

  std::size_t n() const { return m_vertices.size(); }

  template <std::size_t N>
  std::array<std::size_t, N> positions(const std::array<Vertex_handle, N>& simplex) const
  {
    std::array<std::size_t, N> result;
    std::transform(simplex.begin(), simplex.end(), result.begin(),
                   [this](const Vertex_handle v) { return m_positions[{{ v }}]; });
    std::sort(result.begin(), result.end());
    return result;
  }

  template <std::size_t N>
  Bbox_3 bbox(const std::array<std::size_t, N>& simplex) const
  {
    Bbox_3 result;
    for(const std::size_t v : simplex)
      result += m_boxes[v];
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
    internal::for_each_outer_facet(cells, [this](const Cell_handle c, const int i)
    {
      const Triangle f = internal::facet_vertices(c, i); // the cell is on its positive side
      const std::array<std::size_t, 3> p = {{ m_positions[{{ f[0] }}], m_positions[{{ f[1] }}],
                                              m_positions[{{ f[2] }}] }};
      const bool is_odd = ((p[0] > p[1]) != (p[0] > p[2])) != (p[1] > p[2]);
      m_outer_faces.push_back({ positions(f), is_odd ? NEGATIVE : POSITIVE });
    });
  }

  template <typename EdgeRange, typename FacetRange>
  void collect_obstacles(const EdgeRange& edges, const FacetRange& facets)
  {
    m_obstacles = Obstacles();
    std::vector<Face> outer_faces;
    for(const Outer_face& f : m_outer_faces)
      outer_faces.push_back(f.face);
    m_obstacles.faces = outer_faces;
    for(const auto& f : facets)
      m_obstacles.faces.push_back(positions(f));
    make_unique(m_obstacles.faces);
    for(const auto& e : edges)
      m_obstacles.edges.push_back(positions(e));
    make_unique(m_obstacles.edges);
    const std::vector<Edge> edges_of_faces = edges_of(m_obstacles.faces);
    m_obstacles.single_edges = difference(m_obstacles.edges, edges_of_faces);
    m_obstacles.edges.insert(m_obstacles.edges.end(), edges_of_faces.begin(), edges_of_faces.end());
    make_unique(m_obstacles.edges);
    m_obstacles.inner_edges = difference(m_obstacles.edges, edges_of(outer_faces));
    for(const Face& f : m_obstacles.faces)
      m_obstacles.boxes.push_back(bbox(f));
    collect_sides();
  }

  void collect_sides()
  {
    const std::size_t number_of_faces = m_obstacles.faces.size();
    for(Bit_matrix Obstacles::* const m : { &Obstacles::positive, &Obstacles::negative, &Obstacles::coplanar,
                                            &Obstacles::stars, &Obstacles::inner, &Obstacles::outer })
      (m_obstacles.*m).assign(n(), number_of_faces);
    m_obstacles.aside.assign(number_of_faces, n());
    const std::vector<Orientation> inner_sides = this->inner_sides();
    for(std::size_t i = 0; i < number_of_faces; ++i)
      for(std::size_t v = 0; v < n(); ++v)
      {
        if(internal::contains(m_obstacles.faces[i], v))
        {
          m_obstacles.stars.set(v, i);
          m_obstacles.coplanar.set(v, i);
          continue;
        }
        const Orientation o = orientation(m_obstacles.faces[i], v);
        (o == COPLANAR ? m_obstacles.coplanar : o == POSITIVE ? m_obstacles.positive : m_obstacles.negative).set(v, i);
        if(o == COPLANAR)
          continue;
        m_obstacles.aside[i] = v;
        if(inner_sides[i] != COPLANAR)
          (o == inner_sides[i] ? m_obstacles.inner : m_obstacles.outer).set(v, i);
      }
  }

  // Of each face of the obstacles, the side on which the polyhedron is; COPLANAR if it is on both.
  std::vector<Orientation> inner_sides() const
  {
    std::vector<Orientation> result(m_obstacles.faces.size(), COPLANAR);
    for(const Outer_face& f : m_outer_faces)
      result[std::lower_bound(m_obstacles.faces.begin(), m_obstacles.faces.end(), f.face)
             - m_obstacles.faces.begin()] = f.inner_side;
    return result;
  }

  // The faces of the obstacles that have a and b on opposite sides, word by word.
  Bits separating(const std::size_t a, const std::size_t b, const std::size_t w) const
  {
    return (m_obstacles.positive.word(a, w) & m_obstacles.negative.word(b, w))
         | (m_obstacles.negative.word(a, w) & m_obstacles.positive.word(b, w));
  }

  static std::vector<Edge> difference(const std::vector<Edge>& a, const std::vector<Edge>& b)
  {
    std::vector<Edge> result;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
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

  static std::vector<Edge> edges_of(const std::vector<Face>& faces)
  {
    std::vector<Edge> result;
    for(const Face& f : faces)
      result.insert(result.end(), { {{ f[0], f[1] }}, {{ f[0], f[2] }}, {{ f[1], f[2] }} });
    make_unique(result);
    return result;
  }

  template <typename Simplex>
  static void make_unique(std::vector<Simplex>& simplices)
  {
    std::sort(simplices.begin(), simplices.end());
    simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  }

  // Those that have to be used and are on no face of the boundary, which make sure of themselves.
  void collect_inner_vertices(const std::vector<Vertex_handle>& free_vertices)
  {
    m_is_outer.assign(n(), false);
    for(const Outer_face& f : m_outer_faces)
      for(const std::size_t v : f.face)
        m_is_outer[v] = true;
    m_inner_vertices.clear();
    for(std::size_t v = 0; v < n(); ++v)
      if(! m_is_outer[v] && ! internal::contains(free_vertices, m_vertices[v]))
        m_inner_vertices.push_back(v);
  }

  // --- edges ---------------------------------------------------------------------------------------------------------

  template <typename CellRange>
  void collect_cells_at_vertices(const CellRange& cells)
  {
    m_cells_at.assign(n(), std::vector<Cell_handle>());
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
      {
        const std::size_t v = m_positions[{{ c->vertex(i) }}];
        if(v != m_positions.none) // it may be the superfluous one
          m_cells_at[v].push_back(c);
      }
  }

  void collect_edges()
  {
    m_edges.assign(n(), n());
    for(std::size_t a = 0; a < n(); ++a)
      for(std::size_t b = a + 1; b < n(); ++b)
      {
        const Edge e = {{ a, b }};
        if(std::binary_search(m_obstacles.edges.begin(), m_obstacles.edges.end(), e) || is_inside_and_free(e))
          m_edges.set(a, b);
      }
  }

  // For an edge that is no obstacle. One that crosses none is inside at both ends or at none; unless it passes through
  // a vertex, and then it may be kept, for it is in no tetrahedralization anyway.
  bool is_inside_and_free(const Edge& e) const
  {
    const Uncertain<bool> at_0 = starts_inside(e[0], e[1]), at_1 = starts_inside(e[1], e[0]);
    return CGAL::possibly(at_0) && CGAL::possibly(at_1) && is_free(e)
        && (CGAL::certainly(at_0) || CGAL::certainly(at_1) || is_inside_at_cells(e));
  }

  // Whether the ray from a to b starts inside the polyhedron, as far as the sides of the faces at a tell. The shortest
  // way from a direction to the boundary, seen from a, ends at a face that has it on its inner side if it comes from
  // inside, on its outer side if from outside. A ray along the boundary may be taken for either: such an edge overlaps
  // or crosses one of the boundary, and is not wanted.
  Uncertain<bool> starts_inside(const std::size_t a, const std::size_t b) const
  {
    const auto is_any = [&](const Bit_matrix& side)
    {
      return side.any_of([&](const std::size_t w) { return m_obstacles.stars.word(a, w) & side.word(b, w); },
                         [](std::size_t) { return true; });
    };
    if(! m_is_outer[a])
      return true;
    if(! is_any(m_obstacles.inner))
      return false;
    return is_any(m_obstacles.outer) ? Uncertain<bool>::indeterminate() : Uncertain<bool>(true);
  }

  // Whether an edge between vertices on the boundary starts inside the polyhedron, by the cells at one of them.
  bool is_inside_at_cells(const Edge& e) const
  {
    const bool is_first = m_cells_at[e[0]].size() <= m_cells_at[e[1]].size();
    const std::size_t a = e[is_first ? 0 : 1], b = e[is_first ? 1 : 0];
    return std::any_of(m_cells_at[a].begin(), m_cells_at[a].end(),
                       [&](const Cell_handle c) { return starts_in(c, m_vertices[a], m_vertices[b]); });
  }

  // Whether the ray from a, a vertex of the cell, to b starts in the closed cell.
  bool starts_in(const Cell_handle c, const Vertex_handle a, const Vertex_handle b) const
  {
    for(int i = 0; i < 4; ++i)
    {
      const Tetrahedron t = internal::with_exchanged_vertex(c, c->vertex(i), b);
      if(c->vertex(i) != a && m_predicates.orientation(t[0], t[1], t[2], t[3]) == NEGATIVE)
        return false;
    }
    return true;
  }

  // Whether no obstacle crosses the edge, which is none itself.
  bool is_free(const Edge& e) const
  {
    const Bbox_3 box = bbox(e);
    const auto separating_faces = [&](const std::size_t w) { return separating(e[0], e[1], w); };
    const auto faces_in_plane = [&](const std::size_t w)
    {
      return m_obstacles.coplanar.word(e[0], w) & m_obstacles.coplanar.word(e[1], w);
    };
    const auto is_near = [&](const std::size_t i) { return CGAL::do_overlap(box, m_obstacles.boxes[i]); };
    return ! m_obstacles.positive.any_of(separating_faces, [&](const std::size_t i)
           {
             return is_near(i) && crosses_through(e, m_obstacles.faces[i]);
           })
        && ! m_obstacles.coplanar.any_of(faces_in_plane, [&](const std::size_t i)
           {
             return is_near(i) && crosses_in_plane(e, i);
           })
        && std::none_of(m_obstacles.single_edges.begin(), m_obstacles.single_edges.end(),
                        [&](const Edge& f) { return cross(e, f); });
  }

  // Whether an edge in the plane of a face of the obstacles crosses one of its edges: seen from a vertex off the plane,
  // each has the ends of the other one on opposite sides.
  bool crosses_in_plane(const Edge& e, const std::size_t i) const
  {
    const Face& f = m_obstacles.faces[i];
    const std::size_t x = m_obstacles.aside[i];
    const std::array<Orientation, 3> sides = {{ orientation(e, x, f[0]), orientation(e, x, f[1]),
                                                orientation(e, x, f[2]) }};
    for(int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      if(sides[k] * sides[l] == NEGATIVE
         && orientation({{ f[k], f[l] }}, x, e[0]) * orientation({{ f[k], f[l] }}, x, e[1]) == NEGATIVE)
        return true;
    }
    return false;
  }

  // Whether an edge with ends on both sides of the face pierces it or crosses one of its edges.
  bool crosses_through(const Edge& e, const Face& f) const
  {
    std::array<int, 3> number_of = {{ 0, 0, 0 }}; // of the edges of the face, by how the edge passes them
    for(int k = 0; k < 3; ++k)
    {
      ++number_of[orientation(e, f[k], f[(k + 1) % 3]) + 1];
      if(number_of[0] * number_of[2] != 0 || number_of[1] == 2)
        return false;
    }
    return true;
  }

  bool pierces(const Edge& e, const Face& f) const
  {
    return m_predicates.segment_pierces_triangle(m_vertices[e[0]], m_vertices[e[1]],
                                                 m_vertices[f[0]], m_vertices[f[1]], m_vertices[f[2]]);
  }

  bool cross(const Edge& e, const Edge& f) const
  {
    return m_predicates.segments_cross(m_vertices[e[0]], m_vertices[e[1]], m_vertices[f[0]], m_vertices[f[1]]);
  }

  // --- faces ---------------------------------------------------------------------------------------------------------

  // All faces, ordered by their vertices.
  void collect_faces()
  {
    m_first.assign(1, 0);
    m_thirds.clear();
    m_faces.assign(n() * n(), n());
    for(std::size_t a = 0; a < n(); ++a)
      for(std::size_t b = 0; b < n(); ++b)
      {
        if(m_edges(a, b))
          m_edges.for_each([&](const std::size_t w) { return m_edges.word(a, w) & m_edges.word(b, w); },
                           [&](const std::size_t c) { add_face({{ a, b, c }}); });
        m_first.push_back(static_cast<Number>(m_thirds.size()));
      }
  }

  void add_face(const Face& f)
  {
    if(! is_free(f))
      return;
    m_thirds.push_back(static_cast<Number>(f[2]));
    m_faces.set(f[0] * n() + f[1], f[2]);
  }

  // Whether no obstacle pierces the face, of which all edges are free. Where a surface of obstacles passes through it,
  // this starts at one of its vertices, mostly, so it is enough to look there; what is overlooked, Face_matching finds.
  bool is_free(const Face& f) const
  {
    for(int k = 0; k < 3; ++k)
    {
      const std::size_t v = f[k], b = f[(k + 1) % 3], c = f[(k + 2) % 3];
      const auto separating_faces = [&](const std::size_t w)
      {
        return m_obstacles.stars.word(v, w) & separating(b, c, w);
      };
      if(m_obstacles.stars.any_of(separating_faces,
                                  [&](const std::size_t i) { return pierces_at_vertex(i, v, b, c); }))
        return false;
    }
    return std::none_of(m_obstacles.inner_edges.begin(), m_obstacles.inner_edges.end(),
                        [&](const Edge& e) { return pierces(e, f); });
  }

  // Whether the opposite edge of v in a face of the obstacles, which has b and c on opposite sides, pierces vbc.
  bool pierces_at_vertex(const std::size_t i, const std::size_t v, const std::size_t b, const std::size_t c) const
  {
    const Face& f = m_obstacles.faces[i];
    const std::size_t k = std::find(f.begin(), f.end(), v) - f.begin();
    const Edge e = {{ f[(k + 1) % 3], f[(k + 2) % 3] }};
    const Orientation side_of_b = m_obstacles.positive(b, i) ? POSITIVE : NEGATIVE; // the line of e passes b there, too
    return orientation(e, b, c) == side_of_b
        && orientation({{ v, b, c }}, e[0]) * orientation({{ v, b, c }}, e[1]) == NEGATIVE;
  }

  // The position of a face in the list of all, or their number.
  std::size_t find(const Face& f) const
  {
    const std::size_t e = f[0] * n() + f[1];
    const auto begin = m_thirds.begin() + m_first[e], end = m_thirds.begin() + m_first[e + 1];
    const auto it = std::lower_bound(begin, end, f[2]);
    return it != end && *it == f[2] ? it - m_thirds.begin() : m_thirds.size();
  }

  void collect_boundary()
  {
    CGAL_assertion(number_of_sides() < (std::numeric_limits<Number>::max)());
    m_boundary.clear();
    m_is_outer_side.assign(number_of_sides(), false);
    for(const Outer_face& f : m_outer_faces)
    {
      CGAL_assertion(find(f.face) != m_thirds.size());
      m_boundary.push_back(side(find(f.face), f.inner_side));
      m_is_outer_side[Face_matching::opposite(m_boundary.back())] = true;
    }
  }

  // The positive sides are even.
  static Side side(const std::size_t face, const Orientation o)
  {
    return static_cast<Side>(2 * face + (o == POSITIVE ? 0 : 1));
  }

  // --- tetrahedra ----------------------------------------------------------------------------------------------------

  bool collect_tetrahedra(const std::size_t max_number)
  {
    m_tetrahedra.clear();
    m_last_vertices.clear();
    m_faces_at_vertex.resize(n() * n());
    for(std::size_t a = 0; a < n(); ++a)
    {
      for(std::size_t b = a + 1; b < n(); ++b)
        for(Number i = m_first[a * n() + b]; i < m_first[a * n() + b + 1]; ++i)
          m_faces_at_vertex[b * n() + m_thirds[i]] = i;
      for(std::size_t b = a + 1; b < n(); ++b)
      {
        for(Number i = m_first[a * n() + b]; i < m_first[a * n() + b + 1]; ++i)
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
    const std::size_t c = m_thirds[i];
    const auto last_vertices = [&](const std::size_t w)
    {
      return m_faces.word(a * n() + b, w) & m_faces.word(a * n() + c, w) & m_faces.word(b * n() + c, w);
    };
    m_faces.for_each(last_vertices, [&](const std::size_t d)
    {
      const Orientation o = orientation({{ a, b, c }}, d);
      if(o == COPLANAR || contains_inner_vertex({{ a, b, c, d }}, o))
        return;
      const Sides sides = {{ side(find({{ b, c, d }}), -o), side(m_faces_at_vertex[c * n() + d], o),
                             side(m_faces_at_vertex[b * n() + d], -o), side(i, o) }};
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
        std::array<Vertex_handle, 4> p = {{ m_vertices[t[0]], m_vertices[t[1]], m_vertices[t[2]], m_vertices[t[3]] }};
        p[i] = m_vertices[v];
        if(t[i] == v || m_predicates.orientation(p[0], p[1], p[2], p[3]) == -o)
          return false;
      }
      return true;
    });
  }

  const Predicates& m_predicates;
  std::vector<Vertex_handle> m_vertices;
  Simplex_index_3<Vertex_handle, 1> m_positions; // of these
  std::vector<Bbox_3> m_boxes;                   // around these
  std::vector<Outer_face> m_outer_faces;
  std::vector<char> m_is_outer;                  // of each vertex, whether it is on the boundary
  std::vector<std::size_t> m_inner_vertices;     // those that are not, and have to be used
  std::vector<std::vector<Cell_handle> > m_cells_at; // of each vertex, the cells of the polyhedron at it
  Obstacles m_obstacles;
  Bit_matrix m_edges;                            // for each vertex, the other ends of its edges, if greater
  Bit_matrix m_faces;                            // for each pair of vertices, the third ones of its faces, if greater
  std::vector<Number> m_first;                   // of each pair of vertices, where its faces begin
  std::vector<Number> m_thirds;                  // of the faces at one edge after the other, their greatest vertices
  std::vector<Number> m_faces_at_vertex;         // of each pair, the position of its face with the vertex in hand
  std::vector<Side> m_boundary;
  std::vector<char> m_is_outer_side;             // of each side, whether it is on the boundary, outside
  std::vector<Sides> m_tetrahedra;               // the side opposite to the greatest vertex is last
  std::vector<Number> m_last_vertices;           // of the tetrahedra, their greatest vertices
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_CANDIDATE_TETRAHEDRA_3_H
