// What remesh_holes() is made of, but for the mesher: incidences, holes that grow, their surfaces, sides of facets, old
// sizes and old places, each against a naive reference.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "moved_grid_br3.h"
#include "random_numbers_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_surface_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Locate_in_hole_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Tetrahedra_incidences_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
using br3_test::Moved_grid;
using br3_test::random_int;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;
typedef internal::Tetrahedra_incidences_3                   Incidences;
typedef internal::Hole_cells_3                              Hole_cells;
typedef std::array<std::size_t, 3>                          Facet;
typedef std::array<std::size_t, 4>                          Tetrahedron;

template <typename Kernel>
internal::Moved_mesh_3<typename Kernel::Point_3> mesh_of(const Moved_grid& grid)
{
  return { { grid.points<typename Kernel::Point_3>(), grid.facets, grid.edges }, grid.tetrahedra, grid.regions };
}

Facet sorted(Facet f)
{
  std::sort(f.begin(), f.end());
  return f;
}

// No side of a facet that several tetrahedra have is on the boundary, however many there are.
void test_incidences_of_nonmanifold_facet()
{
  for(std::size_t n = 1; n <= 4; ++n)
  {
    std::vector<Tetrahedron> tetrahedra;
    for(std::size_t k = 0; k < n; ++k)
      tetrahedra.push_back({{ 0, k % 2 == 0 ? 1u : 2u, k % 2 == 0 ? 2u : 1u, 3 + k }});
    const Incidences incidences(3 + n, tetrahedra);
    assert(incidences.nonmanifold_facets().size() == (n > 2 ? 1 : 0) && incidences.inconsistent_facets().empty());
    for(std::size_t side = 0; side < 4 * n; ++side)
    {
      const std::size_t other = incidences.opposite(side);
      assert((other == incidences.none) == (n == 1 || side % 4 != 3));
      assert(other == incidences.none || (other != side && other % 4 == 3));
    }
  }
}

void test_incidences()
{
  std::mt19937 rng(5);
  Moved_grid grid(3);
  std::shuffle(grid.tetrahedra.begin(), grid.tetrahedra.end(), rng);
  for(Tetrahedron& t : grid.tetrahedra) // their vertices in any order, but for the orientation
    for(int k = 0; k < 3; ++k)
    {
      const std::size_t i = std::size_t(random_int(rng, 4)), u = t[(i + 1) % 4];
      t[(i + 1) % 4] = t[(i + 2) % 4];
      t[(i + 2) % 4] = t[(i + 3) % 4];
      t[(i + 3) % 4] = u;
    }
  grid.places.push_back({{ 9, 9, 9 }}); // a vertex without cells
  const Incidences incidences(grid.places.size(), grid.tetrahedra);
  assert(incidences.nonmanifold_facets().empty() && incidences.inconsistent_facets().empty());
  for(std::size_t v = 0; v < grid.places.size(); ++v)
  {
    std::vector<std::size_t> star;
    for(std::size_t c = 0; c < grid.tetrahedra.size(); ++c)
    {
      const Tetrahedron& t = grid.tetrahedra[c];
      if(std::find(t.begin(), t.end(), v) != t.end())
        star.push_back(c);
    }
    const auto range = incidences.cells(v);
    assert(std::vector<std::size_t>(range.begin(), range.end()) == star && range.size() == star.size());
  }
  std::map<Facet, std::vector<std::size_t> > sides;
  for(std::size_t s = 0; s < 4 * grid.tetrahedra.size(); ++s)
    sides[sorted(incidences.facet(s))].push_back(s);
  for(const auto& f : sides)
  {
    assert(f.second.size() <= 2);
    assert(incidences.opposite(f.second.front()) == (f.second.size() == 1 ? incidences.none : f.second.back()));
    assert(incidences.opposite(f.second.back()) == (f.second.size() == 1 ? incidences.none : f.second.front()));
    const std::size_t found = incidences.find({{ f.first[2], f.first[0], f.first[1] }});
    assert(std::find(f.second.begin(), f.second.end(), found) != f.second.end());
  }
  assert(incidences.find({{ 0, 1, 63 }}) == incidences.none && ! incidences.has_edge(0, 63));
  assert(incidences.has_edge(0, 1) && incidences.has_edge(1, 0) && ! incidences.has_edge(0, 64));

  // the cell is on the positive side
  for(std::size_t s = 0; s < 4 * grid.tetrahedra.size(); ++s)
  {
    const Facet f = incidences.facet(s);
    const auto points = grid.points<Epick::Point_3>();
    assert(CGAL::orientation(points[f[0]], points[f[1]], points[f[2]], points[grid.tetrahedra[s / 4][s % 4]])
           == CGAL::POSITIVE);
  }
}

