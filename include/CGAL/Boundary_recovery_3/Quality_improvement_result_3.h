// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_QUALITY_IMPROVEMENT_RESULT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_QUALITY_IMPROVEMENT_RESULT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Mesh_quality_3.h>
#include <CGAL/Boundary_recovery_3/Quality_certificate_3.h>
#include <CGAL/Boundary_recovery_3/enumerations.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Boundary_recovery_3 {

/// \ingroup PkgBoundaryRecovery3Classes
/// how often `CGAL::improve_mesh_quality()` changed something, without what was undone again.
struct Quality_improvement_counts
{
  std::size_t number_of_rounds = 0;               ///< number of times that all bad cells were looked at
  std::size_t number_of_removed_edges = 0;        ///< number of edges that shell transformations removed
  std::size_t number_of_removed_facets = 0;       ///< number of times that facets were removed, or others put there
  std::size_t number_of_moved_vertices = 0;       ///< number of times that a vertex was moved
  std::size_t number_of_inserted_points = 0;      ///< number of vertices that were inserted
  std::size_t number_of_removed_vertices = 0;     ///< number of vertices that were removed
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief what `CGAL::improve_mesh_quality()` did, and why cells that are bad still are so.
 *
 * \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, or of a class derived from it
 */
template <typename Triangulation_>
struct Quality_improvement_result_3
{
  typedef Triangulation_                       Triangulation; ///< the triangulation type
  typedef Quality_certificate_3<Triangulation> Certificate;   ///< the type of the certificate

  /// how it ended; `meshed` if no cell is below the target any more, or nothing helps
  Meshing_status status = Meshing_status::meshed;

  Mesh_quality_3 before; ///< the quality before the first change
  Mesh_quality_3 after;  ///< the quality after the last one

  /// whether `after` is there: not if nobody asked for the improvement, or the work ended before it, or was stopped
  /// with no time left to measure. Then `after` has no cells, nor has `before` if that was before the first change.
  bool is_measured = false;

  /// the cells that are below the target, with the reasons; if the work was stopped, see `is_complete` there
  Certificate certificate;

  Quality_improvement_counts counts; ///< what was changed

  double seconds = 0; ///< duration in seconds (wall clock), that of the measuring included

  /// returns `true` iff all is done, which does not mean that no cell is below the target.
  explicit operator bool() const { return status == Meshing_status::meshed; }
};

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the status, the quality before and after, and the certificate, as a line each.
template <typename Triangulation>
std::ostream& operator<<(std::ostream& os, const Quality_improvement_result_3<Triangulation>& result)
{
  os << to_string(result.status);
  if(result.status == Meshing_status::invalid_input)
    return os;
  if(result.is_measured || result.before.number_of_cells > 0)
    os << "\nbefore: " << result.before;
  if(result.is_measured)
    os << "\nafter: " << result.after;
  else
    os << "\nafter: not measured, there was no time left";
  return os << '\n' << result.certificate;
}

} // namespace Boundary_recovery_3

using Boundary_recovery_3::Quality_improvement_result_3;

} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_QUALITY_IMPROVEMENT_RESULT_3_H
