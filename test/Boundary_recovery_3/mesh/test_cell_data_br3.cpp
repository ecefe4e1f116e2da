// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The visitor that keeps regions and marked facets while cells are replaced: flips and splits at random, and a
// recovery. The region of a cell is compared with that of the place where it is, found by exact numbers in the mesh
// that was there first; marks with a list.

#undef NDEBUG

#include "mesh_portrait_br3.h"

#include <CGAL/Boundary_recovery_3/Mesh_indices_keeper_3.h>
#include <CGAL/Boundary_recovery_3/Shell_3.h>
#include <CGAL/Boundary_recovery_3/Shell_validity_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_index_transfer_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/split_simplex.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Constrained_boundary_recovery_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shell_transformation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_cell_base_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_vertex_base_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;
namespace internal = BR::internal;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<
          CGAL::Tetrahedral_remeshing::Remeshing_vertex_base_3<K>,
          CGAL::Tetrahedral_remeshing::Remeshing_cell_base_3<K> > > Tr;
typedef Tr::Vertex_handle           Vertex_handle;
typedef Tr::Cell_handle             Cell_handle;
typedef Tr::Point                   Point;
typedef std::array<Vertex_handle, 3> Vertex_triple;
typedef std::array<Vertex_handle, 4> Tetrahedron;
typedef BR::Mesh_indices_keeper_3<Tr> Keeper;
typedef internal::Constraints_3<Tr> Constraints;

Exact::Point_3 exact(const Vertex_handle v) { return Exact::Point_3(v->point().x(), v->point().y(), v->point().z()); }

Exact::Point_3 centroid(const Cell_handle c)
{
  return CGAL::centroid(exact(c->vertex(0)), exact(c->vertex(1)), exact(c->vertex(2)), exact(c->vertex(3)));
}

// The regions of a mesh as it was.
class Region_map
{
public:
  explicit Region_map(const Tr& tr)
  {
    for(const Cell_handle c : tr.finite_cell_handles())
      m_cells.push_back({ {{ exact(c->vertex(0)), exact(c->vertex(1)), exact(c->vertex(2)), exact(c->vertex(3)) }},
                          c->subdomain_index() });
  }

  int operator()(const Exact::Point_3& p) const
  {
    for(const Cell& c : m_cells)
      if(has(c, p))
        return c.region;
    assert(false);
    return -1;
  }

private:
  struct Cell
  {
    std::array<Exact::Point_3, 4> points;
    int region;
  };

  static bool has(const Cell& c, const Exact::Point_3& p)
  {
    for(int i = 0; i < 4; ++i)
    {
      std::array<Exact::Point_3, 4> q = c.points;
      q[i] = p;
      if(CGAL::orientation(q[0], q[1], q[2], q[3]) == CGAL::NEGATIVE)
        return false;
    }
    return true;
  }

  std::vector<Cell> m_cells;
};

// The marks, by the vertices of the facets.
class Marks
{
public:
  void set(const Vertex_triple& f, const int mark) { m_marks[key(f)] = mark; }

  int operator()(const Vertex_triple& f) const
  {
    const auto it = m_marks.find(key(f));
    return it == m_marks.end() ? 0 : it->second;
  }

  // Facets that have all of these vertices get parts, each with v in the place of one of them.
  void split(const std::set<Vertex_handle>& vertices, const Vertex_handle v)
  {
    const auto marks = m_marks;
    for(const auto& m : marks)
      if(std::includes(m.first.begin(), m.first.end(), vertices.begin(), vertices.end()))
      {
        m_marks.erase(m.first);
        for(const Vertex_handle w : vertices)
        {
          std::set<Vertex_handle> part = m.first;
          part.erase(w);
          part.insert(v);
          m_marks[part] = m.second;
        }
      }
  }

  bool is_at_edge(const int mark, const Vertex_handle u, const Vertex_handle v) const
  {
    return std::any_of(m_marks.begin(), m_marks.end(), [&](const auto& m)
    {
      return m.second == mark && m.first.count(u) == 1 && m.first.count(v) == 1;
    });
  }

private:
  static std::set<Vertex_handle> key(const Vertex_triple& f) { return std::set<Vertex_handle>(f.begin(), f.end()); }

