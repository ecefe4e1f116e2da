// Whether points are too near to walls that are much larger than the size, by looking at all of these.

#ifndef BR3_TEST_ENCROACHMENT_H
#define BR3_TEST_ENCROACHMENT_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace br3_test {

// How near a point is to what it must not encroach on, as parts of the distances from which on it does not.
struct Encroachment
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
  typedef K::Point_3                                          Point;
  typedef std::array<Point, 3>                                Triangle;

  // The size is both the one beside the wall and the one at the point.
  void look_at(const Triangle& t, const Point& p, const double size)
  {
    const double height = smallest_height(t);
    if(height > 2 * size)
      to_walls = (std::min)(to_walls, std::sqrt(CGAL::squared_distance(p, K::Triangle_3(t[0], t[1], t[2])))
                                      / (std::min)(.15 * height, 1.5 * size));
    for(std::size_t i = 0; i < 3; ++i)
      look_at_edge(t[i], t[(i + 1) % 3], p, size);
  }

  void look_at_edge(const Point& q, const Point& r, const Point& p, const double size)
  {
    if(! (distance(q, r) > 2 * size))
      return;
    const double angle = CGAL::approximate_angle(q, p, r);
    const double to_edge = std::sqrt(CGAL::squared_distance(p, K::Segment_3(q, r))) / (1.5 * size);
    to_edges = (std::min)(to_edges, (std::max)((180 - angle) / 15, to_edge));
  }

  double nearest() const { return (std::min)(to_walls, to_edges); }
  bool is_doubtful() const { return std::abs(nearest() - 1) < 1e-6; }

  double to_walls = std::numeric_limits<double>::infinity();
  double to_edges = std::numeric_limits<double>::infinity();

private:
  static double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

  static double smallest_height(const Triangle& t)
  {
    const double longest = (std::max)({ distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0]) });
    return 2 * std::sqrt(CGAL::squared_area(t[0], t[1], t[2])) / longest;
  }
};

} // namespace br3_test

#endif // BR3_TEST_ENCROACHMENT_H
