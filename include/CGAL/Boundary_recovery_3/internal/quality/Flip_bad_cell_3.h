// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_FLIP_BAD_CELL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_FLIP_BAD_CELL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Skirt_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The shell transformation that is led by quality alone, and removes the supporting edge [CZZ+17, Sections 1.3 and 2]:
 * the covering mesh of the shell is exchanged for the best complete triangulation of the skirt polygon.
 */
template <typename Mesh>
class Remove_bad_edge_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  explicit Remove_bad_edge_3(Mesh& mesh) : m_mesh(mesh), m_skirt(mesh) { }

  // Searches for the best way to remove the edge from the vertex i to the vertex j of a cell of the domain. Returns
  // whether the cells would be less bad then, by more than `least_gain`, and none worse than the worst one now.
  bool find(const Cell_handle c, const int i, const int j, const double least_gain)
  {
    const Vertex_handle u = c->vertex(i), v = c->vertex(j);
    return collect_shell(c, u, v)
        && m_skirt.find(least_gain, internal::distance(Mesh::coordinates(u), Mesh::coordinates(v)));
  }

  // By how much the cells would be less bad.
  double gain() const { return m_skirt.gain(); }

  // Removes the edge. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply() { return m_skirt.apply(); }

  const Cells& new_cells() const { return m_skirt.new_cells(); }

private:
  typedef typename Mesh::Triangulation Tr;

  // Returns false if the edge has to stay, or if there are too many cells around it.
  bool collect_shell(const Cell_handle c, const Vertex_handle u, const Vertex_handle v)
  {
    m_skirt.start(v, u);
    Cell_handle cell = c;
    do
    {
      const int k = Tr::next_around_edge(cell->index(u), cell->index(v));
      if(m_mesh.domain().is_wall(cell, k) || ! m_skirt.add_corner(cell->vertex(k)))
        return false;
      m_skirt.add_cell(cell);
      cell = cell->neighbor(k);
    }
    while(cell != c);
    return ! m_mesh.domain().is_constrained_edge(u, v);
  }

  Mesh& m_mesh;
  Skirt_triangulation_3<Mesh> m_skirt;
};

// Facets that are between the same two vertices, p and another one, are told by their cells at p. Returns that of the
// one beyond the edge uv of a facet; none if that is not between the two, or the edge or the facet has to stay.
template <typename Mesh>
typename Mesh::Cell_handle cell_beyond_edge(const Mesh& mesh, const typename Mesh::Cell_handle at_p,
                                            const typename Mesh::Vertex_handle p, const typename Mesh::Vertex_handle u,
                                            const typename Mesh::Vertex_handle v)
{
  typedef typename Mesh::Cell_handle Cell_handle;
  const Cell_handle at_q = at_p->neighbor(at_p->index(p));
  const int q = at_q->index(at_p);
  const int i = 6 - at_p->index(u) - at_p->index(v) - at_p->index(p); // the index of the third vertex of the facet
  const int j = 6 - at_q->index(u) - at_q->index(v) - q;
  if(mesh.domain().is_wall(at_p, i) || mesh.domain().is_wall(at_q, j))
    return Cell_handle();
  const Cell_handle next = at_p->neighbor(i);
  const int k = next->index(p);
  if(next->neighbor(k) != at_q->neighbor(j) || mesh.domain().is_wall(next, k))
    return Cell_handle();
  return mesh.domain().is_constrained_edge(u, v) ? Cell_handle() : next;
}

/*
 * Multi-face removal: facets that are side by side and all between the same two vertices p and q go, and the edge pq
 * comes; the inverse of the removal of an edge. With one facet it is the 2-3 flip.
 *
 * It begins with one facet. Where the new cell at one of its edges would not be better than what is there, the facet
 * beyond that edge goes, too.
 */
template <typename Mesh>
class Remove_bad_facet_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  static constexpr int max_number_of_facets = 8;

  explicit Remove_bad_facet_3(Mesh& mesh) : m_mesh(mesh) { }

  // Searches for facets to be removed beside the one opposite to the vertex i of a cell of the domain. Returns whether
  // the cells would be less bad then, by more than `least_gain`, and none worse than the worse cell at the facet.
  bool find(const Cell_handle c, const int i, const double least_gain)
  {
    if(m_mesh.domain().is_wall(c, i))
      return false;
    const Cell_handle n = c->neighbor(i);
    m_p = c->vertex(i);
    m_q = n->vertex(n->index(c));
    if(! m_mesh.is_edge_in_size(m_p, m_q))
      return false;
    m_cells.clear();
    m_tetrahedra.clear();
    m_gain = 0;
    m_worst = m_mesh.least_quality(add(c, n));
    const auto f = internal::facet_vertices(c, i);
    for(int k = 0; k < 3; ++k)
      m_open_edges.push_back(Open_edge{ f[k], f[(k + 1) % 3], c });
    while(! m_open_edges.empty())
    {
      const Open_edge e = m_open_edges.back();
      m_open_edges.pop_back();
      if(! close(e) && ! extend(e))
      {
        m_open_edges.clear();
        return false;
      }
    }
    return m_gain > least_gain;
  }

  // By how much the cells would be less bad.
  double gain() const { return m_gain; }

  // Removes the facets. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply()
  {
    if(! m_mesh.are_positive(m_tetrahedra))
      return false;
    m_new_cells = &m_mesh.replace(m_cells, m_tetrahedra);
    return true;
  }

  const Cells& new_cells() const { return *m_new_cells; }

