#ifndef BOUNDARY_RECOVERY_3_PROGRAM_ROUND_NUMBER_H
#define BOUNDARY_RECOVERY_3_PROGRAM_ROUND_NUMBER_H

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

// a large number as people say it, with two or three digits that count
inline std::string round_number(const double x)
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr const char* units[] = { "", " thousand", " million", " billion" };
  if(! (x >= 1e4)) // nor is it NaN
    return std::to_string(static_cast<long long>(x > 0 ? x : 0));
  if(! (x < 1e15))
    return x < infinity ? "10^" + std::to_string(static_cast<int>(std::log10(x))) : "10^308 or more";
  double y = x;
  int unit = 0;
  for(; y >= 1000 && unit < 3; y /= 1000)
    ++unit;
  std::ostringstream os;
  os << std::fixed << std::setprecision(y < 10 ? 1 : 0) << y << units[unit];
  return os.str();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_ROUND_NUMBER_H
