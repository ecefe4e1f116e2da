// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_TETRAHEDRALIZATION_SEARCH_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_TETRAHEDRALIZATION_SEARCH_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <cstddef>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * What the searches for a tetrahedralization of a polyhedron have in common: the bounds on their work, and how they
 * end.
 */
struct Tetrahedralization_search
{
  struct Bounds
  {
    std::size_t vertices;   // of the polyhedron, the largest one if it grows
    std::size_t tetrahedra; // between them, where all that can be are collected
    std::size_t steps;      // of one search
  };

  enum Outcome
  {
    FOUND,
    NONE,    // there is none
    GAVE_UP  // a bound was reached
  };
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_TETRAHEDRALIZATION_SEARCH_H
