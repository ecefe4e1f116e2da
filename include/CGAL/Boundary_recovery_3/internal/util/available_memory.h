// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_AVAILABLE_MEMORY_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_AVAILABLE_MEMORY_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <limits>
#include <string>

#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace CGAL::Boundary_recovery_3::internal {

// The number behind this word at the beginning of a line of a file, or the largest number.
inline std::size_t number_in_file(const std::string& file, const std::string& word)
{
  std::ifstream is(file);
  std::string line;
  while(std::getline(is, line))
    if(line.compare(0, word.size(), word) == 0)
    {
      const std::size_t digit = line.find_first_of("0123456789", word.size());
      if(digit != std::string::npos && line.size() - digit < 20)
        return static_cast<std::size_t>(std::stoull(line.substr(digit)));
    }
  return (std::numeric_limits<std::size_t>::max)();
}

/*
 * How many more bytes this process can have, as far as the system tells: what Linux says is available, what a container
 * leaves, and the limit of the address space. The largest number where nobody knows.
 */
inline std::size_t available_memory()
{
  static constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();
  const std::size_t kilobytes = number_in_file("/proc/meminfo", "MemAvailable:");
  std::size_t result = kilobytes == unlimited ? unlimited : 1024 * kilobytes;

  const std::size_t limit = number_in_file("/sys/fs/cgroup/memory.max", "");
  const std::size_t used = number_in_file("/sys/fs/cgroup/memory.current", "");
  if(limit != unlimited && used != unlimited)
    result = (std::min)(result, limit - (std::min)(limit, used));

#ifndef _WIN32
  rlimit address_space;
  const std::size_t size = number_in_file("/proc/self/status", "VmSize:"); // in kilobytes
  if(getrlimit(RLIMIT_AS, &address_space) == 0 && address_space.rlim_cur != RLIM_INFINITY && size != unlimited)
  {
    const std::size_t bytes = static_cast<std::size_t>(address_space.rlim_cur);
    result = (std::min)(result, bytes - (std::min)(bytes, 1024 * size));
  }
#endif
  return result;
}

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_AVAILABLE_MEMORY_H
