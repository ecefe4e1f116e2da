// A recovery that goes through all the phases is stopped at every question, and every call of its visitor throws:
// each time the triangulation is valid, is as flips left it unless the points were finished, and can be recovered.
#undef NDEBUG

#include "mesh_validity_br3.h"
#include "recover_and_judge_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef CGAL::Boundary_recovery_result_3<Triangulation>     Result;
typedef br3_test::Portrait<Triangulation>                   Portrait;
typedef CGAL::Boundary_recovery_3::Recovery_mode            Mode;
typedef CGAL::Boundary_recovery_3::Phase           Phase;
typedef CGAL::Boundary_recovery_3::Recovery_status          Status;
namespace params = CGAL::parameters;

struct Thrown { };

// Throws at the n-th call of any member, or answers no to the n-th question.
struct Disturbing_visitor
{
  void on_phase_begin(const Phase p)
  {
    phase = p;
    if(p == Phase::conforming_edge_recovery && flips == nullptr)
      flips = std::make_unique<Portrait>(*tr);
    number_of_suppressions += p == Phase::steiner_suppression ? 1 : 0;
    count("on_phase_begin");
  }

  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report&) { count("on_phase_end"); }
  void on_progress(const Phase, const std::size_t, const std::size_t) { count("on_progress"); }

  bool go_further()
  {
    assert(! is_stopped); // nobody who said no is asked again
    count("go_further");
    is_stopped = number_of_questions++ == last_question;
    return ! is_stopped;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange&) { count("before_cells_removal"); }

  template <typename CellRange>
  void after_cells_creation(const CellRange&) { count("after_cells_creation"); }

  void count(const char* name)
  {
    assert(! has_thrown); // nobody who threw is called again
    has_thrown = number_of_calls++ == last_call;
    member = name;
    if(has_thrown)
      throw Thrown();
  }

  std::size_t last_call = std::size_t(-1), last_question = std::size_t(-1);
  std::size_t number_of_calls = 0, number_of_questions = 0, number_of_suppressions = 0;
  bool is_stopped = false, has_thrown = false;
  Phase phase = Phase::insertion;
  std::string member;
  const Triangulation* tr = nullptr;
  std::unique_ptr<Portrait> flips; // what they left to the points
};

// How often each kind of outcome was met.
std::map<std::string, std::size_t> number_of;
std::set<Phase> disturbed_phases;

class Disturbed_recovery
{
public:
  Disturbed_recovery(const br3_test::Plc& plc, const Mode mode)
    : m_plc(plc), m_mode(mode)
  {
    for(const auto& c : plc.points)
      m_points.emplace_back(c[0], c[1], c[2]);
    Triangulation tr;
    const auto result = CGAL::recover_boundary(tr, m_points, plc.triangles, params::recovery_mode(Mode::flips_only),
                                               params::constrained_edges(plc.edges));
    assert(result.status == Status::incomplete); // so that there is something to do for points
    m_volume = volume(tr);
  }

  void operator()() const
  {
    Disturbing_visitor undisturbed;
    Triangulation tr;
    assert(recover(tr, undisturbed));
    for(std::size_t i = 0; i < undisturbed.number_of_questions; ++i)
      stop(i);
    for(std::size_t i = 0; i < undisturbed.number_of_calls; ++i)
      throw_at(i);
    std::cout << undisturbed.number_of_questions << " stops, " << undisturbed.number_of_calls << " throws" << std::endl;
  }

private:
  typedef br3_test::Rational Rational;

  Result recover(Triangulation& tr, Disturbing_visitor& visitor) const
  {
    visitor.tr = &tr;
    return CGAL::recover_boundary(tr, m_points, m_plc.triangles, params::recovery_mode(m_mode),
                                  params::constrained_edges(m_plc.edges).visitor(std::ref(visitor)));
  }

  void stop(const std::size_t i) const
  {
    Disturbing_visitor visitor;
    visitor.last_question = i;
    Triangulation tr;
    const Result result = recover(tr, visitor);
    assert(visitor.is_stopped);
    disturbed_phases.insert(visitor.phase);
    assert(result.status == Status::stopped || result.status == Status::recovered);
    ++number_of[to_string(result.status)];
    if(result.status == Status::stopped)
    {
      assert(result.steiner_vertices.empty());
      check_taken_back(tr, visitor);
    }
    check_missing(tr, result);
    check_mesh(tr, result.steiner_vertices.size());
    if(result.status == Status::stopped)
      check_that_it_can_be_recovered(tr);
  }

