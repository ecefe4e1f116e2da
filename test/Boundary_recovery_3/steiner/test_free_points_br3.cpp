// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Free Steiner points: how they are merged, how their stars are reduced and how they are forgotten, against
// definitions. And those in layers that are thinner than numbers are from each other: cavities grow until such a point
// sees all from where a number is.

#undef NDEBUG

#include "cell_mirror_br3.h"
#include "recovery_of_oracles_br3.h"
#include "stopping_visitor_br3.h"
#include "tetrahedralizations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Round_steiner_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_free_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_steiner_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

typedef BR::internal::Constraints_3<Tr>           Constraints;
typedef BR::internal::Steiner_ledger_3<Tr>        Ledger;
typedef std::vector<Vertex_handle>                Vertices;
typedef std::set<Vertex_handle>                   Vertex_set;

// Checks what it is told, and says no after so many questions.
struct Mirror
  : public br3_test::Cell_mirror<Tr>
{
  explicit Mirror(const Tr& tr) : br3_test::Cell_mirror<Tr>(tr) { }

  bool go_further() { return patience.go_further(); }

  br3_test::Patience patience = { 1000000 };
};

typedef BR::internal::Any_visitor_3<Tr, Mirror&>  Any_mirror;
typedef BR::internal::Steiner_mesh_3<Tr>          Mesh;
typedef Mesh::Editor                              Editor;
typedef Mesh::Context                             Context;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

// Points of which most are in a layer that is thinner than numbers are from each other, and some above and below it.
Tr thin_layer(std::mt19937& rng)
{
  const double heights[] = { 1, std::nextafter(1., 2.) };
  Tr tr;
  for(int x = 0; x < 4; ++x)
    for(int y = 0; y < 4; ++y)
    {
      const int dx = random_int(rng, 4), dy = random_int(rng, 4);
      tr.insert(Point(8 * x + dx, 8 * y + dy, heights[random_int(rng, 2)]));
    }
  for(int i = 0; i < 8; ++i)
  {
    const int x = random_int(rng, 28), y = random_int(rng, 28);
    tr.insert(Point(x, y, i % 2 == 0 ? -9 : 11));
  }
  return tr;
}

// A vertex at the exact center of a cell, which may be too thin for a number.
Vertex_handle insert_in_center(Tr& tr, const Cell_handle c, BR::internal::Exact_positions_3<Tr>& positions)
{
  const Vertex_handle v = tr.tds().create_vertex();
  positions.set(v, CGAL::centroid(positions(c->vertex(0)), positions(c->vertex(1)), positions(c->vertex(2)),
                                  positions(c->vertex(3))));
  Tetrahedra tetrahedra;
  for(int i = 0; i < 4; ++i)
    tetrahedra.push_back(BR::internal::with_exchanged_vertex(c, c->vertex(i), v));
  BR::internal::Replace_cells<Tr> replace;
  replace(tr, Cells(1, c), tetrahedra);
  return v;
}

bool is_thin(const Cell_handle c)
{
  return volume({{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }}) < 1e-10;
}

// A point in a layer of slivers has to leave it, through what is no constraint.
void test_points_without_number()
{
  std::mt19937 rng(23);
  for(int round = 0; round < 300; ++round)
  {
    Tr tr = thin_layer(rng);
    const Cells cells = finite_cells(tr);
    const Number old_volume = total_volume(tetrahedra_of(cells));
    const auto thin = std::find_if(cells.begin(), cells.end(), is_thin);
    if(thin == cells.end())
      continue;
    Constraints constraints;
    for(const Cell_handle c : cells)
      if(random_int(rng, 5) < round % 5)
      {
        constraints.insert(c->vertex(0), c->vertex(1));
        if(round % 2 == 0)
          constraints.insert(c->vertex(0), c->vertex(1), c->vertex(2));
      }
    Ledger ledger(constraints);
    const Vertex_handle v = insert_in_center(tr, *thin, ledger.positions());
    ledger.insert_free(v, { 1, 0 });
    const std::size_t number_of_vertices = tr.number_of_vertices();

    const Predicates predicates(tr, &ledger.positions());
    Mirror mirror(tr);
    if(round % 3 == 0)
      mirror.patience = { random_int(rng, 60) };
    Any_mirror any_mirror(mirror);
    Editor editor(tr, any_mirror);
    Context context(any_mirror);
    Mesh mesh(editor, predicates, constraints, ledger, context);
    BR::internal::Round_free_point_3<Tr> round_point(mesh);
    const bool is_done = round_point(v);
    mirror.check(tr);
    assert(BR::internal::is_mesh_valid(tr, predicates) && tr.number_of_vertices() == number_of_vertices);
    assert(is_done != ledger.positions().contains(v) && ledger.free_points() == Vertices(1, v));
    const Tetrahedra tetrahedra = tetrahedra_of(finite_cells(tr));
    assert(! is_done || total_volume(tetrahedra) == old_volume);
    for(const Edge& e : constraints.edges())
      assert(number_around(tetrahedra, e) > 0);
    for(const Facet& f : constraints.facets())
      assert(number_around(tetrahedra, f) > 0);
    assert(is_done || tr.degree(v) == 4);
    ++number_of[is_done ? "point that got a number" : context.is_stopped() ? "stop" : "point without a number"];
  }
}

