#ifndef BOUNDARY_RECOVERY_3_PROGRAM_FILL_LOOP_H
#define BOUNDARY_RECOVERY_3_PROGRAM_FILL_LOOP_H

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

// Triangles between the vertices of a closed loop that fill it, turned as the loop is, by CGAL's hole filling: flat
// loops as polygons, others such that they go on as the triangles beside do. `opposite` has the third vertices of
// these, one for each edge, or none. Empty if no way is found.
template <typename Point>
std::vector<std::array<std::size_t, 3> > fill_loop(const std::vector<Point>& points,
                                                   const std::vector<std::size_t>& loop,
                                                   const std::vector<Point>& opposite = std::vector<Point>())
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  static constexpr std::size_t max_size_for_cubic_algorithm = 200; // vertices
  const auto parameters = CGAL::parameters::use_2d_constrained_delaunay_triangulation(true)
                            .do_not_use_cubic_algorithm(loop.size() > max_size_for_cubic_algorithm);
  std::vector<Point> polyline;
  for(const std::size_t v : loop)
    polyline.push_back(points[v]);
  std::vector<CGAL::Triple<int, int, int> > triangles;
  if(opposite.empty())
    PMP::triangulate_hole_polyline(polyline, std::back_inserter(triangles), parameters);
  else
    PMP::triangulate_hole_polyline(polyline, opposite, std::back_inserter(triangles), parameters);
  std::vector<std::array<std::size_t, 3> > result;
  for(const auto& t : triangles)
  {
    std::array<int, 3> i = {{ t.first, t.second, t.third }};
    std::sort(i.begin(), i.end());
    result.push_back({{ loop[i[0]], loop[i[1]], loop[i[2]] }});
  }
  return result;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_FILL_LOOP_H
