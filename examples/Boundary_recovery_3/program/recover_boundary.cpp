// Reads a triangulated surface, recovers it in a Delaunay triangulation of its vertices, and writes the
// tetrahedra of the domain that it bounds. `recover_boundary --help` tells the options.

#include <CGAL/recover_boundary.h>

#include "command_line.h"
#include "default_surface.h"
#include "print_summary.h"
#include "read_surface.h"
#include "repair_surface.h"
#include "report_repair.h"
#include "write_domain.h"
#include "write_report.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef Kernel::Point_3                                       Point;
typedef CGAL::Delaunay_triangulation_3<Kernel>                Triangulation;
typedef CGAL::Boundary_recovery_result_3<Triangulation>       Result;
typedef CGAL::Boundary_recovery_3::Recovery_status            Status;

#ifndef BOUNDARY_RECOVERY_3_VERSION // our CMakeLists.txt tells the version of the package
#define BOUNDARY_RECOVERY_3_VERSION "unknown"
#endif

enum Exit_status { recovered = 0, usage_or_file_error = 1, invalid_input = 2, incomplete_or_stopped = 3 };

// recovers the faces of the surface in `tr`, which is empty at first: the call inserts the points, too
Result recover(Triangulation& tr, const Surface<Point>& surface, const Options& options, Progress_printer& progress)
{
  const auto common = CGAL::parameters::visitor(std::ref(progress)).maximum_running_time(options.time_limit);
  const auto mode = CGAL::parameters::recovery_mode(options.mode);
  const auto defects = CGAL::parameters::list_defects(options.list_defects);
  if(options.max_recursion_level < 0)
    return CGAL::recover_boundary(tr, surface.points, surface.faces, common, mode, defects);
  return CGAL::recover_boundary(tr, surface.points, surface.faces, common, mode, defects,
                                CGAL::parameters::max_recursion_level(options.max_recursion_level));
}

// The surface has each point once and may lack vertices of the file, and its faces may be parts: translates to the
// numbers of the file.
void use_numbers_of_file(Result& result, Domain<Point>& domain, const Surface<Point>& surface)
{
  const auto translate = [&](Result::Input_simplex& simplex)
  {
    if(simplex.dimension == 0 && simplex.index != Result::Input_simplex::no_index)
      simplex.index = surface.file_vertex(simplex.index);
    if(simplex.dimension == 2 && simplex.index != Result::Input_simplex::no_index)
      simplex.index = surface.file_face(simplex.index);
    for(std::size_t& v : simplex.vertices)
      v = surface.file_vertex(v);
  };
  std::for_each(result.missing_edges.begin(), result.missing_edges.end(), translate);
  std::for_each(result.missing_facets.begin(), result.missing_facets.end(), translate);
  std::for_each(result.unrepresentable_constraints.begin(), result.unrepresentable_constraints.end(), translate);
  for(Result::Input_defect& defect : result.defects)
    std::for_each(defect.simplices.begin(), defect.simplices.end(), translate);
  for(std::size_t& patch : domain.patches) // these begin with 1
    patch = surface.file_face(patch - 1) + 1;
}

// whether a file can be opened for writing; leaves no trace of the trial
bool is_writable(const std::string& file)
{
  std::error_code ignored;
  const bool existed = std::filesystem::exists(file, ignored);
  const bool opened = std::ofstream(file, std::ios::app).is_open();
  if(opened && ! existed)
    std::filesystem::remove(file, ignored);
  return opened;
}

// The same file may have several names, by links. The only copy of a surface must not become a mesh of it.
bool is_input(const std::string& file, const Options& options)
{
  std::error_code ignored; // a file that does not exist yet
  return ! options.input.empty() && std::filesystem::equivalent(file, options.input, ignored);
}

int fail(const std::string& message)
{
  std::cerr << "recover_boundary: " << message << std::endl;
  return usage_or_file_error;
}

void print_defects(const Result& result)
{
  const std::size_t n = result.number_of_defects, listed = result.defects.size();
  const std::size_t shown = (std::min)(listed, std::size_t(10));
  std::cerr << "recover_boundary: invalid input, " << (n > listed ? "at least " : "") << n
            << (n == 1 ? " defect" : " defects") << '\n';
  for(std::size_t i = 0; i < shown; ++i)
    std::cerr << "  " << result.defects[i] << '\n';
  if(n > shown)
  {
    std::cerr << "  and " << n - shown << " more: --report lists ";
    if(n > listed)
      std::cerr << "the first " << listed << '\n';
    else
      std::cerr << "all of them\n";
  }
}

