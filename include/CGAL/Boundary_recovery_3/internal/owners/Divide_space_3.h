// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_DIVIDE_SPACE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_DIVIDE_SPACE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Divides space into parts of equal work by *recursive coordinate bisection*: the box of the work is cut across its
 * longest side, so that both halves have the work of their parts, and so on. Parts are compact, and have few vertices
 * on their borders.
 *
 * Parts are the leaves of a tree of cuts. At a smaller depth, there are fewer and larger parts: each has the number of
 * the first one of those that it will be cut into.
 *
 * Each round of work has axes of its own, so that its borders are elsewhere: they meet those of another round only
 * where two planes meet. In a long body, all axes put the vertices into the same order; so the borders of each round
 * are also shifted by a part of the work of a part.
 */
class Divide_space_3
{
public:
  // A plane between the halves of a part.
  struct Cut
  {
    Coordinates_3 normal;
    double        place = 0;
    Part_number   second_half = 0; // the first one has the number of the part

    double place_of(const Coordinates_3& p) const { return dot_product(normal, p); }
    bool is_before(const Coordinates_3& p) const { return place_of(p) < place; }
  };

  // Into parts with the work of one of `number` equal ones. If a round is shifted, there is one more: the first and the
  // last one share the work of one of these.
  Divide_space_3(const std::size_t number, const int round)
    : m_number(number), m_axes(axes_of_round(round)), m_shift(shift_of_round(round)), m_cuts(number_of_parts())
  { }

  std::size_t number_of_parts() const { return m_shift > 0 ? m_number + 1 : m_number; }

  // That of the whole tree.
  int depth() const
  {
    int depth = 0;
    while((std::size_t(1) << depth) < number_of_parts())
      ++depth;
    return depth;
  }

  // There is that much to do around a point.
  void add(const Coordinates_3& p, const double work) { m_items.push_back(Item{ place(p), work }); }

  // The same for each of many places, which follow one another and are mostly near each other: of `number` of them,
  // `place()` of the last one stands for all.
  template <typename Place>
  void add_one_of(const std::size_t number, const double work, const Place& place)
  {
    m_work_of_several += work;
    if(++m_number_of_several % number == 0)
      add(place(), std::exchange(m_work_of_several, 0));
  }

  // To be called when all work was added.
  void operator()() { divide(m_items.begin(), m_items.end(), Range{ 0, number_of_parts() }); }

  // The part, from 1 on, that a point is in.
  Part_number part_of(const Coordinates_3& p) const { return part_of(p, depth()); }

  // The same at a smaller depth.
  Part_number part_of(const Coordinates_3& p, const int depth) const
  {
    Range range = { 0, number_of_parts() };
    for(int k = 0; k < depth && range.size() > 1; ++k)
      range = half(range, m_cuts[range.middle()].is_before(p));
    return number_of(range);
  }

  // What a part of this depth is cut by. None: it is so small that it stays as it is.
  const Cut* cut_of(const Part_number part, const int depth) const
  {
    Range range = { 0, number_of_parts() };
    for(int k = 0; k < depth && range.size() > 1; ++k)
      range = half(range, part <= range.middle());
    return range.size() > 1 ? &m_cuts[range.middle()] : nullptr;
  }

private:
  struct Item
  {
    Coordinates_3 place;
    double work;
  };

  // Of leaves.
  struct Range
  {
    std::size_t first, last; // the last one is the one behind them

    std::size_t size() const { return last - first; }
    std::size_t middle() const { return (first + last) / 2; }
  };

  typedef std::vector<Item>::iterator  Iterator;
  typedef std::array<Coordinates_3, 3> Axes;

  static Range half(const Range& r, const bool is_first)
  {
    return is_first ? Range{ r.first, r.middle() } : Range{ r.middle(), r.last };
  }

  static Part_number number_of(const Range& r) { return static_cast<Part_number>(r.first + 1); }

  Coordinates_3 place(const Coordinates_3& p) const
  {
    return {{ dot_product(m_axes[0], p), dot_product(m_axes[1], p), dot_product(m_axes[2], p) }};
  }

  static double shift_of_round(const int round)
  {
    static constexpr std::array<double, 4> shifts = {{ 0, 0.5, 0.25, 0.75 }};
    return shifts[static_cast<std::size_t>(round) % shifts.size()];
  }

  // Orthogonal, and all of the same length; those of the later ones are turned, each in another way.
  static Axes axes_of_round(const int round)
  {
    static const Axes axes[] = {
      {{ {{ 3, 0, 0 }}, {{ 0, 3, 0 }}, {{ 0, 0, 3 }} }},
      {{ {{ 1, 2, 2 }}, {{ 2, 1, -2 }}, {{ 2, -2, 1 }} }},
      {{ {{ -1, 2, 2 }}, {{ 2, -1, 2 }}, {{ 2, 2, -1 }} }},
      {{ {{ 1, -2, 2 }}, {{ -2, 1, 2 }}, {{ 2, 2, 1 }} }}
    };
    return axes[round % 4];
  }

  void divide(const Iterator begin, const Iterator end, const Range& range)
  {
    if(range.size() == 1)
      return;
    const std::size_t axis = longest_side(begin, end);
    const double place = place_of_cut(begin, end, axis, (work_before(range.middle()) - work_before(range.first)) /
                                                        (work_before(range.last) - work_before(range.first)));
    const Iterator middle = std::partition(begin, end, [&](const Item& item) { return item.place[axis] < place; });
    m_cuts[range.middle()] = { m_axes[axis], place, number_of(half(range, false)) };
    divide(begin, middle, half(range, true));
    divide(middle, end, half(range, false));
  }

  // The work of all parts before this position, in the work of an ordinary one.
  double work_before(const std::size_t part) const
  {
    return (std::min)((std::max)(double(part) - m_shift, 0.), double(m_number));
  }

  // Where the second half begins, if the first one is to have that share of the work; infinity if nowhere. Each step
  // sorts half of the items that the last one did, so all of them take linear time.
  static double place_of_cut(const Iterator begin, const Iterator end, const std::size_t axis, const double share)
  {
    const double target = share * work(begin, end);
    Iterator first = begin, last = end;
    double before = 0;
    while(last - first > 1)
    {
      const Iterator middle = first + (last - first) / 2;
      std::nth_element(first, middle, last,
                       [axis](const Item& x, const Item& y) { return x.place[axis] < y.place[axis]; });
      const double up_to_middle = before + work(first, middle);
      if(up_to_middle < target)
      {
        before = up_to_middle;
        first = middle;
      }
      else
        last = middle;
    }
    return last == end ? std::numeric_limits<double>::infinity() : last->place[axis];
  }

  static double work(const Iterator begin, const Iterator end)
  {
    double sum = 0;
    for(Iterator item = begin; item != end; ++item)
      sum += item->work;
    return sum;
  }

  static std::size_t longest_side(const Iterator begin, const Iterator end)
  {
    Axis_box_3 box;
    for(Iterator item = begin; item != end; ++item)
      box.add(item->place);
    const Coordinates_3 sides = difference(box.upper, box.lower);
    return static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  const std::size_t m_number;
  const Axes m_axes;
  const double m_shift;
  std::vector<Item> m_items;
  double m_work_of_several = 0; // that were not added yet
  std::size_t m_number_of_several = 0;
  std::vector<Cut> m_cuts; // between the parts before and from a position on
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_DIVIDE_SPACE_3_H
