// Edges inside that are far too long: how they are found, removed, and divided where they cannot be removed; in meshes
// that are far from Delaunay, where field points alone leave such edges.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "grid_scene_br3.h"
#include "mesh_validity_br3.h"
#include "random_numbers_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Remove_long_edge_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/shape/Cell_shape_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_field_points.h>
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
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
namespace parameters = CGAL::parameters;
typedef CGAL::Exact_predicates_inexact_constructions_kernel       K;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type  Tr;
typedef Tr::Cell_handle                                           Cell_handle;
typedef Tr::Vertex_handle                                         Vertex_handle;
typedef Tr::Edge                                                  Edge;
typedef std::pair<Vertex_handle, Vertex_handle>                   Vertex_pair;

// A block of points in the places of a grid, or near them where no surface is, maybe cut into two regions; its cells
// are flipped at random.
struct Scene
  : public br3_test::Grid_scene<Tr>
{
  typedef std::map<std::set<Vertex_handle>, std::array<int, 3> > Walls;

  Scene(const int n, const unsigned seed, const int number_of_flips, const bool is_cut) : br3_test::Grid_scene<Tr>(0)
  {
    std::mt19937 rng(seed);
    const auto moved = [&](const int x, const bool is_on_surface)
    {
      return x == 0 || x == n || is_on_surface ? x : x + 0.25 * (br3_test::random_int(rng, 1001) - 500) / 500.;
    };
    for(int x = 0; x <= n; ++x)
      for(int y = 0; y <= n; ++y)
        for(int z = 0; z <= n; ++z)
        {
          const bool is_on_side = x == 0 || x == n || y == 0 || y == n || z == 0 || z == n;
          const bool is_on_cut = is_cut && x == 2;
          const double px = moved(x, is_on_side || is_on_cut), py = moved(y, is_on_side || is_on_cut);
          tr.insert(Point(px, py, moved(z, is_on_side || is_on_cut)));
        }
    add_box({{ 0, 0, 0 }}, {{ n, n, n }}, true);
    if(is_cut)
      add_rectangle(0, {{ 2, 0, 0 }}, {{ 2, n, n }}, true);
    std::set<std::set<Vertex_handle> > surface;
    for(const auto& f : facets)
      surface.insert({ f[0], f[1], f[2] });
    for(int k = 0; k < number_of_flips; ++k)
      flip(random_cell(rng), br3_test::random_int(rng, 4), surface);
    const int number_of_regions = CGAL::mark_domain(tr, facets);
    assert(number_of_regions == (is_cut ? 2 : 1) && br3_test::is_valid_mesh(tr));
  }

  static bool is_wall(const Cell_handle c, const int i)
  {
    return c->is_facet_on_surface(i) || c->subdomain_index() != c->neighbor(i)->subdomain_index();
  }

  bool is_at_wall(const Edge& e) const
  {
    auto f = tr.incident_facets(e);
    const auto first = f;
    do
      if(is_wall(f->first, f->second))
        return true;
    while(++f != first);
    return false;
  }

  std::vector<Edge> edges_inside() const
  {
    std::vector<Edge> result;
    for(const Edge& e : tr.finite_edges())
      if(! is_at_wall(e))
        result.push_back(e);
    return result;
  }

  double length(const Edge& e) const { return std::sqrt(tr.segment(e).squared_length()); }

  Walls walls() const
  {
    Walls result;
    for(const auto& f : tr.finite_facets())
      if(is_wall(f.first, f.second))
      {
        const auto v = internal::facet_vertices(f.first, f.second);
        const int r = f.first->subdomain_index(), s = f.first->neighbor(f.second)->subdomain_index();
        result[{ v[0], v[1], v[2] }] = {{ (std::min)(r, s), (std::max)(r, s), f.first->surface_patch_index(f.second) }};
      }
    return result;
  }

  std::map<int, double> volumes() const
  {
    std::map<int, double> result;
    for(const Cell_handle c : tr.finite_cell_handles())
      result[c->subdomain_index()] += tr.tetrahedron(c).volume();
    return result;
  }

private:
  Cell_handle random_cell(std::mt19937& rng) const
  {
    const std::vector<Cell_handle> cells(tr.finite_cell_handles().begin(), tr.finite_cell_handles().end());
    return cells[br3_test::random_int(rng, static_cast<int>(cells.size()))];
  }

  // Removes no facet of the surface.
  void flip(const Cell_handle c, const int i, const std::set<std::set<Vertex_handle> >& surface)
  {
    const auto is_on_surface = [&](const Cell_handle d, const int k)
    {
      const auto v = internal::facet_vertices(d, k);
      return surface.count({ v[0], v[1], v[2] }) > 0;
    };
    if(! is_on_surface(c, i) && tr.flip(c, i))
      return;
    for(int j = 0; j < 4; ++j)
      if(j != i)
      {
        bool is_free = true;
        auto f = tr.incident_facets(c, i, j);
        const auto first = f;
        do
          is_free = is_free && ! is_on_surface(f->first, f->second);
        while(++f != first);
        if(is_free && tr.flip(c, i, j))
          return;
      }
  }
};

