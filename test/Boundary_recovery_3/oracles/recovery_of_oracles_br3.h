// The recovery in Delaunay triangulations with both kernels: what includes this is linked to oracles_br3, and does not
// compile it again.

#ifndef BR3_TEST_RECOVERY_OF_ORACLES_H
#define BR3_TEST_RECOVERY_OF_ORACLES_H

#include <CGAL/Boundary_recovery_3/internal/input/Recover_indexed_boundary.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace br3_test {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Inexact_kernel;
typedef CGAL::Delaunay_triangulation_3<Inexact_kernel>      Inexact_delaunay;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact_kernel;
typedef CGAL::Delaunay_triangulation_3<Exact_kernel>        Exact_delaunay;

} // namespace br3_test

namespace CGAL::Boundary_recovery_3::internal {

#ifndef CGAL_BOUNDARY_RECOVERY_3_COMPILED // which has this

extern template Boundary_recovery_result_3<br3_test::Inexact_delaunay>
Recover_indexed_boundary<br3_test::Inexact_delaunay, br3_test::Inexact_kernel>::operator()(
  std::vector<br3_test::Inexact_delaunay::Vertex_handle>);

#endif

#ifndef BR3_TEST_EPICK_ONLY

extern template Boundary_recovery_result_3<br3_test::Exact_delaunay>
Recover_indexed_boundary<br3_test::Exact_delaunay, br3_test::Exact_kernel>::operator()(
  std::vector<br3_test::Exact_delaunay::Vertex_handle>);

#endif

} // namespace CGAL::Boundary_recovery_3::internal

#endif // BR3_TEST_RECOVERY_OF_ORACLES_H
