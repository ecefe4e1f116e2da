// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_PLACE_SECTOR_POINTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_PLACE_SECTOR_POINTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Facet_fans_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Origin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The sectors into which fans cut the star of a vertex: sets of cells, numbered in the order of the cells of the star.
 */
template <typename Tr>
class Star_sectors_3
{
public:
  typedef typename Tr::Cell_handle       Cell_handle;
  typedef Half_facet_star_3<Tr>          Star;
  typedef Facet_fans_3<Tr>               Fans;
  typedef typename Fans::Fan             Fan;

  explicit Star_sectors_3(const Tr& tr) : m_tr(tr) { }

  void label(const Star& star, const Fans& fans)
  {
    m_sector_of_cell.clear();
    m_is_infinite.clear();
    const auto is_open = [&](const Cell_handle c, const int i)
    {
      if(c->vertex(i) == star.center())
        return false;
      const Half_facet_3<Tr> h(star.center(), c, i);
      return ! fans.contains(h.v, h.w);
    };
    const auto add = [this](const Cell_handle c) { return m_sector_of_cell.emplace(&*c, size() - 1).second; };
    for(const Cell_handle c : star.cells())
      if(m_sector_of_cell.count(&*c) == 0)
      {
        m_is_infinite.push_back(m_tr.is_infinite(c));
        internal::flood_fill(c, is_open, add);
      }
  }

  std::size_t size() const { return m_is_infinite.size(); }

  // Whether the sector i is outside the hull.
  bool is_infinite(const std::size_t i) const { return m_is_infinite[i]; }

  // The sector that a cell of the star is in.
  std::size_t operator[](const Cell_handle c) const { return m_sector_of_cell.find(&*c)->second; }

  // Those on the positive and on the negative side of a fan.
  std::array<std::size_t, 2> sides(const Fan& fan) const
  {
    const auto& h = fan.facets.front();
    return {{ (*this)[h.cell], (*this)[h.cell->neighbor(h.cell->index(h.opposite))] }};
  }

private:
  const Tr& m_tr;
  std::unordered_map<const void*, std::size_t> m_sector_of_cell; // look-up only
  std::vector<bool> m_is_infinite;                               // by sector
};

/*
 * The points s_i that come in the place of a Steiner point s [CZZ+17, Alg. A.1 to A.3], one for each sector of its
 * star. Each sees all the boundary of its sector, which is starred from it. The sector outside the hull has no s_i: its
 * triangles go to the infinite vertex.
 */
template <typename Tr>
class Place_sector_points_3
{
public:
  typedef Steiner_mesh_3<Tr>                Mesh;
  typedef typename Mesh::Vertex_handle               Vertex_handle;
  typedef typename Mesh::Cell_handle                 Cell_handle;
  typedef typename Mesh::Vertices                    Vertices;
  typedef typename Mesh::Editor::Tetrahedron         Tetrahedron;
  typedef Half_facet_star_3<Tr>                      Star;
  typedef Facet_fans_3<Tr>                           Fans;
  typedef Star_sectors_3<Tr>                         Sectors;

  explicit Place_sector_points_3(Mesh& mesh) : m_mesh(mesh), m_move_into_kernel(mesh.predicates, mesh.positions) { }

  // Creates the vertices, and finds positions for them, which may be exact ones. The fans are triangulated. Returns
  // false if there is no position for one of them; then no vertex was created.
  bool operator()(const Star& star, const Fans& fans, const Sectors& sectors)
  {
    collect_faces(star, fans, sectors);
    for(Sector& sector : m_sectors)
      if(! sector.is_infinite && ! place_point(star.center(), sector))
      {
        delete_vertices();
        return false;
      }
    return true;
  }

  // The new vertices, by sector.
  Vertices vertices() const
  {
    Vertices result;
    for(const Sector& sector : m_sectors)
      if(sector.vertex != Vertex_handle())
        result.push_back(sector.vertex);
    return result;
  }

