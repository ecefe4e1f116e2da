// The figures of a mesh, and the certificate, against a slow reference on random meshes, and on shapes made by hand;
// what improve_mesh_quality() says and does where nothing is to be changed.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "plain_angles_br3.h"
#include "random_numbers_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/Selected_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/mesh/cell_simplices.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Cell_angles_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Explain_bad_cells_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_domain_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Improve_quality_3.h>
#include <CGAL/Boundary_recovery_3/internal/quality/Measure_quality_3.h>
#include <CGAL/Boundary_recovery_3/mesh_quality.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/improve_mesh_quality.h>
#include <CGAL/mark_domain.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;
namespace parameters = CGAL::parameters;
using BR3::Bad_cell_reason;
using br3_test::Corners;
using br3_test::Vector;
typedef CGAL::Exact_predicates_inexact_constructions_kernel K;

bool is_near(const double a, const double b, const double tolerance = 1e-6) { return std::abs(a - b) <= tolerance; }

// A triangulation, some cells of which may be selected, and slow answers to all questions.
template <typename Kernel>
struct Scene
{
  typedef typename Kernel::Point_3                                               Point;
  typedef typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Tr;
  typedef typename Tr::Vertex_handle                                             Vertex_handle;
  typedef typename Tr::Cell_handle                                               Cell_handle;
  typedef typename Tr::Facet                                                     Facet;
  typedef std::map<Cell_handle, bool>                                            Selection;
  typedef boost::associative_property_map<Selection>                             Selection_map;
  typedef BR3::Quality_certificate_3<Tr>                                         Certificate;
  typedef BR3::Bad_cell_3<Tr>                                                    Bad_cell;

