// make_boundary_constrained_mesh_3() on soups: regions of exact volumes, each triangle and edge where it was, patches,
// dimensions, and what becomes of bad input.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "box_scene_br3.h"
#include "box_soup_br3.h"
#include "mesh_validity_br3.h"

#include <CGAL/Boundary_recovery_3/internal/mesh/Ordinary_scale_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/regions_at_places.h>
#include <CGAL/Boundary_recovery_3/internal/meshing/Boundary_constrained_meshing_3.h>
#include <CGAL/Boundary_recovery_3/mesh_quality.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace parameters = CGAL::parameters;
using br3_test::Box;
using br3_test::Box_soup;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact;

template <typename Kernel>
struct Scene
  : public br3_test::Box_scene<Kernel>
{
  typedef br3_test::Box_scene<Kernel>   Base;
  typedef typename Base::Tr             Tr;
  typedef typename Base::Vertex_handle  Vertex_handle;
  typedef typename Base::Cell_handle    Cell_handle;
  typedef typename Base::Result         Result;
  typedef std::function<double(const typename Base::Point&, int, int)> Size;

  using Base::Base;
  using Base::soup;
  using Base::points;
  using Base::tr;
  using Base::result;
  using Base::volume;

  template <typename ... NPs>
  Result& make(const Size& size, const NPs& ... nps)
  {
    result = CGAL::make_boundary_constrained_mesh_3(tr, points, soup.triangles, size,
                                                    parameters::constrained_edges(soup.edges), nps...);
    return result;
  }

  // Whether everything of the surface is there, and nothing else is marked. `patches` are by input position.
  void check_surface(const std::vector<int>& patches) const
  {
    std::map<std::array<Vertex_handle, 3>, int> patch_of;
    for(const auto& f : result.recovery.surface_facets())
    {
      std::array<Vertex_handle, 3> facet = f;
      std::sort(facet.begin(), facet.end());
      patch_of[facet] = patches[f.index];
    }
    std::size_t number_of_sides = 0;
    for(const Cell_handle c : tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
      {
        std::array<Vertex_handle, 3> facet = BR3::internal::facet_vertices(c, i);
        std::sort(facet.begin(), facet.end());
        const auto known = patch_of.find(facet);
        assert(c->surface_patch_index(i) == (known == patch_of.end() ? 0 : known->second));
        assert(known != patch_of.end() || c->subdomain_index() == c->neighbor(i)->subdomain_index());
        number_of_sides += known != patch_of.end();
      }
    assert(number_of_sides == 2 * patch_of.size());
  }

  void check_vertices() const
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      assert(result.recovery.vertices[i]->point() == points[i]);
    std::map<Vertex_handle, int> dimension;
    for(const Vertex_handle v : tr.finite_vertex_handles())
      dimension[v] = 3;
    for(const auto& f : result.recovery.surface_facets())
      for(const Vertex_handle v : f)
        dimension[v] = 2;
    for(const auto& e : result.constrained_edges)
      for(const Vertex_handle v : e)
        dimension[v] = 1;
    for(const Vertex_handle v : tr.finite_vertex_handles())
    {
      assert(v->in_dimension() == dimension[v]);
      assert(v->in_dimension() != 3 || v->index() == v->cell()->subdomain_index());
    }
  }

  // What holds for every mesh whose recovery was a success; some points may be outside of all regions.
  void check(const std::vector<int>& patches, const std::vector<long>& volumes) const
  {
    assert(br3_test::is_valid_mesh(tr));
    check_surface(patches);
    check_vertices();
    assert(result.number_of_regions == static_cast<int>(volumes.size()));
    for(std::size_t r = 0; r < volumes.size(); ++r)
      assert(volume(static_cast<int>(r) + 1) == 6 * volumes[r]);
    for(const Cell_handle c : tr.all_cell_handles())
      assert(0 <= c->subdomain_index() && c->subdomain_index() <= (tr.is_infinite(c) ? 0 : result.number_of_regions));
    Cell_handle c;
    int i, j;
    for(const auto& e : result.constrained_edges)
      assert(tr.is_edge(e[0], e[1], c, i, j));
    assert(result.phases.size() >= 1 && result.phases[0].phase == BR3::Phase::domain_marking);
    const auto& counts = result.improvement.counts;
    const std::size_t number_of_points = result.filling.number_of_field_points + counts.number_of_inserted_points;
    assert(tr.number_of_vertices() + counts.number_of_removed_vertices ==
           result.phases[0].number_of_vertices + number_of_points);
    assert(result.phases[0].number_of_vertices >= points.size() + result.recovery.steiner_vertices.size());
    for(const Vertex_handle v : result.recovery.steiner_vertices)
      assert(tr.tds().is_vertex(v));
    double seconds = 0;
    for(const auto& phase : result.recovery.phases)
      seconds += phase.seconds;
    for(const auto& report : result.phases)
    {
      assert(report.seconds >= 0 && report.number_of_cells > 0);
      seconds += report.seconds;
    }
    assert(result.seconds >= seconds);
  }

  void check_improvement() const
  {
    const auto& improvement = result.improvement;
    assert(improvement && improvement.seconds >= 0 && improvement.seconds <= result.seconds);
    assert(improvement.certificate.min_dihedral_angle == 25);
    assert(improvement.before.number_of_cells > 0 && improvement.after.number_of_cells > 0);
    assert(improvement.after.min_dihedral_angle >= improvement.before.min_dihedral_angle);
    const auto& histogram = improvement.after.histogram; // of five degrees each
    assert(improvement.certificate.cells.size() == std::accumulate(histogram.begin(), histogram.begin() + 5, 0u));
    for(const auto& bad : improvement.certificate.cells)
      assert(tr.tds().is_cell(bad.cell) && bad.cell->subdomain_index() != 0);
  }

  void check_meshed(const std::vector<int>& patches, const std::vector<long>& volumes) const
  {
    assert(result && result.status == BR3::Meshing_status::meshed && result.filling);
    assert(result.filling.number_of_field_points > 0);
    assert(result.phases.size() == 4);
    assert(result.phases[1].phase == BR3::Phase::forecast);
    assert(result.phases[2].phase == BR3::Phase::field_point_insertion);
    assert(result.phases[3].phase == BR3::Phase::quality_improvement);
    assert(result.phases[3].number_of_vertices == tr.number_of_vertices());
    assert(result.phases[3].number_of_cells == tr.number_of_finite_cells());
    check_improvement();
    check(patches, volumes);
  }
};

