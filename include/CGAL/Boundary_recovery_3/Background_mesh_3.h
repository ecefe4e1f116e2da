// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a tetrahedral mesh with sizes at its vertices, as arrays.
 *
 * \tparam GT the geometric traits
 *
 * \sa `read_background_mesh()`
 */
template <typename GT>
struct Background_mesh_3
{
  typedef typename GT::Point_3       Point_3;     ///< the point type
  typedef std::array<std::size_t, 4> Tetrahedron; ///< the positions of four points, from 0

  std::vector<Point_3> points;         ///< the vertices
  std::vector<Tetrahedron> tetrahedra; ///< the tetrahedra
  std::vector<double> sizes;           ///< the size at each vertex, in the unit of the coordinates

  /// returns whether there is a positive and finite size for each vertex, and all tetrahedra name vertices.
  bool is_valid() const
  {
    if(sizes.size() != points.size())
      return false;
    for(const double size : sizes)
      if(! (size > 0 && size < std::numeric_limits<double>::infinity()))
        return false;
    for(const Tetrahedron& t : tetrahedra)
      for(const std::size_t v : t)
        if(v >= points.size())
          return false;
    return true;
  }
};

} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_BACKGROUND_MESH_3_H
