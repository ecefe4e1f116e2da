// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_BAD_CELL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_BAD_CELL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Allowed_lengths_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Best_point_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Inserts a vertex into a bad cell: the cell and some around it are exchanged for the star of a new vertex.
 *
 * The cavity grows where the star would have its worst cell, as long as that helps; then the point is moved to where
 * the cells are less bad; and so on in turns. Nothing is changed before the whole star is known to be better.
 */
template <typename Mesh>
class Insert_into_bad_cell_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  Insert_into_bad_cell_3(Mesh& mesh, const typename Mesh::Quality& quality) : m_mesh(mesh), m_best_point(quality) { }

  // Searches for a point. Returns whether the cells would be less bad then, and none worse than the worst one now. The
  // first point is in the cell, so if that is flat and at a wall, it is in the plane of the wall.
  bool find(const Cell_handle c)
  {
    return find(c, true) || (m_mesh.quality(c) < nearly_flat * m_mesh.enough() && find(c, false));
  }

  // Inserts the vertex. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply()
  {
    const typename Mesh::Point_3 p(m_point[0], m_point[1], m_point[2]);
    for(const Face& f : m_faces)
      if(! m_mesh.is_positive(Mesh::point(f.vertices[0]), Mesh::point(f.vertices[1]), Mesh::point(f.vertices[2]), p))
        return false;
    m_new_cells = &m_mesh.star(m_cells, m_faces, p, m_size, m_least);
    return true;
  }

  const Cells& new_cells() const { return *m_new_cells; }

