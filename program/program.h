#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PROGRAM_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PROGRAM_H

#include "command_line.h"
#include "domain.h"
#include "explain_refusal.h"
#include "interruption.h"
#include "open_surface.h"
#include "print_result.h"
#include "report_holes.h"
#include "report_remeshing.h"
#include "report_repair.h"
#include "surface_tools.h"
#include "whole_file.h"
#include "write_domain.h"
#include "write_report.h"

#include <CGAL/version.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <system_error>
#include <vector>

enum Exit_status { success = 0, usage_or_file_error = 1, invalid_input = 2, incomplete_or_stopped = 3 };

// What all the programs do with surfaces and files, in the order in which they do it. A function that returns `false`
// has set the message that `fail()` prints.
template <typename Point>
class Program
{
  const std::string m_name;
  const Common_options& m_options;
  Surface<Point> m_surface;
  Repair_changes m_changes;
  std::vector<Hole> m_holes;
  Open_surface m_open;
  Remeshing_changes m_remeshing;
  std::string m_message;

public:
  Program(const std::string& name, const Common_options& options) : m_name(name), m_options(options) { }

  const Surface<Point>& surface() const { return m_surface; }

  int fail(const std::string& message) const
  {
    std::cerr << m_name << ": " << message << std::endl;
    return usage_or_file_error;
  }

  int fail() const { return fail(m_message); }

  // what `fail()` prints
  const std::string& message() const { return m_message; }

  // The same file may have several names, by links. The only copy of what is read must not become a mesh of it.
  bool keeps_inputs(const std::vector<std::string>& inputs)
  {
    for(const std::string& file : files_to_write())
      for(const std::string& input : inputs)
      {
        std::error_code ignored; // a file that does not exist yet
        if(! input.empty() && std::filesystem::equivalent(file, input, ignored))
          return refuse("the input would be overwritten: " + file);
      }
    return true;
  }

  // `default_surface` makes the surface that is taken if there is no input
  template <typename DefaultSurface>
  bool read_surface(const DefaultSurface& default_surface)
  {
    if(! m_options.input.empty())
      return read_input_surface(m_options.input, m_surface, m_message);
    m_surface = default_surface();
    return true;
  }

  // better said before the work than after it
  bool can_write()
  {
    for(const std::string& file : files_to_write())
      if(! can_be_written(file))
        return refuse_file(file);
    return true;
  }

  // divides polygons, tells what the user has to know of the surface, repairs it, closes holes and replaces triangles
  // if that is asked for
  void prepare_surface()
  {
    divide_polygons(m_surface, m_options.repair);
    if(! m_options.quiet)
      for(const std::string& note : m_surface.notes)
        std::cout << "note: " << note << std::endl;
    if(m_options.repair)
      repair_surface();
    if(m_options.max_hole_length >= 0 && is_triangle_soup(m_surface))
      close_holes();
    if(m_options.largest_edge >= 0)
      remesh_surface();
    note_lost_patches();
    if(! m_options.quiet)
      print_surface(std::cout, m_options.input.empty() ? "default surface" : m_options.input, m_surface);
  }

  // tells where the mesh is
  void print_outputs() const
  {
    if(m_options.outputs.empty())
      std::cout << "no mesh is written; -o OUTPUT does that" << std::endl;
    for(const std::string& file : m_options.outputs)
      std::cout << (&file == &m_options.outputs.front() ? "written: " : ", ") << file;
    if(! m_options.outputs.empty())
      std::cout << std::endl;
  }

  // divides the surface into patches unless it has some, or nobody will see them
  void set_patches()
  {
    if(! m_options.outputs.empty() && ! m_surface.has_patches())
      divide_into_patches(m_surface, m_options.patch_angle);
  }

  // places in regions with names, and in those that are to be empty, beside those of the file
  template <typename NamedPlaces, typename Places>
  void add_places(const NamedPlaces& regions, const Places& voids)
  {
    for(const auto& [name, x, y, z] : regions)
      m_surface.regions.push_back({ name, Point(x, y, z) });
    for(const auto& [x, y, z] : voids)
      m_surface.voids.push_back(Point(x, y, z));
  }

  // finds what of the surface bounds nothing, for the messages and the report; before `use_numbers_of_file()`
  void find_open_surface(const Domain<Point>& domain) { m_open = ::find_open_surface(m_surface, domain); }

  // Part of the surface may be forgotten, or out of place: nobody would see that in the mesh.
  void warn_of_idle_faces() const
  {
    if(m_options.quiet || m_open.idle_faces.empty())
      return;
    std::cerr << m_name << ": warning: ";
    print_idle_faces(std::cerr, m_open, m_surface);
    explain_open_surface();
  }

  // tells where the surface is open, if it bounds nothing at all
  void explain_open_surface() const { print_open_surface(std::cerr, m_open, m_options); }

