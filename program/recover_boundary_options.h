#ifndef BOUNDARY_RECOVERY_3_PROGRAM_RECOVER_BOUNDARY_OPTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_RECOVER_BOUNDARY_OPTIONS_H

#include "command_line.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>

#include <string>

// What the user of `recover_boundary` asks for.
struct Recovery_options
  : public Common_options
{
  CGAL::Boundary_recovery_3::Recovery_mode mode = CGAL::Boundary_recovery_3::Recovery_mode::constrained;
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
  explicit Recovery_command_line(Recovery_options& options)
    : Command_line("recover_boundary",
        "Meshes the inside of a triangulated surface with tetrahedra that have all its triangles as faces. Points are\n"
        "added only if there is no other way found, and not on the surface.\n" + std::string(input_text), options),
      m_options(options)
  {
    add_output_options();
    add_flag("--keep-exterior", m_options.keep_exterior, "write the tetrahedra outside the domain, too, as region 0");
    add_recovery_options();
    add_surface_options();
    add_message_options();
    set_notes("exit status: 0 every constraint recovered, 1 usage or file error, 2 invalid input, 3 incomplete or\n"
              "stopped");
  }

private:
  std::string timing_text() const override
  {
    return "print @@rec and @@tmesh, the seconds of the recovery and with the insertion";
  }

  void add_recovery_options()
  {
    using CGAL::Boundary_recovery_3::Recovery_effort;

    begin_group("recovery");
    CLI::Option* const conforming =
      add_flag("--conforming", m_is_conforming, "points may stay on the surface: each triangle is a union of faces");
    add_flag("--flips-only", m_is_flips_only, "leave no added point")->excludes(conforming);
    add_choice<Recovery_effort>("--effort", { { "more-time", Recovery_effort::more_time },
                                              { "more-points", Recovery_effort::more_points } }, m_options.effort,
                                "what may be given up, more-time by default");
    add_number("--max-recursion-level", "N", m_options.max_recursion_level, Number_kind::integer,
               "never recurse deeper than N when flipping", 1000);
    add_time_limit("stop after that time and write what there is");
    add_flag("--table", m_options.table, "print lost constraints and intersections per recursion level");
  }

  void check_combination() override
  {
    using CGAL::Boundary_recovery_3::Recovery_mode;

    if(m_is_conforming || m_is_flips_only)
      m_options.mode = m_is_conforming ? Recovery_mode::conforming : Recovery_mode::flips_only;
  }

  bool m_is_conforming = false, m_is_flips_only = false;
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_RECOVER_BOUNDARY_OPTIONS_H
