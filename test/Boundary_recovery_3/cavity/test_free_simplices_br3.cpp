// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// What can be in a tetrahedralization of a polyhedron: its obstacles, and the edges and faces that these leave free,
// against definitions and the reference geometry.

#undef NDEBUG

#include "reference_geometry_br3.h"
#include "tetrahedralizations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/cavity/Free_simplices_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Polyhedron_obstacles_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

using br3_test::Lattice_point;
typedef BR::internal::Polyhedron_obstacles_3<Tr>   Obstacles;
typedef BR::internal::Free_edges_3<Tr>             Free_edges;
typedef BR::internal::Free_faces_3<Tr>             Free_faces;
typedef Obstacles::Edge                            Index_edge;
typedef Obstacles::Face                            Index_face;
typedef std::set<Vertex_handle>                    Vertex_set;
typedef std::vector<Vertex_handle>                 Vertices;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

template <typename Range>
auto set_of(const Range& range)
{
  return std::set<std::decay_t<decltype(*std::begin(range))> >(std::begin(range), std::end(range));
}

Lattice_point lattice_point(const Vertex_handle v)
{
  return { static_cast<std::int64_t>(v->point().x()), static_cast<std::int64_t>(v->point().y()),
           static_cast<std::int64_t>(v->point().z()) };
}

// One polyhedron, its obstacles, and what is free.
class Tester
{
public:
  Tester(const Tr& tr, const Cells& cells, const Edges& edges, const Facets& facets, const Vertex_handle superfluous)
    : m_predicates(tr), m_cells(cells), m_edges(edges), m_facets(facets), m_superfluous(superfluous),
      m_obstacles(m_predicates), m_free_edges(m_obstacles), m_free_faces(m_obstacles)
  {
    m_obstacles.assign(cells, edges, facets, superfluous);
    m_free_edges.collect(cells);
    m_free_faces.collect(m_free_edges.greater_ends());
    for(const Vertex_handle v : m_obstacles.vertices())
      m_points.push_back(lattice_point(v));
  }

  void operator()() const
  {
    check_vertices();
    check_obstacles();
    check_sides();
    for(std::size_t a = 0; a < n(); ++a)
      for(std::size_t b = 0; b < n(); ++b)
        check_edge(a, b);
    check_list_of_faces();
    for(std::size_t a = 0; a < n(); ++a)
      for(std::size_t b = a + 1; b < n(); ++b)
        for(std::size_t c = b + 1; c < n(); ++c)
          check_face({{ a, b, c }});
  }

private:
  std::size_t n() const { return m_obstacles.number_of_vertices(); }

  int side(const Index_face& f, const std::size_t v) const
  {
    return br3_test::sign(br3_test::volume(m_points[f[0]], m_points[f[1]], m_points[f[2]], m_points[v]));
  }

  bool do_cross(const Index_edge& e, const Index_edge& f) const
  {
    return br3_test::do_cross(m_points[e[0]], m_points[e[1]], m_points[f[0]], m_points[f[1]]);
  }

  bool does_pierce(const Index_edge& e, const Index_face& f) const
  {
    return br3_test::does_pierce(m_points[e[0]], m_points[e[1]], m_points[f[0]], m_points[f[1]], m_points[f[2]]);
  }

  static std::vector<Index_edge> edges_of(const Index_face& f)
  {
    return { {{ f[0], f[1] }}, {{ f[0], f[2] }}, {{ f[1], f[2] }} };
  }

  template <std::size_t N>
  std::array<std::size_t, N> indices(const std::array<Vertex_handle, N>& simplex) const
  {
    std::array<std::size_t, N> result;
    for(std::size_t k = 0; k < N; ++k)
      result[k] = m_obstacles.position(simplex[k]);
    std::sort(result.begin(), result.end());
    return result;
  }

  // --- obstacles ----------------------------------------------------------------------------------------------------

  void check_vertices() const
  {
    Vertex_set vertices;
    for(const Tetrahedron& t : tetrahedra_of(m_cells))
      vertices.insert(t.begin(), t.end());
    vertices.erase(m_superfluous);
    assert(set_of(m_obstacles.vertices()) == vertices && vertices.size() == n());
    for(std::size_t v = 0; v < n(); ++v)
      assert(m_obstacles.position(m_obstacles.vertex(v)) == v);
    assert(m_superfluous == Vertex_handle() || m_obstacles.position(m_superfluous) >= n());
  }

