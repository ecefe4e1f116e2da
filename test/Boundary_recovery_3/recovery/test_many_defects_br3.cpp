// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors
// Input with very many defects: it is refused after little work, valid input does not notice that it was searched, and
// the list of defects is as long as one wants.

#undef NDEBUG
#define CGAL_NDEBUG // assertions of CGAL take most of the time here

#include "mesh_validity_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <functional>
#include <iostream>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace params = CGAL::parameters;
typedef CGAL::Exact_predicates_inexact_constructions_kernel        Kernel;
typedef Kernel::Point_3                                            Point_3;
typedef CGAL::Delaunay_triangulation_3<Kernel>                     Triangulation;
typedef Triangulation::Vertex_handle                               Vertex_handle;
typedef CGAL::Boundary_recovery_result_3<Triangulation>            Result;
typedef CGAL::Boundary_recovery_3::Input_defect_kind               Kind;
typedef CGAL::Boundary_recovery_3::Phase                  Phase;
typedef CGAL::Boundary_recovery_3::Recovery_status                 Status;

struct Soup
{
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t> > faces;

  void add(const std::array<Point_3, 3>& triangle)
  {
    const std::size_t n = points.size();
    points.insert(points.end(), triangle.begin(), triangle.end());
    faces.push_back({ n, n + 1, n + 2 });
  }
};

// Two families of k long triangles, of which each crosses all of the other family. With corners on few lines, their
// Delaunay triangulation has about k^2 cells.
Soup crossing_families(const std::size_t k, const bool is_on_lines)
{
  std::minstd_rand random(1);
  const auto noise = [&](const double size)
  {
    return is_on_lines ? 0. : size * (static_cast<double>(random() % 1000) / 500 - 1);
  };
  Soup soup;
  for(std::size_t i = 0; i < k; ++i)
  {
    const double t = 10 * (static_cast<double>(i) + .5) / static_cast<double>(k);
    // braces, as only in them the order of the random numbers is the same with all compilers
    soup.add({ Point_3{ -1 + noise(.1), t + noise(.2), noise(.3) }, Point_3{ 11 + noise(.1), t + noise(.2), noise(.3) },
               Point_3{ 5 + noise(1), t, 8 + noise(1) } });
    soup.add({ Point_3{ t + noise(.2), -1 + noise(.1), 3 + noise(.3) },
               Point_3{ t + noise(.2), 11 + noise(.1), 3 + noise(.3) }, Point_3{ t, 5 + noise(1), -5 + noise(1) } });
  }
  return soup;
}

std::string text(const Result& result)
{
  std::ostringstream os;
  for(const auto& defect : result.defects)
    os << defect << '\n';
  return os.str();
}

bool has_run(const Result& result, const Phase phase)
{
  return std::any_of(result.phases.begin(), result.phases.end(), [&](const auto& p) { return p.phase == phase; });
}

struct Phase_counter
  : public CGAL::Default_meshing_visitor_3
{
  void on_phase_begin(const Phase) { ++number_of_begins; }
  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report&) { ++number_of_ends; }
  int number_of_begins = 0, number_of_ends = 0;
};

// Intersections are found before the first recursion; those that are named are those that `list_defects` names.
void test_crossing_families_are_refused_early()
{
  const Soup soup = crossing_families(120, false);
  Triangulation tr;
  Phase_counter visitor;
  const Result result = CGAL::recover_boundary(tr, soup.points, soup.faces, params::visitor(std::ref(visitor)));
  assert(result.status == Status::invalid_input && result.vertices.empty());
  assert(has_run(result, Phase::plain_removal) && ! has_run(result, Phase::edge_recovery_brc1));
  assert(visitor.number_of_begins == visitor.number_of_ends);
  assert(result.number_of_defects == result.defects.size() && br3_test::is_valid_mesh(tr));
  assert(! result.missing_edges.empty() && ! result.missing_facets.empty());
  assert(tr.number_of_vertices() == soup.points.size() && result.steiner_vertices.empty());

  Triangulation unchanged;
  const Result expected = CGAL::recover_boundary(unchanged, soup.points, soup.faces, params::list_defects(true));
  assert(text(result) == text(expected) && unchanged.number_of_vertices() == 0);
}

// Where only two of the many missing constraints intersect, they are found after some more work.
void test_few_defects_among_many_difficulties()
{
  Soup soup = crossing_families(1, false);
  const std::size_t n = soup.points.size();
  const br3_test::Plc plc = br3_test::Notched_box(32, 1).plc();
  for(const auto& c : plc.points)
    soup.points.emplace_back(100 + c[0], c[1], c[2]);
  for(const auto& t : plc.triangles)
    soup.faces.push_back({ n + t[0], n + t[1], n + t[2] });
  Triangulation tr;
  const Result result = CGAL::recover_boundary(tr, soup.points, soup.faces);
  assert(result.status == Status::invalid_input && result.number_of_defects == 1);
  assert(has_run(result, Phase::edge_recovery_brc1) && ! has_run(result, Phase::edge_recovery_brc3));
}

