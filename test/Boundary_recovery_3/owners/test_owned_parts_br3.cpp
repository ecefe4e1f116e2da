// Parts of a mesh are filled and improved by several threads: the mesh is the same for any number of them, valid, and
// as good as that of one thread. Visitors that throw, or say no, in the middle. Given any argument, four threads make
// one mesh only: for ThreadSanitizer, with which all would take long.
#undef NDEBUG

#include "mesh_validity_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Cell_quality_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Fill_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/vertex_owners.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Concurrency.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Divide_space_3.h>
#include <CGAL/Boundary_recovery_3/internal/owners/Owned_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/for_each_task.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/mark_domain.h>
#include <CGAL/recover_boundary.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = CGAL::Boundary_recovery_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel      K;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type Tr;
typedef Tr::Vertex_handle                                        Vertex_handle;
typedef Tr::Cell_handle                                          Cell_handle;
typedef std::array<std::size_t, 3>                               Triangle;

struct Interruption { };

// Keeps an account of the cells of the domain, and throws, or says no, at one of the calls.
struct Visitor final
  : public internal::Mesh_visitor_3<Tr>
{
  void before_cells_removal(const Cells& gone) override
  {
    if(number_of_changes++ == last_change)
      throw Interruption();
    for(const Cell_handle c : gone)
      assert(cells.erase(&*c) == 1);
  }

  void after_cells_creation(const Cells& come) override
  {
    for(const Cell_handle c : come)
      assert(cells.insert(&*c).second);
  }

  bool go_further() override { return number_of_questions++ != last_question; }
  bool watches_cells() const override { return true; }

  void on_progress(const BR3::Phase phase, const std::size_t done, const std::size_t total) override
  {
    assert(done <= total);
    const double share = total > 0 ? double(done) / double(total) : 1;
    if(phase == BR3::Phase::quality_improvement)
    {
      assert(share >= last_share && share < 1);
      last_share = share;
    }
  }

  std::set<const void*> cells;
  std::size_t number_of_changes = 0, last_change = std::size_t(-1);
  std::size_t number_of_questions = 0, last_question = std::size_t(-1);
  double last_share = 0;
};

// Two octahedra, one in the other one, whose triangles are divided into four again and again.
struct Surface
{
  explicit Surface(const int number_of_divisions)
  {
    for(const double radius : { 1., 0.5 })
    {
      const std::size_t first = points.size();
      for(int i = 0; i < 6; ++i)
        points.emplace_back(i / 2 == 0 ? sign(i) * radius : 0, i / 2 == 1 ? sign(i) * radius : 0,
                            i / 2 == 2 ? sign(i) * radius : 0);
      for(int i = 0; i < 8; ++i)
      {
        const std::size_t x = first + (i & 1), y = first + 2 + ((i >> 1) & 1), z = first + 4 + (i >> 2);
        const bool is_even = ((i & 1) + ((i >> 1) & 1) + (i >> 2)) % 2 == 0;
        divide(is_even ? Triangle{{ x, y, z }} : Triangle{{ x, z, y }}, number_of_divisions);
      }
    }
  }

  std::vector<K::Point_3> points;
  std::vector<Triangle> triangles;

private:
  static int sign(const int i) { return i % 2 == 0 ? 1 : -1; }

  std::size_t middle(const std::size_t i, const std::size_t j)
  {
    const auto inserted = m_middles.insert({ std::minmax(i, j), points.size() });
    if(inserted.second)
      points.push_back(CGAL::midpoint(points[i], points[j]));
    return inserted.first->second;
  }

  void divide(const Triangle& t, const int n)
  {
    if(n == 0)
      return triangles.push_back(t);
    const std::size_t a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
    divide({{ t[0], c, b }}, n - 1);
    divide({{ c, t[1], a }}, n - 1);
    divide({{ b, a, t[2] }}, n - 1);
    divide({{ a, b, c }}, n - 1);
  }

  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_middles;
};

// The mesh of a surface, in steps, with parts of a size for tests.
struct Scene
{
  explicit Scene(const int number_of_divisions = 3)
    : surface(number_of_divisions), recovery(CGAL::recover_boundary(tr, surface.points, surface.triangles))
  {
    assert(recovery);
    assert(CGAL::mark_domain(tr, recovery.surface_facets()) == 2);
    note_cells();
  }

  void set_threads(const std::size_t number)
  {
    concurrency.number_of_threads = number;
    concurrency.cells_per_part = 1200;
  }

