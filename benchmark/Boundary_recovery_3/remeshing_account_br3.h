// What the remeshings of a moved mesh took, as rows and sums, for the benchmarks.

#ifndef BR3_BENCHMARK_REMESHING_ACCOUNT_H
#define BR3_BENCHMARK_REMESHING_ACCOUNT_H

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>

#include <cstddef>
#include <iomanip>
#include <iostream>

namespace br3_benchmark {

typedef CGAL::Boundary_recovery_3::Phase Phase;

// The figures of [CZZ+17, Section 5.2.3].
struct Account
{
  std::size_t steps = 0;      // of the motion that made remeshings necessary
  std::size_t remeshings = 0;
  std::size_t old_cells = 0;  // of all meshes that were looked through
  std::size_t bad_cells = 0, new_cells = 0;
  std::size_t holes = 0, holes_with_steiner_points = 0, enlargements = 0, failures = 0;
  double selection = 0, recovery = 0, filling = 0, improvement = 0, sewing = 0, all = 0; // seconds
  double smallest_angle = 180; // after the remeshings of a step

  template <typename Result>
  void add(const std::size_t number_of_old_cells, const Result& result)
  {
    ++remeshings;
    old_cells += number_of_old_cells;
    bad_cells += result.number_of_bad_cells;
    new_cells += result.tetrahedra.size() - result.number_of_kept_cells;
    holes += result.number_of_holes;
    holes_with_steiner_points += result.number_of_holes_with_steiner_points;
    enlargements += result.number_of_enlargements;
    failures += result.number_of_failures;
    selection += result.seconds_of(Phase::hole_selection);
    recovery += result.seconds_of(Phase::hole_recovery);
    filling += result.seconds_of(Phase::hole_filling);
    improvement += result.seconds_of(Phase::hole_improvement);
    sewing += result.seconds_of(Phase::hole_sewing);
    all += result.seconds;
  }
};

inline void print_head()
{
  std::cout << "step     cells   bad inverted holes       out       new enlarged failed Steiner recovery  filling"
               " improvement      all  before  after\n";
}

template <typename Result>
void print_row(const int step, const std::size_t old_cells, const double old_angle, const double new_angle,
               const Result& result)
{
  std::cout << std::setw(4) << step << std::setw(10) << old_cells << std::setw(6) << result.number_of_bad_cells
            << std::setw(9) << result.number_of_inverted_cells << std::setw(6) << result.number_of_holes
            << std::setw(10) << old_cells - result.number_of_kept_cells
            << std::setw(10) << result.tetrahedra.size() - result.number_of_kept_cells
            << std::setw(9) << result.number_of_enlargements << std::setw(7) << result.number_of_failures
            << std::setw(8) << result.number_of_holes_with_steiner_points
            << std::setprecision(3) << std::setw(9) << result.seconds_of(Phase::hole_recovery)
            << std::setw(9) << result.seconds_of(Phase::hole_filling)
            << std::setw(12) << result.seconds_of(Phase::hole_improvement) << std::setw(9) << result.seconds
            << std::setprecision(1) << std::setw(8) << old_angle << std::setw(7) << new_angle << std::endl;
}

// Linear passes over the whole mesh are in the selection and the sewing; they are told by old cells, too.
inline void print_sums(const Account& account, const double full_seconds_per_cell)
{
  const double passes = account.selection + account.sewing, work = account.recovery + account.filling;
  const double new_cells = double(account.new_cells), without_improvement = account.all - account.improvement;
  std::cout << account.remeshings << " remeshings in " << account.steps << " steps: " << account.bad_cells
            << " bad cells in " << account.holes << " holes, " << account.new_cells << " new cells; "
            << account.enlargements << " enlargements for a valid boundary, " << account.failures
            << " because the recovery failed, " << account.holes_with_steiner_points << " holes with Steiner points\n"
            << std::setprecision(3) << "seconds: selection " << account.selection << ", recovery " << account.recovery
            << ", filling " << account.filling << ", improvement " << account.improvement << ", sewing "
            << account.sewing << ", all " << account.all << '\n'
            << std::setprecision(1) << "without improvement: " << 1e6 * without_improvement / new_cells
            << " s per million new cells, " << 1e6 * work / new_cells << " of it in recovery and filling, where the"
            << " full mesh takes " << 1e6 * full_seconds_per_cell << "; selection and sewing take "
            << 1e6 * passes / double(account.old_cells) << " s per million old cells; the recovery has "
            << 100 * account.recovery / without_improvement << " % of all, and " << 100 * account.recovery / work
            << " % of recovery and filling\n"
            << "smallest angle after a step: " << account.smallest_angle << std::endl;
}

} // namespace br3_benchmark

#endif // BR3_BENCHMARK_REMESHING_ACCOUNT_H