  static Vector place(const Vertex_handle v)
  {
    return {{ CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()), CGAL::to_double(v->point().z()) }};
  }

  static Corners corners(const Cell_handle c)
  {
    return {{ place(c->vertex(0)), place(c->vertex(1)), place(c->vertex(2)), place(c->vertex(3)) }};
  }

  bool contains(const Cell_handle c) const
  {
    return ! tr.is_infinite(c) && c->subdomain_index() != 0 && (selection.empty() || selection.at(c));
  }

  bool is_wall(const Cell_handle c, const int i) const
  {
    return c->is_facet_on_surface(i) || c->neighbor(i)->subdomain_index() != c->subdomain_index()
           || ! contains(c->neighbor(i));
  }

  static std::array<Vertex_handle, 3> vertices(const Facet& f)
  {
    std::array<Vertex_handle, 3> result = {{ f.first->vertex((f.second + 1) % 4), f.first->vertex((f.second + 2) % 4),
                                             f.first->vertex((f.second + 3) % 4) }};
    std::sort(result.begin(), result.end());
    return result;
  }

  // ------------------------------------------------ the reference

  void check_quality(const BR3::Mesh_quality_3& quality) const
  {
    std::size_t n = 0, bins = 0;
    double sum = 0, low = 180, high = 0, least_ratio = 1;
    for(const Cell_handle c : tr.finite_cell_handles())
      if(contains(c))
      {
        ++n;
        const Corners p = corners(c);
        const auto angles = br3_test::dihedral_angles(p);
        low = (std::min)(low, br3_test::smallest(angles));
        high = (std::max)(high, br3_test::largest(angles));
        sum += br3_test::radius_ratio(p);
        least_ratio = (std::min)(least_ratio, br3_test::radius_ratio(p));
      }
    assert(quality.number_of_cells == n);
    if(n == 0)
    {
      assert(std::isnan(quality.min_dihedral_angle) && std::isnan(quality.max_dihedral_angle));
      assert(std::isnan(quality.mean_radius_ratio) && std::isnan(quality.min_radius_ratio));
      return;
    }
    assert(is_near(quality.min_dihedral_angle, low) && is_near(quality.max_dihedral_angle, high));
    assert(is_near(quality.mean_radius_ratio, sum / double(n)) && is_near(quality.min_radius_ratio, least_ratio));
    for(const std::size_t m : quality.histogram)
      bins += m;
    assert(bins == n);
    check_counts(quality);
    check_edges(quality);
  }

  void check_counts(const BR3::Mesh_quality_3& quality) const
  {
    std::array<std::size_t, 18> histogram = {};
    std::array<std::size_t, 4> below = {};
    std::array<std::size_t, 3> above = {};
    for(const Cell_handle c : tr.finite_cell_handles())
      if(contains(c))
      {
        const auto angles = br3_test::dihedral_angles(corners(c));
        ++histogram[static_cast<std::size_t>(br3_test::smallest(angles) / 5)];
        for(std::size_t i = 0; i < 4; ++i)
          below[i] += br3_test::smallest(angles) < 5. * double(i + 1);
        for(std::size_t i = 0; i < 3; ++i)
          above[i] += br3_test::largest(angles) > 150 + 10. * double(i);
      }
    assert(quality.histogram == histogram);
    assert(quality.numbers_of_cells_below == below && quality.numbers_of_cells_above == above);
  }

  // All edges of cells, and whether they are in no wall.
  std::map<std::set<Vertex_handle>, bool> edges() const
  {
    std::map<std::set<Vertex_handle>, bool> is_inner;
    for(const Cell_handle c : tr.finite_cell_handles())
      if(contains(c))
      {
        for(int i = 0; i < 4; ++i)
          for(int j = 0; j < i; ++j)
            is_inner.emplace(std::set<Vertex_handle>{ c->vertex(i), c->vertex(j) }, true);
        for(int i = 0; i < 4; ++i)
          if(is_wall(c, i))
            for(int j = 1; j < 4; ++j)
              is_inner[{ c->vertex((i + j) % 4), c->vertex((i + (j == 3 ? 1 : j + 1)) % 4) }] = false;
      }
    return is_inner;
  }

  void check_edges(const BR3::Mesh_quality_3& quality) const
  {
    std::size_t number = 0, number_in_size = 0;
    for(const auto& edge : edges())
    {
      const Vertex_handle u = *edge.first.begin(), v = *edge.first.rbegin();
      const double size_u = CGAL::to_double(u->meshing_info()), size_v = CGAL::to_double(v->meshing_info());
      if(! edge.second || size_u == 0 || size_v == 0)
        continue;
      ++number;
      const double ratio = br3_test::distance(place(u), place(v)) / ((size_u + size_v) / 2);
      number_in_size += ratio >= std::sqrt(0.5) && ratio <= std::sqrt(2.);
    }
    assert(quality.number_of_sized_edges == number);
    assert(number > 0 ? is_near(quality.share_of_edges_in_size, double(number_in_size) / double(number))
                      : std::isnan(quality.share_of_edges_in_size));
  }

  // The angle between the walls around the edge ij of a cell, 360 if there are none, and the walls.
  double angle_between_walls(const Cell_handle c, const int i, const int j, std::array<Facet, 2>& walls) const
  {
    std::vector<Cell_handle> ring; // from the cell on, once around
    typename Tr::Cell_circulator circulator = tr.incident_cells(c, i, j, c), end = circulator;
    do
      ring.push_back(circulator);
    while(++circulator != end);
    const Vertex_handle u = c->vertex(i), v = c->vertex(j);
    const auto angle = [&](const Cell_handle d)
    {
      std::vector<Vector> others;
      for(int k = 0; k < 4; ++k)
        if(d->vertex(k) != u && d->vertex(k) != v)
          others.push_back(place(d->vertex(k)));
      return br3_test::angle_between(place(u), place(v), others[0], others[1]);
    };
    const std::size_t n = ring.size();
    double sum = angle(c);
    for(const std::size_t step : { std::size_t(1), n - 1 }) // in both directions
    {
      std::size_t at = 0;
      while(! is_wall(ring[at], ring[at]->index(ring[(at + step) % n])))
      {
        at = (at + step) % n;
        if(at == 0)
          return 360;
        sum += angle(ring[at]);
      }
      walls[step == 1] = Facet(ring[at], ring[at]->index(ring[(at + step) % n]));
    }
    return sum;
  }

  void check_bad_cell(const Bad_cell& bad, const double target) const
  {
    const Cell_handle c = bad.cell;
    const auto angles = br3_test::dihedral_angles(corners(c));
    assert(contains(c) && is_near(bad.min_dihedral_angle, br3_test::smallest(angles)));
    assert(bad.min_dihedral_angle < target);
    double forced = 360, needle = 360;
    std::set<std::set<std::array<Vertex_handle, 3> > > walls_of_forced;
    for(int i = 0, k = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j, ++k)
      {
        if(is_near(angles[k], bad.min_dihedral_angle, 1e-12))
          assert(c->has_vertex(bad.edge[0]) && c->has_vertex(bad.edge[1]));
        if(! (angles[k] < target))
          continue;
        std::array<Facet, 2> walls;
        const double angle = angle_between_walls(c, i, j, walls);
        if(angle < target)
          walls_of_forced.insert({ vertices(walls[0]), vertices(walls[1]) });
        forced = (std::min)(forced, angle);
      }
    for(int i = 0; i < 4; ++i)
      if(is_wall(c, i))
        needle = (std::min)(needle, plane_angle(Facet(c, i)));
    const Gap gap = narrowest_gap(c, target);
    const bool is_as_thin = 0.5 * needle < bad.min_dihedral_angle;
    assert(bad.reason == (forced < target ? Bad_cell_reason::forced :
                          gap.height < gap.limit ? Bad_cell_reason::gap :
                          needle < target && is_as_thin ? Bad_cell_reason::needle : Bad_cell_reason::not_improved));
    if(bad.reason == Bad_cell_reason::gap)
      return check_gap(bad, gap);
    assert(std::isnan(bad.distance));
    if(bad.reason == Bad_cell_reason::not_improved && is_flat_on_walls(c, angles, target))
      return check_flat(bad, target);
    const int number_of_facets = bad.reason == Bad_cell_reason::forced ? 2 :
                                 bad.reason == Bad_cell_reason::needle ? 1 : check_needle_nearby(bad, target);
    assert(bad.number_of_facets() == number_of_facets);
    for(int k = 0; k < 2; ++k)
      assert((bad.facets[k] != Facet()) == (number_of_facets > k));
    for(int k = 0; k < number_of_facets; ++k)
      assert(is_wall(bad.facets[k].first, bad.facets[k].second));
    if(bad.reason != Bad_cell_reason::not_improved)
      assert(is_near(bad.surface_angle, number_of_facets == 2 ? forced : needle));
    if(number_of_facets == 2)
      assert(walls_of_forced.count({ vertices(bad.facets[0]), vertices(bad.facets[1]) }) == 1);
    if(bad.reason == Bad_cell_reason::needle)
      assert(bad.facets[0].first == c);
  }

  // How far above the center of the inscribed circle of a facet the next wall is, and how far it has to be.
  struct Gap
  {
    Facet wall, ceiling;
    double height = std::numeric_limits<double>::infinity();
    double limit = 0;
    double radius = 0;
  };

  // Where the line from p in a direction meets the triangle: how far away, infinity if it does not.
  static double distance_along(const Vector& p, const Vector& direction, const std::array<Vector, 3>& t)
  {
    std::array<double, 3> parts;
    for(int i = 0; i < 3; ++i)
      parts[i] = br3_test::scalar(direction, br3_test::cross(br3_test::minus(t[(i + 1) % 3], p),
                                                             br3_test::minus(t[(i + 2) % 3], p)));
    const double sum = parts[0] + parts[1] + parts[2];
    if(sum == 0 || (std::min)({ parts[0] / sum, parts[1] / sum, parts[2] / sum }) < 0)
      return std::numeric_limits<double>::infinity();
    double distance = 0;
    for(int i = 0; i < 3; ++i)
      distance += parts[i] / sum * br3_test::scalar(direction, br3_test::minus(t[i], p));
    return distance;
  }

  static std::array<Vector, 3> triangle(const Facet& f)
  {
    const auto v = BR3::internal::facet_vertices(f.first, f.second);
    return {{ place(v[0]), place(v[1]), place(v[2]) }};
  }

  // All walls are looked at, once for each.
  Gap gap_above(const Facet& wall, const double target) const
  {
    const std::array<Vector, 3> t = triangle(wall);
    const Vector normal = br3_test::cross(br3_test::minus(t[1], t[0]), br3_test::minus(t[2], t[0]));
    const double a = br3_test::distance(t[1], t[2]), b = br3_test::distance(t[2], t[0]);
    const double c = br3_test::distance(t[0], t[1]);
    Vector center, direction;
    for(int k = 0; k < 3; ++k)
    {
      center[k] = (a * t[0][k] + b * t[1][k] + c * t[2][k]) / (a + b + c);
      direction[k] = normal[k] / br3_test::length(normal);
    }
    if(gaps.count(wall) == 0)
    {
      Gap gap;
      gap.wall = wall;
      for(const auto& other : all_walls())
      {
        const double height = distance_along(center, direction, other.second);
        if(height > 0 && height < gap.height && vertices(other.first) != vertices(wall))
        {
          gap.height = height;
          gap.ceiling = other.first;
        }
      }
      gaps.emplace(wall, gap);
    }
    Gap gap = gaps.at(wall);
    gap.radius = br3_test::length(normal) / (a + b + c);
    gap.limit = gap.radius * std::tan((std::min)(target, 60.) * std::acos(-1.) / 180);
    if(gap.ceiling == Facet() || number_of_common_vertices(wall, gap.ceiling) >= 2)
      gap.height = std::numeric_limits<double>::infinity();
    return gap;
  }

  const std::vector<std::pair<Facet, std::array<Vector, 3> > >& all_walls() const
  {
    if(walls.empty())
      for(const Cell_handle c : tr.finite_cell_handles())
        for(int i = 0; i < 4; ++i)
          if(contains(c) && is_wall(c, i))
            walls.emplace_back(Facet(c, i), triangle(Facet(c, i)));
    return walls;
  }

  static int number_of_common_vertices(const Facet& f, const Facet& g)
  {
    const auto v = vertices(f), w = vertices(g);
    return static_cast<int>(std::count_if(v.begin(), v.end(), [&](const Vertex_handle u)
    {
      return std::find(w.begin(), w.end(), u) != w.end();
    }));
  }

  // Above a wall of the cell, or else above the walls that are next to the cell around its edges, if it is low there.
  Gap narrowest_gap(const Cell_handle c, const double target) const
  {
    Gap narrowest;
    const auto look_at = [&](const Gap& gap)
    {
      if(gap.height < gap.limit && gap.height < narrowest.height)
        narrowest = gap;
    };
    for(int i = 0; i < 4; ++i)
      if(is_wall(c, i))
        look_at(gap_above(Facet(c, i), target));
    if(narrowest.height < narrowest.limit)
      return narrowest;
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        std::array<Facet, 2> walls;
        angle_between_walls(c, i, j, walls);
        for(const Facet& wall : walls)
          if(wall != Facet() && wall.first != c && is_low(c, gap_above(wall, target)))
            look_at(gap_above(wall, target));
      }
    return narrowest;
  }

  bool is_low(const Cell_handle c, const Gap& gap) const
  {
    const std::array<Vector, 3> t = triangle(gap.wall);
    const Vector normal = br3_test::cross(br3_test::minus(t[1], t[0]), br3_test::minus(t[2], t[0]));
    const Corners p = corners(c);
    return std::all_of(p.begin(), p.end(), [&](const Vector& q)
    {
      return std::abs(br3_test::scalar(normal, br3_test::minus(q, t[0]))) < gap.limit * br3_test::length(normal);
    });
  }

  void check_gap(const Bad_cell& bad, const Gap& gap) const
  {
    assert(bad.number_of_facets() == 2 && is_near(bad.distance, gap.height));
    assert(is_near(gap_above(bad.facets[0], 1).height, gap.height)); // maybe another one, in a tie
    assert(bad.surface_angle < 60.001 && bad.distance < gap.limit);
    if(bad.facets[0].first == bad.cell)
      assert(bad.min_dihedral_angle < bad.surface_angle + 1e-6); // that is what is proved
    assert(number_of_common_vertices(bad.facets[0], bad.facets[1]) < 2);
    if(bad.facets[0] == gap.wall)
      assert(vertices(bad.facets[1]) == vertices(gap.ceiling)
             && is_near(bad.surface_angle, std::atan2(gap.height, gap.radius) * 180 / std::acos(-1.)));
  }

  // Whether two walls of the cell are nearly in a plane; the angles are at the edges 01, 02, 03, 12, 13, 23.
  bool is_flat_on_walls(const Cell_handle c, const std::array<double, 6>& angles, const double target) const
  {
    bool is_flat = false;
    for(int i = 0, k = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j, ++k) // the facets at this edge are opposite to the other two vertices
        is_flat = is_flat || (angles[5 - k] > 180 - target && is_wall(c, i) && is_wall(c, j));
    return is_flat;
  }

  void check_flat(const Bad_cell& bad, const double target) const
  {
    assert(bad.number_of_facets() == 2 && bad.surface_angle > 180 - target);
    for(const Facet& f : bad.facets)
      assert(f.first == bad.cell && is_wall(bad.cell, f.second));
    assert(vertices(bad.facets[0]) != vertices(bad.facets[1]));
  }

  // That the sharpest one of all needles is named that have an edge of the cell, or else a vertex. Returns 1, or 0 if
  // there is none.
  int check_needle_nearby(const Bad_cell& bad, const double target) const
  {
    std::array<double, 3> sharpest = {{ 360, 360, 360 }}; // with one and two vertices in common
    for(const Cell_handle c : tr.finite_cell_handles())
      for(int i = 0; i < 4; ++i)
        if(contains(c) && is_wall(c, i))
        {
          const int n = (std::min)(2, number_of_common_vertices(bad.cell, Facet(c, i)));
          sharpest[n] = (std::min)(sharpest[n], plane_angle(Facet(c, i)));
        }
    const int n = sharpest[2] < target ? 2 : sharpest[1] < target ? 1 : 0;
    assert(n == 0 ? std::isnan(bad.surface_angle) : is_near(bad.surface_angle, sharpest[n]));
    if(n > 0)
      assert((std::min)(2, number_of_common_vertices(bad.cell, bad.facets[0])) == n
             && is_near(plane_angle(bad.facets[0]), bad.surface_angle) && contains(bad.facets[0].first));
    return n > 0 ? 1 : 0;
  }

  static int number_of_common_vertices(const Cell_handle c, const Facet& f)
  {
    int n = 0;
    for(int i = 1; i < 4; ++i)
      n += c->has_vertex(f.first->vertex((f.second + i) % 4));
    return n;
  }

  static double plane_angle(const Facet& f)
  {
    std::array<Vector, 3> corners;
    for(int i = 0; i < 3; ++i)
      corners[i] = place(f.first->vertex((f.second + i + 1) % 4));
    return br3_test::smallest_plane_angle(corners);
  }

  void check_certificate(const Certificate& certificate, const double target) const
  {
    assert(certificate.min_dihedral_angle == target);
    std::size_t number_of_bad_cells = 0;
    for(const Cell_handle c : tr.finite_cell_handles())
      number_of_bad_cells += contains(c) && br3_test::smallest(br3_test::dihedral_angles(corners(c))) < target;
    assert(certificate.cells.size() == number_of_bad_cells);
    std::set<Cell_handle> cells;
    double last = 0;
    for(const Bad_cell& bad : certificate.cells)
    {
      assert(bad.min_dihedral_angle >= last && cells.insert(bad.cell).second);
      last = bad.min_dihedral_angle;
      check_bad_cell(bad, target);
    }
  }

  template <typename NamedParameters>
  void check_certificates(const NamedParameters& np) const
  {
    for(const double target : { 5., 20., 40. })
    {
      const Certificate certificate = BR3::quality_certificate(tr, target, np);
      check_certificate(certificate, target);
      check_forced_cells(certificate, internal::selected_domain(tr, np));
    }
  }

  // The improvement gives up those that the certificate calls so.
  void check_forced_cells(const Certificate& certificate, const internal::Selected_domain_3<Tr>& domain) const
  {
    const internal::Walls_at_edge_3<Tr> walls_at_edge(domain);
    for(const Bad_cell& bad : certificate.cells)
      assert(internal::is_forced(walls_at_edge, bad.cell, certificate.min_dihedral_angle)
             == (bad.reason == BR3::Bad_cell_reason::forced));
  }

  // ------------------------------------------------ all answers

  void check()
  {
    const Selection_map is_selected(selection);
    if(selection.empty())
      check_certificates(parameters::default_values());
    else
      check_certificates(parameters::cell_is_selected_map(is_selected));
    check_quality(selection.empty() ? BR3::mesh_quality(tr)
                                    : BR3::mesh_quality(tr, parameters::cell_is_selected_map(is_selected)));
  }

  Tr tr;
  Selection selection; // empty: all cells
  mutable std::map<Facet, Gap> gaps; // that were asked for
  mutable std::vector<std::pair<Facet, std::array<Vector, 3> > > walls; // once they were
};

