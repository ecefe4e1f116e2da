// Boxes and sheets in the Delaunay triangulation of a grid, whose facets are taken from the triangulation.

#ifndef BR3_TEST_GRID_SCENE_H
#define BR3_TEST_GRID_SCENE_H

#include <CGAL/Kernel/global_functions_3.h>

#include <array>
#include <cassert>
#include <utility>
#include <vector>

namespace br3_test {

// Boxes whose facets are in the Delaunay triangulation, whichever diagonals it chose: the facets are taken from the
// triangulation, those in the plane of a side of the box, and turned outward.
template <typename Tr>
struct Grid_scene
{
  typedef Tr                                      Triangulation;
  typedef typename Tr::Point                      Point;
  typedef typename Triangulation::Vertex_handle   Vertex_handle;
  typedef typename Triangulation::Cell_handle     Cell_handle;
  typedef std::array<Vertex_handle, 3>            Triple;

  Triangulation tr;
  std::vector<Triple> facets;

  // all points of the integer grid in [0,n]^3
  explicit Grid_scene(const int n)
  {
    for(int x = 0; x <= n; ++x)
      for(int y = 0; y <= n; ++y)
        for(int z = 0; z <= n; ++z)
          tr.insert(Point(x, y, z));
    assert(tr.is_valid());
  }

  static bool is_between(const Point& p, const std::array<int, 3>& low, const std::array<int, 3>& high)
  {
    for(int i = 0; i < 3; ++i)
      if(p[i] < low[i] || p[i] > high[i])
        return false;
    return true;
  }

  // appends the facets with all vertices in a box that is flat in direction `axis`, turned upward or downward
  void add_rectangle(const int axis, const std::array<int, 3>& low, const std::array<int, 3>& high, const bool up)
  {
    assert(low[axis] == high[axis]);
    for(auto it = tr.finite_facets_begin(); it != tr.finite_facets_end(); ++it)
    {
      Triple t;
      bool inside = true;
      for(int i = 0; i < 3; ++i)
      {
        t[i] = it->first->vertex(Triangulation::vertex_triple_index(it->second, i));
        inside = inside && is_between(t[i]->point(), low, high);
      }
      if(! inside)
        continue;
      const auto normal = CGAL::normal(t[0]->point(), t[1]->point(), t[2]->point());
      if((normal[axis] > 0) != up)
        std::swap(t[1], t[2]);
      facets.push_back(t);
    }
  }

  void add_box(const std::array<int, 3>& low, const std::array<int, 3>& high, const bool outward)
  {
    for(int axis = 0; axis < 3; ++axis)
    {
      std::array<int, 3> flat_high = high, flat_low = low;
      flat_high[axis] = low[axis];
      flat_low[axis] = high[axis];
      add_rectangle(axis, low, flat_high, ! outward);
      add_rectangle(axis, flat_low, high, outward);
    }
  }
};

} // namespace br3_test

#endif // BR3_TEST_GRID_SCENE_H
