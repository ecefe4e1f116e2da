// Triangulations of random and of degenerate point sets for the tests, always the same ones on every machine.
//
// All coordinates are small integers, possibly divided by a common number, so that the references can compute with
// 64-bit integers without any rounding and without the predicates of CGAL.

#ifndef BR3_TEST_RANDOM_TRIANGULATIONS_H
#define BR3_TEST_RANDOM_TRIANGULATIONS_H

#include "random_numbers_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace br3_test {

struct Lattice_point
{
  std::int64_t x, y, z;

  friend bool operator<(const Lattice_point& p, const Lattice_point& q)
  {
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  }
};

typedef std::vector<Lattice_point> Lattice_points;

inline Lattice_points distinct(const Lattice_points& points)
{
  Lattice_points result;
  std::set<Lattice_point> seen;
  for(const Lattice_point& p : points)
    if(seen.insert(p).second)
      result.push_back(p);
  return result;
}

inline Lattice_points shuffled(Lattice_points points, std::mt19937& rng)
{
  for(std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[random_int(rng, static_cast<int>(i))]);
  return points;
}

// In general position, but for accidents: n points with coordinates below `range`.
inline Lattice_points random_points(const int n, const int range, std::mt19937& rng)
{
  Lattice_points points;
  for(int i = 0; i < n; ++i)
  {
    const int x = random_int(rng, range), y = random_int(rng, range), z = random_int(rng, range);
    points.push_back({ x, y, z });
  }
  return distinct(points);
}

// As degenerate as can be: a part, about `percent` %, of the points of a grid, in random order.
inline Lattice_points grid_points(const int nx, const int ny, const int nz, const int percent, std::mt19937& rng)
{
  Lattice_points points;
  for(int x = 0; x < nx; ++x)
    for(int y = 0; y < ny; ++y)
      for(int z = 0; z < nz; ++z)
        if(random_int(rng, 100) < percent)
          points.push_back({ x, y, z });
  return shuffled(points, rng);
}

// A short edge on an axis, whose ends are the first two points, and n points around it, at random distances: the
// ring is not convex. With `is_flat` and `is_round` they are in a plane and on a circle, some in a line with the axis.
inline Lattice_points ring_points(const int n, const bool is_flat, const bool is_round, std::mt19937& rng)
{
  static const int circle[12][2] = { {25, 0}, {20, 15}, {15, 20}, {0, 25}, {-15, 20}, {-20, 15},
                                     {-25, 0}, {-20, -15}, {-15, -20}, {0, -25}, {15, -20}, {20, -15} };
  Lattice_points points = { { 0, 0, 3 }, { 0, 0, -3 } };
  const int first = random_int(rng, 12);
  for(int i = 0; i < n; ++i)
  {
    const int* c = circle[(first + (12 * i) / n) % 12];
    const int scale = is_round ? 2 : 1 + random_int(rng, 6);
    const int height = is_flat ? 0 : random_int(rng, 41) - 20;
    points.push_back({ c[0] * scale, c[1] * scale, height });
  }
  return distinct(points);
}

template <typename Kernel>
struct Triangulations
{
  typedef CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>  Vertex_base; // the index of the lattice point
  typedef CGAL::Triangulation_cell_base_with_info_3<int, Kernel>    Cell_base;
  typedef CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base> Tds;
  typedef CGAL::Delaunay_triangulation_3<Kernel, Tds>  Delaunay;
  typedef CGAL::Triangulation_3<Kernel, Tds>           Triangulation;
};

// Inserts the points, divided by `divisor`, in their order.
template <typename Delaunay>
void insert_points(Delaunay& tr, const Lattice_points& points, const int divisor = 1)
{
  typedef typename Delaunay::Geom_traits::FT FT;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Lattice_point& p = points[i];
    const FT x(static_cast<double>(p.x)), y(static_cast<double>(p.y)), z(static_cast<double>(p.z));
    tr.insert(typename Delaunay::Point(x / divisor, y / divisor, z / divisor))->info() = static_cast<int>(i);
  }
  tr.infinite_vertex()->info() = -1;
  assert(tr.number_of_vertices() == points.size());
}

template <typename Tr>
std::vector<typename Tr::Cell_handle> finite_cells(const Tr& tr)
{
  std::vector<typename Tr::Cell_handle> cells;
  for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    cells.push_back(c);
  return cells;
}

template <typename Tr>
std::vector<typename Tr::Vertex_handle> finite_vertices(const Tr& tr)
{
  std::vector<typename Tr::Vertex_handle> vertices(tr.number_of_vertices());
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    vertices[v->info()] = v;
  return vertices;
}

// Tries n random 2-3 and 3-2 flips, after which the triangulation is not Delaunay any more. Returns how many were
// possible.
template <typename Kernel, typename Tds>
int flip_at_random(CGAL::Triangulation_3<Kernel, Tds>& tr, const int n, std::mt19937& rng)
{
  int number_of_flips = 0;
  for(int k = 0; k < n; ++k)
  {
    const auto cells = finite_cells(tr);
    const auto c = cells[random_int(rng, static_cast<int>(cells.size()))];
    const int i = random_int(rng, 4), j = (i + 1 + random_int(rng, 3)) % 4;
    if(random_int(rng, 2) == 0 ? tr.flip(c, i) : tr.flip(c, i, j))
      ++number_of_flips;
  }
  assert(tr.is_valid());
  return number_of_flips;
}

} // namespace br3_test

#endif // BR3_TEST_RANDOM_TRIANGULATIONS_H
