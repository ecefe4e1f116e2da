// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_VERTEX_OWNERS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_VERTEX_OWNERS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * While several threads change a mesh, each of them works on one part of it, and each vertex has an *owner*, one of the
 * parts. A cell is *inner* to the part that owns all its four vertices.
 *
 * A part looks for work in its inner cells only, and only it changes, removes or marks them. It also links the cells
 * behind their outer facets to new cells: such a cell has three vertices of the part, so no other part does anything to
 * it but to link another of its facets, of which there is none, as that would have three vertices of the other part. So
 * no thread reads what another one writes, and nothing has to be locked.
 *
 * A vertex is on the *border* if one of its cells is not inner. These cells stay, and so does the vertex.
 */
typedef std::uint16_t Part_number; // from 1 on; 0: none

// Whether vertices have a place for it.
template <typename Vertex, typename = void>
struct Has_part : std::false_type { };

template <typename Vertex>
struct Has_part<Vertex, std::void_t<decltype(std::declval<Vertex&>().set_part(std::declval<const Vertex&>().part()))> >
  : std::true_type
{ };

// The highest bit tells of the border.
constexpr Part_number border_bit = 0x8000;
constexpr Part_number max_number_of_parts = border_bit - 1;

template <typename Vertex_handle>
Part_number owner(const Vertex_handle v) { return Part_number(v->part() & max_number_of_parts); }

template <typename Vertex_handle>
bool is_on_border(const Vertex_handle v) { return (v->part() & border_bit) != 0; }

// The part that a cell is inner to; 0: none.
template <typename Cell>
Part_number owner_of_cell(const Cell& c)
{
  const Part_number part = internal::owner(c.vertex(0));
  return internal::owner(c.vertex(1)) == part && internal::owner(c.vertex(2)) == part
      && internal::owner(c.vertex(3)) == part ? part : Part_number(0);
}

// All vertices of a cell that is inner to no part.
template <typename Cell>
void put_on_border(const Cell& c)
{
  for(int i = 0; i < 4; ++i)
    c.vertex(i)->set_part(Part_number(c.vertex(i)->part() | border_bit));
}

// Whether the vertices of a facet of a cell are on the border. If not, the cell behind it is inner to the same part.
template <typename Cell>
bool is_facet_on_border(const Cell& c, const int i)
{
  return internal::is_on_border(c.vertex((i + 1) & 3)) && internal::is_on_border(c.vertex((i + 2) & 3))
      && internal::is_on_border(c.vertex((i + 3) & 3));
}

// Whether a cell has a vertex on the border.
template <typename Cell>
bool is_at_border(const Cell& c)
{
  return internal::is_on_border(c.vertex(0)) || internal::is_on_border(c.vertex(1))
      || internal::is_on_border(c.vertex(2)) || internal::is_on_border(c.vertex(3));
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESH_VERTEX_OWNERS_H
