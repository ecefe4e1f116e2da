#include "size_field.h"

#include <CGAL/remesh_holes.h>

#include <boost/property_map/function_property_map.hpp>

#include <functional>
#include <sstream>

namespace boundary_recovery {

typedef CGAL::Hole_remeshing_result_3<Point_3> Result;

namespace {

template <typename Rows_of_vectors, typename T>
void copy_rows(const std::vector<Rows_of_vectors>& rows, Rows<T>& result)
{
  constexpr std::size_t width = std::tuple_size<Rows_of_vectors>::value;
  result = Rows<T>(rows.size(), width);
  for(std::size_t i = 0; i < rows.size(); ++i)
    for(std::size_t j = 0; j < width; ++j)
      result[i][j] = static_cast<T>(rows[i][j]);
}

// New vertices and cells have the old number -1.
template <typename Number, typename T>
void copy_numbers(const std::vector<Number>& numbers, Rows<T>& result)
{
  result = Rows<T>(numbers.size(), 1);
  for(std::size_t i = 0; i < numbers.size(); ++i)
    result[i][0] = static_cast<T>(numbers[i]);
}

Record make_report(const Result& result)
{
  Record report;
  report.add("status", to_string(result.status));
  report.add("seconds", result.seconds);
  report.add("number_of_kept_vertices", result.number_of_kept_vertices);
  report.add("number_of_kept_cells", result.number_of_kept_cells);
  report.add("number_of_bad_cells", result.number_of_bad_cells);
  report.add("number_of_inverted_cells", result.number_of_inverted_cells);
  report.add("number_of_holes", result.number_of_holes);
  report.add("number_of_enlargements", result.number_of_enlargements);
  report.add("number_of_failures", result.number_of_failures);
  report.add("number_of_steiner_points", result.number_of_steiner_points);
  report.add("smallest_new_angle", result.smallest_new_angle);
  report.add("number_of_forced_cells", result.number_of_forced_cells);
  report.add("number_of_needles", result.number_of_needles);
  report.add("number_of_unimproved_cells", result.number_of_unimproved_cells);
  report.add("phases", plain_phases(result.phases));
  return report;
}

void collect(const Result& result, Remeshed& remeshed)
{
  Mesh& mesh = remeshed.mesh;
  mesh.status = to_string(result.status);
  mesh.report = make_report(result);
  mesh.defects = plain_defects(result.defects);
  mesh.number_of_defects = result.defects.size();
  std::ostringstream message;
  for(const auto& invalid : result.invalid_sizes)
    message << invalid;
  mesh.message = message.str();
  mesh.points = Rows<double>(result.points.size(), 3);
  for(std::size_t i = 0; i < result.points.size(); ++i)
    set_point(mesh.points, i, result.points[i]);
  copy_rows(result.tetrahedra, mesh.tetrahedra);
  copy_rows(result.facets, mesh.triangles);
  copy_rows(result.edges, mesh.edges);
  copy_numbers(result.regions, mesh.regions);
  copy_numbers(result.old_vertices, mesh.point_numbers);
  copy_numbers(result.old_cells, remeshed.tetrahedron_numbers);
  remeshed.location_cells = Rows<std::int64_t>(result.locations.size(), 1);
  remeshed.location_weights = Rows<double>(result.locations.size(), 4);
  for(std::size_t i = 0; i < result.locations.size(); ++i)
  {
    remeshed.location_cells[i][0] = static_cast<std::int64_t>(result.locations[i].cell);
    for(std::size_t j = 0; j < 4; ++j)
      remeshed.location_weights[i][j] = result.locations[i].coordinates[j];
  }
}

} // namespace

Remeshed remesh_holes(const Point_rows& points, const Index_rows& tetrahedra, const std::int64_t* const regions,
                      const unsigned char* const is_selected, const Index_rows& facets, const Index_rows& edges,
                      const Sizes* const sizes, const Options& options, Watch& watch)
{
  namespace params = CGAL::parameters;
  const auto selection = [is_selected](const std::size_t c) { return is_selected != nullptr && is_selected[c] != 0; };
  const auto region = [regions](const std::size_t c) { return regions == nullptr ? 1 : static_cast<int>(regions[c]); };
  Visitor visitor(watch);
  const auto common = params::visitor(std::ref(visitor)).maximum_running_time(options.time_limit)
                        .cell_is_selected_map(boost::make_function_property_map<std::size_t>(selection));
  const auto region_map = params::cell_region_map(boost::make_function_property_map<std::size_t>(region));
  const auto angle = params::min_dihedral_angle(options.min_angle);
  const auto improve = params::improve_quality(options.improve);
  const auto layers = params::number_of_layers(options.layers);
  const auto fixed_facets = params::constrained_facets(as_rows<3>(facets));
  const auto fixed_edges = params::constrained_edges(as_rows<2>(edges));

  const auto remesh = [&](const auto& ... size)
  {
    return CGAL::remesh_holes(as_points(points), as_rows<4>(tetrahedra), size..., common, region_map, angle, improve,
                              layers, fixed_facets, fixed_edges);
  };
  Remeshed remeshed;
  if(sizes == nullptr)
    collect(remesh(), remeshed);
  else
    collect(remesh(Size_field(*sizes, points, Index_rows())), remeshed);
  return remeshed;
}

} // namespace boundary_recovery
