// insert_field_points(): what may change and what must not, sizes that are kept, limits, stops, and fields without
// sizes; on our triangulations, on those of CGAL's remeshing, and on vertices without room for sizes.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "encroachment_br3.h"
#include "grid_scene_br3.h"
#include "mesh_validity_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Combined_sizing_fields_3.h>
#include <CGAL/Boundary_recovery_3/Size_source_3.h>
#include <CGAL/Boundary_recovery_3/Source_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_insertion_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Fill_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/sizing/Small_size_search_3.h>
#include <CGAL/Boundary_recovery_3/parameters.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/mark_domain.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace parameters = CGAL::parameters;
typedef BR3::Meshing_status                                     Status;
typedef CGAL::Exact_predicates_inexact_constructions_kernel     K;
typedef CGAL::Exact_predicates_exact_constructions_kernel       Exact;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type     Tr;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Exact>::type Exact_tr;
typedef CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>::Tds Remeshing_tds;
typedef CGAL::Delaunay_triangulation_3<K, Remeshing_tds>        Remeshing_tr;
typedef BR3::Boundary_constrained_mesh_cell_base_3<K>           Cell_base;
typedef CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<
  CGAL::Triangulation_vertex_base_3<K>, Cell_base> >            Bare_tr; // vertices know nothing

// A block of n^3 unit cubes with another region in it, or a sheet.
template <typename Triangulation>
struct Scene
  : public br3_test::Grid_scene<Triangulation>
{
  typedef br3_test::Grid_scene<Triangulation>     Base;
  typedef typename Triangulation::Cell_handle     Cell_handle;
  typedef typename Triangulation::Vertex_handle   Vertex_handle;
  typedef typename Triangulation::Point           Point;
  typedef std::set<Vertex_handle>                 Simplex;
  using Base::tr;
  using Base::facets;

  explicit Scene(const int n, const bool has_sheet = false) : Base(n), m_has_sheet(has_sheet)
  {
    this->add_box({{ 0, 0, 0 }}, {{ n, n, n }}, true);
    if(has_sheet)
      this->add_rectangle(0, {{ 1, 0, 1 }}, {{ 1, n, n }}, true);
    else
      this->add_box({{ 1, 1, 1 }}, {{ 2, 2, 2 }}, true);
    const int number_of_regions = has_sheet ? 1 : 2;
    if constexpr(BR3::internal::Has_vertex_indices<typename Triangulation::Vertex>::value)
      assert(CGAL::mark_domain(tr, facets) == number_of_regions);
    else
    {
      for(const Cell_handle c : tr.all_cell_handles())
        c->set_subdomain_index(tr.is_infinite(c) ? 0 : is_in_box(c) && ! has_sheet ? 2 : 1);
    }
  }

  // Each wall with its regions and its mark.
  std::map<Simplex, std::array<int, 3> > walls() const
  {
    std::map<Simplex, std::array<int, 3> > result;
    for(const auto& f : tr.finite_facets())
    {
      const auto v = BR3::internal::facet_vertices(f.first, f.second);
      const int r = region(f.first), s = region(f.first->neighbor(f.second));
      if(f.first->is_facet_on_surface(f.second) || r != s)
        result[{ v[0], v[1], v[2] }] = {{ (std::min)(r, s), (std::max)(r, s),
                                          static_cast<int>(f.first->surface_patch_index(f.second)) }};
    }
    return result;
  }

  std::map<int, double> volumes() const
  {
    std::map<int, double> result;
    for(const Cell_handle c : tr.finite_cell_handles())
      result[region(c)] += CGAL::to_double(tr.tetrahedron(c).volume());
    return result;
  }

  std::vector<std::array<double, 3> > points() const
  {
    std::vector<std::array<double, 3> > result;
    for(const Vertex_handle v : tr.finite_vertex_handles())
      result.push_back(BR3::internal::coordinates_of(v->point()));
    return result;
  }

  // Whether no wall is between a cell and a point.
  bool are_in_one_room(const Cell_handle c, const Point& p) const
  {
    const Cell_handle d = tr.locate(p, c);
    const Point q = CGAL::centroid(tr.tetrahedron(c));
    const bool is_sheet_between = m_has_sheet && (p.z() > 1 || q.z() > 1) && (p.x() < 1) != (q.x() < 1);
    return ! tr.is_infinite(d) && region(c) == region(d) && ! is_sheet_between;
  }

  static int region(const Cell_handle c) { return static_cast<int>(c->subdomain_index()); }

private:
  bool is_in_box(const Cell_handle c) const
  {
    const auto p = CGAL::centroid(tr.tetrahedron(c));
    return p.x() > 1 && p.x() < 2 && p.y() > 1 && p.y() < 2 && p.z() > 1 && p.z() < 2;
  }

  bool m_has_sheet;
};

