// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BAD_CELLS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BAD_CELLS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/sort_in_space.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The cells that are not good enough, and when each was visited last: if nothing has changed around it since, what
 * failed before would fail again.
 */
template <typename Mesh>
class Bad_cells_3
{
public:
  typedef typename Mesh::Cell_handle Cell_handle;

  struct Bad_cell
  {
    double quality;
    Cell_handle cell;
    std::size_t time; // of the last visit, in changes of the mesh; 0: none
  };

  // What goes through the whole list asks for each cell whether to go on; if not, the list is of no use any more.
  explicit Bad_cells_3(const Mesh& mesh, std::function<bool()> goes_on = [] { return true; })
    : m_mesh(mesh), m_goes_on(std::move(goes_on))
  { }

  // A cell of the domain, visited at that time, may be bad. Returns its quality.
  double push(const Cell_handle c, const std::size_t time = 0)
  {
    const double q = m_mesh.quality(c);
    if(q < m_mesh.enough())
      m_cells.push_back(Bad_cell{ q, c, time });
    return q;
  }

  // These cells of the domain are new, or have a vertex that moved.
  template <typename CellRange>
  void push_all(const CellRange& cells)
  {
    for(const Cell_handle c : cells)
      push(c);
  }

  // It was not visited, or they were not.
  void put_back(const Bad_cell& c) { m_cells.push_back(c); }
  void put_back(const std::vector<Bad_cell>& cells) { m_cells.insert(m_cells.end(), cells.begin(), cells.end()); }

  // Whether a handle, maybe of a cell that is gone, is one of a cell of the domain; the second: of a bad one.
  bool is_in_domain(const Cell_handle c) const
  {
    return m_mesh.triangulation().tds().cells().is_used(c) && m_mesh.domain().contains(c);
  }

  bool contains(const Cell_handle c) const
  {
    return is_in_domain(c) && m_mesh.quality(c) < m_mesh.enough();
  }

  // What is in the list, without those that are gone or good, the worst one first. In equal meshes, the order is the
  // same.
  const std::vector<Bad_cell>& worst_first()
  {
    remove_what_is_not_bad();
    if(m_goes_on())
      sort_worst_first(m_cells.begin(), m_cells.end());
    return m_cells;
  }

  // Begins a round: these are to be worked through; there is none left here.
  std::vector<Bad_cell> next_round()
  {
    worst_first();
    return begin_round();
  }

  // The same in blocks of cells that are near each other, for the sake of the cache; the worst one of a block comes
  // first in it.
  std::vector<Bad_cell> next_round_in_blocks(const std::size_t cells_per_block)
  {
    remove_what_is_not_bad();
    internal::sort_in_space(m_cells, [](const Bad_cell& c) { return internal::centroid(internal::corners(c.cell)); },
                            m_goes_on);
    auto end = m_cells.begin();
    while(end != m_cells.end() && m_goes_on())
    {
      const auto begin = end;
      end += (std::min)(static_cast<std::ptrdiff_t>(cells_per_block), m_cells.end() - begin);
      sort_worst_first(begin, end);
    }
    return begin_round();
  }

  // How many are in the list, with those that are gone or good.
  std::size_t size() const { return m_cells.size(); }

  // All of them as they are, some maybe gone or good. There is none left here.
  std::vector<Bad_cell> take() { return std::exchange(m_cells, std::vector<Bad_cell>()); }

  // How bad the cells of the last round were together.
  double badness() const { return m_badness; }

private:
  typedef typename std::vector<Bad_cell>::iterator Iterator;

  static void sort_worst_first(const Iterator begin, const Iterator end)
  {
    std::stable_sort(begin, end, [](const Bad_cell& x, const Bad_cell& y) { return x.quality < y.quality; });
  }

  // Takes out cells that are gone or good, and those that are there before.
  void remove_what_is_not_bad()
  {
    Unique_hash_map<Cell_handle, bool> is_there(false); // for looking up only
    std::vector<Bad_cell> cells;
    for(const Bad_cell& c : m_cells)
    {
      if(! m_goes_on())
        break;
      if(! is_in_domain(c.cell) || std::exchange(is_there[c.cell], true))
        continue;
      const double quality = m_mesh.quality(c.cell);
      if(quality < m_mesh.enough())
        cells.push_back(Bad_cell{ quality, c.cell, c.time });
    }
    m_cells.swap(cells);
  }

  std::vector<Bad_cell> begin_round()
  {
    m_badness = 0;
    for(const Bad_cell& c : m_cells)
      m_badness += m_mesh.badness(c.quality);
    return std::exchange(m_cells, std::vector<Bad_cell>());
  }

  const Mesh& m_mesh;
  const std::function<bool()> m_goes_on;
  std::vector<Bad_cell> m_cells;
  double m_badness = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_QUALITY_BAD_CELLS_3_H
