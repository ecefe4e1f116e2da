// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Many isolated edges that cross each other at small distances, as fibres and wells do. The points that come off them
// are many and close to each other, and all of them have to be where floating point numbers are.

#undef NDEBUG

#include "recover_and_judge_br3.h"
#include "steiner_scene_br3.h"

#include <CGAL/Boundary_recovery_3/internal/lost/Constraint_search_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_by_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_isolated_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_free_point_3.h>

#include <CGAL/Random.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;

typedef br3_test::Scene_triangulation              Tr;
typedef Tr::Vertex_handle                          Vertex_handle;
typedef CGAL::Boundary_recovery_3::Recovery_mode   Mode;
typedef CGAL::Boundary_recovery_3::Phase  Phase;

// Looks when a phase ends, and at one of its calls, stops the recovery or throws.
struct Visitor
  : public CGAL::Default_meshing_visitor_3
{
  struct Disturbance { };

  explicit Visitor(const Tr&) { }

  bool go_further()
  {
    if(++number_of_calls == call && is_throwing)
      throw Disturbance();
    return number_of_calls < call;
  }

  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& report)
  {
    if(report.phase == Phase::conforming_edge_recovery && look)
      look(report.lost_edges);
  }

  std::size_t number_of_calls = 0;
  std::size_t call = std::size_t(-1);
  bool is_throwing = false;
  std::function<void(std::size_t)> look;
};

typedef br3_test::Steiner_scene<Visitor>   Scene;

void add_edge(br3_test::Plc& plc, const br3_test::Coordinates& p, const br3_test::Coordinates& q)
{
  plc.edges.push_back({ plc.points.size(), plc.points.size() + 1 });
  plc.points.push_back(p);
  plc.points.push_back(q);
}

br3_test::Plc random_segments(const std::size_t number, const unsigned seed)
{
  br3_test::Plc plc;
  CGAL::Random random(seed);
  const auto random_point = [&]
  {
    br3_test::Coordinates p;
    for(double& x : p)
      x = random.get_double();
    return p;
  };
  for(std::size_t i = 0; i < number; ++i)
  {
    const br3_test::Coordinates p = random_point(), q = random_point();
    add_edge(plc, p, q);
  }
  return plc;
}

// Lines of both families of the hyperbolic paraboloid z = xy, those of one a little above the others.
br3_test::Plc skew_lines(const int number)
{
  br3_test::Plc plc;
  const double gap = 1. / 1024;
  for(int i = 0; i < number; ++i)
  {
    const double t = -1 + 2. * i / (number - 1);
    add_edge(plc, {{ t, -1.125, -1.125 * t }}, {{ t, 1.125, 1.125 * t }});
    add_edge(plc, {{ -1.125, t, -1.125 * t + gap }}, {{ 1.125, t, 1.125 * t + gap }});
  }
  return plc;
}

// A long edge, the first, that passes bars on all sides, none farther than a thousandth of the distance between them.
br3_test::Plc edge_along_bars(const int number, const unsigned seed)
{
  br3_test::Plc plc;
  CGAL::Random random(seed);
  add_edge(plc, {{ 0, 0, -1 }}, {{ 0, 0, double(number) }});
  for(int i = 0; i < number; ++i)
  {
    const double angle = 2 * CGAL_PI * random.get_double(), x = std::cos(angle), y = std::sin(angle);
    const double distance = random.get_double(.0001, .001), shift = random.get_double(-.15, .15);
    const double slope = random.get_double(-.25, .25);
    const auto point = [&](const double t)
    {
      return br3_test::Coordinates{{ t * x - distance * y, t * y + distance * x, i + slope * t }};
    };
    add_edge(plc, point(shift - .5), point(shift + .5));
  }
  return plc;
}

