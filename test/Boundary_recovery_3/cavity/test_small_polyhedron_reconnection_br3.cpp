// The search for another tetrahedralization of a few cells: what it finds is checked exactly, and what it must not find
// is asked for, too.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "tetrahedralizations_br3.h"

#include <CGAL/Boundary_recovery_3/internal/cavity/Small_polyhedron_reconnection_3.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

typedef BR::internal::Small_polyhedron_reconnection_3<Tr>     Reconnection;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

// Searches and replaces: the result must be a triangulation again, which has all that was required.
Tetrahedra reconnect(Tr& tr, Reconnection& reconnection, const Cells& cells, const Edges& edges, const Facets& facets)
{
  assert(reconnection(cells, edges, facets) == Reconnection::FOUND);
  const Tetrahedra result = reconnection.tetrahedra();
  check_tetrahedralization(result, cells, edges, facets);
  replace_cells(tr, cells, result);
  return result;
}

// --- the table of orientations ---------------------------------------------------------------------------------------

typedef CGAL::Exact_predicates_exact_constructions_kernel     Exact_kernel;
typedef BR::internal::Orientation_table_3<Tr>                 Table;
typedef Table::Vertex_set                                     Vertex_set;

Exact_kernel::Point_3 exact_point(const Table& table, const int i)
{
  return CGAL::Cartesian_converter<Kernel, Exact_kernel>()(table.vertices()[i]->point());
}

typedef Exact_kernel::Segment_3   Exact_segment;
typedef Exact_kernel::Triangle_3  Exact_triangle;

// In a point inside both.
bool do_cross(const Exact_segment& s, const Exact_segment& t)
{
  return CGAL::do_intersect(s, t) && ! s.has_on(t.source()) && ! s.has_on(t.target())
      && ! t.has_on(s.source()) && ! t.has_on(s.target());
}

bool do_cross(const Exact_segment& s, const Exact_triangle& t)
{
  if(t.is_degenerate() || ! CGAL::do_intersect(s, t) || t.has_on(s.source()) || t.has_on(s.target()))
    return false;
  for(int k = 0; k < 3; ++k)
    if(CGAL::do_intersect(s, Exact_segment(t[k], t[k + 1])))
      return false;
  return true;
}

void check_edges_and_faces(const Table& table)
{
  const int n = table.number_of_vertices();
  const auto p = [&](const int i) { return exact_point(table, i); };
  for(int a = 0; a < n; ++a)
    for(int b = 0; b < n; ++b)
    {
      if(a == b)
        continue;
      const Exact_segment e(p(a), p(b));
      for(int i = 0; i < n; ++i)
        for(int j = i + 1; j < n; ++j)
        {
          const Vertex_set apexes = table.apexes_of_pierced_faces({{ a, b }}, {{ i, j }});
          if(i == a || i == b || j == a || j == b)
          {
            assert(apexes == 0);
            continue;
          }
          assert(table.apexes_of_pierced_faces({{ b, a }}, {{ j, i }}) == apexes);
          const bool is_edge_crossed = do_cross(e, Exact_segment(p(i), p(j)));
          assert(((table.ends_of_crossing_edges({{ i, j }}, a) & Table::set_of(b)) != 0) == is_edge_crossed);
          number_of["crossing edges"] += is_edge_crossed;
          for(int k = 0; k < n; ++k)
          {
            if(k == a || k == b || k == i || k == j)
              continue;
            const bool is_pierced = do_cross(e, Exact_triangle(p(i), p(j), p(k)));
            assert(((apexes & Table::set_of(k)) != 0) == is_pierced);
            const Vertex_set positive = table.sides({{ i, j, k }}).positive;
            if((positive & Table::set_of(a)) != 0)
              assert(((table.ends_of_piercing_edges({{ i, j, k }}, a) & Table::set_of(b)) != 0) == is_pierced);
            number_of["pierced faces"] += is_pierced;
          }
        }
    }
}

