// Triangle soups of boxes and rectangles with integer coordinates, of which everybody knows what is inside.

#ifndef BR3_TEST_BOX_SOUP_H
#define BR3_TEST_BOX_SOUP_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace br3_test {

typedef std::array<int, 3> Integer_point;

struct Box
{
  Integer_point low, high;

  long volume() const
  {
    return long(high[0] - low[0]) * long(high[1] - low[1]) * long(high[2] - low[2]);
  }

  // Whether a point is inside, given by `scale` times its coordinates.
  template <typename Number>
  bool contains(const std::array<Number, 3>& p, const int scale) const
  {
    for(int i = 0; i < 3; ++i)
      if(! (p[i] > Number(scale * low[i]) && p[i] < Number(scale * high[i])))
        return false;
    return true;
  }
};

struct Box_soup
{
  std::vector<Integer_point> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::vector<std::array<std::size_t, 2> > edges;

  std::size_t add_point(const Integer_point& p)
  {
    const auto inserted = m_index.emplace(p, points.size());
    if(inserted.second)
      points.push_back(p);
    return inserted.first->second;
  }

  void add_edge(const Integer_point& p, const Integer_point& q)
  {
    const std::size_t u = add_point(p);
    edges.push_back({{ u, add_point(q) }});
  }

  // Two triangles; `axis` is the direction in which the rectangle is flat, and its normal points up, or down.
  void add_rectangle(const int axis, const Integer_point& low, const Integer_point& high, const bool is_up)
  {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    std::array<std::size_t, 4> corners;
    for(std::size_t i = 0; i < 4; ++i)
    {
      Integer_point p = low;
      p[j] = i == 1 || i == 2 ? high[j] : low[j];
      p[k] = i >= 2 ? high[k] : low[k];
      corners[i] = add_point(p);
    }
    if(! is_up)
      std::swap(corners[1], corners[3]);
    triangles.push_back({{ corners[0], corners[1], corners[2] }});
    triangles.push_back({{ corners[0], corners[2], corners[3] }});
  }

  // The side `side` of a box, from 0 to 5: low and high in each direction.
  void add_side(const Box& box, const int side, const bool is_outward)
  {
    const int axis = side / 2;
    const bool is_high = side % 2 == 1;
    Integer_point low = box.low, high = box.high;
    (is_high ? low : high)[axis] = (is_high ? box.high : box.low)[axis];
    add_rectangle(axis, low, high, is_high == is_outward);
  }

  void add_box(const Box& box, const bool is_outward = true)
  {
    for(int side = 0; side < 6; ++side)
      add_side(box, side, is_outward);
  }

private:
  std::map<Integer_point, std::size_t> m_index;
};

} // namespace br3_test

#endif // BR3_TEST_BOX_SOUP_H
