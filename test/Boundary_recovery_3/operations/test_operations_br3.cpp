// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Local operations, and what is asked before them, against definitions: in meshes of points in general position and of
// degenerate ones, with and without exact positions, each alone and many in transactions that are taken back.

#undef NDEBUG

#include "changing_mesh_br3.h"
#include "expected_change_br3.h"
#include "random_operations_br3.h"
#include "random_places_br3.h"

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Remove_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
using br3_test::number_of;
using br3_test::random_int;
using br3_test::random_item;

typedef CGAL::Exact_predicates_inexact_constructions_kernel  K;
typedef CGAL::Exact_predicates_exact_constructions_kernel    EK;
typedef internal::Star_obstacle                              Star_obstacle;

// --- what is only asked ----------------------------------------------------------------------------------------------

template <typename Mesh>
class Random_question
  : private br3_test::Random_places<Mesh>
{
  typedef br3_test::Random_places<Mesh>  Places;

public:
  Random_question(Mesh& mesh, std::mt19937& rng) : Places(mesh, rng) { }

  void operator()()
  {
    query_constraints();
    grow();
    shrink();
  }

private:
  typedef typename Places::Tr             Tr;
  typedef typename Places::Vertex_handle  Vertex_handle;
  typedef typename Places::Cell_handle    Cell_handle;
  typedef typename Places::Simplex        Simplex;
  typedef typename Places::Vertices       Vertices;
  typedef typename Places::Cells          Cells;
  typedef typename Mesh::Constraints      Constraints;
  typedef std::array<Vertex_handle, 2>    Vertex_pair;
  typedef std::array<Vertex_handle, 3>    Vertex_triple;

  using Places::m;
  using Places::rng;
  using Places::is_any_constraint_at;
  using Places::random_cells;
  using Places::random_vertex;
  using Places::without;

  // As far as cells are wanted that are chosen at random, but never through a constrained facet.
  void grow()
  {
    std::set<Cell_handle> wanted;
    for(const Cell_handle c : br3_test::finite_cells(m.tr))
      if(random_int(rng, 4) > 0)
        wanted.insert(c);
    const Cells seeds = random_cells(2);
    std::set<Cell_handle> expected(seeds.begin(), seeds.end());
    Cells open = seeds;
    bool is_constraint_met = false;
    while(! open.empty())
    {
      const Cell_handle c = open.back();
      open.pop_back();
      for(int i = 0; i < 4; ++i)
      {
        const bool is_closed = m.constraints.simplices.count(without(Mesh::vertices_of(c), c->vertex(i))) == 1;
        is_constraint_met |= is_closed;
        if(! is_closed && wanted.count(c->neighbor(i)) == 1 && expected.insert(c->neighbor(i)).second)
          open.push_back(c->neighbor(i));
      }
    }
    this->for_each_kind_of_constraints([&](const auto& constraints)
    {
      internal::Cavity_3<Tr, std::decay_t<decltype(constraints)> > cavity(m.tr, constraints, seeds);
      internal::grow_where(cavity, [&](const Cell_handle c)
      {
        assert(! m.tr.is_infinite(c));
        return wanted.count(c) == 1;
      });
      assert(cavity.cells().size() == expected.size());
      assert(std::set<Cell_handle>(cavity.cells().begin(), cavity.cells().end()) == expected);
      assert(std::equal(seeds.begin(), seeds.end(), cavity.cells().begin()));
    });
    ++number_of[is_constraint_met ? "cavity grown as far as constraints" : "cavity grown"];
  }

  // The greatest subset of the cells all of whose outer faces v sees: all subsets are looked at.
  void shrink()
  {
    const Cells cells = random_cells(3 + random_int(rng, 8));
    Vertices near;
    for(const Vertex_handle w : Mesh::tetrahedron(cells.front()))
      near.push_back(w);
    const Vertex_handle v = random_int(rng, 4) == 0 ? random_vertex() : m.create_vertex(near, rng);
    if(v == Vertex_handle())
      return;
    const std::vector<char> is_subset_seen = seen_subsets(cells, v);
    std::size_t greatest = 0;
    for(std::size_t subset = 0; subset < is_subset_seen.size(); ++subset)
      if(is_subset_seen[subset])
        greatest |= subset;
    assert(is_subset_seen[greatest]); // it is one, for the union of two is another one
    const std::size_t number_of_seeds = static_cast<std::size_t>(random_int(rng, 3));
    const std::size_t seeds = (std::size_t(1) << number_of_seeds) - 1;
    Cells expected, shuffled(cells.begin() + static_cast<std::ptrdiff_t>(number_of_seeds), cells.end());
    for(std::size_t k = shuffled.size(); k > 1; --k)
      std::swap(shuffled[k - 1], shuffled[static_cast<std::size_t>(random_int(rng, static_cast<int>(k)))]);
    shuffled.insert(shuffled.begin(), cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(number_of_seeds));
    for(const Cell_handle c : shuffled)
      if((greatest >> (std::find(cells.begin(), cells.end(), c) - cells.begin()) & 1) != 0)
        expected.push_back(c);

    internal::Cavity_3<Tr, Constraints> cavity(m.tr, m.constraints, shuffled);
    const bool is_seen = internal::shrink_until_seen(cavity, v, m.predicates, number_of_seeds);
    assert(is_seen == ((greatest & seeds) == seeds));
    assert(! is_seen || cavity.cells() == expected);
    ++number_of[! is_seen ? "cavity not shrunk" : expected.empty() ? "cavity shrunk to nothing"
                          : expected == shuffled ? "cavity seen" : "cavity shrunk"];
    if(m.cells_with({ v }).empty())
      m.delete_vertex(v);
  }

  // By the bits of their cells.
  std::vector<char> seen_subsets(const Cells& cells, const Vertex_handle v) const
  {
    std::vector<std::vector<std::size_t> > behind_hidden_faces(cells.size()); // as bits; zero if it is none of them
    for(std::size_t k = 0; k < cells.size(); ++k)
      for(int i = 0; i < 4; ++i)
        if(! m.are_positive({ Mesh::with_exchanged(cells[k], cells[k]->vertex(i), v) }))
        {
          const auto n = std::find(cells.begin(), cells.end(), cells[k]->neighbor(i));
          behind_hidden_faces[k].push_back(n == cells.end() ? 0 : std::size_t(1) << (n - cells.begin()));
        }
    std::vector<char> result(std::size_t(1) << cells.size(), true);
    for(std::size_t subset = 0; subset < result.size(); ++subset)
      for(std::size_t k = 0; k < cells.size(); ++k)
        if((subset >> k & 1) != 0)
          for(const std::size_t behind : behind_hidden_faces[k])
            result[subset] = result[subset] && (subset & behind) != 0;
    return result;
  }

  // Of all constraints, and of a set that has the facets without their edges.
  void query_constraints()
  {
    const Vertex_handle v = random_vertex();
    this->for_each_kind_of_constraints([&](const auto& set) { check_queries(set, m.constraints, v); });
    ++number_of[is_any_constraint_at(v) ? "constraint at a vertex" : "no constraint at a vertex"];
    Constraints facets;
    for(const Simplex& s : m.constraints.simplices)
      if(s.size() == 3)
        facets.simplices.insert(s);
    check_queries(facets, facets, v);
  }

  // `constraints` are those that are in the set, whatever that is.
  template <typename Set>
  void check_queries(const Set& set, const Constraints& constraints, const Vertex_handle v) const
  {
    const Cells cells = m.cells_with({ v });
    std::set<Simplex> expected, found;
    for(const Simplex& s : constraints.simplices)
      for(const Cell_handle c : cells)
        if(Mesh::is_face(s, Mesh::vertices_of(c)))
          expected.insert(s);
    std::vector<Vertex_pair> edges;
    std::vector<Vertex_triple> facets;
    internal::collect_constraints(set, cells, edges, facets);
    for(const Vertex_pair& e : edges)
      found.insert(Simplex(e.begin(), e.end()));
    for(const Vertex_triple& f : facets)
      found.insert(Simplex(f.begin(), f.end()));
    assert(found == expected);
  }
};

