// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_ORIENTATION_TABLE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_ORIENTATION_TABLE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * The orientations of all quadruples of a few vertices, and the predicates that can be read off them, for many vertices
 * at a time.
 *
 * Vertices are given by their positions in the list of vertices. As long as the first vertices of the next list are
 * those of the last one, their orientations are kept.
 */
template <typename Tr>
class Orientation_table_3
{
public:
  typedef typename Tr::Vertex_handle    Vertex_handle;
  typedef Vertex_predicates_3<Tr>       Predicates;
  typedef std::array<int, 2>            Edge;
  typedef std::array<int, 3>            Face;
  typedef Bits                          Vertex_set;

  static constexpr std::size_t max_number_of_vertices = 63; // one less than bits, for all()

  // The vertices on the positive and on the negative side of a face.
  struct Sides
  {
    Vertex_set positive = 0, negative = 0;
  };

  explicit Orientation_table_3(const Predicates& predicates) : m_predicates(predicates) { }

  // To be called if vertices moved.
  void forget() { m_vertices.clear(); }

  // At most `max_number_of_vertices`.
  void set_vertices(const std::vector<Vertex_handle>& vertices)
  {
    CGAL_precondition(vertices.size() <= max_number_of_vertices);
    const std::size_t smaller = (std::min)(vertices.size(), m_vertices.size());
    const auto different = std::mismatch(vertices.begin(), vertices.begin() + smaller, m_vertices.begin());
    const int same = static_cast<int>(different.first - vertices.begin());
    m_vertices = vertices;
    fill_in_sides(same);
  }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }
  int number_of_vertices() const { return static_cast<int>(m_vertices.size()); }

  // The number of vertices if it is none of them.
  int position(const Vertex_handle v) const
  {
    return static_cast<int>(std::find(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin());
  }

  static Vertex_set set_of(const int i) { return internal::bit(i); }

  static Vertex_set set_of(const Edge& e) { return set_of(e[0]) | set_of(e[1]); }

  Vertex_set all() const { return internal::bits_before(number_of_vertices()); }

  // For distinct vertices of the face; they are on none of its sides.
  Sides sides(Face f) const
  {
    const bool is_odd = sort(f);
    Sides result = m_sides[first_index(f[1], f[2]) + f[0]];
    if(is_odd)
      std::swap(result.positive, result.negative);
    return result;
  }

  // The vertices b such that the edge ab crosses the interior of the face in a point. `a` is on its positive side.
  Vertex_set ends_of_piercing_edges(const Face& f, const int a) const
  {
    Vertex_set result = sides(f).negative;
    for(int k = 0; k < 3 && result != 0; ++k)
      result &= sides({{ f[k], f[(k + 1) % 3], a }}).negative;
    return result;
  }

  // The vertices k such that the edge e crosses the interior of the face ijk in a point, where f is the edge ij.
  Vertex_set apexes_of_pierced_faces(const Edge& e, const Edge& f) const
  {
    if((set_of(e) & set_of(f)) != 0)
      return 0;
    const Sides x = sides({{ e[0], e[1], f[0] }}), y = sides({{ e[0], e[1], f[1] }});
    const Vertex_set through // the line of e crosses ijk
      = (x.positive & set_of(f[1])) != 0 ? x.negative & y.positive
      : (x.negative & set_of(f[1])) != 0 ? x.positive & y.negative : 0;
    if(through == 0)
      return 0;
    const Sides s = sides({{ f[0], f[1], e[0] }}), t = sides({{ f[0], f[1], e[1] }});
    return through & ((s.positive & t.negative) | (s.negative & t.positive));
  }

  // The vertices b such that the edges ab and e are in a plane and cross in a point inside both.
  Vertex_set ends_of_crossing_edges(const Edge& e, const int a) const
  {
    if(a == e[0] || a == e[1])
      return 0;
    const Sides s = sides({{ e[0], e[1], a }});
    Vertex_set result = 0;
    internal::for_each_bit(all() & ~(s.positive | s.negative | set_of(e) | set_of(a)), [&](const int b)
    {
      if(is_crossed(e, {{ a, b }}))
        result |= set_of(b);
    });
    return result;
  }

  // Whether a vertex is in the closed tetrahedron of the face and the vertex v that is none of its own. `v` is on the
  // positive side of the face.
  bool contains_vertex(const Face& f, const int v) const
  {
    Vertex_set outside = sides(f).negative | set_of(f[0]) | set_of(f[1]) | set_of(f[2]) | set_of(v);
    for(int k = 0; k < 3; ++k)
      outside |= sides({{ f[k], f[(k + 1) % 3], v }}).positive;
    return outside != all();
  }

private:
  // For four vertices in a plane: seen from any vertex off the plane, each edge has the ends of the other one on
  // opposite sides.
  bool is_crossed(const Edge& e, const Edge& f) const
  {
    const Sides s = sides({{ e[0], e[1], f[0] }}), t = sides({{ e[0], e[1], f[1] }});
    const Sides x = sides({{ f[0], f[1], e[0] }}), y = sides({{ f[0], f[1], e[1] }});
    return ((s.positive & t.negative) | (s.negative & t.positive)) != 0
        && ((x.positive & y.negative) | (x.negative & y.positive)) != 0;
  }

  // Returns whether the number of exchanges is odd.
  static bool sort(Face& f)
  {
    bool is_odd = false;
    const auto exchange = [&](int& i, int& j) { if(i > j) { std::swap(i, j); is_odd = ! is_odd; } };
    exchange(f[0], f[1]);
    exchange(f[1], f[2]);
    exchange(f[0], f[1]);
    return is_odd;
  }

  // Of n vertices; one of the factors is 0 if n < 3.
  static std::size_t number_of_faces(const std::size_t n) { return n * (n - 1) * (n - 2) / 6; }

  // The index of the first of the faces ijk, i < j < k: all those with smaller k are before them, then those with the
  // same k and smaller j.
  static std::size_t first_index(const int j, const int k)
  {
    return number_of_faces(k) + static_cast<std::size_t>(j) * (j - 1) / 2;
  }

  // Orients all the quadruples; those of the first `known` vertices are known.
  void fill_in_sides(const int known)
  {
    m_sides.resize(number_of_faces(known));
    for(Sides& s : m_sides)
    {
      s.positive &= internal::bits_before(known);
      s.negative &= internal::bits_before(known);
    }
    m_sides.resize(number_of_faces(number_of_vertices()));
    for(int l = known; l < number_of_vertices(); ++l)
      for(int k = 0; k < l; ++k)
        for(int j = 0; j < k; ++j)
          for(int i = 0; i < j; ++i)
            store_orientation(i, j, k, l);
  }

  // For i < j < k < l.
  void store_orientation(const int i, const int j, const int k, const int l)
  {
    const Orientation o = m_predicates.orientation(m_vertices[i], m_vertices[j], m_vertices[k], m_vertices[l]);
    if(o == ZERO)
      return;
    Vertex_set Sides::* const even = o == POSITIVE ? &Sides::positive : &Sides::negative;
    Vertex_set Sides::* const odd = o == POSITIVE ? &Sides::negative : &Sides::positive;
    m_sides[first_index(j, k) + i].*even |= set_of(l);
    m_sides[first_index(j, l) + i].*odd |= set_of(k);
    m_sides[first_index(k, l) + i].*even |= set_of(j);
    m_sides[first_index(k, l) + j].*odd |= set_of(i);
  }

  const Predicates& m_predicates;
  std::vector<Vertex_handle> m_vertices;
  std::vector<Sides> m_sides; // by index, seen from where i, j, k with i < j < k are counterclockwise
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_GEOMETRY_ORIENTATION_TABLE_3_H
