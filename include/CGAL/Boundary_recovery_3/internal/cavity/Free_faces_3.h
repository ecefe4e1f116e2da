// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_FACES_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_FACES_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/cavity/Polyhedron_obstacles_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Bit_matrix.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The faces between vertices of a polyhedron of which all edges are free, and that no obstacle pierces: those that can
 * be in a tetrahedralization of it. They are ordered by their vertices abc, a < b < c.
 */
template <typename Tr>
class Free_faces_3
{
public:
  typedef Polyhedron_obstacles_3<Tr>    Obstacles;
  typedef typename Obstacles::Edge      Edge;
  typedef typename Obstacles::Face      Face;
  typedef std::uint32_t                 Number; // of a face or a vertex: there may be many, so memory counts

  explicit Free_faces_3(const Obstacles& obstacles) : m_obstacles(obstacles) { }

  // `greater_ends` are, for each vertex, the other ends of the free edges, if greater.
  void collect(const Bit_matrix& greater_ends)
  {
    m_first.assign(1, 0);
    m_thirds.clear();
    m_faces.assign(n() * n(), n());
    for(std::size_t a = 0; a < n(); ++a)
      for(std::size_t b = 0; b < n(); ++b)
      {
        if(greater_ends(a, b))
          greater_ends.for_each([&](const std::size_t w) { return greater_ends.word(a, w) & greater_ends.word(b, w); },
                                [&](const std::size_t c) { this->add_face({{ a, b, c }}); });
        m_first.push_back(static_cast<Number>(m_thirds.size()));
      }
  }

  std::size_t size() const { return m_thirds.size(); }

  Face operator[](const std::size_t i) const
  {
    const std::size_t e = std::upper_bound(m_first.begin(), m_first.end(), i) - m_first.begin() - 1;
    return {{ e / n(), e % n(), m_thirds[i] }};
  }

  // The position of a face in the list of all, or their number.
  std::size_t find(const Face& f) const
  {
    const std::size_t e = pair(f[0], f[1]);
    const auto begin = m_thirds.begin() + m_first[e], end = m_thirds.begin() + m_first[e + 1];
    const auto it = std::lower_bound(begin, end, f[2]);
    return it != end && *it == f[2] ? it - m_thirds.begin() : m_thirds.size();
  }

  // The faces abc for given a and b are those from the first position to the last one, which is excluded.
  Number begin_at(const std::size_t a, const std::size_t b) const { return m_first[pair(a, b)]; }
  Number end_at(const std::size_t a, const std::size_t b) const { return m_first[pair(a, b) + 1]; }

  // The greatest vertex of the face i.
  Number third(const std::size_t i) const { return m_thirds[i]; }

  // Calls `work` with each d > c that makes the faces abd, acd and bcd, for a < b < c, in increasing order.
  template <typename Work>
  void for_each_common_third(const std::size_t a, const std::size_t b, const std::size_t c, const Work& work) const
  {
    const auto thirds = [&](const std::size_t w)
    {
      return m_faces.word(pair(a, b), w) & m_faces.word(pair(a, c), w) & m_faces.word(pair(b, c), w);
    };
    m_faces.for_each(thirds, work);
  }

private:
  std::size_t n() const { return m_obstacles.number_of_vertices(); }
  std::size_t pair(const std::size_t a, const std::size_t b) const { return a * n() + b; }

  void add_face(const Face& f)
  {
    if(! is_free(f))
      return;
    m_thirds.push_back(static_cast<Number>(f[2]));
    m_faces.set(pair(f[0], f[1]), f[2]);
  }

  // Whether no obstacle pierces the face, of which all edges are free. Where a surface of obstacles passes through it,
  // this starts at one of its vertices, mostly, so it is enough to look there; what is overlooked, Face_matching finds.
  bool is_free(const Face& f) const
  {
    const Bit_matrix& stars = m_obstacles.sides().stars;
    for(int k = 0; k < 3; ++k)
    {
      const std::size_t v = f[k], b = f[(k + 1) % 3], c = f[(k + 2) % 3];
      const auto separating_faces = [&](const std::size_t w)
      {
        return stars.word(v, w) & m_obstacles.separating(b, c, w);
      };
      if(stars.any_of(separating_faces, [&](const std::size_t i) { return this->pierces_at_vertex(i, v, b, c); }))
        return false;
    }
    return std::none_of(m_obstacles.inner_edges().begin(), m_obstacles.inner_edges().end(),
                        [&](const Edge& e) { return this->pierces(e, f); });
  }

  // Whether the opposite edge of v in a face of the obstacles, which has b and c on opposite sides, pierces vbc.
  bool pierces_at_vertex(const std::size_t i, const std::size_t v, const std::size_t b, const std::size_t c) const
  {
    const Face& f = m_obstacles.faces()[i];
    const std::size_t k = std::find(f.begin(), f.end(), v) - f.begin();
    const Edge e = {{ f[(k + 1) % 3], f[(k + 2) % 3] }};
    const bool is_b_positive = m_obstacles.sides().positive(b, i); // the line of e passes b there, too
    return m_obstacles.orientation(e, b, c) == (is_b_positive ? POSITIVE : NEGATIVE)
        && m_obstacles.orientation({{ v, b, c }}, e[0]) * m_obstacles.orientation({{ v, b, c }}, e[1]) == NEGATIVE;
  }

  bool pierces(const Edge& e, const Face& f) const
  {
    const auto& v = m_obstacles.vertices();
    return m_obstacles.predicates().segment_pierces_triangle(v[e[0]], v[e[1]], v[f[0]], v[f[1]], v[f[2]]);
  }

  const Obstacles& m_obstacles;
  Bit_matrix m_faces;            // for each pair of vertices, the third ones of its faces, if greater
  std::vector<Number> m_first;   // of each pair of vertices, where its faces begin
  std::vector<Number> m_thirds;  // of the faces at one edge after the other, their greatest vertices
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_CAVITY_FREE_FACES_3_H
