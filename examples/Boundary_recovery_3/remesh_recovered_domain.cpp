#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/IO/File_medit.h>
#include <CGAL/IO/output_to_vtu.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/convert_to_remeshing_triangulation.h>
#include <CGAL/mark_domain.h>
#include <CGAL/recover_boundary.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3                                     Point;

typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type     Triangulation;
typedef CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel>    Remeshing_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Remeshing_triangulation, int, int> Complex;
typedef Remeshing_triangulation::Vertex_handle                            Vertex_handle;
typedef Remeshing_triangulation::Cell_handle                              Cell_handle;
typedef std::array<std::size_t, 3>                                        Triangle;

// The number of triangles of the surface that are facets between the points where they were.
std::size_t number_of_triangles_there(const Remeshing_triangulation& tr,
                                      const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  std::map<Point, Vertex_handle> vertex;
  for(const Vertex_handle v : tr.finite_vertex_handles())
    vertex[v->point()] = v;
  std::size_t n = 0;
  for(const Triangle& t : triangles)
  {
    const Vertex_handle u = vertex[points[t[0]]], v = vertex[points[t[1]]], w = vertex[points[t[2]]];
    Cell_handle c;
    int i, j, k;
    n += u != Vertex_handle() && v != Vertex_handle() && w != Vertex_handle() && tr.is_facet(u, v, w, c, i, j, k);
  }
  return n;
}

int main()
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  if(! CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/washer_br3.off"), points, triangles))
    return EXIT_FAILURE;

  Triangulation tr;
  const auto result = CGAL::recover_boundary(tr, points, triangles);
  std::cout << result << std::endl;
  if(! result)
    return EXIT_FAILURE;

  //! [indices]
  // Cells get the number of their region, triangles of the surface their patch, and vertices the dimension of what they
  // are on.
  const int number_of_regions = CGAL::mark_domain(tr, result.facets);
  //! [indices]

  //! [remeshing]
  // The surface stays as it is, the inside gets edges of length 0.4 or so.
  Remeshing_triangulation remeshed;
  CGAL::Boundary_recovery_3::convert_to_remeshing_triangulation(tr, remeshed);
  CGAL::tetrahedral_isotropic_remeshing(remeshed, 0.4, CGAL::parameters::remesh_boundaries(false));
  //! [remeshing]
  std::cout << tr.number_of_vertices() << " vertices before, " << remeshed.number_of_vertices()
            << " after the remeshing; " << number_of_triangles_there(remeshed, points, triangles) << " of "
            << triangles.size() << " triangles are there" << std::endl;

  //! [handover]
  // Other packages take a complex, or a file.
  Complex complex;
  complex.triangulation() = remeshed;
  complex.rescan_after_load_of_triangulation();
  std::cout << complex.number_of_cells_in_complex() << " tetrahedra and " << complex.number_of_facets_in_complex()
            << " triangles in the complex" << std::endl;
  std::ofstream medit("remeshed.mesh"), vtu("remeshed.vtu");
  medit.precision(17);
  vtu.precision(17);
  CGAL::IO::write_MEDIT(medit, remeshed);
  CGAL::IO::output_to_vtu(vtu, complex, CGAL::IO::ASCII);
  //! [handover]

  const bool is_kept = number_of_regions == 1
                    && number_of_triangles_there(remeshed, points, triangles) == triangles.size()
                    && complex.number_of_facets_in_complex() == triangles.size();
  return is_kept && remeshed.tds().is_valid() && medit && vtu ? EXIT_SUCCESS : EXIT_FAILURE;
}