// All the bad cells, by naive tests.
void test_bad_cells()
{
  std::mt19937 rng(6);
  Moved_grid grid(4);
  grid.set_region({{ 0, 0, 0 }}, {{ 2, 4, 4 }}, 0);
  grid.shake(rng, 0.7, 2);
  const auto points = grid.points<Epick::Point_3>();
  for(const double angle : { 0., 20. })
  {
    const internal::Find_bad_cells_3<Epick> bad(mesh_of<Epick>(grid), angle,
                                                [](const std::size_t c) { return c % 50 == 3; },
                                                [](const int region) { return region == 0; });
    std::size_t number = 0, number_of_inverted = 0;
    for(std::size_t c = 0; c < grid.tetrahedra.size(); ++c)
    {
      const Tetrahedron& t = grid.tetrahedra[c];
      const bool is_inverted = CGAL::orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]])
                               != CGAL::POSITIVE;
      double smallest = 180;
      for(std::size_t i = 0; i < 4; ++i)
        for(std::size_t j = 0; j < 4; ++j)
          if(i != j)
          {
            std::array<std::size_t, 2> k;
            std::size_t n = 0;
            for(std::size_t m = 0; m < 4; ++m)
              if(m != i && m != j)
                k[n++] = m;
            smallest = (std::min)(smallest, std::abs(CGAL::approximate_dihedral_angle(
                                              points[t[i]], points[t[j]], points[t[k[0]]], points[t[k[1]]])));
          }
      const bool is_thin = grid.regions[c] != 0 && smallest < angle;
      assert(bool(bad.is_bad[c]) == (is_inverted || is_thin || c % 50 == 3));
      number += bad.is_bad[c] ? 1 : 0;
      number_of_inverted += is_inverted ? 1 : 0;
    }
    assert(bad.number_of_bad_cells == number && bad.number_of_inverted_cells == number_of_inverted);
    assert(number_of_inverted > 10);
  }
}

// The parts of a set of cells that are connected by facets.
std::set<std::vector<std::size_t> > components(const Incidences& incidences, const std::set<std::size_t>& cells)
{
  std::map<std::size_t, std::size_t> name;
  for(const std::size_t c : cells)
    name[c] = c;
  for(bool is_changed = true; is_changed; )
  {
    is_changed = false;
    for(const std::size_t c : cells)
      for(std::size_t i = 0; i < 4; ++i)
      {
        const std::size_t side = incidences.opposite(4 * c + i);
        if(side != incidences.none && cells.count(side / 4) > 0 && name[side / 4] < name[c])
        {
          name[c] = name[side / 4];
          is_changed = true;
        }
      }
  }
  std::map<std::size_t, std::vector<std::size_t> > parts;
  for(const auto& c : name)
    parts[c.second].push_back(c.first);
  std::set<std::vector<std::size_t> > result;
  for(const auto& part : parts)
    result.insert(part.second);
  return result;
}

void check_holes(const Hole_cells& holes, const Incidences& incidences, const std::set<std::size_t>& cells)
{
  std::set<std::vector<std::size_t> > result;
  for(std::size_t k = 0; k < holes.number_of_holes(); ++k)
    if(! holes.cells(k).empty())
      result.insert(holes.cells(k));
  assert(result == components(incidences, cells));
  for(const auto& a : result)
    for(const auto& b : result)
      assert(holes.are_in_same_hole(a.front(), b.back()) == (a == b));
}

