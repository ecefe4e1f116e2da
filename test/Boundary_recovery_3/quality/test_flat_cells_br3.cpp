// Vertices that are nearly in the plane of a face of their star, on random constrained meshes, and with very many
// cells. Where kernels are thin, smoothing leaves them there. A layer of vertices at the smallest distance from a wall,
// of which none can move alone. And a cell between two walls that nearly are in a plane. Judged by exact predicates.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "improvement_judge_br3.h"

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Best_point_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Insert_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Move_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;
using br3_test::Improvement_options;
typedef CGAL::Exact_predicates_inexact_constructions_kernel                Kernel;
typedef br3_test::Improvement_scene<Kernel>                                Scene;
typedef Scene::Tr                                                          Tr;
typedef Scene::Vertex_handle                                               Vertex_handle;
typedef Scene::Cell_handle                                                 Cell_handle;
typedef br3_test::Improvement_trial<Scene, BR3::Dihedral_angle_quality_3>  Trial;
typedef Trial::Mesh                                                        Mesh;
typedef internal::Free_star_3<Mesh>                                        Star;
typedef internal::Coordinates_3                                            Place;

const std::size_t any_number = 100000;

struct Improvement
  : public Trial
{
  explicit Improvement(const unsigned seed, const Improvement_options& options)
    : Trial(seed, options, BR3::Dihedral_angle_quality_3(), BR3::Dihedral_angle_quality_3().of_angle(12))
  { }
};

double worst_quality(const Improvement& t, const Star& star, const Place& p)
{
  double worst = 2;
  for(const auto& f : star.faces())
    worst = (std::min)(worst, t.mesh.quality(f, p));
  return worst;
}

// Moves a vertex towards the center of a face of its star as far as possible, but for a small part of the way.
void squeeze(Improvement& t, const Vertex_handle v, const Star& star, const std::size_t face)
{
  Place center = {{ 0, 0, 0 }};
  for(const Vertex_handle u : star.faces()[face])
    for(int j = 0; j < 3; ++j)
      center[j] += Mesh::coordinates(u)[j] / 3;
  const Place start = Mesh::coordinates(v);
  double inside = 0, outside = 1;
  for(int i = 0; i < 40; ++i)
  {
    const double s = (inside + outside) / 2;
    (t.mesh.move(v, internal::point_between(start, center, s), star.cells(), star.faces()) ? inside : outside) = s;
  }
  const Place place = internal::point_between(start, center, inside * (1 - 1e-8));
  const bool is_moved = t.mesh.move(v, place, star.cells(), star.faces());
  assert(is_moved);
}

void assert_positive(const Improvement& t, const Star& star)
{
  for(const Cell_handle c : star.cells())
    assert(t.mesh.is_positive(c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)));
}

// By a power of two, so that no orientation changes.
void flatten(Tr& tr)
{
  for(const Vertex_handle v : tr.finite_vertex_handles())
    v->set_point(Tr::Point(v->point().x(), v->point().y(), std::ldexp(v->point().z(), -14)));
}

struct Numbers
{
  int squeezed = 0, smoothed = 0, deepened = 0, constrained = 0;
};

// How often the worst cell is nearly as good again as it was at first.
void test_vertex(Improvement& t, const Vertex_handle v, Star& star, Numbers& numbers)
{
  internal::Deepen_vertex_3<Mesh> deepen(t.mesh);
  internal::Smooth_vertex_3<Mesh> smooth(t.mesh);
  const Place start = Mesh::coordinates(v);
  if(! star.collect(v))
  {
    ++numbers.constrained;
    assert(! deepen(v) && Mesh::coordinates(v) == start);
    return;
  }
  const double enough = 0.1 * worst_quality(t, star, start);
  squeeze(t, v, star, numbers.squeezed % star.faces().size());
  const Place squeezed = Mesh::coordinates(v);
  const double worst = worst_quality(t, star, squeezed);
  if(worst < 1e-3 * enough)
  {
    ++numbers.squeezed;
    numbers.smoothed += smooth(v) && worst_quality(t, star, Mesh::coordinates(v)) > enough;
    v->set_point(Tr::Point(squeezed[0], squeezed[1], squeezed[2]));
    const bool is_deepened = deepen(v);
    const double worst_now = worst_quality(t, star, Mesh::coordinates(v));
    assert(is_deepened && worst_now > 2 * worst);
    numbers.deepened += worst_now > enough;
    assert_positive(t, star);
    const Place place = Mesh::coordinates(v);
    assert(deepen(v) ? worst_quality(t, star, Mesh::coordinates(v)) > 2 * worst_now : Mesh::coordinates(v) == place);
  }
  v->set_point(Tr::Point(start[0], start[1], start[2]));
}

