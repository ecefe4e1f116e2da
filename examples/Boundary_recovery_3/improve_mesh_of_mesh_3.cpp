#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Triangulation_3.h>
#include <CGAL/improve_mesh_quality.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>

typedef CGAL::Exact_predicates_inexact_constructions_kernel         Kernel;
typedef Kernel::Point_3                                             Point_3;
typedef CGAL::Labeled_mesh_domain_3<Kernel>                         Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type                    Mesh_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Mesh_triangulation> Complex;
typedef CGAL::Mesh_criteria_3<Mesh_triangulation>                   Criteria;
typedef CGAL::Triangulation_3<Mesh_triangulation::Geom_traits,
                              Mesh_triangulation::Triangulation_data_structure> Triangulation;
typedef Triangulation::Cell_handle                                  Cell_handle;
typedef Triangulation::Vertex_handle                                Vertex_handle;

// The facets of the surface, and those between regions.
std::set<std::set<Vertex_handle> > surface(const Triangulation& tr)
{
  std::set<std::set<Vertex_handle> > result;
  for(const auto& f : tr.finite_facets())
    if(f.first->is_facet_on_surface(f.second))
    {
      std::set<Vertex_handle> vertices;
      for(int i = 1; i < 4; ++i)
        vertices.insert(f.first->vertex((f.second + i) % 4));
      result.insert(vertices);
    }
  return result;
}

int main()
{
  // Somebody else's mesh: an ellipsoid, as Mesh_3's refinement leaves it.
  namespace params = CGAL::parameters;
  const auto ellipsoid = [](const Point_3& p) { return p.x() * p.x() + 2 * p.y() * p.y() + 3 * p.z() * p.z() - 1; };
  const Domain domain = Domain::create_implicit_mesh_domain(ellipsoid, Kernel::Sphere_3(CGAL::ORIGIN, 4.));
  const Criteria criteria(params::facet_angle = 25, params::facet_size = 0.2, params::facet_distance = 0.02,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.2);
  const Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, params::no_perturb(), params::no_exude());

  //! [all]
  // The copy has the same points and indices; weights of points are not asked for any more.
  Triangulation tr = CGAL::convert_to_triangulation_3(complex);
  const auto surface_before = surface(tr);
  const auto result = CGAL::improve_mesh_quality(tr);
  std::cout << result << std::endl;
  //! [all]

  //! [some]
  // Only cells on one side, and these to a higher angle. Facets to other cells are not changed.
  std::map<Cell_handle, bool> is_selected;
  for(const Cell_handle c : tr.all_cell_handles())
    is_selected[c] = ! tr.is_infinite(c) && c->vertex(0)->point().x() > 0;
  const auto on_one_side = CGAL::improve_mesh_quality(
    tr, params::min_dihedral_angle(25.), params::cell_is_selected_map(boost::make_assoc_property_map(is_selected)));
  std::cout << on_one_side << std::endl;
  //! [some]

  const bool is_right = tr.is_valid() && ! surface_before.empty() && surface(tr) == surface_before
                     && result.after.min_dihedral_angle >= result.before.min_dihedral_angle
                     && on_one_side.before.number_of_cells < result.after.number_of_cells
                     && on_one_side.after.min_dihedral_angle >= on_one_side.before.min_dihedral_angle;
  return result && on_one_side && is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
