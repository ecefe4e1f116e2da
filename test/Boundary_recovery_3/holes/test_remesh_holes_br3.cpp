// remesh_holes() on grids whose vertices were moved at random, with regions, sheets and edges: all that it promises, by
// a judge of its own.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "hole_judge_br3.h"
#include "moved_grid_br3.h"

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_surface_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Hole_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Moved_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Remesh_arrays_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Remesh_holes_3.h>
#include <CGAL/Boundary_recovery_3/internal/holes/Sew_holes_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <CGAL/property_map.h>
#include <CGAL/remesh_holes.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace parameters = CGAL::parameters;
using br3_test::Moved_grid;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3                                     Point;
typedef CGAL::Hole_remeshing_result_3<Point>                Result;
typedef BR3::Meshing_status                                 Status;
typedef BR3::Input_defect_kind                              Kind;

template <typename ... NPs>
Result remesh(const Moved_grid& grid, const NPs& ... nps)
{
  return CGAL::remesh_holes(grid.points<Point>(), grid.tetrahedra,
                            parameters::cell_region_map(CGAL::make_property_map(grid.regions)),
                            parameters::constrained_facets(grid.facets), parameters::constrained_edges(grid.edges),
                            nps...);
}

void judge(const Moved_grid& grid, const Result& result, const std::string& what)
{
  const std::vector<Point> points = grid.points<Point>();
  br3_test::Hole_judge<Kernel, Result> judge(points, grid.tetrahedra, grid.regions, grid.facets, grid.edges, result);
  const std::string verdict = result ? judge.verdict() : "not meshed";
  std::cout << what << ": " << result << "; inverted " << result.number_of_inverted_cells << " of "
            << grid.tetrahedra.size() << ", enlarged " << result.number_of_enlargements << ", failures "
            << result.number_of_failures << ", smallest angle " << result.smallest_new_angle << std::endl;
  if(! verdict.empty())
    std::cerr << what << ": " << verdict << std::endl;
  assert(verdict.empty());
}

bool is_same(const Result& a, const Result& b)
{
  return a.points == b.points && a.tetrahedra == b.tetrahedra && a.regions == b.regions && a.facets == b.facets &&
         a.edges == b.edges && a.old_vertices == b.old_vertices && a.old_cells == b.old_cells;
}

// The old mesh, and nothing else.
void check_unchanged(const Moved_grid& grid, const Result& result, const Status status)
{
  assert(result.status == status);
  assert(result.points.size() == grid.places.size() && result.tetrahedra == grid.tetrahedra);
  for(std::size_t v = 0; v < grid.places.size(); ++v)
    for(int i = 0; i < 3; ++i)
      assert(result.points[v][i] == grid.places[v][std::size_t(i)] || grid.places[v] != grid.places[v]);
  assert(result.regions == grid.regions && result.facets == grid.facets && result.edges == grid.edges);
  assert(result.number_of_kept_vertices == grid.places.size() && result.number_of_kept_cells == grid.tetrahedra.size());
  for(std::size_t v = 0; v < result.old_vertices.size(); ++v)
    assert(result.old_vertices[v] == v);
  for(std::size_t c = 0; c < result.old_cells.size(); ++c)
    assert(result.old_cells[c] == c);
  assert(result.locations.empty());
}

// Regions that touch, one with a negative number and one that is 0, a sheet across regions, and edges.
Moved_grid furnished_grid(const int n)
{
  Moved_grid grid(n);
  grid.set_region({{ 0, 0, 0 }}, {{ n / 2, n, n }}, 0);
  grid.set_region({{ n / 3, n / 3, n / 3 }}, {{ 2 * n / 3, 2 * n / 3, 2 * n / 3 }}, -7);
  grid.add_sheet(n / 4, {{ 1, 1 }}, {{ n - 1, n - 2 }});
  grid.add_edges(n - 1, n - 2, 2, n - 1);
  return grid;
}

void test_moved_at_random()
{
  std::mt19937 rng(28);
  for(const double distance : { 0.3, 0.6, 1., 2. })
    for(const int one_of : { 1, 4, 60 })
      for(const std::size_t layers : { 0, 2 })
      {
        Moved_grid grid = furnished_grid(8);
        grid.shake(rng, distance, one_of);
        const Result result = remesh(grid, parameters::number_of_layers(layers));
        judge(grid, result, "moved by " + std::to_string(distance) + ", one of " + std::to_string(one_of) + ", " +
                            std::to_string(layers) + " layers");
        assert(is_same(result, remesh(grid, parameters::number_of_layers(layers))));
      }
}

