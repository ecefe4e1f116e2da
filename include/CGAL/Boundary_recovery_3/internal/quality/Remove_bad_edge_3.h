// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_REMOVE_BAD_EDGE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_REMOVE_BAD_EDGE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The shell transformation that is led by quality alone, and removes the supporting edge [CZZ+17, Sections 1.3 and 2]:
 * the covering mesh of the shell is exchanged for the complete triangulation of the skirt polygon whose cells are the
 * least bad together, of those that have no cell worse than the worst one now.
 *
 * The best triangulation is found by dynamic programming over the intervals of the skirt polygon (Klincsek). Whatever
 * is worse already is not looked at.
 */
template <typename Mesh>
class Remove_bad_edge_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  // Shells of a larger degree are left alone.
  static constexpr int max_degree = 12;

  explicit Remove_bad_edge_3(Mesh& mesh) : m_mesh(mesh) { }

  // Searches for the best way to remove the edge from the vertex i to the vertex j of a cell of the domain. Returns
  // whether the cells would be less bad then, by more than `least_gain`, and none worse than the worst one now.
  bool find(const Cell_handle c, const int i, const int j, const double least_gain)
  {
    if(! collect_shell(c, i, j))
      return false;
    const auto account = m_mesh.account_of(m_cells);
    const double bound = account.badness - least_gain;
    if(! (bound > 0))
      return false;
    const double least = least_badness(m_mesh.least_quality(account.worst), bound);
    m_gain = account.badness - least;
    return least < bound;
  }

  // By how much the cells would be less bad.
  double gain() const { return m_gain; }

  // Removes the edge. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply()
  {
    m_tetrahedra.clear();
    collect_tetrahedra(0, degree() - 1);
    for(const auto& t : m_tetrahedra)
      if(! m_mesh.is_positive(t[0], t[1], t[2], t[3]))
        return false;
    m_new_cells = &m_mesh.replace(m_cells, m_tetrahedra);
    return true;
  }

  const Cells& new_cells() const { return *m_new_cells; }

private:
  typedef typename Mesh::Triangulation Tr;
  typedef typename Mesh::Tetrahedron   Tetrahedron;

  int degree() const { return static_cast<int>(m_ring.size()); }

  // Returns false if the edge has to stay, or if there are too many cells around it.
  bool collect_shell(const Cell_handle c, const int i, const int j)
  {
    m_a = c->vertex(i);
    m_b = c->vertex(j);
    m_ring.clear();
    m_cells.clear();
    Cell_handle cell = c;
    do
    {
      const int k = Tr::next_around_edge(cell->index(m_a), cell->index(m_b));
      if(degree() == max_degree || m_mesh.domain().is_wall(cell, k))
        return false;
      m_ring.push_back(cell->vertex(k));
      m_cells.push_back(cell);
      cell = cell->neighbor(k);
    }
    while(cell != c);
    if constexpr(Mesh::Domain::has_constrained_edges)
      if(m_mesh.domain().is_constrained_edge(m_a, m_b))
        return false;
    m_at_a = Mesh::coordinates(m_a);
    m_at_b = Mesh::coordinates(m_b);
    m_length = internal::distance(m_at_a, m_at_b);
    m_corners.resize(m_ring.size());
    std::transform(m_ring.begin(), m_ring.end(), m_corners.begin(), &Mesh::coordinates);
    return true;
  }

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
    const auto [q, r] = m_mesh.quality().of_two_cells({{ m_corners[i], m_corners[k], m_corners[j], m_at_b }},
                                                      {{ m_corners[i], m_corners[j], m_corners[k], m_at_a }});
    badness += m_mesh.badness(q) + m_mesh.badness(r);
    if(q < worst || r < worst || ! (badness < m_least[i][j]))
      return;
    m_least[i][j] = badness;
    m_middle[i][j] = k;
  }

  // The cells for the skirt polygon from position i to position j; that takes no deeper recursion than max_degree.
  void collect_tetrahedra(const int i, const int j)
  {
    if(j == i + 1)
      return;
    const int k = m_middle[i][j];
    m_tetrahedra.push_back(Tetrahedron{{ m_ring[i], m_ring[k], m_ring[j], m_b }});
    m_tetrahedra.push_back(Tetrahedron{{ m_ring[i], m_ring[j], m_ring[k], m_a }});
    collect_tetrahedra(i, k);
    collect_tetrahedra(k, j);
  }

  Mesh& m_mesh;
  Vertex_handle m_a, m_b;
  boost::container::static_vector<Vertex_handle, max_degree> m_ring;
  boost::container::static_vector<Coordinates_3, max_degree> m_corners; // of the ring
  boost::container::static_vector<Cell_handle, max_degree> m_cells;
  boost::container::static_vector<Tetrahedron, 2 * max_degree> m_tetrahedra;
  Coordinates_3 m_at_a, m_at_b;
  double m_length = 0; // of the edge
  std::array<std::array<double, max_degree>, max_degree> m_least; // badness, by interval
  std::array<std::array<int, max_degree>, max_degree> m_middle;
  double m_gain = 0;
  const Cells* m_new_cells = nullptr;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_REMOVE_BAD_EDGE_3_H
