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
#include <CGAL/Boundary_recovery_3/internal/mesh/Cell_replacement.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_journal_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The one way in which cells and vertices of a mesh are changed: phases share it, it tells a visitor, and while a
 * transaction is on, also a journal, so that all changes since can be taken back.
 *
 * It is itself a visitor, which hands on everything to the other one: what is changed by functors with a visitor, such
 * as `Shell_transformation_3`, gets into the journal, too. Announced like that, cells may at most be doubled in number
 * if memory is lacking; and vertices are neither created nor removed.
 *
 * The journal is told first: whatever the visitor throws, it can be taken back.
 */
template <typename Tr_, typename Visitor_>
class Mesh_editor_3
{
public:
  typedef Tr_                                     Tr;
  typedef Visitor_                                Visitor;
  typedef typename Tr::Vertex_handle              Vertex_handle;
  typedef typename Tr::Cell_handle                Cell_handle;
  typedef typename Tr::Point                      Point;
  typedef typename Cell_replacement<Tr>::Cells        Cells;
  typedef typename Cell_replacement<Tr>::Tetrahedron  Tetrahedron;
  typedef typename Mesh_journal_3<Tr>::Vertex_pair    Vertex_pair;

  Mesh_editor_3(Tr& tr, Visitor& visitor) : m_tr(tr), m_visitor(visitor) { }

  Mesh_editor_3(const Mesh_editor_3&) = delete;
  Mesh_editor_3& operator=(const Mesh_editor_3&) = delete;

  Tr& triangulation() { return m_tr; }
  Visitor& visitor() { return m_visitor; }

  // --- changes ------------------------------------------------------------------------------------------------------

  // Puts cells with the given vertices in the place of others, see `Cell_replacement`. The vertices in `dropped` go
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

  // Has to be called before somebody else moves a vertex that was there when the transaction began.
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

  // Another visitor is told, for one that threw is not called again.
  template <typename Other_visitor>
  std::vector<Vertex_pair> undo(Other_visitor& visitor) { return m_journal.undo(m_tr, visitor); }

  // --- as a visitor -------------------------------------------------------------------------------------------------

  void on_phase_begin(const Recovery_phase phase) { m_visitor.on_phase_begin(phase); }

  void on_phase_end(const Phase_report& report) { m_visitor.on_phase_end(report); }

  void on_progress(const Recovery_phase phase, const std::size_t done, const std::size_t total)
  {
    m_visitor.on_progress(phase, done, total);
  }

  bool go_further() { return m_visitor.go_further(); }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    if(m_journal.is_active())
      m_journal.before_exchange(cells, 2 * cells.size());
    m_visitor.before_cells_removal(cells);
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    if(m_journal.is_active())
      m_journal.after_exchange(cells);
    m_visitor.after_cells_creation(cells);
  }

private:
  Tr& m_tr;
  Visitor& m_visitor;
  Cell_replacement<Tr> m_replacement;
  Mesh_journal_3<Tr> m_journal;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_EDITOR_3_H
