// The dihedral angles of a mesh, for the benchmarks; in double precision, as they decide nothing.

#ifndef BR3_BENCHMARK_MESH_QUALITY_H
#define BR3_BENCHMARK_MESH_QUALITY_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>

namespace br3_benchmark {

typedef std::array<double, 3> Point;

inline Point difference(const Point& p, const Point& q) { return {{ p[0] - q[0], p[1] - q[1], p[2] - q[2] }}; }
inline double dot(const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

inline Point cross(const Point& u, const Point& v)
{
  return {{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] }};
}

// The smallest and the largest dihedral angle, in degrees, of the cells that were added, and how many cells have one
// below 5, 10, 15 and 20 degrees.
class Dihedral_angles
{
  double m_smallest = 180, m_largest = 0;
  std::array<std::size_t, 4> m_numbers_below = {{ 0, 0, 0, 0 }};

public:
  void add(const std::array<Point, 4>& p)
  {
    double smallest = 180;
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const int k = i == 0 ? (j == 1 ? 2 : 1) : 0, l = 6 - i - j - k; // the edge is between i and j
        const Point e = difference(p[j], p[i]);
        const Point u = cross(e, difference(p[k], p[i])), v = cross(e, difference(p[l], p[i])), w = cross(u, v);
        const double angle = std::atan2(std::sqrt(dot(w, w)), dot(u, v)) * (180 / 3.14159265358979323846);
        smallest = (std::min)(smallest, angle);
        m_largest = (std::max)(m_largest, angle);
      }
    m_smallest = (std::min)(m_smallest, smallest);
    for(std::size_t i = 0; i < m_numbers_below.size(); ++i)
      m_numbers_below[i] += smallest < 5. * double(i + 1) ? 1 : 0;
  }

  double smallest() const { return m_smallest; }
  double largest() const { return m_largest; }
  const std::array<std::size_t, 4>& numbers_below() const { return m_numbers_below; }
};

// members of a JSON object
inline std::ostream& write_json(std::ostream& os, const Dihedral_angles& angles)
{
  const auto& n = angles.numbers_below();
  return os << "\"smallest_angle\": " << angles.smallest() << ", \"largest_angle\": " << angles.largest()
            << ", \"cells_below_5_10_15_20\": [" << n[0] << ", " << n[1] << ", " << n[2] << ", " << n[3] << "]";
}

} // namespace br3_benchmark

#endif // BR3_BENCHMARK_MESH_QUALITY_H
