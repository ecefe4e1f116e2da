// What the tests of the searches for tetrahedralizations share: random cavities, and exact checks.

#ifndef BR3_TEST_TETRAHEDRALIZATIONS_BR3_H
#define BR3_TEST_TETRAHEDRALIZATIONS_BR3_H

#include "random_triangulations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/geometry/Vertex_predicates_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <random>
#include <vector>

namespace BR = CGAL::Boundary_recovery_3;
using br3_test::random_int;

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef Kernel::Point_3                                       Point;
typedef CGAL::Delaunay_triangulation_3<Kernel>                Tr;
typedef Tr::Vertex_handle                                     Vertex_handle;
typedef Tr::Cell_handle                                       Cell_handle;
typedef BR::internal::Vertex_predicates_3<Tr>                 Predicates;
typedef std::array<Vertex_handle, 4>                          Tetrahedron;
typedef std::vector<Tetrahedron>                              Tetrahedra;
typedef std::array<Vertex_handle, 2>                          Edge;
typedef std::array<Vertex_handle, 3>                          Facet;
typedef std::vector<Cell_handle>                              Cells;
typedef std::vector<Edge>                                     Edges;
typedef std::vector<Facet>                                    Facets;
typedef CGAL::Exact_rational                                  Number;

// Six times the signed volume.
inline Number volume(const Tetrahedron& t)
{
  std::array<std::array<Number, 3>, 3> m;
  for(int i = 0; i < 3; ++i)
    for(int k = 0; k < 3; ++k)
      m[i][k] = Number(t[i + 1]->point()[k]) - Number(t[0]->point()[k]);
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
       - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
       + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

inline Tetrahedra tetrahedra_of(const Cells& cells)
{
  Tetrahedra result;
  for(const Cell_handle c : cells)
    result.push_back({{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }});
  return result;
}

// All tetrahedra must be positive, and not flat.
inline Number total_volume(const Tetrahedra& tetrahedra)
{
  Number sum = 0;
  for(const Tetrahedron& t : tetrahedra)
  {
    const Number v = volume(t);
    assert(v > 0);
    sum += v;
  }
  return sum;
}

template <typename Simplex>
std::size_t number_around(const Tetrahedra& tetrahedra, const Simplex& simplex)
{
  return std::count_if(tetrahedra.begin(), tetrahedra.end(), [&](const Tetrahedron& t)
  {
    return std::all_of(simplex.begin(), simplex.end(), [&](const Vertex_handle v)
    {
      return std::find(t.begin(), t.end(), v) != t.end();
    });
  });
}

inline Point random_point(std::mt19937& rng, const bool on_grid)
{
  const auto coordinate = [&] { return on_grid ? random_int(rng, 5) : random_int(rng, 1 << 30) / 3.; };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return Point(x, y, z);
}

inline Cells finite_cells(const Tr& tr)
{
  Cells result;
  for(const Cell_handle c : tr.finite_cell_handles())
    result.push_back(c);
  return result;
}

// A union of up to n finite cells that is connected by facets.
inline Cells random_cavity(const Tr& tr, std::mt19937& rng, const std::size_t n)
{
  const Cells all = finite_cells(tr);
  Cells cavity(1, all[random_int(rng, static_cast<int>(all.size()))]);
  for(int trial = 0; trial < 1000 && cavity.size() < n; ++trial)
  {
    const Cell_handle c = cavity[random_int(rng, static_cast<int>(cavity.size()))]->neighbor(random_int(rng, 4));
    if(! tr.is_infinite(c) && std::find(cavity.begin(), cavity.end(), c) == cavity.end())
      cavity.push_back(c);
  }
  return cavity;
}

// Some edges and facets of the cells: the cells themselves are a solution.
inline void require_what_is_there(const Cells& cells, std::mt19937& rng, Edges& edges, Facets& facets)
{
  for(const Cell_handle c : cells)
  {
    const int i = random_int(rng, 4), j = (i + 1 + random_int(rng, 3)) % 4;
    edges.push_back({{ c->vertex(i), c->vertex(j) }});
    facets.push_back({{ c->vertex((i + 1) % 4), c->vertex((i + 2) % 4), c->vertex((i + 3) % 4) }});
  }
}

// The tetrahedra fill the cells, and have what was required.
inline void check_tetrahedralization(const Tetrahedra& tetrahedra, const Cells& cells, const Edges& edges,
                                     const Facets& facets)
{
  assert(total_volume(tetrahedra) == total_volume(tetrahedra_of(cells)));
  for(const Edge& e : edges)
    assert(number_around(tetrahedra, e) > 0);
  for(const Facet& f : facets)
    assert(number_around(tetrahedra, f) > 0);
}

// The result must be a triangulation again.
inline void replace_cells(Tr& tr, const Cells& cells, const Tetrahedra& tetrahedra)
{
  const std::size_t number_of_cells = tr.number_of_cells() + tetrahedra.size() - cells.size();
  BR::internal::Replace_cells<Tr> replace;
  replace(tr, cells, tetrahedra);
  assert(tr.number_of_cells() == number_of_cells && tr.tds().is_valid());
}

// Calls `work` with a triangulation and a cavity in it, many times; each second time with requirements, of what is
// there. Where `work` fills the cavity in another way, the next one is in that, and no longer in a Delaunay
// triangulation.
template <typename Work>
void for_each_random_cavity(const unsigned seed, const bool on_grid, const int number_of_triangulations,
                            const Work& work)
{
  std::mt19937 rng(seed);
  for(int round = 0; round < number_of_triangulations; ++round)
  {
    Tr tr;
    for(int i = 0; i < 60; ++i)
      tr.insert(random_point(rng, on_grid));
    for(int k = 0; k < 20; ++k)
    {
      const Cells cells = random_cavity(tr, rng, 4 + random_int(rng, 17));
      assert(cells.size() >= 4 && cells.size() <= 20);
      Edges edges;
      Facets facets;
      if(k % 2 == 1)
        require_what_is_there(cells, rng, edges, facets);
      work(tr, cells, edges, facets);
    }
  }
}

// Calls `work` with the hulls of n points, as triangulations, and with some edges between any two of them, drawn at
// random: a search has to take back choices.
template <typename Work>
void for_each_random_hull(std::mt19937& rng, const int number_of_hulls, const int n, const int min_number_of_edges,
                          const int max_number_of_edges, const Work& work)
{
  for(int round = 0; round < number_of_hulls; ++round)
  {
    Tr tr;
    std::vector<Vertex_handle> v;
    for(int i = 0; i < n; ++i)
      v.push_back(tr.insert(random_point(rng, false)));
    Edges edges;
    for(int i = 0; i < min_number_of_edges + round % (max_number_of_edges - min_number_of_edges + 1); ++i)
    {
      const int a = random_int(rng, n), b = (a + 1 + random_int(rng, n - 1)) % n;
      edges.push_back({{ v[a], v[b] }});
    }
    work(tr, edges);
  }
}

#endif // BR3_TEST_TETRAHEDRALIZATIONS_BR3_H
