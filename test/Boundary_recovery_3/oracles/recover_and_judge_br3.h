// Runs recover_boundary() on an input in all the modes with both kernels, each twice, and has the outcome judged.
// With BR3_TEST_EPICK_ONLY, one kernel has to do, to save time where compiling is slow. To be linked to oracles_br3.

#ifndef BR3_TEST_RECOVER_AND_JUDGE_H
#define BR3_TEST_RECOVER_AND_JUDGE_H

#include "brute_force_checker_br3.h"
#include "fuzz_input_br3.h"
#include "recovery_of_oracles_br3.h"

#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace br3_test {

typedef CGAL::Boundary_recovery_3::Recovery_mode   Recovery_mode;
typedef CGAL::Boundary_recovery_3::Recovery_status Recovery_status;

// A triangulation by the points of its vertices and the ranks of these in its cells: no address is in it.
template <typename Tr>
struct Portrait
{
  std::vector<typename Tr::Point> points;
  std::vector<std::array<std::size_t, 4> > cells;

  explicit Portrait(const Tr& tr)
  {
    std::vector<typename Tr::Vertex_handle> vertices;
    for(const auto v : tr.finite_vertex_handles())
      vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end(), [](const auto& v, const auto& w) { return v->point() < w->point(); });
    std::map<const void*, std::size_t> rank;
    for(const auto& v : vertices)
    {
      rank.emplace(&*v, points.size());
      points.push_back(v->point());
    }
    if(tr.dimension() == 3)
      for(const auto c : tr.finite_cell_handles())
      {
        cells.emplace_back();
        for(int i = 0; i < 4; ++i)
          cells.back()[i] = rank.at(&*c->vertex(i));
        std::sort(cells.back().begin(), cells.back().end());
      }
    std::sort(cells.begin(), cells.end());
  }

  bool operator==(const Portrait& other) const { return cells == other.cells && points == other.points; }
};

// Returns the status in the default mode, or `incomplete` if it is this in the mode `conforming`.
// Throws a Complaint if anything is wrong.
Recovery_status recover_and_judge(const Fuzz_case& fuzz_case);

} // namespace br3_test

#endif // BR3_TEST_RECOVER_AND_JUDGE_H
