// The promises of recover_boundary(): every constraint is there or listed, vertices stay as they are, all cells are
// positive, the outcome is the same each time and in each thread, and a recovery can be stopped anywhere.

#undef NDEBUG

#include "mesh_validity_br3.h"
#include "recovery_of_oracles_br3.h"

#include <CGAL/Boundary_recovery_3/internal/input/Recover_indexed_boundary.h>
#include <CGAL/Boundary_recovery_3/internal/input/input_conversion.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_planar_edges_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Boundary_recovery_3/label_regions.h>
#include <CGAL/Constrained_boundary_recovery_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
using CGAL::Boundary_recovery_3::Phase_report;
using CGAL::Boundary_recovery_3::Recovery_mode;
using CGAL::Boundary_recovery_3::Phase;
using CGAL::Boundary_recovery_3::Recovery_status;

template <typename K>
struct Soup
{
  std::vector<typename K::Point_3> points;
  std::vector<std::vector<std::size_t> > triangles;
};

template <typename K>
Soup<K> read(const std::string& name)
{
  Soup<K> soup;
  assert(CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/" + name), soup.points, soup.triangles));
  return soup;
}

// Not Delaunay by type, and its vertices have data of the caller.
template <typename K>
using Plain_triangulation = CGAL::Triangulation_3<
  K, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<int, K>,
                                          CGAL::Delaunay_triangulation_cell_base_3<K> > >;

typedef std::set<std::vector<std::size_t> > Cells;

// The finite cells by the input indices of their vertices.
template <typename Tr, typename Vertices>
Cells cells_by_index(const Tr& tr, const Vertices& vertices)
{
  std::map<const void*, std::size_t> index;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    index.emplace(&*vertices[i], i);
  Cells cells;
  for(const auto c : tr.finite_cell_handles())
  {
    std::vector<std::size_t> cell;
    for(int i = 0; i < 4; ++i)
      cell.push_back(index.at(&*c->vertex(i)));
    std::sort(cell.begin(), cell.end());
    cells.insert(cell);
  }
  return cells;
}

// The facets of the result are those of the input, and those of the surface are in the triangulation: each facet of the
// input, its parts if it has some, or nothing if it is missing.
template <typename Tr, typename Soup>
void check_facets(const Tr& tr, const Soup& soup, const CGAL::Boundary_recovery_result_3<Tr>& result)
{
  typedef typename CGAL::Boundary_recovery_result_3<Tr>::Vertex_triple Vertex_triple;
  std::vector<std::vector<Vertex_triple> > parts(soup.triangles.size()), found(soup.triangles.size());
  for(const auto& part : result.parts_of_facets)
    parts[part.constraint.index].push_back({{ part.vertices[0], part.vertices[1], part.vertices[2] }});
  std::size_t last = 0;
  for(const auto& facet : result.surface_facets())
  {
    typename Tr::Cell_handle c;
    int i, j, k;
    assert(tr.is_facet(facet[0], facet[1], facet[2], c, i, j, k));
    assert(facet.index >= last);
    last = facet.index;
    found[facet.index].push_back(facet);
  }
  std::vector<bool> is_missing(soup.triangles.size(), false);
  for(const auto& facet : result.missing_facets)
    is_missing[facet.index] = true;
  assert(result.facets.size() == soup.triangles.size());
  for(std::size_t f = 0; f < result.facets.size(); ++f)
  {
    for(std::size_t i = 0; i < 3; ++i)
      assert(result.facets[f][i] == result.vertices[soup.triangles[f][i]]);
    if(is_missing[f])
      assert(found[f].empty() && parts[f].empty());
    else
      assert(found[f] == (parts[f].empty() ? std::vector<Vertex_triple>(1, result.facets[f]) : parts[f]));
  }
}

// What the result says is missing is missing, and nothing else.
template <typename Tr, typename Soup>
void check_account(const Tr& tr, const Soup& soup, const CGAL::Boundary_recovery_result_3<Tr>& result)
{
  std::set<std::vector<std::size_t> > facets, edges;
  for(const auto& c : cells_by_index(tr, result.vertices))
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = i + 1; j < 4; ++j)
      {
        edges.insert({ c[i], c[j] });
        for(std::size_t k = j + 1; k < 4; ++k)
          facets.insert({ c[i], c[j], c[k] });
      }
  std::set<std::size_t> missing_facets;
  for(const auto& f : result.missing_facets)
  {
    assert(f.dimension == 2 && f.vertices == soup.triangles[f.index]);
    missing_facets.insert(f.index);
  }
  assert(missing_facets.size() == result.missing_facets.size());
  std::set<std::vector<std::size_t> > missing_edges, all_edges;
  for(const auto& e : result.missing_edges)
  {
    assert(e.dimension == 1 && e.points.size() == 2);
    missing_edges.insert({ (std::min)(e.vertices[0], e.vertices[1]), (std::max)(e.vertices[0], e.vertices[1]) });
  }
  for(std::size_t i = 0; i < soup.triangles.size(); ++i)
  {
    std::vector<std::size_t> t = soup.triangles[i];
    std::sort(t.begin(), t.end());
    assert((facets.count(t) == 0) == (missing_facets.count(i) != 0));
    all_edges.insert({ t[0], t[1] });
    all_edges.insert({ t[0], t[2] });
    all_edges.insert({ t[1], t[2] });
  }
  for(const auto& e : all_edges)
    assert((edges.count(e) == 0) == (missing_edges.count(e) != 0));
  assert(bool(result) == (result.missing_facets.empty() && result.missing_edges.empty()));
  assert(result.number_of_facets == soup.triangles.size() && result.number_of_edges == all_edges.size());
}

