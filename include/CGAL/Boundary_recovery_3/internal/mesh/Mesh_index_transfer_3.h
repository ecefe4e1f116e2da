// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_INDEX_TRANSFER_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_INDEX_TRANSFER_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Finds the parts of a facet that was split when some cells were replaced.
 *
 * It goes by combinatorics. A facet abc that is gone was split by a new vertex v if the facets abv, bcv and cav are
 * there; or if its edge ab is gone, and the facets avc and vbc are there. If cells around it were starred from a vertex
 * beside it, this may find the facets of a cone over it: they separate the same cells.
 */
template <typename Tr>
class Split_facets_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef std::array<Vertex_handle, 3>  Vertex_triple;

  // The new cells, and the vertices of the old ones.
  template <typename CellRange>
  Split_facets_3(const CellRange& new_cells, const Simplex_index_3<Vertex_handle, 1>& old_vertices)
  {
    for(const Cell_handle c : new_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_triple f = internal::facet_vertices(c, i);
        for(int j = 0; j < 3; ++j)
          add(f[j], f[(j + 1) % 3], f[(j + 2) % 3], old_vertices[{{ f[(j + 2) % 3] }}] == old_vertices.none);
      }
  }

  // The parts of a facet that is gone, oriented as it was; none if it was not split by one vertex.
  std::vector<Vertex_triple> operator()(const Vertex_triple& facet) const
  {
    std::vector<Vertex_triple> best;
    for(int i = 0; i < 3; ++i)
      for(const Vertex_handle v : new_vertices_at(facet[i], facet[(i + 1) % 3]))
      {
        const std::vector<Vertex_triple> parts = parts_at(facet, v);
        if(parts.size() > best.size())
          best = parts;
      }
    return best;
  }

private:
  // The facet uvw is there.
  void add(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w, const bool is_new)
  {
    const std::size_t e = m_edges.insert({{ u, v }}).first;
    if(e == m_new_vertices.size())
      m_new_vertices.emplace_back();
    if(is_new && ! internal::contains(m_new_vertices[e], w))
      m_new_vertices[e].push_back(w);
  }

  bool is_edge(const Vertex_handle u, const Vertex_handle v) const { return m_edges[{{ u, v }}] != m_edges.none; }

  // The new vertices w for which the facet uvw is there.
  const std::vector<Vertex_handle>& new_vertices_at(const Vertex_handle u, const Vertex_handle v) const
  {
    const std::size_t e = m_edges[{{ u, v }}];
    return e == m_edges.none ? m_nothing : m_new_vertices[e];
  }

  std::vector<Vertex_triple> parts_at(const Vertex_triple& facet, const Vertex_handle v) const
  {
    std::vector<Vertex_triple> parts;
    bool is_covered = true;
    for(int i = 0; i < 3; ++i)
    {
      Vertex_triple part = facet;
      part[i] = v;
      const Vertex_handle p = facet[(i + 1) % 3], q = facet[(i + 2) % 3];
      if(internal::contains(new_vertices_at(p, q), v))
        parts.push_back(part);
      else
        is_covered = is_covered && ! is_edge(p, q);
    }
    if(! is_covered || parts.size() < 2)
      parts.clear();
    return parts;
  }

  Simplex_index_3<Vertex_handle, 2> m_edges;
  std::vector<std::vector<Vertex_handle> > m_new_vertices; // at the edge with this number
  const std::vector<Vertex_handle> m_nothing;
};

/*
 * Gives cells that come in the place of others the indices of that place: the region, and the marks of facets.
 *
 * The facets of the old cells are remembered with the regions on both sides. A new cell has the region that is on its
 * side of those that it has, too, or parts of them. The other new cells have that of the cells beside them: there is
 * nothing in between.
 *
 * Infinite cells have the region of the infinite cells that were there.
 */
template <typename Tr>
class Mesh_index_transfer_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef typename Tr::Cell             Cell;
  typedef std::array<Vertex_handle, 3>  Vertex_triple;
  typedef typename Cell_indices<Cell>::Subdomain_index      Subdomain_index;
  typedef typename Cell_indices<Cell>::Surface_patch_index  Surface_patch_index;

  explicit Mesh_index_transfer_3(const Tr& tr) : m_tr(&tr) { }

  // The cells that go.
  template <typename CellRange>
  void collect(const CellRange& cells)
  {
    m_facets.clear();
    m_facet_index = Simplex_index_3<Vertex_handle, 3>();
    m_region.reset();
    m_infinite_region.reset();
    m_is_uniform = true;
    for(const Cell_handle c : cells)
      look_at(c);
    if(m_is_uniform)
      return;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        add_facet(c, i);
  }

  // The cells that come.
  template <typename CellRange>
  void distribute(const CellRange& cells)
  {
    if(! m_region)
      return;
    if(m_is_uniform)
    {
      for(const Cell_handle c : cells)
        c->set_subdomain_index(*m_region);
      return;
    }
    number_cells(cells);
    look_up_facets();
    if(add_parts_of_facets())
      look_up_facets();
    mark_facets();
    find_regions();
    spread_regions();
    for(const New_cell& c : m_cells)
      c.cell->set_subdomain_index(*c.region);
    mark_new_interfaces();
  }

  std::size_t number_of_ambiguous_cells() const { return m_number_of_ambiguous_cells; }

