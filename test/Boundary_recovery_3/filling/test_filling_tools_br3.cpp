// What the filling is made of: numbers of vertices, sizes at them, bounds of sizes, circumspheres, the forecast, and
// the memory that is left.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "random_numbers_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Vertex_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/available_memory.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel            K;
typedef K::Point_3                                                     Point;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type       Tr;
typedef CGAL::Delaunay_triangulation_3<K>                              Plain_tr; // no place for sizes in its vertices
typedef internal::Coordinates_3                                        Coordinates;
typedef std::array<Coordinates, 4>                                     Tetrahedron;

double random_coordinate(std::mt19937& rng) { return br3_test::random_int(rng, 1 << 20) / double(1 << 20); }

Coordinates random_place(std::mt19937& rng)
{
  return {{ random_coordinate(rng), random_coordinate(rng), random_coordinate(rng) }};
}

Point point(const Coordinates& p) { return Point(p[0], p[1], p[2]); }

template <typename Triangulation>
void insert_random_points(Triangulation& tr, const int n, std::mt19937& rng)
{
  for(int i = 0; i < n; ++i)
    tr.insert(point(random_place(rng)));
}

void test_local_vertices()
{
  std::mt19937 rng(1);
  Plain_tr tr;
  insert_random_points(tr, 300, rng);
  const std::vector<Plain_tr::Vertex_handle> vertices(tr.finite_vertex_handles().begin(),
                                                      tr.finite_vertex_handles().end());
  internal::Local_vertices<Plain_tr::Vertex_handle> local;
  for(int round = 0; round < 200; ++round)
  {
    local.clear();
    std::map<Plain_tr::Vertex_handle, std::size_t> expected;
    const int n = br3_test::random_int(rng, round % 2 == 0 ? 20 : 600);
    for(int k = 0; k < n; ++k)
    {
      const auto v = vertices[br3_test::random_int(rng, static_cast<int>(vertices.size()))];
      assert(local.insert(v) == expected.emplace(v, expected.size()).second);
    }
    assert(local.size() == expected.size());
    for(const auto& e : expected)
      assert(local.vertices()[e.second] == e.first);
  }
}

template <typename Triangulation>
void test_vertex_sizes()
{
  std::mt19937 rng(2);
  Triangulation tr;
  insert_random_points(tr, 20, rng);
  internal::Vertex_sizes_3<Triangulation> sizes(tr);
  double size = 1;
  for(const auto v : tr.finite_vertex_handles())
  {
    assert(! sizes.is_known(v) && ! sizes.is_pending(v));
    sizes.set(v, size);
    assert(sizes.is_known(v) && sizes[v] == size && ! sizes.is_pending(v));
    sizes.set_pending(v, size / 2);
    assert(sizes.is_pending(v) && sizes[v] == size / 2);
    sizes.settle(v);
    assert(! sizes.is_pending(v) && sizes[v] == size / 2);
    size *= 1.5;
  }
  const internal::Vertex_sizes_3<Triangulation> forgotten(tr);
  for(const auto v : tr.finite_vertex_handles())
    assert(! forgotten.is_known(v));
}

void test_circumsphere()
{
  std::mt19937 rng(3);
  for(int k = 0; k < 2000; ++k)
  {
    Tetrahedron t = {{ random_place(rng), random_place(rng), random_place(rng), random_place(rng) }};
    if(CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(t[3])) == CGAL::NEGATIVE)
      std::swap(t[0], t[1]);
    assert(internal::volume_times_6(t) > 0);
    const internal::Sphere_3 s = internal::circumsphere(t);
    for(const Coordinates& p : t)
      assert(std::abs(internal::distance(p, s.center) / std::sqrt(s.squared_radius) - 1) < 1e-6);
    const Coordinates q = random_place(rng);
    const auto side = CGAL::side_of_bounded_sphere(point(t[0]), point(t[1]), point(t[2]), point(t[3]), point(q));
    assert(internal::is_in_circumsphere(t, q) == (side == CGAL::ON_BOUNDED_SIDE));
  }
  const Tetrahedron flat = {{ {{ 0, 0, 0 }}, {{ 1, 0, 0 }}, {{ 0, 1, 0 }}, {{ 1, 1, 0 }} }};
  assert(! (internal::circumsphere(flat).squared_radius <= 1e9)); // not a number, or infinite
}

