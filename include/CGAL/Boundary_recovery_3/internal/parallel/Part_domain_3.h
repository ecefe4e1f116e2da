// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PART_DOMAIN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PART_DOMAIN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Constrained_edge_map_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>

#include <CGAL/property_map.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * All cells of a triangulation that are in a region. If it is one of a part of a mesh, it has seams: walls that are on
 * no surface, with nothing behind them.
 */
template <typename Tr>
class Part_domain_3
  : public Selected_domain_3<Tr, Static_boolean_property_map<typename Tr::Cell_handle, true>,
                             Constrained_edge_map_3<Tr> >
{
  typedef Static_boolean_property_map<typename Tr::Cell_handle, true>          All_cells;
  typedef Selected_domain_3<Tr, All_cells, Constrained_edge_map_3<Tr> >        Base;

public:
  static constexpr bool has_seams = true;

  // Constrained edges are arrays of two vertex handles.
  template <typename EdgeRange>
  Part_domain_3(const Tr& tr, const EdgeRange& constrained_edges)
    : Base(tr, All_cells(), Constrained_edge_map_3<Tr>(constrained_edges))
  { }

  static bool is_seam(const typename Tr::Cell_handle c, const int i)
  {
    return ! c->is_facet_on_surface(i) && c->neighbor(i)->subdomain_index() == typename Base::Subdomain_index();
  }
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_PART_DOMAIN_3_H
