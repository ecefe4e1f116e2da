// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Sizes that a surface carries into space are those of the formula, computed from all of its vertices; they grow no
// faster than allowed, and a triangulation with marked facets gives the same ones as the triangles.

#undef NDEBUG

#include "time_growth_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Surface_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Box_hierarchy_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Cone_minimum_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef internal::Cone_minimum_3::Site Site;
typedef internal::Coordinates_3 Coordinates_3;

// within 0 and 1
double random_number(std::mt19937& rng) { return rng() / 4294967296.; }

Coordinates_3 random_place(std::mt19937& rng, const double size)
{
  return {{ size * random_number(rng), size * random_number(rng), size * random_number(rng) }};
}

double distance(const Coordinates_3& p, const Coordinates_3& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// The smallest size within a distance of a place.
double brute_force(const std::vector<Site>& sites, const double grading, const Coordinates_3& p,
                   const double radius = 0)
{
  double smallest = std::numeric_limits<double>::infinity();
  for(const Site& q : sites)
    smallest = (std::min)(smallest, q.size + grading * (std::max)(0., distance(p, q.point) - radius));
  return smallest;
}

bool are_equal(const double x, const double y) { return std::abs(x - y) <= 1e-13 * (std::abs(x) + std::abs(y)); }

// Random sites, in a cube far away from the origin or not, and near or far queries.
void test_cones(const std::size_t n, const double size, const double shift, const double spread, const double grading)
{
  std::mt19937 rng(static_cast<unsigned>(n));
  std::vector<Site> sites;
  for(std::size_t i = 0; i < n; ++i)
  {
    Coordinates_3 p = random_place(rng, size);
    p[0] += shift;
    sites.push_back(Site{ p, size * std::pow(spread, - random_number(rng)) });
  }
  sites.push_back(sites.front()); // the same twice
  const internal::Cone_minimum_3 cones(sites, grading);
  for(int k = 0; k < 300; ++k)
  {
    Coordinates_3 p = random_place(rng, k % 3 == 0 ? size : k % 3 == 1 ? 100 * size : size / 100);
    p[0] += shift;
    const double value = cones(p);
    assert(std::abs(value - brute_force(sites, grading, p)) <= 1e-13 * value + 1e-15 * std::abs(shift));
    assert(value == cones(p));
    const double radius = size * std::pow(random_number(rng), 3), least = cones.around(p, radius);
    assert(std::abs(least - brute_force(sites, grading, p, radius)) <= 1e-13 * value + 1e-15 * std::abs(shift));
    assert(least <= value && cones.around(p, 0) == value);
  }
  for(const Site& q : sites)
    assert(cones(q.point) <= q.size * (1 + 1e-13));
}

// All vertices of a sphere are as far away from its center.
void test_sphere()
{
  std::mt19937 rng(7);
  std::vector<Site> sites;
  while(sites.size() < 5000)
  {
    const Coordinates_3 p = random_place(rng, 2), q = {{ p[0] - 1, p[1] - 1, p[2] - 1 }};
    const double length = distance(p, {{ 1, 1, 1 }});
    if(length > .1 && length < 1)
      sites.push_back(Site{ {{ q[0] / length, q[1] / length, q[2] / length }}, .01 + .001 * random_number(rng) });
  }
  const internal::Cone_minimum_3 cones(sites, .2);
  for(const double x : { 0., 1e-9, .3, .99, 1., 1.01, 50. })
    assert(are_equal(cones({{ x, 0, 0 }}), brute_force(sites, .2, {{ x, 0, 0 }})));
}

void test_degenerate_cones()
{
  const double infinity = std::numeric_limits<double>::infinity();
  assert(internal::Cone_minimum_3()({{ 1, 2, 3 }}) == infinity);
  assert(internal::Cone_minimum_3(std::vector<Site>(), .2)({{ 1, 2, 3 }}) == infinity);
  for(std::size_t n = 1; n < 40; ++n)
  {
    const std::vector<Site> same(n, Site{ {{ 1, 2, 3 }}, 5 });
    assert(internal::Cone_minimum_3(same, .2)({{ 1, 2, 3 }}) == 5);
    assert(are_equal(internal::Cone_minimum_3(same, .2)({{ 1, 2, 13 }}), 7));
  }
}

double time_of_questions(const std::vector<Site>& sites)
{
  const internal::Cone_minimum_3 cones(sites, .2);
  return br3_test::time_of([&]
  {
    for(int k = 0; k < 500; ++k)
      assert(cones({{ .01 * k, 1, 1 }}) < 2);
  });
}

// Of many sites at one place, the smallest counts, and they take no more time than one.
void test_sites_at_one_place()
{
  std::vector<Site> equal, falling;
  for(int i = 0; i < 20000; ++i)
  {
    equal.push_back(Site{ {{ 1, 2, 3 }}, .1 });
    falling.push_back(Site{ {{ 1, 2, 3 }}, .2 - .000005 * i });
  }
  for(const auto* const many : { &equal, &falling })
  {
    const std::vector<Site> few(many->begin(), many->begin() + 20);
    assert(br3_test::exponent(time_of_questions(few), time_of_questions(*many), 1000) < .4);
    assert(are_equal(internal::Cone_minimum_3(*many, .2)({{ 1, 2, 13 }}), many->back().size + 2));
  }
}

// Sizes grow by the grading times the distance, at most, and that is reached.
template <typename Field>
void test_grading(const Field& field, const double grading)
{
  std::mt19937 rng(3);
  double steepest = 0;
  for(int k = 0; k < 2000; ++k)
  {
    const Coordinates_3 p = random_place(rng, 3), q = random_place(rng, 3);
    const double growth = std::abs(field(p) - field(q)) / distance(p, q);
    assert(growth <= grading * (1 + 1e-9));
    steepest = (std::max)(steepest, growth);
  }
  assert(steepest > grading * .9);
}

template <typename Point_3>
double distance(const Point_3& p, const Point_3& q)
{
  return distance(internal::coordinates_of(p), internal::coordinates_of(q));
}

template <typename Point_3>
double area(const Point_3& p, const Point_3& q, const Point_3& r)
{
  return std::sqrt(CGAL::to_double(CGAL::squared_area(p, q, r)));
}

// The mean length of the edges at a vertex, 0 if there is none.
template <typename Point_3>
double mean_length(const std::vector<Point_3>& points, const std::vector<std::array<int, 3> >& triangles, const int i)
{
  std::set<int> neighbors;
  for(const auto& t : triangles)
    if(std::count(t.begin(), t.end(), i) > 0)
      neighbors.insert(t.begin(), t.end());
  neighbors.erase(i);
  double sum = 0, number = 0;
  for(const int j : neighbors)
    if(points[j] != points[i])
    {
      sum += distance(points[i], points[j]);
      ++number;
    }
  return number > 0 ? sum / number : 0;
}

// The mean by area of what `size` says of the triangles at a vertex, 0 if there is no area.
template <typename Point_3, typename Size>
double mean_by_area(const std::vector<Point_3>& points, const std::vector<std::array<int, 3> >& triangles, const int i,
                    const Size& size)
{
  double sum = 0, total = 0;
  for(const auto& t : triangles)
    if(std::count(t.begin(), t.end(), i) > 0)
    {
      const double weight = area(points[t[0]], points[t[1]], points[t[2]]);
      sum += weight * size(t);
      total += weight;
    }
  return total > 0 ? sum / total : 0;
}

// The sizes of a surface at its vertices, by the definition.
template <typename Point_3>
std::vector<Site> brute_force_sites(const std::vector<Point_3>& points,
                                    const std::vector<std::array<int, 3> >& triangles, const double grading)
{
  const auto first_mean = [&](const int i)
  {
    return mean_by_area(points, triangles, i, [&](const std::array<int, 3>& t)
    {
      return (distance(points[t[0]], points[t[1]]) + distance(points[t[1]], points[t[2]]) +
              distance(points[t[2]], points[t[0]])) / 3;
    });
  };
  std::vector<Site> sites;
  for(int i = 0; i < static_cast<int>(points.size()); ++i)
  {
    const double length = mean_length(points, triangles, i);
    const double by_area = mean_by_area(points, triangles, i, [&](const std::array<int, 3>& t)
    {
      return (first_mean(t[0]) + first_mean(t[1]) + first_mean(t[2])) / 3;
    });
    if(length > 0)
      sites.push_back(Site{ internal::coordinates_of(points[i]),
                            by_area > (1 + grading) * length ? by_area : length });
  }
  return sites;
}

// The facets between cells of different regions, and marked ones, as triangles between numbered points.
template <typename Tr>
std::vector<std::array<int, 3> > surface_of(const Tr& tr, std::vector<typename Tr::Geom_traits::Point_3>& points)
{
  std::vector<typename Tr::Vertex_handle> vertices;
  for(const auto v : tr.finite_vertex_handles())
  {
    vertices.push_back(v);
    points.push_back(v->point());
  }
  std::vector<std::array<int, 3> > triangles;
  for(const auto c : tr.finite_cell_handles())
    for(int i = 0; i < 4; ++i)
    {
      const auto d = c->neighbor(i);
      if(c->subdomain_index() == (tr.is_infinite(d) ? 0 : d->subdomain_index()) && ! c->is_facet_on_surface(i))
        continue;
      std::array<int, 3> t;
      for(int j = 0, k = 0; j < 4; ++j)
        if(j != i)
          t[k++] = static_cast<int>(std::find(vertices.begin(), vertices.end(), c->vertex(j)) - vertices.begin());
      std::sort(t.begin(), t.end());
      triangles.push_back(t);
    }
  std::sort(triangles.begin(), triangles.end()); // most of them were seen from both sides
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

// Random points, two regions and an outside, and a sheet of marked facets.
template <typename Tr>
void test_triangulation()
{
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  std::mt19937 rng(11);
  Tr tr;
  for(int i = 0; i < 60; ++i)
    tr.insert(Point_3(3 * random_number(rng), 3 * random_number(rng), 3 * random_number(rng)));
  for(const auto c : tr.finite_cell_handles())
    c->set_subdomain_index(c->vertex(0)->point().x() < 1 ? 0 : c->vertex(0)->point().x() < 2 ? 1 : 2);
  int number_of_marks = 0;
  for(const auto& f : tr.finite_facets())
    if(++number_of_marks % 10 == 0)
    {
      const auto other = tr.mirror_facet(f);
      f.first->set_surface_patch_index(f.second, 5);
      other.first->set_surface_patch_index(other.second, 5);
    }

  std::vector<Point_3> points;
  const std::vector<std::array<int, 3> > triangles = surface_of(tr, points);
  const std::vector<Site> sites = brute_force_sites(points, triangles, .1);
  const CGAL::Boundary_recovery_3::Surface_sizing_field_3<Tr> field(tr, .1), of_triangles(points, triangles, .1);
  const auto size = [&](const Coordinates_3& p) { return CGAL::to_double(field(Point_3(p[0], p[1], p[2]))); };
  for(int k = 0; k < 200; ++k)
  {
    const Coordinates_3 p = random_place(rng, k % 2 == 0 ? 3 : 30);
    assert(are_equal(size(p), brute_force(sites, .1, p)));
    const Point_3 q(p[0], p[1], p[2]);
    assert(are_equal(size(p), CGAL::to_double(of_triangles(q))) && field(q) == field(q, 3, 1));
  }
  assert(field.grading() == .1);
  test_grading(size, .1);
}

// The same sizes, bit for bit, wherever the cells are in memory.
template <typename Tr>
void test_addresses()
{
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  std::vector<std::unique_ptr<char[]> > memory;
  std::vector<double> sizes;
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    std::mt19937 rng(seed);
    for(int k = 0; k < 500; ++k)
      memory.push_back(std::make_unique<char[]>(rng() % 100000));
    std::shuffle(memory.begin(), memory.end(), rng);
    memory.resize(memory.size() / 2); // so there are gaps
    Tr tr;
    rng.seed(12);
    for(int i = 0; i < 1000; ++i)
      tr.insert(Point_3(random_number(rng), random_number(rng), random_number(rng)));
    for(const auto c : tr.finite_cell_handles())
      c->set_subdomain_index(c->vertex(0)->point().x() < .5 ? 1 : 2);
    const CGAL::Boundary_recovery_3::Surface_sizing_field_3<Tr> field(tr, .1);
    std::vector<double> found;
    for(const auto v : tr.finite_vertex_handles())
      found.push_back(CGAL::to_double(field(v->point())));
    assert(sizes.empty() || found == sizes);
    sizes = found;
  }
}

// A square of 2 n^2 equal triangles. At `vertex` it is cut by a fan of eight tiny triangles, as isosurfaces are where
// they pass a vertex of their grid.
template <typename Point_3>
void make_square(const int n, const double tiny, std::vector<Point_3>& points,
                 std::vector<std::array<int, 3> >& triangles)
{
  const auto number = [n](const int i, const int j) { return i * (n + 1) + j; };
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      points.push_back(Point_3(i, j, 0));
  const int center = number(n / 2, n / 2);
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      triangles.push_back({{ number(i, j), number(i + 1, j), number(i + 1, j + 1) }});
      triangles.push_back({{ number(i, j), number(i + 1, j + 1), number(i, j + 1) }});
    }
  if(tiny == 0)
    return;
  std::vector<std::array<int, 3> > more; // around the center: each of its triangles is cut off at a corner
  for(auto& t : triangles)
    for(int k = 0; k < 3; ++k)
      if(t[k] == center)
      {
        const auto corner = [&](const int end)
        {
          const Point_3 p = CGAL::ORIGIN + ((points[center] - CGAL::ORIGIN) * (1 - tiny) +
                                            (points[end] - CGAL::ORIGIN) * tiny);
          const auto known = std::find(points.begin(), points.end(), p);
          if(known != points.end())
            return static_cast<int>(known - points.begin());
          points.push_back(p);
          return static_cast<int>(points.size()) - 1;
        };
        const int next = t[(k + 1) % 3], last = t[(k + 2) % 3], a = corner(next), b = corner(last);
        more.push_back({{ center, a, b }});
        more.push_back({{ a, next, b }});
        t = {{ b, next, last }};
        break;
      }
  triangles.insert(triangles.end(), more.begin(), more.end());
}

