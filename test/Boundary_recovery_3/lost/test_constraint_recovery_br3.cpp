// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Recovery of lost constraints without points, by each of its means alone: what they say is in the mesh is there,
// nothing that was there gets lost, and the mesh is valid.

#undef NDEBUG

#include "mesh_validity_br3.h"
#include "steiner_inputs_br3.h"
#include "stopping_visitor_br3.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Cavity_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_by_flips_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_state_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recursive_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_validity.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shell_transformation_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;
namespace internal = CGAL::Boundary_recovery_3::internal;
using br3_test::Stopping_visitor;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Vertex_handle                                   Vertex_handle;
typedef internal::Constraints_3<Tr>                         Constraints;
typedef internal::Vertex_predicates_3<Tr>                   Predicates;
typedef internal::Recovery_context<Stopping_visitor>        Context;
typedef std::vector<std::size_t>                            Indices;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, std::size_t> number_of;

// The Delaunay triangulation of the points, and the constraints.
class Scene
{
public:
  explicit Scene(const br3_test::Plc& plc)
    : predicates(tr), context(visitor)
  {
    std::vector<Vertex_handle> v;
    for(const auto& c : plc.points)
      v.push_back(tr.insert(K::Point_3(c[0], c[1], c[2])));
    for(const auto& e : plc.edges)
      constraints.insert(v[e[0]], v[e[1]]);
    for(const auto& t : plc.triangles)
      constraints.insert(v[t[0]], v[t[1]], v[t[2]]);
    m_lost_edges = lost<2>();
    m_lost_facets = lost<3>();
  }

  bool is_lost(const Constraints::Vertex_pair& e) const
  {
    Tr::Cell_handle c;
    int i, j;
    return ! tr.is_edge(e[0], e[1], c, i, j);
  }

  bool is_lost(const Constraints::Vertex_triple& f) const
  {
    Tr::Cell_handle c;
    int i, j, k;
    return ! tr.is_facet(f[0], f[1], f[2], c, i, j, k);
  }

  template <std::size_t N>
  Indices lost() const
  {
    Indices result;
    for(std::size_t i = 0; i < all<N>().size(); ++i)
      if(is_lost(all<N>()[i]))
        result.push_back(i);
    return result;
  }

  // Edges (N = 2), or facets whose edges are in the mesh (N = 3).
  template <std::size_t N>
  Indices treatable() const
  {
    Indices result = lost<N>();
    if constexpr(N == 3)
      result.erase(std::remove_if(result.begin(), result.end(), [&](const std::size_t f)
      {
        const auto& e = constraints.edges_of_facet(f);
        return std::any_of(e.begin(), e.end(), [&](const std::size_t i) { return is_lost(constraints.edges()[i]); });
      }), result.end());
    return result;
  }

  // To be called after each change.
  void check()
  {
    assert(internal::is_mesh_valid(tr, predicates) && br3_test::is_valid_mesh(tr));
    const Indices edges = lost<2>(), facets = lost<3>();
    assert(std::includes(m_lost_edges.begin(), m_lost_edges.end(), edges.begin(), edges.end()));
    assert(std::includes(m_lost_facets.begin(), m_lost_facets.end(), facets.begin(), facets.end()));
    m_lost_edges = edges;
    m_lost_facets = facets;
  }

  template <std::size_t N>
  const auto& all() const
  {
    if constexpr(N == 2)
      return constraints.edges();
    else
      return constraints.facets();
  }

  Tr tr;
  Constraints constraints;
  const Predicates predicates;
  Stopping_visitor visitor;
  Context context;

private:
  Indices m_lost_edges, m_lost_facets; // after the last check
};

template <std::size_t N>
std::string counted(const std::string& means) { return (N == 2 ? "edges" : "facets") + (" recovered " + means); }

