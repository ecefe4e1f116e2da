// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_DOMAIN_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_DOMAIN_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Encroached_walls_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Insert_field_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Remove_long_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/walk_to.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Small_size_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Fills a domain with field points [CZZ+17, Section 4.1, step 6]: one point for each cell that is too large for the
 * sizes around it, at its circumcenter, or where that cannot be, at its centroid.
 *
 * A cell is too large if its circumradius is longer than `largest_radius` times the size at its centroid. Each cell is
 * examined once: the cells of the domain, and after each insertion the cells around the new vertices. A point is
 * inserted only if no vertex of its cavity is nearer than `Length_rules::smallest_distance` times the size at the
 * point, so the work ends.
 *
 * Where sizes grow fast, a cell may be small enough for the size at its centroid, but not for sizes elsewhere in the
 * cell. Such a cell gets a point where the size is far smaller, if there is such a place.
 *
 * No point may encroach on a wall that is far larger than the sizes beside the wall: the cells between the point and
 * the wall would be bad. If a centroid encroaches, a place farther from the wall is tried.
 *
 * Few cells are too large and get no point, mostly where the mesh is far from Delaunay after the recovery. Some of them
 * have edges that are much longer than the size; in the end, these edges are removed or divided.
 */
template <typename Tr>
class Fill_domain_3
{
public:
  typedef Selected_domain_3<Tr>               Domain;
  typedef Region_sizes_3<Tr>                  Sizes;
  typedef typename Tr::Vertex_handle          Vertex_handle;
  typedef typename Tr::Cell_handle            Cell_handle;
  typedef typename Tr::Geom_traits::Point_3   Point_3;
  typedef std::vector<Vertex_handle>          Vertices;
  typedef std::array<Coordinates_3, 4>        Corners;

  Fill_domain_3(Tr& tr, Domain& domain, Sizes& sizes, Recovery_context<Tr>& context)
    : m_tr(tr), m_domain(domain), m_sizes(sizes), m_context(context), m_cavity(tr, domain),
      m_search(sizes), m_insert(tr, domain, context.visitor()), m_remove_edge(tr, domain, context.visitor())
  { }

  // No vertex is left as pending, also if somebody throws.
  ~Fill_domain_3()
  {
    for(const Vertex_handle v : m_pending)
      m_sizes.settle(v);
  }

  // Fills the domain, which has these cells, until it is done, or there are as many vertices as allowed, or the context
  // or the sizes say no. About `expected_number` points are expected; only reports of progress depend on that.
  void operator()(const std::vector<Cell_handle>& cells, const std::size_t max_number_of_vertices,
                  const std::size_t expected_number)
  {
    const Encroached_walls_3 walls = large_walls(cells);
    begin(walls, m_tr.number_of_vertices(), max_number_of_vertices, expected_number);
    fill(cells);
    shorten_long_edges();
    if(can_go_on())
      tell_progress(m_vertices.size());
  }

  // --- the same step by step ----------------------------------------------------------------------------------------

  // The walls of the cells that are large compared with the sizes beside them; no seams, since these do not stay.
  Encroached_walls_3 large_walls(const std::vector<Cell_handle>& cells);

  // There are so many vertices by now.
  void begin(const Encroached_walls_3& walls, const std::size_t number_of_vertices,
             const std::size_t max_number_of_vertices, const std::size_t expected_number)
  {
    m_walls = &walls;
    m_max_number_of_points = max_number_of_vertices - (std::min)(number_of_vertices, max_number_of_vertices);
    m_expected_number = expected_number;
    m_search.add_vertices(number_of_vertices);
  }

  // Looks at these cells, and at those that come.
  void fill(const std::vector<Cell_handle>& cells) { look_at_all(cells, [this](const Cell_handle c) { look_at(c); }); }

