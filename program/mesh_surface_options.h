#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_OPTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_OPTIONS_H

#include "command_line.h"

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>

#include <cstddef>
#include <limits>
#include <string>

using CGAL::Boundary_recovery_3::Improvement_effort;

constexpr const char* meshing_usage =
  "usage: mesh_surface [INPUT] [options]\n"
  "Meshes the inside of a triangulated surface with tetrahedra of the sizes that are asked for. Every triangle of the\n"
  "surface is a face of the mesh, exactly as it is. The tetrahedra are improved; for those that have small angles\n"
  "nevertheless, it is told whether the surface forces them.\n"
  "INPUT is an .off, .ply, .stl or .obj file; without it, the program takes a surface of its own.\n"
  "  -o OUTPUT              write the mesh: .mesh, .msh (Gmsh 4.1), .vtu or .vtk; may be repeated\n"
  "sizes: how long edges shall be. Of those that are given, the smallest one counts at each point; without --size,\n"
  "sizes from the surface are among them. Beside triangles that are smaller, edges are shorter.\n"
  "  --size H               the same size everywhere\n"
  "  --sources FILE         sizes around points, segments, triangles and boxes, one a line:\n"
  "                           point    x y z  size radius growth\n"
  "                           segment  x y z  x y z  size radius growth\n"
  "                           triangle x y z  x y z  x y z  size radius growth\n"
  "                           box      x y z  x y z  size radius growth\n"
  "                         within the radius, it is the size; from there, it grows by the growth per length, or,\n"
  "                         with the words 'doubling D' in the place of the growth, exponentially, to the double at\n"
  "                         the distance D\n"
  "  --background MESH      sizes at the vertices of a tetrahedral mesh: a .mesh file with a .sol file beside it, or\n"
  "                         one of TetGen's .node, .ele and .mtr files, with the others beside it\n"
  "  --grading G            sizes from the surface or of the background mesh grow by at most G per length; default:\n"
  "                         0.3 from the surface, and no limit in the mesh\n"
  "  --no-field-points      insert no points for the sizes: only those that the surface needs, if any; nor improve\n"
  "                         the tetrahedra\n"
  "  --max-vertices N       mesh nothing if more vertices than that are needed; the improvement does without more\n"
  "  --time-limit SECONDS   stop after that time, and write what there is if the surface is recovered by then\n"
  "  --subdomains N         divide the inside into N parts, which are meshed at the same time; their seams are meshed\n"
  "                         again. The mesh depends on N, but not on the number of threads\n"
  "  --threads T            use at most T threads for the parts; default: as many as the machine has\n"
  "quality:\n"
  "  --min-angle DEGREES    improve tetrahedra with a dihedral angle below that one, default: 25; more is\n"
  "                         seldom possible\n"
  "  --effort low|normal|high\n"
  "                         how much work the improvement is worth, default: normal; high takes some times as long\n"
  "  --no-improvement       leave the tetrahedra as the field points make them\n"
  "surfaces that are not valid:\n"
  "  --repair               merge points, and drop, turn and divide triangles\n"
  "  --tolerance X          repair: merge points whose coordinates differ by at most X, where that helps; without\n"
  "                         this option, X is four units in the last place of the largest coordinate in single\n"
  "                         precision; 0 merges none\n"
  "  --list-defects         look for intersections before anything else, and mesh nothing if there are any\n"
  "messages:\n"
  "  --report FILE.json     write a report with sizes, times, the quality of the mesh, the tetrahedra with small\n"
  "                         angles and their reasons, and all that is wrong\n"
  "  --timing               print seconds: @@rec, of the recovery without the insertion of the surface's points,\n"
  "                         @@fill, of the field points, @@improve, of the quality, and @@tmesh, of all that makes\n"
  "                         the mesh\n"
  "  --quiet                print errors and limits that ended the work only, and what --timing asks for\n"
  "  --help                 print this text\n"
  "The vertices of INPUT come first in the mesh, in their order; left out are those that no triangle has, and all but\n"
  "the first of equal ones. Its triangles are in all formats; their patches are their numbers in INPUT, from 1.\n"
  "Tetrahedra have the numbers of their regions, from 1. Of what is outside, only triangles are written that bound\n"
  "nothing. In .msh files, each region is a volume, all triangles with the same regions on both sides are a surface,\n"
  "these are physical groups with names, and the patches are data of the triangles.\n"
  "exit status: 0 meshed; 1 usage or file error; 2 invalid surface, or a size that is none; 3 incomplete, stopped,\n"
  "too large, or no region found. There is a mesh if it is 0, or if the work was stopped after the recovery.\n";

