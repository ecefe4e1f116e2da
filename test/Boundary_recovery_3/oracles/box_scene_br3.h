// A soup of boxes with the mesh that is made of it, and the exact volumes of its regions.

#ifndef BR3_TEST_BOX_SCENE_H
#define BR3_TEST_BOX_SCENE_H

#include "box_soup_br3.h"
#include "brute_force_checker_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>

#include <vector>

namespace br3_test {

template <typename Kernel>
struct Box_scene
{
  typedef typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Tr;
  typedef typename Kernel::Point_3                                              Point;
  typedef typename Tr::Vertex_handle                                            Vertex_handle;
  typedef typename Tr::Cell_handle                                              Cell_handle;
  typedef CGAL::Boundary_recovery_3::Boundary_constrained_mesh_result_3<Tr>     Result;

  explicit Box_scene(const Box_soup& soup) : soup(soup)
  {
    for(const auto& p : soup.points)
      points.emplace_back(p[0], p[1], p[2]);
  }

  // Six times the volume of a region.
  Rational volume(const int region) const
  {
    Rational sum = 0;
    for(const Cell_handle c : tr.finite_cell_handles())
      if(c->subdomain_index() == region)
        sum += br3_test::volume(to_rational(c->vertex(0)->point()), to_rational(c->vertex(1)->point()),
                                to_rational(c->vertex(2)->point()), to_rational(c->vertex(3)->point()));
    return sum;
  }

  const Box_soup soup;
  std::vector<Point> points;
  Tr tr;
  Result result;
};

} // namespace br3_test

#endif // BR3_TEST_BOX_SCENE_H
