// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_MESH_QUALITY_H
#define CGAL_BOUNDARY_RECOVERY_3_MESH_QUALITY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Explain_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief measures the cells of a mesh: angles, radius ratios, and lengths of edges in comparison with the sizes.
 *
 * The sizes are those that `CGAL::insert_field_points()` writes to vertices with a member `meshing_info()`.
 *
 * \tparam Triangulation an instance of `Triangulation_3`, or of a class derived from it, whose cells are models of
 *         `MeshCellBase_3`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{cell_is_selected_map}
 *     \cgalParamDescription{the cells that are measured}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with `Triangulation::Cell_handle` as key type and `bool` as
 *                    value type}
 *     \cgalParamDefault{all cells in regions of the domain}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the figures, up to rounding
 */
template <typename Triangulation, typename CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_quality_3 mesh_quality(const Triangulation& tr, const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename Triangulation::Cell_handle Cell_handle;
  const auto domain = internal::selected_domain(tr, np);
  internal::Measure_quality_3<Triangulation> measure(tr, domain);
  return measure([](const Cell_handle, const internal::Cell_angles_3&) { });
}

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief lists the cells of a mesh with a dihedral angle below a target, each with the reason.
 *
 * `CGAL::improve_mesh_quality()` returns such a list; this function makes the list for any mesh. Constrained are the
 * facets for which `is_facet_on_surface()` holds, facets between regions, and facets between selected cells and others.
 *
 * \tparam Triangulation an instance of `Triangulation_3`, or of a class derived from it, whose cells are models of
 *         `MeshCellBase_3`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tr the triangulation
 * \param min_dihedral_angle the target, in degrees
 * \param np an optional sequence of named parameters: those of `mesh_quality()`
 *
 * \return the certificate; empty if `min_dihedral_angle` is NaN or not positive
 */
template <typename Triangulation, typename CGAL_NP_TEMPLATE_PARAMETERS>
Quality_certificate_3<Triangulation> quality_certificate(const Triangulation& tr, const double min_dihedral_angle,
                                                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename Triangulation::Cell_handle Cell_handle;
  const auto domain = internal::selected_domain(tr, np);
  internal::Explain_bad_cells_3<Triangulation> explain(tr, domain, min_dihedral_angle);
  if(tr.dimension() == 3)
    for(const Cell_handle c : tr.finite_cell_handles())
      if(domain.contains(c))
        explain.add(c, internal::Cell_angles_3(internal::corners(c)));
  return explain.certificate();
}

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_MESH_QUALITY_H
