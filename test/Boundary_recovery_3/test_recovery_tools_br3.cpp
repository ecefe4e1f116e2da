// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The small tools of the recovery, each on its own: the hash table of simplices, the snapshot of a mesh, its exterior,
// the search for points in the kernel of a polyhedron, and predicates for vertices with exact positions.

#undef NDEBUG

#include "brute_force_checker_br3.h"
#include "random_triangulations_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Exterior_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_snapshot_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Hash_index.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Vertex_handle                                   Vertex_handle;
typedef K::Point_3                                          Point_3;

// Against std::map, with simplices that come again, one by one and many at a time, and with reserve() in between.
template <std::size_t N>
void test_simplex_index(const unsigned seed, const int number_of_vertices)
{
  typedef internal::Simplex_index_3<const Point_3*, N> Index;
  typedef std::array<const Point_3*, N> Simplex;
  std::vector<Point_3> vertices(static_cast<std::size_t>(number_of_vertices)); // any addresses will do
  std::mt19937 rng(seed);
  Index index;
  std::map<Simplex, std::size_t> expected; // by sorted simplices
  std::vector<Simplex> queries, inserted_simplices;
  const auto sorted = [](Simplex s)
  {
    std::sort(s.begin(), s.end(), std::less<const Point_3*>());
    return s;
  };
  const auto expected_number = [&](const Simplex& s)
  {
    const auto it = expected.find(sorted(s));
    return it == expected.end() ? Index::none : it->second;
  };
  const auto check_many = [&]
  {
    std::vector<std::size_t> numbers(1);
    index.look_up(queries, numbers);
    assert(numbers.size() == queries.size());
    for(std::size_t k = 0; k < queries.size(); ++k)
      assert(numbers[k] == expected_number(queries[k]));
  };
  for(int i = 0; i < 4000; ++i)
  {
    Simplex s;
    for(const Point_3*& p : s)
      p = &vertices[static_cast<std::size_t>(br3_test::random_int(rng, number_of_vertices))];
    queries.push_back(s);
    assert(index[s] == expected_number(s));
    if(br3_test::random_int(rng, 3) == 0)
    {
      const bool is_new = expected_number(s) == Index::none;
      const auto inserted = index.insert(s);
      assert(inserted.second == is_new);
      assert(inserted.first == expected.emplace(sorted(s), expected.size()).first->second);
      if(is_new)
        inserted_simplices.push_back(s);
    }
    if(br3_test::random_int(rng, 500) == 0)
    {
      index.reserve(static_cast<std::size_t>(br3_test::random_int(rng, 3000)));
      check_many();
    }
    assert(index.size() == expected.size());
  }
  check_many();
  assert(index.keys() == inserted_simplices);

  index.clear();
  assert(index.size() == 0 && index[queries.back()] == index.none);
  for(const bool is_new : { true, false })
    assert(index.insert(queries.back()) == std::make_pair(std::size_t(0), is_new));
}

// All pairs of simplices with N vertices, which may be the same ones.
template <std::size_t N>
void test_permutations()
{
  std::vector<std::array<std::size_t, N> > simplices(1);
  for(std::size_t i = 0; i < N; ++i)
  {
    std::vector<std::array<std::size_t, N> > longer;
    for(auto s : simplices)
      for(s[i] = 0; s[i] < N; ++s[i])
        longer.push_back(s);
    simplices = longer;
  }
  for(const auto& s : simplices)
    for(const auto& t : simplices)
      assert(internal::is_permutation(s, t) == std::is_permutation(s.begin(), s.end(), t.begin()));
}

