// Smoothing of both kinds, contraction and insertion, led by quality, on random constrained meshes, judged after each
// step; where the best point is, which vertices are free, which edge is contracted, and which lengths are allowed,
// against slow references.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "improvement_judge_br3.h"

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Allowed_lengths_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Best_point_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Contract_bad_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Places_near_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Star_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;
using br3_test::Improvement_options;
using br3_test::Lengths_slack;
typedef CGAL::Exact_predicates_inexact_constructions_kernel     Kernel;
typedef br3_test::Improvement_scene<Kernel>                     Scene;
typedef Scene::Tr                                               Tr;
typedef Scene::Vertex_handle                                    Vertex_handle;
typedef Scene::Cell_handle                                      Cell_handle;

struct Quality
{
  bool is_random = false;

  double operator()(const std::array<std::array<double, 3>, 4>& corners) const
  {
    return is_random ? br3_test::random_quality(corners) : BR3::Dihedral_angle_quality_3()(corners);
  }
};

typedef br3_test::Improvement_trial<Scene, Quality>   Trial;
typedef Trial::Mesh                                   Mesh;
typedef internal::Best_point_in_star_3<Quality>       Best_point;
typedef internal::Bad_cells_3<Mesh>::Bad_cell         Bad_cell;
typedef internal::Coordinates_3                       Place;

struct Improvement
  : public Trial
{
  Improvement(const unsigned seed, const Improvement_options& options, const double degrees,
              const bool is_random = false)
    : Trial(seed, options, Quality{ is_random }, is_random ? 0.9 : BR3::Dihedral_angle_quality_3().of_angle(degrees))
  { }
};

// From now on, new cells may be worse than those that go, but not worse than one in twenty of the mesh.
void be_lenient(Improvement& t)
{
  std::vector<double> qualities;
  for(const Cell_handle c : t.scene.cells())
    if(t.scene.contains(c))
      qualities.push_back(t.mesh.quality(c));
  std::sort(qualities.begin(), qualities.end());
  t.mesh.set_measure_of_badness(internal::Badness_3(t.mesh.enough(), qualities[qualities.size() / 20]));
}

// How many vertices were inserted, and how many went for them.
struct Insertions
{
  int number = 0;
  std::size_t number_of_removed_vertices = 0;
};

// Vertices are inserted as `attempt` does it.
template <typename Insert, typename Attempt>
void test_insertion(Improvement& t, const Insert& insert, const Attempt& attempt, const double size,
                    Insertions& insertions, const double tolerated_loss = 0)
{
  const std::set<Vertex_handle> before(t.scene.tr.finite_vertex_handles().begin(),
                                       t.scene.tr.finite_vertex_handles().end());
  const auto counted_attempt = [&](const Cell_handle c)
  {
    const std::size_t number = t.scene.tr.number_of_vertices();
    if(! attempt(c))
      return false;
    BR3::Quality_improvement_counts counts;
    insert.count(counts);
    assert(counts.number_of_inserted_points == 1);
    assert(t.scene.tr.number_of_vertices() + counts.number_of_removed_vertices == number + 1);
    insertions.number_of_removed_vertices += counts.number_of_removed_vertices;
    return true;
  };
  insertions.number += try_on_all_cells(t.scene, t.mesh, Lengths_slack::longest_edge, counted_attempt, tolerated_loss);
  for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
  {
    assert(before.count(v) > 0 || v->in_dimension() == 3);
    assert(v->meshing_info() >= size && v->meshing_info() <= 2 * size);
  }
}

void test_insertion_near_cells(Improvement& t, const double size, Insertions& insertions)
{
  internal::Insert_near_bad_cell_3<Mesh> insert(t.mesh);
  const auto attempt = [&](const Cell_handle c) { return insert.find(c) && insert.apply(); };
  test_insertion(t, insert, attempt, size, insertions);
}

// At any place that is good enough, not at the best one.
void test_insertion_anywhere_near_cells(Improvement& t, const double size, Insertions& insertions)
{
  const double tolerated_loss = 0.5;
  CGAL::Random random(7);
  internal::Insert_near_bad_cell_3<Mesh> insert(t.mesh);
  const auto attempt = [&](const Cell_handle c)
  {
    return insert.find_any(c, tolerated_loss, random) && insert.apply();
  };
  test_insertion(t, insert, attempt, size, insertions, tolerated_loss);
}

// What was done on random meshes.
struct Steps
{
  int number_of_moved_vertices = 0;
  int number_of_contractions = 0;
  Insertions into_cells, near_cells, anywhere_near_cells;
};