  // The new cells of the star.
  std::vector<Tetrahedron> tetrahedra() const
  {
    std::vector<Tetrahedron> result;
    for(const Sector& sector : m_sectors)
      for(const Vertex_triple& f : sector.faces)
        result.push_back({{ f[0], f[1], f[2], apex(sector) }});
    return result;
  }

private:
  typedef typename Mesh::Exact_point                    Exact_point;
  typedef typename Mesh::Positions::Exact_kernel::Vector_3    Exact_vector;
  typedef typename Fans::Fan                            Fan;
  typedef typename Fan::Vertex_triple                   Vertex_triple;

  struct Sector
  {
    bool is_infinite;
    std::vector<Vertex_triple> faces;   // the sector is on their positive sides; where infinite, only those in fans
    Exact_vector normal = NULL_VECTOR;  // the sum of the unit normals of the fans
    std::vector<Exact_vector> normals;  // of the fans, exact ones
    Exact_vector middle = NULL_VECTOR;  // the mean direction of the fans
    Vertex_handle vertex = Vertex_handle();
  };

  Vertex_handle apex(const Sector& sector) const
  {
    return sector.is_infinite ? m_mesh.tr.infinite_vertex() : sector.vertex;
  }

  void collect_faces(const Star& star, const Fans& fans, const Sectors& sectors)
  {
    m_sectors.clear();
    for(std::size_t i = 0; i < sectors.size(); ++i)
    {
      m_sectors.emplace_back();
      m_sectors.back().is_infinite = sectors.is_infinite(i);
    }
    for(const Cell_handle c : star.cells())
    {
      Sector& sector = m_sectors[sectors[c]];
      if(! sector.is_infinite) // the infinite vertex is on the old ones
        sector.faces.push_back(internal::facet_vertices(c, c->index(star.center())));
    }
    for(const Fan& fan : fans)
    {
      const std::array<std::size_t, 2> sides = sectors.sides(fan);
      add_faces(fan, m_sectors[sides[0]], m_sectors[sides[1]]);
      add_directions(fan, m_mesh.positions(star.center()), m_sectors[sides[0]], m_sectors[sides[1]]);
    }
  }

  static void add_faces(const Fan& fan, Sector& above, Sector& below)
  {
    for(const Vertex_triple& t : fan.triangles)
    {
      above.faces.push_back(t);
      below.faces.push_back({{ t[0], t[2], t[1] }});
    }
  }

  void add_directions(const Fan& fan, const Exact_point& s, Sector& above, Sector& below) const
  {
    const double length = std::sqrt(fan.normal.squared_length());
    if(length > 0)
    {
      const Exact_vector unit_normal(fan.normal[0] / length, fan.normal[1] / length, fan.normal[2] / length);
      above.normal = above.normal + unit_normal;
      below.normal = below.normal - unit_normal;
    }
    const Vertex_triple& t = fan.triangles.front();
    const Exact_point p = m_mesh.positions(t[0]), q = m_mesh.positions(t[1]), r = m_mesh.positions(t[2]);
    const Exact_vector normal = CGAL::cross_product(q - p, r - p), middle = CGAL::centroid(p, q, r) - s;
    above.normals.push_back(normal);
    below.normals.push_back(- normal);
    above.middle = above.middle + middle;
    below.middle = below.middle + middle;
  }

  // Directions from s into the sector are that of the sum of the unit normals; the exact normals; and where normals
  // cancel, the mean direction of both fans, or its opposite.
  bool place_point(const Vertex_handle s, Sector& sector)
  {
    std::vector<Exact_vector> directions(1, sector.normal);
    directions.insert(directions.end(), sector.normals.begin(), sector.normals.end());
    directions.push_back(sector.middle);
    directions.push_back(- sector.middle);
    sector.vertex = m_mesh.editor.create_vertex();
    return m_move_into_kernel(sector.vertex, sector.faces, s, directions);
  }

  void delete_vertices()
  {
    for(const Vertex_handle v : vertices())
    {
      m_mesh.positions.erase(v);
      m_mesh.editor.delete_vertex(v);
    }
  }

  Mesh& m_mesh;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  std::vector<Sector> m_sectors;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_PLACE_SECTOR_POINTS_3_H