  void note_cells()
  {
    visitor.cells.clear();
    for(const Cell_handle c : tr.finite_cell_handles())
      if(c->subdomain_index() != 0)
        visitor.cells.insert(&*c);
  }

  BR3::Field_points_result_3<Tr> fill(const double h = 0.09, const std::size_t max_number = std::size_t(-1))
  {
    const internal::Any_size_field_3<K, double> size(h);
    internal::Selected_domain_3<Tr> domain(tr);
    internal::Field_point_insertion_3<Tr> insert(tr, domain, size, visitor);
    insert.set_concurrency(concurrency);
    return insert(max_number, std::numeric_limits<double>::infinity());
  }

  BR3::Quality_improvement_result_3<Tr> improve(const std::size_t max_number = std::size_t(-1))
  {
    visitor.last_share = 0;
    const BR3::Dihedral_angle_quality_3 quality;
    internal::Selected_domain_3<Tr> domain(tr);
    internal::Improve_quality_3<Tr, BR3::Dihedral_angle_quality_3> improve(tr, domain, quality, max_number, visitor);
    improve.set_concurrency(concurrency);
    return improve(25, BR3::Improvement_effort::normal, std::numeric_limits<double>::infinity());
  }

  // Valid, and with all triangles; the containers know what they have.
  void check()
  {
    assert(br3_test::is_valid_mesh(tr));
    for(const Triangle& t : surface.triangles)
      assert(tr.is_facet(recovery.vertices[t[0]], recovery.vertices[t[1]], recovery.vertices[t[2]],
                         facet.first, i, j, facet.second)
             && facet.first->is_facet_on_surface(6 - i - j - facet.second));
    std::size_t number = 0;
    for(const Cell_handle c : tr.finite_cell_handles())
      if(c->subdomain_index() != 0)
      {
        ++number;
        assert(visitor.cells.count(&*c) == 1);
      }
    assert(visitor.cells.size() == number);
    assert(std::size_t(std::distance(tr.tds().vertices().begin(), tr.tds().vertices().end()))
           == tr.tds().number_of_vertices());
  }

  // The cells in their order.
  std::vector<K::Point_3> portrait() const
  {
    std::vector<K::Point_3> points;
    for(const Cell_handle c : tr.finite_cell_handles())
      for(int k = 0; k < 4; ++k)
        points.push_back(c->vertex(k)->point());
    return points;
  }

  Surface surface;
  Tr tr;
  BR3::Boundary_recovery_result_3<Tr> recovery;
  internal::Concurrency concurrency;
  Visitor visitor;
  std::pair<Cell_handle, int> facet;
  int i = 0, j = 0;
};

// The part that a point is in at last, cut after cut.
internal::Part_number part_by_cuts(const internal::Divide_space_3& divide, const internal::Coordinates_3& p)
{
  internal::Part_number part = 1;
  for(int depth = 0; depth < divide.depth(); ++depth)
  {
    assert(divide.part_of(p, depth) == part);
    const internal::Divide_space_3::Cut* const cut = divide.cut_of(part, depth);
    if(cut != nullptr && ! cut->is_before(p))
      part = cut->second_half;
  }
  assert(divide.cut_of(part, divide.depth()) == nullptr);
  return part;
}

// Numbers in blocks are looked at by all threads, and taken in order, until somebody says no, or throws: then nothing
// is taken any more.
void test_blocks()
{
  std::vector<std::size_t> handles(100000);
  std::iota(handles.begin(), handles.end(), std::size_t(0));
  const auto squares = [](std::vector<std::size_t> block)
  {
    for(std::size_t& x : block)
      x *= x;
    return block;
  };
  const internal::Concurrency_tag_of<Tr> tag;
  for(const std::size_t number_of_threads : { 1, 3, 8 })
    internal::with_threads(number_of_threads, [&]
    {
      std::vector<std::size_t> taken;
      const auto take = [&](const std::vector<std::size_t>& block)
      {
        taken.insert(taken.end(), block.begin(), block.end());
        return true;
      };
      assert(internal::for_each_block(handles, squares, take, tag));
      assert(taken == squares(handles));

      int number_of_blocks = 0;
      assert(! internal::for_each_block(handles, squares, [&](const auto&) { return ++number_of_blocks < 3; }, tag));
      assert(number_of_blocks == 3);
      const auto throws = [&](const auto&)
      {
        return ++number_of_blocks < 6 ? true : throw Interruption();
      };
      bool is_thrown = false;
      try { internal::for_each_block(handles, squares, throws, tag); }
      catch(const Interruption&) { is_thrown = true; }
      assert(is_thrown && number_of_blocks == 6);

      std::vector<char> seen(handles.size(), 0);
      internal::for_each_handle(handles, [&](const std::size_t i) { ++seen[i]; }, tag);
      assert(std::count(seen.begin(), seen.end(), 1) == std::ptrdiff_t(handles.size()));
      std::vector<std::size_t> twice_even;
      const auto twice_if_even = [](const std::size_t i) { return i % 2 == 0 ? std::optional(2 * i) : std::nullopt; };
      internal::take_each(handles, twice_if_even, [&](const std::size_t i) { twice_even.push_back(i); }, tag);
      assert(twice_even.size() == handles.size() / 2 && twice_even[49999] == 199996 && twice_even[4096] == 16384);
    });
}

