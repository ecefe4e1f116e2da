// A naive judge of what remesh_holes() returns. It knows the old mesh and the new one, and nothing of the package.

#ifndef BR3_TEST_HOLE_JUDGE_H
#define BR3_TEST_HOLE_JUDGE_H

#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace br3_test {

// Each check tells what is wrong, if something is.
template <typename Kernel, typename Result>
class Hole_judge
{
public:
  typedef typename Kernel::Point_3   Point;
  typedef std::array<std::size_t, 4> Tetrahedron;
  typedef std::array<std::size_t, 3> Facet;
  typedef std::array<std::size_t, 2> Edge;
  typedef CGAL::Exact_rational       Rational;

  Hole_judge(const std::vector<Point>& points, const std::vector<Tetrahedron>& tetrahedra,
             const std::vector<int>& regions, const std::vector<Facet>& facets, const std::vector<Edge>& edges,
             const Result& result)
    : m_points(points), m_tetrahedra(tetrahedra), m_regions(regions), m_facets(facets), m_edges(edges), m_new(result)
  { }

  // The first thing that is wrong; empty if nothing is.
  std::string verdict()
  {
    for(const auto check : { &Hole_judge::check_vertices, &Hole_judge::check_cells, &Hole_judge::check_facets,
                             &Hole_judge::check_constraints, &Hole_judge::check_volumes, &Hole_judge::check_locations })
    {
      const std::string complaint = (this->*check)();
      if(! complaint.empty())
        return complaint;
    }
    return "";
  }

private:
  typedef std::array<Rational, 3> Exact_point;

  static Rational exact(const double x) { return Rational(x); }

  template <typename FT>
  static Rational exact(const FT& x) { return Rational(CGAL::exact(x)); }

  static Exact_point exact_point(const Point& p) { return {{ exact(p.x()), exact(p.y()), exact(p.z()) }}; }

  static Rational volume(const std::array<Exact_point, 4>& p)
  {
    std::array<Exact_point, 3> d;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        d[i][j] = p[i + 1][j] - p[0][j];
    return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  }

  static std::array<Exact_point, 4> corners(const std::vector<Point>& points, const Tetrahedron& t)
  {
    return {{ exact_point(points[t[0]]), exact_point(points[t[1]]), exact_point(points[t[2]]),
              exact_point(points[t[3]]) }};
  }

  std::size_t old_vertex(const std::size_t v) const { return m_new.old_vertices[v]; }

  template <typename Simplex>
  Simplex old_simplex(Simplex simplex) const
  {
    for(std::size_t& v : simplex)
      v = old_vertex(v);
    return simplex;
  }

  std::string check_vertices()
  {
    const std::size_t n = m_new.number_of_kept_vertices;
    if(m_new.old_vertices.size() != m_new.points.size() || m_new.locations.size() != m_new.points.size() - n)
      return "numbers of vertices";
    for(std::size_t v = 0; v < m_new.points.size(); ++v)
    {
      if((v < n) != (old_vertex(v) != m_new.no_index))
        return "a new vertex among old ones";
      if(v > 0 && v < n && old_vertex(v - 1) >= old_vertex(v))
        return "the order of vertices";
      if(v < n && m_new.points[v] != m_points[old_vertex(v)])
        return "a vertex has moved";
    }
    std::set<std::size_t> used, used_before;
    for(const Tetrahedron& t : m_new.tetrahedra)
      used.insert(t.begin(), t.end());
    for(const Tetrahedron& t : m_tetrahedra)
      used_before.insert(t.begin(), t.end());
    for(std::size_t v = 0; v < m_new.points.size(); ++v)
      if(used.count(v) == 0 && (v >= n || used_before.count(old_vertex(v)) > 0))
        return "a vertex without cells";
    std::set<std::size_t> there(m_new.old_vertices.begin(), m_new.old_vertices.begin() + std::ptrdiff_t(n));
    for(std::size_t v = 0; v < m_points.size(); ++v)
      if(used_before.count(v) == 0 && there.count(v) == 0)
        return "a vertex without cells is gone";
    return "";
  }

  std::string check_cells()
  {
    const std::size_t n = m_new.number_of_kept_cells;
    if(m_new.old_cells.size() != m_new.tetrahedra.size() || m_new.regions.size() != m_new.tetrahedra.size())
      return "numbers of cells";
    for(std::size_t c = 0; c < m_new.tetrahedra.size(); ++c)
    {
      const std::size_t old = m_new.old_cells[c];
      if((c < n) != (old != m_new.no_index))
        return "a new cell among old ones";
      if(c > 0 && c < n && m_new.old_cells[c - 1] >= old)
        return "the order of cells";
      if(c < n && (old_simplex(m_new.tetrahedra[c]) != m_tetrahedra[old] || m_new.regions[c] != m_regions[old]))
        return "a cell that stayed is another one";
      if(! (volume(corners(m_new.points, m_new.tetrahedra[c])) > 0))
        return "a cell is flat or inverted";
    }
    return "";
  }

  // The two sides of a facet: the regions of the cells that are on the sides where the order of the vertices is even,
  // and odd; -1: nothing.
  typedef std::map<Facet, std::array<int, 2> > Sides;