template <typename Tr, typename Soup>
CGAL::Boundary_recovery_result_3<Tr> recover_and_check(Tr& tr, const Soup& soup,
                                                       const Recovery_mode mode = Recovery_mode::constrained)
{
  const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles, params::recovery_mode(mode));
  assert(result.vertices.size() == soup.points.size());
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    assert(result.vertices[i]->point() == soup.points[i]);
  assert(tr.number_of_vertices() == soup.points.size());
  assert(br3_test::is_valid_mesh(tr));
  check_account(tr, soup, result);
  check_facets(tr, soup, result);
  assert(result.phases.front().phase == Phase::insertion);
  assert(result.phases[1].phase == Phase::search);
  const bool was_complete = result.phases[1].lost_edges == 0 && result.phases[1].lost_facets == 0;
  assert(result.phases.back().phase == (was_complete ? Phase::search : Phase::recount));
  return result;
}

template <typename K>
void test_surfaces()
{
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  for(const char* name : { "cube_br3.off", "nested_cubes_br3.off", "two_cubes_br3.off", "washer_br3.off",
                          "gear_br3.off" })
  {
    Tr tr;
    const auto result = recover_and_check(tr, read<K>(name));
    assert(result.status == Recovery_status::recovered);
    assert(result.phases[1].phase == Phase::search && result.phases[1].lost_edges > 0);
    assert(result.number_of_shell_transformations > 0);
  }
  // A point is needed: without, nobody can recover this, and it is no fault of the input.
  const auto soup = read<K>("schoenhardt_br3.off");
  Tr tr;
  const auto result = recover_and_check(tr, soup, Recovery_mode::flips_only);
  assert(result.status == Recovery_status::incomplete);
  assert(result.defects.empty() && ! result.missing_edges.empty() && ! result.missing_facets.empty());
  assert(result.surface_facets().size() == soup.triangles.size() - result.missing_facets.size());
  Tr with_points;
  const auto recovered = CGAL::recover_boundary(with_points, soup.points, soup.triangles);
  assert(recovered.status == Recovery_status::recovered && recovered.steiner_vertices.size() == 1);
  assert(with_points.number_of_vertices() == soup.points.size() + 1);
  assert(br3_test::is_valid_mesh(with_points));
  check_facets(with_points, soup, recovered);
}

