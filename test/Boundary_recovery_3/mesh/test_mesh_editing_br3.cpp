// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Replacement of cells, few and many, and the journal that takes changes of a mesh back: after random operations, in
// nested transactions, with visitors that throw, and when memory is lacking.

#undef NDEBUG

#include "mesh_portrait_br3.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_change_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/mesh_indices.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
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
#include <new>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Memory is lacking after so many allocations; never, if negative.
long number_of_allocations = -1;

// (Inlined, GCC would take malloc() and free() for a mismatch.)
[[gnu::noinline]] void* operator new(const std::size_t size)
{
  if(number_of_allocations == 0)
    throw std::bad_alloc();
  if(number_of_allocations > 0)
    --number_of_allocations;
  if(void* const p = std::malloc(size))
    return p;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* const p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* const p, std::size_t) noexcept { std::free(p); }

namespace BR = CGAL::Boundary_recovery_3;
namespace internal = BR::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K> Plain_tr;
typedef CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<
          CGAL::Tetrahedral_remeshing::Remeshing_vertex_base_3<K>,
          CGAL::Tetrahedral_remeshing::Remeshing_cell_base_3<K> > > Marked_tr;

void mark_at_random(Plain_tr&, std::mt19937&) { }

void mark_at_random(Marked_tr& tr, std::mt19937& rng)
{
  for(const auto c : tr.all_cell_handles())
  {
    c->set_subdomain_index(static_cast<int>(rng() % 5));
    for(int i = 0; i < 4; ++i)
      c->set_surface_patch_index(i, static_cast<int>(rng() % 5));
  }
  for(const auto v : tr.finite_vertex_handles())
  {
    v->set_dimension(static_cast<int>(rng() % 4));
    v->set_index(static_cast<int>(rng() % 5));
  }
}

// A connected set of n finite cells, if there are so many.
template <typename Tr>
std::vector<typename Tr::Cell_handle> random_cells(const Tr& tr, const std::size_t n, std::mt19937& rng)
{
  auto seed = tr.finite_cells_begin();
  std::advance(seed, rng() % tr.number_of_finite_cells());
  std::vector<typename Tr::Cell_handle> cells(1, seed);
  std::set<const void*> known = { &*cells[0] };
  for(std::size_t k = 0; k < cells.size() && cells.size() < n; ++k)
    for(int i = 0; i < 4 && cells.size() < n; ++i)
    {
      const auto c = cells[k]->neighbor(i);
      if(! tr.is_infinite(c) && known.insert(&*c).second)
        cells.push_back(c);
    }
  return cells;
}

// Four tetrahedra for each cell, around a new vertex in it.
template <typename Tr, typename Create_vertex>
std::vector<std::array<typename Tr::Vertex_handle, 4> >
split_cells(const std::vector<typename Tr::Cell_handle>& cells, const Create_vertex& create_vertex)
{
  std::vector<std::array<typename Tr::Vertex_handle, 4> > tetrahedra;
  for(const auto c : cells)
  {
    const auto v = create_vertex(CGAL::centroid(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                                                c->vertex(3)->point()));
    for(int i = 0; i < 4; ++i)
      tetrahedra.push_back(internal::with_exchanged_vertex(c, c->vertex(i), v));
  }
  return tetrahedra;
}

template <typename Cells, typename Tetrahedra>
bool have_vertices(const Cells& cells, const Tetrahedra& tetrahedra)
{
  bool result = cells.size() == tetrahedra.size();
  for(std::size_t k = 0; result && k < cells.size(); ++k)
    for(int i = 0; i < 4; ++i)
      result = result && cells[k]->vertex(i) == tetrahedra[k][i];
  return result;
}

