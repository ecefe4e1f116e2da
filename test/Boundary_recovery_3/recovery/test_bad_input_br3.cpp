// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// Bad input through recover_boundary(): the defects are named, and the triangulation stays as it was.

#undef NDEBUG
#define CGAL_NDEBUG // as most programs have it: assertions must not be what finds bad input, and with them, numbers of
                    // exact constructions cannot be infinite

#include "mesh_validity_br3.h"
#include "recovery_of_oracles_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
typedef CGAL::Boundary_recovery_3::Input_defect_kind Kind;
typedef CGAL::Boundary_recovery_3::Phase Phase;
using CGAL::Boundary_recovery_3::Recovery_status;
typedef std::vector<std::size_t> Indices;
typedef std::vector<Indices> Faces;
typedef std::vector<std::array<std::size_t, 2> > Edges;
typedef std::pair<int, std::size_t> Name; // dimension and index
typedef std::set<std::vector<Name> > Pairs;

template <typename Tr>
std::set<std::set<const void*> > cells(const Tr& tr)
{
  std::set<std::set<const void*> > result;
  for(const auto c : tr.all_cell_handles())
  {
    std::set<const void*> cell;
    for(int i = 0; i <= tr.dimension(); ++i)
      cell.insert(&*c->vertex(i));
    result.insert(cell);
  }
  return result;
}

template <typename Result>
Pairs defects(const Result& r, const Kind kind)
{
  assert(r.status == Recovery_status::invalid_input && ! r);
  std::ostringstream os;
  os << r;
  assert(os && os.str().find(to_string(kind)) != std::string::npos);
  Pairs pairs;
  for(const auto& d : r.defects)
    if(d.kind == kind)
    {
      std::vector<Name> names;
      for(const auto& s : d.simplices)
        names.emplace_back(s.dimension, s.index);
      assert(pairs.insert(names).second);
    }
  return pairs;
}

// Runs f, which must refuse and change nothing.
template <typename Tr, typename F>
void check_refused(Tr& tr, const F& f, const Kind kind, const Pairs& expected)
{
  const auto n = tr.number_of_vertices();
  const auto before = cells(tr);
  const auto result = f(tr);
  assert(defects(result, kind) == expected);
  assert(tr.number_of_vertices() == n && cells(tr) == before);
}

template <typename K>
struct Test
{
  typedef typename K::Point_3 P;
  typedef std::vector<P> Points;
  typedef CGAL::Delaunay_triangulation_3<K> Dt;

  Points five = { P(-9,-9,-9), P(20,-9,-9), P(-9,20,-9), P(-9,-9,20), P(-5,-5,-5) };
  Points tet = { P(0,0,0), P(4,0,0), P(0,4,0), P(0,0,4) };
  Faces tet_faces = { {0,2,1}, {0,1,3}, {1,2,3}, {2,0,3} };

  void refused(const Points& p, const Faces& f, const Kind k, const Pairs& e, const Edges& edges = Edges())
  {
    Dt tr(five.begin(), five.end());
    check_refused(tr, [&](Dt& t) { return CGAL::recover_boundary(t, p, f, params::constrained_edges(edges)); }, k, e);
  }