// What must be the same afterwards.
template <typename Triangulation>
struct State
{
  std::map<typename Scene<Triangulation>::Simplex, std::array<int, 3> > walls;
  std::map<int, double> volumes;
  std::size_t number_of_vertices;

  explicit State(const Scene<Triangulation>& scene)
    : walls(scene.walls()), volumes(scene.volumes()), number_of_vertices(scene.tr.number_of_vertices())
  { }

  void check(const Scene<Triangulation>& scene, const std::size_t number_of_new_vertices) const
  {
    assert(br3_test::is_valid_mesh(scene.tr));
    assert(scene.walls() == walls);
    assert(scene.tr.number_of_vertices() == number_of_vertices + number_of_new_vertices);
    const auto now = scene.volumes();
    assert(now.size() == volumes.size());
    for(const auto& v : volumes)
      assert(std::abs(now.at(v.first) / v.second - 1) < 1e-12);
    for(auto c = scene.tr.all_cells_begin(); c != scene.tr.all_cells_end(); ++c)
      assert(c->tds_data().is_clear());
  }
};

// Whether a point is near a wall that is too large for that.
template <typename Triangulation>
bool is_encroaching(const Scene<Triangulation>& scene, const typename Triangulation::Point& p, const double size)
{
  const auto rounded = [](const auto& q)
  {
    return K::Point_3(CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z()));
  };
  br3_test::Encroachment encroachment;
  for(const auto& [u, v, w] : scene.facets)
    encroachment.look_at({{ rounded(u->point()), rounded(v->point()), rounded(w->point()) }}, rounded(p), size);
  return encroachment.nearest() < 1;
}

// New vertices keep their distance from those that they see, but for few that divide long edges. Hardly any cell is
// too large whose circumcenter can be reached from it, and does not encroach on a wall.
template <typename Triangulation>
void check_sizes(const Scene<Triangulation>& scene, const double size, const std::size_t number_of_old_vertices)
{
  std::set<typename Triangulation::Vertex_handle> old_vertices;
  for(const auto v : scene.tr.finite_vertex_handles())
    if(old_vertices.size() < number_of_old_vertices)
      old_vertices.insert(v);
  std::size_t number_of_edges = 0, number_of_short_edges = 0;
  for(const auto& e : scene.tr.finite_edges())
  {
    const auto u = e.first->vertex(e.second), v = e.first->vertex(e.third);
    if(old_vertices.count(u) == 0 || old_vertices.count(v) == 0)
    {
      const double length = std::sqrt(CGAL::to_double(scene.tr.segment(e).squared_length())) / size;
      assert(length >= 0.399);
      ++number_of_edges;
      number_of_short_edges += length < 0.699;
    }
  }
  assert(10 * number_of_short_edges <= number_of_edges);
  std::size_t number_of_cells = 0, number_of_large_cells = 0;
  for(const auto c : scene.tr.finite_cell_handles())
  {
    const auto sphere = BR3::internal::circumsphere(BR3::internal::corners(c));
    const typename Triangulation::Point center(sphere.center[0], sphere.center[1], sphere.center[2]);
    if(! scene.are_in_one_room(c, center) || is_encroaching(scene, center, size))
      continue;
    ++number_of_cells;
    number_of_large_cells += std::sqrt(sphere.squared_radius) > 0.7501 * size;
  }
  assert(20 * number_of_large_cells <= number_of_cells);
}

