// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_NUMBER_EDGE_NODES_H
#define CGAL_BOUNDARY_RECOVERY_3_NUMBER_EDGE_NODES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the nodes in the middle of edges of a mesh of second order, numbered from 0 by `number_edge_nodes()`.
 *
 * The order of the nodes of a simplex is that of VTK (`VTK_QUADRATIC_TETRA`, `VTK_QUADRATIC_TRIANGLE`), MEDIT and
 * Abaqus. In the order of Gmsh, the last two nodes of a tetrahedron change places.
 *
 * \tparam Index_ an integer type
 */
template <typename Index_>
struct Edge_nodes_3
{
  typedef Index_ Index; ///< the type of numbers

  /// for each node, the vertices at the ends of its edge, the smaller number first
  std::vector<std::array<Index, 2> > edges;

  /// for each tetrahedron, the nodes of its edges 01, 12, 20, 03, 13, 23
  std::vector<std::array<Index, 6> > tetrahedra;

  /// for each triangle, the nodes of its edges 01, 12, 20
  std::vector<std::array<Index, 3> > triangles;
};

namespace internal {

// Numbers the edges of simplices. An edge is looked up among those that have the same smaller vertex, by its larger
// one: no hashing, and the order is that of the vertices.
template <typename Index>
class Edge_numbering_3
{
  typedef std::pair<std::size_t, std::size_t> Ends; // positions in a simplex

  static constexpr Ends edges_of_tetrahedron[] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  static constexpr Ends edges_of_triangle[] = { { 0, 1 }, { 1, 2 }, { 2, 0 } };

  std::vector<std::size_t> m_begin; // for each vertex, where the edges begin of which it is the smaller end
  std::vector<Index> m_ends;        // the larger end of each edge, in ascending order
  std::vector<bool> m_is_of_triangle;
  std::vector<Index> m_numbers;     // of each edge

public:
  template <typename TetrahedronRange, typename TriangleRange>
  Edge_nodes_3<Index> operator()(const TetrahedronRange& tetrahedra, const TriangleRange& triangles)
  {
    const auto for_each_edge = [&](const auto& f)
    {
      for(const auto& t : triangles)
        for_each_edge_of(t, edges_of_triangle, f);
      for(const auto& t : tetrahedra)
        for_each_edge_of(t, edges_of_tetrahedron, f);
    };
    collect_edges(for_each_edge);
    m_is_of_triangle.resize(m_ends.size(), false);
    for(const auto& t : triangles)
      for_each_edge_of(t, edges_of_triangle,
                       [&](const Index u, const Index v) { m_is_of_triangle[position(u, v)] = true; });
    Edge_nodes_3<Index> nodes;
    number_edges(nodes);
    for(const auto& t : tetrahedra)
      nodes.tetrahedra.push_back(nodes_of(t, edges_of_tetrahedron));
    for(const auto& t : triangles)
      nodes.triangles.push_back(nodes_of(t, edges_of_triangle));
    return nodes;
  }

private:
  // calls the function with the smaller and the larger end of each edge
  template <typename Simplex, std::size_t N, typename F>
  static void for_each_edge_of(const Simplex& simplex, const Ends (&edges)[N], const F& f)
  {
    for(const auto& [i, j] : edges)
    {
      const Index u = static_cast<Index>(simplex[i]), v = static_cast<Index>(simplex[j]);
      f((std::min)(u, v), (std::max)(u, v));
    }
  }

  // lists the edges by their ends, each once
  template <typename ForEachEdge>
  void collect_edges(const ForEachEdge& for_each_edge)
  {
    m_begin.assign(1, 0);
    for_each_edge([&](const Index u, const Index v)
    {
      if(m_begin.size() < std::size_t(v) + 2)
        m_begin.resize(std::size_t(v) + 2, 0);
      ++m_begin[std::size_t(u) + 1];
    });
    for(std::size_t v = 1; v < m_begin.size(); ++v)
      m_begin[v] += m_begin[v - 1];
    m_ends.resize(m_begin.back());
    std::vector<std::size_t> next(m_begin);
    for_each_edge([&](const Index u, const Index v) { m_ends[next[std::size_t(u)]++] = v; });

    auto out = m_ends.begin();
    for(std::size_t v = 0; v + 1 < m_begin.size(); ++v)
    {
      const auto first = iterator(v), last = iterator(v + 1);
      std::sort(first, last);
      m_begin[v] = static_cast<std::size_t>(out - m_ends.begin());
      out = std::unique_copy(first, last, out);
    }
    m_begin.back() = static_cast<std::size_t>(out - m_ends.begin());
    m_ends.erase(out, m_ends.end());
  }

