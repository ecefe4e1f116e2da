// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The phases with Steiner points, one by one and without any flips before, so that every lost constraint is full of
// points; what the visitor is told of them; what is left when they are stopped; and inputs of all sizes.
// The expensive assertions look at every cell after each Steiner point that is inserted, split or removed.

#undef NDEBUG

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/QP_functions.h>

// What CGAL_CHECK_EXPENSIVE does, but only below: some of CGAL's own headers do not compile with it.
#undef CGAL_expensive_assertion
#undef CGAL_expensive_postcondition
#define CGAL_expensive_assertion(EX) CGAL_assertion(EX)
#define CGAL_expensive_postcondition(EX) CGAL_postcondition(EX)

#include "brute_force_checker_br3.h"
#include "cell_mirror_br3.h"
#include "constraint_parts_checker_br3.h"
#include "mesh_validity_br3.h"
#include "recovery_of_oracles_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Boundary_recovery_3/internal/steiner/Conforming_recovery_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Constraint_parts_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Round_steiner_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Split_off_steiner_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Suppress_steiner_points_3.h>
#include <CGAL/Constrained_boundary_recovery_3.h>
#include <CGAL/recover_boundary.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

using br3_test::Cell_mirror;
using br3_test::Coordinates;
using br3_test::Plc;
using br3_test::Simplex;
using br3_test::require;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Epeck;
typedef CGAL::Boundary_recovery_3::Recovery_mode            Recovery_mode;
typedef CGAL::Boundary_recovery_3::Phase           Phase;
typedef CGAL::Boundary_recovery_3::Recovery_status          Status;

#ifndef BR3_TEST_EPICK_ONLY
const std::size_t number_of_kernels = 2;
#else
const std::size_t number_of_kernels = 1; // to save time where compiling is slow
#endif

std::size_t number_of_failures = 0;

template <typename Check>
void catch_complaints(const std::string& name, const Check& check)
{
  try {
    check();
  } catch(const std::exception& e) {
    std::cerr << name << ": " << e.what() << std::endl;
    ++number_of_failures;
  }
}

struct Totals
{
  std::size_t on_edges = 0, on_facets = 0, removed = 0;
};

// Runs the phases on one input, and checks the triangulation after each.
template <typename K>
class Phase_by_phase
{
public:
  typedef CGAL::Delaunay_triangulation_3<K>                     Tr;
  typedef typename Tr::Vertex_handle                            Vertex_handle;
  typedef br3_test::Constraint_parts_checker<Tr>                Checker;
  typedef typename Checker::Vertices                            Vertices;
  typedef CGAL::Constrained_boundary_recovery_3<Tr, Cell_mirror<Tr> > Recovery;

  explicit Phase_by_phase(const Plc& plc)
    : m_vertices(insert(plc)), m_mirror(m_tr), m_recovery(m_tr, m_mirror)
  {
    for(const Simplex& e : plc.edges)
      m_recovery.insert_constraint(m_vertices[e[0]], m_vertices[e[1]]);
    for(const Simplex& t : plc.triangles)
      m_recovery.insert_constraint(m_vertices[t[0]], m_vertices[t[1]], m_vertices[t[2]]);
    for(const auto c : m_tr.finite_cell_handles())
      m_volume += volume(c);
  }

  void operator()(Totals& totals)
  {
    m_recovery.search();
    m_recovery.recover_conforming();
    check_conformity();
    totals.on_edges += ! m_recovery.split_edges().empty();
    totals.on_facets += m_recovery.split_facets().size() > m_recovery.split_edges().size();

    require(m_recovery.split_steiner_points(), "points are left on constraints");
    require(m_recovery.split_edges().empty() && m_recovery.split_facets().empty(), "a constraint is still split");
    check_mesh(is_exact);
    check_constraints();
    const std::size_t before = m_recovery.steiner_vertices().size();

    require(m_recovery.suppress_steiner_points(), "a point has no position in floating point numbers");
    require(m_recovery.steiner_vertices().size() <= before, "suppression adds points");
    totals.removed += before - m_recovery.steiner_vertices().size();
    check_mesh(true);
    check_constraints();
    m_recovery.recount();
    require(m_recovery.lost_edges().empty() && m_recovery.lost_facets().empty(), "something is lost in the end");
  }

private:
  static constexpr bool is_exact = std::is_same<K, Epeck>::value;

