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
#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The part of a triangulation that is filled or improved: the cells of the regions of the domain, as far as they are
 * selected. Its walls are the constrained facets, and those to cells that do not belong to it. Edges may be
 * constrained, too.
 *
 * What selects cells and constrains edges are the caller's property maps, of whatever types.
 *
 * Where the triangulation is a part of a larger mesh, some walls are seams: they are on no surface, have nothing behind
 * them, and are to be taken away later.
 */
template <typename Tr>
class Selected_domain_3
{
public:
  typedef typename Tr::Vertex_handle              Vertex_handle;
  typedef typename Tr::Cell_handle                Cell_handle;
  typedef typename Tr::Cell::Subdomain_index      Subdomain_index;
  typedef std::pair<Vertex_handle, Vertex_handle> Edge;

  // All cells of the regions, and no edge is constrained.
  explicit Selected_domain_3(const Tr& tr) : m_tr(tr) { }

  // From now on, the domain consists of the cells that a property map from cells to Booleans selects. It is kept up to
  // date.
  template <typename Cell_is_selected_map>
  void select([[maybe_unused]] const Cell_is_selected_map& map)
  {
    if constexpr(! std::is_same<Cell_is_selected_map, Static_boolean_property_map<Cell_handle, true> >::value)
      m_selection = std::make_shared<Map_selection<Cell_is_selected_map> >(map);
  }

  // The edges that a property map from pairs of vertices to Booleans tells are constrained.
  template <typename Edge_is_constrained_map>
  void constrain_edges([[maybe_unused]] const Edge_is_constrained_map& map)
  {
    if constexpr(! std::is_same<Edge_is_constrained_map, Static_boolean_property_map<Edge, false> >::value)
      m_is_constrained = [map](const Edge& e)
      {
        using boost::get;
        return bool(get(map, e));
      };
  }

  // The facets of cells without a region that are on no surface are seams.
  void set_has_seams() { m_has_seams = true; }

  // From now on, it consists of the inner cells of a part, see `vertex_owners.h`.
  void select_part(const Part_number part) { m_part = part; }

  // A new vertex belongs to that part.
  void own([[maybe_unused]] const Vertex_handle v) const
  {
    if constexpr(Has_part<typename Tr::Vertex>::value)
      if(m_part != 0)
        v->set_part(m_part);
  }

  // Whether there can be constrained edges at all.
  bool has_constrained_edges() const { return bool(m_is_constrained); }

  // Whether there can be walls that are to be taken away later.
  bool has_seams() const { return m_has_seams; }

  // Whether there can be cells in the regions of the domain that are not selected.
  bool has_selection() const { return bool(m_selection) || m_part != 0; }

  bool contains(const Cell_handle c) const
  {
    return c->subdomain_index() != Subdomain_index() && ! m_tr.is_infinite(c) && is_selected(c);
  }

  // Whether the facet opposite to the vertex i of a cell of the domain must stay.
  bool is_wall(const Cell_handle c, const int i) const
  {
    const Cell_handle n = c->neighbor(i);
    return c->is_facet_on_surface(i) || n->subdomain_index() != c->subdomain_index() || is_border(c, i)
        || (m_selection && ! m_selection->contains(n));
  }

  // Whether that is so only because the cell behind the facet, of the same region, is no inner cell of the part.
  bool is_border([[maybe_unused]] const Cell_handle c, [[maybe_unused]] const int i) const
  {
    if constexpr(Has_part<typename Tr::Vertex>::value)
      return m_part != 0 && internal::is_facet_on_border(*c, i) && ! c->is_facet_on_surface(i)
          && c->neighbor(i)->subdomain_index() == c->subdomain_index() && is_beyond_border(c->neighbor(i));
    return false;
  }

  // Whether a cell is no inner cell of the part, whatever is known of the border.
  bool is_beyond_border([[maybe_unused]] const Cell_handle c) const
  {
    if constexpr(Has_part<typename Tr::Vertex>::value)
      if(m_part != 0 && internal::owner_of_cell(*c) != m_part)
        return m_is_border_met = true;
    return false;
  }

  // Whether a cell of a part has a vertex on the border.
  bool is_at_border([[maybe_unused]] const Cell_handle c) const
  {
    if constexpr(Has_part<typename Tr::Vertex>::value)
      return m_part != 0 && internal::is_at_border(*c);
    return false;
  }

  // Whether the border was in the way since the last call of the second function.
  bool is_border_met() const { return m_is_border_met; }
  void forget_border() const { m_is_border_met = false; }

