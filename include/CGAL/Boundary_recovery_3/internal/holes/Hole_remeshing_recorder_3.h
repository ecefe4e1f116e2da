// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_REMESHING_RECORDER_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_REMESHING_RECORDER_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

// Stands between the work and the caller's visitor, and measures phases.
template <typename Visitor>
class Hole_remeshing_recorder_3
{
public:
  typedef Hole_remeshing_phase        Phase;
  typedef Hole_remeshing_phase_report Report;

  // `maximum_running_time` is in seconds, from now on.
  Hole_remeshing_recorder_3(Visitor& visitor, std::vector<Report>& reports, const double maximum_running_time)
    : m_context(visitor), m_reports(reports)
  {
    m_context.set_maximum_running_time(maximum_running_time);
  }

  void begin(const Phase phase)
  {
    m_start_of_phase = seconds();
    m_context.visitor().on_phase_begin(phase);
  }

  void end(const Phase phase, const std::size_t number_of_holes)
  {
    m_reports.push_back(Report{ phase, number_of_holes, seconds() - m_start_of_phase });
    m_context.visitor().on_phase_end(m_reports.back());
  }

  void progress(const Phase phase, const std::size_t done, const std::size_t total)
  {
    m_context.visitor().on_progress(phase, done, total);
  }

  bool can_go_further() { return m_context.go_further(); }

  double seconds() const { return m_context.seconds(); }

private:
  Recovery_context<Visitor> m_context;
  std::vector<Report>& m_reports;
  double m_start_of_phase = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_HOLES_HOLE_REMESHING_RECORDER_3_H