// Numbers whose hash values collide: in all bits, in those that decide on the slot, or in those that are in it.
void test_colliding_hash_values()
{
  const std::array<std::uint64_t (*)(std::uint64_t), 3> hashes = {{
    [](std::uint64_t) { return std::uint64_t(7); },
    [](const std::uint64_t i) { return i << 32; },
    [](const std::uint64_t i) { return i; }
  }};
  for(const auto hash : hashes)
  {
    internal::Hash_index<std::uint64_t, std::uint64_t (*)(std::uint64_t), std::equal_to<std::uint64_t> > index(hash);
    index.reserve(0);
    assert(index[0] == index.none);
    for(const std::uint64_t i : { 5, 3, 5, 0, 3, 200, 0 })
      index.insert(i);
    assert((index.keys() == std::vector<std::uint64_t>{ 5, 3, 0, 200 }));
    for(std::uint64_t i = 0; i < 300; ++i)
      index.insert(i);
    assert(index.size() == 300 && index[0] == 2 && index[4] == 6 && index[299] == 299 && index[300] == index.none);
  }
}

// So many that the search looks at the link of this vertex.
void insert_many_at_one_vertex(internal::Constraints_3<Tr>& constraints, const std::vector<Vertex_handle>& vertices)
{
  for(std::size_t i = 2; i < vertices.size(); ++i)
  {
    constraints.insert(vertices[0], vertices[i]);
    constraints.insert(vertices[i - 1], vertices[0], vertices[i]);
  }
}

// Facets that are in the mesh, in any order of their vertices, and edges and facets by chance.
internal::Constraints_3<Tr> random_constraints(const Tr& tr, const std::size_t vertices_per_lost_one, std::mt19937& rng)
{
  std::vector<Vertex_handle> vertices;
  for(const Vertex_handle v : tr.finite_vertex_handles())
    vertices.push_back(v);
  const auto random_vertex = [&]
  {
    return vertices[static_cast<std::size_t>(br3_test::random_int(rng, static_cast<int>(vertices.size())))];
  };
  internal::Constraints_3<Tr> constraints;
  for(const auto& f : tr.finite_facets())
    if(br3_test::random_int(rng, 4) == 0)
    {
      const int first = br3_test::random_int(rng, 3), step = 1 + br3_test::random_int(rng, 2);
      const auto v = internal::facet_vertices(f.first, f.second);
      constraints.insert(v[first], v[(first + step) % 3], v[(first + 2 * step) % 3]);
    }
  for(std::size_t i = 0; i < vertices.size(); i += vertices_per_lost_one)
  {
    const Vertex_handle u = random_vertex(), v = random_vertex(), w = random_vertex();
    if(u == v || v == w || w == u)
      continue;
    constraints.insert(u, v);
    if(i % 3 == 0)
      constraints.insert(u, v, w);
  }
  if(vertices_per_lost_one == 1)
    insert_many_at_one_vertex(constraints, vertices);
  return constraints;
}

// Against the triangulation's own answers: all constraints, and some of them.
void check_constraint_search(const Tr& tr, const internal::Constraints_3<Tr>& constraints,
                             internal::Constraint_search_3<Tr>& search, std::mt19937& rng)
{
  internal::Lost_constraints expected, some, expected_of_some;
  typedef std::vector<std::size_t> internal::Lost_constraints::* Kind;
  const auto expect = [&](const Kind kind, const auto& simplices, const auto& is_in_mesh)
  {
    for(std::size_t s = 0; s < simplices.size(); ++s)
    {
      const bool is_lost = ! is_in_mesh(simplices[s]), is_chosen = br3_test::random_int(rng, 2) == 0;
      if(is_lost)
        (expected.*kind).push_back(s);
      if(is_chosen)
        (some.*kind).push_back(s);
      if(is_lost && is_chosen)
        (expected_of_some.*kind).push_back(s);
    }
  };
  Tr::Cell_handle c;
  int i, j, k;
  expect(&internal::Lost_constraints::edges, constraints.edges(),
         [&](const auto& e) { return tr.is_edge(e[0], e[1], c, i, j); });
  expect(&internal::Lost_constraints::facets, constraints.facets(),
         [&](const auto& f) { return tr.is_facet(f[0], f[1], f[2], c, i, j, k); });
  for(int repetition = 0; repetition < 2; ++repetition)
  {
    const internal::Lost_constraints lost = search(), lost_of_some = search(some), lost_of_none = search({});
    assert(lost.edges == expected.edges && lost.facets == expected.facets);
    assert(lost_of_some.edges == expected_of_some.edges && lost_of_some.facets == expected_of_some.facets);
    assert(lost_of_none.edges.empty() && lost_of_none.facets.empty());
  }
}