void test_all_steps(const unsigned seed, const bool is_lenient, Steps& steps)
{
  Improvement_options options;
  options.is_grid = seed % 4 == 0;
  options.size = seed % 3 == 0 ? 0.06 : seed % 3 == 1 ? 0.4 : 0;
  options.number_of_points = seed % 5 == 0 ? 60 : 120;
  const double degrees = 10 + seed % 4 * 10;
  const auto on_mesh = [&](const auto& test)
  {
    Improvement t(seed, options, degrees, seed % 5 == 4);
    if(is_lenient)
      be_lenient(t);
    test(t);
  };
  on_mesh([&](Improvement& t)
  {
    internal::Smooth_vertex_3<Mesh> smooth(t.mesh);
    for(int i = 0; i < 4; ++i)
      steps.number_of_moved_vertices += try_on_all_cells(t.scene, t.mesh, Lengths_slack::none, [&](const Cell_handle c)
                                                         { return smooth(c->vertex(i)); });
  });
  on_mesh([&](Improvement& t)
  {
    internal::Contract_bad_edge_3<Mesh> contract(t.mesh);
    for(int i = 0; i < 4; ++i)
      steps.number_of_contractions += try_on_all_cells(t.scene, t.mesh, Lengths_slack::none, [&](const Cell_handle c)
                                                       { return contract.find(c->vertex(i), 0) && contract.apply(); });
  });
  on_mesh([&](Improvement& t)
  {
    internal::Insert_into_bad_cell_3<Mesh> insert(t.mesh);
    const auto attempt = [&](const Cell_handle c) { return insert.find(c) && insert.apply(); };
    test_insertion(t, insert, attempt, options.size, steps.into_cells);
  });
  on_mesh([&](Improvement& t) { test_insertion_near_cells(t, options.size, steps.near_cells); });
  on_mesh([&](Improvement& t) { test_insertion_anywhere_near_cells(t, options.size, steps.anywhere_near_cells); });
}

// How bad the cells of a cavity are, and the new ones with the vertex at this place, and at the best one.
void check_account(Improvement& t, internal::Star_cavity_3<Mesh> cavity, const Place& p)
{
  double badness = 0, of_star = 0;
  for(const Cell_handle c : cavity.cells())
    badness += t.mesh.badness(t.mesh.quality(c));
  for(const auto& f : cavity.faces())
  {
    assert(f.quality == t.mesh.quality(f.vertices, p));
    of_star += t.mesh.badness(f.quality);
  }
  assert(std::abs(cavity.badness() - badness) < 1e-9);
  assert(std::abs(cavity.gain() - (badness - of_star)) < 1e-9);
  const double gain = cavity.gain();
  double worst = 2;
  const double told_worst = cavity.move_point();
  for(const auto& f : cavity.faces())
    worst = (std::min)(worst, f.quality);
  assert(told_worst == worst && cavity.gain() >= gain);
}

void take_in_some(Scene& scene, internal::Star_cavity_3<Mesh>& cavity)
{
  for(int step = 0; step < 12; ++step)
  {
    const auto& f = cavity.faces()[static_cast<std::size_t>(scene.random_int(int(cavity.faces().size())))];
    if(! cavity.is_wall(f))
      cavity.take_in(f.cell->neighbor(f.index));
  }
  if(cavity.cells().size() > 3)
    cavity.go_back_to(cavity.cells().size() - 2);
}

// All cells at a vertex of the cavity that are not behind a wall.
void take_in_all_around(const Vertex_handle v, internal::Star_cavity_3<Mesh>& cavity)
{
  while(true)
  {
    const auto it = std::find_if(cavity.faces().begin(), cavity.faces().end(), [&](const auto& f)
                                 { return internal::contains(f.vertices, v) && ! cavity.is_wall(f); });
    if(it == cavity.faces().end())
      return;
    cavity.take_in(it->cell->neighbor(it->index));
  }
}

