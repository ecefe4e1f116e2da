// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_RECOVERY_RESULT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_RECOVERY_RESULT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// how far `CGAL::recover_boundary()` goes to recover a constraint.
enum class Recovery_mode
{
  constrained, ///< every constraint becomes one simplex of the triangulation; Steiner points only off the constraints
  conforming,  ///< Steiner points stay on the constraints, which become unions of simplices. A Steiner point of the
               ///< phase `planar_edge_recovery` may be left off the constraints
  flips_only   ///< no points: where a few edges stay lost, Steiner points are tried as a temporary means, and all is
               ///< taken back unless every one of them can be removed again; so are points beside planes, see the phase
               ///< `planar_edge_recovery`
};

/// \ingroup PkgBoundaryRecovery3Classes
/// what a boundary recovery may give up for the other: time, or Steiner points. The mode `flips_only`, where no point
/// may be left, and the constraints that are recovered are the same for all of them.
enum class Recovery_effort
{
  more_time,  ///< time is given up: all is tried so that few points are needed, and few of them are left
  more_points ///< points are given up: what needs much time for the last few of them is left out
};

/// \ingroup PkgBoundaryRecovery3Classes
/// how a boundary recovery ended.
enum class Recovery_status
{
  recovered,     ///< every constraint is in the triangulation (mode `conforming`: as a union of simplices)
  incomplete,    ///< some constraints are missing; they are listed. In the modes with points, none could be represented
                 ///< where it would have to be; the triangulation is as the flips left it. Of Steiner points, only
                 ///< those are in it that are left of the phase `planar_edge_recovery`, if any
  invalid_input, ///< the input cannot be recovered by anybody; its defects are listed. If intersections were found only
                 ///< after flips, Steiner points of the phase `planar_edge_recovery` may be in the triangulation
  stopped        ///< the visitor or the time limit ended the recovery early; what is missing then is listed. Of Steiner
                 ///< points, only those are in the triangulation that are left of the phase `planar_edge_recovery`, if
                 ///< any
};

/// \ingroup PkgBoundaryRecovery3Classes
/// the phases of a boundary recovery, in the order in which they run first and by the names of [CZZ+17, Section 4].
enum class Recovery_phase
{
  insertion,             ///< surface points that are not in the triangulation are inserted
  search,                ///< the constraints that the triangulation lacks are searched
  planar_edge_recovery,  ///< lost edges that cross many mesh edges in a plane, by Steiner points close to it that are
                         ///< removed again where possible
  plain_removal,         ///< complete removals of single shells, without recursion
  edge_recovery_brc1,    ///< first calling of [CZZ+17, Alg. 5]: lost edges, under BRC1
  edge_recovery_brc3,    ///< second calling of [CZZ+17, Alg. 5]: intersections of lost edges, under BRC3
  edge_reconnection,     ///< small polyhedron reconnection of the cells around each lost edge
  facet_recovery_brc2,   ///< first calling for facets, under BRC2
  facet_recovery_brc4,   ///< second calling for facets, under BRC4
  facet_reconnection,    ///< small polyhedron reconnection of the cells around each lost facet
  conforming_edge_recovery,  ///< Steiner points on lost edges, or beside them, where many edges of no facet are lost
  conforming_facet_recovery, ///< Steiner points on lost facets
  steiner_splitting,     ///< Steiner points come off the constraints [CZZ+17, Alg. A.1 to A.5]
  steiner_suppression,   ///< Steiner points are removed [CZZ+17, Section 4.3]
  recount                ///< if any was lost, every constraint is looked up again; only this decides the status
};

