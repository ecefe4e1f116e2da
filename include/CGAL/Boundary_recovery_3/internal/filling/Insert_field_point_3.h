// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_INSERT_FIELD_POINT_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_INSERT_FIELD_POINT_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_cavity_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Stars the cavity of a field point from it, where millions of points are inserted: the cells are linked by a table of
 * the edges of the cavity. Regions, and the marks of the faces, are carried over.
 *
 * The visitor is told of the cells that go and come, see `CellReplacementVisitor_3`.
 */
template <typename Tr, typename Domain, typename Visitor>
class Insert_field_point_3
{
public:
  typedef Field_point_cavity_3<Tr, Domain>  Cavity;
  typedef typename Tr::Vertex_handle        Vertex_handle;
  typedef typename Tr::Cell_handle          Cell_handle;
  typedef typename Cavity::Point            Point;

  Insert_field_point_3(Tr& tr, Domain& domain, Visitor& visitor) : m_tr(tr), m_domain(domain), m_visitor(visitor) { }

  // Inserts p; the cavity is that of p. Returns the new vertex. If memory is lacking, or the visitor throws beforehand,
  // nothing is changed.
  Vertex_handle operator()(Cavity& cavity, const Point& p)
  {
    const Vertex_handle v = prepare(cavity);
    v->set_point(typename Tr::Point(p));
    v->set_cell(m_new_cells.front());
    glue_facets(cavity.cells().front()->subdomain_index());
    glue_cells(cavity.vertices());
    for(const Cell_handle c : cavity.cells())
    {
      m_domain.remove(c);
      m_tr.tds().delete_cell(c);
    }
    cavity.clear(false);
    m_visitor.after_cells_creation(m_new_cells);
    return v;
  }

private:
  typedef typename Tr::Cell                     Cell;
  typedef typename Cell::Subdomain_index        Subdomain_index;
  typedef typename Cell::Surface_patch_index    Surface_patch_index;

  // What is left of a face when the cells of the cavity are gone: the facet of the cell behind it, and its mark.
  struct Facet
  {
    std::array<Vertex_handle, 3> vertices; // as those of the face
    Cell_handle cell;
    int index;
    Surface_patch_index patch;
  };

  // Creates the vertex and the cells.
  Vertex_handle prepare(Cavity& cavity)
  {
    try {
      m_visitor.before_cells_removal(cavity.cells());
      collect_facets(cavity);
      reserve_edges(cavity.vertices().size());
      const Vertex_handle v = m_tr.tds().create_vertex();
      create_cells(v);
      return v;
    } catch(...) {
      cavity.clear(true);
      throw;
    }
  }

  void collect_facets(const Cavity& cavity)
  {
    m_facets.clear();
    for(const auto& f : cavity.faces())
    {
      const Cell_handle n = f.cell->neighbor(f.index);
      m_facets.push_back(Facet{ f.vertices, n, n->index(f.cell), f.cell->surface_patch_index(f.index) });
    }
  }

  // All of them, or none; then the vertex goes, too.
  void create_cells(const Vertex_handle v)
  {
    m_new_cells.clear();
    m_new_cells.reserve(m_facets.size());
    try {
      for(const Facet& f : m_facets)
        m_new_cells.push_back(m_tr.tds().create_cell(f.vertices[0], f.vertices[1], f.vertices[2], v));
    } catch(...) {
      for(const Cell_handle c : m_new_cells)
        m_tr.tds().delete_cell(c);
      m_tr.tds().delete_vertex(v);
      throw;
    }
  }

  void glue_facets(const Subdomain_index region)
  {
    for(std::size_t k = 0; k < m_facets.size(); ++k)
    {
      const Facet& f = m_facets[k];
      const Cell_handle c = m_new_cells[k];
      c->set_subdomain_index(region);
      c->set_surface_patch_index(3, f.patch);
      m_tr.tds().set_adjacency(c, 3, f.cell, f.index);
      for(const Vertex_handle v : f.vertices)
        v->set_cell(c);
      m_domain.add(c);
    }
  }

  void reserve_edges(const std::size_t n)
  {
    if(m_facet_at_edge.size() < n * n)
      m_facet_at_edge.resize(n * n);
  }

  // Two cells whose faces have an edge in common are neighbors. These faces pass along it in opposite directions, so
  // that each direction belongs to one of them: no entry of the table is read that was not written before.
  void glue_cells(const Local_numbers<Vertex_handle>& number)
  {
    const std::size_t n = number.size();
    const auto for_each_edge = [&](const auto& work)
    {
      for(std::size_t k = 0; k < m_facets.size(); ++k)
      {
        const std::array<Vertex_handle, 3>& f = m_facets[k].vertices;
        const std::array<std::size_t, 3> v = {{ number[f[0]], number[f[1]], number[f[2]] }};
        for(std::size_t i = 0; i < 3; ++i)
          work(v[(i + 1) % 3], v[(i + 2) % 3], static_cast<std::uint32_t>(4 * k + i));
      }
    };
    for_each_edge([&](const std::size_t u, const std::size_t v, const std::uint32_t facet)
    {
      m_facet_at_edge[u * n + v] = facet;
    });
    for_each_edge([&](const std::size_t u, const std::size_t v, const std::uint32_t facet)
    {
      m_new_cells[facet / 4]->set_neighbor(static_cast<int>(facet % 4), m_new_cells[m_facet_at_edge[v * n + u] / 4]);
    });
  }

  Tr& m_tr;
  Domain& m_domain;
  Visitor& m_visitor;
  std::vector<Facet> m_facets;
  std::vector<Cell_handle> m_new_cells;       // in the order of the facets; the index of the new vertex is 3
  std::vector<std::uint32_t> m_facet_at_edge; // by two vertices: 4 times the number of a new cell, plus its facet's
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_INSERT_FIELD_POINT_3_H
