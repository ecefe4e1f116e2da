#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/recover_boundary.h>

#include <cstdlib>
#include <iostream>
#include <string>

// With exact constructions, Steiner points are exactly on the edges and triangles.
typedef CGAL::Exact_predicates_exact_constructions_kernel   Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/schoenhardt_br3.off");
  if(! CGAL::IO::read_polygon_mesh(file, surface))
    return EXIT_FAILURE;

  Triangulation tr;
  const auto result = CGAL::recover_boundary(tr, surface,
    CGAL::parameters::recovery_mode(CGAL::Boundary_recovery_3::Recovery_mode::conforming));
  std::cout << result << ", " << result.steiner_vertices.size() << " Steiner points" << std::endl;

  for(const auto& part : result.parts_of_edges)
    std::cout << part.vertices[0]->point() << " to " << part.vertices[1]->point()
              << " is a part of the " << part.constraint << '\n';

  // The triangles without points on them are single facets of the triangulation, the others are several of them.
  const auto facets = result.surface_facets();
  bool is_exact = true;
  for(const auto& facet : facets)
  {
    const auto& corners = result.facets[facet.index];
    for(const auto v : facet)
      is_exact = is_exact && CGAL::coplanar(corners[0]->point(), corners[1]->point(), corners[2]->point(), v->point());
  }
  std::cout << num_faces(surface) << " triangles are " << facets.size() << " facets, and "
            << (is_exact ? "all" : "not all") << " of them are exactly in the planes of their triangles" << std::endl;
  return result && is_exact ? EXIT_SUCCESS : EXIT_FAILURE;
}
