// Qualities and angles of tetrahedra against plain geometry: shapes from regular to flat, in units from tiny to huge.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "plain_angles_br3.h"
#include "random_numbers_br3.h"

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
using br3_test::Corners;

const double pi = 3.14159265358979323846;
const Corners regular = {{ {{ 1, 1, 1 }}, {{ -1, 1, -1 }}, {{ 1, -1, -1 }}, {{ -1, -1, 1 }} }};

bool is_near(const double a, const double b, const double tolerance) { return std::abs(a - b) <= tolerance; }

Corners scaled(Corners p, const double factor)
{
  for(auto& q : p)
    for(double& x : q)
      x *= factor;
  return p;
}

// Of all shapes: some vertices are near to others, or the whole is nearly flat. Positively oriented.
Corners random_corners(std::mt19937& rng)
{
  const double flatness = br3_test::random_int(rng, 2) == 0 ? 1 : std::pow(10., -br3_test::random_int(rng, 6));
  Corners p;
  for(auto& q : p)
    for(int i = 0; i < 3; ++i)
      q[i] = (br3_test::random_int(rng, 2000001) - 1000000) * 1e-6 * (i == 2 ? flatness : 1);
  if(br3_test::random_int(rng, 3) == 0)
    for(int i = 0; i < 3; ++i)
      p[3][i] = p[1][i] + (p[3][i] - p[1][i]) * 0.01;
  if(br3_test::volume_times_6(p) < 0)
    std::swap(p[0], p[1]);
  return p;
}

double plain_dihedral_quality(const Corners& p, const double obtuse_factor)
{
  double smallest = std::numeric_limits<double>::infinity();
  for(const double angle : br3_test::dihedral_angles(p))
    smallest = (std::min)(smallest, std::sin(angle * pi / 180) * (angle > 90 ? obtuse_factor : 1));
  return smallest / (std::sqrt(8.) / 3);
}

double plain_volume_length_quality(const Corners& p)
{
  double sum = 0;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < i; ++j)
      sum += std::pow(br3_test::distance(p[i], p[j]), 2);
  return 6 * std::sqrt(2.) * (br3_test::volume_times_6(p) / 6) / std::pow(sum / 6, 1.5);
}

void test_qualities()
{
  const BR3::Dihedral_angle_quality_3 dihedral, mild(0.7), plain(1);
  const BR3::Volume_length_quality_3 volume_length;
  std::mt19937 rng(1);
  for(int k = 0; k < 20000; ++k)
  {
    Corners p = random_corners(rng);
    const double angle = br3_test::smallest(br3_test::dihedral_angles(p));
    for(const auto& quality : { std::make_pair(dihedral, 0.6), std::make_pair(mild, 0.7), std::make_pair(plain, 1.) })
    {
      const double value = quality.first(p);
      assert(is_near(value, plain_dihedral_quality(p, quality.second), 1e-9));
      assert(value <= quality.first.of_angle(angle) + 1e-9);
    }
    assert(is_near(volume_length(p), plain_volume_length_quality(p), 1e-12));
    assert(volume_length(p) <= volume_length.of_angle(angle) + 1e-9);
    std::swap(p[2], p[3]);
    assert(dihedral(p) < 0 && volume_length(p) < 0);
  }
}

// The best that there is for an angle.
void test_bounds()
{
  const BR3::Dihedral_angle_quality_3 dihedral;
  const BR3::Volume_length_quality_3 volume_length;
  assert(is_near(dihedral(regular), 1, 1e-12) && is_near(volume_length(regular), 1, 1e-12));
  for(const double degrees : { 0., 1., 10., 20., 45., 70.5 })
  {
    // edges of the length 1 and 2 h sin(angle / 2) across each other, see the manual
    const double angle = degrees * pi / 180, h = std::sqrt(2 / (3 - std::cos(angle)));
    const Corners best = {{ {{ -0.5, 0, 0 }}, {{ 0.5, 0, 0 }}, {{ 0, h, 0 }},
                            {{ 0, h * std::cos(angle), h * std::sin(angle) }} }};
    assert(is_near(volume_length(best), volume_length.of_angle(degrees), 1e-12));
    assert(is_near(dihedral.of_angle(degrees), std::sin(angle) * 3 / std::sqrt(8.), 1e-12));
  }
  assert(dihedral.of_angle(80) == dihedral.of_angle(75) && is_near(dihedral.of_angle(75), 1, 1e-12));
  assert(volume_length.of_angle(80) == volume_length.of_angle(75) && is_near(volume_length.of_angle(75), 1, 1e-12));
  assert(dihedral.of_angle(-1) == 0 && volume_length.of_angle(-1) == 0);
}

