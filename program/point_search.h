#ifndef BOUNDARY_RECOVERY_3_PROGRAM_POINT_SEARCH_H
#define BOUNDARY_RECOVERY_3_PROGRAM_POINT_SEARCH_H

#include <CGAL/Fuzzy_iso_box.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

// Finds points in boxes. The points have to stay where they are.
template <typename Point>
class Point_search
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel                       Kernel;
  typedef typename CGAL::Pointer_property_map<Point>::const_type            Point_map;
  typedef CGAL::Search_traits_3<Kernel>                                     Base_traits;
  typedef CGAL::Search_traits_adapter<std::size_t, Point_map, Base_traits>  Traits;
  typedef CGAL::Kd_tree<Traits>                                             Tree;

  Traits m_traits;
  Tree m_tree;

public:
  // `numbers` are those of the points among which to search
  Point_search(const std::vector<Point>& points, const std::vector<std::size_t>& numbers)
    : m_traits(CGAL::make_property_map(points)),
      m_tree(numbers.begin(), numbers.end(), typename Tree::Splitter(), m_traits)
  { }

  // replaces the content of `found` by the numbers of the points in the smallest box around two points, which is made
  // larger by `margin` on each side
  void operator()(const Point& p, const Point& q, const double margin, std::vector<std::size_t>& found) const
  {
    const auto low = [=](const int i) { return (std::min)(p[i], q[i]) - margin; };
    const auto high = [=](const int i) { return (std::max)(p[i], q[i]) + margin; };
    const CGAL::Fuzzy_iso_box<Traits> box(Point(low(0), low(1), low(2)), Point(high(0), high(1), high(2)), 0.,
                                          m_traits);
    found.clear();
    m_tree.search(std::back_inserter(found), box);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_POINT_SEARCH_H
