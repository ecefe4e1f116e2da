#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;

bool name_of_status_is_known();

int main()
{
  const std::vector<Kernel::Point_3> points = { {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1} };
  const std::vector<std::array<std::size_t, 3> > triangles = { {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2} };

  Triangulation tr;
  const auto result = CGAL::recover_boundary(tr, points, triangles);
  std::cout << result << std::endl;
  return result && tr.number_of_vertices() == 4 && tr.is_valid() && name_of_status_is_known()
    ? EXIT_SUCCESS : EXIT_FAILURE;
}
