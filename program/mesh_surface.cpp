// Reads a triangulated surface, and writes a mesh of its inside with tetrahedra of the sizes that are asked for.
// `mesh_surface --help` tells the options.

#include <CGAL/make_boundary_constrained_mesh_3.h>

#include "bad_tetrahedra.h"
#include "default_flow.h"
#include "domain.h"
#include "domain_quality.h"
#include "edge_lengths.h"
#include "large_pages.h"
#include "live_progress_bar.h"
#include "mesh_size.h"
#include "mesh_surface_options.h"
#include "meshing_estimate.h"
#include "named_regions.h"
#include "print_mesh.h"
#include "print_result.h"
#include "program.h"
#include "progress_estimate.h"
#include "round_number.h"
#include "second_order.h"
#include "terminal.h"
#include "write_mesh_report.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef Kernel::Point_3                                               Point;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
typedef CGAL::Boundary_constrained_mesh_result_3<Triangulation>       Result;
typedef CGAL::Boundary_recovery_3::Meshing_status                     Status;
typedef Mesh_size<Triangulation>                                      Size;

// what is known of the mesh when it is made
struct Measurements
{
  Mesh_quality quality;
  Edge_lengths edges;
  std::vector<Bad_tetrahedron> bad_tetrahedra;
  double seconds_total = 0;    // of all that makes the mesh
  double seconds_recovery = 0; // without the insertion of the surface's points
};

// Tells which share of the whole run is done. Places of names that are wrong end the work before anything takes long.
class Progress
  : public CGAL::Default_meshing_visitor_3
{
  typedef CGAL::Boundary_recovery_3::Phase        Phase;
  typedef CGAL::Boundary_recovery_3::Phase_report Phase_report;

  static constexpr double bytes_per_triangle = 1000, bytes_per_cell = 170; // that meshing them takes

  const Triangulation& m_tr;
  const Surface<Point>& m_surface;
  const bool m_is_quiet;
  Live_progress_bar<Meshing_estimate> m_bar;
  Large_pages m_pages;
  Named_regions m_regions;
  std::size_t m_number_of_expected_cells = 0;

public:
  Progress(const Triangulation& tr, const Surface<Point>& surface, const Meshing_options& options)
    : m_tr(tr), m_surface(surface), m_is_quiet(options.quiet),
      m_bar(std::cout, ! options.quiet && stdout_is_terminal(), options), m_pages(options.number_of_threads != 1)
  { }

  // of the steps that are not the library's
  void begin(const Step step) { m_bar.tell([=](Meshing_estimate& estimate) { estimate.begin(step); }); }

  void set_part_of_step(const double part)
  {
    m_bar.tell([=](Meshing_estimate& estimate) { estimate.set_part_of_step(part); });
  }

  void begin_reading(const std::string& file)
  {
    m_bar.tell([&](Meshing_estimate& estimate) { estimate.set_file(file); });
  }

  // The surface is ready to be meshed.
  void set_surface()
  {
    m_pages.reserve(bytes_per_triangle * double(m_surface.faces.size()));
    m_bar.tell([this](Meshing_estimate& estimate) { estimate.set_surface(m_surface); });
  }

  // before anything is printed
  void hide() { m_bar.hide(); }

  void on_phase_begin(const Phase phase)
  {
    m_bar.tell([=](Meshing_estimate& estimate) { estimate.begin_phase(phase); });
    if(phase == Phase::field_point_insertion) // not before: the library has checked now that the mesh fits into memory
      m_pages.reserve(bytes_per_cell * double(std::exchange(m_number_of_expected_cells, 0)));
  }

  // The forecast is told at once, on a terminal or not.
  void on_phase_end(const Phase_report& report)
  {
    m_bar.tell([&](Meshing_estimate& estimate) { estimate.end_phase(report); });
    if(report.phase == Phase::field_point_insertion)
      m_pages.end_fetching();
    if(report.phase == Phase::forecast)
      m_number_of_expected_cells = report.number_of_cells - (std::min)(report.number_of_cells,
                                                                       m_tr.number_of_finite_cells());
    if(report.phase == Phase::forecast && ! m_is_quiet)
    {
      hide();
      std::cout << "about " << round_number(double(report.number_of_cells)) << " tetrahedra are to be expected"
                << std::endl;
    }
    if(report.phase == Phase::domain_marking)
      m_regions.find(m_tr, m_surface.regions);
  }

  void on_progress(const Phase phase, const std::size_t done, const std::size_t total)
  {
    if(total > 0)
      m_bar.tell([=](Meshing_estimate& estimate) { estimate.set_progress(phase, done, total); });
  }

  bool go_further() { return m_regions.message().empty(); }

  const Named_regions& regions() const { return m_regions; }
};

