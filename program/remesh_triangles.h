#ifndef BOUNDARY_RECOVERY_3_PROGRAM_REMESH_TRIANGLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_REMESH_TRIANGLES_H

#include "reference_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

// Gives the triangles of a complex angles that are not small, and edges of the sizes that its reference surface and its
// own narrow parts ask for: joins vertices, divides and flips edges, and moves vertices within patches, in turns.
// Nothing is done that would take a triangle or an edge of a curve farther away than the reference surface allows.
class Triangle_remesher
{
  typedef Reference_surface::Complex  Complex;
  typedef Reference_surface::Point    Point;
  typedef Reference_surface::Vector   Vector;
  typedef Complex::Index              Index;
  typedef Complex::Indices            Indices;
  typedef Complex::Kind               Kind;
  typedef std::array<Index, 3>        Vertices;
  typedef std::array<Index, 2>        Edge;

  static constexpr int number_of_rounds = 6, max_number_of_sweeps = 5;
  static constexpr double first_factor = 8;        // of the smallest size: what is narrow is divided little by little
  static constexpr std::size_t largest_ratio = 5, always_allowed = 100000; // of triangles: as long as there are fewer
  static constexpr double growth = 0.3;            // of sizes, per length
  static constexpr double too_short = 4. / 5, too_long = 4. / 3; // in terms of the size
  static constexpr double smallest_cosine = 0.3;   // between a triangle and what it stands for
  static constexpr double good_shape = 0.5;

  Complex& m_complex;
  const Reference_surface& m_reference;
  const double m_largest_size;
  double m_smallest_size;
  std::vector<double> m_sizes;
  std::size_t m_clock = 0, m_last_flips = 0, m_last_moves = 0; // one tick for each sweep
  std::vector<std::size_t> m_changes; // when something around a vertex changed last

public:
  Triangle_remesher(Complex& complex, const Reference_surface& reference, const double largest_edge,
                    const double smallest_size)
    : m_complex(complex), m_reference(reference), m_largest_size(largest_edge / too_long),
      m_smallest_size(smallest_size * first_factor), m_changes(complex.points.size(), 0)
  { }

  void operator()()
  {
    const double smallest_size = m_smallest_size / first_factor;
    const std::size_t bound = number_of_faces() * largest_ratio + always_allowed;
    for(int i = 0; i < number_of_rounds; ++i)
    {
      if(i > 0 && number_of_faces() < bound)
        m_smallest_size = (std::max)(smallest_size, m_smallest_size / 2);
      set_sizes();
      collapse_short_edges();
      set_sizes();
      split_long_edges();
      flip_edges();
      move_vertices();
      flip_edges();
    }
  }

private:
  std::size_t number_of_faces() const
  {
    return std::count_if(m_complex.faces.begin(), m_complex.faces.end(), [](const auto& f) { return ! f.is_removed; });
  }

  const Point& point(const Index v) const { return m_complex.points[v]; }

  double length(const Index v, const Index w) const { return std::sqrt(CGAL::squared_distance(point(v), point(w))); }

  double edge_size(const Edge& e) const { return (std::min)(m_sizes[e[0]], m_sizes[e[1]]); }

  // notes that something around the vertices of a star changed
  void note_change(const Index v)
  {
    m_changes.resize(m_complex.points.size(), m_clock);
    for(const Index f : m_complex.stars[v])
      for(const Index w : m_complex.faces[f].vertices)
        m_changes[w] = m_clock;
  }

  bool has_changed(const Index v, const std::size_t since) const { return m_changes[v] >= since; }

  bool is_curve(const Index v, const Index w) const
  {
    return m_complex.faces[m_complex.faces_of_edge(v, w)[0]].curve(v, w) != Complex::none;
  }

