// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BITS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BITS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * A set of numbers below 64, as the bits of a word.
 */
typedef std::uint64_t Bits;

constexpr int max_number_of_bits = 64;

// The set of i alone.
constexpr Bits bit(const int i) { return Bits(1) << i; }

// All the numbers below i, for i < 64.
constexpr Bits bits_before(const int i) { return internal::bit(i) - 1; }

// All the numbers above i.
constexpr Bits bits_after(const int i) { return ~Bits(0) << i << 1; }

constexpr bool has_bit(const Bits bits, const int i) { return (bits >> i & 1) != 0; }

// Whether there is one at most.
constexpr bool is_single_bit(const Bits bits) { return (bits & (bits - 1)) == 0; }

inline int number_of_bits(const Bits bits)
{
  return static_cast<int>(std::bitset<max_number_of_bits>(bits).count());
}

// A de Bruijn sequence: any six bits of it that follow each other are different from all others.
constexpr Bits de_bruijn_sequence = UINT64_C(0x03F79D71B4CB0A89);

constexpr std::array<unsigned char, max_number_of_bits> shifts_of_de_bruijn_sequence()
{
  std::array<unsigned char, max_number_of_bits> result = {{ }};
  for(int i = 0; i < max_number_of_bits; ++i)
    result[de_bruijn_sequence << i >> 58] = static_cast<unsigned char>(i);
  return result;
}

// The smallest number in a set that is not empty. (C++20 has std::countr_zero for this.)
inline int lowest_bit(const Bits bits)
{
  static constexpr std::array<unsigned char, max_number_of_bits> shifts = shifts_of_de_bruijn_sequence();
  return shifts[(bits & (~bits + 1)) * de_bruijn_sequence >> 58];
}

// The smallest number above i in a set that is not empty; if there is none, the smallest one.
inline int next_bit_on_circle(const Bits bits, const int i)
{
  const Bits after = bits & internal::bits_after(i);
  return internal::lowest_bit(after != 0 ? after : bits);
}

// Whether `is_wanted` holds for one of the set, in increasing order.
template <typename Is_wanted>
bool any_of_bits(const Bits bits, const Is_wanted& is_wanted)
{
  for(Bits rest = bits; rest != 0; rest &= rest - 1)
    if(is_wanted(internal::lowest_bit(rest)))
      return true;
  return false;
}

// Calls `work` with each of the set, in increasing order.
template <typename Work>
void for_each_bit(const Bits bits, const Work& work)
{
  for(Bits rest = bits; rest != 0; rest &= rest - 1)
    work(internal::lowest_bit(rest));
}

/*
 * A set of small numbers for each row. Rows are combined word by word, so this takes some operations for 64 columns at
 * a time.
 */
class Bit_matrix
{
public:
  // All empty.
  void assign(const std::size_t number_of_rows, const std::size_t number_of_columns)
  {
    m_number_of_words = (number_of_columns + bits_of_word - 1) / bits_of_word;
    m_words.assign(number_of_rows * m_number_of_words, 0);
  }

  void set(const std::size_t row, const std::size_t column)
  {
    m_words[row * m_number_of_words + column / bits_of_word] |= internal::bit(column % bits_of_word);
  }

  bool operator()(const std::size_t row, const std::size_t column) const
  {
    return internal::has_bit(word(row, column / bits_of_word), column % bits_of_word);
  }

  // The bits of the columns from 64 w on.
  Bits word(const std::size_t row, const std::size_t w) const { return m_words[row * m_number_of_words + w]; }

  // Whether `is_wanted` holds for one of the columns of which the bit is set in `combination(w)`, the words of a row or
  // of several, combined. In increasing order.
  template <typename Combination, typename Is_wanted>
  bool any_of(const Combination& combination, const Is_wanted& is_wanted) const
  {
    for(std::size_t w = 0; w < m_number_of_words; ++w)
      if(internal::any_of_bits(combination(w), [&](const int i) { return is_wanted(w * bits_of_word + i); }))
        return true;
    return false;
  }

  // Calls `work` with all of them.
  template <typename Combination, typename Work>
  void for_each(const Combination& combination, const Work& work) const
  {
    any_of(combination, [&](const std::size_t column) { work(column); return false; });
  }

private:
  static constexpr std::size_t bits_of_word = max_number_of_bits;

  std::vector<Bits> m_words;
  std::size_t m_number_of_words = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BITS_H
