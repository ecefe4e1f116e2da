// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_NEAR_BAD_CELL_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_NEAR_BAD_CELL_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/filling/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/filling/facet_towards.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Places_near_cell_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Star_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Inserts a vertex near a bad cell, where insertion into the cell does not help: beside a thin triangle of the surface,
 * cells are good if they have their other vertices near its short edge, or beside its long ones, and that is far from
 * the center of any cell there.
 *
 * Several places are tried. The cavity of a place is made of the cells on the way to it, and grows where its star has
 * the worst cell. Of all states on the way, and of all places, the one that helps most is taken.
 */
template <typename Mesh>
class Insert_near_bad_cell_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;
  typedef typename Mesh::Cells       Cells;

  explicit Insert_near_bad_cell_3(Mesh& mesh) : m_mesh(mesh), m_cavity(mesh) { }

  // Searches for a point. Returns whether the cells would be less bad then, and none worse than the worst one now, or,
  // if the mesh has it so, than what is tolerated.
  bool find(const Cell_handle c)
  {
    if(! m_mesh.has_room())
      return false;
    set_limits(c, 0);
    double best_gain = 0;
    const Coordinates_3* best = nullptr;
    for(const Coordinates_3& p : m_places_near(internal::corners(c)))
    {
      const double gain = gain_at(c, p);
      if(gain > best_gain)
      {
        best_gain = gain;
        best = &p;
      }
    }
    return best != nullptr && gain_at(c, *best) > 0;
  }

  // The same for a few of the places, at random, where the cells may be worse by less than `tolerated_loss`: the first
  // one that will do is taken.
  bool find_any(const Cell_handle c, const double tolerated_loss, CGAL::Random& random)
  {
    if(! m_mesh.has_room())
      return false;
    set_limits(c, tolerated_loss);
    const std::vector<Coordinates_3>& places = m_places_near(internal::corners(c));
    for(int k = 0; k < max_number_of_random_places && ! places.empty(); ++k)
      if(gain_at(c, places[random.uniform_int<std::size_t>(0, places.size() - 1)]) > m_least_gain)
        return true;
    return false;
  }

  // Inserts the vertex.
  void apply() { m_new_cells = &m_cavity.exchange(); }

  const Cells& new_cells() const { return *m_new_cells; }

  // Free vertices around which all cells are new.
  std::size_t number_of_removed_vertices() const { return m_cavity.number_of_vertices_inside(); }

private:
  typedef Star_cavity_3<Mesh>   Cavity;
  typedef typename Cavity::Face Face;

  // See "Tuning constants" in the manual.
  static constexpr int max_number_of_steps = 20;
  static constexpr std::size_t max_number_of_cells = 30;
  static constexpr int max_number_of_random_places = 4;

  void set_limits(const Cell_handle c, const double tolerated_loss)
  {
    m_least_gain = - tolerated_loss;
    m_least_at_wall = m_mesh.least_quality(m_mesh.quality(c));
  }

  // Returns by how much the cells would be less bad with a vertex there; the least gain: not by more, or it is not
  // possible.
  double gain_at(const Cell_handle c, const Coordinates_3& p)
  {
    return are_walls_good_with(c, p) && walk(c, p) && make_cavity(p) ? m_cavity.gain() : m_least_gain;
  }

  // The cells at the walls of c stay whatever the cavity grows to, so nothing is worth while if they are too bad.
  bool are_walls_good_with(const Cell_handle c, const Coordinates_3& p) const
  {
    for(int i = 0; i < 4; ++i)
      if(m_mesh.domain().is_wall(c, i) && m_mesh.quality(internal::facet_vertices(c, i), p) < m_least_at_wall)
        return false;
    return true;
  }

  // Collects the cells from c to the one that the point is in, none of them twice. Returns false if there is a wall
  // before, or it is far.
  bool walk(Cell_handle c, const Coordinates_3& p)
  {
    m_way.clear();
    for(int step = 0; step < max_number_of_steps; ++step)
    {
      m_way.push_back(c);
      const int i = internal::facet_towards(c, p, [&](const int k) { return ! is_on_way(c->neighbor(k)); });
      if(i < 0)
        return true;
      if(m_mesh.domain().is_wall(c, i))
        return false;
      c = c->neighbor(i);
    }
    return false;
  }

  bool is_on_way(const Cell_handle c) const { return internal::contains(m_way, c); }

  // Begins with the cells of the way, and moves the point in the end. Returns false if the cells would be too bad.
  bool make_cavity(const Coordinates_3& p)
  {
    m_cavity.start(m_way.front(), p);
    for(std::size_t k = 1; k < m_way.size(); ++k)
      m_cavity.take_in(m_way[k]);
    if(! grow())
      return false;
    const double quality = m_cavity.move_point();
    return m_cavity.gain() > m_least_gain && quality > 0
        && quality >= m_mesh.least_quality(m_cavity.worst_quality())
        && m_cavity.has_only_free_vertices_inside() && m_cavity.is_in_size() && m_cavity.is_star();
  }

  // Grows the cavity, and goes back to where the cells are the least bad. Returns false if that is nowhere as
  // good as it has to be.
  bool grow()
  {
    double best_gain = m_least_gain;
    std::size_t best = 0;
    while(true)
    {
      const double gain = m_cavity.badness() - set_worst_face();
      const double least = m_mesh.least_quality(m_cavity.worst_quality());
      if(gain > best_gain && m_worst > 0 && m_worst >= least && m_cavity.has_only_free_vertices_inside())
      {
        best_gain = gain;
        best = m_cavity.cells().size();
      }
      if(m_face == nullptr || m_worst_at_wall < least || m_cavity.cells().size() >= max_number_of_cells)
        break;
      m_cavity.take_in(m_face->cell->neighbor(m_face->index));
    }
    if(best > 0 && best < m_cavity.cells().size())
      m_cavity.go_back_to(best);
    return best > 0;
  }

  // The worst new cell, and its face, if it may be gone through, or that of another one; and the worst one at a wall,
  // which stays whatever the cavity grows to. Returns how bad all are.
  double set_worst_face()
  {
    double badness = 0, worst = m_mesh.enough();
    m_worst = m_worst_at_wall = worst;
    m_face = nullptr;
    for(const Face& f : m_cavity.faces())
    {
      badness += m_mesh.badness(f.quality);
      m_worst = (std::min)(m_worst, f.quality);
      if(! (f.quality < (std::max)(worst, m_worst_at_wall)))
        continue;
      if(m_cavity.is_wall(f))
        m_worst_at_wall = (std::min)(m_worst_at_wall, f.quality);
      else if(f.quality < worst)
      {
        worst = f.quality;
        m_face = &f;
      }
    }
    return badness;
  }

  Mesh& m_mesh;
  Cavity m_cavity;
  std::vector<Cell_handle> m_way; // from the bad cell to the point
  Places_near_cell_3 m_places_near;
  const Face* m_face = nullptr; // of the cavity
  double m_worst = 0;           // of the qualities of the new cells
  double m_worst_at_wall = 0;
  double m_least_gain = 0;
  double m_least_at_wall = 0; // of the qualities of the cells at the walls of the bad cell
  const Cells* m_new_cells = nullptr;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_INSERT_NEAR_BAD_CELL_3_H
