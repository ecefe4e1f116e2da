// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_RETRIANGULATE_FACETS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_RETRIANGULATE_FACETS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Flip_bad_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Skirt_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * *Multi-face retriangulation* [MBA+09]: facets that are side by side and all between the same two vertices are
 * exchanged for the best triangulation of the polygon that they fill. It does at once what takes the removal of all of
 * them, and then that of the new edge, where the cells in between would be too bad.
 */
template <typename Mesh>
class Retriangulate_facets_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  explicit Retriangulate_facets_3(Mesh& mesh) : m_mesh(mesh), m_skirt(mesh) { }

  // Searches for facets beside one of a bad cell, and for the best triangulation of their polygon.
  bool find(const Cell_handle c)
  {
    double gain = Mesh::least_gain;
    int best = -1;
    for(int i = 0; i < 4; ++i)
      if(collect_facets(c, i) && m_skirt.find(gain, m_length))
      {
        gain = m_skirt.gain();
        best = i;
      }
    return best >= 0 && collect_facets(c, best) && m_skirt.find(0, m_length);
  }

  double gain() const { return m_skirt.gain(); }

  // Exchanges them. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply() { return m_skirt.apply(); }

  const Cells& new_cells() const { return m_skirt.new_cells(); }

  void count(Quality_improvement_counts& counts) const { ++counts.number_of_removed_facets; }

private:
  typedef Skirt_triangulation_3<Mesh> Skirt;

  static constexpr int max_number_of_facets = Skirt::max_degree - 2;

  // An edge of a facet, along which that is on the left, seen from above, and the cell there.
  struct Edge { Vertex_handle u, v; Cell_handle above; };

  // All that are beside the facet opposite to the vertex i of a cell. Returns false if they are less than two, or too
  // many, or have a vertex inside, which would be lost.
  bool collect_facets(const Cell_handle c, const int i)
  {
    if(m_mesh.domain().is_wall(c, i))
      return false;
    const Cell_handle n = c->neighbor(i);
    m_above = c->vertex(i);
    m_below = n->vertex(n->index(c));
    m_length = 0;
    m_polygon.clear();
    m_cells_above.assign(1, c);
    const auto f = internal::facet_vertices(c, i);
    m_open_edges.clear();
    for(int k = 0; k < 3; ++k)
      m_open_edges.push_back(Edge{ f[k], f[(k + 1) % 3], c });
    while(! m_open_edges.empty())
    {
      const Edge e = m_open_edges.back();
      m_open_edges.pop_back();
      if(! extend(e))
        m_polygon.push_back(e);
      if(m_cells_above.size() > max_number_of_facets)
        return false;
    }
    return m_cells_above.size() > 1 && m_polygon.size() == m_cells_above.size() + 2 && set_skirt();
  }

  // Goes on to the facet beyond an edge. Returns false if that is not between the two vertices, or the edge has to
  // stay.
  bool extend(const Edge& e)
  {
    const Cell_handle next = internal::cell_beyond_edge(m_mesh, e.above, m_above, e.u, e.v);
    if(next == Cell_handle())
      return false;
    m_length = (std::max)(m_length, internal::distance(Mesh::coordinates(e.u), Mesh::coordinates(e.v)));
    if(internal::contains(m_cells_above, next))
      return true;
    m_cells_above.push_back(next);
    const Vertex_handle w = next->vertex(next->index(e.above));
    m_open_edges.push_back(Edge{ e.u, w, next });
    m_open_edges.push_back(Edge{ w, e.v, next });
    return true;
  }

  // Returns false if the polygon touches itself.
  bool set_skirt()
  {
    m_skirt.start(m_above, m_below);
    for(const Cell_handle c : m_cells_above)
    {
      m_skirt.add_cell(c);
      m_skirt.add_cell(c->neighbor(c->index(m_above)));
    }
    auto edge = m_polygon.begin();
    for(std::size_t n = 0; n < m_polygon.size(); ++n)
    {
      if(n > 0 && edge == m_polygon.begin())
        return false;
      m_skirt.add_corner(edge->u);
      const Vertex_handle next = edge->v;
      edge = std::find_if(m_polygon.begin(), m_polygon.end(), [&](const Edge& e) { return e.u == next; });
    }
    return edge == m_polygon.begin();
  }

  Mesh& m_mesh;
  Skirt m_skirt;
  Vertex_handle m_above, m_below;
  double m_length = 0; // of the longest edge that goes
  boost::container::static_vector<Cell_handle, max_number_of_facets + 1> m_cells_above; // one for each facet
  boost::container::static_vector<Edge, max_number_of_facets + 3> m_polygon;            // in any order
  boost::container::static_vector<Edge, max_number_of_facets + 4> m_open_edges;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_RETRIANGULATE_FACETS_3_H
