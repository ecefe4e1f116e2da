// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_CHANGE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_CHANGE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The net change of a mesh since some moment: the cells and vertices that are new, and what is known of the old ones
 * that are gone or moved. What came and went since leaves no trace.
 *
 * Containers use the addresses of what was deleted again. That does no harm here: whatever is new is in a table as long
 * as it exists, so what is not in it is old; and old cells have old vertices only, so their handles mean what they
 * meant at that moment.
 *
 * When something is recorded, memory is never lacking if there was room made for it before.
 */
template <typename Tr>
class Mesh_change_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef typename Tr::Point            Point;

  struct Old_cell
  {
    explicit Old_cell(const Cell_handle c)
      : cell(c), vertices{{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }}, indices(*c)
    { }

    Cell_handle cell;
    std::array<Vertex_handle, 4> vertices;
    Cell_indices<typename Tr::Cell> indices;
  };

  struct Old_vertex
  {
    explicit Old_vertex(const Vertex_handle v) : vertex(v), point(v->point()), indices(*v), size(*v) { }

    Vertex_handle vertex;
    Point point;
    Vertex_indices<typename Tr::Vertex> indices;
    Vertex_size<typename Tr::Vertex> size;
  };

  void make_room_for_cells(const std::size_t number_of_old_cells, const std::size_t number_of_new_cells)
  {
    make_room(m_removed_cells, number_of_old_cells);
    make_room_for_handles(m_new_cells, number_of_new_cells);
  }

  void make_room_for_new_vertices(const std::size_t n) { make_room_for_handles(m_new_vertices, n); }
  void make_room_for_removed_vertices(const std::size_t n) { make_room(m_removed_vertices, n); }

  void make_room_for_moved_vertices(const std::size_t n)
  {
    make_room(m_moved_vertices, n);
    make_room(m_points_before, n);
  }

  // Cells went, and others came in their place.
  template <typename CellRange>
  void exchange(const std::vector<Old_cell>& removed, const CellRange& created)
  {
    for(const Old_cell& c : removed)
      if(m_new_cells.erase({{ c.cell }}) == none)
        m_removed_cells.push_back(c);
    for(const Cell_handle c : created)
      m_new_cells.insert({{ c }});
  }

  void add_vertex(const Vertex_handle v) { m_new_vertices.insert({{ v }}); }

  // A vertex goes, none of whose cells is left.
  void remove_vertex(Old_vertex v)
  {
    if(m_new_vertices.erase({{ v.vertex }}) != none)
      return;
    const std::size_t moved = m_moved_vertices.erase({{ v.vertex }});
    if(moved != none)
      v.point = m_points_before[moved];
    m_removed_vertices.push_back(v);
  }

  // A vertex moves, which was at p up to now.
  void move_vertex(const Vertex_handle v, const Point& p)
  {
    if(! is_new(v) && m_moved_vertices.insert({{ v }}).second)
      m_points_before.push_back(p);
  }

  // Another change came after this one. If memory is lacking, nothing happens.
  void append(const Mesh_change_3& later)
  {
    const std::vector<Cell_handle> cells = later.new_cells();
    const std::vector<Vertex_handle> vertices = later.new_vertices();
    make_room_for_cells(later.m_removed_cells.size(), cells.size());
    make_room_for_new_vertices(vertices.size());
    make_room_for_removed_vertices(later.m_removed_vertices.size());
    make_room_for_moved_vertices(later.m_moved_vertices.size());
    later.for_each_moved_vertex([this](const Vertex_handle v, const Point& p) { move_vertex(v, p); });
    exchange(later.m_removed_cells, cells);
    for(const Old_vertex& v : later.m_removed_vertices)
      remove_vertex(v);
    for(const Vertex_handle v : vertices)
      add_vertex(v);
  }

  bool is_new(const Cell_handle c) const { return m_new_cells[{{ c }}] != none; }
  bool is_new(const Vertex_handle v) const { return m_new_vertices[{{ v }}] != none; }

  // In the order in which they came.
  std::vector<Cell_handle> new_cells() const { return present(m_new_cells); }
  std::vector<Vertex_handle> new_vertices() const { return present(m_new_vertices); }

  // In the order in which they went.
  const std::vector<Old_cell>& removed_cells() const { return m_removed_cells; }
  const std::vector<Old_vertex>& removed_vertices() const { return m_removed_vertices; }

  // Calls `work` with each old vertex that moved, and the point where it was.
  template <typename Work>
  void for_each_moved_vertex(const Work& work) const
  {
    for(std::size_t k = 0; k < m_moved_vertices.size(); ++k)
      if(! m_moved_vertices.is_erased(k))
        work(m_moved_vertices.keys()[k][0], m_points_before[k]);
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  // So that the time is linear, memory grows by a factor.
  template <typename Container>
  static void make_room(Container& items, const std::size_t n)
  {
    if(items.capacity() < items.size() + n)
      items.reserve((std::max)(items.size() + n, 2 * items.size()));
  }

  // The same, and those that went again are dropped, if they are more than the others.
  template <typename Handle>
  static void make_room_for_handles(Simplex_index_3<Handle, 1>& index, const std::size_t n)
  {
    if(index.capacity() < index.size() + n && 2 * index.number_of_erased_keys() > index.size())
      index.renumber();
    make_room(index, n);
  }

  template <typename Handle>
  static std::vector<Handle> present(const Simplex_index_3<Handle, 1>& index)
  {
    std::vector<Handle> result;
    result.reserve(index.size() - index.number_of_erased_keys());
    for(std::size_t k = 0; k < index.size(); ++k)
      if(! index.is_erased(k))
        result.push_back(index.keys()[k][0]);
    return result;
  }

  Simplex_index_3<Cell_handle, 1> m_new_cells;
  Simplex_index_3<Vertex_handle, 1> m_new_vertices;
  std::vector<Old_cell> m_removed_cells;
  std::vector<Old_vertex> m_removed_vertices;
  Simplex_index_3<Vertex_handle, 1> m_moved_vertices;
  std::vector<Point> m_points_before; // of these, by number
};

