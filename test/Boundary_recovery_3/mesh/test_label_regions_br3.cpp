// Regions that facets separate: inside, outside, voids, shared facets, sheets, gaps.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "grid_scene_br3.h"

#include <CGAL/Boundary_recovery_3/label_regions.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <iostream>
#include <map>
#include <vector>

template <typename Kernel>
struct Scene
  : public br3_test::Grid_scene<CGAL::Delaunay_triangulation_3<Kernel> >
{
  typedef br3_test::Grid_scene<CGAL::Delaunay_triangulation_3<Kernel> > Base;
  typedef typename Base::Cell_handle                                    Cell_handle;
  using Base::Base;
  using Base::facets;
  using Base::tr;

  std::map<Cell_handle, int> regions;

  int label()
  {
    regions.clear();
    const int n = CGAL::Boundary_recovery_3::label_regions(tr, facets, boost::make_assoc_property_map(regions));
    assert(regions.size() == tr.number_of_finite_cells());
    for(const auto& entry : regions)
      assert(! tr.is_infinite(entry.first) && entry.second >= 0 && entry.second <= n);
    return n;
  }

  // six times the volume of a region
  typename Kernel::FT volume(const int region) const
  {
    typename Kernel::FT sum = 0;
    for(const auto& entry : regions)
      if(entry.second == region)
        sum += 6 * CGAL::volume(entry.first->vertex(0)->point(), entry.first->vertex(1)->point(),
                                entry.first->vertex(2)->point(), entry.first->vertex(3)->point());
    return sum;
  }
};

template <typename Kernel>
void test_one_cube()
{
  for(const bool outward : { true, false })
  {
    Scene<Kernel> scene(3);
    scene.add_box({{1, 1, 1}}, {{2, 2, 2}}, outward);
    assert(scene.facets.size() == 12);
    assert(scene.label() == 1);
    assert(scene.volume(1) == 6 && scene.volume(0) == 6 * 26);
  }

  Scene<Kernel> whole(2); // the surface is the convex hull
  whole.add_box({{0, 0, 0}}, {{2, 2, 2}}, true);
  assert(whole.label() == 1 && whole.volume(0) == 0 && whole.volume(1) == 48);

  std::swap(whole.facets[5][0], whole.facets[5][1]); // orientations that disagree: parity decides
  assert(whole.label() == 1 && whole.volume(1) == 48);
}

template <typename Kernel>
void test_cube_in_cube()
{
  Scene<Kernel> two(3), hollow(3), odd(3);
  two.add_box({{0, 0, 0}}, {{3, 3, 3}}, true);
  two.add_box({{1, 1, 1}}, {{2, 2, 2}}, true);
  assert(two.label() == 2);
  assert(two.volume(1) == 6 * 26 && two.volume(2) == 6 && two.volume(0) == 0);
  std::reverse(two.facets.begin(), two.facets.end());
  for(int i = 0; i < 12; ++i) // each facet of the inner cube comes first once: first the region behind it
  {
    assert(two.label() == 2);
    assert(two.volume(1) == 6 && two.volume(2) == 6 * 26);
    std::rotate(two.facets.begin(), two.facets.begin() + 1, two.facets.begin() + 12);
  }

  hollow.add_box({{0, 0, 0}}, {{3, 3, 3}}, true);
  hollow.add_box({{1, 1, 1}}, {{2, 2, 2}}, false);
  assert(hollow.label() == 1);
  assert(hollow.volume(1) == 6 * 26 && hollow.volume(0) == 6);

  // a sheet that ends inside does not make a region of the void
  hollow.add_rectangle(2, {{2, 2, 2}}, {{3, 3, 2}}, true);
  assert(hollow.label() == 1 && hollow.volume(0) == 6);

  odd.add_box({{0, 0, 0}}, {{3, 3, 3}}, true);
  odd.add_box({{1, 1, 1}}, {{2, 2, 2}}, true);
  std::swap(odd.facets.back()[0], odd.facets.back()[1]); // no winding number any more: parity, which makes a void
  assert(odd.label() == 1 && odd.volume(1) == 6 * 26);
}