// Points of a lattice in random places, so that cells are of all kinds, in two regions and outside of them.
template <typename Kernel>
Scene<Kernel> random_scene(std::mt19937& rng, const int number_of_points, const bool is_all_selected)
{
  typedef Scene<Kernel> S;
  S scene;
  const auto coordinate = [&] { return br3_test::random_int(rng, 1001) / 1000.; };
  for(int i = 0; i < number_of_points; ++i)
  {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const auto v = scene.tr.insert(typename S::Point(x, y, z * (i % 2 == 0 ? 1 : 0.1)));
    v->set_meshing_info(i % 5 == 0 ? 0 : 0.2 + 0.1 * (i % 3));
    v->set_dimension(3);
  }
  for(const auto c : scene.tr.finite_cell_handles())
    c->set_subdomain_index(br3_test::random_int(rng, 8) == 0 ? 0 : br3_test::random_int(rng, 8) == 0 ? 2 : 1);
  for(const auto& f : scene.tr.finite_facets())
    if(br3_test::random_int(rng, 6) == 0)
      for(const auto& side : { f, scene.tr.mirror_facet(f) })
        side.first->set_surface_patch_index(side.second, 1);
  if(! is_all_selected)
    for(const auto c : scene.tr.all_cell_handles())
      scene.selection[c] = br3_test::random_int(rng, 4) > 0;
  for(const auto c : scene.tr.finite_cell_handles())
    for(int i = 0; i < 4; ++i)
      if(scene.contains(c) && is_all_selected && scene.is_wall(c, i))
        for(int j = 1; j < 4; ++j)
          c->vertex((i + j) % 4)->set_dimension(2);
  return scene;
}