  Vertices insert(const Plc& plc)
  {
    Vertices result;
    for(const Coordinates& c : plc.points)
    {
      m_points.emplace_back(c[0], c[1], c[2]);
      result.push_back(m_tr.insert(m_points.back()));
    }
    return result;
  }

  template <typename Cell_handle>
  static br3_test::Rational volume(const Cell_handle c)
  {
    return br3_test::volume(br3_test::to_rational(c->vertex(0)->point()), br3_test::to_rational(c->vertex(1)->point()),
                            br3_test::to_rational(c->vertex(2)->point()), br3_test::to_rational(c->vertex(3)->point()));
  }

  // Points that are on constraints, or in a polyhedron too flat for them, have positions that the triangulation cannot
  // store; cells may be inverted then.
  void check_mesh(const bool are_positions_exact) const
  {
    require(m_tr.tds().is_valid(), "the data structure is not valid");
    m_mirror.check(m_tr);
    br3_test::Rational sum = 0;
    for(const auto c : m_tr.finite_cell_handles())
    {
      const br3_test::Rational v = volume(c);
      require(! are_positions_exact || v > 0, "a cell is flat or inverted");
      sum += v;
    }
    require(! are_positions_exact || sum == m_volume, "the cells do not fill the convex hull");
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      require(m_vertices[i]->point() == m_points[i], "an input vertex has moved");
    require(m_tr.number_of_vertices() == m_points.size() + m_recovery.steiner_vertices().size(),
            "Steiner vertices are miscounted");
  }

  // Each constraint is a union of mesh simplices.
  void check_conformity() const
  {
    require(m_recovery.lost_edges().empty() && m_recovery.lost_facets().empty(), "points do not recover everything");
    check_mesh(is_exact);
    const Checker checker(m_tr);
    for(std::size_t e = 0; e < m_recovery.constrained_edges().size(); ++e)
      checker.check_edge(to_vector(m_recovery.constrained_edges()[e]), parts_of_edge(e));
    for(std::size_t f = 0; f < m_recovery.constrained_facets().size(); ++f)
    {
      const auto& facet = m_recovery.constrained_facets()[f];
      typename Checker::Edges rim;
      for(int i = 0; i < 3; ++i)
        for(const Vertices& part : parts_of_edge(m_recovery.index(facet[i], facet[(i + 1) % 3])))
          rim.insert(Checker::edge(part[0], part[1]));
      std::vector<Vertices> parts;
      for(const auto& part : m_recovery.parts_of_facet(f))
        parts.push_back(to_vector(part));
      checker.check_facet(to_vector(facet), parts, rim);
    }
  }

  // In the order of the documentation: from the first vertex to the second.
  std::vector<Vertices> parts_of_edge(const std::size_t e) const
  {
    std::vector<Vertices> result;
    for(const auto& part : m_recovery.parts_of_edge(e))
    {
      require(part[0] == (result.empty() ? m_recovery.constrained_edges()[e][0] : result.back()[1]),
              "the parts of an edge are not in order");
      result.push_back(to_vector(part));
    }
    require(! result.empty() && result.back()[1] == m_recovery.constrained_edges()[e][1],
            "the parts of an edge do not end at its second vertex");
    return result;
  }

  template <std::size_t n>
  static Vertices to_vector(const std::array<Vertex_handle, n>& vertices)
  {
    return Vertices(vertices.begin(), vertices.end());
  }

  // Each constraint is one mesh simplex.
  void check_constraints() const
  {
    typename Tr::Cell_handle c;
    int i, j, k;
    for(const auto& e : m_recovery.constrained_edges())
      require(m_tr.is_edge(e[0], e[1], c, i, j), "a constrained edge is not in the mesh");
    for(const auto& f : m_recovery.constrained_facets())
      require(m_tr.is_facet(f[0], f[1], f[2], c, i, j, k), "a constrained facet is not in the mesh");
  }

