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

#include "cell_mirror_br3.h"
#include "mesh_validity_br3.h"
#include "steiner_inputs_br3.h"
#include "stopping_visitor_br3.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/Shell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recover_constraint_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_by_flips_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recovery_state_3.h>
#include <CGAL/Boundary_recovery_3/internal/lost/Recursive_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
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
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Vertex_handle                                   Vertex_handle;
typedef internal::Constraints_3<Tr>                         Constraints;
typedef internal::Vertex_predicates_3<Tr>                   Predicates;
typedef internal::Recovery_context<Tr>                      Context;
typedef br3_test::Stopping_visitor<Tr>                      Stopping_visitor;
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
  internal::Mesh_editor_3<Tr> editor(scene.tr, scene.context.visitor());
  internal::Recover_constraint_3<Tr, N> recover(editor, scene.predicates, scene.constraints);
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
    const std::size_t shells = transformation.number_of_shells();
    recover.set_max_number_of_shells(0);
    assert(! recover(transformation, c, validity, 3, scene.context) && recover.was_cut_off());
    assert(transformation.number_of_shells() == shells && scene.is_lost(c));
    recover.set_max_number_of_shells(recover.default_max_number_of_shells);
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
  typedef internal::Recursive_recovery_3<Tr, N> Recovery;
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
    call("plainly", [&] { return recover.remove_without_recursion(BR::Phase::plain_removal); });
  assert(levels.empty());
  if(first <= 1)
    call("under BRC1 or BRC2", [&] { return recover.recover_with_best_cells(BR::Phase::edge_recovery_brc1, 5); });
  call("under BRC3 or BRC4", [&] { return recover.recover_with_fewest_crossings(BR::Phase::edge_recovery_brc3, 5); });
}

// One constraint after the other, by the reconnection of the cells that it crosses. Where that fails, it fails again in
// the same mesh, in the same cells.
template <std::size_t N>
void test_cavities(Scene& scene)
{
  internal::Recover_in_cavity_3<Tr>
    recover(scene.tr, scene.predicates, scene.constraints, scene.visitor);
  for(const std::size_t i : scene.treatable<N>())
  {
    const auto& c = scene.all<N>()[i];
    const bool was_lost = scene.is_lost(c);
    const std::size_t before = recover.number_of_replacements();
    std::vector<Vertex_handle> failed;
    const bool is_recovered = recover(c, failed);
    assert(is_recovered == ! scene.is_lost(c));
    if(! is_recovered)
    {
      const std::vector<Vertex_handle> vertices = failed;
      assert(! recover(c, failed) && failed == vertices);
      number_of["failures in cavities"] += ! failed.empty();
    }
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
  internal::Recursive_recovery_3<Tr, 2>
    recover(scene.tr, scene.predicates, scene.constraints, scene.context, lost, levels);
  assert(recover.remove_without_recursion(BR::Phase::plain_removal) == 0 && lost == before);
  assert(recover.recover_with_best_cells(BR::Phase::edge_recovery_brc1, 5) == 0 && lost == before);
  assert(scene.visitor.number_of_questions == 1 && scene.treatable<2>() == before);
}

struct Thrown { };

// Checks what it is told of cells, writes down what it is told of phases, and throws or says no at one of the calls.
struct Watching_visitor
  : public br3_test::Cell_mirror<Tr>
{
  explicit Watching_visitor(const Tr& tr) : br3_test::Cell_mirror<Tr>(tr) { }

  void on_phase_begin(const BR::Phase phase) { begun.push_back(phase); }

  void on_phase_end(const BR::Phase_report& report) { ended.push_back(report); }

  void on_progress(const BR::Phase phase, const std::size_t done, const std::size_t total)
  {
    assert(phase == begun.back() && ended.size() + 1 == begun.size() && done <= total);
  }

  bool go_further() { return number_of_questions++ != last_question; }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    if(++number_of_replacements == last_replacement)
      throw Thrown();
    br3_test::Cell_mirror<Tr>::before_cells_removal(cells);
  }

  std::vector<BR::Phase> begun;
  std::vector<BR::Phase_report> ended;
  std::size_t number_of_questions = 0, last_question = std::size_t(-1);
  std::size_t number_of_replacements = 0, last_replacement = std::size_t(-1);
};

// The phases in their order: each knows at its end what is lost, and is in the account if it had anything to do.
class Phase_by_phase
{
public:
  typedef internal::Recovery_state_3<Tr>     State;
  typedef internal::Recovery_by_flips_3<Tr>  Recovery;
  typedef BR::Phase                                   Phase;

  explicit Phase_by_phase(const br3_test::Plc& plc)
    : m_scene(plc), m_visitor(m_scene.tr), m_any_visitor(m_visitor), m_context(m_any_visitor),
      m_state(m_scene.tr, m_scene.predicates, m_scene.constraints, m_context), m_recovery(m_state)
  { }