// --- transactions ----------------------------------------------------------------------------------------------------

// What a transaction that is taken back brings back, and what the caller has to.
template <typename Mesh>
struct State
{
  typedef typename Mesh::Vertex_handle  Vertex_handle;

  explicit State(const Mesh& mesh) : constraints(mesh.constraints)
  {
    for(const auto c : mesh.tr.all_cell_handles())
      cells.insert(Mesh::tetrahedron(c));
    for(auto v = mesh.tr.tds().vertices().begin(); v != mesh.tr.tds().vertices().end(); ++v)
      if(v != mesh.tr.infinite_vertex())
      {
        points.emplace(v, v->point());
        if(mesh.positions.contains(v))
          positions.emplace(v, mesh.exact_point(v));
      }
  }

  // Pairs of an old and a new handle.
  template <typename Vertex_pairs>
  void rename(const Vertex_pairs& pairs)
  {
    std::map<Vertex_handle, Vertex_handle> names;
    for(const auto& p : pairs)
      assert(names.emplace(p[0], p[1]).second);
    const auto name = [&](const Vertex_handle v) { return names.count(v) == 1 ? names.at(v) : v; };
    State old = *this;
    cells.clear();
    for(typename Mesh::Tetrahedron t : old.cells)
    {
      std::transform(t.begin(), t.end(), t.begin(), name);
      cells.insert(t);
    }
    constraints.simplices.clear();
    for(const auto& s : old.constraints.simplices)
    {
      typename Mesh::Simplex renamed;
      for(const Vertex_handle v : s)
        renamed.insert(name(v));
      constraints.simplices.insert(renamed);
    }
    points.clear();
    for(const auto& p : old.points)
      assert(points.emplace(name(p.first), p.second).second);
    positions.clear();
    for(const auto& p : old.positions)
      assert(positions.emplace(name(p.first), p.second).second);
  }