  Tr m_tr;
  std::vector<typename K::Point_3> m_points;
  const Vertices m_vertices;
  Cell_mirror<Tr> m_mirror;
  Recovery m_recovery;
  br3_test::Rational m_volume = 0;
};

void check_phases(const std::string& name, const Plc& plc, Totals& totals)
{
  catch_complaints(name + ", Epick", [&] { Phase_by_phase<Epick> phases(plc); phases(totals); });
#ifndef BR3_TEST_EPICK_ONLY
  catch_complaints(name + ", Epeck", [&] { Phase_by_phase<Epeck> phases(plc); phases(totals); });
#endif
}

void test_phases()
{
  Totals totals;
  check_phases("schoenhardt", br3_test::twisted_prism(3, .3, 1000, 1000), totals);
  check_phases("prism", br3_test::twisted_prism(7, .3, 1000, 1000), totals);
  check_phases("notched box", br3_test::Notched_box(1, 1).plc(), totals);
  for(unsigned seed = 0; seed < 16; ++seed)
    check_phases("random " + std::to_string(seed),
                 br3_test::Random_constraints(seed)(6 + static_cast<int>(seed) % 9, seed % 2 == 0 ? 4 : 40, 60, 40),
                 totals);
  for(std::size_t blades = 0; blades <= 4; ++blades)
    for(unsigned seed = 0; seed < 3; ++seed)
      check_phases("fan " + std::to_string(blades) + ' ' + std::to_string(seed),
                   br3_test::Random_constraints(seed).fan(blades, 14), totals);
  for(unsigned diagonals = 0; diagonals < 64; diagonals += 9)
    check_phases("box " + std::to_string(diagonals), br3_test::box(diagonals, diagonals % 2 == 0), totals);
  for(unsigned seed = 0; seed < 4; ++seed)
    check_phases("flat hull " + std::to_string(seed), br3_test::flat_hull(seed, 12), totals);
  assert(totals.on_edges > 10 * number_of_kernels && totals.on_facets >= 2 * number_of_kernels
         && totals.removed > 25 * number_of_kernels);
}

// Counts the questions of each phase, and answers no to one of them, or to the first one after a phase.
template <typename Tr>
struct Stopping_visitor
  : public Cell_mirror<Tr>
{
  static constexpr std::size_t after_the_phase = 0;

  explicit Stopping_visitor(const Tr& tr) : Cell_mirror<Tr>(tr) { }

  void on_phase_begin(const Phase phase) { current = phase; }

  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report& report)
  {
    is_over = is_over || (report.phase == last_phase && last_question == after_the_phase);
  }

  bool go_further() { return ! is_over && (++questions[current] != last_question || current != last_phase); }

  bool is_over = false;
  Phase current = Phase::insertion, last_phase = Phase::insertion;
  std::size_t last_question = (std::numeric_limits<std::size_t>::max)();
  std::map<Phase, std::size_t> questions;
};

// Recoveries of one input that are stopped, judged as if they just did not find more.
template <typename K>
class Stopped_recoveries
{
public:
  typedef CGAL::Delaunay_triangulation_3<K>   Tr;
  typedef Stopping_visitor<Tr>                Visitor;

  Stopped_recoveries(const Plc& plc, const Recovery_mode mode) : m_plc(plc), m_expectation(plc), m_mode(mode) { }

  // Returns the number of recoveries that were stopped before everything was there.
  std::size_t operator()(const Phase phase) const
  {
    const std::size_t n = questions(phase);
    std::size_t result = 0;
    for(const std::size_t i : std::set<std::size_t>{ 1, 2, 3, n / 4, n / 2, n - 1, n })
      if(i > 0 && i <= n)
        result += recover(phase, i, std::numeric_limits<double>::infinity()).status == Status::stopped;
    return result;
  }

  std::size_t after(const double seconds) const
  {
    return recover(Phase::insertion, never, seconds).status == Status::stopped;
  }