  void simple()
  {
    refused({}, {}, Kind::empty_input, {{}});
    refused(tet, {{0,1,7}}, Kind::index_out_of_range, {{{2,0}}});
    refused(tet, {{0,1,2}, {0,1,1}}, Kind::degenerate_facet, {{{2,1}}});
    refused({P(0,0,0), P(1,1,1), P(2,2,2), P(0,1,0)}, {{0,1,2}, {0,1,3}}, Kind::degenerate_facet, {{{2,0}}});
    refused(tet, {{0,1,2}, {1,2,0}, {2,1,0}}, Kind::duplicate_facet, {{{2,0},{2,1}}, {{2,0},{2,2}}});
    refused({P(0,0,0), P(4,0,0), P(0,4,0), P(0,0,4), P(0,0,0)}, {{0,1,2}, {4,1,3}}, Kind::coincident_vertices,
            {{{0,0},{0,4}}});
    refused(tet, {{0,1,2}, {0,1,2,3}}, Kind::not_a_triangle, {{{2,1}}});
    refused(tet, tet_faces, Kind::degenerate_edge, {{{1,1}}}, {{{0,1}}, {{2,2}}});
    Dt empty;
    check_refused(empty, [](Dt& t) { return CGAL::recover_boundary(t, Points{P(0,0,0), P(1,0,0), P(0,1,0)},
                                                                   Faces{{0,1,2}}); },
                  Kind::dimension_less_than_3, {{}});
  }

  void not_finite()
  {
    const double inf = std::numeric_limits<double>::infinity();
    for(const double bad : { std::numeric_limits<double>::quiet_NaN(), inf, -inf })
    {
      Points p = tet;
      p[2] = P(0, bad, 0);
      refused(p, tet_faces, Kind::non_finite_coordinate, {{{0,2}}});
      p[2] = P(0, 0, typename K::FT(bad) * typename K::FT(0)); // not known to be NaN, with exact constructions
      refused(p, tet_faces, Kind::non_finite_coordinate, {{{0,2}}});
    }
  }

  // With exact constructions, numbers beyond the range of double are finite.
  void huge()
  {
    typedef typename K::FT FT;
    const FT huge = FT(1e308) * FT(1e308);
    Dt tr;
    const auto result = CGAL::recover_boundary(tr, Points{ P(0,0,0), P(huge,0,0), P(0,4,0), P(0,0,-huge) }, tet_faces);
    assert(result && result.number_of_facets == 4);
  }

  void crossing(const Points& p, const Faces& f, const Pairs& e, const Edges& edges = Edges())
  {
    Dt tr(five.begin(), five.end());
    check_refused(tr, [&](Dt& t) { return CGAL::recover_boundary(t, p, f, params::constrained_edges(edges),
                                                                 params::list_defects(true)); },
                  Kind::intersecting_constraints, e);
    const auto r = CGAL::recover_boundary(tr, p, f, params::constrained_edges(edges));
    assert(defects(r, Kind::intersecting_constraints) == e);
    assert(br3_test::is_valid_mesh(tr));
  }

  void intersections()
  {
    const Pairs both = {{{2,0},{2,1}}};
    const Faces two = {{0,1,2}, {3,4,5}};
    const auto with = [&](const P& a, const P& b, const P& c) { return Points{tet[0], tet[1], tet[2], a, b, c}; };
    crossing(with(P(1,1,-1), P(1,1,1), P(9,9,1)), two, both);
    crossing(with(P(1,1,0), P(1,1,1), P(1,2,3)), two, both);         // a vertex inside
    crossing(with(P(2,-1,-1), P(2,1,1), P(2,-5,3)), two, both);      // an edge through an edge
    crossing(with(P(1,1,0), P(5,1,0), P(1,5,0)), two, both);         // coplanar overlap
    crossing({tet[0], tet[1], tet[2], P(1,1,-1), P(1,1,1)}, {{0,1,2}}, {{{1,0},{2,0}}}, {{{3,4}}});
    // The spike 4 of a tetrahedron pierces the facet 0 of another one.
    Points p = tet;
    for(const P& q : { P(1,1,1), P(.5,.5,-3), P(2,.5,-3), P(.5,2,-3) })
      p.push_back(q);
    Faces f = tet_faces;
    for(const Indices& t : { Indices{4,6,5}, {4,5,7}, {5,6,7}, {6,4,7} })
      f.push_back(t);
    crossing(p, f, {{{2,0},{2,4}}, {{2,0},{2,5}}, {{2,0},{2,7}}});
    // One ulp above the facet is no intersection.
    const double ulp = std::nextafter(0., 1.);
    Dt tr;
    assert(CGAL::recover_boundary(tr, with(P(1,1,ulp), P(1,1,1), P(1,2,3)), two, params::list_defects(true)).status
           != Recovery_status::invalid_input);
  }