// Points in a layer of slivers, each but the first in the star of another one. Where none of those that are left gets a
// number any more, rounds still help: edges come off the points, some go, and their neighbors move.
void test_cluster_without_numbers(const unsigned seed)
{
  std::mt19937 rng(seed);
  Tr tr = thin_layer(rng);
  const Cells cells = finite_cells(tr);
  const auto thin = std::find_if(cells.begin(), cells.end(), is_thin);
  if(thin == cells.end())
    return;
  Constraints constraints;
  const int density = 1 + random_int(rng, 5);
  for(const Cell_handle c : cells)
    for(int i = 0; i < 4; ++i)
      if(random_int(rng, 6) < density)
      {
        const Facet f = BR::internal::facet_vertices(c, i);
        constraints.insert(f[0], f[1]);
        if(random_int(rng, 2) == 0)
          constraints.insert(f[0], f[1], f[2]);
      }
  Ledger ledger(constraints);
  Vertices points(1, insert_in_center(tr, *thin, ledger.positions()));
  for(int i = random_int(rng, 6); i >= 0; --i)
  {
    Cells star;
    assert(BR::internal::collect_star(tr, points[random_int(rng, static_cast<int>(points.size()))], star));
    const Cell_handle c = star[random_int(rng, static_cast<int>(star.size()))];
    points.push_back(insert_in_center(tr, c, ledger.positions()));
  }
  for(const Vertex_handle v : points)
    ledger.insert_free(v, { 1, 0 });

  const Predicates predicates(tr, &ledger.positions());
  Mirror mirror(tr);
  Any_mirror any_mirror(mirror);
  Editor editor(tr, any_mirror);
  Context context(any_mirror);
  Mesh mesh(editor, predicates, constraints, ledger, context);
  BR::internal::Round_free_point_3<Tr> round_point(mesh);
  const auto is_held = [&](const Vertex_handle v) { return ledger.is_free(v) && ! round_point(v); };
  std::size_t number_held = points.size() + 1;
  for(bool is_better = true; is_better; ) // a point may get a number when others have got one
  {
    const auto number = static_cast<std::size_t>(std::count_if(points.begin(), points.end(), is_held));
    is_better = number < number_held;
    number_held = number;
  }
  assert((number_held == 0) == ledger.positions().empty());
  BR::internal::Suppress_steiner_points_3<Tr> suppress(mesh);
  const bool is_done = suppress.round_points(0);
  mirror.check(tr);
  assert(BR::internal::is_mesh_valid(tr, predicates) && is_done == ledger.positions().empty());
  const Tetrahedra tetrahedra = tetrahedra_of(finite_cells(tr));
  for(const Edge& e : constraints.edges())
    assert(number_around(tetrahedra, e) > 0);
  for(const Facet& f : constraints.facets())
    assert(number_around(tetrahedra, f) > 0);
  if(number_held > 0)
    ++number_of[is_done ? "cluster that needed a round" : "cluster without numbers"];
}