// Right after all points came off their edges, many of them had no position that the triangulation could store, and
// there were eight times as many as on the edges.
void test_points_that_come_off_edges(const br3_test::Plc& plc)
{
  Scene scene(plc);
  internal::Recover_by_points_3<Tr> recover(scene.state, scene.ledger);
  recover.look_up();
  recover.recover_conforming(3);
  assert(scene.state.is_nothing_lost() && scene.is_conforming());
  assert(recover.split_points() && scene.ledger.points_on_constraints().empty() && scene.is_valid());
  const auto& points = scene.ledger.free_points();
  const std::size_t number_on_edges = scene.ledger.number_of_constraint_points();
  std::cout << number_on_edges << " points on edges, then " << points.size() << " beside them" << std::endl;
  assert(! points.empty() && points.size() < 4 * number_on_edges);
  assert(std::none_of(points.begin(), points.end(), [&](const Vertex_handle v)
  {
    return scene.ledger.positions().contains(v);
  }));
  recover.recount();
  assert(scene.state.is_nothing_lost());
}

template <typename Editor>
void split_cell(Editor& editor, const Tr::Cell_handle c, const Vertex_handle v)
{
  std::vector<std::array<Vertex_handle, 3> > faces;
  for(int i = 0; i < 4; ++i)
    faces.push_back(internal::facet_vertices(c, i));
  editor.replace(std::array<Tr::Cell_handle, 1>{{ c }}, internal::star(faces, v), std::vector<Vertex_handle>());
}

// A new point goes if its star can do without it, and else moves to the middle; both keep the parts of edges.
void test_suppression_of_one_point()
{
  Scene scene(random_segments(12, 3));
  typedef internal::Mesh_editor_3<Tr>  Editor;
  typedef internal::Steiner_mesh_3<Tr> Mesh;
  internal::Recover_by_points_3<Tr> recover(scene.state, scene.ledger);
  recover.look_up();
  recover.recover_conforming(0);
  const std::size_t number = scene.ledger.points_on_constraints().size();
  assert(number > 0 && scene.is_conforming());

  Editor editor(scene.tr, scene.any_visitor);
  Mesh mesh(editor, scene.predicates, scene.constraints, scene.ledger, scene.context);
  internal::Suppress_free_point_3<Tr, Scene::Ledger> suppress(mesh, scene.ledger);
  for(int i = 0; i < 2; ++i)
  {
    const Tr::Cell_handle c = scene.tr.finite_cells_begin();
    const auto center = CGAL::centroid(scene.ledger.positions()(c->vertex(0)), scene.ledger.positions()(c->vertex(1)),
                                       scene.ledger.positions()(c->vertex(2)), scene.ledger.positions()(c->vertex(3)));
    const std::size_t number_of_cells = scene.tr.number_of_finite_cells();
    const Vertex_handle v = editor.create_vertex();
    scene.ledger.positions().set(v, center);
    scene.ledger.insert_free(v, scene.ledger.carrier(scene.ledger.points_on_constraints().front()));
    split_cell(editor, c, v);
    suppress.relocate(v);
    assert(scene.is_valid() && scene.is_conforming() && ! scene.ledger.positions().contains(v));
    assert(suppress.remove(v, 4));
    assert(scene.is_valid() && scene.is_conforming() && ! scene.ledger.is_free(v));
    assert(scene.tr.number_of_finite_cells() == number_of_cells);
  }
  assert(scene.ledger.points_on_constraints().size() == number);
}

// Points that go from chains leave parts of edges behind, no others come in their place, and those that stay do not
// move.
void test_points_that_go_from_chains()
{
  Scene scene(random_segments(30, 6));
  internal::Recover_by_points_3<Tr> recover(scene.state, scene.ledger);
  recover.look_up();
  recover.recover_conforming(0);
  assert(scene.is_conforming());
  internal::Mesh_editor_3<Tr> editor(scene.tr, scene.any_visitor);
  internal::Steiner_mesh_3<Tr> mesh(editor, scene.predicates, scene.constraints, scene.ledger, scene.context);
  internal::Remove_chain_point_3<Tr> remove(mesh);
  const std::vector<Vertex_handle> before = scene.ledger.points_on_constraints();
  std::size_t number_of_vertices = scene.tr.number_of_vertices();
  for(const Vertex_handle s : before)
  {
    const std::size_t e = scene.ledger.carrier(s).index;
    const std::size_t length = scene.ledger.vertices_on_edge(e).size();
    const auto position = scene.ledger.positions()(s);
    const bool is_gone = remove(s, 4);
    assert(scene.ledger.is_on_constraint(s) != is_gone && scene.ledger.positions().contains(s) != is_gone);
    assert(is_gone || scene.ledger.positions()(s) == position);
    assert(scene.ledger.vertices_on_edge(e).size() == length - (is_gone ? 1 : 0));
    number_of_vertices -= is_gone ? 1 : 0;
    assert(scene.tr.number_of_vertices() == number_of_vertices);
    assert(scene.is_valid() && scene.is_conforming() && scene.ledger.free_points().empty());
  }
  const std::size_t number = scene.ledger.points_on_constraints().size();
  std::cout << before.size() << " points on chains, then " << number << std::endl;
  assert(number > 0 && 10 * number < 9 * before.size());
}