template <typename Triangulation>
void test_filling(const bool has_sheet, const double size)
{
  Scene<Triangulation> scene(3, has_sheet), again(3, has_sheet);
  const State<Triangulation> before(scene);
  const auto result = CGAL::insert_field_points(scene.tr, size);
  assert(result && result.status == Status::meshed && result.invalid_sizes.empty());
  assert(result.number_of_field_points > 0);
  before.check(scene, result.number_of_field_points);
  check_sizes(scene, size, before.number_of_vertices);
  const double cells = static_cast<double>(scene.tr.number_of_finite_cells());
  assert(result.forecast_of_cells > cells / 2 && result.forecast_of_cells < 2 * cells);

  const auto same = CGAL::insert_field_points(again.tr, size);
  assert(same.number_of_field_points == result.number_of_field_points && again.points() == scene.points());

  // It is done: once more changes next to nothing.
  const auto more = CGAL::insert_field_points(scene.tr, size);
  assert(more && more.number_of_field_points <= result.number_of_field_points / 20);
}

// New vertices know where they are, and the size there.
void test_indices()
{
  Scene<Tr> scene(3);
  const auto size = [](const K::Point_3& p, const int dimension, const int region)
  {
    assert(dimension == 3 && (region == 1 || region == 2));
    return region == 1 ? 0.9 : 0.3 + 0 * p.x();
  };
  const std::size_t n = scene.tr.number_of_vertices();
  const auto result = CGAL::insert_field_points(scene.tr, size);
  assert(result);
  std::map<int, std::size_t> number;
  std::size_t k = 0;
  for(const Tr::Vertex_handle v : scene.tr.finite_vertex_handles())
    if(k++ >= n)
    {
      const K::Point_3& p = v->point();
      const bool is_inner = p.x() > 1 && p.x() < 2 && p.y() > 1 && p.y() < 2 && p.z() > 1 && p.z() < 2;
      assert(v->in_dimension() == 3 && v->index() == (is_inner ? 2 : 1));
      assert(v->meshing_info() == (is_inner ? 0.3 : 0.9));
      ++number[v->index()];
    }
  assert(number[2] > 10 && number[2] > number[1]);
}

void test_selection()
{
  Scene<Tr> scene(3, true);
  typedef std::set<Tr::Cell_handle> Cells;
  Cells selected;
  std::set<std::set<Tr::Vertex_handle> > others;
  const auto vertices_of = [](const Tr::Cell_handle c)
  {
    return std::set<Tr::Vertex_handle>({ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) });
  };
  for(const Tr::Cell_handle c : scene.tr.finite_cell_handles())
    if(CGAL::centroid(scene.tr.tetrahedron(c)).x() < 2)
      selected.insert(c);
    else
      others.insert(vertices_of(c));
  const State<Tr> before(scene);
  const auto result = CGAL::insert_field_points(
    scene.tr, 0.45, parameters::cell_is_selected_map(CGAL::Boolean_property_map<Cells>(selected)));
  assert(result && result.number_of_field_points > 20);
  before.check(scene, result.number_of_field_points);
  std::size_t number_of_others = 0;
  for(const Tr::Cell_handle c : scene.tr.finite_cell_handles())
    if(others.count(vertices_of(c)) > 0)
      ++number_of_others;
    else
      assert(CGAL::centroid(scene.tr.tetrahedron(c)).x() < 2 && selected.erase(c) == 1);
  assert(number_of_others == others.size() && selected.empty());
}

void test_constrained_edges()
{
  typedef std::pair<Tr::Vertex_handle, Tr::Vertex_handle> Edge;
  for(const bool are_constrained : { true, false })
  {
    Scene<Tr> scene(3, true);
    std::set<Edge> edges;
    for(const auto& e : scene.tr.finite_edges())
      if(scene.tr.segment(e).squared_length() == 1)
        edges.insert({ e.first->vertex(e.second), e.first->vertex(e.third) });
    const std::set<Edge> all = edges;
    if(! are_constrained)
      edges.clear();
    const auto result = CGAL::insert_field_points(
      scene.tr, 0.5, parameters::edge_is_constrained_map(CGAL::Boolean_property_map<std::set<Edge> >(edges)));
    assert(result && result.number_of_field_points > 0);
    std::size_t number_of_lost_edges = 0;
    for(const Edge& e : all)
      number_of_lost_edges += ! scene.tr.tds().is_edge(e.first, e.second);
    assert(are_constrained == (number_of_lost_edges == 0));
  }
}

