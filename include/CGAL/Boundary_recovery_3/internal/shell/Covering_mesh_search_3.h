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

#include <CGAL/Boundary_recovery_3/Partial_triangulation.h>
#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Core_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/Ring_triangulations_3.h>
#include <CGAL/Boundary_recovery_3/internal/shell/position_tables.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

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

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SHELL_COVERING_MESH_SEARCH_3_H