// Cells that are round enough are good enough, and it is not asked for more than that.
void test_sure_roundness()
{
  using BR3::internal::sure_roundness;
  const double infinity = (std::numeric_limits<double>::infinity)();
  const BR3::Dihedral_angle_quality_3 dihedral, plain(1);
  const BR3::Volume_length_quality_3 volume_length;
  std::mt19937 rng(4);
  int number = 0;
  for(int k = 0; k < 50000; ++k)
  {
    const Corners p = random_corners(rng);
    const double least = br3_test::random_int(rng, 1000) * 0.001;
    for(const auto& quality : { dihedral, plain })
      if(volume_length(p) >= sure_roundness(quality, least))
      {
        ++number;
        assert(quality(p) >= least);
      }
  }
  assert(number > 5000);
  for(const double degrees : { 10., 25., 40. })
    assert(is_near(sure_roundness(plain, plain.of_angle(degrees)), volume_length.of_angle(degrees), 1e-8));
  // the smallest angle decides, and then the largest one, of which 0.6 times the sine counts
  assert(is_near(sure_roundness(dihedral, dihedral.of_angle(25)), volume_length.of_angle(25), 1e-8));
  const double obtuse = pi - std::asin(std::sin(33 * pi / 180) / 0.6);
  assert(is_near(sure_roundness(dihedral, dihedral.of_angle(33)), BR3::internal::largest_roundness(obtuse), 1e-8));
  assert(sure_roundness(dihedral, 0.7) == infinity && sure_roundness(plain, 1.1) == infinity);
  assert(sure_roundness(volume_length, 0.1) == infinity); // nothing is known of it
}

void test_extreme_cells()
{
  const BR3::Dihedral_angle_quality_3 dihedral;
  const BR3::Volume_length_quality_3 volume_length;
  std::mt19937 rng(2);
  for(const int exponent : { -280, -200, -70, -30, -20, -19, 19, 20, 30, 70, 200, 280 })
    for(int k = 0; k < 20; ++k)
    {
      const Corners p = random_corners(rng), q = scaled(p, std::pow(10., exponent));
      assert(is_near(dihedral(q), dihedral(p), 1e-9) && is_near(volume_length(q), volume_length(p), 1e-9));
      const BR3::internal::Cell_angles_3 of_p(p), of_q(q);
      assert(is_near(of_p.smallest(), of_q.smallest(), 1e-7) && is_near(of_p.largest(), of_q.largest(), 1e-7));
      assert(is_near(of_p.radius_ratio(), of_q.radius_ratio(), 1e-9));
    }
  Corners flat = regular, line = regular, point = regular;
  flat[3] = {{ 0, 1, 0 }}; // on an edge
  for(int i = 0; i < 4; ++i)
  {
    line[i] = {{ 1. * i, 2. * i, 3. * i }};
    point[i] = {{ 1, 2, 3 }};
  }
  for(const Corners& p : { flat, line, point })
    assert(is_near(dihedral(p), 0, 1e-12) && is_near(volume_length(p), 0, 1e-12));
  const BR3::internal::Cell_angles_3 of_flat(flat);
  assert(of_flat.smallest() == 0 && of_flat.largest() == 180 && of_flat.radius_ratio() == 0);
  const double infinity = (std::numeric_limits<double>::infinity)();
  assert(of_flat.square_of_largest_cotangent() == infinity && of_flat.square_of_smallest_cotangent() == - infinity);
  for(const Corners& p : { line, point })
    assert(! (BR3::internal::Cell_angles_3(p).square_of_largest_cotangent() <= infinity)); // no number
}

// One that knows nothing of two cells at once.
struct Plain_quality
{
  double operator()(const Corners& p) const { return br3_test::distance(p[0], p[1]); }
};

// Also whether the result is negative zero.
bool is_same(const double a, const double b) { return a == b && std::signbit(a) == std::signbit(b); }