  // all edges, once each, in an order that does not depend on what was done before
  std::vector<Edge> edges() const
  {
    std::vector<Edge> result;
    for(const auto& face : m_complex.faces)
      for(int i = 0; i < 3 && ! face.is_removed; ++i)
      {
        const auto ends = std::minmax(face.vertices[i], face.vertices[(i + 1) % 3]);
        result.push_back({{ ends.first, ends.second }});
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // ---- sizes

  // the sizes of the reference surface and of narrow parts, which grow from there
  void set_sizes()
  {
    m_sizes.assign(m_complex.points.size(), m_largest_size);
    for(Index v = 0; v < m_sizes.size(); ++v)
      for(const Index patch : patches(v))
        m_sizes[v] = (std::min)(m_sizes[v], m_reference.size(point(v), closest(point(v), patch).number, growth));
    for(const Edge& e : edges())
      if(is_narrow(e))
        for(const Index v : e)
          m_sizes[v] = (std::min)(m_sizes[v], length(e[0], e[1]));
    for(double& size : m_sizes)
      size = (std::max)(size, (std::min)(m_smallest_size, m_largest_size));
    grade_sizes();
  }

  // whether an edge cannot become longer: its ends are corners, or on different curves
  bool is_narrow(const Edge& e) const
  {
    const Kind k = m_complex.kinds[e[0]], m = m_complex.kinds[e[1]];
    if(k == Kind::free || m == Kind::free)
      return false;
    return (k == Kind::fixed && m == Kind::fixed) || ! is_curve(e[0], e[1]);
  }

  void grade_sizes()
  {
    typedef std::pair<double, Index> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    for(Index v = 0; v < m_sizes.size(); ++v)
      if(! m_complex.stars[v].empty())
        queue.emplace(m_sizes[v], v);
    while(! queue.empty())
    {
      const Entry entry = queue.top();
      queue.pop();
      if(entry.first > m_sizes[entry.second])
        continue;
      for(const Index w : m_complex.neighbors(entry.second))
      {
        const double size = entry.first + growth * length(entry.second, w);
        if(size < m_sizes[w])
          queue.emplace(m_sizes[w] = size, w);
      }
    }
  }

  Indices patches(const Index v) const
  {
    Indices result;
    for(const Index f : m_complex.stars[v])
      result.push_back(m_complex.faces[f].patch);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // ---- what is allowed

  Reference_surface::Closest closest(const Point& p, const Index patch) const
  {
    return m_reference.closest_in_patch(p, patch);
  }

  bool is_frozen(const Index f) const
  {
    const auto& v = m_complex.faces[f].vertices;
    return m_reference.is_frozen(closest(CGAL::centroid(point(v[0]), point(v[1]), point(v[2])),
                                         m_complex.faces[f].patch).number);
  }

  bool is_any_frozen(const Indices& faces) const
  {
    return m_reference.is_tightened() &&
           std::any_of(faces.begin(), faces.end(), [&](const Index f) { return is_frozen(f); });
  }

  static Vector normal(const std::array<Point, 3>& t) { return CGAL::normal(t[0], t[1], t[2]); }

  // 1 for an equilateral triangle, 0 for one without area
  static double shape(const std::array<Point, 3>& t)
  {
    const double sum = CGAL::squared_distance(t[0], t[1]) + CGAL::squared_distance(t[1], t[2]) +
                       CGAL::squared_distance(t[2], t[0]);
    return sum == 0 ? 0 : 2 * std::sqrt(3 * normal(t).squared_length()) / sum;
  }

  std::array<Point, 3> triangle(const Index f) const
  {
    const auto& v = m_complex.faces[f].vertices;
    return {{ point(v[0]), point(v[1]), point(v[2]) }};
  }

  // the triangle of a face with a vertex in another place
  std::array<Point, 3> moved_triangle(const Index f, const Index v, const Point& p) const
  {
    std::array<Point, 3> t = triangle(f);
    t[m_complex.faces[f].position(v)] = p;
    return t;
  }

  bool is_segment_close(const Point& p, const Point& q, const Index patch) const
  {
    static constexpr int n = 4;
    for(int i = 1; i < n; ++i)
      if(! m_reference.is_close(p + (double(i) / n) * (q - p), patch))
        return false;
    return true;
  }

  bool is_turned_alike(const std::array<Point, 3>& t, const Index reference_face) const
  {
    const Vector n = normal(t), m = m_reference.normal(reference_face);
    return n * m > smallest_cosine * std::sqrt(n.squared_length() * m.squared_length());
  }

  // whether a triangle may stand for the part of a patch that is below it
  bool is_allowed(const std::array<Point, 3>& t, const Index patch) const
  {
    if(m_reference.is_flat(patch))
      return is_turned_alike(t, m_reference.flat_face(patch));
    const Point c = CGAL::centroid(t[0], t[1], t[2]);
    const auto below = closest(c, patch);
    return is_turned_alike(t, below.number) && ! m_reference.is_frozen(below.number) && m_reference.is_close(c, below);
  }

  // The same for a triangle with a vertex in another place, and one of its edges there: the other one is that of the
  // next triangle, or of a curve.
  bool is_move_allowed(const Index f, const Index v, const Point& p) const
  {
    const auto& face = m_complex.faces[f];
    const Index next = face.vertices[(face.position(v) + 1) % 3];
    return is_allowed(moved_triangle(f, v, p), face.patch) &&
           (face.curve(v, next) != Complex::none || is_segment_close(p, point(next), face.patch));
  }

  // ---- joining

  void collapse_short_edges()
  {
    std::vector<Edge> refused; // in ascending order
    std::size_t since = 0;
    for(int i = 0; i < max_number_of_sweeps; ++i)
    {
      const std::size_t begin = ++m_clock;
      if(collapse_sweep(since, refused) == 0)
        break;
      since = begin;
    }
  }

  // what was refused is tried again only where something changed
  std::size_t collapse_sweep(const std::size_t since, std::vector<Edge>& refused)
  {
    std::vector<std::pair<double, Edge> > short_edges;
    for(const Edge& e : edges())
      if(length(e[0], e[1]) < too_short * edge_size(e) &&
         (has_changed(e[0], since) || has_changed(e[1], since) ||
          ! std::binary_search(refused.begin(), refused.end(), e)))
        short_edges.emplace_back(length(e[0], e[1]), e);
    std::sort(short_edges.begin(), short_edges.end());
    std::size_t n = 0;
    for(const auto& entry : short_edges)
    {
      const Edge& e = entry.second;
      if(m_complex.has_edge(e[0], e[1]) && (try_collapse(e[0], e[1]) || try_collapse(e[1], e[0])))
        ++n;
      else
        refused.push_back(e);
    }
    std::sort(refused.begin(), refused.end());
    return n;
  }

  bool try_collapse(const Index a, const Index b)
  {
    if(! m_complex.can_collapse(a, b) || is_any_frozen(m_complex.stars[a]) || ! keeps_curve(a, b) ||
       ! keeps_shapes(a, b))
      return false;
    m_complex.collapse(a, b);
    note_change(b);
    return true;
  }

  // whether the curve of `a`, if it is on one, stays where it is
  bool keeps_curve(const Index a, const Index b) const
  {
    if(m_complex.kinds[a] == Kind::free)
      return true;
    for(const Index c : m_complex.neighbors(a))
    {
      const Index curve = m_complex.faces[m_complex.faces_of_edge(a, c)[0]].curve(a, c);
      if(c != b && curve != Complex::none)
        return is_curve_close(b, c, curve) &&
               CGAL::squared_distance(point(a), Reference_surface::Segment(point(b), point(c))) <=
                 m_reference.squared_tolerance();
    }
    return false;
  }

  bool is_curve_close(const Index v, const Index w, const Index curve) const
  {
    static constexpr int n = 4;
    for(int i = 1; i < n; ++i)
      if(! m_reference.is_close_to_curve(point(v) + (double(i) / n) * (point(w) - point(v)), curve))
        return false;
    return true;
  }

  bool keeps_shapes(const Index a, const Index b) const
  {
    double longest = 0, worst = 1, new_longest = 0, new_worst = 1;
    for(const Index c : m_complex.neighbors(a))
    {
      longest = (std::max)(longest, length(a, c));
      new_longest = (std::max)(new_longest, length(b, c));
    }
    for(const Index f : m_complex.stars[a])
    {
      worst = (std::min)(worst, shape(triangle(f)));
      if(! m_complex.faces[f].has(b))
        new_worst = (std::min)(new_worst, shape(moved_triangle(f, a, point(b))));
    }
    if(new_longest > (std::max)(longest, too_long * m_sizes[b]) || new_worst < (std::min)(worst, good_shape))
      return false;
    return std::all_of(m_complex.stars[a].begin(), m_complex.stars[a].end(), [&](const Index f)
    {
      return m_complex.faces[f].has(b) || is_move_allowed(f, a, point(b));
    });
  }

  // ---- dividing

  void split_long_edges()
  {
    typedef std::pair<double, Edge> Entry;
    std::priority_queue<Entry> queue;
    const auto add = [&](const Index v, const Index w)
    {
      const Edge e = {{ (std::min)(v, w), (std::max)(v, w) }};
      if(length(v, w) > too_long * edge_size(e))
        queue.emplace(length(v, w), e);
    };
    for(const Edge& e : edges())
      add(e[0], e[1]);
    while(! queue.empty())
    {
      const Edge e = queue.top().second;
      queue.pop();
      if(! m_complex.has_edge(e[0], e[1]) || is_any_frozen(m_complex.faces_of_edge(e[0], e[1])))
        continue;
      const Index m = split(e);
      for(const Index v : m_complex.neighbors(m))
        add(m, v);
    }
  }

  Index split(const Edge& e)
  {
    const Point middle = CGAL::midpoint(point(e[0]), point(e[1]));
    const auto& face = m_complex.faces[m_complex.faces_of_edge(e[0], e[1])[0]];
    const Index curve = face.curve(e[0], e[1]);
    const Point target = curve == Complex::none ? closest(middle, face.patch).point
                                                : m_reference.closest_on_curve(middle, curve);
    const Index m = m_complex.split(e[0], e[1], middle);
    m_sizes.push_back((m_sizes[e[0]] + m_sizes[e[1]]) / 2);
    if(is_move_allowed(m, target))
      m_complex.points[m] = target;
    note_change(m);
    return m;
  }

  bool is_move_allowed(const Index v, const Point& p) const
  {
    return std::all_of(m_complex.stars[v].begin(), m_complex.stars[v].end(), [&](const Index f)
                       { return is_move_allowed(f, v, p); });
  }

  // ---- flipping

  void flip_edges()
  {
    for(int i = 0; i < max_number_of_sweeps; ++i)
    {
      const std::size_t since = std::exchange(m_last_flips, ++m_clock);
      std::size_t n = 0;
      for(const Edge& e : edges())
        n += (has_changed(e[0], since) || has_changed(e[1], since)) && m_complex.has_edge(e[0], e[1]) &&
             try_flip(e[0], e[1]);
      if(n == 0)
        break;
    }
  }

  bool try_flip(const Index a, const Index b)
  {
    const Indices faces = m_complex.faces_of_edge(a, b);
    if(m_complex.faces[faces[0]].curve(a, b) != Complex::none)
      return false;
    const bool is_first = m_complex.faces[faces[0]].runs(a, b);
    const Index f = faces[is_first ? 0 : 1], g = faces[is_first ? 1 : 0];
    const Index c = m_complex.faces[f].third(a, b), d = m_complex.faces[g].third(a, b);
    const std::array<Point, 3> t = {{ point(a), point(d), point(c) }}, u = {{ point(d), point(b), point(c) }};
    const Index patch = m_complex.faces[f].patch;
    const double worst = (std::min)(shape(triangle(f)), shape(triangle(g)));
    if((std::min)(shape(t), shape(u)) <= worst || length(c, d) > (std::max)(length(a, b), too_long * m_largest_size) ||
       m_complex.has_edge(c, d) || is_any_frozen(faces) ||
       ! is_allowed(t, patch) || ! is_allowed(u, patch) || ! is_segment_close(point(c), point(d), patch))
      return false;
    m_complex.flip(a, b);
    note_change(c);
    note_change(d);
    return true;
  }

  // ---- moving

  void move_vertices()
  {
    for(int i = 0; i < max_number_of_sweeps; ++i)
    {
      const std::size_t since = std::exchange(m_last_moves, ++m_clock);
      for(Index v = 0; v < m_complex.points.size(); ++v)
        if(m_complex.kinds[v] == Kind::free && ! m_complex.stars[v].empty() && has_changed(v, since))
          try_move(v);
    }
  }

  // to the middle of its neighbors, within its patch, if the worst of its triangles becomes better
  void try_move(const Index v)
  {
    const Indices& star = m_complex.stars[v];
    Vector sum = CGAL::NULL_VECTOR;
    const Indices neighbors = m_complex.neighbors(v);
    for(const Index w : neighbors)
      sum = sum + (point(w) - point(v));
    const Point p = closest(point(v) + sum / double(neighbors.size()), m_complex.faces[star[0]].patch).point;
    double longest = too_long * m_largest_size, new_longest = 0, worst = 1, new_worst = 1;
    for(const Index w : neighbors)
    {
      longest = (std::max)(longest, length(v, w));
      new_longest = (std::max)(new_longest, std::sqrt(CGAL::squared_distance(p, point(w))));
    }
    for(const Index f : star)
    {
      worst = (std::min)(worst, shape(triangle(f)));
      new_worst = (std::min)(new_worst, shape(moved_triangle(f, v, p)));
    }
    if(new_worst > worst && new_longest <= longest && ! is_any_frozen(star) && is_move_allowed(v, p))
    {
      m_complex.points[v] = p;
      note_change(v);
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_REMESH_TRIANGLES_H
