#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_recovery_3/mesh_quality.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <set>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Boundary_recovery_3::Bad_cell_3<Triangulation>          Bad_cell;
typedef CGAL::Boundary_recovery_3::Bad_cell_reason                    Reason;

int main()
{
  // A wedge: its lower and its upper side meet at 8 degrees, and whoever meshes it has cells with that angle.
  const double angle = 8 * CGAL_PI / 180;
  std::vector<Kernel::Point_3> points;
  for(const double x : { 0, 1, 2 })
  {
    points.emplace_back(x, 0, 0);
    points.emplace_back(x, 3, 0);
    points.emplace_back(x, 3 * std::cos(angle), 3 * std::sin(angle));
  }
  const std::vector<std::array<std::size_t, 3> > triangles = {
    {{ 0, 1, 3 }}, {{ 3, 1, 4 }}, {{ 3, 4, 6 }}, {{ 6, 4, 7 }},   // the lower side
    {{ 0, 3, 2 }}, {{ 3, 5, 2 }}, {{ 3, 6, 5 }}, {{ 6, 8, 5 }},   // the upper side
    {{ 1, 2, 4 }}, {{ 4, 2, 5 }}, {{ 4, 5, 7 }}, {{ 7, 5, 8 }},   // the thick end
    {{ 0, 2, 1 }}, {{ 6, 7, 8 }} };

  //! [improvement]
  Triangulation tr;
  const auto result = CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, 1.,
                                                             CGAL::parameters::min_dihedral_angle(15.));
  std::cout << result.improvement << std::endl;
  //! [improvement]

  //! [certificate]
  std::set<int> blamed; // triangles of the input
  for(const Bad_cell& bad : result.improvement.certificate.cells)
  {
    std::cout << bad.min_dihedral_angle << " degrees at " << bad.edge[0]->point() << " - " << bad.edge[1]->point()
              << ", " << to_string(bad.reason);
    for(int i = 0; i < bad.number_of_facets(); ++i)
    {
      const Triangulation::Facet f = bad.facets[i];
      const int triangle = f.first->surface_patch_index(f.second) - 1; // patches are numbered from 1
      std::cout << (i == 1 ? " and " : bad.reason == Reason::not_improved ? " beside triangle " : ": triangle ")
                << triangle;
      if(bad.reason == Reason::forced)
        blamed.insert(triangle);
    }
    if(bad.number_of_facets() > 0)
      std::cout << " at " << bad.surface_angle << " degrees";
    std::cout << std::endl;
  }
  //! [certificate]

  // Where nothing is forced, or a needle, it may be worthwhile to try harder, or with other sizes.
  const std::size_t not_improved = result.improvement.certificate.number_of_cells(Reason::not_improved, 10);
  std::cout << not_improved << " cells below 10 degrees are not the fault of the surface\n"
            << CGAL::Boundary_recovery_3::mesh_quality(tr) << std::endl;

  const bool is_right = blamed == std::set<int>{ 0, 2, 4, 6 };
  return result && is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