// Flips edges and facets by chance.
void flip_some(Tr& tr, const int number_of_attempts, std::mt19937& rng)
{
  for(int k = 0; k < number_of_attempts; ++k)
  {
    auto c = tr.finite_cells_begin();
    std::advance(c, br3_test::random_int(rng, static_cast<int>(tr.number_of_finite_cells())));
    const int i = br3_test::random_int(rng, 4), j = (i + 1 + br3_test::random_int(rng, 3)) % 4;
    if(! tr.flip(c, i, j))
      tr.flip(c, i);
  }
}

// Facets stay, go, come and come back, few at a time or many, and constraints are added.
void test_constraint_search(const br3_test::Lattice_points& points, const std::size_t vertices_per_lost_one,
                            std::mt19937& rng)
{
  Tr tr;
  for(const auto& p : points)
    tr.insert(Point_3(p.x, p.y, p.z));
  if(tr.dimension() < 3)
    return;
  internal::Constraints_3<Tr> constraints = random_constraints(tr, vertices_per_lost_one, rng);
  internal::Constraint_search_3<Tr> search(tr, constraints);
  for(const int number_of_flips : { 0, 1, 3, 3, 300, 1, 0 })
  {
    flip_some(tr, number_of_flips, rng);
    check_constraint_search(tr, constraints, search, rng);
    const auto v = internal::facet_vertices(tr.all_cells_begin(), br3_test::random_int(rng, 4));
    if(! tr.is_infinite(v[0]) && ! tr.is_infinite(v[1]) && ! tr.is_infinite(v[2]))
      constraints.insert(v[0], v[1], v[2]);
  }
}

// The vertices of all the cells in their order, and the coordinates, by the addresses of the vertices.
struct Mesh_portrait
{
  explicit Mesh_portrait(const Tr& tr)
  {
    for(const auto c : tr.all_cell_handles())
      cells.insert({{ &*c->vertex(0), &*c->vertex(1), &*c->vertex(2), &*c->vertex(3) }});
    for(const Vertex_handle v : tr.finite_vertex_handles())
      points[&*v] = {{ v->point().x(), v->point().y(), v->point().z() }};
  }

  bool operator==(const Mesh_portrait& other) const { return cells == other.cells && points == other.points; }

  std::multiset<std::array<const void*, 4> > cells;
  std::map<const void*, br3_test::Coordinates> points;
};

struct Counting_visitor
  : public CGAL::Default_boundary_recovery_visitor_3
{
  template <typename CellRange>
  void before_cells_removal(const CellRange& cells) { removed += cells.size(); }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { created += cells.size(); }

  std::size_t removed = 0, created = 0;
};

