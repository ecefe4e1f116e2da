// Components of cells by flood fill, against a reference that passes over all the facets until nothing changes.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "random_triangulations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cassert>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_3<K>                   Tr;
typedef Tr::Cell_handle                                     Cell_handle;
typedef Tr::Facet                                           Facet;

// A triangulation with facets that are closed, some of them from one side only.
struct Scene
{
  Tr tr;
  std::set<Facet> closed;

  bool is_open(const Cell_handle c, const int i) const { return closed.count(Facet(c, i)) == 0; }
};

Scene random_scene(const unsigned seed, const int percent_closed, const bool is_symmetric)
{
  Scene scene;
  std::mt19937 rng(seed);
  for(const auto& p : br3_test::random_points(30, 9, rng))
    scene.tr.insert(K::Point_3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)));
  assert(scene.tr.dimension() == 3);
  for(const Facet& f : scene.tr.all_facets())
    if(br3_test::random_int(rng, 100) < percent_closed)
    {
      scene.closed.insert(f);
      if(is_symmetric || br3_test::random_int(rng, 2) == 0)
        scene.closed.insert(scene.tr.mirror_facet(f));
    }
  return scene;
}

// The definition: what one pass over all the facets adds to the seed, until one adds nothing.
std::set<Cell_handle> reached_by_passes(const Scene& scene, const Cell_handle seed)
{
  std::set<Cell_handle> result = { seed };
  for(std::size_t before = 0; before != result.size(); )
  {
    before = result.size();
    for(const Cell_handle c : scene.tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
        if(result.count(c) == 1 && scene.is_open(c, i))
          result.insert(c->neighbor(i));
  }
  return result;
}

// The cells in the order in which they are added.
std::vector<Cell_handle> filled(const Scene& scene, const Cell_handle seed)
{
  std::vector<Cell_handle> order;
  std::set<Cell_handle> known;
  const auto is_open = [&](const Cell_handle c, const int i)
  {
    assert(known.count(c) == 1); // nobody is asked about cells that were not reached
    return scene.is_open(c, i);
  };
  const auto add = [&](const Cell_handle c)
  {
    const bool is_new = known.insert(c).second;
    if(is_new)
      order.push_back(c);
    return is_new;
  };
  internal::flood_fill(seed, is_open, add);
  return order;
}

void test_against_passes(const Scene& scene)
{
  for(const Cell_handle seed : scene.tr.all_cell_handles())
  {
    const std::vector<Cell_handle> order = filled(scene, seed);
    assert(order.front() == seed);
    assert(std::set<Cell_handle>(order.begin(), order.end()) == reached_by_passes(scene, seed));
    assert(order == filled(scene, seed));
  }
}

// All the components, one after the other with common marks. Returns their number.
int test_components(const Scene& scene)
{
  std::map<Cell_handle, int> component;
  int number_of_components = 0;
  const auto is_open = [&](const Cell_handle c, const int i) { return scene.is_open(c, i); };
  const auto add = [&](const Cell_handle c) { return component.emplace(c, number_of_components).second; };
  for(const Cell_handle c : scene.tr.all_cell_handles())
    if(component.count(c) == 0)
    {
      internal::flood_fill(c, is_open, add);
      ++number_of_components;
    }
  for(const Cell_handle seed : scene.tr.all_cell_handles())
  {
    const std::set<Cell_handle> expected = reached_by_passes(scene, seed);
    for(const Cell_handle c : scene.tr.all_cell_handles())
      assert((component[c] == component[seed]) == (expected.count(c) == 1));
  }
  return number_of_components;
}

// Cells that are known before stop the flood, a seed that is known stops it at once.
void test_known_cells(const Scene& scene)
{
  const Cell_handle seed = scene.tr.infinite_cell();
  int number_of_calls = 0;
  const auto is_open = [&](Cell_handle, int) { ++number_of_calls; return true; };
  internal::flood_fill(seed, is_open, [](Cell_handle) { return false; });
  assert(number_of_calls == 0);
  internal::flood_fill(seed, is_open, [&](const Cell_handle c) { return c == seed && number_of_calls == 0; });
  assert(number_of_calls == 4);
}

int main()
{
  for(const unsigned seed : { 1u, 2u, 3u })
    for(const int percent : { 0, 20, 40, 60, 100 })
    {
      const Scene scene = random_scene(seed, percent, true);
      test_against_passes(scene);
      const int number_of_components = test_components(scene);
      assert(percent != 0 || number_of_components == 1);
      assert(percent < 60 || number_of_components > 1);
      assert(percent != 100 || number_of_components == static_cast<int>(scene.tr.tds().number_of_cells()));
      test_against_passes(random_scene(seed, percent, false));
      test_known_cells(scene);
    }
  std::cout << "cells are reached" << std::endl;
  return 0;
}
