// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The recovery by Steiner points as a transaction: what each mode leaves in the mesh, what is taken back where this
// does not work or a visitor throws, what the visitor is told, and the account.

#undef NDEBUG

#include "cell_mirror_br3.h"
#include "steiner_inputs_br3.h"
#include "steiner_scene_br3.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_by_points_3.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;
namespace internal = CGAL::Boundary_recovery_3::internal;
using br3_test::Plc;
typedef BR::Recovery_mode   Mode;
typedef BR::Phase  Phase;

struct Thrown { };

// Checks what it is told of cells, writes down what it is told of phases, and throws when it is called for the n-th
// time.
struct Visitor
  : public br3_test::Cell_mirror<br3_test::Scene_triangulation>
{
  typedef br3_test::Cell_mirror<br3_test::Scene_triangulation> Mirror;

  using Mirror::Mirror;

  void on_phase_begin(const Phase phase)
  {
    begun.push_back(phase);
    count();
  }

  void on_phase_end(const BR::Phase_report& report)
  {
    assert(report.phase == begun.back());
    ended.push_back(report);
    count();
    if(report.phase == Phase::recount)
      recounts.push_back(number_of_calls);
  }

  void on_progress(const Phase phase, const std::size_t done, const std::size_t total)
  {
    assert(phase == begun.back() && ended.size() + 1 == begun.size() && done <= total);
    count();
  }

  bool go_further()
  {
    count();
    return number_of_calls < last_call_before_stop;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    count();
    Mirror::before_cells_removal(cells);
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    Mirror::after_cells_creation(cells);
    count();
  }

  void count()
  {
    assert(! has_thrown);
    has_thrown = ++number_of_calls == last_call;
    if(has_thrown)
      throw Thrown();
  }

  std::vector<Phase> begun;
  std::vector<BR::Phase_report> ended;
  std::vector<std::size_t> recounts; // at which calls these ended
  std::size_t number_of_calls = 0;
  std::size_t last_call = std::size_t(-1), last_call_before_stop = std::size_t(-1);
  bool has_thrown = false;
};

typedef br3_test::Steiner_scene<Visitor>                    Scene;
typedef Scene::Tr                                           Tr;
typedef Scene::Vertex_handle                                Vertex_handle;
typedef internal::Recover_by_points_3<Tr>                  Recovery;
typedef std::vector<Vertex_handle>                          Vertices;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

const int max_recursion_level = 30;

// The constraints that are not in the mesh as one simplex.
internal::Lost_constraints lost_constraints(const Scene& scene)
{
  internal::Lost_constraints result;
  Tr::Cell_handle c;
  int i, j, k;
  for(std::size_t e = 0; e < scene.constraints.edges().size(); ++e)
    if(! scene.tr.is_edge(scene.constraints.edges()[e][0], scene.constraints.edges()[e][1], c, i, j))
      result.edges.push_back(e);
  for(std::size_t f = 0; f < scene.constraints.facets().size(); ++f)
  {
    const auto& v = scene.constraints.facets()[f];
    if(! scene.tr.is_facet(v[0], v[1], v[2], c, i, j, k))
      result.facets.push_back(f);
  }
  return result;
}

bool are_same(const internal::Lost_constraints& x, const internal::Lost_constraints& y)
{
  return x.edges == y.edges && x.facets == y.facets;
}

// What there was before a recovery.
struct Earlier
{
  explicit Earlier(const Scene& scene)
    : cells(scene.cells()), lost(scene.state.lost), points(scene.ledger.points()),
      numbers{ scene.ledger.number_of_constraint_points(), scene.ledger.number_of_free_points() }
  {
    for(const Vertex_handle v : scene.tr.finite_vertex_handles())
      positions[&*v] = v->point();
  }

  // Also that the mesh is valid, and that nothing is left in the ledger.
  void check_nothing_has_changed(const Scene& scene) const
  {
    assert(scene.is_valid() && scene.cells() == cells && scene.ledger.points() == points);
    assert(Earlier(scene).positions == positions && scene.ledger.positions().empty());
    assert(Earlier(scene).numbers == numbers && scene.ledger.points_on_constraints().empty());
    assert(are_same(scene.state.lost, lost) && scene.ledger.free_points() == points);
  }

  Scene::Cells cells;
  internal::Lost_constraints lost;
  Vertices points;
  std::vector<std::size_t> numbers;
  std::map<const void*, Tr::Point> positions;
};

