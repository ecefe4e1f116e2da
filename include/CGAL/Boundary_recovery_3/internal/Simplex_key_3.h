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

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Keys of edges, facets and single handles in hash tables: the addresses of the vertices, in increasing order.
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

template <typename Handle>
Simplex_key_3<1> simplex_key(const std::array<Handle, 1>& single)
{
  return {{ &*single[0] }};
}

inline bool is_equal(const Simplex_key_3<1>& x, const Simplex_key_3<1>& y) { return x[0] == y[0]; }

// Written out, for the comparison of std::array is a call of memcmp().
inline bool is_equal(const Simplex_key_3<2>& x, const Simplex_key_3<2>& y)
{
  return x[0] == y[0] && x[1] == y[1];
}

inline bool is_equal(const Simplex_key_3<3>& x, const Simplex_key_3<3>& y)
{
  return x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
}

struct Simplex_key_hash
{
  template <std::size_t N>
  std::uint64_t operator()(const Simplex_key_3<N>& key) const
  {
    // Fibonacci hashing: vertices are equally spaced in their container, so the low bits alone would collide.
    std::uint64_t h = 0;
    for(const void* p : key)
    {
      h = (h ^ reinterpret_cast<std::uintptr_t>(p)) * UINT64_C(0x9E3779B97F4A7C15);
      h ^= h >> 32;
    }
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

/*
 * Numbers simplices in the order in which they come; the order of their vertices makes no difference. A hash table with
 * open addressing, for the flips ask all the time whether a simplex is in it; nothing is ever taken out.
 *
 * The slots hold a number and a part of the hash value only: the table is small, and what is not in it is told from the
 * slots alone as a rule. The simplices are dense, so those of neighbors, numbered one after the other, are close
 * together.
 *
 * With N = 1 it numbers vertices, or any other handles.
 */
template <typename Vertex_handle, std::size_t N>
class Simplex_index_3
{
public:
  typedef std::array<Vertex_handle, N> Simplex;

  static constexpr std::size_t none = std::size_t(-1);

  std::size_t size() const { return m_simplices.size(); }

  // By their numbers, each as it was given first.
  const std::vector<Simplex>& simplices() const { return m_simplices; }

  void reserve(const std::size_t n)
  {
    m_simplices.reserve(n);
    if(are_too_few(m_slots.size(), n))
      rehash(n);
  }

  // Returns the number of the simplex, and whether it is new.
  std::pair<std::size_t, bool> insert(const Simplex& simplex)
  {
    if(are_too_few(m_slots.size(), size() + 1))
      rehash(2 * (size() + 1));
    const Key key = internal::simplex_key(simplex);
    const std::uint64_t hash = Simplex_key_hash()(key);
    Slot& slot = m_slots[position(key, hash)];
    if(slot.index != empty)
      return std::make_pair(std::size_t(slot.index), false);
    CGAL_assertion(size() < empty);
    slot = Slot{ static_cast<std::uint32_t>(size()), tag(hash) };
    m_simplices.push_back(simplex);
    return std::make_pair(size() - 1, true);
  }

  // Returns the number of the simplex, or none.
  std::size_t operator[](const Simplex& simplex) const
  {
    if(m_slots.empty())
      return none;
    const Key key = internal::simplex_key(simplex);
    const std::uint64_t hash = Simplex_key_hash()(key);
    return number_at(position(key, hash));
  }

  // The same for many simplices, step by step for all of them, so that the waits for memory overlap. (On a surface with
  // 270,000 triangles, looking up all the constraints takes a tenth less time. Insertion does not gain.)
  void look_up(const std::vector<Simplex>& simplices, std::vector<std::size_t>& numbers) const
  {
    numbers.assign(simplices.size(), none);
    if(m_slots.empty())
      return;
    struct Query
    {
      Key key;
      std::uint64_t hash;
      std::size_t position;
    };
    std::vector<Query> queries(simplices.size());
    for(std::size_t k = 0; k < queries.size(); ++k)
    {
      queries[k].key = internal::simplex_key(simplices[k]);
      queries[k].hash = Simplex_key_hash()(queries[k].key);
    }
    for(Query& q : queries)
      q.position = position_of_tag(q.hash, first_position(q.hash));
    for(std::size_t k = 0; k < queries.size(); ++k)
      numbers[k] = number_at(position(queries[k].key, queries[k].hash, queries[k].position));
  }

private:
  typedef Simplex_key_3<N> Key;

  static constexpr std::uint32_t empty = std::uint32_t(-1);

  struct Slot
  {
    std::uint32_t index = empty;
    std::uint32_t tag = 0;
  };

  // The bits of the hash value that do not decide on the position, unless there are billions of slots.
  static std::uint32_t tag(const std::uint64_t hash) { return static_cast<std::uint32_t>(hash >> 32); }

  std::size_t number_at(const std::size_t position) const
  {
    const std::uint32_t index = m_slots[position].index;
    return index == empty ? none : index;
  }

  std::size_t first_position(const std::uint64_t hash) const
  {
    return static_cast<std::size_t>(hash) & (m_slots.size() - 1);
  }

  // From i on, the next slot that is empty or may be the one of the simplex.
  std::size_t position_of_tag(const std::uint64_t hash, std::size_t i) const
  {
    while(m_slots[i].index != empty && m_slots[i].tag != tag(hash))
      i = (i + 1) & (m_slots.size() - 1);
    return i;
  }

  // Where the simplex is, or would be put.
  std::size_t position(const Key& key, const std::uint64_t hash) const
  {
    return position(key, hash, first_position(hash));
  }

  // The same, if it is known not to be before i.
  std::size_t position(const Key& key, const std::uint64_t hash, std::size_t i) const
  {
    for(;; i = (i + 1) & (m_slots.size() - 1))
    {
      i = position_of_tag(hash, i);
      if(m_slots[i].index == empty || is_equal(internal::simplex_key(m_simplices[m_slots[i].index]), key))
        return i;
    }
  }

  // At most two thirds of the slots are in use.
  static bool are_too_few(const std::size_t number_of_slots, const std::size_t n)
  {
    return 2 * number_of_slots < 3 * n;
  }

  // Makes room for n simplices; the number of slots is a power of 2.
  void rehash(const std::size_t n)
  {
    std::size_t number_of_slots = 16;
    while(are_too_few(number_of_slots, n))
      number_of_slots *= 2;
    m_slots.assign(number_of_slots, Slot());
    for(std::size_t k = 0; k < size(); ++k)
    {
      const Key key = internal::simplex_key(m_simplices[k]);
      const std::uint64_t hash = Simplex_key_hash()(key);
      m_slots[position(key, hash)] = Slot{ static_cast<std::uint32_t>(k), tag(hash) };
    }
  }

  std::vector<Slot> m_slots;
  std::vector<Simplex> m_simplices;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIMPLEX_KEY_3_H
