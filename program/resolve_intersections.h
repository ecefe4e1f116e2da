#ifndef BOUNDARY_RECOVERY_3_PROGRAM_RESOLVE_INTERSECTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_RESOLVE_INTERSECTIONS_H

#include "can_resolve_intersections.h"
#include "triangle_soup.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#ifdef BOUNDARY_RECOVERY_3_PROGRAM_HAS_AUTOREFINEMENT
#include <CGAL/Polygon_mesh_processing/autorefinement.h>

// Notes from which triangle each new one comes. CGAL copies visitors, so the list is elsewhere.
struct Refinement_visitor
  : public CGAL::Polygon_mesh_processing::Autorefinement::Default_visitor
{
  std::vector<std::size_t>* origins;

  explicit Refinement_visitor(std::vector<std::size_t>& origins) : origins(&origins) { }

  void number_of_output_triangles(const std::size_t n) { origins->assign(n, 0); }
  void verbatim_triangle_copy(const std::size_t target, const std::size_t origin) { (*origins)[target] = origin; }
  void new_subtriangle(const std::size_t target, const std::size_t origin) { (*origins)[target] = origin; }
};

// divides triangles where they intersect; the points there are exact, and rounded in the end. By that, triangles may
// intersect again, hardly more than touch.
template <typename Point>
void resolve_intersections(Triangle_soup<Point>& soup)
{
  std::vector<std::array<std::size_t, 3> > triangles;
  for(const Sourced_triangle& t : soup.triangles)
    triangles.push_back({{ t[0], t[1], t[2] }});
  std::vector<std::size_t> origins;
  CGAL::Polygon_mesh_processing::autorefine_triangle_soup(
    soup.points, triangles, CGAL::parameters::visitor(Refinement_visitor(origins)));

  std::vector<Sourced_triangle> refined;
  for(std::size_t i = 0; i < triangles.size(); ++i)
  {
    refined.push_back(soup.triangles[origins[i]]);
    std::copy(triangles[i].begin(), triangles[i].end(), refined.back().begin());
  }
  soup.triangles.swap(refined);
}

#else

template <typename Point>
void resolve_intersections(Triangle_soup<Point>&)
{ }

#endif // BOUNDARY_RECOVERY_3_PROGRAM_HAS_AUTOREFINEMENT

#endif // BOUNDARY_RECOVERY_3_PROGRAM_RESOLVE_INTERSECTIONS_H
