// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_SURFACE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_SURFACE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/holes/Hole_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * What stays of a hole: the facets that bound it, those inside of it that are constrained, and constrained edges, with
 * vertices numbered from 0 on.
 *
 * Regions are numbered, too: 0 is what is not in the hole, and those in it follow in the order of the caller's numbers.
 */
template <typename Point_3>
struct Hole_surface_3
{
  typedef Moved_mesh_3<Point_3>       Mesh;
  typedef Constrained_sides_3<Point_3> Constraints;
  typedef std::array<std::size_t, 3>  Facet;
  typedef std::array<std::size_t, 2>  Edge;

  std::vector<std::size_t> vertices; // their positions in the mesh, in order
  std::vector<Point_3> points;       // of the vertices
  std::vector<Facet> facets;         // by local numbers
  std::vector<std::size_t> sides;    // a side of each facet in the mesh
  std::vector<std::array<int, 2> > regions_of_sides; // on the positive side of each facet, and on the other one
  std::vector<Edge> edges;           // by local numbers
  std::vector<int> regions;          // the caller's number of each region; that of 0 means nothing

  Hole_surface_3(const Mesh& mesh, const Tetrahedra_incidences_3& incidences, const Constraints& constraints,
                 const Hole_cells_3& hole_cells, const std::vector<std::size_t>& cells)
  {
    number_regions(mesh, cells);
    for(const std::size_t c : cells)
      for(std::size_t i = 0; i < 4; ++i)
        add_side(mesh, incidences, constraints, hole_cells, 4 * c + i);
    if(constraints.has_edges())
      add_edges(mesh, constraints, cells);
    number_vertices(mesh);
  }

  int local_region(const int region) const
  {
    return static_cast<int>(std::lower_bound(regions.begin() + 1, regions.end(), region) - regions.begin());
  }

private:
  void number_regions(const Mesh& mesh, const std::vector<std::size_t>& cells)
  {
    regions.push_back(0);
    for(const std::size_t c : cells)
      if(regions.size() == 1 || mesh.regions[c] != regions.back())
        regions.push_back(mesh.regions[c]);
    std::sort(regions.begin() + 1, regions.end());
    regions.erase(std::unique(regions.begin() + 1, regions.end()), regions.end());
  }

  void add_side(const Mesh& mesh, const Tetrahedra_incidences_3& incidences, const Constraints& constraints,
                const Hole_cells_3& hole_cells, const std::size_t side)
  {
    const std::size_t opposite = incidences.opposite(side);
    const bool is_inside = opposite != incidences.none && hole_cells.are_in_same_hole(side / 4, opposite / 4);
    if(is_inside && (side > opposite || ! constraints.is_constrained(side)))
      return;
    facets.push_back(incidences.facet(side));
    sides.push_back(side);
    regions_of_sides.push_back({{ local_region(mesh.regions[side / 4]),
                                  is_inside ? local_region(mesh.regions[opposite / 4]) : 0 }});
  }

  void add_edges(const Mesh& mesh, const Constraints& constraints, const std::vector<std::size_t>& cells)
  {
    Simplex_index_3<std::size_t, 2> known;
    for(const std::size_t c : cells)
      for(std::size_t i = 0; i < 4; ++i)
        for(std::size_t j = i + 1; j < 4; ++j)
        {
          const Edge edge = {{ mesh.tetrahedra[c][i], mesh.tetrahedra[c][j] }};
          if(constraints.is_constrained_edge(edge) && known.insert(edge).second)
            edges.push_back(edge);
        }
  }

  void number_vertices(const Mesh& mesh)
  {
    for(const Facet& f : facets)
      vertices.insert(vertices.end(), f.begin(), f.end());
    for(const Edge& e : edges)
      vertices.insert(vertices.end(), e.begin(), e.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for(const std::size_t v : vertices)
      points.push_back(mesh.points[v]);
    for(Facet& f : facets)
      number(f);
    for(Edge& e : edges)
      number(e);
  }

  template <typename Simplex>
  void number(Simplex& simplex) const
  {
    for(std::size_t& v : simplex)
      v = static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  }
};

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
    return describe_simplex(m_mesh, position(s, vertices), vertices);
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

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_SURFACE_3_H