// --- one by one -----------------------------------------------------------------------------------------------------

bool recover_one_by_one(Scene& scene, const std::size_t max_number_at_once = 0)
{
  internal::Recover_by_points_3<Tr> recover(scene.state, scene.ledger);
  recover.look_up();
  return recover(Mode::constrained, 30, max_number_at_once);
}

// When the last edge is whole, no point is on any, and all points are where floating point numbers are. If all edges
// became chains first, this would be known only in the end. Returns the number of calls that can be disturbed.
std::size_t test_one_by_one(const br3_test::Plc& plc, const bool are_at_once)
{
  Scene scene(plc);
  std::size_t number_of_attempts = 0;
  scene.visitor.look = [&](const std::size_t number_of_lost_edges)
  {
    ++number_of_attempts;
    assert(number_of_lost_edges == 0 && scene.is_valid() && scene.is_conforming());
    assert(scene.ledger.points_on_constraints().empty() != are_at_once);
    assert(scene.ledger.free_points().empty() == are_at_once);
    assert(are_at_once || scene.ledger.positions().empty());
  };
  assert(recover_one_by_one(scene, are_at_once ? plc.edges.size() : 0) && number_of_attempts == 1);
  assert(scene.is_valid() && scene.is_conforming() && scene.ledger.positions().empty());
  assert(scene.ledger.points_on_constraints().empty() && ! scene.ledger.free_points().empty());
  assert(scene.ledger.points().size() == scene.tr.number_of_vertices() - plc.points.size());
  return scene.visitor.number_of_calls;
}

// Then all is as before, also what was recovered already. A stop in the end may do no harm.
void test_disturbance(const br3_test::Plc& plc, const std::size_t call, const bool is_throwing)
{
  Scene scene(plc);
  const Scene::Cells cells = scene.cells();
  scene.visitor.call = call;
  scene.visitor.is_throwing = is_throwing;
  try {
    if(recover_one_by_one(scene))
    {
      assert(! is_throwing && scene.is_valid() && scene.is_conforming() && scene.ledger.positions().empty());
      return;
    }
    assert(! is_throwing);
  } catch(const Visitor::Disturbance&) {
    assert(is_throwing);
  }
  assert(scene.cells() == cells && scene.ledger.points().empty() && scene.ledger.positions().empty());
  assert(scene.ledger.number_of_constraint_points() == 0 && scene.ledger.number_of_free_points() == 0);
}

// An edge with a vertex on it is put back, time after time; the others are whole and stay so, until all is put back.
void test_edge_that_fails(br3_test::Plc plc)
{
  add_edge(plc, {{ .25, .25, .25 }}, {{ .75, .75, .75 }});
  add_edge(plc, {{ .5, .5, .5 }}, {{ .25, .75, .5 }});
  Scene scene(plc);
  const Scene::Cells cells = scene.cells();
  std::size_t number_of_attempts = 0;
  scene.visitor.look = [&](const std::size_t number_of_lost_edges)
  {
    ++number_of_attempts;
    assert(number_of_lost_edges == 1 && scene.is_valid() && ! scene.ledger.free_points().empty());
    internal::Constraint_search_3<Tr> search(scene.tr, scene.constraints);
    assert(search().edges == std::vector<std::size_t>(1, plc.edges.size() - 2));
    assert(scene.ledger.positions().empty());
  };
  assert(! recover_one_by_one(scene) && number_of_attempts == 1);
  assert(scene.cells() == cells && scene.ledger.points().empty());
}

