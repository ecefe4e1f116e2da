// Meshes the domain of a surface with TetGen and prints what that took as one line of JSON, after TetGen's own log.
// Only built where TetGen's library is found (Debian: libtet1.5-dev).

#include "mesh_quality_br3.h"
#include "peak_memory_br3.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#define TETLIBRARY // else its header expects to be the program
#include <tetgen.h>

struct Surface
{
  std::vector<double> coordinates;
  std::vector<int> triangles;
};

// OFF as `benchmark_recovery --write-surface` writes it: triangles, no comments.
bool read_surface(const char* file, Surface& surface)
{
  std::ifstream is(file);
  std::string word;
  std::size_t points = 0, faces = 0, edges = 0;
  if(! (is >> word >> points >> faces >> edges) || word != "OFF")
    return false;
  surface.coordinates.resize(3 * points);
  for(double& x : surface.coordinates)
    is >> x;
  for(std::size_t i = 0; i < faces; ++i)
  {
    int size = 0, v = 0;
    if(! (is >> size) || size != 3)
      return false;
    for(int k = 0; k < 3; ++k)
    {
      if(! (is >> v) || v < 0 || static_cast<std::size_t>(v) >= points)
        return false;
      surface.triangles.push_back(v);
    }
  }
  return true;
}

// Each triangle is a facet with a marker of its own: coplanar ones are not merged.
void set_input(tetgenio& in, const Surface& surface)
{
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(surface.coordinates.size() / 3);
  in.pointlist = new REAL[surface.coordinates.size()];
  std::copy(surface.coordinates.begin(), surface.coordinates.end(), in.pointlist);
  in.numberoffacets = static_cast<int>(surface.triangles.size() / 3);
  in.facetlist = new tetgenio::facet[in.numberoffacets];
  in.facetmarkerlist = new int[in.numberoffacets];
  for(int i = 0; i < in.numberoffacets; ++i)
  {
    tetgenio::facet& f = in.facetlist[i];
    tetgenio::init(&f);
    f.numberofpolygons = 1;
    f.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(f.polygonlist);
    f.polygonlist->numberofvertices = 3;
    f.polygonlist->vertexlist = new int[3];
    std::copy_n(&surface.triangles[3 * i], 3, f.polygonlist->vertexlist);
    in.facetmarkerlist[i] = i + 1;
  }
}

// How many points beyond the input ones are vertices of the first `number` simplices of a list.
std::set<int> new_points(const int* list, const int number, const int size, const int number_of_inputs)
{
  std::set<int> points;
  for(int i = 0; list != nullptr && i < number * size; ++i)
    if(list[i] >= number_of_inputs)
      points.insert(list[i]);
  return points;
}

// How many triangles of the surface are no faces of tetrahedra. TetGen splits some in spite of its switch Y.
std::size_t number_of_split_triangles(const Surface& surface, const tetgenio& out)
{
  typedef std::array<int, 3> Facet;
  std::vector<Facet> faces;
  faces.reserve(4 * static_cast<std::size_t>(out.numberoftetrahedra));
  for(int i = 0; i < out.numberoftetrahedra; ++i)
    for(int j = 0; j < 4; ++j)
    {
      const int* t = out.tetrahedronlist + static_cast<std::ptrdiff_t>(i) * out.numberofcorners;
      faces.push_back({{ t[(j + 1) % 4], t[(j + 2) % 4], t[(j + 3) % 4] }});
      std::sort(faces.back().begin(), faces.back().end());
    }
  std::sort(faces.begin(), faces.end());
  std::size_t number = 0;
  for(std::size_t i = 0; i < surface.triangles.size(); i += 3)
  {
    Facet f = {{ surface.triangles[i], surface.triangles[i + 1], surface.triangles[i + 2] }};
    std::sort(f.begin(), f.end());
    number += std::binary_search(faces.begin(), faces.end(), f) ? 0 : 1;
  }
  return number;
}

br3_benchmark::Dihedral_angles angles_of(const tetgenio& out)
{
  br3_benchmark::Dihedral_angles angles;
  for(int i = 0; i < out.numberoftetrahedra; ++i)
  {
    std::array<br3_benchmark::Point, 4> p;
    for(int j = 0; j < 4; ++j)
      std::copy_n(out.pointlist + 3 * out.tetrahedronlist[i * out.numberofcorners + j], 3, p[j].begin());
    angles.add(p);
  }
  return angles;
}

