// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVED_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVED_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Allowed_lengths_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Badness_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The mesh whose quality is improved: what all operations ask of it, and how they change it.
 *
 * An operation exchanges cells of one region for others that fill the same polyhedron. Qualities are computed in
 * floating point numbers and only rank cells; whether a cell is positively oriented is decided exactly. That suffices:
 * positively oriented cells whose outer facets are those of the polyhedron cover each of its points once.
 *
 * Several operations in a row can be an attempt, which is taken back if the cells are not less bad for all of them.
 */
template <typename Tr, typename Quality_>
class Improved_mesh_3
{
public:
  typedef Tr                                   Triangulation;
  typedef Selected_domain_3<Tr>                Domain;
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef typename Tr::Geom_traits::Point_3    Point_3;
  typedef std::array<Coordinates_3, 4>         Corners;

  // The quality of cells, and how often it was asked for: the price of whatever asked.
  class Quality
  {
  public:
    explicit Quality(const Quality_& quality) : m_quality(quality) { }

    double operator()(const Corners& corners) const
    {
      ++m_number;
      return m_quality(corners);
    }

    std::array<double, 2> of_two_cells(const Corners& p, const Corners& q) const
    {
      m_number += 2;
      return internal::qualities_of_two_cells(m_quality, p, q);
    }

    std::size_t number() const { return m_number; }

  private:
    const Quality_& m_quality;
    mutable std::size_t m_number = 0;
  };

  typedef Domain_keeper_3<Tr>                  Domain_keeper;
  typedef Mesh_editor_3<Tr>                    Editor;
  typedef typename Editor::Tetrahedron         Tetrahedron;
  typedef typename Editor::Cells               Cells;

  Improved_mesh_3(Tr& tr, Domain& domain, const Quality_& quality, Mesh_visitor_3<Tr>& visitor)
    : m_tr(tr), m_domain(domain), m_uncounted_quality(quality), m_quality(quality), m_domain_keeper(domain, visitor),
      m_editor(tr, m_domain_keeper), m_orientation(tr.geom_traits().orientation_3_object()), m_lengths(tr), m_times(0),
      m_number_of_old_vertices(tr.number_of_vertices())
  { }

  Tr& triangulation() { return m_tr; }
  const Tr& triangulation() const { return m_tr; }
  const Domain& domain() const { return m_domain; }

  static Coordinates_3 coordinates(const Vertex_handle v) { return internal::coordinates_of(v->point()); }

  const Quality& quality() const { return m_quality; }
  const Quality_& uncounted_quality() const { return m_uncounted_quality; }

  double quality(const Corners& corners) const { return m_quality(corners); }
  double quality(const Cell_handle c) const { return m_quality(internal::corners(c)); }

  // The quality of the cell between a face and the point p, from where the vertices of the face are seen
  // counterclockwise.
  double quality(const std::array<Vertex_handle, 3>& face, const Coordinates_3& p) const
  {
    return m_quality(corners(face, p));
  }

  static Corners corners(const std::array<Vertex_handle, 3>& face, const Coordinates_3& p)
  {
    return {{ coordinates(face[0]), coordinates(face[1]), coordinates(face[2]), p }};
  }

  double quality(const Tetrahedron& t) const
  {
    return m_quality(internal::corners(t));
  }

  // Whether a vertex is on a constraint, as far as it has a dimension that tells.
  static bool is_on_constraint_by_dimension(const Vertex_handle v)
  {
    if constexpr(Has_vertex_indices<typename Tr::Vertex>::value)
      return v->in_dimension() >= 0 && v->in_dimension() < 3;
    else
      return false;
  }

  // From now on, cells better than this need not be any better.
  void set_enough(const double quality) { set_measure_of_badness(quality); }
  double enough() const { return m_badness.enough(); }

  // The same, maybe a lenient one.
  void set_measure_of_badness(const Badness_3& badness)
  {
    m_badness = badness;
    m_time_of_measure = ++m_time;
  }
  const Badness_3& measure_of_badness() const { return m_badness; }

  // From now on, operations that make a nearly flat cell far better, but others worse, are not tried.
  void be_strict() { m_is_strict = true; }
  bool is_strict() const { return m_is_strict; }

  // How bad a cell of this quality is: from 0, good enough, to 1, flat.
  double badness(const double quality) const { return m_badness.of_quality(quality); }

  // The quality that new cells have at least, if that is the one of the worst cell that goes.
  double least_quality(const double worst) const { return m_badness.least_quality(worst); }

  bool is_nearly_flat(const double quality) const { return quality < nearly_flat * enough(); }

  // By how much cells have to become less bad for flips: less may be rounding, and in a grid, they would go on in
  // circles. See "Tuning constants" in the manual.
  static constexpr double least_gain = 1e-10;

