// Random constrained meshes are filled with points for random sizes: boxes in grids, and random regions, sheets and
// edges among random points of small grids, or beside them; sources are outside, inside, and on the constraints. Then
// points are inserted exactly on constraints. Each mesh is judged in rational numbers, and made twice.
//   N SEED [SECONDS]  N meshes, or as many as fit in the time; N consecutive SEEDs. Each is told before it is made.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "box_soup_br3.h"
#include "brute_force_checker_br3.h"
#include "grid_scene_br3.h"
#include "mesh_validity_br3.h"
#include "random_numbers_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/Source_sizing_field_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Field_point_cavity_3.h>
#include <CGAL/Boundary_recovery_3/internal/filling/Insert_field_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/mark_domain.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;
namespace parameters = CGAL::parameters;
typedef br3_test::Rational                                  Rational;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact;

const std::size_t max_number_of_new_vertices = 800;

// A mesh with regions, walls and edges that must stay.
template <typename Kernel>
class Random_mesh
  : public br3_test::Grid_scene<typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type>
{
public:
  typedef br3_test::Grid_scene<typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type> Base;
  typedef typename Base::Triangulation            Tr;
  typedef typename Tr::Cell_handle                Cell_handle;
  typedef typename Tr::Vertex_handle              Vertex_handle;
  typedef typename Tr::Point                      Point;
  typedef std::pair<Vertex_handle, Vertex_handle> Edge;
  typedef std::map<int, Rational>                 Volumes;
  typedef std::map<std::set<Vertex_handle>, std::array<int, 3> > Walls;
  using Base::tr;

  std::mt19937 rng;
  std::set<Edge> edges;
  std::set<Cell_handle> selected;
  double extent;

  explicit Random_mesh(const unsigned seed) : Base(seed % 3 == 0 ? 3 : 0), rng(seed)
  {
    if(seed % 3 == 0)
      mark_boxes();
    else
    {
      insert_random_points();
      if(random_int(2) == 0)
        flip_randomly();
      const bool is_one_region = random_int(3) == 0;
      mark_random_regions(is_one_region);
      if(! is_one_region)
        mark_random_sheets();
    }
    const bool is_selected_all = random_int(2) == 0;
    const int part_of_edges = 5 + random_int(100);
    for(const Cell_handle c : tr.finite_cell_handles())
      if(is_selected_all || random_int(3) > 0)
        selected.insert(c);
    for(const Cell_handle c : tr.finite_cell_handles()) // the order of finite_edges() depends on addresses
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < i; ++j)
          if(random_int(part_of_edges) == 0)
            edges.insert({ c->vertex(i), c->vertex(j) });
  }

  int random_int(const int n) { return br3_test::random_int(rng, n); }
  double random_number(const double low, const double high) { return low + (high - low) * random_int(1024) / 1023; }

  static int region(const Cell_handle c) { return static_cast<int>(c->subdomain_index()); }

  static bool is_wall(const Cell_handle c, const int i)
  {
    return c->is_facet_on_surface(i) || region(c) != region(c->neighbor(i));
  }

  // With the regions of both sides and the patch.
  Walls walls() const
  {
    Walls result;
    for(const auto& f : tr.finite_facets())
      if(is_wall(f.first, f.second))
      {
        const auto v = internal::facet_vertices(f.first, f.second);
        const auto mirror = tr.mirror_facet(f);
        const int r = region(f.first), s = region(mirror.first);
        assert(f.first->surface_patch_index(f.second) == mirror.first->surface_patch_index(mirror.second));
        result[{ v[0], v[1], v[2] }] = {{ (std::min)(r, s), (std::max)(r, s),
                                          static_cast<int>(f.first->surface_patch_index(f.second)) }};
      }
    return result;
  }

  // Six times the volume that the walls of each region bound.
  Volumes volumes_inside_walls() const
  {
    Volumes result;
    for(const Cell_handle c : tr.finite_cell_handles())
      for(int i = 0; i < 4; ++i)
        if(region(c) != 0 && region(c) != region(c->neighbor(i)))
        {
          const auto v = internal::facet_vertices(c, i);
          result[region(c)] += volume({{ v[0], v[1], v[2] }}, br3_test::Rational_point{ { 0, 0, 0 } });
        }
    return result;
  }

  // The same as the sum of the cells, all of which have to be positive.
  Volumes volumes_of_cells() const
  {
    Volumes result;
    for(const Cell_handle c : tr.finite_cell_handles())
    {
      const Rational v = volume({{ c->vertex(0), c->vertex(1), c->vertex(2) }},
                                br3_test::to_rational(c->vertex(3)->point()));
      assert(v > 0);
      if(region(c) != 0)
        result[region(c)] += v;
    }
    return result;
  }

  Cell_handle random_cell()
  {
    const auto cells = cells_of_domain();
    return cells[random_int(static_cast<int>(cells.size()))];
  }

  // At a vertex of a cell, on an edge or a facet, inside, or, rarely, outside; coordinates are rounded.
  Point random_place(const Cell_handle c)
  {
    const int i = random_int(4), number_of_corners = 1 + random_int(4);
    std::array<double, 3> x = {{ 0, 0, 0 }};
    for(int k = 0; k < number_of_corners; ++k)
      for(int j = 0; j < 3; ++j)
        x[j] += internal::coordinates_of(c->vertex((i + k) % 4)->point())[j] / number_of_corners;
    if(random_int(6) == 0)
      x[random_int(3)] += random_number(-3, 3) * extent;
    return Point(x[0], x[1], x[2]);
  }

  Point random_place() { return random_place(random_cell()); }

