// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_CELLS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_CELLS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Which cells of a mesh have to be replaced: those that are inverted or flat, which exact predicates tell; those with a
 * dihedral angle below a threshold; and those that the caller names.
 */
template <typename Kernel>
struct Find_bad_cells_3
{
  typedef Moved_mesh_3<typename Kernel::Point_3> Mesh;

  std::vector<char> is_bad; // of the tetrahedra
  std::size_t number_of_bad_cells = 0;
  std::size_t number_of_inverted_cells = 0;

  // Cells of the region that is not filled may have any shape; `is_selected` is called with a position.
  template <typename Is_selected, typename Is_unfilled>
  Find_bad_cells_3(const Mesh& mesh, const double min_dihedral_angle, const Is_selected& is_selected,
                   const Is_unfilled& is_unfilled)
    : is_bad(mesh.tetrahedra.size(), false)
  {
    const double good = Dihedral_angle_quality_3(1).of_angle(min_dihedral_angle) * (1 + 1e-6); // for rounding
    for(std::size_t c = 0; c < mesh.tetrahedra.size(); ++c)
    {
      const bool is_inverted = ! mesh.is_positive(c);
      is_bad[c] = is_inverted || is_selected(c)
               || (! is_unfilled(mesh.regions[c]) && is_below(mesh, c, min_dihedral_angle, good));
      number_of_inverted_cells += is_inverted ? 1 : 0;
      number_of_bad_cells += is_bad[c] ? 1 : 0;
    }
  }

private:
  // Most cells are so good that angles need not be computed.
  static bool is_below(const Mesh& mesh, const std::size_t c, const double min_dihedral_angle, const double good)
  {
    const auto corners = mesh.corners(c);
    return Dihedral_angle_quality_3(1)(corners) < good && Cell_angles_3(corners).smallest() < min_dihedral_angle;
  }
};

/*
 * Which tetrahedra are replaced, and which of them belong together: a hole is a set of them that is connected by
 * facets.
 *
 * Holes can only grow. One that does is dissolved, and its tetrahedra wait until holes are formed again, since it may
 * have reached others.
 */
class Hole_cells_3
{
public:
  typedef std::array<std::size_t, 4> Tetrahedron;

  Hole_cells_3(const std::vector<Tetrahedron>& tetrahedra, const Tetrahedra_incidences_3& incidences)
    : m_tetrahedra(tetrahedra), m_incidences(incidences), m_hole(tetrahedra.size(), std::size_t(kept))
  { }

  bool contains(const std::size_t cell) const { return m_hole[cell] != kept; }

  bool are_in_same_hole(const std::size_t c, const std::size_t d) const { return m_hole[c] == m_hole[d]; }

  // Returns whether it was not in a hole.
  bool add(const std::size_t cell)
  {
    if(contains(cell))
      return false;
    m_hole[cell] = waiting;
    m_waiting.push_back(cell);
    return true;
  }

  // Adds the tetrahedra at vertices of those that wait, so many times.
  void add_layers(const std::size_t number)
  {
    std::size_t first = 0;
    for(std::size_t k = 0; k < number; ++k)
    {
      const std::size_t last = m_waiting.size();
      for(; first < last; ++first)
        for(const std::size_t v : m_tetrahedra[m_waiting[first]])
          add_star(v);
    }
  }

  // Returns whether there was something to be added.
  bool add_star(const std::size_t v)
  {
    bool has_grown = false;
    for(const std::size_t c : m_incidences.cells(v))
      has_grown = add(c) || has_grown;
    return has_grown;
  }

  // The hole is no more; its tetrahedra wait.
  void dissolve(const std::size_t hole)
  {
    for(const std::size_t c : m_cells[hole])
      m_hole[c] = waiting;
    m_waiting.insert(m_waiting.end(), m_cells[hole].begin(), m_cells[hole].end());
    m_cells[hole].clear();
  }

  // Makes holes of the tetrahedra that wait, and of other holes that they reach, which are no more. Returns the number
  // of the first new one; the others follow.
  std::size_t form_holes()
  {
    const std::size_t first_new = m_cells.size();
    std::sort(m_waiting.begin(), m_waiting.end());
    for(const std::size_t c : std::exchange(m_waiting, std::vector<std::size_t>()))
      if(m_hole[c] == waiting)
        form_hole(c);
    return first_new;
  }

  // Those that are no more are counted, too.
  std::size_t number_of_holes() const { return m_cells.size(); }

  // In their order; none if the hole is no more.
  const std::vector<std::size_t>& cells(const std::size_t hole) const { return m_cells[hole]; }

private:
  static constexpr std::size_t kept = std::size_t(-1);
  static constexpr std::size_t waiting = std::size_t(-2);

  void form_hole(const std::size_t seed)
  {
    const std::size_t hole = m_cells.size();
    std::vector<std::size_t> cells(1, seed);
    m_hole[seed] = hole;
    for(std::size_t k = 0; k < cells.size(); ++k)
      for(std::size_t i = 0; i < 4; ++i)
      {
        const std::size_t side = m_incidences.opposite(4 * cells[k] + i);
        if(side == m_incidences.none)
          continue;
        const std::size_t c = side / 4;
        if(m_hole[c] == kept || m_hole[c] == hole)
          continue;
        if(m_hole[c] != waiting)
          m_cells[m_hole[c]].clear();
        m_hole[c] = hole;
        cells.push_back(c);
      }
    std::sort(cells.begin(), cells.end());
    m_cells.push_back(std::move(cells));
  }

  const std::vector<Tetrahedron>& m_tetrahedra;
  const Tetrahedra_incidences_3& m_incidences;
  std::vector<std::size_t> m_hole;                // of each tetrahedron
  std::vector<std::size_t> m_waiting;             // those that are in no hole yet
  std::vector<std::vector<std::size_t> > m_cells; // of each hole
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_CELLS_3_H