// Where points are on facets, their parts take their place: they bound the region, and can be recovered again.
template <typename K>
void test_split_facets()
{
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  const auto soup = read<K>("schoenhardt_br3.off");
  Tr tr;
  const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles,
                                             params::recovery_mode(Recovery_mode::conforming));
  assert(result && ! result.parts_of_facets.empty());
  check_facets(tr, soup, result);
  const auto facets = result.surface_facets();
  assert(facets.size() > soup.triangles.size());
  std::map<typename Tr::Cell_handle, int> region;
  assert(CGAL::Boundary_recovery_3::label_regions(tr, facets, boost::make_assoc_property_map(region)) == 1);
  const auto again = CGAL::recover_boundary(tr, facets);
  assert(again && again.number_of_shell_transformations == 0);
  assert(std::equal(facets.begin(), facets.end(), again.facets.begin(), again.facets.end()));
}

// There are no facets where the input is invalid, be it found at once, or when some are missing after the flips.
void test_facets_of_invalid_input()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
  const std::vector<K::Point_3> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 },
                                           { 1, 1, -4 }, { 1, 1, 4 }, { 5, 5, 1 } };
  const std::vector<std::array<std::size_t, 3> > crossing = { {{ 0, 1, 2 }}, {{ 3, 4, 5 }} }, flat = { {{ 0, 1, 1 }} };
  for(const auto& triangles : { crossing, flat })
  {
    CGAL::Delaunay_triangulation_3<K> tr;
    const auto result = CGAL::recover_boundary(tr, points, triangles);
    assert(result.status == Recovery_status::invalid_input);
    assert(result.missing_facets.empty() == (triangles == flat));
    assert(result.facets.empty() && result.surface_facets().empty());
  }
}

template <typename K>
void test_overloads()
{
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  typedef CGAL::Surface_mesh<typename K::Point_3> Mesh;
  typedef CGAL::Polyhedron_3<K> Polyhedron;
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Soup<K> soup = read<K>("gear_br3.off");
  Tr tr;
  const auto expected = recover_and_check(tr, soup);
  const Cells cells = cells_by_index(tr, expected.vertices);

  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  Tr of_mesh;
  std::map<typename Mesh::Vertex_index, typename Tr::Vertex_handle> handles;
  const auto result = CGAL::recover_boundary(of_mesh, mesh,
                                             params::vertex_to_vertex_map(boost::make_assoc_property_map(handles)));
  assert(result && cells_by_index(of_mesh, result.vertices) == cells);
  assert(handles.size() == num_vertices(mesh));
  for(const auto v : vertices(mesh))
    assert(handles[v]->point() == mesh.point(v));
  std::size_t number_of_faces = 0;
  for(const auto f : faces(mesh))
  {
    std::size_t i = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      assert(result.facets[number_of_faces][i++] == handles[v]);
    ++number_of_faces;
  }
  assert(result.facets.size() == number_of_faces);

  Polyhedron polyhedron;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, polyhedron);
  Tr of_polyhedron;
  assert(CGAL::recover_boundary(of_polyhedron, polyhedron));

  // A second call inserts nothing, and keeps what it is given again.
  const auto again = CGAL::recover_boundary(tr, soup.points, soup.triangles);
  assert(again && again.number_of_inserted_vertices == 0 && again.number_of_shell_transformations == 0);
  assert(again.vertices == expected.vertices && cells_by_index(tr, again.vertices) == cells);

  // Vertex handles, also in a triangulation that is not Delaunay by type.
  Plain_triangulation<K> plain(soup.points.begin(), soup.points.end());
  const auto of_plain = CGAL::recover_boundary(plain, soup.points, soup.triangles,
                                               params::recovery_mode(Recovery_mode::flips_only));
  assert(of_plain.status == Recovery_status::recovered || of_plain.status == Recovery_status::incomplete);
  check_account(plain, soup, of_plain);
  check_facets(plain, soup, of_plain);
  std::vector<std::array<typename Tr::Vertex_handle, 3> > facets;
  for(const auto& t : soup.triangles)
    facets.push_back({{ expected.vertices[t[0]], expected.vertices[t[1]], expected.vertices[t[2]] }});
  assert(facets == expected.facets);
  const auto of_handles = CGAL::recover_boundary(tr, facets);
  assert(of_handles && of_handles.facets == facets && cells_by_index(tr, expected.vertices) == cells);
}