template <typename Kernel>
void test_random_meshes(const int number)
{
  std::mt19937 rng(5);
  for(int k = 0; k < number; ++k)
  {
    Scene<Kernel> scene = random_scene<Kernel>(rng, 5 + k * 3, k % 3 > 0);
    scene.check();
  }
  Scene<Kernel> empty;
  empty.check();
  empty.tr.insert(typename Scene<Kernel>::Point(0, 0, 0));
  empty.check();
}

// The mesh between some points, all of whose hull is constrained.
Scene<K> hull_scene(const std::vector<Vector>& points)
{
  Scene<K> scene;
  for(const Vector& p : points)
    scene.tr.insert(K::Point_3(p[0], p[1], p[2]));
  std::vector<std::array<Scene<K>::Vertex_handle, 3> > hull;
  for(const auto& f : scene.tr.finite_facets())
    if(scene.tr.is_infinite(f.first) || scene.tr.is_infinite(scene.tr.mirror_facet(f).first))
    {
      const auto cell = scene.tr.is_infinite(f.first) ? f.first : scene.tr.mirror_facet(f).first;
      const int i = scene.tr.is_infinite(f.first) ? f.second : scene.tr.mirror_facet(f).second;
      hull.push_back(BR3::internal::facet_vertices(cell, i));
    }
  const int number_of_regions = CGAL::mark_domain(scene.tr, hull);
  assert(number_of_regions == 1);
  scene.check();
  return scene;
}

