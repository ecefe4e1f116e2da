// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_DOMAIN_KEEPER_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_DOMAIN_KEEPER_3_H

#include <CGAL/license/Boundary_recovery_3.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The visitor of whatever exchanges cells of one region of a domain at a time, with no wall between them: keeps the
 * domain and the indices of its cells up to date, and hands on everything to another visitor, which finds them so.
 */
template <typename Tr, typename Domain, typename Visitor>
class Domain_keeper_3
{
public:
  typedef typename Tr::Cell_handle           Cell_handle;
  typedef typename Tr::Cell::Subdomain_index Subdomain_index;

  Domain_keeper_3(Domain& domain, Visitor& visitor) : m_domain(domain), m_visitor(visitor) { }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    m_visitor.before_cells_removal(cells);
    m_region = (*cells.begin())->subdomain_index();
    m_is_exchanging = true;
    for(const Cell_handle c : cells)
      m_domain.remove(c);
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    for(const Cell_handle c : cells)
      set_indices(c);
    after_cells_return(cells);
  }

  // The same for cells that have their indices, maybe of several regions, since they were there before.
  template <typename CellRange>
  void after_cells_return(const CellRange& cells)
  {
    add_to_domain(cells);
    m_visitor.after_cells_creation(cells);
  }

  // To be called if the exchange of these cells threw: if they are still there, they are in the domain again.
  template <typename CellRange>
  void after_failure(const CellRange& cells)
  {
    if(m_is_exchanging)
      add_to_domain(cells);
  }

private:
  template <typename CellRange>
  void add_to_domain(const CellRange& cells)
  {
    m_is_exchanging = false;
    for(const Cell_handle c : cells)
      m_domain.add(c);
  }

  // Facets between the new cells have no mark.
  void set_indices(const Cell_handle c)
  {
    c->set_subdomain_index(m_region);
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle n = c->neighbor(i);
      c->set_surface_patch_index(i, n->surface_patch_index(n->index(c)));
    }
  }

  Domain& m_domain;
  Visitor& m_visitor;
  Subdomain_index m_region = Subdomain_index(); // of the cells that are exchanged
  bool m_is_exchanging = false;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_DOMAIN_KEEPER_3_H
