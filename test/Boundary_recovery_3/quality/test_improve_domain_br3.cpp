// The improvement as a whole on random constrained meshes, each exchange of cells judged as it happens: never worse,
// the same again, stopped or interrupted at any time, on triangulations of CGAL's own, too.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "improvement_judge_br3.h"
#include "mesh_validity_br3.h"

#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/improve_mesh_quality.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;
namespace parameters = CGAL::parameters;
using br3_test::Improvement_options;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef BR3::Dihedral_angle_quality_3                       Quality;

struct Interruption { };

// Judges each exchange of cells; stops, or throws, at a certain call.
template <typename Scene>
class Judging_visitor
  : public CGAL::Default_meshing_visitor_3
{
public:
  typedef typename Scene::Vertex_handle Vertex_handle;
  typedef typename Scene::Cell_handle   Cell_handle;
  typedef std::set<Vertex_handle>       Vertices;
  typedef std::map<Vertices, int>       Outside; // the patches of the outer facets, and of those that are marked
  typedef std::map<int, br3_test::Rational> Volumes; // by region

  explicit Judging_visitor(const Scene& scene) : m_scene(scene) { }

  bool go_further() { return ++number_of_questions != last_question; }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    throw_at_last_call();
    if(m_floor > 1)
      for(const Cell_handle c : m_scene.tr.finite_cell_handles())
        if(m_scene.contains(c))
          m_floor = (std::min)(m_floor, Quality()(internal::corners(c)));
    m_going = std::set<Cell_handle>(cells.begin(), cells.end());
    m_outside = outside(cells);
    m_volumes = Volumes();
    m_worst = 2;
    for(const Cell_handle c : cells)
    {
      assert(m_scene.contains(c));
      m_volumes[static_cast<int>(c->subdomain_index())] += volume(c);
      m_worst = (std::min)(m_worst, Quality()(internal::corners(c)));
    }
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    assert(outside(cells) == m_outside);
    double worst = 2;
    for(const Cell_handle c : cells)
    {
      assert(m_scene.contains(c) && volume(c) > 0);
      worst = (std::min)(worst, Quality()(internal::corners(c)));
      m_volumes[static_cast<int>(c->subdomain_index())] -= volume(c);
    }
    const bool is_taken_back = is_in_place_of_going_cells(cells);
    if(is_taken_back)
    {
      assert(worst >= m_floor - 1e-9);
      ++number_of_exchanges_taken_back;
    }
    else
      assert(worst >= least_quality() - 1e-9 && m_volumes.size() == 1 && m_volumes.begin()->second == 0);
    ++number_of_exchanges;
    note_number_of_vertices(is_taken_back);
    throw_at_last_call();
  }

  std::size_t number_of_questions = 0, last_question = 0; // 0: it is never the last one
  std::size_t number_of_calls = 0, last_call = 0;
  std::size_t number_of_exchanges = 0;
  std::size_t largest_risen_number = 0; // of vertices, after one was inserted
  std::size_t number_of_exchanges_taken_back = 0; // of several at once, with moves of vertices, in several regions

private:
  // Of new cells: at last, they may be worse than those that go, but not worse than the whole mesh was.
  double least_quality() const { return (std::min)(m_worst, (std::max)(m_worst / 5, m_floor)); }

  // Operations create cells before they delete the old ones; where those come back that there were, the new ones are
  // deleted before, and their places in memory are taken.
  template <typename CellRange>
  bool is_in_place_of_going_cells(const CellRange& cells) const
  {
    return std::any_of(cells.begin(), cells.end(), [&](const Cell_handle c) { return m_going.count(c) > 0; });
  }

  void note_number_of_vertices(const bool is_taken_back)
  {
    const std::size_t number = m_scene.tr.number_of_vertices();
    if(number > m_last_number_of_vertices && ! is_taken_back)
      largest_risen_number = (std::max)(largest_risen_number, number);
    m_last_number_of_vertices = number;
  }

  void throw_at_last_call()
  {
    if(++number_of_calls == last_call)
      throw Interruption();
  }

  static br3_test::Rational volume(const Cell_handle c)
  {
    return br3_test::volume(br3_test::to_rational(c->vertex(0)->point()), br3_test::to_rational(c->vertex(1)->point()),
                            br3_test::to_rational(c->vertex(2)->point()), br3_test::to_rational(c->vertex(3)->point()));
  }

  template <typename CellRange>
  static Outside outside(const CellRange& cells)
  {
    const std::set<Cell_handle> all(cells.begin(), cells.end());
    Outside result;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(all.count(c->neighbor(i)) == 0 || c->is_facet_on_surface(i))
          result[{ c->vertex((i + 1) % 4), c->vertex((i + 2) % 4), c->vertex((i + 3) % 4) }]
            = static_cast<int>(c->surface_patch_index(i));
    return result;
  }

  const Scene& m_scene;
  std::set<Cell_handle> m_going; // not there any more when others were created
  Outside m_outside;
  Volumes m_volumes;
  double m_worst = 0; // of the cells that go
  std::size_t m_last_number_of_vertices = m_scene.tr.number_of_vertices();
  double m_floor = 2; // quality of the worst cell of the mesh at first
};

