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

#include <CGAL/Boundary_recovery_3/enumerations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// a vertex, edge or facet of the input, in the caller's own indices.
template <typename Point_3_>
struct Input_simplex_3
{
  typedef Point_3_ Point_3; ///< the point type

  /// the `index` of an edge that is in the input only as an edge of a facet, and of a vertex of the triangulation that
  /// is not in the input
  static constexpr std::size_t no_index = std::size_t(-1);

  int dimension = -1;                ///< 0: vertex, 1: edge, 2: facet, 3: tetrahedron
  std::size_t index = no_index;      ///< position in the range of the input
  std::vector<std::size_t> vertices; ///< the input indices of the vertices; none for a vertex without index
  std::vector<Point_3> points;       ///< the coordinates of the vertices; empty where an index has no finite point
};

/// \ingroup PkgBoundaryRecovery3Classes
/// a defect of the input, with the simplices that cause the defect: one, two, or none if the whole input is the cause.
template <typename Point_3_>
struct Input_defect_3
{
  Input_defect_kind kind;                            ///< the kind of the defect
  std::vector<Input_simplex_3<Point_3_> > simplices; ///< the simplices that cause the defect
};

/// \ingroup PkgBoundaryRecovery3Classes
/// the duration of a phase, and counts at its end. Phases of a recovery count lost constraints, phases of the meshing
/// count vertices and cells, phases of the remeshing of holes count holes. All other counts are 0.
struct Phase_report
{
  Phase phase;                        ///< the phase
  std::size_t lost_edges = 0;         ///< number of constrained edges that are not in the triangulation
  std::size_t lost_facets = 0;        ///< number of constrained facets that are not in the triangulation
  std::size_t number_of_vertices = 0; ///< number of vertices of the triangulation; after the phase `forecast`, the
                                      ///< expected number
  std::size_t number_of_cells = 0;    ///< number of finite cells of the triangulation, in and outside the domain; after
                                      ///< the phase `forecast`, the expected number in the domain
  std::size_t number_of_holes = 0;    ///< number of holes
  double seconds = 0;                 ///< duration in seconds (wall clock)
};

/// \ingroup PkgBoundaryRecovery3Classes
/// one row of the tables of [CZZ+17, Section 5.1.2]: the state after a pass with one maximal recursion level.
struct Recursion_level_report
{
  Phase phase;                      ///< the calling
  int max_recursion_level = -1;     ///< the maximal recursion level of the pass; -1: before the first one
  std::size_t n1 = 0;               ///< number of lost edges (or facets)
  std::size_t n2 = 0;               ///< number of intersections of lost edges (facets) with mesh entities
  std::size_t n3 = 0;               ///< largest number of intersections of one lost edge (facet)
  std::size_t n4 = 0;               ///< number of crossed mesh entities, each counted once: the size of the paper's
                                    ///< hash table
};

/// \ingroup PkgBoundaryRecovery3Classes
/// a mesh edge or facet that is a part of a constraint. Mesh edges follow each other in the order of their places on
/// the constrained edge. Mesh facets come in any order, each in the orientation of the constrained facet.
template <typename Vertex_handle_, typename Point_3_>
struct Constraint_part_3
{
  std::vector<Vertex_handle_> vertices;    ///< the vertices: two or three
  Input_simplex_3<Point_3_> constraint;    ///< the whole constraint
};

/// \ingroup PkgBoundaryRecovery3Classes
/// a mesh facet of the surface: an array of three vertices, in the orientation of the constrained facet to which the
/// mesh facet belongs.
template <typename Vertex_handle_>
struct Surface_facet_3
  : public std::array<Vertex_handle_, 3>
{
  std::size_t index = 0; ///< position of the constrained facet in its input range
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the result of `CGAL::recover_boundary()`: the status, missing constraints, defects, and the counts of each
 * phase.
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

  /// the vertex of the triangulation for each input vertex, by input index. Input vertices without a constraint are
  /// included. Empty if `status` is `invalid_input`.
  std::vector<Vertex_handle> vertices;

  /// the vertices of each constrained facet, by input index, in the orientation of the input. Missing facets are
  /// included; a vertex is a default handle if it is one in `vertices`. Empty if `status` is `invalid_input`.
  std::vector<Vertex_triple> facets;

  /// the constrained edges that are not in the triangulation
  std::vector<Input_simplex> missing_edges;

  /// the constrained facets that are not in the triangulation
  std::vector<Input_simplex> missing_facets;

  /// the constraints that need a Steiner point, on or beside the constraint, at a position that the number type of the
  /// kernel cannot store: the edges of the last attempt, then the facets. Empty unless `status` is `incomplete` and the
  /// mode is not `flips_only`.
  std::vector<Input_simplex> unrepresentable_constraints;

  /// the defects of the input, if `status` is `invalid_input`: at most as many as the named parameter
  /// `maximum_number_of_defects` allows, the first ones
  std::vector<Input_defect> defects;

  /// number of defects. It is larger than the number of listed defects iff the list is cut off; the number of pairs of
  /// constraints that intersect is then a lower bound
  std::size_t number_of_defects = 0;

  /// the mesh edges that form constrained edges with Steiner points (mode `conforming` only). Each other constrained
  /// edge is one mesh edge, or missing
  std::vector<Constraint_part> parts_of_edges;

  /// the mesh facets that form constrained facets with Steiner points (mode `conforming` only). Each other constrained
  /// facet is one mesh facet, or missing
  std::vector<Constraint_part> parts_of_facets;

  /// the Steiner points that are left in the triangulation, in and outside the domain
  std::vector<Vertex_handle> steiner_vertices;

  std::size_t number_of_edges = 0;             ///< number of constrained edges, with the edges of triangles, but
                                               ///< without the edges of other faces
  std::size_t number_of_facets = 0;            ///< number of constrained facets
  std::size_t number_of_constraint_points = 0; ///< number of Steiner points that were put on constraints
  std::size_t number_of_steiner_points = 0;    ///< number of Steiner points off the constraints that replaced points on
                                               ///< constraints (none in the mode `conforming`), plus the points of the
                                               ///< phase `planar_edge_recovery` in all modes; points that were removed
                                               ///< later count
  std::size_t number_of_inserted_vertices = 0; ///< number of input points that were not in the triangulation before
  std::size_t number_of_shell_transformations = 0; ///< number of replacements of cells by flips, stars and
                                                   ///< reconnections, with those that were taken back

  std::vector<Phase_report> phases;           ///< one entry for each run of a phase. Phases with Steiner points run
                                              ///< again if other points have to be tried, up to six times
  std::vector<Recursion_level_report> levels; ///< one entry for each pass of [CZZ+17, Alg.\ 5]

  /// returns the mesh facets of the surface, in the order of the constrained facets: for each constrained facet the
  /// mesh facet, or several parts if it has Steiner points (mode `conforming` only), or nothing if it is missing.
  /// `label_regions()` and `CGAL::recover_boundary()` accept this range.
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
/// writes the kind, index, vertices and coordinates of a simplex of the input.
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
/// writes the kind and the simplices of a defect of the input.
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
/// writes the status and, one a line, the defects, the missing constraints, and the constraints without storable
/// points.
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