  std::multiset<typename Mesh::Tetrahedron> cells; // the order of their vertices counts
  std::map<Vertex_handle, typename Mesh::Point> points;
  std::map<Vertex_handle, typename Mesh::Exact_point> positions;
  typename Mesh::Constraints constraints;
};

// Random changes in nested transactions; the visitor throws now and then.
template <typename Mesh>
class Random_transaction
{
public:
  Random_transaction(Mesh& mesh, br3_test::Random_operation<Mesh>& operation, std::mt19937& rng)
    : m(mesh), m_operation(operation), rng(rng)
  { }

  void operator()(const std::size_t depth = 1)
  {
    State<Mesh> before(m);
    m.editor.begin();
    assert(m.editor.journal().depth() == depth);
    const bool is_complete = make_operations(depth);
    number_of["transaction interrupted"] += ! is_complete;
    if(depth > 1 && is_complete && random_int(rng, 2) == 0)
    {
      m.editor.commit();
      ++number_of["transaction committed"];
    }
    else
      undo(before);
    assert(m.editor.journal().depth() == depth - 1);
  }

private:
  bool make_operations(const std::size_t depth)
  {
    try {
      for(int k = 0; k < 8; ++k)
      {
        if(depth < 3 && random_int(rng, 4) == 0)
          (*this)(depth + 1);
        m.recorder.number_of_calls_left = random_int(rng, 15) == 0 ? 1 + random_int(rng, 2) : 0;
        m_operation();
        m.recorder.number_of_calls_left = 0;
      }
    } catch(const br3_test::Interruption&) {
      return false;
    }
    return true;
  }

  void undo(State<Mesh>& before)
  {
    for(auto v = m.tr.tds().vertices().begin(); v != m.tr.tds().vertices().end(); ++v)
      m.positions.erase(v);
    br3_test::Change_recorder other;
    typename Mesh::Any_recorder any_other(other);
    const auto renamed = random_int(rng, 2) == 0 ? m.editor.undo() : m.editor.undo(any_other);
    before.rename(renamed);
    const State<Mesh> now(m);
    assert(now.cells == before.cells && now.points == before.points);
    m.constraints = before.constraints;
    for(const auto& p : before.positions)
      assert(m.place(p.first, p.second));
    assert(internal::is_mesh_valid(m.tr, m.predicates) && m.are_all_constraints_there());
    ++number_of["transaction taken back"];
    number_of["vertex renamed"] += ! renamed.empty();
    m_operation.forget();
  }

  Mesh& m;
  br3_test::Random_operation<Mesh>& m_operation;
  std::mt19937& rng;
};

// --- all of it in random meshes --------------------------------------------------------------------------------------

br3_test::Lattice_points points(const int kind, std::mt19937& rng)
{
  switch(kind)
  {
    case 0: return br3_test::random_points(25, 64, rng);
    case 1: return br3_test::grid_points(4, 3, 3, 80, rng);
    case 2: return br3_test::ring_points(12, false, false, rng);
    case 3: return br3_test::ring_points(12, true, true, rng); // cocircular, and coplanar
    default: return br3_test::grid_points(5, 4, 2, 100, rng);  // on the hull, all of them
  }
}

