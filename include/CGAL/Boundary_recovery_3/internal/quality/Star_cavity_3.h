// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_STAR_CAVITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_STAR_CAVITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Best_point_in_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Cells that are to be exchanged for the star of a new vertex: they grow one by one, through facets that are no walls.
 * Free vertices that come to be inside go with them.
 */
template <typename Mesh>
class Star_cavity_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  // The facet opposite to the vertex `index` of a cell of the cavity, seen from inside.
  struct Face
  {
    std::array<Vertex_handle, 3> vertices;
    Cell_handle cell;
    int index;
    double quality; // of the new cell there
  };

  explicit Star_cavity_3(Mesh& mesh) : m_mesh(mesh), m_best_point(mesh.quality()) { }

  // One cell, and the place of the vertex.
  void start(const Cell_handle c, const Coordinates_3& p)
  {
    m_point = p;
    m_faces.clear();
    m_cells.clear();
    m_worst = std::numeric_limits<double>::infinity();
    m_badness = 0;
    add(c);
  }

  // Adds the neighbor of a cell of the cavity.
  void take_in(const Cell_handle c)
  {
    m_faces.erase(std::remove_if(m_faces.begin(), m_faces.end(),
                                 [&](const Face& f) { return f.cell->neighbor(f.index) == c; }), m_faces.end());
    add(c);
  }

  // The first ones of the cells are left.
  void go_back_to(const std::size_t number_of_cells)
  {
    const std::vector<Cell_handle> cells(m_cells.begin(), m_cells.begin() + number_of_cells);
    start(cells.front(), m_point);
    for(std::size_t i = 1; i < number_of_cells; ++i)
      take_in(cells[i]);
  }

  const std::vector<Cell_handle>& cells() const { return m_cells; }
  const std::vector<Face>& faces() const { return m_faces; }

  // Whether it should not grow any more.
  bool is_large() const { return m_cells.size() >= max_number_of_cells; }

  // Moves the vertex to the best place. Returns the quality of the worst new cell.
  double move_point()
  {
    m_best_point.clear(m_mesh.measure_of_badness());
    for(const Face& f : m_faces)
      m_best_point.add(internal::corners(f.vertices));
    m_best_point.improve(m_point, [](const Coordinates_3&) { return true; });
    const std::vector<double>& qualities = m_best_point.qualities();
    for(std::size_t k = 0; k < m_faces.size(); ++k)
      m_faces[k].quality = qualities[k];
    return *std::min_element(qualities.begin(), qualities.end());
  }

  // The same, from another place on.
  double move_point_from(const Coordinates_3& p)
  {
    m_point = p;
    return move_point();
  }

  // The quality of the worst cell that goes, and the sum of badness of all.
  double worst_quality() const { return m_worst; }
  double badness() const { return m_badness; }

  bool is_wall(const Face& f) const { return m_mesh.domain().is_wall(f.cell, f.index); }

  // By how much the new cells are less bad.
  double gain() const
  {
    double gain = m_badness;
    for(const Face& f : m_faces)
      gain -= m_mesh.badness(f.quality);
    return gain;
  }

  // Whether nothing but free vertices would be lost. All of the facets between cells of the cavity were gone through,
  // so none is constrained; but edges and vertices inside may be. Euler's formula tells how many vertices are on the
  // sphere that its boundary has to be.
  bool has_only_free_vertices_inside()
  {
    set_vertices_of_faces();
    return 2 * m_vertices.size() == m_faces.size() + 4 && set_free_vertices_inside() && ! has_constrained_edge_inside();
  }

  // Whether the edges of the new vertex, which gets the mean size, would be. The cavity has only free vertices inside,
  // as `has_only_free_vertices_inside()` found last.
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

  // Whether all new cells are positively oriented; that is decided exactly.
  bool is_star() const
  {
    const typename Mesh::Point_3 p(m_point[0], m_point[1], m_point[2]);
    return std::all_of(m_faces.begin(), m_faces.end(), [&](const Face& f)
    {
      return m_mesh.is_positive(Mesh::point(f.vertices[0]), Mesh::point(f.vertices[1]), Mesh::point(f.vertices[2]), p);
    });
  }

  // Exchanges the cells. The edges were found to be in size.
  const Cells& exchange()
  {
    return m_mesh.star(m_cells, m_faces, typename Mesh::Point_3(m_point[0], m_point[1], m_point[2]), m_size, m_least,
                       m_vertices_inside);
  }

  // How many vertices go, or are gone.
  std::size_t number_of_vertices_inside() const { return m_vertices_inside.size(); }

private:
  static constexpr std::size_t max_number_of_cells = 30; // see "Tuning constants" in the manual

  // With those of its facets that the cavity ends at.
  void add(const Cell_handle c)
  {
    m_cells.push_back(c);
    const std::size_t number_before = m_faces.size();
    for(int i = 0; i < 4; ++i)
      if(! internal::contains(m_cells, c->neighbor(i)))
        m_faces.push_back(Face{ internal::facet_vertices(c, i), c, i, 0 });
    look_at_qualities(c, number_before);
  }

  // Those of a cell that goes, the item without a face, and of the new cells at its faces, the last ones.
  void look_at_qualities(const Cell_handle c, const std::size_t first_face)
  {
    boost::container::static_vector<Face*, 5> items(1, nullptr);
    for(std::size_t k = first_face; k < m_faces.size(); ++k)
      items.push_back(&m_faces[k]);
    const auto corners = [&](const Face* const f)
    {
      return f == nullptr ? internal::corners(c) : Mesh::corners(f->vertices, m_point);
    };
    internal::visit_qualities(m_mesh.quality(), items, corners, [&](Face* const f, const double q)
    {
      if(f != nullptr)
        f->quality = q;
      else
        count_old_cell(q);
      return true;
    });
  }

  void count_old_cell(const double quality)
  {
    m_worst = (std::min)(m_worst, quality);
    m_badness += m_mesh.badness(quality);
  }

  void set_vertices_of_faces()
  {
    m_vertices.clear();
    for(const Face& f : m_faces)
      for(const Vertex_handle v : f.vertices)
        if(! internal::contains(m_vertices, v))
          m_vertices.push_back(v);
  }

  // Returns false if one is not free, or a wall was gone around.
  bool set_free_vertices_inside()
  {
    m_vertices_inside.clear();
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        if(m_mesh.domain().is_wall(c, i) && internal::contains(m_cells, c->neighbor(i)))
          return false;
        const Vertex_handle v = c->vertex(i);
        if(internal::contains(m_vertices, v) || internal::contains(m_vertices_inside, v))
          continue;
        if(Mesh::is_on_constraint_by_dimension(v))
          return false;
        m_vertices_inside.push_back(v);
      }
    return true;
  }

  bool has_constrained_edge_inside() const
  {
    if(m_mesh.domain().has_constrained_edges())
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
  double m_worst = 0;   // of the qualities of the cells
  double m_badness = 0; // of the cells
  std::vector<Cell_handle> m_cells;
  std::vector<Face> m_faces;
  std::vector<Vertex_handle> m_vertices; // of the faces
  std::vector<Vertex_handle> m_vertices_inside;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_STAR_CAVITY_3_H
