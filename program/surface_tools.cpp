// Reads surfaces, and does to them what takes little of CGAL.

#include "surface_tools.h"

#include "close_holes.h"
#include "divide_polygons.h"
#include "patches_by_angle.h"
#include "read_surface.h"

#include <string>
#include <vector>

bool read_input_surface(const std::string& file, Input_surface& surface, std::string& message)
{
  return read_surface(file, surface, message);
}

void divide_polygons(Input_surface& surface, const bool are_bent_allowed)
{
  Polygon_divider<Input_point> divide(surface);
  divide(are_bent_allowed);
}

std::vector<Hole> close_holes(Input_surface& surface, const double max_length)
{
  return Hole_closer<Input_point>(surface)(max_length);
}

void divide_into_patches(Input_surface& surface, const double angle)
{
  set_patches_by_angle(surface, angle);
}
