// remesh_holes() on grids whose vertices were moved at random, with regions, sheets and edges: all that it promises, by
// a judge of its own.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "hole_judge_br3.h"
#include "moved_grid_br3.h"

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>
#include <CGAL/remesh_holes.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace parameters = CGAL::parameters;
using br3_test::Moved_grid;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3                                     Point;
typedef CGAL::Hole_remeshing_result_3<Point>                Result;
typedef BR3::Meshing_status                                 Status;
typedef BR3::Input_defect_kind                              Kind;

template <typename ... NPs>
Result remesh(const Moved_grid& grid, const NPs& ... nps)
{
  return CGAL::remesh_holes(grid.points<Point>(), grid.tetrahedra,
                            parameters::cell_region_map(CGAL::make_property_map(grid.regions)),
                            parameters::constrained_facets(grid.facets), parameters::constrained_edges(grid.edges),
                            nps...);
}

void judge(const Moved_grid& grid, const Result& result, const std::string& what)
{
  const std::vector<Point> points = grid.points<Point>();
  br3_test::Hole_judge<Kernel, Result> judge(points, grid.tetrahedra, grid.regions, grid.facets, grid.edges, result);
  const std::string verdict = result ? judge.verdict() : "not meshed";
  std::cout << what << ": " << result << "; inverted " << result.number_of_inverted_cells << " of "
            << grid.tetrahedra.size() << ", enlarged " << result.number_of_enlargements << ", failures "
            << result.number_of_failures << ", smallest angle " << result.smallest_new_angle << std::endl;
  if(! verdict.empty())
    std::cerr << what << ": " << verdict << std::endl;
  assert(verdict.empty());
}

bool is_same(const Result& a, const Result& b)
{
  return a.points == b.points && a.tetrahedra == b.tetrahedra && a.regions == b.regions && a.facets == b.facets &&
         a.edges == b.edges && a.old_vertices == b.old_vertices && a.old_cells == b.old_cells;
}

// The old mesh, and nothing else.
void check_unchanged(const Moved_grid& grid, const Result& result, const Status status)
{
  assert(result.status == status);
  assert(result.points.size() == grid.places.size() && result.tetrahedra == grid.tetrahedra);
  for(std::size_t v = 0; v < grid.places.size(); ++v)
    for(int i = 0; i < 3; ++i)
      assert(result.points[v][i] == grid.places[v][std::size_t(i)] || grid.places[v] != grid.places[v]);
  assert(result.regions == grid.regions && result.facets == grid.facets && result.edges == grid.edges);
  assert(result.number_of_kept_vertices == grid.places.size() && result.number_of_kept_cells == grid.tetrahedra.size());
  for(std::size_t v = 0; v < result.old_vertices.size(); ++v)
    assert(result.old_vertices[v] == v);
  for(std::size_t c = 0; c < result.old_cells.size(); ++c)
    assert(result.old_cells[c] == c);
  assert(result.locations.empty());
}

// Regions that touch, one with a negative number and one that is 0, a sheet across regions, and edges.
Moved_grid furnished_grid(const int n)
{
  Moved_grid grid(n);
  grid.set_region({{ 0, 0, 0 }}, {{ n / 2, n, n }}, 0);
  grid.set_region({{ n / 3, n / 3, n / 3 }}, {{ 2 * n / 3, 2 * n / 3, 2 * n / 3 }}, -7);
  grid.add_sheet(n / 4, {{ 1, 1 }}, {{ n - 1, n - 2 }});
  grid.add_edges(n - 1, n - 2, 2, n - 1);
  return grid;
}

void test_moved_at_random()
{
  std::mt19937 rng(28);
  for(const double distance : { 0.3, 0.6, 1., 2. })
    for(const int one_of : { 1, 4, 60 })
      for(const std::size_t layers : { 0, 2 })
      {
        Moved_grid grid = furnished_grid(8);
        grid.shake(rng, distance, one_of);
        const Result result = remesh(grid, parameters::number_of_layers(layers));
        judge(grid, result, "moved by " + std::to_string(distance) + ", one of " + std::to_string(one_of) + ", " +
                            std::to_string(layers) + " layers");
        assert(is_same(result, remesh(grid, parameters::number_of_layers(layers))));
      }
}

int main()
{
  test_moved_at_random();
  return EXIT_SUCCESS;
}
