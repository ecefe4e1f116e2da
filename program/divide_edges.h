#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_EDGES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_EDGES_H

#include "triangle_soup.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

typedef std::map<Vertex_numbers, std::size_t> Middle_vertices; // of edges

// What a triangle is divided into.
struct Triangle_part
{
  Sourced_triangle triangle;
  std::array<bool, 3> is_edge_inner; // whether the edge opposite to each vertex is inside of the triangle, and so is no
                                     // part of its edges

  // The position of the vertex opposite to an edge that is to be divided, or -1: if it is the middle one itself, that
  // is the right edge of a triangle without area.
  int edge_to_divide(const Middle_vertices& middles) const
  {
    int found = -1;
    for(int i = 0; i < 3; ++i)
    {
      const auto it = is_edge_inner[i] ? middles.end() : middles.find(edge_of(triangle, i));
      if(it != middles.end() && it->second == triangle[i])
        return i;
      if(it != middles.end())
        found = i;
    }
    return found;
  }
};

// Divides all the triangles that have one of the edges, there and where parts of their edges are to be divided. The
// middle vertex of an edge must be such that both parts are shorter. Edges that the division makes inside of a triangle
// are not divided, even where other triangles have the same edge: that could lead back to a triangle that was there
// before, without end. A triangle without area leaves parts with a repeated vertex.
template <typename Point>
void divide_edges(Triangle_soup<Point>& soup, const Middle_vertices& middles)
{
  std::vector<Sourced_triangle> done;
  std::vector<Triangle_part> open;
  for(const Sourced_triangle& triangle : soup.triangles)
    for(open.push_back({ triangle, {{ false, false, false }} }); ! open.empty();)
    {
      const Triangle_part part = open.back();
      const Sourced_triangle& t = part.triangle;
      open.pop_back();
      const int i = t.has_repeated_vertex() ? -1 : part.edge_to_divide(middles);
      if(i < 0)
      {
        done.push_back(t);
        continue;
      }
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const std::size_t middle = middles.at(edge_of(t, i));
      Triangle_part first = part, second = part;
      first.triangle[k] = second.triangle[j] = middle;
      first.is_edge_inner[j] = second.is_edge_inner[k] = true;
      open.push_back(second);
      open.push_back(first);
    }
  soup.triangles.swap(done);
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DIVIDE_EDGES_H
