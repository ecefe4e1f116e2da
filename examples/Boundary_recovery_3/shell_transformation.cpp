#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Shell_transformation_3.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef Triangulation::Point                                Point;
typedef Triangulation::Vertex_handle                        Vertex_handle;
typedef Triangulation::Edge                                 Edge;
typedef CGAL::Shell_transformation_3<Triangulation>         Shell_transformation;
typedef Shell_transformation::Shell                         Shell;

// Looks up the edge ab, and prints how many tetrahedra there are and how many of them are around ab.
bool find_edge(const Triangulation& tr, const Vertex_handle a, const Vertex_handle b, Edge& ab)
{
  const bool is_edge = tr.is_edge(a, b, ab.first, ab.second, ab.third);
  std::cout << tr.number_of_finite_cells() << " tetrahedra, "
            << (is_edge ? Shell(tr, ab.first, ab.second, ab.third).degree() : 0) << " around ab" << std::endl;
  return is_edge;
}

int main()
{
  // A short edge ab, and around it a skirt polygon of five points at different heights.
  Triangulation tr;
  const Vertex_handle a = tr.insert(Point(0, 0,  2));
  const Vertex_handle b = tr.insert(Point(0, 0, -2));
  tr.insert(Point( 4, -3,  0));
  tr.insert(Point( 4,  3,  1));
  tr.insert(Point(-1,  5, -4));
  tr.insert(Point(-5,  0,  1));
  tr.insert(Point(-1, -5,  3));

  Edge ab;
  if(! find_edge(tr, a, b, ab))
    return EXIT_FAILURE;

  // With this quality, a covering mesh is better if fewer of its tetrahedra are around ab. Among those with as
  // many, the one with the best worst tetrahedron is taken.
  Shell_transformation transformation(tr, CGAL::Boundary_recovery_3::Worst_element_quality_3<Triangulation>(tr));

  // One transformation reduces the shell, but the points are too uneven to remove ab.
  const Shell_transformation::Outcome outcome = transformation(ab);
  std::cout << "transformation: "
            << (outcome == Shell_transformation::REMOVED ? "removed" :
                outcome == Shell_transformation::REDUCED ? "reduced" : "unchanged") << std::endl;
  if(! find_edge(tr, a, b, ab))
    return EXIT_SUCCESS;

  // Recursion also transforms the shells of link edges, here up to two levels deep.
  const bool is_removed = transformation.remove_edge(ab, 2);
  std::cout << "removal: " << (is_removed ? "done" : "failed") << std::endl;
  find_edge(tr, a, b, ab);
  std::cout << transformation.number_of_transformations() << " covering meshes were replaced" << std::endl;
  return is_removed ? EXIT_SUCCESS : EXIT_FAILURE;
}
