// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_WALK_ELEMENTS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_WALK_ELEMENTS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <array>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// A mesh edge (dimension 1) or facet (dimension 2) that crosses a constraint, and a cell that has it.
template <typename Tr>
struct Crossing_3
{
  int dimension;
  std::array<typename Tr::Vertex_handle, 3> vertices; // the third one of an edge is the default handle
  typename Tr::Cell_handle cell;
};

// A place in the shell of an edge ab: the interior of the facet a b p_i, or of the cell a b p_i p_next(i).
struct Shell_wedge
{
  int index; // i
  bool is_facet;
};

// The wedge through which the half-plane from the line ab through v leaves ab. If v is a vertex of the shell, there is
// nothing to look for, and the index is Shell_3::none.
template <typename Tr>
Shell_wedge find_wedge(const Shell_3<Tr>& shell, const Vertex_predicates_3<Tr>& predicates,
                       const typename Tr::Vertex_handle v)
{
  const Shell_wedge none = { Shell_3<Tr>::none, false };
  if(shell.index(v) != Shell_3<Tr>::none)
    return none;
  const auto side_of = [&](const int i)
  {
    return i == shell.infinite_index() ? ZERO : predicates.orientation(shell.a(), shell.b(), shell.vertex(i), v);
  };
  Orientation side = side_of(0);
  for(int i = 0; i < shell.degree(); ++i)
  {
    if(i != shell.infinite_index() && side == COPLANAR
       && predicates.side_of_line(shell.a(), shell.b(), shell.vertex(i), v) == POSITIVE)
      return { i, true };
    const Orientation next_side = side_of(shell.next(i));
    if(side == POSITIVE && next_side == NEGATIVE)
      return { i, false };
    side = next_side;
  }
  CGAL_assertion(false);
  return none;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_WALK_ELEMENTS_H