  // The same only where a cell is concerned. Returns the other cells, which have to be looked at later.
  template <typename Concerns>
  std::vector<Cell_handle> fill(const std::vector<Cell_handle>& cells, const Concerns& concerns)
  {
    std::vector<Cell_handle> others;
    look_at_all(cells, [&](const Cell_handle c)
    {
      if(concerns(c))
        look_at(c);
      else
        others.push_back(c);
    });
    return others;
  }

  // The cells of a part whose points would have changed something beyond its border.
  const std::vector<Cell_handle>& cells_put_off() const { return m_cells_put_off; }

  // What was done in a part, and is not done there.
  void take_over(const Fill_domain_3& part)
  {
    m_vertices.insert(m_vertices.end(), part.m_vertices.begin(), part.m_vertices.end());
    m_long_cells.insert(m_long_cells.end(), part.m_long_cells.begin(), part.m_long_cells.end());
    m_search.take_over(part.m_search);
    m_search.add_vertices(part.m_vertices.size());
    m_is_full = m_is_full || part.m_is_full;
  }

  void shorten_long_edges();

  bool can_go_on() { return m_sizes.is_valid() && ! m_is_full && m_context.go_further_after_short_step(); }

  // Whether the handle belongs to a cell without pending vertices. If the cell that had the handle is gone, a newer
  // cell may have it, which does no harm.
  bool is_there(const Cell_handle c) const
  {
    if(! m_tr.tds().cells().is_used(c))
      return false;
    for(int i = 0; i < 4; ++i)
      if(m_sizes.is_pending(c->vertex(i)))
        return false;
    return true;
  }

  // The vertices that were inserted, in order.
  const Vertices& vertices() const { return m_vertices; }

  // Whether no small size can be in a cell unseen.
  bool is_resolved() const { return m_search.is_complete(); }

  // Whether a point was not inserted because the largest number of vertices was reached.
  bool is_full() const { return m_is_full; }

private:
  typedef Remove_long_edge_3<Tr>   Remove_edge;
  typedef Small_size_search_3<Tr>  Search;
  typedef typename Sizes::Size     Size;

  // As parts of the size, see "Tuning constants" in the manual.
  static constexpr double largest_radius = 0.75;
  static constexpr double largest_wall = 0.5;            // beside a long edge, as a part of its length
  static constexpr double largest_seam = 2;
  static constexpr int max_number_of_rounds = 4;
  static constexpr std::size_t vertices_per_edge = 8;    // that is tried, where many cells have to be long
  static constexpr std::size_t least_number_of_edges = 8000;
  static constexpr int max_number_of_steps = 20;
  static constexpr std::size_t number_of_reports = 200;

  template <typename Look_at>
  void look_at_all(const std::vector<Cell_handle>& cells, const Look_at& look_at)
  {
    for(std::size_t k = 0; k < cells.size() && can_go_on(); ++k)
      if(is_there(cells[k]))
      {
        look_at(cells[k]);
        look_around_new_vertices(look_at);
      }
  }

  // The last one first: what is near was touched a moment ago, and is in the cache.
  template <typename Look_at>
  void look_around_new_vertices(const Look_at& look_at)
  {
    while(! m_pending.empty() && can_go_on())
    {
      const Vertex_handle v = settle_last();
      for(const Cell_handle c : m_star)
        if(can_go_on() && is_there(c) && c->has_vertex(v))
          look_at(c);
    }
  }

  // The last new vertex, whose star is known then. Cells with another new vertex are left to that one.
  Vertex_handle settle_last()
  {
    const Vertex_handle v = m_pending.back();
    m_pending.pop_back();
    m_sizes.settle(v);
    m_star.clear();
    m_tr.tds().incident_cells(v, std::back_inserter(m_star));
    return v;
  }