// A body in the middle, that has a region of its own, and everything in it, by the same vector.
Moved_grid grid_with_moved_body(const int n, const std::array<double, 3>& motion)
{
  Moved_grid grid(n);
  grid.set_region({{ n / 3, n / 3, n / 3 }}, {{ 2 * n / 3, 2 * n / 3, 2 * n / 3 }}, 5);
  std::vector<bool> is_in_body(grid.places.size(), false);
  for(std::size_t c = 0; c < grid.tetrahedra.size(); ++c)
    for(const std::size_t v : grid.tetrahedra[c])
      is_in_body[v] = is_in_body[v] || grid.regions[c] == 5;
  for(std::size_t v = 0; v < grid.places.size(); ++v)
    for(std::size_t i = 0; i < 3 && is_in_body[v]; ++i)
      grid.places[v][i] += motion[i];
  return grid;
}

void test_moved_body()
{
  for(const double distance : { 0.3, 0.9, 1.5, 1.75 })
    for(const std::size_t layers : { 0, 1 })
    {
      const Moved_grid grid = grid_with_moved_body(6, {{ distance, distance / 2, - distance / 3 }});
      judge(grid, remesh(grid, parameters::number_of_layers(layers)), "a body moved by " + std::to_string(distance));
    }
}

// Through the boundary of the mesh.
void test_surface_through_surface()
{
  const Moved_grid grid = grid_with_moved_body(6, {{ 2.5, 0.125, 0.25 }});
  const Result result = remesh(grid);
  check_unchanged(grid, result, Status::invalid_input);
  assert(! result.defects.empty());
  const std::vector<Point> points = grid.points<Point>();
  const auto regions_of_facets = grid.regions_of_facets();
  for(const auto& defect : result.defects)
  {
    assert(defect.kind == Kind::intersecting_constraints && defect.simplices.size() == 2);
    std::vector<Kernel::Triangle_3> triangles;
    for(const auto& s : defect.simplices)
    {
      assert(s.dimension == 2 && s.index == s.no_index && s.vertices.size() == 3);
      Moved_grid::Facet f = {{ s.vertices[0], s.vertices[1], s.vertices[2] }};
      std::sort(f.begin(), f.end());
      const auto& regions = regions_of_facets.at(f);
      assert(regions.size() == 1 || regions[0] != regions[1]);
      triangles.emplace_back(points[f[0]], points[f[1]], points[f[2]]);
    }
    assert(CGAL::do_intersect(triangles[0], triangles[1]));
  }

  // named facets have their positions
  Moved_grid named = grid;
  for(const auto& f : regions_of_facets)
    if(f.second.size() == 1)
      named.facets.insert(named.facets.begin(), f.first);
  const Result other = remesh(named);
  check_unchanged(named, other, Status::invalid_input);
  std::size_t number = 0;
  for(const auto& defect : other.defects)
    for(const auto& s : defect.simplices)
      if(s.index != s.no_index)
      {
        assert(std::is_permutation(s.vertices.begin(), s.vertices.end(), named.facets[s.index].begin()));
        ++number;
      }
  assert(number >= other.defects.size() && other.defects.size() == result.defects.size());
}

// All of it, so that every cell is inverted, and every hole grows until it is the whole mesh.
void test_mirrored()
{
  Moved_grid grid(3);
  for(auto& p : grid.places)
    p[0] = - p[0];
  const Result result = remesh(grid);
  check_unchanged(grid, result, Status::invalid_input);
  assert(result.defects.size() == 1 && result.defects.front().kind == Kind::inverted_region);
  for(auto& p : grid.places)
    p[0] = 0;
  const Result flat = remesh(grid);
  check_unchanged(grid, flat, Status::invalid_input);
  assert(! flat.defects.empty());
}

template <typename Change>
void check_defect(const Kind kind, const std::size_t number_of_simplices, const int dimension, const Change& change)
{
  Moved_grid grid(3);
  grid.add_sheet(1, {{ 0, 0 }}, {{ 2, 2 }});
  grid.add_edges(1, 2, 0, 2);
  change(grid);
  const Result result = remesh(grid);
  check_unchanged(grid, result, Status::invalid_input);
  assert(! result.defects.empty());
  for(const auto& defect : result.defects)
  {
    assert(defect.kind == kind && defect.simplices.size() == number_of_simplices);
    for(const auto& s : defect.simplices)
      assert(s.dimension == dimension && s.index != s.no_index);
  }
}

