// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_DECOMPOSITION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_DECOMPOSITION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Region_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Cell_replacement.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Divided_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/partition_graph.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Divides the domain of a triangulation into parts that will have about the same number of cells when it is filled, and
 * puts into the triangulation what the parts have become.
 */
template <typename Tr>
class Decomposition_3
{
public:
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef Divided_mesh_3<Tr>           Mesh;

  explicit Decomposition_3(Tr& tr) : m_tr(tr) { }

  // Makes the arrays. Constrained edges are given by arrays of two vertex handles.
  template <typename SizingField, typename Domain, typename EdgeRange>
  void divide(const SizingField& size, const Domain& domain, const EdgeRange& constrained_edges,
              const std::size_t number_of_parts, Mesh& mesh)
  {
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(domain.contains(c))
        m_cells.push_back(c);
    Region_sizes_3<Tr, SizingField>(m_tr, size).ask_at_vertices(m_cells);
    const std::vector<std::size_t> parts = internal::partition_graph(dual_graph(size, domain), number_of_parts);

    Unique_hash_map<Vertex_handle, std::size_t> numbers; // for looking up only
    mesh.parts.resize(number_of_parts);
    for(std::size_t k = 0; k < m_cells.size(); ++k)
    {
      std::array<std::size_t, 4> t;
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle v = m_cells[k]->vertex(i);
        if(! numbers.is_defined(v))
        {
          numbers[v] = m_vertices.size();
          m_vertices.push_back(v);
          mesh.vertices.emplace_back(*v);
        }
        t[i] = numbers[v];
      }
      mesh.parts[parts[k]].push_back({ t, Cell_indices<typename Tr::Cell>(*m_cells[k]) });
    }
    for(const auto& e : constrained_edges)
      if(numbers.is_defined(e[0]) && numbers.is_defined(e[1]))
        mesh.constrained_edges.push_back({{ numbers[e[0]], numbers[e[1]] }});
  }

  // Vertices of the triangulation that are free in the mesh may be elsewhere then, or gone.
  void put_into_triangulation(const Mesh& mesh)
  {
    std::vector<char> is_used(mesh.vertices.size(), false);
    for(const auto& part : mesh.parts)
      for(const auto& c : part)
        for(const std::size_t v : c.vertices)
          is_used[v] = true;
    const std::size_t old_number = m_vertices.size();
    for(std::size_t v = 0; v < mesh.vertices.size(); ++v)
    {
      if(v >= old_number)
        m_vertices.push_back(is_used[v] ? m_tr.tds().create_vertex() : Vertex_handle());
      if(is_used[v] && (v >= old_number || m_vertices[v]->in_dimension() == 3))
        mesh.vertices[v].give_to(*m_vertices[v]);
    }
    replace_cells(mesh);
    for(std::size_t v = 0; v < old_number; ++v)
      if(! is_used[v])
        m_tr.tds().delete_vertex(m_vertices[v]);
  }

private:
  // How many cells there are to be in a cell, and how many facets in a facet, for the sizes at its centroid.
  template <typename SizingField, typename Domain>
  Weighted_graph dual_graph(const SizingField& field, const Domain& domain) const
  {
    Size_query_3<Tr, SizingField> query(field);
    Unique_hash_map<Cell_handle, std::size_t> numbers; // for looking up only
    for(std::size_t k = 0; k < m_cells.size(); ++k)
      numbers[m_cells[k]] = k;
    Weighted_graph graph;
    for(const Cell_handle c : m_cells)
    {
      const auto corners = internal::corners(c);
      const Cell_shape_3 shape(corners);
      const Coordinates_3 p = internal::centroid(corners);
      const double h = query(typename Tr::Geom_traits::Point_3(p[0], p[1], p[2]), 3,
                             Region_sizes_3<Tr, SizingField>::region(c));
      graph.begin_node(1 + (h > 0 ? std::sqrt(2.) * shape.volume_times_6 / (h * h * h) : 0));
      for(int i = 0; i < 4; ++i)
        if(numbers.is_defined(c->neighbor(i)))
        {
          const double area = 0.5 * std::sqrt(internal::dot_product(shape.normals[i], shape.normals[i]));
          const bool costs_nothing = domain.is_wall(c, i) || ! (h > 0);
          graph.add_edge(numbers[c->neighbor(i)],
                         costs_nothing ? 1 : 2 + static_cast<int>((std::min)(1e5, area / (h * h))));
        }
    }
    make_symmetric(graph);
    return graph;
  }

  // An edge has the smaller one of the weights at its ends.
  static void make_symmetric(Weighted_graph& graph)
  {
    for(std::size_t u = 0; u < graph.node_weights.size(); ++u)
      for(std::size_t k = graph.edge_begin[u]; k < graph.edge_end(u); ++k)
        for(std::size_t l = graph.edge_begin[graph.ends[k]]; l < graph.edge_end(graph.ends[k]); ++l)
          if(graph.ends[l] == u)
            graph.edge_weights[k] = graph.edge_weights[l] = (std::min)(graph.edge_weights[k], graph.edge_weights[l]);
  }

  void replace_cells(const Mesh& mesh)
  {
    std::vector<std::array<Vertex_handle, 4> > tetrahedra;
    tetrahedra.reserve(mesh.number_of_cells());
    for(const auto& part : mesh.parts)
      for(const auto& c : part)
        tetrahedra.push_back({{ m_vertices[c.vertices[0]], m_vertices[c.vertices[1]], m_vertices[c.vertices[2]],
                                m_vertices[c.vertices[3]] }});
    Cell_replacement<Tr> replacement;
    auto cell = replacement(m_tr, m_cells, tetrahedra).begin();
    for(const auto& part : mesh.parts)
      for(const auto& c : part)
        c.indices.give_to(**cell++);
  }

  Tr& m_tr;
  std::vector<Cell_handle> m_cells;      // of the domain, before it was divided
  std::vector<Vertex_handle> m_vertices; // by number
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_DECOMPOSITION_3_H
