// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BIT_MATRIX_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BIT_MATRIX_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_BIT_MATRIX_H