// One constraint after the other, by shell transformations.
template <std::size_t N>
void test_single_constraints(Scene& scene)
{
  typedef BR::Kept_constraints_3<Constraints> Kept;
  typedef std::conditional_t<N == 2, BR::BRC1<Tr>, BR::BRC2<Tr> > Condition;
  typedef BR::Shell_validity_conjunction_3<Kept, Condition> Validity;
  typedef BR::Worst_element_quality_3<Tr> Quality;
  CGAL::Shell_transformation_3<Tr, Quality, Validity, Stopping_visitor>
    transformation(scene.tr, Quality(scene.tr), scene.visitor, scene.predicates);
  internal::Constraint_recovery_3<Tr, N> recover(scene.tr, scene.predicates);
  for(const std::size_t i : scene.treatable<N>())
  {
    const auto& c = scene.all<N>()[i];
    if(! scene.is_lost(c))
      continue; // it came back with another one
    const auto crossings = recover.crossings(c);
    assert(! crossings.empty());
    for(const auto& crossing : crossings)
      for(int k = 0; k <= crossing.dimension; ++k)
        assert(crossing.cell->has_vertex(crossing.vertices[static_cast<std::size_t>(k)])
               && ! internal::contains(c, crossing.vertices[static_cast<std::size_t>(k)]));
    const Validity validity = std::apply([&](const auto ... v)
    {
      return Validity(Kept(scene.constraints), Condition(scene.tr, v...));
    }, c);
    const bool is_recovered = recover(transformation, c, validity, 3, scene.context);
    assert(is_recovered == ! scene.is_lost(c) && is_recovered == recover.crossings(c).empty());
    scene.check();
    number_of[counted<N>("one by one")] += is_recovered;
  }
}

// What is taken out of the list is recovered. What comes back by the way may stay in it.
template <std::size_t N>
void check_list(Scene& scene, const Indices& lost, const Indices& before)
{
  scene.check();
  assert(std::is_sorted(lost.begin(), lost.end()));
  assert(std::includes(before.begin(), before.end(), lost.begin(), lost.end()));
  for(const std::size_t i : before)
    assert(internal::contains(lost, i) || ! scene.is_lost(scene.all<N>()[i]));
}

// All the constraints of one dimension: the three callings in their order, from one of them on.
template <std::size_t N>
void test_callings(Scene& scene, const int first)
{
  typedef internal::Recursive_recovery_3<Tr, N, Stopping_visitor> Recovery;
  Indices lost = scene.treatable<N>();
  std::vector<BR::Recursion_level_report> levels;
  Recovery recover(scene.tr, scene.predicates, scene.constraints, scene.context, lost, levels);
  const auto call = [&](const std::string& means, const auto& calling)
  {
    const Indices before = lost;
    if(lost.empty())
      return;
    const std::size_t number_of_levels = levels.size(), number_of_replacements = calling();
    check_list<N>(scene, lost, before);
    assert(lost == before || number_of_replacements > 0);
    assert(levels.size() == number_of_levels || levels.back().n1 == lost.size());
    number_of[counted<N>(means)] += before.size() - lost.size();
  };
  if(first == 0)
    call("plainly", [&] { return recover.remove_plainly(BR::Recovery_phase::plain_removal); });
  assert(levels.empty());
  if(first <= 1)
    call("under BRC1 or BRC2", [&] { return recover.first_calling(BR::Recovery_phase::edge_recovery_brc1, 5); });
  call("under BRC3 or BRC4", [&] { return recover.second_calling(BR::Recovery_phase::edge_recovery_brc3, 5); });
}

// One constraint after the other, by the reconnection of the cells that it crosses.
template <std::size_t N>
void test_cavities(Scene& scene)
{
  internal::Cavity_recovery_3<Tr, Stopping_visitor>
    recover(scene.tr, scene.predicates, scene.constraints, scene.visitor);
  for(const std::size_t i : scene.treatable<N>())
  {
    const auto& c = scene.all<N>()[i];
    const bool was_lost = scene.is_lost(c);
    const std::size_t before = recover.number_of_replacements();
    const bool is_recovered = recover(c);
    assert(is_recovered == ! scene.is_lost(c));
    assert(recover.number_of_replacements() == before + (was_lost && is_recovered ? 1 : 0));
    scene.check();
    number_of[counted<N>("in cavities")] += was_lost && is_recovered;
  }
}

// Once stopped, nothing is changed.
void test_stop(const br3_test::Plc& plc)
{
  Scene scene(plc);
  scene.visitor.last_question = 0;
  assert(! scene.context.go_further());
  Indices lost = scene.treatable<2>();
  const Indices before = lost;
  std::vector<BR::Recursion_level_report> levels;
  internal::Recursive_recovery_3<Tr, 2, Stopping_visitor>
    recover(scene.tr, scene.predicates, scene.constraints, scene.context, lost, levels);
  assert(recover.remove_plainly(BR::Recovery_phase::plain_removal) == 0 && lost == before);
  assert(recover.first_calling(BR::Recovery_phase::edge_recovery_brc1, 5) == 0 && lost == before);
  assert(scene.visitor.number_of_questions == 1 && scene.treatable<2>() == before);
}