// Attempts, each of some phases in their order, that end with a recount; none but the last one works. One that was
// stopped before its first phase has the recount only.
void check_account(const Scene& scene, const Mode mode, const bool is_done)
{
  const std::vector<BR::Phase_report>& phases = scene.state.phases;
  assert(scene.visitor.begun.size() == phases.size() && scene.visitor.ended.size() == phases.size());
  int number_of_attempts = 0;
  Phase last = Phase::recount;
  for(std::size_t i = 0; i < phases.size(); ++i)
  {
    assert(scene.visitor.begun[i] == phases[i].phase && scene.visitor.ended[i].phase == phases[i].phase);
    assert(scene.visitor.ended[i].lost_edges == phases[i].lost_edges && phases[i].seconds >= 0);
    assert(scene.visitor.ended[i].lost_facets == phases[i].lost_facets);
    number_of_attempts += phases[i].phase == Phase::conforming_edge_recovery;
    const bool is_first = phases[i].phase == Phase::conforming_edge_recovery
                       || (scene.context.is_stopped() && phases[i].phase == Phase::recount);
    assert(last == Phase::recount ? is_first : phases[i].phase > last);
    number_of["stopped before the first phase"] += last == Phase::recount && phases[i].phase == Phase::recount;
    assert(mode != Mode::conforming || phases[i].phase == Phase::recount || phases[i].phase < Phase::steiner_splitting);
    last = phases[i].phase;
  }
  assert(number_of_attempts <= 6);
  if(number_of_attempts == 0)
    return;
  assert(last == Phase::recount && phases.back().lost_edges == scene.state.lost.edges.size());
  assert(phases.back().lost_facets == scene.state.lost.facets.size());
  assert(scene.ledger.points_on_constraints().size() <= scene.ledger.number_of_constraint_points());
  assert(scene.ledger.free_points().size() <= scene.ledger.number_of_free_points());
  if(! is_done || number_of_attempts > 1)
    ++number_of[mode == Mode::flips_only ? "taken back without points" : "taken back"];
}

// Runs a mode, and returns whether it did what it says.
bool recover(Scene& scene, const Mode mode)
{
  Recovery recovery(scene.state, scene.ledger);
  recovery.look_up();
  assert(are_same(scene.state.lost, lost_constraints(scene)));
  const Earlier earlier(scene);
  const bool was_anything_lost = ! scene.state.is_nothing_lost();
  const bool is_done = recovery(mode, max_recursion_level);
  assert(is_done == scene.state.is_nothing_lost());
  check_account(scene, mode, is_done);
  scene.visitor.check(scene.tr);
  if(! is_done)
    earlier.check_nothing_has_changed(scene);
  if(! was_anything_lost || ! is_done)
    return is_done;
  assert(scene.is_valid() && scene.is_conforming() && scene.ledger.positions().empty());
  assert(scene.tr.number_of_vertices() == scene.vertices.size() + scene.ledger.points().size());
  for(const Vertex_handle v : earlier.points)
    assert(scene.ledger.is_free(v) && scene.tr.tds().is_vertex(v));
  if(mode == Mode::conforming)
    assert(scene.ledger.free_points() == earlier.points);
  else
    assert(scene.ledger.points_on_constraints().empty() && lost_constraints(scene).edges.empty()
           && lost_constraints(scene).facets.empty());
  if(mode == Mode::flips_only)
    assert(scene.ledger.points() == earlier.points);
  if(scene.ledger.number_of_constraint_points() == earlier.numbers[0])
    ++number_of["recovered without any point"];
  else
    ++number_of[mode == Mode::conforming ? "recovered conforming"
                : mode == Mode::flips_only ? "recovered without points in the end" : "recovered"];
  return true;
}

// First some of the constraints, then all of them: the points that are there stay.
void test_settled_points(const Plc& plc, const Mode mode)
{
  Plc first = plc;
  first.triangles.resize(plc.triangles.size() / 2);
  Scene scene(first);
  if(! recover(scene, Mode::constrained))
    return;
  const Vertices points = scene.ledger.points();
  for(std::size_t f = first.triangles.size(); f < plc.triangles.size(); ++f)
  {
    const auto& t = plc.triangles[f];
    scene.constraints.insert(scene.vertices[t[0]], scene.vertices[t[1]], scene.vertices[t[2]]);
  }
  scene.state.phases.clear();
  scene.visitor.begun.clear();
  scene.visitor.ended.clear();
  recover(scene, mode);
  number_of["settled points"] += ! points.empty();
}