  std::map<std::set<Vertex_handle>, int> m_marks;
};

void set_mark(Tr& tr, const Cell_handle c, const int i, const int mark)
{
  c->set_surface_patch_index(i, mark);
  c->neighbor(i)->set_surface_patch_index(tr.mirror_index(c, i), mark);
}

void check(const Tr& tr, const Region_map& regions, const Marks& marks)
{
  for(const Cell_handle c : tr.all_cell_handles())
  {
    assert(c->subdomain_index() == (tr.is_infinite(c) ? 0 : regions(centroid(c))));
    for(int i = 0; i < 4; ++i)
      assert(c->surface_patch_index(i) == marks(internal::facet_vertices(c, i)));
  }
}

// Four regions that grew from cells here and there, or three of them and the outside.
void find_regions(Tr& tr, std::mt19937& rng)
{
  std::vector<Cell_handle> queue;
  for(int region = 1; region <= 4; ++region)
  {
    auto c = tr.finite_cells_begin();
    std::advance(c, rng() % tr.number_of_finite_cells());
    c->set_subdomain_index(region % 4);
    queue.push_back(c);
  }
  std::set<Cell_handle> known(queue.begin(), queue.end());
  while(! queue.empty())
  {
    const std::size_t k = rng() % queue.size();
    const Cell_handle c = queue[k];
    queue.erase(queue.begin() + static_cast<long>(k));
    for(int i = 0; i < 4; ++i)
      if(! tr.is_infinite(c->neighbor(i)) && known.insert(c->neighbor(i)).second)
      {
        c->neighbor(i)->set_subdomain_index(c->subdomain_index());
        queue.push_back(c->neighbor(i));
      }
  }
}

class Keeper_test
{
public:
  explicit Keeper_test(const unsigned seed)
    : m_rng(seed), m_keeper(m_tr), m_any_keeper(m_keeper), m_editor(m_tr, m_any_keeper),
      m_transform(m_tr, Quality(m_tr), Validity(m_constraints), m_editor)
  {
    for(int i = 0; i < 30; ++i)
    {
      // multiples of 64, so that points of splits are exact
      const int x = random(16), y = random(16), z = random(16);
      m_tr.insert(Point(64 * x, 64 * y, 64 * z));
    }
    find_regions(m_tr, m_rng);
    for(const Tr::Facet& f : m_tr.finite_facets())
    {
      const int r = f.first->subdomain_index(), s = f.first->neighbor(f.second)->subdomain_index();
      if(r != s || random(10) == 0)
        constrain(f, r == s ? 99 : 10 * (std::min)(r, s) + (std::max)(r, s));
    }
  }

  void run()
  {
    const Region_map regions(m_tr);
    check(m_tr, regions, m_marks);
    for(int k = 0; k < 120; ++k)
    {
      if(k % 12 == 0)
        check(m_tr, regions, m_marks);
      const int operation = random(6);
      if(operation == 0)
        split_edge();
      else if(operation == 1)
        split_facet();
      else
        flip();
    }
    check(m_tr, regions, m_marks);
    assert(m_tr.tds().is_valid() && m_keeper.number_of_ambiguous_cells() == 0);
  }

  int number_of_splits = 0, number_of_merges = 0;

  std::size_t number_of_flips() const { return m_transform.number_of_transformations(); }

private:
  typedef BR::Worst_element_quality_3<Tr> Quality;
  typedef BR::Kept_constraints_3<Constraints> Validity;
  typedef internal::Any_visitor_3<Tr, Keeper&> Any_keeper;
  typedef internal::Mesh_editor_3<Tr> Editor;

  int random(const int n) { return static_cast<int>(m_rng() % static_cast<unsigned>(n)); }

  void constrain(const Tr::Facet& f, const int mark)
  {
    const Vertex_triple v = internal::facet_vertices(f.first, f.second);
    set_mark(m_tr, f.first, f.second, mark);
    m_constraints.insert(v[0], v[1], v[2]);
    m_marks.set(v, mark);
  }

  Cell_handle random_cell()
  {
    auto c = m_tr.finite_cells_begin();
    std::advance(c, random(static_cast<int>(m_tr.number_of_finite_cells())));
    return c;
  }