template <typename Mesh>
void test_random_operations(const unsigned seed, const int number_of_meshes)
{
  std::mt19937 rng(seed);
  for(int round = 0; round < number_of_meshes; ++round)
  {
    Mesh mesh(points(round % 5, rng), round % 3 == 0 ? 30 : 0, rng);
    if(round % 4 > 0)
      mesh.insert_random_constraints(round % 4 == 1 ? 60 : 20, rng);
    br3_test::Random_operation<Mesh> operation(mesh, rng);
    Random_transaction<Mesh> transaction(mesh, operation, rng);
    Random_question<Mesh> question(mesh, rng);
    for(int k = 0; k < 30; ++k)
    {
      operation();
      if(k % 3 == 0)
      {
        question();
        operation.forget(); // a vertex came and went
      }
      if(k % 10 == 9)
        transaction();
    }
  }
}

// --- insertion as in Delaunay triangulations -------------------------------------------------------------------------

template <typename Tr>
std::multiset<std::multiset<int> > indices_of_cells(const Tr& tr)
{
  std::multiset<std::multiset<int> > result;
  for(const auto c : tr.all_cell_handles())
    result.insert({ c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info() });
  return result;
}

// The cells whose spheres contain a new point, starred from it, are what the triangulation makes by itself.
template <typename Kernel>
void test_delaunay_insertion(const unsigned seed, const int number_of_meshes)
{
  typedef br3_test::Changing_mesh<Kernel, false>  Mesh;
  typedef typename Mesh::Vertex_handle            Vertex_handle;
  typedef typename Mesh::Cell_handle              Cell_handle;
  typedef internal::Cavity_3<typename Mesh::Tr, typename Mesh::Constraints>  Cavity;
  std::mt19937 rng(seed);
  for(int round = 0; round < number_of_meshes; ++round)
  {
    Mesh m(points(round % 4, rng), 0, rng);
    for(int k = 0; k < 10; ++k)
    {
      const Cell_handle c = random_item(br3_test::finite_cells(m.tr), rng);
      const int dimension = 1 + random_int(rng, 3);
      typename Mesh::Vertices support;
      for(int i = 0; i <= dimension; ++i)
        support.push_back(c->vertex(i));
      const typename Mesh::Cells cells = m.cells_with(typename Mesh::Simplex(support.begin(), support.end()));
      if(m.is_any_infinite(cells))
        continue;
      typename Mesh::Tr copy(m.tr);
      const Vertex_handle v = m.create_vertex(support, rng);
      if(v == Vertex_handle())
        continue;
      v->info() = 1000 + k;
      copy.insert(v->point())->info() = v->info();

      Cavity cavity(m.tr, m.constraints, { random_item(cells, rng) });
      internal::grow_where(cavity, [&](const Cell_handle d)
      {
        return m.tr.side_of_sphere(d, v->point(), true) == CGAL::ON_BOUNDED_SIDE;
      });
      assert(internal::find_obstacle_to_star(cavity, m.predicates, v) == Star_obstacle::NONE);
      internal::star_cavity(m.editor, cavity, v);
      assert(m.tr.is_valid() && indices_of_cells(m.tr) == indices_of_cells(copy));
      ++number_of["Delaunay insertion"];
    }
  }
}

// --- special polyhedra -----------------------------------------------------------------------------------------------

typedef br3_test::Changing_mesh<K, false>                                     Plain_mesh;
typedef internal::Remove_vertex_3<Plain_mesh::Tr, Plain_mesh::Constraints>    Remove_vertex;

Plain_mesh::Tetrahedra positive(const Plain_mesh& mesh, Plain_mesh::Tetrahedra tetrahedra)
{
  for(Plain_mesh::Tetrahedron& t : tetrahedra)
    if(mesh.volume(t) < 0)
      std::swap(t[0], t[1]);
  return tetrahedra;
}

