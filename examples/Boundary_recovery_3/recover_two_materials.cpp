#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/Boundary_recovery_3/label_regions.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef Triangulation::Cell_handle                          Cell_handle;

int main()
{
  // Two cubes that share a square. The two triangles of the square are there once: a soup may be non-manifold.
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  if(! CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/two_cubes_br3.off"), points, triangles))
    return EXIT_FAILURE;

  Triangulation tr;
  const auto result = CGAL::recover_boundary(tr, points, triangles);
  std::cout << result << std::endl;
  if(! result)
    return EXIT_FAILURE;

  //! [labels]
  // The triangles as facets of the triangulation separate the regions.
  typedef CGAL::Unique_hash_map<Cell_handle, int> Region_map;
  Region_map region(0); // 0 is outside
  const int number_of_regions =
    CGAL::Boundary_recovery_3::label_regions(tr, result.facets, boost::associative_property_map<Region_map>(region));
  //! [labels]

  std::vector<double> volume(number_of_regions + 1, 0);
  for(const Cell_handle c : tr.finite_cell_handles())
    volume[region[c]] += tr.tetrahedron(c).volume();
  for(int r = 1; r <= number_of_regions; ++r)
    std::cout << "material " << r << ": volume " << volume[r] << std::endl;

  // What separates two materials is a facet of both.
  std::size_t number_of_interfaces = 0;
  for(const auto& f : tr.finite_facets())
  {
    const int here = region[f.first], there = region[tr.mirror_facet(f).first];
    if(here != there && here != 0 && there != 0)
      ++number_of_interfaces;
  }
  std::cout << number_of_interfaces << " facets between materials" << std::endl;

  const bool is_right = number_of_regions == 2 && number_of_interfaces == 2
                     && std::abs(volume[1] - 1) < 1e-12 && std::abs(volume[2] - 1) < 1e-12; // sums are rounded
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