void test_random_meshes(const bool is_flat)
{
  Numbers numbers;
  for(unsigned seed = 0; seed < 8; ++seed)
  {
    Improvement_options options;
    options.number_of_points = 80;
    options.has_walls = seed % 2 == 0;
    options.is_grid = seed == 7;
    Improvement t(seed, options);
    if(is_flat)
      flatten(t.scene.tr);
    Star star(t.mesh, any_number);
    for(const Vertex_handle v : t.scene.tr.finite_vertex_handles())
      test_vertex(t, v, star, numbers);
  }
  std::cout << numbers.squeezed << " squeezed, " << numbers.smoothed << " smoothed, " << numbers.deepened
            << " deepened; " << numbers.constrained << " constrained" << std::endl;
  assert(numbers.squeezed > 50 && numbers.constrained > 50);
  assert(numbers.deepened > 0.9 * numbers.squeezed);
  assert(! is_flat || numbers.smoothed < 0.1 * numbers.squeezed);
}

// Between two poles and the vertices of a polygon, near one of the faces.
void test_many_cells()
{
  Improvement_options options;
  options.has_walls = false;
  Improvement t(1, options);
  const int number_of_corners = 200;
  const Vertex_handle v = t.scene.make_vertex_inside_of_polygon(number_of_corners);
  Star star(t.mesh, any_number);
  bool is_done = star.collect(v);
  assert(is_done && star.cells().size() == 2 * number_of_corners);
  squeeze(t, v, star, 0);
  const auto deepest = internal::deepest_point(t.scene.tr, star.faces(), Mesh::coordinates(v));
  assert(deepest && worst_quality(t, star, *deepest) > 1e-3);
  is_done = internal::Smooth_vertex_3<Mesh>(t.mesh)(v);
  assert(! is_done);
  is_done = internal::Deepen_vertex_3<Mesh>(t.mesh)(v);
  assert(is_done && worst_quality(t, star, Mesh::coordinates(v)) > 1e-3);
  assert_positive(t, star);
}

double worst_quality(const Improvement& t)
{
  double worst = 2;
  for(const Cell_handle c : t.scene.tr.finite_cell_handles())
  {
    assert(t.mesh.is_positive(c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)));
    worst = (std::min)(worst, t.mesh.quality(c));
  }
  return worst;
}

// The corners of a rectangle, one of them higher by nearly nothing: a cell between the two walls, and others above.
// Sizes that allow no edge of the new vertex do not count then.
void test_flat_cell_between_walls(const unsigned seed, const double size)
{
  Improvement_options options;
  options.has_walls = false;
  Improvement t(1, options);
  Tr& tr = t.scene.tr;
  tr.clear();
  CGAL::Random random(seed);
  const double length = random.get_int(4, 13) / 8.;
  const std::array<Vertex_handle, 4> corners = {{
    tr.insert(Scene::Point(0, 0, 0)), tr.insert(Scene::Point(length, 0, 0)),
    tr.insert(Scene::Point(length, 1, 0)), tr.insert(Scene::Point(0, 1, std::ldexp(1., -46))) }};
  tr.insert(Scene::Point(length / 2, 0.5, 4));
  for(int i = 0; i < 5; ++i)
    tr.insert(Scene::Point(length * random.get_double(0.4, 0.6), random.get_double(0.4, 0.6),
                           random.get_double(1.5, 2.5)));
  for(const Vertex_handle v : tr.finite_vertex_handles())
    v->set_meshing_info(size);
  t.scene.select_all();
  Cell_handle flat;
  const bool is_cell = tr.is_cell(corners[0], corners[1], corners[2], corners[3], flat);
  assert(is_cell && t.mesh.quality(flat) < 1e-12 && worst_quality(t) < 1e-12);
  const std::size_t number = tr.number_of_vertices();

  internal::Insert_into_shell_3<Mesh> insert_into_shell(t.mesh);
  const bool is_done = insert_into_shell.find(flat) && insert_into_shell.apply();
  assert(is_done);
  BR3::Quality_improvement_counts counts;
  insert_into_shell.count(counts);
  assert(tr.number_of_vertices() + counts.number_of_removed_vertices == number + counts.number_of_inserted_points);
  assert(tr.tds().is_valid() && worst_quality(t) > 1e-3);
  Cell_handle c;
  int i, j, k;
  assert(tr.is_facet(corners[0], corners[1], corners[2], c, i, j, k));
  assert(tr.is_facet(corners[0], corners[2], corners[3], c, i, j, k));
}

int main()
{
  for(unsigned seed = 0; seed < 10; ++seed)
    for(const double size : { 0., 100. })
      test_flat_cell_between_walls(seed, size);
  test_random_meshes(false);
  test_random_meshes(true);
  test_many_cells();
}
