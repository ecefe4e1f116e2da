// What recovery_of_oracles_br3.h promises.

#include "recovery_of_oracles_br3.h"

namespace CGAL::Boundary_recovery_3::internal {

#ifndef CGAL_BOUNDARY_RECOVERY_3_COMPILED

template Boundary_recovery_result_3<br3_test::Inexact_delaunay>
Recover_indexed_boundary<br3_test::Inexact_delaunay, br3_test::Inexact_kernel>::operator()(
  std::vector<br3_test::Inexact_delaunay::Vertex_handle>);

#endif

#ifndef BR3_TEST_EPICK_ONLY

template Boundary_recovery_result_3<br3_test::Exact_delaunay>
Recover_indexed_boundary<br3_test::Exact_delaunay, br3_test::Exact_kernel>::operator()(
  std::vector<br3_test::Exact_delaunay::Vertex_handle>);

#endif

} // namespace CGAL::Boundary_recovery_3::internal
