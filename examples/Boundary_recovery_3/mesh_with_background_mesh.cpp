#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Boundary_recovery_3/Background_mesh_3.h>
#include <CGAL/Boundary_recovery_3/Background_mesh_sizing_field_3.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Boundary_recovery_3::Background_mesh_3<Kernel>          Background_mesh;

int main()
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  if(! CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/cube_br3.off"), points, triangles))
    return EXIT_FAILURE;

  //! [background]
  // Six tetrahedra that fill the cube, as a solver writes them, with the sizes that it wants next: small at one corner.
  // Here the two files are strings; `read_background_mesh("x.mesh", ...)` reads x.mesh and x.sol.
  std::istringstream mesh_file("MeshVersionFormatted 2\nDimension 3\n"
                               "Vertices 8\n"
                               "0 0 0 0\n1 0 0 0\n0 1 0 0\n1 1 0 0\n0 0 1 0\n1 0 1 0\n0 1 1 0\n1 1 1 0\n"
                               "Tetrahedra 6\n"
                               "1 2 4 8 0\n1 4 3 8 0\n1 3 7 8 0\n1 7 5 8 0\n1 5 6 8 0\n1 6 2 8 0\n"
                               "End\n");
  std::istringstream sol_file("MeshVersionFormatted 2\nDimension 3\n"
                              "SolAtVertices 8\n1 1\n"
                              "0.05\n0.5\n0.5\n0.5\n0.5\n0.5\n0.5\n0.5\n"
                              "End\n");
  Background_mesh background;
  std::string message;
  if(! CGAL::Boundary_recovery_3::read_MEDIT_background_mesh(mesh_file, sol_file, background, message))
  {
    std::cerr << message << std::endl;
    return EXIT_FAILURE;
  }
  const CGAL::Boundary_recovery_3::Background_mesh_sizing_field_3<Kernel> size(background, 0.3); // growth on its edges

  Triangulation tr;
  const auto result = CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, size);
  //! [background]
  std::cout << result.filling << std::endl;
  if(! result)
    return EXIT_FAILURE;

  // About half of the vertices are in the eighth of the cube around the corner.
  std::size_t near = 0, far = 0;
  for(const auto v : tr.finite_vertex_handles())
    ++(v->point().x() < .5 && v->point().y() < .5 && v->point().z() < .5 ? near : far);
  std::cout << near << " vertices near the corner, " << far << " elsewhere" << std::endl;
  return 3 * near > far ? EXIT_SUCCESS : EXIT_FAILURE;
}