void check_tetrahedra(const Table& table)
{
  const int n = table.number_of_vertices();
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      for(int k = 0; k < n; ++k)
        for(int l = 0; l < n; ++l)
        {
          if(i == j || i == k || i == l || j == k || j == l || k == l)
            continue;
          const Exact_kernel::Tetrahedron_3 t(exact_point(table, i), exact_point(table, j), exact_point(table, k),
                                              exact_point(table, l));
          const Table::Sides s = table.sides({{ i, j, k }});
          assert(((s.positive & Table::set_of(l)) != 0) == (t.orientation() == CGAL::POSITIVE));
          assert(((s.negative & Table::set_of(l)) != 0) == (t.orientation() == CGAL::NEGATIVE));
          if(t.orientation() != CGAL::POSITIVE)
            continue;
          bool contains_vertex = false;
          for(int m = 0; m < n; ++m)
            if(m != i && m != j && m != k && m != l && ! t.has_on_unbounded_side(exact_point(table, m)))
              contains_vertex = true;
          assert(table.contains_vertex({{ i, j, k }}, l) == contains_vertex);
          number_of["tetrahedra with a vertex"] += contains_vertex;
        }
}

// Each list begins like the one before, and then differs.
void test_orientation_table()
{
  std::mt19937 rng(11);
  Tr tr;
  for(int i = 0; i < 40; ++i)
    tr.insert(random_point(rng, true));
  const std::vector<Vertex_handle> all(tr.finite_vertex_handles().begin(), tr.finite_vertex_handles().end());
  const Predicates predicates(tr);
  Table table(predicates);
  std::vector<Vertex_handle> vertices(all.begin(), all.begin() + 7);
  for(int round = 0; round < 3; ++round)
  {
    table.set_vertices(vertices);
    check_edges_and_faces(table);
    check_tetrahedra(table);
    vertices.resize(4 + round);
    vertices.insert(vertices.end(), all.begin() + 10 + 5 * round, all.begin() + 14 + 5 * round);
  }
}

// The table is full, and the last vertices are in it, too.
void test_full_orientation_table()
{
  std::mt19937 rng(12);
  Tr tr;
  while(tr.number_of_vertices() < Table::max_number_of_vertices)
    tr.insert(random_point(rng, true));
  const std::vector<Vertex_handle> all(tr.finite_vertex_handles().begin(), tr.finite_vertex_handles().end());
  const Predicates predicates(tr);
  Table table(predicates);
  table.set_vertices(all);
  const int n = table.number_of_vertices();
  assert(BR::internal::number_of_bits(table.all()) == n);
  for(int trial = 0; trial < 2000; ++trial)
  {
    const Table::Face f = {{ n - 1 - random_int(rng, 20), random_int(rng, 20), 20 + random_int(rng, 20) }};
    for(int l = 0; l < n; ++l)
    {
      const CGAL::Orientation o = CGAL::orientation(all[f[0]]->point(), all[f[1]]->point(), all[f[2]]->point(),
                                                    all[l]->point());
      assert(((table.sides(f).positive & Table::set_of(l)) != 0) == (o == CGAL::POSITIVE));
      assert(((table.sides(f).negative & Table::set_of(l)) != 0) == (o == CGAL::NEGATIVE));
    }
  }
}

// --- cavities in random triangulations -------------------------------------------------------------------------------

void test_cavities(const bool on_grid)
{
  const std::string kind = on_grid ? "grid cavity" : "double cavity";
  for_each_random_cavity(on_grid ? 7 : 8, on_grid, 6,
                         [&](Tr& tr, const Cells& cells, const Edges& edges, const Facets& facets)
  {
    const Tetrahedra old = tetrahedra_of(cells);
    const Predicates predicates(tr);
    Reconnection reconnection(predicates);
    const Tetrahedra result = reconnect(tr, reconnection, cells, edges, facets);
    const bool is_changed = std::any_of(old.begin(), old.end(),
                                        [&](const Tetrahedron& t) { return number_around(result, t) == 0; });
    ++number_of[kind + (edges.empty() ? "" : " with requirements")];
    if(is_changed)
      ++number_of[kind + " changed"];
  });
}

// --- hulls of few points, with edges drawn at random: the search has to take back choices ----------------------------

