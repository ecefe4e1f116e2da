// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_SHELL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_SHELL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Boundary_recovery_3 {

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief the shell of an edge `ab`: the cells around `ab` and the skirt polygon `p_0 ... p_{m-1}`, the link of `ab`.
 *
 * Indices are cyclic in the paper; here they are from 0 to `degree() - 1`, and `next(i)` and `previous(i)` are cyclic.
 * The cell `cell(i)` has the vertices `a`, `b`, `p_i`, `p_{next(i)}`, which are positively oriented in this order. One
 * vertex of the skirt polygon is the infinite vertex if `ab` is on the convex hull. Source: [CZZ+17, Section 1.3].
 *
 * \tparam Tr an instance of `CGAL::Triangulation_3`
 */
template <typename Tr>
class Shell_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle; ///< the vertex handle of the triangulation
  typedef typename Tr::Cell_handle   Cell_handle;   ///< the cell handle of the triangulation

  /// value of `infinite_index()` if `ab` is not on the convex hull, and of `index()` if there is no such vertex
  static constexpr int none = -1;

  /// an empty shell
  Shell_3() { }

  /// the shell of the edge from `c->vertex(i)` to `c->vertex(j)`.
  Shell_3(const Tr& tr, const Cell_handle c, const int i, const int j) { assign(tr, c, i, j); }

  /// makes this the shell of the edge from `c->vertex(i)` to `c->vertex(j)`.
  void assign(const Tr& tr, const Cell_handle c, const int i, const int j)
  {
    m_a = c->vertex(i);
    m_b = c->vertex(j);
    m_infinite_index = none;
    m_ring.clear();
    m_cells.clear();
    Cell_handle cell = c;
    do
    {
      const int k = Tr::next_around_edge(cell->index(m_a), cell->index(m_b));
      const Vertex_handle p = cell->vertex(k);
      if(tr.is_infinite(p))
        m_infinite_index = degree();
      m_ring.push_back(p);
      m_cells.push_back(cell);
      cell = cell->neighbor(k);
    }
    while(cell != c);
  }

  /// the first vertex of the supporting edge
  Vertex_handle a() const { return m_a; }
  /// the second vertex of the supporting edge
  Vertex_handle b() const { return m_b; }
  /// the number of cells around `ab`
  int degree() const { return static_cast<int>(m_ring.size()); }
  /// the vertex `p_i` of the skirt polygon
  Vertex_handle vertex(const int i) const { return m_ring[i]; }
  /// the cell `a b p_i p_{next(i)}`
  Cell_handle cell(const int i) const { return m_cells[i]; }
  /// the cyclic successor of `i`
  int next(const int i) const { return i + 1 == degree() ? 0 : i + 1; }
  /// the cyclic predecessor of `i`
  int previous(const int i) const { return i == 0 ? degree() - 1 : i - 1; }
  /// the position of the infinite vertex in the skirt polygon, or `none`
  int infinite_index() const { return m_infinite_index; }

  /// the position of `v` in the skirt polygon, or `none`
  int index(const Vertex_handle v) const
  {
    const auto it = std::find(m_ring.begin(), m_ring.end(), v);
    return it == m_ring.end() ? none : static_cast<int>(it - m_ring.begin());
  }

  /// the cells of the shell, a range
  const auto& cells() const { return m_cells; }

private:
  static constexpr std::size_t usual_degree = 16;

  Vertex_handle m_a, m_b;
  boost::container::small_vector<Vertex_handle, usual_degree> m_ring;
  boost::container::small_vector<Cell_handle, usual_degree> m_cells;
  int m_infinite_index = none;
};

/*!
 * \ingroup PkgBoundaryRecovery3Classes
 *
 * \brief a partial triangulation of the skirt polygon of a shell, by positions in the polygon.
 *
 * It represents a covering mesh: each triangle `p_i p_k p_j` represents the tetrahedra of the triangle with `a` and
 * with `b`, and each edge `p_i p_j` of the core the tetrahedron `a b p_i p_j`. Source: [CZZ+17, Section 3.1.1, Eq.\ 1].
 */
struct Partial_triangulation
{
  /// the vertices of the core, in increasing order; empty if the supporting edge disappears
  boost::container::small_vector<int, 16> core;

  /// the triangles `(i, k, j)` outside the core, in the cyclic order of the skirt polygon
  boost::container::small_vector<std::array<int, 3>, 16> triangles;

  /// the degree of the covering mesh
  int core_size() const { return static_cast<int>(core.size()); }
};

} // namespace CGAL::Boundary_recovery_3

#endif // CGAL_BOUNDARY_RECOVERY_3_SHELL_3_H
