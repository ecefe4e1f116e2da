// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_FIND_BAD_CELLS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_FIND_BAD_CELLS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Which cells of a mesh have to be replaced: those that are inverted or flat, which exact predicates tell; those with a
 * dihedral angle below a threshold; and those that the caller names.
 */
template <typename Kernel>
struct Find_bad_cells_3
{
  typedef Moved_mesh_3<typename Kernel::Point_3> Mesh;

  std::vector<char> is_bad; // of the tetrahedra
  std::size_t number_of_bad_cells = 0;
  std::size_t number_of_inverted_cells = 0;

  // Cells of the region that is not filled may have any shape; `is_selected` is called with a position.
  template <typename Is_selected, typename Is_unfilled>
  Find_bad_cells_3(const Mesh& mesh, const double min_dihedral_angle, const Is_selected& is_selected,
                   const Is_unfilled& is_unfilled)
    : is_bad(mesh.tetrahedra.size(), false)
  {
    const double good = Dihedral_angle_quality_3(1).of_angle(min_dihedral_angle) * (1 + 1e-6); // for rounding
    for(std::size_t c = 0; c < mesh.tetrahedra.size(); ++c)
    {
      const bool is_inverted = ! mesh.is_positive(c);
      is_bad[c] = is_inverted || is_selected(c)
               || (! is_unfilled(mesh.regions[c]) && is_below(mesh, c, min_dihedral_angle, good));
      number_of_inverted_cells += is_inverted ? 1 : 0;
      number_of_bad_cells += is_bad[c] ? 1 : 0;
    }
  }

private:
  // Most cells are so good that angles need not be computed.
  static bool is_below(const Mesh& mesh, const std::size_t c, const double min_dihedral_angle, const double good)
  {
    const auto corners = mesh.corners(c);
    return Dihedral_angle_quality_3(1)(corners) < good && Cell_angles_3(corners).smallest() < min_dihedral_angle;
  }
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_FIND_BAD_CELLS_3_H