void test_snapshot(const br3_test::Lattice_points& points, const int number_of_new_points, std::mt19937& rng)
{
  Tr tr;
  for(const auto& p : points)
    tr.insert(Point_3(static_cast<double>(p.x) / 3, static_cast<double>(p.y) / 3, static_cast<double>(p.z) / 3));
  assert(tr.dimension() == 3);
  const std::size_t number_of_cells = tr.number_of_cells(), number_of_vertices = tr.number_of_vertices();
  const Mesh_portrait before(tr);
  const internal::Mesh_snapshot_3<Tr> snapshot(tr);

  std::size_t number_of_inserted_points = 0;
  for(int i = 0; i < number_of_new_points; ++i)
  {
    const double x = br3_test::random_int(rng, 100), y = br3_test::random_int(rng, 100);
    const std::size_t n = tr.number_of_vertices();
    tr.insert(Point_3(x / 20 - 1, y / 20 - 1, (x + y) / 30 - 1));
    number_of_inserted_points += tr.number_of_vertices() - n;
  }
  int number_of_flips = 0;
  for(int k = 0; k < 50; ++k)
  {
    std::vector<Tr::Facet> facets(tr.finite_facets_begin(), tr.finite_facets_end());
    const Tr::Facet f = facets[static_cast<std::size_t>(br3_test::random_int(rng, static_cast<int>(facets.size())))];
    number_of_flips += tr.flip(f.first, f.second);
  }
  assert((number_of_flips > 0 || number_of_inserted_points > 0) && ! (before == Mesh_portrait(tr)));
  const std::vector<Vertex_handle> new_vertices = snapshot.new_vertices(tr);
  assert(new_vertices.size() == number_of_inserted_points);

  Counting_visitor visitor;
  const std::size_t number_of_changed_cells = tr.number_of_cells();
  snapshot.restore(tr, new_vertices, visitor);
  assert(visitor.removed == number_of_changed_cells && visitor.created == number_of_cells);
  assert(tr.number_of_cells() == number_of_cells && tr.number_of_vertices() == number_of_vertices);
  assert(before == Mesh_portrait(tr));
  assert(tr.is_valid()); // with the neighbors of the cells, and Delaunay again
}

void test_snapshots()
{
  std::mt19937 rng(7);
  for(int i = 0; i < 8; ++i)
  {
    test_snapshot(br3_test::random_points(20, 12, rng), i % 3 == 0 ? 0 : 10, rng);
    test_snapshot(br3_test::grid_points(3, 3, 3, 90, rng), 10, rng);
  }
}

// A polyhedron, given by triangles that are counterclockwise from outside, and a vertex for the point in its kernel.
class Polyhedron
{
public:
  typedef internal::Move_into_kernel_3<Tr> Move_into_kernel;

  Polyhedron(const std::vector<br3_test::Coordinates>& points, const std::vector<br3_test::Simplex>& triangles)
    : m_predicates(m_tr, &m_positions), m_move_into_kernel(m_predicates, m_positions), m_v(m_tr.tds().create_vertex())
  {
    for(const auto& p : points)
    {
      vertices.push_back(m_tr.tds().create_vertex());
      vertices.back()->set_point(Point_3(p[0], p[1], p[2]));
    }
    m_v->set_point(vertices[0]->point());
    for(const auto& t : triangles)
      m_faces.push_back({{ vertices[t[0]], vertices[t[2]], vertices[t[1]] }});
  }

  // What the tool says about the deepest point, judged by rational numbers.
  bool has_deepest_point()
  {
    const bool result = m_move_into_kernel(m_v, m_faces);
    assert(result == is_in_kernel() || ! result);
    assert(m_positions.empty());
    return result;
  }

  // The same from a vertex of the polyhedron on, in one direction.
  bool has_point_on_ray(const std::size_t origin, const Move_into_kernel::Exact_vector& direction)
  {
    m_positions.erase(m_v);
    const bool result = m_move_into_kernel(m_v, m_faces, vertices[origin], { direction });
    assert(result == is_in_kernel());
    return result;
  }

  bool has_exact_position() const { return m_positions.contains(m_v); }
  Point_3 point() const { return m_v->point(); }

  std::vector<Vertex_handle> vertices;

private:
  bool is_in_kernel() const
  {
    const br3_test::Rational_point x = br3_test::to_rational(m_positions(m_v));
    return std::all_of(m_faces.begin(), m_faces.end(), [&](const Move_into_kernel::Vertex_triple& f)
    {
      return br3_test::volume(br3_test::to_rational(f[0]->point()), br3_test::to_rational(f[1]->point()),
                              br3_test::to_rational(f[2]->point()), x) > 0;
    });
  }

