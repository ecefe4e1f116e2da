// Cavities of field points against a naive search, on grids with other regions, sheets and edges; and their stars:
// valid, with the regions, walls and marks of before.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "grid_scene_br3.h"
#include "mesh_validity_br3.h"
#include "random_numbers_br3.h"
#include "time_growth_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Insert_field_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/mark_domain.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <new>
#include <random>
#include <set>
#include <utility>
#include <vector>

std::size_t largest_allocation = 0;

// (Inlined, GCC would take malloc() and free() for a mismatch.)
[[gnu::noinline]] void* operator new(const std::size_t size)
{
  largest_allocation = (std::max)(largest_allocation, size);
  if(void* const p = std::malloc(size))
    return p;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* const p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* const p, std::size_t) noexcept { std::free(p); }

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact;

template <typename Kernel>
struct Scene
  : public br3_test::Grid_scene<typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type>
{
  typedef br3_test::Grid_scene<typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type> Base;
  typedef typename Base::Triangulation Tr;
  typedef typename Tr::Cell_handle     Cell_handle;
  typedef typename Tr::Vertex_handle   Vertex_handle;
  typedef typename Tr::Point           Point;
  typedef std::set<Cell_handle>        Cells;
  typedef std::pair<Vertex_handle, Vertex_handle> Edge;
  typedef std::set<Edge>               Edges;
  typedef CGAL::Boolean_property_map<Edges> Edge_map;
  typedef internal::Selected_domain_3<Tr> Domain;
  typedef internal::Field_point_cavity_3<Tr> Cavity;
  using Base::tr;
  using Base::facets;

  Edges edges;

  explicit Scene(const int n) : Base(n) { }

  // All regions, with the edges that are listed.
  Domain domain()
  {
    Domain domain(tr);
    domain.constrain_edges(Edge_map(edges));
    return domain;
  }

  // Each cell that the point is in conflict with and that can be reached without crossing a wall.
  Cells reachable_conflicts(const Point& p, const Cell_handle first, bool& is_wall_inside) const
  {
    Cells cells = { first };
    std::vector<Cell_handle> front = { first };
    while(! front.empty())
    {
      const Cell_handle c = front.back();
      front.pop_back();
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle n = c->neighbor(i);
        if(! is_wall(c, i) && is_in_conflict(n, p) && cells.insert(n).second)
          front.push_back(n);
      }
    }
    is_wall_inside = false;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        is_wall_inside = is_wall_inside || (cells.count(c->neighbor(i)) > 0 && is_wall(c, i));
    return cells;
  }

  bool is_star_shaped(const Cells& cells, const Point& p) const
  {
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
      {
        const auto f = internal::facet_vertices(c, i);
        if(cells.count(c->neighbor(i)) == 0
           && CGAL::orientation(f[0]->point(), f[1]->point(), f[2]->point(), p) != CGAL::POSITIVE)
          return false;
      }
    return true;
  }

  // Whether an edge that is listed, or a vertex, is in these cells only.
  bool has_something_inside(const Cells& cells) const
  {
    const auto are_all_around = [&](const auto& has_it)
    {
      bool is_there = false;
      for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
        if(has_it(c))
        {
          is_there = true;
          if(cells.count(c) == 0)
            return false;
        }
      return is_there;
    };
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(are_all_around([&](const Cell_handle d) { return d->has_vertex(c->vertex(i)); }))
          return true;
    for(const Edge& e : edges)
      if(are_all_around([&](const Cell_handle d) { return d->has_vertex(e.first) && d->has_vertex(e.second); }))
        return true;
    return false;
  }

  // The walls, by their vertices, with the regions of both sides and the mark.
  std::map<std::set<Vertex_handle>, std::array<int, 3> > walls() const
  {
    std::map<std::set<Vertex_handle>, std::array<int, 3> > result;
    for(const auto& f : tr.finite_facets())
      if(is_wall(f.first, f.second))
      {
        const auto v = internal::facet_vertices(f.first, f.second);
        const int r = f.first->subdomain_index(), s = f.first->neighbor(f.second)->subdomain_index();
        const auto mirror = tr.mirror_facet(f);
        assert(f.first->surface_patch_index(f.second) == mirror.first->surface_patch_index(mirror.second));
        result[{ v[0], v[1], v[2] }] = {{ (std::min)(r, s), (std::max)(r, s), f.first->surface_patch_index(f.second) }};
      }
    return result;
  }

  std::map<int, double> volumes() const // exact on such grids
  {
    std::map<int, double> result;
    for(const Cell_handle c : tr.finite_cell_handles())
      result[c->subdomain_index()] += CGAL::to_double(6 * tr.tetrahedron(c).volume());
    return result;
  }

  bool are_marks_clear() const
  {
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      if(! c->tds_data().is_clear())
        return false;
    return true;
  }

