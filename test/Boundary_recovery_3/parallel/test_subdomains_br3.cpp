// Meshes that are made in sub-domains: each triangle and edge where it was, regions of exact volumes, the same bits for
// any number of threads, and what stops the work. Beside that, partitions, triangulations of parts, and seams.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "box_scene_br3.h"
#include "box_soup_br3.h"
#include "mesh_validity_br3.h"

#include <CGAL/Boundary_recovery_3/internal/parallel/Decomposition_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Divided_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Part_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Seams_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Subdomain_meshing_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Task_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/for_each_task.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/partition_graph.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Vain_attempts_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/sum_of_qualities.h>
#include <CGAL/Boundary_recovery_3/mesh_quality.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = CGAL::Boundary_recovery_3::internal;
namespace parameters = CGAL::parameters;
using br3_test::Box_soup;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact;

// Not more threads than this, as long as it lives.
struct Threads
{
#ifdef CGAL_LINKED_WITH_TBB
  explicit Threads(const std::size_t n) : control(tbb::global_control::max_allowed_parallelism, n) { }
  tbb::global_control control;
#else
  explicit Threads(std::size_t) { }
#endif
};

template <typename Kernel>
struct Scene
  : public br3_test::Box_scene<Kernel>
{
  typedef br3_test::Box_scene<Kernel>   Base;
  typedef typename Base::Tr             Tr;
  typedef typename Base::Vertex_handle  Vertex_handle;
  typedef typename Base::Cell_handle    Cell_handle;
  typedef typename Base::Result         Result;

  using Base::Base;
  using Base::soup;
  using Base::points;
  using Base::tr;
  using Base::result;

  template <typename ... NPs>
  Result& make(const double size, const NPs& ... nps)
  {
    result = CGAL::make_boundary_constrained_mesh_3(tr, points, soup.triangles, size,
                                                    parameters::constrained_edges(soup.edges), nps...);
    return result;
  }

  // That all is where it was, and everything fits together.
  void check() const
  {
    assert(br3_test::is_valid_mesh(tr));
    for(std::size_t i = 0; i < points.size(); ++i)
      assert(result.recovery.vertices[i]->point() == points[i]);
    for(std::size_t k = 0; k < soup.triangles.size(); ++k)
    {
      Cell_handle c;
      int i, j, l;
      const auto& t = soup.triangles[k];
      assert(tr.is_facet(result.recovery.vertices[t[0]], result.recovery.vertices[t[1]], result.recovery.vertices[t[2]],
                         c, i, j, l));
      const int index = 6 - i - j - l;
      assert(c->surface_patch_index(index) == static_cast<int>(k) + 1);
      assert(tr.mirror_facet({ c, index }).first->surface_patch_index(tr.mirror_index(c, index))
             == static_cast<int>(k) + 1);
    }
    for(const auto& e : soup.edges)
    {
      Cell_handle c;
      int i, j;
      assert(tr.is_edge(result.recovery.vertices[e[0]], result.recovery.vertices[e[1]], c, i, j));
    }
    std::size_t number_of_sides = 0;
    for(const Cell_handle c : tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
        number_of_sides += c->is_facet_on_surface(i);
    assert(number_of_sides == 2 * soup.triangles.size());
  }

  std::vector<double> portrait() const
  {
    std::vector<double> numbers;
    for(const Vertex_handle v : tr.finite_vertex_handles())
      for(int i = 0; i < 3; ++i)
        numbers.push_back(CGAL::to_double(v->point()[i]));
    for(const Cell_handle c : tr.finite_cell_handles())
    {
      numbers.push_back(c->subdomain_index());
      for(int i = 0; i < 4; ++i)
        numbers.push_back(tr.is_infinite(c->vertex(i)) ? 0 : CGAL::to_double(c->vertex(i)->point()[0]));
    }
    return numbers;
  }
};

// Two regions side by side, another one in one of them, a sheet and an edge in the other.
Box_soup boxes()
{
  const br3_test::Box left = { {{ 0, 0, 0 }}, {{ 3, 3, 3 }} }, right = { {{ 3, 0, 0 }}, {{ 6, 3, 3 }} },
                      inner = { {{ 1, 1, 1 }}, {{ 2, 2, 2 }} };
  Box_soup soup;
  soup.add_box(left);
  soup.add_box(inner);
  for(int side = 1; side < 6; ++side)
    soup.add_side(right, side, true);
  soup.add_rectangle(0, {{ 4, 1, 1 }}, {{ 4, 2, 2 }}, true);
  soup.add_edge({{ 5, 1, 1 }}, {{ 5, 2, 2 }});
  return soup;
}

template <typename Kernel>
void test_regions(const double size, const std::size_t number_of_subdomains)
{
  std::vector<double> portrait;
  for(const std::size_t number_of_threads : { 1, 2, 4 })
  {
    const Threads threads(number_of_threads);
    Scene<Kernel> scene(boxes());
    assert(scene.make(size, parameters::number_of_subdomains(number_of_subdomains)));
    scene.check();
    assert(scene.result.number_of_regions == 3);
    assert(scene.volume(1) + scene.volume(2) + scene.volume(3) == 6 * 2 * 27);
    assert(scene.result.improvement.after.number_of_cells == BR3::mesh_quality(scene.tr).number_of_cells);
    assert(portrait.empty() || portrait == scene.portrait());
    portrait = scene.portrait();
  }
}

// Sizes from the surface, without the improvement; more sub-domains than there are cells; only one; none.
void test_numbers()
{
  for(const std::size_t number : { 0, 1, 3, 100000 })
  {
    Scene<K> scene(boxes()), other(boxes());
    scene.result = CGAL::make_boundary_constrained_mesh_3(scene.tr, scene.points, scene.soup.triangles,
                                                          parameters::constrained_edges(scene.soup.edges),
                                                          parameters::number_of_subdomains(number),
                                                          parameters::improve_quality(false));
    assert(scene.result && scene.result.improvement.after.number_of_cells == 0);
    scene.check();
    assert(scene.volume(1) + scene.volume(2) + scene.volume(3) == 6 * 2 * 27);
    if(number < 2)
    {
      other.make(.5);
      Scene<K> one(boxes());
      one.make(.5, parameters::number_of_subdomains(number));
      assert(one.portrait() == other.portrait());
    }
  }
}

// The same sizes as without sub-domains, and hardly more bad cells: what walls of parts did is mended.
void test_quality()
{
  Scene<K> one(boxes()), many(boxes());
  one.make(.2);
  many.make(.2, parameters::number_of_subdomains(8));
  const auto& expected = one.result.improvement.after;
  const auto& found = many.result.improvement.after;
  for(int i = 1; i < 4; ++i)
    assert(found.numbers_of_cells_below[i] <= 10 + expected.numbers_of_cells_below[i] * 11 / 10);
  assert(found.share_of_edges_in_size > expected.share_of_edges_in_size - .01);
  assert(found.mean_radius_ratio > expected.mean_radius_ratio - .01);
}

struct Stopping_visitor
  : public CGAL::Default_boundary_constrained_mesh_visitor_3
{
  using Default_boundary_constrained_mesh_visitor_3::on_progress;

  explicit Stopping_visitor(const std::size_t number_of_questions) : questions_left(number_of_questions) { }

  void on_progress(BR3::Meshing_phase phase, const std::size_t done, const std::size_t total)
  {
    const double share = static_cast<double>(done) / static_cast<double>(total);
    assert(share <= 1 && (phase != last_phase || share >= last_share));
    last_phase = phase;
    last_share = share;
  }

  bool go_further() { return questions_left == 0 || --questions_left > 0; }

  std::size_t questions_left; // 0: it goes on
  BR3::Meshing_phase last_phase = BR3::Meshing_phase::forecast;
  double last_share = 0;
};

// Stopped anywhere, the mesh is valid, and the surface in it.
void test_stops()
{
  std::size_t number_of_stops = 0;
  for(std::size_t n = 1; ; n += 1 + n / 4)
  {
    const Threads threads(1);
    Scene<K> scene(boxes());
    Stopping_visitor visitor(n);
    scene.make(.4, parameters::number_of_subdomains(4), parameters::visitor(std::ref(visitor)));
    if(scene.result)
      break;
    assert(scene.result.status == BR3::Meshing_status::stopped);
    if(! scene.result.recovery)
      continue;
    ++number_of_stops;
    scene.check();
    assert(scene.volume(1) + scene.volume(2) + scene.volume(3) == 6 * 2 * 27);
  }
  assert(number_of_stops > 5);
  Scene<K> scene(boxes());
  Stopping_visitor visitor(0);
  assert(scene.make(.4, parameters::number_of_subdomains(4), parameters::visitor(std::ref(visitor))));
  Scene<K> full(boxes());
  assert(full.make(.4, parameters::number_of_subdomains(4), parameters::maximum_number_of_vertices(100)).status
         == BR3::Meshing_status::too_large);
  Scene<K> wrong(boxes());
  assert(wrong.make(.4, parameters::number_of_subdomains(4), parameters::min_dihedral_angle(80)).status
         == BR3::Meshing_status::invalid_input);
  wrong.check();
}

// A row of nodes, of which the last one is heavy, or most are, or one outweighs all others; two rows.
void test_partition()
{
  for(const std::size_t number_of_rows : { 1, 2 })
    for(const double heaviest : { 1., 10., 1e9 })
    {
      internal::Weighted_graph graph;
      const std::size_t n = 100;
      for(std::size_t k = 0; k < n * number_of_rows; ++k)
      {
        graph.begin_node(k + 1 == n * number_of_rows ? heaviest : 1);
        if(k % n > 0)
          graph.add_edge(k - 1, 1);
        if(k % n + 1 < n)
          graph.add_edge(k + 1, 1);
      }
      for(const std::size_t number_of_parts : { 1, 2, 3, 5, 1000 })
      {
        const auto parts = internal::partition_graph(graph, number_of_parts);
        assert(parts.size() == n * number_of_rows);
        std::vector<double> weights(number_of_parts, 0);
        for(std::size_t k = 0; k < parts.size(); ++k)
          weights.at(parts[k]) += graph.node_weights[k];
        const double mean = graph.weight() / static_cast<double>(number_of_parts);
        if(heaviest < 1e9 && number_of_parts <= 5)
          assert(*std::max_element(weights.begin(), weights.end()) < 1.3 * mean + 2);
        assert(internal::partition_graph(graph, number_of_parts) == parts);
      }
      internal::limit_weights(graph, 20);
      assert(*std::max_element(graph.node_weights.begin(), graph.node_weights.end()) <= 1.01 * graph.weight() / 20);
    }
  assert(internal::partition_graph(internal::Weighted_graph(), 3).empty());
}

void test_tasks()
{
  std::vector<std::size_t> weights = { 3, 5, 5, 1 }, order;
  internal::for_each_task(weights, [&](const std::size_t k) { order.push_back(k); }, CGAL::Sequential_tag());
  assert((order == std::vector<std::size_t>{ 1, 2, 0, 3 }));
  std::vector<std::atomic<int> > done(4);
  internal::for_each_task(weights, [&](const std::size_t k) { ++done[k]; }, CGAL::Parallel_if_available_tag());
  for(const auto& d : done)
    assert(d == 1);
}

typedef Scene<K>::Tr                      Tr;
typedef internal::Divided_mesh_3<Tr>      Mesh;
typedef internal::Part_triangulation_3<Tr> Part_triangulation;
typedef std::array<std::size_t, 4>        Tetrahedron;

// The cells of the left box and of a part of the right one; every second one is in another part.
Mesh divided_mesh(const std::size_t number_of_parts)
{
  Scene<K> scene(boxes());
  scene.make(.7);
  Mesh mesh;
  std::vector<Tr::Vertex_handle> vertices;
  std::size_t k = 0;
  mesh.parts.resize(number_of_parts);
  for(const auto c : scene.tr.finite_cell_handles())
    if(c->subdomain_index() != 0)
    {
      Tetrahedron t;
      for(int i = 0; i < 4; ++i)
      {
        t[i] = static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), c->vertex(i)) - vertices.begin());
        if(t[i] == vertices.size())
        {
          vertices.push_back(c->vertex(i));
          mesh.vertices.emplace_back(*c->vertex(i));
        }
      }
      mesh.parts[k++ % 97 * number_of_parts / 97].push_back({ t, internal::Cell_indices<Tr::Cell>(*c) });
    }
  return mesh;
}

