// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SUPPRESS_STEINER_POINTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SUPPRESS_STEINER_POINTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Growing_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Round_steiner_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_free_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The cells that no constrained facets separate from the infinite ones.
 */
template <typename Tr>
class Exterior_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef typename Tr::Cell_handle      Cell_handle;

  Exterior_3(const Tr& tr, const Constraints_3<Tr>& constraints)
    : m_number_of_other_cells(tr.tds().number_of_cells()), m_contains(false)
  {
    const auto is_open = [&](const Cell_handle c, const int i)
    {
      const std::array<Vertex_handle, 3> f = internal::facet_vertices(c, i);
      return tr.is_infinite(c, i) || ! constraints.is_constrained(f[0], f[1], f[2]);
    };
    internal::flood_fill(tr.infinite_cell(), is_open, [this](const Cell_handle c) { return this->add(c); });
  }

  bool contains(const Cell_handle c) const { return m_contains[c]; }

  // Whether there are no other cells.
  bool is_everything() const { return m_number_of_other_cells == 0; }

private:
  // Returns whether c is new.
  bool add(const Cell_handle c)
  {
    bool& is_known = m_contains[c];
    if(is_known)
      return false;
    is_known = true;
    --m_number_of_other_cells;
    return true;
  }

  std::size_t m_number_of_other_cells;
  Unique_hash_map<Cell_handle, bool> m_contains;
};

/*
 * Makes one point of two free Steiner points that are neighbors, where one point sees the boundary of both stars.
 */
template <typename Tr>
class Merge_points_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;

  explicit Merge_points_3(Mesh& mesh) : m_mesh(mesh), m_move_into_kernel(mesh.predicates, mesh.positions) { }

  // Merges v, of which `star` are the cells around it, with the first neighbor for which this is possible.
  void operator()(const Vertex_handle v, const std::vector<Cell_handle>& star)
  {
    const auto before = v->point();
    for(const Vertex_handle w : internal::vertices_without(star, v))
    {
      if(! m_mesh.ledger.is_free(w) || ! internal::collect_star(m_mesh.tr, w, m_star))
        continue;
      if(! m_mesh.context.go_further())
        return;
      Cavity_3<Tr> cavity(m_mesh.tr, m_mesh.constraints, star);
      for(const Cell_handle c : m_star)
        cavity.add(c);
      std::vector<Vertex_triple> faces;
      std::vector<Vertex_handle> inner_points;
      if(! m_mesh.positions.contains(v) && cavity.collect_boundary(m_mesh.ledger.free_points(), faces, inner_points)
         && m_move_into_kernel(v, faces))
      {
        internal::star_and_forget(m_mesh.editor, m_mesh.ledger, cavity, v);
        return;
      }
      v->set_point(before);
    }
  }

private:
  typedef typename Mesh::Vertex_triple Vertex_triple;

  Mesh& m_mesh;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  std::vector<Cell_handle> m_star;
};

/*
 * Where points could not be removed in some way. That fails again as long as the Steiner points around are there: all
 * else stays much the same.
 */
template <typename Ledger>
class Failed_removals_3
{
public:
  typedef typename Ledger::Vertex_handle Vertex_handle;
  typedef std::vector<Vertex_handle>     Points;

  explicit Failed_removals_3(const Ledger& ledger) : m_ledger(ledger) { }

  // `points` are free points around v.
  void insert(const Vertex_handle v, Points points) { m_points[&*v] = std::move(points); }

  bool contains(const Vertex_handle v) const
  {
    const auto it = m_points.find(&*v);
    return it != m_points.end() && std::all_of(it->second.begin(), it->second.end(),
                                               [this](const Vertex_handle w) { return m_ledger.is_free(w); });
  }

private:
  const Ledger& m_ledger;
  std::unordered_map<const void*, Points> m_points; // by addresses of vertices, only looked up
};

/*
 * The postprocessing of [CZZ+17, Section 4.3]: removes Steiner points that are on no constraint.
 *
 * Points are first removed one by one, and those that stay move to the deepest point of their kernel. Where that does
 * no more, two neighbors become one where one point sees the boundary of both stars, and ever larger cavities around a
 * star are reconnected.
 *
 * It ends: no step adds a point, every round but the last removes some, and within a round, the flips around a point
 * only ever take edges away from it.
 */
template <typename Tr>
class Suppress_steiner_points_3
{
public:
  typedef Steiner_mesh_3<Tr>          Mesh;
  typedef typename Mesh::Vertex_handle         Vertex_handle;
  typedef typename Mesh::Cell_handle           Cell_handle;
  typedef Growing_cavity_3<Tr>                 Growing_cavity;

  explicit Suppress_steiner_points_3(Mesh& mesh)
    : m_mesh(mesh), m_suppress(mesh, mesh.constraints), m_merge(mesh), m_round(mesh),
      m_growing_cavity(mesh.tr, mesh.predicates, mesh.constraints)
  { }

