// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_PARTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_PARTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Encroached_walls_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Fill_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Divide_space_3.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Owned_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/circumsphere.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Region_sizes_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Fills parts of a domain at the same time. Borders are filled first: the domain is cut into halves, these into
 * quarters, and so on, and before each cut, the cells at that place are made as small as all cells are to be. Thus
 * borders hardly ever hinder the points of the parts. Points that would change something beyond a border are put off to
 * another round with other borders; what is left is done by one thread.
 */
template <typename Tr>
class Fill_parts_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef std::vector<Cell_handle>   Cells;
  typedef Selected_domain_3<Tr>      Domain;
  typedef Region_sizes_3<Tr>         Sizes;
  typedef Fill_domain_3<Tr>          Fill_domain;

  // `fill` is that for the domain as a whole.
  Fill_parts_3(Tr& tr, Domain& domain, Sizes& sizes, Recovery_context<Tr>& context, Fill_domain& fill)
    : m_tr(tr), m_domain(domain), m_sizes(sizes), m_rounds(tr, context, least_share), m_fill(fill)
  { }

  // Fills the domain, which has these cells, see `Fill_domain_3`.
  void operator()(const Cells& cells, const std::size_t number_of_parts, const std::size_t expected_number)
  {
    m_walls = m_fill.large_walls(cells);
    m_expected_number = expected_number;
    m_fill.begin(m_walls, m_tr.number_of_vertices(), no_limit, expected_number);
    fill_from_borders(cells, number_of_parts);
    for(int round = 1; m_rounds.pays(round, m_put_off.size()) && m_fill.can_go_on(); ++round)
      fill_rest(number_of_parts, round);
    m_fill.fill(m_put_off);
    m_fill.shorten_long_edges();
  }

