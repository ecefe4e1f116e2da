// Valid inputs that flips alone do not recover, or that are full of lost constraints. All coordinates are integers.

#ifndef BR3_TEST_STEINER_INPUTS_H
#define BR3_TEST_STEINER_INPUTS_H

#include "brute_force_input_br3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

namespace br3_test {

// A prism with n sides whose top is turned by `turn` steps of a side, and whose walls are folded inwards. For n = 3 and
// half a step or less, this is the polyhedron of Schoenhardt.
inline Plc twisted_prism(const std::size_t n, const double turn, const double radius, const double height)
{
  Plc plc;
  for(const bool is_top : { false, true })
    for(std::size_t i = 0; i < n; ++i)
    {
      const double a = 2 * std::acos(-1.) * (static_cast<double>(i) + (is_top ? turn : 0)) / static_cast<double>(n);
      plc.points.push_back({{ std::round(radius * std::cos(a)), std::round(radius * std::sin(a)),
                              is_top ? height : 0. }});
    }
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (i + 1) % n;
    plc.triangles.push_back({ i, j, n + j }); // the diagonal from i to n + j is the longer one, it goes inside
    plc.triangles.push_back({ i, n + j, n + i });
    if(i >= 2)
    {
      plc.triangles.push_back({ 0, i, i - 1 });
      plc.triangles.push_back({ n, n + i - 1, n + i });
    }
  }
  return plc;
}

// A box with n notches from above along y, down to the lines x = 8i, z = xy / 8 + gap, and n notches from below along
// x, up to y = 8j, z = xy / 8 - gap: between them the saddle of Chazelle's polyhedron is `2 gap` thick.
class Notched_box
{
public:
  Notched_box(const int n, const int gap)
    : m_n(n), m_length(8 * (n + 1)), m_height(16 * (n + 1) * (n + 1)), m_gap(gap)
  {
    for(const int side : { 1, -1 })
    {
      for(int i = 1; i <= n; ++i)
        add_notch(side, i);
      for(int i = 0; i <= n; ++i) // what the notches leave of the top
        add_quad({{ at(side, 8 * i + (i == 0 ? 0 : 1), 0, side * m_height),
                    at(side, 8 * i + (i == n ? 8 : 7), 0, side * m_height),
                    at(side, 8 * i + (i == n ? 8 : 7), m_length, side * m_height),
                    at(side, 8 * i + (i == 0 ? 0 : 1), m_length, side * m_height) }});
      for(const int end : { 0, m_length })
        add_wall(side, end);
    }
  }

  const Plc& plc() const { return m_plc; }

private:
  // For the notches from below, x and y change roles.
  std::size_t at(const int side, const int along, const int across, const int z)
  {
    const std::array<int, 3> p = side > 0 ? std::array<int, 3>{{ along, across, z }}
                                          : std::array<int, 3>{{ across, along, z }};
    const auto inserted = m_indices.emplace(p, m_plc.points.size());
    if(inserted.second)
      m_plc.points.push_back({{ static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) }});
    return inserted.first->second;
  }

  std::size_t bottom_of_notch(const int side, const int i, const int across)
  {
    return at(side, 8 * i, across, i * across + side * m_gap);
  }

  // An array, as arguments get their numbers in an order that is the compiler's affair.
  void add_quad(const std::array<std::size_t, 4>& p)
  {
    m_plc.triangles.push_back({ p[0], p[1], p[2] });
    m_plc.triangles.push_back({ p[0], p[2], p[3] });
  }

  void add_notch(const int side, const int i)
  {
    for(const int d : { -1, 1 })
      add_quad({{ bottom_of_notch(side, i, 0), bottom_of_notch(side, i, m_length),
                  at(side, 8 * i + d, m_length, side * m_height), at(side, 8 * i + d, 0, side * m_height) }});
  }

  // The wall that the notches of a side open to: all of it is seen from the far edge, the notches are so thin.
  void add_wall(const int side, const int end)
  {
    std::vector<std::size_t> rim = { at(side, m_length, end, -side * m_height),
                                     at(side, m_length, end, side * m_height) };
    for(int i = m_n; i >= 1; --i)
    {
      rim.push_back(at(side, 8 * i + 1, end, side * m_height));
      rim.push_back(bottom_of_notch(side, i, end));
      rim.push_back(at(side, 8 * i - 1, end, side * m_height));
    }
    rim.push_back(at(side, 0, end, side * m_height));
    rim.push_back(at(side, 0, end, -side * m_height));
    if(side < 0)
      std::reverse(rim.begin(), rim.end());
    cut_ears(rim, side > 0 ? 0 : 1);
  }

  double area(const std::size_t p, const std::size_t q, const std::size_t r, const int axis) const
  {
    const Coordinates& a = m_plc.points[p];
    const Coordinates& b = m_plc.points[q];
    const Coordinates& c = m_plc.points[r];
    return (b[axis] - a[axis]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[axis] - a[axis]); // exact, they are integers
  }

  // Of a polygon that is counterclockwise in the plane of `axis` and z.
  void cut_ears(std::vector<std::size_t> rim, const int axis)
  {
    while(rim.size() > 2)
      for(std::size_t i = 0; i < rim.size(); ++i)
      {
        const std::size_t p = rim[(i + rim.size() - 1) % rim.size()], q = rim[i], r = rim[(i + 1) % rim.size()];
        const bool is_ear = area(p, q, r, axis) > 0 && std::none_of(rim.begin(), rim.end(), [&](const std::size_t v)
        {
          return v != p && v != q && v != r && area(p, q, v, axis) >= 0 && area(q, r, v, axis) >= 0
              && area(r, p, v, axis) >= 0;
        });
        if(! is_ear)
          continue;
        m_plc.triangles.push_back({ p, q, r });
        rim.erase(rim.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      }
  }

  const int m_n, m_length, m_height, m_gap;
  Plc m_plc;
  std::map<std::array<int, 3>, std::size_t> m_indices;
};