// All parts have about the same work; the first and the last one have it together in some rounds. Many points are in
// the same plane, as in symmetric surfaces.
void test_division()
{
  CGAL::Random random(0);
  std::vector<internal::Coordinates_3> points(4000);
  for(internal::Coordinates_3& p : points)
    p = {{ random.get_double(-1, 1), random.get_double(-1, 1), random.get_double(-1, 1) }};
  for(std::size_t k = 0; k < 20; ++k)
    points[k][0] = 0;
  const auto work = [](const internal::Coordinates_3& p) { return p[0] < 0 ? 3. : 1.; };
  for(int round = 0; round < 4; ++round)
  {
    internal::Divide_space_3 divide(7, round);
    for(const internal::Coordinates_3& p : points)
      divide.add(p, work(p));
    divide();
    const std::size_t number = divide.number_of_parts();
    assert(number == (round == 0 ? 7 : 8));
    std::vector<double> work_of_parts(number + 1, 0);
    double sum = 0;
    for(const internal::Coordinates_3& p : points)
    {
      work_of_parts.at(divide.part_of(p)) += work(p);
      assert(part_by_cuts(divide, p) == divide.part_of(p));
      sum += work(p);
    }
    assert(work_of_parts[0] == 0);
    if(round > 0)
      work_of_parts[1] += work_of_parts[number];
    for(std::size_t k = 1; k <= 7; ++k)
      assert(std::abs(work_of_parts[k] - sum / 7) < 0.01 * sum / 7);
  }
}

// The rules of `vertex_owners.h` hold when all parts are marked; a mesh without work is what it was.
void test_border()
{
  Scene scene;
  assert(scene.fill());
  const auto before = scene.portrait();
  {
    const internal::Selected_domain_3<Tr> domain(scene.tr);
    internal::Owned_parts_3<Tr> parts(scene.tr, domain, 9, 2);
    parts.mark_border(domain);
    std::vector<std::size_t> numbers(parts.size() + 1, 0);
    for(const Cell_handle c : scene.tr.finite_cell_handles())
      if(domain.contains(c))
      {
        ++numbers[parts.part_of(c)];
        for(std::size_t k = 0; k < parts.size(); ++k)
        {
          const bool is_inner = parts.part_of(c) == k;
          assert(parts[k].domain().contains(c) == is_inner);
          for(int i = 0; is_inner && i < 4; ++i)
          {
            const Cell_handle n = c->neighbor(i);
            const bool is_border = ! domain.is_wall(c, i) && parts.part_of(n) != k;
            assert(parts[k].domain().is_border(c, i) == is_border);
            assert(parts[k].domain().is_wall(c, i) == (domain.is_wall(c, i) || is_border));
          }
        }
      }
    for(const std::size_t number : numbers)
      assert(number > 0);
  }
  assert(scene.portrait() == before);
  scene.check();
}

