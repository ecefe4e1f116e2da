// What recover_and_judge_br3.h promises.

#undef NDEBUG

#include "recover_and_judge_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

namespace br3_test {

namespace {

template <typename K>
class Recovery_run
{
public:
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  typedef typename K::Point_3               Point_3;

  Recovery_run(const Fuzz_case& fuzz_case, const Expectation& expectation, const Recovery_mode mode)
  {
    const Plc& plc = fuzz_case.plc;
    std::vector<Point_3> points;
    for(const Coordinates& c : plc.points)
      points.emplace_back(c[0], c[1], c[2]);
    typename Brute_force_checker<Tr>::Earlier_vertices earlier;
    const auto insert = [&](const Point_3& p) { earlier.emplace_back(m_tr.insert(p), p); };
    for(const Coordinates& c : plc.earlier_points)
      insert(Point_3(c[0], c[1], c[2]));
    if(fuzz_case.are_points_inserted_before)
      std::for_each(points.begin(), points.end(), insert);
    const Portrait<Tr> before(m_tr);

    namespace params = CGAL::parameters;
    const double limit = 60; // seconds: nothing here takes so long
    const auto result = CGAL::recover_boundary(m_tr, points, plc.triangles, params::recovery_mode(mode),
                                               params::list_defects(fuzz_case.is_list_of_defects_wanted),
                                               params::constrained_edges(plc.edges).maximum_running_time(limit));
    m_status = result.status;
    Brute_force_checker<Tr>(plc, expectation, mode, m_tr, earlier, result)();
    if(expectation.has_simple_defect || (expectation.is_invalid() && fuzz_case.is_list_of_defects_wanted
                                         && fuzz_case.are_points_inserted_before))
      require(is_flat(before) || before == Portrait<Tr>(m_tr), "a refused input changed the triangulation");
  }

  const Tr& triangulation() const { return m_tr; }
  Recovery_status status() const { return m_status; }

private:
  // Then points may have been inserted before the defect was found.
  static bool is_flat(const Portrait<Tr>& before) { return before.cells.empty(); }

  Tr m_tr;
  Recovery_status m_status;
};

template <typename K>
Recovery_status recover_twice(const Fuzz_case& fuzz_case, const Expectation& expectation, const Recovery_mode mode)
{
  const Recovery_run<K> first(fuzz_case, expectation, mode);
  const Recovery_run<K> second(fuzz_case, expectation, mode); // all its addresses are different
  typedef Portrait<typename Recovery_run<K>::Tr> Portrait_of_run;
  require(first.status() == second.status(), "two runs have a different status");
  require(Portrait_of_run(first.triangulation()) == Portrait_of_run(second.triangulation()), "two runs differ");
  return first.status();
}

} // namespace

Recovery_status recover_and_judge(const Fuzz_case& fuzz_case)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
#ifndef BR3_TEST_EPICK_ONLY
  typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;
#endif
  const Expectation expectation(fuzz_case.plc);
  Recovery_status status = Recovery_status::stopped;
  bool is_incomplete = false;
  const char* names[] = { "constrained", "conforming", "flips_only" };
  for(const Recovery_mode mode : { Recovery_mode::flips_only, Recovery_mode::conforming, Recovery_mode::constrained })
  {
    const char* kernel = "Epick";
    try {
      status = recover_twice<Epick>(fuzz_case, expectation, mode);
      is_incomplete = is_incomplete || (mode == Recovery_mode::conforming && status == Recovery_status::incomplete);
#ifndef BR3_TEST_EPICK_ONLY
      kernel = "Epeck";
      recover_twice<Epeck>(fuzz_case, expectation, mode);
#endif
    } catch(const std::exception& e) {
      throw Complaint(std::string(kernel) + ", " + names[static_cast<int>(mode)] + ": " + e.what());
    }
  }
  return is_incomplete ? Recovery_status::incomplete : status;
}

} // namespace br3_test