void test_holes_that_grow()
{
  std::mt19937 rng(7);
  for(int run = 0; run < 10; ++run)
  {
    const Moved_grid grid(4);
    const Incidences incidences(grid.places.size(), grid.tetrahedra);
    Hole_cells holes(grid.tetrahedra, incidences);
    std::set<std::size_t> cells;
    const auto add_stars = [&](const std::vector<std::size_t>& vertices)
    {
      for(const std::size_t v : vertices)
        for(const std::size_t c : incidences.cells(v))
          cells.insert(c);
    };
    for(int k = 0; k < 6; ++k)
    {
      const std::size_t c = std::size_t(random_int(rng, 384));
      assert(holes.add(c) == cells.insert(c).second && holes.contains(c));
    }
    for(int layer = 0; layer < run % 3; ++layer)
      for(const std::size_t c : std::set<std::size_t>(cells))
        add_stars({ grid.tetrahedra[c].begin(), grid.tetrahedra[c].end() });
    holes.add_layers(std::size_t(run % 3));
    assert(holes.form_holes() == 0);
    check_holes(holes, incidences, cells);
    for(int round = 0; round < 4; ++round)
    {
      const std::size_t hole = std::size_t(random_int(rng, int(holes.number_of_holes())));
      if(holes.cells(hole).empty())
        continue;
      const std::vector<std::size_t> old_cells = holes.cells(hole);
      const std::size_t v = grid.tetrahedra[holes.cells(hole).back()][0];
      const std::size_t number = cells.size();
      add_stars({ v });
      holes.dissolve(hole);
      assert(holes.cells(hole).empty());
      assert(holes.add_star(v) == (cells.size() > number));
      const std::size_t first = holes.form_holes();
      assert(first + 1 == holes.number_of_holes());
      check_holes(holes, incidences, cells);
    }
  }
}

// A facet has to stay if it is on the boundary, between regions, or named; those of a hole are these and its boundary.
void test_surface_of_hole()
{
  std::mt19937 rng(8);
  Moved_grid grid(5);
  grid.set_region({{ 0, 0, 0 }}, {{ 2, 4, 4 }}, 3);
  grid.set_region({{ 1, 1, 1 }}, {{ 3, 3, 3 }}, -2);
  grid.add_sheet(3, {{ 1, 0 }}, {{ 4, 2 }});
  grid.add_edges(4, 4, 1, 4);
  grid.edges.push_back(grid.edges.front()); // once more
  std::swap(grid.edges[0][0], grid.edges[0][1]);
  const auto mesh = mesh_of<Epick>(grid);
  const Incidences incidences(grid.places.size(), grid.tetrahedra);
  internal::Constrained_sides_3<Epick::Point_3> constraints(mesh, incidences);
  std::vector<std::size_t> lost_facets, lost_edges;
  constraints.find(lost_facets, lost_edges);
  assert(lost_facets.empty() && lost_edges.empty());
  for(std::size_t e = 0; e < 3; ++e)
    assert(constraints.position(grid.edges[e]) == e && constraints.is_constrained_edge(grid.edges[e]));

  const auto regions_of_facets = grid.regions_of_facets();
  std::map<Facet, std::size_t> position;
  for(std::size_t f = 0; f < grid.facets.size(); ++f)
    position[sorted(grid.facets[f])] = f;
  const auto has_to_stay = [&](const Facet& f)
  {
    const auto& regions = regions_of_facets.at(f);
    return regions.size() == 1 || regions[0] != regions[1] || position.count(f) > 0;
  };
  for(std::size_t s = 0; s < 4 * grid.tetrahedra.size(); ++s)
  {
    const Facet f = sorted(incidences.facet(s));
    assert(constraints.is_constrained(s) == has_to_stay(f));
    assert(constraints.position(s) == (position.count(f) > 0 ? position[f] : constraints.none));
  }
  const std::vector<bool> is_constrained = grid.constrained_vertices();
  for(std::size_t v = 0; v < grid.places.size(); ++v)
    assert(constraints.is_constrained_vertex(v) == is_constrained[v]);

  for(int run = 0; run < 10; ++run)
  {
    Hole_cells holes(grid.tetrahedra, incidences);
    for(int k = 0; k < 1 + run; ++k)
      holes.add(std::size_t(random_int(rng, 750)));
    holes.add_layers(std::size_t(run % 3));
    holes.form_holes();
    for(std::size_t h = 0; h < holes.number_of_holes(); ++h)
    {
      const internal::Hole_surface_3<Epick::Point_3> surface(mesh, incidences, constraints, holes, holes.cells(h));
      std::map<Facet, std::vector<int> > expected;
      for(const std::size_t c : holes.cells(h))
        for(std::size_t i = 0; i < 4; ++i)
          expected[sorted(incidences.facet(4 * c + i))].push_back(grid.regions[c]);
      std::size_t number = 0;
      for(const auto& f : expected)
        number += f.second.size() == 1 || has_to_stay(f.first) ? 1 : 0;
      assert(surface.facets.size() == number);
      assert(std::is_sorted(surface.vertices.begin(), surface.vertices.end()));
      for(std::size_t k = 0; k < number; ++k)
      {
        Facet f;
        for(std::size_t i = 0; i < 3; ++i)
          f[i] = surface.vertices[surface.facets[k][i]];
        assert(f == incidences.facet(surface.sides[k]));
        std::vector<int> regions(1, surface.regions[std::size_t(surface.regions_of_sides[k][0])]);
        assert(regions[0] == grid.regions[surface.sides[k] / 4]);
        if(surface.regions_of_sides[k][1] != 0)
          regions.push_back(surface.regions[std::size_t(surface.regions_of_sides[k][1])]);
        assert(std::is_permutation(regions.begin(), regions.end(), expected.at(sorted(f)).begin(),
                                   expected.at(sorted(f)).end()));
      }
      std::set<std::array<std::size_t, 2> > edges;
      for(const std::size_t c : holes.cells(h))
        for(const std::size_t u : grid.tetrahedra[c])
          for(const std::size_t v : grid.tetrahedra[c])
            if(u < v && constraints.is_constrained_edge({{ u, v }}))
              edges.insert({{ u, v }});
      assert(surface.edges.size() == edges.size());
    }
  }
}