// Says stop at the first question. No points are inserted then.
struct Stop_at_once
  : public CGAL::Default_meshing_visitor_3
{
  bool go_further()
  {
    is_asked = true;
    return false;
  }

  void on_phase_begin(const Phase phase) { assert(phase != Phase::insertion || ! is_asked); }

  bool is_asked = false;
};

// By their indices.
template <typename Result>
std::vector<std::size_t> unknown_vertices(const Result& result)
{
  typedef CGAL::Boundary_recovery_3::Input_defect_kind Kind;
  assert(result.status == Recovery_status::invalid_input && ! result);
  std::ostringstream os;
  os << result;
  assert(os && os.str().find(to_string(Kind::unknown_vertex)) != std::string::npos);
  std::vector<std::size_t> indices;
  for(const auto& d : result.defects)
    if(d.kind == Kind::unknown_vertex)
    {
      assert(d.simplices.size() == 1 && d.simplices[0].dimension == 0);
      indices.push_back(d.simplices[0].index);
    }
  return indices;
}

// Nothing is inserted in a triangulation that is not Delaunay by type. Points that it does not have are told, even if
// the search for other defects was stopped.
template <typename K>
void test_unknown_vertices()
{
  typedef Plain_triangulation<K>   Plain;
  typedef typename K::Point_3      Point_3;
  typedef std::vector<std::size_t> Indices;
  std::vector<Point_3> points = { Point_3(0, 0, 0), Point_3(4, 0, 0), Point_3(0, 4, 0), Point_3(0, 0, 4) };
  Plain tetrahedron(points.begin(), points.end());
  points.push_back(Point_3(7, 7, 7));
  const std::vector<Indices> faces = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  assert(unknown_vertices(CGAL::recover_boundary(tetrahedron, points, faces)) == Indices({ 4 }));
  assert(tetrahedron.number_of_vertices() == 4 && tetrahedron.number_of_cells() == 5 && tetrahedron.is_valid());

  const std::size_t n = 60;
  std::vector<Point_3> fan;
  std::vector<Indices> triangles;
  for(std::size_t i = 0; i <= n; ++i)
    fan.emplace_back(double(i), double(i * i), 0);
  fan.emplace_back(0, 0, 100);
  for(std::size_t i = 0; i < n; ++i)
    triangles.push_back({ i, i + 1, n + 1 });
  Plain plain(fan.begin() + 2, fan.end());
  Stop_at_once visitor;
  const auto result = CGAL::recover_boundary(plain, fan, triangles, params::list_defects(true),
                                             params::visitor(std::ref(visitor)));
  assert(visitor.is_asked && unknown_vertices(result).size() == 2 && result.defects.size() == 2);
}

template <typename K>
void test_parameters()
{
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  typedef typename K::Point_3 Point_3;
  const auto flips_only = params::recovery_mode(Recovery_mode::flips_only);
  const Soup<K> soup = read<K>("washer_br3.off");
  {
    Tr tr;
    assert(CGAL::recover_boundary(tr, soup.points, soup.triangles, params::max_recursion_level(8), flips_only,
                                  params::geom_traits(K()).maximum_running_time(1000.)));
  }
  { // recursion is needed here, and 0 forbids it
    const Soup<K> gear = read<K>("gear_br3.off");
    Tr tr;
    const auto result = CGAL::recover_boundary(tr, gear.points, gear.triangles, params::max_recursion_level(0));
    for(const auto& level : result.levels)
      assert(level.max_recursion_level <= 0 && level.n1 <= level.n2 && level.n3 <= level.n4 && level.n4 <= level.n2);
  }
  { // points behind a map
    std::vector<std::pair<int, Point_3> > pairs;
    for(const Point_3& p : soup.points)
      pairs.emplace_back(static_cast<int>(pairs.size()), p);
    Tr tr;
    assert(CGAL::recover_boundary(tr, pairs, soup.triangles,
             params::point_map(CGAL::Second_of_pair_property_map<std::pair<int, Point_3> >())));
  }
  { // a sheet that ends inside, an isolated edge, and a point that was there before: the bipyramid loses its axis
    const std::vector<Point_3> points = { Point_3(0, 0, 0), Point_3(4, 0, 0), Point_3(0, 4, 0),
                                          Point_3(1, 1, -1), Point_3(1, 1, 1), Point_3(9, 9, 9) };
    const std::vector<std::array<std::size_t, 3> > sheet = { {{ 0, 3, 4 }} };
    const std::vector<std::array<std::size_t, 2> > edges = { {{ 3, 4 }}, {{ 1, 5 }} };
    Tr tr;
    tr.insert(Point_3(-9, -9, 9));
    tr.insert(points[5]);
    const auto result = CGAL::recover_boundary(tr, points, sheet, params::constrained_edges(edges));
    assert(result && result.number_of_facets == 1 && result.number_of_edges == 4);
    assert(result.number_of_inserted_vertices == 5);
    typename Tr::Cell_handle c;
    int i, j, k;
    assert(tr.is_facet(result.vertices[0], result.vertices[3], result.vertices[4], c, i, j, k));
    assert(tr.is_edge(result.vertices[3], result.vertices[4], c, i, j));
    assert(tr.is_edge(result.vertices[1], result.vertices[5], c, i, j));
    assert(br3_test::is_valid_mesh(tr));
  }
}

