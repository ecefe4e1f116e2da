// Writes the meshes before and after a remeshing, so that program/draw_mesh.py can draw them.

#ifndef BR3_BENCHMARK_MESH_FILES_H
#define BR3_BENCHMARK_MESH_FILES_H

#include "remeshed_mesh_br3.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace br3_benchmark {

// The reference of a tetrahedron tells what becomes of it, or has become.
enum Reference { stays = 1, replaced = 2, bad = 3 };

// In the format of Medit.
inline void write_mesh(const std::string& name, const Mesh& mesh, const std::vector<int>& references)
{
  std::ofstream out(name);
  out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.points.size() << '\n';
  for(const Kernel::Point_3& p : mesh.points)
    out << p << " 0\n";
  out << "Triangles\n" << mesh.facets.size() << '\n';
  for(const Triangle& t : mesh.facets)
    out << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << " 1\n";
  out << "Tetrahedra\n" << mesh.tetrahedra.size() << '\n';
  for(std::size_t c = 0; c < mesh.tetrahedra.size(); ++c)
  {
    for(const std::size_t v : mesh.tetrahedra[c])
      out << v + 1 << ' ';
    out << references[c] << '\n';
  }
  out << "End\n";
}

// The files of the steps, if there is a prefix.
class Mesh_files
{
  std::string m_prefix;

public:
  explicit Mesh_files(const std::string& prefix) : m_prefix(prefix) { }

  void write(const int step, const std::string& when, const Mesh& mesh, const std::vector<int>& references) const
  {
    if(! m_prefix.empty())
      write_mesh(m_prefix + (step < 10 ? "0" : "") + std::to_string(step) + '_' + when + ".mesh", mesh, references);
  }

  void write(const int step, const std::string& when, const Mesh& mesh) const
  {
    write(step, when, mesh, std::vector<int>(mesh.tetrahedra.size(), stays));
  }

  // `old_cells` are those of the new mesh.
  void write_before(const int step, const Mesh& mesh, const std::vector<std::size_t>& old_cells,
                    const double least_angle) const
  {
    if(m_prefix.empty())
      return;
    std::vector<int> references(mesh.tetrahedra.size(), replaced);
    for(const std::size_t c : old_cells)
      if(c < references.size())
        references[c] = stays;
    for(std::size_t c = 0; c < references.size(); ++c)
      if(mesh.smallest_angle_of(c) < least_angle || ! mesh.is_positive(c))
        references[c] = bad;
    write(step, "before", mesh, references);
  }

  void write_after(const int step, const Mesh& mesh, const std::size_t number_of_kept_cells) const
  {
    if(m_prefix.empty())
      return;
    std::vector<int> references(mesh.tetrahedra.size(), replaced);
    std::fill(references.begin(), references.begin() + std::ptrdiff_t(number_of_kept_cells), stays);
    write(step, "after", mesh, references);
  }
};

} // namespace br3_benchmark

#endif // BR3_BENCHMARK_MESH_FILES_H
