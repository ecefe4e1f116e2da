// Reads a triangulated surface, recovers it in a Delaunay triangulation of its vertices, and writes the
// tetrahedra of the domain that it bounds. `recover_boundary --help` tells the options.

#include <CGAL/recover_boundary.h>

#include "default_surface.h"
#include "domain_quality.h"
#include "large_pages.h"
#include "print_summary.h"
#include "program.h"
#include "recover_boundary_options.h"
#include "recovered_domain.h"
#include "terminal.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>

#include <functional>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef Kernel::Point_3                                       Point;
typedef CGAL::Delaunay_triangulation_3<Kernel>                Triangulation;
typedef CGAL::Boundary_recovery_result_3<Triangulation>       Result;
typedef CGAL::Boundary_recovery_3::Recovery_status            Status;

// that recovering them takes where many edges are lost; what is not used takes no memory, as no thread fetches it
constexpr double bytes_per_triangle = 2000;

// recovers the faces of the surface in `tr`, which is empty at first: the call inserts the points, too
Result recover(Triangulation& tr, const Surface<Point>& surface, const Recovery_options& options,
               Progress_printer& progress)
{
  const auto common = CGAL::parameters::visitor(std::ref(progress)).maximum_running_time(options.time_limit);
  const auto mode = CGAL::parameters::recovery_mode(options.mode);
  const auto effort = CGAL::parameters::effort(options.effort);
  const auto defects = CGAL::parameters::list_defects(options.list_defects);
  if(options.max_recursion_level < 0)
    return CGAL::recover_boundary(tr, surface.points, surface.faces, common, mode, effort, defects);
  return CGAL::recover_boundary(tr, surface.points, surface.faces, common, mode, effort, defects,
                                CGAL::parameters::max_recursion_level(options.max_recursion_level));
}

void write_entries(Json_writer& json, const Recovery_options& options, const Result& result,
                   const Domain<Point>& domain, const Mesh_quality& quality, const Seconds& seconds)
{
  static constexpr const char* modes[] = { "constrained", "conforming", "flips_only" };
  json.entry("mode", modes[static_cast<int>(options.mode)]);
  json.entry("status", to_string(result.status));
  Report_writer<Result> write_result(json);
  write_result(result);
  json.entry("number_of_steiner_points_in_domain", domain.number_of_steiner_points);
  json.entry("number_of_points", domain.points.size());
  json.entry("number_of_tetrahedra", domain.tetrahedra.size());
  json.entry("number_of_regions", domain.number_of_regions);
  json.entry("domain", domain.tetrahedra.empty() ? "none" : domain.is_convex_hull ? "convex_hull" : "regions");
  json.entry("min_dihedral_angle", quality.smallest_angle);
  json.entry("max_dihedral_angle", quality.largest_angle);
  json.entry("seconds", seconds.total);
  json.entry("seconds_recovery", seconds.recovery);
}

int run(const Recovery_options& options, Program<Point>& program)
{
  if(! program.keeps_inputs({ options.input }) || ! program.read_surface(default_surface<Point>) ||
     ! program.can_write())
    return program.fail();
  program.prepare_surface();

  Large_pages pages(false); // recursive flips go back and forth in the mesh; in small pages, they take a tenth longer
  pages.reserve(bytes_per_triangle * double(program.surface().faces.size()));
  Triangulation tr;
  Progress_printer progress(std::cout, ! options.quiet && stdout_is_terminal());
  CGAL::Real_timer timer;
  timer.start();
  Result result = recover(tr, program.surface(), options, progress);
  timer.stop();
  const Seconds seconds = make_seconds(timer.time(), result.phases);

  Domain<Point> domain;
  if(result.status != Status::invalid_input)
    domain = make_recovered_domain(tr, result, options.keep_exterior);
  const Mesh_quality quality = measure_quality(domain);
  if(result || result.status == Status::invalid_input)
    program.find_open_surface(domain);
  program.use_numbers_of_file(result, domain);

  if(! program.write_report([&](Json_writer& json)
                            { write_entries(json, options, result, domain, quality, seconds); }))
    return program.fail();
  if(result.status == Status::invalid_input)
    return program.refuse_input(result);
  if(! program.write_outputs(domain))
    return program.fail();

  if(options.quiet && result.status == Status::stopped)
    program.fail("the time limit ended the work before the surface was recovered");
  if(! options.quiet)
  {
    print_summary(std::cout, result, domain, quality, seconds);
    if(domain.is_convex_hull)
      program.explain_open_surface();
    else
      program.warn_of_idle_faces();
    if(options.outputs.empty())
      std::cout << "no mesh is written; -o OUTPUT does that" << std::endl;
  }
  if(options.table)
    print_levels(std::cout, result.levels);
  if(options.timing)
    std::cout << "@@rec " << seconds.recovery << '\n' << "@@tmesh " << seconds.total << std::endl;
  return result ? success : incomplete_or_stopped;
}

int main(int argc, char* argv[])
{
  Large_pages::use_one_heap();
  return run_program<Point, Recovery_command_line, Recovery_options>("recover_boundary", argc, argv, run);
}
