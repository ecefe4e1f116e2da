// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FIELD_POINT_CAVITY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FIELD_POINT_CAVITY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <CGAL/Triangulation_utils_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The few vertices of a cavity, each once, in the order in which they come. To clear it costs nothing, whatever its
 * size, so it can serve millions of cavities, most of them small.
 */
template <typename Vertex_handle>
class Local_vertices
{
public:
  Local_vertices() : m_slots(64) { }

  void clear()
  {
    ++m_round;
    m_vertices.clear();
  }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  std::size_t size() const { return m_vertices.size(); }

  // Returns whether the vertex is new.
  bool insert(const Vertex_handle v)
  {
    if(2 * (m_vertices.size() + 1) > m_slots.size())
      enlarge();
    Slot& slot = m_slots[position(v)];
    if(slot.round == m_round)
      return false;
    slot = Slot{ m_round, v };
    m_vertices.push_back(v);
    return true;
  }

private:
  struct Slot
  {
    std::uint64_t round = 0; // when it was filled; it is empty in all other rounds
    Vertex_handle vertex;
  };

  std::size_t position(const Vertex_handle v) const
  {
    const std::size_t mask = m_slots.size() - 1;
    std::size_t i = static_cast<std::size_t>(internal::hash_share(v)) & mask;
    while(m_slots[i].round == m_round && m_slots[i].vertex != v)
      i = (i + 1) & mask;
    return i;
  }

  void enlarge()
  {
    m_slots.assign(2 * m_slots.size(), Slot());
    for(const Vertex_handle v : m_vertices)
      m_slots[position(v)] = Slot{ m_round, v };
  }

  std::vector<Slot> m_slots;
  std::vector<Vertex_handle> m_vertices;
  std::uint64_t m_round = 1;
};

/*
 * The cells that a new point in a region of the domain takes the place of: the cavity of the modified Bowyer-Watson
 * algorithm [CZZ+17, Section 4.1, step 6].
 *
 * It consists of the cells whose circumspheres contain the point, as far as they can be reached from the first one
 * without crossing a constrained facet. It is made star-shaped by exact orientations: cells at faces that the point
 * does not see are taken out. Nor may a constraint be inside, or a vertex be lost.
 *
 * While a cavity is there, its cells are marked as in conflict; `clear()` ends that, or the destructor, if a property
 * map or a visitor threw.
 */
template <typename Tr>
class Field_point_cavity_3
{
public:
  typedef Selected_domain_3<Tr>         Domain;
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;
  typedef typename Tr::Geom_traits::Point_3 Point;
  typedef std::vector<Cell_handle>      Cells;
  typedef Local_vertices<Vertex_handle>  Vertices;

  // The facet opposite to the vertex `index` of a cell of the cavity, seen from inside.
  struct Face
  {
    std::array<Vertex_handle, 3> vertices;
    Cell_handle cell;
    int index;
  };

  Field_point_cavity_3(const Tr& tr, const Domain& domain) : m_tr(tr), m_domain(domain) { }

  Field_point_cavity_3(const Field_point_cavity_3&) = delete;
  Field_point_cavity_3& operator=(const Field_point_cavity_3&) = delete;

  ~Field_point_cavity_3() { clear(true); }

  // Finds the cavity of p, which begins with the first cell. Returns whether it can be starred, and no vertex that is
  // met is nearer than `min_distance`, nor has a seam an edge longer than `max_seam`.
  bool find(const Point& p, const Cell_handle first, const double min_distance = 0,
            const double max_seam = std::numeric_limits<double>::infinity())
  {
    m_point = p;
    m_coordinates = internal::coordinates_of(p);
    m_min_squared_distance = min_distance * min_distance;
    m_max_seam = max_seam;
    m_is_at_border = false;
    return start(first) && grow()
        && ((! is_large() && are_faces_seen()) || shrink_until_seen())
        && is_no_vertex_inside() && ! has_constrained_edge_inside();
  }

  // Whether the last search ended where the cavity would have gone on beyond the border of a part.
  bool is_at_border() const { return m_is_at_border; }