  Tr m_tr;
  internal::Exact_positions_3<Tr> m_positions;
  const internal::Vertex_predicates_3<Tr> m_predicates;
  Move_into_kernel m_move_into_kernel;
  const Vertex_handle m_v;
  std::vector<Move_into_kernel::Vertex_triple> m_faces;
};

std::vector<br3_test::Coordinates> scaled(std::vector<br3_test::Coordinates> points, const int exponent)
{
  for(auto& p : points)
    for(double& x : p)
      x = std::ldexp(x, exponent);
  return points;
}

const std::vector<br3_test::Simplex> tetrahedron = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };

// The center and the radius of the ball in a corner of a cube, at all the scales.
void test_deepest_point()
{
  for(const int exponent : { 0, 1, 5, -5, 300, -300, 1000, -1000, 1023 }) // there, twice the size overflows
  {
    Polyhedron p(scaled({ {{ 0, 0, 0 }}, {{ 1, 0, 0 }}, {{ 0, 1, 0 }}, {{ 0, 0, 1 }} }, exponent), tetrahedron);
    assert(p.has_deepest_point());
    const double radius = std::ldexp(1 / (3 + std::sqrt(3.)), exponent);
    for(int i = 0; i < 3; ++i)
      assert(std::abs(p.point()[i] / radius - 1) < 1e-9);
  }
}

// The polyhedron of Schoenhardt is seen from its center, the notched box from nowhere.
void test_empty_kernel()
{
  const br3_test::Plc schoenhardt = br3_test::twisted_prism(3, .3, 1000, 1000);
  Polyhedron with_kernel(schoenhardt.points, schoenhardt.triangles);
  assert(with_kernel.has_deepest_point());
  const br3_test::Plc box = br3_test::Notched_box(2, 1).plc();
  Polyhedron without_kernel(box.points, box.triangles);
  assert(! without_kernel.has_deepest_point());
  for(const double z : { 1., .5, -1. })
    assert(! without_kernel.has_point_on_ray(0, Polyhedron::Move_into_kernel::Exact_vector(1, .1, z)));
}

void test_ray()
{
  typedef Polyhedron::Move_into_kernel::Exact_vector Vector;
  for(const int exponent : { 0, 300, -300 })
  {
    const std::vector<br3_test::Coordinates> points = { {{ 0, 0, 0 }}, {{ 1, 0, 0 }}, {{ 0, 1, 0 }}, {{ 0, 0, 1 }} };
    Polyhedron p(scaled(points, exponent), tetrahedron);
    assert(p.has_point_on_ray(0, Vector(1, 2, 3)) && ! p.has_exact_position());
    assert(p.point().y() == 2 * p.point().x()); // on the ray, for these numbers are few digits long
    assert(p.has_point_on_ray(0, Vector(-1, 0, 0)) && ! p.has_exact_position()); // not on the ray, but inside
  }
  // Between two neighboring numbers there is none: the exact position on the ray remains.
  const double next = std::nextafter(1., 2.);
  Polyhedron flat({ {{ 0, 0, 1 }}, {{ 1, 0, 1 }}, {{ 0, 1, 1 }}, {{ .25, .25, next }} }, tetrahedron);
  assert(! flat.has_deepest_point());
  assert(flat.has_point_on_ray(0, Vector(1, 1, std::ldexp(1., -52))) && flat.has_exact_position());
  assert(! flat.has_point_on_ray(0, Vector(-1, -1, 0)) && ! flat.has_exact_position());
}

// Vertices, some of them with exact positions, and the predicates for them against the kernel with exact constructions.
class Mixed_vertices
{
public:
  typedef internal::Exact_positions_3<Tr>                     Positions;
  typedef Positions::Exact_kernel                             EK;