// A cavity knows its faces and its worst cell, also after cells were taken out again; and whether all of its vertices
// are on its boundary, or free.
void test_star_cavities()
{
  Improvement_options options;
  options.number_of_points = 80;
  Improvement t(3, options, 30);
  internal::Star_cavity_3<Mesh> cavity(t.mesh);
  const br3_test::Improvement_judge<Scene, Mesh> judge(t.scene, t.mesh);
  std::array<int, 2> number = {{ 0, 0 }};
  std::size_t number_inside = 0;
  int number_of_cells = 0;
  for(const Cell_handle c : t.scene.cells())
  {
    if(! t.scene.contains(c))
      continue;
    cavity.start(c, internal::centroid(internal::corners(c)));
    if(++number_of_cells % 2 == 0)
      take_in_all_around(c->vertex(number_of_cells % 4), cavity);
    else
      take_in_some(t.scene, cavity);
    const std::set<Cell_handle> cells(cavity.cells().begin(), cavity.cells().end());
    std::set<Vertex_handle> vertices, outside;
    std::size_t number_of_faces = 0;
    double worst = 2;
    bool is_wall_inside = false;
    for(const Cell_handle d : cells)
    {
      worst = (std::min)(worst, t.mesh.quality(d));
      for(int i = 0; i < 4; ++i)
      {
        vertices.insert(d->vertex(i));
        if(cells.count(d->neighbor(i)) > 0)
          is_wall_inside = is_wall_inside || t.domain.is_wall(d, i);
        else
          ++number_of_faces;
      }
    }
    for(const auto& f : cavity.faces())
    {
      assert(cells.count(f.cell) > 0 && cells.count(f.cell->neighbor(f.index)) == 0);
      outside.insert(f.vertices.begin(), f.vertices.end());
    }
    assert(cavity.faces().size() == number_of_faces && cavity.worst_quality() == worst);
    check_account(t, cavity, internal::centroid(internal::corners(c)));
    const bool is_possible = cavity.has_only_free_vertices_inside();
    ++number[is_possible];
    if(! is_possible)
      continue;
    assert(! is_wall_inside && 2 * outside.size() == cavity.faces().size() + 4);
    assert(vertices.size() == outside.size() + cavity.number_of_vertices_inside());
    number_inside += cavity.number_of_vertices_inside();
    for(const Vertex_handle v : vertices)
      assert(outside.count(v) > 0 || judge.is_free(v));
  }
  std::cout << number[1] << " of " << number[0] + number[1] << " cavities, " << number_inside << " vertices inside"
            << std::endl;
  assert(number[0] > 5 && number[1] > 50 && number_inside > 0);
}

// How round the cells of the mesh at a vertex are together.
double roundness_at(const Scene& scene, const Vertex_handle v)
{
  double sum = 0;
  for(const Cell_handle c : scene.tr.finite_cell_handles())
    if(c->has_vertex(v))
      sum += BR3::Volume_length_quality_3()(internal::corners(c));
  return sum;
}

// Vertices go where cells are rounder, as the judge allows. Returns how many did.
int test_centered_vertices(const unsigned seed)
{
  Improvement_options options;
  options.size = seed % 3 == 0 ? 0.06 : seed % 3 == 1 ? 0.16 : 0;
  options.number_of_points = 120;
  Improvement t(seed, options, 10 + seed % 4 * 15, seed == 5);
  internal::Center_vertex_3<Mesh> center(t.mesh);
  int vertex = 0;
  return try_on_all_cells(t.scene, t.mesh, Lengths_slack::none, [&](const Cell_handle c)
  {
    const Vertex_handle v = c->vertex(++vertex % 4);
    const double before = roundness_at(t.scene, v);
    const bool is_moved = center(v);
    assert(! is_moved || roundness_at(t.scene, v) > before);
    return is_moved;
  });
}

// ------------------------------------------------ where vertices are inserted near a cell

double smallest_angle(const std::array<Place, 4>& corners) { return internal::Cell_angles_3(corners).smallest(); }

// The smaller one of the smallest angles, in degrees, of the cells between a point and two thin triangles, the ones at
// a long edge, whose short edges are at different ends.
double smallest_angle_between_needles(const Place& p, const double length)
{
  const Place a = {{ 0, 0, 0 }}, b = {{ 0, 0, length }}, left = {{ -1, 0, 0.01 * length }},
              right = {{ 1, 0, 0.99 * length }};
  return (std::min)(smallest_angle({{ a, b, left, p }}),
                    smallest_angle({{ b, a, right, p }}));
}

// A thin triangle in the wall y = 0, and a vertex that is far away, for its width.
std::array<Place, 4> cell_at_needle(const double length, const double third)
{
  return {{ {{ 0, 0, 0 }}, {{ 0, 0, length }}, {{ 1, 0, third }}, {{ 0.5, 0.3 * length, 0.5 * length }} }};
}

// One of the places near a cell at a thin triangle is such that both cells at the long edge are as good as one vertex
// can make them; none is where nothing can be.
void test_places_near_cells()
{
  internal::Places_near_cell_3 places_near;
  for(const double length : { 8., 10., 16., 20. })
  {
    double best = 0;
    for(const Place& q : places_near(cell_at_needle(length, 0.99 * length)))
      if(q[1] > 0)
        best = (std::max)(best, smallest_angle_between_needles(q, length));
    assert(best * length > 145);
  }
  // beside the middle of the long edge, unless it is so long that places beside it are few and far between
  for(const double ratio : { 100., 127., 129., 1000. })
  {
    const double length = ratio * std::sqrt(2.);
    const auto& places = places_near(cell_at_needle(length, length - 1));
    const bool is_beside = std::any_of(places.begin(), places.end(), [&](const Place& q)
    {
      return q[1] > 0 && q[1] < 3 && std::abs(q[2] - 0.5 * length) < 0.1 * length;
    });
    assert(is_beside == (ratio < 128));
  }
  // without length, or without area
  const Place a = {{ 0, 0, 0 }}, b = {{ 1, 0, 0 }}, c = {{ 0, 1, 0 }};
  assert(places_near({{ a, b, c, a }}).empty());
  for(const Place& q : places_near({{ a, b, {{ 2, 0, 0 }}, {{ 8, 0, 0 }} }}))
    assert(q[1] == 0 && q[2] == 0 && q[0] > 0 && q[0] < 8);
}