private:
  std::vector<Cell_handle> cells_of_domain() const
  {
    std::vector<Cell_handle> result;
    for(const Cell_handle c : tr.finite_cell_handles())
      if(region(c) != 0)
        result.push_back(c);
    return result;
  }

  static Rational volume(const std::array<Vertex_handle, 3>& v, const br3_test::Rational_point& p)
  {
    return br3_test::volume(br3_test::to_rational(v[0]->point()), br3_test::to_rational(v[1]->point()),
                            br3_test::to_rational(v[2]->point()), p);
  }

  // A box in a box, another region or a void, and a sheet.
  void mark_boxes()
  {
    extent = 3;
    const br3_test::Box outer = { {{ 0, 0, 0 }}, {{ 3, 3, 3 }} };
    const br3_test::Box inner = { {{ 1, 1, 1 }}, {{ 2, 2, 2 }} };
    const bool has_inner = random_int(3) > 0;
    this->add_box(outer.low, outer.high, random_int(4) > 0);
    if(has_inner)
      this->add_box(inner.low, inner.high, random_int(2) == 0);
    if(random_int(2) == 0) // it does not reach through
    {
      const int axis = random_int(3), position = 1 + random_int(2);
      std::array<int, 3> low = {{ random_int(2), random_int(2), random_int(2) }}, high = {{ 2, 2, 2 }};
      low[axis] = high[axis] = position;
      this->add_rectangle(axis, low, high, random_int(2) == 0);
    }
    const int number_of_regions = CGAL::mark_domain(tr, this->facets);
    assert(number_of_regions == 1 || (has_inner && number_of_regions == 2));
    Rational all = 0;
    for(const auto& v : volumes_of_cells())
    {
      all += v.second;
      assert(v.second == Rational(6 * inner.volume()) || v.second == Rational(6 * outer.volume())
             || v.second == Rational(6 * (outer.volume() - inner.volume())));
    }
    assert(all == Rational(6 * outer.volume()) || all == Rational(6 * (outer.volume() - inner.volume())));
  }

  void insert_random_points()
  {
    const int grid = 2 + random_int(5), number = 6 + random_int(40), positions = random_int(4);
    const double unit = positions == 0 ? 0.1 : 1;
    extent = grid * unit;
    const auto coordinate = [&]
    {
      const double x = random_int(grid + 1) * unit;
      return positions == 1 ? x + std::ldexp(random_int(5) - 2, -46) : x;
    };
    for(int k = 0; k < number; ++k)
    {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      tr.insert(Point(x, y, z));
    }
    for(int j = 0; j < 3; ++j)
      tr.insert(Point(j == 0 ? extent : 0, j == 1 ? extent : 0, j == 2 ? extent : 0));
    assert(tr.dimension() == 3);
  }

  // Far from Delaunay, circumspheres contain vertices.
  void flip_randomly()
  {
    for(int k = 0; k < 400; ++k)
    {
      const std::vector<Cell_handle> cells(tr.finite_cell_handles().begin(), tr.finite_cell_handles().end());
      const Cell_handle c = cells[random_int(static_cast<int>(cells.size()))];
      const int i = random_int(4);
      if(! tr.flip(c, i))
        tr.flip(c, i, (i + 1 + random_int(3)) % 4);
    }
    assert(br3_test::is_valid_mesh(tr));
  }

  // Each grows from a cell; or each cell has any region; or all have the same.
  void mark_random_regions(const bool is_one_region)
  {
    const std::vector<Cell_handle> cells(tr.finite_cell_handles().begin(), tr.finite_cell_handles().end());
    const int number = static_cast<int>(cells.size()), number_of_regions = is_one_region ? 1 : 1 + random_int(3);
    const bool are_scattered = ! is_one_region && random_int(4) == 0;
    const bool is_background_inside = is_one_region || random_int(2) == 0;
    for(const Cell_handle c : tr.all_cell_handles())
      c->set_subdomain_index(tr.is_infinite(c) ? 0 : are_scattered ? random_int(number_of_regions + 1)
                                                                   : is_background_inside);
    for(int r = 1; ! are_scattered && r <= number_of_regions; ++r)
    {
      std::vector<Cell_handle> front = { cells[random_int(number)] };
      const std::size_t size = static_cast<std::size_t>(1 + random_int(number));
      for(std::size_t k = 0; k < front.size() && k < size; ++k)
      {
        front[k]->set_subdomain_index(r);
        for(int i = 0; i < 4; ++i)
          if(! tr.is_infinite(front[k]->neighbor(i)) && region(front[k]->neighbor(i)) != r)
            front.push_back(front[k]->neighbor(i));
      }
    }
    cells.front()->set_subdomain_index(1); // something is inside
  }

  // Facets between regions may have a patch, and others, too.
  void mark_random_sheets()
  {
    const int part = 10 + random_int(80);
    for(const Cell_handle c : tr.finite_cell_handles()) // the order of finite_facets() depends on addresses
      for(int i = 0; i < 4; ++i)
        if(random_int(is_wall(c, i) ? 4 : part) == 0)
        {
          const int patch = 1 + random_int(9);
          c->set_surface_patch_index(i, patch);
          c->neighbor(i)->set_surface_patch_index(tr.mirror_index(c, i), patch);
        }
  }
};