// What the user of `mesh_surface` asks for.
struct Meshing_options
  : public Common_options
{
  double size = 0;                  // 0: from the surface
  std::string sources;
  std::string background;
  double grading = 0.3;
  bool has_grading = false;
  bool insert_field_points = true;
  double min_angle = 25;            // in degrees, that of the library
  bool has_min_angle = false;
  Improvement_effort effort = Improvement_effort::normal;
  bool has_effort = false;
  bool improve_quality = true;
  std::size_t maximum_number_of_vertices = (std::numeric_limits<std::size_t>::max)();
  std::size_t number_of_subdomains = 1;
  std::size_t number_of_threads = 0; // 0: as many as there are
  bool has_threads = false;
};

class Meshing_command_line
  : public Command_line
{
  Meshing_options& m_options;

public:
  Meshing_command_line(const int argc, const char* const argv[], Meshing_options& options)
    : Command_line(argc, argv, options), m_options(options)
  { }

protected:
  bool parse_own_option(const std::string& option) override
  {
    if(option == "--size")
      m_options.size = number_after(option, Number_kind::positive);
    else if(option == "--sources")
      m_options.sources = value_after(option);
    else if(option == "--background")
      m_options.background = value_after(option);
    else if(option == "--grading")
    {
      m_options.grading = number_after(option, Number_kind::not_negative);
      m_options.has_grading = true;
    }
    else if(option == "--no-field-points")
      m_options.insert_field_points = false;
    else if(option == "--min-angle")
    {
      m_options.min_angle = number_after(option, Number_kind::not_negative);
      m_options.has_min_angle = true;
    }
    else if(option == "--effort")
    {
      const std::string name = value_after(option);
      if(name != "low" && name != "normal" && name != "high")
        refuse("--effort is low, normal or high");
      m_options.effort = name == "low" ? Improvement_effort::low
                                       : name == "normal" ? Improvement_effort::normal : Improvement_effort::high;
      m_options.has_effort = true;
    }
    else if(option == "--no-improvement")
      m_options.improve_quality = false;
    else if(option == "--subdomains")
      m_options.number_of_subdomains =
        static_cast<std::size_t>(number_after(option, Number_kind::integer, largest_number_of_subdomains));
    else if(option == "--threads")
    {
      m_options.number_of_threads =
        static_cast<std::size_t>(number_after(option, Number_kind::integer, largest_number_of_threads));
      m_options.has_threads = true;
    }
    else if(option == "--max-vertices")
      m_options.maximum_number_of_vertices =
        static_cast<std::size_t>(number_after(option, Number_kind::integer, largest_integer));
    else
      return false;
    return true;
  }

  void check_combination() override
  {
    if(m_options.has_grading && m_options.size > 0 && m_options.background.empty())
      refuse("--grading is for sizes from the surface or a background mesh only");
    if(m_options.number_of_subdomains == 0)
      refuse("--subdomains needs at least 1");
    if(m_options.has_threads && (m_options.number_of_threads == 0 || m_options.number_of_subdomains == 1))
      refuse("--threads needs at least 1, and --subdomains");
    if(m_options.min_angle > largest_angle)
      refuse("--min-angle needs an angle of at most 70.53 degrees: no tetrahedron has only larger ones");
    if(m_options.has_min_angle && (! m_options.improve_quality || ! m_options.insert_field_points))
      refuse("--min-angle is for tetrahedra that are improved only");
    if(m_options.has_effort && (! m_options.improve_quality || ! m_options.insert_field_points))
      refuse("--effort is for tetrahedra that are improved only");
  }

private:
  static constexpr double largest_angle = 70.53;

  static constexpr double largest_number_of_subdomains = 1000000;
  static constexpr double largest_number_of_threads = 100000;

  static constexpr double largest_integer = 9007199254740992; // 2^53: all integers up to here are numbers
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_OPTIONS_H
