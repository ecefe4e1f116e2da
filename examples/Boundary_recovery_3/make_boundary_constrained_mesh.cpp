#include <CGAL/Boundary_recovery_3/write_domain_MEDIT.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  if(! CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/gear_br3.off"), surface))
    return EXIT_FAILURE;

  Triangulation tr;
  const auto result = CGAL::make_boundary_constrained_mesh_3(tr, surface); // with sizes from the surface
  std::cout << result << std::endl;

  // the cells of the domain and the triangles of the surface, each once and with its number, from 1
  const bool is_written = CGAL::IO::write_domain_MEDIT("mesh.mesh", tr, result.recovery);
  return result && is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
