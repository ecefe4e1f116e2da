// mark_domain(): the regions of cells, the patches of facets, and the dimensions of vertices, each found a second time
// by other means; on vertices and cells of ours, and on those of CGAL's packages. And what of a domain is selected,
// what its walls and seams are, and which edges are constrained.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "box_soup_br3.h"
#include "grid_scene_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Mark_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Region_labeller_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_cell_base_3.h>
#include <CGAL/Mesh_vertex_base_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_cell_base_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_vertex_base_3.h>
#include <CGAL/mark_domain.h>
#include <CGAL/property_map.h>
#include <CGAL/Boundary_recovery_3/Boundary_recovery_result_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
using br3_test::Box;

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact;

typedef CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<
          CGAL::Tetrahedral_remeshing::Remeshing_vertex_base_3<K>,
          CGAL::Tetrahedral_remeshing::Remeshing_cell_base_3<K> > > Over_remeshing_bases;

// Those of Mesh_3, for a domain whose patches are no integers.
struct Domain_types
{
  typedef short               Subdomain_index;
  typedef std::pair<int, int> Surface_patch_index;
  typedef std::pair<int, int> Index;
};
typedef CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<
          CGAL::Mesh_vertex_base_3<K, Domain_types, CGAL::Triangulation_vertex_base_3<K> >,
          CGAL::Mesh_cell_base_3<K, Domain_types, CGAL::Triangulation_cell_base_3<K> > > > Over_mesh_bases;

// The number of a patch, as it was before it became one; -1: none.
int number(const int patch) { return patch == 0 ? -1 : patch; }
int number(const std::pair<int, int>& patch) { return patch == std::pair<int, int>() ? -1 : patch.first; }

template <typename Tr>
struct Scene
  : public br3_test::Grid_scene<Tr>
{
  typedef std::array<typename Tr::Vertex_handle, 2> Vertex_pair;
  using br3_test::Grid_scene<Tr>::Grid_scene;
  using br3_test::Grid_scene<Tr>::tr;

  void add(const Box& box, const bool is_outward = true) { this->add_box(box.low, box.high, is_outward); }

  // An edge of the triangulation from a point of the grid, in the order of the cells.
  void add_edge(const std::array<int, 3>& p)
  {
    const auto v = tr.insert(typename Tr::Point(p[0], p[1], p[2])); // which is there
    edges.push_back({{ v, v->cell()->vertex((v->cell()->index(v) + 1) % 4) }});
    if(tr.is_infinite(edges.back()[1]))
      edges.back()[1] = v->cell()->vertex((v->cell()->index(v) + 2) % 4);
  }

  std::vector<Vertex_pair> edges;
};

template <typename Cell_handle>
std::array<long, 3> four_times_centroid(const Cell_handle c)
{
  std::array<long, 3> sum = {{ 0, 0, 0 }};
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 3; ++j)
      sum[j] += static_cast<long>(CGAL::to_double(c->vertex(i)->point()[j]));
  return sum;
}

// `region` says what region four times the centroid of a cell is in. `patches` are numbers, by input position.
template <typename Tr, typename FacetRange>
void check_marks(const Scene<Tr>& scene, const FacetRange& facets, const std::vector<int>& patches,
                 const std::function<int(const std::array<long, 3>&)>& region)
{
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef std::set<Vertex_handle> Vertex_set;
  std::map<Vertex_set, int> patch_of;
  std::map<Vertex_handle, int> dimension, index;
  std::size_t position = 0;
  for(const auto& f : facets)
  {
    const int patch = patches[position++];
    patch_of.emplace(Vertex_set(f.begin(), f.end()), patch);
    for(const Vertex_handle v : f)
      if(dimension.emplace(v, 2).second)
        index[v] = patch;
  }
  std::set<Vertex_handle> known;
  for(std::size_t e = 0; e < scene.edges.size(); ++e)
    for(const Vertex_handle v : scene.edges[e])
      if(known.insert(v).second)
      {
        dimension[v] = 1;
        index[v] = static_cast<int>(e) + 1;
      }

  const Tr& tr = scene.tr;
  std::size_t number_of_sides = 0;
  for(const auto c : tr.all_cell_handles())
  {
    const bool is_infinite = tr.is_infinite(c);
    assert(int(c->subdomain_index()) == (is_infinite ? 0 : region(four_times_centroid(c))));
    for(int i = 0; i < 4; ++i)
    {
      Vertex_set facet;
      for(int j = 0; j < 4; ++j)
        if(j != i)
          facet.insert(c->vertex(j));
      const auto known_patch = patch_of.find(facet);
      assert(number(c->surface_patch_index(i)) == (known_patch == patch_of.end() ? -1 : known_patch->second));
      assert(c->is_facet_on_surface(i) == (known_patch != patch_of.end()));
      number_of_sides += known_patch != patch_of.end();
    }
    for(int i = 0; i < 4 && ! is_infinite; ++i)
    {
      const Vertex_handle v = c->vertex(i);
      const auto known_dimension = dimension.find(v);
      assert(v->in_dimension() == (known_dimension == dimension.end() ? 3 : known_dimension->second));
      typedef std::decay_t<decltype(v->index())> Index; // of CGAL 6, a variant
      if constexpr(std::is_constructible<Index, int>::value)
        assert(v->index() == Index(known_dimension == dimension.end() ? int(c->subdomain_index()) : index[v]));
      else if(v->in_dimension() == 2)
        assert(v->index() == Index(index[v], -index[v])); // it can be made of a patch only
    }
  }
  assert(number_of_sides == 2 * patch_of.size()); // each one is there
}

