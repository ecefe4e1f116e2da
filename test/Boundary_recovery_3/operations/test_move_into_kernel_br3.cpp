// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The search for points in the kernel of a polyhedron, judged by rational numbers.

#undef NDEBUG

#include "box_soup_br3.h"
#include "brute_force_checker_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Visibility_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/points_in_kernel.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/exact_numbers.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Vertex_handle                                   Vertex_handle;
typedef K::Point_3                                          Point_3;

// A polyhedron, given by triangles that are counterclockwise from outside, and a vertex for the point in its kernel.
class Polyhedron
{
public:
  typedef internal::Move_into_kernel_3<Tr> Move_into_kernel;
  typedef Move_into_kernel::Exact_point    Exact_point;

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

  // Puts the vertex at an exact point inside, and moves it on to the middle of the kernel.
  Exact_point centered(const Exact_point& inside)
  {
    m_positions.set(m_v, inside);
    assert(is_in_kernel());
    m_move_into_kernel.center(m_v, m_faces);
    assert(is_in_kernel());
    return m_positions(m_v);
  }

  Exact_point exact(const std::size_t i) const { return m_positions(vertices[i]); }

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

// The geometry alone, in the corner of a cube: what is proposed, and what is decided.
void test_kernel_alone()
{
  typedef internal::Exact_positions_3<Tr>    Positions;
  typedef Positions::Exact_point_3           Exact_point;
  typedef Positions::Exact_kernel::Vector_3  Exact_vector;
  Tr tr;
  const Positions positions;
  const internal::Vertex_predicates_3<Tr> predicates(tr, &positions);
  std::vector<Vertex_handle> v;
  for(const Point_3& p : { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), Point_3(0, 0, 0) })
  {
    v.push_back(tr.tds().create_vertex());
    v.back()->set_point(p);
  }
  std::vector<std::array<Vertex_handle, 3> > faces;
  for(const br3_test::Simplex& t : tetrahedron)
    faces.push_back({{ v[t[0]], v[t[2]], v[t[1]] }});

  const internal::Visibility_kernel_3<Tr> kernel(predicates, faces, predicates.approximate_point(v[0]));
  int number_of_questions = 0;
  const auto answer = [&](const bool a) { return [&, a](const auto&) { ++number_of_questions; return a; }; };
  const auto deepest = kernel.deepest_point(answer(true));
  assert(number_of_questions == 1 && deepest && std::abs(deepest->x() * (3 + std::sqrt(3.)) - 1) < 1e-9);
  const auto on_ray = kernel.point_on_ray({ 1, 1, 1 }, answer(true));
  assert(number_of_questions == 2 && on_ray && on_ray->x() > 0 && on_ray->x() == on_ray->y() && on_ray->x() < 1. / 3);
  assert(! kernel.point_on_ray({ 1, 1, 1 }, answer(false)) && number_of_questions > 10);
  assert(! kernel.point_on_ray({ 0, 0, 0 }, answer(true)));

  const internal::Is_in_kernel_3<Tr> is_in_kernel(predicates);
  for(int x = -1; x <= 8; ++x)
    for(int y = -1; y <= 8; ++y)
      for(int z = -1; z <= 8; ++z)
      {
        v[4]->set_point(Point_3(x / 8., y / 8., z / 8.));
        assert(is_in_kernel(v[4], faces) == (x > 0 && y > 0 && z > 0 && x + y + z < 8));
      }

  const std::array<double, 3> sizes = {{ 1, 1, 1 }};
  const auto exact = internal::exact_point_on_ray(positions, faces, positions(v[0]), Exact_vector(1, 2, 3), sizes);
  assert(exact && exact->x() > 0 && exact->y() == 2 * exact->x() && exact->z() == 3 * exact->x() && 6 * exact->x() < 1);
  assert(! internal::exact_point_on_ray(positions, faces, positions(v[0]), Exact_vector(-1, 0, 0), sizes));
  const auto near = internal::representable_point_in_kernel(positions, faces, Exact_point(.25, .25, .25), .125);
  assert(near);
  for(const double x : *near)
    assert(x >= .125 && x <= .375);
}

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

// Many faces in few planes, which make the linear program degenerate: a cube whose sides are divided into n by n
// squares, as seen from one of its corners.
void test_many_faces_in_a_plane()
{
  const int n = 8;
  br3_test::Box_soup soup;
  for(int axis = 0; axis < 3; ++axis)
    for(const int height : { 0, n })
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j)
        {
          br3_test::Integer_point low, high;
          low[axis] = high[axis] = height;
          low[(axis + 1) % 3] = i;
          low[(axis + 2) % 3] = j;
          high[(axis + 1) % 3] = i + 1;
          high[(axis + 2) % 3] = j + 1;
          soup.add_rectangle(axis, low, high, height == n);
        }
  std::vector<br3_test::Coordinates> points;
  for(const br3_test::Integer_point& p : soup.points)
    points.push_back({{ 1. * p[0] / n, 1. * p[1] / n, 1. * p[2] / n }});
  std::vector<br3_test::Simplex> triangles;
  for(const auto& t : soup.triangles)
    triangles.emplace_back(t.begin(), t.end());
  Polyhedron cube(points, triangles);
  assert(triangles.size() == 768 && cube.has_deepest_point());
  for(int i = 0; i < 3; ++i)
    assert(std::abs(cube.point()[i] - .5) < 1e-9);
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

// From a corner of a bipyramid, which may be thinner than numbers are from each other, the vertex moves near to the
// mean of all corners. How long its numbers are depends neither on where it was nor on the unit.
void test_center()
{
  typedef Polyhedron::Exact_point Exact_point;
  typedef CGAL::Kernel_traits<Exact_point>::Kernel::FT FT;
  const std::vector<br3_test::Simplex> bipyramid = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 },
                                                     { 1, 0, 4 }, { 2, 1, 4 }, { 0, 2, 4 } };
  for(const int exponent : { 0, 300, -300, 800, -800 })
    for(const double height : { 1., std::ldexp(1., -52) })
    {
      Polyhedron p(scaled({ {{ 0, 0, 1 }}, {{ 1, 0, 1 }}, {{ 0, 1, 1 }}, {{ .25, .25, 1 + height }},
                            {{ .25, .25, 1 - height }} }, exponent), bipyramid);
      auto sum = p.exact(0) - CGAL::ORIGIN;
      for(std::size_t i = 1; i < 5; ++i)
        sum = sum + (p.exact(i) - CGAL::ORIGIN);
      const Exact_point mean = CGAL::ORIGIN + sum / 5;
      const FT unit = (p.exact(3).z() - p.exact(4).z()) / 1024;
      for(const double part : { 1e-22, .5 })
      {
        const Exact_point found = p.centered(p.exact(0) + part * (mean - p.exact(0)));
        assert(p.has_exact_position());
        for(int i = 0; i < 3; ++i)
        {
          const FT multiple = found[i] / unit;
          assert(CGAL::abs(FT(found[i] - mean[i])) < 64 * unit);
          assert(multiple == internal::nearest_integer(multiple));
        }
      }
    }
}

int main()
{
  test_kernel_alone();
  test_deepest_point();
  test_many_faces_in_a_plane();
  test_empty_kernel();
  test_ray();
  test_center();
  std::cout << "done" << std::endl;
}