std::vector<int> numbers_from_1(const std::size_t n)
{
  std::vector<int> numbers;
  for(std::size_t i = 1; i <= n; ++i)
    numbers.push_back(static_cast<int>(i));
  return numbers;
}

template <typename Kernel>
void test(const Box_soup& soup, const double size, const std::vector<long>& volumes)
{
  typedef typename Kernel::Point_3 Point;
  Scene<Kernel> scene(soup);
  scene.make([&](const Point&, const int dimension, const int index)
  {
    assert(dimension == 3 && index > 0 && index <= static_cast<int>(volumes.size()));
    return size;
  });
  scene.check_meshed(numbers_from_1(soup.triangles.size()), volumes);
  assert(scene.result.constrained_edges.size() == soup.edges.size());
}

const Box big = {{{ 0, 0, 0 }}, {{ 12, 12, 12 }}}, small = {{{ 3, 4, 5 }}, {{ 7, 8, 10 }}},
          beside = {{{ 12, 0, 0 }}, {{ 20, 12, 12 }}};

Box_soup box_with_sheet_and_edges()
{
  Box_soup soup;
  soup.add_box(big);
  soup.add_rectangle(2, {{ 3, 3, 6 }}, {{ 9, 9, 6 }}, true);
  soup.add_edge({{ 1, 1, 1 }}, {{ 2, 2, 11 }});
  soup.add_edge({{ 2, 2, 11 }}, {{ 11, 10, 11 }});
  soup.add_edge({{ 0, 0, 12 }}, {{ 1, 3, 11 }});
  soup.add_edge({{ 15, 0, 0 }}, {{ 15, 1, 12 }});
  return soup;
}

