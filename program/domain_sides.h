#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_SIDES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_SIDES_H

#include "domain.h"

#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>
#include <CGAL/tags.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

// The regions on both sides of a triangle, the smaller one first; 0 is the outside.
typedef std::array<int, 2> Sides;

// the region beside a triangle, the smaller one of two; 0 if there is none
inline int region_beside(const Sides& sides) { return sides[0] != 0 ? sides[0] : sides[1]; }

// Finds the tetrahedra beside each triangle of a domain. Triangles are looked up by their vertex with the smallest
// number: no hashing, no sorting. Most facets of tetrahedra have a point that no triangle has, as those have the first
// numbers; all threads sort those tetrahedra out that have only such facets.
template <typename Point>
class Side_finder
{
  typedef std::array<Point_number, 3> Triangle;

  const Domain<Point>& m_domain;
  const std::vector<int>& m_regions;     // of the tetrahedra; or other numbers that tell them apart
  std::vector<std::size_t> m_begin;      // for each point up to the last one of a triangle, where its triangles begin
  std::vector<std::size_t> m_triangles;  // sorted by their smallest point
  std::vector<Sides> m_sides;
  std::vector<int> m_number_of_sides;

public:
  Side_finder(const Domain<Point>& domain, const std::vector<int>& regions)
    : m_domain(domain), m_regions(regions), m_begin(number_of_points(domain.triangles) + 1, 0),
      m_triangles(domain.triangles.size()),
      m_sides(domain.triangles.size(), Sides{{ 0, 0 }}), m_number_of_sides(domain.triangles.size(), 0)
  { }

  // the sides of each triangle
  std::vector<Sides> operator()()
  {
    sort_triangles();
    CGAL::Boundary_recovery_3::internal::take_each(
      boost::irange(std::size_t(0), m_domain.tetrahedra.size()),
      [this](const std::size_t t) { return can_have_triangle(t) ? std::make_optional(t) : std::nullopt; },
      [this](const std::size_t t) { add_sides(t); }, CGAL::Parallel_if_available_tag());
    for(Sides& sides : m_sides)
      std::sort(sides.begin(), sides.end());
    return std::move(m_sides);
  }

private:
  static std::size_t number_of_points(const std::vector<Triangle>& triangles)
  {
    std::size_t n = 0;
    for(const Triangle& t : triangles)
      n = (std::max)(n, std::size_t(*std::max_element(t.begin(), t.end())) + 1);
    return n;
  }

  static Triangle sorted(Triangle t)
  {
    std::sort(t.begin(), t.end());
    return t;
  }

  static Point_number smallest(const Triangle& t) { return *std::min_element(t.begin(), t.end()); }

  void sort_triangles()
  {
    for(const Triangle& t : m_domain.triangles)
      ++m_begin[smallest(t) + 1];
    for(std::size_t v = 1; v < m_begin.size(); ++v)
      m_begin[v] += m_begin[v - 1];
    std::vector<std::size_t> next(m_begin);
    for(std::size_t i = 0; i < m_domain.triangles.size(); ++i)
      m_triangles[next[smallest(m_domain.triangles[i])]++] = i;
  }

  bool can_be_of_triangle(const Point_number v) const { return v + std::size_t(1) < m_begin.size(); }

  bool can_have_triangle(const std::size_t t) const
  {
    const auto& v = m_domain.tetrahedra[t];
    return std::count_if(v.begin(), v.end(), [this](const Point_number i) { return can_be_of_triangle(i); }) >= 3;
  }

  void add_sides(const std::size_t t)
  {
    const auto& v = m_domain.tetrahedra[t];
    for(int i = 0; i < 4; ++i)
      add_side({{ v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4] }}, m_regions[t]);
  }

  void add_side(const Triangle& corners, const int region)
  {
    if(! std::all_of(corners.begin(), corners.end(), [this](const Point_number v) { return can_be_of_triangle(v); }))
      return;
    const Triangle facet = sorted(corners);
    for(std::size_t k = m_begin[facet[0]]; k < m_begin[facet[0] + 1]; ++k)
    {
      const std::size_t i = m_triangles[k];
      if(m_number_of_sides[i] < 2 && sorted(m_domain.triangles[i]) == facet)
        m_sides[i][m_number_of_sides[i]++] = region;
    }
  }
};

template <typename Point>
std::vector<Sides> find_sides(const Domain<Point>& domain, const std::vector<int>& regions)
{
  return Side_finder<Point>(domain, regions)();
}

template <typename Point>
std::vector<Sides> find_sides(const Domain<Point>& domain)
{
  return find_sides(domain, domain.regions);
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DOMAIN_SIDES_H
