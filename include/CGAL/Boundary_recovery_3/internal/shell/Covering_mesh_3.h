// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_COVERING_MESH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_COVERING_MESH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Partial_triangulation.h>
#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <boost/container/small_vector.hpp>
#include <boost/container/vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Geometric validity of the elements that a partial triangulation of the skirt polygon of a shell stands for.
 *
 * The infinite vertex may be an ear of the skirt polygon only, and only if the two facets of the convex hull at ab are
 * coplanar and form a strictly convex quadrilateral: then exchanging its diagonals leaves the hull as it is.
 */
template <typename Tr>
class Shell_positivity
{
public:
  typedef Shell_3<Tr>              Shell;
  typedef Vertex_predicates_3<Tr>  Predicates;

  Shell_positivity(const Shell& shell, const Predicates& predicates)
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

/*
 * Searches the optimal covering mesh of a shell: steps 1 to 4 of [CZZ+17, Alg. 3].
 *
 * Instead of enumerating all the cycles of the triangulation graph, a second dynamic program finds the best core of
 * each size: over the cores with the smallest position s, `m_suffix[t](i)` is the best value of t arcs that lead from i
 * back to s. The time is O(m^3) for the matrices and O(m^4) for the cores, m being the degree of the shell.
 *
 * Ties are broken so that the outcome is unique: among equal vectors the lexicographically smallest core, and in
 * each ring the first apex, counted from its start.
 */
template <typename Tr, typename Quality, typename Validity>
class Covering_mesh_search
{
public:
  typedef Shell_3<Tr>                 Shell;
  typedef Vertex_predicates_3<Tr>     Predicates;
  typedef typename Quality::Value     Value;

  static constexpr int none = Shell::none;
  static constexpr int max_degree = 63; // positions are bits

  Covering_mesh_search(const Predicates& predicates, const Quality& quality, const Validity& validity)
    : m_predicates(predicates), m_quality(quality), m_validity(validity)
  { }

  // Finds the best covering mesh of `shell`, where the face a b p_f is to be avoided (f may be none).
  // If `keeps_edge`, ab stays; skirt vertices for which `is_kept(i)` holds stay in the core, i.e. the face a b p_i
  // stays. Returns false if that is the covering mesh that is there.
  // If `only_if_done`, only those covering meshes are searched that do what is asked for: avoid that face, or lose ab.
  template <typename IsKept>
  bool operator()(const Shell& shell, const int f, const bool keeps_edge, const IsKept& is_kept,
                  const bool only_if_done = false)
  {
    CGAL_precondition(shell.degree() <= max_degree);
    m_shell = &shell;
    m = shell.degree();
    m_f = f;
    m_keeps_edge = keeps_edge;
    m_kept = 0;
    for(int i = 0; i < m; ++i)
      if(is_kept(i))
        m_kept |= only(i);
    choose_covering_mesh(only_if_done);
    if(m_best.core_size < 0 || m_best.core_size == m)
      return false;
    build_partial_triangulation();
    return true;
  }

  // The outcome of the last search that returned true.
  const Partial_triangulation& partial_triangulation() const { return m_result; }

private:
  struct Candidate
  {
    int core_size = -1;     // n; -1: none yet
    int start = 0;          // smallest position of the core
    bool avoids = false;    // Q' = 1
    Value value = Value();  // Q, where it can matter
  };

  // A set of positions in the skirt polygon. Most of the entries of the matrices do not exist; sets tell quickly where
  // there is none, and are quickly emptied for the next shell.
  typedef std::uint64_t Positions;
  typedef std::array<Positions, max_degree> Table; // a set for each position

  static Positions only(const int i) { return Positions(1) << i; }
  static Positions after(const int i) { return ~Positions(0) << i << 1; }
  static bool contains(const Positions positions, const int i) { return (positions >> i & 1) != 0; }

  int at(const int i, const int j) const { return i * m + j; }
  bool has_ring(const int i, const int j) const { return contains(m_rings_from[i], j); }

  // [CZZ+17, Alg. 2] in two parts. A complete reduction is made of rings that do not contain the arc from the last
  // position to the first, so the first part tells whether there is one; in most cases it also is the end.
  void choose_covering_mesh(const bool only_if_done)
  {
    m_best = Candidate();
    start_matrices();
    for(int d = 2; d < m; ++d)
      for(int i = 0; i + d < m; ++i)
        fill_in_ring(i, i + d);
    if(! m_keeps_edge && has_ring(0, m - 1))
    {
      m_best.core_size = 0;
      m_best.avoids = true;
      if(! Quality::is_first_in_vector)
        return; // [1, N_big, Q] cannot be beaten
      m_best.value = ring_value(0, m - 1);
    }
    if(only_if_done && m_f == none)
      return;
    for(int d = 2; d + 1 < m; ++d) // a core has three arcs or more
      for(int i = m - d; i < m; ++i)
        fill_in_ring(i, i + d - m);
    choose_core(only_if_done);
  }

