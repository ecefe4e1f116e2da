// The largest memory of this process so far, for the benchmarks.

#ifndef BR3_BENCHMARK_PEAK_MEMORY_H
#define BR3_BENCHMARK_PEAK_MEMORY_H

#include <fstream>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace br3_benchmark {

// In MB; negative where the system does not tell. On Linux, getrusage() would count the process that started this one,
// too: its memory is inherited until the program is replaced, and the peak is not forgotten then.
inline double peak_memory()
{
#if defined(__linux__)
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word; )
  {
    double kilobytes;
    if(word == "VmHWM:" && status >> kilobytes)
      return kilobytes / 1024;
  }
#endif
#if defined(__unix__) || defined(__APPLE__)
  struct rusage u;
  if(getrusage(RUSAGE_SELF, &u) == 0)
#if defined(__APPLE__)
    return static_cast<double>(u.ru_maxrss) / (1024. * 1024.);
#else
    return static_cast<double>(u.ru_maxrss) / 1024.;
#endif
#endif
  return -1;
}

} // namespace br3_benchmark

#endif // BR3_BENCHMARK_PEAK_MEMORY_H