// A mesh in which some of the inner vertices are free Steiner points, and some facets between others are constrained.
class Scene
{
public:
  Scene(const Tr& points, std::mt19937& rng)
    : tr(points), ledger(constraints), predicates(tr, &ledger.positions()), mirror(tr), any_mirror(mirror),
      editor(tr, any_mirror)
  {
    for(const Vertex_handle v : tr.finite_vertex_handles())
    {
      Cells star;
      if(random_int(rng, 2) == 0 && BR::internal::collect_star(tr, v, star))
        ledger.insert_free(v, { 1, 0 });
    }
    for(const Cell_handle c : tr.finite_cell_handles())
    {
      const Facet v = BR::internal::facet_vertices(c, random_int(rng, 4));
      if(random_int(rng, 2) == 0 && std::none_of(v.begin(), v.end(), [&](const auto w) { return ledger.is_free(w); }))
        constraints.insert(v[0], v[1], v[2]);
    }
    m_number_of_other_vertices = tr.number_of_vertices() - ledger.free_points().size();
    m_volume = total_volume(tetrahedra_of(finite_cells(tr)));
  }

  // The mesh is valid, has all that it has to have, and the ledger and the visitor know of it.
  void check() const
  {
    assert(BR::internal::is_mesh_valid(tr, predicates));
    const Tetrahedra tetrahedra = tetrahedra_of(finite_cells(tr));
    assert(! ledger.positions().empty() || total_volume(tetrahedra) == m_volume);
    assert(tr.number_of_vertices() == m_number_of_other_vertices + ledger.free_points().size());
    for(const Vertex_handle v : ledger.free_points())
      assert(ledger.is_free(v) && tr.tds().is_vertex(v));
    for(const Edge& e : constraints.edges())
      assert(number_around(tetrahedra, e) > 0);
    for(const Facet& f : constraints.facets())
      assert(number_around(tetrahedra, f) > 0);
    mirror.check(tr);
  }

  Cells star(const Vertex_handle v) const
  {
    Cells result;
    assert(BR::internal::collect_star(tr, v, result));
    return result;
  }

  Vertex_set neighbors(const Vertex_handle v) const
  {
    const Vertices result = BR::internal::vertices_without(star(v), v);
    return Vertex_set(result.begin(), result.end());
  }

  std::set<Vertex_set> cells() const
  {
    std::set<Vertex_set> result;
    for(const Tetrahedron& t : tetrahedra_of(finite_cells(tr)))
      result.insert(Vertex_set(t.begin(), t.end()));
    return result;
  }

  void merge(const Vertex_handle v, const int number_of_questions)
  {
    mirror.patience = { number_of_questions };
    Context context(any_mirror);
    Mesh mesh(editor, predicates, constraints, ledger, context);
    BR::internal::Merge_points_3<Tr> merge_points(mesh);
    merge_points(v, star(v));
  }

  Tr tr;
  Constraints constraints;
  Ledger ledger;
  const Predicates predicates;
  Mirror mirror;
  Any_mirror any_mirror; // hands on everything to `mirror`
  Editor editor;

private:
  std::size_t m_number_of_other_vertices;
  Number m_volume;
};

Tr random_mesh(std::mt19937& rng, const int number_of_points, const bool on_grid)
{
  Tr tr;
  for(int i = 0; i < number_of_points; ++i)
    tr.insert(random_point(rng, on_grid));
  return tr;
}

// Whether v could be merged with w without leaving where one of both is.
bool can_be_merged(const Scene& scene, const Vertex_handle v, const Vertex_handle w)
{
  BR::internal::Cavity_3<Tr> cavity(scene.tr, scene.constraints, scene.star(v));
  for(const Cell_handle c : scene.star(w))
    cavity.add(c);
  return std::any_of(cavity.vertices().begin(), cavity.vertices().end(), [&](const Vertex_handle x)
  {
    return (x == v || x == w) && BR::internal::find_obstacle_to_star(cavity, scene.predicates, x,
                                                                     scene.ledger.free_points())
                                   == BR::internal::Star_obstacle::NONE;
  });
}