void test_hulls()
{
  std::mt19937 rng(10);
  for_each_random_hull(rng, 60, 12, 3, 6, [&](Tr& tr, const Edges& edges)
  {
    const Predicates predicates(tr);
    Reconnection reconnection(predicates);
    const Reconnection::Outcome outcome = reconnection(finite_cells(tr), edges, Facets());
    ++number_of[outcome == Reconnection::FOUND ? "hull found" :
                outcome == Reconnection::NONE ? "hull none" : "hull gave up"];
    if(outcome == Reconnection::FOUND)
      reconnect(tr, reconnection, finite_cells(tr), edges, Facets());

    // A few of the edges that are there: none is no answer, since the cells themselves are a solution.
    for(int k = 0; k < 20; ++k)
    {
      const Cells cells = finite_cells(tr);
      Edges some;
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle c = cells[random_int(rng, static_cast<int>(cells.size()))];
        const int j = random_int(rng, 4), l = (j + 1 + random_int(rng, 3)) % 4;
        some.push_back({{ c->vertex(j), c->vertex(l) }});
      }
      reconnect(tr, reconnection, cells, some, Facets());
      ++number_of["hull with some of its edges"];
    }
  });
}

// --- bipyramids: two cells against three -----------------------------------------------------------------------------

void test_bipyramid(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c)
{
  Tr tr;
  const Edge axis = {{ tr.insert(p), tr.insert(q) }};
  const Facet equator = {{ tr.insert(a), tr.insert(b), tr.insert(c) }};
  const Predicates predicates(tr);
  Reconnection reconnection(predicates);

  const bool is_tall = tr.number_of_finite_cells() == 2;
  assert(is_tall || tr.number_of_finite_cells() == 3);
  const auto add_axis = [&]
  {
    const Tetrahedra result = reconnect(tr, reconnection, finite_cells(tr), Edges(1, axis), Facets());
    assert(result.size() == 3 && number_around(result, axis) == 3);
  };
  const auto add_equator = [&]
  {
    const Tetrahedra result = reconnect(tr, reconnection, finite_cells(tr), Edges(), Facets(1, equator));
    assert(result.size() == 2 && number_around(result, equator) == 2);
  };
  ++number_of[is_tall ? "bipyramid of two cells" : "bipyramid of three cells"];
  // There and back.
  for(int i = 0; i < 2; ++i)
    if(is_tall == (i == 0))
      add_axis();
    else
      add_equator();

  // The one pierces the other, so both cannot be had, from either side.
  for(int i = 0; i < 2; ++i)
  {
    assert(reconnection(finite_cells(tr), Edges(1, axis), Facets(1, equator)) == Reconnection::NONE);
    assert(reconnection.tetrahedra().empty());
    ++number_of["bipyramid with both required"];
    if(tr.number_of_finite_cells() == 2)
      add_axis();
    else
      add_equator();
  }
}

void test_bipyramids()
{
  const Point a(3, 0, 0), b(-2, 2, 0), c(-2, -3, 0);
  test_bipyramid(Point(0, 0, 7), Point(0, 0, -7), a, b, c);
  test_bipyramid(Point(0, 0, 1), Point(0, 0, -1), a, b, c);
  test_bipyramid(Point(.1, .2, 6.7), Point(-.1, .1, -5.3), a, b, c);
  test_bipyramid(Point(.1, .2, .7), Point(-.1, .1, -.3), a, b, c);
}

// --- twisted prisms --------------------------------------------------------------------------------------------------

// Over a regular n-gon. The diagonals from the bottom at k to the top at k + 1 are within the convex hull.
void test_twisted_prism(const int n, const double degrees)
{
  const double pi = std::acos(-1.);
  Tr tr;
  std::vector<Vertex_handle> v;
  for(int k = 0; k < 2 * n; ++k)
  {
    const double angle = 2 * pi * (k % n) / n + (k < n ? 0 : degrees * pi / 180);
    v.push_back(tr.insert(Point(std::cos(angle), std::sin(angle), k < n ? 0 : 1.5)));
  }
  const Cells cells = finite_cells(tr);
  Edges sides, diagonals;
  for(int k = 0; k < n; ++k)
  {
    const Vertex_handle a = v[k], b = v[(k + 1) % n], c = v[n + (k + 1) % n], d = v[n + k];
    sides.push_back({{ a, b }});
    sides.push_back({{ b, c }});
    sides.push_back({{ c, d }});
    diagonals.push_back({{ a, c }});
  }
  const Predicates predicates(tr);
  Reconnection reconnection(predicates);

  // With all of them, the rest of the hull is the polyhedron of Schoenhardt, or of Rambau: no tetrahedralization.
  Edges all = sides;
  all.insert(all.end(), diagonals.begin(), diagonals.end());
  assert(reconnection(cells, all, Facets()) == Reconnection::NONE);
  assert(reconnection.tetrahedra().empty());
  ++number_of["twisted prism with all diagonals"];

  // One diagonal alone can be had, whichever it is.
  for(const Edge& diagonal : diagonals)
  {
    Edges one = sides;
    one.push_back(diagonal);
    const Tetrahedra result = reconnect(tr, reconnection, finite_cells(tr), one, Facets());
    // Around it is the tetrahedron between it and the hull, and at least two more.
    assert(number_around(result, diagonal) >= 3);
    ++number_of["twisted prism with one diagonal"];
  }
}

