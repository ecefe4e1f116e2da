// Exact geometry of lattice points, written with coordinates of intersection points and not with orientations, so that
// it shares nothing with what it is to check. Coordinates below 2^12 keep every product inside 128 bits.

#ifndef BR3_TEST_REFERENCE_GEOMETRY_H
#define BR3_TEST_REFERENCE_GEOMETRY_H

#include "random_triangulations_br3.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace br3_test {

typedef boost::multiprecision::int128_t Wide;

struct Vector { Wide x, y, z; };

inline Vector operator-(const Lattice_point& q, const Lattice_point& p) { return { q.x - p.x, q.y - p.y, q.z - p.z }; }
inline Wide dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
inline bool is_zero(const Vector& u) { return u.x == 0 && u.y == 0 && u.z == 0; }

inline Vector cross(const Vector& u, const Vector& v)
{
  return { u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x };
}

inline Wide determinant(const Vector& u, const Vector& v, const Vector& w) { return dot(u, cross(v, w)); }
inline int sign(const Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Six times the signed volume.
inline Wide volume(const Lattice_point& p, const Lattice_point& q, const Lattice_point& r, const Lattice_point& s)
{
  return determinant(q - p, r - p, s - p);
}

// A fraction with a positive denominator.
struct Fraction
{
  Wide numerator, denominator;

  Fraction(const Wide n, const Wide d) : numerator(d < 0 ? -n : n), denominator(d < 0 ? -d : d) { }
  bool is_inside_unit_interval() const { return 0 < numerator && numerator < denominator; }

  friend bool operator<(const Fraction& x, const Fraction& y)
  {
    return x.numerator * y.denominator < y.numerator * x.denominator;
  }
};

// Whether w is in the open segment uv.
inline bool is_in_open_segment(const Lattice_point& u, const Lattice_point& v, const Lattice_point& w)
{
  const Wide t = dot(v - u, w - u);
  return is_zero(cross(v - u, w - u)) && 0 < t && t < dot(v - u, v - u);
}

// Whether the point w of the plane of the triangle pqr is inside it; with `is_closed`, also on its rim.
inline bool is_in_triangle(const Lattice_point& p, const Lattice_point& q, const Lattice_point& r,
                           const Lattice_point& w, const bool is_closed)
{
  const Vector n = cross(q - p, r - p);
  const int least = is_closed ? 0 : 1;
  return dot(n, w - p) == 0 && sign(dot(n, cross(q - p, w - p))) >= least
      && sign(dot(n, cross(r - q, w - q))) >= least && sign(dot(n, cross(p - r, w - r))) >= least;
}

// The place t of the crossing u + t (v - u) of two segments, if they have exactly one point in common, and that is
// inside both.
inline bool find_crossing(const Lattice_point& u, const Lattice_point& v,
                          const Lattice_point& p, const Lattice_point& q, Fraction& t)
{
  const Vector n = cross(v - u, q - p);
  if(is_zero(n) || dot(n, p - u) != 0)
    return false;
  // u + t (v - u) = p + s (q - p), multiplied by (q - p) and by (v - u)
  const Wide square = dot(n, n);
  t = Fraction(dot(cross(p - u, q - p), n), square);
  const Fraction s(dot(cross(p - u, v - u), n), square);
  return t.is_inside_unit_interval() && s.is_inside_unit_interval();
}

// The same for the point where a segment pierces a triangle: the only common one, and inside both.
inline bool find_crossing(const Lattice_point& u, const Lattice_point& v,
                          const Lattice_point& p, const Lattice_point& q, const Lattice_point& r, Fraction& t)
{
  // u + t (v - u) = p + x (q - p) + y (r - p), by Cramer's rule
  const Wide d = determinant(u - v, q - p, r - p);
  if(d == 0)
    return false;
  t = Fraction(determinant(u - p, q - p, r - p), d);
  const Fraction x(determinant(u - v, u - p, r - p), d), y(determinant(u - v, q - p, u - p), d);
  return t.is_inside_unit_interval() && x.numerator > 0 && y.numerator > 0 && x.numerator + y.numerator < x.denominator;
}

inline bool do_cross(const Lattice_point& u, const Lattice_point& v, const Lattice_point& p, const Lattice_point& q)
{
  Fraction t(0, 1);
  return find_crossing(u, v, p, q, t);
}

inline bool does_pierce(const Lattice_point& u, const Lattice_point& v,
                        const Lattice_point& p, const Lattice_point& q, const Lattice_point& r)
{
  Fraction t(0, 1);
  return find_crossing(u, v, p, q, r, t);
}

} // namespace br3_test

#endif // BR3_TEST_REFERENCE_GEOMETRY_H
