// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_SUPPRESSION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_SUPPRESSION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Growing_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Cell_replacement.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Exterior_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_validity.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>
#include <CGAL/Shell_transformation_3.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The condition that no new edge ends at a given vertex.
 */
template <typename Tr>
class No_new_edge_at_vertex_3
  : public No_shell_validity_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;

  explicit No_new_edge_at_vertex_3(const Vertex_handle v) : m_v(v) { }

  bool is_valid_chord(const Shell_3<Tr>& s, const int i, const int j) const
  {
    return s.vertex(i) != m_v && s.vertex(j) != m_v;
  }

private:
  Vertex_handle m_v;
};

/*
 * The postprocessing of [CZZ+17, Section 4.3]: removes Steiner points that are on no constraint.
 *
 * A vertex is dropped when its ball can be covered without it: by starring the ball from one of its neighbors (this is
 * collapsing an edge; it contains the 4-1 flip), or by small polyhedron reconnection of the ball. Until that works, the
 * edges at the vertex are removed one after the other by recursive shell transformations. Then the ball and one layer
 * more is tried, and in the end ever larger cavities around the ball: first such that grow by the vertices that touch
 * them most, then such that grow where they have to. Two neighbors become one where one point sees the boundary of both
 * balls. In between, points move to the deepest point of their kernel.
 *
 * It ends: no step adds a point, every round but the last removes some, and within a round, the flips around a point
 * only ever take edges away from it.
 */
template <typename Tr, typename Visitor>
class Steiner_suppression_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef typename Tr::Edge                    Edge;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Constraints_3<Tr>                    Constraints;
  typedef Exact_positions_3<Tr>                Positions;
  typedef Cavity_3<Tr>                         Cavity;
  typedef Growing_cavity_3<Tr>                 Growing_cavity;

  // `predicates` know of `positions`; `points` are the Steiner points, those that are removed are taken out of it.
  Steiner_suppression_3(Tr& tr, const Predicates& predicates, const Constraints& constraints, Positions& positions,
                        std::vector<Vertex_handle>& points, Visitor& visitor)
    : m_tr(tr), m_predicates(predicates), m_constraints(constraints), m_positions(positions), m_points(points),
      m_visitor(visitor), m_reconnection(predicates), m_growing_cavity(tr, predicates, constraints),
      m_move_into_kernel(predicates, positions),
      m_transformation(tr, Quality(tr), Validity(Kept(constraints), No_new_edge_at_vertex_3<Tr>(Vertex_handle())),
                       visitor, predicates)
  { }

  // Removes as many points as it can. The recursion level of the flips is low first, for most points need no more. (On
  // 256 inputs, the other level leaves 4 % fewer points in the domain, in 5 % more time.)
  template <typename Context>
  void operator()(const int max_recursion_level, Context& context)
  {
    const int low = (std::min)(low_recursion_level, max_recursion_level);
    remove_points(ALL_POINTS, low, context);
    if(max_recursion_level > low)
      remove_points(POINTS_OF_DOMAIN, max_recursion_level, context);
    while(change_cavities(context))
      remove_points(ALL_POINTS, low, context);
  }

  // Gives each of the points a position that the triangulation can store. Returns whether there is one for all of them.
  // Once stopped, only what is quick is tried.
  template <typename Context>
  bool round_points(Context& context)
  {
    const std::vector<Vertex_handle> points = m_points;
    return std::count_if(points.begin(), points.end(), [&](const Vertex_handle v)
    {
      return internal::contains(m_points, v) && ! round(v, context);
    }) == 0;
  }

  std::size_t number_of_transformations() const { return m_transformation.number_of_transformations(); }