  // Whether it must stay for now only.
  bool is_seam(const Cell_handle c, const int i) const
  {
    return m_has_seams && ! c->is_facet_on_surface(i) && c->neighbor(i)->subdomain_index() == Subdomain_index();
  }

  bool is_constrained_edge(const Vertex_handle u, const Vertex_handle v) const
  {
    return has_constrained_edges() && (m_is_constrained(Edge(u, v)) || m_is_constrained(Edge(v, u)));
  }

  // A cell of it comes, or goes.
  void add(const Cell_handle c) { set_selected(c, true); }
  void remove(const Cell_handle c) { set_selected(c, false); }

private:
  struct Selection
  {
    virtual ~Selection() = default;
    virtual bool contains(Cell_handle c) const = 0;
    virtual void set(Cell_handle c, bool is_selected) = 0;
  };

  template <typename Map>
  struct Map_selection final
    : public Selection
  {
    explicit Map_selection(const Map& map) : map(map) { }

    bool contains(const Cell_handle c) const override
    {
      using boost::get;
      return bool(get(map, c));
    }

    void set(const Cell_handle c, const bool is_selected) override
    {
      using boost::put;
      put(map, c, is_selected);
    }

    Map map;
  };

  bool is_selected(const Cell_handle c) const
  {
    if constexpr(Has_part<typename Tr::Vertex>::value)
      if(m_part != 0 && internal::owner_of_cell(*c) != m_part)
        return false;
    return ! m_selection || m_selection->contains(c);
  }

  void set_selected(const Cell_handle c, const bool is_selected)
  {
    if(m_selection)
      m_selection->set(c, is_selected);
  }

  const Tr& m_tr;
  std::shared_ptr<Selection> m_selection;            // none: all cells
  std::function<bool(const Edge&)> m_is_constrained; // none: no edge
  bool m_has_seams = false;
  Part_number m_part = 0; // 0: all cells
  mutable bool m_is_border_met = false;
};

// The domain that the named parameters `cell_is_selected_map` and `edge_is_constrained_map` select.
template <typename Tr, typename NamedParameters>
Selected_domain_3<Tr> selected_domain(const Tr& tr, const NamedParameters& np)
{
  static_assert(Has_cell_indices<typename Tr::Cell>::value,
                "The cells of this triangulation have no regions and patches; mark_domain() gives them to those of "
                "CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type.");
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  Selected_domain_3<Tr> domain(tr);
  if constexpr(! is_default_parameter<NamedParameters, internal_np::cell_selector_t>::value)
    domain.select(get_parameter(np, internal_np::cell_selector));
  if constexpr(! is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value)
    domain.constrain_edges(get_parameter(np, internal_np::edge_is_constrained));
  return domain;
}

/*
 * The visitor of whatever exchanges cells of one region of a domain at a time, with no wall between them: keeps the
 * domain and the indices of its cells up to date, and hands on everything to another visitor, which finds them so.
 */
template <typename Tr>
class Domain_keeper_3
  : public Forwarding_visitor_3<Tr>
{
  using Forwarding_visitor_3<Tr>::m_visitor;

public:
  typedef typename Tr::Cell_handle           Cell_handle;
  typedef typename Tr::Cell::Subdomain_index Subdomain_index;
  typedef Selected_domain_3<Tr>              Domain;
  typedef Mesh_visitor_3<Tr>                 Visitor;
  typedef Cell_span<Cell_handle>             Cells;

  Domain_keeper_3(Domain& domain, Visitor& visitor) : Forwarding_visitor_3<Tr>(visitor), m_domain(domain) { }

  void before_cells_removal(const Cells& cells) override
  {
    m_visitor.before_cells_removal(cells);
    m_region = (*cells.begin())->subdomain_index();
    m_is_exchanging = true;
    for(const Cell_handle c : cells)
      m_domain.remove(c);
  }

  void after_cells_creation(const Cells& cells) override
  {
    for(const Cell_handle c : cells)
      set_indices(c);
    after_cells_return(cells);
  }

  // The same for cells that have their indices, maybe of several regions, since they were there before.
  void after_cells_return(const Cells& cells)
  {
    add_to_domain(cells);
    m_visitor.after_cells_creation(cells);
  }

  // To be called if the exchange of these cells threw: if they are still there, they are in the domain again.
  void after_failure(const Cells& cells)
  {
    if(m_is_exchanging)
      add_to_domain(cells);
  }

private:
  void add_to_domain(const Cells& cells)
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
  Subdomain_index m_region = Subdomain_index(); // of the cells that are exchanged
  bool m_is_exchanging = false;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_SELECTED_DOMAIN_3_H