void test_edges_of_tetrahedra()
{
  std::mt19937 rng(1);
  for(int k = 0; k < 500; ++k)
  {
    std::array<internal::Coordinates_3, 4> p; // on a small grid, so that many edges are equal
    for(auto& x : p)
      x = {{ double(br3_test::random_int(rng, 3)), double(br3_test::random_int(rng, 3)),
             double(br3_test::random_int(rng, 3)) }};
    std::vector<double> lengths;
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
        lengths.push_back(std::hypot(p[i][0] - p[j][0], p[i][1] - p[j][1], p[i][2] - p[j][2]));
    std::sort(lengths.rbegin(), lengths.rend());
    const auto edges = internal::edges_from_long_to_short(p);
    std::set<std::set<int> > pairs;
    for(int n = 0; n < 6; ++n)
    {
      const auto& e = edges[n];
      assert(std::abs(e.length - lengths[n]) < 1e-12 && e.length == internal::distance(p[e.i], p[e.j]));
      assert(pairs.insert({ e.i, e.j }).second && e.i != e.j);
      const auto m = internal::midpoint(p[e.i], p[e.j]);
      assert(internal::distance(m, p[e.i]) == e.length / 2 && internal::distance(m, p[e.j]) == e.length / 2);
    }
    assert(internal::longest_edge(p).length == edges[0].length);
    for(int corner = 0; corner < 4; ++corner)
    {
      double longest = 0;
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          if(i != corner && j != corner)
            longest = (std::max)(longest, internal::distance(p[i], p[j]));
      assert(internal::longest_edge_of_facet(p, corner) == longest);
    }
  }
}

struct Counting_visitor
  : public internal::Mesh_visitor_3<Tr>
{
  void before_cells_removal(const Cells& cells) override { change -= int(cells.size()); }
  void after_cells_creation(const Cells& cells) override { change += int(cells.size()); }
  int change = 0;
};

// Edges that come are shorter; what must stay stays, and the domain and the visitor know the cells.
void test_removal()
{
  int number_of_removed = 0, number_of_others = 0;
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    Scene scene(4, seed, 2000, true);
    std::set<Cell_handle> selected(scene.tr.finite_cell_handles().begin(), scene.tr.finite_cell_handles().end());
    internal::Selected_domain_3<Tr> domain(scene.tr);
    domain.select(CGAL::make_boolean_property_map(selected));
    Counting_visitor visitor;
    internal::Remove_long_edge_3<Tr> remove(scene.tr, domain, visitor);
    const auto walls = scene.walls();
    const auto volumes = scene.volumes();
    int number_of_cells = static_cast<int>(scene.tr.number_of_finite_cells());
    std::vector<std::pair<Vertex_pair, double> > edges;
    for(const Edge& e : scene.edges_inside())
      edges.push_back({ { e.first->vertex(e.second), e.first->vertex(e.third) }, scene.length(e) });
    for(const auto& [ends, length] : edges)
    {
      Edge e;
      if(! scene.tr.tds().is_edge(ends.first, ends.second, e.first, e.second, e.third) || scene.is_at_wall(e))
        continue;
      std::set<std::set<Vertex_handle> > before;
      for(const Edge& x : scene.tr.finite_edges())
        before.insert({ x.first->vertex(x.second), x.first->vertex(x.third) });
      const bool is_done = remove(e);
      ++(is_done ? number_of_removed : number_of_others);
      assert(is_done != remove.new_cells().empty());
      for(const Edge& x : scene.tr.finite_edges())
        if(before.count({ x.first->vertex(x.second), x.first->vertex(x.third) }) == 0)
          assert(is_done && scene.length(x) < 0.9 * length);
      number_of_cells += visitor.change;
      visitor.change = 0;
      assert(number_of_cells == static_cast<int>(scene.tr.number_of_finite_cells()));
    }
    assert(br3_test::is_valid_mesh(scene.tr) && scene.walls() == walls);
    for(const auto& v : volumes)
      assert(std::abs(scene.volumes().at(v.first) - v.second) < 1e-9);
    assert(selected == std::set<Cell_handle>(scene.tr.finite_cell_handles().begin(),
                                             scene.tr.finite_cell_handles().end()));
  }
  std::cout << number_of_removed << " edges removed, or with less cells, " << number_of_others << " not" << std::endl;
  assert(number_of_removed > 50 && number_of_others > 50);
}

// Twelve meshes far from Delaunay. With field points alone, 324 of their edges inside are longer than twice the size,
// and the longest one is 4.2 times as long.
void test_filling()
{
  typedef CGAL::Boolean_property_map<std::set<Cell_handle> > Selection;
  const double size = 0.72;
  std::size_t number_of_edges = 0, number_of_long_edges = 0;
  double longest = 0;
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    Scene scene(5, seed, 6000, false);
    std::set<Cell_handle> selected(scene.tr.finite_cell_handles().begin(), scene.tr.finite_cell_handles().end());
    const auto walls = scene.walls();
    const auto result =
      CGAL::insert_field_points(scene.tr, size, parameters::cell_is_selected_map(Selection(selected)));
    assert(result && br3_test::is_valid_mesh(scene.tr) && scene.walls() == walls);
    assert(selected == std::set<Cell_handle>(scene.tr.finite_cell_handles().begin(),
                                             scene.tr.finite_cell_handles().end()));
    for(const Edge& e : scene.edges_inside())
    {
      ++number_of_edges;
      number_of_long_edges += scene.length(e) > 2 * size;
      longest = (std::max)(longest, scene.length(e) / size);
    }
  }
  std::cout << number_of_long_edges << " of " << number_of_edges << " edges are longer than twice the size, the "
            << "longest one " << longest << " times it" << std::endl;
  assert(number_of_edges > 10000 && number_of_long_edges < 50 && longest < 3.8);
}

int main()
{
  test_edges_of_tetrahedra();
  test_removal();
  test_filling();
  return EXIT_SUCCESS;
}
