// Random places in a mesh where something can be done or asked.

#ifndef BR3_TEST_RANDOM_PLACES_H
#define BR3_TEST_RANDOM_PLACES_H

#include "changing_mesh_br3.h"
#include "constraint_sets_br3.h"
#include "random_numbers_br3.h"
#include "random_triangulations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace br3_test {

// How often each kind of case was met.
inline std::map<std::string, int> number_of;

template <typename Items>
typename Items::value_type random_item(const Items& items, std::mt19937& rng)
{
  return items[static_cast<std::size_t>(random_int(rng, static_cast<int>(items.size())))];
}

template <typename Mesh>
class Random_places
{
protected:
  typedef typename Mesh::Tr             Tr;
  typedef typename Mesh::Vertex_handle  Vertex_handle;
  typedef typename Mesh::Cell_handle    Cell_handle;
  typedef typename Mesh::Simplex        Simplex;
  typedef typename Mesh::Tetrahedron    Tetrahedron;
  typedef typename Mesh::Vertices       Vertices;
  typedef typename Mesh::Cells          Cells;

  Random_places(Mesh& mesh, std::mt19937& rng) : m(mesh), rng(rng) { }

  static Simplex without(Simplex s, const Vertex_handle v)
  {
    s.erase(v);
    return s;
  }

  bool is_any_constraint_at(const Vertex_handle v) const
  {
    return std::any_of(m.constraints.simplices.begin(), m.constraints.simplices.end(),
                       [&](const Simplex& s) { return s.count(v) == 1; });
  }

  // Calls `work` with the constraints in each kind of set that there is.
  template <typename Work>
  void for_each_kind_of_constraints(const Work& work) const
  {
    work(m.constraints);
    work(Constraints_in_mesh<Tr>(m.tr, m.constraints));
    work(numbered<Tr>(m.constraints));
  }

  // Calls `work`, which changes the constraints, with these in one kind of set.
  template <typename Work>
  void with_constraints(const Work& work)
  {
    const int kind = random_int(rng, 3);
    if(kind == 0)
      work(m.constraints);
    else if(kind == 1)
    {
      Constraints_in_mesh<Tr> in_mesh(m.tr, m.constraints);
      work(in_mesh);
    }
    else
    {
      auto set = numbered<Tr>(m.constraints);
      work(set);
      m.constraints = without_numbers<Tr>(set);
    }
  }

  Cell_handle random_finite_cell() const { return random_item(finite_cells(m.tr), rng); }

  Vertex_handle random_vertex() const { return random_finite_cell()->vertex(random_int(rng, 4)); }

  // Inside the hull, with no constraint at it; none if a few trials find no such vertex.
  Vertex_handle random_free_vertex() const
  {
    for(int trial = 0; trial < 20; ++trial)
    {
      const Vertex_handle v = random_vertex();
      if(! m.is_any_infinite(m.cells_with({ v })) && ! is_any_constraint_at(v))
        return v;
    }
    return Vertex_handle();
  }

  // A union of up to n cells that is connected by facets.
  Cells random_cells(const int n) const
  {
    Cells cells(1, random_finite_cell());
    for(int trial = 0; trial < 100 && cells.size() < static_cast<std::size_t>(n); ++trial)
    {
      const Cell_handle c = random_item(cells, rng)->neighbor(random_int(rng, 4));
      if(! m.tr.is_infinite(c) && std::count(cells.begin(), cells.end(), c) == 0)
        cells.push_back(c);
    }
    return cells;
  }

  // All cells around a vertex, in the order of the library.
  Cells star(const Vertex_handle v) const
  {
    Cells cells;
    const bool is_finite = CGAL::Boundary_recovery_3::internal::collect_star(m.tr, v, cells);
    const Cells expected = m.cells_with({ v });
    assert(is_finite == ! m.is_any_infinite(expected));
    assert(cells.size() == expected.size());
    for(const Cell_handle c : expected)
      assert(std::count(cells.begin(), cells.end(), c) == 1);
    return cells;
  }

  Mesh& m;
  std::mt19937& rng;
};

} // namespace br3_test

#endif // BR3_TEST_RANDOM_PLACES_H
