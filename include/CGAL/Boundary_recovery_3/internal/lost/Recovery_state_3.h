// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVERY_STATE_3_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVERY_STATE_3_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>

#include <cstddef>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

/*
 * What the phases of a recovery share: the mesh, the constraints and what is lost of them, the context of the run, and
 * the account of what was done.
 */
template <typename Tr>
struct Recovery_state_3
{
  typedef Constraints_3<Tr>          Constraints;
  typedef Vertex_predicates_3<Tr>    Predicates;
  typedef Recovery_context<Tr>       Context;

  // All arguments have to outlive this object.
  Recovery_state_3(Tr& tr, const Predicates& predicates, const Constraints& constraints, Context& context)
    : tr(tr), predicates(predicates), constraints(constraints), context(context), m_search(tr, constraints)
  { }

  bool is_nothing_lost() const { return lost.edges.empty() && lost.facets.empty(); }

  // Looks up all the constraints, each as one simplex.
  void look_up_all() { lost = m_search(); }

  // Looks up what was lost: what is in the mesh stays there, unless points are added.
  void look_up_lost() { lost = m_search(lost); }

  // Runs a phase, unless the recovery was stopped; what decides on the outcome always runs.
  template <typename Work>
  void run(const Phase phase, const Work& work)
  {
    if(phase != Phase::recount && phase != Phase::search && ! context.go_further())
      return;
    context.run(phase, work, [this](Phase_report& report)
    {
      report.lost_edges = lost.edges.size();
      report.lost_facets = lost.facets.size();
      phases.push_back(report);
    });
  }

  Tr& tr;
  const Predicates& predicates;
  const Constraints& constraints;
  Context& context;
  Lost_constraints lost;
  std::vector<Phase_report> phases;
  std::vector<Recursion_level_report> levels;
  std::size_t number_of_transformations = 0; // replacements of cells by flips, stars and reconnections

private:
  Constraint_search_3<Tr> m_search;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_LOST_RECOVERY_STATE_3_H
