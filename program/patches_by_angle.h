#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PATCHES_BY_ANGLE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PATCHES_BY_ANGLE_H

#include "disjoint_sets.h"
#include "surface.h"
#include "surface_features.h"
#include "triangle_soup.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Patches of a surface that has none: they end where the angle between neighboring triangles differs from 180 degrees
// by at least the given angle, and where more or less than two triangles meet, whichever way they are turned. Patches
// are numbered by their first triangles. None is set if a triangle has a vertex twice.
template <typename Point>
void set_patches_by_angle(Surface<Point>& surface, const double angle)
{
  const auto& faces = surface.faces;
  const auto is_degenerate = [](const auto& face)
  { return face[0] == face[1] || face[1] == face[2] || face[2] == face[0]; };
  if(std::any_of(faces.begin(), faces.end(), is_degenerate))
    return;

  const auto normal_along = [&](const Triangle_edge& e) // of its triangle, turned so that it goes along the edge
  {
    const auto& p = surface.points;
    return CGAL::normal(p[e.vertices.first], p[e.vertices.second], p[e.opposite]);
  };
  Disjoint_sets sets(faces.size());
  visit_edges(faces, [&](const auto edge, const std::size_t number)
  {
    if(number == 2 && angle_between(normal_along(*edge), - normal_along(*(edge + 1))) < angle)
      sets.union_set(edge->triangle, (edge + 1)->triangle);
  });

  std::vector<int> numbers(faces.size(), 0); // by the triangles that stand for patches
  int number_of_patches = 0;
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    int& number = numbers[sets.find_set(f)];
    if(number == 0)
      number = ++number_of_patches;
    surface.patches[f] = number;
  }
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PATCHES_BY_ANGLE_H
