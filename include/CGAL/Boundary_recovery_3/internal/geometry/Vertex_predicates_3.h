// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_VERTEX_PREDICATES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_VERTEX_PREDICATES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Exact decisions about finite vertices of a triangulation.
 *
 * Every phase asks here, by vertex handles, and never touches coordinates itself: this is the one place that knows
 * that a vertex may have an exact position beside the triangulation. As long as none has, this costs one comparison.
 *
 * "Crosses" and "pierces" mean transversal intersections in relative interiors: a segment crosses an edge in an
 * interior point of both, and pierces a triangle in an interior point of both that is the only common one. What merely
 * touches, and a segment inside the plane of a triangle, does neither.
 */
template <typename Tr>
class Vertex_predicates_3
{
public:
  typedef typename Tr::Vertex_handle       Vertex_handle;
  typedef typename Tr::Geom_traits         Geom_traits;
  typedef typename Geom_traits::Point_3    Point_3;
  typedef Exact_positions_3<Tr>            Positions;
  typedef typename Positions::Exact_kernel Exact_kernel;
  typedef typename Positions::Position     Position;
  typedef Simple_cartesian<double>::Point_3 Approximate_point;

  // `positions`, if given, has to outlive this object.
  explicit Vertex_predicates_3(const Tr& tr, const Positions* positions = nullptr)
    : m_tr(&tr),
      m_positions(positions),
      m_orientation(tr.geom_traits().orientation_3_object()),
      m_coplanar_orientation(tr.geom_traits().coplanar_orientation_3_object())
  { }

  bool is_infinite(const Vertex_handle v) const { return m_tr->is_infinite(v); }

  const Point_3& point(const Vertex_handle v) const { return internal::bare_point<Point_3>(v->point()); }