template <typename Quality>
void check_pair(const Quality& quality, const Corners& p, const Corners& q)
{
  const std::array<double, 2> qualities = BR3::internal::qualities_of_two_cells(quality, p, q);
  assert(is_same(qualities[0], quality(p)) && is_same(qualities[1], quality(q)));
}

// Random, mostly of an ordinary size; or tiny, huge, inverted, without a volume, or without an area.
Corners random_extreme_corners(std::mt19937& rng)
{
  static const int exponents[] = { -200, -20, 0, 0, 0, 0, 20, 150 };
  Corners p = scaled(random_corners(rng), std::pow(10., exponents[br3_test::random_int(rng, 8)]));
  switch(br3_test::random_int(rng, 8))
  {
  case 0: p[3] = p[2]; break;
  case 1: p[1] = p[2] = p[3]; break;
  case 2: for(auto& q : p) q[2] = 0; break;
  case 3: std::swap(p[0], p[1]); break;
  }
  return p;
}

void test_two_cells()
{
  using BR3::internal::Has_quality_of_two_cells;
  static_assert(Has_quality_of_two_cells<BR3::Dihedral_angle_quality_3>::value, "two cells at once");
  static_assert(! Has_quality_of_two_cells<Plain_quality>::value, "one after the other");
  std::mt19937 rng(5);
  for(int k = 0; k < 50000; ++k)
  {
    const Corners p = random_extreme_corners(rng), q = random_extreme_corners(rng);
    for(const double factor : { 0., 0.6, 1. })
      check_pair(BR3::Dihedral_angle_quality_3(factor), p, q);
    check_pair(BR3::Volume_length_quality_3(), p, q);
    check_pair(Plain_quality(), p, q);
  }
}

// All are visited in order, those of an odd number, too, until the visitor has enough.
void test_visits()
{
  const BR3::Dihedral_angle_quality_3 quality;
  std::mt19937 rng(6);
  std::vector<Corners> cells;
  for(std::size_t number = 0; number < 6; ++number, cells.push_back(random_corners(rng)))
    for(std::size_t last = 1; last <= number + 1; ++last)
    {
      std::size_t k = 0;
      const auto visit = [&](const Corners& p, const double q)
      {
        assert(&p == &cells[k] && q == quality(p));
        return ++k != last;
      };
      const auto corners = [](const Corners& p) { return p; };
      const bool is_complete = BR3::internal::visit_qualities(quality, cells, corners, visit);
      assert(is_complete == (last > number) && k == (std::min)(last, number));
    }
}

void test_angles()
{
  std::mt19937 rng(3);
  for(int k = 0; k < 20000; ++k)
  {
    const Corners p = random_corners(rng);
    const BR3::internal::Cell_angles_3 angles(p);
    const std::array<double, 6> expected = br3_test::dihedral_angles(p);
    for(int i = 0; i < 6; ++i)
      assert(is_near(angles[i], expected[i], 1e-7));
    assert(is_near(angles.smallest(), br3_test::smallest(expected), 1e-7));
    assert(is_near(angles.largest(), br3_test::largest(expected), 1e-7));
    assert(angles.smallest() == angles[angles.edge_of_smallest()]);
    assert(angles.largest() == angles[angles.edge_of_largest()]);
    for(const double degrees : { 0., 1e-3, 5., 30., 60., 90., 135., 179., 180. })
    {
      const double square = BR3::internal::signed_square_of_cotangent(degrees);
      assert((angles.square_of_largest_cotangent() > square) == (angles.smallest() < degrees));
      assert((angles.square_of_smallest_cotangent() < square) == (angles.largest() > degrees));
    }
    assert(is_near(angles.radius_ratio(), br3_test::radius_ratio(p), 1e-9));
    const std::array<std::array<double, 3>, 3> triangle = {{ p[0], p[1], p[2] }};
    assert(is_near(BR3::internal::smallest_plane_angle(triangle), br3_test::smallest_plane_angle(triangle), 1e-7));
  }
  assert(is_near(BR3::internal::Cell_angles_3(regular).radius_ratio(), 1, 1e-12));
}

int main()
{
  test_qualities();
  test_bounds();
  test_sure_roundness();
  test_extreme_cells();
  test_two_cells();
  test_visits();
  test_angles();
  std::cout << "qualities are right" << std::endl;
}
