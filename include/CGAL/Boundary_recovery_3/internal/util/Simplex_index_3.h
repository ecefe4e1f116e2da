// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_SIMPLEX_INDEX_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_SIMPLEX_INDEX_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/Hash_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// What a vertex, given by its handle or its index, adds to the sum that the hash value of a simplex is made of.
template <typename Handle>
std::uint64_t hash_share(const Handle v) { return mixed_bits(reinterpret_cast<std::uintptr_t>(&*v)); }

inline std::uint64_t hash_share(const std::size_t v) { return mixed_bits(v); }

// The same for all orders of the vertices.
struct Simplex_hash
{
  template <typename Vertex, std::size_t N>
  std::uint64_t operator()(const std::array<Vertex, N>& simplex) const
  {
    std::uint64_t sum = 0;
    for(const Vertex v : simplex)
      sum += internal::hash_share(v);
    return mixed_bits(sum);
  }
};

// Whether two simplices have the same vertices. There are no branches, for nobody could predict which order it is.

template <typename Vertex>
bool is_permutation(const std::array<Vertex, 1>& x, const std::array<Vertex, 1>& y) { return x[0] == y[0]; }

template <typename Vertex>
bool is_permutation(const std::array<Vertex, 2>& x, const std::array<Vertex, 2>& y)
{
  const auto is_same = [&](const int i, const int j) -> unsigned { return x[i] == y[j]; };
  return ((is_same(0, 0) & is_same(1, 1)) | (is_same(0, 1) & is_same(1, 0))) != 0;
}

template <typename Vertex>
bool is_permutation(const std::array<Vertex, 3>& x, const std::array<Vertex, 3>& y)
{
  const auto is_same = [&](const int i, const int j) -> unsigned { return x[i] == y[j]; };
  const auto is_order = [&](const int i, const int j, const int k) // i is where x[0] is in y
  {
    return is_same(0, i) & ((is_same(1, j) & is_same(2, k)) | (is_same(1, k) & is_same(2, j)));
  };
  return (is_order(0, 1, 2) | is_order(1, 2, 0) | is_order(2, 0, 1)) != 0;
}

struct Have_same_vertices
{
  template <typename Vertex, std::size_t N>
  bool operator()(const std::array<Vertex, N>& x, const std::array<Vertex, N>& y) const
  {
    return internal::is_permutation(x, y);
  }
};

// Whether two triples of different vertices are the same, and in the same order but for the one that they begin with:
// those of facets that have the same side in front.
template <typename Vertex>
bool is_rotation(const std::array<Vertex, 3>& x, const std::array<Vertex, 3>& y)
{
  const std::size_t i = x[0] == y[0] ? 0 : x[0] == y[1] ? 1 : 2;
  return x[0] == y[i] && x[1] == y[(i + 1) % 3] && x[2] == y[(i + 2) % 3];
}

// Whether a vertex is named twice, so that it is none of its dimension.
template <typename Simplex>
bool has_repeated_vertex(Simplex simplex)
{
  std::sort(simplex.begin(), simplex.end());
  return std::adjacent_find(simplex.begin(), simplex.end()) != simplex.end();
}

/*
 * Numbers simplices; the order of their vertices makes no difference. They are stored as they are: to sort the vertices
 * takes more time than to look the simplex up, for nobody can predict the branches.
 *
 * With N = 1 it numbers vertices, or any other handles.
 */
template <typename Vertex_handle, std::size_t N>
using Simplex_index_3 = Hash_index<std::array<Vertex_handle, N>, Simplex_hash, Have_same_vertices>;

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_SIMPLEX_INDEX_3_H
