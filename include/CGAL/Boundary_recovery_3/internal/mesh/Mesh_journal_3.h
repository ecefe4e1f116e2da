// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_JOURNAL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_JOURNAL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_change_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_restoration_3.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Takes changes of a mesh back, in time that depends on what has changed only, not on the size of the mesh.
 *
 * Between begin() and commit() or undo() it has to be told of every change; `Mesh_editor_3` does so. Such transactions
 * may be nested: an operation can be tried and taken back inside a longer one. Each keeps its net change.
 *
 * What is taken back are cells with their indices of CGAL's mesh cells, and vertices with theirs, their points and
 * sizes. It is combinatorial: it does not matter if cells are inverted. Other data is up to visitors.
 */
template <typename Tr>
class Mesh_journal_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef std::array<Vertex_handle, 2>  Vertex_pair;

  // Whether changes have to be told.
  bool is_active() const { return ! m_changes.empty(); }

  // The number of transactions that have begun, and not ended yet.
  std::size_t depth() const { return m_changes.size(); }

  // The net change since the last begin().
  const Mesh_change_3<Tr>& change() const { return m_changes.back(); }

  void begin() { m_changes.emplace_back(); }

  // Ends a transaction; the change becomes part of that of the transaction around it, if there is one. If memory is
  // lacking, the transaction goes on.
  void commit()
  {
    CGAL_precondition(is_active());
    if(Mesh_change* const outer = outer_change())
      outer->append(m_changes.back());
    m_changes.pop_back();
  }

  // Ends a transaction, and makes the mesh what it was when it began. What had been removed has new handles: returns
  // the handle that each such vertex had, and the one that it has now.
  //
  // The visitor is told which cells go and come, if there are any. If it throws when it is told what goes, or memory is
  // lacking, nothing changes, and the transaction goes on. If it throws later, all is done.
  template <typename Visitor>
  std::vector<Vertex_pair> undo(Tr& tr, Visitor& visitor)
  {
    CGAL_precondition(is_active());
    m_going_cells.clear();
    Mesh_restoration_3<Tr> restoration(tr, m_changes.back(), outer_change());
    if(restoration.new_cells().empty())
    {
      restoration.restore();
      m_changes.pop_back();
      return restoration.renamed_vertices();
    }
    visitor.before_cells_removal(restoration.new_cells());
    restoration.restore();
    // visitors may have ideas of their own of the indices of cells
    const auto finish = [&] { restoration.restore_indices(); m_changes.pop_back(); };
    try {
      visitor.after_cells_creation(restoration.cells());
    } catch(...) {
      finish();
      throw;
    }
    finish();
    return restoration.renamed_vertices();
  }

  // --- what it has to be told while it is active --------------------------------------------------------------------

  // Before cells are exchanged: nothing fails afterwards, if there are no more new cells. What is not followed by
  // after_exchange() did not happen.
  template <typename CellRange>
  void before_exchange(const CellRange& old_cells, const std::size_t number_of_new_cells)
  {
    m_changes.back().make_room_for_cells(old_cells.size(), number_of_new_cells);
    m_going_cells.clear();
    for(const Cell_handle c : old_cells)
      m_going_cells.emplace_back(c);
  }

  template <typename CellRange>
  void after_exchange(const CellRange& new_cells)
  {
    m_changes.back().make_room_for_cells(m_going_cells.size(), new_cells.size());
    m_changes.back().exchange(m_going_cells, new_cells);
    m_going_cells.clear();
  }

  // Before vertices are created, and for each of them.
  void make_room_for_new_vertices(const std::size_t n) { m_changes.back().make_room_for_new_vertices(n); }
  void after_creation(const Vertex_handle v) { m_changes.back().add_vertex(v); }

  // Before vertices are removed, and for each of them, when no cell has it any more.
  void make_room_for_removed_vertices(const std::size_t n) { m_changes.back().make_room_for_removed_vertices(n); }
  void before_removal(const Vertex_handle v) { m_changes.back().remove_vertex(Old_vertex(v)); }

  // Before a vertex gets another point.
  void before_move(const Vertex_handle v)
  {
    m_changes.back().make_room_for_moved_vertices(1);
    m_changes.back().move_vertex(v, v->point());
  }

private:
  typedef Mesh_change_3<Tr>                   Mesh_change;
  typedef typename Mesh_change::Old_cell      Old_cell;
  typedef typename Mesh_change::Old_vertex    Old_vertex;

  Mesh_change* outer_change() { return m_changes.size() > 1 ? &m_changes[m_changes.size() - 2] : nullptr; }

  std::vector<Mesh_change> m_changes; // one for each transaction, the innermost last
  std::vector<Old_cell> m_going_cells;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_JOURNAL_3_H