  void add_if_large(const Cell_handle c, const int i, std::vector<Encroached_walls_3::Wall>& walls)
  {
    const Corners p = internal::corners(c);
    const double longest = internal::longest_edge_of_facet(p, i);
    if(! Encroached_walls_3::is_large(longest, m_sizes.least_size_at_centroid(c, p)))
      return;
    const double size = m_sizes.of_field(internal::centroid(p), m_sizes.region(c));
    if(Encroached_walls_3::is_large(longest, size))
      walls.push_back({ internal::corners(internal::facet_vertices(c, i)), size });
  }

  bool is_wall_that_stays(const Cell_handle c, const int i) const
  {
    return m_domain.is_wall(c, i) && ! m_domain.is_seam(c, i);
  }

  void look_at(const Cell_handle c)
  {
    const Corners p = internal::corners(c);
    const Sphere_3 sphere = internal::circumsphere(p);
    const double radius = std::sqrt(sphere.squared_radius);
    m_is_at_border = false;
    if(radius <= largest_radius * m_sizes.least_size_at_centroid(c, p))
      return look_where_small(c, p, radius / largest_radius);
    const Coordinates_3 center = internal::centroid(p);
    const Size size = m_sizes(center, c);
    if(radius <= largest_radius * size.possible)
      return look_where_small(c, p, radius / largest_radius);
    if(! try_center(sphere.center, c) && ! try_point(center, c, size) && ! try_point_beside_walls(center, c, size)
       && ! try_where_small(c, p, size.possible) && ! is_put_off(c)
       && internal::longest_edge(p).length > Length_rules::longest_edge * size.possible)
      m_long_cells.push_back(c);
  }

  bool try_center(const Coordinates_3& center, const Cell_handle c)
  {
    const Cell_handle at_center = walk(c, center);
    return at_center != Cell_handle() && try_point(center, at_center, m_sizes(center, at_center));
  }

  // Whether the border of a part was in the way; then the cell is looked at later, and nothing else is tried there.
  bool is_put_off(const Cell_handle c)
  {
    if(m_is_at_border)
      m_cells_put_off.push_back(c);
    return m_is_at_border;
  }

  // The cell is good for a size. No size is far smaller if sizes do not grow fast, since no corner is farther away from
  // the centroid than one and a half radii.
  void look_where_small(const Cell_handle c, const Corners& p, const double size)
  {
    constexpr double harmless_growth = (1 - Search::certain) / (1.5 * largest_radius);
    if(! (m_sizes.grading() <= harmless_growth) && ! try_where_small(c, p, size))
      is_put_off(c);
  }

  bool try_where_small(const Cell_handle c, const Corners& p, const double size)
  {
    return ! m_is_at_border && m_search(c, p, size, [&](const Coordinates_3& q)
    {
      const Size at_q = m_sizes(q, c);
      return try_point(q, c, at_q) || try_point_beside_walls(q, c, at_q);
    });
  }

  // If a place encroaches on walls, there may be one beside them.
  bool try_point_beside_walls(const Coordinates_3& place, const Cell_handle c, const Size& size)
  {
    const Coordinates_3 p = m_walls->place_beside(place, size.possible);
    if(p == place || m_is_at_border)
      return false;
    const Cell_handle at_p = walk(c, p);
    return at_p != Cell_handle() && try_point(p, at_p, m_sizes(p, at_p));
  }

  // Goes through the edges of the cell that are too long, the longest one first, until one is removed, or else divided
  // in the middle: then the cell is gone.
  void shorten_long_edge(const Cell_handle c)
  {
    const Corners p = internal::corners(c);
    for(const Tetrahedron_edge_3& e : internal::edges_from_long_to_short(p))
    {
      const Coordinates_3 middle = internal::midpoint(p[e.i], p[e.j]);
      const Size size = m_sizes(middle, c);
      if(! (e.length > Length_rules::longest_edge * size.possible) || m_number_of_edges_left == 0)
        return;
      --m_number_of_edges_left;
      if(m_domain.is_constrained_edge(c->vertex(e.i), c->vertex(e.j)) || has_to_be_long(c, e))
        continue;
      if(m_remove_edge(typename Tr::Edge(c, e.i, e.j)))
      {
        m_long_cells.insert(m_long_cells.end(), m_remove_edge.new_cells().begin(), m_remove_edge.new_cells().end());
        return;
      }
      if(e.length > Length_rules::longest_undivided_edge * size.possible && try_point_on_edge(middle, c, size))
        return;
    }
  }