// Two triangles of a wall, and the flat cell between them that has both: a vertex at one of the places near it makes
// good cells with both, without longer edges.
void test_places_above_flat_cells()
{
  internal::Places_near_cell_3 places_near;
  for(const double depth : { 0., 0.01, 0.1 })
    for(const double width : { 0.4, 0.6, 1. })
    {
      const Place a = {{ 0, 0, 0 }}, b = {{ 1, 0, 0 }};
      const Place left = {{ 0.4, width, depth }}, right = {{ 0.6, -width, depth }};
      const std::array<Place, 4> cell = {{ a, b, left, right }};
      const double longest = (std::max)(internal::distance(a, b), internal::distance(left, right));
      double best = 0;
      for(const Place& q : places_near(cell))
        if(q[2] > 0 && std::all_of(cell.begin(), cell.end(),
                                   [&](const Place& p) { return internal::distance(p, q) <= longest; }))
          best = (std::max)(best, (std::min)(smallest_angle({{ a, b, left, q }}),
                                             smallest_angle({{ b, a, right, q }})));
      assert(best > 25);
    }
}

// A facet that the center of a cell's neighbor is behind leads there; none does from the center of the cell itself. If
// it is excluded, the point is behind another one, or behind none.
void test_steps_towards_points()
{
  Improvement t(3, Improvement_options(), 30);
  int number = 0;
  for(const Cell_handle c : t.scene.tr.finite_cell_handles())
  {
    assert(internal::facet_towards(c, internal::centroid(internal::corners(c))) < 0);
    for(int i = 0; i < 4; ++i)
    {
      if(t.scene.tr.is_infinite(c->neighbor(i)))
        continue;
      const Place q = internal::centroid(internal::corners(c->neighbor(i)));
      const int first = internal::facet_towards(c, q);
      const int other = internal::facet_towards(c, q, [&](const int k) { return k != first; });
      const auto volume = [&](const int k) { return internal::volume_times_6_with(internal::corners(c), k, q); };
      assert(first >= 0 && volume(first) <= volume(i) && volume(i) < 0 && other != first);
      assert(other < 0 || (volume(other) < 0 && volume(first) <= volume(other)));
      number += other >= 0;
    }
  }
  assert(number > 50);
}

// ------------------------------------------------ which vertices are free, and where they go

void test_free_vertices()
{
  std::array<int, 2> number = {{ 0, 0 }};
  for(unsigned seed = 0; seed < 8; ++seed)
  {
    Improvement_options options;
    options.is_grid = seed == 7;
    options.number_of_points = 80;
    Improvement t(seed, options, 30);
    const br3_test::Improvement_judge<Scene, Mesh> judge(t.scene, t.mesh);
    internal::Free_star_3<Mesh> star(t.mesh);
    for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
    {
      const bool is_free = judge.is_free(v);
      ++number[is_free];
      assert(star.collect(v) == is_free);
      if(! is_free)
        continue;
      std::set<Cell_handle> cells(star.cells().begin(), star.cells().end());
      std::set<Vertex_handle> neighbors(star.neighbors().begin(), star.neighbors().end()), expected;
      assert(cells.size() == star.cells().size() && neighbors.size() == star.neighbors().size());
      for(const Cell_handle c : t.scene.cells())
      {
        assert((cells.count(c) > 0) == c->has_vertex(v));
        for(int i = 0; i < 4; ++i)
          if(c->has_vertex(v) && c->vertex(i) != v)
            expected.insert(c->vertex(i));
      }
      assert(neighbors == expected);
    }
  }
  assert(number[0] > 50 && number[1] > 20);
}

// A vertex of very many cells is left alone: here, between two poles and the vertices of a polygon.
bool is_free_inside_of_polygon(const int number_of_corners)
{
  Improvement_options options;
  options.has_walls = false;
  Improvement t(1, options, 30);
  const Vertex_handle v = t.scene.make_vertex_inside_of_polygon(number_of_corners);
  const Tr& tr = t.scene.tr;
  assert(tr.degree(v) == std::size_t(number_of_corners) + 2);
  const bool is_free = internal::Free_star_3<Mesh>(t.mesh).collect(v);
  for(const Cell_handle c : tr.all_cell_handles())
    assert(c->tds_data().is_clear());
  return is_free;
}

