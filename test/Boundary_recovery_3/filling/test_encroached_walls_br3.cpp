// Walls that are far larger than the sizes beside them: which points encroach on them, where there is a place beside
// them, and that field points keep away from them.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "encroachment_br3.h"
#include "mesh_validity_br3.h"
#include "random_numbers_br3.h"
#include "time_growth_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Encroached_walls_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/improve_mesh_quality.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel      K;
typedef K::Point_3                                               Point;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type Tr;
typedef internal::Coordinates_3                                  Coordinates;
typedef internal::Encroached_walls_3                             Walls;
typedef br3_test::Encroachment::Triangle                         Triangle;

Coordinates coordinates(const Point& p, const double scale = 1)
{
  return {{ scale * p.x(), scale * p.y(), scale * p.z() }};
}

struct Scene
{
  std::mt19937 rng;
  std::vector<Triangle> triangles;

  Scene(const unsigned seed, const int number) : rng(seed)
  {
    while(static_cast<int>(triangles.size()) < number)
    {
      const Point p = point();
      const Triangle t = {{ p, near(p), near(p) }};
      if(CGAL::squared_area(t[0], t[1], t[2]) > 0)
        triangles.push_back(t);
    }
  }

  double number(const int n) { return br3_test::random_int(rng, 1000 * n) / 1000.; }
  Point point() { return Point(number(20), number(20), number(20)); }
  const Triangle& random_triangle()
  {
    return triangles[static_cast<std::size_t>(br3_test::random_int(rng, static_cast<int>(triangles.size())))];
  }

  Point near_triangle(const Triangle& t)
  {
    return CGAL::barycenter(t[0], number(1), t[1], number(1), t[2], .5) + .1 * (point() - Point(10, 10, 10));
  }

  Point near(const Point& p) { return p + K::Vector_3(number(8) - 4, number(8) - 4, number(8) - 4); }

  // Both sides of all.
  Walls walls(const double size, const double scale = 1) const
  {
    std::vector<Walls::Wall> result;
    for(const Triangle& t : triangles)
    {
      const Coordinates p = coordinates(t[0], scale), q = coordinates(t[1], scale), r = coordinates(t[2], scale);
      result.push_back({ {{ p, q, r }}, scale * size });
      result.push_back({ {{ r, q, p }}, scale * size });
    }
    return Walls(result);
  }

  br3_test::Encroachment encroachment(const Point& p, const double size) const
  {
    br3_test::Encroachment result;
    for(const Triangle& t : triangles)
      result.look_at(t, p, size);
    return result;
  }
};

// The same as by looking at all of them, in coordinates of any magnitude.
void test_what_encroaches()
{
  Scene scene(1, 60);
  int number_at_walls = 0, number_at_edges = 0, number_far_away = 0;
  for(const double size : { .05, .2, .5 })
  {
    const Walls walls = scene.walls(size), tiny = scene.walls(size, std::ldexp(1, -400)),
                huge = scene.walls(size, std::ldexp(1, 400));
    for(int k = 0; k < 10000; ++k)
    {
      const Point p = scene.near_triangle(scene.random_triangle());
      const br3_test::Encroachment encroachment = scene.encroachment(p, size);
      if(encroachment.is_doubtful())
        continue;
      const bool is_encroached = encroachment.nearest() < 1;
      assert(walls.are_encroached_by(coordinates(p), size) == is_encroached);
      assert(tiny.are_encroached_by(coordinates(p, std::ldexp(1, -400)), std::ldexp(size, -400)) == is_encroached);
      assert(huge.are_encroached_by(coordinates(p, std::ldexp(1, 400)), std::ldexp(size, 400)) == is_encroached);
      number_at_walls += encroachment.to_walls < 1;
      number_at_edges += encroachment.to_edges < 1 && encroachment.to_walls > 1;
      number_far_away += ! is_encroached;
    }
  }
  assert((std::min)({ number_at_walls, number_at_edges, number_far_away }) > 100);
}

// Walls as large as the size, or without an area, do not matter; none at all, neither.
void test_small_walls()
{
  Scene scene(2, 40);
  const Walls walls = scene.walls(10), none, flat({ { {{ {{ 0, 0, 0 }}, {{ 1, 0, 0 }}, {{ .5, 0, 0 }} }}, 2 } });
  for(int k = 0; k < 1000; ++k)
  {
    const Point p = scene.point();
    assert(! walls.are_encroached_by(coordinates(p), 10) && ! none.are_encroached_by(coordinates(p), 1));
    assert(! flat.are_encroached_by({{ .5, 0, 0 }}, 1));
    assert(none.place_beside(coordinates(p), 1) == coordinates(p));
  }
}

// A point is moved out of where it encroaches, not farther than that, or stays where it is.
void test_place_beside()
{
  const double size = .3;
  int number_of_moved = 0;
  for(unsigned seed = 0; seed < 400; ++seed)
  {
    Scene scene(seed, 1);
    const Walls walls = scene.walls(size);
    for(int k = 0; k < 20; ++k)
    {
      const Triangle& t = scene.triangles.front();
      const Point p = scene.near_triangle(t);
      const Coordinates place = walls.place_beside(coordinates(p), size);
      const double way = internal::distance(place, coordinates(p));
      if(! walls.are_encroached_by(coordinates(p), size))
        assert(way < 1e-12);
      else if(CGAL::squared_distance(p, K::Triangle_3(t[0], t[1], t[2])) > 0)
      {
        assert(! walls.are_encroached_by(place, size) && way > 0 && way < 4 * 1.5 * size);
        ++number_of_moved;
      }
    }
  }
  assert(number_of_moved > 500);
}

