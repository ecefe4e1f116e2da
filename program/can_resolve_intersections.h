#ifndef BOUNDARY_RECOVERY_3_PROGRAM_CAN_RESOLVE_INTERSECTIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_CAN_RESOLVE_INTERSECTIONS_H

#include <CGAL/version.h>

// CGAL::Polygon_mesh_processing::autorefine_triangle_soup() came with CGAL 6.0.
#if CGAL_VERSION_NR >= 1060000000 && __has_include(<CGAL/Polygon_mesh_processing/autorefinement.h>)
#define BOUNDARY_RECOVERY_3_PROGRAM_HAS_AUTOREFINEMENT
constexpr bool can_resolve_intersections = true;
#else
constexpr bool can_resolve_intersections = false;
#endif

#endif // BOUNDARY_RECOVERY_3_PROGRAM_CAN_RESOLVE_INTERSECTIONS_H
