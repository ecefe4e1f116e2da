#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_MPI_OPTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_MPI_OPTIONS_H

#include "byte_string.h"
#include "lower_case.h"
#include "mesh_surface_options.h"
#include "surface.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

// What the user of `mesh_surface_mpi` asks for.
struct Mpi_options
  : public Meshing_options
{
  Mpi_options()
  {
    number_of_subdomains = 16;
    number_of_threads = 1; // of each rank
  }

  std::string work; // empty: nothing is kept
  bool pieces = false;
};

class Mpi_command_line
  : public Meshing_command_line
{
public:
  explicit Mpi_command_line(Mpi_options& options)
    : Meshing_command_line("mesh_surface_mpi",
        "Meshes what a triangulated surface bounds in sub-domains, with several processes on one or more machines.\n"
        "The mesh depends on the number of sub-domains, which is 16 by default, but not on those of ranks and\n"
        "threads, bit for bit; it is that of mesh_surface with as many sub-domains. All ranks read INPUT, and all the\n"
        "files that options name.\n"
        + std::string(input_text), options, "mpirun -n RANKS "),
      m_options(options)
  {
    for(const char* option : { "--time-limit", "--threads" }) // the mesh may not depend on the speed of ranks
      remove_option(option);
    begin_group("ranks");
    add_number("--threads", "T", options.number_of_threads, Number_kind::positive,
               "work on T sub-domains at once in each rank, which takes the memory for as many; default: 1,\n"
               "for one rank on each core. mpirun may have to be told that a rank has T cores: Open MPI is\n"
               "by --map-by slot:PE=T", largest_number_of_threads);
    add_option("--work", "FOLDER", options.work,
               "keep what is finished in that folder, which all ranks see: after a run that failed, the\n"
               "next one with the same input and options does only what is missing. By default, it is a\n"
               "temporary folder, enough on one machine. Rank 0 removes it at the end, after a failure\n"
               "as well, unless it was killed itself");
    add_flag("--pieces", options.pieces,
             "in .msh files, tell Gmsh which tetrahedra are of which sub-domain. With -o OUTPUT.pvtu, the\n"
             "mesh is written in pieces, one for each sub-domain, beside a file that names them; each rank\n"
             "writes some, and no rank has all in memory");
  }

private:
  const Mpi_options& m_options;

  bool is_own_format(const std::string& extension) const override { return extension == ".pvtu"; }

  void check_combination() override
  {
    Meshing_command_line::check_combination();
    for(const std::string& file : m_options.outputs)
      if(m_options.order == 2 && is_own_format(lower_case_extension(file)))
        refuse("--order 2 is for meshes that are written as a whole, not in pieces: " + file);
  }
};

// A hash of all that the mesh depends on: not of the names of files, but of what they have.
template <typename Point>
std::uint64_t key_of_mesh(const Surface<Point>& surface, const Mpi_options& options, const std::string& version,
                          const std::vector<std::string>& files_of_sizes)
{
  Byte_hash hash;
  hash.add(version).add(surface.points.size()).add(surface.faces.size());
  for(const Point& p : surface.points)
    for(int i = 0; i < 3; ++i)
      hash.add(double(p[i]));
  for(const std::vector<std::size_t>& face : surface.faces)
    for(const std::size_t v : face)
      hash.add(v);
  for(const std::size_t face : surface.file_faces)
    hash.add(face);
  for(const Point& place : surface.voids)
    for(int i = 0; i < 3; ++i)
      hash.add(double(place[i]));
  for(const auto& region : surface.regions)
  {
    hash.add(region.name);
    for(int i = 0; i < 3; ++i)
      hash.add(double(region.place[i]));
  }
  hash.add(options.size).add(options.grading).add(options.has_grading).add(options.insert_field_points)
      .add(options.min_angle).add(static_cast<int>(options.effort)).add(options.improve_quality)
      .add(options.maximum_number_of_vertices)
      .add(options.number_of_subdomains)
      .add(lower_case_extension(options.background));
  for(const std::string& file : files_of_sizes)
  {
    std::ifstream is(file, std::ios::binary);
    hash.add(! file.empty()).add(std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>()));
  }
  return hash.value();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_MPI_OPTIONS_H