  Mixed_vertices() : m_predicates(m_tr, &m_positions)
  {
    for(Vertex_handle& v : m_vertices)
      v = m_tr.tds().create_vertex();
  }

  void set(const int i, const EK::Point_3& p)
  {
    m_positions.set(m_vertices[static_cast<std::size_t>(i)], p);
    m_points[static_cast<std::size_t>(i)] = p;
  }

  void set(const int i, const Point_3& p)
  {
    m_positions.erase(m_vertices[static_cast<std::size_t>(i)]);
    m_vertices[static_cast<std::size_t>(i)]->set_point(p);
    m_points[static_cast<std::size_t>(i)] = EK::Point_3(p.x(), p.y(), p.z());
  }

  // Checks all the orders of the four vertices, and returns the orientation in the given one.
  CGAL::Orientation check() const
  {
    std::array<std::size_t, 4> i = {{ 0, 1, 2, 3 }};
    const CGAL::Orientation expected = CGAL::orientation(m_points[0], m_points[1], m_points[2], m_points[3]);
    do
    {
      const Vertex_handle p = m_vertices[i[0]], q = m_vertices[i[1]], r = m_vertices[i[2]], s = m_vertices[i[3]];
      const EK::Point_3 &ep = m_points[i[0]], &eq = m_points[i[1]], &er = m_points[i[2]], &es = m_points[i[3]];
      const CGAL::Orientation o = CGAL::orientation(ep, eq, er, es);
      assert(m_predicates.orientation(p, q, r, s) == o);
      // Also if there is no exact position, and where filters suffice.
      assert(Positions::Homogeneous_point::orientation(homogeneous(p), homogeneous(q), homogeneous(r), homogeneous(s))
             == o);
      const bool collinear = CGAL::collinear(ep, eq, er);
      assert(m_predicates.are_collinear(p, q, r) == collinear);
      if(o == CGAL::COPLANAR)
        assert(m_predicates.side_of_line(p, q, r, s)
               == (collinear ? CGAL::COLLINEAR : CGAL::coplanar_orientation(ep, eq, er, es)));
    }
    while(std::next_permutation(i.begin(), i.end()));
    return expected;
  }

private:
  Positions::Homogeneous_point homogeneous(const Vertex_handle v) const
  {
    return Positions::homogeneous(v, m_positions.find(v));
  }

  Tr m_tr;
  Positions m_positions;
  const internal::Vertex_predicates_3<Tr> m_predicates;
  std::array<Vertex_handle, 4> m_vertices;
  std::array<EK::Point_3, 4> m_points;
};

// In the unit 2^exponent; `range` below 2^10 makes coincidences likely.
Point_3 random_point(std::mt19937& rng, const int range, const int exponent)
{
  std::array<double, 3> c;
  for(double& x : c)
    x = std::ldexp(static_cast<double>(br3_test::random_int(rng, 2 * range) - range), exponent);
  return Point_3(c[0], c[1], c[2]);
}

// Exact positions on segments, on planes, and a little off them.
void test_predicates_of_exact_positions(const unsigned seed, const int range, const int exponent)
{
  typedef Mixed_vertices::EK EK;
  std::mt19937 rng(seed);
  Mixed_vertices vertices;
  std::map<CGAL::Orientation, int> found;
  for(int k = 0; k < 200; ++k)
  {
    std::array<EK::Point_3, 4> p;
    for(int i = 0; i < 4; ++i)
    {
      const Point_3 q = random_point(rng, range, exponent);
      p[static_cast<std::size_t>(i)] = EK::Point_3(q.x(), q.y(), q.z());
      vertices.set(i, q);
    }
    const int first = br3_test::random_int(rng, 5); // those from here on get exact positions; 4: none
    for(int i = first; i < 4; ++i)
    {
      const std::size_t a = static_cast<std::size_t>(i), b = static_cast<std::size_t>((i + 1) % 4);
      const std::size_t c = static_cast<std::size_t>((i + 2) % 4);
      const EK::FT s = EK::FT(br3_test::random_int(rng, 20) - 5) / EK::FT(7);
      const EK::FT t = EK::FT(br3_test::random_int(rng, 4)) / EK::FT(3);
      p[a] = p[b] + s * (p[c] - p[b]) + t * (p[(a + 3) % 4] - p[b]);
      if(br3_test::random_int(rng, 3) == 0)
        p[a] = p[a] + (p[c] - p[b]) / EK::FT(std::ldexp(1., 200)) + EK::Vector_3(0, 0, std::ldexp(1., exponent - 70));
      vertices.set(i, p[a]);
    }
    ++found[vertices.check()];
  }
  assert(found.size() == 3);
}

