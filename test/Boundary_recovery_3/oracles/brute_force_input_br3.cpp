// What brute_force_input_br3.h promises.

#include "brute_force_input_br3.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <climits>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace br3_test {

namespace {

template <typename Integer>
using Points = std::vector<std::vector<Integer> >;

// The exponent of the last bit of x.
int least_exponent(const double x)
{
  int e;
  double m = std::frexp(x, &e);
  for(; m != std::floor(m); m *= 2)
    --e;
  return e;
}

template <typename Integer>
bool are_boxes_apart(const Simplex& s, const Simplex& t, const Points<Integer>& p)
{
  for(int i = 0; i < 3; ++i)
  {
    const auto less = [&](const std::size_t v, const std::size_t w) { return p[v][i] < p[w][i]; };
    const auto of_s = std::minmax_element(s.begin(), s.end(), less);
    const auto of_t = std::minmax_element(t.begin(), t.end(), less);
    if(less(*of_s.second, *of_t.first) || less(*of_t.second, *of_s.first))
      return true;
  }
  return false;
}

std::vector<Simplex> faces(const Simplex& s)
{
  std::vector<Simplex> result;
  for(unsigned mask = 1; mask < (1u << s.size()); ++mask)
  {
    result.emplace_back();
    for(std::size_t i = 0; i < s.size(); ++i)
      if(mask & (1u << i))
        result.back().push_back(s[i]);
  }
  return result;
}

// Whether sum x_i f_i = sum y_j g_j, sum x_i = sum y_j = 1 has exactly one solution, and that is positive: by
// elimination without fractions. After each step all the pivots are the same number.
template <typename Integer>
bool do_insides_meet_in_a_point(const Simplex& f, const Simplex& g, const Points<Integer>& p)
{
  const std::size_t n = f.size() + g.size();
  std::array<std::array<Integer, 6>, 5> a; // the last column is the right side
  for(std::size_t j = 0; j < n; ++j)
  {
    const bool is_f = j < f.size();
    const std::vector<Integer>& q = p[is_f ? f[j] : g[j - f.size()]];
    for(int i = 0; i < 3; ++i)
      a[i][j] = is_f ? q[i] : Integer(-q[i]);
    a[3][j] = is_f ? 1 : 0;
    a[4][j] = is_f ? 0 : 1;
  }
  for(int i = 0; i < 5; ++i)
    a[i][n] = i < 3 ? 0 : 1;

  Integer previous = 1;
  for(std::size_t c = 0; c < n; ++c)
  {
    std::size_t r = c;
    while(r < 5 && a[r][c] == 0)
      ++r;
    if(r == 5)
      return false; // none or many
    std::swap(a[r], a[c]);
    const Integer pivot = a[c][c];
    for(std::size_t i = 0; i < 5; ++i)
      if(i != c)
      {
        const Integer factor = a[i][c];
        for(std::size_t j = 0; j <= n; ++j)
          a[i][j] = Integer((pivot * a[i][j] - factor * a[c][j]) / previous);
      }
    previous = pivot;
  }
  for(std::size_t i = 0; i < 5; ++i)
    if(i < n ? (previous > 0 ? a[i][n] <= 0 : a[i][n] >= 0) : a[i][n] != 0)
      return false;
  return true;
}

template <typename Integer>
bool do_simplices_intersect(const Simplex& s, const Simplex& t, const Points<Integer>& p)
{
  if(are_boxes_apart(s, t, p))
    return false;
  for(const Simplex& f : faces(s))
    for(const Simplex& g : faces(t))
      if(f.size() + g.size() <= 5 && ! (f.size() == 1 && f == g) && do_insides_meet_in_a_point(f, g, p))
        return true;
  return false;
}

} // namespace

Brute_force_input::Brute_force_input(const Plc& plc) : m_plc(plc)
{
  std::vector<Coordinates> all = plc.points;
  all.insert(all.end(), plc.earlier_points.begin(), plc.earlier_points.end());
  int least = INT_MAX;
  for(const Coordinates& p : all)
    for(const double x : p)
      if(x != 0)
        least = (std::min)(least, least_exponent(x));
  m_is_small = true;
  for(const Coordinates& p : all)
  {
    m_big.emplace_back();
    m_small.emplace_back();
    for(int i = 0; i < 3; ++i)
      set_coordinate(p[i], least, i);
  }
}

bool Brute_force_input::do_intersect(const Simplex& s, const Simplex& t) const
{
  return m_is_small ? do_simplices_intersect(s, t, m_small) : do_simplices_intersect(s, t, m_big);
}

bool Brute_force_input::is_degenerate(Simplex s) const
{
  std::sort(s.begin(), s.end());
  if(std::adjacent_find(s.begin(), s.end()) != s.end() || m_big[s[0]] == m_big[s[1]])
    return true;
  return s.size() == 3 && is_collinear(s[0], s[1], s[2]);
}

