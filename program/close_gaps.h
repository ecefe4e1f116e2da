#ifndef BOUNDARY_RECOVERY_3_PROGRAM_CLOSE_GAPS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_CLOSE_GAPS_H

#include "distance_between.h"
#include "divide_edges.h"
#include "point_search.h"
#include "triangle_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Closes gaps along edges: where one triangle has an edge, and vertices are along it on the other side, as close as the
// tolerance, the triangle is divided at these. Points do not move. (The function stitch_borders() of the package
// Polygon Mesh Processing stitches edges between equal points only.)
template <typename Point>
class Gap_closer
{
  typedef std::array<double, 3> Vector;

  Triangle_soup<Point>& m_soup;
  const double m_tolerance;
  std::vector<std::size_t> m_dropped;

public:
  Gap_closer(Triangle_soup<Point>& soup, const double tolerance) : m_soup(soup), m_tolerance(tolerance) { }

  // returns the number of edges that were divided
  std::size_t operator()()
  {
    std::size_t number_of_edges = 0;
    for(;;) // There is an end: open edges become shorter, no others become open, and vertices are not added.
    {
      const Middle_vertices middles = find_middles();
      if(middles.empty())
        return number_of_edges;
      divide_edges(m_soup, middles);
      const std::vector<std::size_t> gone = drop_repeated_vertices(m_soup);
      m_dropped.insert(m_dropped.end(), gone.begin(), gone.end());
      number_of_edges += middles.size();
    }
  }

  // The sources of triangles that are gone, or a part of them: their edges are as close to each other as the tolerance.
  const std::vector<std::size_t>& dropped() const { return m_dropped; }

private:
  Middle_vertices find_middles() const
  {
    const std::vector<Open_edge> edges = open_edges(m_soup.triangles);
    std::vector<std::size_t> vertices, close;
    for(const Open_edge& e : edges)
      vertices.insert(vertices.end(), { e.vertices.first, e.vertices.second });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

    const Point_search<Point> search(m_soup.points, vertices);
    Middle_vertices middles;
    for(const Open_edge& e : edges)
    {
      search(m_soup.points[e.vertices.first], m_soup.points[e.vertices.second], m_tolerance, close);
      std::sort(close.begin(), close.end());
      double longest = length(e.vertices.first, e.vertices.second); // Parts are shorter, so that there is an end.
      for(const std::size_t v : close)
      {
        const double longer_part = (std::max)(length(e.vertices.first, v), length(v, e.vertices.second));
        if(v != e.opposite && longer_part < longest && is_along(v, e.vertices))
        {
          middles[e.vertices] = v;
          longest = longer_part; // where it is short, there are few rounds
        }
      }
    }
    return middles;
  }

  // Whether a vertex is close to an edge, beside it; an edge that is not longer than the gap may be wide has no sides.
  bool is_along(const std::size_t v, const Vertex_numbers& edge) const
  {
    const Point& p = m_soup.points[edge.first];
    const Point& q = m_soup.points[edge.second];
    const double size = (std::max)({ std::abs(q.x() - p.x()), std::abs(q.y() - p.y()), std::abs(q.z() - p.z()) });
    if(! (size > 2 * m_tolerance))
      return false;
    // in units of the edge no square is too large or too small
    const Vector e = difference(p, q, size), w = difference(p, m_soup.points[v], size);
    const double t = dot(w, e) / dot(e, e), gap = m_tolerance / size;
    const Vector off = {{ w[0] - t * e[0], w[1] - t * e[1], w[2] - t * e[2] }};
    return dot(off, off) <= gap * gap && t > 0 && t < 1;
  }

  // All comparisons take the length of an edge from here: if rounding errors made it differ, an edge could be shorter
  // than itself, and there would be no end.
  double length(const std::size_t v, const std::size_t w) const
  {
    return distance_between(m_soup.points[v], m_soup.points[w]);
  }

  static Vector difference(const Point& p, const Point& q, const double unit)
  {
    return {{ (q.x() - p.x()) / unit, (q.y() - p.y()) / unit, (q.z() - p.z()) / unit }};
  }

  static double dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_CLOSE_GAPS_H
