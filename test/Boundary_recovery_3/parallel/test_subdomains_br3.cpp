// Meshes that are made in sub-domains: each triangle and edge where it was, regions of exact volumes, the same bits for
// any number of threads, and what stops the work. Beside that, partitions, triangulations of parts, and seams.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "box_scene_br3.h"
#include "box_soup_br3.h"
#include "mesh_validity_br3.h"

#include <CGAL/Boundary_recovery_3/internal/parallel/Decomposition_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_in_subdomains_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Mesh_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Part_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Seam_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Seams_3.h>
#include <CGAL/Boundary_recovery_3/internal/parallel/Work_on_part_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
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
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <type_traits>
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

  template <typename Size, typename ... NPs>
  Result& make(const Size& size, const NPs& ... nps)
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

// Hardly a larger share of bad cells than without sub-domains: what walls of parts did is mended. That is done with
// high effort, so there are more vertices beside large triangles, and fewer edges in size.
void test_quality()
{
  Scene<K> one(boxes()), many(boxes());
  one.make(.2);
  many.make(.2, parameters::number_of_subdomains(4));
  const auto& expected = one.result.improvement.after;
  const auto& found = many.result.improvement.after;
  const auto share = [](const BR3::Mesh_quality_3& quality, const int i)
  {
    return static_cast<double>(quality.numbers_of_cells_below[i]) / static_cast<double>(quality.number_of_cells);
  };
  for(int i = 1; i < 4; ++i)
    assert(share(found, i) <= 1.1 * share(expected, i) + .0005);
  std::cout << "share of edges in size: " << expected.share_of_edges_in_size << ", in sub-domains "
            << found.share_of_edges_in_size << std::endl;
  assert(found.share_of_edges_in_size > expected.share_of_edges_in_size - .05);
  assert(found.mean_radius_ratio > expected.mean_radius_ratio - .01);
}

// Small sizes around a place, which none of the other sizes tell of.
struct Spot
{
  double operator()(const K::Point_3& p) const
  {
    return (std::min)(1., 0.01 + 3 * (std::max)(0., std::sqrt(CGAL::squared_distance(p, place)) - 0.03));
  }

  double grading() const { return 3; }

  static double distance(const Scene<K>& scene)
  {
    double nearest = 1;
    for(const auto v : scene.tr.finite_vertex_handles())
      nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(v->point(), place)));
    return nearest;
  }

  static const inline K::Point_3 place = K::Point_3(4.387, 1.824, 2.368);
};

void test_small_sizes()
{
  const auto coarse = parameters::improve_quality(false);
  std::size_t numbers[5] = { };
  for(const std::size_t number : { 1, 2, 3, 4 })
  {
    Scene<K> scene(boxes()), unknown(boxes());
    assert(scene.make(Spot(), parameters::number_of_subdomains(number), coarse));
    scene.check();
    assert(scene.result.filling.is_field_resolved && Spot::distance(scene) < 0.01);
    assert(scene.result.number_of_subdomains == number);
    numbers[number] = scene.tr.number_of_vertices();
    assert(numbers[number] > 0.8 * numbers[1] && numbers[number] < 1.2 * numbers[1]);
    unknown.make([](const K::Point_3& p) { return Spot()(p); }, parameters::number_of_subdomains(number), coarse);
    assert(! unknown.result.filling.is_field_resolved);
  }
}

// Never are there more vertices than allowed; the limit does not change the mesh if there are not; and what would be
// needed is told.
void test_number_of_vertices()
{
  const auto coarse = parameters::improve_quality(false);
  Scene<K> free(boxes());
  assert(free.make(Spot(), parameters::number_of_subdomains(4), coarse));
  const std::size_t number = free.tr.number_of_vertices();
  for(const std::size_t limit : { number, number - 1, number / 4 })
    for(const std::size_t number_of_threads : { 1, 3 })
    {
      const Threads threads(number_of_threads);
      Scene<K> scene(boxes());
      scene.make(Spot(), parameters::number_of_subdomains(4), coarse, parameters::maximum_number_of_vertices(limit));
      scene.check();
      assert(scene.tr.number_of_vertices() <= limit);
      const auto& filling = scene.result.filling;
      assert(filling.number_of_field_points <= limit);
      if(limit == number)
        assert(scene.result && scene.portrait() == free.portrait());
      else
        assert(filling.status == BR3::Meshing_status::too_large
               && filling.forecast_of_vertices > static_cast<double>(limit));
    }
}

