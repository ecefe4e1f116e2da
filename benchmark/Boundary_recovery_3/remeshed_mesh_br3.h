// A mesh of the air around a body that moves, as arrays, and what must be true for it, for the benchmarks.

#ifndef BR3_BENCHMARK_REMESHED_MESH_H
#define BR3_BENCHMARK_REMESHED_MESH_H

#include "mesh_quality_br3.h"
#include "moving_body_br3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace br3_benchmark {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef std::array<std::size_t, 4>                          Tetrahedron;

inline Point coordinates(const Kernel::Point_3& p) { return {{ p.x(), p.y(), p.z() }}; }

// The surface: a box that turns outward, and bodies in it that turn inward, so that what is inside of them is no
// region. The last one moves.
struct Scene
{
  std::vector<Kernel::Point_3> points;
  std::vector<Triangle> triangles;
  std::size_t first_moving_point = 0;
  double volume = 0; // of the air

  void add(const Body& body, const bool is_void)
  {
    first_moving_point = points.size();
    volume += is_void ? - body.volume() : body.volume();
    for(const Triangle& t : body.triangles)
    {
      triangles.push_back({{ first_moving_point + t[0], first_moving_point + t[1], first_moving_point + t[2] }});
      if(is_void)
        std::swap(triangles.back()[1], triangles.back()[2]);
    }
    for(const Point& p : body.points)
      points.emplace_back(p[0], p[1], p[2]);
  }
};

struct Mesh
{
  std::vector<Kernel::Point_3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Triangle> facets; // those of the surface, in its order

  double smallest_angle_of(const std::size_t cell) const
  {
    const Tetrahedron& t = tetrahedra[cell];
    Dihedral_angles angles;
    angles.add({{ coordinates(points[t[0]]), coordinates(points[t[1]]),
                  coordinates(points[t[2]]), coordinates(points[t[3]]) }});
    return angles.smallest();
  }

  double smallest_angle() const
  {
    double angle = 180;
    for(std::size_t c = 0; c < tetrahedra.size(); ++c)
      angle = (std::min)(angle, smallest_angle_of(c));
    return angle;
  }

  double volume() const
  {
    double sum = 0;
    for(const Tetrahedron& t : tetrahedra)
      sum += CGAL::volume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    return sum;
  }

  bool is_positive(const std::size_t cell) const
  {
    const Tetrahedron& t = tetrahedra[cell];
    return CGAL::orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) == CGAL::POSITIVE;
  }

  bool has_positive_cells_only() const
  {
    for(std::size_t c = 0; c < tetrahedra.size(); ++c)
      if(! is_positive(c))
        return false;
    return true;
  }

  // Whether the surface, where its points are now, is the boundary of the mesh, and nothing else is.
  bool has_boundary(const Scene& scene) const
  {
    if(facets.size() != scene.triangles.size())
      return false;
    for(std::size_t i = 0; i < facets.size(); ++i)
      for(std::size_t j = 0; j < 3; ++j)
        if(points[facets[i][j]] != scene.points[scene.triangles[i][j]])
          return false;
    std::vector<Triangle> expected = facets;
    for(Triangle& f : expected)
      std::sort(f.begin(), f.end());
    std::sort(expected.begin(), expected.end());
    return boundary() == expected;
  }

  bool is_valid(const Scene& scene) const
  {
    return has_positive_cells_only() && has_boundary(scene) && std::abs(volume() - scene.volume) < 1e-9 * scene.volume;
  }

private:
  // The facets of one cell only, sorted.
  std::vector<Triangle> boundary() const
  {
    std::vector<Triangle> all;
    all.reserve(4 * tetrahedra.size());
    for(const Tetrahedron& t : tetrahedra)
      for(std::size_t i = 0; i < 4; ++i)
      {
        all.push_back({{ t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4] }});
        std::sort(all.back().begin(), all.back().end());
      }
    std::sort(all.begin(), all.end());
    std::vector<Triangle> result;
    for(std::size_t i = 0; i < all.size(); ++i)
      if((i == 0 || all[i - 1] != all[i]) && (i + 1 == all.size() || all[i + 1] != all[i]))
        result.push_back(all[i]);
    return result;
  }
};

} // namespace br3_benchmark

#endif // BR3_BENCHMARK_REMESHED_MESH_H