// The six tetrahedra that a cube consists of.
std::vector<Tetrahedron> tetrahedra_of_cube(const Coordinates& low, const double length)
{
  std::vector<Tetrahedron> tetrahedra;
  std::array<int, 3> axes = {{ 0, 1, 2 }};
  do
  {
    Tetrahedron t;
    t[0] = low;
    for(std::size_t i = 0; i < 3; ++i)
    {
      t[i + 1] = t[i];
      t[i + 1][axes[i]] += length;
    }
    tetrahedra.push_back(t);
  } while(std::next_permutation(axes.begin(), axes.end()));
  return tetrahedra;
}

// The integral over some tetrahedra.
template <typename Size>
double forecast(Size size, const double grading, const std::size_t max_number_of_questions,
                const std::vector<Tetrahedron>& tetrahedra)
{
  internal::Forecast_3<Size> integral(size, grading, max_number_of_questions);
  for(const Tetrahedron& t : tetrahedra)
    integral.add(t, 1, size(internal::centroid(t), 1));
  return integral();
}

// The integral over the unit cube.
template <typename Size>
double forecast(const Size& size, const double grading, const std::size_t max_number_of_questions)
{
  return forecast(size, grading, max_number_of_questions, tetrahedra_of_cube({{ 0, 0, 0 }}, 1));
}

void test_forecast()
{
  const auto constant = [](const Coordinates&, const int) { return 0.1; };
  assert(std::abs(forecast(constant, 0, 1000) - 6000 * std::sqrt(2)) < 1e-6);

  // h = a + g x has the integral 6 sqrt(2) (1/a^2 - 1/(a+g)^2) / (2 g)
  const double a = 0.05, g = 0.3;
  const auto linear = [&](const Coordinates& p, const int) { return a + g * p[0]; };
  const double exact = 6 * std::sqrt(2) * (1 / (a * a) - 1 / ((a + g) * (a + g))) / (2 * g);
  assert(std::abs(forecast(linear, g, 20000) / exact - 1) < 0.02);
  assert(std::abs(forecast(linear, g, 2000) / exact - 1) < 0.05); // what is not looked at is guessed

  // a small source in a corner of large cells, which none of the first places tells of
  const auto source = [&](const Coordinates& p, const int)
  {
    return (std::min)(0.5, 0.001 + 0.2 * internal::distance(p, {{ 0.3, 0.4, 0.7 }}));
  };
  double sum = 0; // by shells around it, as far as they are inside
  for(double r = 0; r < 0.29; r += 1e-5)
    sum += 1e-5 * 4 * 3.14159265 * r * r * 6 * std::sqrt(2) / std::pow(0.001 + 0.2 * r, 3);
  const double value = forecast(source, 0.2, 20000);
  assert(value > sum && value < 1.5 * sum);
  assert(forecast(source, std::numeric_limits<double>::infinity(), 20000) > 0.9 * sum);

  const auto invalid = [](const Coordinates& p, const int) { return p[0] < 0.4 ? 0.1 : -1; };
  assert(forecast(invalid, 1, 1000) >= 0); // it comes to an end

  // of many tetrahedra, those are cut that matter most, in whatever order they come
  std::vector<Tetrahedron> many;
  for(int k = 0; k < 1000; ++k)
    for(const Tetrahedron& t : tetrahedra_of_cube({{ k % 10 / 10., k / 10 % 10 / 10., k / 100 / 10. }}, 0.1))
      many.push_back(t);
  const double of_many = forecast(source, 0.2, 1000, many);
  std::shuffle(many.begin(), many.end(), std::mt19937(7));
  assert(std::abs(forecast(source, 0.2, 1000, many) / of_many - 1) < 1e-9);
  assert(std::abs(of_many / forecast(source, 0.2, 0, many) - 1) > 1e-3); // the cuts tell something
}

// Sizes grow away from a corner.
struct Cone
{
  double operator()(const Point& p) const { return 0.1 + 0.4 * std::sqrt(CGAL::squared_distance(p, Point(1, 0, 0))); }
  double grading() const { return 0.4; }
};

