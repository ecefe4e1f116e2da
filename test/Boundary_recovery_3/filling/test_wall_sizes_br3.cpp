// Where walls are finer than the size that is asked for: their sizes, how sizes grow from there, and that those of one
// region do not matter in another one.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "grid_scene_br3.h"
#include "mesh_validity_br3.h"
#include "random_numbers_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Vertex_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/mark_domain.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
namespace parameters = CGAL::parameters;
typedef CGAL::Exact_predicates_inexact_constructions_kernel      K;
typedef K::Point_3                                               Point;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type Tr;
typedef Tr::Vertex_handle                                        Vertex_handle;
typedef Tr::Cell_handle                                          Cell_handle;
typedef std::vector<Cell_handle>                                 Cells;

double length(const Vertex_handle u, const Vertex_handle v)
{
  return std::sqrt(CGAL::squared_distance(u->point(), v->point()));
}

Cells cells_of_domain(const Tr& tr)
{
  Cells cells;
  for(const Cell_handle c : tr.finite_cell_handles())
    if(c->subdomain_index() != 0)
      cells.push_back(c);
  return cells;
}

// Lengths of all edges of the walls at each vertex, once for each facet, and for each of its sides that is in the
// domain.
std::map<Vertex_handle, std::vector<double> > edges_of_walls(const Tr& tr)
{
  std::map<Vertex_handle, std::vector<double> > result;
  for(const auto& f : tr.finite_facets())
  {
    const std::array<int, 2> regions = {{ f.first->subdomain_index(),
                                          f.first->neighbor(f.second)->subdomain_index() }};
    if(regions[0] == regions[1] && ! f.first->is_facet_on_surface(f.second))
      continue;
    const auto v = internal::facet_vertices(f.first, f.second);
    for(const int region : regions)
      for(std::size_t i = 0; i < 3 && region != 0; ++i)
        for(std::size_t j = 0; j < 3; ++j)
          if(i != j)
            result[v[i]].push_back(length(v[i], v[j]));
  }
  return result;
}

void test_sizes_of_walls()
{
  std::mt19937 rng(11);
  Tr tr;
  for(int i = 0; i < 300; ++i) // some edges are very short
    tr.insert(Point(br3_test::random_int(rng, 9) + br3_test::random_int(rng, 9) / 100., br3_test::random_int(rng, 9),
                    br3_test::random_int(rng, 9)));
  for(const Cell_handle c : tr.all_cell_handles())
    c->set_subdomain_index(tr.is_infinite(c) ? 0 : br3_test::random_int(rng, 3));
  const auto domain = internal::selected_domain(tr, parameters::default_values());
  const Cells cells = cells_of_domain(tr);
  const internal::Wall_sizes_3<Tr> walls(cells, domain);
  const auto edges = edges_of_walls(tr);
  assert(walls.vertices().size() == edges.size());
  assert(std::set<Vertex_handle>(walls.vertices().begin(), walls.vertices().end()).size() == edges.size());
  int number_of_needles = 0;
  for(const auto& [v, lengths] : edges)
  {
    const double shortest = *std::min_element(lengths.begin(), lengths.end());
    const double mean = std::accumulate(lengths.begin(), lengths.end(), 0.) / static_cast<double>(lengths.size());
    assert(std::abs(walls[v] - (std::max)(shortest, mean / 2)) < 1e-12);
    number_of_needles += shortest < mean / 2;
  }
  assert(number_of_needles > 10 && number_of_needles + 10 < static_cast<int>(edges.size()));

  // What a place in a cell is told.
  const double size = 2;
  const internal::Any_size_field_3<K, double> any_size(size);
  internal::Region_sizes_3<Tr> sizes(tr, any_size);
  assert(sizes.ask_at_vertices(cells));
  sizes.set_walls(walls);
  for(const Cell_handle c : cells)
  {
    const auto corners = internal::corners(c);
    const auto center = internal::centroid(corners);
    double expected = size;
    for(int i = 0; i < 4; ++i)
      if(edges.count(c->vertex(i)) != 0)
        expected = (std::min)(expected, walls[c->vertex(i)] + 0.9 * internal::distance(corners[i], center));
    const auto told = sizes(center, c);
    assert(told.asked == size && std::abs(told.possible - expected) < 1e-12);
    assert(sizes.least_size_at_centroid(c, corners) == told.possible && sizes.of_field(center, 1) == size);
  }
  sizes.restore_sizes_of_field();
  for(const auto& v : edges)
    assert(v.first->meshing_info() == size);
}

// A unit cube, with a square grid on its bottom, and nothing on the other sides but what the triangulation chose.
struct Cube_on_grid
{
  static constexpr int n = 12;
  Tr tr;

