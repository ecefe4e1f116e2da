// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_DEFECTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_DEFECTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/holes/Constrained_sides_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_surface_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * What is to be done about the defects of the boundary of a hole. If something in it does not have to stay, the hole
 * grows there, and it is gone. Else nobody can mesh the hole, and the caller is told.
 */
template <typename Point_3>
class Hole_defects_3
{
public:
  typedef Moved_mesh_3<Point_3>        Mesh;
  typedef Constrained_sides_3<Point_3> Constraints;
  typedef Hole_surface_3<Point_3>      Surface;
  typedef Input_simplex_3<Point_3>     Simplex;
  typedef Input_defect_3<Point_3>      Defect;

  Hole_defects_3(const Mesh& mesh, const Constraints& constraints, const Surface& surface)
    : m_mesh(mesh), m_constraints(constraints), m_surface(surface)
  { }

  void add(const std::vector<Defect>& defects)
  {
    for(const Defect& defect : defects)
      add(defect);
  }

  // The vertices, as positions in the mesh, where the hole has to grow.
  const std::vector<std::size_t>& growing_vertices() const { return m_growing_vertices; }

  // Defects without remedy, in the caller's words.
  const std::vector<Defect>& defects() const { return m_defects; }

  // Whether there is one that is not at any place: all vertices are coplanar.
  bool is_flat() const { return m_is_flat; }

private:
  void add(const Defect& defect)
  {
    if(defect.simplices.empty())
    {
      m_is_flat = true;
      return;
    }
    bool can_grow = false;
    Defect described{ defect.kind, { } };
    for(const Simplex& s : defect.simplices)
    {
      described.simplices.push_back(describe(s));
      if(has_to_stay(s))
        continue;
      can_grow = true;
      for(const std::size_t v : s.vertices)
        m_growing_vertices.push_back(m_surface.vertices[v]);
    }
    if(! can_grow)
      m_defects.push_back(std::move(described));
  }

  // Edges are named only if they are constrained.
  bool has_to_stay(const Simplex& s) const
  {
    return s.dimension == 2 ? m_constraints.is_constrained(m_surface.sides[s.index])
         : s.dimension == 1 || m_constraints.is_constrained_vertex(m_surface.vertices[s.vertices.front()]);
  }

  Simplex describe(const Simplex& s) const
  {
    std::vector<std::size_t> vertices;
    for(const std::size_t v : s.vertices)
      vertices.push_back(m_surface.vertices[v]);
    return m_mesh.describe(position(s, vertices), vertices);
  }

  std::size_t position(const Simplex& s, const std::vector<std::size_t>& vertices) const
  {
    switch(s.dimension)
    {
      case 0:  return vertices[0];
      case 1:  return m_constraints.position({{ vertices[0], vertices[1] }});
      default: return m_constraints.position(m_surface.sides[s.index]);
    }
  }

  const Mesh& m_mesh;
  const Constraints& m_constraints;
  const Surface& m_surface;
  std::vector<std::size_t> m_growing_vertices;
  std::vector<Defect> m_defects;
  bool m_is_flat = false;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_DEFECTS_3_H
