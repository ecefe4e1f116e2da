// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_INTERSECTION_TABLE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_INTERSECTION_TABLE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/Bbox_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * How often mesh edges and faces are crossed by the lost constraints of one dimension N - 1 (edges for N = 2, facets
 * for N = 3).
 *
 * This is the hash table of [CZZ+17, Section 4.2.1], with one difference. There, entities that come up during a pass
 * are not counted before the next one. Here an entity is counted when it is first asked for, against the lost
 * constraints whose bounding boxes meet its own, and the count is remembered; it depends on the lost constraints only,
 * not on the mesh.
 */
template <typename Tr, std::size_t N>
class Intersection_table_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef std::array<Vertex_handle, N>  Constraint;

  explicit Intersection_table_3(const Tr& tr) : m_predicates(tr) { }

  // Sets the lost constraints, and forgets all counts if they changed.
  void set_constraints(const std::vector<Constraint>& constraints)
  {
    if(constraints == m_constraints)
      return;
    m_constraints = constraints;
    m_boxes.clear();
    for(const Constraint& c : constraints)
      m_boxes.push_back(box(c));
    m_edges = Counts<2>();
    m_faces = Counts<3>();
  }

  int number_of_crossings(const Vertex_handle u, const Vertex_handle v)
  {
    return remembered_count(Edge{{ u, v }}, m_edges);
  }

  int number_of_crossings(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
  {
    // where a lost facet has its edges, a mesh face can meet it along its own edges only
    return N == 3 ? 0 : remembered_count(Face{{ u, v, w }}, m_faces);
  }

private:
  typedef std::array<Vertex_handle, 2> Edge;
  typedef std::array<Vertex_handle, 3> Face;

  template <std::size_t M>
  struct Counts
  {
    Simplex_index_3<Vertex_handle, M> index;
    std::vector<int> numbers; // by the numbers of `index`
  };

  template <std::size_t M>
  int remembered_count(const std::array<Vertex_handle, M>& entity, Counts<M>& counts) const
  {
    const auto inserted = counts.index.insert(entity);
    if(inserted.second)
      counts.numbers.push_back(count(entity));
    return counts.numbers[inserted.first];
  }

  template <std::size_t M>
  Bbox_3 box(const std::array<Vertex_handle, M>& simplex) const
  {
    Bbox_3 b;
    for(const Vertex_handle v : simplex)
      b += m_predicates.point(v).bbox();
    return b;
  }

  template <std::size_t M>
  int count(const std::array<Vertex_handle, M>& entity) const
  {
    const Bbox_3 b = box(entity);
    int n = 0;
    for(std::size_t i = 0; i < m_constraints.size(); ++i)
      if(do_overlap(b, m_boxes[i]) && crosses(m_constraints[i], entity))
        ++n;
    return n;
  }

  bool crosses(const Edge& c, const Edge& e) const { return m_predicates.segments_cross(c[0], c[1], e[0], e[1]); }

  bool crosses(const Edge& c, const Face& f) const
  {
    return m_predicates.segment_pierces_triangle(c[0], c[1], f[0], f[1], f[2]);
  }

  bool crosses(const Face& c, const Edge& e) const
  {
    return m_predicates.segment_pierces_triangle(e[0], e[1], c[0], c[1], c[2]);
  }

  bool crosses(const Face&, const Face&) const { return false; }

  Vertex_predicates_3<Tr> m_predicates;
  std::vector<Constraint> m_constraints;
  std::vector<Bbox_3> m_boxes;
  Counts<2> m_edges;
  Counts<3> m_faces;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_INTERSECTION_TABLE_3_H
