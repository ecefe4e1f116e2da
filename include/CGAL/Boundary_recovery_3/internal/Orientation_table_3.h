// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_ORIENTATION_TABLE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_ORIENTATION_TABLE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/Vertex_predicates_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The orientations of all quadruples of a few vertices, and the predicates that can be read off them.
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

  static constexpr std::size_t max_number_of_vertices = 28; // they are bits of 32

  explicit Orientation_table_3(const Predicates& predicates) : m_predicates(predicates) { }

  // To be called if vertices moved.
  void forget() { m_vertices.clear(); }

  // Returns false if there are too many.
  bool set_vertices(const std::vector<Vertex_handle>& vertices)
  {
    if(vertices.size() > max_number_of_vertices)
    {
      forget();
      return false;
    }
    const std::size_t smaller = (std::min)(vertices.size(), m_vertices.size());
    const auto different = std::mismatch(vertices.begin(), vertices.begin() + smaller, m_vertices.begin());
    const int same = static_cast<int>(different.first - vertices.begin());
    m_vertices = vertices;
    fill_in_sides(same);
    return true;
  }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }
  int number_of_vertices() const { return static_cast<int>(m_vertices.size()); }

  // The number of vertices if it is none of them.
  int position(const Vertex_handle v) const
  {
    return static_cast<int>(std::find(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin());
  }

  // For distinct i, j, k; 0 if l is one of them.
  int orientation(const int i, const int j, const int k, const int l) const
  {
    const Sides& s = sides(i, j, k);
    return static_cast<int>((s.positive >> l) & 1) - static_cast<int>((s.negative >> l) & 1);
  }

  bool crosses(const Edge& e, const Edge& f) const
  {
    if(e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1] || orientation(e[0], e[1], f[0], f[1]) != 0)
      return false;
    // Coplanar: seen from any vertex off their plane, each edge has the ends of the other on opposite sides.
    for(int w = 0; w < number_of_vertices(); ++w)
    {
      const int s = orientation(e[0], e[1], f[0], w), t = orientation(e[0], e[1], f[1], w);
      const int x = orientation(f[0], f[1], e[0], w), y = orientation(f[0], f[1], e[1], w);
      if(s != 0 || t != 0 || x != 0 || y != 0)
        return s * t < 0 && x * y < 0;
    }
    return false;
  }

  bool pierces(const Edge& e, const Face& f) const
  {
    const Sides& s = sides(f);
    if(((((s.positive >> e[0]) & (s.negative >> e[1])) | ((s.negative >> e[0]) & (s.positive >> e[1]))) & 1) == 0)
      return false; // both ends on the same side, or one of them in the plane
    const int side = orientation(e[0], e[1], f[0], f[1]);
    return side != 0
        && orientation(e[0], e[1], f[1], f[2]) == side
        && orientation(e[0], e[1], f[2], f[0]) == side;
  }

  // Whether a vertex is in the closed tetrahedron that is not one of its own.
  // `faces` are its faces, with the tetrahedron on their positive sides.
  bool contains_vertex(const std::array<int, 4>& v, const std::array<Face, 4>& faces) const
  {
    std::uint32_t outside = bit(v[0]) | bit(v[1]) | bit(v[2]) | bit(v[3]);
    for(const Face& f : faces)
      outside |= sides(f).negative;
    return outside != bit(number_of_vertices()) - 1;
  }

private:
  // The vertices on the positive and on the negative side of a face, as bits.
  struct Sides
  {
    std::uint32_t positive = 0, negative = 0;
  };

  static std::uint32_t bit(const int i) { return std::uint32_t(1) << i; }

  Sides& sides(const int i, const int j, const int k) { return m_sides[offset(i, j, k)]; }
  const Sides& sides(const int i, const int j, const int k) const { return m_sides[offset(i, j, k)]; }
  const Sides& sides(const Face& f) const { return sides(f[0], f[1], f[2]); }

  // Does not depend on the number of vertices, so that entries stay where they are.
  static std::size_t offset(const int i, const int j, const int k)
  {
    return (static_cast<std::size_t>(i) * max_number_of_vertices + j) * max_number_of_vertices + k;
  }

  // Orients all the quadruples; those of the first `known` vertices are known.
  void fill_in_sides(const int known)
  {
    m_sides.resize(max_number_of_vertices * max_number_of_vertices * max_number_of_vertices);
    for(int k = known; k < number_of_vertices(); ++k)
      for(int j = 0; j < k; ++j)
        for(int i = 0; i < j; ++i)
          sides(i, j, k) = Sides();
    const std::uint32_t known_bits = bit(known) - 1;
    for(int k = 0; k < known; ++k)
      for(int j = 0; j < k; ++j)
        for(int i = 0; i < j; ++i)
        {
          sides(i, j, k).positive &= known_bits;
          sides(i, j, k).negative &= known_bits;
        }
    for(int l = known; l < number_of_vertices(); ++l)
      for(int k = 0; k < l; ++k)
        for(int j = 0; j < k; ++j)
          for(int i = 0; i < j; ++i)
            store_orientation(i, j, k, l);
    copy_sides_to_permutations();
  }

  void store_orientation(const int i, const int j, const int k, const int l)
  {
    const Orientation o = m_predicates.orientation(m_vertices[i], m_vertices[j], m_vertices[k], m_vertices[l]);
    if(o == ZERO)
      return;
    std::uint32_t Sides::* const even = o == POSITIVE ? &Sides::positive : &Sides::negative;
    std::uint32_t Sides::* const odd = o == POSITIVE ? &Sides::negative : &Sides::positive;
    sides(i, j, k).*even |= bit(l);
    sides(i, j, l).*odd |= bit(k);
    sides(i, k, l).*even |= bit(j);
    sides(j, k, l).*odd |= bit(i);
  }

  void copy_sides_to_permutations()
  {
    for(int k = 0; k < number_of_vertices(); ++k)
      for(int j = 0; j < k; ++j)
        for(int i = 0; i < j; ++i)
        {
          const Sides s = sides(i, j, k);
          Sides reversed;
          reversed.positive = s.negative;
          reversed.negative = s.positive;
          sides(j, k, i) = sides(k, i, j) = s;
          sides(j, i, k) = sides(i, k, j) = sides(k, j, i) = reversed;
        }
  }

  const Predicates& m_predicates;
  std::vector<Vertex_handle> m_vertices;
  std::vector<Sides> m_sides; // by ordered triples
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_ORIENTATION_TABLE_3_H