  typename std::vector<Index>::iterator iterator(const std::size_t vertex)
  {
    return m_ends.begin() + static_cast<std::ptrdiff_t>(m_begin[vertex]);
  }

  // first the edges of triangles, then the others
  void number_edges(Edge_nodes_3<Index>& nodes)
  {
    m_numbers.resize(m_ends.size());
    for(const bool is_of_triangle : { true, false })
      for(std::size_t u = 0; u + 1 < m_begin.size(); ++u)
        for(std::size_t k = m_begin[u]; k < m_begin[u + 1]; ++k)
          if(m_is_of_triangle[k] == is_of_triangle)
          {
            m_numbers[k] = static_cast<Index>(nodes.edges.size());
            nodes.edges.push_back({{ static_cast<Index>(u), m_ends[k] }});
          }
  }

  std::size_t position(const Index u, const Index v)
  {
    const auto first = iterator(std::size_t(u)), last = iterator(std::size_t(u) + 1);
    return static_cast<std::size_t>(std::lower_bound(first, last, v) - m_ends.begin());
  }

  template <typename Simplex, std::size_t N>
  std::array<Index, N> nodes_of(const Simplex& simplex, const Ends (&edges)[N])
  {
    std::array<Index, N> result;
    std::size_t n = 0;
    for_each_edge_of(simplex, edges,
                     [&](const Index u, const Index v) { result[n++] = m_numbers[position(u, v)]; });
    return result;
  }
};

template <typename Range>
using Index_of_simplices = std::decay_t<decltype((*std::begin(std::declval<const Range&>()))[0])>;

} // namespace internal

/*!
 * \ingroup PkgBoundaryRecovery3Functions
 *
 * \brief numbers the nodes in the middle of edges, which a mesh of second order has in addition to its vertices.
 *
 * Each edge has one node, which all its simplices share. The edges of the triangles come first, then the other edges,
 * both sorted by the smaller vertex, then by the larger one. So the numbers of the nodes do not depend on the order of
 * the simplices. The time is about linear.
 *
 * Edges of a mesh of this package are straight. The place of a node is `CGAL::midpoint()` of its two vertices in
 * `Edge_nodes_3::edges`. In files, nodes follow the vertices: add the number of vertices to the number of a node.
 *
 * \code
 * const auto nodes = CGAL::Boundary_recovery_3::number_edge_nodes(tetrahedra, triangles);
 * const std::size_t number_of_vertices = points.size();
 * for(const auto& [u, v] : nodes.edges)
 *   points.push_back(CGAL::midpoint(points[u], points[v]));
 * // tetrahedron t has the nodes number_of_vertices + nodes.tetrahedra[t][0], ...
 * \endcode
 *
 * \tparam TetrahedronRange a model of `ConstRange` whose value type has an operator `[]` with the numbers of four
 *         vertices, as `std::array<std::size_t, 4>` has
 * \tparam TriangleRange the same with three vertices
 *
 * \param tetrahedra the tetrahedra, or an empty range
 * \param triangles the triangles, such as those of the surface, or an empty range. They need not be facets of the
 *        tetrahedra
 *
 * \return the nodes, with numbers of the type in the tetrahedra. The memory grows with the largest number of a vertex.
 *
 * \pre The numbers of vertices are not negative, and their type can store the number of edges.
 */
template <typename TetrahedronRange, typename TriangleRange>
#ifdef DOXYGEN_RUNNING
Edge_nodes_3<Index>
#else
Edge_nodes_3<internal::Index_of_simplices<TetrahedronRange> >
#endif
number_edge_nodes(const TetrahedronRange& tetrahedra, const TriangleRange& triangles)
{
  return internal::Edge_numbering_3<internal::Index_of_simplices<TetrahedronRange> >()(tetrahedra, triangles);
}

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_NUMBER_EDGE_NODES_H