// A scene with all that an improvement of it needs.
template <typename Kernel>
struct Improvement
{
  typedef br3_test::Improvement_scene<Kernel>                       Scene;
  typedef typename Scene::Tr                                        Tr;
  typedef typename Scene::Domain                                    Domain;
  typedef typename Scene::Vertex_handle                             Vertex_handle;
  typedef typename Scene::Cell_handle                               Cell_handle;
  typedef Judging_visitor<Scene>                                    Visitor;
  typedef internal::Any_visitor_3<Tr, Visitor&>                     Any_visitor;
  typedef internal::Recovery_context<Tr>                            Context;
  typedef internal::Improved_mesh_3<Tr, Quality>                    Mesh;
  typedef internal::Improve_domain_3<Tr, Quality>                   Improve_domain;
  typedef br3_test::Improvement_judge<Scene, Mesh>                  Judge;

  Improvement(const unsigned seed, const Improvement_options& options)
    : scene(seed, options), domain(scene.domain()), visitor(scene), any_visitor(visitor),
      context(any_visitor), mesh(scene.tr, domain, quality, any_visitor), judge(scene, mesh)
  {
    mesh.set_enough(quality.of_angle(30));
    judge.remember_all();
    worst_before = worst();
  }

  BR3::Quality_improvement_counts operator()(const double degrees = 30)
  {
    Improve_domain improve(scene.tr, domain, quality, context);
    improve(degrees);
    return improve.counts();
  }

  double worst() const
  {
    double result = 2;
    for(const Cell_handle c : scene.cells())
      if(scene.contains(c))
        result = (std::min)(result, quality(internal::corners(c)));
    return result;
  }

  std::size_t number_of_bad_cells(const double degrees = 15) const
  {
    std::size_t number = 0;
    for(const Cell_handle c : scene.cells())
      number += scene.contains(c) && quality(internal::corners(c)) < quality.of_angle(degrees);
    return number;
  }

  // Whatever happened, the mesh is valid, and not worse.
  void check() const
  {
    judge.check_all();
    assert(worst() >= worst_before - 1e-9);
  }

  Scene scene;
  Domain domain;
  Quality quality;
  Visitor visitor;
  Any_visitor any_visitor; // hands on everything to `visitor`
  Context context;
  Mesh mesh;
  Judge judge;
  double worst_before;
};

// What can be compared with another mesh: all but addresses.
template <typename Tr>
std::vector<std::array<double, 12> > bytes_of(const Tr& tr)
{
  std::vector<std::array<double, 12> > result;
  for(const auto c : tr.finite_cell_handles())
  {
    std::array<double, 12> row;
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 3; ++j)
        row[3 * i + j] = CGAL::to_double(c->vertex(i)->point()[j]);
    result.push_back(row);
  }
  return result;
}

Improvement_options options_of(const unsigned seed)
{
  Improvement_options options;
  options.is_grid = seed % 4 == 0;
  options.size = seed % 3 == 0 ? 0.15 : 0;
  options.number_of_points = 60 + static_cast<int>(seed % 5) * 20;
  return options;
}

// Each exchange is counted, but for those that were taken back, and for taking them back; vertices are removed by
// themselves, or go where others are inserted.
template <typename Visitor>
void check_counts(const BR3::Quality_improvement_counts& counts, const Visitor& visitor,
                  const std::size_t number_of_more_vertices)
{
  assert(counts.number_of_inserted_points - counts.number_of_removed_vertices == number_of_more_vertices);
  const std::size_t others = counts.number_of_removed_edges + counts.number_of_removed_facets +
                             counts.number_of_inserted_points;
  assert(others + 2 * visitor.number_of_exchanges_taken_back <= visitor.number_of_exchanges);
  assert(visitor.number_of_exchanges_taken_back > 0 ||
         visitor.number_of_exchanges <= others + counts.number_of_removed_vertices);
}

