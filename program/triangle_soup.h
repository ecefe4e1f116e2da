#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// A triangle that knows of which face of the input it is a part, or the whole of it, and how often it was there. The
// functions of the package Polygon Mesh Processing take it for a polygon: when they exchange polygons, the numbers go
// with them.
struct Sourced_triangle
  : public std::vector<std::size_t>
{
  std::size_t source = 0;
  long weight = 1;    // number of triangles that it stands for and that turn like it, minus those that do not
  bool is_odd = true; // whether it stands for an odd number of them

  Sourced_triangle() { }
  Sourced_triangle(const std::array<std::size_t, 3>& vertices, const std::size_t source)
    : std::vector<std::size_t>(vertices.begin(), vertices.end()), source(source)
  { }

  bool has_repeated_vertex() const
  {
    return (*this)[0] == (*this)[1] || (*this)[1] == (*this)[2] || (*this)[2] == (*this)[0];
  }
};

// What is repaired: points, of which several may be equal or not used, and triangles.
template <typename Point>
struct Triangle_soup
{
  std::vector<Point> points;
  std::vector<Sourced_triangle> triangles;
};

// Returns the sources of the triangles that are gone, in their order.
template <typename Point>
std::vector<std::size_t> drop_repeated_vertices(Triangle_soup<Point>& soup)
{
  std::vector<std::size_t> gone;
  std::vector<Sourced_triangle> kept;
  for(const Sourced_triangle& t : soup.triangles)
    if(t.has_repeated_vertex())
      gone.push_back(t.source);
    else
      kept.push_back(t);
  soup.triangles.swap(kept);
  return gone;
}

typedef std::pair<std::size_t, std::size_t> Vertex_numbers; // those of an edge, the smaller one first

template <typename Triangle>
Vertex_numbers edge_of(const Triangle& triangle, const int i)
{
  return std::minmax(triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
}

// whether vertex `w` comes after vertex `v` of a triangle that has both
inline bool goes_along(const std::vector<std::size_t>& triangle, const std::size_t v, const std::size_t w)
{
  const std::size_t i = std::find(triangle.begin(), triangle.end(), v) - triangle.begin();
  return triangle[(i + 1) % 3] == w;
}

// Makes one of triangles with the same vertices, the first one, and keeps account of them. A fold is nothing then, if
// both its sides are the same, but two bodies that touch have opposite sides, too: so the one triangle stays for now.
template <typename Point>
void unite_equal_triangles(Triangle_soup<Point>& soup)
{
  std::map<std::array<std::size_t, 3>, std::size_t> positions;
  std::vector<Sourced_triangle> united;
  for(const Sourced_triangle& t : soup.triangles)
  {
    std::array<std::size_t, 3> key = {{ t[0], t[1], t[2] }};
    std::sort(key.begin(), key.end());
    const auto inserted = positions.emplace(key, united.size());
    if(inserted.second)
    {
      united.push_back(t);
      continue;
    }
    Sourced_triangle& first = united[inserted.first->second];
    first.weight += goes_along(first, t[0], t[1]) ? t.weight : -t.weight;
    first.is_odd = first.is_odd != t.is_odd;
  }
  soup.triangles.swap(united);
}

// an edge of a triangle, the number of that triangle, and its third vertex
struct Triangle_edge
{
  Vertex_numbers vertices;
  std::size_t triangle;
  std::size_t opposite;
};

typedef Triangle_edge Open_edge; // one that no other triangle has

// the edges of all triangles in the order of their vertices; a triangle is a vector or array of three vertices
template <typename Triangle>
std::vector<Triangle_edge> sorted_edges(const std::vector<Triangle>& triangles)
{
  std::vector<Triangle_edge> edges;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(int i = 0; i < 3; ++i)
      edges.push_back(Triangle_edge{ edge_of(triangles[t], i), t, triangles[t][i] });
  std::stable_sort(edges.begin(), edges.end(), [](const Triangle_edge& e, const Triangle_edge& f)
                   { return e.vertices < f.vertices; });
  return edges;
}

// calls `visit` with the first one of each set of equal edges, and how many they are
template <typename Triangle, typename Visit>
void visit_edges(const std::vector<Triangle>& triangles, const Visit& visit)
{
  const std::vector<Triangle_edge> edges = sorted_edges(triangles);
  for(auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end)
  {
    end = std::find_if(begin, edges.end(), [&](const Triangle_edge& e) { return e.vertices != begin->vertices; });
    visit(begin, static_cast<std::size_t>(end - begin));
  }
}

template <typename Triangle>
std::vector<Open_edge> open_edges(const std::vector<Triangle>& triangles)
{
  std::vector<Open_edge> result;
  visit_edges(triangles, [&](const auto edge, const std::size_t number)
  {
    if(number == 1)
      result.push_back(*edge);
  });
  return result;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H