  // The later suppression is stopped, the fewer points are left. Stopped before it begins, it leaves all of them.
  void check_suppression() const
  {
    const double for_ever = std::numeric_limits<double>::infinity();
    const Result at_once = recover(Phase::steiner_splitting, Visitor::after_the_phase, for_ever);
    require(at_once.status == Status::recovered, "a stop between splitting and suppression loses something");
    require(at_once.steiner_vertices.size() == at_once.number_of_steiner_points, "a point is gone, or is too many");
    const std::size_t n = questions(Phase::steiner_suppression), step = 1 + n / 40;
    require(at_once.number_of_steiner_points == 0 || n > 0, "suppression cannot be stopped");
    std::size_t left = at_once.steiner_vertices.size();
    for(std::size_t i = 1; i <= n + 1; i += step)
    {
      const Result result = recover(Phase::steiner_suppression, i, for_ever);
      require(result.steiner_vertices.size() <= left, "a later stop leaves more points");
      left = result.steiner_vertices.size();
    }
    const Result unstopped = recover(Phase::insertion, never, for_ever);
    require(unstopped.status == Status::recovered && unstopped.steiner_vertices.size() <= left,
            "a stop leaves fewer points");
  }

private:
  typedef CGAL::Boundary_recovery_result_3<Tr> Result;

  static constexpr std::size_t never = (std::numeric_limits<std::size_t>::max)();

  std::size_t questions(const Phase phase) const
  {
    Tr tr;
    insert(tr);
    Visitor visitor(tr);
    const auto result = CGAL::recover_boundary(tr, m_points, m_plc.triangles, CGAL::parameters::recovery_mode(m_mode),
                                               CGAL::parameters::constrained_edges(m_plc.edges)
                                                 .visitor(std::ref(visitor)));
    require(bool(result), "not recovered without a stop");
    visitor.check(tr);
    return visitor.questions[phase];
  }

  Result recover(const Phase phase, const std::size_t last_question, const double seconds) const
  {
    Tr tr;
    const auto earlier = insert(tr);
    Visitor visitor(tr);
    visitor.last_phase = phase;
    visitor.last_question = last_question;
    auto result = CGAL::recover_boundary(tr, m_points, m_plc.triangles, CGAL::parameters::recovery_mode(m_mode),
                                         CGAL::parameters::constrained_edges(m_plc.edges)
                                           .visitor(std::ref(visitor)).maximum_running_time(seconds));
    visitor.check(tr);
    const Result given = result;
    const Status status = result.status;
    require(status == Status::recovered || status == Status::stopped, "a wrong status after a stop");
    require(phase != Phase::steiner_suppression || status == Status::recovered,
            "a stop of suppression loses something");
    require(status == Status::recovered || result.steiner_vertices.empty(), "Steiner points are left after a stop");
    if(status == Status::stopped)
      result.status = Status::incomplete;
    const Recovery_mode mode = status == Status::stopped ? Recovery_mode::flips_only : m_mode;
    br3_test::Brute_force_checker<Tr>(m_plc, m_expectation, mode, tr, earlier, result)();
    return given;
  }

  typename br3_test::Brute_force_checker<Tr>::Earlier_vertices insert(Tr& tr) const
  {
    typename br3_test::Brute_force_checker<Tr>::Earlier_vertices earlier;
    m_points.clear();
    for(const Coordinates& c : m_plc.points)
    {
      m_points.emplace_back(c[0], c[1], c[2]);
      earlier.emplace_back(tr.insert(m_points.back()), m_points.back());
    }
    return earlier;
  }

  const Plc& m_plc;
  const br3_test::Expectation m_expectation;
  const Recovery_mode m_mode;
  mutable std::vector<typename K::Point_3> m_points;
};