template <typename Kernel>
void test_regions_that_share_a_face()
{
  Scene<Kernel> scene(4);
  scene.add_box({{0, 0, 0}}, {{2, 4, 4}}, true);
  const std::size_t n = scene.facets.size();
  scene.add_box({{2, 0, 0}}, {{4, 4, 4}}, true);
  // the facets of the shared face are given once only
  scene.facets.erase(std::remove_if(scene.facets.begin() + n, scene.facets.end(), [](const auto& t)
    { return std::all_of(t.begin(), t.end(), [](const auto v) { return v->point().x() == 2; }); }),
    scene.facets.end());
  assert(scene.label() == 2);
  assert(scene.volume(1) == 6 * 32 && scene.volume(2) == 6 * 32 && scene.volume(0) == 0);

  Scene<Kernel> twice(4); // given twice, in both orientations, they are a wall all the same
  twice.add_box({{0, 0, 0}}, {{2, 4, 4}}, true);
  twice.add_box({{2, 0, 0}}, {{4, 4, 4}}, true);
  assert(twice.label() == 2);
  assert(twice.volume(1) == 6 * 32 && twice.volume(2) == 6 * 32);

  Scene<Kernel> apart(4); // two cubes that touch in an edge
  apart.add_box({{0, 0, 0}}, {{2, 2, 2}}, true);
  apart.add_box({{2, 2, 0}}, {{4, 4, 2}}, true);
  assert(apart.label() == 2);
  assert(apart.volume(1) == 48 && apart.volume(2) == 48 && apart.volume(0) == 6 * 48);
}

template <typename Kernel>
void test_sheets_and_gaps()
{
  Scene<Kernel> sheet(3);
  sheet.add_box({{0, 0, 0}}, {{3, 3, 3}}, true);
  sheet.add_rectangle(2, {{1, 1, 1}}, {{2, 2, 1}}, true);
  assert(sheet.facets.size() == 6 * 18 + 2);
  assert(sheet.label() == 1 && sheet.volume(1) == 6 * 27);

  Scene<Kernel> cut(3); // a sheet from wall to wall separates two regions
  cut.add_box({{0, 0, 0}}, {{3, 3, 3}}, true);
  cut.add_rectangle(2, {{0, 0, 1}}, {{3, 3, 1}}, true);
  assert(cut.label() == 2);
  assert(cut.volume(1) + cut.volume(2) == 6 * 27);
  assert((std::min)(cut.volume(1), cut.volume(2)) == 6 * 9);

  Scene<Kernel> open(3);
  open.add_box({{0, 0, 0}}, {{3, 3, 3}}, true);
  open.facets.pop_back();
  assert(open.label() == 0 && open.volume(0) == 6 * 27);

  // a facet that the triangulation lacks is such a gap
  Scene<Kernel> lacking(3);
  lacking.add_box({{1, 1, 1}}, {{2, 2, 2}}, true);
  for(const auto v : lacking.tr.finite_vertex_handles())
    if(v->point() == typename Scene<Kernel>::Point(3, 3, 3))
      lacking.facets[7][0] = v;
  assert(lacking.label() == 0);

  lacking.facets.clear();
  assert(lacking.label() == 0);
}

template <typename Kernel>
void test_small_dimensions()
{
  typedef CGAL::Delaunay_triangulation_3<Kernel> Triangulation;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef std::vector<std::array<typename Triangulation::Vertex_handle, 3> > Facets;
  Triangulation tr;
  std::map<Cell_handle, int> regions;
  for(int i = 0; i < 4; ++i)
  {
    assert(tr.dimension() < 3);
    assert(CGAL::Boundary_recovery_3::label_regions(tr, Facets(), boost::make_assoc_property_map(regions)) == 0);
    assert(regions.empty());
    tr.insert(typename Kernel::Point_3(i % 2, i / 2, 0));
  }
}

// the same cells get the same numbers in two runs on different memory
template <typename Kernel>
void test_determinism()
{
  std::vector<int> first;
  std::vector<Scene<Kernel> > keep; // keeps memory in use, so that addresses differ
  keep.reserve(3);
  for(int run = 0; run < 3; ++run)
  {
    keep.emplace_back(4);
    Scene<Kernel>& scene = keep.back();
    scene.add_box({{2, 2, 2}}, {{4, 4, 4}}, true);
    scene.add_box({{0, 0, 0}}, {{2, 2, 2}}, true);
    scene.add_box({{0, 3, 0}}, {{1, 4, 4}}, true);
    assert(scene.label() == 3);
    std::vector<int> numbers;
    for(const auto c : scene.tr.finite_cell_handles())
      numbers.push_back(scene.regions[c]);
    if(run == 0)
      first = numbers;
    assert(numbers == first);
  }
}

template <typename Kernel>
void test_kernel()
{
  test_one_cube<Kernel>();
  test_cube_in_cube<Kernel>();
  test_regions_that_share_a_face<Kernel>();
  test_sheets_and_gaps<Kernel>();
  test_small_dimensions<Kernel>();
  test_determinism<Kernel>();
}

int main()
{
  test_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>();
  test_kernel<CGAL::Exact_predicates_exact_constructions_kernel>();
  std::cout << "regions are right" << std::endl;
  return 0;
}