// A tetrahedron around a smaller one: sides that fit, and those that contradict each other.
void test_labels()
{
  typedef CGAL::Boundary_constrained_mesh_triangulation_3<Epick>::type Tr;
  typedef Tr::Vertex_handle Vertex_handle;
  typedef std::array<Vertex_handle, 3> Vertex_triple;
  Tr tr;
  std::array<Vertex_handle, 8> v;
  for(std::size_t k = 0; k < 8; ++k)
  {
    const double scale = k < 4 ? 10 : 1;
    v[k] = tr.insert(Epick::Point_3(k % 4 == 1 ? 3 * scale : - scale, k % 4 == 2 ? 3 * scale : - scale,
                                    k % 4 == 3 ? 3 * scale : - scale));
  }
  std::vector<Vertex_triple> facets;
  for(const std::size_t k : { 0, 4 })
    for(std::size_t i = 0; i < 4; ++i)
    {
      Vertex_triple f = {{ v[k + (i + 1) % 4], v[k + (i + 2) % 4], v[k + (i + 3) % 4] }};
      if(CGAL::orientation(f[0]->point(), f[1]->point(), f[2]->point(), v[k + i]->point()) == CGAL::NEGATIVE)
        std::swap(f[0], f[1]);
      facets.push_back(f);
    }
  std::vector<std::array<int, 2> > regions(8, {{ 1, 0 }});
  std::fill(regions.begin() + 4, regions.end(), std::array<int, 2>{{ 2, 1 }});
  assert(internal::Label_hole_3<Tr>(tr)(facets, regions));
  std::size_t numbers[3] = { 0, 0, 0 };
  for(const auto c : tr.all_cell_handles())
  {
    ++numbers[c->subdomain_index()];
    const bool is_small = c->has_vertex(v[4]) && c->has_vertex(v[5]) && c->has_vertex(v[6]) && c->has_vertex(v[7]);
    assert(c->subdomain_index() == (tr.is_infinite(c) ? 0 : is_small ? 2 : 1));
    for(int i = 0; i < 4; ++i)
      assert(c->is_facet_on_surface(i) == (c->subdomain_index() != c->neighbor(i)->subdomain_index()));
  }
  assert(numbers[0] == 4 && numbers[1] > 4 && numbers[2] == 1);

  // a facet that is turned over, wrong regions inside, and all of it inside out
  for(std::size_t k = 0; k < 8; ++k)
  {
    auto wrong = facets;
    std::swap(wrong[k][0], wrong[k][1]);
    assert(! internal::Label_hole_3<Tr>(tr)(wrong, regions));
    auto other = regions;
    other[k][k < 4 ? 0 : 1] = 3;
    assert(! internal::Label_hole_3<Tr>(tr)(facets, other));
  }
  for(auto& r : regions)
    std::swap(r[0], r[1]);
  assert(! internal::Label_hole_3<Tr>(tr)(facets, regions));
}

