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

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Fibonacci hashing: numbers and addresses are often equally spaced, so the low bits alone would collide.
inline std::uint64_t mixed_bits(const std::uint64_t bits)
{
  const std::uint64_t h = bits * UINT64_C(0x9E3779B97F4A7C15);
  return h ^ (h >> 32);
}

/*
 * Numbers keys in the order in which they come. A hash table with open addressing, for the flips ask all the time
 * whether a simplex is in it.
 *
 * Keys that are taken out are not found any more, but keep their numbers: a key that comes again gets a new one.
 *
 * The slots hold a number and a part of the hash value only: the table is small, and what is not in it is told from the
 * slots alone as a rule. The keys are dense, so those of neighbors, numbered one after the other, are close together.
 *
 * A hash value has 64 bits, all of them mixed. The order of the keys is that in which they came, and does not depend on
 * hash values.
 */
template <typename Key, typename Hash, typename Equal>
class Hash_index
{
public:
  static constexpr std::size_t none = std::size_t(-1);

  explicit Hash_index(const Hash& hash = Hash(), const Equal& is_equal = Equal())
    : m_hash(hash), m_is_equal(is_equal)
  { }

  // With those that were taken out.
  std::size_t size() const { return m_keys.size(); }

  // By their numbers, each as it was given first.
  const std::vector<Key>& keys() const { return m_keys; }

  // How many keys there is room for, those that were taken out included; insertion does not fail then.
  std::size_t capacity() const { return (std::min)(m_keys.capacity(), 2 * m_slots.size() / 3); }

  void reserve(const std::size_t n)
  {
    m_keys.reserve(n);
    if(are_too_few(m_slots.size(), n))
      rehash(n);
  }

  void clear()
  {
    m_keys.clear();
    m_number_of_erased_keys = 0;
    std::fill(m_slots.begin(), m_slots.end(), Slot());
  }

  // Returns the number of the key, and whether it is new.
  std::pair<std::size_t, bool> insert(const Key& key)
  {
    if(are_too_few(m_slots.size(), size() + 1))
      rehash(2 * (size() + 1));
    const std::uint64_t hash = m_hash(key);
    Slot& slot = m_slots[position(key, hash)];
    if(slot.index != empty)
      return std::make_pair(std::size_t(slot.index), false);
    CGAL_assertion(size() < empty);
    slot = Slot{ static_cast<std::uint32_t>(size()), tag(hash) };
    m_keys.push_back(key);
    return std::make_pair(size() - 1, true);
  }

  // Takes a key out, and returns the number that it had, or none. This needs no memory.
  std::size_t erase(const Key& key)
  {
    const std::size_t k = (*this)[key];
    if(k != none)
    {
      free_slot(position(key, m_hash(key)));
      ++m_number_of_erased_keys;
    }
    return k;
  }

  // Whether the key with this number was taken out. It is looked up.
  bool is_erased(const std::size_t k) const { return m_number_of_erased_keys > 0 && (*this)[m_keys[k]] != k; }

  std::size_t number_of_erased_keys() const { return m_number_of_erased_keys; }

  // Gives new numbers to the keys that are left, in the same order. This needs no memory.
  void renumber()
  {
    std::size_t kept = 0;
    for(std::size_t k = 0; k < size(); ++k)
    {
      Slot& slot = m_slots[position(m_keys[k], m_hash(m_keys[k]))];
      if(slot.index != k)
        continue;
      slot.index = static_cast<std::uint32_t>(kept);
      m_keys[kept++] = m_keys[k];
    }
    m_keys.erase(m_keys.begin() + kept, m_keys.end());
    m_number_of_erased_keys = 0;
  }

  // Returns the number of the key, or none.
  std::size_t operator[](const Key& key) const
  {
    return m_slots.empty() ? none : number_at(position(key, m_hash(key)));
  }

  // The same for many keys, step by step for all of them, so that the waits for memory overlap. (On a surface with
  // 270,000 triangles, looking up all the constraints takes a tenth less time. Insertion does not gain.)
  void look_up(const std::vector<Key>& keys, std::vector<std::size_t>& numbers) const
  {
    numbers.assign(keys.size(), none);
    if(m_slots.empty())
      return;
    struct Query
    {
      std::uint64_t hash;
      std::size_t position;
    };
    std::vector<Query> queries(keys.size());
    for(std::size_t k = 0; k < queries.size(); ++k)
      queries[k].hash = m_hash(keys[k]);
    for(Query& q : queries)
      q.position = position_of_tag(q.hash, first_position(q.hash));
    for(std::size_t k = 0; k < queries.size(); ++k)
      numbers[k] = number_at(position(keys[k], queries[k].hash, queries[k].position));
  }

private:
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

