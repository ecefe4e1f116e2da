// The dihedral angles of a mesh, for the benchmarks; in double precision, as they decide nothing.

#ifndef BR3_BENCHMARK_MESH_QUALITY_H
#define BR3_BENCHMARK_MESH_QUALITY_H

#include <algorithm>
#include <array>
#include <cmath>

namespace br3_benchmark {

typedef std::array<double, 3> Point;

inline Point difference(const Point& p, const Point& q) { return {{ p[0] - q[0], p[1] - q[1], p[2] - q[2] }}; }
inline double dot(const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

inline Point cross(const Point& u, const Point& v)
{
  return {{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] }};
}

// The smallest and the largest dihedral angle, in degrees, of the cells that were added.
class Dihedral_angles
{
  double m_smallest = 180, m_largest = 0;

public:
  void add(const std::array<Point, 4>& p)
  {
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const int k = i == 0 ? (j == 1 ? 2 : 1) : 0, l = 6 - i - j - k; // the edge is between i and j
        const Point e = difference(p[j], p[i]);
        const Point u = cross(e, difference(p[k], p[i])), v = cross(e, difference(p[l], p[i])), w = cross(u, v);
        const double angle = std::atan2(std::sqrt(dot(w, w)), dot(u, v)) * (180 / 3.14159265358979323846);
        m_smallest = (std::min)(m_smallest, angle);
        m_largest = (std::max)(m_largest, angle);
      }
  }

  double smallest() const { return m_smallest; }
  double largest() const { return m_largest; }
};

} // namespace br3_benchmark

#endif // BR3_BENCHMARK_MESH_QUALITY_H
