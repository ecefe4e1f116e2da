#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DISSOLVE_DEGENERATE_TRIANGLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DISSOLVE_DEGENERATE_TRIANGLES_H

#include "divide_edges.h"
#include "triangle_soup.h"

#include <CGAL/Kernel_traits.h>

#include <cstddef>
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
    drop_repeated_vertices(true);
    while(find_longest_edges())
    {
      divide_edges(m_soup, m_middles); // what has no area is divided at its own vertex
      drop_repeated_vertices(false); // parts only
    }
    return m_dissolved;
  }

private:
  void drop_repeated_vertices(const bool is_listed)
  {
    std::vector<Sourced_triangle> kept;
    for(const Sourced_triangle& t : m_soup.triangles)
      if(! t.has_repeated_vertex())
        kept.push_back(t);
      else if(is_listed)
        m_dissolved.push_back(t.source);
    m_soup.triangles.swap(kept);
  }

  // Each division makes the longest edges of what is left of the degenerate triangles shorter, so there is an end.
  bool find_longest_edges()
  {
    m_middles.clear();
    for(const Sourced_triangle& t : m_soup.triangles)
    {
      const int i = middle_vertex(t);
      if(i < 0)
        continue;
      m_middles.emplace(edge_of(t, i), t[i]);
      m_dissolved.push_back(t.source);
    }
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