  void start_matrices()
  {
    clear(m_rings_from);
    clear(m_rings_to);
    clear(m_known_chords);
    clear(m_valid_chords);
    clear(m_known_values);
    make_room(m_apices, m * m);
    make_room(m_best_apex, m * m);
    make_room(m_value, m * m);
    m_triangles.assign(m * m * m, UNKNOWN);
    make_room(m_triangle_values, m * m * m);
    for(int i = 0; i < m; ++i)
    {
      const int j = m_shell->next(i);
      set_ring(i, j, ring_edge);
      m_known_values[i] = only(j);
      m_value[at(i, j)] = m_quality.best();
    }
  }

  void set_ring(const int i, const int j, const Positions apices)
  {
    m_rings_from[i] |= only(j);
    m_rings_to[j] |= only(i);
    m_apices[at(i, j)] = apices;
  }

  void clear(Table& table) const { std::fill_n(table.begin(), m, 0); }

  // For values that are written before they are read: they need not be initialized for each shell.
  template <typename Vector>
  static void make_room(Vector& values, const int n)
  {
    if(values.size() < static_cast<std::size_t>(n))
      values.resize(n);
  }

  // One apex is enough for a ring; the others are looked at if it matters which of them is the best.
  void fill_in_ring(const int i, const int j)
  {
    Positions apices = m_rings_from[i] & m_rings_to[j] & ~m_kept;
    for(int k = m_shell->next(i); apices != 0; k = m_shell->next(k))
      if(contains(apices, k))
      {
        if(is_valid_triangle(i, k, j))
          break;
        apices &= ~only(k);
      }
    // p_j p_i may be an edge of the skirt polygon: then it is no chord
    if(apices != 0 && (j == m_shell->previous(i) || is_valid_chord((std::min)(i, j), (std::max)(i, j))))
      set_ring(i, j, apices);
  }

  // The best value of what covers the ring R_ij, its chord included. In most shells nobody asks: there is nothing to
  // choose from. The depth of the recursion is less than the degree.
  const Value& ring_value(const int i, const int j)
  {
    Value& value = m_value[at(i, j)];
    if(contains(m_known_values[i], j))
      return value;
    m_known_values[i] |= only(j);
    int& apex = m_best_apex[at(i, j)];
    apex = none;
    for(int k = m_shell->next(i); k != j; k = m_shell->next(k))
    {
      if(! contains(m_apices[at(i, j)], k) || ! is_valid_triangle(i, k, j))
        continue;
      const Value q = m_quality.combine(m_quality.combine(ring_value(i, k), ring_value(k, j)), triangle_value(i, k, j));
      if(apex == none || value < q)
      {
        apex = k;
        value = q;
      }
    }
    if(j != m_shell->previous(i))
      value = m_quality.combine(value, m_quality.of_chord(*m_shell, i, j));
    return value;
  }

  // For a ring that is more than an edge.
  int best_apex(const int i, const int j)
  {
    const Positions apices = m_apices[at(i, j)];
    const bool is_single = (apices & (apices - 1)) == 0;
    if(! is_single)
    {
      ring_value(i, j);
      return m_best_apex[at(i, j)];
    }
    int k = m_shell->next(i);
    while(! contains(apices, k))
      k = m_shell->next(k);
    return k;
  }

  // For i < j; both rings at a chord ask.
  bool is_valid_chord(const int i, const int j)
  {
    if(! contains(m_known_chords[i], j))
    {
      m_known_chords[i] |= only(j);
      if(m_validity.is_valid_chord(*m_shell, i, j))
        m_valid_chords[i] |= only(j);
    }
    return contains(m_valid_chords[i], j);
  }

  // Where what is known of a triangle is stored. The same one comes in three rotations; this makes i the smallest.
  int triangle(int& i, int& k, int& j) const
  {
    while(k < i || j < i)
    {
      const int first = i;
      i = k; k = j; j = first;
    }
    return at(at(i, k), j);
  }

