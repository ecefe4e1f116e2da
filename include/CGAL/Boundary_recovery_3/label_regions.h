// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_LABEL_REGIONS_H
#define CGAL_BOUNDARY_RECOVERY_3_LABEL_REGIONS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Region_labeller_3.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL::Boundary_recovery_3 {
/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief labels each finite cell of a triangulation with its region; the given facets separate the regions.
 *
 * Region 0 is outside the domain. The regions of the domain are numbered 1, 2, ... in the order of the facets: first
 * the regions on both sides of the first facet, and so on. The region behind a facet, where an outward facet has its
 * inside, comes before the region in front of it.
 *
 * Integers decide which components belong to the domain:
 * - the component of the infinite cells is outside; through a gap in the surface, it reaches inside;
 * - if the facets form an oriented cycle, components with winding number 0 are outside. Therefore a cube inside a
 *   cube is a void if its facets turn inward, and a second region if they turn outward;
 * - else, if every edge has an even number of facets, components that an even number of facets separates from the
 *   infinite cells are outside;
 * - else, as for regions that share facets, every bounded component belongs to the domain.
 *
 * A facet with the same component on both sides, as in a sheet that ends inside, separates nothing and does not count
 * here.
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`, or of a class derived from it; its cells need no further members
 * \tparam FacetRange a range of arrays of three `Tr::Vertex_handle`
 * \tparam CellRegionMap a model of `WritablePropertyMap` with `Tr::Cell_handle` as key type and `int` as value type
 *
 * \param tr the triangulation
 * \param facets the facets that separate regions, in the orientation of the input. Triples that are not facets of `tr`
 *        are ignored.
 * \param region the region of each finite cell, which this function writes
 *
 * \return the number of regions of the domain. If the dimension of `tr` is not 3, it is 0, and nothing is written.
 */
template <typename Tr, typename FacetRange, typename CellRegionMap>
int label_regions(const Tr& tr, const FacetRange& facets, CellRegionMap region)
{
  if(tr.dimension() < 3)
    return 0;
  typedef typename Tr::Cell_handle Cell_handle;
  return internal::Region_labeller_3<Tr>(tr, facets).label([&](const Cell_handle c, const int number)
  {
    if(! tr.is_infinite(c))
      put(region, c, number);
  });
}

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_LABEL_REGIONS_H
