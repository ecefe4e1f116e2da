// Meshes a bumpy ellipsoid with Mesh_3, and compares ways to improve that: improve_mesh_quality(), with both qualities;
// Mesh_3's perturbation and exudation; and a round of tetrahedral_isotropic_remeshing() that keeps the surface.
// Argument: the size of the cells (default: 0.05).

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/mesh_quality.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/improve_mesh_quality.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel         K;
typedef CGAL::Labeled_mesh_domain_3<K>                              Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type                    Mesh_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Mesh_triangulation> Complex;
typedef CGAL::Mesh_criteria_3<Mesh_triangulation>                   Criteria;

namespace params = CGAL::parameters;

double bumpy_ellipsoid(const K::Point_3& p)
{
  return p.x() * p.x() + 2 * p.y() * p.y() + 3 * p.z() * p.z() - 1 + 0.3 * std::sin(4 * p.x()) * std::sin(5 * p.y());
}

// `improve` returns the mesh that is measured.
template <typename Improve>
void measure(const std::string& name, const Improve& improve)
{
  CGAL::Real_timer timer;
  timer.start();
  const auto tr = improve();
  timer.stop();
  const auto quality = CGAL::Boundary_recovery_3::mesh_quality(tr);
  std::cout << name << "  " << quality.number_of_cells << " cells, angles from " << quality.min_dihedral_angle << " to "
            << quality.max_dihedral_angle << ", " << quality.numbers_of_cells_below[3]
            << " cells below 20, mean radius ratio " << quality.mean_radius_ratio << ", " << timer.time() << " s"
            << std::endl;
}

int main(int argc, char** argv)
{
  const double size = argc > 1 ? std::stod(argv[1]) : 0.05;
  const Domain domain = Domain::create_implicit_mesh_domain(bumpy_ellipsoid, K::Sphere_3(CGAL::ORIGIN, 4.));
  const Criteria criteria(params::facet_angle = 25, params::facet_size = size, params::facet_distance = size / 10,
                          params::cell_radius_edge_ratio = 2, params::cell_size = size);
  Complex complex;
  measure("refinement                  ", [&]
  {
    complex = CGAL::make_mesh_3<Complex>(domain, criteria, params::no_perturb(), params::no_exude());
    return CGAL::convert_to_triangulation_3(complex);
  });
  measure("improve_mesh_quality()      ", [&]
  {
    auto tr = CGAL::convert_to_triangulation_3(complex);
    CGAL::improve_mesh_quality(tr);
    return tr;
  });
  measure("  Volume_length_quality_3   ", [&]
  {
    auto tr = CGAL::convert_to_triangulation_3(complex);
    CGAL::improve_mesh_quality(tr, params::cell_quality(CGAL::Boundary_recovery_3::Volume_length_quality_3()));
    return tr;
  });
  measure("remeshing, one round        ", [&]
  {
    auto tr = CGAL::convert_to_triangulation_3(complex);
    CGAL::tetrahedral_isotropic_remeshing(tr, size, params::remesh_boundaries(false).number_of_iterations(1));
    return tr;
  });
  measure("perturbation, then exudation", [&]
  {
    CGAL::perturb_mesh_3(complex, domain, params::time_limit = 300);
    CGAL::exude_mesh_3(complex, params::time_limit = 300);
    return CGAL::convert_to_triangulation_3(complex);
  });
  return EXIT_SUCCESS;
}
