// Meshes of grids, six tetrahedra in each cube, with regions, sheets and edges, whose vertices can be moved.

#ifndef BR3_TEST_MOVED_GRID_H
#define BR3_TEST_MOVED_GRID_H

#include "random_numbers_br3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace br3_test {

struct Moved_grid
{
  typedef std::array<double, 3>      Place;
  typedef std::array<std::size_t, 4> Tetrahedron;
  typedef std::array<std::size_t, 3> Facet;
  typedef std::array<std::size_t, 2> Edge;

  // n cubes in each direction, with coordinates that are integers.
  explicit Moved_grid(const int n) : n(n)
  {
    for(int i = 0; i <= n; ++i)
      for(int j = 0; j <= n; ++j)
        for(int k = 0; k <= n; ++k)
          places.push_back({{ double(i), double(j), double(k) }});
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
        for(int k = 0; k < n; ++k)
          add_cube({{ i, j, k }});
    regions.assign(tetrahedra.size(), 1);
  }

  std::size_t vertex(const int i, const int j, const int k) const
  {
    return std::size_t((i * (n + 1) + j) * (n + 1) + k);
  }

  // Cubes from `low` to `high` get another region.
  void set_region(const std::array<int, 3>& low, const std::array<int, 3>& high, const int region)
  {
    for(std::size_t c = 0; c < tetrahedra.size(); ++c)
    {
      bool is_inside = true;
      for(std::size_t i = 0; i < 3; ++i)
        is_inside = is_inside && cubes[c][i] >= low[i] && cubes[c][i] < high[i];
      if(is_inside)
        regions[c] = region;
    }
  }

  // The facets at height `z` above a rectangle are constrained.
  void add_sheet(const int z, const std::array<int, 2>& low, const std::array<int, 2>& high)
  {
    for(int i = low[0]; i < high[0]; ++i)
      for(int j = low[1]; j < high[1]; ++j)
      {
        facets.push_back({{ vertex(i, j, z), vertex(i + 1, j, z), vertex(i + 1, j + 1, z) }});
        facets.push_back({{ vertex(i, j, z), vertex(i + 1, j + 1, z), vertex(i, j + 1, z) }});
      }
  }

  // A row of edges is constrained.
  void add_edges(const int i, const int j, const int low, const int high)
  {
    for(int k = low; k < high; ++k)
      edges.push_back({{ vertex(i, j, k), vertex(i, j, k + 1) }});
  }

  // For each vertex whether something constrained has it, the boundary and facets between regions included.
  std::vector<bool> constrained_vertices() const
  {
    std::vector<bool> result(places.size(), false);
    for(const auto& f : regions_of_facets())
      if(f.second.size() == 1 || f.second[0] != f.second[1])
        for(const std::size_t v : f.first)
          result[v] = true;
    for(const Facet& f : facets)
      for(const std::size_t v : f)
        result[v] = true;
    for(const Edge& e : edges)
      for(const std::size_t v : e)
        result[v] = true;
    return result;
  }

  // By sorted vertices.
  std::map<Facet, std::vector<int> > regions_of_facets() const
  {
    std::map<Facet, std::vector<int> > result;
    for(std::size_t c = 0; c < tetrahedra.size(); ++c)
      for(std::size_t i = 0; i < 4; ++i)
      {
        const Tetrahedron& t = tetrahedra[c];
        Facet f = {{ t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4] }};
        std::sort(f.begin(), f.end());
        result[f].push_back(regions[c]);
      }
    return result;
  }

  // One of `one_of` vertices that nothing constrained has is moved, by up to `distance` in each direction.
  void shake(std::mt19937& rng, const double distance, const int one_of = 1)
  {
    const std::vector<bool> is_constrained = constrained_vertices();
    for(std::size_t v = 0; v < places.size(); ++v)
      if(! is_constrained[v] && random_int(rng, one_of) == 0)
        for(double& x : places[v])
          x += distance * (random_int(rng, 2001) - 1000) / 1000.;
  }

  template <typename Point>
  std::vector<Point> points() const
  {
    std::vector<Point> result;
    for(const Place& p : places)
      result.emplace_back(p[0], p[1], p[2]);
    return result;
  }

  int n;
  std::vector<Place> places;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::array<int, 3> > cubes; // of the tetrahedra
  std::vector<int> regions;
  std::vector<Facet> facets;
  std::vector<Edge> edges;

private:
  // The tetrahedra around its diagonal.
  void add_cube(const std::array<int, 3>& cube)
  {
    std::array<std::size_t, 3> axes = {{ 0, 1, 2 }};
    do
    {
      std::array<int, 3> corner = cube;
      Tetrahedron t;
      t[0] = vertex(corner[0], corner[1], corner[2]);
      for(std::size_t k = 0; k < 3; ++k)
      {
        ++corner[axes[k]];
        t[k + 1] = vertex(corner[0], corner[1], corner[2]);
      }
      if((axes[0] + 1) % 3 != axes[1]) // an odd permutation
        std::swap(t[2], t[3]);
      tetrahedra.push_back(t);
      cubes.push_back(cube);
    }
    while(std::next_permutation(axes.begin(), axes.end()));
  }
};

} // namespace br3_test

#endif // BR3_TEST_MOVED_GRID_H
