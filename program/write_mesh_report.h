#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MESH_REPORT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MESH_REPORT_H

#include "bad_tetrahedra.h"
#include "domain_quality.h"
#include "edge_lengths.h"
#include "mesh_surface_options.h"
#include "write_report.h"

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

// what the user asked for
inline void write_options(Json_writer& json, const Meshing_options& options)
{
  json.key("size"); // null: from the surface
  json.value(options.size > 0 ? options.size : std::numeric_limits<double>::quiet_NaN());
  json.entry("sources", options.sources);
  json.entry("background", options.background);
  json.entry("grading", options.grading);
  json.entry("insert_field_points", options.insert_field_points);
  json.entry("number_of_subdomains", options.number_of_subdomains);
  json.entry("order", options.order);
}

// how the phases after the recovery went
template <typename Result>
void write_meshing(Json_writer& json, const Result& result)
{
  json.entry("number_of_regions", result.number_of_regions);
  json.entry("forecast_of_tetrahedra", result.filling.forecast_of_cells);
  json.entry("forecast_of_vertices", result.filling.forecast_of_vertices);
  json.entry("number_of_field_points", result.filling.number_of_field_points);
  json.entry("is_field_resolved", result.filling.is_field_resolved);
  json.entry("number_of_meshed_subdomains", result.number_of_subdomains);
  json.key("invalid_sizes");
  json.objects(result.filling.invalid_sizes, [&](const auto& invalid)
  {
    json.key("point");
    json.point(invalid.point);
    json.entry("size", invalid.size);
    json.entry("message", invalid.message);
  });
  json.key("meshing_phases");
  json.objects(result.phases, [&](const CGAL::Boundary_recovery_3::Phase_report& phase)
  {
    json.entry("name", to_string(phase.phase));
    json.entry("number_of_vertices", phase.number_of_vertices);
    json.entry("number_of_cells", phase.number_of_cells);
    json.entry("seconds", phase.seconds);
  });
}

// a list of angles in degrees, and one of the tetrahedra that each of them holds for
template <typename Angles, typename Numbers>
void write_counts(Json_writer& json, const std::string& name, const Angles& angles, const Numbers& numbers)
{
  json.key(name);
  json.begin('{');
  for(std::size_t i = 0; i < angles.size(); ++i)
    json.entry(std::to_string(static_cast<int>(angles[i])), numbers[i]);
  json.end('}');
}

inline void write_quality(Json_writer& json, const Mesh_quality& quality)
{
  json.entry("min_dihedral_angle", quality.smallest_angle);
  json.entry("max_dihedral_angle", quality.largest_angle);
  json.key("histogram_of_dihedral_angles"); // of ten degrees each
  json.list(quality.histogram, [&](const std::size_t n) { json.value(n); });
  write_counts(json, "tetrahedra_with_angle_below", Mesh_quality::small_angles, quality.below);
  write_counts(json, "tetrahedra_with_angle_above", Mesh_quality::large_angles, quality.above);
}

inline void write_edges(Json_writer& json, const Edge_lengths& edges)
{
  json.entry("number_of_edges_inside", edges.number_of_edges);
  json.entry("number_of_edges_in_size", edges.number_in_range);
  json.entry("number_of_edges_below_size", edges.number_below);
  json.entry("number_of_edges_above_size", edges.number_above);
  json.entry("mean_length_by_size", edges.mean());
  json.entry("max_length_by_size", edges.maximum);
}

inline void write_figures(Json_writer& json, const std::string& name,
                          const CGAL::Boundary_recovery_3::Mesh_quality_3& quality)
{
  json.key(name);
  json.begin('{');
  json.entry("number_of_tetrahedra", quality.number_of_cells);
  json.entry("min_dihedral_angle", quality.min_dihedral_angle);
  json.entry("max_dihedral_angle", quality.max_dihedral_angle);
  json.key("histogram_of_smallest_angles"); // of five degrees each
  json.list(quality.histogram, [&](const std::size_t n) { json.value(n); });
  write_counts(json, "tetrahedra_with_angle_below", Mesh_quality::small_angles, quality.numbers_of_cells_below);
  write_counts(json, "tetrahedra_with_angle_above", Mesh_quality::large_angles, quality.numbers_of_cells_above);
  json.entry("mean_radius_ratio", quality.mean_radius_ratio);
  json.entry("min_radius_ratio", quality.min_radius_ratio);
  json.entry("share_of_edges_in_size", quality.share_of_edges_in_size);
  json.end('}');
}

inline void write_bad_tetrahedron(Json_writer& json, const Bad_tetrahedron& bad)
{
  json.entry("tetrahedron", bad.tetrahedron);
  json.entry("min_dihedral_angle", bad.min_dihedral_angle);
  json.key("edge");
  json.list(bad.edge, [&](const Point_number v) { json.value(std::size_t(v)); });
  json.entry("reason", to_string(bad.reason));
  if(bad.facets.empty())
    return;
  json.entry("surface_angle", bad.surface_angle);
  if(bad.reason == CGAL::Boundary_recovery_3::Bad_cell_reason::gap)
    json.entry("distance", bad.distance);
  json.key("facets");
  json.objects(bad.facets, [&](const Bad_tetrahedron::Facet& facet)
  {
    if(facet.triangle != Bad_tetrahedron::Facet::no_triangle)
      json.entry("triangle", facet.triangle);
    json.key("points");
    json.list(facet.points, [&](const Point_number v) { json.value(std::size_t(v)); });
  });
}

// what the improvement did, and the whole certificate
template <typename Improvement>
void write_improvement(Json_writer& json, const Improvement& improvement, const std::vector<Bad_tetrahedron>& bad)
{
  using CGAL::Boundary_recovery_3::Bad_cell_reason;

  json.key("improvement");
  json.begin('{');
  json.entry("status", to_string(improvement.status));
  json.entry("number_of_rounds", improvement.counts.number_of_rounds);
  json.entry("number_of_removed_edges", improvement.counts.number_of_removed_edges);
  json.entry("number_of_removed_facets", improvement.counts.number_of_removed_facets);
  json.entry("number_of_moved_vertices", improvement.counts.number_of_moved_vertices);
  json.entry("number_of_inserted_points", improvement.counts.number_of_inserted_points);
  json.entry("number_of_removed_vertices", improvement.counts.number_of_removed_vertices);
  json.entry("is_measured", improvement.is_measured); // else there was no time left
  json.entry("is_certificate_complete", improvement.certificate.is_complete);
  write_figures(json, "before", improvement.before);
  write_figures(json, "after", improvement.after);
  json.entry("target_angle", improvement.certificate.min_dihedral_angle);
  for(const auto reason : { Bad_cell_reason::forced, Bad_cell_reason::gap, Bad_cell_reason::needle,
                            Bad_cell_reason::not_improved })
    json.entry(std::string("number_of_") + to_string(reason), improvement.certificate.number_of_cells(reason));
  json.key("bad_tetrahedra");
  json.objects(bad, [&](const Bad_tetrahedron& b) { write_bad_tetrahedron(json, b); });
  json.end('}');
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_MESH_REPORT_H