void test_invalid_arrays()
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const std::size_t none = std::size_t(-1);
  check_defect(Kind::non_finite_coordinate, 1, 0, [&](Moved_grid& grid) { grid.places[7][1] = nan; });
  check_defect(Kind::non_finite_coordinate, 1, 0, [&](Moved_grid& grid) { grid.places[63][2] = - infinity; });
  check_defect(Kind::index_out_of_range, 1, 3, [&](Moved_grid& grid) { grid.tetrahedra[5][3] = grid.places.size(); });
  check_defect(Kind::index_out_of_range, 1, 2, [&](Moved_grid& grid) { grid.facets[1][0] = none; });
  check_defect(Kind::index_out_of_range, 1, 1, [&](Moved_grid& grid) { grid.edges[1][1] = none; });
  check_defect(Kind::repeated_vertex, 1, 3, [](Moved_grid& grid) { grid.tetrahedra[5][3] = grid.tetrahedra[5][0]; });
  check_defect(Kind::degenerate_facet, 1, 2, [](Moved_grid& grid) { grid.facets[1][0] = grid.facets[1][2]; });
  check_defect(Kind::degenerate_edge, 1, 1, [](Moved_grid& grid) { grid.edges[1][0] = grid.edges[1][1]; });
  check_defect(Kind::not_in_mesh, 1, 2, [](Moved_grid& grid) { grid.facets[1] = {{ 0, 1, 63 }}; });
  check_defect(Kind::not_in_mesh, 1, 1, [](Moved_grid& grid) { grid.edges[0] = {{ 0, 63 }}; });
  check_defect(Kind::inconsistent_orientation, 2, 3,
               [](Moved_grid& grid) { std::swap(grid.tetrahedra[70][0], grid.tetrahedra[70][1]); });
  check_defect(Kind::nonmanifold_facet, 2, 3, [](Moved_grid& grid)
  {
    grid.places.push_back({{ 1.5, 1.5, 9 }});
    const auto t = grid.tetrahedra[80];
    grid.tetrahedra.push_back({{ t[0], t[1], t[2], grid.places.size() - 1 }});
    grid.regions.push_back(1);
  });
}

struct Counting_visitor
  : public CGAL::Default_meshing_visitor_3
{
  void on_phase_begin(const BR3::Phase phase) { begun.push_back(phase); }
  void on_phase_end(const BR3::Phase_report& report) { ended.push_back(report.phase); }
  void on_progress(BR3::Phase phase, const std::size_t done, const std::size_t total)
  {
    assert(phase == begun.back() && done > 0 && done <= total);
  }

  bool go_further() { return ++number_of_questions <= last_question; }

  std::vector<BR3::Phase> begun, ended;
  std::size_t number_of_questions = 0;
  std::size_t last_question = std::size_t(-1);
};

void test_stopped()
{
  std::mt19937 rng(4);
  Moved_grid grid = furnished_grid(5);
  grid.shake(rng, 0.8, 3);
  Counting_visitor all;
  const Result result = remesh(grid, parameters::visitor(std::ref(all)));
  assert(result && all.begun.size() % 3 == 2 && all.begun == all.ended && result.phases.size() == all.begun.size());
  for(std::size_t last = 0; last < all.number_of_questions; last += 1 + last / 4)
  {
    Counting_visitor some;
    some.last_question = last;
    check_unchanged(grid, remesh(grid, parameters::visitor(std::ref(some))), Status::stopped);
    assert(some.number_of_questions == last + 1 && some.begun == some.ended);
  }
  check_unchanged(grid, remesh(grid, parameters::maximum_running_time(0)), Status::stopped);
  check_unchanged(grid, remesh(grid, parameters::maximum_running_time(1e-3)), Status::stopped);
  assert(is_same(result, remesh(grid, parameters::maximum_running_time(1000))));
}

