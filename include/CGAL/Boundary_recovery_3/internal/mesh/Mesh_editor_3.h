// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_EDITOR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_EDITOR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_change_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Records the changes of a mesh, and can undo them, in a time that depends on the size of the changes, not on the size
 * of the mesh.
 *
 * From begin() to commit() or undo(), the journal has to be told of every change; `Mesh_editor_3` does that. Such
 * transactions may be nested, so that a part of a longer operation can be undone. Each transaction keeps its net
 * change.
 *
 * The journal restores cells with their subdomain and surface patch indices, and vertices with their indices, points
 * and sizes. It uses no predicates, so cells may be inverted. All other data has to be restored by visitors.
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

  // Ends the innermost transaction, and restores the mesh as it was when this transaction began. Restored cells and
  // vertices have new handles: returns the old and the new handle of each restored vertex.
  //
  // The visitor is told which cells go and come, if there are any. If before_cells_removal() throws, or memory is
  // lacking, nothing changes, and the transaction goes on. If after_cells_creation() throws, the mesh is restored
  // nevertheless, and the transaction has ended.
  std::vector<Vertex_pair> undo(Tr& tr, Mesh_visitor_3<Tr>& visitor)
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
    // visitors may set indices of cells when they are told of them; the old indices count
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

  // To be called before cells are replaced. after_exchange() needs no more memory, and cannot fail, if there are at
  // most `number_of_new_cells` new cells. If after_exchange() is not called, the cells count as not replaced.
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

  // Before n vertices are removed, and before each of them is removed, when it is no vertex of a cell any more.
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

/*
 * Replaces the cells of a mesh, and creates, moves and deletes vertices. A visitor is told of replaced cells. During a
 * transaction, a journal is told of all changes, so that they can be undone.
 *
 * The editor is a visitor, too, which forwards everything to the other visitor. If a functor such as
 * `Shell_transformation_3` has the editor as its visitor, its changes get into the journal. Such a functor must not
 * create or delete vertices. The journal makes room for twice as many new cells as old ones; if there are more and
 * memory is lacking, they cannot be undone.
 *
 * The journal is told of each change before the visitor, so the change can be undone if the visitor throws.
 */
template <typename Tr_>
class Mesh_editor_3 final
  : public Forwarding_visitor_3<Tr_>
{
  using Forwarding_visitor_3<Tr_>::m_visitor;

public:
  typedef Tr_                                     Tr;
  typedef Mesh_visitor_3<Tr>                      Visitor;
  typedef typename Tr::Vertex_handle              Vertex_handle;
  typedef typename Tr::Cell_handle                Cell_handle;
  typedef typename Tr::Point                      Point;
  typedef typename Replace_cells<Tr>::Cells        Cells;
  typedef typename Replace_cells<Tr>::Tetrahedron  Tetrahedron;
  typedef typename Mesh_journal_3<Tr>::Vertex_pair    Vertex_pair;

  Mesh_editor_3(Tr& tr, Visitor& visitor) : Forwarding_visitor_3<Tr>(visitor), m_tr(tr) { }

  Tr& triangulation() { return m_tr; }
  Visitor& visitor() { return m_visitor; }

  // --- changes ------------------------------------------------------------------------------------------------------

  // Puts cells with the given vertices in the place of others, see `Replace_cells`. The vertices in `dropped` go
  // with the old cells. If memory is lacking, or the visitor throws when it is told what goes, nothing changes.
  template <typename CellRange, typename TetrahedronRange, typename VertexRange = std::array<Vertex_handle, 0> >
  const Cells& replace(const CellRange& old_cells, const TetrahedronRange& tetrahedra,
                       const VertexRange& dropped = VertexRange())
  {
    if(m_journal.is_active())
    {
      m_journal.before_exchange(old_cells, tetrahedra.size());
      m_journal.make_room_for_removed_vertices(dropped.size());
    }
    m_visitor.before_cells_removal(old_cells);
    m_replacement(m_tr, old_cells, tetrahedra);
    if(m_journal.is_active())
      m_journal.after_exchange(new_cells());
    for(const Vertex_handle v : dropped)
      delete_vertex(v);
    m_visitor.after_cells_creation(new_cells());
    return new_cells();
  }

  // The new cells of the last replacement, in the order in which they were given.
  const Cells& new_cells() const { return m_replacement.new_cells(); }

  // It is in no cell as yet.
  Vertex_handle create_vertex()
  {
    if(! m_journal.is_active())
      return m_tr.tds().create_vertex();
    m_journal.make_room_for_new_vertices(1);
    const Vertex_handle v = m_tr.tds().create_vertex();
    m_journal.after_creation(v);
    return v;
  }

  Vertex_handle create_vertex(const Point& p)
  {
    const Vertex_handle v = create_vertex();
    v->set_point(p);
    return v;
  }

  // No cell may have it any more.
  void delete_vertex(const Vertex_handle v)
  {
    if(m_journal.is_active())
    {
      m_journal.make_room_for_removed_vertices(1);
      m_journal.before_removal(v);
    }
    m_tr.tds().delete_vertex(v);
  }

  void move(const Vertex_handle v, const Point& p)
  {
    before_move(v);
    v->set_point(p);
  }

  // To be called before a vertex is moved in another way than by move(), if the vertex existed before the transaction.
  void before_move(const Vertex_handle v)
  {
    if(m_journal.is_active())
      m_journal.before_move(v);
  }

  // --- transactions, which may be nested, see `Mesh_journal_3` ------------------------------------------------------

  const Mesh_journal_3<Tr>& journal() const { return m_journal; }

  void begin() { m_journal.begin(); }

  void commit() { m_journal.commit(); }

  std::vector<Vertex_pair> undo() { return m_journal.undo(m_tr, m_visitor); }

  // The same, but another visitor is told of the cells: after a visitor has thrown, it is not called again.
  std::vector<Vertex_pair> undo(Visitor& visitor) { return m_journal.undo(m_tr, visitor); }

  // --- as a visitor -------------------------------------------------------------------------------------------------

  void before_cells_removal(const Cell_span<Cell_handle>& cells) override
  {
    if(m_journal.is_active())
      m_journal.before_exchange(cells, 2 * cells.size());
    m_visitor.before_cells_removal(cells);
  }

  void after_cells_creation(const Cell_span<Cell_handle>& cells) override
  {
    if(m_journal.is_active())
      m_journal.after_exchange(cells);
    m_visitor.after_cells_creation(cells);
  }

private:
  Tr& m_tr;
  Replace_cells<Tr> m_replacement;
  Mesh_journal_3<Tr> m_journal;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_EDITOR_3_H
