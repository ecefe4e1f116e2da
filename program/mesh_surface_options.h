#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_OPTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_OPTIONS_H

#include "command_line.h"
#include "lower_case.h"

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>

#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

using CGAL::Boundary_recovery_3::Improvement_effort;

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
  int order = 1;                    // of the mesh that is written
  bool verbose = false;
  std::vector<std::tuple<std::string, double, double, double> > regions; // names, and places in them
  std::vector<std::tuple<double, double, double> > voids;                // places in regions that are to be empty
  Improvement_effort effort = Improvement_effort::normal;
  bool improve_quality = true;
  std::size_t maximum_number_of_vertices = (std::numeric_limits<std::size_t>::max)();
  std::size_t number_of_subdomains = 1;
  std::size_t number_of_threads = 0; // 0: as many as there are
};

class Meshing_command_line
  : public Command_line
{
  Meshing_options& m_options;

public:
  explicit Meshing_command_line(Meshing_options& options)
    : Meshing_command_line("mesh_surface",
        "Meshes the inside of a triangulated surface with tetrahedra of the sizes that are asked for. Every\n"
        "triangle of the surface is a face of the mesh, exactly as it is. The tetrahedra are improved; for those\n"
        "that have small angles nevertheless, it is told whether the surface forces them.\n"
        + std::string(input_text), options)
  { }

protected:
  static constexpr double largest_number_of_threads = 100000;

  Meshing_command_line(const std::string& name, const std::string& description, Meshing_options& options,
                       const std::string& before_name = "")
    : Command_line(name, description, options, before_name), m_options(options)
  {
    add_output_options();
    add_choice<int>("--order", { { "1", 1 }, { "2", 2 } }, m_options.order,
                    "2: write tetrahedra and triangles of second order, with a node in the middle of each\n"
                    "edge, which is straight; default: 1");
    add_size_options();
    add_quality_options();
    add_limit_options();
    add_surface_options();
    add_remeshing_options();
    add_name_options();
    add_message_options();
    set_notes(
      "The vertices of INPUT come first in the mesh, in their order; left out are those that no triangle has, and\n"
      "all but the first of equal ones. Its triangles are in all formats, with their patches and, but for .mesh and\n"
      ".msh2, their numbers, counted as INPUT does. Tetrahedra have the numbers of their regions, from 1. Of what is\n"
      "outside, only triangles are written that bound nothing. In .msh files, patches and regions are physical\n"
      "groups.\n"
      "exit status: 0 meshed; 1 usage or file error; 2 invalid surface, or a size or place that is none;\n"
      "3 incomplete, stopped, too large, or no region found. There is a mesh if it is 0, or if the work was stopped\n"
      "after the recovery.");
  }

  void check_combination() override
  {
    m_options.has_grading = is_given("--grading");
    if(m_options.has_grading && m_options.size > 0 && m_options.background.empty())
      refuse("--grading is for sizes from the surface or a background mesh only");
    if(m_options.number_of_subdomains == 0)
      refuse("--subdomains needs at least 1");
    for(const std::string& file : m_options.outputs)
      if(m_options.order == 2 && lower_case_extension(file) == ".su2")
        refuse("SU2 has no elements of second order: " + file);
    const bool is_improved = m_options.improve_quality && m_options.insert_field_points;
    for(const char* option : { "--min-angle", "--effort" })
      if(is_given(option) && ! is_improved)
        refuse(std::string(option) + " is for tetrahedra that are improved only");
  }

private:
  std::string timing_text() const override
  {
    return "print seconds: @@rec, of the recovery without the insertion of the surface's points,\n"
           "@@fill, of the field points, @@improve, of the quality, and @@tmesh, of all that makes\n"
           "the mesh";
  }

  void add_own_message_options() override
  {
    add_flag("--verbose", m_options.verbose, "print tables of all phases and of angles, and the worst tetrahedra");
  }

  void add_size_options()
  {
    begin_group("sizes",
                "how long edges shall be. Of those that are given, the smallest one counts at each point;\n"
                "without --size, sizes from the surface are among them. Beside triangles that are smaller, edges are\n"
                "shorter.");
    add_number("--size", "H", m_options.size, Number_kind::positive, "the same size everywhere");
    add_option("--sources", "FILE", m_options.sources,
               "sizes around points, segments, triangles and boxes, one a line:\n"
               "  point    x y z  size radius growth\n"
               "  segment  x y z  x y z  size radius growth\n"
               "  triangle x y z  x y z  x y z  size radius growth\n"
               "  box      x y z  x y z  size radius growth\n"
               "within the radius, it is the size; from there, it grows by the growth per length, or,\n"
               "with the words 'doubling D' in the place of the growth, exponentially, to the double at\n"
               "the distance D");
    add_option("--background", "MESH", m_options.background,
               "sizes at the vertices of a tetrahedral mesh: a .mesh file with a .sol file beside it, or\n"
               "one of TetGen's .node, .ele and .mtr files, with the others beside it");
    add_number("--grading", "G", m_options.grading, Number_kind::not_negative,
               "sizes from the surface or of the background mesh grow by at most G per length; default:\n"
               "0.3 from the surface, and no limit in the mesh");
    add_negative_flag("--no-field-points", m_options.insert_field_points,
                      "insert no points for the sizes: only those that the surface needs, if any; nor improve\n"
                      "the tetrahedra");
  }

  void add_quality_options()
  {
    begin_group("quality");
    add_number("--min-angle", "DEGREES", m_options.min_angle, Number_kind::not_negative,
               "improve tetrahedra with a dihedral angle below that one, default: 25; more is\n"
               "seldom possible, more than 70.53 never", largest_angle);
    add_choice<Improvement_effort>("--effort", { { "low", Improvement_effort::low },
                                                 { "normal", Improvement_effort::normal },
                                                 { "high", Improvement_effort::high } }, m_options.effort,
                                   "how much work the improvement is worth, default: normal; high takes some\n"
                                   "times as long");
    add_negative_flag("--no-improvement", m_options.improve_quality,
                      "leave the tetrahedra as the field points make them");
  }

  void add_limit_options()
  {
    begin_group("limits and threads");
    add_number("--max-vertices", "N", m_options.maximum_number_of_vertices, Number_kind::integer,
               "mesh nothing if more vertices than that are needed; the improvement does without more",
               largest_integer);
    add_time_limit("stop after that time, and write what there is if the surface is recovered by then");
    add_number("--threads", "T", m_options.number_of_threads, Number_kind::positive,
               "use at most T threads; default: as many as the machine has. The mesh does not depend on it",
               largest_number_of_threads);
    add_number("--subdomains", "N", m_options.number_of_subdomains, Number_kind::integer,
               "mesh the inside in N parts, then their seams again, as mesh_surface_mpi does. The mesh\n"
               "depends on N", largest_number_of_subdomains);
  }

  void add_remeshing_options()
  {
    begin_group("surfaces of needles, or of triangles that are larger than the size");
    add_number("--remesh-surface", "[H]", m_options.largest_edge, Number_kind::not_negative,
               "replace the triangles of the surface by others with better angles, and with edges of at\n"
               "most H; without H or with 0, of a tenth of the diagonal of the bounding box. The new surface\n"
               "is within a thousandth of the diagonal. Edges sharper than --patch-angle, borders and\n"
               "patches stay; steps smaller than a quarter of that distance do not");
  }

  void add_name_options()
  {
    begin_group("names",
                "solids of .stl, o, g and usemtl of .obj, physical groups of .msh, references of .mesh, markers\n"
                "of .poly and .smesh and an integer property of the faces in .ply are patches of the surface.");
    add_number("--patch-angle", "DEGREES", m_options.patch_angle, Number_kind::not_negative,
               "where there are no names, patches end at edges sharper than that, default: 40", 180);
    add_option("--region", "NAME X Y Z", m_options.regions,
               "the name of the region that has this place; may be repeated");
    add_option("--void", "X Y Z", m_options.voids,
               "the region that has this place is to be empty; may be repeated. .poly and .smesh files have\n"
               "such places, too: holes, and the attributes of regions as names");
  }

  static constexpr double largest_angle = 70.53; // no tetrahedron has only larger ones

  static constexpr double largest_number_of_subdomains = 1000000;

  static constexpr double largest_integer = 9007199254740992; // 2^53: all integers up to here are numbers
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_OPTIONS_H
