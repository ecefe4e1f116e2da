#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/IO/File_medit.h>
#include <CGAL/IO/output_to_vtu.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
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

// The recovery inserts points into a Delaunay triangulation, the remeshing takes a Triangulation_3 whose vertices and
// cells have indices: this one is both.
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, int, int> Complex;
typedef Triangulation::Vertex_handle                        Vertex_handle;
typedef Triangulation::Cell_handle                          Cell_handle;
typedef std::array<std::size_t, 3>                          Triangle;

// The number of triangles of the surface that are facets between the points where they were.
std::size_t number_of_triangles_there(const Triangulation& tr,
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

  // The surface stays as it is, the inside gets edges of length 0.4 or so.
  const std::size_t vertices_before = tr.number_of_vertices();
  CGAL::tetrahedral_isotropic_remeshing(tr, 0.4, CGAL::parameters::remesh_boundaries(false));
  std::cout << vertices_before << " vertices before, " << tr.number_of_vertices() << " after the remeshing; "
            << number_of_triangles_there(tr, points, triangles) << " of " << triangles.size()
            << " triangles are there" << std::endl;

  //! [handover]
  // Other packages take a complex, or a file.
  Complex complex;
  complex.triangulation() = tr;
  complex.rescan_after_load_of_triangulation();
  std::cout << complex.number_of_cells_in_complex() << " tetrahedra and " << complex.number_of_facets_in_complex()
            << " triangles in the complex" << std::endl;
  std::ofstream medit("remeshed.mesh"), vtu("remeshed.vtu");
  medit.precision(17);
  vtu.precision(17);
  CGAL::IO::write_MEDIT(medit, tr);
  CGAL::IO::output_to_vtu(vtu, complex, CGAL::IO::ASCII);
  //! [handover]

  const bool is_kept = number_of_regions == 1
                    && number_of_triangles_there(tr, points, triangles) == triangles.size()
                    && complex.number_of_facets_in_complex() == triangles.size();
  return is_kept && tr.tds().is_valid() && medit && vtu ? EXIT_SUCCESS : EXIT_FAILURE;
}
