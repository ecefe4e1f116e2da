// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVERY_BY_FLIPS_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVERY_BY_FLIPS_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Cavity_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_state_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recursive_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * The recovery without points [CZZ+17, Section 4.2], with plain removals before it and small polyhedron reconnection
 * behind it. What each phase recovered is looked up at its end. A phase that has nothing to do is left out.
 */
template <typename Tr, typename Visitor>
class Recovery_by_flips_3
{
public:
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef Recovery_state_3<Tr, Visitor>      State;
  typedef Recovery_phase                     Phase;

  // `state` has to outlive this object.
  explicit Recovery_by_flips_3(State& state)
    : m_state(state),
      m_edge_recovery(state.tr, state.predicates, state.constraints, state.context, state.lost.edges, state.levels),
      m_facet_recovery(state.tr, state.predicates, state.constraints, state.context, m_treatable_facets, state.levels)
  { }

  void remove_plainly()
  {
    run_if_any(m_state.lost.edges, Phase::plain_removal,
               [&](const Phase phase) { return m_edge_recovery.remove_plainly(phase); });
  }

  void recover_edges_brc1(const int l_max)
  {
    run_if_any(m_state.lost.edges, Phase::edge_recovery_brc1,
               [&](const Phase phase) { return m_edge_recovery.first_calling(phase, l_max); });
  }

  void recover_edges_brc3(const int l_max)
  {
    run_if_any(m_state.lost.edges, Phase::edge_recovery_brc3,
               [&](const Phase phase) { return m_edge_recovery.second_calling(phase, l_max); });
  }

  void reconnect_edges()
  {
    run_if_any(m_state.lost.edges, Phase::edge_reconnection, [&](const Phase phase)
    {
      return this->reconnect(phase, m_state.lost.edges, m_state.constraints.edges());
    });
  }

  void recover_facets_brc2(const int l_max)
  {
    run_if_any(treatable_facets(), Phase::facet_recovery_brc2,
               [&](const Phase phase) { return m_facet_recovery.first_calling(phase, l_max); });
  }

  void recover_facets_brc4(const int l_max)
  {
    run_if_any(treatable_facets(), Phase::facet_recovery_brc4,
               [&](const Phase phase) { return m_facet_recovery.second_calling(phase, l_max); });
  }

  void reconnect_facets()
  {
    run_if_any(treatable_facets(), Phase::facet_reconnection, [&](const Phase phase)
    {
      return this->reconnect(phase, m_treatable_facets, m_state.constraints.facets());
    });
  }

private:
  // `work` returns the number of replacements that it made.
  template <typename Work>
  void run_if_any(const std::vector<std::size_t>& constraints, const Phase phase, const Work& work)
  {
    if(constraints.empty())
      return;
    m_state.run(phase, [&]
    {
      m_state.number_of_transformations += work(phase);
      m_state.look_up_lost();
    });
  }

  // The lost facets whose edges are in the mesh.
  const std::vector<std::size_t>& treatable_facets()
  {
    m_treatable_facets.clear();
    for(const std::size_t f : m_state.lost.facets)
    {
      const auto& edges = m_state.constraints.edges_of_facet(f);
      if(std::none_of(edges.begin(), edges.end(), [this](const std::size_t e) { return is_edge_lost(e); }))
        m_treatable_facets.push_back(f);
    }
    return m_treatable_facets;
  }

  bool is_edge_lost(const std::size_t e) const
  {
    return std::binary_search(m_state.lost.edges.begin(), m_state.lost.edges.end(), e);
  }

  // Small polyhedron reconnection around each of the lost constraints. One success may clear the way for another
  // constraint, so passes are repeated while they help. What failed is not tried again in the same mesh.
  template <typename Simplex>
  std::size_t reconnect(const Phase phase, std::vector<std::size_t>& lost, const std::vector<Simplex>& simplices)
  {
    Cavity_recovery_3<Tr, Visitor>
      recover(m_state.tr, m_state.predicates, m_state.constraints, m_state.context.visitor());
    std::vector<std::size_t> hopeless_since(lost.size(), std::size_t(-1)); // numbers of replacements, or -1
    for(std::size_t before = 0; before != lost.size() && ! lost.empty(); )
    {
      before = lost.size();
      std::size_t kept = 0;
      for(std::size_t i = 0; i < before; ++i)
      {
        const std::size_t s = lost[i];
        const bool is_hopeless = hopeless_since[i] == recover.number_of_replacements();
        if(is_hopeless || ! m_state.context.go_further() || ! recover(simplices[s]))
        {
          hopeless_since[kept] = recover.number_of_replacements();
          lost[kept++] = s;
        }
        m_state.context.visitor().on_progress(phase, i + 1, before);
      }
      lost.resize(kept);
    }
    return recover.number_of_replacements();
  }

  State& m_state;
  std::vector<std::size_t> m_treatable_facets;
  Recursive_recovery_3<Tr, 2, Visitor> m_edge_recovery;
  Recursive_recovery_3<Tr, 3, Visitor> m_facet_recovery;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVERY_BY_FLIPS_3_H
