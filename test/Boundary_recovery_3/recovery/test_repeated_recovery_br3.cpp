// Recoveries one after the other: with one object, and in one triangulation.
#undef NDEBUG

#include "mesh_validity_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Constrained_boundary_recovery_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef Triangulation::Vertex_handle                        Vertex_handle;
typedef CGAL::Boundary_recovery_3::Recovery_mode            Mode;
typedef CGAL::Boundary_recovery_3::Phase           Phase;

// Compares what each phase reports with the triangulation.
struct Counting_visitor
  : public CGAL::Default_meshing_visitor_3
{
  const Triangulation* tr = nullptr;
  std::vector<std::array<Vertex_handle, 3> > facets;

  std::size_t number_of_lost_facets() const
  {
    std::size_t result = 0;
    Triangulation::Cell_handle c;
    int i, j, k;
    for(const auto& f : facets)
      result += tr->is_facet(f[0], f[1], f[2], c, i, j, k) ? 0 : 1;
    return result;
  }

  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& report)
  {
    if(report.phase < Phase::conforming_edge_recovery || report.phase == Phase::recount)
      assert(report.lost_facets == number_of_lost_facets());
  }
};

// The Steiner points of an earlier recovery stay, whatever becomes of a later one.
void test_one_object()
{
  const auto prism = br3_test::twisted_prism(3, .3, 1000, 1000); // needs a point
  Triangulation tr;
  std::array<std::vector<Vertex_handle>, 2> vertices;
  for(int k = 0; k < 2; ++k)
    for(const auto& p : prism.points)
      vertices[k].push_back(tr.insert(Kernel::Point_3(p[0] + 10000 * k, p[1] + 37 * k, p[2] + 11 * k)));

  Counting_visitor visitor;
  visitor.tr = &tr;
  CGAL::Constrained_boundary_recovery_3<Triangulation, Counting_visitor> recovery(tr, visitor);
  const auto insert = [&](const int k)
  {
    for(const auto& t : prism.triangles)
    {
      visitor.facets.push_back({{ vertices[k][t[0]], vertices[k][t[1]], vertices[k][t[2]] }});
      recovery.insert_constraint(vertices[k][t[0]], vertices[k][t[1]], vertices[k][t[2]]);
    }
  };

  insert(0);
  assert(recovery(Mode::constrained));
  const std::vector<Vertex_handle> points = recovery.steiner_vertices();
  assert(! points.empty());

  insert(1);
  assert(! recovery(Mode::flips_only)); // tries points, and takes them back
  assert(! recovery.lost_edges().empty());
  assert(recovery.steiner_vertices() == points);
  assert(tr.number_of_vertices() == 2 * prism.points.size() + points.size());
  assert(br3_test::is_valid_mesh(tr));

  assert(recovery(Mode::constrained));
  assert(recovery.steiner_vertices().size() > points.size());
  assert(visitor.number_of_lost_facets() == 0);
  assert(br3_test::is_valid_mesh(tr));
}

// After a recovery the triangulation is not Delaunay, and takes no new points.
void test_one_triangulation()
{
  const auto prism = br3_test::twisted_prism(3, .3, 1000, 1000);
  std::vector<Kernel::Point_3> points;
  for(const auto& p : prism.points)
    points.emplace_back(p[0], p[1], p[2]);
  Triangulation tr;
  assert(CGAL::recover_boundary(tr, points, prism.triangles));
  assert(CGAL::recover_boundary(tr, points, prism.triangles));
  const std::size_t before = tr.number_of_vertices();

  points.emplace_back(0, 0, 20000);
  auto triangles = prism.triangles;
  triangles.push_back({{ 0, 1, points.size() - 1 }});
  const auto result = CGAL::recover_boundary(tr, points, triangles);
  assert(result.status == CGAL::Boundary_recovery_3::Recovery_status::invalid_input);
  assert(result.defects.size() == 1);
  assert(result.defects.front().kind == CGAL::Boundary_recovery_3::Input_defect_kind::unknown_vertex);
  assert(tr.number_of_vertices() == before);
}

int main()
{
  test_one_object();
  test_one_triangulation();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
