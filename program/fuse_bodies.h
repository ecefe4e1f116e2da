#ifndef BOUNDARY_RECOVERY_3_PROGRAM_FUSE_BODIES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_FUSE_BODIES_H

#include "soup_regions.h"
#include "triangle_soup.h"

#include <algorithm>
#include <cstddef>
#include <vector>

// Makes one body of all that overlap: keeps the triangles between what is outside of all bodies and what is inside of
// any, and turns them outward. Inside is where the winding number is not 0: the number of bodies around a place, those
// counted as -1 that are inside out. It changes with each triangle on the way from the outside, so it is exact.
// Triangles that bound nothing are kept outside of all bodies, and dropped inside.
template <typename Point>
class Body_fuser
{
  // a way from a region to another one, and what it adds to the winding number
  struct Crossing
  {
    std::size_t target;
    long weight;
  };

  Triangle_soup<Point>& m_soup;
  const Soup_regions<Point> m_regions;
  std::vector<long> m_windings; // of each region

public:
  explicit Body_fuser(Triangle_soup<Point>& soup) : m_soup(soup), m_regions(soup) { }

  // Returns `false`, and changes nothing, if there are no winding numbers, as the surface is open where it bounds
  // something, or its triangles are not turned alike; or if there is no body.
  bool operator()()
  {
    if(m_soup.triangles.empty() || m_regions.walls().size() != m_soup.triangles.size() || ! find_windings()
       || ! is_any_body())
      return false;
    std::vector<Sourced_triangle> kept;
    for(const Region_wall& wall : m_regions.walls())
    {
      const bool is_outside_in_front = m_windings[wall.regions[0]] == 0;
      if(is_outside_in_front && ! wall.separates())
        kept.push_back(m_soup.triangles[wall.triangle]);
      if(is_outside_in_front == (m_windings[wall.regions[1]] == 0))
        continue;
      kept.push_back(m_soup.triangles[wall.triangle]);
      if(! is_outside_in_front)
        std::reverse(kept.back().begin(), kept.back().end());
      kept.back().weight = 1;
    }
    m_soup.triangles.swap(kept);
    return true;
  }

private:
  bool is_any_body() const
  {
    return std::any_of(m_windings.begin(), m_windings.end(), [](const long winding) { return winding != 0; });
  }

  // returns whether all ways to a region give it the same number
  bool find_windings()
  {
    const std::size_t n = m_regions.volumes().size();
    std::vector<std::vector<Crossing> > crossings(n);
    for(const Region_wall& wall : m_regions.walls())
      if(wall.separates()) // a sheet that ends in a region has no say
      {
        const long weight = m_soup.triangles[wall.triangle].weight;
        crossings[wall.regions[0]].push_back(Crossing{ wall.regions[1], weight });
        crossings[wall.regions[1]].push_back(Crossing{ wall.regions[0], -weight });
      }
    m_windings.assign(n, 0);
    std::vector<bool> is_known(n, false);
    std::vector<std::size_t> stack(1, 0);
    is_known[0] = true;
    while(! stack.empty())
    {
      const std::size_t region = stack.back();
      stack.pop_back();
      for(const Crossing& crossing : crossings[region])
      {
        const long winding = m_windings[region] + crossing.weight;
        if(is_known[crossing.target] && m_windings[crossing.target] != winding)
          return false;
        if(is_known[crossing.target])
          continue;
        is_known[crossing.target] = true;
        m_windings[crossing.target] = winding;
        stack.push_back(crossing.target);
      }
    }
    return true;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_FUSE_BODIES_H
