// Reads and repairs surfaces as the programs do it.

#include "module_types.h"

#include "divide_polygons.h"
#include "patches_by_angle.h"
#include "read_surface.h"
#include "repair_surface.h"

namespace boundary_recovery {
namespace {

Surface_arrays plain_surface(const Surface<Point_3>& surface)
{
  Surface_arrays arrays;
  arrays.points = Rows<double>(surface.points.size(), 3);
  arrays.point_numbers = Rows<std::int64_t>(surface.points.size(), 1);
  for(std::size_t i = 0; i < surface.points.size(); ++i)
  {
    set_point(arrays.points, i, surface.points[i]);
    arrays.point_numbers[i][0] = static_cast<std::int64_t>(surface.file_vertices[i]);
  }
  arrays.triangles = Rows<std::int64_t>(surface.faces.size(), 3);
  arrays.triangle_numbers = Rows<std::int64_t>(surface.faces.size(), 1);
  arrays.patches = Rows<std::int32_t>(surface.faces.size(), 1);
  for(std::size_t i = 0; i < surface.faces.size(); ++i)
  {
    if(surface.faces[i].size() != 3)
    {
      arrays.message = "face " + std::to_string(surface.file_faces[i]) + " is not a triangle";
      return arrays;
    }
    for(std::size_t j = 0; j < 3; ++j)
      arrays.triangles[i][j] = static_cast<std::int64_t>(surface.faces[i][j]);
    arrays.triangle_numbers[i][0] = static_cast<std::int64_t>(surface.file_faces[i]);
    arrays.patches[i][0] = surface.patches[i];
  }
  arrays.patch_names = surface.patch_names;
  arrays.notes = surface.notes;
  return arrays;
}

} // namespace

Surface_arrays read_surface_file(const std::string& file)
{
  Surface<Point_3> surface;
  Surface_arrays arrays;
  if(! read_surface(file, surface, arrays.message))
    return arrays;
  Polygon_divider<Point_3> divide(surface);
  divide(false);
  if(! surface.has_patches() && is_triangle_soup(surface))
    set_patches_by_angle(surface, default_patch_angle);
  return plain_surface(surface);
}

Surface_arrays repair_surface(const Point_rows& points, const Index_rows& triangles, const double tolerance)
{
  const Points p = as_points(points);
  Surface<Point_3> surface = make_surface(std::vector<Point_3>(p.begin(), p.end()), as_rows<3>(triangles));
  const Repair_changes changes = Surface_repairer<Point_3>(surface)(tolerance, false);
  Surface_arrays arrays = plain_surface(surface);
  if(! changes.is_possible)
    arrays.message = "the surface cannot be repaired: a triangle names a point that does not exist, or a point has no "
                     "finite coordinates";
  arrays.changes.add("number_of_merged_points", changes.merged_vertices.size());
  arrays.changes.add("number_of_degenerate_triangles", changes.degenerate_faces.size());
  arrays.changes.add("number_of_duplicate_triangles", changes.duplicate_faces.size());
  arrays.changes.add("number_of_reversed_triangles", changes.reversed_faces.size());
  arrays.changes.add("number_of_divided_triangles", changes.divided_faces.size());
  arrays.changes.add("number_of_new_points", changes.number_of_new_points);
  arrays.changes.add("open_edges_before", changes.open_edges[0]);
  arrays.changes.add("open_edges_after", changes.open_edges[1]);
  arrays.changes.add("intersections_before", changes.intersections[0]);
  arrays.changes.add("intersections_after", changes.intersections[1]);
  return arrays;
}

} // namespace boundary_recovery