  void check_obstacles() const
  {
    // the faces of one cell only, each with the vertex of the cell that is opposite
    std::map<Index_face, std::size_t> outer;
    for(const Tetrahedron& t : tetrahedra_of(m_cells))
      for(std::size_t i = 0; i < 4; ++i)
      {
        const Index_face f = indices<3>({{ t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4] }});
        if(! outer.emplace(f, m_obstacles.position(t[i])).second)
          outer.erase(f);
      }
    std::set<Index_edge> outer_edges, edges_of_faces, edges;
    std::set<Index_face> faces;
    std::set<std::size_t> outer_vertices;
    for(const auto& f : outer)
    {
      faces.insert(f.first);
      outer_vertices.insert(f.first.begin(), f.first.end());
      for(const Index_edge& e : edges_of(f.first))
        outer_edges.insert(e);
    }
    for(const Facet& f : m_facets)
      faces.insert(indices(f));
    for(const Index_face& f : faces)
      for(const Index_edge& e : edges_of(f))
        edges_of_faces.insert(e);
    edges = edges_of_faces;
    for(const Edge& e : m_edges)
      edges.insert(indices(e));

    assert(m_obstacles.outer_faces().size() == outer.size());
    for(const auto& f : m_obstacles.outer_faces())
      if(outer.at(f.face) < n()) // else the opposite vertex is the superfluous one
        assert(f.inner_side == side(f.face, outer.at(f.face)));
    assert(m_obstacles.faces() == std::vector<Index_face>(faces.begin(), faces.end()));
    for(std::size_t a = 0; a < n(); ++a)
    {
      assert(m_obstacles.is_outer(a) == (outer_vertices.count(a) == 1));
      for(std::size_t b = a + 1; b < n(); ++b)
        assert(m_obstacles.has_edge({{ a, b }}) == (edges.count({{ a, b }}) == 1));
    }
    const auto without = [&](const std::set<Index_edge>& others)
    {
      std::vector<Index_edge> result;
      std::set_difference(edges.begin(), edges.end(), others.begin(), others.end(), std::back_inserter(result));
      return result;
    };
    assert(m_obstacles.inner_edges() == without(outer_edges));
    assert(m_obstacles.single_edges() == without(edges_of_faces));
    number_of["obstacle inside"] += ! m_obstacles.inner_edges().empty();
    number_of["edge that is in no face"] += ! m_obstacles.single_edges().empty();
  }

  void check_sides() const
  {
    const Obstacles::Sides& sides = m_obstacles.sides();
    for(std::size_t i = 0; i < m_obstacles.faces().size(); ++i)
    {
      const Index_face& f = m_obstacles.faces()[i];
      const auto outer = std::find_if(m_obstacles.outer_faces().begin(), m_obstacles.outer_faces().end(),
                                      [&](const Obstacles::Outer_face& o) { return o.face == f; });
      const bool is_outer = outer != m_obstacles.outer_faces().end();
      for(std::size_t v = 0; v < n(); ++v)
      {
        const int s = side(f, v);
        assert(sides.positive(v, i) == (s > 0) && sides.negative(v, i) == (s < 0) && sides.coplanar(v, i) == (s == 0));
        assert(sides.stars(v, i) == BR::internal::contains(f, v));
        assert(sides.inner(v, i) == (is_outer && s != 0 && s == outer->inner_side));
        assert(sides.outer(v, i) == (is_outer && s != 0 && s != outer->inner_side));
        assert(m_obstacles.orientation(f, v) == s);
        const std::size_t w = (v + i) % n();
        const BR::internal::Bits separating = m_obstacles.separating(v, w, i / 64);
        assert(BR::internal::has_bit(separating, static_cast<int>(i % 64)) == (s * side(f, w) < 0));
      }
      assert(side(f, m_obstacles.aside(i)) != 0);
      for(const std::size_t v : f)
        assert(CGAL::do_overlap(m_obstacles.box(i), m_obstacles.vertex(v)->point().bbox()));
    }
  }

  // --- what is free -------------------------------------------------------------------------------------------------

  bool is_free(const std::size_t a, const std::size_t b) const { return m_free_edges.greater_ends()(a, b); }

  void check_edge(const std::size_t a, const std::size_t b) const
  {
    if(a >= b || m_obstacles.has_edge({{ a, b }}))
    {
      assert(is_free(a, b) == (a < b));
      return;
    }
    if(is_crossed({{ a, b }}))
    {
      assert(! is_free(a, b));
      ++number_of["edge that is crossed"];
    }
    else if(! passes_through_vertex({{ a, b }})) // such an edge is in no tetrahedralization anyway
    {
      assert(is_free(a, b) == is_inside({{ a, b }}));
      ++number_of[is_free(a, b) ? "free edge" : "edge outside"];
    }
  }

  // In a point inside both.
  bool is_crossed(const Index_edge& e) const
  {
    const auto crosses = [&](const Index_edge& f) { return do_cross(e, f); };
    return std::any_of(m_obstacles.faces().begin(), m_obstacles.faces().end(), [&](const Index_face& f)
           {
             const std::vector<Index_edge> edges = edges_of(f);
             return does_pierce(e, f) || std::any_of(edges.begin(), edges.end(), crosses);
           })
        || std::any_of(m_obstacles.single_edges().begin(), m_obstacles.single_edges().end(), crosses);
  }

  bool passes_through_vertex(const Index_edge& e) const
  {
    return std::any_of(m_points.begin(), m_points.end(), [&](const Lattice_point& p)
    {
      return br3_test::is_in_open_segment(m_points[e[0]], m_points[e[1]], p);
    });
  }

  // Whether the midpoint is in one of the closed cells; all in units of a half.
  bool is_inside(const Index_edge& e) const
  {
    const Lattice_point p = m_points[e[0]], q = m_points[e[1]], middle = { p.x + q.x, p.y + q.y, p.z + q.z };
    return std::any_of(m_cells.begin(), m_cells.end(), [&](const Cell_handle c)
    {
      for(int i = 0; i < 4; ++i)
      {
        std::array<Lattice_point, 4> t;
        for(int k = 0; k < 4; ++k)
        {
          const Lattice_point v = lattice_point(c->vertex(k));
          t[static_cast<std::size_t>(k)] = k == i ? middle : Lattice_point{ 2 * v.x, 2 * v.y, 2 * v.z };
        }
        if(br3_test::volume(t[0], t[1], t[2], t[3]) < 0)
          return false;
      }
      return true;
    });
  }

  // They are in order, and found in all ways.
  void check_list_of_faces() const
  {
    for(std::size_t i = 0; i < m_free_faces.size(); ++i)
    {
      const Index_face f = m_free_faces[i];
      assert(f[0] < f[1] && f[1] < f[2] && (i == 0 || m_free_faces[i - 1] < f));
      assert(m_free_faces.find(f) == i && m_free_faces.third(i) == f[2]);
      assert(m_free_faces.begin_at(f[0], f[1]) <= i && i < m_free_faces.end_at(f[0], f[1]));
      std::vector<std::size_t> found, expected;
      m_free_faces.for_each_common_third(f[0], f[1], f[2], [&](const std::size_t d) { found.push_back(d); });
      for(std::size_t d = f[2] + 1; d < n(); ++d)
        if(is_in_list({{ f[0], f[1], d }}) && is_in_list({{ f[0], f[2], d }}) && is_in_list({{ f[1], f[2], d }}))
          expected.push_back(d);
      assert(found == expected);
    }
  }

  bool is_in_list(const Index_face& f) const { return m_free_faces.find(f) < m_free_faces.size(); }

  // What does not start at a vertex of the face, nor is inside the polyhedron, may be overlooked.
  void check_face(const Index_face& f) const
  {
    const bool are_edges_free = is_free(f[0], f[1]) && is_free(f[0], f[2]) && is_free(f[1], f[2]);
    bool is_pierced = std::any_of(m_obstacles.inner_edges().begin(), m_obstacles.inner_edges().end(),
                                  [&](const Index_edge& e) { return does_pierce(e, f); });
    for(const Index_face& g : m_obstacles.faces())
      for(std::size_t k = 0; k < 3; ++k)
        is_pierced = is_pierced
                  || (BR::internal::contains(f, g[k]) && does_pierce({{ g[(k + 1) % 3], g[(k + 2) % 3] }}, f));
    assert(is_in_list(f) == (are_edges_free && ! is_pierced));
    if(are_edges_free)
      ++number_of[is_pierced ? "face that is pierced" : "free face"];
  }

  const Predicates m_predicates;
  const Cells m_cells;
  const Edges m_edges;
  const Facets m_facets;
  const Vertex_handle m_superfluous;
  Obstacles m_obstacles;
  Free_edges m_free_edges;
  Free_faces m_free_faces;
  std::vector<Lattice_point> m_points;
};