std::multiset<Tetrahedron> sorted(const Mesh::Part& part)
{
  std::multiset<Tetrahedron> result;
  for(const auto& c : part)
  {
    Tetrahedron t = c.vertices;
    std::sort(t.begin(), t.end());
    result.insert(t);
  }
  return result;
}

// Any set of cells makes a triangulation in which all walks end, and gives the same cells back.
void test_part_triangulation()
{
  const Mesh mesh = divided_mesh(7);
  for(const Mesh::Part& part : mesh.parts)
  {
    Part_triangulation triangulation(mesh, part);
    Tr& tr = triangulation.triangulation();
    assert(tr.number_of_finite_cells() == part.size());
    for(auto c = tr.tds().cells_begin(); c != tr.tds().cells_end(); ++c)
      for(int i = 0; i < 4; ++i)
      {
        const Tr::Cell_handle n = c->neighbor(i);
        assert(n != Tr::Cell_handle() && n->neighbor(n->index(Tr::Cell_handle(c))) == Tr::Cell_handle(c));
        for(int j = 0; j < 4; ++j)
          assert(j == i || n->has_vertex(c->vertex(j)));
      }
    for(const auto v : tr.finite_vertex_handles())
    {
      std::size_t number = 0, expected = 0;
      std::vector<Tr::Cell_handle> star;
      tr.tds().incident_cells(v, std::back_inserter(star));
      for(const auto c : star)
        number += ! tr.is_infinite(c);
      for(const auto c : tr.finite_cell_handles())
        expected += c->has_vertex(v);
      assert(number == expected);
    }
    const auto change = triangulation.change();
    assert(change.number_of_new_numbers == 0);
    Mesh copy = mesh;
    copy.parts.assign(1, Mesh::Part());
    auto moved = change;
    internal::put_back(copy, 0, moved, copy.vertices.size());
    Mesh::Part expected = part;
    std::multiset<std::array<double, 3> > places, expected_places;
    for(const auto& c : expected)
      for(const std::size_t v : c.vertices)
        expected_places.insert({{ mesh.vertices[v].point[0], mesh.vertices[v].point[1], mesh.vertices[v].point[2] }});
    for(const auto& c : copy.parts[0])
      for(const std::size_t v : c.vertices)
        places.insert({{ copy.vertices[v].point[0], copy.vertices[v].point[1], copy.vertices[v].point[2] }});
    assert(places == expected_places);
  }
}

