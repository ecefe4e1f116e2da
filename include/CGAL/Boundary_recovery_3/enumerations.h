// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_ENUMERATIONS_H
#define CGAL_BOUNDARY_RECOVERY_3_ENUMERATIONS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <ostream>

namespace CGAL::Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// how far `CGAL::recover_boundary()` goes to recover a constraint.
enum class Recovery_mode
{
  constrained, ///< every constraint becomes one simplex of the triangulation; Steiner points are off the constraints
  conforming,  ///< Steiner points stay on the constraints, which become unions of simplices. A Steiner point of the
               ///< phase `planar_edge_recovery` may be left off the constraints
  flips_only   ///< no points are left. Where a few edges stay lost, and beside planes, see the phase
               ///< `planar_edge_recovery`, Steiner points are tried; all changes are taken back unless all these points
               ///< can be removed again
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of a mode, as it is spelled in the enumeration.
inline const char* to_string(const Recovery_mode value)
{
  switch(value)
  {
    case Recovery_mode::constrained: return "constrained";
    case Recovery_mode::conforming:  return "conforming";
    case Recovery_mode::flips_only:  return "flips_only";
  }
  return "";
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the name of a mode.
inline std::ostream& operator<<(std::ostream& os, const Recovery_mode value) { return os << to_string(value); }

/// \ingroup PkgBoundaryRecovery3Classes
/// what a boundary recovery gives up: time, or Steiner points. The recovered constraints do not depend on the effort,
/// and the mode `flips_only`, which leaves no points, does not depend on it at all.
enum class Recovery_effort
{
  more_time,  ///< time is given up: everything is tried to need few points, and to leave few
  more_points ///< points are given up: work that takes much time to save the last few points is left out
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of an effort, as it is spelled in the enumeration.
inline const char* to_string(const Recovery_effort value)
{
  switch(value)
  {
    case Recovery_effort::more_time:   return "more_time";
    case Recovery_effort::more_points: return "more_points";
  }
  return "";
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the name of an effort.
inline std::ostream& operator<<(std::ostream& os, const Recovery_effort value) { return os << to_string(value); }

/// \ingroup PkgBoundaryRecovery3Classes
/// how a boundary recovery ended.
enum class Recovery_status
{
  recovered,     ///< every constraint is in the triangulation (mode `conforming`: as a union of simplices)
  incomplete,    ///< some constraints are missing; they are listed. In the modes with points, a point that is needed
                 ///< has a position that cannot be represented. The triangulation is as the flips left it, and its only
                 ///< Steiner points are those of the phase `planar_edge_recovery`, if any
  invalid_input, ///< no method can recover the input; its defects are listed. If intersections were found after flips
                 ///< only, Steiner points of the phase `planar_edge_recovery` may be in the triangulation
  stopped        ///< the visitor or the time limit ended the recovery early; missing constraints are listed. The only
                 ///< Steiner points in the triangulation are those of the phase `planar_edge_recovery`, if any
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of a status, as it is spelled in the enumeration.
inline const char* to_string(const Recovery_status status)
{
  switch(status)
  {
    case Recovery_status::recovered:     return "recovered";
    case Recovery_status::incomplete:    return "incomplete";
    case Recovery_status::invalid_input: return "invalid_input";
    case Recovery_status::stopped:       return "stopped";
  }
  return "";
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the name of a status.
inline std::ostream& operator<<(std::ostream& os, const Recovery_status value) { return os << to_string(value); }

/// \ingroup PkgBoundaryRecovery3Classes
/// the phases of the work, in the order of their first run: of a boundary recovery, from `insertion` to `recount`, by
/// the names of [CZZ+17, Section 4]; of the meshing, from `domain_marking` to `quality_improvement`; of the remeshing
/// of holes, from `hole_selection` to `hole_sewing`.
enum class Phase
{
  insertion,                  ///< surface points that the triangulation lacks are inserted
  search,                     ///< the constraints that the triangulation lacks are searched
  planar_edge_recovery,       ///< lost edges that cross many mesh edges in a plane are recovered by Steiner points
                              ///< close to the plane, which are removed again where possible
  plain_removal,              ///< stars of ends, and complete removals of single shells
  edge_recovery_brc1,         ///< first calling of [CZZ+17, Alg.\ 5]: lost edges, under BRC1
  edge_recovery_brc3,         ///< second calling of [CZZ+17, Alg.\ 5]: intersections of lost edges, under BRC3
  edge_reconnection,          ///< small polyhedron reconnection of the cells around each lost edge
  facet_recovery_brc2,        ///< first calling for facets, under BRC2
  facet_recovery_brc4,        ///< second calling for facets, under BRC4
  facet_reconnection,         ///< small polyhedron reconnection of the cells around each lost facet
  conforming_edge_recovery,   ///< Steiner points are put on lost edges, or beside them, where many edges of no facet
                              ///< are lost
  conforming_facet_recovery,  ///< Steiner points are put on lost facets
  steiner_splitting,          ///< Steiner points come off the constraints [CZZ+17, Alg.\ A.1 to A.5]
  steiner_suppression,        ///< Steiner points are removed [CZZ+17, Section 4.3]
  recount,                    ///< if any constraint was lost, all constraints are looked up again; only this decides on
                              ///< the status

  domain_marking,             ///< step 5: regions and the outside are marked
  forecast,                   ///< the number of cells is estimated from the size field
  decomposition,              ///< the domain is divided into sub-domains, if they are asked for
  field_point_insertion,      ///< step 6: field points are inserted
  quality_improvement,        ///< step 7: the quality is improved

  hole_selection,             ///< the input is checked, and cells to replace are searched
  hole_recovery,              ///< the boundary of each hole is recovered; holes grow until their boundaries are valid
                              ///< surfaces
  hole_filling,               ///< field points are inserted
  hole_improvement,           ///< the quality of new cells is improved
  hole_sewing                 ///< old and new cells are put together, and new vertices are located in the old mesh
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of a phase, as it is spelled in the enumeration.
inline const char* to_string(const Phase phase)
{
  switch(phase)
  {
    case Phase::insertion:                 return "insertion";
    case Phase::search:                    return "search";
    case Phase::planar_edge_recovery:      return "planar_edge_recovery";
    case Phase::plain_removal:             return "plain_removal";
    case Phase::edge_recovery_brc1:        return "edge_recovery_brc1";
    case Phase::edge_recovery_brc3:        return "edge_recovery_brc3";
    case Phase::edge_reconnection:         return "edge_reconnection";
    case Phase::facet_recovery_brc2:       return "facet_recovery_brc2";
    case Phase::facet_recovery_brc4:       return "facet_recovery_brc4";
    case Phase::facet_reconnection:        return "facet_reconnection";
    case Phase::conforming_edge_recovery:  return "conforming_edge_recovery";
    case Phase::conforming_facet_recovery: return "conforming_facet_recovery";
    case Phase::steiner_splitting:         return "steiner_splitting";
    case Phase::steiner_suppression:       return "steiner_suppression";
    case Phase::recount:                   return "recount";
    case Phase::domain_marking:            return "domain_marking";
    case Phase::forecast:                  return "forecast";
    case Phase::decomposition:             return "decomposition";
    case Phase::field_point_insertion:     return "field_point_insertion";
    case Phase::quality_improvement:       return "quality_improvement";
    case Phase::hole_selection:            return "hole_selection";
    case Phase::hole_recovery:             return "hole_recovery";
    case Phase::hole_filling:              return "hole_filling";
    case Phase::hole_improvement:          return "hole_improvement";
    case Phase::hole_sewing:               return "hole_sewing";
  }
  return "";
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the name of a phase.
inline std::ostream& operator<<(std::ostream& os, const Phase value) { return os << to_string(value); }

namespace internal {

// The phases of a recovery come first.
inline bool is_of_recovery(const Phase phase) { return phase <= Phase::recount; }

} // namespace internal

/// \ingroup PkgBoundaryRecovery3Classes
/// the kinds of defects of an input.
enum class Input_defect_kind
{
  empty_input,              ///< no facet and no edge was given
  non_finite_coordinate,    ///< a vertex has a NaN or an infinite coordinate
  index_out_of_range,       ///< a facet or edge names a vertex that does not exist
  not_a_triangle,           ///< a face does not have three vertices
  unknown_vertex,           ///< a vertex handle is null, infinite, or of another triangulation; or a point is not a
                            ///< vertex of a triangulation that is not Delaunay, and so cannot be inserted
  degenerate_facet,         ///< the vertices of a facet are collinear, or not distinct
  degenerate_edge,          ///< both ends of a constrained edge are the same vertex
  duplicate_facet,          ///< two facets have the same three vertices
  coincident_vertices,      ///< two vertices of constraints are at one point
  dimension_less_than_3,    ///< all the points are coplanar
  intersecting_constraints, ///< two constraints intersect, not in a common vertex or edge; or a vertex is on the
                            ///< constraint of other vertices
  repeated_vertex,          ///< a tetrahedron of a mesh names a vertex twice
  nonmanifold_facet,        ///< more than two tetrahedra of a mesh have the same facet
  inconsistent_orientation, ///< by the order of their vertices, two tetrahedra of a mesh are on the same side of a
                            ///< common facet
  not_in_mesh,              ///< a constrained facet or edge is not a facet or edge of a tetrahedron of the mesh
  inverted_region           ///< the constrained facets that bound a region of a mesh do not have the region on the side
                            ///< where, by the order of the vertices, its tetrahedra are
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of a kind of defect, as it is spelled in the enumeration.
inline const char* to_string(const Input_defect_kind kind)
{
  switch(kind)
  {
    case Input_defect_kind::empty_input:              return "empty_input";
    case Input_defect_kind::non_finite_coordinate:    return "non_finite_coordinate";
    case Input_defect_kind::index_out_of_range:       return "index_out_of_range";
    case Input_defect_kind::not_a_triangle:           return "not_a_triangle";
    case Input_defect_kind::unknown_vertex:           return "unknown_vertex";
    case Input_defect_kind::degenerate_facet:         return "degenerate_facet";
    case Input_defect_kind::degenerate_edge:          return "degenerate_edge";
    case Input_defect_kind::duplicate_facet:          return "duplicate_facet";
    case Input_defect_kind::coincident_vertices:      return "coincident_vertices";
    case Input_defect_kind::dimension_less_than_3:    return "dimension_less_than_3";
    case Input_defect_kind::intersecting_constraints: return "intersecting_constraints";
    case Input_defect_kind::repeated_vertex:          return "repeated_vertex";
    case Input_defect_kind::nonmanifold_facet:        return "nonmanifold_facet";
    case Input_defect_kind::inconsistent_orientation: return "inconsistent_orientation";
    case Input_defect_kind::not_in_mesh:              return "not_in_mesh";
    case Input_defect_kind::inverted_region:          return "inverted_region";
  }
  return "";
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the name of a kind of defect.
inline std::ostream& operator<<(std::ostream& os, const Input_defect_kind value) { return os << to_string(value); }

/// \ingroup PkgBoundaryRecovery3Classes
/// the end of `CGAL::make_boundary_constrained_mesh_3()`, or of one of its steps.
enum class Meshing_status
{
  meshed,        ///< all is done
  no_region,     ///< the surface is in the triangulation, but bounds no region: there is nothing to mesh
  incomplete,    ///< constraints are missing; the result of the recovery lists them. Nothing was meshed
  invalid_input, ///< no method can recover the surface, or a size is not a positive number, or an angle is impossible;
                 ///< the result lists the errors
  too_large,     ///< the mesh would take more vertices, or more memory, than allowed; the forecast has the number. No
                 ///< field point was inserted, or, if the first forecast was too low, not more points than allowed
  stopped        ///< the visitor or the time limit ended the work early, with a valid mesh
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of a status, as it is spelled in the enumeration.
inline const char* to_string(const Meshing_status status)
{
  switch(status)
  {
    case Meshing_status::meshed:        return "meshed";
    case Meshing_status::no_region:     return "no_region";
    case Meshing_status::incomplete:    return "incomplete";
    case Meshing_status::invalid_input: return "invalid_input";
    case Meshing_status::too_large:     return "too_large";
    case Meshing_status::stopped:       return "stopped";
  }
  return "";
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the name of a status.
inline std::ostream& operator<<(std::ostream& os, const Meshing_status value) { return os << to_string(value); }

/// \ingroup PkgBoundaryRecovery3Classes
/// the work that the improvement of a mesh is worth. An operation is tried on bad cells of one kind as long as it
/// improves them at a sufficient rate. Work is counted, not timed, so the mesh does not depend on the machine.
enum class Improvement_effort
{
  low,    ///< the operations with the largest gain for the least work
  normal, ///< all operations that pay; on most smooth surfaces, all that is possible
  high    ///< forty times the credit, and a fortieth of the rate: for the last bad cells
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of an effort, as it is spelled in the enumeration.
inline const char* to_string(const Improvement_effort value)
{
  switch(value)
  {
    case Improvement_effort::low:    return "low";
    case Improvement_effort::normal: return "normal";
    case Improvement_effort::high:   return "high";
  }
  return "";
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the name of an effort.
inline std::ostream& operator<<(std::ostream& os, const Improvement_effort value) { return os << to_string(value); }

/// \ingroup PkgBoundaryRecovery3Classes
/// the reason of a dihedral angle below the target.
enum class Bad_cell_reason
{
  forced,      ///< the cell has this angle between two constrained facets that meet at less than the target: every mesh
               ///< with these facets has such a cell there
  gap,         ///< the cell has a constrained facet, or at least an edge of one, and another constrained facet without
               ///< a common edge is so near above it that no cell with all angles above the target fits in between, see
               ///< `Bad_cell_3::facets`
  needle,      ///< the cell has a constrained facet with a plane angle below the target and below twice the smallest
               ///< angle of the cell: only a cell as thin as this facet could do better
  not_improved ///< none of these: better cells may exist, but are hard to find beside a needle
};

/// \ingroup PkgBoundaryRecovery3Classes
/// returns the name of a reason, as it is spelled in the enumeration.
inline const char* to_string(const Bad_cell_reason reason)
{
  switch(reason)
  {
    case Bad_cell_reason::forced:       return "forced";
    case Bad_cell_reason::gap:          return "gap";
    case Bad_cell_reason::needle:       return "needle";
    case Bad_cell_reason::not_improved: return "not_improved";
  }
  return "";
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the name of a reason.
inline std::ostream& operator<<(std::ostream& os, const Bad_cell_reason value) { return os << to_string(value); }

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_ENUMERATIONS_H
