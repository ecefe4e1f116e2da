// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_COVERING_MESH_SEARCH_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_COVERING_MESH_SEARCH_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Ring_triangulations_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Searches the best core of a shell: step 4 of [CZZ+17, Alg. 3].
 *
 * Instead of enumerating all the cycles of the triangulation graph, a second dynamic program finds the best core of
 * each size: over the cores with the smallest position s, `m_suffix(t, i)` is the best value of t arcs that lead from i
 * back to s. The time is O(m^4), m being the degree of the shell.
 *
 * Ties are broken so that the outcome is unique: among equal vectors the lexicographically smallest core is taken.
 */
template <typename Tr, typename Quality, typename Validity>
class Core_search_3
{
public:
  typedef Shell_3<Tr>                                   Shell;
  typedef Vertex_predicates_3<Tr>                       Predicates;
  typedef Ring_triangulations_3<Tr, Quality, Validity>  Rings;
  typedef typename Quality::Value                       Value;

  static constexpr int none = Shell::none;

  // A covering mesh, by what it is compared by.
  struct Candidate
  {
    int core_size = -1;     // n; -1: none yet
    int start = 0;          // smallest position of the core
    bool avoids = false;    // Q' = 1
    Value value = Value();  // Q, where it can matter
  };

  Core_search_3(const Predicates& predicates, const Quality& quality, Rings& rings)
    : m_predicates(predicates), m_quality(quality), m_rings(rings)
  { }

  // The best of the covering meshes that keep ab, and of `complete_reduction`, if there is that one. All the rings have
  // to be known; the face a b p_f is to be avoided (f may be none). If `only_if_done`, the others are not searched.
  Candidate operator()(const Shell& shell, const int f, const Candidate& complete_reduction, const bool only_if_done)
  {
    m_shell = &shell;
    m = shell.degree();
    m_f = f;
    m_best = complete_reduction;
    choose_core(only_if_done);
    return m_best;
  }

  // The lexicographically smallest core that has the value of the last outcome, which keeps ab.
  template <typename Core>
  void trace(Core& core)
  {
    const int s = m_best.start;
    fill_in_suffixes(s, m_best.core_size, m_best_avoided);
    Value prefix = m_quality.of_supporting_edge(*m_shell);
    core.push_back(s);
    for(int t = m_best.core_size; t > 1; --t)
    {
      const int i = core.back(), j = next_of_core(i, t, prefix);
      prefix = m_quality.combine(prefix, arc_value(i, j));
      core.push_back(j);
    }
  }

private:
  // The share of one arc <i,j> of a core in the quality: what covers R_ij, the tetrahedron a b p_i p_j, the face a b
  // p_i.
  const Value& arc_value(const int i, const int j)
  {
    if(! m_known_arc_values.contains(i, j))
    {
      m_known_arc_values.insert(i, j);
      m_arc_value(i, j) = m_quality.combine(m_rings.value(i, j),
                                            m_quality.combine(m_quality.of_core_edge(*m_shell, i, j),
                                                              m_quality.of_core_vertex(*m_shell, i)));
    }
    return m_arc_value(i, j);
  }