// Two lost edges cross one mesh edge, whichever way they run: n4 counts it once.
void test_number_of_crossed_entities()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  const std::vector<K::Point_3> points = { { 0, 0, -4 }, { 0, 0, 4 },
                                           { -8, 0, 1 }, { 8, 0, 1 }, { 0, -8, -1 }, { 0, 8, -1 } };
  for(const bool is_first_reversed : { false, true })
    for(const bool is_second_reversed : { false, true })
    {
      Tr tr;
      std::vector<Tr::Vertex_handle> v;
      for(const K::Point_3& p : points)
        v.push_back(tr.insert(p));
      CGAL::Constrained_boundary_recovery_3<Tr> recovery(tr);
      recovery.insert_constraint(v[is_first_reversed ? 3 : 2], v[is_first_reversed ? 2 : 3]);
      recovery.insert_constraint(v[is_second_reversed ? 5 : 4], v[is_second_reversed ? 4 : 5]);
      recovery.search();
      recovery.recover_edges_brc1();
      assert(recovery.lost_edges().empty());
      const auto& level = recovery.levels().front();
      assert(level.max_recursion_level == -1 && level.n1 == 2 && level.n2 == 2 && level.n3 == 1 && level.n4 == 1);
    }
}

// Vertices keep the data of the caller.
void test_custom_base()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
  Plain_triangulation<K> tr;
  const Soup<K> soup = read<K>("gear_br3.off");
  int n = 0;
  for(const auto& p : soup.points)
    tr.insert(p)->info() = n++;
  const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles);
  assert(result && result.number_of_inserted_vertices == 0);
  for(int i = 0; i < n; ++i)
    assert(result.vertices[i]->info() == i);
}

typedef CGAL::Exact_predicates_inexact_constructions_kernel                 K;
typedef CGAL::Delaunay_triangulation_3<K>                                   Tr;

Cells recovered_cells(const Soup<K>& soup)
{
  Tr tr;
  const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles);
  assert(result);
  return cells_by_index(tr, result.vertices);
}

// Has nothing but iterators.
template <typename Container>
struct Bare_range
{
  typedef typename Container::const_iterator const_iterator;
  const_iterator begin() const { return container.begin(); }
  const_iterator end() const { return container.end(); }
  Container container;
};

void test_ranges()
{
  const Soup<K> soup = read<K>("two_cubes_br3.off");
  CGAL::Delaunay_triangulation_3<K> expected, tr;
  const auto result = CGAL::recover_boundary(expected, soup.points, soup.triangles);
  typedef std::list<K::Point_3> Points;
  const Points points(soup.points.begin(), soup.points.end());
  const auto same = CGAL::recover_boundary(tr, Bare_range<Points>{ points }, soup.triangles);
  assert(result && same);
  assert(cells_by_index(tr, same.vertices) == cells_by_index(expected, result.vertices));
}

