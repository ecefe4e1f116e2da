// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_OWNED_PARTS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_OWNED_PARTS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Unit_frame_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Divides space into parts of equal work by *recursive coordinate bisection*: the box of the work is cut across its
 * longest side, so that both halves have the work of their parts, and so on. Parts are compact, and have few vertices
 * on their borders.
 *
 * Each round of work has axes of its own, so that its borders are elsewhere: they meet those of another round only
 * where two planes meet. In a long body, all axes put the vertices into the same order; so the borders of each round
 * are also shifted by a part of the work of a part.
 */
class Divide_space_3
{
public:
  // Into parts with the work of one of `number` equal ones. If a round is shifted, there is one more: the first and the
  // last one share the work of one of these.
  Divide_space_3(const std::size_t number, const int round)
    : m_number(number), m_axes(axes_of_round(round)), m_shift(shift_of_round(round)), m_cuts(number_of_parts())
  { }

  std::size_t number_of_parts() const { return m_shift > 0 ? m_number + 1 : m_number; }

  // There is that much to do around a point.
  void add(const Coordinates_3& p, const double work) { m_items.push_back(Item{ place(p), work, m_items.size() }); }

  // To be called when all work was added.
  void operator()() { divide(m_items.begin(), m_items.end(), 0, number_of_parts()); }

  // The part, from 1 on, that a point is in.
  Part_number part_of(const Coordinates_3& p) const
  {
    const Coordinates_3 q = place(p);
    std::size_t first = 0, last = number_of_parts();
    while(last - first > 1)
    {
      const std::size_t half = (first + last) / 2;
      (q[m_cuts[half].axis] < m_cuts[half].place ? last : first) = half;
    }
    return static_cast<Part_number>(last);
  }

private:
  struct Item
  {
    Coordinates_3 place;
    double work;
    std::size_t number; // so that the order of equal places is known
  };

  // Between the parts before and from a position on.
  struct Cut
  {
    std::size_t axis = 0;
    double      place = 0;
  };

  typedef std::vector<Item>::iterator  Iterator;
  typedef std::array<Coordinates_3, 3> Axes;

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

  // Of the positions of the parts, the last one is the one behind them.
  void divide(const Iterator begin, const Iterator end, const std::size_t first_part, const std::size_t last_part)
  {
    if(last_part - first_part == 1)
      return;
    const std::size_t half = (first_part + last_part) / 2;
    const std::size_t axis = longest_side(begin, end);
    const Iterator middle = split(begin, end, axis, (work_before(half) - work_before(first_part)) /
                                                    (work_before(last_part) - work_before(first_part)));
    m_cuts[half] = { axis, middle == end ? std::numeric_limits<double>::infinity() : middle->place[axis] };
    divide(begin, middle, first_part, half);
    divide(middle, end, half, last_part);
  }

  // The work of all parts before this position, in the work of an ordinary one.
  double work_before(const std::size_t part) const
  {
    return (std::min)((std::max)(double(part) - m_shift, 0.), double(m_number));
  }

  // Returns where the second half begins, if the first one is to have that share of the work. Each step sorts half of
  // the items that the last one did, so all of them take linear time.
  static Iterator split(const Iterator begin, const Iterator end, const std::size_t axis, const double share)
  {
    const double target = share * work(begin, end);
    Iterator first = begin, last = end;
    double before = 0;
    while(last - first > 1)
    {
      const Iterator middle = first + (last - first) / 2;
      std::nth_element(first, middle, last, [axis](const Item& x, const Item& y)
      {
        return x.place[axis] < y.place[axis] || (x.place[axis] == y.place[axis] && x.number < y.number);
      });
      const double up_to_middle = before + work(first, middle);
      if(up_to_middle < target)
      {
        before = up_to_middle;
        first = middle;
      }
      else
        last = middle;
    }
    return last;
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
  std::vector<Cut> m_cuts;
};

/*
 * What one thread at a time works on: the inner cells of a part of a mesh, see `vertex_owners.h`, as a domain of its
 * own, whose walls are the facets behind which there are other cells.
 *
 * The part has a triangulation with containers of its own. What is created there is linked to the cells of the whole
 * mesh, and what is deleted there may come from the whole mesh: its place is for new cells of this part. Handles do not
 * know containers, so nobody notices. At last, the containers of the whole mesh take over those of the part. Thus no
 * thread waits for another one, and where cells are does not depend on what other threads do.
 *
 * The containers of a part cannot tell how much they have, nor go through it, as they count what went and came only.
 */
template <typename Tr>
class Owned_part_3
{
public:
  typedef Selected_domain_3<Tr> Domain;

