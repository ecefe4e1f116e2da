// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_MESHING_RECORDER_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_MESHING_RECORDER_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_result_3.h>

#include <chrono>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Stands between the steps of the mesher and the caller's visitor: it collects what phases report, asks whether to go
 * on only until the answer is no, and knows the time that is left for all steps together.
 */
template <typename Visitor>
class Meshing_recorder_3
{
public:
  // `maximum_running_time` is in seconds, from now on.
  Meshing_recorder_3(Visitor& visitor, std::vector<Meshing_phase_report>& reports, const double maximum_running_time)
    : m_visitor(visitor), m_reports(reports), m_start(Clock::now()), m_maximum_running_time(maximum_running_time)
  { }

  void on_phase_begin(const Recovery_phase phase) { m_visitor.on_phase_begin(phase); }

  void on_phase_begin(const Meshing_phase phase) { m_visitor.on_phase_begin(phase); }

  void on_phase_end(const Phase_report& report) { m_visitor.on_phase_end(report); }

  void on_phase_end(const Meshing_phase_report& report)
  {
    m_reports.push_back(report);
    m_visitor.on_phase_end(report);
  }

  template <typename Phase>
  void on_progress(const Phase phase, const std::size_t done, const std::size_t total)
  {
    m_visitor.on_progress(phase, done, total);
  }

  bool go_further()
  {
    m_is_stopped = m_is_stopped || ! m_visitor.go_further();
    return ! m_is_stopped;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells) { m_visitor.before_cells_removal(cells); }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { m_visitor.after_cells_creation(cells); }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  // May be negative.
  double seconds_left() const { return m_maximum_running_time - seconds(); }

  // Whether neither the visitor nor the time limit ends the work.
  bool can_go_further() { return seconds_left() > 0 && go_further(); }

private:
  typedef std::chrono::steady_clock Clock;

  Visitor& m_visitor;
  std::vector<Meshing_phase_report>& m_reports;
  Clock::time_point m_start;
  double m_maximum_running_time;
  bool m_is_stopped = false;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_MESHING_MESHING_RECORDER_3_H