// A few tiny triangles do not rule a coarse surface; where triangles are alike, nothing changes.
void test_tiny_triangles()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point_3;
  typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Tr;
  for(const double tiny : { 0., 1. / 4, 1. / 1024, 1. / 1048576 })
  {
    std::vector<Point_3> points;
    std::vector<std::array<int, 3> > triangles;
    make_square(8, tiny, points, triangles);
    const CGAL::Boundary_recovery_3::Surface_sizing_field_3<Tr> field(points, triangles);
    const double grading = field.grading();
    const std::vector<Site> sites = brute_force_sites(points, triangles, grading);
    for(const Site& q : sites)
      assert(are_equal(field(Point_3(q.point[0], q.point[1], q.point[2])), brute_force(sites, grading, q.point)));
    auto turned = triangles; // and given twice, in another order
    for(auto& t : turned)
      std::swap(t[0], t[2]);
    turned.insert(turned.begin(), triangles.rbegin(), triangles.rend());
    const CGAL::Boundary_recovery_3::Surface_sizing_field_3<Tr> same_field(points, turned);
    for(const Point_3& p : points)
      assert(same_field(p) == field(p));
    const double mean_edge = (4 + 2 * std::sqrt(2.)) / 6, at_center = field(Point_3(4, 4, 0));
    assert(tiny == 0 ? are_equal(at_center, mean_edge) : at_center > mean_edge / 2);
  }
}

