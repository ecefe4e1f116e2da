#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H

#include "domain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// The dihedral angles of tetrahedra, in degrees.
struct Mesh_quality
{
  static constexpr std::array<double, 4> small_angles = {{ 5, 10, 15, 20 }};
  static constexpr std::array<double, 3> large_angles = {{ 150, 160, 170 }};
  static constexpr std::size_t number_of_bins = 18;
  static constexpr double degrees_per_bin = 180. / number_of_bins;

  double smallest_angle = 0, largest_angle = 0;              // 0 and 0 if there is no tetrahedron
  std::array<std::size_t, number_of_bins> histogram = {};    // of all angles: number in each bin
  std::array<std::size_t, small_angles.size()> below = {};   // number of tetrahedra with an angle below
  std::array<std::size_t, large_angles.size()> above = {};   // number of tetrahedra with an angle above

  // of two meshes together
  Mesh_quality& operator+=(const Mesh_quality& other)
  {
    if(largest_angle == 0)
      smallest_angle = other.smallest_angle;
    else if(other.largest_angle > 0)
      smallest_angle = (std::min)(smallest_angle, other.smallest_angle);
    largest_angle = (std::max)(largest_angle, other.largest_angle);
    add(histogram, other.histogram);
    add(below, other.below);
    add(above, other.above);
    return *this;
  }

private:
  template <std::size_t N>
  static void add(std::array<std::size_t, N>& sum, const std::array<std::size_t, N>& numbers)
  {
    for(std::size_t i = 0; i < N; ++i)
      sum[i] += numbers[i];
  }
};

// Measures the dihedral angles. A mesh has millions of tetrahedra: four normals each, instead of one look at each edge.
template <typename Point>
class Quality_meter
{
  typedef std::array<double, 3> Vector;

  static constexpr double degrees_per_radian = 57.295779513082321;

  const Domain<Point>& m_domain;
  Mesh_quality m_quality;
  std::array<double, Mesh_quality::number_of_bins - 1> m_borders; // the cosines between the bins

public:
  explicit Quality_meter(const Domain<Point>& domain)
    : m_domain(domain)
  {
    for(std::size_t i = 0; i < m_borders.size(); ++i)
      m_borders[i] = std::cos(double(i + 1) * Mesh_quality::degrees_per_bin / degrees_per_radian);
  }

  Mesh_quality operator()()
  {
    if(m_domain.tetrahedra.empty())
      return m_quality;
    m_quality.smallest_angle = 180;
    for(const auto& tetrahedron : m_domain.tetrahedra)
      add(tetrahedron);
    return m_quality;
  }

private:
  static Vector difference(const Point& p, const Point& q) { return {{ p.x() - q.x(), p.y() - q.y(), p.z() - q.z() }}; }

  static Vector cross(const Vector& a, const Vector& b)
  {
    return {{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] }};
  }

  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  // the angle between two facets with these outward normals; the arc cosine alone would blur angles near 0 and 180
  static double angle(const Vector& a, const Vector& b)
  {
    const Vector n = cross(a, b);
    return std::atan2(std::sqrt(dot(n, n)), -dot(a, b)) * degrees_per_radian;
  }

  void add(const std::array<Point_number, 4>& tetrahedron)
  {
    std::array<Vector, 3> e;
    for(std::size_t i = 0; i < 3; ++i)
      e[i] = difference(m_domain.points[tetrahedron[i + 1]], m_domain.points[tetrahedron[0]]);
    std::array<Vector, 4> normals = {{ {}, cross(e[2], e[1]), cross(e[0], e[2]), cross(e[1], e[0]) }};
    for(std::size_t i = 0; i < 3; ++i) // the four add up to 0
      normals[0][i] = -(normals[1][i] + normals[2][i] + normals[3][i]);

    std::array<double, 4> lengths;
    for(std::size_t i = 0; i < 4; ++i)
      lengths[i] = std::sqrt(dot(normals[i], normals[i]));

    std::array<std::size_t, 2> low = {{ 0, 1 }}, high = low; // between which facets the extreme angles are
    double low_cosine = -2, high_cosine = 2;
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = i + 1; j < 4; ++j)
      {
        const double cosine = -dot(normals[i], normals[j]) / (lengths[i] * lengths[j]);
        ++m_quality.histogram[bin(cosine)];
        if(cosine > low_cosine)
          low = {{ i, j }};
        if(cosine < high_cosine)
          high = {{ i, j }};
        low_cosine = (std::max)(low_cosine, cosine);
        high_cosine = (std::min)(high_cosine, cosine);
      }
    count(angle(normals[low[0]], normals[low[1]]), angle(normals[high[0]], normals[high[1]]));
  }

  // Cosines fall as angles grow. NaN, that of a facet without area, is in the first bin.
  std::size_t bin(const double cosine) const
  {
    const auto larger = [](const double border, const double x) { return border >= x; };
    return static_cast<std::size_t>(std::lower_bound(m_borders.begin(), m_borders.end(), cosine, larger)
                                    - m_borders.begin());
  }

  void count(const double low, const double high)
  {
    m_quality.smallest_angle = (std::min)(m_quality.smallest_angle, low);
    m_quality.largest_angle = (std::max)(m_quality.largest_angle, high);
    for(std::size_t i = 0; i < m_quality.below.size(); ++i)
      m_quality.below[i] += low < Mesh_quality::small_angles[i];
    for(std::size_t i = 0; i < m_quality.above.size(); ++i)
      m_quality.above[i] += high > Mesh_quality::large_angles[i];
  }
};

template <typename Point>
Mesh_quality measure_quality(const Domain<Point>& domain)
{
  return Quality_meter<Point>(domain)();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H