struct Counting_visitor
  : public CGAL::Default_meshing_visitor_3
{
  void on_phase_begin(const BR3::Phase phase) { begun.push_back(phase); }
  void on_phase_end(const BR3::Phase_report& report)
  {
    ended.push_back(report.phase);
    if(report.phase == BR3::Phase::forecast)
      forecast = report.number_of_vertices;
  }

  void on_progress(const BR3::Phase phase, const std::size_t done, const std::size_t total)
  {
    assert(phase == BR3::Phase::field_point_insertion && done <= total);
    const double part = static_cast<double>(done) / static_cast<double>(total);
    assert(part >= progress);
    progress = part;
    ++number_of_reports;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    number_of_cells -= static_cast<long>(cells.size());
    if(number_of_removals_until_throw-- == 0)
      throw std::runtime_error("the visitor wants to keep these cells");
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells)
  {
    number_of_cells += static_cast<long>(cells.size());
    if(number_of_insertions_until_throw-- == 0)
      throw std::runtime_error("the visitor has seen enough");
  }

  bool go_further() { return number_of_questions++ != last_question; }

  std::vector<BR3::Phase> begun, ended;
  std::size_t forecast = 0;
  double progress = 0;
  int number_of_reports = 0;
  long number_of_cells = 0;
  long number_of_removals_until_throw = -1;
  long number_of_insertions_until_throw = -1;
  std::size_t number_of_questions = 0;
  std::size_t last_question = std::size_t(-1);
};

void test_limits()
{
  { // the forecast is above the limit: nothing is changed
    Scene<Tr> scene(3);
    const State<Tr> before(scene);
    const auto result = CGAL::insert_field_points(scene.tr, 0.2, parameters::maximum_number_of_vertices(100));
    assert(! result && result.status == Status::too_large && result.number_of_field_points == 0);
    assert(result.forecast_of_vertices > 100);
    before.check(scene, 0);
  }
  { // the forecast is too low, as the field changes its mind
    Scene<Tr> scene(3, true);
    const State<Tr> before(scene);
    Counting_visitor visitor;
    const auto size = [&](const K::Point_3&) { return visitor.begun.size() < 2 ? 1. : 0.1; };
    const auto result = CGAL::insert_field_points(scene.tr, size, parameters::maximum_number_of_vertices(500),
                                                  parameters::visitor(std::ref(visitor)));
    assert(visitor.forecast < 500 && result.forecast_of_vertices > 500 && result.status == Status::too_large);
    assert(scene.tr.number_of_vertices() == 500);
    before.check(scene, result.number_of_field_points);
  }
  { // the limit is as many vertices as there will be, or one less
    const auto number_and_status = [](const std::size_t limit)
    {
      Scene<Tr> scene(3);
      Counting_visitor visitor;
      const auto size = [&](const K::Point_3&) { return visitor.begun.size() < 2 ? 1. : 0.4; };
      const auto result = CGAL::insert_field_points(scene.tr, size, parameters::maximum_number_of_vertices(limit),
                                                    parameters::visitor(std::ref(visitor)));
      return std::make_pair(scene.tr.number_of_vertices(), result.status);
    };
    const std::size_t number = number_and_status(100000).first;
    assert(number_and_status(number) == std::make_pair(number, Status::meshed));
    assert(number_and_status(number - 1) == std::make_pair(number - 1, Status::too_large));
  }
  for(const double size : { 3e-9, 1e-30, 1e-300 }) // does not fit into any memory
  {
    Scene<Tr> scene(2, true);
    const State<Tr> before(scene);
    const auto result = CGAL::insert_field_points(scene.tr, size);
    assert(result.status == Status::too_large && result.number_of_field_points == 0);
    before.check(scene, 0);
  }
  for(const double size : { 3., 3e9, 1e300 }) // nothing to do
  {
    Scene<Tr> scene(2, true);
    const auto result = CGAL::insert_field_points(scene.tr, size);
    assert(result && result.number_of_field_points == 0);
  }
}

// Small sizes around a place, and how fast they grow from there.
struct Spot
{
  double operator()(const K::Point_3& p) const
  {
    ++number_of_questions;
    return (std::min)(1., 0.01 + growth * std::sqrt(CGAL::squared_distance(p, place)));
  }

