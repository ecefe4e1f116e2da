#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// A triangle that knows of which face of the input it is a part, or the whole of it. The functions of the package
// Polygon Mesh Processing take it for a polygon: when they exchange polygons, the number goes with them.
struct Sourced_triangle
  : public std::vector<std::size_t>
{
  std::size_t source = 0;

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

typedef std::pair<std::size_t, std::size_t> Vertex_numbers; // those of an edge, the smaller one first

inline Vertex_numbers edge_of(const Sourced_triangle& t, const int i)
{
  return std::minmax(t[(i + 1) % 3], t[(i + 2) % 3]);
}

// an edge that only one triangle has, and the third vertex of that triangle
struct Open_edge
{
  Vertex_numbers vertices;
  std::size_t opposite;
};

template <typename Point>
std::vector<Open_edge> open_edges(const Triangle_soup<Point>& soup)
{
  std::map<Vertex_numbers, std::vector<std::size_t> > opposite;
  for(const Sourced_triangle& t : soup.triangles)
    for(int i = 0; i < 3; ++i)
      opposite[edge_of(t, i)].push_back(t[i]);
  std::vector<Open_edge> result;
  for(const auto& edge : opposite)
    if(edge.second.size() == 1)
      result.push_back(Open_edge{ edge.first, edge.second[0] });
  return result;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H