  Owned_part_3(Tr& whole, const Domain& domain, const Part_number number)
    : m_tr(whole.geom_traits()), m_domain(domain)
  {
    m_domain.select_part(number);
    m_tr.tds().clear();
    m_tr.tds().set_dimension(3);
    m_tr.set_infinite_vertex(whole.infinite_vertex());
  }

  Tr& triangulation() { return m_tr; }
  Domain& domain() { return m_domain; }

  // The time is that for the free places of the part.
  void give_back(Tr& whole)
  {
    take_over(whole.tds().cells(), m_tr.tds().cells());
    take_over(whole.tds().vertices(), m_tr.tds().vertices());
  }

private:
  // A merge goes through the free places of the container that stays, so that one is the smaller one.
  template <typename Container>
  static void take_over(Container& whole, Container& part)
  {
    whole.swap(part);
    whole.merge(part);
  }

  Tr m_tr;
  Domain m_domain;
};

/*
 * The parts of a mesh in one round of work: the vertices are divided anew, then tasks work on all parts at the same
 * time, each on one of them. The result depends on the number of parts, not on that of threads.
 */
template <typename Tr>
class Owned_parts_3
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Tr::Cell_handle   Cell_handle;
  typedef Selected_domain_3<Tr>      Domain;
  typedef Owned_part_3<Tr>           Part;

  // Of a domain with all its cells selected: so many parts of equal work, or one more. `work(v)` is what has to be done
  // at a finite vertex.
  template <typename Work>
  Owned_parts_3(Tr& tr, const Domain& domain, const std::size_t number, const int round, const Work& work)
    : m_tr(tr)
  {
    const Divide_space_3 divide = divided_space(number, round, work);
    for(const Vertex_handle v : tr.finite_vertex_handles())
      v->set_part(divide.part_of(internal::coordinates_of(v->point())));
    for(std::size_t k = 0; k < divide.number_of_parts(); ++k)
      m_parts.emplace_back(tr, domain, static_cast<Part_number>(k + 1));
  }

  Owned_parts_3(const Owned_parts_3&) = delete;
  Owned_parts_3& operator=(const Owned_parts_3&) = delete;

  // The mesh is whole again, also if a task threw.
  ~Owned_parts_3()
  {
    for(Part& part : m_parts)
      part.give_back(m_tr);
  }

  std::size_t size() const { return m_parts.size(); }

  Part& operator[](const std::size_t k) { return m_parts[k]; }

  // The position of the part that a cell is inner to; `size()` if there is none.
  std::size_t part_of(const Cell_handle c) const
  {
    const Part_number owner = internal::owner_of_cell(*c);
    return owner == 0 ? size() : owner - std::size_t(1);
  }

  // Finds the vertices on the border, before the work begins.
  void mark_border(const Domain& domain)
  {
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(domain.contains(c) && part_of(c) == size())
        for(int i = 0; i < 4; ++i)
          internal::put_on_border(c->vertex(i));
  }

private:
  static constexpr std::size_t vertices_per_part = 2000; // that the work of others is added to

  // Vertices that follow one another are mostly near each other: of several, one stands for all.
  template <typename Work>
  Divide_space_3 divided_space(const std::size_t number, const int round, const Work& work) const
  {
    Divide_space_3 divide(number, round);
    const std::size_t step = 1 + m_tr.number_of_vertices() / (number * vertices_per_part);
    double sum = 0;
    std::size_t k = 0;
    for(const Vertex_handle v : m_tr.finite_vertex_handles())
    {
      sum += work(v);
      if(++k % step == 0)
        divide.add(internal::coordinates_of(v->point()), std::exchange(sum, 0));
    }
    divide();
    return divide;
  }

  Tr& m_tr;
  std::deque<Part> m_parts;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_OWNED_PARTS_3_H