// Patches that are not numbers.
template <typename Tr, typename FacetRange>
int mark(Tr& tr, const FacetRange& facets, const std::vector<int>& patches,
         const std::vector<std::array<typename Tr::Vertex_handle, 2> >& edges)
{
  if constexpr(std::is_same<std::decay_t<decltype(tr.infinite_cell()->surface_patch_index(0))>, int>::value)
    return CGAL::mark_domain(tr, facets, CGAL::parameters::constrained_edges(edges),
                             CGAL::parameters::face_patch_map(CGAL::make_property_map(patches)));
  else
  {
    std::vector<std::pair<int, int> > pairs;
    for(const int patch : patches)
      pairs.emplace_back(patch, -patch);
    return CGAL::mark_domain(tr, facets, CGAL::parameters::face_patch_map(CGAL::make_property_map(pairs)),
                             CGAL::parameters::constrained_edges(edges));
  }
}

// Marks twice, with different patches: what was there before is overwritten.
template <typename Tr>
void test(Scene<Tr>& scene, const int number_of_regions,
          const std::function<int(const std::array<long, 3>&)>& region)
{
  std::vector<int> patches;
  for(std::size_t i = 0; i < scene.facets.size(); ++i)
    patches.push_back(1000 - 7 * static_cast<int>(i / 2));
  assert(mark(scene.tr, scene.facets, patches, scene.edges) == number_of_regions);
  check_marks(scene, scene.facets, patches, region);

  if constexpr(std::is_same<std::decay_t<decltype(scene.tr.infinite_cell()->surface_patch_index(0))>, int>::value)
  {
    scene.edges.clear();
    assert(CGAL::mark_domain(scene.tr, scene.facets) == number_of_regions);
    for(std::size_t i = 0; i < patches.size(); ++i)
      patches[i] = static_cast<int>(i) + 1;
    check_marks(scene, scene.facets, patches, region);
  }
}

template <typename Tr>
void test_scenes()
{
  const Box big = {{{ 0, 0, 0 }}, {{ 4, 4, 4 }}}, small = {{{ 1, 1, 2 }}, {{ 2, 3, 3 }}},
            beside = {{{ 2, 1, 2 }}, {{ 3, 3, 3 }}};
  const auto in = [](const Box& box)
  {
    return [box](const std::array<long, 3>& p) { return box.contains(p, 4) ? 1 : 0; };
  };

  Scene<Tr> one(4);
  one.add(small);
  one.add_edge({{ 0, 0, 0 }});
  test<Tr>(one, 1, in(small));

  Scene<Tr> nested(4);
  nested.add(big);
  nested.add(small);
  test<Tr>(nested, 2, [&](const auto& p) { return small.contains(p, 4) ? 2 : 1; });

  Scene<Tr> hollow(4);
  hollow.add(big);
  hollow.add(small, false);
  test<Tr>(hollow, 1, [&](const auto& p) { return small.contains(p, 4) ? 0 : 1; });

  Scene<Tr> two(4); // the wall between them is there twice
  two.add(small);
  two.add(beside);
  test<Tr>(two, 2, [&](const auto& p) { return small.contains(p, 4) ? 1 : beside.contains(p, 4) ? 2 : 0; });

  Scene<Tr> sheet(4); // and edges: inside, at the sheet, on the surface, at one vertex
  sheet.add(big);
  sheet.add_rectangle(2, {{ 1, 1, 2 }}, {{ 3, 2, 2 }}, true);
  sheet.add_edge({{ 2, 3, 3 }});
  sheet.add_edge({{ 2, 2, 2 }});
  sheet.add_edge({{ 4, 4, 4 }});
  sheet.add_edge({{ 2, 3, 3 }});
  test<Tr>(sheet, 1, in(big));

  Scene<Tr> open(4);
  open.add(big);
  open.facets.pop_back();
  open.add(small); // facets that agree nowhere: all that is bounded belongs to the domain
  test<Tr>(open, 1, in(small));

  Scene<Tr> gap(4);
  gap.add(big);
  gap.facets.erase(gap.facets.begin() + 3);
  test<Tr>(gap, 0, [](const auto&) { return 0; });
}