/// \ingroup PkgBoundaryRecovery3Classes
/// what can be wrong with an input.
enum class Input_defect_kind
{
  empty_input,              ///< no facet and no edge was given
  non_finite_coordinate,    ///< a vertex has a NaN or an infinite coordinate
  index_out_of_range,       ///< a facet or edge names a vertex that does not exist
  not_a_triangle,           ///< a face does not have three vertices
  unknown_vertex,           ///< a vertex handle is null, infinite, or not of the triangulation; or a point is no vertex
                            ///< of a triangulation that is not Delaunay, so it cannot be inserted
  degenerate_facet,         ///< the vertices of a facet are collinear, or not distinct
  degenerate_edge,          ///< both ends of a constrained edge are the same vertex
  duplicate_facet,          ///< two facets have the same three vertices
  coincident_vertices,      ///< two vertices of constraints are at one point
  dimension_less_than_3,    ///< all the points are coplanar
  intersecting_constraints, ///< two constraints intersect elsewhere than in a common vertex or edge, or a vertex is
                            ///< on a constraint that is not its own
  repeated_vertex,          ///< a tetrahedron of a mesh names a vertex twice
  nonmanifold_facet,        ///< more than two tetrahedra of a mesh have the same facet
  inconsistent_orientation, ///< two tetrahedra of a mesh are on the same side of a common facet, by the order of their
                            ///< vertices
  not_in_mesh,              ///< a constrained facet or edge of a mesh is none of its tetrahedra
  inverted_region           ///< the facets that bound a region of a mesh, and have to stay, do not have it on the side
                            ///< where its tetrahedra are by the order of their vertices
};

/// \ingroup PkgBoundaryRecovery3Classes
/// a vertex, edge or facet of the input, in the caller's own indices.
template <typename Point_3_>
struct Input_simplex_3
{
  typedef Point_3_ Point_3; ///< the point type

  /// value of `index` of an edge that was given as an edge of a facet only, and of a vertex that is in the
  /// triangulation but not in the input
  static constexpr std::size_t no_index = std::size_t(-1);

  int dimension = -1;                ///< 0: vertex, 1: edge, 2: facet, 3: tetrahedron
  std::size_t index = no_index;      ///< position of the vertex, constrained edge, facet or tetrahedron in its input
                                     ///< range
  std::vector<std::size_t> vertices; ///< the input indices of its vertices; none for a vertex without index
  std::vector<Point_3> points;       ///< the coordinates of its vertices; empty where an index has no finite point
};

/// \ingroup PkgBoundaryRecovery3Classes
/// one defect of the input, and the simplices that cause it: one or two, or none where it is in the input as a whole.
template <typename Point_3_>
struct Input_defect_3
{
  Input_defect_kind kind;                            ///< what is wrong
  std::vector<Input_simplex_3<Point_3_> > simplices; ///< with what
};

/// \ingroup PkgBoundaryRecovery3Classes
/// what was lost when a phase ended, and its duration.
struct Phase_report
{
  Recovery_phase phase;          ///< the phase
  std::size_t lost_edges = 0;    ///< number of constrained edges that are not in the triangulation
  std::size_t lost_facets = 0;   ///< number of constrained facets that are not in the triangulation
  double seconds = 0;            ///< duration in seconds (wall clock)
};

/// \ingroup PkgBoundaryRecovery3Classes
/// one row of the tables of [CZZ+17, Section 5.1.2]: the state after a pass with one maximal recursion level.
struct Recursion_level_report
{
  Recovery_phase phase;             ///< the calling
  int max_recursion_level = -1;     ///< the maximal recursion level of the pass; -1: before the first one
  std::size_t n1 = 0;               ///< number of lost edges (or facets)
  std::size_t n2 = 0;               ///< number of intersections of lost edges (facets) with mesh entities
  std::size_t n3 = 0;               ///< largest number of intersections of one lost edge (facet)
  std::size_t n4 = 0;               ///< number of mesh entities that are crossed, each counted once: the size of the
                                    ///< paper's hash table
};

/// \ingroup PkgBoundaryRecovery3Classes
/// a mesh edge or facet that is a part of a constraint. Mesh edges come one after the other, as they are on the
/// constrained edge; mesh facets come in any order, each in the orientation of the constrained facet.
template <typename Vertex_handle_, typename Point_3_>
struct Constraint_part_3
{
  std::vector<Vertex_handle_> vertices;    ///< its vertices: two or three
  Input_simplex_3<Point_3_> constraint;    ///< the constraint that it is a part of
};