// Even grids have their sizes, whatever lies flat in them, and flat ones have some.
void test_old_sizes()
{
  Moved_grid grid(4);
  std::vector<char> is_bad(grid.tetrahedra.size(), false);
  std::vector<std::size_t> cells(grid.tetrahedra.size());
  std::iota(cells.begin(), cells.end(), std::size_t(0));
  const Incidences incidences(grid.places.size(), grid.tetrahedra);
  const double mean = (3 + 2 * std::sqrt(2.) + std::sqrt(3.)) / 6; // of the edges of each cell
  const auto size_at = [&](const double x)
  {
    return internal::Old_sizes_3(mesh_of<Epick>(grid), incidences, is_bad, cells)({{ x, x, x }});
  };
  for(const double x : { 1., 1.3, 2., 2.5 })
    assert(std::abs(size_at(x) - mean) < 0.3 * mean);

  // a cell that is stretched, and known to be bad, does not matter
  const double before = size_at(2.);
  const std::size_t v = grid.vertex(2, 2, 2);
  for(const std::size_t c : incidences.cells(v))
    is_bad[c] = true;
  grid.places[v] = {{ 1000, 0, 0 }};
  assert(std::abs(size_at(2.1) - before) < 0.3 * mean);

  for(auto& p : grid.places)
    p[1] = 0;
  is_bad.assign(is_bad.size(), true);
  assert(size_at(1.) > 0.1 && size_at(1.) < 100);
}

template <typename FT>
CGAL::Exact_rational rational(const FT& x) { return CGAL::Exact_rational(CGAL::exact(x)); }

inline CGAL::Exact_rational rational(const double x) { return CGAL::Exact_rational(x); }