// Of denominators: powers of two within and beyond the range of floating point numbers, others, and products of both.
Mixed_vertices::EK::FT random_divisor(std::mt19937& rng)
{
  typedef Mixed_vertices::EK::FT FT;
  const FT large(std::ldexp(1., 600));
  const std::array<FT, 6> divisors = {{ FT(1), FT(3), large, FT(7 * large), FT(large * large), FT(6 * large * large) }};
  return divisors[static_cast<std::size_t>(br3_test::random_int(rng, 6))];
}

// Points of all scales, in one tetrahedron: subnormal, ordinary and huge numbers.
void test_mixed_scales(const unsigned seed)
{
  typedef Mixed_vertices::EK EK;
#ifdef CGAL_USE_GMP
  const std::array<int, 7> exponents = {{ -1074, -1030, -300, 0, 20, 300, 980 }};
#else // the conversion of numbers that small is beyond the kernel with exact constructions, the reference
  const std::array<int, 7> exponents = {{ -900, -600, -300, 0, 20, 300, 980 }};
#endif
  std::mt19937 rng(seed);
  Mixed_vertices vertices;
  std::map<CGAL::Orientation, int> found;
  for(int k = 0; k < 400; ++k)
  {
    for(int i = 0; i < 4; ++i)
    {
      const int e = exponents[static_cast<std::size_t>(br3_test::random_int(rng, 7))];
      const Point_3 p = random_point(rng, 3, e);
      if(br3_test::random_int(rng, 2) == 0)
        vertices.set(i, p);
      else
        vertices.set(i, EK::Point_3(p.x(), EK::FT(p.y()) / random_divisor(rng), p.z()));
    }
    ++found[vertices.check()];
  }
  assert(found.size() == 3);
}

// The points of a ray in homogeneous coordinates and as they are defined, seen from planes through them and others.
void test_points_on_rays(const unsigned seed)
{
  typedef Mixed_vertices::Positions Positions;
  typedef Mixed_vertices::EK EK;
  std::mt19937 rng(seed);
  const auto random_exact_point = [&]
  {
    const Point_3 p = random_point(rng, 3, 0);
    return EK::Point_3(p.x() / random_divisor(rng), p.y(), p.z() / random_divisor(rng));
  };
  std::map<CGAL::Orientation, int> found;
  for(int k = 0; k < 300; ++k)
  {
    const EK::Point_3 p = random_exact_point(), a = random_exact_point(), b = random_exact_point();
    const EK::Vector_3 d = random_exact_point() - CGAL::ORIGIN;
    const double s = std::ldexp(1., - br3_test::random_int(rng, 1000));
    const EK::Point_3 x = p + EK::FT(s) * d;
    const EK::Point_3 c = br3_test::random_int(rng, 2) == 0 ? random_exact_point() : a + EK::FT(2) * (x - b);
    const CGAL::Orientation o = CGAL::orientation(a, b, c, x);
    const Positions::Homogeneous_point on_ray = Positions::Homogeneous_point::on_ray(
      Positions::to_homogeneous(p), Positions::to_homogeneous(CGAL::ORIGIN + d), s);
    assert(Positions::Homogeneous_point::orientation(Positions::to_homogeneous(a), Positions::to_homogeneous(b),
                                                     Positions::to_homogeneous(c), on_ray) == o);
    ++found[o];
  }
  assert(found.size() == 3);
}

