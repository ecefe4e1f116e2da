// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BAD_CELLS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BAD_CELLS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The cells that are not good enough, and where the mesh changed lately: around a cell where nothing did, what failed
 * before would fail again.
 */
template <typename Mesh>
class Bad_cells_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;

  explicit Bad_cells_3(const Mesh& mesh) : m_mesh(mesh), m_last_change(0) { }

  // Begins anew, with the same cells.
  void forget_changes() { m_last_change.clear(m_round = 0); }

  // A cell of the domain may be bad. Returns its quality.
  double push(const Cell_handle c)
  {
    const double q = m_mesh.quality(c);
    if(q < m_mesh.enough())
      m_cells.emplace_back(q, c);
    return q;
  }

  template <typename CellRange>
  void push_all(const CellRange& cells)
  {
    for(const Cell_handle c : cells)
      push(c);
  }

  // These cells of the domain are new, or have a vertex that moved.
  template <typename CellRange>
  void push_changed(const CellRange& cells)
  {
    note_change(cells);
    push_all(cells);
  }

  template <typename CellRange>
  void note_change(const CellRange& cells)
  {
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        m_last_change[c->vertex(i)] = m_round;
  }

  // Whether a handle, maybe of a cell that is gone, is one of a bad cell of the domain.
  bool contains(const Cell_handle c) const
  {
    return m_mesh.triangulation().tds().cells().is_used(c) && m_mesh.domain().contains(c)
        && m_mesh.quality(c) < m_mesh.enough();
  }

  // Whether something changed at the vertices of a cell in this round or in the last one.
  bool has_changed(const Cell_handle c) const
  {
    for(int i = 0; i < 4; ++i)
      if(m_last_change.is_defined(c->vertex(i)) && m_last_change[c->vertex(i)] + 1 >= m_round)
        return true;
    return false;
  }

  // Begins a round: the cells to be worked through, the worst one first; there is none left here. In equal meshes, the
  // order is the same.
  std::vector<Cell_handle> next_round()
  {
    ++m_round;
    sort();
    std::vector<Cell_handle> cells;
    cells.reserve(m_cells.size());
    m_badness = 0;
    for(const auto& entry : m_cells)
    {
      cells.push_back(entry.second);
      m_badness += m_mesh.badness(entry.first);
    }
    m_cells.clear();
    return cells;
  }

  // How bad these cells were together.
  double badness() const { return m_badness; }

private:
  // Those that are gone, or are there twice, are taken out; where qualities are equal, these are not side by side.
  void sort()
  {
    Unique_hash_map<Cell_handle, bool> is_there(false); // for looking up only
    for(auto& entry : m_cells)
      if(contains(entry.second) && ! is_there[entry.second])
      {
        entry.first = m_mesh.quality(entry.second);
        is_there[entry.second] = true;
      }
      else
        entry.first = m_mesh.enough();
    std::stable_sort(m_cells.begin(), m_cells.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    while(! m_cells.empty() && m_cells.back().first >= m_mesh.enough())
      m_cells.pop_back();
  }

  const Mesh& m_mesh;
  std::vector<std::pair<double, Cell_handle> > m_cells; // with their qualities
  Unique_hash_map<Vertex_handle, int> m_last_change;    // the round, by vertex; for looking up only
  int m_round = 0;
  double m_badness = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BAD_CELLS_3_H