// Every place in the grid is found in a positive cell that contains it, and is what its coordinates say.
template <typename Kernel>
void test_old_places(const double distance, const double scale, const double offset)
{
  typedef typename Kernel::Point_3 Point;
  std::mt19937 rng(9);
  Moved_grid grid(4);
  grid.set_region({{ 0, 0, 0 }}, {{ 2, 4, 4 }}, 7);
  grid.shake(rng, distance);
  for(auto& p : grid.places)
    for(double& x : p)
      x = x * scale + offset;
  const auto mesh = mesh_of<Kernel>(grid);
  std::vector<std::size_t> cells(grid.tetrahedra.size());
  std::iota(cells.begin(), cells.end(), std::size_t(0));
  const Incidences incidences(grid.places.size(), grid.tetrahedra);
  Hole_cells holes(grid.tetrahedra, incidences);
  for(const std::size_t c : cells)
    holes.add(c);
  holes.form_holes();
  internal::Locate_in_hole_3<Kernel> locate(mesh, incidences, holes, cells);
  assert(incidences.has_vertex(locate.cell_at(5), 5));
  for(int run = 0; run < 400; ++run)
  {
    std::array<double, 3> x;
    for(double& y : x)
      y = random_int(rng, 4000) / 1000. * scale + offset;
    Point p(x[0], x[1], x[2]);
    if(run % 4 == 0) // at a vertex, or on an edge
      p = CGAL::midpoint(mesh.points[std::size_t(random_int(rng, 125))],
                         mesh.points[std::size_t(random_int(rng, 125))]);
    if(p.x() == 2 * scale + offset || p.x() < offset || p.x() > 4 * scale + offset || p.y() < offset ||
       p.y() > 4 * scale + offset || p.z() < offset || p.z() > 4 * scale + offset)
      continue; // both regions, or midpoints of vertices that left the grid
    const int region = p.x() < 2 * scale + offset ? 7 : 1;
    const std::size_t start = run % 3 == 0 ? locate.none : std::size_t(random_int(rng, 384));
    const auto location = locate(p, region, start);
    if(distance == 0) // cells do not overlap: the way makes no difference, unless p is on a boundary
      assert(location.cell == locate(p, region, locate.none).cell || *std::min_element(
               location.coordinates.begin(), location.coordinates.end()) == 0);
    assert(location.cell < grid.tetrahedra.size() && grid.regions[location.cell] == region);
    const Tetrahedron& t = grid.tetrahedra[location.cell];
    assert(CGAL::orientation(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]])
           == CGAL::POSITIVE);
    double sum = 0;
    std::array<double, 3> q = {{ 0, 0, 0 }};
    for(std::size_t i = 0; i < 4; ++i)
    {
      std::array<Point, 4> corners = {{ mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]] }};
      corners[i] = p;
      assert(CGAL::orientation(corners[0], corners[1], corners[2], corners[3]) != CGAL::NEGATIVE);
      assert(location.coordinates[i] >= 0);
      sum += location.coordinates[i];
      for(std::size_t j = 0; j < 3; ++j)
        q[j] += location.coordinates[i] * (grid.places[t[i]][j] - offset);
    }
    assert(std::abs(sum - 1) < 1e-12);
    for(std::size_t j = 0; j < 3; ++j)
      assert(std::abs(q[j] - (CGAL::to_double(p[int(j)]) - offset)) <= 1e-9 * scale);
  }
  for(const std::size_t start : { std::size_t(-1), std::size_t(0), std::size_t(200) })
    assert(locate(Point(offset - scale, offset, offset), 7, start).cell == locate.none);
}

// A cell whose thickness is a few of the last bits: only exact numbers tell the coordinates.
void test_old_places_in_thin_cell()
{
  typedef Epick::Point_3 Point;
  const double e = std::ldexp(1., -50);
  internal::Moved_mesh_3<Point> mesh;
  mesh.points = { Point(1, 1, 1), Point(2, 1, 1 + e), Point(1, 2, 1 + 2 * e), Point(1.25, 1.25, 1 + 4 * e) };
  mesh.tetrahedra = { {{ 0, 1, 2, 3 }} };
  mesh.regions = { 1 };
  const Incidences incidences(4, mesh.tetrahedra);
  Hole_cells holes(mesh.tetrahedra, incidences);
  holes.add(0);
  holes.form_holes();
  internal::Locate_in_hole_3<Epick> locate(mesh, incidences, holes, holes.cells(0));
  const Point p(1.25, 1.25, 1 + 2 * e);
  const auto location = locate(p, 1, 0);
  assert(location.cell == 0);
  // p is on the segment from the fourth vertex to the place (1.25, 1.25, 1 + 0.75 e) on the opposite facet
  const double w = (2 - 0.75) / (4 - 0.75);
  assert(std::abs(location.coordinates[3] - w) < 1e-15);
  assert(std::abs(location.coordinates[1] - 0.25 * (1 - w)) < 1e-15);
  assert(std::abs(location.coordinates[2] - 0.25 * (1 - w)) < 1e-15);
}

int main()
{
  test_incidences();
  test_incidences_of_nonmanifold_facet();
  test_bad_cells();
  test_holes_that_grow();
  test_surface_of_hole();
  test_labels();
  test_old_sizes();
  for(const double distance : { 0., 0.6, 2. })
  {
    test_old_places<Epick>(distance, 1, 0);
#ifndef BR3_TEST_EPICK_ONLY
    test_old_places<Epeck>(distance, 1, 0);
#endif
  }
  test_old_places<Epick>(0.6, 1e-150, 0);
  test_old_places<Epick>(0.6, 1, 1e5);
  test_old_places_in_thin_cell();
  return EXIT_SUCCESS;
}
