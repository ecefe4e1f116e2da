#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_DOMAIN_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_DOMAIN_H

#include "domain.h"
#include "lower_case.h"
#include "output_buffer.h"
#include "whole_file.h"
#include "write_by_gmsh.h"
#include "write_gmsh.h"
#include "write_medit.h"
#include "write_vtk.h"

#include <string>
#include <vector>

constexpr const char* known_output_formats = ".mesh, .msh (Gmsh 4.1), .msh2 (Gmsh 2.2), .vtu, .vtk";

// those that we write ourselves
inline bool is_output_format(const std::string& extension)
{
  return extension == ".mesh" || extension == ".msh" || extension == ".msh2" || extension == ".vtu" ||
         extension == ".vtk";
}

// writes the domain in the format that the extension names; returns `false` if that fails. The parts of the tetrahedra,
// if they are given, are in .msh files only.
template <typename Point>
bool write_domain(const std::string& file, const std::string& extension, const Domain<Point>& domain,
                  const std::vector<int>& parts = { })
{
  if(is_format_of_gmsh(extension))
    return write_by_gmsh(file, extension, domain);
  Output_buffer os(file);
  if(extension == ".mesh")
    write_medit(os, domain);
  else if(extension == ".msh")
    Gmsh_writer<Point>(os, domain, parts)();
  else if(extension == ".msh2")
    Gmsh_writer<Point>(os, domain).write_version_2();
  else if(extension == ".vtu")
    Vtu_writer<Point>(os, domain)();
  else
    write_vtk(os, domain);
  return os.close();
}

// the same, in the format that the extension of the file names, as a whole or not at all
template <typename Point>
bool write_whole_domain(const std::string& file, const Domain<Point>& domain, const std::vector<int>& parts = { })
{
  Whole_file whole(file);
  return write_domain(whole.name(), lower_case_extension(file), domain, parts) && whole.finish();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_DOMAIN_H
