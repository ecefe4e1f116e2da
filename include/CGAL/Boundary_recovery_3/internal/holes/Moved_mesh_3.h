// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_MOVED_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_MOVED_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/input/Indexed_input_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * A mesh as arrays: what the caller of remesh_holes() has. Some of its tetrahedra may be flat or inverted, that is, the
 * order of their vertices is the only thing that tells on which side of a facet they are.
 *
 * Its facets and edges are those that have to stay, beside those that bound regions.
 */
template <typename Point_3_>
struct Moved_mesh_3
  : public Indexed_input_3<Point_3_>
{
  typedef Point_3_                   Point_3;
  typedef std::array<std::size_t, 4> Tetrahedron;

  using Indexed_input_3<Point_3>::points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<int> regions; // of the tetrahedra

  // In floating point numbers.
  std::array<Coordinates_3, 4> corners(const std::size_t cell) const
  {
    const Tetrahedron& t = tetrahedra[cell];
    return {{ internal::coordinates_of(points[t[0]]), internal::coordinates_of(points[t[1]]),
              internal::coordinates_of(points[t[2]]), internal::coordinates_of(points[t[3]]) }};
  }

  // Whether a cell is neither flat nor inverted.
  bool is_positive(const std::size_t cell) const
  {
    const Tetrahedron& t = tetrahedra[cell];
    const auto orientation = typename Kernel_traits<Point_3>::Kernel().orientation_3_object();
    return orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) == POSITIVE;
  }
};

template <typename Point_3>
Input_simplex_3<Point_3> describe_tetrahedron(const Moved_mesh_3<Point_3>& mesh, const std::size_t c)
{
  return describe_simplex(mesh, c, mesh.tetrahedra[c]);
}

/*
 * What of a mesh has to stay, whatever is remeshed: the facets that the caller says, those between two regions, those
 * on the boundary of the mesh, and the edges that the caller says.
 */
template <typename Point_3>
class Constrained_sides_3
{
public:
  typedef Moved_mesh_3<Point_3>      Mesh;
  typedef std::array<std::size_t, 2> Edge;

  static constexpr std::size_t none = std::size_t(-1);

  Constrained_sides_3(const Mesh& mesh, const Tetrahedra_incidences_3& incidences)
    : m_mesh(mesh), m_incidences(incidences)
  { }

  // Looks up the facets and edges of the caller. Those that are not there are appended to lists of positions.
  void find(std::vector<std::size_t>& lost_facets, std::vector<std::size_t>& lost_edges)
  {
    if(! m_mesh.facets.empty())
      m_is_named.assign(4 * m_mesh.tetrahedra.size(), false);
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
    {
      const std::size_t side = m_incidences.find(m_mesh.facets[f]);
      if(side == none)
        lost_facets.push_back(f);
      else
      {
        name(side, f);
        if(m_incidences.opposite(side) != none)
          name(m_incidences.opposite(side), f);
      }
    }
    for(std::size_t e = 0; e < m_mesh.edges.size(); ++e)
      if(! m_incidences.has_edge(m_mesh.edges[e][0], m_mesh.edges[e][1]))
        lost_edges.push_back(e);
      else if(m_edges.insert(m_mesh.edges[e]).second)
        m_positions_of_edges.push_back(e);
  }

  // The caller's position of a facet, or none.
  std::size_t position(const std::size_t side) const
  {
    const auto it = m_position_of_side.find(side);
    return it == m_position_of_side.end() ? none : it->second;
  }

  // Whether there is another region, or nothing, behind a facet.
  bool bounds_region(const std::size_t side) const
  {
    const std::size_t opposite = m_incidences.opposite(side);
    return opposite == none || m_mesh.regions[opposite / 4] != m_mesh.regions[side / 4];
  }

  bool is_constrained(const std::size_t side) const { return bounds_region(side) || is_named(side); }

  bool has_edges() const { return ! m_mesh.edges.empty(); }

  bool is_constrained_edge(const Edge& edge) const { return m_edges[edge] != m_edges.none; }

  // The caller's position of a constrained edge.
  std::size_t position(const Edge& edge) const { return m_positions_of_edges[m_edges[edge]]; }

  // Whether something that has to stay has this vertex.
  bool is_constrained_vertex(const std::size_t v) const
  {
    for(const std::size_t c : m_incidences.cells(v))
      for(std::size_t i = 0; i < 4; ++i)
      {
        const std::size_t u = m_mesh.tetrahedra[c][i];
        if(u != v && (is_constrained(4 * c + i) || (has_edges() && is_constrained_edge({{ u, v }}))))
          return true;
      }
    return false;
  }

private:
  // The first position counts.
  void name(const std::size_t side, const std::size_t f)
  {
    m_is_named[side] = true;
    m_position_of_side.emplace(side, f);
  }

  bool is_named(const std::size_t side) const { return ! m_is_named.empty() && m_is_named[side]; }

  const Mesh& m_mesh;
  const Tetrahedra_incidences_3& m_incidences;
  std::vector<bool> m_is_named; // of all sides, as most are not; empty if none is
  std::unordered_map<std::size_t, std::size_t> m_position_of_side; // for looking up only
  Simplex_index_3<std::size_t, 2> m_edges;
  std::vector<std::size_t> m_positions_of_edges;
};

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
        report(Input_defect_kind::non_finite_coordinate, describe_vertex(m_mesh, v));
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
      report(Input_defect_kind::not_in_mesh, describe_facet(m_mesh, f));
    for(const std::size_t e : edges)
      report(Input_defect_kind::not_in_mesh, describe_edge(m_mesh, e));
    return m_defects.empty();
  }

  std::vector<Defect>& defects() { return m_defects; }

private:
  template <typename Simplex>
  void check_indices(const std::vector<Simplex>& simplices, const Input_defect_kind repeated)
  {
    for(std::size_t i = 0; i < simplices.size(); ++i)
      if(! is_in_range(m_mesh, simplices[i]))
        report(Input_defect_kind::index_out_of_range, describe_simplex(m_mesh, i, simplices[i]));
      else if(has_repeated_vertex(simplices[i]))
        report(repeated, describe_simplex(m_mesh, i, simplices[i]));
  }

  void report(const Input_defect_kind kind, const Input_simplex_3<Point_3>& simplex)
  {
    m_defects.push_back(Defect{ kind, { simplex } });
  }

  // Each with the two tetrahedra.
  void report(const Input_defect_kind kind, const std::vector<Tetrahedra_incidences_3::Side_pair>& facets)
  {
    for(const auto& sides : facets)
      m_defects.push_back(Defect{ kind, { describe_tetrahedron(m_mesh, sides.first / 4),
                                          describe_tetrahedron(m_mesh, sides.second / 4) } });
  }

  const Mesh& m_mesh;
  std::vector<Defect> m_defects;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_MOVED_MESH_3_H
