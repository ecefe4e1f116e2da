// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Predicates for vertices with exact positions, against the kernel with exact constructions; tables of orientations,
// against integer arithmetic.

#undef NDEBUG

#include "random_triangulations_br3.h"
#include "reference_geometry_br3.h"

#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Orientation_table_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Vertex_handle                                   Vertex_handle;
typedef K::Point_3                                          Point_3;

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

// All faces and edges of some points, against what is asked for by its definition.
class Table_check
{
public:
  typedef internal::Orientation_table_3<Tr>   Table;
  typedef Table::Vertex_set                   Vertex_set;

  explicit Table_check(const br3_test::Lattice_points& points)
    : m_predicates(m_tr, nullptr), m_table(m_predicates), m_points(points)
  {
    for(const auto& p : points)
    {
      m_vertices.push_back(m_tr.tds().create_vertex());
      m_vertices.back()->set_point(to_point(p));
    }
  }

  // With some of the vertices at first, and again after two of them were exchanged.
  void operator()()
  {
    m_table.set_vertices(std::vector<Vertex_handle>(m_vertices.begin(), m_vertices.begin() + m_vertices.size() / 2));
    m_table.set_vertices(m_vertices);
    check();
    std::swap(m_vertices[1], m_vertices[3]);
    std::swap(m_points[1], m_points[3]);
    m_table.set_vertices(m_vertices);
    check();
    std::swap(m_points[2], m_points[4]); // the points only
    m_vertices[2]->set_point(to_point(m_points[2]));
    m_vertices[4]->set_point(to_point(m_points[4]));
    m_table.forget();
    m_table.set_vertices(m_vertices);
    check();
  }

  std::size_t number_of_crossings = 0;

private:
  static Point_3 to_point(const br3_test::Lattice_point& p)
  {
    return Point_3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
  }

  const br3_test::Lattice_point& point(const int i) const { return m_points[static_cast<std::size_t>(i)]; }

  // Six times the volume of a tetrahedron.
  br3_test::Wide volume(const int i, const int j, const int k, const int l) const
  {
    return br3_test::volume(point(i), point(j), point(k), point(l));
  }

  // The numbers for which `is_wanted` holds.
  template <typename Is_wanted>
  Vertex_set set_of(const Is_wanted& is_wanted) const
  {
    Vertex_set result = 0;
    for(int i = 0; i < m_table.number_of_vertices(); ++i)
      if(is_wanted(i))
        result |= Vertex_set(1) << i;
    return result;
  }

  void check()
  {
    const int n = m_table.number_of_vertices();
    assert(n == static_cast<int>(m_vertices.size()) && m_table.vertices() == m_vertices);
    assert(m_table.all() == set_of([](int) { return true; }) && m_table.position(Vertex_handle()) == n);
    for(int i = 0; i < n; ++i)
    {
      assert(m_table.position(m_vertices[static_cast<std::size_t>(i)]) == i);
      for(int j = 0; j < n; ++j)
        for(int k = 0; k < n; ++k)
          if(i != j && j != k && k != i)
          {
            check_face({{ i, j, k }});
            check_edges({{ i, j }}, k);
          }
    }
  }

  void check_face(const Table::Face& f)
  {
    const auto positive = set_of([&](const int x) { return volume(f[0], f[1], f[2], x) > 0; });
    const auto negative = set_of([&](const int x) { return volume(f[0], f[1], f[2], x) < 0; });
    assert(m_table.sides(f).positive == positive && m_table.sides(f).negative == negative);
    int number_of_positive = 0;
    internal::for_each_bit(positive, [&](const int a)
    {
      assert(number_of_positive++ > 0 || internal::lowest_bit(positive) == a);
      assert(m_table.ends_of_piercing_edges(f, a) == set_of([&](const int b)
      {
        return br3_test::does_pierce(point(a), point(b), point(f[0]), point(f[1]), point(f[2]));
      }));
      const auto inside = set_of([&](const int x)
      {
        return x != f[0] && x != f[1] && x != f[2] && x != a && volume(f[0], f[1], f[2], x) >= 0
            && volume(f[1], f[0], a, x) >= 0 && volume(f[2], f[1], a, x) >= 0 && volume(f[0], f[2], a, x) >= 0;
      });
      assert(m_table.contains_vertex(f, a) == (inside != 0));
    });
    assert(number_of_positive == internal::number_of_bits(positive));
  }

  // Edges that start at k, and faces that have it.
  void check_edges(const Table::Edge& e, const int k)
  {
    const Vertex_set crossing = set_of([&](const int b)
    {
      return br3_test::do_cross(point(e[0]), point(e[1]), point(k), point(b));
    });
    assert(m_table.ends_of_crossing_edges(e, k) == crossing);
    number_of_crossings += crossing != 0;
    const int l = (k + 1) % m_table.number_of_vertices();
    assert(m_table.apexes_of_pierced_faces(e, {{ k, l }}) == set_of([&](const int x)
    {
      return br3_test::does_pierce(point(e[0]), point(e[1]), point(k), point(l), point(x));
    }));
  }

  Tr m_tr;
  const internal::Vertex_predicates_3<Tr> m_predicates;
  Table m_table;
  br3_test::Lattice_points m_points;
  std::vector<Vertex_handle> m_vertices;
};

void test_orientation_tables()
{
  std::mt19937 rng(5);
  std::size_t number_of_crossings = 0;
  for(const int range : { 3, 5, 2000 })
    for(int round = 0; round < 4; ++round)
    {
      Table_check check(br3_test::random_points(13, range, rng));
      check();
      number_of_crossings += check.number_of_crossings;
    }
  assert(number_of_crossings > 1000);
}

int main()
{
  for(const unsigned seed : { 1u, 2u })
  {
    for(const int exponent : { 0, 300, -300, 900, -900 })
      for(const int range : { 3, 1000000 })
        test_predicates_of_exact_positions(seed, range, exponent);
    test_mixed_scales(seed);
    test_points_on_rays(seed);
  }
  test_orientation_tables();
  std::cout << "done" << std::endl;
}