  void foreign_vertices()
  {
    for(const P& foreign : { P(1,1,0), P(2,0,0) })
    {
      Dt tr(five.begin(), five.end());
      tr.insert(foreign);
      const Pairs found = defects(CGAL::recover_boundary(tr, tet, tet_faces), Kind::intersecting_constraints);
      assert(found.count({{0,std::size_t(-1)}, {2,0}}) == 1);
      assert(found.count({{0,std::size_t(-1)}, {1,std::size_t(-1)}}) == (foreign == P(2,0,0) ? 1u : 0u));
    }
  }

  // On an edge that belongs to no facet, and inside a facet that stands alone: in all the modes, looked for at once or
  // in the end. Beside them it is no harm.
  void foreign_vertices_on_single_constraints()
  {
    using CGAL::Boundary_recovery_3::Recovery_mode;
    const Points p = { P(0,0,0), P(4,4,0), P(0,4,0), P(4,0,0), P(1,2,7) };
    for(const bool is_edge : { true, false })
      for(const P& foreign : { P(2,2,0), P(1,3,0), P(2,2,1) })
        for(const Recovery_mode mode : { Recovery_mode::constrained, Recovery_mode::conforming,
                                         Recovery_mode::flips_only })
          for(const bool is_first : { true, false })
          {
            Dt tr(five.begin(), five.end());
            const auto v = tr.insert(foreign);
            const auto r = CGAL::recover_boundary(tr, p, is_edge ? Faces() : Faces{{0,1,2}},
                                                  params::recovery_mode(mode), params::list_defects(is_first),
                                                  params::constrained_edges(is_edge ? Edges{{{0,1}}} : Edges()));
            const bool is_on_edge = foreign == P(2,2,0), is_on_facet = ! is_edge && foreign != P(2,2,1);
            assert(v->point() == foreign && tr.tds().is_valid());
            Pairs expected;
            if(is_on_edge)
              expected.insert({{0,std::size_t(-1)}, {1, is_edge ? 0 : std::size_t(-1)}});
            if(is_on_facet)
              expected.insert({{0,std::size_t(-1)}, {2,0}});
            if(expected.empty())
              assert(r && r.defects.empty());
            else
              assert(defects(r, Kind::intersecting_constraints) == expected);
          }
  }

  void handles()
  {
    typedef typename Dt::Vertex_handle V;
    typedef std::vector<std::array<V, 3> > Facets;
    Dt tr(five.begin(), five.end());
    std::vector<V> v;
    for(const V w : tr.finite_vertex_handles())
      v.push_back(w);
    const auto check = [](Dt& t, const Facets& f, const Kind k, const Pairs& e)
                       { check_refused(t, [&](Dt& s) { return CGAL::recover_boundary(s, f); }, k, e); };
    check(tr, {{{v[0], v[1], V()}}}, Kind::unknown_vertex, {{{0,2}}});
    check(tr, {{{v[0], tr.infinite_vertex(), v[1]}}}, Kind::unknown_vertex, {{{0,1}}});
    check(tr, {{{v[0], v[1], v[2]}}, {{v[1], v[0], v[2]}}}, Kind::duplicate_facet, {{{2,0},{2,1}}});
    Dt flat;
    const V a = flat.insert(P(0,0,0)), b = flat.insert(P(1,0,0)), c = flat.insert(P(0,1,0));
    check(flat, {{{a, b, c}}}, Kind::dimension_less_than_3, {{}});
  }