// Cells that the caller names are replaced, others only if they are inverted; and sizes are those of the caller.
void test_selected_and_sized()
{
  Moved_grid grid = furnished_grid(6);
  std::vector<char> is_selected(grid.tetrahedra.size(), false);
  const auto is_selected_map = CGAL::make_property_map(is_selected);
  const Result nothing = remesh(grid, parameters::cell_is_selected_map(is_selected_map));
  check_unchanged(grid, nothing, Status::meshed);
  assert(nothing.number_of_holes == 0 && nothing.number_of_bad_cells == 0);

  for(std::size_t c = 0; c < grid.tetrahedra.size(); ++c)
    is_selected[c] = grid.cubes[c][0] < 2 || (grid.cubes[c][0] == 4 && grid.cubes[c][1] == 2);
  const Result result = remesh(grid, parameters::cell_is_selected_map(is_selected_map),
                               parameters::number_of_layers(0));
  judge(grid, result, "selected cells");
  assert(result.number_of_holes == 2 && result.number_of_inverted_cells == 0);
  std::size_t number_of_selected_cells = 0;
  for(const char b : is_selected)
    number_of_selected_cells += b ? 1 : 0;
  assert(result.number_of_bad_cells == number_of_selected_cells);
  assert(result.number_of_kept_cells == grid.tetrahedra.size() - number_of_selected_cells);
  for(std::size_t c = 0; c < result.number_of_kept_cells; ++c)
    assert(! is_selected[result.old_cells[c]]);

  const auto layers = [&](const std::size_t n)
  {
    return remesh(grid, parameters::cell_is_selected_map(is_selected_map), parameters::number_of_layers(n));
  };
  assert(layers(1).number_of_kept_cells < result.number_of_kept_cells);
  assert(layers(2).number_of_kept_cells < layers(1).number_of_kept_cells && layers(9).number_of_kept_cells == 0);

  const auto with_size = [&](const auto& size)
  {
    return CGAL::remesh_holes(grid.points<Point>(), grid.tetrahedra, size,
                              parameters::cell_region_map(CGAL::make_property_map(grid.regions)),
                              parameters::constrained_facets(grid.facets),
                              parameters::constrained_edges(grid.edges),
                              parameters::cell_is_selected_map(is_selected_map), parameters::number_of_layers(0));
  };
  const Result fine = with_size(0.4);
  judge(grid, fine, "size 0.4");
  assert(fine.points.size() > 2 * result.points.size());
  const Result fine_in_0 = with_size([](const Point&, const int dimension, const int region)
  {
    assert(dimension == 3 && (region == 1 || region == 0 || region == -7));
    return region == 0 ? 0.4 : 3.;
  });
  judge(grid, fine_in_0, "size 0.4 in one region");
  assert(fine_in_0.points.size() < fine.points.size() && fine_in_0.points.size() > result.points.size());

  const Result no_size = with_size(-1.);
  check_unchanged(grid, no_size, Status::invalid_input);
  assert(no_size.invalid_sizes.size() == 1 && no_size.invalid_sizes.front().size == -1);
}

void test_trivial_input()
{
  const Result nothing = CGAL::remesh_holes(std::vector<Point>(), std::vector<std::array<int, 4> >());
  assert(nothing && nothing.points.empty() && nothing.tetrahedra.empty() && nothing.number_of_holes == 0);
  for(const double angle : { -1., 71., std::numeric_limits<double>::quiet_NaN() })
    check_unchanged(Moved_grid(2), remesh(Moved_grid(2), parameters::min_dihedral_angle(angle)), Status::invalid_input);

  // points that no cell has stay
  Moved_grid grid(4);
  grid.places.insert(grid.places.end(), {{{ 1.5, 1.5, 1.5 }}, {{ 99, 0, 0 }}});
  std::mt19937 rng(3);
  grid.shake(rng, 1.2, 4);
  judge(grid, remesh(grid), "with points that no cell has");
}

// Many holes, each around one vertex that was moved, most of them apart from each other.
void test_many_holes()
{
  std::mt19937 rng(1);
  Moved_grid grid = furnished_grid(16);
  grid.shake(rng, 1.5, 200);
  const Result result = remesh(grid, parameters::number_of_layers(std::size_t(0)));
  judge(grid, result, "many holes");
  assert(result.number_of_holes > 10);
}

// The new mesh is the next old one.
Moved_grid next_mesh(const Moved_grid& grid, const Result& result)
{
  Moved_grid next = grid;
  next.places.clear();
  for(const Point& p : result.points)
    next.places.push_back({{ p.x(), p.y(), p.z() }});
  next.tetrahedra = result.tetrahedra;
  next.regions = result.regions;
  next.facets = result.facets;
  next.edges = result.edges;
  return next;
}

// No grid any more.
void test_again_and_again()
{
  std::mt19937 rng(17);
  Moved_grid grid = furnished_grid(7);
  grid.shake(rng, 2);
  for(int round = 0; round < 8; ++round)
  {
    const std::size_t layers = std::size_t(round % 3);
    const Result result = remesh(grid, parameters::number_of_layers(layers));
    judge(grid, result, "round " + std::to_string(round));
    grid = next_mesh(grid, result);
    grid.shake(rng, 0.6, 1 + 10 * (round % 4));
  }
}

int main()
{
  test_again_and_again();
  test_moved_at_random();
  test_moved_body();
  test_surface_through_surface();
  test_mirrored();
  test_invalid_arrays();
  test_stopped();
  test_selected_and_sized();
  test_trivial_input();
  test_many_holes();
  return EXIT_SUCCESS;
}