// Two facets at 8 degrees, with one cell between them, or two.
void test_wedge()
{
  const double degree = std::acos(-1.) / 180;
  for(const bool is_divided : { false, true })
  {
    std::vector<Vector> points = { {{ 0, 0, 0 }}, {{ 1, 0, 0 }}, {{ 0.5, 1, 0 }},
                                   {{ 0.5, std::cos(8 * degree), std::sin(8 * degree) }} };
    if(is_divided)
      points.push_back({{ 0.5, std::cos(5 * degree), std::sin(5 * degree) }});
    const Scene<K> scene = hull_scene(points);
    const std::size_t number_of_cells = is_divided ? 2 : 1;
    assert(scene.tr.number_of_finite_cells() == number_of_cells);
    const auto forced = BR3::quality_certificate(scene.tr, 9);
    assert(forced.number_of_cells(Bad_cell_reason::forced) == number_of_cells);
    for(const auto& bad : forced.cells)
      assert(is_near(bad.surface_angle, 8));
    assert(is_near(forced.cells[0].min_dihedral_angle, is_divided ? 3 : 8));
    // it would be possible to have no cell below 7 degrees, and it is not done
    const auto divided = BR3::quality_certificate(scene.tr, 7);
    assert(divided.cells.size() == (is_divided ? 2 : 0));
    assert(divided.number_of_cells(Bad_cell_reason::forced) == 0);
  }
}

// A triangle of the surface with an angle of 2.9 degrees, and a point above it.
void test_needle()
{
  const Scene<K> scene = hull_scene({ {{ 0, 0, 0 }}, {{ 10, 0, 0 }}, {{ 10, 0.5, 0 }}, {{ 6, 0.1, 2 }},
                                      {{ -5, -20, 8 }}, {{ 25, -20, 8 }}, {{ 5, 25, 8 }}, {{ 5, 0, 20 }} });
  int number = 0;
  for(const auto& bad : BR3::quality_certificate(scene.tr, 12).cells)
  {
    if(bad.reason != Bad_cell_reason::needle)
      continue;
    const auto facet = Scene<K>::vertices(bad.facets[0]);
    if(! std::all_of(facet.begin(), facet.end(), [](const auto v) { return v->point().z() == 0; }))
      continue; // another needle, at the side
    assert(is_near(bad.surface_angle, std::atan(0.05) * 180 / std::acos(-1.)));
    ++number;
  }
  assert(number == 1);
}