// One of the neighbors is gone, or nothing has changed.
void test_merge(const unsigned seed)
{
  std::mt19937 rng(seed);
  Scene scene(random_mesh(rng, 40, seed % 2 == 0), rng);
  const Vertices points = scene.ledger.free_points();
  for(const Vertex_handle v : points)
  {
    if(! scene.ledger.is_free(v))
      continue;
    const std::set<Vertex_set> cells = scene.cells();
    const Vertices before = scene.ledger.free_points();
    const Vertex_set neighbors = scene.neighbors(v);
    const Point point = v->point();
    scene.merge(v, 0);
    assert(scene.cells() == cells && v->point() == point);
    scene.merge(v, 1000);
    scene.check();
    const Vertices after = scene.ledger.free_points();
    if(after == before)
    {
      assert(scene.cells() == cells && v->point() == point);
      for(const Vertex_handle w : neighbors)
        assert(! scene.ledger.is_free(w) || ! can_be_merged(scene, v, w));
      ++number_of["point that cannot be merged"];
      continue;
    }
    assert(after.size() + 1 == before.size() && scene.ledger.is_free(v));
    const auto w = std::find_if(before.begin(), before.end(), [&](const auto x) { return ! scene.ledger.is_free(x); });
    assert(w != before.end() && neighbors.count(*w) == 1);
    const std::set<Vertex_set> new_cells = scene.cells();
    for(const Vertex_set& c : cells)
      assert(c.count(*w) == 1 ? new_cells.count(c) == 0 : c.count(v) == 1 || new_cells.count(c) == 1);
    ++number_of["points that were merged"];
  }
}

// A point whose place is not a number stays as it is.
void test_merge_of_exact_position()
{
  std::mt19937 rng(3);
  Scene scene(random_mesh(rng, 40, false), rng);
  const std::set<Vertex_set> cells = scene.cells();
  for(const Vertex_handle v : scene.ledger.free_points())
  {
    const Point point = v->point();
    scene.ledger.positions().set(v, scene.ledger.positions()(v));
    scene.merge(v, 1000);
    assert(scene.cells() == cells && v->point() == point && scene.ledger.positions().contains(v));
    scene.ledger.positions().erase(v);
  }
}

// One neighbor after the other is gone, until there are few enough of them; none is new.
void test_reduction(const unsigned seed)
{
  std::mt19937 rng(seed);
  Scene scene(random_mesh(rng, 40, seed % 2 == 0), rng);
  BR::internal::Reduce_star_3<Tr, Constraints> reduce(scene.editor, scene.predicates, scene.constraints);
  for(const Vertex_handle v : scene.ledger.free_points())
  {
    const std::size_t wanted = 4 + static_cast<std::size_t>(random_int(rng, 3));
    const std::size_t number_of_transformations = reduce.number_of_transformations();
    Vertex_set neighbors = scene.neighbors(v);
    br3_test::Patience patience = { random_int(rng, 4) == 0 ? 0 : 1000 };
    const bool has_patience = patience.number_of_steps > 0;
    bool is_reached = false;
    const bool is_done = reduce(v, random_int(rng, 4), patience, [&](const Cells& star)
    {
      assert(! is_reached && std::set<Cell_handle>(star.begin(), star.end()).size() == star.size());
      const Cells expected = scene.star(v);
      assert(std::is_permutation(star.begin(), star.end(), expected.begin(), expected.end()));
      const Vertex_set left = scene.neighbors(v);
      assert(left.size() < neighbors.size());
      assert(std::includes(neighbors.begin(), neighbors.end(), left.begin(), left.end()));
      neighbors = left;
      is_reached = left.size() <= wanted;
      ++number_of["neighbor that was removed"];
      return is_reached;
    });
    scene.check();
    assert(is_done == is_reached);
    assert(has_patience || (! is_done && reduce.number_of_transformations() == number_of_transformations));
    const Vertex_set left = scene.neighbors(v); // an edge may be removed that the last one could not be tried for
    assert(std::includes(neighbors.begin(), neighbors.end(), left.begin(), left.end()));
    ++number_of[is_done ? "star that was reduced" : "star that was not reduced"];
  }
}