private:
  static bool is_wall(const Cell_handle c, const int i)
  {
    return c->is_facet_on_surface(i) || c->subdomain_index() != c->neighbor(i)->subdomain_index();
  }

  bool is_in_conflict(const Cell_handle c, const Point& p) const
  {
    return ! tr.is_infinite(c)
        && CGAL::side_of_bounded_sphere(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                                        c->vertex(3)->point(), p) == CGAL::ON_BOUNDED_SIDE;
  }
};

// How often each kind of cavity occurred, so that none is missing in the test.
struct Counts
{
  int whole = 0, shrunk = 0, refused = 0, wall_inside = 0, something_inside = 0;
};

// Tries points with coordinates that are multiples of 1/8 in random cells, from cells that may be others.
template <typename Kernel>
void try_points(Scene<Kernel>& scene, const int number, std::mt19937& rng, Counts& counts)
{
  typedef Scene<Kernel> S;
  internal::Mesh_visitor_3<typename S::Tr> visitor;
  typename S::Domain domain = scene.domain();
  typename S::Cavity cavity(scene.tr, domain);
  internal::Insert_field_point_3<typename S::Tr> insert(scene.tr, domain, visitor);
  for(int k = 0; k < number; ++k)
  {
    std::vector<typename S::Cell_handle> cells;
    for(const auto c : scene.tr.finite_cell_handles())
      if(domain.contains(c))
        cells.push_back(c);
    const auto first = cells[br3_test::random_int(rng, static_cast<int>(cells.size()))];
    std::array<double, 3> x;
    for(int i = 0; i < 3; ++i)
      x[i] = CGAL::to_double(CGAL::centroid(scene.tr.tetrahedron(first))[i]);
    for(double& y : x)
      y = std::round(8 * y + br3_test::random_int(rng, 5) - 2) / 8;
    const typename S::Point p(x[0], x[1], x[2]);

    bool is_wall_inside = false;
    const auto expected = scene.reachable_conflicts(p, first, is_wall_inside);
    const auto walls = scene.walls();
    const auto volumes = scene.volumes();
    const std::size_t number_of_cells = scene.tr.number_of_finite_cells();
    const bool is_found = cavity.find(p, first);
    const std::set<typename S::Cell_handle> found(cavity.cells().begin(), cavity.cells().end());
    if(! is_wall_inside && scene.is_star_shaped(expected, p) && ! scene.has_something_inside(expected))
    {
      assert(is_found && found == expected);
      ++counts.whole;
    }
    else if(is_found)
      ++counts.shrunk;
    else
      ++counts.refused;
    counts.wall_inside += is_wall_inside;
    counts.something_inside += ! is_wall_inside && scene.has_something_inside(expected);
    if(is_found)
    {
      assert(std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
      assert(scene.is_star_shaped(found, p) && ! scene.has_something_inside(found));
      const std::size_t change = cavity.faces().size() - cavity.cells().size();
      const auto v = insert(cavity, p);
      assert(v->point() == p && scene.tr.number_of_finite_cells() == number_of_cells + change);
      assert(br3_test::is_valid_mesh(scene.tr));
    }
    else
      cavity.clear(true);
    assert(scene.are_marks_clear());
    assert(scene.walls() == walls && scene.volumes() == volumes);
    for(const auto& e : scene.edges)
      assert(scene.tr.tds().is_edge(e.first, e.second));
  }
}

template <typename Kernel>
void test(const unsigned seed, Counts& counts)
{
  std::mt19937 rng(seed);
  Scene<Kernel> scene(3);
  scene.add_box({{ 0, 0, 0 }}, {{ 3, 3, 3 }}, true);
  if(seed % 3 == 1)
    scene.add_box({{ 1, 1, 1 }}, {{ 2, 2, 2 }}, true);   // a second region
  else if(seed % 3 == 2)
    for(int axis = 0; axis < 3; ++axis) // sheets
      scene.add_rectangle(axis, {{ 1, 1, 1 }}, {{ axis == 0 ? 1 : 2, axis == 1 ? 1 : 2, axis == 2 ? 1 : 2 }}, true);
  CGAL::mark_domain(scene.tr, scene.facets);
  for(const auto& e : scene.tr.finite_edges())
    if(br3_test::random_int(rng, 30) == 0)
      scene.edges.insert({ e.first->vertex(e.second), e.first->vertex(e.third) });
  try_points(scene, 40, rng, counts);
}

// A tetrahedron with a vertex inside, and a point between that and a corner. The cell behind the vertex is not in
// conflict. If the cavity begins with it nevertheless, as a walk in floating point numbers may want it, all four cells
// are in the cavity: the point sees its faces, but the vertex would be lost.
void test_vertex_inside()
{
  typedef Scene<K> S;
  S scene(0);
  const auto q = scene.tr.finite_vertices_begin(); // the origin
  const auto a = scene.tr.insert(S::Point(4, 0, -1)), b = scene.tr.insert(S::Point(-2, 3, -1));
  const auto c = scene.tr.insert(S::Point(-2, -3, -1)), d = scene.tr.insert(S::Point(0, 0, 8));
  assert(scene.tr.number_of_finite_cells() == 4);
  for(const S::Cell_handle cell : scene.tr.all_cell_handles())
    cell->set_subdomain_index(scene.tr.is_infinite(cell) ? 0 : 1);
  S::Domain domain = scene.domain();
  S::Cavity cavity(scene.tr, domain);
  const S::Point p(0, 0, 3);
  S::Cell_handle behind, before;
  int i, j, k, l;
  assert(scene.tr.is_cell(q, a, b, c, behind, i, j, k, l) && scene.tr.is_cell(q, a, b, d, before, i, j, k, l));
  bool is_wall_inside = false;
  const auto all = scene.reachable_conflicts(p, behind, is_wall_inside);
  assert(all.size() == 4 && scene.is_star_shaped(all, p) && scene.has_something_inside(all));
  assert(! cavity.find(p, behind));
  cavity.clear(true);
  assert(cavity.find(p, before) && cavity.cells().size() == 3);
  cavity.clear(true);
}

// n vertices on a sphere, all of which its center sees. All edges of the hull are constrained.
struct Sphere
{
  typedef Scene<K> S;

  explicit Sphere(const int n)
    : scene(-1), domain(scene.domain()), cavity(scene.tr, domain)
  {
    std::mt19937 rng(1);
    std::vector<S::Point> points;
    while(points.size() < static_cast<std::size_t>(n))
    {
      const double angle = br3_test::random_int(rng, 100000), z = (br3_test::random_int(rng, 20001) - 10000) / 10001.;
      const double r = std::sqrt(1 - z * z);
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    scene.tr.insert(points.begin(), points.end());
    for(const S::Cell_handle c : scene.tr.all_cell_handles())
      c->set_subdomain_index(scene.tr.is_infinite(c) ? 0 : 1);
    for(const S::Cell_handle c : scene.tr.all_cell_handles())
      if(scene.tr.is_infinite(c))
        add_edges(internal::facet_vertices(c, c->index(scene.tr.infinite_vertex())));
    first = scene.tr.locate(center);
  }

  void add_edges(const std::array<S::Vertex_handle, 3>& f)
  {
    for(std::size_t i = 0; i < 3; ++i)
      scene.edges.insert({ f[i], f[(i + 1) % 3] });
  }

  void find()
  {
    assert(cavity.find(center, first));
    assert(cavity.faces().size() > scene.tr.number_of_vertices()); // some points are hidden by flat cells
  }

  // How long it takes to find the cavity.
  double time()
  {
    return br3_test::time_of([&]
    {
      find();
      cavity.clear(true);
    });
  }

  const S::Point center = S::Point(0, 0, 0);
  S scene;
  S::Domain domain;
  S::Cavity cavity;
  S::Cell_handle first;
};

// A large cavity takes no more memory, nor time, than goes with its surface.
void test_large_cavity()
{
  const int n = 4000;
  Sphere sphere(n), small(n / 8);
  assert(br3_test::exponent(small.time(), sphere.time(), 8) < 1.5);
  internal::Mesh_visitor_3<Sphere::S::Tr> visitor;
  internal::Insert_field_point_3<Sphere::S::Tr> insert(sphere.scene.tr, sphere.domain, visitor);
  largest_allocation = 0;
  sphere.find();
  insert(sphere.cavity, sphere.center);
  assert(largest_allocation < std::size_t(1000 * n)); // a table of all pairs has 16 n^2 bytes
  assert(br3_test::is_valid_mesh(sphere.scene.tr));
}

int main()
{
  test_vertex_inside();
  test_large_cavity();
  Counts counts;
  for(unsigned seed = 0; seed < 42; ++seed)
    test<K>(seed, counts);
#ifndef BR3_TEST_EPICK_ONLY
  for(unsigned seed = 42; seed < 45; ++seed)
    test<Exact>(seed, counts);
#endif
  std::cout << "cavities: " << counts.whole << " whole, " << counts.shrunk << " shrunk, " << counts.refused
            << " refused; " << counts.wall_inside << " had a wall inside, " << counts.something_inside
            << " a vertex or an edge" << std::endl;
  assert(counts.whole > 100 && counts.shrunk > 10 && counts.refused > 10);
  assert(counts.wall_inside > 3 && counts.something_inside > 10);
  return EXIT_SUCCESS;
}