  // Removes as many points as it can. The recursion level of the flips is low first, for most points need no more.
  // Where points may be given up for time, that is all: high levels and larger cavities are for the last few.
  void operator()(const int max_recursion_level, const Recovery_effort effort)
  {
    const int low = (std::min)(low_recursion_level, max_recursion_level);
    m_suppress.set_effort(effort);
    remove_points(ALL_POINTS, low);
    if(effort == Recovery_effort::more_points)
      return;
    if(max_recursion_level > low)
      remove_points(POINTS_OF_DOMAIN, max_recursion_level);
    while(change_cavities())
      remove_points(ALL_POINTS, low);
  }

  // In which points that are left make room for each other.
  static constexpr int max_number_of_rounds = 20;

  // Gives each of the points a position that the triangulation can store. Returns whether there is one for all of them.
  // Once stopped, only what is quick is tried. Without rounds, it ends with the first point for which there is none.
  bool round_points(const int max_recursion_level, const int number_of_rounds = max_number_of_rounds)
  {
    const int l_max = (std::min)(low_recursion_level, max_recursion_level);
    std::vector<Vertex_handle> points = m_mesh.ledger.free_points();
    if(number_of_rounds == 0)
      return std::all_of(points.begin(), points.end(), [this](const Vertex_handle v)
      {
        return ! m_mesh.ledger.is_free(v) || m_round(v);
      });
    round(points, m_round);
    for(int i = 0; i < number_of_rounds && ! points.empty() && m_mesh.context.go_further(); ++i)
      round(points, [&](const Vertex_handle v)
      {
        return round_in_smaller_star(v, l_max) || round_among_moved_neighbors(v);
      });
    return points.empty();
  }

  std::size_t number_of_transformations() const { return m_suppress.number_of_transformations(); }

private:
  typedef Failed_removals_3<typename Mesh::Ledger> Failed_removals;

  // Where there is a domain, the points in its exterior are not worth much time.
  enum Points { ALL_POINTS, POINTS_OF_DOMAIN };

  // --- the schedule -------------------------------------------------------------------------------------------------

  // Tries to remove each of the points, as long as this is worthwhile; if the recursion level is high, until this has
  // failed too often. It fails again where it failed before, at this level or a higher one.
  void remove_points(const Points points, const int l_max)
  {
    const bool is_high = l_max > low_recursion_level;
    std::size_t before;
    do
    {
      before = number_of_points();
      std::size_t number_of_failures = 0;
      for_each_point(points, [&](const Vertex_handle v)
      {
        if((! is_high || is_success_likely(before, number_of_failures)) && ! remove(v, l_max, is_high))
          ++number_of_failures;
      });
      if(number_of_points() == before)
        return;
      relocate_points();
    }
    while(is_worthwhile(before));
  }

  bool remove(const Vertex_handle v, const int l_max, const bool is_high)
  {
    if(m_failed_flips[is_high].contains(v))
      return false;
    if(m_suppress.remove(v, l_max))
      return true;
    std::vector<Vertex_handle> neighbors;
    m_mesh.tr.finite_adjacent_vertices(v, std::back_inserter(neighbors));
    for(int level = 0; level <= static_cast<int>(is_high); ++level)
      m_failed_flips[level].insert(v, free_points_of(neighbors));
    return false;
  }

  std::size_t number_of_points() const { return m_mesh.ledger.free_points().size(); }

  // Whether more than one in fifty of the points is gone. Where there are hundreds, every round finds one more.
  bool is_worthwhile(const std::size_t before) const { return 50 * (before - number_of_points()) > before; }

  // Whether what takes long should be tried with one more point. So many failed since there were so many.
  bool is_success_likely(const std::size_t before, const std::size_t number_of_failures) const
  {
    return number_of_failures
           <= max_number_of_failures + failures_per_removed_point * (before - number_of_points());
  }

  // Tries what flips cannot do, the quickest first. Returns whether this was worthwhile.
  bool change_cavities()
  {
    const std::size_t before = number_of_points();
    merge_points();
    if(! is_worthwhile(before))
      reconnect_points();
    return is_worthwhile(before);
  }

  // Work may remove points.
  template <typename Work>
  void for_each_point(const Points which, const Work& work)
  {
    if(which == POINTS_OF_DOMAIN && ! m_exterior_points)
      m_exterior_points = find_exterior_points();
    const std::vector<Vertex_handle> points = m_mesh.ledger.free_points();
    for(const Vertex_handle v : points)
    {
      if(! m_mesh.context.go_further())
        break;
      if(m_mesh.ledger.is_free(v) && (which == ALL_POINTS || ! internal::contains(*m_exterior_points, v)))
        work(v);
      CGAL_expensive_assertion(internal::is_mesh_valid(m_mesh.tr, m_mesh.predicates));
      m_mesh.context.visitor().on_progress(Phase::steiner_suppression, points.size() - number_of_points(),
                                      points.size());
    }
  }

