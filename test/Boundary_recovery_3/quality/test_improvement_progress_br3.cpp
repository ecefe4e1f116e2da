// The share of an improvement that is told: it never falls, is near the truth where all goes as expected, and reaches
// its end.

#undef NDEBUG

#include <CGAL/Boundary_recovery_3/internal/quality/Improvement_progress.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>

using CGAL::Boundary_recovery_3::Improvement_effort;
using CGAL::Boundary_recovery_3::internal::Improvement_progress;

// Nothing is bad: half of the work is the centering.
void test_good_mesh()
{
  Improvement_progress progress;
  progress.begin(60000, 0, 12000, Improvement_effort::normal);
  double last = 0;
  for(std::size_t i = 0; i <= 12000; i += 1000)
  {
    progress.center(i, 12000, 60000 + 11 * i);
    assert(progress.share() > last && progress.share() < 1);
    last = progress.share();
  }
  assert(last > 0.6 && last < 0.9); // the measurement is to come
}

// Of the bad cells, some stay bad, or all of them: what is told at the end of the first round is that much less.
double share_after_first_round(const std::size_t number_of_failures, const Improvement_effort effort)
{
  static constexpr std::size_t number_of_bad_cells = 1000, evaluations_of_visit = 130;
  Improvement_progress progress;
  progress.begin(10000, number_of_bad_cells, 2000, effort);
  progress.begin_round(1, number_of_bad_cells, 10000);
  double last = 0;
  for(std::size_t i = 1; i <= number_of_bad_cells; ++i)
  {
    progress.visit();
    if(i * number_of_failures / number_of_bad_cells > (i - 1) * number_of_failures / number_of_bad_cells)
      progress.fail();
    if(i % 100 != 0)
      continue;
    progress.work(10000 + evaluations_of_visit * i);
    assert(progress.share() >= last && progress.share() < 1);
    last = progress.share();
  }
  return last;
}

void test_bad_cells()
{
  const double none = share_after_first_round(0, Improvement_effort::normal);
  const double some = share_after_first_round(300, Improvement_effort::normal);
  const double all = share_after_first_round(1000, Improvement_effort::normal);
  assert(none > some && some > all && none > 0.4 && all < 0.2);
  assert(share_after_first_round(1000, Improvement_effort::high) < all);
  assert(share_after_first_round(1000, Improvement_effort::low) > all);
}

// More work than expected on the worst cells slows the share down, and does not let it reach its end.
void test_worst_cells()
{
  Improvement_progress progress;
  progress.begin(1000, 500, 0, Improvement_effort::normal);
  progress.begin_worst_cells(10, 500, 20000);
  double last = progress.share();
  for(std::size_t spent = 1000; spent < 1000000; spent *= 2)
  {
    progress.work(20000 + spent);
    assert(progress.share() >= last && progress.share() < 1);
    last = progress.share();
  }
  assert(last > 0.9);
}

// There is nothing to be divided by.
void test_nothing()
{
  Improvement_progress progress;
  assert(progress.share() == 0);
  progress.begin(0, 0, 0, Improvement_effort::normal);
  progress.begin_round(1, 0, 0);
  progress.work(0);
  progress.begin_worst_cells(0, 0, 0);
  progress.center(0, 0, 0);
  assert(std::isfinite(progress.share()) && progress.share() < 1);
}

int main()
{
  test_good_mesh();
  test_bad_cells();
  test_worst_cells();
  test_nothing();
  std::cout << "done" << std::endl;
  return 0;
}