template <typename Kernel>
void test_random_meshes(const unsigned first, const unsigned last)
{
  BR3::Quality_improvement_counts sum;
  std::size_t number_before = 0, number_after = 0, number_taken_back = 0;
  for(unsigned seed = first; seed < last; ++seed)
  {
    Improvement<Kernel> t(seed, options_of(seed)), again(seed, options_of(seed));
    number_before += t.number_of_bad_cells();
    const std::size_t number_of_vertices = t.scene.tr.number_of_vertices();
    const auto counts = t(20 + seed % 3 * 5);
    number_after += t.number_of_bad_cells();
    t.check();
    assert(! t.context.is_stopped());
    check_counts(counts, t.visitor, t.scene.tr.number_of_vertices() - number_of_vertices);
    number_taken_back += t.visitor.number_of_exchanges_taken_back;
    sum.number_of_removed_edges += counts.number_of_removed_edges;
    sum.number_of_removed_facets += counts.number_of_removed_facets;
    sum.number_of_removed_vertices += counts.number_of_removed_vertices;
    sum.number_of_inserted_points += counts.number_of_inserted_points;
    sum.number_of_moved_vertices += counts.number_of_moved_vertices;
    again(20 + seed % 3 * 5);
    assert(bytes_of(t.scene.tr) == bytes_of(again.scene.tr));
  }
  std::cout << sum.number_of_removed_edges << " edges, " << sum.number_of_removed_facets << " facets, "
            << sum.number_of_removed_vertices << " vertices removed, " << sum.number_of_inserted_points
            << " inserted, " << sum.number_of_moved_vertices << " moved; " << number_taken_back
            << " attempts taken back; bad cells " << number_before << " -> " << number_after << std::endl;
  assert(sum.number_of_removed_edges > 0 && sum.number_of_removed_facets > 0 && sum.number_of_moved_vertices > 0);
  if(last - first > 8)
    assert(sum.number_of_removed_vertices > 0 && sum.number_of_inserted_points > 0 && number_taken_back > 0);
  assert(number_after < number_before);
}

// The bad cells of a scene, with the operations on them, and the search, without the schedule.
struct Bad_cell_improvement
  : public Improvement<K>
{
  typedef internal::Improve_bad_cells_3<Tr, Quality> Improve_bad_cells;
  typedef internal::Search_locally_3<Tr, Quality>    Search_locally;

  static constexpr double angle = 12;

  explicit Bad_cell_improvement(const unsigned seed)
    : Improvement<K>(seed, options_of(seed)), improve(scene.tr, domain, quality, context),
      search(improve, domain, context)
  {
    improve.mesh().set_enough(quality.of_angle(angle));
    for(const Cell_handle c : scene.cells())
      if(scene.contains(c))
        improve.bad_cells().push(c);
  }

  // Whether these are all bad cells, each of them once.
  bool is_complete(const std::vector<Improve_bad_cells::Bad_cell>& cells) const
  {
    std::set<Cell_handle> in_list, in_mesh;
    for(const auto& c : cells)
      assert(in_list.insert(c.cell).second);
    for(const Cell_handle c : scene.cells())
      if(scene.contains(c) && quality(internal::corners(c)) < quality.of_angle(angle))
        in_mesh.insert(c);
    return in_list == in_mesh;
  }

  double weight() const
  {
    const internal::Badness_3 badness(quality.of_angle(angle));
    double sum = 0;
    for(const Cell_handle c : scene.cells())
      if(scene.contains(c))
        sum += badness.weight(quality(internal::corners(c)));
    return sum;
  }

  Improve_bad_cells improve;
  Search_locally search;
};

// No cell is lost from the list, whatever is done, taken back, or left; and the search finds something.
void test_search()
{
  double sum_before = 0, sum = 0;
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    Bad_cell_improvement t(seed);
    t.judge.remember_all();
    t.improve.attempt(0);
    assert(t.judge.is_unchanged());
    const auto cells = t.improve.bad_cells().next_round();
    assert(t.is_complete(cells));
    t.improve.bad_cells().put_back(cells);
    t.improve();
    const double before = t.weight();
    t.judge.remember_all();
    t.search(t.angle);
    assert(t.is_complete(t.improve.bad_cells().next_round()) && t.weight() <= before + 1e-9);
    t.check();
    sum_before += before;
    sum += t.weight();
  }
  std::cout << "weight of bad cells before and after the search " << sum_before << " -> " << sum << std::endl;
  assert(sum < 0.95 * sum_before);
}

