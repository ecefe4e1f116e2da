#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DISSOLVE_DEGENERATE_TRIANGLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DISSOLVE_DEGENERATE_TRIANGLES_H

#include "divide_edges.h"
#include "triangle_soup.h"

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

// Takes the triangles without area out of a soup, and leaves no gap. If the vertices of such a triangle are distinct,
// one of them is on the edge between the other two. Where this edge is one of other triangles, too, these are divided
// there, which changes nothing of the surface: predicates are exact, and no point is new. (The function
// remove_degenerate_faces() of the package Polygon Mesh Processing does the like by flips, in manifold meshes only, and
// does not tell where triangles come from.)
template <typename Point>
class Degenerate_triangle_dissolver
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel Kernel;

  Triangle_soup<Point>& m_soup;
  Middle_vertices m_middles;            // of longest edges of degenerate triangles: the vertex on it
  std::vector<std::size_t> m_dissolved; // the sources of the degenerate triangles, in their order

public:
  explicit Degenerate_triangle_dissolver(Triangle_soup<Point>& soup) : m_soup(soup) { }

  // returns the sources of those that are gone
  std::vector<std::size_t> operator()()
  {
    m_dissolved = drop_repeated_vertices(m_soup);
    while(find_longest_edges())
    {
      divide_edges(m_soup, m_middles); // what has no area is divided at its own vertex
      drop_repeated_vertices(m_soup);  // parts only
    }
    return m_dissolved;
  }

private:
  // The longest edge of each degenerate triangle, unless it is a part of a longer one, which comes first: else parts of
  // a triangle could be divided where others are not, and gaps be left. Each division makes the longest edges of what
  // is left of the degenerate triangles shorter, so there is an end.
  bool find_longest_edges()
  {
    m_middles.clear();
    std::vector<std::pair<const Sourced_triangle*, int> > degenerate;
    for(const Sourced_triangle& t : m_soup.triangles)
      if(const int i = middle_vertex(t); i >= 0)
      {
        degenerate.emplace_back(&t, i);
        m_middles.emplace(edge_of(t, i), t[i]);
        m_dissolved.push_back(t.source);
      }
    std::set<Vertex_numbers> shorter;
    for(const auto& [t, i] : degenerate)
      for(const std::size_t v : { (*t)[i], m_middles.at(edge_of(*t, i)) })
        for(const int k : { (i + 1) % 3, (i + 2) % 3 })
          shorter.insert(std::minmax((*t)[k], v));
    for(const Vertex_numbers& edge : shorter)
      m_middles.erase(edge);
    return ! m_middles.empty();
  }

  // the position of the vertex that is between the other two, or -1 if the triangle has an area
  int middle_vertex(const Sourced_triangle& t) const
  {
    const auto point = [&](const int i) -> const Point& { return m_soup.points[t[i % 3]]; };
    const Kernel kernel;
    if(! kernel.collinear_3_object()(point(0), point(1), point(2)))
      return -1;
    for(int i = 0; i < 2; ++i)
      if(kernel.collinear_are_ordered_along_line_3_object()(point(i + 1), point(i), point(i + 2)))
        return i;
    return 2;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DISSOLVE_DEGENERATE_TRIANGLES_H
