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
#include <CGAL/Boundary_recovery_3/internal/owners/Divide_vertices_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>

#include <cstddef>
#include <deque>
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

  // Of a domain with all its cells selected: so many parts of equal work, or one more. `work(v)` is what has to be done
  // at a finite vertex.
  template <typename Work>
  Owned_parts_3(Tr& tr, const Domain& domain, const std::size_t number, const int round, const Work& work)
    : m_tr(tr)
  {
    Divide_vertices_3<Vertex_handle> divide(round);
    for(const Vertex_handle v : tr.finite_vertex_handles())
      divide.add(v, work(v));
    const std::size_t number_of_parts = divide(number);
    for(std::size_t k = 0; k < number_of_parts; ++k)
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

  // Finds the vertices on the border, before the work begins. Calls `note(c, k)` for each cell of the domain, with the
  // position of its part, or `size()`.
  template <typename Note>
  void mark_border(const Domain& domain, const Note& note)
  {
    for(const Cell_handle c : m_tr.finite_cell_handles())
      if(domain.contains(c))
      {
        const std::size_t part = part_of(c);
        note(c, part);
        for(int i = 0; i < 4 && part == size(); ++i)
          internal::put_on_border(c->vertex(i));
      }
  }

private:
  Tr& m_tr;
  std::deque<Part> m_parts;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_OWNERS_OWNED_PARTS_3_H
