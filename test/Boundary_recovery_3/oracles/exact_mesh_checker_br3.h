// Judges the result of recover_boundary() on surfaces of many triangles, from the definition and exactly: rational
// numbers decide wherever double precision is not beyond doubt. Nothing of the library and no predicate of CGAL is
// asked. brute_force_checker_br3.h judges more, but in quadratic time. A fault is thrown as a Complaint.

#ifndef BR3_TEST_EXACT_MESH_CHECKER_H
#define BR3_TEST_EXACT_MESH_CHECKER_H

#include "brute_force_checker_br3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace br3_test {

// A mesh and the surface that it has to contain, as plain numbers. The first `number_of_inputs` points are those of the
// surface, all others are Steiner points.
struct Indexed_mesh
{
  typedef std::array<std::size_t, 3> Facet;
  typedef std::array<std::size_t, 4> Cell;

  std::vector<Coordinates> points;             // rounded where they are in `exact_points`
  std::map<std::size_t, Rational_point> exact_points; // those that doubles cannot represent
  std::size_t number_of_inputs = 0;
  std::vector<Cell> cells;                     // the finite ones
  std::vector<Facet> surface;
  std::set<std::size_t> missing;               // triangles of the surface that are said to be missing
  std::map<std::size_t, std::vector<Facet> > parts; // of triangles that are said to be split
};

class Exact_mesh_checker
{
public:
  typedef Indexed_mesh::Facet        Facet;
  typedef Indexed_mesh::Cell         Cell;
  typedef std::array<std::size_t, 2> Edge;

  // What may be on constraints: nothing; Steiner points at exact positions; rounded ones, which are beside them.
  enum Kind { constrained, conforming, conforming_rounded };

  Exact_mesh_checker(const Indexed_mesh& mesh, const Kind kind) : m_mesh(mesh), m_kind(kind) { }

  void operator()()
  {
    check_cells();
    check_hull();
    if(m_kind == conforming_rounded)
      check_parts();
    else
      check_constraints();
  }

  // With rounded points: the largest distance of one from the plane of its triangle.
  double deviation() const { return m_deviation; }

private:
  struct Side // one side of a mesh facet
  {
    Facet facet;      // sorted
    bool is_odd;      // whether the sorted order is an odd permutation of the one that is seen from outside of the cell
    bool operator<(const Side& s) const { return facet != s.facet ? facet < s.facet : is_odd < s.is_odd; }
  };

  Rational_point exact(const std::size_t v) const
  {
    const auto it = m_mesh.exact_points.find(v);
    return it != m_mesh.exact_points.end() ? it->second : to_rational(m_mesh.points[v]);
  }

  // The sign of the volume. The determinant of doubles decides if it exceeds the bound of its rounding error
  // (J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997) and nothing underflows.
  int orientation(const std::size_t p, const std::size_t q, const std::size_t r, const std::size_t s) const
  {
    if(m_mesh.exact_points.empty() || (is_double(p) && is_double(q) && is_double(r) && is_double(s)))
    {
      double a[3][3], det = 0, permanent = 0;
      const std::size_t others[] = { q, r, s };
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          a[i][j] = m_mesh.points[others[i]][j] - m_mesh.points[p][j];
      for(int i = 0; i < 3; ++i)
      {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double m = a[1][j] * a[2][k], n = a[1][k] * a[2][j];
        det += a[0][i] * (m - n);
        permanent += (std::abs(m) + std::abs(n)) * std::abs(a[0][i]);
      }
      if(std::abs(det) > 1e-15 * permanent && permanent > 1e-200 && permanent < 1e200)
        return det > 0 ? 1 : -1;
    }
    const Rational v = volume(exact(p), exact(q), exact(r), exact(s));
    return v > 0 ? 1 : v < 0 ? -1 : 0;
  }

  bool is_double(const std::size_t v) const { return m_mesh.exact_points.count(v) == 0; }

  // Sorts and tells whether the permutation was odd.
  template <typename Simplex>
  static bool sort(Simplex& s)
  {
    bool is_odd = false;
    for(std::size_t i = 1; i < s.size(); ++i)
      for(std::size_t j = i; j > 0 && s[j] < s[j - 1]; --j, is_odd = ! is_odd)
        std::swap(s[j], s[j - 1]);
    return is_odd;
  }

