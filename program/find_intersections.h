#ifndef BOUNDARY_RECOVERY_3_PROGRAM_FIND_INTERSECTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_FIND_INTERSECTIONS_H

#include "triangle_soup.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

// Ends the recovery as soon as the input is diagnosed.
struct Diagnosis_visitor
  : public CGAL::Default_meshing_visitor_3
{
  bool is_diagnosed = false;

  void on_phase_begin(const CGAL::Boundary_recovery_3::Phase) { is_diagnosed = true; }
  bool go_further() const { return ! is_diagnosed; }
};

// what makes `recover_boundary()` refuse points and triangles
template <typename Point, typename TriangleRange>
auto diagnose(const std::vector<Point>& points, const TriangleRange& triangles)
{
  // that of `mesh_surface`, which has its recovery anyway
  typedef typename CGAL::Kernel_traits<Point>::Kernel                            Kernel;
  typedef typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
  Triangulation tr;
  Diagnosis_visitor visitor;
  return CGAL::recover_boundary(tr, points, triangles, CGAL::parameters::visitor(std::ref(visitor)),
                                CGAL::parameters::list_defects(true));
}

// finds the pairs of triangles that intersect elsewhere than in a common vertex or edge: those that would make
// `recover_boundary()` refuse the soup, which must be free of other defects
template <typename Point>
class Intersection_finder
{
  decltype(diagnose(std::vector<Point>(), std::vector<Sourced_triangle>())) m_result;

public:
  explicit Intersection_finder(const Triangle_soup<Point>& soup) : m_result(diagnose(soup.points, soup.triangles)) { }

  // a lower bound if it is larger than the number of defects that are listed by default
  std::size_t number_of_pairs() const { return m_result.number_of_defects; }

  // the positions of the triangles of each pair, the smaller one first, in ascending order
  std::vector<std::array<std::size_t, 2> > pairs() const
  {
    std::vector<std::array<std::size_t, 2> > result;
    for(const auto& defect : m_result.defects)
      if(defect.kind == CGAL::Boundary_recovery_3::Input_defect_kind::intersecting_constraints)
        result.push_back({{ defect.simplices[0].index, defect.simplices[1].index }});
    return result;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_FIND_INTERSECTIONS_H
