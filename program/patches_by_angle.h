#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PATCHES_BY_ANGLE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PATCHES_BY_ANGLE_H

#include "surface.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Patches of a surface that has none: they end where the angle between neighboring triangles differs from 180 degrees
// by at least the given angle, and where more or less than two triangles meet. Patches are numbered by their first
// triangles. None is set if a triangle has a vertex twice.
template <typename Point>
void set_patches_by_angle(Surface<Point>& surface, const double angle)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  typedef CGAL::Surface_mesh<Point> Mesh;

  const auto is_degenerate = [](const auto& face)
  { return face[0] == face[1] || face[1] == face[2] || face[2] == face[0]; };
  if(std::any_of(surface.faces.begin(), surface.faces.end(), is_degenerate))
    return;

  // Edges of more than two triangles become several, each of two triangles at most, or of one.
  std::vector<Point> points = surface.points;
  std::vector<std::vector<std::size_t> > faces = surface.faces;
  PMP::orient_polygon_soup(points, faces);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);

  const auto is_sharp = mesh.template add_property_map<typename Mesh::Edge_index, bool>("e:is_sharp", false).first;
  const auto patch = mesh.template add_property_map<typename Mesh::Face_index, int>("f:patch", 0).first;
  PMP::sharp_edges_segmentation(mesh, angle, is_sharp, patch);

  std::vector<int> number; // of CGAL's patches, which are numbered from 1 in an order of its own
  int number_of_patches = 0;
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
  {
    const std::size_t p = static_cast<std::size_t>(patch[typename Mesh::Face_index(f)]);
    if(p >= number.size())
      number.resize(p + 1, 0);
    if(number[p] == 0)
      number[p] = ++number_of_patches;
    surface.patches[f] = number[p];
  }
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PATCHES_BY_ANGLE_H
