#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DEFAULT_SURFACE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DEFAULT_SURFACE_H

#include "surface.h"

#include <cmath>
#include <cstddef>
#include <vector>

// A gear with a hub and a bore, triangulated as CAD systems do it: walls of one row of long triangles, flat rings
// of thin ones. Its Delaunay triangulation lacks many of its edges.
template <typename Point>
class Gear
{
  typedef std::size_t Index;
  typedef std::vector<Index> Ring; // the vertices of a closed curve around the axis, at the same angles in each ring

  static constexpr int number_of_teeth = 18;
  static constexpr int number_of_angles = 4 * number_of_teeth; // up, along the tip, down, along the foot

  std::vector<Point> m_points;
  std::vector<std::vector<Index> > m_faces;

public:
  Surface<Point> operator()()
  {
    const Ring bottom_bore = make_ring(0, 8, 8), bottom_gear = make_ring(0, 26, 30);
    const Ring top_gear = make_ring(6, 26, 30), top_foot = make_ring(6, 13, 13);
    const Ring top_hub = make_ring(20, 13, 13), top_bore = make_ring(20, 8, 8);
    add_band(bottom_bore, bottom_gear);
    add_band(bottom_gear, top_gear);
    add_band(top_gear, top_foot);
    add_band(top_foot, top_hub);
    add_band(top_hub, top_bore);
    add_band(top_bore, bottom_bore);
    return make_surface(m_points, m_faces);
  }

private:
  Ring make_ring(const double z, const double foot_radius, const double tip_radius)
  {
    const double pi = std::acos(-1.);
    Ring ring;
    for(int i = 0; i < number_of_angles; ++i)
    {
      const double angle = 2 * pi * i / number_of_angles;
      const double radius = (i % 4 == 1 || i % 4 == 2) ? tip_radius : foot_radius;
      ring.push_back(m_points.size());
      m_points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return ring;
  }

  // Two triangles between each two angles, turned outward if the surface goes on from ring `a` to ring `b`. Their
  // diagonals alternate: a bore whose diagonals all turn the same way cannot be filled without further points.
  void add_band(const Ring& a, const Ring& b)
  {
    for(std::size_t i = 0; i < a.size(); ++i)
    {
      const std::size_t j = (i + 1) % a.size(), k = (i % 2 == 0) ? j : i; // the diagonal is at a[i + j - k] and b[k]
      m_faces.push_back({ a[i], a[j], b[k] });
      m_faces.push_back({ a[i + j - k], b[j], b[i] });
    }
  }
};

// the surface that `recover_boundary` takes if it is given none
template <typename Point>
Surface<Point> default_surface()
{
  return Gear<Point>()();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DEFAULT_SURFACE_H