private:
  typedef typename Mesh::Tetrahedron Tetrahedron;

  // An edge of a facet that goes, along which the facet is on the left, seen from p; with the cell there.
  struct Open_edge
  {
    Vertex_handle u, v;
    Cell_handle at_p;
  };

  // Returns the quality of the worse one.
  double add(const Cell_handle at_p, const Cell_handle at_q)
  {
    const auto [p, q] = m_mesh.quality().of_two_cells(internal::corners(at_p), internal::corners(at_q));
    m_gain += m_mesh.badness(p) + m_mesh.badness(q);
    m_cells.push_back(at_p);
    m_cells.push_back(at_q);
    return (std::min)(p, q);
  }

  // The edge stays: it gets a cell with the new edge.
  bool close(const Open_edge& e)
  {
    const double q = m_mesh.quality(Tetrahedron{{ e.u, e.v, m_q, m_p }});
    if(q < m_worst)
      return false;
    m_gain -= m_mesh.badness(q);
    m_tetrahedra.push_back(Tetrahedron{{ e.u, e.v, m_q, m_p }});
    return true;
  }

  // The edge goes, and with it the facet beyond, if p and q are on both sides of that, too.
  bool extend(const Open_edge& e)
  {
    if(static_cast<int>(m_cells.size()) >= 2 * max_number_of_facets)
      return false;
    const Cell_handle at_p = internal::cell_beyond_edge(m_mesh, e.at_p, m_p, e.u, e.v);
    if(at_p == Cell_handle() || internal::contains(m_cells, at_p))
      return false;
    const Vertex_handle w = at_p->vertex(at_p->index(e.at_p));
    add(at_p, at_p->neighbor(at_p->index(m_p)));
    m_open_edges.push_back(Open_edge{ e.u, w, at_p });
    m_open_edges.push_back(Open_edge{ w, e.v, at_p });
    return true;
  }

  Mesh& m_mesh;
  Vertex_handle m_p, m_q;
  double m_worst = 0; // what qualities are to be at least
  double m_gain = 0;
  boost::container::static_vector<Cell_handle, 2 * max_number_of_facets> m_cells;
  boost::container::static_vector<Tetrahedron, max_number_of_facets + 2> m_tetrahedra;
  boost::container::static_vector<Open_edge, max_number_of_facets + 3> m_open_edges;
  const Cells* m_new_cells = nullptr;
};

/*
 * Removes the edge or the facet of a bad cell that helps most.
 */
template <typename Mesh>
class Flip_bad_cell_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;
  typedef typename Mesh::Cells       Cells;

  explicit Flip_bad_cell_3(Mesh& mesh) : m_remove_edge(mesh), m_remove_facet(mesh) { }

  // Searches which one that is. Returns false if none helps.
  bool find(const Cell_handle c)
  {
    double gain = Mesh::least_gain;
    int i = -1, j = -1; // the edge from vertex i to vertex j, or, if j is negative, the facet opposite to vertex i
    for(int k = 0; k < 4; ++k)
      for(int l = k + 1; l < 4; ++l)
        if(m_remove_edge.find(c, k, l, gain))
        {
          gain = m_remove_edge.gain();
          i = k;
          j = l;
        }
    for(int k = 0; k < 4; ++k)
      if(m_remove_facet.find(c, k, gain))
      {
        gain = m_remove_facet.gain();
        i = k;
        j = -1;
      }
    m_is_edge_removed = j >= 0;
    return i >= 0 && (m_is_edge_removed ? m_remove_edge.find(c, i, j, 0) : m_remove_facet.find(c, i, 0));
  }

  double gain() const { return m_is_edge_removed ? m_remove_edge.gain() : m_remove_facet.gain(); }

  // Removes it. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply() { return m_is_edge_removed ? m_remove_edge.apply() : m_remove_facet.apply(); }

  const Cells& new_cells() const { return m_is_edge_removed ? m_remove_edge.new_cells() : m_remove_facet.new_cells(); }

  void count(Quality_improvement_counts& counts) const
  {
    ++(m_is_edge_removed ? counts.number_of_removed_edges : counts.number_of_removed_facets);
  }

private:
  Remove_bad_edge_3<Mesh> m_remove_edge;
  Remove_bad_facet_3<Mesh> m_remove_facet;
  bool m_is_edge_removed = false;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_FLIP_BAD_CELL_3_H