  void flip()
  {
    const int i = random(4);
    m_transform.remove_edge(Tr::Edge(random_cell(), i, (i + 1 + random(3)) % 4), random(3));
  }

  static Point weighted(const Vertex_handle a, const Vertex_handle b, const Vertex_handle c)
  {
    const Point p = a->point(), q = b->point(), r = c->point();
    return Point(p.x() / 2 + q.x() / 4 + r.x() / 4, p.y() / 2 + q.y() / 4 + r.y() / 4,
                 p.z() / 2 + q.z() / 4 + r.z() / 4);
  }

  void split_edge()
  {
    const Cell_handle c = random_cell();
    const int i = random(4), j = (i + 1 + random(3)) % 4;
    const Vertex_handle a = c->vertex(i), b = c->vertex(j);
    const BR::Shell_3<Tr> shell(m_tr, c, i, j);
    const auto cells = shell.cells();
    std::vector<Tetrahedron> old, tetrahedra;
    const Vertex_handle v = m_editor.create_vertex(CGAL::midpoint(a->point(), b->point()));
    for(const Cell_handle cell : cells)
    {
      old.push_back({{ cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3) }});
      tetrahedra.push_back(internal::with_exchanged_vertex(cell, a, v));
      tetrahedra.push_back(internal::with_exchanged_vertex(cell, b, v));
    }
    m_editor.replace(cells, tetrahedra);
    ++number_of_splits;
    if(random(2) == 0 && ! m_marks.is_at_edge(99, a, b))
      return merge(old, v);
    if(m_constraints.is_constrained(a, b))
      m_constraints.split(a, b, v);
    m_marks.split({ a, b }, v);
  }

  // Facets between regions come back, with their marks.
  void merge(const std::vector<Tetrahedron>& old, const Vertex_handle v)
  {
    const std::vector<Cell_handle> cells(m_editor.new_cells().begin(), m_editor.new_cells().end());
    m_editor.replace(cells, old, std::array<Vertex_handle, 1>{{ v }});
    ++number_of_merges;
  }

  void split_facet()
  {
    const Cell_handle c = random_cell();
    const int i = random(4);
    const Vertex_triple f = internal::facet_vertices(c, i);
    const Vertex_handle v = m_editor.create_vertex(weighted(f[0], f[1], f[2]));
    internal::split_facet(m_editor, m_constraints, c, f, v);
    ++number_of_splits;
    m_marks.split({ f[0], f[1], f[2] }, v);
  }

  std::mt19937 m_rng;
  Tr m_tr;
  Keeper m_keeper;
  Any_keeper m_any_keeper; // hands on everything to `m_keeper`
  Editor m_editor;
  Constraints m_constraints;
  Marks m_marks;
  CGAL::Shell_transformation_3<Tr, Quality, Validity, Editor> m_transform;
};

void test_keeper()
{
  int number_of_splits = 0, number_of_merges = 0;
  std::size_t number_of_flips = 0;
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    Keeper_test test(seed);
    test.run();
    number_of_splits += test.number_of_splits;
    number_of_merges += test.number_of_merges;
    number_of_flips += test.number_of_flips();
  }
  std::cout << number_of_splits << " splits, " << number_of_merges << " merges, " << number_of_flips << " flips"
            << std::endl;
  assert(number_of_splits > 200 && number_of_merges > 30 && number_of_flips > 100);
}

// Facets between regions are destroyed: every cell gets one of the regions, always the same, and some are counted.
std::vector<int> regions_after_careless_flips()
{
  std::mt19937 rng(5);
  Tr tr;
  br3_test::insert_random_points(tr, 60, rng);
  find_regions(tr, rng);
  Keeper keeper(tr);
  CGAL::Shell_transformation_3<Tr, BR::Worst_element_quality_3<Tr>, BR::No_shell_validity_3, Keeper>
    transform(tr, BR::Worst_element_quality_3<Tr>(tr), BR::No_shell_validity_3(), keeper);
  for(int k = 0; k < 200; ++k)
  {
    auto c = tr.finite_cells_begin();
    std::advance(c, rng() % tr.number_of_finite_cells());
    transform.remove_edge(Tr::Edge(c, static_cast<int>(rng() % 2), 2 + static_cast<int>(rng() % 2)), 1);
  }
  std::vector<int> result;
  for(const Cell_handle c : tr.all_cell_handles())
  {
    assert(c->subdomain_index() >= 0 && c->subdomain_index() < 4 && (! tr.is_infinite(c) || c->subdomain_index() == 0));
    result.push_back(c->subdomain_index());
  }
  assert(keeper.number_of_ambiguous_cells() > 0);
  return result;
}

