#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_COMPLEX_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_COMPLEX_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

// Triangles that are divided, joined and flipped one after the other. An edge may have any number of triangles: where
// three of them meet, and at a border, nothing is to be cut open and glued again. An edge in a triangle has the
// position of the vertex opposite to it.
template <typename Point_>
class Triangle_complex
{
public:
  typedef Point_ Point;
  typedef std::size_t Index;
  typedef std::vector<Index> Indices;

  static constexpr Index none = (std::numeric_limits<std::size_t>::max)();

  enum class Kind : unsigned char { free, on_curve, fixed }; // where a vertex may move to

  struct Face
  {
    std::array<Index, 3> vertices;
    std::array<Index, 3> curves = {{ none, none, none }}; // the curves that the edges are parts of
    Index patch = 0;                                      // the part of the surface that the curves bound
    Index source = 0;                                     // a face of the surface that is remeshed
    bool is_removed = false;

    int position(const Index v) const
    {
      return v == vertices[0] ? 0 : v == vertices[1] ? 1 : v == vertices[2] ? 2 : -1;
    }
    bool has(const Index v) const { return position(v) >= 0; }
    Index third(const Index v, const Index w) const { return vertices[third_position(v, w)]; }
    Index curve(const Index v, const Index w) const { return curves[third_position(v, w)]; }
    bool runs(const Index v, const Index w) const { return vertices[(position(v) + 1) % 3] == w; }

  private:
    int third_position(const Index v, const Index w) const { return 3 - position(v) - position(w); }
  };

  std::vector<Point> points;
  std::vector<Kind> kinds;     // of the vertices
  std::vector<Indices> stars;  // the faces of the vertices; none of a vertex that is removed
  std::vector<Face> faces;

  void add_vertex(const Point& p, const Kind kind)
  {
    points.push_back(p);
    kinds.push_back(kind);
    stars.emplace_back();
  }

  void add_face(const Face& face)
  {
    for(const Index v : face.vertices)
      stars[v].push_back(faces.size());
    faces.push_back(face);
  }

  // gives the faces that are left new numbers
  void drop_removed_faces()
  {
    const std::vector<Face> old = std::move(faces);
    faces.clear();
    stars.assign(points.size(), Indices());
    for(const Face& face : old)
      if(! face.is_removed)
        add_face(face);
  }

  Indices faces_of_edge(const Index a, const Index b) const
  {
    Indices result;
    for(const Index f : stars[a])
      if(faces[f].has(b))
        result.push_back(f);
    return result;
  }

  Indices neighbors(const Index v) const
  {
    Indices result;
    for(const Index f : stars[v])
      for(const Index w : faces[f].vertices)
        if(w != v)
          result.push_back(w);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // divides an edge at a new vertex, which is returned
  Index split(const Index a, const Index b, const Point& p)
  {
    const Index m = points.size();
    const Indices old = faces_of_edge(a, b);
    const bool is_curve = faces[old[0]].curve(a, b) != none;
    add_vertex(p, is_curve ? Kind::on_curve : Kind::free);
    for(const Index f : old)
    {
      Face half = faces[f]; // that of `b`
      half.curves[half.position(b)] = none;
      half.vertices[half.position(a)] = m;
      Face& rest = faces[f];
      rest.curves[rest.position(a)] = none;
      rest.vertices[rest.position(b)] = m;
      remove_from_star(b, f);
      stars[m].push_back(f);
      add_face(half);
    }
    return m;
  }

  // Whether the complex stays what it is if `a` goes to the place of `b`: no two triangles become one, no edge gets
  // more of them, and curves stay.
  bool can_collapse(const Index a, const Index b) const
  {
    const Indices dying = faces_of_edge(a, b);
    if(dying.empty() || kinds[a] == Kind::fixed ||
       (kinds[a] == Kind::on_curve && faces[dying[0]].curve(a, b) == none))
      return false;
    for(const Index f : dying)
      if(faces[f].curve(a, faces[f].third(a, b)) != none)
        return false;
    const Indices n = neighbors(a), m = neighbors(b);
    Indices common;
    std::set_intersection(n.begin(), n.end(), m.begin(), m.end(), std::back_inserter(common));
    return common.size() == dying.size() && dying.size() < stars[a].size() && ! makes_double_face(a, b);
  }

  void collapse(const Index a, const Index b)
  {
    for(const Index f : faces_of_edge(a, b))
    {
      give_curve(f, a, b);
      remove(f);
    }
    for(const Index f : stars[a])
    {
      faces[f].vertices[faces[f].position(a)] = b;
      stars[b].push_back(f);
    }
    stars[a].clear();
  }

  bool has_edge(const Index a, const Index b) const
  {
    return std::any_of(stars[a].begin(), stars[a].end(), [&](const Index f) { return faces[f].has(b); });
  }

  // the edge must have two faces that are turned alike, and the new edge must not exist
  void flip(const Index a, const Index b)
  {
    const Indices old = faces_of_edge(a, b);
    const bool is_first = faces[old[0]].runs(a, b);
    const Index f = old[is_first ? 0 : 1], g = old[is_first ? 1 : 0];
    const Index c = faces[f].third(a, b), d = faces[g].third(a, b);
    const Face first = faces[f], second = faces[g];
    faces[f].vertices = {{ a, d, c }};
    faces[f].curves = {{ none, first.curve(a, c), second.curve(a, d) }};
    faces[g].vertices = {{ d, b, c }};
    faces[g].curves = {{ first.curve(b, c), none, second.curve(b, d) }};
    remove_from_star(b, f);
    remove_from_star(a, g);
    stars[d].push_back(f);
    stars[c].push_back(g);
  }

private:
  void remove_from_star(const Index v, const Index f)
  {
    stars[v].erase(std::find(stars[v].begin(), stars[v].end(), f));
  }

  void remove(const Index f)
  {
    faces[f].is_removed = true;
    for(const Index v : faces[f].vertices)
      remove_from_star(v, f);
  }

  // a face without its edge leaves the curve of the edge at `b` to those beyond the other edge
  void give_curve(const Index f, const Index a, const Index b)
  {
    const Index c = faces[f].third(a, b), curve = faces[f].curve(b, c);
    for(const Index g : faces_of_edge(a, c))
      faces[g].curves[3 - faces[g].position(a) - faces[g].position(c)] = curve;
  }

  bool makes_double_face(const Index a, const Index b) const
  {
    return std::any_of(stars[a].begin(), stars[a].end(), [&](const Index f)
    {
      const auto& v = faces[f].vertices;
      const int i = faces[f].position(a);
      const Index x = v[(i + 1) % 3], y = v[(i + 2) % 3];
      return ! faces[f].has(b) && std::any_of(stars[b].begin(), stars[b].end(), [&](const Index g)
                                              { return faces[g].has(x) && faces[g].has(y); });
    });
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_COMPLEX_H
