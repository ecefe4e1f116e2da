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

#include <CGAL/Boundary_recovery_3/enumerations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief figures of the shapes and sizes of the cells of a mesh, see `mesh_quality()`.
 *
 * Without a cell, or without known sizes, figures are NaN.
 */
struct Mesh_quality_3
{
  /// number of cells of the domain
  std::size_t number_of_cells = 0;

  /// the smallest dihedral angle, in degrees
  double min_dihedral_angle = std::numeric_limits<double>::quiet_NaN();

  /// the largest dihedral angle, in degrees
  double max_dihedral_angle = std::numeric_limits<double>::quiet_NaN();

  /// numbers of cells with a dihedral angle below 5, 10, 15 and 20 degrees
  std::array<std::size_t, 4> numbers_of_cells_below = {{ 0, 0, 0, 0 }};

  /// numbers of cells with a dihedral angle above 150, 160 and 170 degrees
  std::array<std::size_t, 3> numbers_of_cells_above = {{ 0, 0, 0 }};

  /// numbers of cells whose smallest dihedral angle is at least 0, 5, ..., 85 degrees, and less than 5 degrees more
  std::array<std::size_t, 18> histogram = {{ 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }};

  /// the mean radius ratio of the cells: 3 times the radius of the inscribed sphere, divided by the radius of the
  /// circumscribed sphere; 1 for the regular tetrahedron
  double mean_radius_ratio = std::numeric_limits<double>::quiet_NaN();

  /// the smallest radius ratio
  double min_radius_ratio = std::numeric_limits<double>::quiet_NaN();

  /// number of inner edges with a known size: edges that are in no constrained facet, and whose ends both have a size
  std::size_t number_of_sized_edges = 0;

  /// the share of these edges that are at least \f$ 1 / \sqrt 2 \f$ and at most \f$ \sqrt 2 \f$ times as long as the
  /// mean of the sizes at both ends
  double share_of_edges_in_size = std::numeric_limits<double>::quiet_NaN();
};

/// \ingroup PkgBoundaryRecovery3Classes
/// writes one line: the number of cells, the extreme dihedral angles, and the number of cells with an angle below 10
/// degrees.
inline std::ostream& operator<<(std::ostream& os, const Mesh_quality_3& quality)
{
  os << quality.number_of_cells << " cells";
  if(quality.number_of_cells == 0)
    return os;
  return os << ", dihedral angles from " << quality.min_dihedral_angle << " to " << quality.max_dihedral_angle
            << " degrees, " << quality.numbers_of_cells_below[1] << " cells below 10";
}

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a cell with a dihedral angle below the target, and the reason.
 *
 * \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, or of a class derived from it
 */
template <typename Triangulation_>
struct Bad_cell_3
{
  typedef Triangulation_                        Triangulation; ///< the triangulation type
  typedef typename Triangulation::Cell_handle   Cell_handle;   ///< its cell handle
  typedef typename Triangulation::Vertex_handle Vertex_handle; ///< its vertex handle
  typedef typename Triangulation::Facet         Facet;         ///< its facet
  typedef std::array<Vertex_handle, 2>          Vertex_pair;   ///< the ends of an edge

  Cell_handle cell; ///< the cell

  double min_dihedral_angle; ///< its smallest dihedral angle, in degrees

  Vertex_pair edge; ///< the edge of the smallest dihedral angle

  Bad_cell_reason reason; ///< the reason of the small angle

  /// - `forced`: the two constrained facets. They share an edge of the cell, perhaps not `edge`, and other cells may be
  ///   between the facets.
  /// - `gap`: two constrained facets. The second one is above the center of the inscribed circle of the first one, at
  ///   the height `distance`, and no constraint is in between. If the first one is a facet of the cell, this proves
  ///   that each cell with this facet has an angle of at most `surface_angle` at one of the edges of the facet.
  ///   Otherwise, the cell has an edge of the first facet, and all vertices of the cell are too near to the plane of
  ///   this facet for angles as large as the target.
  /// - `needle`: the first entry is the constrained facet.
  /// - `not_improved`: two constrained facets of the cell that are nearly in a plane; as long as only this cell is
  ///   between the facets, it is flat. Without such facets, the first entry is the constrained facet with the smallest
  ///   plane angle, if that is below the target, of all with an edge of the cell, or else of all with a vertex of the
  ///   cell. This facet may be the cause, but need not be.
  ///
  /// An entry without a facet is `Triangulation::Facet()`.
  std::array<Facet, 2> facets;