template <typename K>
void test_stops()
{
  std::map<Phase, std::size_t> stopped;
  for(const Plc& plc : { br3_test::twisted_prism(3, .3, 1000, 1000), br3_test::twisted_prism(6, .3, 1000, 1000),
                         br3_test::Notched_box(1, 1).plc() })
    for(const Recovery_mode mode : { Recovery_mode::constrained, Recovery_mode::conforming })
      catch_complaints("a stop", [&]
      {
        const Stopped_recoveries<K> stops(plc, mode);
        for(const Phase phase : { Phase::conforming_edge_recovery, Phase::conforming_facet_recovery,
                                  Phase::steiner_splitting, Phase::steiner_suppression })
          stopped[phase] += stops(phase);
        if(mode == Recovery_mode::constrained)
          stops.check_suppression();
        for(double seconds = 0; seconds < 1; seconds = 3 * seconds + 1e-6)
          stops.after(seconds);
        assert(stops.after(0) == 1);
      });
  assert(stopped[Phase::conforming_edge_recovery] > 0 && stopped[Phase::steiner_splitting] > 0);
}

struct Thrown { };

// Throws at one of the calls in a phase.
struct Throwing_visitor
  : public CGAL::Default_meshing_visitor_3
{
  void on_phase_begin(const Phase phase) { is_in_phase = phase == phase_to_throw_in; }
  void on_progress(Phase, std::size_t, std::size_t) { count(); }
  bool go_further() { count(); return true; }
  template <typename CellRange> void before_cells_removal(const CellRange&) { count(); }
  template <typename CellRange> void after_cells_creation(const CellRange&) { count(); }

  void count()
  {
    if(is_in_phase && ++number_of_calls == last_call)
      throw Thrown();
  }

  Phase phase_to_throw_in = Phase::insertion;
  std::size_t last_call = 0, number_of_calls = 0;
  bool is_in_phase = false;
};

// Whatever a visitor does, the caller's triangulation is valid afterwards, without points that nobody asked for.
template <typename K>
void test_exceptions()
{
  std::map<Phase, std::size_t> thrown;
  const Plc plc = br3_test::twisted_prism(6, .3, 1000, 1000);
  std::vector<typename K::Point_3> points;
  for(const Coordinates& c : plc.points)
    points.emplace_back(c[0], c[1], c[2]);
  for(const Recovery_mode mode : { Recovery_mode::constrained, Recovery_mode::conforming })
    for(const Phase phase : { Phase::plain_removal, Phase::edge_recovery_brc1, Phase::conforming_edge_recovery,
                              Phase::conforming_facet_recovery, Phase::steiner_splitting, Phase::steiner_suppression })
    {
      bool is_thrown = true;
      for(std::size_t n = 1; is_thrown; ++n)
      {
        Throwing_visitor visitor;
        visitor.phase_to_throw_in = phase;
        visitor.last_call = n;
        CGAL::Delaunay_triangulation_3<K> tr;
        try {
          CGAL::recover_boundary(tr, points, plc.triangles, CGAL::parameters::recovery_mode(mode),
                                 CGAL::parameters::visitor(std::ref(visitor)));
          is_thrown = false;
        } catch(const Thrown&) {
          ++thrown[phase];
          assert(br3_test::is_valid_mesh(tr) && tr.number_of_vertices() == points.size());
          assert(CGAL::recover_boundary(tr, points, plc.triangles));
          assert(br3_test::is_valid_mesh(tr));
        }
      }
    }
  for(const Phase phase : { Phase::edge_recovery_brc1, Phase::conforming_edge_recovery, Phase::steiner_splitting,
                            Phase::steiner_suppression })
    assert(thrown[phase] > 2);
}

// Stops after the first Steiner point that is split.
struct Half_splitting_visitor
  : public CGAL::Default_meshing_visitor_3
{
  bool go_further() const { return ! is_over; }
  void on_progress(const Phase phase, std::size_t, std::size_t) { is_over = phase == Phase::steiner_splitting; }

  bool is_over = false;
};