private:
  struct Facet
  {
    Vertex_triple vertices;
    std::array<Subdomain_index, 2> regions; // on the positive side, and on the other
    Surface_patch_index patch;
    bool is_there;                          // in the new cells, too, or parts of it

    bool is_marked() const { return ! (patch == Surface_patch_index()); }
  };

  struct New_cell
  {
    Cell_handle cell;
    std::array<std::size_t, 4> facets; // by their numbers; none if they are new
    std::optional<Subdomain_index> region;
  };

  static constexpr std::size_t none = std::size_t(-1);

  // --- the old cells ------------------------------------------------------------------------------------------------

  // Mostly there is one region, and no mark.
  void look_at(const Cell_handle c)
  {
    if(! m_region)
      m_region = c->subdomain_index();
    if(! m_infinite_region && m_tr->is_infinite(c))
      m_infinite_region = c->subdomain_index();
    m_is_uniform = m_is_uniform && *m_region == c->subdomain_index();
    for(int i = 0; i < 4; ++i)
      m_is_uniform = m_is_uniform && c->surface_patch_index(i) == Surface_patch_index();
  }

  void add_facet(const Cell_handle c, const int i)
  {
    const Vertex_triple vertices = internal::facet_vertices(c, i);
    if(m_facet_index.insert(vertices).second)
      m_facets.push_back(Facet{ vertices, {{ c->subdomain_index(), c->neighbor(i)->subdomain_index() }},
                                c->surface_patch_index(i), false });
  }

  // --- facets -------------------------------------------------------------------------------------------------------

  template <typename CellRange>
  void number_cells(const CellRange& cells)
  {
    m_cells.clear();
    m_cell_index = Simplex_index_3<Cell_handle, 1>();
    for(const Cell_handle c : cells)
    {
      m_cell_index.insert({{ c }});
      m_cells.push_back(New_cell{ c, {{ none, none, none, none }}, std::nullopt });
    }
  }

  void look_up_facets()
  {
    for(New_cell& c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        c.facets[i] = m_facet_index[internal::facet_vertices(c.cell, i)];
        if(c.facets[i] != none)
          m_facets[c.facets[i]].is_there = true;
      }
  }

  // Returns whether there are any.
  bool add_parts_of_facets()
  {
    const std::size_t n = m_facets.size();
    std::optional<Split_facets_3<Tr> > find_parts; // seldom needed
    for(std::size_t k = 0; k < n; ++k)
    {
      if(! is_lost_interface(m_facets[k]))
        continue;
      if(! find_parts)
        find_parts.emplace(new_cells(), old_vertices());
      for(const Vertex_triple& part : (*find_parts)(m_facets[k].vertices))
        add_part(k, part);
    }
    return m_facets.size() > n;
  }

  bool is_lost_interface(const Facet& f) const
  {
    return ! f.is_there && (f.is_marked() || ! (f.regions[0] == f.regions[1]));
  }

  void add_part(const std::size_t k, const Vertex_triple& part)
  {
    Facet f = m_facets[k];
    f.vertices = part;
    m_facets[k].is_there = true;
    if(m_facet_index.insert(part).second)
      m_facets.push_back(f);
  }

  std::vector<Cell_handle> new_cells() const
  {
    std::vector<Cell_handle> result;
    for(const New_cell& c : m_cells)
      result.push_back(c.cell);
    return result;
  }

  Simplex_index_3<Vertex_handle, 1> old_vertices() const
  {
    Simplex_index_3<Vertex_handle, 1> result;
    for(const Facet& f : m_facets)
      for(const Vertex_handle v : f.vertices)
        result.insert({{ v }});
    return result;
  }

  void mark_facets()
  {
    for(const New_cell& c : m_cells)
      for(int i = 0; i < 4; ++i)
        if(c.facets[i] != none)
          c.cell->set_surface_patch_index(i, m_facets[c.facets[i]].patch);
  }

  // --- regions ------------------------------------------------------------------------------------------------------

  // The region on the side of the facet i of a new cell, if that is an old one.
  std::optional<Subdomain_index> region_at(const New_cell& c, const int i) const
  {
    if(c.facets[i] == none)
      return std::nullopt;
    const Facet& f = m_facets[c.facets[i]];
    return f.regions[is_rotation(f.vertices, internal::facet_vertices(c.cell, i)) ? 0 : 1];
  }

  void find_regions()
  {
    for(New_cell& c : m_cells)
      if(m_infinite_region && m_tr->is_infinite(c.cell))
        c.region = m_infinite_region;
      else
        find_region(c);
  }

  // That of most of its facets. If that does not decide, that of the facet which was collected first.
  void find_region(New_cell& c)
  {
    int best = 0;
    std::size_t first = none;
    bool is_ambiguous = false;
    for(int i = 0; i < 4; ++i)
    {
      const std::optional<Subdomain_index> region = region_at(c, i);
      if(! region)
        continue;
      int count = 0;
      for(int j = 0; j < 4; ++j)
        count += region_at(c, j) == region;
      is_ambiguous = is_ambiguous || (c.region && ! (*c.region == *region));
      if(count > best || (count == best && c.facets[i] < first))
      {
        best = count;
        first = c.facets[i];
        c.region = region;
      }
    }
    m_number_of_ambiguous_cells += is_ambiguous;
  }

  // To the cells that have none, through new facets.
  void spread_regions()
  {
    std::vector<std::size_t> queue;
    for(std::size_t k = 0; k < m_cells.size(); ++k)
      if(m_cells[k].region && ! m_tr->is_infinite(m_cells[k].cell))
        queue.push_back(k);
    if(queue.size() == m_cells.size())
      return;
    const std::size_t number_of_seeds = queue.size();
    for(std::size_t q = 0; q < queue.size(); ++q)
      for_each_cell_beside(m_cells[queue[q]], [&](const std::size_t k)
      {
        if(m_cells[k].region)
          return;
        m_cells[k].region = m_cells[queue[q]].region;
        queue.push_back(k);
      });
    for(std::size_t q = number_of_seeds; q < queue.size(); ++q)
      m_number_of_ambiguous_cells += is_beside_other_region(m_cells[queue[q]]);
    give_region_to_others();
  }

  // Calls `work` with the numbers of the finite new cells behind the new facets of one.
  template <typename Work>
  void for_each_cell_beside(const New_cell& c, const Work& work) const
  {
    for(int i = 0; i < 4; ++i)
    {
      const std::size_t k = c.facets[i] == none ? m_cell_index[{{ c.cell->neighbor(i) }}] : none;
      if(k != none && ! m_tr->is_infinite(m_cells[k].cell))
        work(k);
    }
  }

  bool is_beside_other_region(const New_cell& c) const
  {
    bool result = false;
    for_each_cell_beside(c, [&](const std::size_t k) { result = result || m_cells[k].region != c.region; });
    return result;
  }

  // The old cells must have filled another place, or in another way.
  void give_region_to_others()
  {
    for(New_cell& c : m_cells)
      if(! c.region)
      {
        c.region = m_region;
        ++m_number_of_ambiguous_cells;
      }
  }

  // --- marks of new interfaces --------------------------------------------------------------------------------------

  // A new facet between two regions gets the mark that all the facets between them had that are gone.
  void mark_new_interfaces()
  {
    for(const New_cell& c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle n = c.cell->neighbor(i);
        if(c.facets[i] == none && ! (c.cell->subdomain_index() == n->subdomain_index()))
          c.cell->set_surface_patch_index(i, mark_between(c.cell->subdomain_index(), n->subdomain_index()));
      }
  }

  Surface_patch_index mark_between(const Subdomain_index& r, const Subdomain_index& s) const
  {
    std::optional<Surface_patch_index> mark;
    for(const Facet& f : m_facets)
      if(! f.is_there && ((f.regions[0] == r && f.regions[1] == s) || (f.regions[0] == s && f.regions[1] == r)))
      {
        if(mark && ! (*mark == f.patch))
          return Surface_patch_index();
        mark = f.patch;
      }
    return mark ? *mark : Surface_patch_index();
  }

  const Tr* m_tr;
  bool m_is_uniform = true;
  std::optional<Subdomain_index> m_region; // of the first old cell
  std::optional<Subdomain_index> m_infinite_region;
  Simplex_index_3<Vertex_handle, 3> m_facet_index;
  std::vector<Facet> m_facets; // by these numbers
  Simplex_index_3<Cell_handle, 1> m_cell_index;
  std::vector<New_cell> m_cells; // by these numbers
  std::size_t m_number_of_ambiguous_cells = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_INDEX_TRANSFER_3_H
