#ifndef BOUNDARY_RECOVERY_3_PROGRAM_ROUND_NUMBER_H
#define BOUNDARY_RECOVERY_3_PROGRAM_ROUND_NUMBER_H

#include <iomanip>
#include <sstream>
#include <string>

// a large number as people say it, with two or three digits that count
inline std::string round_number(const double x)
{
  static constexpr const char* units[] = { "", " thousand", " million", " billion" };
  if(! (x >= 1e4)) // nor is it NaN
    return std::to_string(static_cast<long long>(x > 0 ? x : 0));
  double y = x;
  int unit = 0;
  for(; y >= 1000 && unit < 3; y /= 1000)
    ++unit;
  std::ostringstream os;
  os << std::fixed << std::setprecision(y < 10 ? 1 : 0) << y << units[unit];
  return os.str();
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_ROUND_NUMBER_H