typedef std::vector<std::array<int, 2> > Edges;

// The edges of simplices, sorted, each of them once.
Edges edges_of(const int* list, const std::size_t number, const int size)
{
  Edges edges;
  edges.reserve(number * static_cast<std::size_t>(size * (size - 1) / 2));
  for(std::size_t i = 0; i < number; ++i)
    for(int j = 0; j < size; ++j)
      for(int k = 0; k < j; ++k)
      {
        const int* simplex = list + i * static_cast<std::size_t>(size);
        edges.push_back({{ (std::min)(simplex[j], simplex[k]), (std::max)(simplex[j], simplex[k]) }});
      }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// The share of the edges inside whose lengths are from sqrt(1/2) to sqrt(2) times the size, as `mesh_surface` counts
// them: without those of the surface.
double share_of_edges_in_size(const Surface& surface, const tetgenio& out, const double size)
{
  const Edges of_surface = edges_of(surface.triangles.data(), surface.triangles.size() / 3, 3);
  std::size_t number = 0, number_in_size = 0;
  for(const auto& e : edges_of(out.tetrahedronlist, static_cast<std::size_t>(out.numberoftetrahedra),
                               out.numberofcorners))
    if(! std::binary_search(of_surface.begin(), of_surface.end(), e))
    {
      double squared_length = 0;
      for(int i = 0; i < 3; ++i)
      {
        const double d = out.pointlist[3 * e[0] + i] - out.pointlist[3 * e[1] + i];
        squared_length += d * d;
      }
      const double ratio = squared_length / (size * size);
      ++number;
      number_in_size += ratio >= 0.5 && ratio <= 2;
    }
  return number == 0 ? 1 : double(number_in_size) / double(number);
}

int main(int argc, char* argv[])
{
  Surface surface;
  const double size = argc == 4 ? std::atof(argv[3]) : 0;
  if(argc < 3 || argc > 4 || (argc == 4 && ! (size > 0)) || ! read_surface(argv[2], surface))
  {
    std::cerr << "usage: benchmark_tetgen SWITCHES SURFACE.off [SIZE], e.g. pYVe; with a size, the share of edges of\n"
                 "about this length is told; exit status: 0 done, 1 no such surface, 2 TetGen failed\n";
    return 1;
  }
  tetgenio in, out;
  set_input(in, surface);
  typedef std::chrono::steady_clock Clock;
  const Clock::time_point start = Clock::now();
  std::vector<char> switches(argv[1], argv[1] + std::string(argv[1]).size() + 1);
  try {
    tetrahedralize(switches.data(), &in, &out);
  } catch(const int e) {
    std::cerr << "TetGen's error " << e << std::endl;
    return 2;
  }
  if(out.numberoftetrahedra == 0)
  {
    std::cerr << "nothing is left" << std::endl;
    return 2;
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const double memory = br3_benchmark::peak_memory();

  const std::set<int> on_edges = new_points(out.edgelist, out.numberofedges, 2, in.numberofpoints);
  std::set<int> on_facets = new_points(out.trifacelist, out.numberoftrifaces, 3, in.numberofpoints);
  for(const int v : on_edges)
    on_facets.erase(v);
  const std::size_t all = static_cast<std::size_t>(out.numberofpoints - in.numberofpoints);
  std::cout << std::fixed << std::setprecision(6) << "\n{\"seconds\": " << seconds << ", \"peak_memory_mb\": " << memory
            << std::defaultfloat << std::setprecision(9) << ", \"points\": " << all << ", \"points_on_edges\": "
            << on_edges.size() << ", \"points_on_facets\": " << on_facets.size() << ", \"points_inside\": "
            << all - on_edges.size() - on_facets.size() << ", \"tetrahedra\": " << out.numberoftetrahedra
            << ", \"split_triangles\": " << number_of_split_triangles(surface, out) << ", ";
  write_json(std::cout, angles_of(out)) << ", ";
  if(size > 0)
    std::cout << "\"share_in_size\": " << share_of_edges_in_size(surface, out, size) << ", ";
  std::cout << "\"vertices\": " << out.numberofpoints << "}" << std::endl;
  std::fflush(stdout); // TetGen's log
  std::_Exit(0); // TetGen's destructors take long, and there is nothing to keep
}
