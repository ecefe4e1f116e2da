#ifndef BOUNDARY_RECOVERY_3_PROGRAM_THREAD_LIMIT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <optional>

// As long as this lives, there are not more threads than that; 0: no limit. Without the TBB there is one anyway.
class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(const std::size_t number)
  {
    if(number > 0)
      m_control.emplace(tbb::global_control::max_allowed_parallelism, number);
  }

private:
  std::optional<tbb::global_control> m_control;
#else
  explicit Thread_limit(const std::size_t) { }
#endif
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_THREAD_LIMIT_H
