// How the time of something grows with its size: what is quadratic is told from what is not, on any machine.

#ifndef BR3_TEST_TIME_GROWTH_H
#define BR3_TEST_TIME_GROWTH_H

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

namespace br3_test {

// The processor time of the fastest of a few runs.
template <typename Work>
double time_of(const Work& work)
{
  double shortest = std::numeric_limits<double>::infinity();
  for(int run = 0; run < 5; ++run)
  {
    const std::clock_t start = std::clock();
    work();
    shortest = (std::min)(shortest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return shortest;
}

// The power of n with which the time grows between two sizes, one of which is `factor` times as large. What takes less
// time than can be measured is taken to take that.
inline double exponent(const double time_of_small, const double time_of_large, const double factor)
{
  static constexpr double shortest = 2e-5;
  return std::log((std::max)(time_of_large, shortest) / (std::max)(time_of_small, shortest)) / std::log(factor);
}

} // namespace br3_test

#endif // BR3_TEST_TIME_GROWTH_H