// n needles at the tip of a cone, without those at its base.
std::vector<Triangle> cone(const int n)
{
  std::vector<Point> base;
  for(int i = 0; i < n; ++i)
    base.emplace_back(std::cos(2 * CGAL_PI * i / n), std::sin(2 * CGAL_PI * i / n), 0);
  std::vector<Triangle> result;
  for(std::size_t i = 0; i < base.size(); ++i)
    result.push_back({{ base[i], base[(i + 1) % base.size()], Point(0, 0, 1) }});
  return result;
}

// Inside of the cone, at most a tenth of its height away from it.
Point place_beside_cone(std::mt19937& rng)
{
  const double z = br3_test::random_int(rng, 900) / 1000., r = 1 - z - br3_test::random_int(rng, 1000) / 7000.;
  const double angle = br3_test::random_int(rng, 1000);
  return Point(r * std::cos(angle), r * std::sin(angle), z);
}

double time_beside_cone(const int n)
{
  Scene scene(1, 0);
  scene.triangles = cone(n);
  const Walls walls = scene.walls(.1);
  return br3_test::time_of([&]
  {
    std::mt19937 rng(1);
    for(int k = 0; k < 100; ++k)
      walls.place_beside(coordinates(place_beside_cone(rng)), .1);
  });
}

// Needles at one vertex have nearly the same edges, which count once: a place is looked at no longer where there are
// more of them. What encroaches is the same, but for what hardly does.
void test_cone()
{
  assert(br3_test::exponent(time_beside_cone(1000), time_beside_cone(16000), 16) < .5);
  Scene scene(1, 0);
  scene.triangles = cone(400);
  const Walls walls = scene.walls(.1);
  int number_of_encroaching = 0, number_of_others = 0;
  for(int k = 0; k < 200; ++k)
  {
    const Point p = place_beside_cone(scene.rng);
    const double nearest = scene.encroachment(p, .1).nearest();
    const bool is_encroached = walls.are_encroached_by(coordinates(p), .1);
    assert(is_encroached ? nearest < 1 + 1e-6 : nearest > .7);
    ++(is_encroached ? number_of_encroaching : number_of_others);
  }
  assert(number_of_encroaching > 20 && number_of_others > 20);
}

// A block with two triangles on each side.
Tr block(const double x, const double y, const double z)
{
  Tr tr;
  for(int k = 0; k < 8; ++k)
    tr.insert(Point(k & 1 ? x : 0, k & 2 ? y : 0, k & 4 ? z : 0));
  for(const auto c : tr.all_cell_handles())
    c->set_subdomain_index(tr.is_infinite(c) ? 0 : 1);
  return tr;
}

std::vector<Triangle> sides(const Tr& tr)
{
  std::vector<Triangle> result;
  for(const auto& f : tr.finite_facets())
    if(tr.is_infinite(f.first) || tr.is_infinite(f.first->neighbor(f.second)))
    {
      const auto v = internal::facet_vertices(f.first, f.second);
      result.push_back({{ v[0]->point(), v[1]->point(), v[2]->point() }});
    }
  return result;
}

// Field points do not encroach, there are as many as there is room for, and cells can be made good enough.
void test_block(const std::array<double, 3>& lengths, const double size, const std::array<std::size_t, 2>& numbers,
                const double least_angle)
{
  Tr tr = block(lengths[0], lengths[1], lengths[2]);
  const std::vector<Triangle> walls = sides(tr);
  assert(walls.size() == 12);
  const auto result = CGAL::insert_field_points(tr, size);
  assert(result && br3_test::is_valid_mesh(tr));
  assert(result.number_of_field_points >= numbers[0] && result.number_of_field_points <= numbers[1]);
  assert(sides(tr).size() == 12);
  for(const auto v : tr.finite_vertex_handles())
    if(v->in_dimension() == 3)
    {
      br3_test::Encroachment encroachment;
      for(const Triangle& t : walls)
        encroachment.look_at(t, v->point(), size);
      assert(encroachment.nearest() > 1 - 1e-6);
    }
  const auto improvement = CGAL::improve_mesh_quality(
    tr, CGAL::parameters::improvement_effort(CGAL::Boundary_recovery_3::Improvement_effort::high));
  assert(improvement && improvement.after.min_dihedral_angle > least_angle);
}

int main()
{
  test_what_encroaches();
  test_small_walls();
  test_place_beside();
  test_cone();
  test_block({{ 1, 1, 1 }}, .1, {{ 300, 3000 }}, 8);     // 2.4 degrees if points may encroach
  test_block({{ 1, 1, 1 }}, .6, {{ 1, 20 }}, 20);        // nothing is large
  test_block({{ 10, 10, 1 }}, .25, {{ 1000, 5000 }}, 1); // there is room for some
  test_block({{ 10, 10, 1 }}, .5, {{ 0, 0 }}, 5);         // and for none
  return EXIT_SUCCESS;
}
