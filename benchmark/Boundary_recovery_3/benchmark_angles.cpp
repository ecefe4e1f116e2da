// Prints the dihedral angles of a tetrahedral mesh, whichever program made it, as one line of JSON.
// Argument: a file in MEDIT's format .mesh.

#include "mesh_quality_br3.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

// Only vertices and tetrahedra are looked at.
struct Mesh
{
  std::vector<br3_benchmark::Point> points;
  std::vector<std::array<std::size_t, 4> > tetrahedra;
};

template <typename Read>
bool read_entries(std::istream& is, const Read& read)
{
  std::size_t number = 0;
  is >> number;
  for(std::size_t i = 0; is && i < number; ++i)
    read();
  return bool(is);
}

bool read_mesh(const char* file, Mesh& mesh)
{
  std::ifstream is(file);
  std::string word, reference;
  while(is >> word)
    if(word == "Vertices" && ! read_entries(is, [&]
      {
        br3_benchmark::Point p;
        is >> p[0] >> p[1] >> p[2] >> reference;
        mesh.points.push_back(p);
      }))
      return false;
    else if(word == "Tetrahedra" && ! read_entries(is, [&]
      {
        std::array<std::size_t, 4> t;
        is >> t[0] >> t[1] >> t[2] >> t[3] >> reference;
        mesh.tetrahedra.push_back(t);
      }))
      return false;
  for(const auto& t : mesh.tetrahedra)
    for(const std::size_t v : t)
      if(v == 0 || v > mesh.points.size())
        return false;
  return ! mesh.tetrahedra.empty();
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 2 || ! read_mesh(argv[1], mesh))
  {
    std::cerr << "usage: benchmark_angles MESH.mesh; exit status: 0 done, 1 no such mesh" << std::endl;
    return EXIT_FAILURE;
  }
  br3_benchmark::Dihedral_angles angles;
  for(const auto& t : mesh.tetrahedra)
    angles.add({{ mesh.points[t[0] - 1], mesh.points[t[1] - 1], mesh.points[t[2] - 1], mesh.points[t[3] - 1] }});
  std::cout << "{\"vertices\": " << mesh.points.size() << ", \"tetrahedra\": " << mesh.tetrahedra.size() << ", ";
  write_json(std::cout, angles) << "}" << std::endl;
  return EXIT_SUCCESS;
}
