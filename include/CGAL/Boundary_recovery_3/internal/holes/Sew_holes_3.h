// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_SEW_HOLES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_SEW_HOLES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_surface_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Locate_in_hole_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Puts the new mesh together: what is outside of the holes, in its order, then what is in the holes, one after the
 * other.
 */
template <typename Kernel>
class Sew_holes_3
{
public:
  typedef typename Kernel::Point_3          Point_3;
  typedef Moved_mesh_3<Point_3>             Mesh;
  typedef Hole_surface_3<Point_3>           Surface;
  typedef Hole_triangulation_3<Kernel>      Triangulation;
  typedef Hole_remeshing_result_3<Point_3>  Result;

  Sew_holes_3(const Mesh& mesh, const Tetrahedra_incidences_3& incidences, const Hole_cells_3& hole_cells,
              Result& result)
    : m_mesh(mesh), m_incidences(incidences), m_hole_cells(hole_cells), m_result(result),
      m_is_kept(mesh.points.size(), false)
  { }

  // First the holes are named, since some vertices in them stay.
  void expect(const Surface& surface, const Triangulation& triangulation)
  {
    for(const std::size_t v : surface.vertices)
      m_is_kept[v] = true;
    m_number_of_new_vertices += triangulation.number_of_vertices();
    m_number_of_new_cells += triangulation.number_of_cells();
  }

  // Then all is copied that is not in a hole.
  void copy()
  {
    reserve();
    std::vector<char> has_cell(m_mesh.points.size(), false);
    for(std::size_t c = 0; c < m_mesh.tetrahedra.size(); ++c)
      for(const std::size_t v : m_mesh.tetrahedra[c])
      {
        has_cell[v] = true;
        m_is_kept[v] = m_is_kept[v] || ! m_hole_cells.contains(c);
      }
    copy_vertices(has_cell);
    for(std::size_t c = 0; c < m_mesh.tetrahedra.size(); ++c)
      if(! m_hole_cells.contains(c))
        add_cell(renumbered(m_mesh.tetrahedra[c]), m_mesh.regions[c], c);
    m_result.number_of_kept_cells = m_result.tetrahedra.size();
    for(const auto& f : m_mesh.facets)
      m_result.facets.push_back(renumbered(f));
    for(const auto& e : m_mesh.edges)
      m_result.edges.push_back(renumbered(e));
  }

  // Then the holes follow.
  void add(const Surface& surface, const Triangulation& triangulation, const std::vector<std::size_t>& old_cells)
  {
    typedef typename Triangulation::Vertex_handle Vertex_handle;
    typedef typename Triangulation::Cell_handle   Cell_handle;
    Locate_in_hole_3<Kernel> locate(m_mesh, m_incidences, m_hole_cells, old_cells);
    Unique_hash_map<Vertex_handle, std::size_t> number; // for looking up only
    for(std::size_t k = 0; k < surface.vertices.size(); ++k)
      number[triangulation.vertices()[k]] = m_new_number[surface.vertices[k]];
    triangulation.for_each_cell([&](const Cell_handle c, const int local_region)
    {
      const int region = surface.regions[static_cast<std::size_t>(local_region)];
      typename Mesh::Tetrahedron t;
      for(int i = 0; i < 4; ++i)
      {
        if(! number.is_defined(c->vertex(i)))
        {
          number[c->vertex(i)] = m_result.points.size();
          add_vertex(c->vertex(i)->point(), region, locate, start(c, number, locate));
        }
        t[static_cast<std::size_t>(i)] = number[c->vertex(i)];
      }
      add_cell(t, region, m_result.no_index);
      m_result.smallest_new_angle = (std::min)(m_result.smallest_new_angle,
                                               Cell_angles_3(internal::corners(c)).smallest());
    });
  }

private:
  // Enough, so that nothing is copied twice.
  void reserve()
  {
    m_result.points.reserve(m_mesh.points.size() + m_number_of_new_vertices);
    m_result.old_vertices.reserve(m_mesh.points.size() + m_number_of_new_vertices);
    m_result.locations.reserve(m_number_of_new_vertices);
    m_result.tetrahedra.reserve(m_mesh.tetrahedra.size() + m_number_of_new_cells);
    m_result.regions.reserve(m_mesh.tetrahedra.size() + m_number_of_new_cells);
    m_result.old_cells.reserve(m_mesh.tetrahedra.size() + m_number_of_new_cells);
    m_result.facets.reserve(m_mesh.facets.size());
    m_result.edges.reserve(m_mesh.edges.size());
  }

  void copy_vertices(const std::vector<char>& has_cell)
  {
    m_new_number.assign(m_mesh.points.size(), m_result.no_index);
    for(std::size_t v = 0; v < m_mesh.points.size(); ++v)
      if(m_is_kept[v] || ! has_cell[v])
      {
        m_new_number[v] = m_result.points.size();
        m_result.points.push_back(m_mesh.points[v]);
        m_result.old_vertices.push_back(v);
      }
    m_result.number_of_kept_vertices = m_result.points.size();
  }

  void add_vertex(const Point_3& p, const int region, Locate_in_hole_3<Kernel>& locate, const std::size_t start)
  {
    m_result.points.push_back(p);
    m_result.old_vertices.push_back(m_result.no_index);
    m_result.locations.push_back(locate(p, region, start));
  }

  // An old cell near a new one: that where another vertex of it is.
  template <typename Cell_handle, typename Numbers>
  std::size_t start(const Cell_handle c, const Numbers& number, const Locate_in_hole_3<Kernel>& locate) const
  {
    for(int i = 0; i < 4; ++i)
      if(number.is_defined(c->vertex(i)))
      {
        const std::size_t v = number[c->vertex(i)];
        if(v >= m_result.number_of_kept_vertices && v - m_result.number_of_kept_vertices < m_result.locations.size())
          return m_result.locations[v - m_result.number_of_kept_vertices].cell;
        if(v < m_result.number_of_kept_vertices)
          return locate.cell_at(m_result.old_vertices[v]);
      }
    return locate.none;
  }

  void add_cell(const typename Mesh::Tetrahedron& t, const int region, const std::size_t old_cell)
  {
    m_result.tetrahedra.push_back(t);
    m_result.regions.push_back(region);
    m_result.old_cells.push_back(old_cell);
  }

  template <typename Simplex>
  Simplex renumbered(Simplex simplex) const
  {
    for(std::size_t& v : simplex)
      v = m_new_number[v];
    return simplex;
  }

  const Mesh& m_mesh;
  const Tetrahedra_incidences_3& m_incidences;
  const Hole_cells_3& m_hole_cells;
  Result& m_result;
  std::size_t m_number_of_new_vertices = 0; // at most, as the next one
  std::size_t m_number_of_new_cells = 0;
  std::vector<char> m_is_kept;           // of the old vertices
  std::vector<std::size_t> m_new_number; // of the old vertices
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_SEW_HOLES_3_H
