// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SELECTED_DOMAIN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SELECTED_DOMAIN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The part of a triangulation that is filled: the cells of the regions of the domain, as far as they are selected. Its
 * walls are the constrained facets, and those to cells that do not belong to it.
 *
 * `Cell_is_selected_map` is a property map from cells to Booleans, which is kept up to date. `Edge_is_constrained_map`
 * is one from pairs of vertices.
 */
template <typename Tr, typename Cell_is_selected_map, typename Edge_is_constrained_map>
class Selected_domain_3
{
public:
  typedef typename Tr::Vertex_handle              Vertex_handle;
  typedef typename Tr::Cell_handle                Cell_handle;
  typedef typename Tr::Cell::Subdomain_index      Subdomain_index;
  typedef std::pair<Vertex_handle, Vertex_handle> Edge;

  // Whether there can be constrained edges at all.
  static constexpr bool has_constrained_edges =
    ! std::is_same<Edge_is_constrained_map, Static_boolean_property_map<Edge, false> >::value;

  // Whether there can be walls that are to be taken away later.
  static constexpr bool has_seams = false;

  // Whether there can be cells in the regions of the domain that are not selected.
  static constexpr bool has_selection =
    ! std::is_same<Cell_is_selected_map, Static_boolean_property_map<Cell_handle, true> >::value;

  Selected_domain_3(const Tr& tr, const Cell_is_selected_map& is_selected,
                    const Edge_is_constrained_map& is_constrained)
    : m_tr(tr), m_is_selected(is_selected), m_is_constrained(is_constrained)
  { }

  bool contains(const Cell_handle c) const
  {
    return c->subdomain_index() != Subdomain_index() && ! m_tr.is_infinite(c) && get(m_is_selected, c);
  }

  // Whether the facet opposite to the vertex i of a cell of the domain must stay.
  bool is_wall(const Cell_handle c, const int i) const
  {
    const Cell_handle n = c->neighbor(i);
    return c->is_facet_on_surface(i) || n->subdomain_index() != c->subdomain_index() || ! get(m_is_selected, n);
  }

  bool is_constrained_edge(const Vertex_handle u, const Vertex_handle v) const
  {
    return get(m_is_constrained, Edge(u, v)) || get(m_is_constrained, Edge(v, u));
  }

  // A cell of it comes, or goes.
  void add(const Cell_handle c) { put(c, true); }
  void remove(const Cell_handle c) { put(c, false); }

private:
  void put(const Cell_handle c, const bool is_selected)
  {
    if constexpr(has_selection)
    {
      using boost::put;
      put(m_is_selected, c, is_selected);
    }
  }

  const Tr& m_tr;
  Cell_is_selected_map m_is_selected;
  Edge_is_constrained_map m_is_constrained;
};

// The domain that the named parameters `cell_is_selected_map` and `edge_is_constrained_map` select.
template <typename Tr, typename NamedParameters>
auto selected_domain(const Tr& tr, const NamedParameters& np)
{
  static_assert(Has_cell_indices<typename Tr::Cell>::value,
                "The cells of this triangulation have no regions and patches; mark_domain() gives them to those of "
                "CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type.");
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename Tr::Cell_handle                       Cell_handle;
  typedef typename Tr::Vertex_handle                     Vertex_handle;
  typedef std::pair<Vertex_handle, Vertex_handle>        Edge;
  typedef Static_boolean_property_map<Cell_handle, true> All_cells;
  typedef Static_boolean_property_map<Edge, false>       No_edge;
  const auto is_selected = choose_parameter<All_cells>(get_parameter(np, internal_np::cell_selector));
  const auto is_constrained = choose_parameter<No_edge>(get_parameter(np, internal_np::edge_is_constrained));
  return Selected_domain_3<Tr, std::decay_t<decltype(is_selected)>, std::decay_t<decltype(is_constrained)> >(
    tr, is_selected, is_constrained);
}

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

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SELECTED_DOMAIN_3_H
