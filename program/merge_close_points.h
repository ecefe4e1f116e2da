#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MERGE_CLOSE_POINTS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MERGE_CLOSE_POINTS_H

#include "point_search.h"

#include <cstddef>
#include <vector>

// finds points that are close to each other: for each point the first one, in the order of the range, from which its
// coordinates differ by at most the tolerance and which is not close to one before; or the point itself. So no point
// would move farther than the tolerance, however many there are in a row.
template <typename Point>
std::vector<std::size_t> first_close_points(const std::vector<Point>& points, const double tolerance)
{
  std::vector<std::size_t> first(points.size()), close;
  for(std::size_t i = 0; i < points.size(); ++i)
    first[i] = i;
  const Point_search<Point> search(points, first);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    if(first[i] != i)
      continue;
    search(points[i], points[i], tolerance, close);
    for(const std::size_t j : close)
      if(j > i && first[j] == j)
        first[j] = i;
  }
  return first;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MERGE_CLOSE_POINTS_H
