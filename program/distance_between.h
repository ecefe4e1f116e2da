#ifndef BOUNDARY_RECOVERY_3_PROGRAM_DISTANCE_BETWEEN_H
#define BOUNDARY_RECOVERY_3_PROGRAM_DISTANCE_BETWEEN_H

#include <cmath>

// The distance of two points, the same number in both directions. No square is too large or too small on the way.
template <typename Point>
double distance_between(const Point& p, const Point& q)
{
  return std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_DISTANCE_BETWEEN_H