/*
 * Takes a change of a mesh back, in two steps: the constructor does all that may fail, and the mesh stays as it is but
 * for vertices without cells; restore() does the rest. Without it, the destructor removes these vertices.
 *
 * The cells that come take the room of those that go: there was room for as many.
 */
template <typename Tr>
class Mesh_restoration_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef std::array<Vertex_handle, 2>  Vertex_pair;
  typedef Mesh_change_3<Tr>             Mesh_change;

  // `outer`, if any, is the change that `change` was going to be a part of.
  Mesh_restoration_3(Tr& tr, const Mesh_change& change, Mesh_change* const outer)
    : m_tr(tr), m_change(change), m_outer(outer), m_created_vertices(tr), m_new_cells(change.new_cells()),
      m_new_vertices(change.new_vertices()), m_open_facets(m_new_cells, change.removed_cells().size())
  {
    m_cells.reserve(change.removed_cells().size());
    for(const Old_vertex& v : change.removed_vertices())
      m_removed_vertices.insert({{ v.vertex }});
    m_renamed_vertices.reserve(m_removed_vertices.size());
    if(m_outer != nullptr)
      make_room_in_outer_change();
    create_vertices();
  }

  // The cells that go.
  const std::vector<Cell_handle>& new_cells() const { return m_new_cells; }

  // The cells that came, after restore().
  const std::vector<Cell_handle>& cells() const { return m_cells; }

  // The handle that each removed vertex had, and the one that it has now. They can be taken once, at the end.
  std::vector<Vertex_pair>&& renamed_vertices() { return std::move(m_renamed_vertices); }

  void restore()
  {
    for(const Cell_handle c : m_new_cells)
      m_tr.tds().delete_cell(c);
    for(const Vertex_handle v : m_new_vertices)
      m_tr.tds().delete_vertex(v);
    for(const Old_cell& c : m_change.removed_cells())
      restore(c);
    CGAL_postcondition(m_open_facets.empty());
    m_change.for_each_moved_vertex([](const Vertex_handle v, const typename Tr::Point& p) { v->set_point(p); });
    if(m_outer != nullptr)
      tell_outer_change();
    m_created_vertices.keep();
  }

  // Gives the cells that came the indices that they had.
  void restore_indices()
  {
    for(std::size_t k = 0; k < m_cells.size(); ++k)
      m_change.removed_cells()[k].indices.give_to(*m_cells[k]);
  }

private:
  typedef typename Mesh_change::Old_cell    Old_cell;
  typedef typename Mesh_change::Old_vertex  Old_vertex;

  void create_vertices()
  {
    for(const Old_vertex& old : m_change.removed_vertices())
    {
      const Vertex_handle v = m_created_vertices.create(old.point);
      m_renamed_vertices.push_back({{ old.vertex, v }});
      old.indices.give_to(*v);
      old.size.give_to(*v);
    }
  }

  void restore(const Old_cell& old)
  {
    std::array<Vertex_handle, 4> v = old.vertices;
    for(Vertex_handle& w : v)
    {
      const std::size_t k = m_removed_vertices[{{ w }}];
      if(k != m_removed_vertices.none)
        w = m_renamed_vertices[k][1];
    }
    const Cell_handle c = m_tr.tds().create_cell(v[0], v[1], v[2], v[3]);
    old.indices.give_to(*c);
    m_cells.push_back(c);
    for(int i = 0; i < 4; ++i)
    {
      v[i]->set_cell(c);
      m_open_facets.glue(m_tr, c, i);
    }
  }

  // --- the outer change ---------------------------------------------------------------------------------------------

  // What comes back has new handles, so for the outer change it is exchanged.

  void make_room_in_outer_change()
  {
    m_outer->make_room_for_cells(m_change.removed_cells().size(), m_change.removed_cells().size());
    m_outer->make_room_for_new_vertices(m_removed_vertices.size());
    m_outer->make_room_for_removed_vertices(m_removed_vertices.size());
  }

  void tell_outer_change()
  {
    m_outer->exchange(m_change.removed_cells(), m_cells);
    for(const Old_vertex& v : m_change.removed_vertices())
      m_outer->remove_vertex(v);
    for(const Vertex_pair& v : m_renamed_vertices)
      m_outer->add_vertex(v[1]);
  }

  Tr& m_tr;
  const Mesh_change& m_change;
  Mesh_change* const m_outer;
  New_vertices_3<Tr> m_created_vertices;
  const std::vector<Cell_handle> m_new_cells;
  const std::vector<Vertex_handle> m_new_vertices;
  Open_facets_3<Tr> m_open_facets;
  Simplex_index_3<Vertex_handle, 1> m_removed_vertices;
  std::vector<Vertex_pair> m_renamed_vertices; // by these numbers
  std::vector<Cell_handle> m_cells;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_MESH_CHANGE_3_H