struct Star_of_point
{
  const std::vector<Best_point::Face>& faces;
  double enough;

  // How bad the cells are, and the worst one.
  std::pair<double, double> operator()(const Place& p) const
  {
    double sum = 0, worst = 2;
    for(const auto& f : faces)
    {
      const double q = Quality()({{ f[0], f[1], f[2], p }});
      worst = (std::min)(worst, q);
      sum += q < enough ? std::pow(1 - q / enough, 3) : 0;
    }
    return { sum, worst };
  }
};

// The least badness of a grid of points; of those that make no cell worse than the worst one at `p`.
double best_of_grid(const Star_of_point& star, const Place& p)
{
  const int n = 12;
  Place low = p, high = p;
  for(const auto& f : star.faces)
    for(const auto& q : f)
      for(int j = 0; j < 3; ++j)
      {
        low[j] = (std::min)(low[j], q[j]);
        high[j] = (std::max)(high[j], q[j]);
      }
  auto best = star(p);
  const double worst = best.second;
  for(int k = 0; k < n * n * n; ++k)
  {
    const std::array<int, 3> at = {{ k % n, k / n % n, k / n / n }};
    Place q;
    for(int j = 0; j < 3; ++j)
      q[j] = low[j] + (high[j] - low[j]) * (at[j] + 0.5) / n;
    const auto there = star(q);
    if(there.second >= worst && there.first < best.first)
      best.first = there.first;
  }
  return best.first;
}

// Smooths a vertex whose best point takes this part of the badness away: that is done if it is worth it.
void check_smoothing(Improvement& t, const Vertex_handle v, const double gain)
{
  internal::Smooth_vertex_3<Mesh> smooth(t.mesh);
  const Place before = Mesh::coordinates(v);
  const bool is_moved = smooth(v);
  assert(is_moved == (Mesh::coordinates(v) != before));
  assert(is_moved == (gain >= 0.02));
}

// With the point where it was left.
double worst_quality(const Best_point& best_point)
{
  assert(best_point.qualities().size() == best_point.number_of_faces());
  return *std::min_element(best_point.qualities().begin(), best_point.qualities().end());
}

void test_best_points()
{
  double possible = 0, reached = 0;
  int number = 0, moved = 0;
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    Improvement_options options;
    options.number_of_points = 80;
    options.has_walls = false;
    Improvement t(seed, options, 40);
    internal::Free_star_3<Mesh> star(t.mesh);
    Best_point best_point(t.quality);
    for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
    {
      if(! star.collect(v))
        continue;
      std::vector<Best_point::Face> faces;
      best_point.clear(t.mesh.enough());
      for(const auto& f : star.faces())
      {
        faces.push_back({{ Mesh::coordinates(f[0]), Mesh::coordinates(f[1]), Mesh::coordinates(f[2]) }});
        best_point.add(faces.back());
      }
      assert(best_point.number_of_faces() == faces.size());
      const Star_of_point of_point = { faces, t.mesh.enough() };
      const Place before = Mesh::coordinates(v);
      Place p = before;
      assert(best_point.improve(p, [](const Place&) { return false; }) == 0 && p == before);
      assert(worst_quality(best_point) == of_point(p).second);
      const double gain = best_point.improve(p, [](const Place&) { return true; });
      assert(worst_quality(best_point) == of_point(p).second);
      const bool is_moved = p != before;
      const double expected_gain = is_moved ? 1 - of_point(p).first / of_point(before).first : 0;
      assert(std::abs(gain - expected_gain) < 1e-12);
      assert(of_point(p).second >= of_point(before).second);
      assert(is_moved ? of_point(p).first < of_point(before).first : p == before);
      possible += of_point(before).first - best_of_grid(of_point, before);
      reached += of_point(before).first - of_point(p).first;
      ++number;
      moved += is_moved;

      // only where it is allowed to go; not at all; not if all is well
      Place q = before;
      best_point.improve(q, [&](const Place& x) { return x[0] <= before[0]; });
      assert(q[0] <= before[0]);
      q = before;
      assert(! best_point.improve(q, [](const Place&) { return false; }) && q == before);
      best_point.clear(of_point(before).second * 0.999);
      for(const auto& f : faces)
        best_point.add(f);
      if(of_point(before).second > 0)
        assert(! best_point.improve(q, [](const Place&) { return true; }) && q == before);
      check_smoothing(t, v, gain);
    }
  }
  std::cout << "smoothing: " << number << " vertices, " << moved << " moved; reached " << reached / possible
            << " of what a grid does" << std::endl;
  assert(number > 50 && moved > number / 2);
  assert(reached > 0.75 * possible);
}

// ------------------------------------------------ which edge is contracted

