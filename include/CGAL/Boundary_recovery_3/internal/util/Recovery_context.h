// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_RECOVERY_CONTEXT_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_RECOVERY_CONTEXT_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>

#include <chrono>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Progress, cancelling and the deadline: one mechanism for all phases.
 * Once asked to stop, it stays so.
 */
template <typename Visitor>
class Recovery_context
{
public:
  typedef std::chrono::steady_clock Clock;

  explicit Recovery_context(Visitor& visitor) : m_visitor(visitor), m_start(Clock::now()) { }

  Visitor& visitor() { return m_visitor; }

  // Seconds from the construction of this object on; infinity: no limit.
  void set_maximum_running_time(const double seconds) { m_maximum_running_time = seconds; }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  bool go_further()
  {
    m_is_stopped = m_is_stopped || ! (seconds() < m_maximum_running_time) || ! m_visitor.go_further();
    return ! m_is_stopped;
  }

  // The same for steps that are so short that it is enough to ask after each 1024 of them.
  bool go_further_after_short_step() { return ++m_number_of_short_steps % 1024 == 0 ? go_further() : ! m_is_stopped; }

  bool is_stopped() const { return m_is_stopped; }

private:
  Visitor& m_visitor;
  Clock::time_point m_start;
  double m_maximum_running_time = std::numeric_limits<double>::infinity();
  bool m_is_stopped = false;
  std::size_t m_number_of_short_steps = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_RECOVERY_CONTEXT_H
