// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_RING_TRIANGULATIONS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_RING_TRIANGULATIONS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <CGAL/enum.h>

#include <boost/container/small_vector.hpp>
#include <boost/container/vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Geometric validity of the elements that a partial triangulation of the skirt polygon of a shell stands for.
 *
 * The infinite vertex may be an ear of the skirt polygon only, and only if the two facets of the convex hull at ab are
 * coplanar and form a strictly convex quadrilateral: then exchanging its diagonals leaves the hull as it is.
 */
template <typename Tr>
class Shell_positivity_3
{
public:
  typedef Shell_3<Tr>              Shell;
  typedef Vertex_predicates_3<Tr>  Predicates;

  Shell_positivity_3(const Shell& shell, const Predicates& predicates)
    : m_shell(shell), m_predicates(predicates)
  { }

  // Whether conv(t,a) and conv(t,b) are positive for t = p_i p_k p_j.
  bool is_triangle_positive(const int i, const int k, const int j) const
  {
    const int h = m_shell.infinite_index();
    if(h == i || h == k || h == j)
      return (h == k && is_hull_ear(i, h, j)) || (h == i && is_hull_ear(j, h, k)) || (h == j && is_hull_ear(k, h, i));
    return m_predicates.orientation(m_shell.vertex(i), m_shell.vertex(k), m_shell.vertex(j), m_shell.b()) == POSITIVE
        && m_predicates.orientation(m_shell.vertex(i), m_shell.vertex(k), m_shell.vertex(j), m_shell.a()) == NEGATIVE;
  }

  // Whether the tetrahedron a b p_i p_j of a core is positive.
  bool is_core_edge_positive(const int i, const int j) const
  {
    if(j == m_shell.next(i))
      return true;
    const int h = m_shell.infinite_index();
    return h != i && h != j
        && m_predicates.orientation(m_shell.a(), m_shell.b(), m_shell.vertex(i), m_shell.vertex(j)) == POSITIVE;
  }

private:
  bool is_hull_ear(const int i, const int h, const int j) const
  {
    return m_shell.next(i) == h && m_shell.next(h) == j
        && m_predicates.segments_cross(m_shell.a(), m_shell.b(), m_shell.vertex(i), m_shell.vertex(j));
  }

  const Shell& m_shell;
  const Predicates& m_predicates;
};

// A set of positions in the skirt polygon of a shell.
typedef Bits Positions;

constexpr int max_number_of_positions = max_number_of_bits;

/*
 * Pairs of positions: for each first one, the set of the second ones. Most of the entries of the matrices do not exist;
 * sets tell quickly where there is none, and are quickly emptied for the next shell.
 */
class Position_pairs
{
public:
  void clear(const int degree) { std::fill_n(m_seconds.begin(), degree, 0); }

  void insert(const int i, const int j) { m_seconds[i] |= internal::bit(j); }

  bool contains(const int i, const int j) const { return internal::has_bit(m_seconds[i], j); }

  Positions operator[](const int i) const { return m_seconds[i]; }

private:
  std::array<Positions, max_number_of_positions> m_seconds;
};

/*
 * A value for each row and position. Values are written before they are read, so they need not be initialized for each
 * shell.
 */
template <typename Value>
class Position_matrix
{
public:
  void assign(const int number_of_rows, const int degree)
  {
    m_degree = degree;
    const std::size_t n = static_cast<std::size_t>(number_of_rows) * degree;
    if(m_values.size() < n)
      m_values.resize(n);
  }

  Value& operator()(const int i, const int j) { return m_values[i * m_degree + j]; }
  const Value& operator()(const int i, const int j) const { return m_values[i * m_degree + j]; }

private:
  boost::container::vector<Value> m_values; // where bool is a type like any other
  int m_degree = 0;
};

/*
 * What is known of the triangles and chords of the skirt polygon of a shell: whether they are valid, and the values of
 * the triangles. Each is asked for once at most.
 */
template <typename Tr, typename Quality, typename Validity>
class Shell_elements_3
{
public:
  typedef Shell_3<Tr>              Shell;
  typedef Vertex_predicates_3<Tr>  Predicates;
  typedef typename Quality::Value  Value;

  Shell_elements_3(const Predicates& predicates, const Quality& quality, const Validity& validity)
    : m_predicates(predicates), m_quality(quality), m_validity(validity)
  { }

