// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_REMOVE_LONG_EDGE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_REMOVE_LONG_EDGE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Shell_transformation_3.h>

#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// That of the worst cell, and that counts more than the number of cells around the edge.
template <typename Tr>
struct Worst_cell_first_3
  : public Worst_element_quality_3<Tr>
{
  using Worst_element_quality_3<Tr>::Worst_element_quality_3;
  static constexpr bool is_first_in_vector = true;
};

// New edges are clearly shorter than the supporting edge, so that no two cells are transformed to and fro.
struct Shorter_edges_validity_3
  : public No_shell_validity_3
{
  static constexpr double largest_ratio = 0.9;

  template <typename Shell>
  bool is_valid_chord(const Shell& s, const int i, const int j) const
  {
    return squared_length(s.vertex(i), s.vertex(j)) < largest_ratio * largest_ratio * squared_length(s.a(), s.b());
  }

private:
  template <typename Vertex_handle>
  static double squared_length(const Vertex_handle u, const Vertex_handle v)
  {
    return internal::squared_distance(coordinates_of(u->point()), coordinates_of(v->point()));
  }
};

/*
 * Gets rid of an edge inside a region of the domain that is too long, by a shell transformation. Regions and marks are
 * carried over, and the domain and the visitor are told.
 */
template <typename Tr>
class Remove_long_edge_3
{
public:
  typedef typename Tr::Cell_handle  Cell_handle;
  typedef typename Tr::Edge         Edge;
  typedef Selected_domain_3<Tr>     Domain;
  typedef Mesh_visitor_3<Tr>        Visitor;

private:
  // Remembers the new cells, too.
  struct Keeper final
    : public Domain_keeper_3<Tr>
  {
    typedef Domain_keeper_3<Tr> Base;
    using Base::Base;

    void after_cells_creation(const Cell_span<Cell_handle>& cells) override
    {
      new_cells.insert(new_cells.end(), cells.begin(), cells.end());
      Base::after_cells_creation(cells);
    }

    std::vector<Cell_handle> new_cells;
  };

  typedef Shell_transformation_3<Tr, Worst_cell_first_3<Tr>, Shorter_edges_validity_3, Keeper> Transformation;

public:
  // Edges with more cells are left alone.
  static constexpr int max_degree = Transformation::max_degree;

  Remove_long_edge_3(Tr& tr, Domain& domain, Visitor& visitor)
    : m_keeper(domain, visitor), m_transform(tr, Worst_cell_first_3<Tr>(tr), Shorter_edges_validity_3(), m_keeper)
  { }

  // Returns whether the edge is gone, or less cells are at it; then none of those that were there is left. No facet at
  // the edge may be a wall.
  bool operator()(const Edge& e)
  {
    m_keeper.new_cells.clear();
    return m_transform(e) != Transformation::UNCHANGED;
  }

  // Those that came with the last call.
  const std::vector<Cell_handle>& new_cells() const { return m_keeper.new_cells; }

private:
  Keeper m_keeper;
  Transformation m_transform;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_REMOVE_LONG_EDGE_3_H
