#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;

int main(int argc, char* argv[])
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  if(! CGAL::IO::read_polygon_soup(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/gear_br3.off"), points, triangles))
    return EXIT_FAILURE;
  const double size = argc > 2 ? std::atof(argv[2]) : 0.5;

  //! [subdomains]
  // By threads, if CGAL_LINKED_WITH_TBB is defined; how many there are makes no difference to the mesh.
  Triangulation tr;
  const auto result = CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, size,
                                                             CGAL::parameters::number_of_subdomains(8));
  //! [subdomains]

  std::cout << to_string(result.status) << ": " << result.improvement.after << std::endl;
  for(const auto& phase : result.phases)
    std::cout << to_string(phase.phase) << ": " << phase.seconds << " s" << std::endl;
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