  // Whether the worst new cell, with this quality, is so much better than the worst old one that the other cells may
  // get worse for it. Only asked for nearly flat cells.
  static bool is_far_better(const double quality, const double worst)
  {
    return quality > least_factor * (std::max)(0., worst);
  }

  // The quality of the worst of several cells, and the sum of their badness. The cells need not be in the mesh: they
  // are given by handles, vertices or corners.
  struct Account
  {
    double worst = 2;
    double badness = 0;
  };

  template <typename CellRange>
  Account account_of(const CellRange& cells) const
  {
    return account(cells, [](const auto& c) { return corners_of(c); });
  }

  // Those of faces, seen from inside, and a point.
  template <typename FaceRange>
  Account account_of_star(const FaceRange& faces, const Coordinates_3& p) const
  {
    return account(faces, [&p](const auto& f) { return corners(f, p); });
  }

  bool is_positive(const Vertex_handle p, const Vertex_handle q, const Vertex_handle r, const Vertex_handle s) const
  {
    return is_positive(point(p), point(q), point(r), point(s));
  }

  template <typename TetrahedronRange>
  bool are_positive(const TetrahedronRange& tetrahedra) const
  {
    return std::all_of(tetrahedra.begin(), tetrahedra.end(),
                       [&](const Tetrahedron& t) { return is_positive(t[0], t[1], t[2], t[3]); });
  }