  // Whether an edge has to be long: it is on a wall, or one of its cells has a wall that is not much smaller than the
  // edge. Also true for edges with too many cells for a removal.
  bool has_to_be_long(const Cell_handle c, const Tetrahedron_edge_3& e) const
  {
    auto around = m_tr.tds().incident_cells(c, e.i, e.j);
    const auto first = around;
    int degree = 0;
    do
      if(++degree > Remove_edge::max_degree || has_large_wall(around, c->vertex(e.i), c->vertex(e.j), e.length))
        return true;
    while(++around != first);
    return false;
  }

  // The same for one of the cells at an edge.
  bool has_large_wall(const Cell_handle c, const Vertex_handle u, const Vertex_handle v, const double length) const
  {
    for(int i = 0; i < 4; ++i)
      if(m_domain.is_wall(c, i)
         && ((c->vertex(i) != u && c->vertex(i) != v)
             || internal::longest_edge_of_facet(internal::corners(c), i) > largest_wall * length))
        return true;
    return false;
  }

  // The cell that contains a point, found by a walk from c in floating point numbers; none if a wall is in the way, or
  // if it takes too many steps. A wrong answer makes another cavity, not an invalid one.
  Cell_handle walk(const Cell_handle start, const Coordinates_3& q)
  {
    if(! std::isfinite(q[0] + q[1] + q[2]))
      return Cell_handle();
    const auto facet_towards = [&](const Cell_handle c) { return internal::facet_towards(c, q); };
    const auto cell_behind = [&](const Cell_handle c, const int i)
    {
      m_is_at_border = m_is_at_border || m_domain.is_border(c, i);
      return m_domain.is_wall(c, i) ? std::nullopt : std::optional<Cell_handle>(c->neighbor(i));
    };
    const auto last = internal::walk_to(start, max_number_of_steps, facet_towards, cell_behind);
    return last && is_in_box(*last, q) ? *last : Cell_handle();
  }

  // Nearly flat cells seem to contain points that are far away.
  static bool is_in_box(const Cell_handle c, const Coordinates_3& q)
  {
    Axis_box_3 box;
    for(const Coordinates_3& p : internal::corners(c))
      box.add(p);
    return box.contains(q);
  }

  // Inserts a vertex at a point in this cell, if the point is allowed. Returns whether it was inserted. Points are not
  // allowed beside a seam that is much too large: the flat cells at the seam would stay after the seam is gone.
  bool try_point(const Coordinates_3& coordinates, const Cell_handle c, const Size& size)
  {
    return try_point(coordinates, c, Length_rules::smallest_distance, size, [] { return true; });
  }

  // The same, but vertices may be nearer, and no new cell may be worse than the worst cell of the cavity.
  bool try_point_on_edge(const Coordinates_3& coordinates, const Cell_handle c, const Size& size)
  {
    return try_point(coordinates, c, Length_rules::smallest_distance_on_edge, size, [&]
    {
      return worst_quality_of_star(coordinates) >= worst_quality_of_cavity();
    });
  }

  template <typename Is_star_good>
  bool try_point(const Coordinates_3& coordinates, const Cell_handle c, const double min_distance, const Size& size,
                 const Is_star_good& is_star_good)
  {
    if(m_is_at_border || ! (size.possible > 0) // there is none
       || m_walls->are_encroached_by(coordinates, size.possible))
      return false;
    const Point_3 p(coordinates[0], coordinates[1], coordinates[2]);
    const bool is_good = m_cavity.find(p, c, min_distance * size.possible, largest_seam * size.possible)
                         && is_star_good();
    m_is_at_border = m_cavity.is_at_border();
    m_is_full = m_is_full || (is_good && m_vertices.size() >= m_max_number_of_points);
    if(is_good && ! m_is_full)
      insert(p, size);
    else
      m_cavity.clear(true);
    return is_good && ! m_is_full;
  }