private:
  typedef Owned_parts_3<Tr>            Parts;
  typedef Rounds_of_parts_3<Tr>        Rounds;
  typedef Divide_space_3::Cut          Cut;
  typedef std::array<Coordinates_3, 4> Corners;

  static constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)(); // of the number of vertices

  // See "Tuning constants" in the manual.
  static constexpr double least_share = 0.15;  // of cells that wait in the number of vertices
  static constexpr double likely_growth = 0.2; // of sizes
  static constexpr double nearly_cut = 0.25;   // distance from a cut, in the width of a cell
  static constexpr std::size_t pieces_per_part = 500; // of which each is added to the work as a whole
  static constexpr double points_per_piece = 0.1; // at least

  // The work on one part, by a thread.
  struct Task
  {
    Task(typename Parts::Part& part, const Sizes& whole, Rounds& rounds)
      : context(rounds), sizes(whole, Part_of_sizes()), fill(part.triangulation(), part.domain(), sizes, context)
    { }

    typename Rounds::Task_context context;
    Sizes sizes;
    Fill_domain fill;
  };

  // The cells that are to be looked at, by the first cut of a tree that they are at: for each depth those of the
  // parts there, and at last those that are at none.
  class Waiting_cells
  {
  public:
    explicit Waiting_cells(const Divide_space_3& divide)
      : m_divide(divide), m_cells(divide.depth() + 1, std::vector<Cells>(divide.number_of_parts()))
    { }

    std::vector<Cells>& operator[](const int depth) { return m_cells[depth]; }

    // All cells of the domain, by all threads.
    void add(const Cells& cells)
    {
      typedef std::pair<std::size_t, Cell_handle> Placed_cell;
      internal::take_each(cells, [this](const Cell_handle c) { return std::optional(Placed_cell(place_of(c), c)); },
                          [this](const Placed_cell& c) { list(c.first).push_back(c.second); },
                          Concurrency_tag_of<Tr>());
    }

    // Those that are still there, in this domain, and only at cuts of a larger depth.
    void add(const Cells& cells, const Fill_domain& fill, const Domain& domain, const int depth)
    {
      for(const Cell_handle c : cells)
        if(fill.is_there(c) && domain.contains(c))
        {
          const std::size_t place = place_of(c);
          if(place >= (depth + 1) * m_divide.number_of_parts())
            list(place).push_back(c);
        }
    }

  private:
    // The number of a list.
    std::size_t place_of(const Cell_handle c) const
    {
      Part_number part = 1;
      int depth = 0;
      const Cut* cut = m_divide.cut_of(part, depth);
      while(cut != nullptr && ! is_at_cut(*cut, c))
      {
        part = is_before(*cut, c) ? part : cut->second_half;
        cut = m_divide.cut_of(part, ++depth);
      }
      return (cut == nullptr ? m_divide.depth() : depth) * m_divide.number_of_parts() + part - 1;
    }

    Cells& list(const std::size_t place)
    {
      return m_cells[place / m_divide.number_of_parts()][place % m_divide.number_of_parts()];
    }

    const Divide_space_3& m_divide;
    std::vector<std::vector<Cells> > m_cells;
  };

  void fill_from_borders(const Cells& all_cells, const std::size_t number_of_parts)
  {
    const Divide_space_3 divide = divided_space(all_cells, number_of_parts, [](const Corners&) { return true; });
    Waiting_cells cells(divide);
    cells.add(all_cells);
    fill_first_cut(*divide.cut_of(1, 0), cells);
    for(int depth = 1; depth <= divide.depth() && m_fill.can_go_on(); ++depth)
    {
      Parts parts(m_tr, m_domain, divide, depth);
      forget_gone_cells(parts, cells[depth]);
      work_on(parts, cells[depth], [&](Task& task, const std::size_t k)
      {
        const Cut* const cut = divide.cut_of(static_cast<Part_number>(k + 1), depth);
        if(cut == nullptr)
          return task.fill.fill(cells[depth][k]);
        const auto concerns = [cut](const Cell_handle c) { return is_at_cut(*cut, c); };
        cells.add(task.fill.fill(cells[depth][k], concerns), task.fill, parts[k].domain(), depth);
      });
    }
  }

  // What came to the places of cells that are gone may be in other parts, and must not be looked at while those are
  // worked on.
  void forget_gone_cells(Parts& parts, std::vector<Cells>& cells)
  {
    const std::vector<std::size_t> weights(cells.size(), 1);
    internal::for_each_task(weights, [&](const std::size_t k)
    {
      const auto is_gone = [&](const Cell_handle c)
      {
        return ! m_fill.is_there(c) || ! parts[k].domain().contains(c);
      };
      cells[k].erase(std::remove_if(cells[k].begin(), cells[k].end(), is_gone), cells[k].end());
    }, Concurrency_tag_of<Tr>());
  }

  // There is only one part that the first cut goes through. So the cells there are filled in two parts at the same
  // time, after those where the border of these meets the cut.
  void fill_first_cut(const Cut& cut, Waiting_cells& waiting)
  {
    std::vector<Cells> cells = { std::exchange(waiting[0].front(), Cells()), Cells() };
    const Divide_space_3 divide = divided_space(cells[0], 2, [&](const Corners& p) { return is_at_cut(cut, p); });
    const Cut& border = *divide.cut_of(1, 0);
    const auto fill = [&](const int depth, const auto& concerns)
    {
      Parts parts(m_tr, m_domain, divide, depth);
      work_on(parts, cells, [&](Task& task, const std::size_t k) { cells[k] = task.fill.fill(cells[k], concerns); });
    };
    fill(0, [&](const Cell_handle c) { return is_at_cut(cut, c) && is_at_cut(border, c); });
    Cells left;
    for(const Cell_handle c : std::exchange(cells[0], Cells()))
      if(m_fill.is_there(c))
        (is_at_cut(border, c) ? left : cells[is_before(border, c) ? 0 : 1]).push_back(c);
    fill(1, [&](const Cell_handle c) { return is_at_cut(cut, c); });
    waiting.add(left, m_fill, m_domain, 0);
    waiting.add(cells[0], m_fill, m_domain, 0);
    waiting.add(cells[1], m_fill, m_domain, 0);
  }

  // What was put off, in parts with other borders.
  void fill_rest(const std::size_t number_of_parts, const int round)
  {
    Parts parts(m_tr, m_domain, number_of_parts, round);
    std::vector<Cells> cells(parts.size() + 1);
    for(const Cell_handle c : m_put_off)
      if(m_fill.is_there(c) && m_domain.contains(c))
        cells[parts.part_of(c)].push_back(c);
    m_put_off = std::move(cells.back());
    cells.pop_back();
    work_on(parts, cells, [&](Task& task, const std::size_t k) { task.fill.fill(cells[k]); });
  }

  // `work(task, k)` is done for each part, which has these cells.
  template <typename Work>
  void work_on(Parts& parts, const std::vector<Cells>& cells, const Work& work)
  {
    parts.mark_border(m_domain);
    const std::size_t number_of_empty_parts = std::size_t(std::count(cells.begin(), cells.end(), Cells()));
    const std::size_t number_of_vertices = m_tr.number_of_vertices() / (1 + parts.size() - number_of_empty_parts);
    std::vector<std::size_t> amounts;
    std::deque<Task> tasks;
    for(std::size_t k = 0; k < parts.size(); ++k)
    {
      tasks.emplace_back(parts[k], m_sizes, m_rounds);
      tasks.back().fill.begin(m_walls, number_of_vertices, no_limit, 0);
      amounts.push_back(cells[k].size());
    }
    m_rounds.visitor().begin(Phase::field_point_insertion, m_fill.vertices().size(), m_expected_number);
    m_rounds(amounts, [&](const std::size_t k)
    {
      work(tasks[k], k);
      m_rounds.visitor().end_task(tasks[k].fill.vertices().size());
    });
    for(const Task& task : tasks)
    {
      m_fill.take_over(task.fill);
      m_sizes.take_over(task.sizes);
      m_put_off.insert(m_put_off.end(), task.fill.cells_put_off().begin(), task.fill.cells_put_off().end());
    }
  }

  // Whether the cut goes through the cell, or passes so near that its points would change something beyond it.
  static bool is_at_cut(const Cut& cut, const Corners& corners)
  {
    const auto [first, last] = std::minmax({ cut.place_of(corners[0]), cut.place_of(corners[1]),
                                             cut.place_of(corners[2]), cut.place_of(corners[3]) });
    const double distance = nearly_cut * (last - first);
    return first - distance < cut.place && last + distance >= cut.place;
  }

  static bool is_at_cut(const Cut& cut, const Cell_handle c) { return is_at_cut(cut, internal::corners(c)); }

  // If it is not at the cut.
  static bool is_before(const Cut& cut, const Cell_handle c)
  {
    return cut.is_before(internal::coordinates_of(c->vertex(0)->point()));
  }

  // The work is about the number of points. Large cells have it everywhere inside, so they are cut into pieces; of
  // several small ones, one stands for all. It is only where it `concerns(corners)` of such a piece.
  template <typename Concerns>
  Divide_space_3 divided_space(const Cells& cells, const std::size_t number_of_parts, const Concerns& concerns)
  {
    double volume = 0;
    for(const Cell_handle c : cells)
      volume += std::abs(internal::volume_times_6(internal::corners(c)));
    const std::size_t number_of_pieces = number_of_parts * pieces_per_part;
    Divide_space_3 divide(number_of_parts, 0);
    const std::size_t several = 1 + cells.size() / number_of_pieces;
    for(const Cell_handle c : cells)
    {
      const Corners corners = internal::corners(c);
      const double volume_of_cell = std::abs(internal::volume_times_6(corners));
      if(volume_of_cell > volume / double(number_of_pieces))
        add_pieces(c, corners, volume_of_cell, volume / double(number_of_pieces), concerns, divide);
      else if(concerns(corners))
        divide.add_one_of(several, number_of_points(volume_of_cell,
                                                    m_sizes.likely_size_at_centroid(c, corners, likely_growth)),
                          [&] { return internal::centroid(corners); });
    }
    divide();
    return divide;
  }

  // Of a cell, or a part of one.
  template <typename Concerns>
  void add_pieces(const Cell_handle c, const Corners& corners, const double volume, const double largest_volume,
                  const Concerns& concerns, Divide_space_3& divide)
  {
    if(! concerns(corners))
      return;
    if(volume <= largest_volume)
    {
      const Coordinates_3 center = internal::centroid(corners);
      return divide.add(center, number_of_points(volume, m_sizes(center, c).possible));
    }
    const Tetrahedron_edge_3 edge = internal::longest_edge(corners);
    for(const int end : { edge.i, edge.j })
    {
      Corners half = corners;
      half[end] = internal::midpoint(corners[edge.i], corners[edge.j]);
      add_pieces(c, half, volume / 2, largest_volume, concerns, divide);
    }
  }

  static double number_of_points(const double volume, const double size)
  {
    return size > 0 ? volume / (size * size * size) + points_per_piece : 0;
  }

  Tr& m_tr;
  Domain& m_domain;
  Sizes& m_sizes;
  Rounds m_rounds;
  Fill_domain& m_fill;
  Encroached_walls_3 m_walls; // the large ones
  std::size_t m_expected_number = 0;
  Cells m_put_off; // that have to be looked at in another round
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_FILLING_FILL_PARTS_3_H
