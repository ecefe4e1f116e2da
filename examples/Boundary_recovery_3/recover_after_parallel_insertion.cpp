#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Triangulation_vertex_base_3<Kernel>           Vertex_base;
typedef CGAL::Delaunay_triangulation_cell_base_3<Kernel>    Cell_base;
typedef CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base, CGAL::Parallel_tag> Tds;
typedef CGAL::Delaunay_triangulation_3<Kernel, Tds>         Triangulation;

int main(int argc, char* argv[])
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  if(! CGAL::IO::read_polygon_soup(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/gear_br3.off"), points, triangles))
    return EXIT_FAILURE;

  //! [insertion]
  // The lock grid makes the insertion parallel. Threads insert in any order, so where the Delaunay triangulation is not
  // unique, the result may differ from run to run.
  Triangulation::Lock_data_structure locks(CGAL::bbox_3(points.begin(), points.end()), 50);
  Triangulation tr(points.begin(), points.end(), &locks);
  const auto result = CGAL::recover_boundary(tr, points, triangles); // finds the vertices of the points
  //! [insertion]

  std::cout << result << "\n" << result.number_of_inserted_vertices << " points were not in the triangulation"
            << std::endl;
  return result && result.number_of_inserted_vertices == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