  // Nothing is known yet.
  void assign(const Shell& shell)
  {
    m_shell = &shell;
    m = shell.degree();
    const std::size_t number_of_triangles = m * m * m;
    m_triangles.assign(number_of_triangles, UNKNOWN);
    if(m_triangle_values.size() < number_of_triangles)
      m_triangle_values.resize(number_of_triangles);
    m_known_chords.clear(m);
    m_valid_chords.clear(m);
  }

  // For i < j.
  bool is_valid_chord(const int i, const int j)
  {
    if(! m_known_chords.contains(i, j))
    {
      m_known_chords.insert(i, j);
      if(m_validity.is_valid_chord(*m_shell, i, j))
        m_valid_chords.insert(i, j);
    }
    return m_valid_chords.contains(i, j);
  }

  bool is_valid_triangle(int i, int k, int j)
  {
    unsigned char& state = m_triangles[triangle(i, k, j)];
    if(state == UNKNOWN)
      state = Shell_positivity_3<Tr>(*m_shell, m_predicates).is_triangle_positive(i, k, j)
           && m_validity.is_valid_triangle(*m_shell, i, k, j) ? VALID : INVALID;
    return state != INVALID;
  }

  // Of a valid triangle.
  const Value& triangle_value(int i, int k, int j)
  {
    const int t = triangle(i, k, j);
    if(m_triangles[t] == VALID)
    {
      m_triangles[t] = VALUED;
      m_triangle_values[t] = m_quality.of_triangle(*m_shell, i, k, j);
    }
    return m_triangle_values[t];
  }

private:
  enum Triangle_state { UNKNOWN, INVALID, VALID, VALUED };

  // Where what is known of a triangle is stored. The same one comes in three rotations; this makes i the smallest.
  int triangle(int& i, int& k, int& j) const
  {
    while(k < i || j < i)
    {
      const int first = i;
      i = k; k = j; j = first;
    }
    return (i * m + k) * m + j;
  }

  const Predicates& m_predicates;
  const Quality& m_quality;
  const Validity& m_validity;

  const Shell* m_shell = nullptr;
  int m = 0;
  std::vector<unsigned char> m_triangles;            // what is known of each triangle
  boost::container::vector<Value> m_triangle_values; // of those that are VALUED
  Position_pairs m_known_chords;                     // i < j for which the validity was asked for
  Position_pairs m_valid_chords;                     // those of them that are valid
};

/*
 * The best triangulations of the rings of a shell: the dynamic program of [CZZ+17, Alg. 2]. The ring R_ij is the
 * polygon of the positions from i to j on the skirt polygon, closed by the chord p_j p_i.
 *
 * M_q holds the best value of each ring, M_k the apex of the triangle at its chord in the best triangulation. At first
 * it is only found out which rings can be triangulated at all; values are computed where somebody asks. The time is
 * O(m^3), m being the degree of the shell.
 *
 * Ties are broken so that the outcome is unique: in each ring the first apex is taken, counted from its start.
 */
template <typename Tr, typename Quality, typename Validity>
class Ring_triangulations_3
{
public:
  typedef Shell_3<Tr>              Shell;
  typedef Vertex_predicates_3<Tr>  Predicates;
  typedef typename Quality::Value  Value;

  Ring_triangulations_3(const Predicates& predicates, const Quality& quality, const Validity& validity)
    : m_quality(quality), m_elements(predicates, quality, validity)
  { }

  // The edges of the skirt polygon are the only rings yet. The positions in `kept` are to stay in the core, so they are
  // no apices.
  void assign(const Shell& shell, const Positions kept)
  {
    m_shell = &shell;
    m_kept = kept;
    m_elements.assign(shell);
    const int m = shell.degree();
    for(Position_pairs* const pairs : { &m_rings_from, &m_rings_to, &m_known_values })
      pairs->clear(m);
    m_apices.assign(m, m);
    m_best_apex.assign(m, m);
    m_value.assign(m, m);
    for(int i = 0; i < m; ++i)
    {
      const int j = shell.next(i);
      set_ring(i, j, ring_edge);
      m_known_values.insert(i, j);
      m_value(i, j) = m_quality.best();
    }
  }

  // Those that do not contain the arc from the last position to the first.
  void fill_in_straight_rings()
  {
    const int m = m_shell->degree();
    for(int d = 2; d < m; ++d)
      for(int i = 0; i + d < m; ++i)
        fill_in_ring(i, i + d);
  }