// The star of a vertex is the polyhedron of Schoenhardt: without it, there are no cells that fill it. With the cells
// next to it, there are, unless all three diagonals that make it are constrained.
void test_vertex_that_cannot_go(const std::size_t number_of_constraints)
{
  std::mt19937 rng(5);
  Plain_mesh m({ { 1000, 0, 0 }, { -500, 866, 0 }, { -500, -866, 0 },
                 { 866, 500, 1500 }, { -866, 500, 1500 }, { 0, -1000, 1500 } }, 0, rng);
  const Plain_mesh::Vertices p = br3_test::finite_vertices(m.tr);
  const Plain_mesh::Vertex_handle v = m.editor.create_vertex(Plain_mesh::Point(0, 0, 750));
  Plain_mesh::Tetrahedra tetrahedra = { {{ p[0], p[1], p[2], v }}, {{ p[3], p[4], p[5], v }} };
  for(std::size_t k = 0; k < 3; ++k)
  {
    const Plain_mesh::Vertex_handle a = p[k], b = p[(k + 1) % 3], c = p[3 + (k + 1) % 3], d = p[3 + k];
    tetrahedra.insert(tetrahedra.end(), { {{ a, b, c, d }}, {{ a, b, c, v }}, {{ a, c, d, v }} });
    if(k < number_of_constraints)
      m.constraints.insert({ a, c });
  }
  tetrahedra = positive(m, tetrahedra);
  const Plain_mesh::Cells cells = br3_test::finite_cells(m.tr);
  br3_test::Expected_change<Plain_mesh>(m, cells, tetrahedra).make([&] { m.editor.replace(cells, tetrahedra); });

  Remove_vertex remove(m.editor, m.predicates, m.constraints);
  const Plain_mesh::Cells star = m.cells_with({ v });
  assert(star.size() == 8 && ! remove.find(star, v));
  for(const Plain_mesh::Vertex_handle x : p)
    assert(! internal::is_star_seen(m.predicates, star, v, x));
  const bool is_found = remove.find_with_layer(star, v);
  assert(is_found == (number_of_constraints < 3));
  if(is_found)
    br3_test::Expected_change<Plain_mesh>(m, remove.cells(), remove.tetrahedra(), { v }).make([&] { remove(v); });
  ++number_of[is_found ? "Schoenhardt's polyhedron with a layer" : "Schoenhardt's polyhedron"];
}

// Of the two ways to fill a bipyramid, only the other one is left when its apex has moved.
void test_search_after_move()
{
  std::mt19937 rng(5);
  Plain_mesh m({ { 10, 0, 0 }, { -5, 9, 0 }, { -5, -9, 0 }, { 0, 0, 30 }, { 0, 0, -30 }, { 0, 0, 0 } }, 0, rng);
  const Plain_mesh::Vertices p = br3_test::finite_vertices(m.tr);
  const Plain_mesh::Cells star = m.cells_with({ p[5] });
  assert(star.size() == 6 && m.tr.number_of_finite_cells() == 6);
  Remove_vertex remove(m.editor, m.predicates, m.constraints);
  assert(remove.find_with_layer(star, p[5]));
  const std::size_t number_of_tetrahedra = remove.tetrahedra().size();
  assert(number_of_tetrahedra == 2 || number_of_tetrahedra == 3);
  if(number_of_tetrahedra == 2)
  {
    m.editor.move(p[3], Plain_mesh::Point(0, 0, -2));
    m.editor.move(p[5], Plain_mesh::Point(0, 0, -5));
  }
  else
    m.editor.move(p[3], Plain_mesh::Point(30, 0, 30));
  remove.forget();
  assert(remove.find_with_layer(star, p[5]));
  assert(remove.tetrahedra().size() == 5 - number_of_tetrahedra && m.are_positive(remove.tetrahedra()));
}

int main()
{
  test_random_operations<Plain_mesh>(1, 40);
  test_random_operations<br3_test::Changing_mesh<K, true> >(2, 20);
  test_random_operations<br3_test::Changing_mesh<EK, false> >(3, 5);
  test_delaunay_insertion<K>(4, 20);
  test_delaunay_insertion<EK>(5, 4);
  for(const std::size_t number_of_constraints : { 0, 1, 3 })
    test_vertex_that_cannot_go(number_of_constraints);
  test_search_after_move();

  for(const char* kind : { "shell not seen", "shell seen from the edge", "shell seen from elsewhere", "edge split",
                           "edge split on the hull", "constrained edge split", "facet split",
                           "facet split on the hull", "facet split from elsewhere", "constrained facet split",
                           "star seen", "star not seen", "edge collapsed", "edge collapsed next to a constraint",
                           "vertex removed by collapse", "vertex removed by reconnection",
                           "vertex removed with a layer", "vertex moved", "vertex not moved",
                           "face hidden", "constraint inside", "vertex lost", "no obstacle",
                           "cavity starred from a new vertex", "cavity starred from a vertex inside",
                           "cavity starred, and vertices are gone", "star extended from inside",
                           "star extended from the boundary", "star extended on the hull",
                           "star extended over hiding cells", "star not extended through a barrier",
                           "star not extended over a constraint or vertex", "cavity grown as far as constraints",
                           "cavity grown", "cavity not shrunk", "cavity shrunk to nothing", "cavity seen",
                           "cavity shrunk", "constraint at a vertex", "no constraint at a vertex",
                           "transaction interrupted", "transaction committed", "transaction taken back",
                           "vertex renamed", "Delaunay insertion", "Schoenhardt's polyhedron",
                           "Schoenhardt's polyhedron with a layer" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 0);
  }
  std::cout << "done" << std::endl;
}