private:
  typedef Kept_constraints_3<Constraints>                                        Kept;
  typedef Shell_validity_conjunction_3<Kept, No_new_edge_at_vertex_3<Tr> >       Validity;
  typedef Worst_element_quality_3<Tr>                                            Quality;
  typedef Small_polyhedron_reconnection_3<Tr>                                    Reconnection;
  typedef typename Cell_replacement<Tr>::Tetrahedron                             Tetrahedron;
  typedef typename Move_into_kernel_3<Tr>::Vertex_triple                         Triangle;

  // Cells, their outer faces seen from inside, and the points inside.
  struct Polyhedron
  {
    std::vector<Cell_handle> cells;
    std::vector<Triangle> faces;
    std::vector<Vertex_handle> inner_points;
  };

  // Where there is a domain, the points in its exterior are not worth much time.
  enum Points { ALL_POINTS, POINTS_OF_DOMAIN };

  // Tries to remove each of the points, as long as this is worthwhile.
  template <typename Context>
  void remove_points(const Points points, const int l_max, Context& context)
  {
    std::size_t before;
    do
    {
      before = m_points.size();
      for_each_point(points, context, [&](const Vertex_handle v) { remove(v, l_max, context); });
      if(m_points.size() == before)
        return;
      relocate_points(context);
    }
    while(is_worthwhile(before));
  }

  // Whether more than one in a hundred of the points is gone. Where there are hundreds, every round finds one more.
  bool is_worthwhile(const std::size_t before) const { return 100 * (before - m_points.size()) > before; }

  // Tries what flips cannot do, the quickest first. Returns whether this was worthwhile.
  template <typename Context>
  bool change_cavities(Context& context)
  {
    const std::size_t before = m_points.size();
    merge_points(context);
    std::vector<Vertex_handle> hopeless;
    for(const auto growth : { Growing_cavity::AROUND, Growing_cavity::TOWARD_DEAD_ENDS })
      if(! is_worthwhile(before))
        reconnect_points(growth, hopeless, context);
    return is_worthwhile(before);
  }

  // Tries to remove each of the points by reconnection of a growing cavity around it, as long as this does not fail too
  // often. Those in the exterior are left alone: on 200 surfaces, that helped one of 781. Adds the points that no
  // growth helps to the `hopeless` ones, and does not try these; the list is empty again once one is removed.
  template <typename Context>
  void reconnect_points(const typename Growing_cavity::Growth growth, std::vector<Vertex_handle>& hopeless,
                        Context& context)
  {
    const std::size_t before = m_points.size();
    std::size_t number_of_failures = 0;
    for_each_point(POINTS_OF_DOMAIN, context, [&](const Vertex_handle v)
    {
      const std::size_t number_of_removed_points = before - m_points.size();
      if(number_of_failures > max_number_of_failures + failures_per_removed_point * number_of_removed_points
         || internal::contains(hopeless, v) || ! collect_ball(v))
        return;
      const auto& bounds = growth == Growing_cavity::AROUND ? around_bounds : dead_ends_bounds;
      const typename Growing_cavity::Outcome outcome = m_growing_cavity(m_ball, v, m_points, growth, bounds, context);
      if(outcome == Growing_cavity::FOUND)
      {
        replace(m_growing_cavity.cells(), m_growing_cavity.tetrahedra(), m_growing_cavity.dropped_points());
        hopeless.clear();
        return;
      }
      ++number_of_failures;
      if(outcome == Growing_cavity::NONE)
        hopeless.push_back(v);
    });
  }

  // Makes one point of two neighbors, where one can star both balls.
  template <typename Context>
  void merge_points(Context& context)
  {
    for_each_point(ALL_POINTS, context, [&](const Vertex_handle v) { merge(v, context); });
  }

  // Moves each of the points to the deepest point of the kernel of its ball, from where more may be possible.
  template <typename Context>
  void relocate_points(Context& context)
  {
    for_each_point(ALL_POINTS, context, [this](const Vertex_handle v) { relocate(v); });
  }

  // Work may remove points.
  template <typename Context, typename Work>
  void for_each_point(const Points which, Context& context, const Work& work)
  {
    if(which == POINTS_OF_DOMAIN && ! m_exterior_points)
      m_exterior_points = find_exterior_points();
    const std::vector<Vertex_handle> points = m_points;
    for(const Vertex_handle v : points)
    {
      if(! context.go_further())
        break;
      m_reconnection.forget(); // work moves points
      if(internal::contains(m_points, v) && (which == ALL_POINTS || ! internal::contains(*m_exterior_points, v)))
        work(v);
      CGAL_expensive_assertion(internal::is_mesh_valid(m_tr, m_predicates));
      context.visitor().on_progress(Recovery_phase::steiner_suppression,
                                    points.size() - m_points.size(), points.size());
    }
  }

  // Points never change sides, for what separates them stays.
  std::vector<Vertex_handle> find_exterior_points() const
  {
    std::vector<Vertex_handle> result;
    if(m_points.empty())
      return result;
    const Exterior_3<Tr> exterior(m_tr, m_constraints);
    if(! exterior.is_everything())
      std::copy_if(m_points.begin(), m_points.end(), std::back_inserter(result),
                   [&](const Vertex_handle v) { return exterior.contains(v->cell()); });
    return result;
  }

  template <typename Context>
  void remove(const Vertex_handle v, const int l_max, Context& context)
  {
    if(! collect_ball(v) || collapse(v) || reconnect_ball(v) || reduce_ball(v, l_max, context))
      return;
    if(context.go_further())
      reconnect_with_layer(v);
  }

  // Moves v to the deepest point of the kernel of its ball, if that can be stored.
  void relocate(const Vertex_handle v)
  {
    if(! collect_ball(v))
      return;
    const std::vector<Triangle> faces = internal::faces_of_ball(m_ball, v);
    const typename Positions::Exact_point_3 exact = m_positions(v);
    const typename Positions::Point_3 before = v->point();
    const bool is_exact = m_positions.contains(v);
    m_positions.erase(v);
    if(m_move_into_kernel(v, faces))
      return;
    v->set_point(before);
    if(is_exact)
      m_positions.set(v, exact);
  }

  // Makes the position of v one that the triangulation can store. Returns whether there is one that sees its ball.
  template <typename Context>
  bool round(const Vertex_handle v, Context& context)
  {
    if(! m_positions.contains(v))
      return true;
    m_reconnection.forget(); // v moves
    collect_ball(v);
    const std::vector<Triangle> faces = internal::faces_of_ball(m_ball, v);
    const typename Positions::Exact_point_3 exact = m_positions(v);
    m_positions.erase(v);
    if(m_move_into_kernel.is_in_kernel(v, faces) || m_move_into_kernel(v, faces)
       || (context.go_further() && m_move_into_kernel.move_near(v, faces, exact)) || star_from_nearby(v, context))
      return true;
    m_positions.set(v, exact);
    return false;
  }

  // Returns false if v is on the hull.
  bool collect_ball(const Vertex_handle v)
  {
    m_ball.clear();
    m_tr.incident_cells(v, std::back_inserter(m_ball));
    return std::none_of(m_ball.begin(), m_ball.end(), [this](const Cell_handle c) { return m_tr.is_infinite(c); });
  }

  // Where no number fits into the kernel of the ball of v: moves v to the center of a cell nearby, and adds the cells
  // behind the faces of the ball that it does not see from there, and so on. Of the centers for which this ends, that
  // with the fewest cells is taken. Returns whether there is one; all the cells around v are new then. If not, v is
  // somewhere.
  template <typename Context>
  bool star_from_nearby(const Vertex_handle v, Context& context)
  {
    typename Positions::Point_3 best_center;
    std::optional<Polyhedron> best;
    for(const Cell_handle c : cells_near_ball(v))
    {
      if(! context.go_further())
        break;
      v->set_point(center(c));
      if(auto polyhedron = enlarged_ball(v, best ? best->cells.size() - 1 : max_number_of_cells))
      {
        best = std::move(polyhedron);
        best_center = v->point();
      }
    }
    if(! best)
      return false;
    v->set_point(best_center);
    star(v, best->cells, best->faces, best->inner_points);
    return true;
  }

  // The finite cells that share a vertex with the ball of v.
  std::vector<Cell_handle> cells_near_ball(const Vertex_handle v)
  {
    collect_neighbors(v);
    Cavity result(m_tr, m_constraints, std::vector<Cell_handle>()); // it takes finite cells only, and each once
    std::vector<Cell_handle> star;
    for(const Vertex_handle w : m_neighbors)
    {
      star.clear();
      m_tr.incident_cells(w, std::back_inserter(star));
      for(const Cell_handle c : star)
        result.add(c);
    }
    return result.cells();
  }

  typename Positions::Point_3 center(const Cell_handle c) const
  {
    std::array<double, 3> x = {{ 0, 0, 0 }};
    for(int i = 0; i < 4; ++i)
      for(int k = 0; k < 3; ++k)
        x[k] += m_predicates.approximate_point(c->vertex(i))[k] / 4; // a sum may be out of range
    return typename Positions::Point_3(x[0], x[1], x[2]);
  }

  // The ball of v with the cells that have to be added so that v sees all the faces, none if that is not possible.
  std::optional<Polyhedron> enlarged_ball(const Vertex_handle v, const std::size_t max_number_of_cells) const
  {
    Cavity cavity(m_tr, m_constraints, m_ball);
    Polyhedron result;
    if(! cavity.grow_until_seen(v, m_predicates, max_number_of_cells)
       || ! cavity.collect_boundary(m_points, result.faces, result.inner_points))
      return std::nullopt;
    result.cells = cavity.cells();
    return result;
  }

  // Stars the balls of v and of another Steiner point, its neighbor, from one point.
  template <typename Context>
  void merge(const Vertex_handle v, Context& context)
  {
    if(! collect_ball(v))
      return;
    collect_neighbors(v);
    const std::vector<Cell_handle> ball = m_ball;
    const typename Positions::Point_3 before = v->point();
    for(const Vertex_handle w : m_neighbors)
    {
      if(! internal::contains(m_points, w) || ! collect_ball(w))
        continue;
      if(! context.go_further())
        return;
      Cavity cavity(m_tr, m_constraints, ball);
      for(const Cell_handle c : m_ball)
        cavity.add(c);
      std::vector<Triangle> faces;
      std::vector<Vertex_handle> inner_points;
      if(! m_positions.contains(v) && cavity.collect_boundary(m_points, faces, inner_points)
         && m_move_into_kernel(v, faces))
      {
        star(v, cavity.cells(), faces, inner_points);
        return;
      }
      v->set_point(before);
    }
  }

  // Stars the cavity from v, one of the points inside; the others are gone then.
  void star(const Vertex_handle v, const std::vector<Cell_handle>& cavity, const std::vector<Triangle>& faces,
            std::vector<Vertex_handle> inner_points)
  {
    m_tetrahedra.clear();
    for(const Triangle& f : faces)
      m_tetrahedra.push_back({{ f[0], f[1], f[2], v }});
    inner_points.erase(std::find(inner_points.begin(), inner_points.end(), v));
    replace(cavity, m_tetrahedra, inner_points);
  }

  // Fills the cavity with other cells, none of which has the points in `dropped`.
  template <typename TetrahedronRange>
  void replace(const std::vector<Cell_handle>& cavity, const TetrahedronRange& tetrahedra,
               const std::vector<Vertex_handle>& dropped)
  {
    for(const Vertex_handle v : dropped)
    {
      m_points.erase(std::find(m_points.begin(), m_points.end(), v));
      m_positions.erase(v);
    }
    m_replacement(m_tr, cavity, tetrahedra, m_visitor, dropped);
  }

  void collect_neighbors(const Vertex_handle v) { m_neighbors = internal::vertices_without(m_ball, v); }

  // Stars the ball from a neighbor of v that sees all of its boundary.
  bool collapse(const Vertex_handle v)
  {
    collect_neighbors(v);
    for(const Vertex_handle x : m_neighbors)
      if(sees_boundary_of_ball(x, v))
      {
        m_tetrahedra.clear();
        for(const Cell_handle c : m_ball)
          if(! c->has_vertex(x))
            m_tetrahedra.push_back(internal::with_exchanged_vertex(c, v, x));
        replace(m_ball, m_tetrahedra, { v });
        return true;
      }
    return false;
  }

  bool sees_boundary_of_ball(const Vertex_handle x, const Vertex_handle v) const
  {
    return std::all_of(m_ball.begin(), m_ball.end(), [&](const Cell_handle c)
    {
      if(c->has_vertex(x))
        return true;
      const Tetrahedron t = internal::with_exchanged_vertex(c, v, x);
      return m_predicates.orientation(t[0], t[1], t[2], t[3]) == POSITIVE;
    });
  }

  bool reconnect_ball(const Vertex_handle v) { return reconnect(m_ball, v); }

  void reconnect_with_layer(const Vertex_handle v)
  {
    Cavity cavity(m_tr, m_constraints, m_ball);
    for(const Cell_handle c : m_ball)
      cavity.add(c->neighbor(c->index(v)));
    reconnect(cavity.cells(), v);
  }

  // Fills the cavity without v, if this is possible.
  bool reconnect(const std::vector<Cell_handle>& cells, const Vertex_handle v)
  {
    std::vector<std::array<Vertex_handle, 2> > edges;
    std::vector<std::array<Vertex_handle, 3> > facets;
    m_constraints.collect(cells, edges, facets);
    if(m_reconnection(cells, edges, facets, v) != Reconnection::FOUND)
      return false;
    replace(cells, m_reconnection.tetrahedra(), { v });
    return true;
  }

  // Removes edges at v, as long as this succeeds and v cannot be dropped. Returns whether it could.
  template <typename Context>
  bool reduce_ball(const Vertex_handle v, const int l_max, Context& context)
  {
    m_transformation.validity() = Validity(Kept(m_constraints), No_new_edge_at_vertex_3<Tr>(v));
    for(bool is_changed = true; is_changed; )
    {
      is_changed = false;
      collect_neighbors(v);
      const std::vector<Vertex_handle> neighbors = m_neighbors;
      for(const Vertex_handle x : neighbors)
      {
        if(! context.go_further())
          return false;
        Cell_handle c;
        int i, j;
        if(! m_tr.is_edge(v, x, c, i, j))
          continue;
        const bool is_removed = m_transformation.remove_edge(Edge(c, i, j), l_max);
        collect_ball(v); // its cells may have been replaced even if the edge is still there
        if(! is_removed)
          continue;
        is_changed = true;
        if(collapse(v) || reconnect_ball(v))
          return true;
      }
    }
    return false;
  }

  // Raising the level from 0, as for lost edges, left a few more points in twice the time.
  static constexpr int low_recursion_level = 4;

  // For the points that nothing else removes. (On 35 surfaces that keep points, 99 stay. With cavities of up to 40
  // vertices that grow around alone, 122 do; with those that grow toward dead ends alone, 103. With half as many
  // tetrahedra, 105. The search is over after 160 steps, mostly.)
  static constexpr typename Growing_cavity::Bounds around_bounds = { 40, 100000, 400 };
  static constexpr typename Growing_cavity::Bounds dead_ends_bounds = { 128, 100000, 400 };

  // Where one of hundreds of points after the other stays, as in Chazelle's polyhedra, the rest will.
  static constexpr std::size_t max_number_of_failures = 40;
  static constexpr std::size_t failures_per_removed_point = 10;

  // Of a ball that is enlarged until its vertex sees all. (Of nine balls, the smallest had 101 to 148.)
  static constexpr std::size_t max_number_of_cells = 1000;

  Tr& m_tr;
  const Predicates& m_predicates;
  const Constraints& m_constraints;
  Positions& m_positions;
  std::vector<Vertex_handle>& m_points;
  Visitor& m_visitor;
  Reconnection m_reconnection;
  Growing_cavity m_growing_cavity;
  Move_into_kernel_3<Tr> m_move_into_kernel;
  Shell_transformation_3<Tr, Quality, Validity, Visitor> m_transformation;
  Cell_replacement<Tr> m_replacement;
  std::optional<std::vector<Vertex_handle> > m_exterior_points; // where there is a domain; none until asked for
  std::vector<Cell_handle> m_ball;
  std::vector<Vertex_handle> m_neighbors;
  std::vector<Tetrahedron> m_tetrahedra;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_STEINER_STEINER_SUPPRESSION_3_H
