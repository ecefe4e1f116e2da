// Recovers random segments in a cube, which are isolated constrained edges: NUMBER of them (default: 200), from SEED
// (default: 0). Prints when each phase ends, the status, and the number of Steiner points that are left.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using CGAL::Boundary_recovery_3::to_string;

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Delaunay_triangulation_3<K>                     Triangulation;

struct Talking_visitor
  : public CGAL::Default_meshing_visitor_3
{
  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& report)
  {
    std::cout << to_string(report.phase) << ": " << report.seconds << " s, " << report.lost_edges << " edges lost"
              << std::endl;
  }
};

int main(int argc, char** argv)
{
  const std::size_t number = argc > 1 ? std::stoul(argv[1]) : 200;
  CGAL::Random random(argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 0);
  const auto random_point = [&]
  {
    std::array<double, 3> x;
    for(double& coordinate : x)
      coordinate = random.get_double();
    return K::Point_3(x[0], x[1], x[2]);
  };
  std::vector<K::Point_3> points;
  std::vector<std::array<std::size_t, 2> > edges;
  for(std::size_t i = 0; i < 2 * number; ++i)
  {
    points.push_back(random_point());
    if(i % 2 == 1)
      edges.push_back({{ i - 1, i }});
  }
  Triangulation tr;
  const std::vector<std::array<std::size_t, 3> > no_facets;
  const auto result = CGAL::recover_boundary(tr, points, no_facets,
                                             CGAL::parameters::constrained_edges(edges).visitor(Talking_visitor()));
  std::cout << result << ", " << result.steiner_vertices.size() << " Steiner points" << std::endl;
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
