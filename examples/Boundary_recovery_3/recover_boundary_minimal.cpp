#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/recover_boundary.h>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  if(! CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/gear_br3.off"), surface))
  {
    std::cerr << "Pass a file with a manifold surface." << std::endl;
    return EXIT_FAILURE;
  }

  Triangulation tr;
  const auto result = CGAL::recover_boundary(tr, surface);
  std::cout << result << "\n" << tr.number_of_finite_cells() << " tetrahedra" << std::endl;
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