// What is not finite in the squares of coordinates, or nothing, is the same in another unit.
void test_scales()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point_3;
  typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Tr;
  std::vector<Point_3> points;
  std::vector<std::array<int, 3> > triangles;
  make_square(4, 1. / 64, points, triangles);
  const CGAL::Boundary_recovery_3::Surface_sizing_field_3<Tr> field(points, triangles);
  for(const double unit : { std::ldexp(1., -800), std::ldexp(1., -400), std::ldexp(1., 400), std::ldexp(1., 800) })
  {
    std::vector<Point_3> scaled;
    for(const Point_3& p : points)
      scaled.push_back(Point_3(unit * p.x(), unit * p.y(), unit * p.z()));
    const CGAL::Boundary_recovery_3::Surface_sizing_field_3<Tr> scaled_field(scaled, triangles);
    for(std::size_t i = 0; i < points.size(); ++i)
      assert(scaled_field(scaled[i]) == unit * field(points[i]));
  }
}

// Nothing is there to take sizes from.
template <typename Tr>
void test_nothing()
{
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  typedef CGAL::Boundary_recovery_3::Surface_sizing_field_3<Tr> Field;
  const double infinity = std::numeric_limits<double>::infinity();
  Tr tr;
  assert(Field(tr)(Point_3(0, 0, 0)) == infinity);
  tr.insert(Point_3(0, 0, 0));
  tr.insert(Point_3(1, 0, 0));
  tr.insert(Point_3(0, 1, 0));
  assert(Field(tr)(Point_3(0, 0, 0)) == infinity); // of dimension two
  tr.insert(Point_3(0, 0, 1));
  assert(Field(tr)(Point_3(0, 0, 0)) == infinity); // no region
  tr.finite_cells_begin()->set_subdomain_index(1);
  assert(are_equal(CGAL::to_double(Field(tr)(Point_3(0, 0, 0))), 1) && Field(tr).grading() == .3);
  // an edge beside the surface counts, one of the surface counts once
  const auto far = tr.insert(Point_3(50, 0, 0)), farther = tr.insert(Point_3(50, 0, 3));
  for(const auto c : tr.finite_cell_handles())
    c->set_subdomain_index(0);
  typename Tr::Cell_handle c;
  int i, j, k, l;
  typename Tr::Vertex_handle v[4];
  for(const auto u : tr.finite_vertex_handles())
    if(u->point() == Point_3(0, 0, 0)) v[0] = u;
    else if(u->point() == Point_3(1, 0, 0)) v[1] = u;
    else if(u->point() == Point_3(0, 1, 0)) v[2] = u;
    else if(u->point() == Point_3(0, 0, 1)) v[3] = u;
  assert(tr.is_cell(v[0], v[1], v[2], v[3], c, i, j, k, l));
  c->set_subdomain_index(1);
  const std::vector<std::array<typename Tr::Vertex_handle, 2> > edges = { {{ farther, far }}, {{ v[1], v[0] }} };
  assert(CGAL::to_double(Field(tr)(Point_3(50, 0, 0))) > 10);
  assert(Field(tr, .2, edges)(Point_3(50, 0, 0)) == 3 && Field(tr, .2, edges)(Point_3(50, 0, 1)) == 3.2);
  assert(Field(tr, .2, edges)(Point_3(0, 0, 0)) == Field(tr, .2)(Point_3(0, 0, 0)));

  const std::vector<Point_3> points(3, Point_3(1, 1, 1));
  const std::vector<std::array<int, 3> > triangles = { {{ 0, 1, 2 }} };
  assert(Field(points, triangles)(Point_3(0, 0, 0)) == infinity); // without length
}

int main()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
  typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;
  for(const std::size_t n : { 1, 7, 8, 9, 16, 17, 100, 1000, 3001 })
    test_cones(n, 1, 0, 10, .2);
  test_cones(500, 1e-9, 0, 1e6, .2);
  test_cones(500, 1e9, 0, 1e12, .2);
  test_cones(500, 1e-3, 1e6, 10, .2);
  test_cones(500, 1e200, 0, 10, .5);
  test_cones(500, 1e-200, 0, 10, .5);
  test_cones(500, 1, 0, 10, 0);
  test_cones(500, 1, 0, 1.01, 3);
  test_sphere();
  test_degenerate_cones();
  test_sites_at_one_place();
  test_triangulation<CGAL::Boundary_constrained_mesh_triangulation_3<Epick>::type>();
  test_triangulation<CGAL::Boundary_constrained_mesh_triangulation_3<Epeck>::type>();
  test_triangulation<CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Epick> >();
  test_addresses<CGAL::Boundary_constrained_mesh_triangulation_3<Epick>::type>();
  test_tiny_triangles();
  test_scales();
  test_nothing<CGAL::Boundary_constrained_mesh_triangulation_3<Epick>::type>();
  std::cout << "done" << std::endl;
  return 0;
}
