#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DEFAULT_FLOW_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DEFAULT_FLOW_H

#include "surface.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

// A swept wing in a box of air: small triangles on the wing, large ones on the box. The domain is what is between them.
template <typename Point>
class Wing_in_box
{
  typedef std::size_t Index;
  typedef std::array<int, 3> Grid_point;
  typedef std::vector<Index> Section; // the vertices around the wing, from the trailing edge over the upper side

  static constexpr int number_of_stations = 13;  // of a section, on each side
  static constexpr int number_of_sections = 35;
  static constexpr double span = 2.4, taper = 0.45, sweep = 0.75, thickness = 0.14;
  static constexpr double spacing = 0.25;        // of the grid on the box
  static constexpr Grid_point low = {{ -3, -7, -3 }}, high = {{ 9, 7, 3 }};

  std::vector<Point> m_points;
  std::vector<std::vector<Index> > m_faces;

public:
  Surface<Point> operator()()
  {
    add_wing();
    add_box();
    return make_surface(m_points, m_faces);
  }

private:
  // turned into the wing, away from the air
  void add_wing()
  {
    std::vector<Section> sections;
    for(int i = 0; i < number_of_sections; ++i)
      sections.push_back(make_section(span * (double(i) / (number_of_sections - 1) - 0.5)));
    for(std::size_t s = 0; s + 1 < sections.size(); ++s)
      add_band(sections[s], sections[s + 1]);
    add_tip(sections.front(), false);
    add_tip(sections.back(), true);
  }

  Section make_section(const double y)
  {
    const double outboard = 2 * std::abs(y) / span; // 0 in the middle, 1 at the tips
    const double chord = 1 - (1 - taper) * outboard, front = sweep * outboard;
    Section section;
    for(int k = 0; k < 2 * number_of_stations; ++k)
    {
      const double x = (1 + std::cos(std::acos(-1.) * k / number_of_stations)) / 2;
      const double z = (k <= number_of_stations) ? half_thickness(x) : -half_thickness(x);
      section.push_back(m_points.size());
      m_points.emplace_back(front + chord * x, y, k % number_of_stations == 0 ? 0 : chord * z);
    }
    return section;
  }

  // of a NACA profile that is closed at the trailing edge
  static double half_thickness(const double x)
  {
    return 5 * thickness * (0.2969 * std::sqrt(x) - x * (0.1260 + x * (0.3516 - x * (0.2843 - x * 0.1036))));
  }

  void add_band(const Section& a, const Section& b)
  {
    for(std::size_t k = 0; k < a.size(); ++k)
    {
      const std::size_t l = (k + 1) % a.size();
      add_quad(a[k], a[l], b[l], b[k], k % 2 == 0);
    }
  }

  // the ends of the wing are flat
  void add_tip(const Section& section, const bool is_last)
  {
    const auto add = [&](const Index a, const Index b, const Index c)
    {
      if(is_last)
        m_faces.push_back({ a, c, b });
      else
        m_faces.push_back({ a, b, c });
    };
    const std::size_t n = section.size();
    for(std::size_t k = 0; 2 * k + 2 <= n; ++k) // from the trailing edge on, between the upper side and the lower one
    {
      if(k > 0)
        add(section[k], section[n - k], section[k + 1]);
      if(2 * k + 2 < n)
        add(section[k + 1], section[(n - k) % n], section[n - k - 1]);
    }
  }

  void add_quad(const Index a, const Index b, const Index c, const Index d, const bool is_from_a)
  {
    m_faces.push_back({ a, b, is_from_a ? c : d });
    m_faces.push_back({ is_from_a ? a : b, c, d });
  }

  void add_box()
  {
    std::map<Grid_point, Index> numbers;
    const auto vertex = [&](const Grid_point& g)
    {
      const auto inserted = numbers.emplace(g, m_points.size());
      if(inserted.second)
        m_points.emplace_back(spacing * g[0], spacing * g[1], spacing * g[2]);
      return inserted.first->second;
    };
    for(int axis = 0; axis < 3; ++axis)
      for(const bool is_high : { false, true })
      {
        const int u = (axis + (is_high ? 1 : 2)) % 3, v = (axis + (is_high ? 2 : 1)) % 3; // turned outward
        Grid_point g = is_high ? high : low;
        for(int i = low[u]; i < high[u]; ++i)
          for(int j = low[v]; j < high[v]; ++j)
          {
            const auto corner = [&](const int di, const int dj)
            {
              g[u] = i + di;
              g[v] = j + dj;
              return vertex(g);
            };
            const Index a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
            add_quad(a, b, c, d, (i + j) % 2 == 0);
          }
      }
  }
};

// the surface that `mesh_surface` takes if it is given none
template <typename Point>
Surface<Point> default_flow()
{
  return Wing_in_box<Point>()();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DEFAULT_FLOW_H