// No cell is lost, or in two zones, which are not empty.
void test_seams()
{
  Mesh mesh = divided_mesh(5);
  std::multiset<Tetrahedron> all;
  for(const auto& part : mesh.parts)
    for(const auto& t : sorted(part))
      all.insert(t);
  for(std::size_t round = 2; round <= internal::Seams_3<Tr>::last_round; ++round)
  {
    auto zones = internal::Seams_3<Tr>(mesh, 2).take_out(round);
    std::multiset<Tetrahedron> now;
    for(const auto& part : mesh.parts)
      for(const auto& t : sorted(part))
        now.insert(t);
    for(const auto& zone : zones)
    {
      assert(! zone.cells.empty());
      for(const auto& t : sorted(zone.cells))
        now.insert(t);
      mesh.parts[zone.part].insert(mesh.parts[zone.part].end(), zone.cells.begin(), zone.cells.end());
    }
    assert(now == all);
  }
}

// The figures of parts together are those of the whole, but for edges that are in two parts.
void test_sum_of_qualities()
{
  const Mesh mesh = divided_mesh(1);
  Part_triangulation whole(mesh, mesh.parts[0]);
  const auto expected = BR3::mesh_quality(whole.triangulation());
  std::vector<BR3::Mesh_quality_3> qualities(1);
  const Mesh divided = divided_mesh(7);
  for(const Mesh::Part& part : divided.parts)
  {
    Part_triangulation triangulation(divided, part);
    qualities.push_back(BR3::mesh_quality(triangulation.triangulation()));
  }
  const auto sum = internal::sum_of_qualities(qualities);
  assert(sum.number_of_cells == expected.number_of_cells && sum.histogram == expected.histogram);
  assert(sum.numbers_of_cells_below == expected.numbers_of_cells_below);
  assert(sum.numbers_of_cells_above == expected.numbers_of_cells_above);
  assert(sum.min_dihedral_angle == expected.min_dihedral_angle && sum.min_radius_ratio == expected.min_radius_ratio);
  assert(sum.max_dihedral_angle == expected.max_dihedral_angle);
  assert(std::abs(sum.mean_radius_ratio - expected.mean_radius_ratio) < 1e-12);
  assert(internal::sum_of_qualities({ }).number_of_cells == 0);
  BR3::Quality_improvement_counts counts, more;
  more.number_of_rounds = 3;
  more.number_of_moved_vertices = 5;
  internal::add_counts(counts, more);
  internal::add_counts(counts, more);
  assert(counts.number_of_rounds == 3 && counts.number_of_moved_vertices == 10);
}

