// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_MESH_QUALITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_MESH_QUALITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <array>
#include <cstddef>
#include <limits>
#include <ostream>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief figures of the shapes, and of the sizes, of the cells of a mesh, see `mesh_quality()`.
 *
 * Figures that do not exist, since there is no cell, or no size known, are NaN.
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

  /// the mean of the radius ratios of the cells: 3 times the radius of the inscribed sphere, over that of the
  /// circumscribed one, 1 for the regular tetrahedron
  double mean_radius_ratio = std::numeric_limits<double>::quiet_NaN();

  /// the smallest radius ratio
  double min_radius_ratio = std::numeric_limits<double>::quiet_NaN();

  /// number of inner edges whose length should be known: they are in no constrained facet, and both ends know a size
  std::size_t number_of_sized_edges = 0;

  /// the share of those edges that are at least \f$ 1 / \sqrt 2 \f$ and at most \f$ \sqrt 2 \f$ times as long as the
  /// mean of the sizes at their ends
  double share_of_edges_in_size = std::numeric_limits<double>::quiet_NaN();
};

/// \ingroup PkgBoundaryRecovery3Classes
/// writes the number of cells, the extreme dihedral angles, and how many cells have one below 10 degrees, as one line.
inline std::ostream& operator<<(std::ostream& os, const Mesh_quality_3& quality)
{
  os << quality.number_of_cells << " cells";
  if(quality.number_of_cells == 0)
    return os;
  return os << ", dihedral angles from " << quality.min_dihedral_angle << " to " << quality.max_dihedral_angle
            << " degrees, " << quality.numbers_of_cells_below[1] << " cells below 10";
}

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_MESH_QUALITY_3_H