bool Brute_force_input::are_all_coplanar() const
{
  const std::size_t n = m_big.size();
  for(std::size_t i = 1; i < n; ++i)
    if(m_big[i] != m_big[0])
      for(std::size_t j = i + 1; j < n; ++j)
        if(! is_collinear(0, i, j))
        {
          for(std::size_t k = j + 1; k < n; ++k)
            if(determinant(0, i, j, k) != 0)
              return false;
          return true;
        }
  return true;
}

bool Brute_force_input::has_simple_defect() const
{
  if(m_plc.triangles.empty() && m_plc.edges.empty())
    return true;
  std::set<Simplex> different;
  std::set<std::size_t> used;
  for(const std::vector<Simplex>* simplices : { &m_plc.triangles, &m_plc.edges })
    for(Simplex s : *simplices)
    {
      std::sort(s.begin(), s.end());
      if(is_degenerate(s) || (! different.insert(s).second && s.size() == 3))
        return true;
      used.insert(s.begin(), s.end());
    }
  std::set<std::vector<Big> > places;
  for(const std::size_t v : used)
    places.insert(m_big[v]);
  return places.size() < used.size() || are_all_coplanar();
}

std::set<Simplex> Brute_force_input::all_edges() const
{
  std::set<Simplex> result = edges_of_triangles();
  for(const Simplex& e : m_plc.edges)
    result.insert({ (std::min)(e[0], e[1]), (std::max)(e[0], e[1]) });
  return result;
}

std::set<std::set<Simplex> > Brute_force_input::intersecting_pairs() const
{
  const std::set<Simplex> covered = edges_of_triangles();
  std::vector<Simplex> constraints;
  for(Simplex t : m_plc.triangles)
  {
    std::sort(t.begin(), t.end());
    constraints.push_back(t);
  }
  for(const Simplex& e : all_edges())
    if(covered.count(e) == 0)
      constraints.push_back(e);
  std::set<std::set<Simplex> > result;
  for(std::size_t i = 0; i < constraints.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(do_intersect(constraints[i], constraints[j]))
        result.insert({ constraints[i], constraints[j] });
  return result;
}

std::set<std::set<Simplex> > Brute_force_input::vertices_on_constraints() const
{
  std::set<std::set<Simplex> > result;
  const std::set<Simplex> edges = all_edges();
  std::vector<Simplex> constraints(edges.begin(), edges.end());
  for(Simplex t : m_plc.triangles)
  {
    std::sort(t.begin(), t.end());
    constraints.push_back(t);
  }
  for(std::size_t v = 0; v < m_big.size(); ++v)
    if(std::find(m_big.begin(), m_big.end(), m_big[v]) == m_big.begin() + v)
      for(const Simplex& s : constraints)
      {
        const bool is_corner = std::any_of(s.begin(), s.end(), [&](std::size_t w) { return m_big[w] == m_big[v]; });
        if(! is_corner && do_intersect({ v }, s))
          result.insert({ { v }, s });
      }
  return result;
}

void Brute_force_input::set_coordinate(const double x, const int least, const int i)
{
  int e = 0;
  const double m = x == 0 ? 0 : std::frexp(x, &e);
  const Big integer(std::ldexp(m, 53)); // an integer
  const int shift = x == 0 ? 0 : e - 53 - least;
  m_big.back().push_back(shift >= 0 ? Big(integer << shift) : Big(integer / (Big(1) << -shift)));
  const bool fits = abs(m_big.back().back()) < (1 << 18); // then products of two determinants fit, too
  m_small.back().push_back(fits ? Small(m_big.back().back()) : Small(0));
  m_is_small = m_is_small && fits;
  assert(i + 1 == static_cast<int>(m_big.back().size()));
  static_cast<void>(i); // with NDEBUG
}

Brute_force_input::Big Brute_force_input::determinant(const std::size_t o, const std::size_t p, const std::size_t q,
                                                      const std::size_t r) const
{
  std::array<std::array<Big, 3>, 3> d;
  const std::size_t v[3] = { p, q, r };
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      d[i][j] = m_big[v[i]][j] - m_big[o][j];
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0])
       + d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

bool Brute_force_input::is_collinear(const std::size_t o, const std::size_t p, const std::size_t q) const
{
  for(int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    if((m_big[p][i] - m_big[o][i]) * (m_big[q][j] - m_big[o][j])
       != (m_big[p][j] - m_big[o][j]) * (m_big[q][i] - m_big[o][i]))
      return false;
  }
  return true;
}

std::set<Simplex> Brute_force_input::edges_of_triangles() const
{
  std::set<Simplex> result;
  for(const Simplex& t : m_plc.triangles)
    for(int i = 0; i < 3; ++i)
      result.insert({ (std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3]) });
  return result;
}

} // namespace br3_test