// Two plates that are 0.02 apart: all cells are in the gap between them, whichever of their vertices is on which plate.
void test_gap()
{
  std::vector<Vector> points;
  for(const double z : { 0., 0.02 })
    for(int i = 0; i < 9; ++i)
      points.push_back({{ i % 3 + (i == 4 ? 0.1 : 0), i / 3 + (i == 4 ? 0.2 : 0), z }});
  const Scene<K> scene = hull_scene(points);
  const auto certificate = BR3::quality_certificate(scene.tr, 5);
  assert(certificate.cells.size() >= 8);
  assert(certificate.number_of_cells(Bad_cell_reason::gap) == certificate.cells.size());
  bool has_cell_on_edges = false;
  for(const auto& bad : certificate.cells)
  {
    assert(is_near(bad.distance, 0.02) && bad.surface_angle < 5);
    has_cell_on_edges = has_cell_on_edges || bad.facets[0].first != bad.cell;
  }
  assert(has_cell_on_edges);
  std::ostringstream os;
  os << certificate;
  assert(os.str().find(" gap") != std::string::npos);
  // there is room enough for one degree
  assert(BR3::quality_certificate(scene.tr, 1).number_of_cells(Bad_cell_reason::gap) == 0);
}

// A cell on two triangles that are nearly in a plane: they are named, though their plane angles are below the target.
void test_flat_walls()
{
  const double h = 1e-9;
  const Scene<K> scene = hull_scene({ {{ -1, 0, -h }}, {{ 1, 0, -h }}, {{ 0, 1, 0 }}, {{ 0, -1, 0 }},
                                      {{ 0.1, 0.2, 2 }} });
  const auto certificate = BR3::quality_certificate(scene.tr, 50);
  assert(! certificate.cells.empty());
  const auto& bad = certificate.cells[0];
  assert(bad.min_dihedral_angle < 1e-6 && bad.reason == Bad_cell_reason::not_improved);
  assert(bad.number_of_facets() == 2 && bad.surface_angle > 179.999);
  const auto v = Scene<K>::vertices(bad.facets[0]), w = Scene<K>::vertices(bad.facets[1]);
  for(const auto& facet : { v, w })
    for(const auto u : facet)
      assert(u->point().z() <= 0);
}

// A flat cell of four points inside.
void test_sliver()
{
  std::vector<Vector> points = { {{ 1, 0, 0.01 }}, {{ -1, 0, 0.01 }}, {{ 0, 1, -0.01 }}, {{ 0, -1, -0.01 }} };
  for(int i = 0; i < 8; ++i)
    points.push_back({{ i % 2 == 0 ? -5. : 5., i / 2 % 2 == 0 ? -5. : 5., i / 4 == 0 ? -5.1 : 5. }});
  const Scene<K> scene = hull_scene(points);
  const auto certificate = BR3::quality_certificate(scene.tr, 3);
  assert(certificate.cells.size() == 1 && certificate.cells[0].reason == Bad_cell_reason::not_improved);
  assert(certificate.number_of_cells(Bad_cell_reason::not_improved) == 1);
  assert(certificate.number_of_cells(Bad_cell_reason::not_improved, certificate.cells[0].min_dihedral_angle) == 0);
  std::ostringstream os;
  os << certificate;
  assert(os.str() == "1 cells below 3 degrees: 1 not_improved");
}

// A model of CellQuality_3 that has what the concept asks for, and nothing else: half of another quality.
struct Half_quality
{
  explicit Half_quality(int) { }
  Half_quality(const Half_quality&) = default;
  Half_quality& operator=(const Half_quality&) = delete;

  double operator()(const std::array<std::array<double, 3>, 4>& corners) const { return whole(corners) / 2; }
  double of_angle(const double degrees) const { return whole.of_angle(degrees) / 2; }

  BR3::Volume_length_quality_3 whole;
};

struct Phases
  : public CGAL::Default_meshing_visitor_3
{
  void on_phase_begin(const BR3::Phase phase)
  {
    assert(phase == BR3::Phase::quality_improvement);
    ++number_of_begins;
  }

  void on_phase_end(const BR3::Phase_report& report)
  {
    assert(report.phase == BR3::Phase::quality_improvement && report.number_of_cells > 0);
    ++number_of_ends;
  }

  int number_of_begins = 0, number_of_ends = 0;
};