// What is said to be missing is what is missing, though the work ended in the middle.
void test_missing_constraints_of_refused_input()
{
  const Soup soup = crossing_families(60, false);
  Triangulation tr(soup.points.begin(), soup.points.end());
  std::vector<Vertex_handle> vertices(soup.points.size());
  for(const Vertex_handle v : tr.finite_vertex_handles())
    vertices[std::find(soup.points.begin(), soup.points.end(), v->point()) - soup.points.begin()] = v;
  const Result result = CGAL::recover_boundary(tr, soup.points, soup.faces);
  assert(result.status == Status::invalid_input);
  std::set<std::size_t> missing;
  for(const auto& facet : result.missing_facets)
    assert(missing.insert(facet.index).second);
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
  {
    Triangulation::Cell_handle c;
    int i, j, k;
    const auto& t = soup.faces[f];
    assert(tr.is_facet(vertices[t[0]], vertices[t[1]], vertices[t[2]], c, i, j, k) != (missing.count(f) == 1));
  }
}

// Where points on lines make quadratically many cells, not even all of them are inserted.
void test_insertion_ends_early()
{
  const Soup soup = crossing_families(1000, true);
  Triangulation tr;
  const Result result = CGAL::recover_boundary(tr, soup.points, soup.faces, params::maximum_number_of_defects(10));
  assert(result.status == Status::invalid_input && result.defects.size() == 10 && result.number_of_defects > 10);
  assert(tr.number_of_vertices() < soup.points.size() && ! has_run(result, Phase::search));
  assert(br3_test::is_valid_mesh(tr));
}

// The search does not change what is done with valid input, here one that takes so much work that it is searched.
void test_valid_input_does_not_notice()
{
  const br3_test::Plc plc = br3_test::Notched_box(4, 1).plc();
  std::vector<Point_3> points;
  for(const auto& c : plc.points)
    points.emplace_back(c[0], c[1], c[2]);
  Triangulation searched_first, searched_meanwhile;
  const Result a = CGAL::recover_boundary(searched_first, points, plc.triangles, params::list_defects(true));
  const Result b = CGAL::recover_boundary(searched_meanwhile, points, plc.triangles);
  assert(a && b && ! b.steiner_vertices.empty());
  assert(a.number_of_shell_transformations == b.number_of_shell_transformations);
  std::ostringstream as, bs; // in the order in which vertices and cells are stored
  as << searched_first;
  bs << searched_meanwhile;
  assert(as.str() == bs.str());
}

// The list has the first defects of all; the number tells whether there are more.
void test_bounded_list_of_intersections()
{
  const std::size_t k = 40;
  const Soup soup = crossing_families(k, true);
  Triangulation all_tr;
  const Result all = CGAL::recover_boundary(all_tr, soup.points, soup.faces, params::list_defects(true));
  const std::size_t n = all.defects.size();
  assert(n == k * k && all.number_of_defects == n);
  for(const bool is_first : { true, false })
    for(const std::size_t max_number : { std::size_t(0), std::size_t(1), k, n - 1, n, n + 1 })
    {
      Triangulation tr;
      const Result some = CGAL::recover_boundary(tr, soup.points, soup.faces, params::list_defects(is_first),
                                                 params::maximum_number_of_defects(max_number));
      assert(some.status == Status::invalid_input && some.defects.size() == (std::min)(max_number, n));
      assert(some.number_of_defects <= n && (some.number_of_defects > max_number) == (n > max_number));
      assert(some.number_of_defects > 0 && text(all).compare(0, text(some).size(), text(some)) == 0);
      std::ostringstream os;
      os << some;
      assert((os.str().find("of at least") != std::string::npos) == (n > max_number));
    }
}

void check_bounded(const Result& result, const Kind kind, const std::size_t number, const std::size_t max_number)
{
  assert(result.status == Status::invalid_input && result.number_of_defects == number);
  assert(result.defects.size() == (std::min)(number, max_number));
  for(const auto& defect : result.defects)
    assert(defect.kind == kind);
}

// Defects of the other kinds are counted.
void test_bounded_lists_of_other_defects()
{
  const std::vector<Point_3> points = { Point_3(0,0,0), Point_3(4,0,0), Point_3(0,4,0), Point_3(0,0,4) };
  typedef std::vector<std::vector<std::size_t> > Faces;
  for(const std::size_t max_number : { 0, 1, 2, 3, 4 })
  {
    const auto bound = params::maximum_number_of_defects(max_number);
    Triangulation tr(points.begin(), points.end());
    check_bounded(CGAL::recover_boundary(tr, points, Faces{ {0,1,1}, {0,1,2}, {2,2,3}, {3,3,3} }, bound),
                  Kind::degenerate_facet, 3, max_number);
    check_bounded(CGAL::recover_boundary(tr, points, Faces{ {0,1}, {0,1,2}, {0,1,2,3}, {} }, bound),
                  Kind::not_a_triangle, 3, max_number);
    const std::vector<std::array<Vertex_handle, 3> > facets
      = { {{ Vertex_handle(), tr.infinite_vertex(), tr.finite_vertices_begin() }} };
    check_bounded(CGAL::recover_boundary(tr, facets, bound), Kind::unknown_vertex, 2, max_number);
    tr.insert(Point_3(1, 1, 0)); // on one facet
    tr.insert(Point_3(2, 0, 0)); // on an edge of two
    for(const bool is_first : { true, false })
      check_bounded(CGAL::recover_boundary(tr, points, Faces{ {0,2,1}, {0,1,3} }, bound,
                                           params::list_defects(is_first)),
                    Kind::intersecting_constraints, 4, max_number);
  }
}

int main()
{
  test_crossing_families_are_refused_early();
  test_few_defects_among_many_difficulties();
  test_missing_constraints_of_refused_input();
  test_insertion_ends_early();
  test_valid_input_does_not_notice();
  test_bounded_list_of_intersections();
  test_bounded_lists_of_other_defects();
  std::cout << "done" << std::endl;
}
