#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel            Kernel;
typedef Kernel::Point_3                                                Point_3;
typedef CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel> Triangulation;

// The number of facets between regions, or between a region and the outside.
std::size_t number_of_surface_facets(const Triangulation& tr)
{
  std::size_t n = 0;
  for(const auto& f : tr.finite_facets())
    n += f.first->subdomain_index() != tr.mirror_facet(f).first->subdomain_index();
  return n;
}

double volume(const Triangulation& tr)
{
  double sum = 0;
  for(const Triangulation::Cell_handle c : tr.finite_cell_handles())
    if(c->subdomain_index() != 0)
      sum += tr.tetrahedron(c).volume();
  return sum;
}

int main()
{
  // Somebody else's mesh: two half balls, remeshed by CGAL with their surface.
  Triangulation tr;
  CGAL::Random random(0);
  CGAL::Random_points_in_sphere_3<Point_3> in_ball(1, random);
  for(int i = 0; i < 1000; ++i)
    tr.insert(*in_ball++);
  for(const Triangulation::Cell_handle c : tr.finite_cell_handles())
    c->set_subdomain_index(CGAL::centroid(tr.tetrahedron(c)).x() < 0 ? 1 : 2);
  CGAL::tetrahedral_isotropic_remeshing(tr, 0.3);
  const std::size_t number_of_vertices = tr.number_of_vertices(), number_of_facets = number_of_surface_facets(tr);
  const double volume_before = volume(tr);

  //! [filling]
  // Small cells in the second half. The surface and the facets between both halves stay as they are.
  const auto size = [](const Point_3& /* p */, const int /* dimension */, const int region)
  {
    return region == 1 ? 0.3 : 0.1;
  };
  const auto result = CGAL::insert_field_points(tr, size);
  //! [filling]
  std::cout << result << "\n" << number_of_vertices << " vertices before, " << tr.number_of_vertices()
            << " now" << std::endl;

  const bool is_right = tr.is_valid() && number_of_surface_facets(tr) == number_of_facets
                     && std::abs(volume(tr) - volume_before) < 1e-9 // sums are rounded
                     && result.number_of_field_points > 1000;
  return result && is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