// What a mesh was, and has to be afterwards.
template <typename Kernel>
class Judge
{
  typedef Random_mesh<Kernel>           Mesh;
  typedef typename Mesh::Vertex_handle  Vertex_handle;
  typedef typename Mesh::Cell_handle    Cell_handle;

  const Mesh& m_mesh;
  const typename Mesh::Walls m_walls;
  const typename Mesh::Volumes m_volumes;
  std::set<Vertex_handle> m_vertices;
  std::set<std::set<Vertex_handle> > m_others; // cells that are not selected

public:
  explicit Judge(const Mesh& mesh)
    : m_mesh(mesh), m_walls(mesh.walls()), m_volumes(mesh.volumes_inside_walls()),
      m_vertices(mesh.tr.finite_vertex_handles().begin(), mesh.tr.finite_vertex_handles().end())
  {
    assert(mesh.volumes_of_cells() == m_volumes);
  }

  void remember_cells_that_are_not_selected()
  {
    for(const Cell_handle c : m_mesh.tr.finite_cell_handles())
      if(m_mesh.selected.count(c) == 0)
        m_others.insert(vertices_of(c));
  }

  void check(const std::size_t number_of_new_vertices, const bool are_edges_kept) const
  {
    assert(br3_test::is_valid_mesh(m_mesh.tr));
    assert(m_mesh.tr.number_of_vertices() == m_vertices.size() + number_of_new_vertices);
    assert(m_mesh.walls() == m_walls && m_mesh.volumes_of_cells() == m_volumes);
    for(auto c = m_mesh.tr.all_cells_begin(); c != m_mesh.tr.all_cells_end(); ++c)
      assert(c->tds_data().is_clear());
    for(const auto& e : m_mesh.edges)
      assert(! are_edges_kept || m_mesh.tr.tds().is_edge(e.first, e.second));
    std::size_t number_of_others = 0;
    for(const Cell_handle c : m_mesh.tr.finite_cell_handles())
      number_of_others += m_others.count(vertices_of(c));
    assert(number_of_others == m_others.size());
  }