// If all cells are good enough, nothing is done.
void test_nothing_to_do()
{
  for(unsigned seed = 0; seed < 3; ++seed)
  {
    Improvement<K> t(seed, options_of(seed));
    t.judge.remember();
    t(0);
    assert(t.judge.is_unchanged() && t.visitor.number_of_exchanges == 0);
    for(auto& entry : t.scene.selection)
      entry.second = false;
    t.judge.remember();
    const auto counts = t(30);
    assert(t.judge.is_unchanged() && counts.number_of_rounds == 0);
  }
}

// Whenever it is stopped, and whenever the visitor throws.
void test_interruptions(const unsigned seed)
{
  std::size_t number_of_questions = 0, number_of_calls = 0;
  double worst = 0;
  {
    Improvement<K> t(seed, options_of(seed));
    t();
    number_of_questions = t.visitor.number_of_questions;
    number_of_calls = t.visitor.number_of_calls;
    worst = t.worst();
  }
  std::cout << number_of_questions << " questions, " << number_of_calls << " calls" << std::endl;
  assert(number_of_questions > 5 && number_of_calls > 20);
  for(std::size_t k = 1; k <= number_of_questions; k += 1 + number_of_questions / 60)
  {
    Improvement<K> t(seed, options_of(seed));
    t.judge.remember_all();
    t.visitor.last_question = k;
    const auto counts = t();
    t.check();
    assert(t.context.is_stopped() && t.visitor.number_of_questions == k && t.worst() <= worst + 1e-9);
    assert((k == 1) == t.judge.is_unchanged() && (k == 1) == (counts.number_of_rounds == 0));
  }
  for(std::size_t k = 1; k <= number_of_calls; k += 1 + number_of_calls / 25)
  {
    Improvement<K> t(seed, options_of(seed));
    t.visitor.last_call = k;
    bool is_thrown = false;
    try {
      t();
    } catch(const Interruption&) {
      is_thrown = true;
    }
    assert(is_thrown && t.visitor.number_of_calls == k && t.visitor.number_of_exchanges == k / 2);
    t.check();
    t.visitor.last_call = 0;
    t(); // it can be gone on with
    t.check();
  }
}

// What the function says is what happened; and a mesh and its copies become the same.
void test_function()
{
  typedef Improvement<K>::Scene::Selection_map Selection_map;
  for(const unsigned seed : { 1u, 4u, 7u })
  {
    Improvement_options options = options_of(seed);
    Improvement<K> t(seed, options);
    for(const auto c : t.scene.tr.finite_cell_handles())
      t.scene.selection[c] = true;
    t.scene.edges.clear();
    auto copy = t.scene.tr, second = t.scene.tr;
    Judging_visitor<Improvement<K>::Scene> visitor(t.scene);
    const auto result = CGAL::improve_mesh_quality(t.scene.tr, parameters::min_dihedral_angle(28.),
      parameters::visitor(std::ref(visitor)).cell_is_selected_map(Selection_map(t.scene.selection)));
    assert(result && result.after.min_dihedral_angle >= result.before.min_dihedral_angle - 1e-6);
    assert(visitor.number_of_exchanges > 0);
    CGAL::improve_mesh_quality(copy, parameters::min_dihedral_angle(28.));
    CGAL::improve_mesh_quality(second, parameters::min_dihedral_angle(28.));
    assert(bytes_of(copy) == bytes_of(second));
  }
}

// No vertex is inserted beyond the limit; one that is not reached changes nothing.
void test_number_of_vertices()
{
  typedef Improvement<K>::Scene::Selection_map Selection_map;
  const auto improve = [](const std::size_t limit)
  {
    Improvement<K> t(1, options_of(1));
    for(const auto c : t.scene.tr.finite_cell_handles())
      t.scene.selection[c] = true;
    Judging_visitor<Improvement<K>::Scene> visitor(t.scene);
    const auto result = CGAL::improve_mesh_quality(
      t.scene.tr, parameters::min_dihedral_angle(28.), parameters::maximum_number_of_vertices(limit),
      parameters::visitor(std::ref(visitor)).cell_is_selected_map(Selection_map(t.scene.selection)));
    assert(result && visitor.number_of_exchanges > 0 && visitor.largest_risen_number <= limit);
    assert((result.counts.number_of_inserted_points > 0) == (limit > 0));
    return std::make_pair(visitor.largest_risen_number, bytes_of(t.scene.tr));
  };
  const auto free = improve(1000000);
  assert(improve(999999) == free);
  for(const std::size_t limit : { std::size_t(0), free.first - 1, free.first - 3 })
    improve(limit);
}

// Whatever the cells are, and the target.
struct Same_quality
{
  double of_cells, of_target;

  double operator()(const std::array<std::array<double, 3>, 4>&) const { return of_cells; }
  double of_angle(double) const { return of_target; }
};

