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
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Stars the cavity of a field point from it, where millions of points are inserted. The cells are linked by a hash
 * table of the edges of the cavity, which is as large as the cavity needs: most have some ten faces, but the center of
 * a sphere sees all of it. Regions, and the marks of the faces, are carried over.
 *
 * The visitor is told of the cells that go and come, see `MeshingVisitor_3`.
 */
template <typename Tr>
class Insert_field_point_3
{
public:
  typedef Selected_domain_3<Tr>             Domain;
  typedef Mesh_visitor_3<Tr>                Visitor;
  typedef Field_point_cavity_3<Tr>          Cavity;
  typedef typename Tr::Vertex_handle        Vertex_handle;
  typedef typename Tr::Cell_handle          Cell_handle;
  typedef typename Cavity::Point            Point;

  Insert_field_point_3(Tr& tr, Domain& domain, Visitor& visitor) : m_tr(tr), m_domain(domain), m_visitor(visitor) { }

  // Inserts p; the cavity is that of p. Returns the new vertex. If memory is lacking, or the visitor throws beforehand,
  // or the domain, nothing is changed.
  Vertex_handle operator()(Cavity& cavity, const Point& p)
  {
    const Vertex_handle v = prepare(cavity);
    const Subdomain_index region = cavity.cells().front()->subdomain_index();
    v->set_point(typename Tr::Point(p));
    v->set_cell(m_new_cells.front());
    m_domain.own(v);
    if constexpr(Has_vertex_indices<typename Tr::Vertex>::value)
      internal::set_vertex_indices(*v, 3, region);
    glue_facets(cavity.faces(), region);
    glue_cells(cavity.faces());
    for(const Cell_handle c : cavity.cells())
      m_tr.tds().delete_cell(c);
    cavity.clear(false);
    m_visitor.after_cells_creation(m_new_cells);
    return v;
  }

private:
  typedef typename Cavity::Face              Face;
  typedef typename Tr::Cell::Subdomain_index Subdomain_index;

  static constexpr std::uint32_t empty = std::uint32_t(-1);

  // Creates the vertex and the cells.
  Vertex_handle prepare(const Cavity& cavity)
  {
    m_visitor.before_cells_removal(cavity.cells());
    clear_slots(cavity.faces().size());
    const Vertex_handle v = m_tr.tds().create_vertex();
    create_cells(v, cavity);
    return v;
  }

  // All of them, which are in the domain instead of those of the cavity, or none; then the vertex goes, too.
  void create_cells(const Vertex_handle v, const Cavity& cavity)
  {
    m_new_cells.clear();
    try {
      m_new_cells.reserve(cavity.faces().size());
      for(const Face& f : cavity.faces())
        m_new_cells.push_back(m_tr.tds().create_cell(f.vertices[0], f.vertices[1], f.vertices[2], v));
      exchange_in_domain(cavity.cells(), m_new_cells);
    } catch(...) {
      for(const Cell_handle c : m_new_cells)
      {
        try_to([&] { m_domain.remove(c); });
        m_tr.tds().delete_cell(c);
      }
      m_tr.tds().delete_vertex(v);
      for(const Cell_handle c : cavity.cells())
        try_to([&] { m_domain.add(c); });
      throw;
    }
  }

  // If the property map that tells the domain throws once more, the others are put back nevertheless.
  template <typename Work>
  static void try_to(const Work& work)
  {
    try {
      work();
    } catch(...) { }
  }

  void exchange_in_domain(const typename Cavity::Cells& old_cells, const std::vector<Cell_handle>& new_cells)
  {
    for(const Cell_handle c : old_cells)
      m_domain.remove(c);
    for(const Cell_handle c : new_cells)
      m_domain.add(c);
  }

  void glue_facets(const std::vector<Face>& faces, const Subdomain_index region)
  {
    for(std::size_t k = 0; k < faces.size(); ++k)
    {
      const Face& f = faces[k];
      const Cell_handle c = m_new_cells[k];
      const Cell_handle n = f.cell->neighbor(f.index);
      c->set_subdomain_index(region);
      c->set_surface_patch_index(3, f.cell->surface_patch_index(f.index));
      m_tr.tds().set_adjacency(c, 3, n, n->index(f.cell));
      for(const Vertex_handle v : f.vertices)
        v->set_cell(c);
    }
  }

  // At most three of eight will be in use.
  void clear_slots(const std::size_t number_of_faces)
  {
    std::size_t n = 16;
    while(n < 4 * number_of_faces)
      n *= 2;
    m_slots.assign(n, empty);
  }

  // Two cells whose faces have an edge in common are neighbors.
  void glue_cells(const std::vector<Face>& faces)
  {
    for(std::size_t k = 0; k < faces.size(); ++k)
    {
      const std::array<Vertex_handle, 3>& v = faces[k].vertices;
      const std::array<std::uint64_t, 3> shares = {{ hash_share(v[0]), hash_share(v[1]), hash_share(v[2]) }};
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
        std::uint32_t& slot = slot_of_edge(faces, v[a], v[b], shares[a] + shares[b]);
        if(slot == empty)
          slot = static_cast<std::uint32_t>(4 * k + i);
        else
          m_tr.tds().set_adjacency(m_new_cells[k], static_cast<int>(i),
                                   m_new_cells[slot / 4], static_cast<int>(slot % 4));
      }
    }
  }

  // That with the face from which the edge is passed in the other direction, from v to u; an empty one if it has not
  // been met.
  std::uint32_t& slot_of_edge(const std::vector<Face>& faces, const Vertex_handle u, const Vertex_handle v,
                              const std::uint64_t hash)
  {
    const auto is_edge = [&](const std::uint32_t facet)
    {
      const std::array<Vertex_handle, 3>& f = faces[facet / 4].vertices;
      const std::size_t k = facet % 4;
      return f[(k + 1) % 3] == v && f[(k + 2) % 3] == u;
    };
    std::size_t i = static_cast<std::size_t>(hash) & (m_slots.size() - 1);
    while(m_slots[i] != empty && ! is_edge(m_slots[i]))
      i = (i + 1) & (m_slots.size() - 1);
    return m_slots[i];
  }

  Tr& m_tr;
  Domain& m_domain;
  Visitor& m_visitor;
  std::vector<Cell_handle> m_new_cells; // in the order of the faces; the index of the new vertex is 3
  std::vector<std::uint32_t> m_slots;   // of edges: 4 times the number of a face, plus the index of its other vertex
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_INSERT_FIELD_POINT_3_H
