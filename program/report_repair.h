#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REPORT_REPAIR_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REPORT_REPAIR_H

#include "can_resolve_intersections.h"
#include "print_summary.h"
#include "surface_changes.h"
#include "write_report.h"

#include <CGAL/version.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

// prints what was changed, as counts
inline void print_repair(std::ostream& os, const Repair_changes& changes)
{
  if(! changes.is_possible)
  {
    os << "repair: nothing is done, as faces are no triangles, or have no points" << std::endl;
    return;
  }
  const auto print = [&](const std::size_t n, const std::string& noun, const std::string& what)
  {
    if(n > 0)
      os << "  " << count(n, noun) << ' ' << what << '\n';
  };
  os << "repair, with tolerance " << changes.tolerance << ":\n";
  print(changes.merged_vertices.size(), "point", "merged with another one");
  print(changes.flattened_vertices.size(), "point", "with a coordinate that became 0");
  print(changes.degenerate_faces.size(), "triangle", "without area dropped");
  print(changes.duplicate_faces.size(), "triangle", "dropped, there twice");
  print(changes.reversed_faces.size(), "triangle", "turned over");
  print(changes.number_of_stitched_edges, "edge", "stitched to points beside");
  print(changes.unfolded_faces.size(), "triangle", "folded flat replaced by others with the same border");
  print(changes.unfolded_vertices.size(), "point", "inside of these dropped");
  print(changes.divided_faces.size(), "triangle", "divided, into " + count(changes.number_of_parts, "part"));
  print(changes.number_of_new_points, "point", "added where triangles intersect");
  if(changes.is_fusion_wanted)
    os << (changes.is_fused ? "  bodies that overlap are fused\n"
                            : "  bodies are not fused: their triangles still intersect, or do not tell what is "
                              "inside\n");
  print(changes.inner_faces.size(), "triangle", "inside of a body dropped");
  print(changes.number_of_dust_regions, "region", "of dust joined with what is beside: too small or too thin");
  print(changes.dust_faces.size(), "triangle", "beside dust or in a fold dropped");
  os << "  open edges: " << changes.open_edges[0] << " before, " << changes.open_edges[1] << " after\n"
     << "  intersections: " << changes.intersections[0] << " before, " << changes.intersections[1] << " after\n";
  if(changes.intersections[1] > 0 && ! can_resolve_intersections)
    os << "  CGAL " << CGAL_VERSION_STR << " cannot resolve intersections, CGAL 6.0 can\n";
  os.flush();
}

// writes what was changed, with all the vertices and triangles
template <typename Surface>
void write_repair(Json_writer& json, const Repair_changes& changes, const Surface& surface)
{
  const auto value = [&](const std::size_t n) { json.value(n); };
  const auto list = [&](const std::string& name, const std::vector<std::size_t>& numbers)
  {
    json.entry("number_of_" + name, numbers.size());
    json.key(name);
    json.list(numbers, value);
  };
  json.key("repair");
  json.begin('{');
  json.entry("is_possible", changes.is_possible);
  json.entry("can_resolve_intersections", can_resolve_intersections);
  json.entry("tolerance", changes.tolerance);
  json.entry("is_tolerance_used", changes.is_tolerance_used);
  json.entry("number_of_merged_vertices", changes.merged_vertices.size());
  json.key("merged_vertices");
  json.list(changes.merged_vertices, [&](const std::array<std::size_t, 2>& pair) { json.list(pair, value); });
  list("flattened_vertices", changes.flattened_vertices);
  list("degenerate_facets", changes.degenerate_faces);
  list("duplicate_facets", changes.duplicate_faces);
  list("reversed_facets", changes.reversed_faces);
  list("unfolded_facets", changes.unfolded_faces);
  list("unfolded_vertices", changes.unfolded_vertices);
  list("divided_facets", changes.divided_faces);
  list("inner_facets", changes.inner_faces);
  list("dust_facets", changes.dust_faces);
  json.entry("is_fused", changes.is_fused);
  json.entry("number_of_dust_regions", changes.number_of_dust_regions);
  json.entry("number_of_stitched_edges", changes.number_of_stitched_edges);
  json.entry("number_of_parts_of_divided_facets", changes.number_of_parts);
  json.entry("number_of_new_points", changes.number_of_new_points);
  json.before_and_after("number_of_open_edges", changes.open_edges);
  json.before_and_after("number_of_intersections", changes.intersections);
  json.key("source_facets"); // of each triangle that was recovered
  json.list(surface.file_faces, [&](const std::size_t f) { json.number_or_null(f); });
  json.end('}');
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_REPORT_REPAIR_H
