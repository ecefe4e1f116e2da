#ifndef BOUNDARY_RECOVERY_3_PROGRAM_MERGE_CLOSE_POINTS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_MERGE_CLOSE_POINTS_H

#include <CGAL/Fuzzy_iso_box.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <iterator>
#include <vector>

// finds points that are close to each other: for each point the first one, in the order of the range, from which its
// coordinates differ by at most the tolerance and which is not close to one before; or the point itself. So no point
// would move farther than the tolerance, however many there are in a row.
template <typename Point>
std::vector<std::size_t> first_close_points(const std::vector<Point>& points, const double tolerance)
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel                           Kernel;
  typedef typename CGAL::Pointer_property_map<Point>::const_type                Point_map;
  typedef CGAL::Search_traits_3<Kernel>                                         Base_traits;
  typedef CGAL::Search_traits_adapter<std::size_t, Point_map, Base_traits>      Traits;
  typedef CGAL::Kd_tree<Traits>                                                 Tree;

  std::vector<std::size_t> first(points.size()), close;
  for(std::size_t i = 0; i < points.size(); ++i)
    first[i] = i;
  const Traits traits(CGAL::make_property_map(points));
  Tree tree(first.begin(), first.end(), typename Tree::Splitter(), traits);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    if(first[i] != i)
      continue;
    const Point& p = points[i];
    const CGAL::Fuzzy_iso_box<Traits> box(Point(p.x() - tolerance, p.y() - tolerance, p.z() - tolerance),
                                          Point(p.x() + tolerance, p.y() + tolerance, p.z() + tolerance), 0., traits);
    close.clear();
    tree.search(std::back_inserter(close), box);
    for(const std::size_t j : close)
      if(j > i && first[j] == j)
        first[j] = i;
  }
  return first;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_MERGE_CLOSE_POINTS_H
