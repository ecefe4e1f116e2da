#include "mesh_collection.h"
#include "size_field.h"

#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <functional>
#include <sstream>

namespace boundary_recovery {

typedef CGAL::Boundary_constrained_mesh_result_3<Triangulation> Result;

namespace {

Result make_mesh(Triangulation& tr, const Point_rows& points, const Index_rows& triangles, const Index_rows& edges,
                 const Size_field& size, const Options& options, Visitor& visitor)
{
  namespace params = CGAL::parameters;
  typedef BR3::Recovery_mode Mode;
  typedef BR3::Recovery_effort Effort;
  const auto mode = value_named(options.mode, { Mode::constrained, Mode::conforming, Mode::flips_only });
  const auto effort = value_named(options.recovery_effort, { Effort::more_time, Effort::more_points });
  return CGAL::make_boundary_constrained_mesh_3(
    tr, as_points(points), as_rows<3>(triangles), size,
    params::visitor(std::ref(visitor)).maximum_running_time(options.time_limit),
    params::recovery_mode(mode), params::effort(effort), params::constrained_edges(as_rows<2>(edges)),
    params::list_defects(options.list_defects), params::maximum_number_of_defects(options.max_defects),
    params::maximum_number_of_vertices(options.max_vertices), params::number_of_threads(options.threads),
    params::improve_quality(options.improve && options.insert_field_points),
    params::min_dihedral_angle(options.min_angle), params::improvement_effort(effort_of(options)));
}

Record recovery_record(const Result::Recovery& recovery)
{
  Record record;
  record.add("status", to_string(recovery.status));
  record.add("number_of_edges", recovery.number_of_edges);
  record.add("number_of_facets", recovery.number_of_facets);
  record.add("number_of_missing_edges", recovery.missing_edges.size());
  record.add("number_of_missing_facets", recovery.missing_facets.size());
  record.add("number_of_steiner_points", recovery.steiner_vertices.size());
  record.add("number_of_shell_transformations", recovery.number_of_shell_transformations);
  return record;
}

Record filling_record(const Result::Filling& filling)
{
  Record record;
  record.add("status", to_string(filling.status));
  record.add("seconds", filling.seconds);
  record.add("forecast_of_cells", filling.forecast_of_cells);
  record.add("forecast_of_vertices", filling.forecast_of_vertices);
  record.add("number_of_field_points", filling.number_of_field_points);
  record.add("is_field_resolved", filling.is_field_resolved);
  return record;
}

// All that the library tells, but for what is in arrays of its own.
Record make_report(const Result& result)
{
  Record report;
  report.add("status", to_string(result.status));
  report.add("seconds", result.seconds);
  report.add("number_of_regions", result.number_of_regions);
  report.add("recovery", std::vector<Record>{ recovery_record(result.recovery) });
  report.add("filling", std::vector<Record>{ filling_record(result.filling) });
  report.add("improvement", std::vector<Record>{ improvement_record(result.improvement) });
  std::vector<Record> phases = plain_phases(result.recovery.phases);
  const std::vector<Record> later = plain_phases(result.phases);
  phases.insert(phases.end(), later.begin(), later.end());
  report.add("phases", std::move(phases));
  return report;
}

void collect_edges(const Result& result, Mesh& mesh)
{
  mesh.edges = Rows<std::int64_t>(result.constrained_edges.size(), 2);
  for(std::size_t i = 0; i < result.constrained_edges.size(); ++i)
    for(std::size_t j = 0; j < 2; ++j)
      mesh.edges[i][j] = result.constrained_edges[i][j]->index();
}

void collect_mesh(Triangulation& tr, const Result& result, const Point_rows& points, const Options& options, Mesh& mesh)
{
  const auto facets = result.recovery.surface_facets();
  Mesh_collection collection(tr, options.is_outside_wanted);
  collection.add_all(result.recovery.vertices);
  const std::size_t number = collection.add_used(result.recovery.steiner_vertices, facets);
  mesh.report.add("number_of_steiner_points_in_domain", number);
  collection.collect_points(points, mesh);
  collection.collect_cells(cells_of(result.improvement.certificate), mesh);
  collection.collect_facets(facets, mesh);
  collection.collect_bad_cells(result.improvement.certificate, mesh);
  collect_edges(result, mesh);
}

} // namespace

Mesh tetrahedralize(const Point_rows& points, const Index_rows& triangles, const Index_rows& edges, const Sizes& sizes,
                    const Options& options, Watch& watch)
{
  const Size_field size = options.insert_field_points ? Size_field(sizes, points, triangles) : Size_field();
  Visitor visitor(watch);
  Triangulation tr;
  const Result result = make_mesh(tr, points, triangles, edges, size, options, visitor);

  Mesh mesh;
  mesh.status = to_string(result.status);
  mesh.recovery_status = to_string(result.recovery.status);
  mesh.defects = plain_defects(result.recovery.defects);
  mesh.number_of_defects = result.recovery.number_of_defects;
  for(const auto* list : { &result.recovery.missing_edges, &result.recovery.missing_facets })
    for(const auto& simplex : *list)
      mesh.missing.push_back(plain_simplex(simplex));
  std::ostringstream message;
  for(const auto& invalid : result.filling.invalid_sizes)
    message << invalid;
  mesh.message = message.str();
  mesh.report = make_report(result);
  if(result.recovery.status != BR3::Recovery_status::invalid_input && ! result.recovery.vertices.empty())
    collect_mesh(tr, result, points, options, mesh);
  return mesh;
}

} // namespace boundary_recovery
