// The surface of a wing with a pylon, of a store below it, and of a box around both, for the benchmarks.

#ifndef BR3_BENCHMARK_MOVING_BODY_H
#define BR3_BENCHMARK_MOVING_BODY_H

#include "mesh_quality_br3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace br3_benchmark {

typedef std::array<std::size_t, 3> Triangle;

// A surface of triangles that turn outward.
struct Body
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  double volume() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += dot(points[t[0]], cross(points[t[1]], points[t[2]])) / 6;
    return sum;
  }
};

// Positions from the first place to the last one, all places among them. Their distances are those that are asked for
// at the places, and change linearly between them.
inline std::vector<double> graded_lines(const std::vector<std::pair<double, double> >& places_and_distances)
{
  std::vector<double> lines(1, places_and_distances.front().first);
  for(std::size_t i = 0; i + 1 < places_and_distances.size(); ++i)
  {
    const double a = places_and_distances[i].first, b = places_and_distances[i + 1].first;
    const double first = places_and_distances[i].second, last = places_and_distances[i + 1].second;
    const double growth = (last - first) / (b - a);
    std::vector<double> steps(1, 0);
    while(steps.back() < b - a)
      steps.push_back(steps.back() + first + growth * steps.back());
    if(steps.size() > 2 && steps.back() - (b - a) > (b - a) - steps[steps.size() - 2])
      steps.pop_back();
    for(std::size_t k = 1; k + 1 < steps.size(); ++k)
      lines.push_back(a + steps[k] * ((b - a) / steps.back()));
    lines.push_back(b);
  }
  return lines;
}

// The boundary of some of the blocks between three families of lines, which a map then gives its shape. So it is
// watertight whatever the shape.
class Surface_of_blocks
{
  typedef std::array<std::size_t, 3> Indices;

  std::array<std::vector<double>, 3> m_lines;
  std::map<Indices, std::size_t> m_number;
  Body m_body;

  template <typename IsSolid>
  bool is_solid(const Indices& block, const IsSolid& is_solid_at) const
  {
    Point center;
    for(std::size_t i = 0; i < 3; ++i)
    {
      if(block[i] >= m_lines[i].size() - 1) // what is before the first line has a very large index
        return false;
      center[i] = (m_lines[i][block[i]] + m_lines[i][block[i] + 1]) / 2;
    }
    return is_solid_at(center);
  }

  template <typename Shape>
  std::size_t vertex(const Indices& corner, const Shape& shape)
  {
    const auto inserted = m_number.emplace(corner, m_body.points.size());
    if(inserted.second)
      m_body.points.push_back(shape(Point{{ m_lines[0][corner[0]], m_lines[1][corner[1]], m_lines[2][corner[2]] }}));
    return inserted.first->second;
  }

  // Halves a quadrangle at its shorter diagonal: that is the one in wide angles.
  void add_quadrangle(const std::array<std::size_t, 4>& q)
  {
    const auto length = [&](const std::size_t v, const std::size_t w)
    {
      const Point d = difference(m_body.points[v], m_body.points[w]);
      return dot(d, d);
    };
    const std::size_t s = length(q[0], q[2]) <= length(q[1], q[3]) ? 0 : 1;
    m_body.triangles.push_back({{ q[s], q[s + 1], q[s + 2] }});
    m_body.triangles.push_back({{ q[s], q[s + 2], q[(s + 3) % 4] }});
  }

  template <typename Shape>
  void add_side(const Indices& block, const std::size_t axis, const bool is_high, const Shape& shape)
  {
    const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
    std::array<std::size_t, 4> quadrangle;
    for(std::size_t i = 0; i < 4; ++i)
    {
      Indices corner = block;
      corner[axis] += is_high;
      corner[j] += i == 1 || i == 2;
      corner[k] += i >= 2;
      quadrangle[is_high ? i : 3 - i] = vertex(corner, shape);
    }
    add_quadrangle(quadrangle);
  }

public:
  Surface_of_blocks(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z)
    : m_lines{{ x, y, z }}
  { }

  template <typename IsSolid, typename Shape>
  Body operator()(const IsSolid& is_solid_at, const Shape& shape)
  {
    Indices b;
    for(b[0] = 0; b[0] + 1 < m_lines[0].size(); ++b[0])
      for(b[1] = 0; b[1] + 1 < m_lines[1].size(); ++b[1])
        for(b[2] = 0; b[2] + 1 < m_lines[2].size(); ++b[2])
          for(std::size_t side = 0; side < 6 && is_solid(b, is_solid_at); ++side)
          {
            Indices neighbor = b;
            neighbor[side / 2] += side % 2 == 0 ? std::size_t(-1) : 1;
            if(! is_solid(neighbor, is_solid_at))
              add_side(b, side / 2, side % 2 == 1, shape);
          }
    return std::move(m_body);
  }
};

