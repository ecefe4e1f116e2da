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
#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Facet_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Segment_walk_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_state_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recursive_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * Recovery of one lost constraint by small polyhedron reconnection of the cells that it crosses, then of these and
 * some layers more, as far as they can be searched. All the constraints inside that are in the mesh are kept.
 *
 * Where a cavity can be filled, a larger one can be, too, but its search takes longer and may give up. The sizes in
 * between are of no use.
 */
template <typename Tr>
class Recover_in_cavity_3
{
public:
  typedef typename Tr::Vertex_handle           Vertex_handle;
  typedef typename Tr::Cell_handle             Cell_handle;
  typedef Vertex_predicates_3<Tr>              Predicates;
  typedef Constraints_3<Tr>                    Constraints;
  typedef Small_polyhedron_reconnection_3<Tr>  Reconnection;
  typedef std::array<Vertex_handle, 2>         Vertex_pair;
  typedef std::array<Vertex_handle, 3>         Vertex_triple;
  typedef std::vector<Vertex_handle>           Vertices;

  static constexpr int number_of_layers = 3;

  Recover_in_cavity_3(Tr& tr, const Predicates& predicates, const Constraints& constraints, Mesh_visitor_3<Tr>& visitor)
    : m_tr(tr), m_constraints(constraints), m_visitor(visitor),
      m_segment_walk(tr, predicates), m_facet_walk(tr, predicates), m_reconnection(predicates),
      m_cavity(tr, constraints)
  { }

  // Returns whether uv is a mesh edge in the end. `failed` are the vertices of the cells that it crossed when that
  // failed last: if these are the same, it fails again. What is tried now sets them.
  bool operator()(const Vertex_pair& e, Vertices& failed)
  {
    typedef Segment_walk_3<Tr> Walk;
    const typename Walk::Outcome outcome = m_segment_walk(e[0], e[1]);
    if(outcome != Walk::CROSSED)
      return outcome == Walk::IS_EDGE;
    m_cavity.clear();
    if(! add_cells_at(m_segment_walk.crossings()))
      return false;
    return reconnect(std::vector<Vertex_pair>(1, e), std::vector<Vertex_triple>(), failed);
  }

  // Returns whether the facet, whose edges are mesh edges, is a mesh facet in the end. `failed` as above.
  bool operator()(const Vertex_triple& f, Vertices& failed)
  {
    typedef Facet_walk_3<Tr> Walk;
    int i, j;
    Cell_handle c;
    if(! m_tr.is_edge(f[0], f[1], c, i, j))
      return false;
    const typename Walk::Outcome outcome = m_facet_walk(f[0], f[1], f[2], c);
    if(outcome != Walk::CROSSED)
      return outcome == Walk::IS_FACET;
    m_cavity.clear();
    if(! add_cells_at(m_facet_walk.crossings()))
      return false;
    return reconnect(std::vector<Vertex_pair>(), std::vector<Vertex_triple>(1, f), failed);
  }

  std::size_t number_of_replacements() const { return m_number_of_replacements; }

private:
  // Returns false if one of the cells is infinite: then the hull would have to change.
  bool add_cells_at(const std::vector<Crossing_3<Tr> >& crossings)
  {
    m_cells.clear();
    for(const Crossing_3<Tr>& crossing : crossings)
      internal::append_cells_at(m_tr, crossing, m_cells);
    return std::all_of(m_cells.begin(), m_cells.end(), [this](const Cell_handle c) { return m_cavity.add(c); });
  }

  bool reconnect(const std::vector<Vertex_pair>& edges, const std::vector<Vertex_triple>& facets, Vertices& failed)
  {
    if(m_cavity.vertices().size() > max_number_of_vertices || m_cavity.vertices() == failed)
      return false;
    failed = m_cavity.vertices();
    m_reconnection.forget();
    if(reconnect_cells(edges, facets))
      return true;
    const std::size_t before = m_cavity.cells().size();
    for(int layer = 0; layer < number_of_layers; ++layer)
      internal::add_layer(m_cavity, max_number_of_vertices);
    return m_cavity.cells().size() != before && reconnect_cells(edges, facets);
  }