  // A new vertex had no neighbor that is nearer than 0.7 times its size when it came, or 0.4 times where it divides a
  // long edge. Of two, the later one counts. Where a long edge is removed, vertices become neighbors that were hidden.
  // Sizes are those of the field, or grow from other vertices or shorter edges of walls.
  template <typename Size>
  void check_distances(const Size& size) const
  {
    const auto least = least_sizes();
    std::size_t number_of_edges = 0, number_of_short_edges = 0;
    for(const auto& e : m_mesh.tr.finite_edges())
    {
      double limit = std::numeric_limits<double>::infinity();
      for(const Vertex_handle v : { e.first->vertex(e.second), e.first->vertex(e.third) })
        if(m_vertices.count(v) == 0)
        {
          const double size_at_v = CGAL::to_double(v->meshing_info());
          assert(v->in_dimension() == 3);
          assert(size_at_v == size(v->point())
                 || (size_at_v < size(v->point()) && size_at_v > 0.999999 * least_size_at(v, least)));
          limit = (std::min)(limit, 0.4 * size_at_v);
        }
      if(limit < std::numeric_limits<double>::infinity())
      {
        ++number_of_edges;
        const double length = std::sqrt(CGAL::to_double(m_mesh.tr.segment(e).squared_length()));
        number_of_short_edges += length < (1 - 1e-12) * limit;
      }
    }
    assert(50 * number_of_short_edges <= number_of_edges + 100);
  }

private:
  // At each vertex the size that is known, or the shortest edge of a wall.
  std::map<Vertex_handle, double> least_sizes() const
  {
    std::map<Vertex_handle, double> result;
    for(const Vertex_handle v : m_mesh.tr.finite_vertex_handles())
    {
      const double size = CGAL::to_double(v->meshing_info());
      result[v] = size > 0 ? size : std::numeric_limits<double>::infinity();
    }
    for(const auto& wall : m_walls)
      for(const Vertex_handle u : wall.first)
        for(const Vertex_handle v : wall.first)
          if(u != v)
            result[u] = (std::min)(result[u], length(u, v));
    return result;
  }

  static double least_size_at(const Vertex_handle v, const std::map<Vertex_handle, double>& sizes)
  {
    double least = std::numeric_limits<double>::infinity();
    for(const auto& [u, size] : sizes)
      if(u != v)
        least = (std::min)(least, size + 0.9 * length(u, v));
    return least;
  }

  static double length(const Vertex_handle u, const Vertex_handle v)
  {
    return std::sqrt(CGAL::to_double(CGAL::squared_distance(u->point(), v->point())));
  }

  static std::set<Vertex_handle> vertices_of(const Cell_handle c)
  {
    return { c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) };
  }
};

struct Counts
{
  int filled = 0, too_large = 0, unchanged = 0, starred = 0, refused = 0;
};