  void polygons()
  {
    CGAL::Surface_mesh<P> m;
    const auto a = m.add_vertex(P(0,0,0)), b = m.add_vertex(P(1,0,0)), c = m.add_vertex(P(1,1,0));
    const auto d = m.add_vertex(P(0,1,0)), e = m.add_vertex(P(0,0,1));
    m.add_face(a, e, b);
    m.add_face(a, b, c, d);
    Dt tr(five.begin(), five.end());
    check_refused(tr, [&](Dt& t) { return CGAL::recover_boundary(t, m); }, Kind::not_a_triangle, {{{2,1}}});
  }

  // Says stop once, at one of the questions; who is asked again says something else. No points are inserted then.
  struct Stopping_visitor : CGAL::Default_meshing_visitor_3
  {
    explicit Stopping_visitor(const std::size_t last_question) : last_question(last_question) { }

    bool go_further() { return number_of_questions++ != last_question; }
    bool has_stopped() const { return number_of_questions > last_question; }
    void on_phase_begin(const Phase phase) { assert(phase != Phase::insertion || ! has_stopped()); }

    std::size_t last_question;
    std::size_t number_of_questions = 0;
  };

  // Missing is what is not in the triangulation.
  template <typename Result>
  static void check_missing(const Dt& tr, const Faces& faces, const Result& r)
  {
    std::set<std::size_t> missing_facets;
    for(const auto& f : r.missing_facets)
      missing_facets.insert(f.index);
    std::set<std::set<std::size_t> > missing_edges;
    for(const auto& e : r.missing_edges)
      missing_edges.emplace(e.vertices.begin(), e.vertices.end());
    typename Dt::Cell_handle c;
    int i, j, k;
    for(std::size_t f = 0; f < faces.size(); ++f)
    {
      const auto vertex = [&](const int n) { return r.vertices.at(faces[f][n % 3]); };
      const auto is_known = [&](const int n) { return vertex(n) != typename Dt::Vertex_handle(); };
      assert(missing_facets.count(f) == ! (is_known(0) && is_known(1) && is_known(2)
                                           && tr.is_facet(vertex(0), vertex(1), vertex(2), c, i, j, k)));
      for(int n = 0; n < 3; ++n)
        assert(missing_edges.count({ faces[f][n], faces[f][(n + 1) % 3] })
               == ! (is_known(n) && is_known(n + 1) && tr.is_edge(vertex(n), vertex(n + 1), c, i, j)));
    }
  }

  // Stops invalid input at each question: nobody is told then that it is valid, nor some of the defects, and no points
  // are added. `others` are in the triangulation before. Returns the number of questions.
  static std::size_t stop_everywhere(const Points& p, const Faces& faces, const Points& others, const bool is_first)
  {
    for(std::size_t k = 0; ; ++k)
    {
      Dt tr(others.begin(), others.end());
      Stopping_visitor visitor(k);
      const auto r = CGAL::recover_boundary(tr, p, faces, params::list_defects(is_first),
                                            params::visitor(std::ref(visitor)));
      if(! visitor.has_stopped())
      {
        assert(! defects(r, Kind::intersecting_constraints).empty());
        return k;
      }
      assert(r.status == Recovery_status::stopped && r.defects.empty() && r.steiner_vertices.empty());
      check_missing(tr, faces, r);
      const bool has_inserted = std::any_of(r.phases.begin(), r.phases.end(),
                                            [](const auto& report) { return report.phase == Phase::insertion; });
      assert(has_inserted ? k > 0 || ! is_first : tr.number_of_vertices() == others.size());
      assert(tr.tds().is_valid() && tr.number_of_vertices() <= p.size() + others.size());
    }
  }

  // A fan, all of whose boxes overlap.
  static void make_fan(Points& p, Faces& faces)
  {
    const std::size_t n = 60;
    for(std::size_t i = 0; i <= n; ++i)
      p.push_back(P(double(i), double(i * i), 0));
    p.push_back(P(0,0,100));
    for(std::size_t i = 0; i < n; ++i)
      faces.push_back({ i, i + 1, n + 1 });
  }