  bool reconnect_cells(std::vector<Vertex_pair> edges, std::vector<Vertex_triple> facets)
  {
    internal::collect_constraints(m_constraints, m_cavity.cells(), edges, facets);
    if(m_reconnection(m_cavity.cells(), edges, facets) != Reconnection::FOUND)
      return false;
    m_replacement(m_tr, m_cavity.cells(), m_reconnection.tetrahedra(), m_visitor);
    ++m_number_of_replacements;
    return true;
  }

  static constexpr std::size_t max_number_of_vertices = 22;

  Tr& m_tr;
  const Constraints& m_constraints;
  Mesh_visitor_3<Tr>& m_visitor;
  Segment_walk_3<Tr> m_segment_walk;
  Facet_walk_3<Tr> m_facet_walk;
  Reconnection m_reconnection;
  Replace_cells<Tr> m_replacement;
  Cavity_3<Tr, Constraints> m_cavity;
  std::vector<Cell_handle> m_cells;
  std::size_t m_number_of_replacements = 0;
};

/*
 * The recovery without points [CZZ+17, Section 4.2], with plain removals before it and small polyhedron reconnection
 * behind it. What each phase recovered is looked up at its end. A phase that has nothing to do is left out.
 */
template <typename Tr>
class Recovery_by_flips_3
{
public:
  typedef typename Tr::Vertex_handle         Vertex_handle;
  typedef Recovery_state_3<Tr>      State;

  // `state` has to outlive this object.
  explicit Recovery_by_flips_3(State& state)
    : m_state(state),
      m_edge_recovery(state.tr, state.predicates, state.constraints, state.context, state.lost.edges, state.levels),
      m_facet_recovery(state.tr, state.predicates, state.constraints, state.context, m_treatable_facets, state.levels)
  { }

  void remove_without_recursion()
  {
    run_if_any(m_state.lost.edges, Phase::plain_removal,
               [&](const Phase phase) { return m_edge_recovery.remove_without_recursion(phase); });
  }

  void recover_edges_brc1(const int l_max)
  {
    run_if_any(m_state.lost.edges, Phase::edge_recovery_brc1,
               [&](const Phase phase) { return m_edge_recovery.recover_with_best_cells(phase, l_max); });
  }

  void recover_edges_brc3(const int l_max)
  {
    run_if_any(m_state.lost.edges, Phase::edge_recovery_brc3,
               [&](const Phase phase) { return m_edge_recovery.recover_with_fewest_crossings(phase, l_max); });
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
               [&](const Phase phase) { return m_facet_recovery.recover_with_best_cells(phase, l_max); });
  }

  void recover_facets_brc4(const int l_max)
  {
    run_if_any(treatable_facets(), Phase::facet_recovery_brc4,
               [&](const Phase phase) { return m_facet_recovery.recover_with_fewest_crossings(phase, l_max); });
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
  // constraint, so passes are repeated while they help. What failed is not tried again where it crosses the same.
  template <typename Simplex>
  std::size_t reconnect(const Phase phase, std::vector<std::size_t>& lost, const std::vector<Simplex>& simplices)
  {
    Recover_in_cavity_3<Tr>
      recover(m_state.tr, m_state.predicates, m_state.constraints, m_state.context.visitor());
    std::vector<std::vector<Vertex_handle> > failed(lost.size()); // empty: not tried yet
    for(std::size_t before = 0; before != lost.size() && ! lost.empty(); )
    {
      before = lost.size();
      std::size_t kept = 0;
      for(std::size_t i = 0; i < before; ++i)
      {
        const std::size_t s = lost[i];
        if(! m_state.context.go_further() || ! recover(simplices[s], failed[i]))
        {
          std::swap(failed[kept], failed[i]);
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
  Recursive_recovery_3<Tr, 2> m_edge_recovery;
  Recursive_recovery_3<Tr, 3> m_facet_recovery;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVERY_BY_FLIPS_3_H
