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
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Progress, cancelling and the deadline: one mechanism for all phases.
 * Once asked to stop, it stays so.
 *
 * How often the visitor is asked depends on the work, not on time: equal runs ask equally often.
 *
 * It also counts work, in units that are the same on any machine, so that somebody can be asked after much of it
 * whether there is any hope; if not, the recovery ends as if it had been stopped.
 */
template <typename Tr>
class Recovery_context
{
public:
  typedef Mesh_visitor_3<Tr>        Visitor;

  explicit Recovery_context(Visitor& visitor) : m_visitor(visitor), m_start(Clock::now()) { }

  Visitor& visitor() { return m_visitor; }

  // Seconds from the construction of this object on; infinity: no limit.
  void set_maximum_running_time(const double seconds) { m_maximum_running_time = seconds; }

  // May be negative.
  double seconds_left() const { return m_maximum_running_time - seconds(); }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  // Runs a phase: does the work, and tells the visitor of its beginning and its end. `complete` adds to the report what
  // is known by then.
  template <typename Work, typename Complete>
  void run(const Phase phase, const Work& work, const Complete& complete)
  {
    const double start = seconds();
    m_visitor.on_phase_begin(phase);
    work();
    Phase_report report;
    report.phase = phase;
    report.seconds = seconds() - start;
    complete(report);
    m_visitor.on_phase_end(report);
  }

  bool go_further()
  {
    if(is_in_time() && ! m_visitor.go_further())
      stop(seconds());
    return can_go_further();
  }

  // The same for steps that are so short that it is enough to ask after each 1024 of them.
  bool go_further_after_short_step() { return ++m_number_of_short_steps % 1024 == 0 ? go_further() : can_go_further(); }

  // The same for steps of which some take milliseconds: the clock is looked at after each of them, and the visitor is
  // asked after a few.
  bool go_further_after_long_step()
  {
    if(++m_number_of_long_steps % long_steps_per_question == 0)
      return go_further();
    return is_in_time() && can_go_further();
  }

  // Whether what only tells of the work, such as figures, may still be finished: always if nothing ended the work, else
  // for a moment. To be asked after short steps.
  bool can_finish_after_short_step()
  {
    return go_further_after_short_step() || m_number_of_short_steps % 1024 != 0
        || seconds() < m_seconds_at_stop + seconds_after_stop;
  }

  bool is_stopped() const { return m_is_stopped; }

  // The visitor has said no to somebody else who asked.
  void stop() { stop(seconds()); }

  // Calls `examine` once, when more work than this is done.
  void examine_after(const std::size_t work, std::function<void()> examine)
  {
    m_work_before_examination = work;
    m_examine = std::move(examine);
  }

  // To be called where the account of what is lost is in order, since the examination may look at it.
  void add_work(const std::size_t work)
  {
    m_work += work;
    if(! m_examine || m_work <= m_work_before_examination)
      return;
    const std::function<void()> examine = std::exchange(m_examine, nullptr); // it may ask for another examination
    examine();
  }

  std::size_t work() const { return m_work; }

  // Nothing that goes on from now on can recover all.
  void refute() { m_is_refuted = true; }

  bool is_refuted() const { return m_is_refuted; }

private:
  typedef std::chrono::steady_clock Clock;

  // See "Tuning constants" in the manual.
  static constexpr double seconds_after_stop = 0.15;
  static constexpr std::size_t long_steps_per_question = 16;

  // Returns whether nothing has stopped the work; the clock may do so now.
  bool is_in_time()
  {
    if(! m_is_stopped && ! (seconds() < m_maximum_running_time))
      stop(m_maximum_running_time);
    return ! m_is_stopped;
  }

  void stop(const double at)
  {
    m_is_stopped = true;
    m_seconds_at_stop = at;
  }

  bool can_go_further() const { return ! m_is_stopped && ! m_is_refuted; }

  Visitor& m_visitor;
  Clock::time_point m_start;
  double m_maximum_running_time = std::numeric_limits<double>::infinity();
  bool m_is_stopped = false;
  double m_seconds_at_stop = std::numeric_limits<double>::infinity();
  bool m_is_refuted = false;
  std::size_t m_work = 0;
  std::size_t m_work_before_examination = 0;
  std::function<void()> m_examine; // none: nobody wants to
  std::size_t m_number_of_short_steps = 0;
  std::size_t m_number_of_long_steps = 0;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_RECOVERY_CONTEXT_H
