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

#include <CGAL/Boundary_recovery_3/internal/mesh/Cell_replacement.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Split_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/partition_graph.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
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
  typedef Mesh_part_3<Tr>              Part;

  explicit Decomposition_3(Tr& tr) : m_tr(tr) { }

  // Makes the parts, fewer if there are few cells. Constrained edges are given by arrays of two vertex handles. The
  // vertices have the numbers that they have in the range, and then any ones.
  template <typename SizingField, typename Domain, typename EdgeRange, typename VertexRange>
  std::vector<Part> divide(const SizingField& size, const Domain& domain, const EdgeRange& constrained_edges,
                           const std::size_t number_of_parts, const VertexRange& first_vertices)
  {
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(domain.contains(c))
        m_cells.push_back(c);
    Region_sizes_3<Tr, SizingField>(m_tr, size).ask_at_vertices(m_cells);
    const std::vector<std::size_t> partition = internal::partition_graph(dual_graph(size, domain), number_of_parts);

    for(const Vertex_handle v : first_vertices)
      m_vertices.push_back(v);
    for(std::size_t k = m_vertices.size(); k-- > 0; ) // the first one of the same vertices counts
      m_numbers[m_vertices[k]] = k;
    Unique_hash_map<Vertex_handle, std::uint32_t> positions(none); // for looking up only
    Part whole;
    for(const Cell_handle c : m_cells)
    {
      typename Part::Tetrahedron t;
      for(int i = 0; i < 4; ++i)
      {
        std::uint32_t& position = positions[c->vertex(i)];
        if(position == none)
        {
          position = static_cast<std::uint32_t>(whole.vertices.size());
          whole.vertices.emplace_back(number_of(c->vertex(i)), *c->vertex(i));
        }
        t[static_cast<std::size_t>(i)] = position;
      }
      whole.tetrahedra.push_back(t);
      whole.cell_indices.emplace_back(*c);
    }
    for(const auto& e : constrained_edges)
      if(positions[e[0]] != none && positions[e[1]] != none)
        whole.constrained_edges.push_back({{ positions[e[0]], positions[e[1]] }});
    for(const auto& v : whole.vertices)
      m_numbers_in_domain.push_back(v.number);
    std::vector<Part> parts;
    for(auto& group : Split_part_3<Tr>()(whole, { partition.begin(), partition.end() }))
      parts.push_back(std::move(group.second));
    return parts;
  }

  // From which on numbers of vertices are free.
  std::size_t number_of_vertices() const { return m_vertices.size(); }

  // Vertices of the triangulation that are free in the mesh may be elsewhere then, or gone.
  void put_into_triangulation(const std::vector<Part>& parts, const std::size_t number_of_vertices)
  {
    const std::size_t old_number = m_vertices.size();
    std::vector<char> is_used(number_of_vertices, false);
    m_vertices.resize(number_of_vertices);
    for(const Part& part : parts)
      for(const auto& v : part.vertices)
      {
        if(is_used[v.number])
          continue;
        is_used[v.number] = true;
        if(v.number >= old_number)
          m_vertices[v.number] = m_tr.tds().create_vertex();
        if(v.number >= old_number || m_vertices[v.number]->in_dimension() == 3)
          v.give_to(*m_vertices[v.number]);
      }
    replace_cells(parts);
    for(const std::size_t v : m_numbers_in_domain)
      if(! is_used[v])
        m_tr.tds().delete_vertex(m_vertices[v]);
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);
  static constexpr std::size_t no_number = std::size_t(-1);

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
      const Coordinates_3 p = internal::centroid(corners);
      const double size = query(typename Tr::Geom_traits::Point_3(p[0], p[1], p[2]), 3,
                                Region_sizes_3<Tr, SizingField>::region(c));
      const double unit = internal::binary_scale(size), h = size / unit;
      const Cell_shape_3 shape(internal::multiplied(corners, 1 / unit));
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

  std::size_t number_of(const Vertex_handle v)
  {
    std::size_t& number = m_numbers[v];
    if(number == no_number)
    {
      number = m_vertices.size();
      m_vertices.push_back(v);
    }
    return number;
  }

  void replace_cells(const std::vector<Part>& parts)
  {
    std::vector<std::array<Vertex_handle, 4> > tetrahedra;
    tetrahedra.reserve(internal::number_of_cells(parts));
    for(const Part& part : parts)
      for(const auto& t : part.tetrahedra)
      {
        const auto vertex = [&](const std::size_t i) { return m_vertices[part.vertices[t[i]].number]; };
        tetrahedra.push_back({{ vertex(0), vertex(1), vertex(2), vertex(3) }});
      }
    Cell_replacement<Tr> replacement;
    auto cell = replacement(m_tr, m_cells, tetrahedra).begin();
    for(const Part& part : parts)
      for(const auto& indices : part.cell_indices)
        indices.give_to(**cell++);
  }

  Tr& m_tr;
  std::vector<Cell_handle> m_cells;      // of the domain, before it was divided
  std::vector<Vertex_handle> m_vertices; // by number
  std::vector<std::size_t> m_numbers_in_domain;
  Unique_hash_map<Vertex_handle, std::size_t> m_numbers{ no_number }; // for looking up only
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_DECOMPOSITION_3_H
