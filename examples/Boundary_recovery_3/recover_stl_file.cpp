#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/recover_boundary.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;

int main(int argc, char* argv[])
{
  // An STL file has no vertices, only triangles with three points each; CGAL's reader makes one of equal points. The
  // file of the nut also has a triangle that is there twice, and one without area.
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t> > triangles;
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/nut_br3.stl");
  if(! CGAL::IO::read_polygon_soup(file, points, triangles))
    return EXIT_FAILURE;
  std::cout << triangles.size() << " triangles, " << points.size() << " points" << std::endl;

  // As it is, the soup is refused: the function does not guess what was meant.
  Triangulation tr;
  const auto refusal = CGAL::recover_boundary(tr, points, triangles);
  std::cout << refusal << std::endl;

  // What is degenerate or there twice goes. Points that are equal, as in other formats, would become one.
  CGAL::Polygon_mesh_processing::repair_polygon_soup(points, triangles);
  std::cout << "repaired: " << triangles.size() << " triangles, " << points.size() << " points" << std::endl;

  tr.clear();
  const auto result = CGAL::recover_boundary(tr, points, triangles);
  std::cout << result << ", " << tr.number_of_finite_cells() << " tetrahedra" << std::endl;
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