  // The surface has each point once and may lack vertices of the file, and its faces may be parts: translates to the
  // numbers of the file, and tells the patches.
  template <typename Result>
  void use_numbers_of_file(Result& result, Domain<Point>& domain)
  {
    typedef typename Result::Input_simplex Simplex;

    const auto translate = [&](Simplex& simplex)
    {
      if(simplex.dimension == 0 && simplex.index != Simplex::no_index)
        simplex.index = m_surface.vertex_number(simplex.index);
      if(simplex.dimension == 2 && simplex.index != Simplex::no_index)
        simplex.index = m_surface.face_number(simplex.index);
      for(std::size_t& v : simplex.vertices)
        v = m_surface.vertex_number(v);
    };
    std::for_each(result.missing_edges.begin(), result.missing_edges.end(), translate);
    std::for_each(result.missing_facets.begin(), result.missing_facets.end(), translate);
    std::for_each(result.unrepresentable_constraints.begin(), result.unrepresentable_constraints.end(), translate);
    for(auto& defect : result.defects)
      std::for_each(defect.simplices.begin(), defect.simplices.end(), translate);
    if(! domain.triangles.empty())
      set_patches();
    for(std::size_t& face : domain.triangle_numbers)
    {
      domain.patches.push_back(m_surface.patches[face]);
      face = m_surface.face_number(face);
    }
    domain.patch_names = m_surface.patch_names;
  }

  // the entries that the reports of all the programs begin with
  void write_input(Json_writer& json) const
  {
    json.entry("program", m_name);
    json.entry("version", BOUNDARY_RECOVERY_3_VERSION);
    json.entry("cgal_version", CGAL_VERSION_STR);
    json.entry("input", m_options.input.empty() ? std::string("default surface") : m_options.input);
    json.key("notes");
    json.list(m_surface.notes, [&](const std::string& note) { json.value(note); });
    if(m_options.repair)
      write_repair(json, m_changes, m_surface);
    if(m_options.max_hole_length >= 0)
      write_holes(json, m_holes, m_surface);
    if(m_open.number_of_faces > 0)
      write_open_surface(json, m_open, m_surface);
    if(m_options.largest_edge >= 0)
      write_remeshing(json, m_remeshing);
  }

  template <typename Result>
  int refuse_input(const Result& result) const
  {
    std::cerr << m_name << ": ";
    print_defects(std::cerr, result);
    print_remedy(std::cerr, result, m_options);
    explain_open_surface();
    return invalid_input;
  }

  // `tell_progress` is told before each file which part of all is written
  template <typename TellProgress>
  bool write_outputs(const Domain<Point>& domain, const TellProgress& tell_progress)
  {
    const std::size_t n = m_options.outputs.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      tell_progress(double(i) / double(n));
      if(! write_whole_domain(m_options.outputs[i], domain))
        return refuse_file(m_options.outputs[i]);
    }
    return true;
  }

  bool write_outputs(const Domain<Point>& domain)
  {
    return write_outputs(domain, [](double) { });
  }

  // `write` writes the entries of the report, if one is asked for
  template <typename Write>
  bool write_report(const Write& write)
  {
    if(m_options.report.empty())
      return true;
    Whole_file whole(m_options.report);
    std::ofstream os(whole.name());
    Json_writer json(os);
    json.begin('{');
    write_input(json);
    write(json);
    json.end('}');
    os << '\n';
    os.close();
    return (! os.fail() && whole.finish()) || refuse_file(m_options.report);
  }

private:
  void repair_surface()
  {
    m_changes = repair(m_surface, m_options.tolerance, m_options.fuse);
    if(! m_options.quiet)
      print_repair(std::cout, m_changes);
  }

  void close_holes()
  {
    m_holes = ::close_holes(m_surface, m_options.max_hole_length);
    if(! m_options.quiet)
      print_holes(std::cout, m_holes);
  }

  void remesh_surface()
  {
    m_remeshing = remesh(m_surface, m_options.patch_angle, m_options.largest_edge);
    if(! m_options.quiet)
      print_remeshing(std::cout, m_remeshing);
  }

  // A condition on a name that is nowhere would be lost silently.
  void note_lost_patches()
  {
    const std::set<int> left(m_surface.patches.begin(), m_surface.patches.end());
    for(const auto& [number, name] : m_surface.patch_names)
      if(left.count(number) == 0)
      {
        m_surface.notes.push_back("the patch " + name + " has no triangles left");
        if(! m_options.quiet)
          std::cout << "note: " << m_surface.notes.back() << std::endl;
      }
  }

  bool refuse(const std::string& message)
  {
    m_message = message;
    return false;
  }

  // `errno` may know why
  bool refuse_file(const std::string& file)
  {
    return refuse("cannot write " + file + (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string()));
  }

  std::vector<std::string> files_to_write() const
  {
    std::vector<std::string> files = m_options.outputs;
    if(! m_options.report.empty())
      files.push_back(m_options.report);
    return files;
  }
};

// the main function of each program: `run` takes the options and returns the exit status
template <typename Point, typename Reader, typename Options, typename Run>
int run_program(const std::string& name, const int argc, const char* const argv[], const Run& run)
{
  Options options;
  Reader command_line(options);
  Program<Point> program(name, options);
  const bool is_to_run = command_line.parse(argc, argv);
  if(! command_line.message().empty())
    return program.fail(command_line.message());
  int status = success;
  Interruption::prepare();
  try
  {
    std::cout << command_line.text();
    if(is_to_run)
      status = run(options, program);
  }
  catch(const std::exception& e) // such as memory that is exhausted
  {
    return program.fail(e.what());
  }
  if(! std::cout.flush())
    return program.fail("cannot write to the standard output");
  return status;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PROGRAM_H
