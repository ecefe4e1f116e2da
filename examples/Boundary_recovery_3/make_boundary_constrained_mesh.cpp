#include <CGAL/Boundary_recovery_3/write_domain_MEDIT.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/gear_br3.off");
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  if(! CGAL::IO::read_polygon_mesh(file, surface))
  {
    std::cerr << "cannot read " << file << std::endl;
    return 1;
  }

  CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type tr;
  const auto result = CGAL::make_boundary_constrained_mesh_3(tr, surface); // sizes come from the surface
  std::cout << result << std::endl;
  return result && CGAL::IO::write_domain_MEDIT("mesh.mesh", tr, result.recovery) ? 0 : 1;
}