  const Cells& cells() const { return m_cells; }

  const std::vector<Face>& faces() const { return m_faces; }

  const Vertices& vertices() const { return m_vertices; }

  // Takes the marks from the cells around the cavity, and from its cells if they are still there; also after a search
  // without success.
  void clear(const bool are_cells_there)
  {
    if(are_cells_there)
      for(const Cell_handle c : m_cells)
        c->tds_data().clear();
    for(const Cell_handle c : m_cells_around)
      c->tds_data().clear();
    m_cells.clear();
    m_cells_around.clear();
  }

private:
  // From so many cells on, only those are added that are behind facets which the point sees. In meshes that are nearly
  // Delaunay that makes no difference; else circumspheres are large, and most of what they contain is hidden.
  static constexpr std::size_t max_number_of_hidden_cells = 64;

  bool start(const Cell_handle first)
  {
    m_cells.clear();
    m_faces.clear();
    m_vertices.clear();
    for(int i = 0; i < 4; ++i)
      if(! add(first->vertex(i)))
        return false;
    add(first);
    return true;
  }

  bool grow()
  {
    for(std::size_t k = 0; k < m_cells.size(); ++k) // it grows
      for(int i = 0; i < 4; ++i)
        if(! look_behind(m_cells[k], i))
          return false;
    return true;
  }

  // Returns whether it is far enough.
  bool add(const Vertex_handle v)
  {
    return ! m_vertices.insert(v)
        || internal::squared_distance(internal::coordinates_of(v->point()), m_coordinates) >= m_min_squared_distance;
  }

  void add(const Cell_handle c)
  {
    m_cells.push_back(c); // first, so that the mark is cleared in any case
    c->tds_data().mark_in_conflict();
  }

  // Returns false if there is a constrained facet inside, a vertex that is too near, or a seam that is too large.
  bool look_behind(const Cell_handle c, const int i)
  {
    const Cell_handle n = c->neighbor(i);
    const bool is_wall = m_domain.is_wall(c, i);
    if(is_wall && (is_at_large_seam(c, i) || goes_beyond_border(c, i)))
      return false;
    if(n->tds_data().is_in_conflict())
      return ! is_wall;
    if(is_wall || n->tds_data().is_on_boundary() || is_hidden(c, i) || ! is_in_conflict(n))
    {
      m_faces.push_back(Face{ internal::facet_vertices(c, i), c, i });
      return true;
    }
    add(n);
    return add(n->vertex(n->index(c)));
  }

  bool is_at_large_seam(const Cell_handle c, const int i) const
  {
    return m_domain.is_seam(c, i) && internal::longest_edge_of_facet(internal::corners(c), i) > m_max_seam;
  }

  bool goes_beyond_border(const Cell_handle c, const int i)
  {
    m_is_at_border = m_domain.is_border(c, i)
                     && internal::is_in_circumsphere(internal::corners(c->neighbor(i)), m_coordinates);
    return m_is_at_border;
  }

  bool is_large() const { return m_cells.size() >= max_number_of_hidden_cells; }

  // Whether the point does not see a facet from inside; only asked for in large cavities.
  bool is_hidden(const Cell_handle c, const int i) const
  {
    return is_large() && ! (internal::volume_times_6_with(internal::corners(c), i, m_coordinates) > 0);
  }

  // Whether the circumsphere of a cell contains the point, in floating point numbers: a wrong answer makes another
  // cavity, not an invalid one. If not, the cell is marked, and not asked again.
  bool is_in_conflict(const Cell_handle n)
  {
    if(internal::is_in_circumsphere(internal::corners(n), m_coordinates))
      return true;
    m_cells_around.push_back(n);
    n->tds_data().mark_on_boundary();
    return false;
  }

  bool is_seen(const std::array<Vertex_handle, 3>& face) const
  {
    return m_tr.geom_traits().orientation_3_object()(internal::bare_point<Point>(face[0]->point()),
                                                     internal::bare_point<Point>(face[1]->point()),
                                                     internal::bare_point<Point>(face[2]->point()), m_point)
      == POSITIVE;
  }

