#ifndef BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H

#include "read_surface.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

// What the user of the program asks for.
struct Options
{
  std::string input;                // empty: the default surface
  std::vector<std::string> outputs;
  std::string report;
  CGAL::Boundary_recovery_3::Recovery_mode mode = CGAL::Boundary_recovery_3::Recovery_mode::constrained;
  bool has_mode = false;
  int max_recursion_level = -1;     // -1: the default of the library
  double time_limit = (std::numeric_limits<double>::infinity)();
  bool repair = false;
  double tolerance = -1;            // for the repair; -1: that of single precision
  bool list_defects = false;
  bool keep_exterior = false;
  bool quiet = false;
  bool timing = false;
  bool table = false;
  bool help = false;
};

constexpr const char* usage =
  "usage: recover_boundary [INPUT] [options]\n"
  "Meshes the inside of a triangulated surface with tetrahedra that have all its triangles as faces. Points are added\n"
  "only if there is no other way found, and not on the surface.\n"
  "INPUT is an .off, .ply, .stl or .obj file; without it, the program takes a surface of its own.\n"
  "  -o OUTPUT                  write the tetrahedra of the domain: .mesh, .vtu or .vtk; may be repeated\n"
  "  --repair                   merge points, and drop, turn and divide triangles, for a surface that is not valid\n"
  "  --tolerance X              repair: merge points whose coordinates differ by at most X, where that helps; without\n"
  "                             this option, X is four units in the last place of the largest coordinate in single\n"
  "                             precision; 0 merges none\n"
  "  --conforming               points may stay on the surface: each triangle is a union of faces\n"
  "  --flips-only               leave no added point\n"
  "  --keep-exterior            write the tetrahedra outside the domain, too, as region 0\n"
  "  --max-recursion-level N    never recurse deeper than N when flipping\n"
  "  --list-defects             look for intersections before anything else, and mesh nothing if there are any\n"
  "  --time-limit SECONDS       stop after that time and write what there is\n"
  "  --report FILE.json         write a report with all that is wrong or missing\n"
  "  --table                    print lost constraints and intersections per recursion level\n"
  "  --timing                   print @@rec and @@tmesh, the seconds of the recovery and with the insertion\n"
  "  --quiet                    print errors only, and what --table and --timing ask for\n"
  "  --help                     print this text\n"
  "exit status: 0 every constraint recovered, 1 usage or file error, 2 invalid input, 3 incomplete or stopped\n";

// Reads the arguments of the program from left to right.
class Command_line
{
  const std::vector<std::string> m_arguments;
  std::size_t m_next = 0;
  std::string m_message;

public:
  Command_line(const int argc, const char* const argv[])
    : m_arguments(argv + (argc > 0 ? 1 : 0), argv + argc)
  { }

  // returns `false` if the arguments make no sense; `message()` says why
  bool parse(Options& options)
  {
    while(m_message.empty() && m_next < m_arguments.size())
      parse_argument(m_arguments[m_next++], options);
    if(m_message.empty() && options.tolerance >= 0 && ! options.repair)
      m_message = "--tolerance is for --repair only";
    return m_message.empty();
  }

  const std::string& message() const { return m_message; }

private:
  void parse_argument(const std::string& argument, Options& options)
  {
    using CGAL::Boundary_recovery_3::Recovery_mode;

    if(argument == "-o")
      parse_output(argument, options);
    else if(argument == "--conforming")
      set_mode(Recovery_mode::conforming, options);
    else if(argument == "--flips-only")
      set_mode(Recovery_mode::flips_only, options);
    else if(argument == "--max-recursion-level")
      options.max_recursion_level = static_cast<int>(number_after(argument, true));
    else if(argument == "--time-limit")
      options.time_limit = number_after(argument, false);
    else if(argument == "--report")
      options.report = value_after(argument);
    else if(argument == "--repair")
      options.repair = true;
    else if(argument == "--tolerance")
      options.tolerance = number_after(argument, false);
    else if(argument == "--list-defects")
      options.list_defects = true;
    else if(argument == "--keep-exterior")
      options.keep_exterior = true;
    else if(argument == "--table")
      options.table = true;
    else if(argument == "--timing")
      options.timing = true;
    else if(argument == "--quiet")
      options.quiet = true;
    else if(argument == "--help" || argument == "-h")
      options.help = true;
    else if(argument.empty() || argument[0] == '-')
      m_message = "unknown option: " + argument + " (try --help)";
    else if(! options.input.empty())
      m_message = "more than one input: " + options.input + " and " + argument;
    else
      options.input = argument;
  }

  std::string value_after(const std::string& option)
  {
    if(m_next < m_arguments.size() && ! m_arguments[m_next].empty())
      return m_arguments[m_next++];
    m_message = option + " needs a value";
    return std::string();
  }

  double number_after(const std::string& option, const bool is_integer)
  {
    const std::string text = value_after(option);
    if(! m_message.empty())
      return 0;
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    const bool good = *end == '\0' && std::isfinite(x) && x >= 0;
    if(! good || (is_integer && (x != std::floor(x) || x > 1000)))
      m_message = option + " needs a number that is not negative" + (is_integer ? " and integer" : "")
                + ", not " + text;
    return m_message.empty() ? x : 0;
  }

  void parse_output(const std::string& option, Options& options)
  {
    const std::string file = value_after(option);
    const std::string extension = read_surface_internal::lower_case_extension(file);
    if(m_message.empty() && extension != ".mesh" && extension != ".vtu" && extension != ".vtk")
      m_message = "unknown output format: " + file + " (known are .mesh, .vtu, .vtk)";
    options.outputs.push_back(file);
  }

  void set_mode(const CGAL::Boundary_recovery_3::Recovery_mode mode, Options& options)
  {
    if(options.has_mode && options.mode != mode)
      m_message = "--conforming and --flips-only exclude each other";
    options.mode = mode;
    options.has_mode = true;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_COMMAND_LINE_H