  Cube_on_grid()
  {
    for(int x = 0; x <= n; ++x)
      for(int y = 0; y <= n; ++y)
        tr.insert(Point(x / double(n), y / double(n), 0));
    for(const int x : { 0, 1 })
      for(const int y : { 0, 1 })
        tr.insert(Point(x, y, 1));
    for(const Cell_handle c : tr.all_cell_handles())
      c->set_subdomain_index(tr.is_infinite(c) ? 0 : 1);
  }

  // On the bottom, but not at its boundary: there are needles between that and the corners above.
  static bool is_inside_grid(const internal::Coordinates_3& p)
  {
    return p[2] == 0 && (std::min)(p[0], p[1]) > 0 && (std::max)(p[0], p[1]) < 1;
  }

  // The share of the cells at such vertices with circumradii of less than three edges of the grid.
  double share_of_small_cells() const
  {
    int number_of_cells = 0, number_of_small_cells = 0;
    for(const Cell_handle c : tr.finite_cell_handles())
    {
      const auto corners = internal::corners(c);
      if(std::none_of(corners.begin(), corners.end(), is_inside_grid))
        continue;
      ++number_of_cells;
      number_of_small_cells += internal::circumsphere(corners).squared_radius < 9. / (n * n);
    }
    return number_of_small_cells / double(number_of_cells);
  }
};

// Inserts field points by what is behind insert_field_points(), with an option of that. Returns how many.
template <typename Option>
std::size_t insert_with(Tr& tr, const double size, const Option& option)
{
  auto domain = internal::selected_domain(tr, parameters::default_values());
  const internal::Any_size_field_3<K, double> any_size(size);
  internal::Mesh_visitor_3<Tr> visitor;
  internal::Field_point_insertion_3<Tr> insert(tr, domain, any_size, visitor);
  option(insert);
  const auto result = insert(1000, std::numeric_limits<double>::infinity());
  assert(result && br3_test::is_valid_mesh(tr));
  return result.number_of_field_points;
}

void test_growth()
{
  const double size = 1;
  Cube_on_grid cube, coarse, restored, empty;
  const auto result = CGAL::insert_field_points(cube.tr, size);
  assert(result && br3_test::is_valid_mesh(cube.tr));
  assert(cube.share_of_small_cells() > 0.9);
  for(const auto v : cube.tr.finite_vertex_handles())
  {
    assert(v->meshing_info() <= size);
    assert(! Cube_on_grid::is_inside_grid(internal::coordinates_of(v->point()))
           || std::abs(v->meshing_info() - 1. / Cube_on_grid::n) < 1e-12);
  }
  assert(result.number_of_field_points < 100); // hundreds would be needed for the small size everywhere

  insert_with(coarse.tr, size, [](auto& insert) { insert.ignore_sizes_of_walls(); });
  assert(coarse.share_of_small_cells() < 0.1);

  const std::size_t number = insert_with(restored.tr, size, [](auto& insert) { insert.leave_sizes_of_field(); });
  assert(number == result.number_of_field_points);

  for(const Tr* const tr : { &coarse.tr, &restored.tr })
    for(const auto v : tr->finite_vertex_handles())
      assert(v->meshing_info() == size);

  assert(CGAL::insert_field_points(empty.tr, (std::numeric_limits<double>::max)()).number_of_field_points == 0);
}

// The points outside of a box, if sizes inside of it are as given.
std::set<Point> points_around_box(const double size_in_box)
{
  br3_test::Grid_scene<Tr> scene(3);
  scene.add_box({{ 0, 0, 0 }}, {{ 3, 3, 3 }}, true);
  scene.add_box({{ 1, 1, 1 }}, {{ 2, 2, 2 }}, true);
  assert(CGAL::mark_domain(scene.tr, scene.facets) == 2);
  const Point middle(1.5, 1.5, 1.5);
  const int region_of_box = scene.tr.locate(middle)->subdomain_index();
  const auto size = [&](const Point&, int, const int region) { return region == region_of_box ? size_in_box : 0.7; };
  assert(CGAL::insert_field_points(scene.tr, size).number_of_field_points > 0);
  std::set<Point> result;
  for(const auto& p : scene.tr.points())
    if(! scene.is_between(p, {{ 1, 1, 1 }}, {{ 2, 2, 2 }}))
      result.insert(p);
  return result;
}

int main()
{
  test_sizes_of_walls();
  test_growth();
  assert(points_around_box(0.7) == points_around_box(0.1)); // a fine region does not make its neighbors fine
  return EXIT_SUCCESS;
}