  // Points never change sides, for what separates them stays.
  std::vector<Vertex_handle> find_exterior_points() const
  {
    std::vector<Vertex_handle> result;
    const std::vector<Vertex_handle>& points = m_mesh.ledger.free_points();
    if(points.empty())
      return result;
    const Exterior_3<Tr> exterior(m_mesh.tr, m_mesh.constraints);
    if(! exterior.is_everything())
      std::copy_if(points.begin(), points.end(), std::back_inserter(result),
                   [&](const Vertex_handle v) { return exterior.contains(v->cell()); });
    return result;
  }

  // --- ways to remove points ----------------------------------------------------------------------------------------

  // Tries to remove each of the points by reconnection of a growing cavity around it, as long as this does not fail too
  // often. Those in the exterior are left alone: that hardly ever helped one. Nor are those tried where the same
  // failed before.
  void reconnect_points()
  {
    const std::size_t before = number_of_points();
    std::size_t number_of_failures = 0;
    for_each_point(POINTS_OF_DOMAIN, [&](const Vertex_handle v)
    {
      if(! is_success_likely(before, number_of_failures) || m_failed_growths.contains(v) || ! collect_star(v))
        return;
      if(m_growing_cavity(m_star, v, m_mesh.ledger.free_points(), cavity_bounds, m_mesh.context)
         == Growing_cavity::FOUND)
      {
        internal::replace_and_forget(m_mesh.editor, m_mesh.ledger, m_growing_cavity.cells(),
                                     m_growing_cavity.tetrahedra(), m_growing_cavity.dropped_points());
        return;
      }
      ++number_of_failures;
      m_failed_growths.insert(v, free_points_of(m_growing_cavity.vertices()));
    });
  }

  std::vector<Vertex_handle> free_points_of(const std::vector<Vertex_handle>& vertices) const
  {
    std::vector<Vertex_handle> result;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(result),
                 [this](const Vertex_handle v) { return m_mesh.ledger.is_free(v); });
    return result;
  }

  // Makes one point of two neighbors, where one sees the boundary of both stars.
  void merge_points()
  {
    for_each_point(ALL_POINTS, [this](const Vertex_handle v)
    {
      if(collect_star(v))
        m_merge(v, m_star);
    });
  }

  // Moves each of the points to the deepest point of the kernel of its star, from where more may be possible.
  void relocate_points()
  {
    for_each_point(ALL_POINTS, [this](const Vertex_handle v) { m_suppress.relocate(v); });
  }

  // Takes out those points that are gone, or that `work` gives such a position.
  template <typename Work>
  void round(std::vector<Vertex_handle>& points, Work&& work)
  {
    std::size_t kept = 0;
    for(const Vertex_handle v : points)
      if(m_mesh.ledger.is_free(v) && ! work(v))
        points[kept++] = v;
    points.resize(kept);
  }

  // Where there is no number in the star of v, and none around it will do: takes edges off v, so that fewer planes
  // bound the kernel, and tries again. Returns true, too, if v is gone then.
  bool round_in_smaller_star(const Vertex_handle v, const int l_max)
  {
    return m_mesh.context.go_further() && (m_suppress.remove(v, l_max) || m_round(v));
  }

  // The same where all around v make room. Points that hold each other fast near the edge that they came off get away
  // from it together, a bit in each round.
  bool round_among_moved_neighbors(const Vertex_handle v)
  {
    if(! collect_star(v))
      return false;
    const std::vector<Vertex_handle> neighbors = internal::vertices_without(m_star, v);
    for(const Vertex_handle w : neighbors)
      if(m_mesh.ledger.is_free(w) && m_mesh.context.go_further())
      {
        if(m_mesh.positions.contains(w))
          m_round.center(w);
        else
          m_suppress.relocate(w);
      }
    m_round.center(v);
    return m_round(v);
  }

  // Returns false if v is on the hull.
  bool collect_star(const Vertex_handle v) { return internal::collect_star(m_mesh.tr, v, m_star); }

  // See "Tuning constants" in the manual. The level is not raised from 0, as it is for lost edges.
  static constexpr int low_recursion_level = 4;

  // For the points that nothing else removes.
  static constexpr typename Growing_cavity::Bounds cavity_bounds = { 48, 100000, 400 };

  // Where one of hundreds of points after the other stays, as in Chazelle's polyhedra, the rest will.
  static constexpr std::size_t max_number_of_failures = 40;
  static constexpr std::size_t failures_per_removed_point = 10;

  Mesh& m_mesh;
  Suppress_free_point_3<Tr, typename Mesh::Constraints> m_suppress;
  Merge_points_3<Tr> m_merge;
  Round_free_point_3<Tr> m_round;
  Growing_cavity m_growing_cavity;
  std::array<Failed_removals, 2> m_failed_flips{{ Failed_removals(m_mesh.ledger), Failed_removals(m_mesh.ledger) }};
  Failed_removals m_failed_growths{ m_mesh.ledger };
  std::optional<std::vector<Vertex_handle> > m_exterior_points; // where there is a domain; none until asked for
  std::vector<Cell_handle> m_star;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_SUPPRESS_STEINER_POINTS_3_H