// Throws at some of the calls, early and late ones. Then all is as before, and a recovery does what it does.
void test_exceptions(const Plc& plc, const Mode mode)
{
  Scene unstopped(plc);
  const bool is_done = recover(unstopped, mode);
  const std::size_t n = unstopped.visitor.number_of_calls;
  std::set<std::size_t> calls;
  for(std::size_t i = 1; i <= n; ++i)
    if(i <= 6 || i + 6 > n || i % (1 + n / 20) == 0)
      calls.insert(i);
  for(const std::size_t call : calls)
  {
    Scene scene(plc);
    Recovery recovery(scene.state, scene.ledger);
    recovery.look_up();
    const Earlier earlier(scene);
    scene.visitor.last_call = call;
    try {
      recovery(mode, max_recursion_level);
      assert(false);
    } catch(const Thrown&) { }
    earlier.check_nothing_has_changed(scene);
    ++number_of[scene.visitor.begun.empty() ? "thrown before the first phase"
                : "thrown in phase " + std::to_string(static_cast<int>(scene.visitor.begun.back()))];
    Visitor fresh(scene.tr);
    Scene::Any_visitor any_fresh(fresh);
    Scene::Context context(any_fresh);
    Scene::State state(scene.tr, scene.predicates, scene.constraints, context);
    Recovery again(state, scene.ledger);
    again.look_up();
    assert(again(mode, max_recursion_level) == is_done);
    fresh.check(scene.tr);
  }
}

// Stopped at some of the questions, those between two attempts included: what is not complete is taken back.
void test_stops(const Plc& plc, const Mode mode)
{
  Scene unstopped(plc);
  recover(unstopped, mode);
  const std::size_t n = unstopped.visitor.number_of_calls;
  std::vector<std::size_t> calls;
  for(std::size_t i = 0; i < n; i += 1 + n / 10)
    calls.push_back(i);
  for(const std::size_t end_of_attempt : unstopped.visitor.recounts)
    for(std::size_t i = 0; i < 3; ++i)
      calls.push_back(end_of_attempt + i);
  for(const std::size_t call : calls)
  {
    Scene scene(plc);
    scene.visitor.last_call_before_stop = call;
    number_of["stopped"] += ! recover(scene, mode) && scene.context.is_stopped();
  }
}

void test(const Plc& plc)
{
  if(Scene(plc).tr.dimension() < 3)
    return;
  for(const Mode mode : { Mode::flips_only, Mode::conforming, Mode::constrained })
  {
    Scene scene(plc);
    recover(scene, mode);
    test_settled_points(plc, mode);
  }
}

int main()
{
  const Plc schoenhardt = br3_test::twisted_prism(3, .3, 1000, 1000);
  const Plc prism = br3_test::twisted_prism(6, .3, 1000, 1000);
  for(const Plc& plc : { schoenhardt, prism, br3_test::Notched_box(1, 1).plc() })
    test(plc);
  for(unsigned seed = 0; seed < 12; ++seed)
    test(br3_test::Random_constraints(seed)(6 + static_cast<int>(seed) % 9, seed % 2 == 0 ? 4 : 40, 60, 40));
  for(std::size_t blades = 0; blades <= 4; ++blades)
    test(br3_test::Random_constraints(7).fan(blades, 14));
  for(unsigned seed = 0; seed < 4; ++seed)
    test(br3_test::flat_hull(seed, 12));
  for(const Mode mode : { Mode::flips_only, Mode::conforming, Mode::constrained })
    for(const Plc& plc : { schoenhardt, prism, br3_test::Random_constraints(2)(10, 4, 60, 40) })
    {
      test_exceptions(plc, mode);
      test_stops(plc, mode);
    }
  for(const auto& n : number_of)
    std::cout << n.second << " x " << n.first << std::endl;
  for(const std::string kind : { "recovered", "recovered conforming", "recovered without points in the end",
                                 "taken back without points", "settled points", "stopped",
                                 "stopped before the first phase", "thrown before the first phase" })
    assert(number_of[kind] > 0);
  for(const Phase phase : { Phase::conforming_edge_recovery, Phase::conforming_facet_recovery, Phase::steiner_splitting,
                            Phase::steiner_suppression, Phase::recount })
    assert(number_of["thrown in phase " + std::to_string(static_cast<int>(phase))] > 0);
  std::cout << "done" << std::endl;
}
