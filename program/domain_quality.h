#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H

#include "domain.h"

#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

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

// Measures the dihedral angles of tetrahedra. Most are not found but compared, by the squares of their cotangents.
class Quality_meter
{
  typedef CGAL::Boundary_recovery_3::internal::Cell_angles_3       Angles;
  typedef std::array<double, Mesh_quality::number_of_bins - 1>     Ends_of_bins;
  typedef std::array<double, Mesh_quality::small_angles.size()>    Small_angles;
  typedef std::array<double, Mesh_quality::large_angles.size()>    Large_angles;

  const Ends_of_bins m_bins = squares_of_cotangents(ends_of_bins());
  const Small_angles m_small = squares_of_cotangents(Mesh_quality::small_angles);
  const Large_angles m_large = squares_of_cotangents(Mesh_quality::large_angles);
  double m_largest_square = - std::numeric_limits<double>::infinity();
  double m_smallest_square = std::numeric_limits<double>::infinity();
  Mesh_quality m_quality;

public:
  Quality_meter() { m_quality.smallest_angle = 180; }

  // If there is no volume, a square may be no number, which compares with none; then the smallest angle is 0.
  void add(const std::array<std::array<double, 3>, 4>& corners)
  {
    const Angles angles(corners);
    for(int k = 0; k < 6; ++k)
      ++m_quality.histogram[bin(angles.square_of_cotangent(k))];
    const double largest = angles.square_of_largest_cotangent(), smallest = angles.square_of_smallest_cotangent();
    for(std::size_t i = 0; i < m_small.size(); ++i)
      m_quality.below[i] += ! (largest <= m_small[i]);
    for(std::size_t i = 0; i < m_large.size(); ++i)
      m_quality.above[i] += smallest < m_large[i];
    if(! (largest <= m_largest_square))
      m_quality.smallest_angle = (std::min)(m_quality.smallest_angle, angles.smallest());
    if(! (smallest >= m_smallest_square))
      m_quality.largest_angle = (std::max)(m_quality.largest_angle, angles.largest());
    m_largest_square = (std::max)(m_largest_square, largest);
    m_smallest_square = (std::min)(m_smallest_square, smallest);
  }

  // of one tetrahedron at least
  const Mesh_quality& quality() const { return m_quality; }

private:
  // A little below the angles, since those of 60 and 90 degrees are common, up to rounding errors.
  static Ends_of_bins ends_of_bins()
  {
    Ends_of_bins ends;
    for(std::size_t i = 0; i < ends.size(); ++i)
      ends[i] = double(i + 1) * Mesh_quality::degrees_per_bin - 1e-9;
    return ends;
  }

  template <std::size_t N>
  static std::array<double, N> squares_of_cotangents(std::array<double, N> angles)
  {
    for(double& x : angles)
      x = CGAL::Boundary_recovery_3::internal::signed_square_of_cotangent(x);
    return angles;
  }

  // without branches, since nobody can predict them
  std::size_t bin(const double square) const
  {
    std::size_t bin = 0;
    for(const double end : m_bins)
      bin += square <= end;
    return bin;
  }
};

// by all threads
template <typename Point>
Mesh_quality measure_quality(const Domain<Point>& domain)
{
  namespace internal = CGAL::Boundary_recovery_3::internal;
  typedef std::array<Point_number, 4> Tetrahedron;

  const auto corner = [&](const Point_number v)
  {
    const Point& p = domain.points[v];
    return std::array<double, 3>{{ p.x(), p.y(), p.z() }};
  };
  const auto measure = [&](const std::vector<Tetrahedron>& tetrahedra)
  {
    Quality_meter meter;
    for(const Tetrahedron& t : tetrahedra)
      meter.add({{ corner(t[0]), corner(t[1]), corner(t[2]), corner(t[3]) }});
    return meter.quality();
  };
  Mesh_quality sum;
  const auto take = [&sum](const Mesh_quality& quality)
  {
    sum += quality;
    return true;
  };
  internal::for_each_block(domain.tetrahedra, measure, take, CGAL::Parallel_if_available_tag());
  return sum;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_QUALITY_H