// n cells become 4n, and these n again. Nothing happens as long as memory is lacking.
void test_replacement(const std::size_t n, std::mt19937& rng)
{
  typedef Plain_tr Tr;
  Tr tr;
  br3_test::insert_random_points(tr, n > 100 ? 500 : 50, rng);
  const br3_test::Vertex_names<Tr> names(tr);
  const br3_test::Mesh_portrait<Tr> before(tr, names);
  std::vector<Tr::Cell_handle> cells = random_cells(tr, n, rng);
  assert(cells.size() == n);
  std::vector<std::array<Tr::Vertex_handle, 4> > old;
  for(const auto c : cells)
    old.push_back({{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }});
  std::vector<Tr::Vertex_handle> vertices;
  const auto tetrahedra = split_cells<Tr>(cells, [&](const Tr::Point& p)
  {
    vertices.push_back(tr.tds().create_vertex());
    vertices.back()->set_point(p);
    return vertices.back();
  });
  internal::Replace_cells<Tr> replace;
  bool is_done = false;
  long failures = 0;
  const std::size_t number_of_cells = tr.tds().number_of_cells();
  for(; ! is_done; ++failures)
    try {
      number_of_allocations = failures;
      replace(tr, cells, tetrahedra);
      number_of_allocations = -1;
      is_done = true;
    } catch(const std::bad_alloc&) {
      number_of_allocations = -1;
      assert(tr.tds().number_of_cells() == number_of_cells && br3_test::are_neighbors_right(tr));
    }
  assert(n < 32 || failures > 1);
  assert(have_vertices(replace.new_cells(), tetrahedra) && tr.tds().is_valid() && br3_test::are_neighbors_right(tr));
  for(const auto c : replace.new_cells())
    assert(CGAL::orientation(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                             c->vertex(3)->point()) == CGAL::POSITIVE);
  CGAL::Default_meshing_visitor_3 visitor;
  cells.assign(replace.new_cells().begin(), replace.new_cells().end());
  replace(tr, cells, old, visitor, vertices);
  assert(have_vertices(replace.new_cells(), old) && before == br3_test::Mesh_portrait<Tr>(tr, names));
}

struct Refusal { };

// Throws at the given announcement, the first one being that of a removal of cells.
template <typename Tr>
struct Refusing_visitor
  : public internal::Mesh_visitor_3<Tr>
{
  typedef typename internal::Mesh_visitor_3<Tr>::Cells Cells;

  void before_cells_removal(const Cells&) override { count(); }
  void after_cells_creation(const Cells&) override { count(); }

  void count()
  {
    if(countdown-- == 0)
      throw Refusal();
  }

  long countdown = -1;
};

// Random operations in nested transactions, each compared with what there was when it began.
template <typename Tr>
class Journal_test
{
public:
  typedef typename Tr::Vertex_handle  Vertex_handle;
  typedef typename Tr::Cell_handle    Cell_handle;
  typedef typename Tr::Point          Point;
  typedef internal::Mesh_editor_3<Tr> Editor;

  Journal_test(const int number_of_points, const unsigned seed)
    : m_rng(seed), m_editor(m_tr, m_visitor), m_transform(m_tr, Quality(m_tr), BR::No_shell_validity_3(), m_editor)
  {
    br3_test::insert_random_points(m_tr, number_of_points, m_rng);
    mark_at_random(m_tr, m_rng);
  }

  void run(const int depth, const int number_of_operations)
  {
    br3_test::Vertex_names<Tr> names(m_tr);
    const br3_test::Mesh_portrait<Tr> before(m_tr, names);
    const bool is_refused = depth == 0 && random(2) == 0;
    bool is_done = false;
    m_editor.begin();
    try {
      m_visitor.countdown = is_refused ? random(40) : -1;
      m_number_of_allocations = depth == 0 && random(2) == 0 ? random(20) : -1;
      for(int k = 0; k < number_of_operations; ++k)
        operate(depth);
      is_done = true;
    } catch(const Refusal&) {
      ++number_of_refusals;
    } catch(const std::bad_alloc&) {
      ++number_of_failures;
    }
    m_number_of_allocations = -1;
    m_visitor.countdown = -1;
    if(is_done && depth > 0 && random(3) == 0)
      m_editor.commit();
    else
      undo(before, names);
    assert(depth > 0 || m_tr.tds().is_valid()); // not if vertices without cells are about
  }