// What comes back, whatever the improvement does.
void test_results()
{
  Scene<K> scene = hull_scene({ {{ 0, 0, 0 }}, {{ 1, 0, 0 }}, {{ 0, 1, 0 }}, {{ 0, 0, 1 }} });
  Scene<K>::Tr& tr = scene.tr;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Phases phases;
  for(const double impossible : { -1., 70.54, 180., std::numeric_limits<double>::infinity(), nan })
  {
    const auto result = CGAL::improve_mesh_quality(tr, parameters::min_dihedral_angle(impossible),
                                                   parameters::visitor(std::ref(phases)));
    assert(! result && result.status == BR3::Meshing_status::invalid_input && result.before.number_of_cells == 0);
  }
  assert(phases.number_of_begins == 0);
  const auto result = CGAL::improve_mesh_quality(tr, parameters::visitor(std::ref(phases)));
  assert(result && phases.number_of_begins == 1 && phases.number_of_ends == 1);
  assert(result.before.number_of_cells == 1 && result.after.number_of_cells == 1 && result.seconds >= 0);
  assert(is_near(result.after.min_dihedral_angle, std::acos(1 / std::sqrt(3.)) * 180 / std::acos(-1.)));
  assert(result.certificate.min_dihedral_angle == 25 && result.certificate.cells.empty());
  const auto high = CGAL::improve_mesh_quality(tr, parameters::min_dihedral_angle(60.),
                                               parameters::cell_quality(Half_quality(0)),
                                               parameters::maximum_running_time(1e6));
  assert(high && high.certificate.cells.size() == 1);
  assert(high.certificate.cells[0].reason == Bad_cell_reason::forced);
  assert(CGAL::improve_mesh_quality(tr, parameters::min_dihedral_angle(0.)).certificate.cells.empty());
  const auto late = CGAL::improve_mesh_quality(tr, parameters::maximum_running_time(0.));
  assert(late.status == BR3::Meshing_status::stopped && late.after.number_of_cells == 1);
  std::ostringstream os;
  os << high;
  assert(os.str().find("meshed\nbefore: 1 cells, dihedral angles from 54.7") == 0);
  assert(os.str().find("1 cells below 60 degrees: 1 forced") != std::string::npos);

  Scene<K>::Tr empty;
  const auto nothing = CGAL::improve_mesh_quality(empty);
  assert(nothing && nothing.before.number_of_cells == 0 && nothing.certificate.cells.empty());
}

// A mesh of four points, which are one cell.
template <typename Kernel>
BR3::Mesh_quality_3 quality_of_tetrahedron(const std::array<typename Kernel::Point_3, 4>& points)
{
  typename CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type tr;
  tr.insert(points.begin(), points.end());
  for(const auto c : tr.finite_cell_handles())
    c->set_subdomain_index(1);
  const BR3::Mesh_quality_3 quality = BR3::mesh_quality(tr);
  assert(quality.number_of_cells == 1);
  return quality;
}

// Angles that are just as large as the limit of a bin are in the upper one.
void test_limits_of_bins()
{
  typedef K::Point_3 Point;
  std::array<int, 3> axes = {{ 0, 1, 2 }};
  do
  {
    const auto point = [&](const double x, const double y, const double z)
    {
      std::array<double, 3> p;
      p[axes[0]] = x;
      p[axes[1]] = y;
      p[axes[2]] = z;
      return Point(7 + p[0], 8 + p[1], 9 + p[2]);
    };
    const auto of_45 = quality_of_tetrahedron<K>({{ point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(1, 1, 1) }});
    assert(of_45.histogram[9] == 1);
    const auto of_60 = quality_of_tetrahedron<K>({{ point(0, 0, 0), point(2, 0, 0), point(1, 1, 1), point(1, 1, -1) }});
    assert(of_60.histogram[12] == 1 && is_near(of_60.min_dihedral_angle, 60) && is_near(of_60.max_dihedral_angle, 90));
  }
  while(std::next_permutation(axes.begin(), axes.end()));
  for(const int degrees : { 5, 10, 15, 20, 30, 150, 160, 170 })
    for(const double turn : { -1e-9, 1e-9 })
    {
      const double angle = (degrees + turn) * CGAL_PI / 180;
      const auto q = quality_of_tetrahedron<K>({{ Point(0, 0, 0), Point(0, 0, 1), Point(1, 0, .5),
                                                  Point(std::cos(angle), std::sin(angle), .5) }});
      for(int i = 0; i < 4; ++i)
        assert(degrees > 30 || q.numbers_of_cells_below[i] == (degrees + turn < 5 * (i + 1)));
      for(int i = 0; i < 3; ++i)
        assert(q.numbers_of_cells_above[i] == (degrees + turn > 150 + 10 * i));
    }
}

// A cell whose volume is less than any number, beside rounding errors.
void test_cell_without_volume()
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point;
  const Kernel::FT tiny = Kernel::FT(std::ldexp(1., -200));
  const auto q = quality_of_tetrahedron<Kernel>({{ Point(0, 0, 1), Point(4, 0, 1), Point(0, 4, 1),
                                                   Point(1, 1, 1 + tiny) }});
  assert(q.min_dihedral_angle == 0 && q.max_dihedral_angle == 180 && q.histogram[0] == 1);
  assert(q.min_radius_ratio == 0 && q.mean_radius_ratio == 0);
  for(int i = 0; i < 4; ++i)
    assert(q.numbers_of_cells_below[i] == 1);
  for(int i = 0; i < 3; ++i)
    assert(q.numbers_of_cells_above[i] == 1);
}

// Edges are counted by a direction. Here, many edges and facets are parallel to it, or nearly.
template <typename Kernel>
void test_edges_along_direction()
{
  std::mt19937 rng(8);
  const std::array<double, 3> d = {{ 1, 1.4142135623730951, 1.7320508075688772 }};
  for(int round = 0; round < 20; ++round)
  {
    Scene<Kernel> scene;
    for(int i = 0; i < 12; ++i)
    {
      std::array<double, 3> p;
      for(double& x : p)
        x = i == 0 ? 0 : br3_test::random_int(rng, 1000) / 200.;
      for(const double factor : { 0., 1., 2., 4. })
        scene.tr.insert(typename Kernel::Point_3(p[0] + factor * d[0], p[1] + factor * d[1], p[2] + factor * d[2]));
    }
    for(const auto c : scene.tr.finite_cell_handles())
      c->set_subdomain_index(1);
    for(const auto v : scene.tr.finite_vertex_handles())
    {
      v->set_meshing_info(1 + br3_test::random_int(rng, 3));
      v->set_dimension(2 + round % 2);
    }
    for(const auto c : scene.tr.finite_cell_handles())
      for(int i = 0; i < 4; ++i)
        for(int j = 1; j < 4 && scene.is_wall(c, i); ++j)
          c->vertex((i + j) % 4)->set_dimension(2);
    scene.check_edges(BR3::mesh_quality(scene.tr));
  }
}

