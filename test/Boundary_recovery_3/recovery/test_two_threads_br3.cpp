// Two recoveries at once, each of its own triangulation: they give what one after the other gives. To be run with
// ThreadSanitizer, too; it sees what they share even where the outcome is right.
#undef NDEBUG

#include "recover_and_judge_br3.h"
#include "steiner_inputs_br3.h"

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

template <typename K>
struct Outcome
{
  typedef CGAL::Delaunay_triangulation_3<K> Triangulation;

  Outcome(const br3_test::Plc& plc, const Mode mode)
    : portrait(recover(plc, mode)) { }

  br3_test::Portrait<Triangulation> recover(const br3_test::Plc& plc, const Mode mode)
  {
    std::vector<typename K::Point_3> points;
    for(const auto& c : plc.points)
      points.emplace_back(c[0], c[1], c[2]);
    Triangulation tr;
    const auto result = CGAL::recover_boundary(tr, points, plc.triangles, CGAL::parameters::recovery_mode(mode));
    assert(result);
    number_of_steiner_points = result.steiner_vertices.size();
    return br3_test::Portrait<Triangulation>(tr);
  }

  std::size_t number_of_steiner_points = 0;
  br3_test::Portrait<Triangulation> portrait;
};

// Both begin at once, before anything that is made at its first use was made: first the threads, then one by one.
template <typename K>
void test_two_threads(const br3_test::Plc (&plcs)[2], const Mode (&modes)[2])
{
  std::vector<Outcome<K> > of_thread[2];
  std::atomic<int> number_of_ready(0);
  const auto run = [&](const int k)
  {
    ++number_of_ready;
    while(number_of_ready < 2)
      std::this_thread::yield();
    of_thread[k].emplace_back(plcs[k], modes[k]);
  };
  std::thread t0(run, 0), t1(run, 1);
  t0.join();
  t1.join();
  for(int k = 0; k < 2; ++k)
  {
    const Outcome<K> expected(plcs[k], modes[k]);
    assert(expected.number_of_steiner_points > 0);
    assert(of_thread[k][0].number_of_steiner_points == expected.number_of_steiner_points);
    assert(of_thread[k][0].portrait == expected.portrait);
  }
}

int main()
{
  const br3_test::Plc plcs[2] = { br3_test::twisted_prism(3, .3, 1000, 1000), br3_test::Notched_box(1, 1).plc() };
  const Mode modes[2] = { Mode::constrained, Mode::conforming };
  test_two_threads<CGAL::Exact_predicates_inexact_constructions_kernel>(plcs, modes);
#ifndef BR3_TEST_EPICK_ONLY
  test_two_threads<CGAL::Exact_predicates_exact_constructions_kernel>(plcs, modes);
#endif
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