  // From i on, the next slot that is empty or may be the one of the key.
  std::size_t position_of_tag(const std::uint64_t hash, std::size_t i) const
  {
    while(m_slots[i].index != empty && m_slots[i].tag != tag(hash))
      i = (i + 1) & (m_slots.size() - 1);
    return i;
  }

  // Where the key is, or would be put.
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
      if(m_slots[i].index == empty || m_is_equal(m_keys[m_slots[i].index], key))
        return i;
    }
  }

  // At most two thirds of the slots are in use.
  static bool are_too_few(const std::size_t number_of_slots, const std::size_t n)
  {
    return 2 * number_of_slots < 3 * n;
  }

  // Makes room for n keys; the number of slots is a power of 2.
  void rehash(const std::size_t n)
  {
    std::size_t number_of_slots = 16;
    while(are_too_few(number_of_slots, n))
      number_of_slots *= 2;
    std::vector<Slot> slots(number_of_slots);
    slots.swap(m_slots);
    if(m_number_of_erased_keys == 0)
      for(std::size_t k = 0; k < size(); ++k)
        put_into_slot(k);
    else
      for(const Slot& slot : slots)
        if(slot.index != empty)
          put_into_slot(slot.index);
  }

  void put_into_slot(const std::size_t k)
  {
    const std::uint64_t hash = m_hash(m_keys[k]);
    m_slots[position(m_keys[k], hash)] = Slot{ static_cast<std::uint32_t>(k), tag(hash) };
  }

  // Empties the slot i. Those of the keys behind it that could not be reached any more move up.
  void free_slot(std::size_t i)
  {
    const std::size_t mask = m_slots.size() - 1;
    for(std::size_t j = (i + 1) & mask; m_slots[j].index != empty; j = (j + 1) & mask)
    {
      const std::size_t first = first_position(m_hash(m_keys[m_slots[j].index]));
      if(((j - first) & mask) >= ((j - i) & mask))
      {
        m_slots[i] = m_slots[j];
        i = j;
      }
    }
    m_slots[i] = Slot();
  }

  Hash m_hash;
  Equal m_is_equal;
  std::vector<Slot> m_slots;
  std::vector<Key> m_keys;
  std::size_t m_number_of_erased_keys = 0;
};

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

/*
 * Tells most facets that are not in a set from those that may be: two bits for each facet of the set, both in one word
 * of a table that has 8 to 16 bits for each facet.
 */
template <typename Vertex_handle>
class Facet_filter_3
{
public:
  explicit Facet_filter_3(const std::size_t number_of_facets)
  {
    std::size_t size = 1;
    while(8 * size < number_of_facets)
      size *= 2;
    m_words.assign(size, 0);
  }

  void insert(const std::array<Vertex_handle, 3>& f)
  {
    const std::uint64_t sum = hash_share(f[0]) + hash_share(f[1]) + hash_share(f[2]);
    m_words[word(sum)] |= bits(sum);
  }

  // Bit i is set if facet i of the cell may be in the set, and if the cell behind it has a higher address, so that one
  // of the two is asked. There are no branches, for nobody could predict them.
  template <typename Cell_handle>
  unsigned candidates_from_below(const Cell_handle c) const
  {
    std::array<std::uint64_t, 4> h;
    for(int i = 0; i < 4; ++i)
      h[i] = hash_share(c->vertex(i));
    const std::uint64_t sum = h[0] + h[1] + h[2] + h[3];
    unsigned result = 0;
    for(int i = 0; i < 4; ++i)
    {
      const unsigned is_below = std::less<const void*>()(&*c, &*c->neighbor(i));
      const unsigned is_candidate = may_contain(sum - h[i]);
      result |= (is_below & is_candidate) << i;
    }
    return result;
  }

private:
  // The facet is given by the sum over its vertices, which does not depend on their order.
  bool may_contain(const std::uint64_t sum) const { return (m_words[word(sum)] & bits(sum)) == bits(sum); }

  std::size_t word(const std::uint64_t sum) const
  {
    return static_cast<std::size_t>(sum >> 13) & (m_words.size() - 1);
  }

  static std::uint64_t bits(const std::uint64_t sum)
  {
    return (std::uint64_t(1) << (sum & 63)) | (std::uint64_t(1) << (sum >> 6 & 63));
  }

  std::vector<std::uint64_t> m_words;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_SIMPLEX_INDEX_3_H
