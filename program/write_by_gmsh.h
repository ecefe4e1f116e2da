#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WRITE_BY_GMSH_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WRITE_BY_GMSH_H

#include "domain.h"
#include "output_buffer.h"
#include "write_gmsh.h"

#include <algorithm>
#include <array>
#include <string>

#ifdef BOUNDARY_RECOVERY_3_LIBGMSH // the file of the library; our CMakeLists.txt tells it where it is there
#include "interruption.h"
#include "whole_file.h"

#include <gmshc.h>

#ifndef BOOST_DLL_USE_STD_FS
#define BOOST_DLL_USE_STD_FS // else a library of Boost has to be linked
#endif
#include <boost/dll/shared_library.hpp>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <random>
#include <system_error>
#endif

// What Gmsh writes of the formats that others read: those of Abaqus and CalculiX, I-deas, Nastran, SU2 and LS-DYNA.
constexpr const char* formats_of_gmsh = ".inp, .unv, .bdf, .su2, .key";

inline bool is_format_of_gmsh(const std::string& extension)
{
  static const std::array<std::string, 5> extensions = {{ ".inp", ".unv", ".bdf", ".su2", ".key" }};
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

#ifdef BOUNDARY_RECOVERY_3_LIBGMSH

// The library is loaded when it is asked for only, and once: with the ninety others that it needs, that takes much
// longer than small meshes do.
class Gmsh_library
{
  boost::dll::fs::error_code m_error;
  const boost::dll::shared_library m_library{ BOUNDARY_RECOVERY_3_LIBGMSH, m_error };

  Gmsh_library() = default;

public:
  static const Gmsh_library& instance()
  {
    static const Gmsh_library library;
    return library;
  }

  bool is_loaded() const { return ! m_error; }

  // returns `false` if Gmsh cannot read or write one of the files
  bool convert(const std::string& from, const std::string& to) const
  {
    int error = 0;
    initialize(m_library.get<decltype(gmshInitialize)>("gmshInitialize"), error);
    if(error != 0)
      return false;
    set_number("General.Terminal", 0);        // nothing is printed
    set_number("Mesh.BdfFieldFormat", 2);     // 16 columns for each number, and not 8
    set_number("Mesh.SaveGroupsOfNodes", 1);  // conditions of Abaqus are on nodes
    int error_of_file = 0;
    m_library.get<decltype(gmshOpen)>("gmshOpen")(from.c_str(), &error_of_file);
    if(error_of_file == 0)
      m_library.get<decltype(gmshWrite)>("gmshWrite")(to.c_str(), &error_of_file);
    m_library.get<decltype(gmshFinalize)>("gmshFinalize")(&error);
    return error_of_file == 0;
  }

private:
  // Settings of the user are not read. Later versions can run the graphical interface.
  static void initialize(void (&f)(int, char**, int, int*), int& error) { f(0, nullptr, 0, &error); }
  static void initialize(void (&f)(int, char**, int, int, int*), int& error) { f(0, nullptr, 0, 0, &error); }

  void set_number(const char* option, const double value) const
  {
    int ignored = 0; // of an option that a version does not have
    m_library.get<decltype(gmshOptionSetNumber)>("gmshOptionSetNumber")(option, value, &ignored);
  }
};

// empty if files of these formats can be written
inline std::string reason_for_no_gmsh()
{
  return Gmsh_library::instance().is_loaded() ? "" : "cannot load " BOUNDARY_RECOVERY_3_LIBGMSH;
}

// A new folder for two files. It is the current one as long as this object lives, so that files that tell their own
// name are always the same.
class Temporary_folder
{
  const std::filesystem::path m_before = std::filesystem::current_path();
  const std::filesystem::path m_folder =
    std::filesystem::temp_directory_path() / ("mesh_surface_" + std::to_string(std::random_device()()));
  const std::array<std::string, 3> m_names; // of the files and the folder

public:
  Temporary_folder(const std::string& first, const std::string& second)
    : m_names{{ (m_folder / first).string(), (m_folder / second).string(), m_folder.string() }}
  {
    std::filesystem::create_directory(m_folder);
    for(std::size_t i = 0; i < m_names.size(); ++i)
      Interruption::leftovers[i + 1] = m_names[i].c_str();
    std::filesystem::current_path(m_folder);
  }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::current_path(m_before, ignored);
    std::filesystem::remove_all(m_folder, ignored);
    for(std::size_t i = 0; i < m_names.size(); ++i)
      Interruption::leftovers[i + 1] = nullptr;
  }
};

// lets Gmsh write a file in the format that the extension names; returns `false` if that fails. Gmsh knows extensions
// in lower case only, and does not tell if there is no more room.
template <typename Point>
bool write_by_gmsh(const std::string& file, const std::string& extension, const Domain<Point>& domain)
{
  const std::string target = std::filesystem::absolute(file).string();
  const std::string ours = "mesh.msh", theirs = "mesh" + extension;
  const Temporary_folder folder(ours, theirs);
  Output_buffer os(ours);
  Gmsh_writer<Point>(os, domain)();
  if(! os.close())
    return false;
  const bool is_converted = Gmsh_library::instance().convert(ours, theirs);
  errno = 0; // of what it looked for
  return is_converted && copy_bytes(theirs, target);
}

#else

inline std::string reason_for_no_gmsh() { return "this program was built without libgmsh, which writes it"; }

template <typename Point>
bool write_by_gmsh(const std::string&, const std::string&, const Domain<Point>&) { return false; }

#endif

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WRITE_BY_GMSH_H
