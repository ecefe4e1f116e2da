// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_WALLS_AT_EDGE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_WALLS_AT_EDGE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Edge_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

#include <array>
#include <optional>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Finds the two walls that a cell is between at one of its edges, if the angle between them is small: all cells between
 * them have such an angle there, and so have those of any other mesh.
 */
template <typename Tr, typename Domain>
class Walls_at_edge_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef typename Tr::Facet         Facet;

  struct Walls
  {
    std::array<Facet, 2> facets;
    double angle; // between them
  };

  // The domain must exist as long as this does.
  explicit Walls_at_edge_3(const Domain& domain) : m_domain(domain) { }

  // None if they are not less than `limit` degrees apart. The cell is known to have this angle at its edge k.
  std::optional<Walls> operator()(const Cell_handle c, const int k, const double angle, const double limit) const
  {
    const Vertex_handle u = c->vertex(edges_of_cell[k][0]), v = c->vertex(edges_of_cell[k][1]);
    const int* const others = edges_of_cell[5 - k];
    Edge_walk_3<Tr> there(c, others[0], others[1]), back(c, others[1], others[0]);
    double sum_of_angles = angle;
    if(! go_to_wall(there, u, v, sum_of_angles, limit) || ! go_to_wall(back, u, v, sum_of_angles, limit))
      return std::nullopt;
    const double between = angle_at_edge(u, v, there.apex(), back.apex());
    if(! (between < limit))
      return std::nullopt;
    return Walls{ {{ Facet(there.cell(), there.next_facet()), Facet(back.cell(), back.next_facet()) }}, between };
  }

private:
  static constexpr double slack = 1; // degrees by which sums of angles are allowed to be too large before all is known

  bool go_to_wall(Edge_walk_3<Tr>& walk, const Vertex_handle u, const Vertex_handle v, double& sum_of_angles,
                  const double limit) const
  {
    const Cell_handle start = walk.cell();
    while(! m_domain.is_wall(walk.cell(), walk.next_facet()))
    {
      ++walk;
      sum_of_angles += angle_at_edge(u, v, walk.cell()->vertex(walk.next_facet()), walk.apex());
      if(walk.cell() == start || sum_of_angles > limit + slack)
        return false;
    }
    return true;
  }

  static double angle_at_edge(const Vertex_handle u, const Vertex_handle v,
                              const Vertex_handle p, const Vertex_handle q)
  {
    const std::array<Vertex_handle, 4> tetrahedron = {{ u, v, p, q }};
    return Cell_angles_3(internal::corners(tetrahedron))[0]; // the first edge is that of the first two corners
  }

  const Domain& m_domain;
};

// Whether a cell has an angle below `limit` degrees that any mesh has: it is between two walls.
template <typename Tr, typename Domain>
bool is_forced(const Walls_at_edge_3<Tr, Domain>& walls_at_edge, const typename Tr::Cell_handle c, const double limit)
{
  const Cell_angles_3 angles(internal::corners(c));
  for(int k = 0; k < 6; ++k)
    if(angles[k] < limit && walls_at_edge(c, k, angles[k], limit))
      return true;
  return false;
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_WALLS_AT_EDGE_3_H