// Facets without a patch get one that is free; a facet that is there twice has the patch of the first.
void test_patches()
{
  typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type Tr;
  Scene<Tr> scene(1);
  scene.add({{{ 0, 0, 0 }}, {{ 1, 1, 1 }}});
  assert(scene.facets.size() == 12);
  const auto region = [](const std::array<long, 3>&) { return 1; };

  std::vector<int> patches = { 0, 0, 1, 2, 4, 4, 0, 3, -5, 2, 9, 0 };
  assert(mark(scene.tr, scene.facets, patches, { }) == 1);
  std::replace(patches.begin(), patches.end(), 0, 5);
  check_marks(scene, scene.facets, patches, region);

  patches.assign(12, 0);
  assert(mark(scene.tr, scene.facets, patches, { }) == 1);
  patches.assign(12, 1);
  check_marks(scene, scene.facets, patches, region);

  auto facets = scene.facets; // the same ones again, turned; and others that are no facets, or of no vertices
  for(std::size_t i = 0; i < 12; ++i)
    facets.push_back({{ facets[i][1], facets[i][2], facets[i][0] }});
  facets.push_back({{ facets[0][0], facets[0][0], facets[0][1] }});
  facets.push_back({{ Tr::Vertex_handle(), Tr::Vertex_handle(), Tr::Vertex_handle() }});
  facets.push_back({{ facets[0][0], facets[0][1], scene.tr.infinite_vertex() }});
  assert(CGAL::mark_domain(scene.tr, facets) == 1);
  for(std::size_t i = 0; i < 12; ++i)
    patches[i] = static_cast<int>(i) + 1;
  check_marks(scene, scene.facets, patches, region);

  // 0 is no patch of an unsigned type either, and none that is missing makes the others change
  std::vector<unsigned> known = { 7, 0, 2, 0, 1 };
  BR3::internal::complete_patches(known);
  assert((known == std::vector<unsigned>{ 7, 3, 2, 3, 1 }));
}

// Facets with Steiner points on them are several mesh facets of one patch.
template <typename Tr>
void test_parts()
{
  typedef BR3::Surface_facet_3<typename Tr::Vertex_handle> Surface_facet;
  Scene<Tr> scene(2);
  scene.add({{{ 0, 0, 0 }}, {{ 2, 2, 2 }}});
  std::vector<Surface_facet> facets;
  for(std::size_t i = 0; i < scene.facets.size(); ++i)
  {
    Surface_facet facet;
    static_cast<std::array<typename Tr::Vertex_handle, 3>&>(facet) = scene.facets[i];
    facet.index = 100 - i / 3;
    facets.push_back(facet);
  }
  assert(CGAL::mark_domain(scene.tr, facets) == 1);
  std::vector<int> patches;
  for(const Surface_facet& f : facets)
    patches.push_back(static_cast<int>(f.index) + 1);
  check_marks(scene, facets, patches, [](const auto&) { return 1; });
}

template <typename Tr>
void test_small_dimensions()
{
  Tr tr;
  std::vector<std::array<typename Tr::Vertex_handle, 3> > facets;
  for(int i = 0; i < 4; ++i)
  {
    assert(CGAL::mark_domain(tr, facets) == 0);
    const auto v = tr.insert(typename Tr::Point(i % 2, i / 2, 0));
    assert(v->in_dimension() == -1);
    facets.assign(1, {{ v, v, v }});
  }
  tr.insert(typename Tr::Point(0, 0, 1));
  facets.clear();
  assert(CGAL::mark_domain(tr, facets) == 0); // no facet is marked: all is outside
  for(const auto v : tr.finite_vertex_handles())
    assert(v->in_dimension() == 3 && v->index() == 0);
}

// Four cells around a vertex, of which the first is outside; the facet between the second and the third is marked.
struct Four_cells
{
  typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type Tr;
  typedef Tr::Cell_handle                                          Cell_handle;
  typedef Tr::Vertex_handle                                        Vertex_handle;
  typedef std::pair<Vertex_handle, Vertex_handle>                  Edge;