void test_threads()
{
  Scene undivided;
  assert(undivided.fill() && undivided.improve());
  undivided.check();
  std::vector<K::Point_3> first;
  for(const std::size_t number_of_threads : { 1, 2, 3, 8 })
  {
    Scene scene;
    scene.set_threads(number_of_threads);
    const auto filling = scene.fill();
    assert(filling);
    assert(scene.concurrency.number_of_parts(filling.forecast_of_cells / 3, std::size_t(-1)) > 2);
    assert(scene.tr.number_of_vertices() == scene.surface.points.size() + filling.number_of_field_points);
    scene.check();
    const auto improvement = scene.improve();
    assert(improvement);
    scene.check();
    assert(improvement.counts.number_of_moved_vertices > 0);
    const double cells = double(scene.visitor.cells.size()), expected = double(undivided.visitor.cells.size());
    assert(std::abs(cells - expected) < 0.05 * expected);
    const auto measured = internal::Measure_quality_3<Tr>(scene.tr, internal::Selected_domain_3<Tr>(scene.tr))(
      [](Cell_handle, const internal::Cell_angles_3&) { });
    assert(measured.number_of_cells == improvement.after.number_of_cells);
    assert(measured.histogram == improvement.after.histogram);
    assert(measured.min_dihedral_angle == improvement.after.min_dihedral_angle);
    assert(measured.min_dihedral_angle > 20);
    assert(std::abs(measured.share_of_edges_in_size - improvement.after.share_of_edges_in_size) < 1e-12);
    if(first.empty())
      first = scene.portrait();
    assert(scene.portrait() == first);
  }
}

// Those below 25 degrees.
std::size_t number_of_bad_cells(const CGAL::Boundary_recovery_3::Mesh_quality_3& quality)
{
  return std::accumulate(quality.histogram.begin(), quality.histogram.begin() + 5, std::size_t(0));
}

// They are few, and how many there are in one mesh is chance, so those of several meshes are counted together.
void test_bad_cells()
{
  std::size_t number_undivided = 0, number_in_parts = 0;
  for(const double h : { 0.087, 0.09, 0.093, 0.096 })
  {
    Scene undivided, in_parts;
    in_parts.set_threads(2);
    assert(undivided.fill(h) && in_parts.fill(h));
    number_undivided += number_of_bad_cells(undivided.improve().after);
    number_in_parts += number_of_bad_cells(in_parts.improve().after);
  }
  assert(number_undivided > 0);
  assert(number_in_parts <= number_undivided);
}

// Somebody throws at one of the changes, in whichever thread that is.
void test_exceptions()
{
  std::size_t number_of_exceptions = 0;
  for(std::size_t n = 500; ; n = 2 * n + 1)
  {
    Scene scene;
    scene.set_threads(3);
    scene.visitor.last_change = n;
    try {
      assert(scene.fill() && scene.improve());
      break;
    } catch(const Interruption&) {
      ++number_of_exceptions;
    }
    scene.check();
    assert(scene.fill() && scene.improve());
    scene.check();
  }
  assert(number_of_exceptions > 3);
}

void test_stops()
{
  std::size_t number_of_stops = 0;
  for(std::size_t n = 1; ; n += 1 + n)
  {
    Scene scene;
    scene.set_threads(2);
    scene.visitor.last_question = n;
    const auto filling = scene.fill();
    const auto improvement = scene.improve();
    scene.check();
    if(scene.visitor.number_of_questions <= n)
      break;
    number_of_stops += filling.status == BR3::Meshing_status::stopped
                       || improvement.status == BR3::Meshing_status::stopped;
  }
  assert(number_of_stops > 2);
}

// Nothing is divided then, so that the limit is kept.
void test_limit()
{
  Scene scene;
  scene.set_threads(2);
  const std::size_t max_number = scene.tr.number_of_vertices() + 2000;
  assert(scene.fill(0.09, max_number).status == BR3::Meshing_status::too_large);
  assert(scene.tr.number_of_vertices() <= max_number);
  assert(scene.improve(scene.tr.number_of_vertices()));
  assert(scene.tr.number_of_vertices() <= max_number);
  scene.check();
}

// For ThreadSanitizer: all the work on the meshes of three surfaces.
void test_four_threads()
{
  for(const int number_of_divisions : { 2, 3, 4 })
  {
    Scene scene(number_of_divisions);
    scene.set_threads(4);
    assert(scene.fill(0.13) && scene.improve());
    scene.check();
  }
}

// What it has to notice: all tasks change the same number.
void test_race()
{
  volatile long number = 0;
  internal::with_threads(4, [&]
  {
    internal::for_each_task({ 1, 1, 1, 1 }, [&](std::size_t)
    {
      for(int i = 0; i < 1000000; ++i)
        number = number + 1;
    }, CGAL::Parallel_if_available_tag());
  });
}

int main(const int number_of_arguments, const char* const* const arguments)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 8);
#endif
  const std::string what = number_of_arguments > 1 ? arguments[1] : "";
  if(what == "race")
    return test_race(), 0;
  if(what == "threads")
    return test_four_threads(), 0;
  test_blocks();
  test_division();
  test_border();
  test_threads();
  test_bad_cells();
  test_exceptions();
  test_stops();
  test_limit();
}
