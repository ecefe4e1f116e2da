#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_MPI_OPTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_MPI_OPTIONS_H

#include "byte_string.h"
#include "mesh_surface_options.h"
#include "read_surface.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

constexpr const char* mpi_usage =
  "usage: mpirun -n RANKS mesh_surface_mpi [INPUT] [options]\n"
  "Meshes what a triangulated surface bounds in sub-domains, with several processes on one or more machines. The\n"
  "mesh depends on the number of sub-domains, but not on that of the ranks, bit for bit; it is that of mesh_surface\n"
  "with as many sub-domains. All ranks read INPUT, and all the files that options name.\n"
  "It takes the options of mesh_surface, but --time-limit and --threads, and these:\n"
  "  --subdomains N         the number of sub-domains, by default 16\n"
  "  --work FOLDER          keep what is finished in that folder, which all ranks see: after a run that failed, the\n"
  "                         next one with the same input and options does only what is missing. By default, it is a\n"
  "                         temporary folder, enough on one machine. Rank 0 removes it at the end, after a failure\n"
  "                         as well, unless it was killed itself\n"
  "  -o OUTPUT.pvtu         write the mesh in pieces, one for each sub-domain, beside a file that names them; each\n"
  "                         rank writes some of them, and no rank has all of it in memory\n"
  "  --pieces               in .msh files, tell Gmsh which tetrahedra are of which sub-domain\n"
  "  --report FILE.json     tells for each sub-domain, and for each seam, what it took\n"
  "exit status: as that of mesh_surface; 3 if a sub-domain could not be meshed.\n";

// What the user of `mesh_surface_mpi` asks for.
struct Mpi_options
  : public Meshing_options
{
  Mpi_options() { number_of_subdomains = 16; }

  std::string work; // empty: nothing is kept
  bool pieces = false;
};

class Mpi_command_line
  : public Meshing_command_line
{
  Mpi_options& m_options;

public:
  Mpi_command_line(const int argc, const char* const argv[], Mpi_options& options)
    : Meshing_command_line(argc, argv, options), m_options(options)
  { }

private:
  bool parse_own_option(const std::string& option) override
  {
    if(option == "--work")
      m_options.work = value_after(option);
    else if(option == "--pieces")
      m_options.pieces = true;
    else
      return Meshing_command_line::parse_own_option(option);
    return true;
  }

  bool is_own_format(const std::string& extension) override { return extension == ".pvtu"; }

  void check_combination() override
  {
    Meshing_command_line::check_combination();
    if(std::isfinite(m_options.time_limit))
      refuse("--time-limit is not for mesh_surface_mpi: what is meshed would depend on the speed of the ranks");
    if(m_options.has_threads)
      refuse("--threads is not for mesh_surface_mpi, each rank of which works on one thing at a time");
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
  hash.add(options.size).add(options.grading).add(options.has_grading).add(options.insert_field_points)
      .add(options.min_angle).add(static_cast<int>(options.effort)).add(options.improve_quality)
      .add(options.maximum_number_of_vertices)
      .add(options.number_of_subdomains)
      .add(read_surface_internal::lower_case_extension(options.background));
  for(const std::string& file : files_of_sizes)
  {
    std::ifstream is(file, std::ios::binary);
    hash.add(! file.empty()).add(std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>()));
  }
  return hash.value();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MESH_SURFACE_MPI_OPTIONS_H
