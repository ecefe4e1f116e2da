// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CANDIDATE_TETRAHEDRA_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CANDIDATE_TETRAHEDRA_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Face_matching.h>
#include <CGAL/Boundary_recovery_3/internal/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/contains.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
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
 * inside; what crosses one of them is in no tetrahedralization that has them. First come the edges that cross none,
 * then the faces between these, then the tetrahedra between those. So the number of tetrahedra depends on how many
 * vertices see each other, which are few where there are many constraints.
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
    const std::vector<Face> outer_faces = this->outer_faces(cells);
    collect_obstacles(outer_faces, edges, facets);
    collect_inner_vertices(outer_faces, free_vertices);
    collect_edges();
    collect_faces();
    collect_boundary(cells);
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
  // By positions in the list of vertices, in increasing order.
  typedef std::array<std::size_t, 2> Edge;
  typedef std::array<std::size_t, 3> Face;

  struct Obstacles
  {
    std::vector<Edge> edges;
    std::vector<Face> faces;
    std::vector<Bbox_3> boxes;                    // of the faces
    std::vector<std::vector<std::size_t> > stars; // of each vertex, the faces at it
    std::vector<Edge> inner_edges;                // those that are not on the boundary
    std::vector<Edge> single_edges;               // those that are in none of the faces
  };

  std::size_t n() const { return m_vertices.size(); }

  std::size_t position(const Vertex_handle v) const
  {
    return std::find(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin();
  }

  template <std::size_t N>
  std::array<std::size_t, N> positions(const std::array<Vertex_handle, N>& simplex) const
  {
    std::array<std::size_t, N> result;
    std::transform(simplex.begin(), simplex.end(), result.begin(),
                   [this](const Vertex_handle v) { return position(v); });
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
    m_boxes.clear();
    for(const Vertex_handle v : m_vertices)
      m_boxes.push_back(m_predicates.bbox(v));
  }

  template <typename CellRange>
  std::vector<Face> outer_faces(const CellRange& cells) const
  {
    std::vector<Face> result;
    internal::for_each_outer_facet(cells, [&](const Cell_handle c, const int i)
    {
      result.push_back(positions(internal::facet_vertices(c, i)));
    });
    return result;
  }

  template <typename EdgeRange, typename FacetRange>
  void collect_obstacles(const std::vector<Face>& outer_faces, const EdgeRange& edges, const FacetRange& facets)
  {
    m_obstacles = Obstacles();
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
    m_obstacles.stars.resize(n());
    for(std::size_t i = 0; i < m_obstacles.faces.size(); ++i)
    {
      m_obstacles.boxes.push_back(bbox(m_obstacles.faces[i]));
      for(const std::size_t v : m_obstacles.faces[i])
        m_obstacles.stars[v].push_back(i);
    }
    collect_sides();
  }

  static std::vector<Edge> difference(const std::vector<Edge>& a, const std::vector<Edge>& b)
  {
    std::vector<Edge> result;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
  }

  void collect_sides()
  {
    m_sides.clear();
    for(std::size_t v = 0; v < n(); ++v)
      for(const Face& f : m_obstacles.faces)
        m_sides.push_back(internal::contains(f, v) ? COPLANAR : orientation(f, v));
  }

  // On which side of a face of the obstacles a vertex is.
  Orientation side_of_obstacle(const std::size_t v, const std::size_t face) const
  {
    return m_sides[v * m_obstacles.faces.size() + face];
  }

  Orientation orientation(const Face& f, const std::size_t v) const
  {
    return m_predicates.orientation(m_vertices[f[0]], m_vertices[f[1]], m_vertices[f[2]], m_vertices[v]);
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
  void collect_inner_vertices(const std::vector<Face>& outer_faces, const std::vector<Vertex_handle>& free_vertices)
  {
    std::vector<char> is_inner(n(), true);
    for(const Face& f : outer_faces)
      for(const std::size_t v : f)
        is_inner[v] = false;
    m_inner_vertices.clear();
    for(std::size_t v = 0; v < n(); ++v)
      if(is_inner[v] && ! internal::contains(free_vertices, m_vertices[v]))
        m_inner_vertices.push_back(v);
  }

  // --- edges ---------------------------------------------------------------------------------------------------------

  void collect_edges()
  {
    m_above.assign(n(), std::vector<std::size_t>());
    for(std::size_t a = 0; a < n(); ++a)
      for(std::size_t b = a + 1; b < n(); ++b)
        if(is_free(Edge{{ a, b }}))
          m_above[a].push_back(b);
  }

  bool is_free(const Edge& e) const
  {
    if(std::binary_search(m_obstacles.edges.begin(), m_obstacles.edges.end(), e))
      return true;
    const Bbox_3 box = bbox(e);
    for(std::size_t i = 0; i < m_obstacles.faces.size(); ++i)
    {
      const Orientation side = side_of_obstacle(e[0], i);
      if(side == -side_of_obstacle(e[1], i) && CGAL::do_overlap(box, m_obstacles.boxes[i])
         && (side == COPLANAR ? crosses_in_plane(e, m_obstacles.faces[i]) : crosses_through(e, m_obstacles.faces[i])))
        return false;
    }
    return std::none_of(m_obstacles.single_edges.begin(), m_obstacles.single_edges.end(),
                        [&](const Edge& f) { return cross(e, f); });
  }

  // Whether an edge in the plane of the face crosses one of its edges.
  bool crosses_in_plane(const Edge& e, const Face& f) const
  {
    return cross(e, {{ f[0], f[1] }}) || cross(e, {{ f[0], f[2] }}) || cross(e, {{ f[1], f[2] }});
  }

  // Whether an edge with ends on both sides of the face pierces it or crosses one of its edges.
  bool crosses_through(const Edge& e, const Face& f) const
  {
    std::array<int, 3> number_of = {{ 0, 0, 0 }}; // of the edges of the face, by how the edge passes them
    for(int k = 0; k < 3; ++k)
    {
      const Orientation o = m_predicates.orientation(m_vertices[e[0]], m_vertices[e[1]],
                                                     m_vertices[f[k]], m_vertices[f[(k + 1) % 3]]);
      ++number_of[o + 1];
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
    std::vector<std::size_t> common;
    for(std::size_t a = 0; a < n(); ++a)
      for(std::size_t b = 0; b < n(); ++b)
      {
        if(std::binary_search(m_above[a].begin(), m_above[a].end(), b))
        {
          common.clear();
          std::set_intersection(m_above[a].begin(), m_above[a].end(), m_above[b].begin(), m_above[b].end(),
                                std::back_inserter(common));
          std::copy_if(common.begin(), common.end(), std::back_inserter(m_thirds),
                       [&](const std::size_t c) { return is_free(Face{{ a, b, c }}); });
        }
        m_first.push_back(m_thirds.size());
      }
  }

  // Whether no obstacle pierces the face, of which all edges are free. Where a surface of obstacles passes through it,
  // this starts at one of its vertices, mostly, so it is enough to look there; what is overlooked, Face_matching finds.
  bool is_free(const Face& f) const
  {
    for(int k = 0; k < 3; ++k)
      for(const std::size_t i : m_obstacles.stars[f[k]])
      {
        const Orientation side = side_of_obstacle(f[(k + 1) % 3], i);
        if(side != COPLANAR && side == -side_of_obstacle(f[(k + 2) % 3], i)
           && pierces(opposite_edge(m_obstacles.faces[i], f[k]), f))
          return false;
      }
    return std::none_of(m_obstacles.inner_edges.begin(), m_obstacles.inner_edges.end(),
                        [&](const Edge& e) { return pierces(e, f); });
  }

  static Edge opposite_edge(const Face& f, const std::size_t v)
  {
    return v == f[0] ? Edge{{ f[1], f[2] }} : v == f[1] ? Edge{{ f[0], f[2] }} : Edge{{ f[0], f[1] }};
  }

  // The position of a face in the list of all, or their number.
  std::size_t find(const Face& f) const
  {
    const std::size_t e = f[0] * n() + f[1];
    const auto begin = m_thirds.begin() + m_first[e], end = m_thirds.begin() + m_first[e + 1];
    const auto it = std::lower_bound(begin, end, f[2]);
    return it != end && *it == f[2] ? it - m_thirds.begin() : m_thirds.size();
  }

  template <typename CellRange>
  void collect_boundary(const CellRange& cells)
  {
    m_boundary.clear();
    internal::for_each_outer_facet(cells, [&](const Cell_handle c, const int i)
    {
      const Face f = positions(internal::facet_vertices(c, i));
      const Orientation o = m_predicates.orientation(m_vertices[f[0]], m_vertices[f[1]], m_vertices[f[2]],
                                                     c->vertex(i));
      CGAL_assertion(o != COPLANAR && find(f) != m_thirds.size());
      m_boundary.push_back(side(find(f), o));
    });
  }

  // The positive sides are even.
  static Side side(const std::size_t face, const Orientation o) { return 2 * face + (o == POSITIVE ? 0 : 1); }

  // --- tetrahedra ----------------------------------------------------------------------------------------------------

  bool collect_tetrahedra(const std::size_t max_number)
  {
    m_tetrahedra.clear();
    m_last_vertices.clear();
    for(std::size_t a = 0; a < n(); ++a)
      for(const std::size_t b : m_above[a])
      {
        const std::size_t e = a * n() + b;
        for(std::size_t i = m_first[e]; i < m_first[e + 1]; ++i)
          for(std::size_t j = i + 1; j < m_first[e + 1]; ++j)
            add_tetrahedron(a, b, i, j);
        if(m_tetrahedra.size() > max_number)
          return false;
      }
    return true;
  }

  // i and j are faces at the edge ab.
  void add_tetrahedron(const std::size_t a, const std::size_t b, const std::size_t i, const std::size_t j)
  {
    const std::size_t c = m_thirds[i], d = m_thirds[j], none = m_thirds.size();
    const std::size_t acd = find({{ a, c, d }});
    const std::size_t bcd = acd == none ? none : find({{ b, c, d }});
    if(bcd == none)
      return;
    const Orientation o = orientation({{ a, b, c }}, d);
    if(o == COPLANAR || contains_inner_vertex({{ a, b, c, d }}, o))
      return;
    m_tetrahedra.push_back({{ side(bcd, -o), side(acd, o), side(j, -o), side(i, o) }});
    m_last_vertices.push_back(d);
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
  std::vector<Bbox_3> m_boxes;                    // around these
  std::vector<std::size_t> m_inner_vertices;
  Obstacles m_obstacles;
  std::vector<Orientation> m_sides;               // of each vertex, its sides of the faces of the obstacles
  std::vector<std::vector<std::size_t> > m_above; // of each vertex, the other ends of its edges, if greater
  std::vector<std::size_t> m_first;               // of each pair of vertices, where its faces begin
  std::vector<std::size_t> m_thirds;              // of the faces at one edge after the other, their greatest vertices
  std::vector<Side> m_boundary;
  std::vector<Sides> m_tetrahedra;                // the side opposite to the greatest vertex is last
  std::vector<std::size_t> m_last_vertices;       // of the tetrahedra, their greatest vertices
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CANDIDATE_TETRAHEDRA_3_H
