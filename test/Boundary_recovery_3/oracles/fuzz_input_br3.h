// Turns any bytes into a small input of recover_boundary(): soups, sets of constraints that do not intersect, and
// closed surfaces, on small grids, so that every degeneracy occurs, or next to one.

#ifndef BR3_TEST_FUZZ_INPUT_H
#define BR3_TEST_FUZZ_INPUT_H

#include "brute_force_input_br3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>

namespace br3_test {

struct Fuzz_case
{
  Plc plc;
  bool are_points_inserted_before = false; // by the caller
  bool is_list_of_defects_wanted = false;
};

// Reads bytes; zeros follow the last one.
class Fuzz_decoder
{
public:
  Fuzz_decoder(const std::uint8_t* data, const std::size_t size) : m_data(data), m_size(size) { }

  Fuzz_case operator()()
  {
    Fuzz_case result;
    const int settings = next(256);
    const int positions = settings / 8 % 4, circumstances = settings / 32;
    switch(settings % 8)
    {
      case 0:  read_soup(); break;
      case 1:  case 2: read_points(); break;
      case 3:  case 4: case 5: read_prism(); break;
      default: read_star();
    }
    move(positions);
    if(settings % 8 == 1 || settings % 8 == 2)
      read_valid_constraints();
    result.are_points_inserted_before = circumstances % 2 == 1;
    result.is_list_of_defects_wanted = circumstances >= 6;
    if(circumstances == 2)
      read_earlier_points();
    result.plc = m_plc;
    return result;
  }

private:
  bool is_at_end() const { return m_position >= m_size; }
  int next(const int n) { return is_at_end() ? 0 : m_data[m_position++] % n; }

  Coordinates next_point(const int grid)
  {
    const double x = next(grid), y = next(grid), z = next(grid);
    return {{ x, y, z }};
  }

  // Anything, mostly wrong.
  void read_soup()
  {
    const int n = 4 + next(11), grid = 2 + next(7), facets = next(8), edges = next(4);
    for(int i = 0; i < n; ++i)
      m_plc.points.push_back(next_point(grid));
    const auto vertex = [&]() { return static_cast<std::size_t>(next(n)); };
    for(int i = 0; i < facets; ++i)
    {
      const std::size_t u = vertex(), v = vertex(), w = vertex();
      m_plc.triangles.push_back({ u, v, w });
    }
    for(int i = 0; i < edges; ++i)
    {
      const std::size_t u = vertex(), v = vertex();
      m_plc.edges.push_back({ u, v });
    }
  }

  void add_point(const Coordinates& p)
  {
    if(std::find(m_plc.points.begin(), m_plc.points.end(), p) == m_plc.points.end())
      m_plc.points.push_back(p);
  }

  void read_points()
  {
    const int n = 5 + next(10), grid = 2 + next(7);
    for(int i = 0; i < n; ++i)
      add_point(next_point(grid));
  }

  // Triangles and edges as long as there are bytes, those that intersect nothing that is there.
  void read_valid_constraints()
  {
    const Brute_force_input input(m_plc);
    const std::size_t n = m_plc.points.size();
    for(int k = 0; k < 100 && ! is_at_end(); ++k)
    {
      const int low = next(256);
      std::size_t code = static_cast<std::size_t>(low + 256 * next(256));
      Simplex s;
      for(int i = 0; i < 3; ++i, code /= n)
        if(std::find(s.begin(), s.end(), code % n) == s.end())
          s.push_back(code % n);
      if(s.size() > 1 && ! input.is_degenerate(s) && is_free(s, input))
        (s.size() == 3 ? m_plc.triangles : m_plc.edges).push_back(s);
    }
  }

  bool is_free(const Simplex& s, const Brute_force_input& input) const
  {
    for(const auto* simplices : { &m_plc.triangles, &m_plc.edges })
      for(const Simplex& t : *simplices)
        if((s.size() == t.size() && std::is_permutation(s.begin(), s.end(), t.begin())) || input.do_intersect(s, t))
          return false;
    for(std::size_t v = 0; v < m_plc.points.size(); ++v)
      if(input.do_intersect({ v }, s))
        return false;
    return true;
  }