void test_contraction()
{
  std::array<int, 2> number = {{ 0, 0 }};
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    Improvement_options options;
    options.number_of_points = 100;
    options.is_grid = seed == 3;
    options.size = seed % 2 == 1 ? 0.1 : 0;
    Improvement t(seed, options, 30);
    internal::Contract_bad_edge_3<Mesh> contract(t.mesh);
    internal::Free_star_3<Mesh> star(t.mesh);
    for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
    {
      if(! star.collect(v))
      {
        assert(! contract.find(v, 0));
        continue;
      }
      double before = 0, worst_before = 2, best = std::numeric_limits<double>::infinity();
      for(const Cell_handle c : star.cells())
      {
        before += t.mesh.badness(t.mesh.quality(c));
        worst_before = (std::min)(worst_before, t.mesh.quality(c));
      }
      const std::vector<Vertex_handle> neighbors = star.neighbors();
      for(const Vertex_handle u : neighbors)
      {
        double sum = 0, worst = 2;
        bool is_possible = true;
        for(const auto& f : star.faces())
          if(std::find(f.begin(), f.end(), u) == f.end())
          {
            const double q = t.mesh.quality({{ Mesh::coordinates(f[0]), Mesh::coordinates(f[1]),
                                               Mesh::coordinates(f[2]), Mesh::coordinates(u) }});
            sum += t.mesh.badness(q);
            worst = (std::min)(worst, q);
          }
        for(const Vertex_handle w : neighbors)
        {
          const double length = std::sqrt(CGAL::to_double(CGAL::squared_distance(u->point(), w->point())));
          const bool is_short = options.size == 0 || length <= u->meshing_info() + w->meshing_info();
          is_possible = is_possible && (w == u || t.scene.tr.tds().is_edge(u, w)
                                        || (is_short && t.mesh.is_edge_in_size(u, w)));
        }
        if(is_possible && worst >= worst_before)
          best = (std::min)(best, sum);
      }
      const bool is_found = contract.find(v, 0);
      ++number[is_found];
      if(is_found)
        assert(std::abs(contract.gain() - (before - best)) < 1e-12);
      else
        assert(! (best < before - 1e-12));
    }
  }
  std::cout << number[1] << " edges can be contracted, " << number[0] << " vertices stay" << std::endl;
  assert(number[0] > 20 && number[1] > 10);
}

// ------------------------------------------------ which lengths are allowed

// What a constraint allows, spread by going over all edges again and again.
internal::Allowed_lengths_3<Tr> allowed_lengths(const Improvement& t)
{
  internal::Allowed_lengths_3<Tr> lengths(t.scene.tr);
  for(const Cell_handle c : t.scene.cells())
    if(t.scene.contains(c))
      lengths.add(t.domain, c);
  lengths.spread([] { return true; });
  return lengths;
}

void test_allowed_lengths()
{
  int number_of_spread = 0;
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    Improvement_options options;
    options.size = 0.2;
    options.number_of_points = 150;
    Improvement t(seed + 30, options, 30);
    const internal::Allowed_lengths_3<Tr> lengths = allowed_lengths(t);
    std::map<Vertex_handle, std::array<double, 2> > known;
    const double infinity = std::numeric_limits<double>::infinity();
    for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
      known[v] = {{ infinity, 0 }};
    const auto distance = [](const Vertex_handle u, const Vertex_handle v)
    {
      return std::sqrt(CGAL::to_double(CGAL::squared_distance(u->point(), v->point())));
    };
    for(const Cell_handle c : t.scene.cells())
      for(int i = 0; i < 4; ++i)
        if(t.scene.contains(c) && t.domain.is_wall(c, i))
          for(int j = 0; j < 4; ++j)
            for(int k = 0; k < 4; ++k)
              if(j != k && j != i && k != i)
              {
                auto& range = known[c->vertex(j)];
                range[0] = (std::min)(range[0], distance(c->vertex(j), c->vertex(k)));
                range[1] = (std::max)(range[1], distance(c->vertex(j), c->vertex(k)));
              }
    const auto before = known;
    for(bool is_changed = true; is_changed; )
    {
      is_changed = false;
      for(const auto& e : t.scene.tr.finite_edges())
        for(int k = 0; k < 2; ++k)
        {
          const Vertex_handle u = e.first->vertex(k == 0 ? e.second : e.third);
          const Vertex_handle v = e.first->vertex(k == 0 ? e.third : e.second);
          const double size_u = u->meshing_info(), size_v = v->meshing_info(), d = distance(u, v);
          auto& at_v = known[v];
          const auto at_u = known[u];
          if(at_u[0] <= 0.5 * size_u && at_u[0] + 0.5 * d < (std::min)(at_v[0], 0.5 * size_v))
          {
            at_v[0] = at_u[0] + 0.5 * d;
            is_changed = true;
          }
          if(at_u[1] >= 2 * size_u && at_u[1] - d > (std::max)(at_v[1], 2 * size_v))
          {
            at_v[1] = at_u[1] - d;
            is_changed = true;
          }
        }
    }
    for(const auto& entry : known)
    {
      number_of_spread += entry.second != before.at(entry.first);
      const double expected = (std::min)(0.5 * entry.first->meshing_info(), entry.second[0]);
      assert(std::abs(lengths.least(entry.first) - expected) < 1e-12);
    }
    for(const auto& e : t.scene.tr.finite_edges())
    {
      const Vertex_handle u = e.first->vertex(e.second), v = e.first->vertex(e.third);
      const double mean = (u->meshing_info() + v->meshing_info()) / 2;
      const auto range = lengths.at(u, v);
      assert(std::abs(range.least - (std::min)({ mean / 2, known[u][0], known[v][0] })) < 1e-12);
      assert(std::abs(range.largest - (std::max)({ mean * 2, known[u][1], known[v][1] })) < 1e-12);
    }
  }
  assert(number_of_spread > 20);
}

