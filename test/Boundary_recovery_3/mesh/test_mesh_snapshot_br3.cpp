// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Snapshots of a mesh: what is restored is what was there.

#undef NDEBUG

#include "random_triangulations_br3.h"

#include <CGAL/Boundary_recovery_3/Boundary_recovery_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_snapshot_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Vertex_handle                                   Vertex_handle;
typedef K::Point_3                                          Point_3;

// The vertices of all the cells in their order, and the coordinates, by the addresses of the vertices.
struct Mesh_portrait
{
  explicit Mesh_portrait(const Tr& tr)
  {
    for(const auto c : tr.all_cell_handles())
      cells.insert({{ &*c->vertex(0), &*c->vertex(1), &*c->vertex(2), &*c->vertex(3) }});
    for(const Vertex_handle v : tr.finite_vertex_handles())
      points[&*v] = {{ v->point().x(), v->point().y(), v->point().z() }};
  }

  bool operator==(const Mesh_portrait& other) const { return cells == other.cells && points == other.points; }

  std::multiset<std::array<const void*, 4> > cells;
  std::map<const void*, std::array<double, 3> > points;
};

struct Counting_visitor
  : public CGAL::Default_boundary_recovery_visitor_3
{
  template <typename CellRange>
  void before_cells_removal(const CellRange& cells) { removed += cells.size(); }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { created += cells.size(); }

  std::size_t removed = 0, created = 0;
};

void test_snapshot(const br3_test::Lattice_points& points, const int number_of_new_points, std::mt19937& rng)
{
  Tr tr;
  for(const auto& p : points)
    tr.insert(Point_3(static_cast<double>(p.x) / 3, static_cast<double>(p.y) / 3, static_cast<double>(p.z) / 3));
  assert(tr.dimension() == 3);
  const std::size_t number_of_cells = tr.number_of_cells(), number_of_vertices = tr.number_of_vertices();
  const Mesh_portrait before(tr);
  const internal::Mesh_snapshot_3<Tr> snapshot(tr);

  std::size_t number_of_inserted_points = 0;
  for(int i = 0; i < number_of_new_points; ++i)
  {
    const double x = br3_test::random_int(rng, 100), y = br3_test::random_int(rng, 100);
    const std::size_t n = tr.number_of_vertices();
    tr.insert(Point_3(x / 20 - 1, y / 20 - 1, (x + y) / 30 - 1));
    number_of_inserted_points += tr.number_of_vertices() - n;
  }
  int number_of_flips = 0;
  for(int k = 0; k < 50; ++k)
  {
    std::vector<Tr::Facet> facets(tr.finite_facets_begin(), tr.finite_facets_end());
    const Tr::Facet f = facets[static_cast<std::size_t>(br3_test::random_int(rng, static_cast<int>(facets.size())))];
    number_of_flips += tr.flip(f.first, f.second);
  }
  assert((number_of_flips > 0 || number_of_inserted_points > 0) && ! (before == Mesh_portrait(tr)));
  const std::vector<Vertex_handle> new_vertices = snapshot.new_vertices(tr);
  assert(new_vertices.size() == number_of_inserted_points);

  Counting_visitor visitor;
  const std::size_t number_of_changed_cells = tr.number_of_cells();
  snapshot.restore(tr, new_vertices, visitor);
  assert(visitor.removed == number_of_changed_cells && visitor.created == number_of_cells);
  assert(tr.number_of_cells() == number_of_cells && tr.number_of_vertices() == number_of_vertices);
  assert(before == Mesh_portrait(tr));
  assert(tr.is_valid()); // with the neighbors of the cells, and Delaunay again
}

void test_snapshots()
{
  std::mt19937 rng(7);
  for(int i = 0; i < 8; ++i)
  {
    test_snapshot(br3_test::random_points(20, 12, rng), i % 3 == 0 ? 0 : 10, rng);
    test_snapshot(br3_test::grid_points(3, 3, 3, 90, rng), 10, rng);
  }
}

int main()
{
  test_snapshots();
  std::cout << "done" << std::endl;
}