// Points in a cell, one of them in a cell at the other.
void test_forgetting()
{
  std::mt19937 rng(4);
  Scene scene(random_mesh(rng, 20, false), rng);
  const std::set<Vertex_set> before = scene.cells();
  const Cell_handle c = finite_cells(scene.tr).front();
  const Tetrahedra old_cell = tetrahedra_of(Cells(1, c));
  const auto split = [&](const Cell_handle cell)
  {
    const auto& positions = scene.ledger.positions();
    const Vertex_handle v = scene.editor.create_vertex();
    scene.ledger.positions().set(v, CGAL::centroid(positions(cell->vertex(0)), positions(cell->vertex(1)),
                                                   positions(cell->vertex(2)), positions(cell->vertex(3))));
    scene.ledger.insert_free(v, { 2, 0 });
    Tetrahedra tetrahedra;
    for(int i = 0; i < 4; ++i)
      tetrahedra.push_back(BR::internal::with_exchanged_vertex(cell, cell->vertex(i), v));
    scene.editor.replace(Cells(1, cell), tetrahedra);
    scene.check();
    return v;
  };
  const Vertex_handle v = split(c), w = split(scene.star(v).front());
  BR::internal::Cavity_3<Tr> cavity(scene.tr, scene.constraints, scene.star(v));
  for(const Cell_handle d : scene.star(w))
    cavity.add(d);
  BR::internal::star_and_forget(scene.editor, scene.ledger, cavity, v);
  scene.check();
  assert(scene.ledger.is_free(v) && scene.tr.degree(v) == 4 && ! scene.ledger.positions().contains(w));
  BR::internal::replace_and_forget(scene.editor, scene.ledger, scene.star(v), old_cell, Vertices(1, v));
  scene.check();
  assert(scene.cells() == before && scene.ledger.positions().empty());
}

// What could not be removed is not tried again by flips as long as its neighbors stay; another object, which does not
// know that, does try. The points are those that segments between random points need.
void test_failed_removals()
{
  std::mt19937 rng(1);
  std::vector<Point> points;
  for(int i = 0; i < 30; ++i)
  {
    const int x = random_int(rng, 100003), y = random_int(rng, 100003);
    points.emplace_back(x, y, random_int(rng, 100003));
  }
  std::vector<std::array<std::size_t, 2> > segments;
  for(std::size_t i = 0; i < points.size(); i += 2)
    segments.push_back({{ i, i + 1 }});
  Tr tr;
  const auto result = CGAL::recover_boundary(tr, points, std::vector<std::array<std::size_t, 3> >(),
                                             CGAL::parameters::constrained_edges(segments),
                                             CGAL::parameters::effort(BR::Recovery_effort::more_points));
  Constraints constraints;
  for(const auto& segment : segments)
  {
    Vertex_handle u, v;
    assert(tr.is_vertex(points[segment[0]], u) && tr.is_vertex(points[segment[1]], v));
    constraints.insert(u, v);
  }
  Ledger ledger(constraints);
  for(const Vertex_handle v : result.steiner_vertices)
    ledger.insert_free(v, { 1, 0 });
  const Predicates predicates(tr, &ledger.positions());
  Mirror mirror(tr);
  Any_mirror any_mirror(mirror);
  Editor editor(tr, any_mirror);
  Context context(any_mirror);
  Mesh mesh(editor, predicates, constraints, ledger, context);
  BR::internal::Suppress_steiner_points_3<Tr> suppress(mesh), other(mesh);
  const auto suppress_again = [&]
  {
    const Vertices before = ledger.free_points();
    suppress(4, BR::Recovery_effort::more_points);
    return ledger.free_points() != before;
  };
  while(suppress_again()) { }
  suppress_again(); // what lost a neighbor in the last round but one was tried in the last
  const std::size_t number_of_transformations = suppress.number_of_transformations();
  assert(! suppress_again() && ! ledger.free_points().empty());
  assert(suppress.number_of_transformations() == number_of_transformations);
  other(4, BR::Recovery_effort::more_points);
  assert(other.number_of_transformations() > 0 && BR::internal::is_mesh_valid(tr, predicates));
  mirror.check(tr);
}

int main()
{
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    test_merge(seed);
    test_reduction(seed);
  }
  test_merge_of_exact_position();
  test_forgetting();
  test_failed_removals();
  test_points_without_number();
  for(unsigned seed = 0; seed < 60; ++seed)
    test_cluster_without_numbers(seed);
  for(const char* kind : { "points that were merged", "point that cannot be merged", "neighbor that was removed",
                           "star that was reduced", "star that was not reduced", "point that got a number",
                           "point without a number", "stop",
                           "cluster that needed a round" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 0);
  }
  std::cout << "done" << std::endl;
}
