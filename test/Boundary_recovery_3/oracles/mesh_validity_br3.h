// Whether a triangulation is valid, by its own means: is_valid() of CGAL 5.5 does not see inverted cells where
// assertions are off, and that of a Delaunay triangulation wants empty spheres.

#ifndef BR3_TEST_MESH_VALIDITY_H
#define BR3_TEST_MESH_VALIDITY_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/enum.h>

namespace br3_test {

template <typename Triangulation>
bool is_valid_mesh(const Triangulation& tr)
{
  for(const auto c : tr.finite_cell_handles())
    if(CGAL::orientation(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(), c->vertex(3)->point())
       != CGAL::POSITIVE)
      return false;
  return tr.tds().is_valid();
}

} // namespace br3_test

#endif // BR3_TEST_MESH_VALIDITY_H