template <typename Result>
void count_and_check(const Result& result, const std::size_t number_of_vertices, const std::size_t max_number,
                     Counts& counts)
{
  assert(result.invalid_sizes.empty());
  assert(result.status == BR3::Meshing_status::meshed || result.status == BR3::Meshing_status::too_large);
  if(result.status == BR3::Meshing_status::too_large)
    assert(result.number_of_field_points == 0 || number_of_vertices == max_number);
  counts.too_large += result.status == BR3::Meshing_status::too_large;
  ++(result.number_of_field_points > 0 ? counts.filled : counts.unchanged);
}

// From a thousandth to a thousand times the extent, but mostly such that some points are needed.
template <typename Kernel>
double random_size(Random_mesh<Kernel>& mesh)
{
  const double power = mesh.random_int(3) == 0 ? mesh.random_number(-3, 3) : mesh.random_number(-0.8, -0.2);
  return mesh.extent * std::pow(10, power);
}

template <typename Kernel>
void fill_with_one_size(Random_mesh<Kernel>& mesh, Counts& counts)
{
  Judge<Kernel> judge(mesh);
  const double size = random_size(mesh);
  const std::size_t max_number = mesh.tr.number_of_vertices() + max_number_of_new_vertices;
  const auto result = CGAL::insert_field_points(mesh.tr, size, parameters::maximum_number_of_vertices(max_number));
  count_and_check(result, mesh.tr.number_of_vertices(), max_number, counts);
  judge.check(result.number_of_field_points, false);
  judge.check_distances([&](const auto&) { return size; });
}

template <typename Kernel>
BR3::Source_sizing_field_3<Kernel> random_sources(Random_mesh<Kernel>& mesh)
{
  typedef BR3::Size_source_3<Kernel> Source;
  std::vector<Source> sources;
  const double background = random_size(mesh);
  for(int k = 1 + mesh.random_int(3); k > 0; --k)
  {
    const double size = background * std::pow(10, mesh.random_number(-3, 0));
    const double radius = mesh.random_int(2) == 0 ? 0 : mesh.random_number(0, 2) * size;
    const BR3::Size_growth growth =
      mesh.random_int(3) > 0 ? BR3::Size_growth::linear(mesh.random_number(0.4, 2))
                             : BR3::Size_growth::doubling_at(radius + size * mesh.random_number(0.5, 3));
    const auto p = mesh.random_place(), q = mesh.random_place(), r = mesh.random_place();
    switch(mesh.random_int(6))
    {
      case 0:  sources.push_back(Source::segment(p, q, size, radius, growth)); break;
      case 1:  sources.push_back(Source::triangle(p, q, r, size, radius, growth)); break;
      case 2:  sources.push_back(Source::box(p, q, size, radius, growth)); break;
      default: sources.push_back(Source::point(p, size, radius, growth));
    }
  }
  return BR3::Source_sizing_field_3<Kernel>(sources, background);
}

// Only cells that are selected, and edges stay.
template <typename Kernel>
void fill_around_sources(Random_mesh<Kernel>& mesh, Counts& counts)
{
  Judge<Kernel> judge(mesh);
  judge.remember_cells_that_are_not_selected();
  const auto sources = random_sources(mesh);
  assert(sources.is_valid());
  const std::size_t max_number = mesh.tr.number_of_vertices() + max_number_of_new_vertices;
  const auto result = CGAL::insert_field_points(
    mesh.tr, sources, parameters::cell_is_selected_map(CGAL::make_boolean_property_map(mesh.selected))
                                 .edge_is_constrained_map(CGAL::make_boolean_property_map(mesh.edges)),
    parameters::maximum_number_of_vertices(max_number));
  count_and_check(result, mesh.tr.number_of_vertices(), max_number, counts);
  judge.check(result.number_of_field_points, true);
  judge.check_distances(sources);
}