  K::Point_3 place;
  double growth;
  mutable std::size_t number_of_questions = 0;
};

struct Graded_spot
  : public Spot
{
  double grading() const { return growth; }
};

// Fills a block of cubes, and returns whether there is a vertex where the sizes are small.
template <typename Field>
bool is_seen(const Field& field, const K::Point_3& place, const bool is_resolved)
{
  Scene<Tr> scene(4);
  const State<Tr> before(scene);
  const auto result = CGAL::insert_field_points(scene.tr, field);
  assert(result && result.is_field_resolved == is_resolved);
  before.check(scene, result.number_of_field_points);
  double nearest = 1;
  for(const Tr::Vertex_handle v : scene.tr.finite_vertex_handles())
    nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(v->point(), place)));
  return nearest < 0.1;
}

// None is missed, as long as the field tells how small it can be: by its grading, or by bounds.
void test_small_sizes()
{
  typedef BR3::Source_sizing_field_3<K> Sources;
  std::size_t number_of_missed = 0;
  for(const K::Point_3& place : { K::Point_3(0.47, 2.63, 3.31), K::Point_3(1.4, 1.3, 1.6), K::Point_3(2.3, 3.8, 0.4) })
  {
    number_of_missed += ! is_seen(Spot{ place, 2 }, place, false);
    assert(is_seen(Graded_spot{ { place, 2 } }, place, true));
    const auto doubling = BR3::Size_source_3<K>::point(place, 0.01, 0.02, BR3::Size_growth::doubling_at(0.03));
    const auto steep = BR3::Size_source_3<K>::point(place, 0.004, 0.01, BR3::Size_growth::linear(1e3));
    const Sources bounded({ doubling }, 1), unbounded({ doubling }), wall({ steep }, 1);
    assert(is_seen(bounded, place, true) && is_seen(unbounded, place, true) && is_seen(wall, place, true));
    const auto smallest = BR3::make_minimum_sizing_field<K>(1., std::cref(unbounded), 2.);
    assert(is_seen(smallest, place, true));
    BR3::Region_sizing_field_3<K> regions(smallest);
    regions.set_field(2, BR3::make_bounded_sizing_field<K>(smallest, 0.01, 1));
    assert(is_seen(regions, place, true));
  }
  assert(number_of_missed > 0);
}

// It is told if nobody knows, also if the sizes could grow so fast that there would be no end of questions.
void test_unresolved_fields()
{
  const K::Point_3 outside(9, 9, 9);
  assert(! is_seen(1., outside, true));
  const Graded_spot steep{ { outside, 1e6 } };
  assert(! is_seen(steep, outside, false) && steep.number_of_questions < 1000000);
  assert(! is_seen(BR3::make_minimum_sizing_field<K>(Spot{ outside, 1 }, 1.), outside, false));
  assert(! is_seen([](const K::Point_3&) { return 1.; }, outside, false));
}

