// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_HOLE_REMESHING_RESULT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_HOLE_REMESHING_RESULT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/enumerations.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// the location of a place in the old mesh, for the interpolation of a solution.
struct Old_mesh_location_3
{
  std::size_t cell = std::size_t(-1); ///< the position of the old tetrahedron

  /// the weights of the four vertices: not negative, and with the sum 1, up to rounding
  std::array<double, 4> coordinates = {{ 0, 0, 0, 0 }};
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the result of `CGAL::remesh_holes()`: the new mesh, old positions of its vertices and tetrahedra, and counts.
 *
 * If the status is not `meshed`, the mesh is the old mesh.
 *
 * \tparam Point_3_ the point type
 */
template <typename Point_3_>
struct Hole_remeshing_result_3
{
  typedef Point_3_                    Point_3;      ///< the point type
  typedef std::array<std::size_t, 4>  Tetrahedron;  ///< the positions of its four vertices
  typedef std::array<std::size_t, 3>  Facet;        ///< the positions of its three vertices
  typedef std::array<std::size_t, 2>  Edge;         ///< the positions of its two vertices
  typedef Input_defect_3<Point_3>     Input_defect; ///< a defect of the input
  typedef Invalid_size_3<Point_3>     Invalid_size; ///< a place without a size

  /// the old position of new vertices and tetrahedra
  static constexpr std::size_t no_index = std::size_t(-1);

  /// how it ended
  Meshing_status status = Meshing_status::incomplete;

  /// \name The Mesh
  /// @{

  std::vector<Point_3> points;         ///< the vertices: first the old ones that stayed, in their order, then the new
                                       ///< ones
  std::vector<Tetrahedron> tetrahedra; ///< the tetrahedra: first the old ones that stayed, in their order, then the new
                                       ///< ones, positively oriented
  std::vector<int> regions;            ///< the region of each tetrahedron
  std::vector<Facet> facets;           ///< the constrained facets, in their old order; none is missing
  std::vector<Edge> edges;             ///< the constrained edges, in their old order; none is missing

  /// @}

  /// \name Where It Was
  /// @{

  std::vector<std::size_t> old_vertices; ///< the old position of each vertex, or `no_index`
  std::vector<std::size_t> old_cells;    ///< the old position of each tetrahedron, or `no_index`

  /// the location of each new vertex, from `number_of_kept_vertices` on, in the old mesh as it was given: an old
  /// tetrahedron of the same region and hole that is neither inverted nor flat. There is always one, and where inverted
  /// cells fold back, one of several is named.
  std::vector<Old_mesh_location_3> locations;

  /// @}

  /// \name Account
  /// @{

  std::size_t number_of_kept_vertices = 0; ///< number of vertices that stayed; the first ones of `points`
  std::size_t number_of_kept_cells = 0;    ///< number of tetrahedra that stayed; the first ones of `tetrahedra`
  std::size_t number_of_bad_cells = 0;     ///< number of old tetrahedra that were bad
  std::size_t number_of_inverted_cells = 0; ///< number of bad tetrahedra that were flat or inverted
  std::size_t number_of_holes = 0;         ///< number of holes that were meshed
  std::size_t number_of_enlargements = 0;  ///< number of times that a hole grew because its boundary was no valid
                                           ///< surface
  std::size_t number_of_enlargements_for_quality = 0; ///< number of times that a hole grew because cells at its
                                                      ///< boundary stayed bad
  std::size_t number_of_failures = 0;      ///< number of times that a hole grew because its valid boundary could not be
                                           ///< recovered
  std::size_t number_of_steiner_points = 0; ///< number of Steiner points in holes before the improvement
  std::size_t number_of_holes_with_steiner_points = 0; ///< number of holes with Steiner points

  /// the smallest dihedral angle of the new cells, in degrees; 180 without new cells
  double smallest_new_angle = 180;

  std::size_t number_of_forced_cells = 0;  ///< number of new cells below the target of the improvement because of
                                           ///< constrained facets: forced cells and cells in gaps, see
                                           ///< `Quality_certificate_3`
  std::size_t number_of_needles = 0;       ///< number of new cells below the target that are as thin as one of their
                                           ///< constrained facets
  std::size_t number_of_unimproved_cells = 0; ///< number of other new cells below the target

  /// the defects of the input, if `status` is `invalid_input`
  std::vector<Input_defect> defects;

  /// the place without a size, if that is the reason of the status `invalid_input`: none, or one
  std::vector<Invalid_size> invalid_sizes;

  std::vector<Phase_report> phases; ///< one entry for each run of a phase; the phases from `hole_recovery` to
                                    ///< `hole_improvement` run again if holes grow for quality

  double seconds = 0; ///< the whole duration in seconds (wall clock)

  /// @}

  /// returns the duration of a phase in seconds; 0 if it did not run.
  double seconds_of(const Phase phase) const
  {
    double sum = 0;
    for(const Phase_report& report : phases)
      if(report.phase == phase)
        sum += report.seconds;
    return sum;
  }

  /// returns `true` iff all is done.
  explicit operator bool() const { return status == Meshing_status::meshed; }
};

} // namespace Boundary_recovery_3

using Boundary_recovery_3::Hole_remeshing_result_3;

namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the status and the main numbers as one line, and a line for each defect.
template <typename Point_3>
std::ostream& operator<<(std::ostream& os, const Hole_remeshing_result_3<Point_3>& result)
{
  os << to_string(result.status) << ": " << result.number_of_bad_cells << " bad cells in " << result.number_of_holes
     << " holes, " << result.tetrahedra.size() - result.number_of_kept_cells << " new cells";
  for(const auto& defect : result.defects)
    os << '\n' << defect;
  for(const auto& invalid : result.invalid_sizes)
    os << '\n' << invalid;
  return os;
}

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the result of `CGAL::remesh_cells()`: the new mesh as arrays, the handles of its vertices and cells, and
 * counts.
 *
 * Old positions count in the order of `finite_vertex_handles()` and `finite_cell_handles()` before the call. The arrays
 * have all finite cells; cells outside of the domain have the region 0.
 *
 * \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, or of a class derived from it
 */
template <typename Triangulation_>
struct Cell_remeshing_result_3
  : public Hole_remeshing_result_3<typename Triangulation_::Geom_traits::Point_3>
{
  typedef Triangulation_                         Triangulation; ///< the triangulation type
  typedef typename Triangulation::Vertex_handle  Vertex_handle; ///< its vertex handle
  typedef typename Triangulation::Cell_handle    Cell_handle;   ///< its cell handle

  std::vector<Vertex_handle> vertices; ///< the vertex of the triangulation for each element of `points`
  std::vector<Cell_handle> cells;      ///< the cell of the triangulation for each element of `tetrahedra`
};

} // namespace Boundary_recovery_3

using Boundary_recovery_3::Cell_remeshing_result_3;

} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_HOLE_REMESHING_RESULT_3_H
