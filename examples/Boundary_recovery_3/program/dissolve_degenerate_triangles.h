#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DISSOLVE_DEGENERATE_TRIANGLES_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DISSOLVE_DEGENERATE_TRIANGLES_H

#include "triangle_soup.h"

#include <CGAL/Kernel_traits.h>

#include <cstddef>
#include <map>
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
  std::map<Vertex_numbers, std::size_t> m_middle; // of longest edges of degenerate triangles: the vertex on it
  std::vector<std::size_t> m_dissolved;           // the sources of the degenerate triangles, in their order

public:
  explicit Degenerate_triangle_dissolver(Triangle_soup<Point>& soup) : m_soup(soup) { }

  // returns the sources of those that are gone
  std::vector<std::size_t> operator()()
  {
    drop_repeated_vertices(true);
    while(find_longest_edges())
    {
      std::vector<Sourced_triangle> divided;
      for(const Sourced_triangle& t : m_soup.triangles)
        divide(t, divided);
      m_soup.triangles.swap(divided);
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
    m_middle.clear();
    for(const Sourced_triangle& t : m_soup.triangles)
    {
      const int i = middle_vertex(t);
      if(i < 0)
        continue;
      m_middle.emplace(edge_of(t, i), t[i]);
      m_dissolved.push_back(t.source);
    }
    return ! m_middle.empty();
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

  // Appends the parts of a triangle. A degenerate one is divided at its own vertex first, and has no part left.
  void divide(const Sourced_triangle& triangle, std::vector<Sourced_triangle>& parts) const
  {
    std::vector<Sourced_triangle> open(1, triangle);
    while(! open.empty())
    {
      const Sourced_triangle t = open.back();
      open.pop_back();
      const int i = t.has_repeated_vertex() ? -1 : edge_to_divide(t);
      if(i < 0)
      {
        parts.push_back(t);
        continue;
      }
      const std::size_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], m = m_middle.at(edge_of(t, i));
      open.push_back(Sourced_triangle({{ a, m, c }}, t.source));
      open.push_back(Sourced_triangle({{ a, b, m }}, t.source));
    }
  }

  int edge_to_divide(const Sourced_triangle& t) const
  {
    int found = -1;
    for(int i = 0; i < 3; ++i)
    {
      const auto it = m_middle.find(edge_of(t, i));
      if(it != m_middle.end() && it->second == t[i])
        return i;
      if(it != m_middle.end())
        found = i;
    }
    return found;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DISSOLVE_DEGENERATE_TRIANGLES_H