void test_options()
{
  namespace internal = CGAL::Boundary_recovery_3::internal;
  const internal::Recovery_options defaults = internal::recovery_options(params::default_values());
  assert(defaults.mode == Recovery_mode::constrained && defaults.max_recursion_level < 0 && ! defaults.list_defects);
  assert(defaults.maximum_running_time == std::numeric_limits<double>::infinity());
  const internal::Recovery_options options = internal::recovery_options(internal::merge_all(
    params::maximum_running_time(2.5), params::recovery_mode(Recovery_mode::flips_only),
    params::max_recursion_level(7), params::list_defects(true)));
  assert(options.mode == Recovery_mode::flips_only && options.max_recursion_level == 7 && options.list_defects);
  assert(options.maximum_running_time == 2.5);
  assert(internal::size_or_zero(std::vector<int>(3), 0) == 3);
  assert(internal::size_or_zero(Bare_range<std::list<int> >{ std::list<int>(3) }, 0) == 0);
}

// What all the overloads lead to, without vertices and with them.
void test_index_form()
{
  namespace internal = CGAL::Boundary_recovery_3::internal;
  typedef CGAL::Delaunay_triangulation_3<K> Tr;
  const Soup<K> soup = read<K>("gear_br3.off");
  Tr expected, tr;
  const auto result = CGAL::recover_boundary(expected, soup.points, soup.triangles);
  internal::Indexed_input_3<K::Point_3> input;
  input.points = soup.points;
  for(const auto& t : soup.triangles)
    input.facets.push_back({{ t[0], t[1], t[2] }});
  const K kernel;
  const internal::Recovery_options options;
  internal::Mesh_visitor_3<Tr> visitor;
  std::vector<Tr::Vertex_handle> vertices;
  for(const bool is_new : { true, false })
  {
    internal::Recover_indexed_boundary<Tr, K> recover(tr, input, kernel, options, visitor);
    const auto same = recover(vertices);
    assert(same && same.number_of_inserted_vertices == (is_new ? soup.points.size() : 0));
    assert(cells_by_index(tr, same.vertices) == cells_by_index(expected, result.vertices));
    assert(is_new || same.vertices == vertices);
    vertices = same.vertices;
  }
}

void test_determinism()
{
  const Soup<K> soup = read<K>("gear_br3.off");
  const Cells expected = recovered_cells(soup);
  std::vector<std::unique_ptr<char[]> > junk; // other addresses for the second run
  for(std::size_t i = 1; i < 500; ++i)
    junk.emplace_back(new char[(i * 7919) % 4000 + 1]);
  assert(recovered_cells(soup) == expected);
  Cells of_thread[2];
  std::thread t0([&] { of_thread[0] = recovered_cells(soup); });
  std::thread t1([&] { of_thread[1] = recovered_cells(soup); });
  t0.join();
  t1.join();
  assert(of_thread[0] == expected && of_thread[1] == expected);
}

// Keeps the set of finite and infinite cells by their addresses, and stops at the n-th question.
struct Watching_visitor
  : public CGAL::Default_meshing_visitor_3
{
  explicit Watching_visitor(const std::size_t n) : last_question(n) { }

  void on_phase_begin(const Phase phase)
  {
    assert(! is_in_phase);
    is_in_phase = true;
    current = phase;
  }

  void on_phase_end(const Phase_report& report)
  {
    assert(is_in_phase && report.phase == current && report.seconds >= 0);
    is_in_phase = false;
    ++number_of_phases;
  }

  bool go_further() { return ++questions < last_question; }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells) { number_of_cells -= static_cast<long>(cells.size()); }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { number_of_cells += static_cast<long>(cells.size()); }

  std::size_t last_question, questions = 0, number_of_phases = 0;
  long number_of_cells = 0;
  bool is_in_phase = false;
  Phase current = Phase::insertion;
};

// Given by value, a copy of it is called.
struct Visitor_to_be_copied
  : public CGAL::Default_meshing_visitor_3
{
  explicit Visitor_to_be_copied(std::size_t& calls) : calls(calls) { }
  void on_phase_end(const CGAL::Boundary_recovery_3::Phase_report&) { ++calls; ++own_calls; }

  std::size_t& calls;
  std::size_t own_calls = 0;
};

