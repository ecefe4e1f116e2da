// Tetrahedralizations by matching faces: the same answers as from small polyhedron reconnection, and checked exactly.
// Cavities that grow until a point inside can be dropped.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "recovery_of_oracles_br3.h"
#include "stopping_visitor_br3.h"
#include "tetrahedralizations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/cavity/Candidate_tetrahedra_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Face_matching.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Growing_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>
#include <CGAL/Boundary_recovery_3/internal/cavity/Tetrahedralization_search.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Constraints_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Replace_cells.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

typedef BR::internal::Candidate_tetrahedra_3<Tr>              Candidates;
typedef BR::internal::Face_matching                           Face_matching;
typedef BR::internal::Growing_cavity_3<Tr>                    Growing_cavity;
typedef BR::internal::Constraints_3<Tr>                       Constraints;
typedef BR::internal::Small_polyhedron_reconnection_3<Tr>     Reconnection;
typedef BR::internal::Tetrahedralization_search::Outcome      Outcome;
typedef std::vector<Vertex_handle>                            Vertices;
using br3_test::Patience;

const std::size_t many = 1000000;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

struct Search
{
  Search(const Tr& tr, const Cells& cells, const Edges& edges, const Facets& facets,
         const Vertices& free_vertices = Vertices(), const Vertex_handle superfluous = Vertex_handle(),
         const std::size_t max_number_of_steps = 100000)
    : predicates(tr), candidates(predicates)
  {
    assert(candidates.collect(cells, edges, facets, free_vertices, superfluous, many));
    outcome = matching(candidates.number_of_sides(), candidates.tetrahedra(), candidates.boundary(),
                       max_number_of_steps);
    if(outcome == Face_matching::FOUND)
      for(const std::size_t t : matching.selection())
        tetrahedra.push_back(candidates.vertices_of_tetrahedron(t));
  }

  Predicates predicates;
  Candidates candidates;
  Face_matching matching;
  Outcome outcome;
  Tetrahedra tetrahedra;
};

void check_nothing_is_outside(const Candidates& candidates)
{
  for(const Face_matching::Sides& t : candidates.tetrahedra())
    for(const Face_matching::Side s : t)
      assert(! BR::internal::contains(candidates.boundary(), Face_matching::opposite(s)));
}

// The cells themselves are a solution, so none of them may be left out.
void check_cells_are_candidates(const Candidates& candidates, const Cells& cells)
{
  std::set<std::set<Vertex_handle> > found;
  for(std::size_t t = 0; t < candidates.tetrahedra().size(); ++t)
  {
    const Tetrahedron v = candidates.vertices_of_tetrahedron(t);
    found.insert(std::set<Vertex_handle>(v.begin(), v.end()));
  }
  for(const Tetrahedron& v : tetrahedra_of(cells))
    assert(found.count(std::set<Vertex_handle>(v.begin(), v.end())) == 1);
}

// The answer of the other search is the same, and what was found fills the cells and has all that was required.
Outcome check(const Tr& tr, const Cells& cells, const Edges& edges, const Facets& facets)
{
  const Search search(tr, cells, edges, facets);
  check_nothing_is_outside(search.candidates);
  const Predicates predicates(tr);
  Reconnection reconnection(predicates);
  const Outcome outcome = reconnection(cells, edges, facets);
  assert(outcome != Outcome::GAVE_UP && outcome == search.outcome);
  if(outcome == Outcome::FOUND)
    check_tetrahedralization(search.tetrahedra, cells, edges, facets);
  return outcome;
}

void test_cavities(const bool on_grid)
{
  for_each_random_cavity(on_grid ? 17 : 18, on_grid, 3,
                         [&](Tr& tr, const Cells& cells, const Edges& edges, const Facets& facets)
  {
    assert(check(tr, cells, edges, facets) == Face_matching::FOUND);
    const Search search(tr, cells, edges, facets);
    check_cells_are_candidates(search.candidates, cells);
    replace_cells(tr, cells, search.tetrahedra);
    ++number_of[std::string(on_grid ? "grid" : "double") + (edges.empty() ? " cavity" : " cavity with requirements")];
  });
}

void test_hulls()
{
  std::mt19937 rng(20);
  for_each_random_hull(rng, 100, 10, 5, 10, [](const Tr& tr, const Edges& edges)
  {
    ++number_of[check(tr, finite_cells(tr), edges, Facets()) == Face_matching::FOUND ? "hull found" : "hull none"];
    const Search short_search(tr, finite_cells(tr), edges, Facets(), Vertices(), Vertex_handle(), 1);
    number_of["gave up"] += short_search.outcome == Face_matching::GAVE_UP;
  });
}

Cells star(const Tr& tr, const Vertex_handle v)
{
  Cells result;
  tr.incident_cells(v, std::back_inserter(result));
  return result;
}