bool write_report(const Options& options, const Surface<Point>& surface, const Repair_changes& changes,
                  const Result& result, const Domain<Point>& domain, const std::array<double, 2>& angles,
                  const Seconds& seconds)
{
  static constexpr const char* modes[] = { "constrained", "conforming", "flips_only" };
  std::ofstream os(options.report);
  Json_writer json(os);
  json.begin('{');
  json.entry("program", "recover_boundary");
  json.entry("version", BOUNDARY_RECOVERY_3_VERSION);
  json.entry("cgal_version", CGAL_VERSION_STR);
  json.entry("input", options.input.empty() ? std::string("default surface") : options.input);
  json.key("notes");
  json.list(surface.notes, [&](const std::string& note) { json.value(note); });
  if(options.repair)
    write_repair(json, changes, surface);
  json.entry("mode", modes[static_cast<int>(options.mode)]);
  Report_writer<Result> write_result(json);
  write_result(result);
  json.entry("number_of_steiner_points_in_domain", domain.number_of_steiner_points);
  json.entry("number_of_points", domain.points.size());
  json.entry("number_of_tetrahedra", domain.tetrahedra.size());
  json.entry("number_of_regions", domain.number_of_regions);
  json.entry("domain", domain.tetrahedra.empty() ? "none" : domain.is_convex_hull ? "convex_hull" : "regions");
  json.entry("min_dihedral_angle", angles[0]);
  json.entry("max_dihedral_angle", angles[1]);
  json.entry("seconds", seconds.total);
  json.entry("seconds_recovery", seconds.recovery);
  json.end('}');
  os << '\n';
  os.close();
  return ! os.fail();
}

int run(const Options& options)
{
  std::vector<std::string> files = options.outputs;
  if(! options.report.empty())
    files.push_back(options.report);
  for(const std::string& file : files)
    if(is_input(file, options))
      return fail("the input would be overwritten: " + file);

  Surface<Point> surface;
  std::string message;
  if(options.input.empty())
    surface = default_surface<Point>();
  else if(! read_surface(options.input, surface, message))
    return fail(message);
  for(const std::string& file : files)
    if(! is_writable(file)) // better said now than after the work
      return fail("cannot write " + file);

  if(! options.quiet)
    for(const std::string& note : surface.notes)
      std::cout << "note: " << note << std::endl;

  Repair_changes changes;
  if(options.repair)
    changes = Surface_repairer<Point>(surface)(options.tolerance);
  if(options.repair && ! options.quiet)
    print_repair(std::cout, changes);

  Triangulation tr;
  Progress_printer progress(std::cout, ! options.quiet && stdout_is_terminal());
  CGAL::Real_timer timer;
  timer.start();
  Result result = recover(tr, surface, options, progress);
  timer.stop();
  const Seconds seconds = make_seconds(timer.time(), result.phases);

  Domain<Point> domain;
  if(result.status != Status::invalid_input)
    domain = Domain_builder<Triangulation>(tr)(result, options.keep_exterior);
  const std::array<double, 2> angles = range_of_dihedral_angles(domain);
  use_numbers_of_file(result, domain, surface);

  if(! options.report.empty() && ! write_report(options, surface, changes, result, domain, angles, seconds))
    return fail("cannot write " + options.report);
  if(result.status == Status::invalid_input)
  {
    print_defects(result);
    return invalid_input;
  }
  for(const std::string& file : options.outputs)
    if(! write_domain(file, read_surface_internal::lower_case_extension(file), domain))
      return fail("cannot write " + file);

  if(! options.quiet)
  {
    print_summary(std::cout, result, domain, angles, seconds);
    if(options.outputs.empty())
      std::cout << "no mesh is written; -o OUTPUT does that" << std::endl;
  }
  if(options.table)
    print_levels(std::cout, result.levels);
  if(options.timing)
    std::cout << "@@rec " << seconds.recovery << '\n' << "@@tmesh " << seconds.total << std::endl;
  return result ? recovered : incomplete_or_stopped;
}

int main(int argc, char* argv[])
{
  Options options;
  Command_line command_line(argc, argv);
  if(! command_line.parse(options))
    return fail(command_line.message());
  int status = recovered;
  try
  {
    if(options.help)
      std::cout << usage;
    else
      status = run(options);
  }
  catch(const std::exception& e) // such as memory that is exhausted
  {
    return fail(e.what());
  }
  if(! std::cout.flush())
    return fail("cannot write to the standard output");
  return status;
}