  double worst_quality_of_cavity() const
  {
    double worst = 1;
    for(const Cell_handle c : m_cavity.cells())
      worst = (std::min)(worst, internal::tetrahedron_quality(internal::corners(c)));
    return worst;
  }

  double worst_quality_of_star(const Coordinates_3& p) const
  {
    double worst = 1;
    for(const auto& f : m_cavity.faces())
    {
      const auto [q, r, s] = internal::corners(f.vertices);
      worst = (std::min)(worst, internal::tetrahedron_quality({{ q, r, s, p }}));
    }
    return worst;
  }

  void insert(const Point_3& p, const Size& size)
  {
    const Vertex_handle v = m_insert(m_cavity, p);
    m_pending.push_back(v); // first, so that it is settled in any case
    m_sizes.set_pending(v, size);
    m_vertices.push_back(v);
    m_search.add_vertices(1);
    report();
  }

  // Where there are more points than expected, less and less is told.
  void report()
  {
    const std::size_t n = m_vertices.size();
    if(n < m_next_report)
      return;
    m_expected_number = (std::max)(m_expected_number, n);
    m_next_report = n + m_expected_number / number_of_reports + 1;
    tell_progress(m_expected_number);
  }

  void tell_progress(const std::size_t expected_number)
  {
    m_context.visitor().on_progress(Phase::field_point_insertion, m_vertices.size(), expected_number);
  }

  Tr& m_tr;
  Domain& m_domain;
  Sizes& m_sizes;
  Recovery_context<Tr>& m_context;
  Field_point_cavity_3<Tr> m_cavity;
  Search m_search;
  Insert_field_point_3<Tr> m_insert;
  Remove_edge m_remove_edge;
  const Encroached_walls_3* m_walls = nullptr; // the large ones
  Vertices m_vertices;
  Vertices m_pending; // those around which nobody has looked yet
  std::vector<Cell_handle> m_star;
  std::vector<Cell_handle> m_long_cells; // those that may have an edge that is too long
  std::vector<Cell_handle> m_cells_put_off;
  bool m_is_at_border = false; // at the cell that is looked at, the border of a part was met
  std::size_t m_number_of_edges_left = 0;
  std::size_t m_max_number_of_points = 0;
  bool m_is_full = false;
  std::size_t m_expected_number = 0;
  std::size_t m_next_report = 0;
};

template <typename Tr>
Encroached_walls_3 Fill_domain_3<Tr>::large_walls(const std::vector<Cell_handle>& cells)
{
  std::vector<Encroached_walls_3::Wall> walls;
  for(std::size_t k = 0; k < cells.size() && can_go_on(); ++k)
    for(int i = 0; i < 4; ++i)
      if(is_wall_that_stays(cells[k], i))
        add_if_large(cells[k], i, walls);
  return Encroached_walls_3(walls);
}

// What comes by the removal of an edge is looked at in the next round, and so are new cells without a point.
template <typename Tr>
void Fill_domain_3<Tr>::shorten_long_edges()
{
  m_number_of_edges_left = (std::max)(m_tr.number_of_vertices() / vertices_per_edge, least_number_of_edges);
  for(int round = 0; round < max_number_of_rounds; ++round)
  {
    std::vector<Cell_handle> cells;
    cells.swap(m_long_cells);
    for(std::size_t k = 0; k < cells.size() && m_number_of_edges_left > 0 && can_go_on(); ++k)
      if(is_there(cells[k]))
      {
        shorten_long_edge(cells[k]);
        look_around_new_vertices([this](const Cell_handle c) { look_at(c); });
      }
  }
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_DOMAIN_3_H
