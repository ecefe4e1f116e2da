// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_VERTEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_VERTEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Quality_improvement_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Seeds_at_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Star_cavity_3.h>

#include <CGAL/Random.h>

#include <cstddef>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Inserts a vertex where a bad cell is, or near it: some cells are exchanged for the star of the vertex. `Seeds` tells
 * where to try that:
 *
 *   bool is_for(Cell_handle c)                                // whether it helps cells that are as bad as c
 *   std::size_t start(Cell_handle c, double tolerated_loss)   // how many seeds there are at a cell
 *   bool grow(std::size_t k, Star_cavity_3<Mesh>& cavity)     // whether a cavity around one of them will do
 *
 * and whether the first one that will do is taken, or the one that helps most. Nothing is changed before the whole star
 * is known.
 */
template <typename Mesh, typename Seeds>
class Insert_vertex_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;
  typedef typename Mesh::Cells       Cells;

  explicit Insert_vertex_3(Mesh& mesh) : m_mesh(mesh), m_cavity(mesh), m_seeds(mesh) { }

  // Searches for a cavity and a place. Returns whether the cells would be less bad then, and none worse than the worst
  // one now, or, if the mesh has it so, than what is tolerated; or as the seeds say, if those are for flat cells.
  bool find(const Cell_handle c)
  {
    if(! m_seeds.is_for(c) || ! m_mesh.has_room())
      return false;
    const std::size_t number = m_seeds.start(c, 0);
    double best_gain = 0;
    std::size_t best = number;
    for(std::size_t k = 0; k < number; ++k)
      if(m_seeds.grow(k, m_cavity))
      {
        if(Seeds::is_first_one_taken)
          return true;
        if(gain() > best_gain)
        {
          best_gain = gain();
          best = k;
        }
      }
    return best < number && m_seeds.grow(best, m_cavity);
  }

  // The same for one seed at random, where the cells may be worse by less than `tolerated_loss`.
  bool find_any(const Cell_handle c, const double tolerated_loss, CGAL::Random& random)
  {
    const std::size_t number = m_mesh.has_room() ? m_seeds.start(c, tolerated_loss) : 0;
    return number > 0 && m_seeds.grow(random.uniform_int<std::size_t>(0, number - 1), m_cavity);
  }

  double gain() const { return m_cavity.gain(); }

  // Inserts the vertex. Returns true: all cells were found to be positively oriented.
  bool apply()
  {
    m_new_cells = &m_cavity.exchange();
    return true;
  }

  const Cells& new_cells() const { return *m_new_cells; }

  void count(Quality_improvement_counts& counts) const
  {
    ++counts.number_of_inserted_points;
    counts.number_of_removed_vertices += m_cavity.number_of_vertices_inside();
  }

private:
  Mesh& m_mesh;
  Star_cavity_3<Mesh> m_cavity;
  Seeds m_seeds;
  const Cells* m_new_cells = nullptr;
};

template <typename Mesh>
using Insert_into_bad_cell_3 = Insert_vertex_3<Mesh, Seeds_in_cell_3<Mesh>>;

template <typename Mesh>
using Insert_near_bad_cell_3 = Insert_vertex_3<Mesh, Seeds_near_cell_3<Mesh>>;

template <typename Mesh>
using Insert_into_shell_3 = Insert_vertex_3<Mesh, Seeds_in_shells_3<Mesh>>;

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_VERTEX_3_H
