#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;

int main()
{
  // Two cubes that share a square. The two triangles of the square are there once: a soup may be non-manifold.
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  if(! CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/two_cubes_br3.off"), points, triangles))
    return EXIT_FAILURE;

  //! [sizes]
  // The index is the number of the region that the point is in.
  const auto size = [](const Kernel::Point_3& /* p */, const int /* dimension */, const int index)
  {
    return index == 1 ? 0.1 : 0.3;
  };
  Triangulation tr;
  const auto result = CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, size);
  std::cout << result << std::endl;
  if(! result)
    return EXIT_FAILURE;
  //! [sizes]

  std::vector<double> volume(result.number_of_regions + 1, 0);
  std::vector<std::size_t> number_of_cells(result.number_of_regions + 1, 0);
  for(const Triangulation::Cell_handle c : tr.finite_cell_handles())
  {
    volume[c->subdomain_index()] += tr.tetrahedron(c).volume();
    ++number_of_cells[c->subdomain_index()];
  }
  for(int r = 1; r <= result.number_of_regions; ++r)
    std::cout << "material " << r << ": volume " << volume[r] << ", " << number_of_cells[r] << " cells" << std::endl;

  // What separates the materials is still the two triangles.
  std::size_t number_of_interfaces = 0;
  for(const auto& f : tr.finite_facets())
  {
    const int here = f.first->subdomain_index(), there = tr.mirror_facet(f).first->subdomain_index();
    if(here != there && here != 0 && there != 0)
      ++number_of_interfaces;
  }
  std::cout << number_of_interfaces << " facets between materials" << std::endl;

  const bool is_right = result.number_of_regions == 2 && number_of_interfaces == 2
                     && std::abs(volume[1] - 1) < 1e-9 && std::abs(volume[2] - 1) < 1e-9 // sums are rounded
                     && number_of_cells[1] > 5 * number_of_cells[2];
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
