#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/recover_boundary.h>

#include <string>

bool name_of_status_is_known()
{
  return CGAL::Boundary_recovery_3::to_string(CGAL::Boundary_recovery_3::Recovery_status::recovered)
         == std::string("recovered");
}
