// The walks along a segment and over a triangle, against tests of all edges and facets, and where they start; and the
// walk to a place.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "reference_geometry_br3.h"

#include <CGAL/Boundary_recovery_3/internal/geometry/Facet_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/walk_to.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;
using namespace br3_test;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

typedef std::vector<int> Simplex; // sorted indices

// Everything that a segment crosses in transversal, relative interior points, in its order.
struct Place
{
  Fraction t;
  Simplex simplex;
  friend bool operator<(const Place& x, const Place& y) { return x.t < y.t; }
};

template <typename Tr_>
class Tester
{
public:
  typedef Tr_ Tr;
  typedef typename Tr::Vertex_handle                  Vertex_handle;
  typedef typename Tr::Cell_handle                    Cell_handle;
  typedef BR::internal::Vertex_predicates_3<Tr>       Predicates;
  typedef BR::internal::Segment_walk_3<Tr>            Segment_walk;
  typedef BR::internal::Facet_walk_3<Tr>              Facet_walk;

  Tester(const Tr& tr, const Lattice_points& points)
    : m_tr(tr), m_points(points), m_vertices(finite_vertices(tr)), m_predicates(tr),
      m_segment_walk(tr, m_predicates), m_facet_walk(tr, m_predicates)
  {
    for(auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
    {
      const Simplex s = sorted({ e->first->vertex(e->second), e->first->vertex(e->third) });
      m_edges.insert(s);
      m_cells[s] = e->first;
    }
    for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    {
      Simplex s;
      for(int i = 1; i < 4; ++i)
        s.push_back(f->first->vertex((f->second + i) % 4)->info());
      std::sort(s.begin(), s.end());
      m_facets.insert(s);
      const bool is_on_hull = tr.is_infinite(f->first) || tr.is_infinite(f->first->neighbor(f->second));
      if(is_on_hull)
        for(int i = 0; i < 3; ++i)
          m_hull_vertices.insert(s[i]);
    }
  }

  // ---- segments ----

  void check_all_segments()
  {
    for(std::size_t u = 0; u < m_vertices.size(); ++u)
      for(std::size_t v = 0; v < m_vertices.size(); ++v)
        if(u != v)
          check_segment(static_cast<int>(u), static_cast<int>(v));
  }

  void check_random_segments(const int n, std::mt19937& rng)
  {
    const int m = static_cast<int>(m_vertices.size());
    for(int k = 0; k < n; ++k)
    {
      const int u = random_int(rng, m), v = random_int(rng, m);
      if(u != v)
        check_segment(u, v);
    }
  }

  // ---- triangles ----

  // Checks the triangles whose edges are in the mesh, about one of `stride` of those that are facets.
  void check_triangles(const int stride, std::mt19937& rng)
  {
    for(const Simplex& e : m_edges)
      for(int w = e[1] + 1; w < static_cast<int>(m_vertices.size()); ++w)
        if(m_edges.count({ e[0], w }) != 0 && m_edges.count({ e[1], w }) != 0
           && ! is_zero(cross(m_points[e[1]] - m_points[e[0]], m_points[w] - m_points[e[0]]))
           && (m_facets.count({ e[0], e[1], w }) == 0 || random_int(rng, stride) == 0))
        {
          // in all three rotations and both orientations
          check_triangle(e[0], e[1], w);
          check_triangle(e[1], w, e[0]);
          check_triangle(w, e[0], e[1]);
          check_triangle(e[1], e[0], w);
          check_triangle(w, e[1], e[0]);
          check_triangle(e[0], w, e[1]);
        }
  }

  // ---- wedges ----

  // For each vertex and some of the edges: the half-plane is inside one facet or cell around the edge.
  void check_wedges(std::mt19937& rng)
  {
    for(const auto& e : m_edges)
      if(random_int(rng, 4) == 0)
      {
        const Cell_handle c = m_cells[e];
        const BR::Shell_3<Tr> shell(m_tr, c, c->index(m_vertices[e[0]]), c->index(m_vertices[e[1]]));
        for(int v = 0; v < static_cast<int>(m_points.size()); ++v)
          if(! is_zero(cross(m_points[e[1]] - m_points[e[0]], m_points[v] - m_points[e[0]])))
            check_wedge(shell, v);
      }
  }

private:
  // For a cell, the half-plane is between those of its other vertices, less than half a turn apart.
  void check_wedge(const BR::Shell_3<Tr>& shell, const int v)
  {
    const Lattice_point &a = m_points[shell.a()->info()], &b = m_points[shell.b()->info()];
    const BR::internal::Shell_wedge found = BR::internal::find_wedge(shell, m_predicates, m_vertices[v]);
    if(shell.index(m_vertices[v]) != shell.none)
    {
      assert(found.index == shell.none);
      return;
    }
    int number_of_wedges = 0;
    for(int i = 0; i < shell.degree(); ++i)
    {
      if(i == shell.infinite_index())
        continue;
      const Lattice_point& p = m_points[shell.vertex(i)->info()];
      const Wide side = volume(a, b, p, m_points[v]);
      const bool is_in_facet = side == 0 && dot(cross(b - a, p - a), cross(b - a, m_points[v] - a)) > 0;
      const bool is_in_cell = side > 0 && shell.next(i) != shell.infinite_index()
                           && volume(a, b, m_points[shell.vertex(shell.next(i))->info()], m_points[v]) < 0;
      assert((is_in_facet || is_in_cell) == (found.index == i));
      assert(found.index != i || found.is_facet == is_in_facet);
      number_of_wedges += is_in_facet || is_in_cell;
    }
    assert(number_of_wedges == 1);
    ++number_of[found.is_facet ? "wedge is facet" : "wedge is cell"];
  }

  static Simplex sorted(const std::vector<Vertex_handle>& vertices)
  {
    Simplex s;
    for(const Vertex_handle v : vertices)
      s.push_back(v->info());
    std::sort(s.begin(), s.end());
    return s;
  }

  std::vector<Place> places_on_segment(const int u, const int v) const
  {
    const Lattice_points& p = m_points;
    std::vector<Place> places;
    Fraction t(0, 1);
    for(const Simplex& e : m_edges)
      if(find_crossing(p[u], p[v], p[e[0]], p[e[1]], t))
        places.push_back({ t, e });
    for(const Simplex& f : m_facets)
      if(find_crossing(p[u], p[v], p[f[0]], p[f[1]], p[f[2]], t))
        places.push_back({ t, f });
    for(int w = 0; w < static_cast<int>(p.size()); ++w)
      if(is_in_open_segment(p[u], p[v], p[w]))
        places.push_back({ Fraction(dot(p[v] - p[u], p[w] - p[u]), dot(p[v] - p[u], p[v] - p[u])), { w } });
    std::sort(places.begin(), places.end());
    for(std::size_t i = 1; i < places.size(); ++i)
      assert(places[i - 1].t < places[i].t);
    return places;
  }

  void check_segment(const int u, const int v)
  {
    const std::vector<Place> places = places_on_segment(u, v);
    const auto outcome = m_segment_walk(m_vertices[u], m_vertices[v]);
    const auto& crossings = m_segment_walk.crossings();
    const bool is_edge = m_edges.count(Simplex{ (std::min)(u, v), (std::max)(u, v) }) != 0;
    assert((outcome == Segment_walk::IS_EDGE) == is_edge);
    assert(! is_edge || (places.empty() && crossings.empty()));

    const auto in_the_way = std::find_if(places.begin(), places.end(),
                                         [](const Place& p) { return p.simplex.size() == 1; });
    assert((outcome == Segment_walk::BLOCKED) == (in_the_way != places.end()));
    if(outcome == Segment_walk::BLOCKED)
      assert(m_segment_walk.blocking_vertex() == m_vertices[in_the_way->simplex[0]]);
    else
      assert(m_segment_walk.blocking_vertex() == Vertex_handle());
    assert(static_cast<std::ptrdiff_t>(crossings.size()) == in_the_way - places.begin());
    for(std::size_t i = 0; i < crossings.size(); ++i)
      check_crossing(crossings[i], places[i].simplex);
    count_segment(u, v, places, outcome);
  }

  void check_crossing(const typename Segment_walk::Crossing& crossing, const Simplex& simplex) const
  {
    const int n = crossing.dimension + 1;
    assert(n == static_cast<int>(simplex.size()));
    std::vector<Vertex_handle> vertices(crossing.vertices.begin(), crossing.vertices.begin() + n);
    assert(sorted(vertices) == simplex);
    for(const Vertex_handle v : vertices)
      assert(crossing.cell->has_vertex(v));
    assert(m_tr.tds().is_cell(crossing.cell));
  }

  void count_segment(const int u, const int v, const std::vector<Place>& places,
                     const typename Segment_walk::Outcome outcome)
  {
    static const char* const names[3] = { "segment is edge", "segment crosses", "segment blocked" };
    const std::string name = names[outcome];
    ++number_of[name];
    if(outcome == Segment_walk::IS_EDGE)
      return;
    std::set<std::size_t> sizes;
    for(const Place& p : places)
      sizes.insert(p.simplex.size());
    if(places.size() > 1 && places.front().simplex.size() > 1 && sizes.count(1) != 0)
      ++number_of["segment blocked behind crossings"];
    if(sizes == std::set<std::size_t>{ 2 })
      ++number_of["segment crosses edges only"];
    if(sizes == std::set<std::size_t>{ 3 })
      ++number_of["segment crosses facets only"];
    if(sizes == std::set<std::size_t>{ 2, 3 })
      ++number_of["segment crosses edges and facets"];
    if(m_hull_vertices.count(u) != 0 && m_hull_vertices.count(v) != 0)
      ++number_of[name + " between hull vertices"];
    for(const Simplex& f : m_facets)
      if(std::find(f.begin(), f.end(), u) != f.end()
         && volume(m_points[f[0]], m_points[f[1]], m_points[f[2]], m_points[v]) == 0)
      {
        ++number_of[name + " in the plane of a facet at its start"];
        break;
      }
  }

  void check_triangle(const int u, const int v, const int w)
  {
    const Lattice_points& p = m_points;
    Simplex vertices_inside;
    std::set<Simplex> expected;
    for(int x = 0; x < static_cast<int>(p.size()); ++x)
      if(x != u && x != v && x != w)
      {
        assert(! is_in_triangle(p[u], p[v], p[w], p[x], true) || is_in_triangle(p[u], p[v], p[w], p[x], false));
        if(is_in_triangle(p[u], p[v], p[w], p[x], false))
          vertices_inside.push_back(x);
      }
    for(const Simplex& e : m_edges)
      if(does_pierce(p[e[0]], p[e[1]], p[u], p[v], p[w]))
        expected.insert(e);

    const Cell_handle c = m_cells[sorted({ m_vertices[u], m_vertices[v] })];
    const auto outcome = m_facet_walk(m_vertices[u], m_vertices[v], m_vertices[w], c);
    const bool is_facet = m_facets.count(sorted({ m_vertices[u], m_vertices[v], m_vertices[w] })) != 0;
    assert((outcome == Facet_walk::IS_FACET) == is_facet);
    assert((outcome == Facet_walk::BLOCKED) == ! vertices_inside.empty());
    std::set<Simplex> found;
    for(const auto& crossing : m_facet_walk.crossings())
    {
      const Simplex e = sorted({ crossing.vertices[0], crossing.vertices[1] });
      assert(found.insert(e).second && expected.count(e) == 1); // once, and rightly
      assert(m_tr.tds().is_cell(crossing.cell));
      assert(crossing.cell->has_vertex(crossing.vertices[0]) && crossing.cell->has_vertex(crossing.vertices[1]));
    }
    if(outcome == Facet_walk::BLOCKED)
    {
      const Vertex_handle b = m_facet_walk.blocking_vertex();
      assert(std::count(vertices_inside.begin(), vertices_inside.end(), b->info()) == 1);
    }
    else
      assert(found == expected && m_facet_walk.blocking_vertex() == Vertex_handle());
    count_triangle(outcome, expected.size(), found.size());
  }

  void count_triangle(const typename Facet_walk::Outcome outcome, const std::size_t n, const std::size_t found)
  {
    static const char* const names[3] = { "triangle is facet", "triangle crossed", "triangle blocked" };
    ++number_of[names[outcome]];
    if(outcome == Facet_walk::CROSSED)
      ++number_of[n == 1 ? "triangle crossed once" : n == 2 ? "triangle crossed twice" : "triangle crossed more often"];
    if(outcome == Facet_walk::BLOCKED && found > 0)
      ++number_of["triangle blocked behind crossings"];
  }

  const Tr& m_tr;
  const Lattice_points m_points;
  const std::vector<Vertex_handle> m_vertices;
  const Predicates m_predicates;
  Segment_walk m_segment_walk;
  Facet_walk m_facet_walk;
  std::set<Simplex> m_edges, m_facets;
  std::map<Simplex, Cell_handle> m_cells;
  std::set<int> m_hull_vertices;
};

// Tests the Delaunay triangulation of the points, divided by `divisor`, and again after random flips.
template <typename Kernel>
void test_points(const Lattice_points& points, const int divisor, std::mt19937& rng)
{
  typedef typename Triangulations<Kernel>::Triangulation Triangulation;
  typename Triangulations<Kernel>::Delaunay tr;
  insert_points(tr, points, divisor);
  if(tr.dimension() < 3)
    return;
  for(const int number_of_flips : { 0, 50, 200 })
  {
    number_of["flips"] += flip_at_random<Kernel>(tr, number_of_flips, rng);
    Tester<Triangulation> tester(tr, points);
    if(points.size() <= 20)
      tester.check_all_segments();
    else
      tester.check_random_segments(120, rng);
    tester.check_triangles(4, rng);
    tester.check_wedges(rng);
  }
}

// Points in three parallel planes, many of them in the middle one: vertices inside triangles.
Lattice_points plane_points(const int n, std::mt19937& rng)
{
  Lattice_points points;
  for(int i = 0; i < n; ++i)
  {
    const int x = random_int(rng, 9), y = random_int(rng, 9);
    points.push_back({ x, y, i % 4 == 0 ? 3 : i % 4 == 1 ? -3 : 0 });
  }
  return distinct(points);
}

// A vertex inside a triangle whose edges are in the mesh, behind a mesh edge that pierces the triangle: the walk from
// one of the sides meets the edge first.
template <typename Kernel>
void test_blocked_behind_crossings(const int divisor)
{
  // corners, vertex inside, and the ends of edges through the triangle near each side
  const Lattice_points points = { { -600, -400, 0 }, { 600, -400, 0 }, { 0, 800, 0 }, { 0, 0, 0 },
                                  { 0, -380, 10 }, { 0, -380, -10 }, { 280, 180, 10 }, { 280, 180, -10 },
                                  { -280, 180, 10 }, { -280, 180, -10 }, { 0, 0, 300 }, { 0, 0, -300 } };
  typename Triangulations<Kernel>::Delaunay tr;
  insert_points(tr, points, divisor);
  Tester<typename Triangulations<Kernel>::Triangulation> tester(tr, points);
  std::mt19937 rng(7);
  tester.check_all_segments();
  tester.check_triangles(1, rng);
}

template <typename Kernel>
void test_kernel(const int n, const int divisor, const unsigned seed)
{
  std::mt19937 rng(seed);
  test_blocked_behind_crossings<Kernel>(divisor);
  for(int k = 0; k < n; ++k)
  {
    test_points<Kernel>(random_points(40, 2000, rng), divisor, rng);
    test_points<Kernel>(random_points(20, 5, rng), divisor, rng);
    test_points<Kernel>(random_points(12, 3, rng), divisor, rng);
    test_points<Kernel>(grid_points(3, 3, 3, 100, rng), divisor, rng);
    test_points<Kernel>(grid_points(5, 4, 2, 80, rng), divisor, rng);
    test_points<Kernel>(plane_points(40, rng), divisor, rng);
    test_points<Kernel>(ring_points(10, true, true, rng), divisor, rng);
    test_points<Kernel>(ring_points(12, true, false, rng), divisor, rng);
  }
}

// No test may pass because nothing was tested.
void check_that_all_was_met()
{
  for(const auto& n : number_of)
    std::cout << n.second << "\t" << n.first << std::endl;
  for(const std::string what : { "flips",
                                 "segment is edge", "segment crosses", "segment blocked",
                                 "segment crosses between hull vertices", "segment blocked between hull vertices",
                                 "segment crosses in the plane of a facet at its start",
                                 "segment blocked in the plane of a facet at its start",
                                 "segment crosses edges only", "segment crosses facets only",
                                 "segment crosses edges and facets",
                                 "triangle is facet", "triangle crossed once", "triangle crossed twice",
                                 "triangle crossed more often", "triangle blocked",
                                 "wedge is facet", "wedge is cell" })
    assert(number_of[what] >= 100);
  assert(number_of["segment blocked behind crossings"] >= 20);
  assert(number_of["triangle blocked behind crossings"] >= 6);
}

// Cells are integers; the way is barred below 0, and too long from 5 steps on.
void test_walk_to_number()
{
  const auto walk = [](const int start, const int target)
  {
    const auto facet_towards = [&](const int c) { return c == target ? -1 : c < target ? 1 : 0; };
    const auto cell_behind = [](const int c, const int i) -> std::optional<int>
    {
      return c == 0 && i == 0 ? std::nullopt : std::optional<int>(i == 0 ? c - 1 : c + 1);
    };
    return BR::internal::walk_to(start, 5, facet_towards, cell_behind);
  };
  assert(walk(3, 3) == 3 && walk(3, 7) == 7 && walk(4, 0) == 0);
  assert(! walk(3, 8) && ! walk(2, -1));
}

int main()
{
  test_walk_to_number();
  test_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(6, 1, 3);
  test_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(2, 3, 4);
  check_that_all_was_met();
  return 0;
}