  bool is_valid_triangle(int i, int k, int j)
  {
    unsigned char& state = m_triangles[triangle(i, k, j)];
    if(state == UNKNOWN)
      state = Shell_positivity<Tr>(*m_shell, m_predicates).is_triangle_positive(i, k, j)
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

  // The share of one arc <i,j> of a core in the quality: what covers R_ij, the tetrahedron a b p_i p_j, the face a b
  // p_i.
  const Value& arc_value(const int i, const int j)
  {
    if(! contains(m_known_arc_values[i], j))
    {
      m_known_arc_values[i] |= only(j);
      m_arc_value[at(i, j)] = m_quality.combine(ring_value(i, j),
                                                m_quality.combine(m_quality.of_core_edge(*m_shell, i, j),
                                                                  m_quality.of_core_vertex(*m_shell, i)));
    }
    return m_arc_value[at(i, j)];
  }

  // Returns whether there is an arc that is not an edge of the skirt polygon.
  bool fill_in_arcs()
  {
    bool has_chord = false;
    clear(m_arcs);
    clear(m_known_arc_values);
    make_room(m_arc_value, m * m);
    const Shell_positivity<Tr> positivity(*m_shell, m_predicates);
    for(int i = 0; i < m; ++i)
      for(int j = 0; j < m; ++j)
      {
        // R_{j-1,j} closed the long way round would be a core of two vertices
        if(! has_ring(i, j) || j == m_shell->previous(i) || ! positivity.is_core_edge_positive(i, j))
          continue;
        m_arcs[i] |= only(j);
        has_chord = has_chord || j != m_shell->next(i);
      }
    return has_chord;
  }

  // Whether an arc skips the position f. Then a core does, for all the edges of the skirt polygon are arcs, and no arc
  // leaves only one of them for the rest of the core.
  bool can_skip(const int f) const
  {
    for(int i = m_shell->next(f); i != f; i = m_shell->next(i))
      for(int j = m_shell->next(f); j != i; j = m_shell->next(j))
        if(contains(m_arcs[i], j))
          return true;
    return false;
  }

  bool is_better(const Candidate& x, const Candidate& y) const
  {
    if(y.core_size < 0)
      return true;
    const bool x_first = y.value < x.value;
    const bool y_first = x.value < y.value;
    if(Quality::is_first_in_vector && (x_first || y_first))
      return x_first;
    if(x.avoids != y.avoids)
      return x.avoids;
    if(x.core_size != y.core_size)
      return x.core_size < y.core_size;
    return x_first;
  }

  // Among the covering meshes that keep ab; m_best is the complete reduction if there is one.
  void choose_core(const bool only_if_done)
  {
    const bool has_chord = fill_in_arcs();
    if(! has_chord && m_best.core_size < 0)
    {
      m_best.core_size = m; // the covering mesh that is there
      return;
    }
    const bool can_avoid = m_f != none && can_skip(m_f);
    // A core without p_f beats all others by Q', unless Q comes first.
    if(! only_if_done && (Quality::is_first_in_vector || ! can_avoid))
      choose_core_without(none);
    if(can_avoid)
      choose_core_without(m_f);
  }

  // Tries all the cores, or those without the position `avoided`.
  void choose_core_without(const int avoided)
  {
    Candidate best; // of this call; ties between the two calls cannot occur, for they differ in Q'
    for(int s = 0; s + 3 <= m; ++s)
    {
      if(s == avoided)
        continue;
      const int limit = (! Quality::is_first_in_vector && best.core_size > 0) ? best.core_size : m - s;
      const int largest = fill_in_suffixes(s, limit, avoided);
      for(int n = 3; n <= largest; ++n)
      {
        if(! contains(m_suffixes[n], s))
          continue;
        Candidate c;
        c.core_size = n;
        c.start = s;
        c.avoids = m_f == none || avoided != none;
        c.value = m_quality.combine(m_quality.of_supporting_edge(*m_shell), m_suffix[n * m + s]);
        if(best.core_size < 0 || is_better(c, best))
        {
          best = c;
          if(is_better(c, m_best))
          {
            m_best = c;
            m_best_avoided = avoided;
          }
        }
      }
    }
  }

  // m_suffix[t * m + i]: the best value of t arcs from i to s that visit increasing positions > s only.
  // Returns the largest t for which this was computed: `largest`, or the first that closes a cycle where only that
  // matters.
  int fill_in_suffixes(const int s, const int largest, const int avoided)
  {
    m_suffixes.assign(largest + 1, 0);
    make_room(m_suffix, (largest + 1) * m);
    for(int i = s + 1; i < m; ++i)
      if(i != avoided && contains(m_arcs[i], s))
      {
        m_suffixes[1] |= only(i);
        m_suffix[m + i] = arc_value(i, s);
      }
    for(int t = 2; t <= largest && m_suffixes[t - 1] != 0; ++t)
    {
      for(int i = s; i < m; ++i)
        if(i != avoided)
          fill_in_suffix(t, i);
      if(! Quality::is_first_in_vector && contains(m_suffixes[t], s))
        return t;
    }
    return largest;
  }

  void fill_in_suffix(const int t, const int i)
  {
    const Positions nexts = m_arcs[i] & m_suffixes[t - 1] & after(i);
    for(int j = i + 1; nexts >> j != 0; ++j)
    {
      if(! contains(nexts, j))
        continue;
      const Value q = m_quality.combine(arc_value(i, j), m_suffix[(t - 1) * m + j]);
      if(! contains(m_suffixes[t], i) || m_suffix[t * m + i] < q)
      {
        m_suffixes[t] |= only(i);
        m_suffix[t * m + i] = q;
      }
    }
  }

  void build_partial_triangulation()
  {
    m_result.core.clear();
    m_result.triangles.clear();
    if(m_best.core_size == 0)
    {
      triangulate_ring(0, m - 1);
      return;
    }
    trace_core();
    const int n = m_best.core_size;
    for(int c = 0; c < n; ++c)
      triangulate_ring(m_result.core[c], m_result.core[c + 1 == n ? 0 : c + 1]);
  }

  // The lexicographically smallest core that has the best value.
  void trace_core()
  {
    const int s = m_best.start;
    fill_in_suffixes(s, m_best.core_size, m_best_avoided);
    Value prefix = m_quality.of_supporting_edge(*m_shell);
    m_result.core.push_back(s);
    for(int t = m_best.core_size; t > 1; --t)
    {
      const int i = m_result.core.back(), j = next_of_core(i, t, prefix);
      prefix = m_quality.combine(prefix, arc_value(i, j));
      m_result.core.push_back(j);
    }
  }

  // The smallest position that t - 1 arcs lead from back to the start with the best value in all.
  int next_of_core(const int i, const int t, const Value& prefix)
  {
    int best = none;
    for(int j = i + 1; j < m; ++j)
    {
      if(! contains(m_arcs[i] & m_suffixes[t - 1], j))
        continue;
      const Value& suffix = m_suffix[(t - 1) * m + j];
      if(! (m_quality.combine(m_quality.combine(prefix, arc_value(i, j)), suffix) < m_best.value))
        return j;
      // a sum that is rounded differently here than before may miss the best value: then the suffix decides
      if(best == none && ! (m_quality.combine(arc_value(i, j), suffix) < m_suffix[t * m + i]))
        best = j;
    }
    return best;
  }

  // Iterative, since the depth of the triangulation is not bounded by anything small.
  void triangulate_ring(const int from, const int to)
  {
    boost::container::small_vector<std::array<int, 2>, 16> rings;
    rings.push_back({{ from, to }});
    while(! rings.empty())
    {
      const std::array<int, 2> r = rings.back();
      rings.pop_back();
      if(m_apices[at(r[0], r[1])] == ring_edge)
        continue;
      const int k = best_apex(r[0], r[1]);
      m_result.triangles.push_back({{ r[0], k, r[1] }});
      rings.push_back({{ k, r[1] }});
      rings.push_back({{ r[0], k }});
    }
  }

  typedef boost::container::vector<Value> Values; // where bool is a type like any other

  static constexpr Positions ring_edge = 0; // no apex: the ring is one edge of the skirt polygon

  enum Triangle_state { UNKNOWN, INVALID, VALID, VALUED };

  const Predicates& m_predicates;
  const Quality& m_quality;
  const Validity& m_validity;

  const Shell* m_shell = nullptr;
  int m = 0;
  int m_f = none;
  bool m_keeps_edge = false;
  Positions m_kept = 0;
  Table m_rings_from;                   // for each i the j for which R_ij can be triangulated
  Table m_rings_to;                     // for each j the i
  std::vector<Positions> m_apices;      // of each ring; some may turn out not to be valid, but not the first
  Table m_known_values;                 // for each i the j for which M_k and M_q are known
  std::vector<int> m_best_apex;         // M_k
  Values m_value;                       // M_q
  Table m_known_chords;                 // for each i the j > i for which the validity was asked for
  Table m_valid_chords;                 // for each i those of them that are valid
  std::vector<unsigned char> m_triangles; // what is known of each triangle
  Values m_triangle_values;             // of those that are VALUED
  Table m_arcs;                         // for each i the j to which there is an arc of a core
  Table m_known_arc_values;             // those of which the value is known
  Values m_arc_value;
  std::vector<Positions> m_suffixes;    // for each number t of arcs the i for which there is a suffix
  Values m_suffix;
  Candidate m_best;
  int m_best_avoided = none;
  Partial_triangulation m_result;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_COVERING_MESH_3_H
