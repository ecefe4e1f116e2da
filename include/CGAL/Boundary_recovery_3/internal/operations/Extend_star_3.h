// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_EXTEND_STAR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_EXTEND_STAR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

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
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Mesh_editor_3<Tr>                    Editor;

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
       || is_vertex_lost(v) || m_cavity.has_constraint_inside_beside(v))
      return false;
    m_faces.clear();
    for(const auto& f : m_cavity.boundary())
      if(! internal::contains(f.face, v))
        m_faces.push_back(f.face);
    m_editor.replace(m_cavity.cells(), internal::star(m_faces, v));
    ++m_number_of_replacements;
    return true;
  }

  // The cells that the last call looked at, a measure of its work.
  std::size_t number_of_cells() const { return m_cavity.cells().size(); }

  std::size_t number_of_replacements() const { return m_number_of_replacements; }

private:
  // Whether a vertex would be in no cell any more.
  bool is_vertex_lost(const Vertex_handle v)
  {
    const auto inner_vertices = m_cavity.inner_vertices();
    return std::any_of(inner_vertices.begin(), inner_vertices.end(), [v](const Vertex_handle w) { return w != v; });
  }

  // See "Tuning constants" in the manual.
  static constexpr std::size_t max_number_of_cells = 150;

  Editor& m_editor;
  const Predicates& m_predicates;
  Cavity_3<Tr, Constraints> m_cavity;
  std::vector<std::array<Vertex_handle, 3> > m_faces;
  std::size_t m_number_of_replacements = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_EXTEND_STAR_3_H