  void check_end() const { assert(! m_editor.journal().is_active()); }

  int number_of_refusals = 0, number_of_failures = 0, number_of_late_failures = 0, number_of_removed_old_vertices = 0;

private:
  typedef BR::Worst_element_quality_3<Tr> Quality;

  int random(const int n) { return static_cast<int>(m_rng() % static_cast<unsigned>(n)); }

  // Memory is lacking at first, or the visitor does not want to.
  void undo(const br3_test::Mesh_portrait<Tr>& before, br3_test::Vertex_names<Tr>& names)
  {
    const std::size_t depth = m_editor.journal().depth();
    const br3_test::Vertex_names<Tr> names_now(m_tr);
    const br3_test::Mesh_portrait<Tr> changed(m_tr, names_now);
    for(long failures = 0; m_editor.journal().depth() == depth; failures += 1 + failures / 2)
      try {
        number_of_allocations = failures;
        const auto renamed = m_editor.undo();
        number_of_allocations = -1;
        names.rename(renamed);
        number_of_removed_old_vertices += static_cast<int>(renamed.size());
      } catch(const std::bad_alloc&) {
        number_of_allocations = -1;
        if(m_editor.journal().depth() == depth)
          assert(changed == br3_test::Mesh_portrait<Tr>(m_tr, names_now));
        ++number_of_late_failures;
      }
    assert(before == br3_test::Mesh_portrait<Tr>(m_tr, names));
  }

  void operate(const int depth)
  {
    switch(random(depth < 2 ? 8 : 7))
    {
      case 0: case 1: case 2: return flip();
      case 3: return split();
      case 4: return remove_vertex();
      case 5: return move_vertex();
      case 6: return create_and_forget_vertex();
      default: run(depth + 1, random(6));
    }
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
    m_transform.remove_edge(typename Tr::Edge(random_cell(), i, (i + 1 + random(3)) % 4), random(3));
  }

  // Memory may be lacking in the editor, but not in what CGAL does with its marks of cells.
  template <typename Work>
  void with_little_memory(const Work& work)
  {
    struct Little_memory
    {
      explicit Little_memory(long& n) : n(n) { std::swap(n, number_of_allocations); }
      ~Little_memory() { std::swap(n, number_of_allocations); }
      long& n;
    } little_memory(m_number_of_allocations);
    work();
  }

  // One cell, or many.
  void split()
  {
    const auto cells = random_cells(m_tr, random(6) == 0 ? 80 : 1, m_rng);
    with_little_memory([&]
    {
      m_editor.replace(cells, split_cells<Tr>(cells, [&](const Point& p) { return m_editor.create_vertex(p); }));
    });
  }

  // Inner vertices whose star can be covered from another vertex, be they old or new.
  void remove_vertex()
  {
    const Vertex_handle v = random_cell()->vertex(random(4));
    std::vector<Cell_handle> star;
    m_tr.incident_cells(v, std::back_inserter(star));
    for(const Cell_handle c : star)
      if(m_tr.is_infinite(c))
        return;
    for(const Vertex_handle u : internal::vertices_without(star, v))
    {
      std::vector<std::array<Vertex_handle, 4> > tetrahedra;
      for(const auto& f : internal::faces_of_star(star, v))
        if(f[0] != u && f[1] != u && f[2] != u)
          tetrahedra.push_back({{ f[0], f[1], f[2], u }});
      if(std::all_of(tetrahedra.begin(), tetrahedra.end(), [](const auto& t)
         {
           return CGAL::orientation(t[0]->point(), t[1]->point(), t[2]->point(), t[3]->point()) == CGAL::POSITIVE;
         }))
      {
        with_little_memory([&] { m_editor.replace(star, tetrahedra, std::array<Vertex_handle, 1>{{ v }}); });
        return;
      }
    }
  }