inline Body box(const Point& low, const Point& high, const double size)
{
  std::array<std::vector<double>, 3> lines;
  for(std::size_t i = 0; i < 3; ++i)
    lines[i] = graded_lines({ { low[i], size }, { high[i], size } });
  Surface_of_blocks surface(lines[0], lines[1], lines[2]);
  return surface([](const Point&) { return true; }, [](const Point& p) { return p; });
}

// A wing with the chord 3 and the span 6, swept back and blunt at its edges, and below it a pylon down to z = -0.75.
// The triangles are of the given size at the pylon, and twice as large at the tips.
inline Body wing_with_pylon(const double size)
{
  const double front = 0.7, back = 2.3, width = 0.12, bottom = -0.75;
  const auto half_thickness = [](const double x) { return 0.0825 * (1 + (std::min)(1., (std::min)(x, 3 - x) / 0.6)); };
  // Lines along the pylon are nearer to each other where it begins and ends.
  const auto narrowness = [=](const double x)
  {
    return 1 - 0.5 * (std::max)(0., 1 - (std::min)(std::abs(x - front), std::abs(x - back)) / 0.3);
  };
  const auto is_solid = [=](const Point& p)
  {
    return p[2] > 0 || (p[0] > front && p[0] < back && std::abs(p[1]) < width);
  };
  const auto shape = [=](const Point& p) // z is 0 at the lower side of the wing, 1 at the upper one, -1 at the bottom
  {
    const double t = half_thickness(p[0]), side = std::abs(p[1]);
    const double y = side <= width ? side * narrowness(p[0])
                                   : 3 - (3 - side) * ((3 - width * narrowness(p[0])) / (3 - width));
    const double z = p[2] >= 0 ? t * (2 * p[2] - 1) : -t - p[2] * (bottom + t);
    return Point{{ p[0] + 0.08 * y * y, p[1] < 0 ? -y : y, z }};
  };
  const double depth = 0.585, thickness = 0.165; // what 1 is below the wing, and in it at its edges
  std::vector<double> z = graded_lines({ { -1, size / depth }, { 0, size / depth } });
  const std::vector<double> z_in_wing = graded_lines({ { 0, 1.5 * size / thickness }, { 1, 1.5 * size / thickness } });
  z.insert(z.end(), z_in_wing.begin() + 1, z_in_wing.end());
  return Surface_of_blocks(
    graded_lines({ { 0, 2 * size }, { front, size }, { back, size }, { 3, 2 * size } }),
    graded_lines({ { -3, 2 * size }, { -width, size }, { 0, size }, { width, size }, { 3, 2 * size } }),
    z
  )(is_solid, shape);
}

// A body of revolution along x around the origin: a cylinder with the given radius, and half an ellipsoid at each end.
// It is made of a long box, of which the cubes at the ends become spheres, so that no triangle is thin.
inline Body store(const double radius, const double size)
{
  const double half_length = 2 * radius, nose = 1.8, tail = 1.4;
  const double quarter = std::atan(1.);
  const double step = size / (radius * quarter); // of lines on a side of the box, which is a quarter of the circle
  const auto shape = [=](const Point& p)
  {
    const double end = (std::max)(std::abs(p[0]) - 1, 0.);
    const Point d = {{ std::copysign(std::tan(quarter * end), p[0]),
                       std::tan(quarter * p[1]), std::tan(quarter * p[2]) }};
    const double scale = radius / std::sqrt(dot(d, d)), axis = half_length * (std::max)(-1., (std::min)(1., p[0]));
    return Point{{ axis + scale * d[0] * (p[0] > 0 ? nose : tail), scale * d[1], scale * d[2] }};
  };
  const std::vector<double> across = graded_lines({ { -1, step }, { 0, step }, { 1, step } });
  const double along = size / half_length;
  return Surface_of_blocks(
    graded_lines({ { -2, step }, { -1, step }, { 0, along }, { 1, step }, { 2, step } }), across, across
  )([](const Point&) { return true; }, shape);
}

} // namespace br3_benchmark

#endif // BR3_BENCHMARK_MOVING_BODY_H