void test_visitor()
{
  Scene<Tr> scene(3);
  const State<Tr> before(scene);
  const long cells = static_cast<long>(scene.tr.number_of_finite_cells());
  Counting_visitor visitor;
  const auto result = CGAL::insert_field_points(scene.tr, 0.25, parameters::visitor(std::ref(visitor)));
  assert(result && visitor.begun == visitor.ended);
  assert((visitor.begun == std::vector<BR3::Phase>{ BR3::Phase::forecast,
                                                             BR3::Phase::field_point_insertion }));
  assert(cells + visitor.number_of_cells == static_cast<long>(scene.tr.number_of_finite_cells()));
  assert(visitor.number_of_reports > 50 && visitor.progress == 1);

  const std::size_t number_of_questions = visitor.number_of_questions;
  assert(number_of_questions >= 2);
  for(std::size_t last = 0; last < number_of_questions; ++last)
  {
    Scene<Tr> stopped(3);
    Counting_visitor stopper;
    stopper.last_question = last;
    const auto r = CGAL::insert_field_points(stopped.tr, 0.25, parameters::visitor(std::ref(stopper)));
    assert(r.status == Status::stopped && r.number_of_field_points <= result.number_of_field_points);
    assert(last > 0 || r.number_of_field_points < result.number_of_field_points / 2);
    assert(stopper.begun == stopper.ended && stopper.number_of_questions == last + 1);
    assert(br3_test::is_valid_mesh(stopped.tr) && stopped.walls().size() == before.walls.size());
    for(const Tr::Vertex_handle v : stopped.tr.finite_vertex_handles())
      assert(v->meshing_info() >= 0); // nothing is left pending
  }
  for(const long n : { 0, 7 })
    for(const bool is_before : { false, true })
    {
      Scene<Tr> thrown(3);
      const State<Tr> at_first(thrown);
      Counting_visitor thrower;
      (is_before ? thrower.number_of_removals_until_throw : thrower.number_of_insertions_until_throw) = n;
      bool is_caught = false;
      try { CGAL::insert_field_points(thrown.tr, 0.25, parameters::visitor(std::ref(thrower))); }
      catch(const std::runtime_error&) { is_caught = true; }
      assert(is_caught);
      at_first.check(thrown, static_cast<std::size_t>(is_before ? n : n + 1));
      for(const Tr::Vertex_handle v : thrown.tr.finite_vertex_handles())
        assert(v->meshing_info() >= 0);
    }
  Scene<Tr> late(3);
  const auto r = CGAL::insert_field_points(late.tr, 0.25, parameters::maximum_running_time(0.));
  assert(r.status == Status::stopped && r.number_of_field_points == 0);
}

void test_invalid_sizes()
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const double bad : { 0., -1., infinity, -infinity, nan })
    for(const bool is_everywhere : { true, false })
    {
      Scene<Tr> scene(3, true);
      const State<Tr> before(scene);
      const auto field = [&](const K::Point_3& p)
      {
        const bool is_vertex = p.x() == std::round(p.x()) && p.y() == std::round(p.y()) && p.z() == std::round(p.z());
        return is_everywhere || (! is_vertex && p.x() > 2.3) ? bad : 0.4;
      };
      const auto result = CGAL::insert_field_points(scene.tr, field);
      assert(result.status == Status::invalid_input && result.invalid_sizes.size() == 1);
      const auto& invalid = result.invalid_sizes[0];
      assert((std::isnan(bad) && std::isnan(invalid.size)) || invalid.size == bad);
      assert(is_everywhere || invalid.point.x() > 2.3);
      assert(! is_everywhere || result.number_of_field_points == 0);
      before.check(scene, result.number_of_field_points);
    }
  Scene<Tr> scene(3, true);
  const auto thrower = [](const K::Point_3&) -> double { throw std::domain_error("not here"); };
  const auto result = CGAL::insert_field_points(scene.tr, thrower);
  assert(result.status == Status::invalid_input && result.invalid_sizes[0].message == "not here");
  const auto number = CGAL::insert_field_points(scene.tr, -1);
  assert(number.status == Status::invalid_input && number.invalid_sizes.size() == 1);
}

void test_empty()
{
  Tr tr;
  assert(CGAL::insert_field_points(tr, 1.).number_of_field_points == 0);
  tr.insert(K::Point_3(0, 0, 0));
  tr.insert(K::Point_3(1, 0, 0));
  tr.insert(K::Point_3(0, 1, 0));
  assert(CGAL::insert_field_points(tr, 0.1).number_of_field_points == 0);
  tr.insert(K::Point_3(0, 0, 1));
  const auto outside = CGAL::insert_field_points(tr, 0.01); // no cell is in a region
  assert(outside && outside.number_of_field_points == 0 && tr.number_of_vertices() == 4);
}

int main()
{
  for(const bool has_sheet : { false, true })
    for(const double size : { 0.25, 0.5, 0.8 })
      test_filling<Tr>(has_sheet, size);
  test_filling<Remeshing_tr>(false, 0.4);
  test_filling<Bare_tr>(false, 0.4);
#ifndef BR3_TEST_EPICK_ONLY
  test_filling<Exact_tr>(false, 0.5);
#endif
  test_indices();
  test_selection();
  test_constrained_edges();
  test_limits();
  test_small_sizes();
  test_unresolved_fields();
  test_visitor();
  test_invalid_sizes();
  test_empty();
  return EXIT_SUCCESS;
}