/// \ingroup PkgBoundaryRecovery3Classes
/// a mesh facet of the surface: the array of its three vertices, in the orientation of the constrained facet that it is
/// or is a part of.
template <typename Vertex_handle_>
struct Surface_facet_3
  : public std::array<Vertex_handle_, 3>
{
  std::size_t index = 0; ///< position of the constrained facet in its input range
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief what `CGAL::recover_boundary()` did: the status, what is missing or wrong, and the counts of each phase.
 *
 * \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, or of a class derived from it
 */
template <typename Triangulation_>
struct Boundary_recovery_result_3
{
  typedef Triangulation_                              Triangulation;  ///< the triangulation type
  typedef typename Triangulation::Vertex_handle       Vertex_handle;  ///< its vertex handle
  typedef typename Triangulation::Geom_traits::Point_3 Point_3;       ///< its point type
  typedef Input_simplex_3<Point_3>                    Input_simplex;  ///< a simplex of the input
  typedef Input_defect_3<Point_3>                     Input_defect;   ///< a defect of the input
  typedef Constraint_part_3<Vertex_handle, Point_3>   Constraint_part; ///< a part of a constraint
  typedef std::array<Vertex_handle, 3>                Vertex_triple;  ///< the vertices of a facet
  typedef Surface_facet_3<Vertex_handle>              Surface_facet;  ///< a mesh facet of the surface

  /// how the recovery ended
  Recovery_status status = Recovery_status::incomplete;

  /// the vertex of the triangulation for each input vertex, by input index.
  /// Input vertices that no constraint uses have one, too. Empty if `status` is `invalid_input`.
  std::vector<Vertex_handle> vertices;

  /// the vertices of each constrained facet, by input index, in the orientation of the input.
  /// Facets that are missing have theirs, too; they are default handles where `vertices` has such. Empty if `status` is
  /// `invalid_input`.
  std::vector<Vertex_triple> facets;

  /// the constrained edges that are not in the triangulation
  std::vector<Input_simplex> missing_edges;

  /// the constrained facets that are not in the triangulation
  std::vector<Input_simplex> missing_facets;

  /// the constraints for which a Steiner point was needed, on them or beside them, whose position the number type of
  /// the kernel cannot store, in the last attempt: the edges, then the facets. Not empty only if `status` is
  /// `incomplete` and the mode is not `flips_only`.
  std::vector<Input_simplex> unrepresentable_constraints;

  /// what is wrong with the input, if `status` is `invalid_input`; the first ones if there are more than the named
  /// parameter `maximum_number_of_defects`
  std::vector<Input_defect> defects;

  /// number of defects; larger than that of the listed ones iff there are more, and then, of pairs of constraints that
  /// intersect, there are at least so many
  std::size_t number_of_defects = 0;

  /// the mesh edges that constrained edges with Steiner points on them consist of (mode `conforming` only); constrained
  /// edges that are not named here are single mesh edges, unless they are missing
  std::vector<Constraint_part> parts_of_edges;

  /// the mesh facets that constrained facets with Steiner points on them consist of (mode `conforming` only);
  /// constrained facets that are not named here are single mesh facets, unless they are missing
  std::vector<Constraint_part> parts_of_facets;

  /// the Steiner points that are left in the triangulation, those outside of the domain included
  std::vector<Vertex_handle> steiner_vertices;

  std::size_t number_of_edges = 0;             ///< number of constrained edges, those of the facets included (of
                                               ///< faces that are no triangles, none)
  std::size_t number_of_facets = 0;            ///< number of constrained facets
  std::size_t number_of_constraint_points = 0; ///< number of Steiner points that were put on constraints
  std::size_t number_of_steiner_points = 0;    ///< number of Steiner points that came off the constraints in their
                                               ///< place (none in the mode `conforming`), and of those of the phase
                                               ///< `planar_edge_recovery`, in all modes; those that were removed later
                                               ///< included
  std::size_t number_of_inserted_vertices = 0; ///< number of input points that were not in the triangulation before
  std::size_t number_of_shell_transformations = 0; ///< number of replacements of cells by flips and reconnections,
                                                   ///< those that were taken back included

  std::vector<Phase_report> phases;           ///< one entry for each run of a phase; those with Steiner points run
                                              ///< again if other points have to be tried, up to six times
  std::vector<Recursion_level_report> levels; ///< one entry for each pass of [CZZ+17, Alg. 5]

  /// returns the mesh facets that the surface consists of, in the order of the constrained facets: such a facet
  /// itself, its parts if there are Steiner points on it (mode `conforming` only), or nothing if it is missing.
  /// `label_regions()` and `CGAL::recover_boundary()` take them as they are.
  std::vector<Surface_facet> surface_facets() const
  {
    std::vector<Surface_facet> result;
    if(facets.empty()) // of invalid input, facets may be listed as missing
      return result;
    std::vector<bool> is_whole(facets.size(), true);
    for(const Input_simplex& facet : missing_facets)
      is_whole[facet.index] = false;
    for(const Constraint_part& part : parts_of_facets)
    {
      is_whole[part.constraint.index] = false;
      result.push_back({ {{ part.vertices[0], part.vertices[1], part.vertices[2] }}, part.constraint.index });
    }
    for(std::size_t f = 0; f < facets.size(); ++f)
      if(is_whole[f])
        result.push_back({ facets[f], f });
    std::stable_sort(result.begin(), result.end(),
                     [](const Surface_facet& f, const Surface_facet& g) { return f.index < g.index; });
    return result;
  }

  /// returns `true` iff every constraint is in the triangulation.
  explicit operator bool() const { return status == Recovery_status::recovered; }
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
/// returns the name of a phase, as it is spelled in the enumeration.
inline const char* to_string(const Recovery_phase phase)
{
  switch(phase)
  {
    case Recovery_phase::insertion:           return "insertion";
    case Recovery_phase::search:              return "search";
    case Recovery_phase::planar_edge_recovery: return "planar_edge_recovery";
    case Recovery_phase::plain_removal:       return "plain_removal";
    case Recovery_phase::edge_recovery_brc1:  return "edge_recovery_brc1";
    case Recovery_phase::edge_recovery_brc3:  return "edge_recovery_brc3";
    case Recovery_phase::edge_reconnection:   return "edge_reconnection";
    case Recovery_phase::facet_recovery_brc2: return "facet_recovery_brc2";
    case Recovery_phase::facet_recovery_brc4: return "facet_recovery_brc4";
    case Recovery_phase::facet_reconnection:  return "facet_reconnection";
    case Recovery_phase::conforming_edge_recovery:  return "conforming_edge_recovery";
    case Recovery_phase::conforming_facet_recovery: return "conforming_facet_recovery";
    case Recovery_phase::steiner_splitting:   return "steiner_splitting";
    case Recovery_phase::steiner_suppression: return "steiner_suppression";
    case Recovery_phase::recount:             return "recount";
  }
  return "";
}

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
/// writes a simplex of the input: its kind, index, vertices and coordinates.
template <typename Point_3>
std::ostream& operator<<(std::ostream& os, const Input_simplex_3<Point_3>& simplex)
{
  static constexpr const char* names[] = { "vertex", "edge", "facet", "tetrahedron" };
  os << (simplex.dimension < 0 ? "nothing" : names[simplex.dimension]);
  if(simplex.index != Input_simplex_3<Point_3>::no_index)
    os << ' ' << simplex.index;
  if(simplex.dimension > 0)
  {
    os << " [";
    for(std::size_t i = 0; i < simplex.vertices.size(); ++i)
      os << (i == 0 ? "" : " ") << simplex.vertices[i];
    os << ']';
  }
  for(const Point_3& p : simplex.points)
    os << " (" << p << ')';
  return os;
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes a defect of the input: its kind and its simplices.
template <typename Point_3>
std::ostream& operator<<(std::ostream& os, const Input_defect_3<Point_3>& defect)
{
  os << to_string(defect.kind);
  for(std::size_t i = 0; i < defect.simplices.size(); ++i)
    os << (i == 0 ? ": " : " and ") << defect.simplices[i];
  return os;
}

} // namespace Boundary_recovery_3

using Boundary_recovery_3::Boundary_recovery_result_3;

namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the status and, a line each, the defects, all missing constraints, and those without storable points.
template <typename Triangulation>
std::ostream& operator<<(std::ostream& os, const Boundary_recovery_result_3<Triangulation>& result)
{
  os << to_string(result.status);
  for(const auto& defect : result.defects)
    os << '\n' << defect;
  if(result.number_of_defects > result.defects.size())
    os << "\nthese are " << result.defects.size() << " of at least " << result.number_of_defects << " defects";
  for(const auto& edge : result.missing_edges)
    os << "\nmissing " << edge;
  for(const auto& facet : result.missing_facets)
    os << "\nmissing " << facet;
  for(const auto& constraint : result.unrepresentable_constraints)
    os << "\nunrepresentable point of " << constraint;
  return os;
}

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_RECOVERY_RESULT_3_H