// Figures do not depend on the unit of length.
void test_extreme_scales()
{
  std::mt19937 rng(9);
  Scene<K> scene = random_scene<K>(rng, 60, true);
  const BR3::Mesh_quality_3 expected = BR3::mesh_quality(scene.tr);
  for(const int exponent : { -450, -150, 600, 450 }) // one after the other
  {
    for(const auto v : scene.tr.finite_vertex_handles())
    {
      const Vector p = Scene<K>::place(v);
      v->set_point(K::Point_3(std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent)));
      v->set_meshing_info(std::ldexp(v->meshing_info(), exponent));
    }
    const BR3::Mesh_quality_3 quality = BR3::mesh_quality(scene.tr);
    assert(quality.histogram == expected.histogram);
    assert(quality.numbers_of_cells_below == expected.numbers_of_cells_below);
    assert(quality.numbers_of_cells_above == expected.numbers_of_cells_above);
    assert(is_near(quality.min_dihedral_angle, expected.min_dihedral_angle, 1e-9));
    assert(is_near(quality.max_dihedral_angle, expected.max_dihedral_angle, 1e-9));
    assert(is_near(quality.mean_radius_ratio, expected.mean_radius_ratio, 1e-12));
    assert(quality.number_of_sized_edges == expected.number_of_sized_edges);
    assert(quality.share_of_edges_in_size == expected.share_of_edges_in_size);
  }
}

// A selection of all cells. It counts how often it is asked, which it is for each facet that might be a wall, unless
// the domain knows more of it: here, for all but those on the hull.
template <typename Cell_handle>
struct Counting_selection
{
  typedef Cell_handle                         key_type;
  typedef bool                                value_type;
  typedef bool                                reference;
  typedef boost::read_write_property_map_tag  category;

  friend bool get(const Counting_selection& selection, const key_type)
  {
    ++*selection.number_of_questions;
    return true;
  }

  friend void put(const Counting_selection&, const key_type, bool) { }

  std::size_t* number_of_questions;
};

// Around an edge of n bad cells, the questions of the figures and of the certificate do not grow with the square,
// whichever way the ring runs in memory.
void test_edge_of_many_cells(const bool is_turned)
{
  typedef Scene<K>::Tr Tr;
  constexpr int n = 2000;
  Tr tr;
  for(int i = 0; i < 8; ++i)
    tr.insert(K::Point_3(i & 1 ? 9 : -9, i & 2 ? 9 : -9, i & 4 ? 9 : -9));
  const auto low = tr.insert(K::Point_3(0, 0, -.5)), high = tr.insert(K::Point_3(0, 0, .5));
  for(int k = 0; k < n; ++k)
  {
    const double angle = 2 * CGAL_PI * (is_turned ? n - k : k) / n;
    tr.insert(K::Point_3(std::cos(angle), std::sin(angle), 0));
  }
  for(const auto v : tr.finite_vertex_handles())
  {
    v->set_dimension(2);
    v->set_meshing_info(1);
  }
  for(const auto c : tr.finite_cell_handles())
    c->set_subdomain_index(1);
  std::vector<Tr::Cell_handle> ring;
  for(const auto c : tr.finite_cell_handles())
    if(c->has_vertex(low) && c->has_vertex(high))
      ring.push_back(c);
  assert(ring.size() == n);

  std::size_t number_of_questions = 0;
  internal::Selected_domain_3<Tr> domain(tr);
  domain.select(Counting_selection<Tr::Cell_handle>{ &number_of_questions });
  internal::Explain_bad_cells_3<Tr> explain(tr, domain, 2);
  const auto quality = internal::Measure_quality_3<Tr>(tr, domain)(
    [](const Tr::Cell_handle, const internal::Cell_angles_3&) { }, [] { return true; });
  assert(quality->number_of_cells == tr.number_of_finite_cells());
  assert(number_of_questions < 10 * tr.number_of_finite_cells());
  number_of_questions = 0;
  for(const auto c : ring)
    explain.add(c, internal::Cell_angles_3(internal::corners(c)));
  assert(explain.certificate().cells.size() == n && number_of_questions < 1500 * n);
}

int main()
{
  test_random_meshes<K>(30);
#ifndef BR3_TEST_EPICK_ONLY
  test_random_meshes<CGAL::Exact_predicates_exact_constructions_kernel>(6);
  test_edges_along_direction<CGAL::Exact_predicates_exact_constructions_kernel>();
  test_cell_without_volume();
#endif
  test_edges_along_direction<K>();
  test_limits_of_bins();
  test_extreme_scales();
  test_wedge();
  test_needle();
  test_gap();
  test_flat_walls();
  test_sliver();
  test_results();
  for(const bool is_turned : { false, true })
    test_edge_of_many_cells(is_turned);
  std::cout << "certificates are right" << std::endl;
}