// The definition, by iteration until nothing changes.
std::set<Tr::Cell_handle> cells_reached_from_infinity(const Tr& tr, const internal::Constraints_3<Tr>& constraints)
{
  std::set<Tr::Cell_handle> result;
  for(const auto c : tr.all_cell_handles())
    if(tr.is_infinite(c))
      result.insert(c);
  for(std::size_t before = 0; before != result.size(); )
  {
    before = result.size();
    for(const auto& f : tr.finite_facets())
    {
      const auto v = internal::facet_vertices(f.first, f.second);
      if(! constraints.is_constrained(v[0], v[1], v[2])
         && (result.count(f.first) == 1 || result.count(f.first->neighbor(f.second)) == 1))
      {
        result.insert(f.first);
        result.insert(f.first->neighbor(f.second));
      }
    }
  }
  return result;
}

// Facets are constrained at random, `tenths` of them. Returns whether there is more than the exterior.
bool test_exterior(const unsigned seed, const int tenths)
{
  std::mt19937 rng(seed);
  Tr tr;
  for(const auto& p : br3_test::random_points(40, 7, rng))
    tr.insert(Point_3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)));
  assert(tr.dimension() == 3);
  internal::Constraints_3<Tr> constraints;
  for(const auto& f : tr.finite_facets())
    if(br3_test::random_int(rng, 10) < tenths)
    {
      const auto v = internal::facet_vertices(f.first, f.second);
      constraints.insert(v[0], v[1], v[2]);
    }
  const std::set<Tr::Cell_handle> expected = cells_reached_from_infinity(tr, constraints);
  const internal::Exterior_3<Tr> exterior(tr, constraints);
  for(const auto c : tr.all_cell_handles())
    assert(exterior.contains(c) == (expected.count(c) == 1));
  assert(exterior.is_everything() == (expected.size() == tr.tds().number_of_cells()));
  return ! exterior.is_everything();
}

void test_exteriors()
{
  int number_of_domains = 0;
  for(const unsigned seed : { 1u, 2u, 3u, 4u })
    for(const int tenths : { 0, 3, 6, 9, 10 })
    {
      const bool is_domain = test_exterior(seed, tenths);
      assert(tenths != 0 || ! is_domain);
      assert(tenths != 10 || is_domain);
      number_of_domains += is_domain;
    }
  assert(number_of_domains > 8);
}

int main()
{
  for(const unsigned seed : { 1u, 2u, 3u })
    for(const int n : { 5, 40, 1000 })
    {
      test_simplex_index<1>(seed, n);
      test_simplex_index<2>(seed, n);
      test_simplex_index<3>(seed, n);
    }
  test_permutations<1>();
  test_permutations<2>();
  test_permutations<3>();
  test_colliding_hash_values();
  for(const unsigned seed : { 1u, 2u, 3u, 4u, 5u, 6u })
  {
    std::mt19937 rng(seed);
    for(const std::size_t vertices_per_lost_one : { 1, 10, 1000 })
      test_constraint_search(br3_test::random_points(seed % 2 == 0 ? 300 : 20, seed % 3 == 0 ? 5 : 1000, rng),
                             vertices_per_lost_one, rng);
  }
  test_snapshots();
  test_exteriors();
  test_deepest_point();
  test_empty_kernel();
  test_ray();
  for(const unsigned seed : { 1u, 2u })
  {
    for(const int exponent : { 0, 300, -300, 900, -900 })
      for(const int range : { 3, 1000000 })
        test_predicates_of_exact_positions(seed, range, exponent);
    test_mixed_scales(seed);
    test_points_on_rays(seed);
  }
  std::cout << "done" << std::endl;
}