  /// The angle between the two facets, or the largest angle that a gap allows, or the smallest plane angle of the only
  /// facet, in degrees. It is below the target; between two facets that are nearly in a plane, it is above 180 minus
  /// the target. NaN without facets.
  double surface_angle = std::numeric_limits<double>::quiet_NaN();

  /// `gap`: the height of the second facet above the first one, at the center of the inscribed circle of the first one.
  /// It is less than the length of any edge of the first facet. NaN for other reasons.
  double distance = std::numeric_limits<double>::quiet_NaN();

  /// returns the number of named facets.
  int number_of_facets() const
  {
    return static_cast<int>(std::count_if(facets.begin(), facets.end(), [](const Facet& f) { return f != Facet(); }));
  }
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a list of all cells with a dihedral angle below a target, each with the reason.
 *
 * The list has handles of cells and vertices, which are valid as long as the mesh is not changed.
 *
 * \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, or of a class derived from it
 */
template <typename Triangulation_>
struct Quality_certificate_3
{
  typedef Triangulation_            Triangulation; ///< the triangulation type
  typedef Bad_cell_3<Triangulation> Bad_cell;      ///< an entry

  double min_dihedral_angle = 0; ///< the target, in degrees

  std::vector<Bad_cell> cells; ///< the cells below the target, by increasing angle

  /// whether the list is complete. Otherwise it is empty: there was no improvement, or the work ended before the list
  /// was made.
  bool is_complete = false;

  /// returns the number of cells with this reason and with an angle below `degrees`.
  std::size_t number_of_cells(const Bad_cell_reason reason,
                              const double degrees = std::numeric_limits<double>::infinity()) const
  {
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [&](const Bad_cell& bad)
    {
      return bad.reason == reason && bad.min_dihedral_angle < degrees;
    }));
  }
};

/// \ingroup PkgBoundaryRecovery3Classes
/// writes one line: the number of cells below the target for each reason.
template <typename Triangulation>
std::ostream& operator<<(std::ostream& os, const Quality_certificate_3<Triangulation>& certificate)
{
  if(! certificate.is_complete)
    return os << "no certificate: there was no time left to look at all cells";
  os << certificate.cells.size() << " cells below " << certificate.min_dihedral_angle << " degrees";
  const char* separator = ": ";
  typedef Bad_cell_reason Reason;
  for(const Reason reason : { Reason::forced, Reason::gap, Reason::needle, Reason::not_improved })
    if(const std::size_t number = certificate.number_of_cells(reason))
      os << std::exchange(separator, ", ") << number << ' ' << to_string(reason);
  return os;
}

/// \ingroup PkgBoundaryRecovery3Classes
/// numbers of changes by `CGAL::improve_mesh_quality()`, without changes that were undone.
struct Quality_improvement_counts
{
  std::size_t number_of_rounds = 0;               ///< number of rounds over all bad cells
  std::size_t number_of_removed_edges = 0;        ///< number of edges that shell transformations removed
  std::size_t number_of_removed_facets = 0;       ///< number of times that facets were removed, or replaced by others
  std::size_t number_of_moved_vertices = 0;       ///< number of times that a vertex was moved
  std::size_t number_of_inserted_points = 0;      ///< number of vertices that were inserted
  std::size_t number_of_removed_vertices = 0;     ///< number of vertices that were removed
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the result of `CGAL::improve_mesh_quality()`: the status, the quality before and after, and the cells below
 * the target with their reasons.
 *
 * \tparam Triangulation_ an instance of `CGAL::Triangulation_3`, or of a class derived from it
 */
template <typename Triangulation_>
struct Quality_improvement_result_3
{
  typedef Triangulation_                       Triangulation; ///< the triangulation type
  typedef Quality_certificate_3<Triangulation> Certificate;   ///< the type of the certificate

  /// the end of the improvement; `meshed`: no cell is below the target any more, or nothing helps
  Meshing_status status = Meshing_status::meshed;

  Mesh_quality_3 before; ///< the quality before the first change
  Mesh_quality_3 after;  ///< the quality after the last one

  /// whether `after` was measured. Otherwise `after` has no cells: no improvement was asked for, or the work ended
  /// before it, or the time was up. If the work ended before the first change, `before` has no cells either.
  bool is_measured = false;

  /// the cells below the target, with the reasons; if the work was stopped, see `Quality_certificate_3::is_complete`
  Certificate certificate;

  Quality_improvement_counts counts; ///< numbers of changes

  double seconds = 0; ///< duration in seconds (wall clock), with the measurements

  /// returns `true` iff all is done. Cells may still be below the target.
  explicit operator bool() const { return status == Meshing_status::meshed; }
};

/// \ingroup PkgBoundaryRecovery3Classes
/// writes a line each for the status, the quality before and after, and the certificate.
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
