#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DROP_DUST_REGIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DROP_DUST_REGIONS_H

#include "soup_regions.h"
#include "triangle_soup.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

// Makes dust a part of what is beside it. Where two sheets of a surface are as good as one, or a sheet is folded, their
// intersections enclose regions that nobody meant. Dust is small as compared with the whole, or thinner than the
// tolerance, and it is bounded by parts of divided triangles, most of all. It joins the neighbor with which it has the
// largest area in common, the triangles between them go, and so do those of a fold whose sides are the same triangle.
// All the other triangles stay as they are, so nothing intersects.
template <typename Point>
class Dust_dropper
{
  static constexpr double largest_dust = 1e-6; // as a share of the volume of all regions

  Triangle_soup<Point>& m_soup;
  const Soup_regions<Point> m_regions;
  std::vector<double> m_volumes;
  std::vector<std::map<std::size_t, double> > m_areas;  // of each region, those in common with neighbors
  std::vector<bool> m_is_dust;
  std::vector<std::size_t> m_joined;                    // the region that it has become a part of, or itself

public:
  explicit Dust_dropper(Triangle_soup<Point>& soup)
    : m_soup(soup), m_regions(soup), m_volumes(m_regions.volumes()), m_areas(m_volumes.size()),
      m_is_dust(m_volumes.size(), false), m_joined(m_volumes.size())
  { }

  // `is_part` tells of each triangle whether it is not the whole of its source. Returns the number of regions that are
  // gone.
  std::size_t operator()(const std::vector<bool>& is_part, const double tolerance)
  {
    if(m_regions.walls().size() != m_soup.triangles.size()) // not recovered
      return 0;
    measure_areas();
    find_dust(is_part, tolerance);
    const std::size_t number_of_regions = join_dust();
    drop_triangles();
    return number_of_regions;
  }

private:
  void measure_areas()
  {
    for(const Region_wall& wall : m_regions.walls())
      if(wall.separates())
        for(int i = 0; i < 2; ++i)
          m_areas[wall.regions[i]][wall.regions[1 - i]] += wall.area;
  }

  void find_dust(const std::vector<bool>& is_part, const double tolerance)
  {
    double volume = 0;
    for(const double v : m_volumes)
      volume += v;
    std::vector<std::size_t> number_of_parts(m_volumes.size(), 0), number_of_wholes(m_volumes.size(), 0);
    for(const Region_wall& wall : m_regions.walls())
      for(const std::size_t r : wall.regions)
        ++(is_part[wall.triangle] ? number_of_parts : number_of_wholes)[r];
    for(std::size_t r = 1; r < m_volumes.size(); ++r)
    {
      double area = 0;
      for(const auto& neighbor : m_areas[r])
        area += neighbor.second;
      const bool is_small = m_volumes[r] < largest_dust * volume || 2 * m_volumes[r] < tolerance * area;
      m_is_dust[r] = is_small && number_of_parts[r] > number_of_wholes[r];
    }
  }

  // the smallest ones first, as dust may join dust
  std::size_t join_dust()
  {
    std::vector<std::size_t> dust;
    for(std::size_t r = 0; r < m_volumes.size(); ++r)
    {
      m_joined[r] = r;
      if(m_is_dust[r])
        dust.push_back(r);
    }
    std::stable_sort(dust.begin(), dust.end(),
                     [&](const std::size_t r, const std::size_t s) { return m_volumes[r] < m_volumes[s]; });
    for(const std::size_t r : dust)
      join(r, neighbor_for(r));
    return dust.size();
  }

  std::size_t neighbor_for(const std::size_t region) const
  {
    const auto is_worse = [&](const auto& a, const auto& b)
    {
      const bool is_dust_a = m_is_dust[a.first], is_dust_b = m_is_dust[b.first];
      return is_dust_a != is_dust_b ? is_dust_a : a.second < b.second;
    };
    return std::max_element(m_areas[region].begin(), m_areas[region].end(), is_worse)->first;
  }

  void join(const std::size_t region, const std::size_t target)
  {
    m_joined[region] = target;
    for(const auto& neighbor : m_areas[region])
    {
      m_areas[neighbor.first].erase(region);
      if(neighbor.first == target)
        continue;
      m_areas[neighbor.first][target] += neighbor.second;
      m_areas[target][neighbor.first] += neighbor.second;
    }
  }

  std::size_t joined(std::size_t region) const
  {
    while(m_joined[region] != region)
      region = m_joined[region];
    return region;
  }

  // A sheet that was there before the intersections were resolved stays.
  void drop_triangles()
  {
    std::vector<Sourced_triangle> kept;
    for(const Region_wall& wall : m_regions.walls())
    {
      const Sourced_triangle& t = m_soup.triangles[wall.triangle];
      const bool is_within = wall.separates() ? joined(wall.regions[0]) == joined(wall.regions[1]) : ! t.is_odd;
      if(! is_within)
        kept.push_back(t);
    }
    m_soup.triangles.swap(kept);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DROP_DUST_REGIONS_H