// A vertex that comes has nothing of one that went, even if it gets its place in memory.
void test_new_vertex_at_old_place()
{
  Improvement_options options;
  options.size = 0.2;
  Improvement t(0, options, 30);
  internal::Allowed_lengths_3<Tr> lengths = allowed_lengths(t);
  Vertex_handle corner = t.scene.tr.finite_vertices_begin();
  for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
    if(lengths.at(v, v).largest > 2 * v->meshing_info())
      corner = v;
  assert(lengths.at(corner, corner).largest > 2 * corner->meshing_info());
  lengths.set_least(corner, 0.01);
  assert(lengths.at(corner, corner).largest == 2 * corner->meshing_info());
  assert(lengths.at(corner, corner).least == 0.01 && lengths.least(corner) == 0.01);
}

// ------------------------------------------------ the list of bad cells

// From the center of each cell to that of the next one.
double length_of_way(const std::vector<Bad_cell>& cells)
{
  double sum = 0;
  for(std::size_t k = 1; k < cells.size(); ++k)
    sum += internal::distance(internal::centroid(internal::corners(cells[k - 1].cell)),
                              internal::centroid(internal::corners(cells[k].cell)));
  return sum;
}

void test_list_of_bad_cells()
{
  Improvement t(5, Improvement_options(), 30);
  internal::Bad_cells_3<Mesh> bad_cells(t.mesh);
  for(const Cell_handle c : t.scene.cells())
    if(t.scene.contains(c))
      bad_cells.push(c);
  std::set<Cell_handle> expected;
  double badness = 0;
  for(const Cell_handle c : t.scene.cells())
    if(t.scene.contains(c) && t.mesh.quality(c) < t.mesh.enough())
    {
      expected.insert(c);
      badness += t.mesh.badness(t.mesh.quality(c));
      bad_cells.push(c); // a second time
    }
    else
      assert(! bad_cells.contains(c));
  const std::vector<Bad_cell> list = bad_cells.next_round();
  assert(expected.size() > 20 && list.size() == expected.size());
  for(const Bad_cell& c : list)
    assert(expected.erase(c.cell) == 1 && c.quality == t.mesh.quality(c.cell));
  assert(std::abs(bad_cells.badness() - badness) < 1e-9);
  for(std::size_t k = 1; k < list.size(); ++k)
    assert(list[k - 1].quality <= list[k].quality && bad_cells.contains(list[k].cell));
  assert(bad_cells.next_round().empty() && bad_cells.badness() == 0);

  // the same cells in blocks, nearer to each other
  const auto in_blocks = [&](const std::size_t cells_per_block)
  {
    for(const Bad_cell& c : list)
      bad_cells.push(c.cell);
    for(const Bad_cell& c : list)
      bad_cells.put_back(c);
    return bad_cells.next_round_in_blocks(cells_per_block);
  };
  const std::vector<Bad_cell> in_space = in_blocks(1);
  assert(in_space.size() == list.size() && std::abs(bad_cells.badness() - badness) < 1e-9);
  std::set<Cell_handle> cells;
  for(const Bad_cell& c : in_space)
    assert(cells.insert(c.cell).second && bad_cells.contains(c.cell) && c.quality == t.mesh.quality(c.cell));
  assert(length_of_way(in_space) < 0.7 * length_of_way(list));
  for(const std::size_t n : { std::size_t(8), list.size(), list.size() + 1 })
  {
    const std::vector<Bad_cell> blocks = in_blocks(n);
    assert(blocks.size() == list.size());
    for(std::size_t k = 0; k < list.size(); ++k)
    {
      const std::size_t begin = k - k % n, end = (std::min)(begin + n, list.size());
      assert(k == begin || blocks[k - 1].quality <= blocks[k].quality);
      assert(std::count_if(in_space.begin() + begin, in_space.begin() + end,
                           [&](const Bad_cell& c) { return c.cell == blocks[k].cell; }) == 1);
    }
  }

  for(const Bad_cell& c : list)
    assert(c.time == 0);
}