  // Every cell is positive, and cells that share a facet are on different sides of it.
  void check_cells()
  {
    std::vector<Side> sides;
    sides.reserve(4 * m_mesh.cells.size());
    std::vector<bool> is_used(m_mesh.points.size(), false);
    for(const Cell& c : m_mesh.cells)
    {
      require(orientation(c[0], c[1], c[2], c[3]) > 0, "a cell is flat or inverted");
      static constexpr int outwards[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
      for(const auto& f : outwards)
      {
        Side side = { {{ c[f[0]], c[f[1]], c[f[2]] }}, false };
        side.is_odd = sort(side.facet);
        sides.push_back(side);
      }
      for(const std::size_t v : c)
        is_used[v] = true;
    }
    require(std::find(is_used.begin(), is_used.end(), false) == is_used.end(), "a point is not in the mesh");
    std::sort(sides.begin(), sides.end());
    for(std::size_t i = 0, j; i < sides.size(); i = j)
    {
      for(j = i + 1; j < sides.size() && sides[j].facet == sides[i].facet; ++j)
        require(sides[j].is_odd != sides[j - 1].is_odd, "two cells are on the same side of a facet");
      require(j - i <= 2, "a facet has more than two cells");
      m_facets.push_back(sides[i].facet);
      if(j - i == 1)
        m_hull.push_back(sides[i].is_odd ? Facet{{ sides[i].facet[0], sides[i].facet[2], sides[i].facet[1] }}
                                         : sides[i].facet);
    }
  }

  // The facets with one cell make up a closed surface without reflex edges, of the volume of the convex hull of the
  // input points; so the cells, which are positive, tile that hull.
  void check_hull() const
  {
    std::vector<std::pair<Edge, std::size_t> > edges; // directed, with the third vertex of the facet
    for(const Facet& f : m_hull)
      for(int i = 0; i < 3; ++i)
        edges.push_back({ {{ f[i], f[(i + 1) % 3] }}, f[(i + 2) % 3] });
    std::sort(edges.begin(), edges.end());
    for(std::size_t i = 0; i < edges.size(); ++i)
    {
      const auto& e = edges[i];
      require(i == 0 || edges[i - 1].first != e.first, "the hull is no surface");
      const std::pair<Edge, std::size_t> reverse = { {{ e.first[1], e.first[0] }}, 0 };
      const auto it = std::lower_bound(edges.begin(), edges.end(), reverse);
      require(it != edges.end() && it->first == reverse.first, "the hull is not closed");
      if(m_kind != conforming_rounded) // where points of the hull have moved
        require(orientation(e.first[0], e.first[1], e.second, it->second) <= 0, "the hull is not convex");
    }
    if(m_kind != conforming_rounded)
      require(six_volumes_of_hull() == six_volumes_of_convex_hull(), "the cells do not fill the convex hull");
  }

  Rational six_volumes_of_hull() const
  {
    Rational sum = 0;
    for(const Facet& f : m_hull)
      sum += determinant(exact(f[0]), exact(f[1]), exact(f[2]));
    return sum;
  }

  // by a Delaunay triangulation that never saw a flip
  Rational six_volumes_of_convex_hull() const
  {
    typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
    std::vector<K::Point_3> points;
    for(std::size_t i = 0; i < m_mesh.number_of_inputs; ++i)
      points.push_back(K::Point_3(m_mesh.points[i][0], m_mesh.points[i][1], m_mesh.points[i][2]));
    const CGAL::Delaunay_triangulation_3<K> delaunay(points.begin(), points.end());
    Rational sum = 0;
    for(const auto c : delaunay.all_cell_handles())
      if(delaunay.is_infinite(c))
      {
        const int k = c->index(delaunay.infinite_vertex());
        Rational_point p[3]; // counterclockwise as seen from the infinite vertex, as the cell is positive
        for(int i = 0; i < 3; ++i)
          p[i] = to_rational(c->vertex(CGAL::Triangulation_utils_3::vertex_triple_index(k, i))->point());
        sum += determinant(p[0], p[1], p[2]);
      }
    return sum;
  }

  static Rational determinant(const Rational_point& p, const Rational_point& q, const Rational_point& r)
  {
    return dot(cross(p, q), r);
  }

  bool is_mesh_facet(Facet f) const
  {
    sort(f);
    return std::binary_search(m_facets.begin(), m_facets.end(), f);
  }

  // Every triangle is a mesh facet and nothing is on it, or (conforming) mesh facets fill it, unless it is listed.
  void check_constraints() const
  {
    const std::vector<std::vector<std::size_t> > points_on = steiner_points_on_triangles();
    const std::vector<std::vector<Facet> > stars = stars_of_steiner_points();
    for(std::size_t i = 0; i < m_mesh.surface.size(); ++i)
    {
      const Facet& f = m_mesh.surface[i];
      require(m_kind == conforming || points_on[i].empty(), "a Steiner point is on a constraint");
      const bool is_there = points_on[i].empty() ? is_mesh_facet(f) : is_filled(f, points_on[i], stars);
      const bool is_listed = m_mesh.missing.count(i) > 0;
      require(is_there || is_listed, "a triangle is not there, and is not listed as missing");
      require(! is_there || ! is_listed, "a triangle is there, but is listed as missing");
    }
  }

  std::vector<std::vector<std::size_t> > steiner_points_on_triangles() const
  {
    std::vector<std::vector<std::size_t> > result(m_mesh.surface.size());
    if(m_mesh.points.size() == m_mesh.number_of_inputs)
      return result;
    for(std::size_t i = 0; i < result.size(); ++i)
    {
      const Facet& f = m_mesh.surface[i];
      for(std::size_t v = m_mesh.number_of_inputs; v < m_mesh.points.size(); ++v)
        if(is_in_box(v, f) && is_on(exact(v), f))
          result[i].push_back(v);
    }
    return result;
  }

  // Necessary for being on the triangle: rounding keeps the order.
  bool is_in_box(const std::size_t v, const Facet& f) const
  {
    const Coordinates &x = m_mesh.points[v], &a = m_mesh.points[f[0]], &b = m_mesh.points[f[1]],
                      &c = m_mesh.points[f[2]];
    for(int i = 0; i < 3; ++i)
    {
      const double last = (std::nextafter)(x[i], HUGE_VAL), first = (std::nextafter)(x[i], -HUGE_VAL);
      if(last < (std::min)({ a[i], b[i], c[i] }) || first > (std::max)({ a[i], b[i], c[i] }))
        return false;
    }
    return true;
  }

  bool is_on(const Rational_point& x, const Facet& f) const
  {
    const Rational_point p[3] = { exact(f[0]), exact(f[1]), exact(f[2]) };
    const Rational_point n = cross(p[1] - p[0], p[2] - p[0]);
    if(dot(n, x - p[0]) != 0)
      return false;
    for(int i = 0; i < 3; ++i)
      if(dot(n, cross(p[(i + 1) % 3] - p[i], x - p[i])) < 0)
        return false;
    return true;
  }

  // The mesh facets at each Steiner point.
  std::vector<std::vector<Facet> > stars_of_steiner_points() const
  {
    std::vector<std::vector<Facet> > result(m_mesh.points.size() - m_mesh.number_of_inputs);
    if(m_kind == conforming)
      for(const Facet& f : m_facets)
        for(const std::size_t v : f)
          if(v >= m_mesh.number_of_inputs)
            result[v - m_mesh.number_of_inputs].push_back(f);
    return result;
  }

  // Mesh facets do not overlap, so their areas tell. Steiner points are on the triangle, so no part is without one.
  bool is_filled(const Facet& f, const std::vector<std::size_t>& points_on,
                 const std::vector<std::vector<Facet> >& stars) const
  {
    std::set<std::size_t> vertices(f.begin(), f.end());
    vertices.insert(points_on.begin(), points_on.end());
    std::set<Facet> parts;
    for(const std::size_t v : points_on)
      for(const Facet& g : stars[v - m_mesh.number_of_inputs])
        if(std::all_of(g.begin(), g.end(), [&](const std::size_t w) { return vertices.count(w) > 0; }))
          parts.insert(g);
    const Rational_point normal = normal_of(f);
    Rational sum = 0;
    for(const Facet& g : parts)
      sum += CGAL::abs(dot(normal_of(g), normal)); // they are coplanar
    return sum == dot(normal, normal);
  }

  Rational_point normal_of(const Facet& f) const
  {
    return cross(exact(f[1]) - exact(f[0]), exact(f[2]) - exact(f[0]));
  }

  // Where positions are rounded, only the connections can be exact: what is said to be the parts of a triangle are mesh
  // facets that make up a disk, and disks of neighboring triangles meet in the same path.
  void check_parts()
  {
    std::map<Edge, std::set<std::size_t> > paths;
    for(std::size_t i = 0; i < m_mesh.surface.size(); ++i)
    {
      const Facet& f = m_mesh.surface[i];
      const auto it = m_mesh.parts.find(i);
      const std::vector<Facet> parts = it == m_mesh.parts.end() ? std::vector<Facet>(1, f) : it->second;
      const bool is_there = std::all_of(parts.begin(), parts.end(), [&](const Facet& p) { return is_mesh_facet(p); });
      const bool is_listed = m_mesh.missing.count(i) > 0;
      require(is_there != is_listed, is_listed ? "a triangle is there, but is listed as missing"
                                               : "a triangle is not there, and is not listed as missing");
      if(is_there)
        check_disk(f, parts, paths);
    }
  }

  void check_disk(const Facet& f, const std::vector<Facet>& parts, std::map<Edge, std::set<std::size_t> >& paths)
  {
    std::set<std::size_t> vertices;
    std::set<Edge> edges, rim;
    for(const Facet& p : parts)
      for(int i = 0; i < 3; ++i)
      {
        Edge e = {{ p[i], p[(i + 1) % 3] }};
        sort(e);
        vertices.insert(p[i]);
        edges.insert(e);
        if(! rim.insert(e).second)
          rim.erase(e);
      }
    require(vertices.size() + parts.size() == edges.size() + 1, "the parts of a triangle are no disk");
    for(const std::size_t v : vertices)
      measure_deviation(v, f);
    std::vector<std::size_t> cycle = cycle_of(rim, f[0]);
    auto second = std::find(cycle.begin(), cycle.end(), f[1]), third = std::find(cycle.begin(), cycle.end(), f[2]);
    if(third < second)
    {
      std::reverse(cycle.begin(), cycle.end()); // the first corner is at both ends
      second = std::find(cycle.begin(), cycle.end(), f[1]);
      third = std::find(cycle.begin(), cycle.end(), f[2]);
    }
    require(third != cycle.end(), "a corner is not on the rim of the parts of a triangle");
    const auto check_path = [&](const std::size_t v, const std::size_t w, std::set<std::size_t> path)
    {
      require(paths.insert({ Edge{{ (std::min)(v, w), (std::max)(v, w) }}, path }).first->second == path,
              "two triangles disagree on their common edge");
    };
    check_path(f[0], f[1], { cycle.begin(), second + 1 });
    check_path(f[1], f[2], { second, third + 1 });
    check_path(f[2], f[0], { third, cycle.end() });
  }

  // The vertices of a cycle in order, the first one also in the end.
  static std::vector<std::size_t> cycle_of(std::set<Edge> edges, const std::size_t first)
  {
    std::vector<std::size_t> cycle(1, first);
    while(! edges.empty())
    {
      const auto it = std::find_if(edges.begin(), edges.end(), [&](const Edge& e)
                                   { return e[0] == cycle.back() || e[1] == cycle.back(); });
      require(it != edges.end(), "the rim of the parts of a triangle is no cycle");
      cycle.push_back((*it)[0] == cycle.back() ? (*it)[1] : (*it)[0]);
      edges.erase(it);
    }
    require(cycle.back() == first, "the rim of the parts of a triangle is no cycle");
    require(std::set<std::size_t>(cycle.begin(), cycle.end()).size() + 1 == cycle.size(), "a rim meets itself");
    return cycle;
  }

  // How far a vertex is from the plane of a triangle.
  void measure_deviation(const std::size_t v, const Facet& f)
  {
    if(v < m_mesh.number_of_inputs)
      return;
    const Rational_point n = normal_of(f);
    const Rational height = dot(n, exact(v) - exact(f[0]));
    m_deviation = (std::max)(m_deviation, std::sqrt(CGAL::to_double(Rational(height * height / dot(n, n)))));
  }

  const Indexed_mesh& m_mesh;
  const Kind m_kind;
  double m_deviation = 0;
  std::vector<Facet> m_facets; // of the mesh, sorted
  std::vector<Facet> m_hull;   // those of one cell, counterclockwise from outside
};

} // namespace br3_test

#endif // BR3_TEST_EXACT_MESH_CHECKER_H
