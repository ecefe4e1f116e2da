#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/File_medit.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <cstdlib>
#include <fstream>
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

  std::ofstream file("mesh.mesh");
  file.precision(17);
  CGAL::IO::write_MEDIT(file, tr); // the cells in the domain, and each triangle of the surface
  return result && file ? EXIT_SUCCESS : EXIT_FAILURE;
}
