// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_TASK_VISITOR_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_TASK_VISITOR_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_constrained_mesh_visitor_3.h>

#include <atomic>
#include <cstddef>
#include <mutex>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Stands between the tasks of several threads and the visitor, which is called by one of them at a time. It is not told
 * of cells, since those that tasks change are not its.
 */
template <typename Visitor>
class Task_visitor_3
  : public Default_boundary_constrained_mesh_visitor_3
{
public:
  explicit Task_visitor_3(Visitor& visitor) : m_visitor(visitor) { }

  // From now on, progress is that of tasks with this weight, which are one of several rounds of the phase.
  void begin(const Meshing_phase phase, const std::size_t round, const std::size_t number_of_rounds,
             const std::size_t weight)
  {
    m_phase = phase;
    m_done = round * weight;
    m_total = number_of_rounds * weight;
  }

  void end_task(const std::size_t weight)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_done += weight;
    m_visitor.on_progress(m_phase, m_done, m_total);
  }

  // Threads that find the visitor busy go on for now.
  bool go_further()
  {
    const std::unique_lock<std::mutex> lock(m_mutex, std::try_to_lock);
    if(lock && ! m_is_stopped)
      m_is_stopped = ! m_visitor.go_further();
    return ! m_is_stopped;
  }

private:
  Visitor& m_visitor;
  std::mutex m_mutex;
  std::atomic<bool> m_is_stopped{ false };
  Meshing_phase m_phase = Meshing_phase::field_point_insertion;
  std::size_t m_done = 0;
  std::size_t m_total = 0;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_PARALLEL_TASK_VISITOR_3_H
