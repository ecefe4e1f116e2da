#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H

#include "domain.h"

#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>

#include <algorithm>
#include <array>
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

// Measures the dihedral angles.
template <typename Point>
class Quality_meter
{
  typedef CGAL::Boundary_recovery_3::internal::Cell_angles_3 Angles;

  const Domain<Point>& m_domain;
  Mesh_quality m_quality;

public:
  explicit Quality_meter(const Domain<Point>& domain) : m_domain(domain) { }

  Mesh_quality operator()()
  {
    if(m_domain.tetrahedra.empty())
      return m_quality;
    m_quality.smallest_angle = 180;
    for(const auto& t : m_domain.tetrahedra)
    {
      const std::array<std::array<double, 3>, 4> corners = {{ corner(t[0]), corner(t[1]), corner(t[2]), corner(t[3]) }};
      add(Angles(corners));
    }
    return m_quality;
  }

private:
  std::array<double, 3> corner(const Point_number v) const
  {
    const Point& p = m_domain.points[v];
    return {{ p.x(), p.y(), p.z() }};
  }

  void add(const Angles& angles)
  {
    for(int k = 0; k < 6; ++k)
      ++m_quality.histogram[bin(angles[k])];
    m_quality.smallest_angle = (std::min)(m_quality.smallest_angle, angles.smallest());
    m_quality.largest_angle = (std::max)(m_quality.largest_angle, angles.largest());
    for(std::size_t i = 0; i < m_quality.below.size(); ++i)
      m_quality.below[i] += angles.smallest() < Mesh_quality::small_angles[i];
    for(std::size_t i = 0; i < m_quality.above.size(); ++i)
      m_quality.above[i] += angles.largest() > Mesh_quality::large_angles[i];
  }

  static std::size_t bin(const double angle)
  {
    const std::size_t bin = static_cast<std::size_t>(angle / Mesh_quality::degrees_per_bin);
    return (std::min)(bin, Mesh_quality::number_of_bins - 1);
  }
};

template <typename Point>
Mesh_quality measure_quality(const Domain<Point>& domain)
{
  return Quality_meter<Point>(domain)();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H