// All the phases in their order: each knows at its end what is lost, and is in the account if it had anything to do.
void test_phases(const br3_test::Plc& plc)
{
  typedef internal::Recovery_by_flips_3<Tr, Stopping_visitor> Recovery;
  typedef BR::Recovery_phase Phase;
  Scene scene(plc);
  internal::Recovery_state_3<Tr, Stopping_visitor> state(scene.tr, scene.predicates, scene.constraints, scene.context);
  assert(state.is_nothing_lost());
  state.run(Phase::search, [&] { state.look_up_all(); });
  assert(state.lost.edges == scene.lost<2>() && state.lost.facets == scene.lost<3>());
  Recovery recover(state);
  const auto run = [&](const Phase phase, const bool is_for_edges, const auto& work)
  {
    const std::size_t before = state.phases.size(), number_of_transformations = state.number_of_transformations;
    const bool has_work = is_for_edges ? ! scene.lost<2>().empty() : ! scene.treatable<3>().empty();
    const std::size_t number_of_lost = state.lost.edges.size() + state.lost.facets.size();
    work();
    scene.check();
    assert(state.lost.edges == scene.lost<2>() && state.lost.facets == scene.lost<3>());
    assert(state.phases.size() == before + (has_work ? 1 : 0));
    assert(number_of_lost == state.lost.edges.size() + state.lost.facets.size()
           || state.number_of_transformations > number_of_transformations);
    assert(! has_work || (state.phases.back().phase == phase
                          && state.phases.back().lost_edges == state.lost.edges.size()
                          && state.phases.back().lost_facets == state.lost.facets.size()));
    number_of["phases with work"] += has_work;
  };
  run(Phase::plain_removal, true, [&] { recover.remove_plainly(); });
  run(Phase::edge_recovery_brc1, true, [&] { recover.recover_edges_brc1(5); });
  run(Phase::edge_recovery_brc3, true, [&] { recover.recover_edges_brc3(5); });
  run(Phase::edge_reconnection, true, [&] { recover.reconnect_edges(); });
  run(Phase::facet_recovery_brc2, false, [&] { recover.recover_facets_brc2(5); });
  run(Phase::facet_recovery_brc4, false, [&] { recover.recover_facets_brc4(5); });
  run(Phase::facet_reconnection, false, [&] { recover.reconnect_facets(); });
}

void test(const br3_test::Plc& plc)
{
  Scene one_by_one(plc), in_cavities(plc);
  if(one_by_one.tr.dimension() < 3)
    return;
  test_single_constraints<2>(one_by_one);
  test_single_constraints<3>(one_by_one);
  test_cavities<2>(in_cavities);
  test_cavities<3>(in_cavities);
  for(const int first : { 0, 1, 2 })
  {
    Scene all_at_once(plc);
    test_callings<2>(all_at_once, first);
    test_callings<3>(all_at_once, first);
  }
  test_stop(plc);
  test_phases(plc);
}

int main()
{
  for(unsigned seed = 0; seed < 60; ++seed)
    test(br3_test::Random_constraints(seed)(8 + static_cast<int>(seed) % 9, seed % 2 == 0 ? 4 : 40, 60, 40));
  for(std::size_t blades = 0; blades <= 4; ++blades)
    for(unsigned seed = 0; seed < 4; ++seed)
      test(br3_test::Random_constraints(seed).fan(blades, 14));
  test(br3_test::twisted_prism(3, .3, 1000, 1000));
  test(br3_test::Notched_box(1, 1).plc());

  for(const std::string what : { "edges", "facets" })
    for(const std::string means : { "one by one", "in cavities", "plainly", "under BRC1 or BRC2",
                                    "under BRC3 or BRC4" })
    {
      std::cout << number_of[what + " recovered " + means] << ' ' << what << " recovered " << means << std::endl;
      assert(number_of[what + " recovered " + means] > 0);
    }
  std::cout << number_of["phases with work"] << " phases with work" << std::endl;
  assert(number_of["phases with work"] > 100);
  std::cout << "done" << std::endl;
}
