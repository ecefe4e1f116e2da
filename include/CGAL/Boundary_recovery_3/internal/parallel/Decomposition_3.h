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

#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/numbers/binary_scale.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Size_query_3.h>

#include <CGAL/Unique_hash_map.h>

#ifdef CGAL_METIS_ENABLED
#include <metis.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Fills a domain coarsely: what is divided into sub-domains then. The smaller these are, the finer it has to be, for
 * seams are about as thick as its cells.
 */
template <typename Tr>
class Fill_background_3
{
public:
  typedef typename Tr::Geom_traits::Point_3 Point_3;
  typedef Size_field_3<Point_3>             Size_field;

  Fill_background_3(const Size_field& size, const double forecast_of_cells, const std::size_t number_of_subdomains)
    : m_field(size, coarseness(forecast_of_cells, number_of_subdomains))
  { }

  Field_points_result_3<Tr> operator()(Tr& tr, Selected_domain_3<Tr>& domain, Mesh_visitor_3<Tr>& visitor,
                                       const std::size_t max_number_of_vertices, const double seconds_left) const
  {
    Field_point_insertion_3<Tr> insertion(tr, domain, m_field, visitor, Forecast_effort::none);
    insertion.ignore_sizes_of_walls();
    insertion.leave_sizes_of_field();
    return insertion(max_number_of_vertices, seconds_left);
  }

private:
  // See "Tuning constants" in the manual.
  static constexpr double background_coarseness = 8;
  static constexpr double background_cells_per_subdomain = 1000;

  struct Coarse_field final
    : public Size_field
  {
    Coarse_field(const Size_field& field, const double factor) : field(field), factor(factor) { }

    double operator()(const Point_3& p, const int dimension, const int index) const override
    {
      return factor * field(p, dimension, index);
    }

    double least_size_around(const Point_3& p, const double radius, const int index) const override
    {
      return factor * field.least_size_around(p, radius, index);
    }

    double grading() const override { return factor * field.grading(); }
    bool tells_least_sizes() const override { return true; }

    const Size_field& field;
    double factor;
  };

  static double coarseness(const double forecast_of_cells, const std::size_t number_of_subdomains)
  {
    const double number = background_cells_per_subdomain * static_cast<double>(number_of_subdomains);
    return (std::max)(1., (std::min)(background_coarseness, std::cbrt(forecast_of_cells / number)));
  }

  const Coarse_field m_field;
};

// A graph whose nodes and edges have weights; each edge is named at both of its ends.
struct Weighted_graph
{
  void begin_node(const double weight)
  {
    node_weights.push_back(weight);
    edge_begin.push_back(ends.size());
  }

  // Of the node that was begun last.
  void add_edge(const std::size_t end, const int weight)
  {
    ends.push_back(end);
    edge_weights.push_back(weight);
  }

  std::size_t edge_end(const std::size_t node) const
  {
    return node + 1 < edge_begin.size() ? edge_begin[node + 1] : ends.size();
  }

  double weight() const { return std::accumulate(node_weights.begin(), node_weights.end(), 0.); }

  std::vector<double>      node_weights;
  std::vector<std::size_t> edge_begin; // of each node
  std::vector<std::size_t> ends;
  std::vector<int>         edge_weights;
};

// See "Tuning constants" in the manual.
constexpr std::size_t graph_nodes_per_part = 16;

// Makes heavy nodes lighter, until none has more than this share of all weights. There are more nodes than that.
inline void limit_weights(Weighted_graph& graph, const std::size_t least_number_of_shares)
{
  for(double largest = 0, limit = -1; largest > limit; )
  {
    limit = graph.weight() / static_cast<double>(least_number_of_shares);
    largest = *std::max_element(graph.node_weights.begin(), graph.node_weights.end());
    for(double& w : graph.node_weights)
      w = (std::min)(w, limit);
    limit *= 1 + 1e-3; // it need not be exact
  }
}

#ifdef CGAL_METIS_ENABLED

