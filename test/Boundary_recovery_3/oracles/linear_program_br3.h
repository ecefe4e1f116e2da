// The intersections of constraints by definition: O(n^2) and no geometry but a linear program in integers.

#ifndef BR3_TEST_LINEAR_PROGRAM_H
#define BR3_TEST_LINEAR_PROGRAM_H

#include "diagnosed_soup_br3.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace br3_test {

typedef long long               Integer;
typedef std::array<Integer, 3>  Grid_point;
typedef std::vector<Grid_point> Grid_simplex;

// Solves the system of 5 equations `sum x_j columns[j] = rhs` by fraction-free elimination. Returns false if the
// columns are dependent or there is no solution, else the solution as `x[j] / denominator`, positive denominator.
inline bool solve(const std::vector<std::array<Integer, 5> >& columns, const std::array<Integer, 5>& rhs,
           std::vector<Integer>& x, Integer& denominator)
{
  const std::size_t n = columns.size();
  std::array<std::vector<Integer>, 5> m;
  for(std::size_t i = 0; i < 5; ++i)
  {
    for(const auto& column : columns)
      m[i].push_back(column[i]);
    m[i].push_back(rhs[i]);
  }

  Integer previous = 1;
  for(std::size_t k = 0; k < n; ++k)
  {
    std::size_t pivot = k;
    while(pivot < 5 && m[pivot][k] == 0)
      ++pivot;
    if(pivot == 5)
      return false;
    std::swap(m[k], m[pivot]);
    for(std::size_t i = 0; i < 5; ++i)
      if(i != k)
      {
        const Integer factor = m[i][k];
        for(std::size_t j = 0; j <= n; ++j)
        {
          const Integer minor = m[k][k] * m[i][j] - factor * m[k][j];
          assert(minor % previous == 0);
          m[i][j] = minor / previous;
        }
      }
    previous = m[k][k];
  }
  for(std::size_t i = n; i < 5; ++i)
    if(m[i][n] != 0)
      return false;

  const Integer sign = previous < 0 ? -1 : 1;
  denominator = sign * previous;
  x.resize(n);
  for(std::size_t k = 0; k < n; ++k)
    x[k] = sign * m[k][n];
  return true;
}

// Is there a common point of the simplices with a positive barycentric coordinate at a vertex of s that is none of t?
// Such a point is a feasible point of the linear program "sum l_i s_i = sum m_j t_j, sum l = sum m = 1, l, m >= 0".
// If there is one, one of the corners of that polytope is one; the corners are the nonnegative basic solutions.
inline bool intersect_by_linear_program(const Grid_simplex& s, const Grid_simplex& t)
{
  const std::size_t n = s.size() + t.size();
  std::array<Integer, 5> rhs = {{0, 0, 0, 1, 1}};
  for(unsigned subset = 1; subset < (1u << n); ++subset)
  {
    std::vector<std::array<Integer, 5> > columns;
    std::vector<bool> counts;
    for(std::size_t i = 0; i < n; ++i)
      if((subset >> i) & 1u)
      {
        const bool in_s = i < s.size();
        const Grid_point& p = in_s ? s[i] : t[i - s.size()];
        const Integer sign = in_s ? 1 : -1;
        columns.push_back({{ sign * p[0], sign * p[1], sign * p[2], in_s, ! in_s }});
        counts.push_back(in_s && std::find(t.begin(), t.end(), p) == t.end());
      }
    std::vector<Integer> x;
    Integer denominator;
    if(columns.size() > 5 || ! solve(columns, rhs, x, denominator) || *std::min_element(x.begin(), x.end()) < 0)
      continue;
    for(std::size_t i = 0; i < x.size(); ++i)
      if(counts[i] && x[i] > 0)
        return true;
  }
  return false;
}

struct Grid_constraint
{
  std::string name;
  Grid_simplex points;               // sorted
  std::vector<std::size_t> vertices; // sorted
};

inline bool is_degenerate(const Grid_simplex& s)
{
  if(s.size() == 2)
    return s[0] == s[1];
  Integer u[3], v[3];
  for(int i = 0; i < 3; ++i)
  {
    u[i] = s[1][i] - s[0][i];
    v[i] = s[2][i] - s[0][i];
  }
  return u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2];
}

template <typename Vertices>
Grid_constraint grid_constraint(const char letter, const std::size_t index, const Vertices& vertices,
                                const std::vector<Grid_point>& points)
{
  Grid_constraint result = { letter + std::to_string(index), {}, { vertices.begin(), vertices.end() } };
  for(const std::size_t v : vertices)
    result.points.push_back(points[v]);
  std::sort(result.points.begin(), result.points.end());
  std::sort(result.vertices.begin(), result.vertices.end());
  return result;
}

// All pairs that intersect, as "e0 f1".
inline Strings intersections_by_linear_program(const Soup& soup, const std::vector<Grid_point>& points)
{
  std::vector<Grid_constraint> facets, constraints;
  for(std::size_t i = 0; i < soup.facets.size(); ++i)
    facets.push_back(grid_constraint('f', i, soup.facets[i], points));
  facets.erase(std::remove_if(facets.begin(), facets.end(),
                              [](const Grid_constraint& c) { return is_degenerate(c.points); }), facets.end());

  for(std::size_t i = 0; i < soup.edges.size(); ++i)
  {
    const Grid_constraint e = grid_constraint('e', i, soup.edges[i], points);
    const auto contains = [&](const Grid_constraint& c)
      { return std::includes(c.points.begin(), c.points.end(), e.points.begin(), e.points.end()); };
    if(! is_degenerate(e.points) && std::none_of(facets.begin(), facets.end(), contains) &&
       std::none_of(constraints.begin(), constraints.end(), contains))
      constraints.push_back(e);
  }
  constraints.insert(constraints.end(), facets.begin(), facets.end());

  Strings result;
  for(std::size_t i = 0; i < constraints.size(); ++i)
    for(std::size_t j = i + 1; j < constraints.size(); ++j)
    {
      const Grid_constraint& a = constraints[i];
      const Grid_constraint& b = constraints[j];
      // Equal point sets have a trivial program: no vertex is left to be positive at.
      if(a.points == b.points ? a.vertices != b.vertices : intersect_by_linear_program(a.points, b.points))
        result.push_back(a.name + ' ' + b.name);
    }
  return result;
}

} // namespace br3_test

#endif // BR3_TEST_LINEAR_PROGRAM_H
