// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_SMALLEST_ELEMENTS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_SMALLEST_ELEMENTS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Keeps the smallest of the elements that are inserted, a bounded number of them, whatever their order. Never stores
 * more than twice that number, so that the time is constant for each on average.
 */
template <typename T>
class Smallest_elements
{
public:
  explicit Smallest_elements(const std::size_t max_number) : m_max_number(max_number) { }

  // Whether x may be among the smallest: if not, whoever has trouble to find out whether it is to be inserted need not.
  bool is_wanted(const T& x) const { return ! m_bound || x < *m_bound; }

  void insert(const T& x)
  {
    ++m_number_of_insertions;
    m_elements.push_back(x);
    if(m_elements.size() / 2 >= m_max_number) // a bound on the number may be the largest number there is
      discard();
  }

  // Counts those that were not kept, too.
  std::size_t number_of_insertions() const { return m_number_of_insertions; }

  // The elements that are kept, in increasing order.
  std::vector<T> sorted() const
  {
    std::vector<T> result = m_elements;
    std::sort(result.begin(), result.end());
    if(result.size() > m_max_number)
      result.resize(m_max_number);
    return result;
  }

private:
  void discard()
  {
    if(m_elements.size() <= m_max_number)
      return;
    const auto first_to_discard = m_elements.begin() + m_max_number;
    std::nth_element(m_elements.begin(), first_to_discard, m_elements.end());
    m_bound = *first_to_discard;
    m_elements.erase(first_to_discard, m_elements.end());
  }

  const std::size_t m_max_number;
  std::vector<T> m_elements;
  std::optional<T> m_bound; // the smallest that was discarded
  std::size_t m_number_of_insertions = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_SMALLEST_ELEMENTS_H