  // A little, and back if cells are inverted so, or the hull might not be convex.
  void move_vertex()
  {
    const Vertex_handle v = random_cell()->vertex(random(4));
    const Point p = v->point();
    m_editor.move(v, Point(p.x() + random(8) / 64., p.y() + random(8) / 64., p.z() + random(8) / 64.));
    for(int k = random(2); k >= 0; --k)
    {
      std::vector<Cell_handle> star;
      m_tr.incident_cells(v, std::back_inserter(star));
      for(const Cell_handle c : star)
        if(m_tr.is_infinite(c)
           || CGAL::orientation(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                                c->vertex(3)->point()) != CGAL::POSITIVE)
          return m_editor.move(v, p);
    }
  }

  void create_and_forget_vertex()
  {
    const Vertex_handle v = m_editor.create_vertex(Point(0, 0, 1));
    if(random(2) == 0)
      m_editor.delete_vertex(v);
  }

  long m_number_of_allocations = -1;
  std::mt19937 m_rng;
  Tr m_tr;
  Refusing_visitor<Tr> m_visitor;
  Editor m_editor;
  CGAL::Shell_transformation_3<Tr, Quality, BR::No_shell_validity_3, Editor> m_transform;
};

template <typename Tr>
void test_journal()
{
  int number_of_refusals = 0, number_of_failures = 0, number_of_late_failures = 0, number_of_renamed = 0;
  for(unsigned seed = 0; seed < 8; ++seed)
  {
    Journal_test<Tr> test(seed % 4 == 0 ? 150 : 30, seed);
    for(int k = 0; k < 12; ++k)
      test.run(0, k % 4 == 3 ? 60 : 12);
    test.check_end();
    number_of_refusals += test.number_of_refusals;
    number_of_failures += test.number_of_failures;
    number_of_late_failures += test.number_of_late_failures;
    number_of_renamed += test.number_of_removed_old_vertices;
  }
  std::cout << number_of_refusals << " refusals, " << number_of_failures << " failures, " << number_of_late_failures
            << " late failures, " << number_of_renamed << " renamed vertices" << std::endl;
  assert(number_of_refusals > 5 && number_of_failures > 5 && number_of_late_failures > 100 && number_of_renamed > 5);
}

// All cells inverted: it is the combinatorics that count. And a transaction without changes is not announced.
void test_inverted_mesh()
{
  typedef Plain_tr Tr;
  std::mt19937 rng(1);
  Tr tr;
  br3_test::insert_random_points(tr, 100, rng);
  br3_test::Vertex_names<Tr> names(tr);
  const br3_test::Mesh_portrait<Tr> before(tr, names);
  Refusing_visitor<Tr> visitor;
  internal::Mesh_editor_3<Tr> editor(tr, visitor);
  editor.begin();
  const auto cells = random_cells(tr, 100, rng);
  editor.replace(cells, split_cells<Tr>(cells, [&](const Tr::Point& p) { return editor.create_vertex(p); }));
  for(const auto v : tr.finite_vertex_handles())
    editor.move(v, Tr::Point(- v->point().x(), v->point().y(), v->point().z()));
  assert(editor.undo().empty() && before == br3_test::Mesh_portrait<Tr>(tr, names));

  editor.begin();
  visitor.countdown = 0;
  for(const auto v : tr.finite_vertex_handles())
    editor.move(v, Tr::Point(0, 0, 0));
  assert(editor.undo().empty() && before == br3_test::Mesh_portrait<Tr>(tr, names));
}

int main()
{
  std::mt19937 rng(0);
  for(const std::size_t n : { 1, 2, 16, 17, 64, 65, 2000 })
    test_replacement(n, rng);
  test_journal<Plain_tr>();
  test_journal<Marked_tr>();
  test_inverted_mesh();
  return EXIT_SUCCESS;
}