  // Returns whether there is an arc that is not an edge of the skirt polygon.
  bool fill_in_arcs()
  {
    bool has_chord = false;
    m_arcs.clear(m);
    m_known_arc_values.clear(m);
    m_arc_value.assign(m, m);
    const Shell_positivity_3<Tr> positivity(*m_shell, m_predicates);
    for(int i = 0; i < m; ++i)
      for(int j = 0; j < m; ++j)
      {
        // R_{j-1,j} closed the long way round would be a core of two vertices
        if(! m_rings.has_ring(i, j) || j == m_shell->previous(i) || ! positivity.is_core_edge_positive(i, j))
          continue;
        m_arcs.insert(i, j);
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
        if(m_arcs.contains(i, j))
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
        if(! internal::has_bit(m_suffixes[n], s))
          continue;
        Candidate c;
        c.core_size = n;
        c.start = s;
        c.avoids = m_f == none || avoided != none;
        c.value = m_quality.combine(m_quality.of_supporting_edge(*m_shell), m_suffix(n, s));
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

  // m_suffix(t, i): the best value of t arcs from i to s that visit increasing positions > s only.
  // Returns the largest t for which this was computed: `largest`, or the first that closes a cycle where only that
  // matters.
  int fill_in_suffixes(const int s, const int largest, const int avoided)
  {
    m_suffixes.assign(largest + 1, 0);
    m_suffix.assign(largest + 1, m);
    for(int i = s + 1; i < m; ++i)
      if(i != avoided && m_arcs.contains(i, s))
      {
        m_suffixes[1] |= internal::bit(i);
        m_suffix(1, i) = arc_value(i, s);
      }
    for(int t = 2; t <= largest && m_suffixes[t - 1] != 0; ++t)
    {
      for(int i = s; i < m; ++i)
        if(i != avoided)
          fill_in_suffix(t, i);
      if(! Quality::is_first_in_vector && internal::has_bit(m_suffixes[t], s))
        return t;
    }
    return largest;
  }

  void fill_in_suffix(const int t, const int i)
  {
    internal::for_each_bit(m_arcs[i] & m_suffixes[t - 1] & internal::bits_after(i), [&](const int j)
    {
      const Value q = m_quality.combine(this->arc_value(i, j), m_suffix(t - 1, j));
      if(! internal::has_bit(m_suffixes[t], i) || m_suffix(t, i) < q)
      {
        m_suffixes[t] |= internal::bit(i);
        m_suffix(t, i) = q;
      }
    });
  }

  // The smallest position that t - 1 arcs lead from back to the start with the best value in all.
  int next_of_core(const int i, const int t, const Value& prefix)
  {
    int best = none;
    for(int j = i + 1; j < m; ++j)
    {
      if(! internal::has_bit(m_arcs[i] & m_suffixes[t - 1], j))
        continue;
      const Value& suffix = m_suffix(t - 1, j);
      if(! (m_quality.combine(m_quality.combine(prefix, arc_value(i, j)), suffix) < m_best.value))
        return j;
      // a sum that is rounded differently here than before may miss the best value: then the suffix decides
      if(best == none && ! (m_quality.combine(arc_value(i, j), suffix) < m_suffix(t, i)))
        best = j;
    }
    return best;
  }

  const Predicates& m_predicates;
  const Quality& m_quality;
  Rings& m_rings;

  const Shell* m_shell = nullptr;
  int m = 0;
  int m_f = none;
  Position_pairs m_arcs;                // for each i the j to which there is an arc of a core
  Position_pairs m_known_arc_values;    // those of which the value is known
  Position_matrix<Value> m_arc_value;
  std::vector<Positions> m_suffixes;    // for each number t of arcs the i for which there is a suffix
  Position_matrix<Value> m_suffix;
  Candidate m_best;
  int m_best_avoided = none;
};

/*
 * Searches the optimal covering mesh of a shell: steps 1 to 4 of [CZZ+17, Alg. 3]. First the rings of the skirt polygon
 * are triangulated; if that does not decide it, the best core is searched.
 */
template <typename Tr, typename Quality, typename Validity>
class Covering_mesh_search_3
{
public:
  typedef Shell_3<Tr>              Shell;
  typedef Vertex_predicates_3<Tr>  Predicates;

  static constexpr int none = Shell::none;
  static constexpr int max_degree = max_number_of_positions;

  Covering_mesh_search_3(const Predicates& predicates, const Quality& quality, const Validity& validity)
    : m_rings(predicates, quality, validity), m_search_core(predicates, quality, m_rings)
  { }

  Covering_mesh_search_3(const Covering_mesh_search_3&) = delete;
  Covering_mesh_search_3& operator=(const Covering_mesh_search_3&) = delete;

  // Finds the best covering mesh of `shell`, where the face a b p_f is to be avoided (f may be none).
  // If `keeps_edge`, ab stays; skirt vertices for which `is_kept(i)` holds stay in the core, i.e. the face a b p_i
  // stays. Returns false if that is the covering mesh that is there.
  // If `only_if_done`, only those covering meshes are searched that do what is asked for: avoid that face, or lose ab.
  template <typename IsKept>
  bool operator()(const Shell& shell, const int f, const bool keeps_edge, const IsKept& is_kept,
                  const bool only_if_done = false)
  {
    const int m = shell.degree();
    CGAL_precondition(m <= max_degree);
    Positions kept = 0;
    for(int i = 0; i < m; ++i)
      if(is_kept(i))
        kept |= internal::bit(i);
    m_rings.assign(shell, kept);
    const int core_size = choose_covering_mesh(shell, f, keeps_edge, only_if_done);
    if(core_size < 0 || core_size == m)
      return false;
    build_partial_triangulation(m, core_size);
    return true;
  }

  // The outcome of the last search that returned true.
  const Partial_triangulation& partial_triangulation() const { return m_result; }

private:
  typedef Ring_triangulations_3<Tr, Quality, Validity>  Rings;
  typedef Core_search_3<Tr, Quality, Validity>          Core_search;
  typedef typename Core_search::Candidate               Candidate;

  // Returns the size of its core, or -1 if there is none. A complete reduction is made of rings that do not contain the
  // arc from the last position to the first, so these tell whether there is one; in most cases that also is the end.
  int choose_covering_mesh(const Shell& shell, const int f, const bool keeps_edge, const bool only_if_done)
  {
    const int last = shell.degree() - 1;
    Candidate complete_reduction;
    m_rings.fill_in_straight_rings();
    if(! keeps_edge && m_rings.has_ring(0, last))
    {
      if(! Quality::is_first_in_vector)
        return 0; // [1, N_big, Q] cannot be beaten
      complete_reduction.core_size = 0;
      complete_reduction.avoids = true;
      complete_reduction.value = m_rings.value(0, last);
    }
    if(only_if_done && f == none)
      return complete_reduction.core_size;
    m_rings.fill_in_wrapped_rings();
    return m_search_core(shell, f, complete_reduction, only_if_done).core_size;
  }

  void build_partial_triangulation(const int m, const int core_size)
  {
    m_result.core.clear();
    m_result.triangles.clear();
    if(core_size == 0)
    {
      m_rings.triangulate(0, m - 1, m_result.triangles);
      return;
    }
    m_search_core.trace(m_result.core);
    for(int c = 0; c < core_size; ++c)
      m_rings.triangulate(m_result.core[c], m_result.core[c + 1 == core_size ? 0 : c + 1], m_result.triangles);
  }

  Rings m_rings;
  Core_search m_search_core;
  Partial_triangulation m_result;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_COVERING_MESH_SEARCH_3_H