  // Rings of points, each turned against the one below, with a diagonal in every quadrangle: the Schoenhardt polyhedron
  // and the like, with more sides, more storeys, and dents.
  void read_prism()
  {
    const int sides = 3 + next(4), storeys = 1 + next(2), turn = next(16), disorder = next(3), dents = next(2);
    const std::size_t n = static_cast<std::size_t>(sides);
    for(int k = 0; k <= storeys; ++k)
      for(int i = 0; i < sides; ++i)
      {
        const double angle = 6.283185307179586 * (i / double(sides) + k * turn / (16. * sides));
        const double radius = dents ? 16 + 2 * next(8) : 24;
        const double x = std::round(radius * std::cos(angle)), y = std::round(radius * std::sin(angle));
        const double z = 20 * k;
        m_plc.points.push_back({{ x + shift(disorder), y + shift(disorder), z + shift(disorder) }});
      }
    const int diagonals = next(4); // all the one way, all the other way, or mixed
    for(int k = 0; k < storeys; ++k)
      for(std::size_t i = 0; i < n; ++i)
      {
        const std::size_t a = k * n + i, b = k * n + (i + 1) % n, c = b + n, d = a + n;
        if(diagonals == 0 || (diagonals > 1 && next(2) == 0))
          m_plc.triangles.insert(m_plc.triangles.end(), { { a, b, c }, { a, c, d } });
        else
          m_plc.triangles.insert(m_plc.triangles.end(), { { a, b, d }, { b, c, d } });
      }
    for(const std::size_t first : { std::size_t(0), storeys * n })
      for(std::size_t i = 1; i + 1 < n; ++i)
        m_plc.triangles.push_back({ first, first + i, first + i + 1 });
    drop_triangles();
  }

  double shift(const int disorder) { return disorder == 0 ? 0 : (next(2 * disorder + 1) + disorder) % 5 - disorder; }

  // A cube with a pyramid on each side, with the corners at any distance from the centre: always valid.
  void read_star()
  {
    const int extras = next(4);
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
          if(std::abs(x) + std::abs(y) + std::abs(z) == 1 || x * y * z != 0)
          {
            const double r = 1 + next(12);
            m_plc.points.push_back({{ r * x, r * y, r * z }});
          }
    const std::vector<Coordinates> p = m_plc.points;
    for(std::size_t apex = 0; apex < p.size(); ++apex)
      for(std::size_t v = 0; v < p.size(); ++v)
        for(std::size_t w = 0; w < v; ++w)
          if(is_corner(p[v]) && is_corner(p[w]) && is_side(p[apex], p[v], p[w]))
            m_plc.triangles.push_back({ apex, v, w });
    drop_triangles();
    if(extras == 1)
      m_plc.points.push_back({{ 0, 0, 0 }});
    if(extras >= 2)
      add_point(next_point(6));
    if(extras == 3)
      m_plc.edges.push_back({ static_cast<std::size_t>(next(14)), m_plc.points.size() - 1 });
  }

  static bool is_corner(const Coordinates& p) { return p[0] != 0 && p[1] != 0 && p[2] != 0; }

  // Whether v and w are neighbours around the side of the cube that has the apex.
  static bool is_side(const Coordinates& apex, const Coordinates& v, const Coordinates& w)
  {
    int equal = 0;
    for(int i = 0; i < 3; ++i)
    {
      equal += v[i] * w[i] > 0;
      if(apex[i] != 0 && (apex[i] * v[i] < 0 || apex[i] * w[i] < 0))
        return false;
    }
    return equal == 2 && ! is_corner(apex);
  }

  // Makes holes in one surface of four.
  void drop_triangles()
  {
    if(next(4) != 3)
      return;
    std::vector<Simplex> kept;
    for(const Simplex& t : m_plc.triangles)
      if(next(3) != 2)
        kept.push_back(t);
    m_plc.triangles = kept;
  }

  // 0, 1: stay on the grid. 2: tenths, which doubles round. 3: a few units in the last place away.
  void move(const int positions)
  {
    for(Coordinates& p : m_plc.points)
      for(double& x : p)
        if(positions == 2)
          x *= 0.1;
        else if(positions == 3)
          x += std::ldexp((next(5) + 2) % 5 - 2, -46);
  }

  void read_earlier_points()
  {
    const int n = 1 + next(3), grid = 2 + next(8);
    for(int i = 0; i < n; ++i)
      m_plc.earlier_points.push_back(next_point(grid));
  }

  const std::uint8_t* m_data;
  std::size_t m_size, m_position = 0;
  Plc m_plc;
};

// As C++ initializers, for a test.
inline std::ostream& operator<<(std::ostream& os, const Plc& plc)
{
  const auto write = [&](const char* name, const auto& rows)
  {
    os << name << ": {";
    for(std::size_t i = 0; i < rows.size(); ++i)
    {
      os << (i == 0 ? " " : ", ") << "{ ";
      for(std::size_t j = 0; j < rows[i].size(); ++j)
        os << (j == 0 ? "" : ", ") << rows[i][j];
      os << " }";
    }
    os << " }\n";
  };
  os.precision(17);
  write("points", plc.points);
  write("triangles", plc.triangles);
  write("edges", plc.edges);
  write("earlier points", plc.earlier_points);
  return os;
}

} // namespace br3_test

#endif // BR3_TEST_FUZZ_INPUT_H