  static std::string collect(const std::vector<Tetrahedron>& tetrahedra, const std::vector<int>& regions, Sides& sides)
  {
    static constexpr std::size_t order[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };
    for(std::size_t c = 0; c < tetrahedra.size(); ++c)
      for(const auto& o : order)
      {
        const Facet f = {{ tetrahedra[c][o[0]], tetrahedra[c][o[1]], tetrahedra[c][o[2]] }};
        Facet sorted = f;
        std::sort(sorted.begin(), sorted.end());
        const bool is_odd = ! ((f[0] < f[1]) ^ (f[1] < f[2]) ^ (f[2] < f[0]) ^ true);
        auto& side = sides.insert({ sorted, {{ -1, -1 }} }).first->second[is_odd ? 1 : 0];
        if(side != -1)
          return "two cells on one side of a facet";
        side = regions[c];
      }
    return "";
  }

  // The facets on the boundary, and between regions, are the old ones, with the old regions.
  std::string check_facets()
  {
    Sides before;
    collect(m_tetrahedra, m_regions, before);
    const std::string complaint = collect(m_new.tetrahedra, m_new.regions, m_sides);
    if(! complaint.empty())
      return complaint;
    std::size_t number = 0, number_before = 0;
    for(const auto& f : before)
      number_before += f.second[0] != f.second[1] ? 1 : 0;
    for(const auto& f : m_sides)
      if(f.second[0] != f.second[1])
      {
        ++number;
        const auto it = before.find(old_simplex(f.first)); // old vertices are in order
        if(it == before.end() || it->second != f.second)
          return "a facet between regions that was not there";
      }
    return number == number_before ? "" : "a facet between regions is gone";
  }

  std::string check_constraints()
  {
    if(m_new.facets.size() != m_facets.size() || m_new.edges.size() != m_edges.size())
      return "numbers of constraints";
    std::set<Edge> edges;
    for(const Tetrahedron& t : m_new.tetrahedra)
      for(std::size_t i = 0; i < 4; ++i)
        for(std::size_t j = 0; j < 4; ++j)
          edges.insert({{ t[i], t[j] }});
    for(std::size_t f = 0; f < m_facets.size(); ++f)
    {
      Facet sorted = m_new.facets[f];
      std::sort(sorted.begin(), sorted.end());
      if(old_simplex(m_new.facets[f]) != m_facets[f] || m_sides.count(sorted) == 0)
        return "a constrained facet is gone";
    }
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      if(old_simplex(m_new.edges[e]) != m_edges[e] || edges.count(m_new.edges[e]) == 0)
        return "a constrained edge is gone";
    return "";
  }

  static std::map<int, Rational> volumes(const std::vector<Point>& points, const std::vector<Tetrahedron>& tetrahedra,
                                         const std::vector<int>& regions)
  {
    std::map<int, Rational> result;
    for(std::size_t c = 0; c < tetrahedra.size(); ++c)
      result[regions[c]] += volume(corners(points, tetrahedra[c]));
    return result;
  }

  // With all signs, that of a region depends on its boundary only.
  std::string check_volumes()
  {
    const bool is_same = volumes(m_points, m_tetrahedra, m_regions) ==
                         volumes(m_new.points, m_new.tetrahedra, m_new.regions);
    return is_same ? "" : "the volume of a region";
  }

  std::string check_locations()
  {
    std::map<std::size_t, std::set<int> > regions; // of new vertices
    for(std::size_t c = m_new.number_of_kept_cells; c < m_new.tetrahedra.size(); ++c)
      for(const std::size_t v : m_new.tetrahedra[c])
        if(v >= m_new.number_of_kept_vertices)
          regions[v].insert(m_new.regions[c]);
    const std::set<std::size_t> kept(m_new.old_cells.begin(), m_new.old_cells.end());
    for(std::size_t v = m_new.number_of_kept_vertices; v < m_new.points.size(); ++v)
    {
      const auto& location = m_new.locations[v - m_new.number_of_kept_vertices];
      if(location.cell >= m_tetrahedra.size() || kept.count(location.cell) > 0)
        return "a location that is no old cell of a hole";
      if(regions[v].size() != 1 || *regions[v].begin() != m_regions[location.cell])
        return "a location in another region";
      const std::string complaint = check_location(m_new.points[v], location);
      if(! complaint.empty())
        return complaint;
    }
    return "";
  }

  template <typename Location>
  std::string check_location(const Point& p, const Location& location) const
  {
    const Tetrahedron& t = m_tetrahedra[location.cell];
    const std::array<Exact_point, 4> q = corners(m_points, t);
    const Rational whole = volume(q);
    if(! (whole > 0))
      return "a location in an inverted cell";
    double sum = 0;
    for(std::size_t i = 0; i < 4; ++i)
    {
      std::array<Exact_point, 4> part = q;
      part[i] = exact_point(p);
      const Rational weight = volume(part) / whole;
      if(weight < 0)
        return "a location in a cell that the place is outside of";
      if(! (location.coordinates[i] >= 0) || std::abs(CGAL::to_double(weight) - location.coordinates[i]) > 1e-9)
        return "barycentric coordinates";
      sum += location.coordinates[i];
    }
    return std::abs(sum - 1) < 1e-12 ? "" : "the sum of barycentric coordinates";
  }

  const std::vector<Point>& m_points;
  const std::vector<Tetrahedron>& m_tetrahedra;
  const std::vector<int>& m_regions;
  const std::vector<Facet>& m_facets;
  const std::vector<Edge>& m_edges;
  const Result& m_new;
  Sides m_sides; // of the facets of the new mesh
};

} // namespace br3_test

#endif // BR3_TEST_HOLE_JUDGE_H