// All coordinates are integers below `range`.
void test_cavities(const unsigned seed, const int range)
{
  std::mt19937 rng(seed);
  Tr tr;
  while(tr.number_of_vertices() < 50)
  {
    const int x = random_int(rng, range), y = random_int(rng, range), z = random_int(rng, range);
    tr.insert(Point(x, y, z));
  }
  for(int k = 0; k < 30; ++k)
  {
    const Cells cells = random_cavity(tr, rng, 4 + random_int(rng, 25));
    Edges edges;
    Facets facets;
    if(k % 2 == 1)
      require_what_is_there(cells, rng, edges, facets);
    if(k % 4 == 1)
      facets.clear();
    Tester(tr, cells, edges, facets, Vertex_handle())();
  }
  for(const Vertex_handle v : tr.finite_vertex_handles())
  {
    Cells star;
    if(! BR::internal::collect_star(tr, v, star))
      continue;
    Tester(tr, star, Edges(), Facets(), v)();
    ++number_of["star with a superfluous vertex"];
  }
}

int main()
{
  for(const int range : { 5, 1000 })
    for(const unsigned seed : { 31u, 32u })
      test_cavities(seed, range);
  for(const char* kind : { "obstacle inside", "edge that is in no face", "star with a superfluous vertex",
                           "edge that is crossed", "free edge", "edge outside", "face that is pierced", "free face" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 10);
  }
  std::cout << "done" << std::endl;
}