// Points on constraints, at vertices, outside: whatever the kernel makes of them, nothing breaks.
template <typename Kernel>
void insert_anywhere(Random_mesh<Kernel>& mesh, Counts& counts)
{
  typedef Random_mesh<Kernel> Mesh;
  typedef typename Mesh::Tr   Tr;
  for(auto e = mesh.edges.begin(); e != mesh.edges.end(); ) // some were not kept
    e = mesh.tr.tds().is_edge(e->first, e->second) ? std::next(e) : mesh.edges.erase(e);
  Judge<Kernel> judge(mesh);
  internal::Mesh_visitor_3<Tr> visitor;
  internal::Selected_domain_3<Tr> domain(mesh.tr);
  domain.constrain_edges(CGAL::make_boolean_property_map(mesh.edges));
  internal::Field_point_cavity_3<Tr> cavity(mesh.tr, domain);
  internal::Insert_field_point_3<Tr> insert(mesh.tr, domain, visitor);
  std::size_t number = 0;
  for(int k = 0; k < 20; ++k)
  {
    const auto c = mesh.random_cell();
    const auto p = mesh.random_place(c);
    const bool is_found = cavity.find(p, c);
    if(is_found)
      insert(cavity, p);
    else
      cavity.clear(true);
    number += is_found;
    ++(is_found ? counts.starred : counts.refused);
  }
  judge.check(number, true);
}

// The points, and the cells by the positions of their vertices, in the order of the triangulation.
template <typename Kernel>
std::vector<double> portrait(const Random_mesh<Kernel>& mesh)
{
  std::vector<double> result;
  std::map<typename Random_mesh<Kernel>::Vertex_handle, std::size_t> numbers;
  for(const auto v : mesh.tr.finite_vertex_handles())
  {
    numbers.emplace(v, numbers.size());
    const auto x = internal::coordinates_of(v->point());
    result.insert(result.end(), x.begin(), x.end());
  }
  for(const auto c : mesh.tr.finite_cell_handles())
    for(int i = 0; i < 4; ++i)
      result.push_back(static_cast<double>(numbers.at(c->vertex(i))));
  return result;
}

template <typename Kernel>
std::vector<double> make_and_judge(const unsigned seed, Counts& counts)
{
  Random_mesh<Kernel> mesh(seed);
  if(seed % 2 == 0)
  {
    insert_anywhere(mesh, counts); // before most of the mesh is Delaunay
    fill_with_one_size(mesh, counts);
  }
  else
    fill_around_sources(mesh, counts);
  insert_anywhere(mesh, counts);
  return portrait(mesh);
}

template <typename Kernel>
void test(const unsigned seed, Counts& counts)
{
  const std::vector<double> first = make_and_judge<Kernel>(seed, counts);
  const std::vector<double> second = make_and_judge<Kernel>(seed, counts);
  assert(first == second);
}

int main(int argc, char** argv)
{
  const unsigned long n = argc > 1 ? std::stoul(argv[1]) : 30, seed = argc > 2 ? std::stoul(argv[2]) : 1;
  const double limit = argc > 3 ? std::stod(argv[3]) : 1e9;
  const auto start = std::chrono::steady_clock::now();
  Counts counts;
  unsigned long i = 0;
  for(; i < n; ++i)
  {
    if(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > limit)
      break;
    std::cout << (i == 0 ? "seeds: " : " ") << seed + i << std::flush;
#ifndef BR3_TEST_EPICK_ONLY
    if((seed + i) % 16 == 0)
      test<Exact>(static_cast<unsigned>(seed + i), counts);
    else
#endif
      test<K>(static_cast<unsigned>(seed + i), counts);
  }
  std::cout << "\n" << counts.filled << " meshes filled, " << counts.unchanged << " unchanged, " << counts.too_large
            << " too large; " << counts.starred << " points anywhere inserted, " << counts.refused << " refused\n";
  return i >= 20 && (counts.filled == 0 || counts.starred == 0 || counts.refused == 0) ? 1 : 0;
}
