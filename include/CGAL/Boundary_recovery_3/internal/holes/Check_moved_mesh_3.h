// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_CHECK_MOVED_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_CHECK_MOVED_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/holes/Constrained_sides_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * What can be wrong with a mesh that is given by arrays, but for its geometry: the first function has to be satisfied
 * before incidences can be looked for.
 */
template <typename Point_3>
class Check_moved_mesh_3
{
public:
  typedef Moved_mesh_3<Point_3>   Mesh;
  typedef Input_defect_3<Point_3> Defect;

  explicit Check_moved_mesh_3(const Mesh& mesh) : m_mesh(mesh) { }

  // Coordinates, and names of vertices.
  bool check_vertices()
  {
    for(std::size_t v = 0; v < m_mesh.points.size(); ++v)
      if(! has_finite_coordinates(m_mesh.points[v]))
        report(Input_defect_kind::non_finite_coordinate, m_mesh.describe_vertex(v));
    check_indices(m_mesh.tetrahedra, Input_defect_kind::repeated_vertex);
    check_indices(m_mesh.facets, Input_defect_kind::degenerate_facet);
    check_indices(m_mesh.edges, Input_defect_kind::degenerate_edge);
    return m_defects.empty();
  }

  bool check_incidences(const Tetrahedra_incidences_3& incidences)
  {
    report(Input_defect_kind::nonmanifold_facet, incidences.nonmanifold_facets());
    report(Input_defect_kind::inconsistent_orientation, incidences.inconsistent_facets());
    return m_defects.empty();
  }

  bool find_constraints(Constrained_sides_3<Point_3>& constraints)
  {
    std::vector<std::size_t> facets, edges;
    constraints.find(facets, edges);
    for(const std::size_t f : facets)
      report(Input_defect_kind::not_in_mesh, m_mesh.describe(f, m_mesh.facets[f]));
    for(const std::size_t e : edges)
      report(Input_defect_kind::not_in_mesh, m_mesh.describe(e, m_mesh.edges[e]));
    return m_defects.empty();
  }

  std::vector<Defect>& defects() { return m_defects; }

private:
  template <typename Simplex>
  void check_indices(const std::vector<Simplex>& simplices, const Input_defect_kind repeated)
  {
    for(std::size_t i = 0; i < simplices.size(); ++i)
    {
      Simplex s = simplices[i];
      std::sort(s.begin(), s.end());
      if(s.back() >= m_mesh.points.size())
        report(Input_defect_kind::index_out_of_range, m_mesh.describe(i, simplices[i]));
      else if(std::adjacent_find(s.begin(), s.end()) != s.end())
        report(repeated, m_mesh.describe(i, simplices[i]));
    }
  }

  void report(const Input_defect_kind kind, const typename Mesh::Simplex& simplex)
  {
    m_defects.push_back(Defect{ kind, { simplex } });
  }

  // Each with the two tetrahedra.
  void report(const Input_defect_kind kind, const std::vector<Tetrahedra_incidences_3::Side_pair>& facets)
  {
    const auto describe = [&](const std::size_t side)
    {
      return m_mesh.describe(side / 4, m_mesh.tetrahedra[side / 4]);
    };
    for(const auto& sides : facets)
      m_defects.push_back(Defect{ kind, { describe(sides.first), describe(sides.second) } });
  }

  const Mesh& m_mesh;
  std::vector<Defect> m_defects;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_CHECK_MOVED_MESH_3_H
