#ifndef BOUNDARY_RECOVERY_3_PROGRAM_RECOVER_BOUNDARY_OPTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_RECOVER_BOUNDARY_OPTIONS_H

#include "command_line.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>

#include <string>

constexpr const char* recovery_usage =
  "usage: recover_boundary [INPUT] [options]\n"
  "Meshes the inside of a triangulated surface with tetrahedra that have all its triangles as faces. Points are added\n"
  "only if there is no other way found, and not on the surface.\n"
  "INPUT is an .off, .ply, .stl or .obj file; without it, the program takes a surface of its own.\n"
  "  -o OUTPUT                  write the mesh of the domain: .mesh, .msh, .vtu or .vtk; may be repeated\n"
  "  --repair                   merge points, and drop, turn and divide triangles, for a surface that is not valid\n"
  "  --tolerance X              repair: merge points whose coordinates differ by at most X, where that helps; without\n"
  "                             this option, X is four units in the last place of the largest coordinate in single\n"
  "                             precision; 0 merges none\n"
  "  --conforming               points may stay on the surface: each triangle is a union of faces\n"
  "  --flips-only               leave no added point\n"
  "  --keep-exterior            write the tetrahedra outside the domain, too, as region 0\n"
  "  --effort WHAT              what may be given up: more-time (the default) or more-points\n"
  "  --max-recursion-level N    never recurse deeper than N when flipping\n"
  "  --list-defects             look for intersections before anything else, and mesh nothing if there are any\n"
  "  --time-limit SECONDS       stop after that time and write what there is\n"
  "  --report FILE.json         write a report with all that is wrong or missing\n"
  "  --table                    print lost constraints and intersections per recursion level\n"
  "  --timing                   print @@rec and @@tmesh, the seconds of the recovery and with the insertion\n"
  "  --quiet                    print errors and a limit that ended the work only, and what --table and --timing ask\n"
  "                             for\n"
  "  --help                     print this text\n"
  "exit status: 0 every constraint recovered, 1 usage or file error, 2 invalid input, 3 incomplete or stopped\n";

// What the user of `recover_boundary` asks for.
struct Recovery_options
  : public Common_options
{
  CGAL::Boundary_recovery_3::Recovery_mode mode = CGAL::Boundary_recovery_3::Recovery_mode::constrained;
  bool has_mode = false;
  CGAL::Boundary_recovery_3::Recovery_effort effort = CGAL::Boundary_recovery_3::Recovery_effort::more_time;
  int max_recursion_level = -1;     // -1: the default of the library
  bool keep_exterior = false;
  bool table = false;
};

class Recovery_command_line
  : public Command_line
{
  Recovery_options& m_options;

public:
  Recovery_command_line(const int argc, const char* const argv[], Recovery_options& options)
    : Command_line(argc, argv, options), m_options(options)
  { }

private:
  bool parse_own_option(const std::string& option) override
  {
    using CGAL::Boundary_recovery_3::Recovery_mode;

    if(option == "--conforming")
      set_mode(Recovery_mode::conforming);
    else if(option == "--flips-only")
      set_mode(Recovery_mode::flips_only);
    else if(option == "--effort")
      set_effort(value_after(option));
    else if(option == "--max-recursion-level")
      m_options.max_recursion_level = static_cast<int>(number_after(option, Number_kind::integer, 1000));
    else if(option == "--keep-exterior")
      m_options.keep_exterior = true;
    else if(option == "--table")
      m_options.table = true;
    else
      return false;
    return true;
  }

  void set_effort(const std::string& name)
  {
    using CGAL::Boundary_recovery_3::Recovery_effort;

    if(name == "more-time" || name == "more-points")
      m_options.effort = name == "more-time" ? Recovery_effort::more_time : Recovery_effort::more_points;
    else if(! name.empty())
      refuse("--effort needs more-time or more-points, not " + name);
  }

  void set_mode(const CGAL::Boundary_recovery_3::Recovery_mode mode)
  {
    if(m_options.has_mode && m_options.mode != mode)
      refuse("--conforming and --flips-only exclude each other");
    m_options.mode = mode;
    m_options.has_mode = true;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_RECOVER_BOUNDARY_OPTIONS_H