// Points of a grid, and random constraints that do not intersect. A plane of the grid that many points share gives
// constraints on the convex hull.
class Random_constraints
{
public:
  explicit Random_constraints(const unsigned seed) : m_random(seed) { }

  Plc operator()(const int number_of_points, const int grid, const int number_of_triangles, const int number_of_edges)
  {
    Plc plc;
    while(static_cast<int>(plc.points.size()) < number_of_points)
      add_point(plc, {{ next(grid), next(grid), next(grid) }});
    add_constraints(plc, number_of_triangles, number_of_edges);
    return plc;
  }

  // An edge from bottom to top with facets all around it, and random points close to it that want to cut it.
  Plc fan(const std::size_t number_of_blades, const int number_of_points)
  {
    static const double directions[4][2] = { { 40, 3 }, { -5, 38 }, { -37, -8 }, { 6, -41 } };
    Plc plc;
    plc.points = { {{ 0, 0, -50 }}, {{ 1, 2, 50 }} };
    plc.edges = { { 0, 1 } };
    for(std::size_t i = 0; i < number_of_blades; ++i)
    {
      plc.points.push_back({{ directions[i][0], directions[i][1], static_cast<double>(i) }});
      plc.triangles.push_back({ 0, 1, 2 + i });
    }
    while(static_cast<int>(plc.points.size()) < number_of_points)
    {
      add_point(plc, {{ next(21) - 10, next(21) - 10, next(61) - 30 }});
      if(! Brute_force_input(plc).vertices_on_constraints().empty())
        plc.points.pop_back();
    }
    return plc;
  }

  // Tries to add so many triangles and edges.
  void add_constraints(Plc& plc, const int number_of_triangles, const int number_of_edges)
  {
    const int n = static_cast<int>(plc.points.size());
    const Brute_force_input input(plc);
    for(int i = 0; i < number_of_triangles + number_of_edges; ++i)
    {
      Simplex s;
      for(int j = 0; j < (i < number_of_triangles ? 3 : 2); ++j)
        s.push_back(static_cast<std::size_t>(next(n)));
      if(! input.is_degenerate(s) && is_free(plc, input, s))
        (s.size() == 3 ? plc.triangles : plc.edges).push_back(s);
    }
  }

private:
  double next(const int n) { return static_cast<double>(m_random() % static_cast<unsigned>(n)); }

  static void add_point(Plc& plc, const Coordinates& p)
  {
    if(std::find(plc.points.begin(), plc.points.end(), p) == plc.points.end())
      plc.points.push_back(p);
  }

  static bool is_free(const Plc& plc, const Brute_force_input& input, const Simplex& s)
  {
    for(std::size_t v = 0; v < plc.points.size(); ++v)
      if(std::find(s.begin(), s.end(), v) == s.end() && input.do_intersect({ v }, s))
        return false;
    for(const auto* others : { &plc.triangles, &plc.edges })
      for(const Simplex& t : *others)
        if(is_same(s, t) || input.do_intersect(s, t))
          return false;
    return true;
  }

  static bool is_same(Simplex s, Simplex t)
  {
    std::sort(s.begin(), s.end());
    std::sort(t.begin(), t.end());
    return s == t;
  }

  std::mt19937 m_random; // the same numbers everywhere
};

// A box, both diagonals of each side one of which is prescribed by a bit; its facets or only its edges.
inline Plc box(const unsigned diagonals, const bool has_facets)
{
  static const std::size_t sides[6][4] = { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
                                           { 0, 2, 6, 4 }, { 1, 3, 7, 5 } };
  Plc plc;
  for(int i = 0; i < 8; ++i)
    plc.points.push_back({{ static_cast<double>(i & 1), static_cast<double>((i >> 1) & 1),
                            static_cast<double>(i >> 2) }});
  for(int i = 0; i < 6; ++i)
  {
    const std::size_t d = (diagonals >> i) & 1;
    const std::size_t p = sides[i][d], q = sides[i][d + 1], r = sides[i][d + 2], s = sides[i][(d + 3) % 4];
    if(has_facets)
    {
      plc.triangles.push_back({ p, q, r });
      plc.triangles.push_back({ p, r, s });
    }
    else
      plc.edges.push_back({ p, r });
  }
  return plc;
}

// Random constraints in the plane z = 0, which is a flat part of the hull, and a few points above.
inline Plc flat_hull(const unsigned seed, const int number_of_points)
{
  std::mt19937 random(seed);
  Plc plc;
  while(static_cast<int>(plc.points.size()) < number_of_points)
  {
    const bool is_above = plc.points.size() % 4 == 3;
    const Coordinates p = {{ static_cast<double>(random() % 16), static_cast<double>(random() % 16),
                             is_above ? static_cast<double>(1 + random() % 9) : 0. }};
    if(std::find(plc.points.begin(), plc.points.end(), p) == plc.points.end())
      plc.points.push_back(p);
  }
  Random_constraints(seed + 1).add_constraints(plc, 60, 60);
  return plc;
}

} // namespace br3_test

#endif // BR3_TEST_STEINER_INPUTS_H