void test_region_sizes()
{
  std::mt19937 rng(5);
  Tr tr;
  insert_random_points(tr, 200, rng);
  int k = 0;
  std::vector<Tr::Cell_handle> cells;
  for(const auto c : tr.finite_cell_handles())
  {
    c->set_subdomain_index(1 + k++ % 3);
    cells.push_back(c);
  }

  const Cone cone;
  const internal::Any_size_field_3<K, Cone> any_cone(cone);
  internal::Region_sizes_3<Tr> sizes(tr, any_cone);
  assert(sizes.ask_at_vertices(cells) && sizes.grading() == 0.4);
  for(const auto c : cells)
  {
    const Tetrahedron t = internal::corners(c);
    const Coordinates center = internal::centroid(t);
    const double least = sizes.least_size_at_centroid(c, t);
    const double size = cone(point(center));
    assert(least > 0 && least <= size && sizes(center, c).asked == size && sizes(center, c).possible == size);
    assert(sizes.likely_size_at_centroid(c, t, 0.4) >= size);
  }

  // At vertices of several regions, the smallest size counts.
  const auto by_region = [](const Point&, const int dimension, const int region)
  {
    assert(dimension == 3);
    return 0.1 * region;
  };
  const internal::Any_size_field_3<K, decltype(by_region)> any_by_region(by_region);
  internal::Region_sizes_3<Tr> regions(tr, any_by_region);
  assert(regions.ask_at_vertices(cells));
  std::map<Tr::Vertex_handle, double> smallest;
  for(const auto c : cells)
    for(int i = 0; i < 4; ++i)
    {
      const auto it = smallest.emplace(c->vertex(i), 1).first;
      it->second = (std::min)(it->second, 0.1 * c->subdomain_index());
    }
  for(const auto& s : smallest)
    assert(s.first->meshing_info() == s.second);
  for(const auto c : cells)
    assert(regions.least_size_at_centroid(c, internal::corners(c)) == 0); // nothing is known between the vertices

  const double number = 0.25;
  const internal::Any_size_field_3<K, double> any_number(number);
  internal::Region_sizes_3<Tr> numbers(tr, any_number);
  assert(numbers.ask_at_vertices(cells));
  assert(numbers.least_size_at_centroid(cells[0], internal::corners(cells[0])) == 0.25);
  assert(numbers.likely_size_at_centroid(cells[0], internal::corners(cells[0]), 0) == 0.25);

  const auto bad = [](const Point& p) { return p.x() - 0.5; };
  const internal::Any_size_field_3<K, decltype(bad)> any_bad(bad);
  internal::Region_sizes_3<Tr> invalid(tr, any_bad);
  assert(! invalid.ask_at_vertices(cells) && ! invalid.is_valid());
  assert(invalid.query().invalid_size().size == invalid.query().invalid_size().point.x() - 0.5);
}

// A limit of the address space that leaves about 100 MB.
void test_available_memory()
{
  const std::size_t before = internal::available_memory();
  assert(before > 0);
  const std::size_t size = 1024 * internal::number_in_file("/proc/self/status", "VmSize:");
  if(size > (std::size_t(1) << 40)) // sanitizers take terabytes
    return;
  rlimit old_limit;
  assert(getrlimit(RLIMIT_AS, &old_limit) == 0);
  rlimit limit = old_limit;
  limit.rlim_cur = size + (std::size_t(100) << 20);
  assert(setrlimit(RLIMIT_AS, &limit) == 0);
  const std::size_t left = internal::available_memory();
  assert(setrlimit(RLIMIT_AS, &old_limit) == 0);
  assert(left <= (std::size_t(100) << 20) && left > (std::size_t(10) << 20));
  assert(internal::number_in_file("/nowhere/at/all", "x") == (std::numeric_limits<std::size_t>::max)());
}

int main()
{
  test_local_vertices();
  test_vertex_sizes<Tr>();
  test_vertex_sizes<Plain_tr>();
  test_circumsphere();
  test_forecast();
  test_region_sizes();
  test_available_memory();
  return EXIT_SUCCESS;
}
