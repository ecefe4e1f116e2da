// make_boundary_constrained_mesh_3() on surface meshes: the visitor is called in order, and stops the work wherever it
// is asked to, by its answer or by an exception; all overloads are there.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "mesh_validity_br3.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace parameters = CGAL::parameters;
typedef CGAL::Exact_predicates_inexact_constructions_kernel           K;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type      Triangulation;
typedef CGAL::Surface_mesh<K::Point_3>                                Surface;
typedef std::function<double(const K::Point_3&)>                      Size;

struct Interruption { };

// A model of MeshingVisitor_3 that has what the concept asks for, and nothing else. It holds the mesher
// to the order of calls, counts them, and says no, or throws, at one of them.
struct Visitor
{
  typedef Triangulation::Cell_handle Cell_handle;

  void on_phase_begin(const BR3::Phase phase)
  {
    call();
    begin();
    assert(BR3::internal::is_of_recovery(phase) ? phases.empty() : phases.empty() || phases.back() < phase);
    current = phase;
    progress = 0;
    if(! BR3::internal::is_of_recovery(phase))
      phases.push_back(phase);
  }

  void on_phase_end(const BR3::Phase_report& report)
  {
    call();
    end();
    assert(report.phase == current && report.seconds >= 0);
    if(BR3::internal::is_of_recovery(current) || current == BR3::Phase::forecast) // of the mesh that is to be
      return;
    assert(report.number_of_vertices == tr->number_of_vertices());
    assert(report.number_of_cells == tr->number_of_finite_cells());
  }

  void on_progress(const BR3::Phase phase, const std::size_t done, const std::size_t total)
  {
    call();
    assert(is_in_phase && phase == current && phase != BR3::Phase::domain_marking);
    assert(0 < total && done <= total);
    if(BR3::internal::is_of_recovery(phase)) // which has several passes
      return;
    const double quotient = double(done) / double(total);
    assert(quotient >= progress);
    progress = quotient;
  }

  bool go_further()
  {
    call();
    assert(! was_stopped);
    was_stopped = number_of_questions++ == last_question;
    return ! was_stopped;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    call();
    assert(! std::empty(cells));
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    call();
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        assert(c->neighbor(i)->has_neighbor(c));
  }

  void call()
  {
    if(number_of_calls++ == last_call)
      throw Interruption();
  }

  void begin()
  {
    assert(! is_in_phase);
    is_in_phase = true;
  }

  void end()
  {
    assert(is_in_phase);
    is_in_phase = false;
  }

  const Triangulation* tr = nullptr;
  BR3::Phase current = BR3::Phase::insertion;
  std::vector<BR3::Phase> phases; // of the meshing
  double progress = 0;
  bool is_in_phase = false, was_stopped = false;
  std::size_t number_of_questions = 0, last_question = std::size_t(-1);
  std::size_t number_of_calls = 0, last_call = std::size_t(-1);
};

Surface cube(const double length)
{
  Surface surface;
  std::vector<Surface::Vertex_index> v;
  for(int i = 0; i < 8; ++i)
    v.push_back(surface.add_vertex(K::Point_3(i % 2 * length, i / 2 % 2 * length, i / 4 * length)));
  const std::array<std::array<int, 4>, 6> sides
    = {{ {{ 0, 2, 3, 1 }}, {{ 4, 5, 7, 6 }}, {{ 0, 1, 5, 4 }}, {{ 2, 6, 7, 3 }}, {{ 0, 4, 6, 2 }}, {{ 1, 3, 7, 5 }} }};
  for(const auto& s : sides)
  {
    surface.add_face(v[s[0]], v[s[1]], v[s[2]]);
    surface.add_face(v[s[0]], v[s[2]], v[s[3]]);
  }
  return surface;
}

const Size of_0_4 = [](const K::Point_3&) { return 0.4; };
const Size of_0_16 = [](const K::Point_3&) { return 0.16; }; // so small that the filling asks several times

// Each triangle is there, whatever was done.
void check(const Triangulation& tr, const CGAL::Boundary_constrained_mesh_result_3<Triangulation>& result)
{
  assert(br3_test::is_valid_mesh(tr));
  if(result.number_of_regions == 0)
    return;
  std::size_t number_of_sides = 0;
  for(const auto c : tr.all_cell_handles())
  {
    assert(c->subdomain_index() == (tr.is_infinite(c) ? 0 : 1)); // a cube is its own hull
    for(int i = 0; i < 4; ++i)
      number_of_sides += c->is_facet_on_surface(i);
  }
  assert(number_of_sides == 24);
}

