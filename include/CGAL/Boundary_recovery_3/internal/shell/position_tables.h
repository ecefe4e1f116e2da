// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_POSITION_TABLES_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_POSITION_TABLES_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// A set of positions in the skirt polygon of a shell.
typedef Bits Positions;

constexpr int max_number_of_positions = max_number_of_bits;

/*
 * Pairs of positions: for each first one, the set of the second ones. Most of the entries of the matrices do not exist;
 * sets tell quickly where there is none, and are quickly emptied for the next shell.
 */
class Position_pairs
{
public:
  void clear(const int degree) { std::fill_n(m_seconds.begin(), degree, 0); }

  void insert(const int i, const int j) { m_seconds[i] |= internal::bit(j); }

  bool contains(const int i, const int j) const { return internal::has_bit(m_seconds[i], j); }

  Positions operator[](const int i) const { return m_seconds[i]; }

private:
  std::array<Positions, max_number_of_positions> m_seconds;
};

/*
 * A value for each row and position. Values are written before they are read, so they need not be initialized for each
 * shell.
 */
template <typename Value>
class Position_matrix
{
public:
  void assign(const int number_of_rows, const int degree)
  {
    m_degree = degree;
    const std::size_t n = static_cast<std::size_t>(number_of_rows) * degree;
    if(m_values.size() < n)
      m_values.resize(n);
  }

  Value& operator()(const int i, const int j) { return m_values[i * m_degree + j]; }
  const Value& operator()(const int i, const int j) const { return m_values[i * m_degree + j]; }

private:
  boost::container::vector<Value> m_values; // where bool is a type like any other
  int m_degree = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_POSITION_TABLES_H