  // The others, after those, but for the longest: a core has three arcs or more.
  void fill_in_wrapped_rings()
  {
    const int m = m_shell->degree();
    for(int d = 2; d + 1 < m; ++d)
      for(int i = m - d; i < m; ++i)
        fill_in_ring(i, i + d - m);
  }

  // Whether R_ij can be triangulated.
  bool has_ring(const int i, const int j) const { return m_rings_from.contains(i, j); }

  // The best value of what covers the ring R_ij, its chord included. In most shells nobody asks: there is nothing to
  // choose from. The depth of the recursion is less than the degree.
  const Value& value(const int i, const int j)
  {
    Value& best = m_value(i, j);
    if(m_known_values.contains(i, j))
      return best;
    m_known_values.insert(i, j);
    int& apex = m_best_apex(i, j);
    apex = Shell::none;
    for(int k = m_shell->next(i); k != j; k = m_shell->next(k))
    {
      if(! internal::has_bit(m_apices(i, j), k) || ! m_elements.is_valid_triangle(i, k, j))
        continue;
      const Value q = m_quality.combine(m_quality.combine(value(i, k), value(k, j)),
                                        m_elements.triangle_value(i, k, j));
      if(apex == Shell::none || best < q)
      {
        apex = k;
        best = q;
      }
    }
    if(j != m_shell->previous(i))
      best = m_quality.combine(best, m_quality.of_chord(*m_shell, i, j));
    return best;
  }

  // Appends the triangles (i, k, j) of the best triangulation of R_ij. Iterative, since the depth of the triangulation
  // is not bounded by anything small.
  template <typename Triangles>
  void triangulate(const int from, const int to, Triangles& triangles)
  {
    boost::container::small_vector<std::array<int, 2>, 16> rings;
    rings.push_back({{ from, to }});
    while(! rings.empty())
    {
      const std::array<int, 2> r = rings.back();
      rings.pop_back();
      if(m_apices(r[0], r[1]) == ring_edge)
        continue;
      const int k = best_apex(r[0], r[1]);
      triangles.push_back({{ r[0], k, r[1] }});
      rings.push_back({{ k, r[1] }});
      rings.push_back({{ r[0], k }});
    }
  }

private:
  static constexpr Positions ring_edge = 0; // no apex: the ring is one edge of the skirt polygon

  void set_ring(const int i, const int j, const Positions apices)
  {
    m_rings_from.insert(i, j);
    m_rings_to.insert(j, i);
    m_apices(i, j) = apices;
  }

  // One apex is enough for a ring; the others are looked at if it matters which of them is the best.
  void fill_in_ring(const int i, const int j)
  {
    Positions apices = m_rings_from[i] & m_rings_to[j] & ~m_kept;
    while(apices != 0)
    {
      const int k = internal::next_bit_on_circle(apices, i);
      if(m_elements.is_valid_triangle(i, k, j))
        break;
      apices &= ~internal::bit(k);
    }
    // p_j p_i may be an edge of the skirt polygon: then it is no chord; both rings at a chord ask whether it is valid
    if(apices != 0
       && (j == m_shell->previous(i) || m_elements.is_valid_chord((std::min)(i, j), (std::max)(i, j))))
      set_ring(i, j, apices);
  }

  // For a ring that is more than an edge.
  int best_apex(const int i, const int j)
  {
    const Positions apices = m_apices(i, j);
    if(internal::is_single_bit(apices))
      return internal::lowest_bit(apices);
    value(i, j);
    return m_best_apex(i, j);
  }

  const Quality& m_quality;
  Shell_elements_3<Tr, Quality, Validity> m_elements;

  const Shell* m_shell = nullptr;
  Positions m_kept = 0;
  Position_pairs m_rings_from;          // for each i the j for which R_ij can be triangulated
  Position_pairs m_rings_to;            // for each j the i
  Position_matrix<Positions> m_apices;  // of each ring; some may turn out not to be valid, but not the first
  Position_pairs m_known_values;        // for each i the j for which M_k and M_q are known
  Position_matrix<int> m_best_apex;     // the matrix M_k
  Position_matrix<Value> m_value;       // the matrix M_q
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_RING_TRIANGULATIONS_3_H