Result mesh(Triangulation& tr, const Surface<Point>& surface, const Size& size, const Meshing_options& options,
            Progress& progress)
{
  const auto common = CGAL::parameters::visitor(std::ref(progress)).maximum_running_time(options.time_limit);
  const auto defects = CGAL::parameters::list_defects(options.list_defects);
  const auto vertices = CGAL::parameters::maximum_number_of_vertices(options.maximum_number_of_vertices);
  const auto improve = CGAL::parameters::improve_quality(options.improve_quality && options.insert_field_points);
  const auto angle = CGAL::parameters::min_dihedral_angle(options.min_angle);
  const auto effort = CGAL::parameters::improvement_effort(options.effort);
  const auto subdomains = CGAL::parameters::number_of_subdomains(options.number_of_subdomains);
  const auto threads = CGAL::parameters::number_of_threads(options.number_of_threads);
  const auto voids = CGAL::parameters::void_points(surface.voids);
  return CGAL::make_boundary_constrained_mesh_3(tr, surface.points, surface.faces,
                                                options.insert_field_points ? size : Size::unbounded(),
                                                common, defects, vertices, improve, angle, effort, subdomains, threads,
                                                voids);
}

// the regions, unless they are not known: only what is outside would be written otherwise
Domain<Point> make_domain(const Triangulation& tr, const Result& result, const Meshing_options& options)
{
  return reason_for_no_mesh(result, options.maximum_number_of_vertices).empty() ? make_meshed_domain(tr, result)
                                                                                : Domain<Point>();
}

// without the Delaunay insertion, as `recover_boundary` tells it: the phases of the recovery are not all of it
double seconds_of_recovery(const Result& result)
{
  double seconds = make_seconds(result.seconds, result.recovery.phases).recovery - result.filling.seconds
                   - result.improvement.seconds;
  for(const auto& phase : result.phases)
    if(phase.phase == CGAL::Boundary_recovery_3::Phase::domain_marking)
      seconds -= phase.seconds;
  return seconds;
}

bool is_anybody_told(const Meshing_options& options) { return ! options.quiet || ! options.report.empty(); }

// The quality of millions of tetrahedra takes a while: it is measured only if anybody is told, by all threads. The
// parts of the step are shares of its time, as measured; the first one is that of what `run()` collects before.
Measurements measure(const Triangulation& tr, const Domain<Point>& domain, const Size& size, const Result& result,
                     const double seconds, const Meshing_options& options, Progress& progress)
{
  Measurements measured;
  measured.seconds_total = seconds;
  measured.seconds_recovery = seconds_of_recovery(result);
  if(is_anybody_told(options) && ! domain.tetrahedra.empty())
  {
    measured.quality = measure_quality(domain);
    progress.set_part_of_step(0.59);
    measured.edges = measure_edges(tr, size);
    progress.set_part_of_step(0.98);
    measured.bad_tetrahedra = Bad_tetrahedra_list<Triangulation>(tr, domain, result.improvement.certificate.cells)();
  }
  return measured;
}

void write_entries(Json_writer& json, const Meshing_options& options, const Result& result,
                   const Domain<Point>& domain, const Measurements& measured)
{
  write_options(json, options);
  json.entry("status", to_string(result.status));
  json.entry("recovery_status", to_string(result.recovery.status));
  Report_writer<Result::Recovery> write_recovery(json);
  write_recovery(result.recovery);
  write_meshing(json, result);
  json.entry("number_of_steiner_points_in_domain", domain.number_of_steiner_points);
  json.entry("number_of_points", domain.points.size());
  json.entry("number_of_triangles", domain.triangles.size());
  json.entry("number_of_tetrahedra", domain.tetrahedra.size());
  write_quality(json, measured.quality);
  write_edges(json, measured.edges);
  json.entry("seconds", measured.seconds_total);
  json.entry("seconds_recovery", measured.seconds_recovery);
  json.entry("seconds_field_points", result.filling.seconds);
  if(! is_improved(result))
    return;
  json.entry("seconds_improvement", result.improvement.seconds);
  write_improvement(json, result.improvement, measured.bad_tetrahedra);
}

void print_timing(const Result& result, const Measurements& measured)
{
  std::cout << "@@rec " << measured.seconds_recovery << "\n@@fill " << result.filling.seconds
            << "\n@@improve " << result.improvement.seconds << "\n@@tmesh " << measured.seconds_total << std::endl;
}

// tells what is wrong with the input: the surface, a place, or a size
int refuse(const Result& result, const Program<Point>& program)
{
  if(result.recovery.status == CGAL::Boundary_recovery_3::Recovery_status::invalid_input)
    return program.refuse_input(result.recovery);
  for(const std::size_t v : result.invalid_void_points)
  {
    std::ostringstream message;
    message << "no region has the place (" << program.surface().voids[v]
            << ") that is to be empty: it is outside, or on the surface";
    program.fail(message.str());
  }
  for(const auto& invalid : result.filling.invalid_sizes)
  {
    std::ostringstream message;
    message << "invalid input, the size at (" << invalid.point << ") is " << invalid.size
            << (invalid.message.empty() ? "" : ": ") << invalid.message;
    program.fail(message.str());
  }
  return invalid_input;
}

