// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_RESULT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_RESULT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/enumerations.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// a place where a size field has no positive finite size.
template <typename Point_3_>
struct Invalid_size_3
{
  typedef Point_3_ Point_3; ///< the point type

  Point_3 point;       ///< the place
  double size;         ///< what the field returned; NaN if it threw
  std::string message; ///< `what()` of the exception, if the field threw one that has it
};

/// \ingroup PkgBoundaryRecovery3Classes
/// the result of `CGAL::insert_field_points()`: the status, the forecast, and counts.
template <typename Triangulation_>
struct Field_points_result_3
{
  typedef Triangulation_                               Triangulation; ///< the triangulation type
  typedef typename Triangulation::Geom_traits::Point_3 Point_3;       ///< its point type
  typedef Invalid_size_3<Point_3>                      Invalid_size;  ///< a place without a size

  /// the end of the insertion; `meshed`: no edge is longer than the size field allows, except where no point fits
  Meshing_status status = Meshing_status::meshed;

  /// the estimated number of cells in the domain, made before the first point is inserted: the integral of
  /// \f$ 6 \sqrt 2 / h^3 \f$ for the size \f$ h \f$, or the present number of cells if that is larger. If points had to
  /// be refused because the estimate was too low, it is made again.
  double forecast_of_cells = 0;

  double forecast_of_vertices = 0; ///< the same for the vertices of the triangulation

  std::size_t number_of_field_points = 0; ///< number of points that were inserted

  /// whether all places with sizes below an eighth of the cell's size were found. `false` means that this is not known:
  /// the field has neither `grading()` nor `least_size_around()`, or its grading is so large that the questions would
  /// have no end. A cell with eight such places without room for a point counts as done.
  bool is_field_resolved = true;

  /// the place of the invalid size if the status is `invalid_input`: none, or one
  std::vector<Invalid_size> invalid_sizes;

  double seconds = 0; ///< duration in seconds (wall clock), with the forecast

  /// returns `true` iff all is done.
  explicit operator bool() const { return status == Meshing_status::meshed; }
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the result of `CGAL::make_boundary_constrained_mesh_3()`: the status, and the results of its steps.
 *
 * \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, or of a class derived from it
 */
template <typename Triangulation_>
struct Boundary_constrained_mesh_result_3
{
  typedef Triangulation_                            Triangulation; ///< the triangulation type
  typedef typename Triangulation::Vertex_handle     Vertex_handle; ///< its vertex handle
  typedef std::array<Vertex_handle, 2>              Vertex_pair;   ///< the ends of an edge
  typedef Boundary_recovery_result_3<Triangulation> Recovery;      ///< the result of steps 2 to 4
  typedef Field_points_result_3<Triangulation>      Filling;       ///< the result of step 6
  typedef Quality_improvement_result_3<Triangulation> Improvement; ///< the result of step 7

  /// how the meshing ended
  Meshing_status status = Meshing_status::incomplete;

  /// steps 2 to 4: the boundary recovery. Its `steiner_vertices` are without the Steiner points that the improvement
  /// moved or removed.
  Recovery recovery;

  int number_of_regions = 0; ///< step 5: number of regions of the domain

  /// the positions in the named parameter `void_points` of places outside or on the surface. Such places make the
  /// status `invalid_input`
  std::vector<std::size_t> invalid_void_points;

  Filling filling;           ///< step 6: field points

  /// the number of sub-domains in steps 6 and 7; 1 if the domain was not divided
  std::size_t number_of_subdomains = 1;

  /// step 7: the improvement of the quality; empty without an improvement
  Improvement improvement;

  /// the edges of the mesh that form the edges of the named parameter `constrained_edges`; empty if the recovery
  /// failed. `Constrained_edge_map_3` makes a property map of these edges, for functions that change the mesh.
  std::vector<Vertex_pair> constrained_edges;

  std::vector<Phase_report> phases; ///< one entry for each phase after the recovery

  double seconds = 0; ///< duration of all in seconds (wall clock)

  /// returns `true` iff all is done.
  explicit operator bool() const { return status == Meshing_status::meshed; }
};

/// \ingroup PkgBoundaryRecovery3Classes
/// writes a place without a size, and what the field returned or threw there.
template <typename Point_3>
std::ostream& operator<<(std::ostream& os, const Invalid_size_3<Point_3>& invalid)
{
  os << "the size at (" << invalid.point << ") is " << invalid.size;
  return invalid.message.empty() ? os : os << ": " << invalid.message;
}

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the status and the main numbers as one line, and a line for the place without a size, if there is one.
template <typename Triangulation>
std::ostream& operator<<(std::ostream& os, const Field_points_result_3<Triangulation>& result)
{
  os << to_string(result.status) << ": " << result.number_of_field_points << " field points";
  for(const auto& invalid : result.invalid_sizes)
    os << '\n' << invalid;
  return os;
}

} // namespace Boundary_recovery_3

using Boundary_recovery_3::Boundary_constrained_mesh_result_3;
using Boundary_recovery_3::Field_points_result_3;

namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// writes a line for the status and for each step, and further lines for defects and missing constraints.
template <typename Triangulation>
std::ostream& operator<<(std::ostream& os, const Boundary_constrained_mesh_result_3<Triangulation>& result)
{
  os << to_string(result.status) << "\nrecovery: " << result.recovery;
  if(result.recovery)
    os << "\nregions: " << result.number_of_regions;
  if(result.number_of_regions > 0)
    os << "\nfilling: " << result.filling;
  if(result.number_of_regions > 0 && result.filling
     && (! result.improvement || result.improvement.before.number_of_cells > 0)) // else nobody asked for it
    os << "\nimprovement: " << result.improvement;
  return os;
}

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_BOUNDARY_CONSTRAINED_MESH_RESULT_3_H