// Cells that are gone are not bad, and it is known where the mesh has changed since a time.
void test_changes()
{
  Improvement_options options;
  options.number_of_points = 120;
  Improvement t(3, options, 30);
  internal::Bad_cells_3<Mesh> bad_cells(t.mesh);
  internal::Vain_attempts_3<Mesh> vain_attempts(t.mesh);
  const std::size_t begin = t.mesh.time();
  for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
  {
    assert(! vain_attempts.contains(v) && ! t.mesh.has_changed(v, begin));
    vain_attempts.add(v);
    assert(vain_attempts.contains(v));
  }
  for(const Cell_handle c : t.scene.cells())
    if(t.scene.contains(c))
      bad_cells.push(c, begin);
  internal::Contract_bad_edge_3<Mesh> contract(t.mesh);
  const std::size_t number_of_cells = t.scene.tr.number_of_cells();
  for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
    if(contract.find(v, 0) && contract.apply())
      break;
  assert(t.scene.tr.number_of_cells() < number_of_cells && t.mesh.time() > begin);
  bad_cells.push_all(contract.new_cells());
  std::set<Vertex_handle> changed;
  for(const Cell_handle c : contract.new_cells())
    for(int i = 0; i < 4; ++i)
      changed.insert(c->vertex(i));
  for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
  {
    assert(t.mesh.has_changed(v, begin) == (changed.count(v) > 0) && ! t.mesh.has_changed(v, t.mesh.time()));
    assert(vain_attempts.contains(v) != t.mesh.has_changed(v, begin));
  }
  int number = 0;
  const std::vector<Bad_cell> cells = bad_cells.next_round();
  for(const Bad_cell& c : cells)
  {
    assert(t.scene.tr.tds().cells().is_used(c.cell) && t.mesh.quality(c.cell) < t.mesh.enough());
    bool is_beside = false;
    for(int i = 0; i < 4; ++i)
      is_beside = is_beside || changed.count(c.cell->vertex(i)) > 0;
    number += is_beside;
    assert(t.mesh.has_changed(c.cell, c.time) == is_beside);
  }
  assert(number > 0 && number < static_cast<int>(cells.size()));

  // what failed need not fail where something else is bad
  for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
    vain_attempts.add(v);
  t.mesh.set_enough(t.mesh.enough() / 2);
  for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
    assert(! vain_attempts.contains(v));
}

// What cells remember of their shape is forgotten where they have such a memory, and nothing else happens.
struct Cell_with_memory
{
  bool has_circumcenter = true, has_quality = true;
  void invalidate_weighted_circumcenter_cache() { has_circumcenter = false; }
  void reset_cache_validity() { has_quality = false; }
};

void test_forgotten_shapes()
{
  Cell_with_memory c;
  internal::forget_shape(c);
  assert(! c.has_circumcenter && ! c.has_quality);
  int without_memory = 1;
  internal::forget_shape(without_memory);
  assert(without_memory == 1);
}

int main()
{
  for(const bool is_lenient : { false, true })
  {
    Steps steps;
    for(unsigned seed = 0; seed < 16; ++seed)
      test_all_steps(seed, is_lenient, steps);
    std::cout << steps.number_of_moved_vertices << " moved, " << steps.number_of_contractions << " contracted, "
              << steps.into_cells.number << " inserted, " << steps.near_cells.number << " near bad cells, "
              << steps.anywhere_near_cells.number << " anywhere, at a loss; "
              << steps.anywhere_near_cells.number_of_removed_vertices << " removed" << std::endl;
    assert(steps.number_of_moved_vertices > 50 && steps.number_of_contractions > 50);
    assert(steps.into_cells.number > 50 && steps.near_cells.number > 50);
    assert(steps.anywhere_near_cells.number > 100);
    assert(steps.anywhere_near_cells.number_of_removed_vertices > 0);
  }
  test_star_cavities();
  test_places_near_cells();
  test_places_above_flat_cells();
  test_steps_towards_points();
  int number_of_centered_vertices = 0;
  for(unsigned seed = 0; seed < 6; ++seed)
    number_of_centered_vertices += test_centered_vertices(seed);
  std::cout << number_of_centered_vertices << " centered" << std::endl;
  assert(number_of_centered_vertices > 50);
  test_free_vertices();
  assert(is_free_inside_of_polygon(20) && ! is_free_inside_of_polygon(200));
  test_forgotten_shapes();
  test_best_points();
  test_contraction();
  test_allowed_lengths();
  test_new_vertex_at_old_place();
  test_list_of_bad_cells();
  test_changes();
}
