// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_STAR_CAVITY_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_STAR_CAVITY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Why a cavity cannot be starred from a vertex.
enum class Star_obstacle
{
  NONE,
  HIDDEN_FACE,        // the vertex does not see a face of the cavity from inside
  CONSTRAINT_INSIDE,  // an edge or a facet inside the cavity is constrained
  VERTEX_LOST         // a vertex inside the cavity would be in no cell any more
};

// Whether a vertex inside would be in no cell any more if the cavity is starred from v; those in `droppable` may.
template <typename Cavity>
bool is_vertex_lost(Cavity& cavity, const typename Cavity::Vertex_handle v,
                    const typename Cavity::Vertices& droppable = typename Cavity::Vertices())
{
  const typename Cavity::Vertices inner_vertices = cavity.inner_vertices();
  return std::any_of(inner_vertices.begin(), inner_vertices.end(), [&](const typename Cavity::Vertex_handle w)
  {
    return w != v && ! internal::contains(droppable, w);
  });
}

// What is in the way if the cavity is to be starred from v. The vertices in `droppable`, and v, may be inside.
template <typename Cavity, typename Predicates>
Star_obstacle find_obstacle_to_star(Cavity& cavity, const Predicates& predicates,
                                    const typename Cavity::Vertex_handle v,
                                    const typename Cavity::Vertices& droppable = typename Cavity::Vertices())
{
  const auto is_seen = [&](const auto& f)
  {
    return predicates.orientation(f.face[0], f.face[1], f.face[2], v) == POSITIVE;
  };
  if(! std::all_of(cavity.boundary().begin(), cavity.boundary().end(), is_seen))
    return Star_obstacle::HIDDEN_FACE;
  if(cavity.has_constraint_inside())
    return Star_obstacle::CONSTRAINT_INSIDE;
  return internal::is_vertex_lost(cavity, v, droppable) ? Star_obstacle::VERTEX_LOST : Star_obstacle::NONE;
}

// The tetrahedra from v to the faces of a polyhedron, without those faces that have v as a vertex.
template <typename Vertex_handle>
std::vector<std::array<Vertex_handle, 4> > star(const std::vector<std::array<Vertex_handle, 3> >& faces,
                                                const Vertex_handle v)
{
  std::vector<std::array<Vertex_handle, 4> > tetrahedra;
  tetrahedra.reserve(faces.size());
  for(const std::array<Vertex_handle, 3>& f : faces)
    if(! internal::contains(f, v))
      tetrahedra.push_back({{ f[0], f[1], f[2], v }});
  return tetrahedra;
}

// Stars the cavity from v, which sees all its faces; it may be a new vertex, or one inside. The other vertices inside
// are gone. `editor` changes the mesh, see `Mesh_editor_3`: it tells visitors, which can carry data of the cells over,
// and can take it back.
template <typename Editor, typename Cavity>
void star_cavity(Editor& editor, Cavity& cavity, const typename Cavity::Vertex_handle v)
{
  typename Cavity::Vertices dropped = cavity.inner_vertices();
  dropped.erase(std::remove(dropped.begin(), dropped.end(), v), dropped.end());
  editor.replace(cavity.cells(), internal::star(cavity.faces(), v), dropped);
}

/*
 * Extends the star of a vertex over given cells: they, and all the cells that hide part of them from the vertex, are
 * replaced by cells from the vertex to the faces of the cavity that is left. What was a simplex inside is none any
 * more, unless it is at the vertex.
 *
 * The cells at the vertex that hide nothing stay, so the vertex may be on the boundary of the cavity, and on the hull.
 */
template <typename Tr, typename Constraints>
class Extend_star_3
{
public:
  typedef typename Tr::Vertex_handle  Vertex_handle;
  typedef typename Tr::Cell_handle    Cell_handle;
  typedef Vertex_predicates_3<Tr>     Predicates;
  typedef Mesh_editor_3<Tr>           Editor;

  // All arguments have to outlive this object.
  Extend_star_3(Editor& editor, const Predicates& predicates, const Constraints& constraints)
    : m_editor(editor), m_predicates(predicates), m_cavity(editor.triangulation(), constraints)
  { }

  // Returns whether the star of v could be extended. If not, nothing changed: the hull or a constrained facet is in the
  // way, a constraint or a vertex inside would be gone, or there would be too many cells.
  template <typename CellRange>
  bool operator()(const CellRange& cells, const Vertex_handle v)
  {
    m_cavity.clear();
    for(const Cell_handle c : cells)
      if(! m_cavity.add(c))
        return false;
    if(! internal::grow_until_seen(m_cavity, v, m_predicates, max_number_of_cells)
       || internal::is_vertex_lost(m_cavity, v) || m_cavity.has_constraint_inside_beside(v))
      return false;
    m_editor.replace(m_cavity.cells(), internal::star(m_cavity.faces(), v));
    ++m_number_of_replacements;
    return true;
  }

  // The cells that the last call looked at, a measure of its work.
  std::size_t number_of_cells() const { return m_cavity.cells().size(); }

  std::size_t number_of_replacements() const { return m_number_of_replacements; }

private:
  // See "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_cells = 150;

  Editor& m_editor;
  const Predicates& m_predicates;
  Cavity_3<Tr, Constraints> m_cavity;
  std::size_t m_number_of_replacements = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_STAR_CAVITY_H
