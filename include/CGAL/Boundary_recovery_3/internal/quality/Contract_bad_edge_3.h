// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CONTRACT_BAD_EDGE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CONTRACT_BAD_EDGE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Free_star_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Removes a free vertex by the contraction of one of its edges: the cells that are left fill the star of the vertex
 * from the other end.
 */
template <typename Mesh>
class Contract_bad_edge_3
{
public:
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Cell_handle   Cell_handle;
  typedef typename Mesh::Cells         Cells;

  explicit Contract_bad_edge_3(Mesh& mesh) : m_mesh(mesh), m_star(mesh), m_vain_attempts(mesh) { }

  // Searches for the best edge of all vertices of a bad cell, of those around which something has changed.
  bool find(const Cell_handle c)
  {
    double gain = 0;
    int best = -1;
    for(int i = 0; i < 4; ++i)
      if(! m_vain_attempts.contains(c->vertex(i)))
      {
        if(find(c->vertex(i), gain))
        {
          gain = m_gain;
          best = i;
        }
        else if(gain == 0)
          m_vain_attempts.add(c->vertex(i));
      }
    return best >= 0 && find(c->vertex(best), 0);
  }

  // Searches for the best edge of v to be contracted. Returns whether the cells would be less bad then, by more than
  // `least_gain`, and none worse than the worst one now.
  bool find(const Vertex_handle v, const double least_gain)
  {
    m_v = v;
    m_to = Vertex_handle();
    if(! m_star.collect(v))
      return false;
    const auto account = m_mesh.account_of(m_star.cells());
    m_worst = m_mesh.least_quality(account.worst);
    m_least = account.badness - least_gain;
    for(const Vertex_handle u : m_star.neighbors())
      look_at(u);
    m_gain = account.badness - m_least;
    return m_to != Vertex_handle();
  }

  // By how much the cells would be less bad.
  double gain() const { return m_gain; }

  // Contracts the edge. Returns false, and does nothing, if a new cell is not positively oriented.
  bool apply()
  {
    m_tetrahedra.clear();
    for(const auto& f : m_star.faces())
      if(! internal::contains(f, m_to))
        m_tetrahedra.push_back(Tetrahedron{{ f[0], f[1], f[2], m_to }});
    if(! m_mesh.are_positive(m_tetrahedra))
    {
      m_vain_attempts.add(m_v);
      return false;
    }
    m_new_cells = &m_mesh.replace(m_star.cells(), m_tetrahedra, std::array<Vertex_handle, 1>{{ m_v }});
    return true;
  }

  const Cells& new_cells() const { return *m_new_cells; }

  void count(Quality_improvement_counts& counts) const { ++counts.number_of_removed_vertices; }

private:
  typedef typename Mesh::Tetrahedron       Tetrahedron;
  typedef typename Free_star_3<Mesh>::Face Face;

  void look_at(const Vertex_handle u)
  {
    const double badness = badness_with(u);
    if(! (badness < m_least) || ! are_edges_in_size(u))
      return;
    m_least = badness;
    m_to = u;
  }

  // That of the cells that are left, or something not less than what is asked for.
  double badness_with(const Vertex_handle u)
  {
    m_faces.clear();
    for(const Face& f : m_star.faces())
      if(! internal::contains(f, u))
        m_faces.push_back(&f);
    double badness = 0;
    const auto corners = [p = Mesh::coordinates(u)](const Face* const f) { return Mesh::corners(*f, p); };
    const bool is_good = internal::visit_qualities(m_mesh.quality(), m_faces, corners, [&](const Face*, const double q)
    {
      badness += m_mesh.badness(q);
      return q >= m_worst && badness < m_least;
    });
    return is_good ? badness : m_least;
  }

  // Whether the edges that u gets would be.
  bool are_edges_in_size(const Vertex_handle u) const
  {
    for(const auto& f : m_star.faces())
      if(! internal::contains(f, u))
        for(const Vertex_handle w : f)
          if((! m_mesh.is_edge_in_size(u, w) || is_longer_than_sizes(u, w)) && ! is_edge_of_link(u, w))
            return false;
    return true;
  }

  // Beside long constrained edges, others may be longer than their sizes, too; but not where a vertex goes for that.
  static bool is_longer_than_sizes(const Vertex_handle u, const Vertex_handle w)
  {
    const double sizes = Mesh::size(u) + Mesh::size(w); // twice the mean
    return sizes > 0 && internal::distance(Mesh::coordinates(u), Mesh::coordinates(w)) > sizes;
  }

  bool is_edge_of_link(const Vertex_handle u, const Vertex_handle w) const
  {
    return std::any_of(m_star.faces().begin(), m_star.faces().end(), [&](const auto& f)
    {
      return internal::contains(f, u) && internal::contains(f, w);
    });
  }

  Mesh& m_mesh;
  Free_star_3<Mesh> m_star;
  Vain_attempts_3<Mesh> m_vain_attempts;
  Vertex_handle m_v, m_to;
  double m_worst = 0; // what qualities are to be at least
  double m_least = 0; // badness
  double m_gain = 0;
  std::vector<const Face*> m_faces; // that stay
  std::vector<Tetrahedron> m_tetrahedra;
  const Cells* m_new_cells = nullptr;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_CONTRACT_BAD_EDGE_3_H
