#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Boundary_recovery_3/Combined_sizing_fields_3.h>
#include <CGAL/Boundary_recovery_3/Size_source_3.h>
#include <CGAL/Boundary_recovery_3/Source_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/Surface_sizing_field_3.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef Kernel::Point_3                                               Point_3;

using namespace CGAL::Boundary_recovery_3;

// The mean size of the cells near a place: the edge of a regular tetrahedron of their mean volume.
double mean_size(const Triangulation& tr, const Point_3& place, const double radius)
{
  double volume = 0, number = 0;
  for(const auto c : tr.finite_cell_handles())
    if(c->subdomain_index() != 0
       && CGAL::squared_distance(place, CGAL::centroid(tr.tetrahedron(c))) < radius * radius)
    {
      volume += tr.tetrahedron(c).volume();
      ++number;
    }
  return std::cbrt(6 * std::sqrt(2.) * volume / number);
}

int main()
{
  // The air between a wing and a box around it.
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  if(! CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/wing_br3.off"), points, triangles))
    return EXIT_FAILURE;

  //! [sources]
  // Small cells behind the trailing edge, as they are written in a file, ...
  std::istringstream file("# the wake: from the trailing edge backwards\n"
                          "triangle  1 -2 0  1.5 2 0  4 0 0   0.12  0.1  0.2   # size, radius, growth\n");
  std::vector<Size_source_3<Kernel> > sources;
  std::string message;
  if(! read_size_sources(file, sources, message))
  {
    std::cerr << message << std::endl;
    return EXIT_FAILURE;
  }
  // ... and at the tip, where a vortex is, with sizes that have doubled at the distance 0.5.
  sources.push_back(Size_source_3<Kernel>::segment(Point_3(1.5, 2, 0), Point_3(3, 2, 0), 0.06, 0.1,
                                                   Size_growth::doubling_at(0.5)));
  const Source_sizing_field_3<Kernel> from_sources(sources, 1); // nowhere larger than 1

  // Elsewhere the sizes come from the surface. The smallest one wins.
  const Surface_sizing_field_3<Triangulation> from_surface(points, triangles);
  const auto size = make_minimum_sizing_field<Kernel>(std::cref(from_surface), std::cref(from_sources));

  Triangulation tr;
  const auto result = CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, size);
  //! [sources]
  std::cout << result.filling << std::endl;
  if(! result)
    return EXIT_FAILURE;

  const double at_tip = mean_size(tr, Point_3(2, 2, 0), 0.1), in_wake = mean_size(tr, Point_3(2.5, 0, 0), 0.2);
  const double far_away = mean_size(tr, Point_3(6, 0, 3), 1);
  std::cout << "mean sizes of cells: " << at_tip << " at the tip, " << in_wake << " in the wake, " << far_away
            << " far away" << std::endl;
  return at_tip < in_wake && in_wake < far_away ? EXIT_SUCCESS : EXIT_FAILURE;
}
