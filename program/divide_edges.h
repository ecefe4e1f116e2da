#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_EDGES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_EDGES_H

#include "triangle_soup.h"

#include <cstddef>
#include <map>
#include <vector>

typedef std::map<Vertex_numbers, std::size_t> Middle_vertices; // of edges

// the position of the vertex opposite to an edge that is to be divided, or -1: if it is the middle one itself, that is
// the right edge of a triangle without area
inline int edge_to_divide(const Sourced_triangle& t, const Middle_vertices& middles)
{
  int found = -1;
  for(int i = 0; i < 3; ++i)
  {
    const auto it = middles.find(edge_of(t, i));
    if(it != middles.end() && it->second == t[i])
      return i;
    if(it != middles.end())
      found = i;
  }
  return found;
}

// Divides all the triangles that have one of the edges, there and where their parts have one. The middle vertex of an
// edge must be such that both parts are shorter. A triangle without area leaves parts with a repeated vertex.
template <typename Point>
void divide_edges(Triangle_soup<Point>& soup, const Middle_vertices& middles)
{
  std::vector<Sourced_triangle> done, open;
  for(const Sourced_triangle& triangle : soup.triangles)
    for(open.push_back(triangle); ! open.empty();)
    {
      const Sourced_triangle t = open.back();
      open.pop_back();
      const int i = t.has_repeated_vertex() ? -1 : edge_to_divide(t, middles);
      if(i < 0)
      {
        done.push_back(t);
        continue;
      }
      const std::size_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], m = middles.at(edge_of(t, i));
      open.push_back(Sourced_triangle({{ a, m, c }}, t.source));
      open.push_back(Sourced_triangle({{ a, b, m }}, t.source));
    }
  soup.triangles.swap(done);
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_EDGES_H