  void stopped_on_invalid_input()
  {
    Points fan;
    Faces faces;
    make_fan(fan, faces);
    const Points on_the_fan = { P(15.25,465.25,50) };
    Points with_cut = fan;
    Faces faces_with_cut = faces;
    with_cut.insert(with_cut.end(), { P(-10,50,50), P(90,50,50), P(30,60,60) });
    faces_with_cut.push_back({ fan.size(), fan.size() + 1, fan.size() + 2 });
    for(const bool is_first : { true, false })
    {
      assert(stop_everywhere(with_cut, faces_with_cut, {}, is_first) > 0);
      assert(stop_everywhere(fan, faces, on_the_fan, is_first) > 2);
    }
  }

  // What needs no search is told, though the search for other defects was stopped.
  void stopped_on_wrong_triangulation()
  {
    Points fan;
    Faces faces;
    make_fan(fan, faces);
    fan.back() = P(0,4000,0);
    Dt flat(fan.begin(), fan.end());
    Stopping_visitor visitor(0);
    const auto r = CGAL::recover_boundary(flat, fan, faces, params::list_defects(true),
                                          params::visitor(std::ref(visitor)));
    assert(visitor.has_stopped() && r.defects.size() == 1 && r.defects[0].kind == Kind::dimension_less_than_3);
  }

  // What is in the triangulation is not missing because the search for defects was stopped.
  void stopped_on_valid_input()
  {
    Points p;
    Faces faces;
    make_fan(p, faces);
    Dt tr;
    const auto first = CGAL::recover_boundary(tr, p, faces);
    assert(first);
    std::size_t k = 0;
    for(bool has_stopped = true; has_stopped; ++k)
    {
      Stopping_visitor visitor(k);
      assert(CGAL::recover_boundary(tr, p, faces, params::list_defects(true), params::visitor(std::ref(visitor))));
      has_stopped = visitor.has_stopped();
    }
    assert(k > 2);

    // in the order in which the facets name them, as the indices of vertex handles are
    Faces faces_of_handles;
    for(std::size_t i = 0; i < faces.size(); ++i)
      faces_of_handles.push_back({ i < 2 ? i : i + 1, i < 1 ? i + 1 : i + 2, 2 });
    std::vector<std::array<typename Dt::Vertex_handle, 3> > facets;
    Dt delaunay;
    std::vector<typename Dt::Vertex_handle> vertices;
    for(const P& q : p)
      vertices.push_back(delaunay.insert(q));
    for(const auto& f : faces)
    {
      facets.push_back({{ vertices[f[0]], vertices[f[1]], vertices[f[2]] }});
      delaunay.insert(CGAL::midpoint(p[f[0]], p[f[2]]) + typename K::Vector_3(0.25,0,0)); // beside the fan
    }
    const auto before = cells(delaunay);
    Stopping_visitor visitor(0);
    const auto r = CGAL::recover_boundary(delaunay, facets, params::list_defects(true),
                                          params::visitor(std::ref(visitor)));
    assert(r.status == Recovery_status::stopped && cells(delaunay) == before);
    assert(r.missing_edges.size() > 0 && r.missing_edges.size() < 2 * faces.size() + 1);
    check_missing(delaunay, faces_of_handles, r);
  }

  void run()
  {
    simple();
    not_finite();
    if(CGAL::Algebraic_structure_traits<typename K::FT>::Is_exact::value)
      huge();
    intersections();
    foreign_vertices();
    foreign_vertices_on_single_constraints();
    handles();
    polygons();
    stopped_on_invalid_input();
    stopped_on_wrong_triangulation();
    stopped_on_valid_input();
  }
};

int main()
{
  Test<CGAL::Exact_predicates_inexact_constructions_kernel>().run();
  Test<CGAL::Exact_predicates_exact_constructions_kernel>().run();
  std::cout << "done" << std::endl;
}
