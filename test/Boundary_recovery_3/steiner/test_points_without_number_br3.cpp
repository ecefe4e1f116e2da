// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Points in layers that are thinner than numbers are from each other: cavities grow until such a point sees all from
// where a number is.

#undef NDEBUG

#include "stopping_visitor_br3.h"
#include "tetrahedralizations_br3.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Exact_positions_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Cell_replacement.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_validity.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Round_free_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_ledger_3.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

typedef BR::internal::Constraints_3<Tr>   Constraints;
typedef std::vector<Vertex_handle>        Vertices;
using br3_test::Patience;

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
  BR::internal::Cell_replacement<Tr> replace;
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
  typedef CGAL::Default_boundary_recovery_visitor_3 Visitor;
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
    BR::internal::Steiner_ledger_3<Tr> ledger(constraints);
    const Vertex_handle v = insert_in_center(tr, *thin, ledger.positions());
    ledger.insert_free(v, { 1, 0 });
    const std::size_t number_of_vertices = tr.number_of_vertices();

    const Predicates predicates(tr, &ledger.positions());
    Visitor visitor;
    BR::internal::Mesh_editor_3<Tr, Visitor> editor(tr, visitor);
    BR::internal::Round_free_point_3<Tr, Visitor> round_point(editor, predicates, constraints, ledger);
    Patience patience = { round % 3 == 0 ? random_int(rng, 60) : 1000000 };
    const bool is_done = round_point(v, patience);
    assert(BR::internal::is_mesh_valid(tr, predicates) && tr.number_of_vertices() == number_of_vertices);
    assert(is_done != ledger.positions().contains(v) && ledger.free_points() == Vertices(1, v));
    const Tetrahedra tetrahedra = tetrahedra_of(finite_cells(tr));
    assert(! is_done || total_volume(tetrahedra) == old_volume);
    for(const Edge& e : constraints.edges())
      assert(number_around(tetrahedra, e) > 0);
    for(const Facet& f : constraints.facets())
      assert(number_around(tetrahedra, f) > 0);
    assert(is_done || tr.degree(v) == 4);
    ++number_of[is_done ? "point that got a number" : patience.number_of_steps < 0 ? "stop" : "point without a number"];
  }
}

int main()
{
  test_points_without_number();
  for(const char* kind : { "point that got a number", "point without a number", "stop" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 0);
  }
  std::cout << "done" << std::endl;
}