// --- limits ----------------------------------------------------------------------------------------------------------

void test_limits()
{
  std::mt19937 rng(9);
  Tr tr;
  for(int i = 0; i < 60; ++i)
    tr.insert(random_point(rng, false));
  const Predicates predicates(tr);
  Reconnection reconnection(predicates);
  const Cells one(1, finite_cells(tr).front()), many = random_cavity(tr, rng, 15);

  const Reconnection::Bounds one_step = { Reconnection::max_number_of_vertices, 0, 1 };
  assert(reconnection(many, Edges(), Facets(), Vertex_handle(), one_step) == Reconnection::GAVE_UP);
  assert(reconnection.tetrahedra().empty());
  ++number_of["gave up: steps"];
  assert(reconnection(one, Edges(), Facets()) == Reconnection::FOUND);
  assert(reconnection.tetrahedra().size() == 1 && number_around(reconnection.tetrahedra(), tetrahedra_of(one)[0]) == 1);
  ++number_of["single tetrahedron"];

  // It was not the polyhedron, but the bound.
  assert(reconnection(many, Edges(), Facets()) == Reconnection::FOUND);

  assert(tr.number_of_vertices() > Reconnection::default_bounds.vertices);
  assert(reconnection(finite_cells(tr), Edges(), Facets()) == Reconnection::GAVE_UP);
  ++number_of["gave up: vertices"];
}

// With as many vertices as can be, one inside is superfluous.
void test_large_polyhedron()
{
  std::mt19937 rng(13);
  Tr tr;
  while(tr.number_of_vertices() < Reconnection::max_number_of_vertices)
    tr.insert(random_point(rng, false));
  const Cells all = finite_cells(tr);
  const Number volume_before = total_volume(tetrahedra_of(all));
  const Vertex_handle v = tr.insert(CGAL::centroid(tr.tetrahedron(all[all.size() / 2])));
  const Cells cells = finite_cells(tr);
  const Predicates predicates(tr);
  Reconnection reconnection(predicates);
  const Reconnection::Bounds large = { Reconnection::max_number_of_vertices, 0, 2000 };
  assert(reconnection(cells, Edges(), Facets(), v, large) == Reconnection::FOUND);
  assert(total_volume(reconnection.tetrahedra()) == volume_before);
  assert(number_around(reconnection.tetrahedra(), std::array<Vertex_handle, 1>{{ v }}) == 0);
  // One vertex too many.
  assert(reconnection(cells, Edges(), Facets(), Vertex_handle(), large) == Reconnection::GAVE_UP);
  ++number_of["large polyhedron"];
}

int main()
{
  test_orientation_table();
  test_full_orientation_table();
  test_cavities(true);
  test_cavities(false);
  test_hulls();
  test_bipyramids();
  test_twisted_prism(3, 30);
  test_twisted_prism(4, 20);
  test_twisted_prism(5, 12);
  test_twisted_prism(6, 8);
  test_limits();
  test_large_polyhedron();

  for(const char* kind : { "crossing edges", "pierced faces", "tetrahedra with a vertex",
                           "grid cavity", "grid cavity with requirements", "grid cavity changed",
                           "double cavity", "double cavity with requirements", "double cavity changed",
                           "hull found", "hull none", "hull with some of its edges",
                           "bipyramid of two cells", "bipyramid of three cells", "bipyramid with both required",
                           "twisted prism with all diagonals", "twisted prism with one diagonal",
                           "gave up: steps", "gave up: vertices", "single tetrahedron",
                           "large polyhedron" })
  {
    std::cout << number_of[kind] << " x " << kind << std::endl;
    assert(number_of[kind] > 0);
  }
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
