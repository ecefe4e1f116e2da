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
#include <CGAL/Boundary_recovery_3/internal/owners/Divide_space_3.h>
#include <CGAL/Boundary_recovery_3/internal/shape/distances_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

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

  // Of a domain with all its cells selected, whose vertices have owners: so many parts.
  Owned_parts_3(Tr& tr, const Domain& domain, const std::size_t number)
    : m_tr(tr)
  {
    create_parts(number, domain);
  }

  // The vertices get owners anew: so many parts with as many vertices each, or one more.
  Owned_parts_3(Tr& tr, const Domain& domain, const std::size_t number, const int round)
    : Owned_parts_3(tr, domain, divide(tr, number, round))
  { }

  // The parts at a depth of a tree of cuts.
  Owned_parts_3(Tr& tr, const Domain& domain, const Divide_space_3& divide, const int depth)
    : m_tr(tr)
  {
    set_parts(tr, divide, depth);
    create_parts(divide.number_of_parts(), domain);
  }

  // Gives the vertices such owners, and returns how many parts there are.
  static std::size_t divide(Tr& tr, const std::size_t number, const int round)
  {
    const Divide_space_3 divide = divided_space(tr, number, round);
    set_parts(tr, divide, divide.depth());
    return divide.number_of_parts();
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
    std::vector<Cell_handle> border; // to be marked when nobody reads the owners of vertices any more
    internal::take_each(m_tr.all_cell_handles(), [&domain](const Cell_handle c)
    {
      return internal::owner_of_cell(*c) == 0 && domain.contains(c) ? std::make_optional(c) : std::nullopt;
    }, [&border](const Cell_handle c) { border.push_back(c); }, Concurrency_tag_of<Tr>());
    for(const Cell_handle c : border)
      internal::put_on_border(*c);
  }

private:
  static constexpr std::size_t vertices_per_part = 2000; // that the work of others is added to

  // By all threads.
  static void set_parts(Tr& tr, const Divide_space_3& divide, const int depth)
  {
    const auto set_part = [&](const Vertex_handle v)
    {
      v->set_part(divide.part_of(internal::coordinates_of(v->point()), depth));
    };
    internal::for_each_handle(tr.finite_vertex_handles(), set_part, Concurrency_tag_of<Tr>());
  }

  void create_parts(const std::size_t number, const Domain& domain)
  {
    for(std::size_t k = 0; k < number; ++k)
      m_parts.emplace_back(m_tr, domain, static_cast<Part_number>(k + 1));
  }

  static Divide_space_3 divided_space(const Tr& tr, const std::size_t number, const int round)
  {
    Divide_space_3 divide(number, round);
    const std::size_t several = 1 + tr.number_of_vertices() / (number * vertices_per_part);
    for(const Vertex_handle v : tr.finite_vertex_handles())
      divide.add_one_of(several, 1, [v] { return internal::coordinates_of(v->point()); });
    divide();
    return divide;
  }

  Tr& m_tr;
  std::deque<Part> m_parts;
};

/*
 * The rounds of work on the parts of a mesh, whatever the work is.
 */
template <typename Tr>
class Rounds_of_parts_3
{
public:
  // The context of a task, which stops when that of the whole work does.
  struct Task_context
    : public Recovery_context<Tr>
  {
    explicit Task_context(Rounds_of_parts_3& rounds)
      : Recovery_context<Tr>(rounds.m_visitor)
    {
      this->set_maximum_running_time(rounds.m_context.seconds_left());
    }
  };

  // A round pays for that many items, as a share of the number of vertices. Where fewer are left, one thread does it
  // sooner than the mesh is divided.
  Rounds_of_parts_3(const Tr& tr, Recovery_context<Tr>& context, const double least_share)
    : m_tr(tr), m_context(context), m_visitor(context.visitor()), m_least_share(least_share)
  { }

  Part_visitor_3<Tr>& visitor() { return m_visitor; }

  bool pays(const int round, const std::size_t number_of_items)
  {
    return round < max_number_of_rounds
        && double(number_of_items) > m_least_share * double(m_tr.number_of_vertices()) && m_context.go_further();
  }

  // Does `work(k)` for all tasks, at the same time.
  void operator()(const std::vector<std::size_t>& amounts, const std::function<void(std::size_t)>& work)
  {
    internal::for_each_task(amounts, work, Concurrency_tag_of<Tr>());
    if(m_visitor.is_stopped())
      m_context.stop();
  }

private:
  static constexpr int max_number_of_rounds = 4; // see "Tuning constants" in the manual

  const Tr& m_tr;
  Recovery_context<Tr>& m_context;
  Part_visitor_3<Tr> m_visitor;
  const double m_least_share;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_OWNED_PARTS_3_H
