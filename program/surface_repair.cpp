// Repairs and remeshes surfaces.

#include "surface_tools.h"

#include "remesh_surface.h"
#include "repair_surface.h"

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;

} // namespace

Repair_changes repair(Input_surface& surface, const double tolerance, const bool fuses)
{
  return Surface_repairer<Point>(surface)(tolerance, fuses);
}

Remeshing_changes remesh(Input_surface& surface, const double angle, const double largest_edge)
{
  return Surface_remesher<Point>(surface)(angle, largest_edge);
}