// A point off its constraint may have an exact position, too, which is lost if nobody looks.
void test_rounding_of_points_that_are_half_split()
{
  typedef CGAL::Delaunay_triangulation_3<Epick> Tr;
  typedef CGAL::Constrained_boundary_recovery_3<Tr, Half_splitting_visitor> Recovery;
  Tr tr;
  Half_splitting_visitor visitor;
  std::vector<Tr::Vertex_handle> v;
  const Plc plc = br3_test::twisted_prism(3, .3, 1000, 1);
  for(const double height : { std::ldexp(1., -52), 1000. }) // no number is between 1 and 1 + height
    for(const Coordinates& c : plc.points)
      v.push_back(tr.insert(Epick::Point_3(c[0] + 100 * height, c[1], 1 + height * c[2])));
  Recovery recovery(tr, visitor);
  for(const std::size_t first : { std::size_t(0), plc.points.size() })
    for(const Simplex& t : plc.triangles)
      recovery.insert_constraint(v[first + t[0]], v[first + t[1]], v[first + t[2]]);
  recovery.search();
  recovery.recover_conforming();
  assert(recovery.lost_edges().empty() && recovery.lost_facets().empty());
  assert(! recovery.split_steiner_points());
  assert(recovery.steiner_vertices().size() > recovery.split_edges().size() && ! recovery.split_edges().empty());
  assert(! recovery.round_steiner_points());
}

Plc moved(Plc plc, const int exponent, const double shift)
{
  for(Coordinates& c : plc.points)
    for(double& x : c)
      x = std::ldexp(x + shift, exponent);
  return plc;
}

// What a recovery did, in numbers.
struct Counts
{
  std::size_t transformations, on_constraints, off_constraints, left;

  bool operator==(const Counts& other) const
  {
    return transformations == other.transformations && on_constraints == other.on_constraints
        && off_constraints == other.off_constraints && left == other.left;
  }
};

template <typename K>
Counts recover_and_count(const Plc& plc, const Recovery_mode mode)
{
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  std::vector<typename K::Point_3> points;
  for(const Coordinates& c : plc.points)
    points.emplace_back(c[0], c[1], c[2]);
  Tr tr;
  const auto result = CGAL::recover_boundary(tr, points, plc.triangles, CGAL::parameters::recovery_mode(mode),
                                             CGAL::parameters::constrained_edges(plc.edges));
  require(mode == Recovery_mode::flips_only || result.status == Status::recovered, "not recovered");
  br3_test::Brute_force_checker<Tr>(plc, br3_test::Expectation(plc), mode, tr, {}, result)();
  return { result.number_of_shell_transformations, result.number_of_constraint_points,
           result.number_of_steiner_points, result.steiner_vertices.size() };
}

// Powers of two multiply without rounding, so nothing at all may change. Moving changes only how points are rounded.
void test_scales()
{
  std::size_t number_of_points = 0;
  for(const Plc& plc : { br3_test::twisted_prism(3, .3, 1000, 1000), br3_test::twisted_prism(7, .3, 1000, 1000),
                         br3_test::Notched_box(1, 1).plc(), br3_test::Random_constraints(3)(14, 40, 60, 40) })
    for(const Recovery_mode mode : { Recovery_mode::constrained, Recovery_mode::conforming,
                                     Recovery_mode::flips_only })
      catch_complaints("a scaled input", [&]
      {
        const Counts expected = recover_and_count<Epick>(plc, mode);
        number_of_points += expected.on_constraints;
        for(const int exponent : { 30, -30, 300, -300, 1013 })
          require(recover_and_count<Epick>(moved(plc, exponent, 0), mode) == expected, "the scale makes a difference");
        const Counts shifted = recover_and_count<Epick>(moved(plc, 0, 1 << 20), mode);
        require(mode != Recovery_mode::flips_only || shifted == expected, "the origin makes a difference to flips");
#ifndef BR3_TEST_EPICK_ONLY
        recover_and_count<Epeck>(moved(plc, 300, 1 << 20), mode);
#endif
      });
  assert(number_of_points > 0);
}

int main()
{
  test_phases();
  test_scales();
  test_rounding_of_points_that_are_half_split();
  test_stops<Epick>();
  test_exceptions<Epick>();
#ifndef BR3_TEST_EPICK_ONLY
  test_stops<Epeck>();
  test_exceptions<Epeck>();
#endif
  assert(number_of_failures == 0);
  std::cout << "done" << std::endl;
}
