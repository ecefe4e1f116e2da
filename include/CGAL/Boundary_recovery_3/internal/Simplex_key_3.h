// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIMPLEX_KEY_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIMPLEX_KEY_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Hash_index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Keys of edges and facets in hash tables: the addresses of the vertices, in increasing order.
 * Such tables are for look-up only. Nobody may iterate over them, since that order changes from run to run.
 */
template <std::size_t N>
using Simplex_key_3 = std::array<const void*, N>;

template <typename Vertex_handle>
Simplex_key_3<2> simplex_key(const Vertex_handle u, const Vertex_handle v)
{
  const void* p = &*u;
  const void* q = &*v;
  return std::less<const void*>()(p, q) ? Simplex_key_3<2>{{p, q}} : Simplex_key_3<2>{{q, p}};
}

template <typename Vertex_handle>
Simplex_key_3<3> simplex_key(const Vertex_handle u, const Vertex_handle v, const Vertex_handle w)
{
  Simplex_key_3<3> key = {{ &*u, &*v, &*w }};
  const std::less<const void*> less;
  if(less(key[1], key[0])) std::swap(key[0], key[1]);
  if(less(key[2], key[1])) std::swap(key[1], key[2]);
  if(less(key[1], key[0])) std::swap(key[0], key[1]);
  return key;
}

struct Simplex_key_hash
{
  template <std::size_t N>
  std::uint64_t operator()(const Simplex_key_3<N>& key) const
  {
    std::uint64_t h = 0;
    for(const void* p : key)
      h = mixed_bits(h ^ reinterpret_cast<std::uintptr_t>(p));
    return h;
  }
};

template <typename Vertex_handle>
Simplex_key_3<2> simplex_key(const std::array<Vertex_handle, 2>& edge)
{
  return internal::simplex_key(edge[0], edge[1]);
}

template <typename Vertex_handle>
Simplex_key_3<3> simplex_key(const std::array<Vertex_handle, 3>& facet)
{
  return internal::simplex_key(facet[0], facet[1], facet[2]);
}

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIMPLEX_KEY_3_H