// The surface stays as it is, whatever the size is: beside large triangles, cells are large, and flat.
void print_large_triangles(std::ostream& os, const Surface<Point>& surface, const double size)
{
  const auto is_large = [&](const std::vector<std::size_t>& face)
  {
    const auto length = [&](const std::size_t i, const std::size_t j)
    { return std::sqrt(CGAL::squared_distance(surface.points[face[i]], surface.points[face[j]])); };
    return (std::max)({ length(0, 1), length(1, 2), length(2, 0) }) > 2 * size;
  };
  const auto n = std::count_if(surface.faces.begin(), surface.faces.end(), is_large);
  if(n > 0)
    os << "note: " << count(static_cast<std::size_t>(n), "triangle")
       << " of the surface with edges longer than twice the size; --remesh-surface " << size << " divides them"
       << std::endl;
}

// writes the files, and tells how it went; returns the exit status
int finish(const Meshing_options& options, Program<Point>& program, const Result& result, const Domain<Point>& domain,
           const Measurements& measured, Progress& progress)
{
  progress.begin(writing);
  const bool is_report_written =
    program.write_report([&](Json_writer& json) { write_entries(json, options, result, domain, measured); });
  progress.hide();
  if(! is_report_written)
    return program.fail();
  if(result.status == Status::invalid_input)
    return refuse(result, program);
  const std::string& wrong_region = progress.regions().message();
  if(! wrong_region.empty())
  {
    program.fail(wrong_region);
    program.explain_open_surface();
    return invalid_input;
  }

  if(options.timing)
    print_timing(result, measured);
  const std::string reason = reason_for_no_mesh(result, options.maximum_number_of_vertices);
  if(! reason.empty())
  {
    program.fail("there is no mesh: " + reason);
    if(result.status == Status::no_region)
      program.explain_open_surface();
    return incomplete_or_stopped;
  }
  const bool are_written = program.write_outputs(domain, [&](const double part) { progress.set_part_of_step(part); });
  progress.hide();
  if(! are_written)
    return program.fail();
  const std::string unfinished = reason_for_unfinished_mesh(result);
  if(options.quiet && ! unfinished.empty())
    program.fail(unfinished);
  if(! options.quiet)
  {
    const auto print = options.verbose ? print_mesh<Result, Domain<Point> > : print_result<Result, Domain<Point> >;
    print(std::cout, result, domain, measured.quality, measured.edges, measured.bad_tetrahedra, measured.seconds_total);
    program.print_outputs();
    if(options.size > 0 && ! needles_matter(measured.bad_tetrahedra)) // for which the remedy is the same
      print_large_triangles(std::cout, program.surface(), options.size);
    program.warn_of_idle_faces();
  }
  return result ? success : incomplete_or_stopped;
}

int run(const Meshing_options& options, Program<Point>& program)
{
  Triangulation tr;
  Progress progress(tr, program.surface(), options);
  Size size;
  std::string message;
  if(! program.keeps_inputs(input_files(options)))
    return program.fail();
  progress.begin_reading(options.input);
  const bool is_read = program.read_surface(default_flow<Point>);
  progress.hide();
  if(! is_read)
    return program.fail();
  if(! size.read(options, message))
    return program.fail(message);
  if(! program.can_write())
    return program.fail();
  program.prepare_surface();
  program.add_places(options.regions, options.voids);

  progress.set_surface();
  CGAL::Real_timer timer;
  timer.start();
  size.set_surface(program.surface(), options);
  Result result = mesh(tr, program.surface(), size, options, progress);
  timer.stop();

  progress.begin(measuring);
  Domain<Point> domain = make_domain(tr, result, options);
  const bool is_refused = ! progress.regions().message().empty() || result.status == Status::no_region ||
                          result.status == Status::invalid_input;
  if(is_refused || (domain.number_of_regions > 0 && is_anybody_told(options)))
    program.find_open_surface(domain);
  program.use_numbers_of_file(result.recovery, domain);
  domain.region_names = progress.regions().names();
  progress.set_part_of_step(0.45);
  const Measurements measured = measure(tr, domain, size, result, timer.time(), options, progress);
  if(options.order == 2 && ! options.outputs.empty())
    add_edge_points(domain);
  return finish(options, program, result, domain, measured, progress);
}

// What is done with the mesh takes threads, too.
int run_with_threads(const Meshing_options& options, Program<Point>& program)
{
  int status = success;
  CGAL::Boundary_recovery_3::internal::with_threads(options.number_of_threads, [&] { status = run(options, program); });
  return status;
}

int main(int argc, char* argv[])
{
  Large_pages::use_one_heap();
  return run_program<Point, Meshing_command_line, Meshing_options>("mesh_surface", argc, argv, run_with_threads);
}