// If no point went from its chain, nearly four would come off the edges for each one that was put on them, not three.
void test_numbers_of_points(const Scene::Ledger& ledger)
{
  std::cout << ledger.number_of_constraint_points() << " points came to edges, " << ledger.number_of_free_points()
            << " off edges" << std::endl;
  assert(2 * ledger.number_of_free_points() < 7 * ledger.number_of_constraint_points());
}

// After each edge, with or without rounds. What came for the edges before is left alone, until room is made.
void test_edge_after_edge(const br3_test::Plc& plc)
{
  Scene scene(plc);
  internal::Mesh_editor_3<Tr> editor(scene.tr, scene.any_visitor);
  internal::Steiner_mesh_3<Tr> mesh(editor, scene.predicates, scene.constraints, scene.ledger, scene.context);
  internal::Recover_isolated_edge_3<Tr> recover(mesh);
  internal::Constraint_search_3<Tr> search(scene.tr, scene.constraints);
  for(std::vector<std::size_t> lost = search().edges; ! lost.empty(); lost = search().edges)
  {
    scene.ledger.settle();
    assert(recover(lost.front(), 0, 4, lost.size() % 2 == 0 ? 0 : 20));
    scene.ledger.unsettle();
    const std::vector<std::size_t> after = search().edges;
    assert(after.size() < lost.size() && std::includes(lost.begin(), lost.end(), after.begin(), after.end()));
    assert(after.empty() || after.front() != lost.front());
    assert(scene.is_valid() && scene.ledger.points_on_constraints().empty() && scene.ledger.positions().empty());
  }
  assert(! scene.ledger.free_points().empty() && recover.number_of_transformations() > 0);
  test_numbers_of_points(scene.ledger);
  const auto& points = scene.ledger.free_points();
  const std::size_t number = points.size();
  recover.thin_out(4);
  const std::size_t number_then = points.size();
  recover.make_room(4);
  assert(number_then < number && points.size() <= number_then && search().edges.empty());
  assert(scene.is_valid() && scene.is_conforming() && scene.ledger.positions().empty());
}

// When one end of a part of the edge went from point to point along the chain, the stars became too thin for numbers.
void test_long_chain()
{
  Scene scene(edge_along_bars(150, 1));
  internal::Mesh_editor_3<Tr> editor(scene.tr, scene.any_visitor);
  internal::Steiner_mesh_3<Tr> mesh(editor, scene.predicates, scene.constraints, scene.ledger, scene.context);
  internal::Recover_isolated_edge_3<Tr> recover(mesh);
  assert(recover(0, 3, 30, 0));
  std::cout << scene.ledger.number_of_constraint_points() << " points came to a long edge" << std::endl;
  assert(scene.ledger.number_of_constraint_points() > 100);
  assert(scene.is_valid() && scene.ledger.points_on_constraints().empty() && scene.ledger.positions().empty());
  internal::Constraint_search_3<Tr> search(scene.tr, scene.constraints);
  assert(search().edges.empty());
}

void test_one_by_one()
{
  const br3_test::Plc plc = random_segments(20, 2);
  const std::size_t number_of_calls = test_one_by_one(plc, false);
  test_one_by_one(plc, true);
  for(const bool is_throwing : { false, true })
    for(std::size_t call = 1; call < number_of_calls; call += 1 + number_of_calls / 7)
      test_disturbance(plc, call, is_throwing);
  test_edge_that_fails(plc);
  test_edge_after_edge(random_segments(16, 4));
}

void test_recovery(const br3_test::Plc& plc)
{
  br3_test::Fuzz_case c;
  c.plc = plc;
  assert(br3_test::recover_and_judge(c) == br3_test::Recovery_status::recovered);
}

int main()
{
  test_points_that_come_off_edges(random_segments(50, 1));
  test_points_that_come_off_edges(random_segments(60, 7));
  test_suppression_of_one_point();
  test_points_that_go_from_chains();
  test_one_by_one();
  test_long_chain();
  test_recovery(skew_lines(4));
  test_recovery(random_segments(12, 5));
  std::cout << "done" << std::endl;
}
