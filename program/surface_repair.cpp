// Repairs and remeshes surfaces.

#include "surface_tools.h"

#include "remesh_surface.h"
#include "repair_surface.h"

Repair_changes repair(Input_surface& surface, const double tolerance, const bool fuses)
{
  return Surface_repairer<Input_point>(surface)(tolerance, fuses);
}

Remeshing_changes remesh(Input_surface& surface, const double angle, const double largest_edge)
{
  return Surface_remesher<Input_point>(surface)(angle, largest_edge);
}
