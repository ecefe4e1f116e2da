// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_CONSTRAINED_MESH_TRIANGULATION_3_H
#define CGAL_BOUNDARY_CONSTRAINED_MESH_TRIANGULATION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_cell_base_3.h>
#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_vertex_base_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/tags.h>

namespace CGAL {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief provides the triangulation type that `make_boundary_constrained_mesh_3()` is best used with.
 *
 * \tparam Kernel a model of `BoundaryRecoveryTraits_3`
 * \tparam ConcurrencyTag `Sequential_tag`, or `Parallel_tag` for the parallel insertion of points before the recovery
 */
template <typename Kernel, typename ConcurrencyTag = Sequential_tag>
struct Boundary_constrained_mesh_triangulation_3
{
private:
  typedef Boundary_recovery_3::Boundary_constrained_mesh_vertex_base_3<Kernel> Vb;
  typedef Boundary_recovery_3::Boundary_constrained_mesh_cell_base_3<Kernel>   Cb;

public:
  /// a Delaunay triangulation whose vertices and cells carry the indices of CGAL's mesh packages
  typedef Delaunay_triangulation_3<Kernel, Triangulation_data_structure_3<Vb, Cb, ConcurrencyTag> > type;
};

} // namespace CGAL

#endif // CGAL_BOUNDARY_CONSTRAINED_MESH_TRIANGULATION_3_H