  Four_cells()
  {
    for(const K::Point_3& p : { K::Point_3(0, 0, 0), K::Point_3(9, 0, 0), K::Point_3(0, 9, 0), K::Point_3(0, 0, 9) })
      vertices.push_back(tr.insert(p));
    center = tr.insert(K::Point_3(1, 1, 1));
    for(const Cell_handle c : tr.finite_cell_handles())
    {
      c->set_subdomain_index(cells.empty() ? 0 : 1);
      cells.push_back(c);
    }
    assert(cells.size() == 4);
    cells[1]->set_surface_patch_index(cells[1]->index(cells[2]), 5);
    cells[2]->set_surface_patch_index(cells[2]->index(cells[1]), 5);
  }

  Tr tr;
  std::vector<Vertex_handle> vertices;
  Vertex_handle center;
  std::vector<Cell_handle> cells;
};

typedef BR3::internal::Selected_domain_3<Four_cells::Tr> Domain;

// Of the facets of the second cell, in the order of the cells behind them, the last one being infinite.
void check_facets(const Four_cells& scene, const Domain& domain, const std::array<bool, 4>& walls,
                  const std::array<bool, 4>& seams)
{
  const Four_cells::Cell_handle c = scene.cells[1];
  const std::array<int, 4> facets = {{ c->index(scene.cells[0]), c->index(scene.cells[2]), c->index(scene.cells[3]),
                                       c->index(scene.center) }};
  for(std::size_t k = 0; k < 4; ++k)
    assert(domain.is_wall(c, facets[k]) == walls[k] && domain.is_seam(c, facets[k]) == seams[k]);
}

// Cells come and go by the map; a copy of the domain has the same selection.
void test_selection()
{
  Four_cells scene;
  Domain domain(scene.tr);
  assert(! domain.has_selection() && ! domain.has_seams() && ! domain.has_constrained_edges());
  for(const auto c : scene.tr.all_cell_handles())
    assert(domain.contains(c) == (! scene.tr.is_infinite(c) && c != scene.cells[0]));
  check_facets(scene, domain, {{ true, true, false, true }}, {{ false, false, false, false }});
  domain.set_has_seams();
  assert(domain.has_seams());
  check_facets(scene, domain, {{ true, true, false, true }}, {{ true, false, false, true }});

  std::set<Four_cells::Cell_handle> selected(scene.cells.begin(), scene.cells.begin() + 3);
  domain.select(CGAL::make_boolean_property_map(selected));
  Domain copy(domain);
  assert(domain.has_selection() && copy.has_selection());
  check_facets(scene, domain, {{ true, true, true, true }}, {{ true, false, false, true }});
  copy.remove(scene.cells[2]);
  copy.add(scene.cells[3]);
  assert((selected == std::set<Four_cells::Cell_handle>{ scene.cells[0], scene.cells[1], scene.cells[3] }));
  for(std::size_t k = 0; k < 4; ++k)
    assert(domain.contains(scene.cells[k]) == (k % 2 == 1));
  check_facets(scene, domain, {{ true, true, false, true }}, {{ true, false, false, true }});
}

// In whatever order their vertices are given.
void test_constrained_edges()
{
  Four_cells scene;
  std::set<Four_cells::Edge> edges = { { scene.vertices[0], scene.center } };
  std::set<Four_cells::Cell_handle> selected(scene.cells.begin(), scene.cells.end());
  const auto is_constrained = CGAL::make_boolean_property_map(edges);
  const auto is_selected = CGAL::make_boolean_property_map(selected);
  using BR3::internal::selected_domain;
  const auto all = selected_domain(scene.tr, CGAL::parameters::default_values());
  assert(! all.has_selection() && ! all.has_seams() && ! all.has_constrained_edges());
  assert(! all.is_constrained_edge(scene.vertices[0], scene.center));
  assert(selected_domain(scene.tr, CGAL::parameters::cell_is_selected_map(is_selected)).has_selection());
  const auto domain = selected_domain(scene.tr, CGAL::parameters::edge_is_constrained_map(is_constrained));
  assert(! domain.has_selection() && ! domain.has_seams() && domain.has_constrained_edges());
  for(std::size_t k = 0; k < 4; ++k)
  {
    assert(domain.is_constrained_edge(scene.vertices[k], scene.center) == (k == 0));
    assert(domain.is_constrained_edge(scene.center, scene.vertices[k]) == (k == 0));
  }
}

int main()
{
  typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type Ours;
  test_scenes<Ours>();
#ifndef BR3_TEST_EPICK_ONLY
  test_scenes<CGAL::Boundary_constrained_mesh_triangulation_3<Exact>::type>();
#endif
  test_scenes<Over_remeshing_bases>();
  test_scenes<Over_mesh_bases>();
  test_patches();
  test_parts<Ours>();
  test_small_dimensions<Ours>();
  test_selection();
  test_constrained_edges();
  static_assert(sizeof(Ours::Cell) <= 88 && sizeof(Ours::Vertex) <= 64, "the bases are lean");
  std::cout << "the domain is marked" << std::endl;
}