  Approximate_point approximate_point(const Vertex_handle v) const
  {
    const Point_3& p = point(v);
    return Approximate_point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  // A box around v.
  Bbox_3 bbox(const Vertex_handle v) const
  {
    const Position* const position = m_positions == nullptr ? nullptr : m_positions->find(v);
    if(position == nullptr)
      return point(v).bbox();
    const auto& box = position->box;
    return Bbox_3(box.x().inf(), box.y().inf(), box.z().inf(), box.x().sup(), box.y().sup(), box.z().sup());
  }

  // Sign of the volume of the tetrahedron pqrs.
  Orientation orientation(const Vertex_handle p, const Vertex_handle q,
                          const Vertex_handle r, const Vertex_handle s) const
  {
    if(m_positions != nullptr && ! m_positions->empty())
    {
      const std::array<const Position*, 4> positions = {{ m_positions->find(p), m_positions->find(q),
                                                          m_positions->find(r), m_positions->find(s) }};
      if(positions[0] || positions[1] || positions[2] || positions[3])
        return exact_orientation({{ p, q, r, s }}, positions);
    }
    return m_orientation(point(p), point(q), point(r), point(s));
  }

  bool are_collinear(const Vertex_handle p, const Vertex_handle q, const Vertex_handle r) const
  {
    if(has_exact_position(p, q, r))
      return typename Exact_kernel::Collinear_3()((*m_positions)(p), (*m_positions)(q), (*m_positions)(r));
    return m_coplanar_orientation(point(p), point(q), point(r)) == COLLINEAR;
  }

  // For coplanar p, q, r, s: POSITIVE if r and s are on the same side of the line pq, NEGATIVE if on opposite sides,
  // COLLINEAR if one of them is on that line.
  Orientation side_of_line(const Vertex_handle p, const Vertex_handle q,
                           const Vertex_handle r, const Vertex_handle s) const
  {
    if(are_collinear(p, q, r))
      return COLLINEAR;
    if(has_exact_position(p, q, r, s))
      return typename Exact_kernel::Coplanar_orientation_3()((*m_positions)(p), (*m_positions)(q),
                                                             (*m_positions)(r), (*m_positions)(s));
    return m_coplanar_orientation(point(p), point(q), point(r), point(s));
  }

  // Whether the segments uv and pq cross, known to be coplanar.
  bool coplanar_segments_cross(const Vertex_handle u, const Vertex_handle v,
                               const Vertex_handle p, const Vertex_handle q) const
  {
    return side_of_line(u, v, p, q) == NEGATIVE && side_of_line(p, q, u, v) == NEGATIVE;
  }

  bool segments_cross(const Vertex_handle u, const Vertex_handle v,
                      const Vertex_handle p, const Vertex_handle q) const
  {
    if(p == u || p == v || q == u || q == v)
      return false;
    return orientation(u, v, p, q) == COPLANAR && coplanar_segments_cross(u, v, p, q);
  }

  bool segment_pierces_triangle(const Vertex_handle u, const Vertex_handle v,
                                const Vertex_handle p, const Vertex_handle q, const Vertex_handle r) const
  {
    if(p == u || p == v || q == u || q == v || r == u || r == v)
      return false;
    const Orientation side = orientation(u, v, p, q);
    return side != COPLANAR && segment_pierces_triangle_beside(side, u, v, p, q, r);
  }

  // The same if orientation(u, v, p, q) is known, and not COPLANAR, and no vertex is an end of the segment.
  bool segment_pierces_triangle_beside(const Orientation side, const Vertex_handle u, const Vertex_handle v,
                                       const Vertex_handle p, const Vertex_handle q, const Vertex_handle r) const
  {
    return orientation(u, v, q, r) == side
        && orientation(u, v, r, p) == side
        && orientation(p, q, r, u) * orientation(p, q, r, v) == NEGATIVE;
  }

private:
  template <typename ... Vertex_handles>
  bool has_exact_position(const Vertex_handles ... v) const
  {
    return m_positions != nullptr && ! m_positions->empty() && (m_positions->contains(v) || ...);
  }

  // Only kernels with inexact constructions have such positions.
  static Orientation exact_orientation(const std::array<Vertex_handle, 4>& v,
                                       const std::array<const Position*, 4>& positions)
  {
    {
      const typename Positions::Interval::Protector protector;
      const Uncertain<Orientation> o = typename Positions::Interval_kernel::Orientation_3()(
        Positions::box(v[0], positions[0]), Positions::box(v[1], positions[1]),
        Positions::box(v[2], positions[2]), Positions::box(v[3], positions[3]));
      if(is_certain(o))
        return get_certain(o);
    }
    return Positions::Homogeneous_point::orientation(
      Positions::homogeneous(v[0], positions[0]), Positions::homogeneous(v[1], positions[1]),
      Positions::homogeneous(v[2], positions[2]), Positions::homogeneous(v[3], positions[3]));
  }

  const Tr* m_tr;
  const Positions* m_positions;
  typename Geom_traits::Orientation_3 m_orientation;
  typename Geom_traits::Coplanar_orientation_3 m_coplanar_orientation;
};

// Whether no hull facet beside that of an infinite cell is in front of it.
template <typename Tr, typename Predicates>
bool is_hull_convex_at(const Tr& tr, const Predicates& predicates, const typename Tr::Cell_handle c)
{
  const int infinite = c->index(tr.infinite_vertex());
  for(int i = 0; i < 4; ++i)
  {
    if(i == infinite)
      continue;
    std::array<typename Tr::Vertex_handle, 4> v = {{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }};
    v[infinite] = tr.mirror_vertex(c, i);
    if(predicates.orientation(v[0], v[1], v[2], v[3]) == POSITIVE)
      return false;
  }
  return true;
}

template <typename Predicates, typename Cell_handle>
bool is_positive(const Predicates& predicates, const Cell_handle c)
{
  return predicates.orientation(c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)) == POSITIVE;
}

// Whether a finite cell is positively oriented, or the convex hull is convex at the facet of an infinite one.
template <typename Tr, typename Predicates>
bool is_cell_valid(const Tr& tr, const Predicates& predicates, const typename Tr::Cell_handle c)
{
  return tr.is_infinite(c) ? internal::is_hull_convex_at(tr, predicates, c) : internal::is_positive(predicates, c);
}

// Whether a 3-dimensional triangulation is valid where vertices are at the positions that the predicates know, which
// `tr.is_valid()` does not. It looks at every cell: for expensive assertions.
template <typename Tr, typename Predicates>
bool is_mesh_valid(const Tr& tr, const Predicates& predicates)
{
  const auto cells = tr.all_cell_handles();
  return tr.tds().is_valid()
      && std::all_of(cells.begin(), cells.end(), [&](const typename Tr::Cell_handle c)
         {
           return internal::is_cell_valid(tr, predicates, c);
         });
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_VERTEX_PREDICATES_3_H
