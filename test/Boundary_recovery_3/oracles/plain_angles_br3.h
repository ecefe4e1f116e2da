// Angles of tetrahedra and triangles as one learns them at school, in degrees.

#ifndef BR3_TEST_PLAIN_ANGLES_H
#define BR3_TEST_PLAIN_ANGLES_H

#include <algorithm>
#include <array>
#include <cmath>

namespace br3_test {

typedef std::array<double, 3> Vector;
typedef std::array<Vector, 4> Corners;

inline Vector minus(const Vector& p, const Vector& q) { return {{ p[0] - q[0], p[1] - q[1], p[2] - q[2] }}; }

inline double scalar(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

inline Vector cross(const Vector& u, const Vector& v)
{
  return {{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] }};
}

inline double length(const Vector& u) { return std::sqrt(scalar(u, u)); }

inline double distance(const Vector& p, const Vector& q) { return length(minus(p, q)); }

// Between two vectors.
inline double angle(const Vector& u, const Vector& v)
{
  return std::atan2(length(cross(u, v)), scalar(u, v)) * 180 / 3.14159265358979323846;
}

// Between two half-planes from the line through p and q, to r and to s: the angle of their heights above the line.
inline double angle_between(const Vector& p, const Vector& q, const Vector& r, const Vector& s)
{
  const Vector along = minus(q, p);
  const auto height = [&](const Vector& x)
  {
    const double t = scalar(minus(x, p), along) / scalar(along, along);
    return minus(minus(x, p), {{ t * along[0], t * along[1], t * along[2] }});
  };
  return angle(height(r), height(s));
}

// At the edges 01, 02, 03, 12, 13, 23.
inline std::array<double, 6> dihedral_angles(const Corners& p)
{
  return {{ angle_between(p[0], p[1], p[2], p[3]), angle_between(p[0], p[2], p[1], p[3]),
            angle_between(p[0], p[3], p[1], p[2]), angle_between(p[1], p[2], p[0], p[3]),
            angle_between(p[1], p[3], p[0], p[2]), angle_between(p[2], p[3], p[0], p[1]) }};
}

inline double smallest_plane_angle(const std::array<Vector, 3>& p)
{
  return (std::min)({ angle(minus(p[1], p[0]), minus(p[2], p[0])), angle(minus(p[2], p[1]), minus(p[0], p[1])),
                      angle(minus(p[0], p[2]), minus(p[1], p[2])) });
}

inline double smallest(const std::array<double, 6>& angles) { return *std::min_element(angles.begin(), angles.end()); }

inline double largest(const std::array<double, 6>& angles) { return *std::max_element(angles.begin(), angles.end()); }

inline double volume_times_6(const Corners& p)
{
  return scalar(minus(p[1], p[0]), cross(minus(p[2], p[0]), minus(p[3], p[0])));
}

inline double area(const Vector& p, const Vector& q, const Vector& r)
{
  return length(cross(minus(q, p), minus(r, p))) / 2;
}

// 3 times the inradius over the circumradius; that one by the products of the lengths of opposite edges, as in the
// formula of Crelle.
inline double radius_ratio(const Corners& p)
{
  const double volume = std::abs(volume_times_6(p)) / 6;
  const double areas = area(p[0], p[1], p[2]) + area(p[0], p[1], p[3]) +
                       area(p[0], p[2], p[3]) + area(p[1], p[2], p[3]);
  const double a = distance(p[0], p[1]) * distance(p[2], p[3]), b = distance(p[0], p[2]) * distance(p[1], p[3]);
  const double c = distance(p[0], p[3]) * distance(p[1], p[2]);
  const double product = (a + b + c) * (a + b - c) * (a - b + c) * (-a + b + c);
  const double circumradius = std::sqrt((std::max)(0., product)) / (24 * volume);
  return 3 * (3 * volume / areas) / circumradius;
}

} // namespace br3_test

#endif // BR3_TEST_PLAIN_ANGLES_H