// A prism over an N-gon. Its vertices are nearly cocircular, so that the Delaunay triangulation divides the caps in
// another way than the given one, and a lost edge crosses ten mesh edges and more.
Soup<K> prism(const std::size_t n, const std::vector<std::array<std::size_t, 3> >& cap)
{
  Soup<K> soup;
  for(const double z : { 0., 1. })
    for(std::size_t i = 0; i < n; ++i)
    {
      const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
      soup.points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  for(std::size_t i = 0, j = 1; i < n; ++i, j = (i + 1) % n)
  {
    soup.triangles.push_back({{ i, j, n + j }});
    soup.triangles.push_back({{ i, n + j, n + i }});
  }
  for(const auto& t : cap)
  {
    soup.triangles.push_back({{ t[0], t[2], t[1] }});
    soup.triangles.push_back({{ n + t[0], n + t[1], n + t[2] }});
  }
  return soup;
}

std::vector<std::array<std::size_t, 3> > fan(const std::size_t n, const std::size_t hub)
{
  std::vector<std::array<std::size_t, 3> > cap;
  for(std::size_t i = 1; i + 1 < n; ++i)
    cap.push_back({{ hub, (hub + i) % n, (hub + i + 1) % n }});
  return cap;
}

std::vector<std::array<std::size_t, 3> > zigzag_strip(const std::size_t n)
{
  std::vector<std::array<std::size_t, 3> > cap;
  for(std::size_t i = 0, j = n - 1; j - i > 1; )
    if(i + j == n - 1)
    {
      cap.push_back({{ i, i + 1, j }});
      ++i;
    }
    else
    {
      cap.push_back({{ i, j - 1, j }});
      --j;
    }
  return cap;
}

template <typename Result>
bool has_planar_phase(const Result& result)
{
  return std::any_of(result.phases.begin(), result.phases.end(), [](const CGAL::Boundary_recovery_3::Phase_report& r)
  {
    return r.phase == Phase::planar_edge_recovery;
  });
}

// A point beside each cap lets the edges come back by flips in the plane: about as many as there are lost edges, and
// no, or hardly any, points on constraints. By recursion, it takes 3,082 for 741 edges of fans; zigzag strips get a
// point for every tenth edge.
void test_tangled_planar_edges()
{
  for(const auto& soup : { prism(302, fan(302, 0)), prism(151, fan(151, 70)), prism(250, zigzag_strip(250)) })
  {
    Tr tr;
    const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles);
    check_facets(tr, soup, result);
    assert(result.status == Recovery_status::recovered && has_planar_phase(result));
    assert(br3_test::is_valid_mesh(tr));
    assert(result.number_of_constraint_points <= 2);
    assert(result.steiner_vertices.size() <= 1);
    assert(result.number_of_shell_transformations < 2 * result.phases[1].lost_edges);
  }
}

struct Throwing_visitor
  : public CGAL::Default_meshing_visitor_3
{
  void on_progress(const Phase phase, const std::size_t done, const std::size_t total)
  {
    if(phase == Phase::planar_edge_recovery && 2 * done > total)
      throw std::runtime_error("in the middle of a plane");
  }
};

// No point is left in the mode `flips_only`, nor beside a plane where the visitor ends the recovery or throws.
void test_points_beside_planes_are_taken_back()
{
  const Soup<K> soup = prism(250, zigzag_strip(250));
  {
    Tr tr;
    const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles,
                                               params::recovery_mode(Recovery_mode::flips_only));
    assert(has_planar_phase(result) && result.steiner_vertices.empty());
    assert(tr.number_of_vertices() == soup.points.size() && br3_test::is_valid_mesh(tr));
  }
  {
    Tr tr(soup.points.begin(), soup.points.end());
    Throwing_visitor visitor;
    bool is_thrown = false;
    try {
      CGAL::recover_boundary(tr, soup.points, soup.triangles, params::visitor(std::ref(visitor)));
    } catch(const std::runtime_error&) {
      is_thrown = true;
    }
    assert(is_thrown && tr.number_of_vertices() == soup.points.size() && br3_test::is_valid_mesh(tr));
  }
  std::size_t stopped = 0;
  for(std::size_t n = 1; n < 1000; n += 199)
  {
    Tr tr(soup.points.begin(), soup.points.end());
    Watching_visitor visitor(n);
    const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles, params::visitor(std::ref(visitor)));
    assert(br3_test::is_valid_mesh(tr));
    assert(tr.number_of_vertices() == soup.points.size() + result.steiner_vertices.size());
    if(result.status != Recovery_status::stopped || ! has_planar_phase(result))
      continue;
    ++stopped;
    const auto& report = result.phases[2]; // after the insertion and the search
    assert(report.phase == Phase::planar_edge_recovery);
    assert(result.steiner_vertices.empty() || report.lost_edges < result.phases[1].lost_edges);
  }
  assert(stopped > 0);
}