  // Leaves out some of the phases, and returns those that ran.
  std::vector<Phase> operator()(const std::vector<Phase>& left_out = std::vector<Phase>())
  {
    m_left_out = left_out;
    assert(m_state.is_nothing_lost());
    m_state.run(Phase::search, [this] { m_state.look_up_all(); });
    check_state();
    run<2>(Phase::plain_removal, [this] { m_recovery.remove_without_recursion(); });
    run<2>(Phase::edge_recovery_brc1, [this] { m_recovery.recover_edges_brc1(5); });
    run<2>(Phase::edge_recovery_brc3, [this] { m_recovery.recover_edges_brc3(5); });
    run<2>(Phase::edge_reconnection, [this] { m_recovery.reconnect_edges(); });
    run<3>(Phase::facet_recovery_brc2, [this] { m_recovery.recover_facets_brc2(5); });
    run<3>(Phase::facet_recovery_brc4, [this] { m_recovery.recover_facets_brc4(5); });
    run<3>(Phase::facet_reconnection, [this] { m_recovery.reconnect_facets(); });
    m_state.run(Phase::recount, [this] { m_state.look_up_all(); });
    check_state();
    assert(m_state.is_nothing_lost() == (m_scene.lost<2>().empty() && m_scene.lost<3>().empty()));
    return m_visitor.begun;
  }

  void check_mesh() { m_scene.check(); }

  Watching_visitor& visitor() { return m_visitor; }

private:
  template <std::size_t N, typename Work>
  void run(const Phase phase, const Work& work)
  {
    if(internal::contains(m_left_out, phase))
      return;
    const bool is_expected = ! m_scene.treatable<N>().empty() && ! m_context.is_stopped();
    const std::size_t number_of_lost = m_scene.lost<N>().size(), number_of_phases = m_state.phases.size();
    const std::size_t number_of_transformations = m_state.number_of_transformations;
    const std::size_t number_of_replacements = m_visitor.number_of_replacements;
    work();
    const bool has_run = m_state.phases.size() > number_of_phases;
    assert(has_run == is_expected || m_context.is_stopped());
    check_state();
    assert(m_state.number_of_transformations - number_of_transformations
           == m_visitor.number_of_replacements - number_of_replacements);
    if(! has_run)
    {
      assert(m_visitor.number_of_replacements == number_of_replacements);
      return;
    }
    assert(m_state.phases.back().phase == phase && m_state.phases.size() == number_of_phases + 1);
    const std::size_t number_of_recovered = number_of_lost - m_scene.lost<N>().size();
    number_of["recovered in phase " + std::to_string(static_cast<int>(phase))] += number_of_recovered;
    assert(number_of_recovered == 0 || m_visitor.number_of_replacements > number_of_replacements);
  }

  // What is said to be lost is lost, and the visitor and the account know what the state knows.
  void check_state()
  {
    m_scene.check();
    m_visitor.check(m_scene.tr);
    assert(m_state.lost.edges == m_scene.lost<2>() && m_state.lost.facets == m_scene.lost<3>());
    assert(m_visitor.begun.size() == m_state.phases.size() && m_visitor.ended.size() == m_state.phases.size());
    for(std::size_t i = 0; i < m_state.phases.size(); ++i)
      assert(m_visitor.begun[i] == m_state.phases[i].phase && m_visitor.ended[i].phase == m_state.phases[i].phase);
    const auto& last = m_state.phases.back();
    const auto& told = m_visitor.ended.back();
    assert(told.lost_edges == last.lost_edges && told.lost_facets == last.lost_facets && told.seconds == last.seconds);
    assert(last.lost_edges == m_state.lost.edges.size() && last.lost_facets == m_state.lost.facets.size());
    assert(last.seconds >= 0);
  }

  Scene m_scene;
  Watching_visitor m_visitor;
  internal::Any_visitor_3<Tr, Watching_visitor&> m_any_visitor;
  Context m_context;
  State m_state;
  Recovery m_recovery;
  std::vector<Phase> m_left_out;
};

// Undisturbed; without those that do most; stopped from the beginning, when only what decides on the outcome runs; and
// stopped or thrown in the middle.
void test_phases(const br3_test::Plc& plc)
{
  typedef BR::Phase Phase;
  Phase_by_phase without_first(plc), without_flips(plc);
  without_first({ Phase::plain_removal, Phase::edge_recovery_brc1, Phase::facet_recovery_brc2 });
  without_flips({ Phase::plain_removal, Phase::edge_recovery_brc1, Phase::edge_recovery_brc3,
                  Phase::facet_recovery_brc2, Phase::facet_recovery_brc4 });
  Phase_by_phase undisturbed(plc), stopped(plc), stopped_later(plc), thrown(plc);
  undisturbed();
  stopped.visitor().last_question = 0;
  assert((stopped() == std::vector<Phase>{ Phase::search, Phase::recount }));
  stopped_later.visitor().last_question = undisturbed.visitor().number_of_questions / 2;
  stopped_later();
  const std::size_t n = undisturbed.visitor().number_of_replacements;
  if(n == 0)
    return;
  thrown.visitor().last_replacement = (n + 1) / 2;
  try {
    thrown();
    assert(false);
  } catch(const Thrown&) { }
  thrown.check_mesh();
  ++number_of["exceptions"];
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
  std::cout << number_of["exceptions"] << " exceptions" << std::endl;
  assert(number_of["exceptions"] > 0);
  std::cout << number_of["failures in cavities"] << " failures in cavities" << std::endl;
  assert(number_of["failures in cavities"] > 0);
  typedef BR::Phase Phase;
  for(const Phase phase : { Phase::plain_removal, Phase::edge_recovery_brc1, Phase::edge_recovery_brc3,
                            Phase::edge_reconnection, Phase::facet_recovery_brc2, Phase::facet_recovery_brc4,
                            Phase::facet_reconnection })
  {
    const std::string kind = "recovered in phase " + std::to_string(static_cast<int>(phase));
    std::cout << number_of[kind] << ' ' << kind << std::endl;
    assert(number_of[kind] > 0);
  }
  std::cout << "done" << std::endl;
}