  void throw_at(const std::size_t i) const
  {
    Disturbing_visitor visitor;
    visitor.last_call = i;
    Triangulation tr;
    try {
      recover(tr, visitor);
      assert(false);
    } catch(const Thrown&) { }
    disturbed_phases.insert(visitor.phase);
    ++number_of["throw in " + visitor.member];
    const bool has_points = tr.number_of_vertices() > m_points.size();
    ++number_of[has_points ? "points after a throw" : "no points after a throw"];
    assert(! has_points || visitor.number_of_suppressions > 0 || m_mode == Mode::conforming);
    if(! has_points)
      check_taken_back(tr, visitor);
    check_mesh(tr, has_points ? tr.number_of_vertices() - m_points.size() : 0);
    if(! has_points)
      check_that_it_can_be_recovered(tr);
  }

  // Steiner points that were not finished leave no trace.
  void check_taken_back(const Triangulation& tr, const Disturbing_visitor& visitor) const
  {
    if(visitor.flips == nullptr)
      return;
    ++number_of["taken back"];
    assert(Portrait(tr) == *visitor.flips);
  }

  void check_missing(const Triangulation& tr, const Result& result) const
  {
    std::set<std::size_t> missing, parted;
    for(const auto& facet : result.missing_facets)
      missing.insert(facet.index);
    for(const auto& part : result.parts_of_facets)
      parted.insert(part.constraint.index);
    Triangulation::Cell_handle c;
    int i, j, k;
    for(std::size_t f = 0; f < result.facets.size(); ++f)
    {
      const auto& v = result.facets[f];
      const bool is_there = v[0] != nullptr && v[1] != nullptr && v[2] != nullptr && tr.dimension() == 3
                          && tr.is_facet(v[0], v[1], v[2], c, i, j, k);
      assert(parted.count(f) == 1 || is_there != (missing.count(f) == 1)
             || tr.number_of_vertices() < m_points.size()); // before all are inserted, all are listed
    }
    assert((result.status == Status::recovered) == (missing.empty() && result.missing_edges.empty()));
  }

  void check_mesh(const Triangulation& tr, const std::size_t number_of_steiner_points) const
  {
    assert(tr.number_of_vertices() <= m_points.size() + number_of_steiner_points);
    if(tr.dimension() < 3)
      return;
    assert(tr.tds().is_valid());
    if(m_mode != Mode::conforming || number_of_steiner_points == 0) // else rounded points may invert cells
      assert(br3_test::is_valid_mesh(tr));
    if(tr.number_of_vertices() >= m_points.size())
      assert(m_mode == Mode::conforming || volume(tr) == m_volume);
    const std::set<Kernel::Point_3> inputs(m_points.begin(), m_points.end());
    std::size_t others = 0;
    for(const auto v : tr.finite_vertex_handles())
      others += 1 - inputs.count(v->point());
    assert(others == number_of_steiner_points);
  }

  static Rational volume(const Triangulation& tr)
  {
    Rational result = 0;
    for(const auto c : tr.finite_cell_handles())
    {
      const auto p = [&](const int i) { return br3_test::to_rational(c->vertex(i)->point()); };
      result += br3_test::volume(p(0), p(1), p(2), p(3));
    }
    return result;
  }

  void check_that_it_can_be_recovered(Triangulation& tr) const
  {
    Disturbing_visitor undisturbed;
    const Result result = recover(tr, undisturbed);
    assert(result);
    check_missing(tr, result);
    check_mesh(tr, result.steiner_vertices.size());
  }

  const br3_test::Plc& m_plc;
  const Mode m_mode;
  std::vector<Kernel::Point_3> m_points;
  Rational m_volume = 0;
};

int main()
{
  const br3_test::Plc prism = br3_test::twisted_prism(3, .3, 1000, 1000);
  const br3_test::Plc box = br3_test::Notched_box(1, 1).plc();
  const br3_test::Plc random = br3_test::Random_constraints(265)(10, 40, 60, 40); // facets are lost, their edges not
  for(const Mode mode : { Mode::constrained, Mode::conforming })
  {
    Disturbed_recovery(prism, mode)();
    Disturbed_recovery(box, mode)();
    Disturbed_recovery(random, mode)();
  }
  for(const auto& n : number_of)
    std::cout << n.first << ": " << n.second << std::endl;
  for(const Phase phase : disturbed_phases)
    std::cout << to_string(phase) << std::endl;
  for(const Phase phase : { Phase::insertion, Phase::search, Phase::plain_removal, Phase::edge_recovery_brc1,
                            Phase::edge_recovery_brc3, Phase::edge_reconnection, Phase::facet_recovery_brc2,
                            Phase::facet_recovery_brc4, Phase::facet_reconnection, Phase::conforming_edge_recovery,
                            Phase::conforming_facet_recovery, Phase::steiner_splitting, Phase::steiner_suppression,
                            Phase::recount })
    assert(disturbed_phases.count(phase) == 1);
  for(const char* member : { "on_phase_begin", "on_phase_end", "on_progress", "go_further", "before_cells_removal",
                             "after_cells_creation" })
    assert(number_of[std::string("throw in ") + member] > 0);
  assert(number_of["stopped"] > 0 && number_of["taken back"] > 0);
  return EXIT_SUCCESS;
}
