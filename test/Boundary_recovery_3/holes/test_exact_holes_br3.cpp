// remesh_holes() over a kernel with exact constructions, and coordinates that no floating point number is; with
// sanitizers, as a small test of the whole, over the usual kernel.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "hole_judge_br3.h"
#include "moved_grid_br3.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>
#include <CGAL/remesh_holes.h>

#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace parameters = CGAL::parameters;
using br3_test::Moved_grid;
#ifdef BR3_TEST_EPICK_ONLY
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
#else
typedef CGAL::Exact_predicates_exact_constructions_kernel   Kernel;
#endif
typedef Kernel::Point_3                                     Point;
typedef CGAL::Hole_remeshing_result_3<Point>                Result;

int main()
{
  std::mt19937 rng(3);
  for(const double distance : { 0.8, 1.5 })
  {
    Moved_grid grid(4);
    grid.set_region({{ 0, 0, 0 }}, {{ 2, 4, 4 }}, 2);
    grid.add_sheet(2, {{ 1, 1 }}, {{ 3, 4 }});
    grid.shake(rng, distance, 2);
    std::vector<Point> points;
    for(const auto& p : grid.places)
      points.emplace_back(Kernel::FT(p[0]) / 3, Kernel::FT(p[1]) / 7, Kernel::FT(p[2]) / 11);
    const Result result = CGAL::remesh_holes(points, grid.tetrahedra,
                                             parameters::cell_region_map(CGAL::make_property_map(grid.regions)),
                                             parameters::constrained_facets(grid.facets),
                                             parameters::min_dihedral_angle(5.).verbose(false),
                                             parameters::number_of_layers(std::size_t(1)));
    std::cout << result << "; inverted " << result.number_of_inverted_cells << std::endl;
    br3_test::Hole_judge<Kernel, Result> judge(points, grid.tetrahedra, grid.regions, grid.facets, grid.edges, result);
    const std::string verdict = judge.verdict();
    std::cout << verdict << std::endl;
    assert(result && verdict.empty() && result.number_of_bad_cells > 0);
  }
  return EXIT_SUCCESS;
}