void test_questions(const Surface& surface)
{
  std::size_t number_of_stops = 0;
  bool was_stopped_in_filling = false, was_stopped_in_improvement = false;
  // many questions come from the improvement
  for(bool is_done = false; ! is_done; number_of_stops += was_stopped_in_improvement ? number_of_stops / 4 + 1 : 1)
  {
    Triangulation tr;
    Visitor visitor;
    visitor.tr = &tr;
    visitor.last_question = number_of_stops;
    const auto result = CGAL::make_boundary_constrained_mesh_3(tr, surface, of_0_16,
                                                               parameters::visitor(std::ref(visitor)));
    is_done = ! visitor.was_stopped;
    assert(! visitor.is_in_phase);
    assert(bool(result) || visitor.was_stopped);
    assert(result || result.status == BR3::Meshing_status::stopped);
    assert(result.phases.size() == visitor.phases.size());
    for(std::size_t i = 0; i < result.phases.size(); ++i)
      assert(result.phases[i].phase == visitor.phases[i]);
    if(! result && result.filling.number_of_field_points > 0)
      (result.filling ? was_stopped_in_improvement : was_stopped_in_filling) = true;
    check(tr, result);
  }
  assert(number_of_stops > 8 && was_stopped_in_filling && was_stopped_in_improvement);
}

void test_exceptions(const Surface& surface)
{
  std::size_t n = 0, step = 1;
  for(bool is_done = false; ! is_done; n += step)
  {
    Triangulation tr;
    Visitor visitor;
    visitor.tr = &tr;
    visitor.last_call = n;
    try
    {
      CGAL::make_boundary_constrained_mesh_3(tr, surface, of_0_4, parameters::visitor(std::ref(visitor)));
      is_done = true;
    }
    catch(const Interruption&) { }
    assert(is_done == (visitor.number_of_calls <= n));
    assert(tr.number_of_vertices() == 0 || br3_test::is_valid_mesh(tr));
    step = n < 60 ? 1 : n / 8;
  }
  assert(n > 20);
}

// What is between the steps and the visitor.
void test_recorder()
{
  typedef BR3::internal::Any_visitor_3<Triangulation, Visitor&>  Any_visitor;
  typedef BR3::internal::Recording_visitor_3<Triangulation>      Recorder;
  typedef BR3::internal::Recovery_context<Triangulation>         Context;
  Visitor visitor;
  visitor.last_question = 1;
  Any_visitor any_visitor(visitor);
  std::vector<BR3::Phase_report> reports;
  Recorder recorder(any_visitor, reports);
  Context context(recorder);
  assert(context.go_further() && context.seconds_left() > 1e9 && context.seconds() >= 0);
  assert(! recorder.go_further() && ! recorder.go_further() && ! context.go_further());
  assert(visitor.number_of_questions == 2);

  Visitor patient;
  Any_visitor any_patient(patient);
  Recorder other_recorder(any_patient, reports);
  Context late(other_recorder), never(other_recorder);
  late.set_maximum_running_time(0);
  assert(! late.go_further() && other_recorder.go_further() && late.seconds_left() <= 0);
  never.set_maximum_running_time(std::numeric_limits<double>::quiet_NaN());
  assert(! never.go_further()); // no number of seconds is no time
  assert(patient.number_of_questions == 1);
}

// Numbers, functions, and nothing, with any number of chains.
void test_overloads(const Surface& surface)
{
  std::vector<K::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  for(const auto v : vertices(surface))
    points.push_back(surface.point(v));
  for(const auto f : faces(surface))
  {
    triangles.emplace_back();
    std::size_t i = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, surface), surface))
      triangles.back()[i++] = static_cast<std::size_t>(v);
  }
  Triangulation a, b, c, d, e;
  const auto of_function = CGAL::make_boundary_constrained_mesh_3(a, points, triangles, of_0_4);
  assert(of_function);
  check(a, of_function);
  const auto of_surface = CGAL::make_boundary_constrained_mesh_3(
    b, surface, of_0_4, parameters::maximum_running_time(1e6), parameters::maximum_number_of_vertices(100000),
    parameters::visitor(CGAL::Default_meshing_visitor_3()));
  assert(of_surface && a.number_of_vertices() == b.number_of_vertices() && a.number_of_cells() == b.number_of_cells());

  const auto coarse = CGAL::make_boundary_constrained_mesh_3(c, surface, parameters::grading(0.2));
  assert(coarse && coarse.filling.number_of_field_points < of_surface.filling.number_of_field_points);
  check(c, coarse);
  const auto fresh = CGAL::make_boundary_constrained_mesh_3(d, points, triangles);
  assert(fresh && c.number_of_vertices() == d.number_of_vertices() && c.number_of_cells() == d.number_of_cells());

  // patches of faces, of which two have none
  Surface copy(surface);
  auto patch = copy.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  int number_of_faces = 0;
  for(const auto f : faces(copy))
    patch[f] = number_of_faces++ < 2 ? 0 : 3;
  assert(CGAL::make_boundary_constrained_mesh_3(e, copy, parameters::face_patch_map(patch)));
  std::array<int, 4> number_of_sides = {{ 0, 0, 0, 0 }};
  for(const auto cell : e.all_cell_handles())
    for(int i = 0; i < 4; ++i)
      ++number_of_sides[cell->surface_patch_index(i)];
  assert(number_of_sides[1] == 4 && number_of_sides[2] == 0 && number_of_sides[3] == 20);
}

int main()
{
  const Surface surface = cube(2);
  test_recorder();
  test_questions(surface);
  test_exceptions(surface);
  test_overloads(surface);
  std::cout << "visitors are heard" << std::endl;
}
