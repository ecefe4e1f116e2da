#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REMOVE_DETAILS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REMOVE_DETAILS_H

#include "surface_features.h"
#include "triangle_complex.h"

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Takes out of a complex what is smaller than a distance: joins vertices of sharp edges that are closer to each other,
// and vertices and edges, so that steps and strips which nobody would mesh are gone before features are looked for. No
// vertex goes farther than twice the distance.
template <typename Complex>
class Detail_remover
{
  typedef typename Complex::Point             Point;
  typedef typename Complex::Index             Index;
  typedef std::array<Point, 3>                Triangle;
  typedef std::pair<double, std::array<Index, 2> > Entry; // a length or a height, and the numbers of what has it

  static constexpr int max_number_of_sweeps = 8;
  static constexpr double smallest_cosine = 0.95; // between a triangle that is no needle and what becomes of it

  Complex& m_complex;
  const std::vector<bool>& m_is_kept; // of the sources of the faces
  const double m_distance, m_angle;
  std::vector<bool> m_is_sharp;       // of the vertices
  std::vector<double> m_moves;        // how far the vertices that went to the place of a vertex did go

public:
  // `is_sharp` is of the vertices, and `angle` that above which edges are sharp, in degrees
  Detail_remover(Complex& complex, const std::vector<bool>& is_kept, const std::vector<bool>& is_sharp,
                 const double distance, const double angle)
    : m_complex(complex), m_is_kept(is_kept), m_distance(distance), m_angle(angle), m_is_sharp(is_sharp),
      m_moves(complex.points.size(), 0)
  { }

  void operator()()
  {
    for(int i = 0; i < max_number_of_sweeps; ++i)
      if(collapse_short_edges() + collapse_caps() == 0)
        break;
    m_complex.drop_removed_faces();
  }

private:
  const Point& point(const Index v) const { return m_complex.points[v]; }

  double length(const Index v, const Index w) const { return std::sqrt(CGAL::squared_distance(point(v), point(w))); }

  std::size_t collapse_short_edges()
  {
    std::vector<Entry> edges;
    for(const auto& face : m_complex.faces)
      for(int i = 0; i < 3 && ! face.is_removed; ++i)
      {
        const auto ends = std::minmax(face.vertices[i], face.vertices[(i + 1) % 3]);
        if(m_is_sharp[ends.first] && m_is_sharp[ends.second] && length(ends.first, ends.second) < m_distance)
          edges.push_back({ length(ends.first, ends.second), {{ ends.first, ends.second }} });
      }
    std::sort(edges.begin(), edges.end());
    std::size_t n = 0;
    for(const Entry& e : edges)
      n += m_complex.has_edge(e.second[0], e.second[1]) && try_collapse(e.second[0], e.second[1]);
    return n;
  }

  // in the direction that moves planes less
  bool try_collapse(Index a, Index b)
  {
    if(damage(b, a) < damage(a, b))
      std::swap(a, b);
    return collapse(a, b) || collapse(b, a);
  }

  bool collapse(const Index a, const Index b)
  {
    const double move = m_moves[a] + length(a, b);
    if(move > 2 * m_distance || ! m_complex.can_collapse(a, b) || ! is_allowed(a, b))
      return false;
    m_complex.collapse(a, b);
    m_moves[b] = (std::max)(m_moves[b], move);
    return true;
  }

  Triangle triangle(const Index f) const
  {
    const auto& v = m_complex.faces[f].vertices;
    return {{ point(v[0]), point(v[1]), point(v[2]) }};
  }

  static auto normal(const Triangle& t) { return CGAL::normal(t[0], t[1], t[2]); }

  static double longest_edge(const Triangle& t)
  {
    return std::sqrt((std::max)({ CGAL::squared_distance(t[0], t[1]), CGAL::squared_distance(t[1], t[2]),
                                  CGAL::squared_distance(t[2], t[0]) }));
  }

  static double height(const Triangle& t)
  {
    const double length = longest_edge(t);
    return length == 0 ? 0 : std::sqrt(normal(t).squared_length()) / length;
  }

  bool is_thin(const Triangle& t) const { return height(t) < m_distance; }

  // how far `b` is from the planes of the triangles of `a`
  double damage(const Index a, const Index b) const
  {
    double result = 0;
    for(const Index f : m_complex.stars[a])
    {
      const Triangle t = triangle(f);
      if(! is_thin(t))
        result = (std::max)(result, std::abs((point(b) - point(a)) * normal(t)) /
                                    std::sqrt(normal(t).squared_length()));
    }
    return result;
  }

  bool is_allowed(const Index a, const Index b) const
  {
    return std::all_of(m_complex.stars[a].begin(), m_complex.stars[a].end(), [&](const Index f)
    {
      if(m_is_kept[m_complex.faces[f].source])
        return false;
      Triangle t = triangle(f);
      if(m_complex.faces[f].has(b) || is_thin(t))
        return true;
      const auto n = normal(t);
      t[m_complex.faces[f].position(a)] = point(b);
      const auto m = normal(t);
      return n * m > smallest_cosine * std::sqrt(n.squared_length() * m.squared_length());
    });
  }

  // a vertex close to the edge on the other side of a triangle: the edge is divided there
  std::size_t collapse_caps()
  {
    std::vector<Entry> caps;
    for(Index f = 0; f < m_complex.faces.size(); ++f)
      if(! m_complex.faces[f].is_removed && is_thin(triangle(f)) && is_sharp(m_complex.faces[f]))
        caps.push_back({ height(triangle(f)), {{ f, f }} });
    std::sort(caps.begin(), caps.end());
    std::size_t n = 0;
    for(const Entry& cap : caps)
      n += ! m_complex.faces[cap.second[0]].is_removed && try_cap(cap.second[0]);
    return n;
  }

  bool is_sharp(const typename Complex::Face& face) const
  {
    return std::all_of(face.vertices.begin(), face.vertices.end(), [&](const Index v) { return m_is_sharp[v]; });
  }

  bool try_cap(const Index f)
  {
    const Triangle t = triangle(f);
    const double longest = longest_edge(t);
    int i = 0;
    while(CGAL::squared_distance(t[(i + 1) % 3], t[(i + 2) % 3]) < longest * longest * (1 - 1e-12))
      ++i;
    const Point &p = t[i], &q = t[(i + 1) % 3], &r = t[(i + 2) % 3];
    const double share = ((p - q) * (r - q)) / (longest * longest);
    const Index v = m_complex.faces[f].vertices[i], w = m_complex.faces[f].vertices[(i + 1) % 3],
                x = m_complex.faces[f].vertices[(i + 2) % 3];
    const Point foot = q + share * (r - q);
    if(share <= 0 || share >= 1 || ! is_thin(t) || ! may_divide(w, x))
      return false;
    const Index m = m_complex.split(w, x, foot);
    m_moves.push_back(0);
    m_is_sharp.push_back(true);
    return collapse(m, v) || collapse(v, m);
  }

  // a sharp edge, whose triangles may change
  bool may_divide(const Index v, const Index w) const
  {
    const auto faces = m_complex.faces_of_edge(v, w);
    const bool is_sharp = faces.size() != 2 ||
                          angle_between(normal(triangle(faces[0])), normal(triangle(faces[1]))) > m_angle;
    return is_sharp && std::none_of(faces.begin(), faces.end(),
                                    [&](const Index f) { return m_is_kept[m_complex.faces[f].source]; });
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_REMOVE_DETAILS_H