// A vertex inside has to be used, unless it is superfluous, or free.
void test_inner_vertex()
{
  Tr tr;
  for(const Point& p : { Point(0, 0, 0), Point(9, 0, 0), Point(0, 9, 0), Point(0, 0, 9) })
    tr.insert(p);
  const Vertex_handle v = tr.insert(Point(1, 2, 3));
  assert(tr.number_of_finite_cells() == 4);
  const Cells cells = finite_cells(tr);
  assert(Search(tr, cells, Edges(), Facets()).tetrahedra.size() == 4);
  assert(Search(tr, cells, Edges(), Facets(), Vertices(), v).tetrahedra.size() == 1);
  const Search free(tr, cells, Edges(), Facets(), Vertices(1, v));
  assert(free.outcome == Face_matching::FOUND && total_volume(free.tetrahedra) == 9 * 9 * 9);
  ++number_of["inner vertex"];

  // The star can be filled, but is too large, or has too many tetrahedra.
  const Predicates predicates(tr);
  const Constraints none;
  Growing_cavity growing(tr, predicates, none);
  Patience patience = { 100 };
  const auto outcome = [&](const Growing_cavity::Bounds& bounds)
  {
    return growing(cells, v, Vertices(1, v), bounds, patience);
  };
  assert(outcome({ 3, many, 1000 }) == Growing_cavity::GAVE_UP);
  assert(outcome({ 4, 0, 1000 }) == Growing_cavity::GAVE_UP);
  assert(outcome({ 4, 1, 1000 }) == Growing_cavity::FOUND);
  assert(growing.tetrahedra().size() == 1 && growing.dropped_points() == Vertices(1, v));
  ++number_of["bounds"];
}

// Schoenhardt's polyhedron in a box, with a vertex in each of its notches, and one point inside that sees all of it. It
// can be dropped if the polyhedron may be, and not if not.
void test_growing_cavity()
{
  const double pi = std::acos(-1.);
  std::vector<Point> points;
  for(int k = 0; k < 6; ++k)
  {
    const double angle = 2 * pi * (k % 3) / 3 + (k < 3 ? 0 : pi / 6);
    points.push_back(Point(std::cos(angle), std::sin(angle), k < 3 ? 0 : 1.5));
  }
  std::vector<std::array<std::size_t, 3> > triangles = { {{ 0, 2, 1 }}, {{ 3, 4, 5 }} };
  for(std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t l = (k + 1) % 3;
    triangles.push_back({{ k, l, 3 + l }});
    triangles.push_back({{ k, 3 + l, 3 + k }});
  }
  for(std::size_t k = 0; k < 3; ++k)
    points.push_back(CGAL::centroid(points[k], points[(k + 1) % 3], points[3 + k], points[3 + (k + 1) % 3]));
  for(int k = 0; k < 8; ++k)
    points.push_back(Point(k % 2 == 0 ? -5 : 6, k / 2 % 2 == 0 ? -5.5 : 5, k / 4 == 0 ? -4 : 7));

  Tr tr;
  const auto result = CGAL::recover_boundary(tr, points, triangles);
  assert(result && result.steiner_vertices.size() == 1);
  const Vertex_handle v = result.steiner_vertices.front();
  Constraints constraints, none;
  for(const auto& t : triangles)
    constraints.insert(result.vertices[t[0]], result.vertices[t[1]], result.vertices[t[2]]);
  const Predicates predicates(tr);
  const Vertices free_vertices(1, v);
  const Growing_cavity::Bounds bounds = { 17, many, 1000 };
  Patience patience = { 1000 }, no_patience = { 0 };

  Growing_cavity hopeless(tr, predicates, constraints), growing(tr, predicates, none);
  const auto outcome = [&](Growing_cavity& search, const Growing_cavity::Bounds& bounds, Patience& p)
  {
    return search(star(tr, v), v, free_vertices, bounds, p);
  };
  const Growing_cavity::Bounds too_small = { 6, many, 1000 };
  assert(outcome(hopeless, bounds, patience) == Growing_cavity::NONE);
  ++number_of["cavity that must not grow"];
  assert(outcome(growing, bounds, no_patience) == Growing_cavity::GAVE_UP);
  assert(outcome(growing, too_small, patience) == Growing_cavity::GAVE_UP);
  assert(outcome(growing, bounds, patience) == Growing_cavity::FOUND);
  ++number_of["cavity that grows"];
  assert(growing.cells().size() > star(tr, v).size() && growing.dropped_points() == free_vertices);
  assert(total_volume(growing.tetrahedra()) == total_volume(tetrahedra_of(growing.cells())));
  BR::internal::Replace_cells<Tr> replace;
  CGAL::Default_meshing_visitor_3 visitor;
  replace(tr, growing.cells(), growing.tetrahedra(), visitor, growing.dropped_points());
  assert(tr.number_of_vertices() == points.size() && tr.tds().is_valid());
}

int main()
{
  test_cavities(true);
  test_cavities(false);
  test_hulls();
  test_inner_vertex();
  test_growing_cavity();

  for(const char* kind : { "grid cavity", "grid cavity with requirements", "double cavity",
                           "double cavity with requirements", "hull found", "hull none",
                           "gave up", "inner vertex", "bounds", "cavity that must not grow", "cavity that grows" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 0);
  }
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