// The triangles of a polyhedron that no tetrahedra fill without Steiner points, in a box around it that is recovered
// first, and divides the space.
void test_recovery(std::mt19937& rng)
{
  Tr tr;
  std::vector<Vertex_handle> box, prism;
  for(int i = 0; i < 8; ++i)
    box.push_back(tr.insert(Point(i % 2 == 0 ? -2 : 2, i / 2 % 2 == 0 ? -2 : 2, i / 4 == 0 ? -1 : 2)));
  for(const std::array<double, 3>& p : std::vector<std::array<double, 3> >{
        {{ 1, 0, 0 }}, {{ -0.5, 0.866, 0 }}, {{ -0.5, -0.866, 0 }}, {{ 0.866, 0.5, 1 }}, {{ -0.866, 0.5, 1 }},
        {{ 0, -1, 1 }} })
    prism.push_back(tr.insert(Point(p[0], p[1], p[2])));
  for(int i = 0; i < 40; ++i)
  {
    const int x = static_cast<int>(rng() % 17), y = static_cast<int>(rng() % 17), z = static_cast<int>(rng() % 17);
    tr.insert(Point(x / 2. - 4.125, y / 2. - 4.125, z % 8 < 4 ? 2.25 + z / 16. : -1.25 - z / 16.));
  }
  Keeper keeper(tr);
  CGAL::Constrained_boundary_recovery_3<Tr, Keeper> recover(tr, keeper);
  for(const std::array<int, 4>& f : std::vector<std::array<int, 4> >{
        {{ 0, 1, 3, 2 }}, {{ 4, 5, 7, 6 }}, {{ 0, 1, 5, 4 }}, {{ 2, 3, 7, 6 }}, {{ 0, 2, 6, 4 }}, {{ 1, 3, 7, 5 }} })
  {
    recover.insert_constraint(box[f[0]], box[f[1]], box[f[2]]);
    recover.insert_constraint(box[f[0]], box[f[2]], box[f[3]]);
  }
  assert(recover() && recover.steiner_vertices().empty());
  for(const Cell_handle c : tr.finite_cell_handles())
  {
    const Exact::Point_3 p = centroid(c);
    const bool is_inside = CGAL::abs(p.x()) < 2 && CGAL::abs(p.y()) < 2 && -1 < p.z() && p.z() < 2;
    c->set_subdomain_index(is_inside ? 1 : 2);
  }
  Marks marks;
  for(const auto& f : recover.constrained_facets())
  {
    Cell_handle c;
    int i, j, k;
    assert(tr.is_facet(f[0], f[1], f[2], c, i, j, k));
    set_mark(tr, c, 6 - i - j - k, 7);
    marks.set(f, 7);
  }
  const Region_map regions(tr);
  check(tr, regions, marks);
  for(const std::array<int, 3>& f : std::vector<std::array<int, 3> >{ {{ 0, 2, 1 }}, {{ 3, 4, 5 }}, {{ 0, 1, 4 }},
        {{ 0, 4, 3 }}, {{ 1, 2, 5 }}, {{ 1, 5, 4 }}, {{ 2, 0, 3 }}, {{ 2, 3, 5 }} })
    recover.insert_constraint(prism[f[0]], prism[f[1]], prism[f[2]]);
  assert(recover() && ! recover.steiner_vertices().empty());
  check(tr, regions, marks);
  assert(keeper.number_of_ambiguous_cells() == 0);
}

int main()
{
  test_keeper();
  assert(regions_after_careless_flips() == regions_after_careless_flips());
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    std::mt19937 rng(seed);
    test_recovery(rng);
  }
  return EXIT_SUCCESS;
}