private:
  // The facet opposite to the vertex `index` of a cell of the cavity, seen from inside.
  struct Face
  {
    std::array<Vertex_handle, 3> vertices;
    Cell_handle cell;
    int index;
  };

  // See "Tuning constants" in the manual.
  static constexpr int max_number_of_turns = 3;
  static constexpr std::size_t max_number_of_cells = 30;
  static constexpr double nearly_flat = 0.1;

  bool find(const Cell_handle c, const bool minds_walls)
  {
    const double enough = m_mesh.enough();
    start(c);
    for(int turn = 0; turn < max_number_of_turns; ++turn)
    {
      const bool has_grown = grow(enough, minds_walls);
      if(turn > 0 && ! has_grown)
        break;
      if(! is_no_vertex_inside() || has_constrained_edge_inside())
        return false;
      set_faces(enough);
      m_best_point.improve(m_point, [](const Coordinates_3&) { return true; });
      m_quality = m_best_point.worst_quality(m_point);
      if(m_quality >= enough)
        break;
    }
    return m_quality > m_worst && is_less_bad() && is_in_size();
  }

  void start(const Cell_handle c)
  {
    m_cells.assign(1, c);
    m_faces.clear();
    for(int i = 0; i < 4; ++i)
      m_faces.push_back(Face{ internal::facet_vertices(c, i), c, i });
    m_point = internal::centroid(internal::corners(c));
    m_worst = m_quality = m_mesh.quality(c);
  }

  // Takes in the cell behind the worst face, again and again, until that is a wall, or all are good enough. If walls
  // are not minded, that is done at the other faces. Returns whether there was a cell.
  bool grow(const double enough, const bool minds_walls)
  {
    bool has_grown = false;
    while(m_cells.size() < max_number_of_cells)
    {
      double worst = enough;
      const Face* face = nullptr;
      for(const Face& f : m_faces)
      {
        const double q = quality(f);
        if(q < worst && (minds_walls || ! is_wall(f)))
        {
          worst = q;
          face = &f;
        }
      }
      if(face == nullptr || is_wall(*face))
        break;
      take_in(face->cell->neighbor(face->index));
      has_grown = true;
    }
    return has_grown;
  }

  bool is_wall(const Face& f) const { return m_mesh.domain().is_wall(f.cell, f.index); }

  double quality(const Face& f) const { return m_mesh.quality(f.vertices, m_point); }

  void take_in(const Cell_handle c)
  {
    m_worst = (std::min)(m_worst, m_mesh.quality(c));
    m_cells.push_back(c);
    m_faces.erase(std::remove_if(m_faces.begin(), m_faces.end(),
                                 [&](const Face& f) { return f.cell->neighbor(f.index) == c; }), m_faces.end());
    for(int i = 0; i < 4; ++i)
      if(! internal::contains(m_cells, c->neighbor(i)))
        m_faces.push_back(Face{ internal::facet_vertices(c, i), c, i });
  }

  // All of the facets between cells of the cavity were gone through, so none is constrained; but edges may be, and
  // vertices may be inside. Euler's formula tells how many are on the sphere that its boundary has to be.
  bool is_no_vertex_inside()
  {
    m_vertices.clear();
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        if(! internal::contains(m_vertices, c->vertex(i)))
          m_vertices.push_back(c->vertex(i));
        const Cell_handle n = c->neighbor(i);
        if(internal::contains(m_cells, n) && m_mesh.domain().is_wall(c, i))
          return false;
      }
    return 2 * m_vertices.size() == m_faces.size() + 4;
  }

  bool has_constrained_edge_inside() const
  {
    if constexpr(Mesh::Domain::has_constrained_edges)
      for(const Cell_handle c : m_cells)
        for(int i = 0; i < 4; ++i)
          for(int j = 0; j < i; ++j)
            if(m_mesh.domain().is_constrained_edge(c->vertex(i), c->vertex(j)) &&
               std::none_of(m_faces.begin(), m_faces.end(), [&](const Face& f)
               {
                 return internal::contains(f.vertices, c->vertex(i)) && internal::contains(f.vertices, c->vertex(j));
               }))
              return true;
    return false;
  }

  void set_faces(const double enough)
  {
    m_best_point.clear(enough);
    for(const Face& f : m_faces)
      m_best_point.add({{ Mesh::coordinates(f.vertices[0]), Mesh::coordinates(f.vertices[1]),
                          Mesh::coordinates(f.vertices[2]) }});
  }

  bool is_less_bad() const
  {
    double gain = m_mesh.account_of(m_cells).badness;
    for(const Face& f : m_faces)
      gain -= m_mesh.badness(quality(f));
    return gain > 0;
  }

  // Whether the edges of the new vertex, which gets the mean size, would be.
  bool is_in_size()
  {
    const auto& lengths = m_mesh.allowed_lengths();
    m_size = 0;
    m_least = std::numeric_limits<double>::infinity();
    for(const Vertex_handle v : m_vertices)
    {
      m_size += Mesh::size(v) / static_cast<double>(m_vertices.size());
      m_least = (std::min)(m_least, lengths.faded(lengths.least(v), distance(v)));
    }
    const double longest = longest_edge();
    return std::all_of(m_vertices.begin(), m_vertices.end(), [&](const Vertex_handle v)
    {
      const auto range = lengths.at(v, m_size, m_least);
      return distance(v) >= range.least && distance(v) <= (std::max)(range.largest, longest);
    });
  }

  // Of the cells of the cavity: where edges were longer than they should be, they may be so again.
  double longest_edge() const
  {
    double longest = 0;
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
          longest = (std::max)(longest, internal::squared_distance(Mesh::coordinates(c->vertex(i)),
                                                                   Mesh::coordinates(c->vertex(j))));
    return std::sqrt(longest);
  }

  double distance(const Vertex_handle v) const { return internal::distance(Mesh::coordinates(v), m_point); }

  Mesh& m_mesh;
  Best_point_in_star_3<typename Mesh::Quality> m_best_point;
  Coordinates_3 m_point;
  double m_size = 0;
  double m_least = 0;
  double m_worst = 0; // of the cells of the cavity
  double m_quality = 0;
  std::vector<Cell_handle> m_cells;
  std::vector<Face> m_faces;
  std::vector<Vertex_handle> m_vertices;
  const Cells* m_new_cells = nullptr;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_INTO_BAD_CELL_3_H
