#ifndef BOUNDARY_RECOVERY_3_PROGRAM_COUNT_INTERSECTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_COUNT_INTERSECTIONS_H

#include "triangle_soup.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/recover_boundary.h>

#include <cstddef>
#include <functional>

// Ends the recovery as soon as the input is diagnosed.
struct Diagnosis_visitor
  : public CGAL::Default_meshing_visitor_3
{
  bool is_diagnosed = false;

  void on_phase_begin(const CGAL::Boundary_recovery_3::Phase) { is_diagnosed = true; }
  bool go_further() const { return ! is_diagnosed; }
};

// the number of pairs of triangles that intersect elsewhere than in a common vertex or edge: those that would make
// `recover_boundary()` refuse the soup, which must be free of other defects; a lower bound if it is larger than the
// number of defects that are listed by default
template <typename Point>
std::size_t number_of_intersections(const Triangle_soup<Point>& soup)
{
  // that of `mesh_surface`, which has its recovery anyway
  typedef typename CGAL::Kernel_traits<Point>::Kernel                            Kernel;
  typedef typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Triangulation;
  Triangulation tr;
  Diagnosis_visitor visitor;
  const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles,
                                             CGAL::parameters::visitor(std::ref(visitor)),
                                             CGAL::parameters::list_defects(true));
  return result.number_of_defects;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_COUNT_INTERSECTIONS_H