  bool are_faces_seen() const
  {
    return std::all_of(m_faces.begin(), m_faces.end(), [this](const Face& f) { return this->is_seen(f.vertices); });
  }

  // Takes out the cells at faces that the point does not see, until it sees all. Whatever the order, the same cells
  // stay. Returns false if none does.
  bool shrink_until_seen()
  {
    Cells hidden;
    const auto remove = [&](const Cell_handle c)
    {
      if(c->tds_data().is_in_conflict())
      {
        c->tds_data().clear();
        hidden.push_back(c);
      }
    };
    collect_faces(); // where facets were hidden in a large cavity, there may be cells on both sides
    for(const Face& f : m_faces)
      if(! is_seen(f.vertices))
        remove(f.cell);
    while(! hidden.empty())
    {
      const Cell_handle c = hidden.back();
      hidden.pop_back();
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle n = c->neighbor(i);
        if(n->tds_data().is_in_conflict() && ! is_seen(internal::facet_vertices(n, n->index(c))))
          remove(n);
      }
    }
    m_cells.erase(std::remove_if(m_cells.begin(), m_cells.end(),
                                 [](const Cell_handle c) { return ! c->tds_data().is_in_conflict(); }), m_cells.end());
    collect_faces();
    return ! m_cells.empty();
  }

  void collect_faces()
  {
    m_faces.clear();
    m_vertices.clear();
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
      {
        m_vertices.insert(c->vertex(i));
        if(! c->neighbor(i)->tds_data().is_in_conflict())
          m_faces.push_back(Face{ internal::facet_vertices(c, i), c, i });
      }
  }

  // The surface of a polyhedron that a point sees from inside is a sphere: Euler's formula tells how many vertices are
  // on it. None is inside as long as all cells are in conflict, for the sphere of the one behind a vertex ends there;
  // but the first cell is not asked, and the others are in floating point numbers.
  bool is_no_vertex_inside() const { return 2 * m_vertices.size() == m_faces.size() + 4; }

  // Edges of faces are not inside: walks from one of their faces to the other one meet all cells of the cavity at them.
  // Each walk is done in both directions.
  bool has_constrained_edge_inside() const
  {
    if(! m_domain.has_constrained_edges())
      return false;
    const std::size_t n = number_of_constrained_edges_of_cells();
    return n > 0 && 2 * n != number_of_cells_at_constrained_edges_of_faces();
  }

  std::size_t number_of_constrained_edges_of_cells() const
  {
    std::size_t n = 0;
    for(const Cell_handle c : m_cells)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
          n += m_domain.is_constrained_edge(c->vertex(i), c->vertex(j));
    return n;
  }

  std::size_t number_of_cells_at_constrained_edges_of_faces() const
  {
    std::size_t n = 0;
    for(const Face& f : m_faces)
      for(int i = 0; i < 3; ++i)
        if(m_domain.is_constrained_edge(f.vertices[(i + 1) % 3], f.vertices[(i + 2) % 3]))
          n += number_of_cells_at_edge(f, i);
    return n;
  }

  // Of the edge of a face that is opposite to its vertex i: those of the cavity, from that face to the other one.
  static std::size_t number_of_cells_at_edge(const Face& f, const int i)
  {
    std::size_t n = 1;
    Edge_walk_3<Tr> walk(f.cell, Triangulation_utils_3::vertex_triple_index(f.index, i), f.index);
    for(; walk.cell()->neighbor(walk.next_facet())->tds_data().is_in_conflict(); ++walk)
      ++n;
    return n;
  }

  const Tr& m_tr;
  const Domain& m_domain;
  Point m_point;
  Coordinates_3 m_coordinates; // the same
  double m_min_squared_distance = 0;
  double m_max_seam = 0;
  bool m_is_at_border = false;
  Cells m_cells;
  Cells m_cells_around; // those that are marked
  std::vector<Face> m_faces;
  Vertices m_vertices;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FIELD_POINT_CAVITY_3_H
