// Local operations at random places of a mesh, each checked against what it does by definition.

#ifndef BR3_TEST_RANDOM_OPERATIONS_H
#define BR3_TEST_RANDOM_OPERATIONS_H

#include "cavity_surroundings_br3.h"
#include "changing_mesh_br3.h"
#include "expected_change_br3.h"
#include "random_numbers_br3.h"
#include "random_places_br3.h"

#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Move_into_kernel_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/Remove_vertex_3.h>
#include <CGAL/Boundary_recovery_3/internal/operations/split_simplex.h>
#include <CGAL/Boundary_recovery_3/internal/operations/star_cavity.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace br3_test {

namespace internal = CGAL::Boundary_recovery_3::internal;

template <typename Mesh>
class Random_operation
  : private Random_places<Mesh>
{
  typedef Random_places<Mesh>  Places;

public:
  Random_operation(Mesh& mesh, std::mt19937& rng)
    : Places(mesh, rng), m_remove(mesh.editor, mesh.predicates, mesh.constraints)
  { }

  // Makes at most one change, and checks it. An interruption is handed on.
  void operator()()
  {
    switch(random_int(rng, 10))
    {
      case 0: split_edge(); break;
      case 1: split_facet(); break;
      case 2: collapse_edge(); break;
      case 3: case 4: star_cavity(); break;
      case 5: remove_vertex(); break;
      case 6: remove_vertex_with_layer(); break;
      case 7: move_vertex(); break;
      case 8: case 9: extend_star(); break;
    }
  }

  // Vertices moved, or came.
  void forget() { m_remove.forget(); }

private:
  typedef typename Places::Tr             Tr;
  typedef typename Places::Vertex_handle  Vertex_handle;
  typedef typename Places::Cell_handle    Cell_handle;
  typedef typename Places::Simplex        Simplex;
  typedef typename Places::Tetrahedron    Tetrahedron;
  typedef typename Places::Vertices       Vertices;
  typedef typename Places::Cells          Cells;
  typedef typename Mesh::Tetrahedra       Tetrahedra;
  typedef typename Mesh::Constraints      Constraints;
  typedef std::array<Vertex_handle, 3>    Vertex_triple;
  typedef internal::Star_obstacle         Star_obstacle;

  using Places::m;
  using Places::rng;
  using Places::star;
  using Places::is_any_constraint_at;
  using Places::random_cells;
  using Places::random_finite_cell;
  using Places::random_free_vertex;
  using Places::random_vertex;
  using Places::without;

  // --- splits -------------------------------------------------------------------------------------------------------

  // Anywhere on an edge, or near one that is not on the hull.
  void split_edge()
  {
    const Cell_handle finite = random_finite_cell();
    const int i = random_int(rng, 4), j = (i + 1 + random_int(rng, 3)) % 4;
    const Vertex_handle a = finite->vertex(i), b = finite->vertex(j);
    const Cells shell = m.cells_with({ a, b });
    const Cell_handle c = random_item(shell, rng);
    const bool is_on_edge = random_int(rng, 3) > 0;
    const Vertices support = is_on_edge ? Vertices{ a, b } : Vertices{ a, a, a, b, b, b, random_vertex() };
    const Vertex_handle v = m.create_vertex(support, rng);
    if(v == Vertex_handle())
      return;
    Tetrahedra halves;
    for(const Cell_handle cell : shell)
      for(const Vertex_handle end : { a, b })
        halves.push_back(Mesh::with_exchanged(cell, end, v));
    const bool is_seen = m.are_positive(halves);
    assert(is_seen || ! is_on_edge);
    ++number_of[! is_seen ? "shell not seen" : is_on_edge ? "shell seen from the edge" : "shell seen from elsewhere"];
    const bool is_on_hull = m.is_any_infinite(shell), is_constrained = m.constraints.is_constrained(a, b);
    if(! is_seen || (! is_on_edge && (is_on_hull || is_constrained)))
    {
      m.delete_vertex(v);
      return;
    }
    Constraints constraints = m.constraints;
    if(is_constrained)
      constraints.split(a, b, v);
    Expected_change<Mesh>(m, shell, halves).make([&]
    {
      if(! is_constrained && random_int(rng, 2) == 0)
        internal::split_edge(m.editor, c, a, b, v);
      else
        this->with_constraints([&](auto& set) { internal::split_edge(m.editor, set, c, a, b, v); });
    });
    assert(m.constraints.simplices == constraints.simplices);
    ++number_of[is_on_hull ? "edge split on the hull" : "edge split"];
    number_of["constrained edge split"] += is_constrained;
    forget();
  }

  // Anywhere on a facet, or near one that is not on the hull.
  void split_facet()
  {
    Cell_handle c = random_finite_cell();
    const int i = random_int(rng, 4);
    const Vertex_handle apex = c->vertex(i);
    const Simplex facet = without(Mesh::vertices_of(c), apex);
    const Cells cells = m.cells_with(facet);
    assert(cells.size() == 2);
    const bool is_on_facet = random_int(rng, 3) > 0;
    Vertex_triple f = internal::facet_vertices(c, i);
    Vertices support(f.begin(), f.end());
    if(! is_on_facet)
      support = { f[0], f[0], f[1], f[1], f[2], f[2], apex };
    const Vertex_handle v = m.create_vertex(support, rng);
    if(v == Vertex_handle())
      return;
    Tetrahedra thirds;
    for(const Cell_handle cell : cells)
      for(const Vertex_handle w : facet)
        thirds.push_back(Mesh::with_exchanged(cell, w, v));
    c = random_item(cells, rng);
    std::rotate(f.begin(), f.begin() + random_int(rng, 3), f.end());
    const bool is_on_hull = m.is_any_infinite(cells), is_constrained = m.constraints.is_constrained(f[0], f[1], f[2]);
    if(! m.are_positive(thirds) || (! is_on_facet && (is_on_hull || is_constrained)))
    {
      m.delete_vertex(v);
      return;
    }
    Constraints constraints = m.constraints;
    if(is_constrained)
      constraints.split(f[0], f[1], f[2], v);
    Expected_change<Mesh>(m, cells, thirds).make([&]
    {
      if(! is_constrained && random_int(rng, 2) == 0)
        internal::split_facet(m.editor, c, f, v);
      else
        this->with_constraints([&](auto& set) { internal::split_facet(m.editor, set, c, f, v); });
    });
    assert(m.constraints.simplices == constraints.simplices);
    ++number_of[is_on_hull ? "facet split on the hull" : is_on_facet ? "facet split" : "facet split from elsewhere"];
    number_of["constrained facet split"] += is_constrained;
    forget();
  }

  // --- removal of vertices ------------------------------------------------------------------------------------------

  // The cells from x that cover the star of v.
  static Tetrahedra collapsed(const Cells& star, const Vertex_handle v, const Vertex_handle x)
  {
    Tetrahedra result;
    for(const Cell_handle c : star)
      if(Mesh::vertices_of(c).count(x) == 0)
        result.push_back(Mesh::with_exchanged(c, v, x));
    return result;
  }

  // Those neighbors of v onto which it can be collapsed, in the order in which they are met.
  Vertices seeing_neighbors(const Cells& star, const Vertex_handle v) const
  {
    Vertices result;
    Simplex known = { v };
    for(const Cell_handle c : star)
      for(const Vertex_handle x : Mesh::tetrahedron(c))
        if(known.insert(x).second)
        {
          const bool is_seen = m.are_positive(collapsed(star, v, x));
          assert(internal::is_star_seen(m.predicates, star, v, x) == is_seen);
          ++number_of[is_seen ? "star seen" : "star not seen"];
          if(is_seen)
            result.push_back(x);
        }
    return result;
  }

  void collapse_edge()
  {
    const Vertex_handle v = random_free_vertex();
    if(v == Vertex_handle())
      return;
    const Cells cells = star(v);
    const Vertices neighbors = seeing_neighbors(cells, v);
    if(neighbors.empty())
      return;
    const Vertex_handle x = random_item(neighbors, rng);
    Expected_change<Mesh>(m, cells, collapsed(cells, v, x), { v }).make([&]
    {
      internal::collapse_edge(m.editor, cells, v, x);
    });
    ++number_of["edge collapsed"];
    number_of["edge collapsed next to a constraint"] += is_any_constraint_at(x);
  }

  void remove_vertex()
  {
    const Vertex_handle v = random_free_vertex();
    if(v == Vertex_handle())
      return;
    const Cells cells = star(v);
    const Vertices neighbors = seeing_neighbors(cells, v);
    const bool is_found = m_remove.find(cells, v);
    assert(is_found || neighbors.empty());
    ++number_of[! neighbors.empty() ? "vertex removed by collapse" : is_found ? "vertex removed by reconnection"
                                                                              : "vertex not removed"];
    if(! is_found)
      return;
    assert(m_remove.cells() == cells);
    if(! neighbors.empty())
      assert(m_remove.tetrahedra() == collapsed(cells, v, neighbors.front()));
    Expected_change<Mesh>(m, cells, m_remove.tetrahedra(), { v }).make([&] { m_remove(v); });
  }

  void remove_vertex_with_layer()
  {
    const Vertex_handle v = random_free_vertex();
    if(v == Vertex_handle())
      return;
    const Cells cells = star(v);
    std::set<Cell_handle> expected(cells.begin(), cells.end());
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(! m.tr.is_infinite(c->neighbor(i)))
          expected.insert(c->neighbor(i));
    const bool is_found = m_remove.find_with_layer(cells, v);
    ++number_of[is_found ? "vertex removed with a layer" : "vertex not removed with a layer"];
    if(! is_found)
      return;
    const Cells found = m_remove.cells();
    assert(found.size() == expected.size() && std::set<Cell_handle>(found.begin(), found.end()) == expected);
    Expected_change<Mesh>(m, found, m_remove.tetrahedra(), { v }).make([&] { m_remove(v); });
  }

  // --- other places for vertices ------------------------------------------------------------------------------------

  // In the star of a vertex: if it does not see it from there, it is put back. Or into the kernel of the star.
  void move_vertex()
  {
    const Vertex_handle v = random_free_vertex();
    if(v == Vertex_handle())
      return;
    const Cells cells = star(v);
    const typename Mesh::Exact_point before = m.exact_point(v);
    const typename Mesh::Point rounded = v->point();
    const bool had_exact_position = m.positions.contains(v);
    bool is_seen = true;
    if(random_int(rng, 2) == 0)
    {
      m.editor.before_move(v);
      m.positions.erase(v);
      internal::Move_into_kernel_3<Tr> move(m.predicates, m.positions);
      is_seen = move(v, internal::faces_of_star(cells, v));
      assert(! is_seen || are_seen_now(cells));
    }
    else
    {
      const auto p = m.random_point({ v, v, random_vertex() }, rng);
      m.positions.erase(v);
      m.editor.move(v, typename Mesh::Point(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])));
      is_seen = are_seen_now(cells);
    }
    ++number_of[is_seen ? "vertex moved" : "vertex not moved"];
    if(! is_seen)
    {
      m.positions.erase(v);
      v->set_point(rounded);
      if(had_exact_position)
        m.place(v, before);
    }
    assert(internal::is_mesh_valid(m.tr, m.predicates));
    forget();
  }

  bool are_seen_now(const Cells& cells) const
  {
    Tetrahedra tetrahedra;
    for(const Cell_handle c : cells)
      tetrahedra.push_back(Mesh::tetrahedron(c));
    return m.are_positive(tetrahedra);
  }

  // --- stars --------------------------------------------------------------------------------------------------------

  // A few cells, and a vertex in the first one; or a star, and a vertex near its center or that; and sometimes the
  // cells around them that have two faces in common with them.
  void star_cavity()
  {
    Cells cells;
    Vertices near;
    const Vertex_handle center = random_vertex();
    const bool is_star = random_int(rng, 3) > 0 && ! m.is_any_infinite(star(center));
    if(is_star)
    {
      cells = star(center);
      near = Vertices(7, center);
    }
    else
      cells = random_cells(1 + random_int(rng, 4));
    for(const Vertex_handle w : Mesh::tetrahedron(cells.front()))
      near.push_back(w);
    const bool is_vertex_new = ! is_star || random_int(rng, 2) == 0;
    const Vertex_handle v = is_vertex_new ? m.create_vertex(near, rng) : random_int(rng, 5) == 0 ? near.back() : center;
    if(v == Vertex_handle())
      return;
    if(random_int(rng, 2) == 0)
      add_seen_cells(cells, v);
    Vertices droppable;
    for(const Vertex_handle w : Surroundings<Mesh>(m, cells, v).inner_vertices)
      if(random_int(rng, 3) > 0)
        droppable.push_back(w);
    if(! star(cells, v, droppable, is_vertex_new) && is_vertex_new)
      m.delete_vertex(v);
    forget();
  }

  // Cells beyond faces, as far as v sees all the others of theirs.
  void add_seen_cells(Cells& cells, const Vertex_handle v) const
  {
    const std::size_t n = cells.size();
    for(std::size_t k = 0; k < n; ++k)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle c = cells[k]->neighbor(i);
        if(m.tr.is_infinite(c) || std::count(cells.begin(), cells.end(), c) > 0)
          continue;
        cells.push_back(c);
        if(! m.are_positive(Surroundings<Mesh>(m, cells, v).star))
          cells.pop_back();
      }
  }

  bool star(const Cells& cells, const Vertex_handle v, const Vertices& droppable, const bool is_vertex_new)
  {
    const Surroundings<Mesh> around(m, cells, v);
    const Star_obstacle expected = around.obstacle_to_star(droppable);
    this->for_each_kind_of_constraints([&](const auto& constraints)
    {
      internal::Cavity_3<Tr, std::decay_t<decltype(constraints)> > cavity(m.tr, constraints, cells);
      assert(internal::find_obstacle_to_star(cavity, m.predicates, v, droppable) == expected);
      if(droppable.empty())
        assert(internal::find_obstacle_to_star(cavity, m.predicates, v) == expected);
    });
    const std::map<Star_obstacle, std::string> names = { { Star_obstacle::HIDDEN_FACE, "face hidden" },
      { Star_obstacle::CONSTRAINT_INSIDE, "constraint inside" }, { Star_obstacle::VERTEX_LOST, "vertex lost" },
      { Star_obstacle::NONE, "no obstacle" } };
    ++number_of[names.at(expected)];
    if(expected != Star_obstacle::NONE)
      return false;
    Vertices dropped = around.inner_vertices;
    dropped.erase(std::remove(dropped.begin(), dropped.end(), v), dropped.end());
    number_of["cavity starred, and vertices are gone"] += ! dropped.empty();
    ++number_of[is_vertex_new ? "cavity starred from a new vertex" : "cavity starred from a vertex inside"];
    internal::Cavity_3<Tr, Constraints> cavity(m.tr, m.constraints, cells);
    Expected_change<Mesh>(m, cells, around.star, dropped).make([&]
    {
      internal::star_cavity(m.editor, cavity, v);
    });
    return true;
  }

  // Over a few cells, from a vertex of theirs, or of a cell next to them; or over its own star and a cell next to that.
  void extend_star()
  {
    Vertex_handle v = random_vertex();
    Cells seeds = star(v);
    if(random_int(rng, 4) == 0 && ! m.is_any_infinite(seeds))
    {
      const Cell_handle next = seeds.front()->neighbor(seeds.front()->index(v));
      if(! m.tr.is_infinite(next))
        seeds.push_back(next);
    }
    else
    {
      seeds = random_cells(1 + random_int(rng, 3));
      Vertices near;
      for(const Cell_handle c : { seeds.back(), seeds.back()->neighbor(random_int(rng, 4)) })
        for(const Vertex_handle w : Mesh::tetrahedron(c))
          if(! m.tr.is_infinite(w))
            near.push_back(w);
      v = random_item(near, rng);
    }
    internal::Extend_star_3<Tr, Constraints> extend(m.editor, m.predicates, m.constraints);
    Cells cells = seeds;
    const bool is_barred = ! add_hiding_cells(cells, v);
    const Surroundings<Mesh> around(m, cells, v);
    Tetrahedra tetrahedra;
    for(const Tetrahedron& t : around.star)
      if(std::count(t.begin(), t.end(), v) == 1) // no face at v
        tetrahedra.push_back(t);
    const bool is_any_lost = ! is_barred && is_any_simplex_lost(around, tetrahedra);
    if(is_barred || is_any_lost)
    {
      ++number_of[is_barred ? "star not extended through a barrier" : "star not extended over a constraint or vertex"];
      assert(! extend(seeds, v) && extend.number_of_replacements() == 0);
      assert(m.are_all_constraints_there());
      return;
    }
    ++number_of[around.inner_vertices.empty() ? "star extended from the boundary" : "star extended from inside"];
    number_of["star extended on the hull"] += m.is_any_infinite(star(v));
    number_of["star extended over hiding cells"] += cells.size() > seeds.size();
    Expected_change<Mesh>(m, cells, tetrahedra).make([&]
    {
      const bool is_extended = extend(seeds, v);
      assert(is_extended && extend.number_of_replacements() == 1 && extend.number_of_cells() == cells.size());
    });
    forget();
  }

  // Cells beyond faces that v does not see. Returns false if a constrained facet or the hull is in the way.
  bool add_hiding_cells(Cells& cells, const Vertex_handle v) const
  {
    for(std::size_t k = 0; k < cells.size(); ++k)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle c = cells[k], n = c->neighbor(i);
        const Simplex face = without(Mesh::vertices_of(c), c->vertex(i));
        if(std::count(cells.begin(), cells.end(), n) > 0 || face.count(v) == 1
           || m.are_positive({ Mesh::with_exchanged(c, c->vertex(i), v) }))
          continue;
        if(m.tr.is_infinite(n) || m.constraints.simplices.count(face) == 1)
          return false;
        cells.push_back(n);
      }
    return true;
  }

  // Whether a constraint or a vertex of the cells would be gone.
  bool is_any_simplex_lost(const Surroundings<Mesh>& around, const Tetrahedra& tetrahedra) const
  {
    std::set<Simplex> simplices = m.constraints.simplices;
    for(const Cell_handle c : around.cells)
      for(const Vertex_handle w : Mesh::tetrahedron(c))
        simplices.insert(Simplex{ w });
    return std::any_of(simplices.begin(), simplices.end(), [&](const Simplex& s)
    {
      return around.is_inside(s) && std::none_of(tetrahedra.begin(), tetrahedra.end(), [&](const Tetrahedron& t)
      {
        return Mesh::is_face(s, Simplex(t.begin(), t.end()));
      });
    });
  }

  internal::Remove_vertex_3<Tr, Constraints> m_remove;
};

} // namespace br3_test

#endif // BR3_TEST_RANDOM_OPERATIONS_H
