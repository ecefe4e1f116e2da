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
#include <CGAL/Boundary_recovery_3/internal/quality/Remove_bad_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Remove_bad_facet_3.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_FLIP_BAD_CELL_3_H