// That holds for the improvement, too, which does without other vertices then.
void test_number_of_vertices_of_improvement()
{
  Scene<K> filled(boxes()), free(boxes());
  assert(filled.make(.7, parameters::number_of_subdomains(4), parameters::improve_quality(false)));
  assert(free.make(.7, parameters::number_of_subdomains(4)));
  const std::size_t least = static_cast<std::size_t>(filled.result.filling.forecast_of_vertices) + 1;
  for(const std::size_t limit : { least, 10 * least })
  {
    Scene<K> scene(boxes());
    scene.make(.7, parameters::number_of_subdomains(4), parameters::maximum_number_of_vertices(limit));
    scene.check();
    assert(scene.result && scene.tr.number_of_vertices() <= limit);
    assert(limit == least || scene.portrait() == free.portrait());
  }
}

// Far more sub-domains than there are cells.
void test_many_subdomains()
{
  Scene<K> scene(boxes());
  assert(scene.make(3, parameters::number_of_subdomains(100000000), parameters::improve_quality(false)));
  scene.check();
  assert(scene.result.number_of_subdomains >= 1
         && scene.result.number_of_subdomains < scene.tr.number_of_finite_cells());
}

struct Stopping_visitor
  : public CGAL::Default_meshing_visitor_3
{
  explicit Stopping_visitor(const std::size_t number_of_questions) : questions_left(number_of_questions) { }

  void on_progress(BR3::Phase phase, const std::size_t done, const std::size_t total)
  {
    if(BR3::internal::is_of_recovery(phase)) // which has several passes
      return;
    const double share = static_cast<double>(done) / static_cast<double>(total);
    assert(share <= 1 && (phase != last_phase || share >= last_share));
    last_phase = phase;
    last_share = share;
  }

  bool go_further() { return questions_left == 0 || --questions_left > 0; }

  std::size_t questions_left; // 0: it goes on
  BR3::Phase last_phase = BR3::Phase::forecast;
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
    scene.make(.5, parameters::number_of_subdomains(4), parameters::visitor(std::ref(visitor)));
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
  assert(scene.make(.5, parameters::number_of_subdomains(4), parameters::visitor(std::ref(visitor))));
  Scene<K> full(boxes());
  assert(full.make(.5, parameters::number_of_subdomains(4), parameters::maximum_number_of_vertices(100)).status
         == BR3::Meshing_status::too_large);
  Scene<K> wrong(boxes());
  assert(wrong.make(.5, parameters::number_of_subdomains(4), parameters::min_dihedral_angle(80)).status
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

typedef Scene<K>::Tr                       Tr;
typedef internal::Mesh_part_3<Tr>          Part;
typedef internal::Part_triangulation_3<Tr> Part_triangulation;
typedef std::array<std::size_t, 4>         Tetrahedron;

// The number of the cube that has the middle of a cell.
std::size_t cube_of_cell(const Tr::Cell_handle c)
{
  const auto middle = CGAL::centroid(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                                     c->vertex(3)->point());
  std::size_t number = 0;
  for(int i = 0; i < 3; ++i)
    number = 4 * number + static_cast<std::size_t>(middle[i] / 1.5);
  return number;
}

// All the regions, whose cells are in groups without any order, or in cubes.
std::vector<Part> divided_mesh(const std::size_t number_of_parts, const bool in_cubes = false)
{
  Scene<K> scene(boxes());
  scene.make(.5);
  Part whole;
  std::vector<Tr::Vertex_handle> vertices;
  std::vector<std::uint32_t> groups;
  for(const auto c : scene.tr.finite_cell_handles())
    if(c->subdomain_index() != 0)
    {
      Part::Tetrahedron t;
      for(int i = 0; i < 4; ++i)
      {
        const auto found = std::find(vertices.begin(), vertices.end(), c->vertex(i));
        t[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(found - vertices.begin());
        if(found == vertices.end())
        {
          whole.vertices.emplace_back(vertices.size(), *c->vertex(i));
          vertices.push_back(c->vertex(i));
        }
      }
      whole.tetrahedra.push_back(t);
      whole.cell_indices.emplace_back(*c);
      groups.push_back(static_cast<std::uint32_t>(in_cubes ? cube_of_cell(c) % number_of_parts
                                                           : groups.size() % 97 * number_of_parts / 97));
    }
  for(const auto& e : scene.result.constrained_edges)
  {
    const auto position = [&](const Tr::Vertex_handle v)
    {
      return static_cast<std::uint32_t>(std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
    };
    whole.constrained_edges.push_back({{ position(e[0]), position(e[1]) }});
  }
  std::vector<Part> parts(number_of_parts);
  for(auto& [group, part] : internal::Split_part_3<Tr>()(whole, groups))
    parts.at(group) = std::move(part);
  assert(whole.number_of_cells() == 0);
  return parts;
}

// By the numbers of the vertices, with the regions.
std::multiset<std::pair<Tetrahedron, int> > tetrahedra(const std::vector<Part>& parts)
{
  std::multiset<std::pair<Tetrahedron, int> > result;
  for(const Part& part : parts)
    for(std::size_t c = 0; c < part.number_of_cells(); ++c)
    {
      Tetrahedron t;
      for(std::size_t i = 0; i < 4; ++i)
        t[i] = part.vertices.at(part.tetrahedra[c][i]).number;
      std::sort(t.begin(), t.end());
      result.insert({ t, part.cell_indices[c].subdomain });
    }
  return result;
}

// Whether each number is once in the part, and stands for the same point everywhere.
void check_vertices(const std::vector<Part>& parts)
{
  std::map<std::size_t, Tr::Point> points;
  std::map<std::size_t, std::size_t> numbers_of_parts;
  for(const Part& part : parts)
    for(const auto& v : part.vertices)
    {
      ++numbers_of_parts[v.number];
      assert(points.try_emplace(v.number, v.point).first->second == v.point);
    }
  for(const Part& part : parts)
  {
    std::set<std::size_t> numbers;
    for(const auto& v : part.vertices)
      assert(numbers.insert(v.number).second && (v.may_be_shared || numbers_of_parts[v.number] == 1));
  }
}

// By the numbers of the vertices.
std::set<std::set<std::size_t> > constrained_edges(const std::vector<Part>& parts)
{
  std::set<std::set<std::size_t> > edges;
  for(const Part& part : parts)
    for(const auto& e : part.constrained_edges)
      edges.insert({ part.vertices.at(e[0]).number, part.vertices.at(e[1]).number });
  return edges;
}

// Split and joined, it is the same mesh.
void test_split_and_join()
{
  const auto all = tetrahedra(divided_mesh(1));
  std::vector<Part> parts = divided_mesh(7);
  check_vertices(parts);
  assert(tetrahedra(parts) == all);
  for(const Part& part : parts)
    for(const auto& e : part.constrained_edges)
      assert(std::any_of(part.tetrahedra.begin(), part.tetrahedra.end(), [&](const auto& t)
                         { return std::count(t.begin(), t.end(), e[0]) + std::count(t.begin(), t.end(), e[1]) == 2; }));
  internal::Join_parts_3<Tr> join;
  join.add(Part());
  for(Part& part : parts)
    join.add(std::move(part));
  parts.assign(1, join.joined());
  check_vertices(parts);
  assert(tetrahedra(parts) == all);
  assert(constrained_edges(parts) == constrained_edges(divided_mesh(1)) && ! constrained_edges(parts).empty());
}

// Any set of cells makes a triangulation in which all walks end, and gives the same cells back.
void test_part_triangulation()
{
  for(const Part& part : divided_mesh(7))
  {
    Part copy = part;
    Part_triangulation triangulation(std::move(copy));
    Tr& tr = triangulation.triangulation();
    assert(tr.number_of_finite_cells() == part.number_of_cells());
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
    const Part again = triangulation.part(1000000);
    assert(tetrahedra({ again }).size() == part.number_of_cells());
    assert(again.vertices.size() == part.vertices.size());
    assert(again.constrained_edges.size() == part.constrained_edges.size());
    std::multiset<std::array<double, 3> > places, expected_places;
    for(const auto& v : part.vertices)
      expected_places.insert({{ v.point[0], v.point[1], v.point[2] }});
    for(const auto& v : again.vertices)
    {
      places.insert({{ v.point[0], v.point[1], v.point[2] }});
      assert(v.number < 1000000);
    }
    assert(places == expected_places);
  }
}

// Threads in the place of processes: each tells what it has, and waits for the others.
class Meeting
{
public:
  explicit Meeting(const std::size_t size) : m_told(size) { }

  std::vector<char> gather(const std::size_t rank, const std::vector<char>& bytes)
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_condition.wait(lock, [&] { return ! m_is_leaving; });
    m_told[rank] = bytes;
    m_is_leaving = ++m_number == m_told.size();
    m_condition.notify_all();
    m_condition.wait(lock, [&] { return m_is_leaving; });
    std::vector<char> all;
    for(const auto& told : m_told)
      all.insert(all.end(), told.begin(), told.end());
    m_is_leaving = --m_number > 0;
    m_condition.notify_all();
    return all;
  }

private:
  std::mutex m_mutex;
  std::condition_variable m_condition;
  std::vector<std::vector<char> > m_told;
  std::size_t m_number = 0;
  bool m_is_leaving = false;
};

struct Thread_exchange
{
  template <typename T>
  void gather(std::vector<T>& array) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "it is sent as bytes");
    const char* const begin = reinterpret_cast<const char*>(array.data());
    const std::vector<char> all = meeting.gather(rank, { begin, begin + array.size() * sizeof(T) });
    array.resize(all.size() / sizeof(T));
    if(! all.empty())
      std::memcpy(array.data(), all.data(), all.size());
  }

  Meeting& meeting;
  const std::size_t rank;
};

std::vector<internal::Seam_part_3> seam_parts(const std::vector<Part>& parts)
{
  std::vector<internal::Seam_part_3> result;
  for(std::size_t p = 0; p < parts.size(); ++p)
  {
    result.emplace_back(p, parts[p]);
    result.back().add_start(parts[p], p);
  }
  return result;
}

// The cells at the vertices where as many parts meet as are looked for, or at those of the starts.
void test_seams()
{
  const std::vector<Part> parts = divided_mesh(5, true);
  std::map<std::size_t, std::size_t> numbers_of_parts;
  std::set<std::size_t> starts;
  for(std::size_t p = 0; p < parts.size(); ++p)
  {
    for(const auto& v : parts[p].vertices)
      ++numbers_of_parts[v.number];
    for(const std::uint32_t v : parts[p].tetrahedra[p])
      starts.insert(parts[p].vertices[v].number);
  }
  for(const std::size_t round : { 0, 2, 3, 4 })
  {
    auto topologies = seam_parts(parts);
    internal::Seams_3<> seams(topologies, 1);
    const auto zones = seams.find_zones(round);
    std::vector<std::size_t> numbers(zones.size(), 0);
    for(std::size_t p = 0; p < parts.size(); ++p)
      for(std::size_t c = 0; c < parts[p].number_of_cells(); ++c)
      {
        bool is_expected = false, is_blocked = false;
        for(const std::uint32_t v : parts[p].tetrahedra[c])
        {
          const std::size_t number = parts[p].vertices[v].number, n = numbers_of_parts[number];
          is_expected = is_expected || (round == 0 ? starts.count(number) > 0 : round == 4 ? n >= 4 : n == round);
          is_blocked = is_blocked || (round > 0 && round < 4 && n > round);
        }
        const std::uint32_t zone = topologies[p].zone_of_cell[c];
        assert((zone != internal::Seam_part_3::none) == (is_expected && ! is_blocked));
        if(zone == internal::Seam_part_3::none)
          continue;
        ++numbers.at(zone);
        assert(std::binary_search(zones[zone].parts.begin(), zones[zone].parts.end(), p));
      }
    assert(! zones.empty());
    for(std::size_t z = 0; z < zones.size(); ++z)
    {
      assert(numbers[z] > 0 && numbers[z] == zones[z].number_of_cells);
      assert(std::binary_search(zones[z].parts.begin(), zones[z].parts.end(), zones[z].owner));
    }
  }
}

// It makes no difference who has which parts.
void test_seams_of_two_processes()
{
  const std::vector<Part> parts = divided_mesh(5, true);
  for(const std::size_t round : { 0, 2, 3, 4 })
  {
    auto all = seam_parts(parts);
    internal::Seams_3<> all_seams(all, 2);
    const auto expected = all_seams.find_zones(round);
    Meeting meeting(2);
    const auto compare = [&](const std::size_t rank)
    {
      auto own = seam_parts(parts);
      own.erase(std::remove_if(own.begin(), own.end(), [&](const auto& part) { return part.index % 2 != rank; }),
                own.end());
      const Thread_exchange exchange{ meeting, rank };
      internal::Seams_3<Thread_exchange> seams(own, 2, exchange);
      const auto zones = seams.find_zones(round);
      assert(zones.size() == expected.size());
      for(std::size_t z = 0; z < zones.size(); ++z)
        assert(zones[z].parts == expected[z].parts && zones[z].owner == expected[z].owner &&
               zones[z].number_of_cells == expected[z].number_of_cells);
      for(const auto& part : own)
        assert(part.zone_of_cell == all[part.index].zone_of_cell);
    };
    std::thread other(compare, 1);
    compare(0);
    other.join();
  }
}

// The figures of parts together are those of the whole, but for edges that are in two parts.
void test_sum_of_qualities()
{
  Part_triangulation whole(std::move(divided_mesh(1)[0]));
  const auto expected = BR3::mesh_quality(whole.triangulation());
  std::vector<BR3::Mesh_quality_3> qualities(1);
  for(Part& part : divided_mesh(7))
  {
    Part_triangulation triangulation(std::move(part));
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

int main()
{
  test_sum_of_qualities();
  test_partition();
  test_tasks();
  test_split_and_join();
  test_part_triangulation();
  test_seams();
  test_seams_of_two_processes();
  test_regions<K>(.4, 6);
  test_regions<Exact>(1.2, 3);
  test_numbers();
  test_quality();
  test_small_sizes();
  test_number_of_vertices();
  test_number_of_vertices_of_improvement();
  test_many_subdomains();
  test_stops();
  std::cout << "done" << std::endl;
}