  bool is_positive(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const
  {
    return m_orientation(p, q, r, s) == POSITIVE;
  }

  static Point_3 point(const Vertex_handle v) { return internal::bare_point<Point_3>(v->point()); }

  // Whether a new edge between u and v, which replaces an edge with the length `length_before`, has an allowed length.
  // If the old edge is longer or shorter than allowed, the new edge may be as long or as short as the old one.
  bool is_edge_in_size(const Vertex_handle u, const Vertex_handle v, const double length_before) const
  {
    auto range = m_lengths.at(u, v);
    range.include(length_before);
    return range.contains(distance(u, v));
  }

  bool is_edge_in_size(const Vertex_handle u, const Vertex_handle v) const
  {
    return m_lengths.at(u, v).contains(distance(u, v));
  }

  const Allowed_lengths_3<Tr>& allowed_lengths() const { return m_lengths; }

  // Allows edges near constrained facets to be about as long or as short as the edges of these facets. `add_lengths()`
  // has to be called for each cell of the domain, then `spread_lengths()` once, which stops when `goes_on` returns
  // false. Without these calls, only the sizes at the vertices tell which lengths are allowed.
  void add_lengths(const Cell_handle c) { m_lengths.add(m_domain, c); }
  template <typename Question>
  void spread_lengths(const Question& goes_on) { m_lengths.spread(goes_on); }

  static double size(const Vertex_handle v) { return Allowed_lengths_3<Tr>::size(v); }

  // This mesh is a part of a whole one, which is asked for the same: what counts as good enough, how long edges may be.
  void begin_part(const Improved_mesh_3& whole)
  {
    set_measure_of_badness(whole.m_badness);
    m_is_strict = whole.m_is_strict;
    m_are_changes_noted = whole.m_are_changes_noted;
    m_lengths.set_whole(whole.m_lengths);
    m_part_vertices.emplace();
  }

  // The whole mesh takes over what is known about the vertices of a part that are new.
  void end_part(const Improved_mesh_3& part)
  {
    for(const Vertex_handle v : *part.m_part_vertices)
      m_lengths.set_of_constraints(v, part.m_lengths.of_constraints(v));
    m_was_full = m_was_full || part.m_was_full;
  }

  // From now on, operations do not make the triangulation have more vertices than that.
  void set_max_number_of_vertices(const std::size_t number)
  {
    constexpr std::ptrdiff_t most = (std::numeric_limits<std::ptrdiff_t>::max)();
    m_number_of_old_vertices = m_tr.number_of_vertices();
    m_max_number_of_new_vertices = number >= static_cast<std::size_t>(most) ? most
                                 : static_cast<std::ptrdiff_t>(number)
                                   - static_cast<std::ptrdiff_t>(m_number_of_old_vertices);
  }

  // Whether it may have one more: operations that insert one ask that before they search. The numbers of vertices of a
  // part of a mesh, which may lose more than it had got itself, count modulo 2^64.
  bool has_room()
  {
    const bool has_room = number_of_new_vertices() < m_max_number_of_new_vertices;
    m_was_full = m_was_full || ! has_room;
    return has_room;
  }

  // By how many vertices there are more since then; negative: less.
  std::ptrdiff_t number_of_new_vertices() const
  {
    return static_cast<std::ptrdiff_t>(m_tr.number_of_vertices() - m_number_of_old_vertices);
  }

  // Whether that was denied once.
  bool was_full() const { return m_was_full; }

  // --- changes ------------------------------------------------------------------------------------------------------

  // Grows with each change, and with each new measure of badness; never 0.
  std::size_t time() const { return m_time; }

  // From now on, changes are not recorded for has_changed(), since nobody will call it any more.
  void note_no_more_changes() { m_are_changes_noted = false; }

  // The time when the measure of badness was set last.
  std::size_t time_of_measure() const { return m_time_of_measure; }

  // Whether a cell around the vertex has changed after this time; for a cell: whether one around any of its vertices
  // has.
  bool has_changed(const Vertex_handle v, const std::size_t time) const
  {
    return m_times.is_defined(v) && m_times[v] > time;
  }

  bool has_changed(const Cell_handle c, const std::size_t time) const
  {
    for(int i = 0; i < 4; ++i)
      if(has_changed(c->vertex(i), time))
        return true;
    return false;
  }

  // Moves the vertex of the star of these cells and faces, if all of the cells are oriented positively then.
  template <typename CellRange, typename FaceRange>
  bool move(const Vertex_handle v, const Coordinates_3& to, const CellRange& cells, const FaceRange& faces)
  {
    const Point_3 p(to[0], to[1], to[2]);
    for(const auto& f : faces)
      if(! is_positive(point(f[0]), point(f[1]), point(f[2]), p))
        return false;
    before_change(cells);
    m_editor.move(v, typename Tr::Point(p));
    for(const Cell_handle c : cells)
      internal::forget_shape(*c);
    after_change(cells);
    return true;
  }

  // Replaces cells of one region by the star of a new vertex at p. The new vertex gets this size, and its edges may be
  // as short as `least`. `faces` are the outer facets of the old cells; p sees the `vertices` of each face
  // counterclockwise. The vertices in `dropped`, which are on none of these faces, are deleted.
  template <typename CellRange, typename FaceRange, typename VertexRange>
  const Cells& star(const CellRange& old_cells, const FaceRange& faces, const Point_3& p, const double size,
                    const double least, const VertexRange& dropped)
  {
    const Vertex_handle v = create_vertex(p, (*old_cells.begin())->subdomain_index(), size, least);
    try {
      m_star.clear();
      for(const auto& f : faces)
        m_star.push_back(Tetrahedron{{ f.vertices[0], f.vertices[1], f.vertices[2], v }});
      return replace(old_cells, m_star, dropped);
    } catch(...) {
      if(v->cell() == Cell_handle()) // else the star is there, and the visitor threw afterwards
        m_editor.delete_vertex(v);
      throw;
    }
  }

  // Exchanges cells of a region for positively oriented ones with the same outer facets. The vertices that are
  // `dropped` go with the old cells. If memory is lacking, or the visitor throws beforehand, nothing is changed.
  template <typename CellRange, typename TetrahedronRange, typename VertexRange = std::array<Vertex_handle, 0>>
  const Cells& replace(const CellRange& old_cells, const TetrahedronRange& tetrahedra,
                       const VertexRange& dropped = VertexRange())
  {
    if(m_editor.journal().is_active())
      for(const Vertex_handle v : dropped)
        m_dropped_vertices.push_back({ v, m_lengths.of_constraints(v) });
    before_change(old_cells);
    try {
      m_editor.replace(old_cells, tetrahedra, dropped);
    } catch(...) {
      m_domain_keeper.after_failure(old_cells);
      throw;
    }
    after_change(m_editor.new_cells());
    return m_editor.new_cells();
  }

  // --- attempts -----------------------------------------------------------------------------------------------------

  // What is changed from now on may be taken back. Until it is kept or undone, the measure of badness is to stay.
  void begin_attempt()
  {
    m_editor.begin();
    m_gain = 0;
    m_dropped_vertices.clear();
  }

  // By how much the weight of the bad cells has become less since then.
  double gain_of_attempt() const { return m_gain; }

  void keep_attempt() { m_editor.commit(); }

  // Undoes all changes of the attempt. Returns the restored cells, and the cells around vertices that moved back.
  // Restored cells have new handles, and so have restored vertices.
  std::vector<Cell_handle> undo_attempt()
  {
    std::vector<Vertex_handle> moved;
    m_editor.journal().change().for_each_moved_vertex([&](const Vertex_handle v, const auto&) { moved.push_back(v); });
    Undoing_visitor undoing_visitor(m_domain_keeper);
    for(const auto& [before, now] : m_editor.undo(undoing_visitor))
      m_lengths.set_of_constraints(now, constraints_at_dropped_vertex(before));
    std::vector<Cell_handle> cells = std::move(undoing_visitor.cells);
    for(const Vertex_handle v : moved)
      m_tr.tds().incident_cells(v, std::back_inserter(cells));
    for(const Cell_handle c : cells)
      internal::forget_shape(*c);
    note_change(cells);
    return cells;
  }

private:
  typedef typename Allowed_lengths_3<Tr>::Range Range;

  // See "Tuning constants" in the manual.
  static constexpr double nearly_flat = 0.02;
  static constexpr double least_factor = 2;

  struct Dropped_vertex
  {
    Vertex_handle vertex;
    Range constraints;
  };

  struct Undoing_visitor final
    : public Forwarding_visitor_3<Tr>
  {
    explicit Undoing_visitor(Domain_keeper& domain_keeper)
      : Forwarding_visitor_3<Tr>(static_cast<Mesh_visitor_3<Tr>&>(domain_keeper)), domain_keeper(domain_keeper)
    { }

    Domain_keeper& domain_keeper;
    std::vector<Cell_handle> cells; // that came back

    void after_cells_creation(const Cell_span<Cell_handle>& coming) override
    {
      cells.assign(coming.begin(), coming.end());
      domain_keeper.after_cells_return(coming);
    }
  };

  template <typename Range, typename Corners_of>
  Account account(const Range& items, const Corners_of& corners_of) const
  {
    Account account;
    internal::visit_qualities(m_quality, items, corners_of, [&](const auto&, const double q)
    {
      account.worst = (std::min)(account.worst, q);
      account.badness += badness(q);
      return true;
    });
    return account;
  }

  static const Corners& corners_of(const Corners& corners) { return corners; }

  template <typename Cell>
  static Corners corners_of(const Cell& c) { return internal::corners(c); }

  // --- changes ------------------------------------------------------------------------------------------------------

  template <typename CellRange>
  void before_change(const CellRange& cells)
  {
    if(m_editor.journal().is_active())
      m_gain += weight(cells);
  }

  template <typename CellRange>
  void after_change(const CellRange& cells)
  {
    if(m_editor.journal().is_active())
      m_gain -= weight(cells);
    note_change(cells);
  }

  template <typename CellRange>
  double weight(const CellRange& cells) const
  {
    double sum = 0;
    for(const Cell_handle c : cells)
      sum += m_badness.weight(m_uncounted_quality(internal::corners(c)));
    return sum;
  }

  template <typename CellRange>
  void note_change(const CellRange& cells)
  {
    if(! m_are_changes_noted)
      return;
    ++m_time;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        m_times[c->vertex(i)] = m_time;
  }

  // The lengths that were known at a vertex when the attempt deleted it. If several deleted vertices had this handle,
  // it is the first of them: the others were created later, in the same place in memory.
  const Range& constraints_at_dropped_vertex(const Vertex_handle v) const
  {
    return std::find_if(m_dropped_vertices.begin(), m_dropped_vertices.end(),
                        [&](const Dropped_vertex& d) { return d.vertex == v; })->constraints;
  }

  // --- vertices -----------------------------------------------------------------------------------------------------

  static double distance(const Vertex_handle u, const Vertex_handle v)
  {
    return internal::distance(coordinates(u), coordinates(v));
  }

  template <typename Subdomain_index>
  Vertex_handle create_vertex(const Point_3& p, const Subdomain_index& region, const double size, const double least)
  {
    const Vertex_handle v = m_editor.create_vertex(typename Tr::Point(p));
    m_domain.own(v);
    if(m_part_vertices)
      m_part_vertices->push_back(v);
    if constexpr(Has_vertex_indices<typename Tr::Vertex>::value)
      internal::set_vertex_indices(*v, 3, region);
    if constexpr(Has_meshing_info<typename Tr::Vertex>::value)
    {
      v->set_meshing_info(size);
      if(size > 0)
        m_lengths.set_least(v, least);
    }
    return v;
  }

  Tr& m_tr;
  Domain& m_domain;
  const Quality_& m_uncounted_quality;
  const Quality m_quality;
  Domain_keeper m_domain_keeper;
  Editor m_editor; // with a journal, in an attempt
  typename Tr::Geom_traits::Orientation_3 m_orientation;
  std::vector<Tetrahedron> m_star;
  Badness_3 m_badness = 1;
  bool m_is_strict = false;
  Allowed_lengths_3<Tr> m_lengths;
  std::vector<Dropped_vertex> m_dropped_vertices; // by the attempt, in order
  double m_gain = 0; // by an attempt
  bool m_are_changes_noted = true;
  std::size_t m_time = 1;
  std::size_t m_time_of_measure = 1;
  Unique_hash_map<Vertex_handle, std::size_t> m_times; // of the last change, by vertex; for looking up only
  std::size_t m_number_of_old_vertices;
  std::ptrdiff_t m_max_number_of_new_vertices = (std::numeric_limits<std::ptrdiff_t>::max)();
  bool m_was_full = false;
  std::optional<std::vector<Vertex_handle> > m_part_vertices; // those that came, and maybe went; none: this is no part
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_IMPROVED_MESH_3_H