template <typename Kernel>
void test_regions()
{
  Box_soup nested, hollow, two, fan;
  nested.add_box(big);
  nested.add_box(small);
  test<Kernel>(nested, 3, { big.volume() - small.volume(), small.volume() });
  hollow.add_box(big);
  hollow.add_box(small, false);
  hollow.add_point({{ 30, 5, 5 }}); // a point of no triangle
  test<Kernel>(hollow, 3, { big.volume() - small.volume() });
  two.add_box(big); // the wall between them is there once
  for(int side = 1; side < 6; ++side)
    two.add_side(beside, side, true);
  test<Kernel>(two, 4, { big.volume(), beside.volume() });
  test<Kernel>(box_with_sheet_and_edges(), 3, { big.volume() });
  fan.add_box(big); // boxes that meet in an edge, and one at a vertex; a sheet outside
  fan.add_box({{{ 12, 12, 0 }}, {{ 20, 20, 12 }}});
  fan.add_box({{{ -6, -6, -6 }}, {{ 0, 0, 0 }}});
  fan.add_rectangle(0, {{ -3, 3, 3 }}, {{ -3, 6, 8 }}, false);
  test<Kernel>(fan, 4, { big.volume(), 8 * 8 * 12, 216 });
}

// Regions become empty, and the others are numbered anew. Places may be on facets inside, but not on walls.
void test_voids()
{
  Box_soup nested;
  nested.add_box(big);
  nested.add_box(small);
  const auto center = [](const Box& box)
  {
    return K::Point_3((box.low[0] + box.high[0]) / 2., (box.low[1] + box.high[1]) / 2.,
                      (box.low[2] + box.high[2]) / 2.);
  };
  const K::Point_3 corner(big.low[0] + 0.5, big.low[1] + 0.5, big.low[2] + 0.5), outside(1000, 0, 0);
  const auto make = [](Scene<K>& scene, const std::vector<K::Point_3>& voids)
  {
    scene.make([](const K::Point_3&, int, int) { return 3.; }, parameters::void_points(voids));
  };
  Scene<K> hollow(nested), inner(nested), empty(nested), wrong(nested);
  make(hollow, { center(small) });
  assert(hollow.result && hollow.result.number_of_regions == 1);
  assert(hollow.volume(1) == 6 * (big.volume() - small.volume()));
  make(inner, { corner });
  assert(inner.result && inner.result.number_of_regions == 1);
  assert(inner.volume(1) == 6 * small.volume() && inner.volume(2) == 0);
  make(empty, { corner, center(small) });
  assert(empty.result.status == BR3::Meshing_status::no_region && empty.result.number_of_regions == 0);
  const K::Point_3 on_wall(small.low[0], center(small).y(), center(small).z());
  make(wrong, { center(small), outside, on_wall });
  assert(wrong.result.status == BR3::Meshing_status::invalid_input);
  assert((wrong.result.invalid_void_points == std::vector<std::size_t>{ 1, 2 }));
}

void test_patches()
{
  Scene<K> scene(box_with_sheet_and_edges());
  std::vector<int> patches(scene.soup.triangles.size(), 7);
  patches[0] = patches[3] = 0; // they get the first number that is free
  patches[1] = 1;
  const auto size = [](const K::Point_3&, int, int) { return 3.; };
  scene.make(size, parameters::face_patch_map(CGAL::make_property_map(patches)));
  patches[0] = patches[3] = 2;
  scene.check_meshed(patches, { big.volume() });
}

// Without the improvement, the mesh is that of the filling; an angle that is none is told.
void test_improvement()
{
  Scene<K> scene(box_with_sheet_and_edges()), other(scene.soup), invalid(scene.soup);
  const auto size = [](const K::Point_3&, int, int) { return 3.; };
  scene.make(size, parameters::improve_quality(false));
  assert(scene.result && scene.result.phases.size() == 3 && scene.result.improvement.before.number_of_cells == 0);
  assert(scene.result.phases.back().number_of_vertices == scene.tr.number_of_vertices());
  assert(scene.result.improvement.certificate.cells.empty());
  scene.check(numbers_from_1(scene.soup.triangles.size()), { big.volume() });

  const std::size_t number_of_cells = BR3::mesh_quality(scene.tr).number_of_cells;
  other.make(size, parameters::min_dihedral_angle(12.), parameters::cell_quality(BR3::Volume_length_quality_3()));
  assert(other.result && other.result.improvement.before.number_of_cells == number_of_cells);
  assert(other.result.improvement.certificate.min_dihedral_angle == 12);

  invalid.make(size, parameters::min_dihedral_angle(71.));
  assert(invalid.result.status == BR3::Meshing_status::invalid_input && invalid.result.filling);
  assert(invalid.result.improvement.status == BR3::Meshing_status::invalid_input);
  invalid.check(numbers_from_1(scene.soup.triangles.size()), { big.volume() });
}