// The work ends also where cells are bad, and their badness, 0 or infinite, does not fall.
void test_badness_that_stays()
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Same_quality> qualities = { { -infinity, 0.4 }, { -1, 0 }, { -infinity, 0 }, { 0, 0.4 } };
  for(int k = 1; k < 1000; ++k) // those where a cell below the target lacks nothing, as it is rounded
  {
    const double target = k / 1000., quality = std::nextafter(target, 0.);
    if(1 - quality * (1 / target) == 0)
      qualities.push_back({ quality, target });
  }
  std::cout << qualities.size() << " qualities that stay" << std::endl;
  assert(qualities.size() > 20);
  qualities.resize(20);
  for(const Same_quality& quality : qualities)
  {
    Improvement<K> t(2, options_of(2));
    const auto result = CGAL::improve_mesh_quality(t.scene.tr, parameters::cell_quality(quality),
                                                   parameters::min_dihedral_angle(quality.of_target == 0 ? 0. : 25.));
    assert(result && br3_test::is_valid_mesh(t.scene.tr));
  }
}

// An account pays until its credit is spent; what it earns lengthens that, at the rate that is asked for. More effort
// means more credit, and a lower rate; more cells, more credit; each kind of cell has its own.
void test_work_account()
{
  typedef internal::Work_account Account;
  const auto number_of_tries = [](const BR3::Improvement_effort effort, const std::size_t number_of_cells,
                                  const double yield)
  {
    Account account;
    account.open(effort, number_of_cells);
    std::size_t number = 0;
    for(; account.pays(Account::VERY_BAD) && number < 1000000; ++number)
      account.book(Account::VERY_BAD, 90, yield);
    assert(account.pays(Account::BAD) && account.pays(Account::NEARLY_GOOD));
    return number;
  };
  using Effort = BR3::Improvement_effort;
  for(const std::size_t n : { 1000, 5000 })
  {
    const std::size_t low = number_of_tries(Effort::low, n, 0), normal = number_of_tries(Effort::normal, n, 0);
    assert(low < normal && normal < number_of_tries(Effort::high, n, 0));
    assert(normal < number_of_tries(Effort::normal, 2 * n, 0) && normal < number_of_tries(Effort::normal, n, 0.005));
    assert(number_of_tries(Effort::normal, n, 0.005) < 1000000 && number_of_tries(Effort::normal, n, 0.04) == 1000000);
    assert(number_of_tries(Effort::low, n, 0.04) < 1000000 && number_of_tries(Effort::high, n, 0.005) == 1000000);
  }
  assert(number_of_tries(Effort::normal, 0, 0) > 0);
  Account account; // not opened: no limit
  account.book(Account::BAD, 1000000000, 0);
  assert(account.pays(Account::BAD));
  assert(Account::kind(0, 1) == Account::VERY_BAD && Account::kind(0.3, 1) == Account::BAD
         && Account::kind(0.9, 1) == Account::NEARLY_GOOD && Account::kind(0.3, 0.4) == Account::NEARLY_GOOD);
}

// More effort is more work on the same meshes, and fewer bad cells.
void test_effort()
{
  std::array<std::size_t, 3> bad = {{ 0, 0, 0 }}, exchanges = {{ 0, 0, 0 }};
  for(unsigned seed = 0; seed < 12; ++seed)
    for(const int k : { 0, 1, 2 })
    {
      Improvement<K> t(seed, options_of(seed));
      Improvement<K>::Improve_domain improve(t.scene.tr, t.domain, t.quality, t.context);
      improve.set_effort(static_cast<BR3::Improvement_effort>(k));
      improve(30);
      t.check();
      bad[k] += t.number_of_bad_cells(10); // what the search is for
      exchanges[k] += t.visitor.number_of_exchanges;
    }
  std::cout << "effort: " << bad[0] << ", " << bad[1] << ", " << bad[2] << " bad cells; " << exchanges[0] << ", "
            << exchanges[1] << ", " << exchanges[2] << " exchanges" << std::endl;
  assert(exchanges[0] < exchanges[1] && exchanges[1] < exchanges[2]);
  assert(bad[2] < bad[1] && bad[1] < bad[0]);
}

int main()
{
  test_random_meshes<K>(0, 30);
#ifndef BR3_TEST_EPICK_ONLY
  test_random_meshes<CGAL::Exact_predicates_exact_constructions_kernel>(2, 4);
#endif
  test_work_account();
  test_effort();
  test_search();
  test_nothing_to_do();
  test_interruptions(2);
  test_interruptions(3);
  test_function();
  test_number_of_vertices();
  test_badness_that_stays();
}
