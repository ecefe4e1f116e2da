// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_REMOVE_VERTEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_REMOVE_VERTEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Whether x, a neighbor of v, sees all of the star of v from inside: then v can be collapsed onto x, if there is no
// constraint at v. `star` are the cells around v, all of which are finite.
template <typename Predicates, typename CellRange, typename Vertex_handle>
bool is_star_seen(const Predicates& predicates, const CellRange& star, const Vertex_handle v, const Vertex_handle x)
{
  return std::all_of(star.begin(), star.end(), [&](const auto c)
  {
    if(c->has_vertex(x))
      return true;
    const std::array<Vertex_handle, 4> t = internal::with_exchanged_vertex(c, v, x);
    return predicates.orientation(t[0], t[1], t[2], t[3]) == POSITIVE;
  });
}

// The tetrahedra that fill the star of v when v is collapsed onto x.
template <typename CellRange, typename Vertex_handle>
std::vector<std::array<Vertex_handle, 4> > collapsed_star(const CellRange& star, const Vertex_handle v,
                                                          const Vertex_handle x)
{
  std::vector<std::array<Vertex_handle, 4> > tetrahedra;
  for(const auto c : star)
    if(! c->has_vertex(x))
      tetrahedra.push_back(internal::with_exchanged_vertex(c, v, x));
  return tetrahedra;
}

// Collapses the edge from v to x, which sees the star of v: it is covered by cells from x, and v is gone. It contains
// the 4-1 flip. `editor` changes the mesh, see `Mesh_editor_3`, and can take it back.
template <typename Editor, typename CellRange>
void collapse_edge(Editor& editor, const CellRange& star, const typename Editor::Tr::Vertex_handle v,
                   const typename Editor::Tr::Vertex_handle x)
{
  editor.replace(star, internal::collapsed_star(star, v, x),
                 std::array<typename Editor::Tr::Vertex_handle, 1>{{ v }});
}

/*
 * Removes a vertex at which there is no constraint: its star is covered with other cells, by collapsing an edge or by
 * small polyhedron reconnection.
 *
 * The search changes nothing; what it found is done then, or left.
 */
template <typename Tr, typename Constraints>
class Remove_vertex_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Mesh_editor_3<Tr>           Editor;
  typedef std::array<Vertex_handle, 4>         Tetrahedron;

  Remove_vertex_3(Editor& editor, const Predicates& predicates, const Constraints& constraints)
    : m_editor(editor), m_predicates(predicates), m_constraints(constraints), m_reconnection(predicates)
  { }

  // To be called if vertices moved, were created, or came back by an undo.
  void forget() { m_reconnection.forget(); }

  // Whether v can go by one of the two ways. `star` are the cells around it, which are finite.
  bool find(const std::vector<Cell_handle>& star, const Vertex_handle v)
  {
    return find_neighbor(star, v) || find_reconnection(star, v);
  }

  // Whether v can go by reconnection of its star and the cells next to that.
  bool find_with_layer(const std::vector<Cell_handle>& star, const Vertex_handle v)
  {
    Cavity_3<Tr, Constraints> cavity(m_editor.triangulation(), m_constraints, star);
    for(const Cell_handle c : star)
      cavity.add(c->neighbor(c->index(v)));
    return find_reconnection(cavity.cells(), v);
  }

  // What was found last: the cells that go, and the tetrahedra that come.
  const std::vector<Cell_handle>& cells() const { return m_cells; }
  const std::vector<Tetrahedron>& tetrahedra() const { return m_tetrahedra; }

  // Does what was found last for v.
  void operator()(const Vertex_handle v)
  {
    m_editor.replace(m_cells, m_tetrahedra, std::array<Vertex_handle, 1>{{ v }});
  }

private:
  typedef Small_polyhedron_reconnection_3<Tr>  Reconnection;

  // The first neighbor of v onto which it can be collapsed.
  bool find_neighbor(const std::vector<Cell_handle>& star, const Vertex_handle v)
  {
    const std::vector<Vertex_handle> neighbors = internal::vertices_without(star, v);
    const auto x = std::find_if(neighbors.begin(), neighbors.end(), [&](const Vertex_handle w)
    {
      return internal::is_star_seen(m_predicates, star, v, w);
    });
    if(x == neighbors.end())
      return false;
    m_cells = star;
    m_tetrahedra = internal::collapsed_star(star, v, *x);
    return true;
  }

  bool find_reconnection(const std::vector<Cell_handle>& cells, const Vertex_handle v)
  {
    std::vector<std::array<Vertex_handle, 2> > edges;
    std::vector<std::array<Vertex_handle, 3> > facets;
    internal::collect_constraints(m_constraints, cells, edges, facets);
    if(m_reconnection(cells, edges, facets, v) != Reconnection::FOUND)
      return false;
    m_cells = cells;
    m_tetrahedra = m_reconnection.tetrahedra();
    return true;
  }

  Editor& m_editor;
  const Predicates& m_predicates;
  const Constraints& m_constraints;
  Reconnection m_reconnection;
  std::vector<Cell_handle> m_cells;
  std::vector<Tetrahedron> m_tetrahedra;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_REMOVE_VERTEX_3_H