// No region, or nothing that can be recovered: nothing is inserted.
void test_other_ends()
{
  Box_soup open;
  for(int side = 1; side < 6; ++side)
    open.add_side(big, side, true);
  Scene<K> gap(open);
  int number_of_questions = 0;
  const auto size = [&](const K::Point_3&, int, int) { ++number_of_questions; return 3.; };
  gap.make(size);
  assert(! gap.result && gap.result.status == BR3::Meshing_status::no_region && gap.result.phases.size() == 1);
  gap.check(numbers_from_1(open.triangles.size()), { });

  Box_soup crossing;
  crossing.add_box(big);
  crossing.add_rectangle(2, {{ 3, 3, 6 }}, {{ 19, 9, 6 }}, true);
  Scene<K> invalid(crossing);
  invalid.make(size);
  assert(invalid.result.status == BR3::Meshing_status::invalid_input && ! invalid.result.recovery.defects.empty());
  Scene<K> empty{ Box_soup() };
  empty.make(size);
  assert(empty.result.status == BR3::Meshing_status::invalid_input && empty.result.phases.empty());

  Scene<K> late(box_with_sheet_and_edges());
  late.make(size, parameters::maximum_running_time(0.));
  assert(late.result.status == BR3::Meshing_status::stopped && br3_test::is_valid_mesh(late.tr));
  assert(number_of_questions == 0);

  Scene<K> large(box_with_sheet_and_edges());
  large.make(size, parameters::maximum_number_of_vertices(30));
  assert(large.result.status == BR3::Meshing_status::too_large && large.result.filling.forecast_of_vertices > 30);
  large.check(numbers_from_1(large.soup.triangles.size()), { big.volume() });
}

