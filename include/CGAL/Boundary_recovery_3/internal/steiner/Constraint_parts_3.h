// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_CONSTRAINT_PARTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_CONSTRAINT_PARTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The mesh simplices that constraints with Steiner points on them consist of, looked up in the mesh.
 */
template <typename Tr>
class Constraint_parts_3
{
public:
  typedef typename Tr::Vertex_handle     Vertex_handle;
  typedef typename Tr::Cell_handle       Cell_handle;
  typedef Steiner_ledger_3<Tr>           Ledger;
  typedef std::array<Vertex_handle, 2>   Vertex_pair;
  typedef std::array<Vertex_handle, 3>   Vertex_triple;

  Constraint_parts_3(const Tr& tr, const Ledger& ledger)
    : m_tr(tr), m_ledger(ledger)
  { }

  // From one end to the other; none if some part is not a mesh edge.
  std::vector<Vertex_pair> of_edge(const std::size_t e) const
  {
    const std::vector<Vertex_pair> parts = chain(e);
    for(const Vertex_pair& part : parts)
    {
      Cell_handle c;
      int i, j;
      if(! m_tr.is_edge(part[0], part[1], c, i, j))
        return std::vector<Vertex_pair>();
    }
    return parts;
  }

  // In the orientation of the facet; none if they do not tile it. They do if, and only if, their boundary is that of
  // the facet: mesh facets do not overlap.
  std::vector<Vertex_triple> of_facet(const std::size_t f) const
  {
    std::vector<Vertex_triple> parts = facets_on(f);
    Odd_edges open;
    for(const Vertex_triple& part : parts)
      for(int i = 0; i < 3; ++i)
        open.toggle({{ part[i], part[(i + 1) % 3] }});
    for(const std::size_t e : m_ledger.constraints().edges_of_facet(f))
      for(const Vertex_pair& part : chain(e))
        open.toggle(part);
    if(! open.empty())
      return std::vector<Vertex_triple>();
    orient(parts, f);
    return parts;
  }

  // Takes those out of a list that are unions of mesh simplices.
  void take_out_unions(Lost_constraints& lost) const
  {
    if(m_ledger.points_on_constraints().empty())
      return;
    const auto is_edge_union = [this](const std::size_t e) { return ! of_edge(e).empty(); };
    const auto is_facet_union = [this](const std::size_t f) { return ! of_facet(f).empty(); };
    lost.edges.erase(std::remove_if(lost.edges.begin(), lost.edges.end(), is_edge_union), lost.edges.end());
    lost.facets.erase(std::remove_if(lost.facets.begin(), lost.facets.end(), is_facet_union), lost.facets.end());
  }

private:
  // The edges that came an odd number of times.
  class Odd_edges
  {
  public:
    bool empty() const { return m_size == 0; }

    void toggle(const Vertex_pair& e)
    {
      const std::size_t i = m_index.insert(e).first;
      m_is_odd.resize(m_index.size(), false);
      m_is_odd[i] = ! m_is_odd[i];
      if(m_is_odd[i])
        ++m_size;
      else
        --m_size;
    }

  private:
    Simplex_index_3<Vertex_handle, 2> m_index;
    std::vector<bool> m_is_odd;
    std::size_t m_size = 0;
  };

  std::vector<Vertex_pair> chain(const std::size_t e) const
  {
    const std::vector<Vertex_handle> vertices = m_ledger.vertices_on_edge(e);
    std::vector<Vertex_pair> parts;
    for(std::size_t i = 1; i < vertices.size(); ++i)
      parts.push_back({{ vertices[i - 1], vertices[i] }});
    return parts;
  }

  // The edges of the facet have a direction, and neighboring parts run through their common edge in opposite
  // directions.
  void orient(std::vector<Vertex_triple>& parts, const std::size_t f) const
  {
    std::vector<Vertex_pair> directed = boundary(f);
    std::vector<bool> is_done(parts.size(), false);
    while(! directed.empty())
    {
      const Vertex_pair e = directed.back();
      directed.pop_back();
      for(std::size_t i = 0; i < parts.size(); ++i)
      {
        Vertex_triple& p = parts[i];
        const auto end = p.end();
        if(is_done[i] || std::find(p.begin(), end, e[0]) == end || std::find(p.begin(), end, e[1]) == end)
          continue;
        is_done[i] = true;
        while(p[0] != e[0])
          std::rotate(p.begin(), p.begin() + 1, p.end());
        if(p[1] != e[1])
          std::swap(p[1], p[2]);
        directed.push_back({{ p[2], p[1] }});
        directed.push_back({{ p[0], p[2] }});
      }
    }
  }

  // The mesh edges around the facet f, in its direction.
  std::vector<Vertex_pair> boundary(const std::size_t f) const
  {
    const Vertex_triple& facet = m_ledger.constraints().facets()[f];
    std::vector<Vertex_pair> edges;
    for(int i = 0; i < 3; ++i)
    {
      std::vector<Vertex_pair> parts = chain(m_ledger.constraints().edges_of_facet(f)[i]);
      if(parts.front()[0] != facet[i])
        for(Vertex_pair& part : parts)
          std::swap(part[0], part[1]);
      edges.insert(edges.end(), parts.begin(), parts.end());
    }
    return edges;
  }

  // The mesh facets whose vertices are all on the facet f.
  std::vector<Vertex_triple> facets_on(const std::size_t f) const
  {
    Simplex_index_3<Vertex_handle, 3> facets;
    std::vector<Cell_handle> star;
    for(const Vertex_handle v : m_ledger.vertices_on_facet(f))
    {
      star.clear();
      m_tr.incident_cells(v, std::back_inserter(star));
      for(const Cell_handle c : star)
        for(int i = 0; i < 4; ++i)
        {
          const Vertex_triple facet = internal::facet_vertices(c, i);
          if(is_on(facet, f))
            facets.insert(facet);
        }
    }
    return facets.keys();
  }

  bool is_on(const Vertex_triple& facet, const std::size_t f) const
  {
    return m_ledger.is_on_facet(facet[0], f) && m_ledger.is_on_facet(facet[1], f)
        && m_ledger.is_on_facet(facet[2], f);
  }

  const Tr& m_tr;
  const Ledger& m_ledger;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_CONSTRAINT_PARTS_3_H
