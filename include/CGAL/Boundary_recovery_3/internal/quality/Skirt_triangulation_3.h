// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SKIRT_TRIANGULATION_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SKIRT_TRIANGULATION_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Exchanges cells that fill the polyhedron between a closed polygon and two vertices, one on each of its sides, for
 * those that a triangulation of the polygon makes with both of them: the one whose cells are the least bad together, of
 * those that have no cell worse than the worst one now.
 *
 * It is found by dynamic programming over the intervals of the polygon (Klincsek). Whatever is worse already is not
 * looked at.
 */
template <typename Mesh>
class Skirt_triangulation_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  // Larger polygons are left alone.
  static constexpr int max_degree = 12;

  explicit Skirt_triangulation_3(Mesh& mesh) : m_mesh(mesh) { }

  // The polygon goes counterclockwise, seen from `above`. There are no cells yet.
  void start(const Vertex_handle above, const Vertex_handle below)
  {
    m_above = above;
    m_below = below;
    m_ring.clear();
    m_cells.clear();
  }

  // Returns false if it is too large.
  bool add_corner(const Vertex_handle v)
  {
    if(degree() == max_degree)
      return false;
    m_ring.push_back(v);
    return true;
  }

  // One that goes. There are twice as many as corners at most.
  void add_cell(const Cell_handle c) { m_cells.push_back(c); }

  // Searches for the best triangulation. Returns whether the cells would be less bad then, by more than `least_gain`.
  // New edges may be as long, or as short, as one that goes.
  bool find(const double least_gain, const double length_before)
  {
    const auto account = m_mesh.account_of(m_cells);
    const double bound = account.badness - least_gain;
    if(! (bound > 0))
      return false;
    m_at_above = Mesh::coordinates(m_above);
    m_at_below = Mesh::coordinates(m_below);
    m_length = length_before;
    m_corners.resize(m_ring.size());
    std::transform(m_ring.begin(), m_ring.end(), m_corners.begin(), &Mesh::coordinates);
    const double least = least_badness(m_mesh.least_quality(account.worst), bound);
    m_gain = account.badness - least;
    return least < bound;
  }

  // By how much the cells would be less bad.
  double gain() const { return m_gain; }

  // Exchanges the cells. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply()
  {
    m_tetrahedra.clear();
    collect_tetrahedra(0, degree() - 1);
    if(! m_mesh.are_positive(m_tetrahedra))
      return false;
    m_new_cells = &m_mesh.replace(m_cells, m_tetrahedra);
    return true;
  }

  const Cells& new_cells() const { return *m_new_cells; }

private:
  typedef typename Mesh::Tetrahedron Tetrahedron;

  int degree() const { return static_cast<int>(m_ring.size()); }

  // That of the best triangulation that has no cell worse than `worst`, or something not less than `bound`.
  double least_badness(const double worst, const double bound)
  {
    const int m = degree();
    for(int i = 0; i + 1 < m; ++i)
      m_least[i][i + 1] = 0;
    for(int length = 2; length < m; ++length)
      for(int i = 0; i + length < m; ++i)
      {
        const int j = i + length;
        m_least[i][j] = bound;
        if(length + 1 == m || m_mesh.is_edge_in_size(m_ring[i], m_ring[j], m_length))
          for(int k = i + 1; k < j; ++k)
          {
            const double badness = m_least[i][k] + m_least[k][j];
            if(badness < m_least[i][j])
              look_at_triangle(i, k, j, badness, worst);
          }
      }
    return m_least[0][m - 1];
  }

  void look_at_triangle(const int i, const int k, const int j, double badness, const double worst)
  {
    const auto [q, r] = m_mesh.quality().of_two_cells({{ m_corners[i], m_corners[k], m_corners[j], m_at_above }},
                                                      {{ m_corners[i], m_corners[j], m_corners[k], m_at_below }});
    badness += m_mesh.badness(q) + m_mesh.badness(r);
    if(q < worst || r < worst || ! (badness < m_least[i][j]))
      return;
    m_least[i][j] = badness;
    m_middle[i][j] = k;
  }

  // The cells for the polygon from position i to position j; that takes no deeper recursion than max_degree.
  void collect_tetrahedra(const int i, const int j)
  {
    if(j == i + 1)
      return;
    const int k = m_middle[i][j];
    m_tetrahedra.push_back(Tetrahedron{{ m_ring[i], m_ring[k], m_ring[j], m_above }});
    m_tetrahedra.push_back(Tetrahedron{{ m_ring[i], m_ring[j], m_ring[k], m_below }});
    collect_tetrahedra(i, k);
    collect_tetrahedra(k, j);
  }

  Mesh& m_mesh;
  Vertex_handle m_above, m_below;
  boost::container::static_vector<Vertex_handle, max_degree> m_ring;
  boost::container::static_vector<Coordinates_3, max_degree> m_corners; // of the ring
  boost::container::static_vector<Cell_handle, 2 * max_degree> m_cells;
  boost::container::static_vector<Tetrahedron, 2 * max_degree> m_tetrahedra;
  Coordinates_3 m_at_above, m_at_below;
  double m_length = 0; // that edges may have
  std::array<std::array<double, max_degree>, max_degree> m_least; // badness, by interval
  std::array<std::array<int, max_degree>, max_degree> m_middle;
  double m_gain = 0;
  const Cells* m_new_cells = nullptr;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_SKIRT_TRIANGULATION_3_H
