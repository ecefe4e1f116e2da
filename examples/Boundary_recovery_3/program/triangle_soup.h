#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H

#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
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

// Ends the recovery as soon as the input is diagnosed.
struct Diagnosis_visitor
  : public CGAL::Default_boundary_recovery_visitor_3
{
  bool is_diagnosed = false;

  void on_phase_begin(const CGAL::Boundary_recovery_3::Recovery_phase) { is_diagnosed = true; }
  bool go_further() const { return ! is_diagnosed; }
};

// the number of pairs of triangles that intersect elsewhere than in a common vertex or edge: those that would make
// `recover_boundary()` refuse the soup, which must be free of other defects
template <typename Point>
std::size_t number_of_intersections(const Triangle_soup<Point>& soup)
{
  typedef CGAL::Delaunay_triangulation_3<typename CGAL::Kernel_traits<Point>::Kernel> Triangulation;
  Triangulation tr;
  Diagnosis_visitor visitor;
  const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles,
                                             CGAL::parameters::visitor(std::ref(visitor)),
                                             CGAL::parameters::list_defects(true));
  return static_cast<std::size_t>(std::count_if(result.defects.begin(), result.defects.end(), [](const auto& defect)
  { return defect.kind == CGAL::Boundary_recovery_3::Input_defect_kind::intersecting_constraints; }));
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TRIANGLE_SOUP_H