// The part of each node, by METIS, with a seed that does not change.
inline std::vector<std::size_t> parts_by_metis(Weighted_graph graph, const std::size_t number_of_parts)
{
  limit_weights(graph, graph_nodes_per_part / 4 * number_of_parts);
  const double scale = 1e8 / graph.weight(); // integers whose sum does not overflow
  std::vector<idx_t> weights, part(graph.node_weights.size()),
                     begin(graph.edge_begin.begin(), graph.edge_begin.end()),
                     ends(graph.ends.begin(), graph.ends.end()),
                     edge_weights(graph.edge_weights.begin(), graph.edge_weights.end());
  for(const double w : graph.node_weights)
    weights.push_back(1 + static_cast<idx_t>(scale * w));
  begin.push_back(static_cast<idx_t>(ends.size()));
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 0;
  idx_t number_of_nodes = static_cast<idx_t>(part.size()), number_of_constraints = 1, cut = 0,
        parts = static_cast<idx_t>(number_of_parts);
  const int status = METIS_PartGraphKway(&number_of_nodes, &number_of_constraints, begin.data(), ends.data(),
                                         weights.data(), nullptr, edge_weights.data(), &parts, nullptr, nullptr,
                                         options, &cut, part.data());
  if(status != METIS_OK) // the graph is one that METIS takes, so it is memory that is lacking
    throw std::bad_alloc();
  return std::vector<std::size_t>(part.begin(), part.end());
}

#else

// The part of each node: they are taken in breadth-first order, until a part is heavy enough.
inline std::vector<std::size_t> parts_by_search(const Weighted_graph& graph, const std::size_t number_of_parts)
{
  const std::size_t n = graph.node_weights.size();
  const double weight_of_part = graph.weight() / static_cast<double>(number_of_parts);
  std::vector<std::size_t> part(n, number_of_parts), queue;
  double done = 0;
  std::size_t first = 0;
  for(std::size_t root = 0; root < n; ++root)
  {
    if(part[root] == number_of_parts)
    {
      part[root] = 0;
      queue.push_back(root);
    }
    for( ; first < queue.size(); ++first)
    {
      const std::size_t u = queue[first];
      part[u] = (std::min)(number_of_parts - 1, static_cast<std::size_t>(done / weight_of_part));
      done += graph.node_weights[u];
      for(std::size_t k = graph.edge_begin[u]; k < graph.edge_end(u); ++k)
        if(part[graph.ends[k]] == number_of_parts)
        {
          part[graph.ends[k]] = 0; // it is in the queue
          queue.push_back(graph.ends[k]);
        }
    }
  }
  return part;
}

#endif // CGAL_METIS_ENABLED

/*
 * Returns the part, from 0 on, of each node, so that parts have about the same weight and few edges between them, as
 * few as METIS finds, if it is linked. There are fewer parts if the graph is small. METIS prints if a part gets no
 * node; so none is heavier than a fraction of a part.
 */
inline std::vector<std::size_t> partition_graph(const Weighted_graph& graph, const std::size_t number_of_parts)
{
  const std::size_t number = (std::min)(number_of_parts, graph.node_weights.size() / graph_nodes_per_part);
  if(number < 2)
    return std::vector<std::size_t>(graph.node_weights.size(), 0);
#ifdef CGAL_METIS_ENABLED
  return internal::parts_by_metis(graph, number);
#else
  return internal::parts_by_search(graph, number);
#endif
}

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
  typedef Size_field_3<typename Tr::Geom_traits::Point_3> Size_field;

  explicit Decomposition_3(Tr& tr) : m_tr(tr) { }

  // Makes the parts, fewer if there are few cells. Constrained edges are given by arrays of two vertex handles. The
  // vertices have the numbers that they have in the range, and then any ones.
  template <typename EdgeRange, typename VertexRange>
  std::vector<Part> divide(const Size_field& size, const Selected_domain_3<Tr>& domain,
                           const EdgeRange& constrained_edges, const std::size_t number_of_parts,
                           const VertexRange& first_vertices)
  {
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(domain.contains(c))
        m_cells.push_back(c);
    Region_sizes_3<Tr>(m_tr, size).ask_at_vertices(m_cells);
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
  Weighted_graph dual_graph(const Size_field& field, const Selected_domain_3<Tr>& domain) const
  {
    Size_query_3<Tr> query(field);
    Unique_hash_map<Cell_handle, std::size_t> numbers; // for looking up only
    for(std::size_t k = 0; k < m_cells.size(); ++k)
      numbers[m_cells[k]] = k;
    Weighted_graph graph;
    for(const Cell_handle c : m_cells)
    {
      const auto corners = internal::corners(c);
      const Coordinates_3 p = internal::centroid(corners);
      const double size = query(typename Tr::Geom_traits::Point_3(p[0], p[1], p[2]), 3,
                                Region_sizes_3<Tr>::region(c));
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
    Replace_cells<Tr> replacement;
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

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_DECOMPOSITION_3_H
