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
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
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

// What is in the way if the cavity is to be starred from v. The vertices in `droppable`, and v, may be inside.
template <typename Cavity, typename Predicates>
Star_obstacle find_obstacle_to_star(Cavity& cavity, const Predicates& predicates,
                                    const typename Cavity::Vertex_handle v,
                                    const typename Cavity::Vertices& droppable = typename Cavity::Vertices())
{
  typedef typename Cavity::Vertex_handle Vertex_handle;
  const auto is_seen = [&](const auto& f)
  {
    return predicates.orientation(f.face[0], f.face[1], f.face[2], v) == POSITIVE;
  };
  if(! std::all_of(cavity.boundary().begin(), cavity.boundary().end(), is_seen))
    return Star_obstacle::HIDDEN_FACE;
  if(cavity.has_constraint_inside())
    return Star_obstacle::CONSTRAINT_INSIDE;
  const typename Cavity::Vertices inner_vertices = cavity.inner_vertices();
  const bool is_any_lost = std::any_of(inner_vertices.begin(), inner_vertices.end(), [&](const Vertex_handle w)
  {
    return w != v && ! internal::contains(droppable, w);
  });
  return is_any_lost ? Star_obstacle::VERTEX_LOST : Star_obstacle::NONE;
}

// The tetrahedra from v to the faces of a polyhedron.
template <typename Vertex_handle>
std::vector<std::array<Vertex_handle, 4> > star(const std::vector<std::array<Vertex_handle, 3> >& faces,
                                                const Vertex_handle v)
{
  std::vector<std::array<Vertex_handle, 4> > tetrahedra;
  tetrahedra.reserve(faces.size());
  for(const std::array<Vertex_handle, 3>& f : faces)
    tetrahedra.push_back({{ f[0], f[1], f[2], v }});
  return tetrahedra;
}

// Stars the cavity from v, which sees all its faces; it may be a new vertex, or one inside. The other vertices inside
// are gone. `editor` changes the mesh, see `Mesh_editor_3`: it tells visitors, which can carry data of the cells over,
// and can take it back.
template <typename Editor, typename Cavity>
void star_cavity(Editor& editor, Cavity& cavity, const typename Cavity::Vertex_handle v)
{
  std::vector<typename Cavity::Vertex_triple> faces;
  for(const auto& f : cavity.boundary())
    faces.push_back(f.face);
  typename Cavity::Vertices dropped = cavity.inner_vertices();
  dropped.erase(std::remove(dropped.begin(), dropped.end(), v), dropped.end());
  editor.replace(cavity.cells(), internal::star(faces, v), dropped);
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OPERATIONS_STAR_CAVITY_H