void test_visitor_by_value()
{
  const Soup<K> soup = read<K>("gear_br3.off");
  Tr tr;
  std::size_t calls = 0;
  const Visitor_to_be_copied visitor(calls);
  const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles,
                                             params::visitor(visitor).maximum_running_time(1000.));
  assert(result && calls == result.phases.size() && visitor.own_calls == 0);
}

void test_visitor()
{
  const Soup<K> soup = read<K>("gear_br3.off");
  const std::size_t never = (std::numeric_limits<std::size_t>::max)();
  std::size_t total = 0, stopped = 0;
  {
    Tr tr(soup.points.begin(), soup.points.end());
    const long before = static_cast<long>(tr.number_of_cells());
    Watching_visitor visitor(never);
    const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles, params::visitor(std::ref(visitor)));
    assert(result && ! visitor.is_in_phase && visitor.number_of_phases == result.phases.size());
    assert(before + visitor.number_of_cells == static_cast<long>(tr.number_of_cells()));
    total = visitor.questions;
    assert(total > 50);
  }
  for(std::size_t n = 1; n <= total + 1; n += n < 20 ? 1 : total / 25)
  {
    Tr tr(soup.points.begin(), soup.points.end());
    Watching_visitor visitor(n);
    const auto result = CGAL::recover_boundary(tr, soup.points, soup.triangles, params::visitor(std::ref(visitor)));
    assert(! visitor.is_in_phase);
    assert(result.status == Recovery_status::stopped || result.status == Recovery_status::recovered);
    stopped += result.status == Recovery_status::stopped;
    assert(br3_test::is_valid_mesh(tr));
    check_account(tr, soup, result);
    check_facets(tr, soup, result);
  }
  assert(stopped > 20);
  { // no time at all, before and after the points are there
    Tr tr;
    const auto at_once = CGAL::recover_boundary(tr, soup.points, soup.triangles, params::maximum_running_time(0.));
    assert(at_once.status == Recovery_status::stopped && at_once.missing_facets.size() == soup.triangles.size());
    check_facets(tr, soup, at_once);
    assert(at_once.facets[0] == decltype(at_once)::Vertex_triple());
    tr.insert(soup.points.begin(), soup.points.end());
    const auto later = CGAL::recover_boundary(tr, soup.points, soup.triangles, params::maximum_running_time(0.));
    assert(later.status == Recovery_status::stopped);
    check_account(tr, soup, later);
    assert(at_once.number_of_edges == later.number_of_edges && at_once.missing_edges.size() == later.number_of_edges);
  }
}

int main()
{
  test_surfaces<K>();
  test_split_facets<K>();
  test_overloads<K>();
  test_unknown_vertices<K>();
  test_parameters<K>();
#ifndef BR3_TEST_EPICK_ONLY // to save time where compiling is slow
  typedef CGAL::Exact_predicates_exact_constructions_kernel EK;
  test_surfaces<EK>();
  test_split_facets<EK>();
  test_overloads<EK>();
  test_unknown_vertices<EK>();
  test_parameters<EK>();
#endif
  test_number_of_crossed_entities();
  test_facets_of_invalid_input();
  test_custom_base();
  test_ranges();
  test_options();
  test_index_form();
  test_determinism();
  test_tangled_planar_edges();
  test_points_beside_planes_are_taken_back();
  test_visitor();
  test_visitor_by_value();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