// A field that has no size somewhere.
void test_bad_sizes()
{
  for(const double bad : { 0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    Scene<K> scene(box_with_sheet_and_edges());
    scene.make([bad](const K::Point_3&, int, int) { return bad; });
    assert(scene.result.status == BR3::Meshing_status::invalid_input);
    assert(scene.result.recovery && scene.result.filling.invalid_sizes.size() == 1);
    const double told = scene.result.filling.invalid_sizes[0].size;
    assert(told == bad || (std::isnan(told) && std::isnan(bad)));
    scene.check(numbers_from_1(scene.soup.triangles.size()), { big.volume() });
  }
  Scene<K> scene(box_with_sheet_and_edges());
  scene.make([](const K::Point_3&, int, int) -> double { throw std::runtime_error("no idea"); });
  assert(scene.result.status == BR3::Meshing_status::invalid_input);
  std::ostringstream os;
  os << scene.result;
  assert(os.str().find("invalid_input\nrecovery: recovered\nregions: 1\nfilling: invalid_input") == 0);
  assert(os.str().find("no idea") != std::string::npos);
}

// A grading that is none is refused; the domain is marked by then. An edge inside has a say in the sizes.
void test_sizes_from_surface()
{
  typedef Scene<K>::Tr Tr;
  const auto make = [](Tr& tr, const Box_soup& soup, const double grading)
  {
    std::vector<K::Point_3> points;
    for(const auto& p : soup.points)
      points.emplace_back(p[0], p[1], p[2]);
    return CGAL::make_boundary_constrained_mesh_3(tr, points, soup.triangles,
                                                  parameters::constrained_edges(soup.edges),
                                                  parameters::grading(grading));
  };
  Box_soup soup;
  soup.add_box(big);
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double bad : { -0.1, -infinity, infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    Tr tr;
    const auto result = make(tr, soup, bad);
    assert(! result && result.status == BR3::Meshing_status::invalid_input);
    assert(result.recovery && result.number_of_regions == 1 && result.filling.number_of_field_points == 0);
    assert(result.filling.invalid_sizes.size() == 1 && ! result.filling.invalid_sizes[0].message.empty());
    std::ostringstream os;
    os << result;
    assert(os.str().find("grading") != std::string::npos);
  }
  Tr without, with;
  const std::size_t number = make(without, soup, 0.2).filling.number_of_field_points;
  soup.add_edge({{ 6, 6, 6 }}, {{ 6, 6, 7 }});
  const auto result = make(with, soup, 0.2);
  assert(result && result.filling.number_of_field_points > number + 50);
}

// Edges with Steiner points on them, named in any order and more than once.
void test_parts_of_edges()
{
  typedef Scene<K>::Tr Tr;
  BR3::Boundary_recovery_result_3<Tr> recovery;
  Tr tr;
  for(int i = 0; i < 7; ++i)
    recovery.vertices.push_back(tr.insert(K::Point_3(i, i * i, i * i * i)));
  const auto& v = recovery.vertices;
  const auto part = [&](const int i, const int j, const std::size_t a, const std::size_t b)
  {
    BR3::Constraint_part_3<Tr::Vertex_handle, K::Point_3> result;
    result.vertices = { v[i], v[j] };
    result.constraint.vertices = { a, b };
    return result;
  };
  recovery.parts_of_edges = { part(0, 5, 0, 1), part(5, 1, 0, 1), part(3, 6, 3, 2), part(6, 2, 3, 2) };
  const std::vector<std::array<std::size_t, 2> > given = { {{ 2, 3 }}, {{ 1, 2 }}, {{ 1, 0 }}, {{ 0, 1 }} };
  std::vector<std::array<std::size_t, 2> > passed;
  const auto pass = [&](const std::size_t i, const std::size_t j) { passed.push_back({{ i, j }}); };
  BR3::internal::for_each_constrained_edge(parameters::constrained_edges(given), pass);
  assert(passed == given);
  const BR3::internal::Constrained_mesh_edges_3<Tr> edges(recovery, passed);
  typedef std::vector<std::array<Tr::Vertex_handle, 2> > Edges;
  assert((edges.edges == Edges{ {{ v[3], v[6] }}, {{ v[6], v[2] }}, {{ v[1], v[2] }}, {{ v[0], v[5] }},
                                {{ v[5], v[1] }}, {{ v[0], v[5] }}, {{ v[5], v[1] }} }));
  assert((edges.numbers == std::vector<std::size_t>{ 1, 1, 2, 3, 3, 4, 4 }));
}

// While the mesh is improved, vertices of the input do not seem to be free; Steiner points that went or moved are
// forgotten afterwards.
void test_held_vertices()
{
  typedef Scene<K>::Tr Tr;
  BR3::Boundary_recovery_result_3<Tr> recovery;
  Tr tr;
  for(int i = 0; i < 9; ++i)
  {
    (i < 6 ? recovery.vertices : recovery.steiner_vertices).push_back(tr.insert(K::Point_3(i, i * i, i * i * i)));
    (i < 6 ? recovery.vertices : recovery.steiner_vertices).back()->set_dimension(i == 4 ? 2 : 3);
  }
  const std::vector<Tr::Vertex_handle> steiner = recovery.steiner_vertices;
  {
    BR3::internal::Hold_recovered_vertices_3<Tr> hold(tr, recovery);
    for(const Tr::Vertex_handle v : tr.finite_vertex_handles())
      assert(v->in_dimension() == (v == recovery.vertices[4] ? 2 : v->point().x() < 6 ? 0 : 3));
    hold.forget_lost_steiner_vertices();
    assert(recovery.steiner_vertices == steiner);
  }
  for(std::size_t i = 0; i < 6; ++i)
    assert(recovery.vertices[i]->in_dimension() == (i == 4 ? 2 : 3));
  {
    BR3::internal::Hold_recovered_vertices_3<Tr> hold(tr, recovery);
    tr.remove(steiner[0]);
    tr.insert(K::Point_3(0, 0, 7)); // which may get its handle
    steiner[1]->set_point(K::Point_3(7, 49, 340));
    hold.forget_lost_steiner_vertices();
  }
  assert(recovery.steiner_vertices == std::vector<Tr::Vertex_handle>{ steiner[2] });
}

// Steiner points on the surface: the parts of a triangle have its patch.
void test_conforming()
{
  std::vector<std::vector<std::size_t> > polygons;
  Box_soup soup;
  std::vector<K::Point_3> points;
  assert(CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/schoenhardt_br3.off"), points, polygons));
  for(const auto& polygon : polygons)
    soup.triangles.push_back({{ polygon[0], polygon[1], polygon[2] }});
  Scene<K> scene(soup);
  scene.points = points;
  scene.make([](const K::Point_3&, int, int) { return 0.3; },
             parameters::recovery_mode(BR3::Recovery_mode::conforming));
  assert(scene.result && ! scene.result.recovery.parts_of_edges.empty());
  assert(scene.result.filling.number_of_field_points > 0);
  scene.check_surface(numbers_from_1(soup.triangles.size()));
  scene.check_vertices();
  assert(br3_test::is_valid_mesh(scene.tr));
}

// A ball of 32 triangles, no two of which are alike, times a power of two.
struct Uneven_ball
{
  explicit Uneven_ball(const int exponent)
  {
    const std::array<std::array<int, 3>, 6> corners = {{ {{ 1, 0, 0 }}, {{ 0, 1, 0 }}, {{ -1, 0, 0 }}, {{ 0, -1, 0 }},
                                                         {{ 0, 0, 1 }}, {{ 0, 0, -1 }} }};
    for(const auto& p : corners)
      add({{ 2. * p[0], 2. * p[1], 2. * p[2] }}, exponent);
    for(std::size_t k = 0; k < 4; ++k)
    {
      add_divided({{ k, (k + 1) % 4, 4 }}, corners, exponent);
      add_divided({{ (k + 1) % 4, k, 5 }}, corners, exponent);
    }
  }

  void add(const std::array<double, 3>& p, const int exponent)
  {
    const double k = static_cast<double>(points.size());
    const double factor = std::ldexp((1 + 0.1 * std::sin(3 * k)) / std::hypot(p[0], p[1], p[2]), exponent);
    points.emplace_back(p[0] * factor, p[1] * factor, p[2] * factor);
  }

  void add_divided(const std::array<std::size_t, 3>& t, const std::array<std::array<int, 3>, 6>& corners,
                   const int exponent)
  {
    std::array<std::size_t, 3> middles; // opposite to each corner
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t u = t[(i + 1) % 3], v = t[(i + 2) % 3];
      const auto known = middle_of.emplace(std::minmax(u, v), points.size());
      if(known.second)
        add({{ double(corners[u][0] + corners[v][0]), double(corners[u][1] + corners[v][1]),
               double(corners[u][2] + corners[v][2]) }}, exponent);
      middles[i] = known.first->second;
    }
    for(std::size_t i = 0; i < 3; ++i)
      triangles.push_back({{ t[i], middles[(i + 2) % 3], middles[(i + 1) % 3] }});
    triangles.push_back(middles);
  }

  std::vector<K::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle_of; // of the corners
};

// The mesh of that ball, seen at the same scale for all of them.
struct Mesh_at_scale
{
  typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type Tr;

  // `size` 0: the smallest one of the surface.
  Mesh_at_scale(const int exponent, const double size, const int number_of_subdomains)
  {
    const Uneven_ball ball(exponent);
    Tr tr;
    const auto subdomains = parameters::number_of_subdomains(number_of_subdomains);
    const auto result = size > 0
      ? CGAL::make_boundary_constrained_mesh_3(tr, ball.points, ball.triangles, std::ldexp(size, exponent), subdomains)
      : CGAL::make_boundary_constrained_mesh_3(tr, ball.points, ball.triangles, parameters::grading(0), subdomains);
    assert(result && br3_test::is_valid_mesh(tr));
    forecast = result.filling.forecast_of_cells;
    quality = result.improvement.after;
    for(const auto v : tr.finite_vertex_handles())
      numbers.push_back({{ std::ldexp(v->point().x(), -exponent), std::ldexp(v->point().y(), -exponent),
                           std::ldexp(v->point().z(), -exponent), std::ldexp(v->meshing_info(), -exponent) }});
    std::sort(numbers.begin(), numbers.end());
    const auto certificate = BR3::quality_certificate(tr, 40);
    for(const auto& bad : certificate.cells)
      angles.push_back(bad.min_dihedral_angle);
  }

  double forecast;
  BR3::Mesh_quality_3 quality;
  std::vector<std::array<double, 4> > numbers; // coordinates, and the size
  std::vector<double> angles;
};

void check_same_mesh(const Mesh_at_scale& extreme, const Mesh_at_scale& usual, const double tolerance)
{
  const auto is_same = [&](const double x, const double y) { return std::abs(x - y) <= tolerance * std::abs(y); };
  assert(is_same(extreme.forecast, usual.forecast));
  assert(extreme.numbers.size() == usual.numbers.size());
  assert(extreme.angles.size() == usual.angles.size());
  for(std::size_t i = 0; i < usual.angles.size(); ++i)
    assert(is_same(extreme.angles[i], usual.angles[i]));
  for(std::size_t i = 0; i < usual.numbers.size(); ++i)
    for(std::size_t k = 0; k < 4; ++k)
      assert(is_same(extreme.numbers[i][k], usual.numbers[i][k]));
  assert(is_same(extreme.quality.min_dihedral_angle, usual.quality.min_dihedral_angle));
  assert(is_same(extreme.quality.max_dihedral_angle, usual.quality.max_dihedral_angle));
  assert(extreme.quality.number_of_cells == usual.quality.number_of_cells);
  assert(extreme.quality.histogram == usual.quality.histogram);
  assert(is_same(extreme.quality.share_of_edges_in_size, usual.quality.share_of_edges_in_size));
}

// Another scale, and the same points and sizes as before when it ends, with an exception, too.
void test_ordinary_scale()
{
  typedef Mesh_at_scale::Tr Tr;
  for(const int exponent : { -900, -65, 0, 64, 65, 1000 })
  {
    Tr tr;
    const double unit = std::ldexp(1., exponent);
    const std::vector<K::Point_3> points = { { unit, 0, 0 }, { 0, -unit, 0 }, { 0, 0, unit / 3 }, { 0, 0, 0 } };
    for(const auto& p : points)
      tr.insert(p)->set_meshing_info(unit / 5);
    try
    {
      const BR3::internal::Ordinary_scale_3<Tr> scale(tr);
      const double factor = std::abs(exponent) > 64 ? 1 / unit : 1;
      assert(scale.factor() == factor);
      for(const auto v : tr.finite_vertex_handles())
        assert(v->meshing_info() == unit / 5 * factor && std::abs(v->point().x()) <= unit * factor);
      throw std::runtime_error("stop");
    }
    catch(const std::runtime_error&)
    { }
    for(const auto v : tr.finite_vertex_handles())
      assert(v->meshing_info() == unit / 5 && std::count(points.begin(), points.end(), v->point()) == 1);
    assert(tr.is_valid());
  }
  Tr tr; // the smallest coordinate would be rounded
  const double tiny = 3 * std::ldexp(1., -800);
  const K::Point_3 large(1e150, 0, 0), small(0, tiny, 0);
  tr.insert(large);
  tr.insert(small);
  const BR3::internal::Ordinary_scale_3<Tr> scale(tr);
  assert(scale.factor() == 1);
}

// Products of a few lengths are no floating point numbers any more, but the mesh is the same, up to rounding errors:
// far from 1, CGAL numbers cells in another order. So parts are others, too, if it is divided.
void test_extreme_scales()
{
  for(const double size : { 0., 0.4 })
  {
    const Mesh_at_scale usual(0, size, 1);
    assert(usual.numbers.size() > 18 && usual.quality.min_dihedral_angle > 10 && ! usual.angles.empty());
    for(const int exponent : { -498, -166, 166, 365, 498 })
      check_same_mesh(Mesh_at_scale(exponent, size, 1), usual, 1e-9);
  }
  const Mesh_at_scale usual(0, 0.4, 2);
  check_same_mesh(Mesh_at_scale(166, 0.4, 2), usual, 0);
  for(const int exponent : { -498, 365 })
  {
    const Mesh_at_scale extreme(exponent, 0.4, 2);
    assert(std::abs(extreme.forecast / usual.forecast - 1) < 1e-9);
    assert(extreme.quality.min_dihedral_angle > 10 && extreme.numbers.size() < 1.2 * double(usual.numbers.size()));
  }
}

int main()
{
  test_regions<K>();
#ifndef BR3_TEST_EPICK_ONLY
  test<Exact>(box_with_sheet_and_edges(), 3, { big.volume() });
#endif
  test_voids();
  test_patches();
  test_improvement();
  test_other_ends();
  test_bad_sizes();
  test_sizes_from_surface();
  test_parts_of_edges();
  test_held_vertices();
  test_conforming();
  test_ordinary_scale();
  test_extreme_scales();
  std::cout << "meshes are right" << std::endl;
}
