// Two recoveries at once, each of its own triangulation: they give what one after the other gives. To be run with
// ThreadSanitizer, too; it sees what they share even where the outcome is right. Given any argument, the recoveries
// share a counter, to show that it does see it.
#undef NDEBUG

#include "recover_and_judge_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <thread>
#include <vector>

typedef CGAL::Boundary_recovery_3::Recovery_mode Mode;

// Counts the replacements of cells, if it is given a counter.
struct Counting_visitor : CGAL::Default_meshing_visitor_3
{
  explicit Counting_visitor(long* const counter) : counter(counter) { }

  template <typename CellRange>
  void before_cells_removal(const CellRange&)
  {
    if(counter != nullptr)
      ++*counter;
  }

  long* counter;
};

template <typename Triangulation>
struct Outcome
{
  Outcome(const br3_test::Plc& plc, const Mode mode, long* const counter)
    : portrait(recover(plc, mode, counter)) { }

  br3_test::Portrait<Triangulation> recover(const br3_test::Plc& plc, const Mode mode, long* const counter)
  {
    std::vector<typename Triangulation::Point> points;
    for(const auto& c : plc.points)
      points.emplace_back(c[0], c[1], c[2]);
    Triangulation tr;
    const auto result = CGAL::recover_boundary(tr, points, plc.triangles, CGAL::parameters::recovery_mode(mode)
                                                                          .visitor(Counting_visitor(counter)));
    assert(result);
    number_of_steiner_points = result.steiner_vertices.size();
    return br3_test::Portrait<Triangulation>(tr);
  }

  std::size_t number_of_steiner_points = 0;
  br3_test::Portrait<Triangulation> portrait;
};

// Both begin at once, before anything that is made at its first use was made: first the threads, then one by one. Each
// thread recovers all, several times and in another order, so that both run the same code while the other does: what
// ThreadSanitizer remembers of a thread does not reach far back.
template <typename Triangulation>
void test_two_threads(const br3_test::Plc (&plcs)[2], const Mode (&modes)[2], long* const counter)
{
  const int number_of_rounds = 4;
  std::vector<Outcome<Triangulation> > of_thread[2];
  std::atomic<int> number_of_ready(0);
  const auto run = [&](const int k)
  {
    ++number_of_ready;
    while(number_of_ready < 2)
      std::this_thread::yield();
    for(int i = 0; i < 2 * number_of_rounds; ++i)
      of_thread[k].emplace_back(plcs[(k + i) % 2], modes[(k + i) % 2], counter);
  };
  std::thread t0(run, 0), t1(run, 1);
  t0.join();
  t1.join();
  for(int k = 0; k < 2; ++k)
  {
    const Outcome<Triangulation> expected(plcs[k], modes[k], nullptr);
    assert(expected.number_of_steiner_points > 0);
    for(int thread = 0; thread < 2; ++thread)
      for(std::size_t i = (k + thread) % 2; i < of_thread[thread].size(); i += 2)
      {
        assert(of_thread[thread][i].number_of_steiner_points == expected.number_of_steiner_points);
        assert(of_thread[thread][i].portrait == expected.portrait);
      }
  }
}

int main(int argc, char**)
{
  long counter = 0;
  long* const shared = argc > 1 ? &counter : nullptr;
  const br3_test::Plc plcs[2] = { br3_test::twisted_prism(3, .3, 1000, 1000), br3_test::Notched_box(1, 1).plc() };
  const Mode modes[2] = { Mode::constrained, Mode::conforming };
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Inexact_kernel;
  test_two_threads<CGAL::Boundary_constrained_mesh_triangulation_3<Inexact_kernel>::type>(plcs, modes, shared);
#ifndef BR3_TEST_ONE_TRIANGULATION
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
  test_two_threads<CGAL::Delaunay_triangulation_3<Inexact_kernel> >(plcs, modes, shared);
  test_two_threads<CGAL::Delaunay_triangulation_3<Exact_kernel> >(plcs, modes, shared);
#endif
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