// What failed at a vertex is in vain until a cell around it changes.
void test_vain_attempts()
{
  struct Any_mesh
  {
    typedef Tr::Vertex_handle Vertex_handle;
    typedef Tr::Cell_handle   Cell_handle;
  };
  Scene<K> scene(boxes());
  scene.make(2);
  const Any_mesh mesh;
  internal::Bad_cells_3<Any_mesh> cells(mesh);
  internal::Vain_attempts_3<Any_mesh> attempts(cells);
  const Tr::Cell_handle c = scene.tr.finite_cells_begin();
  const Tr::Vertex_handle v = c->vertex(0), other = scene.tr.mirror_vertex(c, 0);
  assert(! attempts.contains(v));
  cells.begin_visit();
  attempts.add(v);
  attempts.add(other);
  assert(attempts.contains(v) && attempts.contains(other) && ! attempts.contains(c->vertex(1)));
  cells.begin_visit();
  cells.note_change(std::vector<Tr::Cell_handle>{ c });
  assert(! attempts.contains(v) && attempts.contains(other));
  cells.begin_visit();
  attempts.add(v);
  assert(attempts.contains(v));
  attempts.clear();
  assert(! attempts.contains(v) && ! attempts.contains(other));
}

int main()
{
  test_vain_attempts();
  test_sum_of_qualities();
  test_partition();
  test_tasks();
  test_part_triangulation();
  test_seams();
  test_regions<K>(.3, 6);
  test_regions<Exact>(.8, 3);
  test_numbers();
  test_quality();
  test_stops();
  std::cout << "done" << std::endl;
}
