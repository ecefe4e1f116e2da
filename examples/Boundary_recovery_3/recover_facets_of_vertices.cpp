#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef Triangulation::Point                                Point;
typedef Triangulation::Vertex_handle                        Vertex_handle;
typedef std::array<Vertex_handle, 3>                        Facet;

// Prints how many tetrahedra there are, and whether one of them has the facet.
bool find_facet(const Triangulation& tr, const Facet& f)
{
  Triangulation::Cell_handle c;
  int i, j, k;
  const bool is_facet = tr.is_facet(f[0], f[1], f[2], c, i, j, k);
  std::cout << tr.number_of_finite_cells() << " tetrahedra, abc is "
            << (is_facet ? "a" : "no") << " facet" << std::endl;
  return is_facet;
}

int main()
{
  // A triangle abc, and a point close to it on either side: the edge between them pierces the triangle.
  Triangulation tr;
  const Vertex_handle a = tr.insert(Point( 4,  0, 0));
  const Vertex_handle b = tr.insert(Point(-2,  3, 0));
  const Vertex_handle c = tr.insert(Point(-2, -3, 0));
  tr.insert(Point(0, 0,  1));
  tr.insert(Point(0, 0, -1));

  const std::vector<Facet> facets = { {{ a, b, c }} };
  find_facet(tr, facets[0]);

  const auto result = CGAL::recover_boundary(tr, facets);
  std::cout << result << std::endl; // the status, and all that is missing
  return result && find_facet(tr, facets[0]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
