// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// How a Steiner point comes off its constraint, step by step: its star, the fans in it, artificial ones, the sectors
// between them, their triangles and their points, each against its definition, in rational numbers.

#undef NDEBUG

#include "steiner_inputs_br3.h"
#include "steiner_scene_br3.h"

#include <CGAL/Boundary_recovery_3/internal/mesh/Mesh_editor_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Facet_fans_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Place_sector_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Recover_by_points_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Split_off_steiner_point_3.h>
#include <CGAL/Boundary_recovery_3/internal/steiner/Steiner_mesh_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace internal = CGAL::Boundary_recovery_3::internal;

typedef br3_test::Silent_scene_visitor             Visitor;
typedef br3_test::Steiner_scene<Visitor>           Scene;
typedef Scene::Tr                                  Tr;
typedef Scene::Vertex_handle                       Vertex_handle;
typedef Scene::Cell_handle                         Cell_handle;
typedef internal::Mesh_editor_3<Tr>                Editor;
typedef internal::Half_facet_star_3<Tr>            Star;
typedef internal::Half_facet_3<Tr>                 Half_facet;
typedef internal::Facet_fan_3<Tr>                  Fan;
typedef internal::Facet_fans_3<Tr>                 Fans;
typedef internal::Star_sectors_3<Tr>               Sectors;
typedef Scene::Ledger::Carrier                     Carrier;
typedef Scene::Ledger::Positions                   Positions;
typedef Positions::Exact_point_3                   Exact_point;
typedef Positions::Exact_kernel::Vector_3          Exact_vector;
typedef Positions::Exact_FT                        FT;
typedef std::vector<Vertex_handle>                 Vertices;
typedef std::set<Vertex_handle>                    Vertex_set;

// How often each kind of case was met; main() checks that all of them were.
std::map<std::string, int> number_of;

class Splitter
{
public:
  explicit Splitter(Scene& scene)
    : m_scene(scene), m_tr(scene.tr), m_editor(scene.tr, scene.any_visitor),
      m_mesh(m_editor, scene.predicates, scene.constraints, scene.ledger, scene.context), m_star(m_tr),
      m_fans(m_tr, scene.predicates), m_sectors(m_tr), m_triangulate_fan(m_tr, scene.predicates),
      m_insert_artificial_fan(m_mesh), m_sector_points(m_mesh)
  { }

  // Takes all the points off their constraints.
  void operator()()
  {
    const Vertices points = m_scene.ledger.points_on_constraints();
    for(const Vertex_handle s : points)
      split(s);
    assert(m_scene.ledger.points_on_constraints().empty() && m_scene.is_conforming());
  }

private:
  void split(const Vertex_handle s)
  {
    m_s = s;
    m_star.collect(s);
    check_star();
    const Carrier origin = m_scene.ledger.carrier(s);
    Vertices new_points;
    if(origin.dimension == 2)
      collect_closed_fan(origin.index);
    else
      collect_open_fans(origin.index, new_points);
    check_sectors();
    for(Fan& fan : m_fans)
      triangulate(fan);
    replace_star();
    const Vertices s_i = m_sector_points.vertices();
    m_scene.ledger.erase(s);
    for(const Vertices& points : { s_i, new_points })
      for(const Vertex_handle v : points)
        m_scene.ledger.insert_free(v, origin);
  }

  // --- geometry -----------------------------------------------------------------------------------------------------

  Exact_point point(const Vertex_handle v) const { return m_scene.ledger.positions()(v); }

  // From s.
  Exact_vector vector_to(const Vertex_handle v) const { return point(v) - point(m_s); }

  // Twice the area of the triangle s v w, times its unit normal.
  Exact_vector normal(const Vertex_handle v, const Vertex_handle w) const
  {
    return CGAL::cross_product(vector_to(v), vector_to(w));
  }

  static bool is_zero(const Exact_vector& v) { return v == CGAL::NULL_VECTOR; }

  FT volume(const std::array<Vertex_handle, 4>& t) const
  {
    return CGAL::volume(point(t[0]), point(t[1]), point(t[2]), point(t[3]));
  }

  // --- the star -----------------------------------------------------------------------------------------------------

  void check_star() const
  {
    std::set<Cell_handle> cells;
    std::set<std::pair<Vertex_handle, Vertex_handle> > sides;
    for(const Cell_handle c : m_tr.all_cell_handles())
      if(c->has_vertex(m_s))
        cells.insert(c);
    assert(m_star.center() == m_s && m_star.cells().size() == cells.size());
    assert(std::set<Cell_handle>(m_star.cells().begin(), m_star.cells().end()) == cells);
    assert(m_star.half_facets().size() == 3 * cells.size());
    for(const Half_facet& h : m_star.half_facets())
    {
      assert(cells.count(h.cell) == 1 && h.cell->has_vertex(h.opposite) && h.opposite != m_s);
      assert(h.cell->has_vertex(h.v) && h.cell->has_vertex(h.w) && h.v != m_s && h.w != m_s);
      assert(m_tr.is_infinite(h.cell) || volume({{ m_s, h.v, h.w, h.opposite }}) > 0);
      assert(sides.emplace(h.v, h.w).second);
    }
    for(const auto& side : sides)
      assert(sides.count({ side.second, side.first }) == 1);
  }

  // --- fans ---------------------------------------------------------------------------------------------------------

  void collect_closed_fan(const std::size_t f)
  {
    const auto& facet = m_scene.constraints.facets()[f];
    m_fans.clear();
    assert(m_fans.add_planar_fan(m_star, m_scene.ledger.vertices_on_facet(f), facet, true) && m_fans.size() == 1);
    const Fan& fan = *m_fans.begin();
    assert(fan.is_closed && fan.facets.back().w == fan.facets.front().v);
    check_fan(fan);
    for(const Half_facet& h : m_star.half_facets())
      if(! is_hull_edge(h))
      {
        const bool is_in_plane = is_on_plane(facet, h.v) && is_on_plane(facet, h.w);
        assert(fan.contains(h.v, h.w) == is_in_plane);
      }
    std::vector<Half_facet> facets(fan.facets.rbegin(), fan.facets.rend());
    assert(set_of(Fan::closed(facets)->polygon()) == set_of(fan.polygon()));
    facets.erase(facets.begin() + 1);
    assert(! Fan::closed(facets) && ! Fan::closed(std::vector<Half_facet>()));
    ++number_of["closed fan"];
  }

  void collect_open_fans(const std::size_t e, Vertices& new_points)
  {
    m_fans.clear(m_scene.ledger.neighbors_on_edge(m_s));
    assert(is_zero(normal(m_fans.ends()[0], m_fans.ends()[1])));
    std::vector<Exact_vector> half_planes;
    for(const std::size_t f : m_scene.constraints.facets_at_edge(e))
    {
      const auto& facet = m_scene.constraints.facets()[f];
      assert(m_fans.add_planar_fan(m_star, m_scene.ledger.vertices_on_facet(f), facet, false));
      add_half_plane(*std::find_if(facet.begin(), facet.end(), [&](const Vertex_handle v)
      {
        return ! is_zero(normal(m_fans.ends()[0], v));
      }), half_planes);
    }
    assert(m_fans.size() == half_planes.size());
    ++number_of["edge with " + std::to_string(half_planes.size()) + " facets"];
    add_hull_fans(half_planes);
    while(m_fans.size() < 2)
      insert_artificial_fan(half_planes, new_points);
    for(std::size_t i = 0; i < half_planes.size(); ++i)
      check_open_fan(*(m_fans.begin() + static_cast<std::ptrdiff_t>(i)), half_planes[i]);
  }

  // Half planes through the edge are given by their normals: those of other points in them have the same direction.
  bool is_in_half_plane(const Vertex_handle v, const Exact_vector& half_plane) const
  {
    const Exact_vector n = normal(m_fans.ends()[0], v);
    return ! is_zero(n) && is_zero(CGAL::cross_product(n, half_plane)) && n * half_plane > 0;
  }

  void add_half_plane(const Vertex_handle v, std::vector<Exact_vector>& half_planes) const
  {
    if(internal::contains(m_fans.ends(), v)
       || std::any_of(half_planes.begin(), half_planes.end(),
                      [&](const Exact_vector& n) { return is_in_half_plane(v, n); }))
      return;
    half_planes.push_back(normal(m_fans.ends()[0], v));
  }

  // Facets of the hull are in the half planes of facets that are there, or in new ones.
  void add_hull_fans(std::vector<Exact_vector>& half_planes)
  {
    const std::size_t before = half_planes.size();
    std::set<Vertex_handle> on_hull;
    for(const Half_facet& h : m_star.half_facets())
      if(m_tr.is_infinite(h.opposite))
        on_hull.insert({ h.v, h.w });
    std::vector<Exact_vector> all = half_planes;
    for(const Vertex_handle v : on_hull)
      add_half_plane(v, all);
    assert(m_fans.add_hull_fans(m_star) && m_fans.size() == all.size());
    for(auto fan = m_fans.begin() + static_cast<std::ptrdiff_t>(before); fan != m_fans.end(); ++fan)
      add_half_plane(internal::contains(m_fans.ends(), fan->facets[0].v) ? fan->facets[0].w : fan->facets[0].v,
                     half_planes);
    assert(half_planes.size() == all.size());
    for(const Half_facet& h : m_star.half_facets())
      assert(! m_tr.is_infinite(h.opposite) || m_fans.contains(h.v, h.w));
    if(! on_hull.empty())
      ++number_of["hull with " + std::to_string(m_fans.size() - before) + " new fans"];
  }

  // Neither the mesh nor what is in it gets lost.
  void insert_artificial_fan(std::vector<Exact_vector>& half_planes, Vertices& new_points)
  {
    const std::size_t before = new_points.size(), number_of_vertices = m_tr.number_of_vertices();
    const FT old_volume = volume_of_mesh();
    assert(m_insert_artificial_fan(m_star, m_fans, new_points));
    assert(m_tr.number_of_vertices() - number_of_vertices == new_points.size() - before);
    assert(m_scene.is_valid() && volume_of_mesh() == old_volume && m_scene.is_conforming());
    check_star();
    const Fan& fan = *(m_fans.end() - 1);
    assert(m_fans.size() == half_planes.size() + 1 && m_fans.has_vertex(fan.polygon()[1]));
    add_half_plane(fan.polygon()[1], half_planes);
    assert(half_planes.size() == m_fans.size());
    for(std::size_t i = before; i < new_points.size(); ++i)
      assert(is_in_half_plane(new_points[i], half_planes.back()) && fan.has_vertex(new_points[i]));
    ++number_of["artificial fan"];
    number_of["points in artificial fans"] += static_cast<int>(new_points.size() - before);
  }

  // It has the mesh facets in the half plane, in their order from one end to the other.
  void check_open_fan(const Fan& fan, const Exact_vector& half_plane) const
  {
    const Vertices polygon = fan.polygon();
    assert(! fan.is_closed && polygon.front() != polygon.back());
    assert(internal::contains(m_fans.ends(), polygon.front()) && internal::contains(m_fans.ends(), polygon.back()));
    check_fan(fan);
    const auto is_on = [&](const Vertex_handle v)
    {
      return internal::contains(m_fans.ends(), v) || is_in_half_plane(v, half_plane);
    };
    for(const Half_facet& h : m_star.half_facets())
      if(! is_hull_edge(h))
        assert(fan.contains(h.v, h.w) == (is_on(h.v) && is_on(h.w)));

    std::vector<Half_facet> facets(fan.facets.rbegin(), fan.facets.rend());
    assert(Fan::open(facets, m_fans.ends())->polygon() == polygon);
    assert(! Fan::open(facets, {{ m_s, m_s }}));
    facets.pop_back();
    assert(! Fan::open(facets, m_fans.ends()));
  }

  // What has the infinite vertex is in no plane.
  bool is_hull_edge(const Half_facet& h) const { return m_tr.is_infinite(h.v) || m_tr.is_infinite(h.w); }

  bool is_on_plane(const Fan::Vertex_triple& plane, const Vertex_handle v) const
  {
    return volume({{ plane[0], plane[1], plane[2], v }}) == 0;
  }

  // Its facets are there, turn around s alike, and follow each other, once around at most.
  void check_fan(const Fan& fan) const
  {
    const Exact_vector n = normal(fan.facets[0].v, fan.facets[0].w);
    const Vertices polygon = fan.polygon();
    assert(polygon.size() == fan.facets.size() + (fan.is_closed ? 0 : 1) && set_of(polygon).size() == polygon.size());
    int number_of_sectors_at_start = 0;
    for(std::size_t i = 0; i < fan.facets.size(); ++i)
    {
      const Half_facet& h = fan.facets[i];
      assert(internal::contains(m_star.cells(), h.cell) && h.cell->has_vertex(h.v) && h.cell->has_vertex(h.w));
      assert(h.cell->has_vertex(h.opposite) && is_half_facet_of_star(h));
      assert(i == 0 || fan.facets[i - 1].w == h.v);
      assert(is_zero(CGAL::cross_product(n, normal(h.v, h.w))) && n * normal(h.v, h.w) > 0);
      assert(fan.contains(h.v, h.w) && fan.contains(h.w, h.v) && fan.has_vertex(h.v) && fan.has_vertex(h.w));
      number_of_sectors_at_start += is_in_sector(polygon[0], h, n);
    }
    assert(number_of_sectors_at_start == 1 && ! fan.has_vertex(m_s));
  }

  bool is_half_facet_of_star(const Half_facet& h) const
  {
    return std::any_of(m_star.half_facets().begin(), m_star.half_facets().end(), [&](const Half_facet& g)
    {
      return g.v == h.v && g.w == h.w && g.cell == h.cell && g.opposite == h.opposite;
    });
  }

  // Whether the direction to x is between that to v, included, and that to w.
  bool is_in_sector(const Vertex_handle x, const Half_facet& h, const Exact_vector& n) const
  {
    const FT at_v = n * normal(h.v, x), at_w = n * normal(x, h.w);
    return at_w > 0 && (at_v > 0 || (at_v == 0 && vector_to(h.v) * vector_to(x) > 0));
  }

  FT volume_of_mesh() const
  {
    FT result = 0;
    for(const Cell_handle c : m_tr.finite_cell_handles())
      result += volume({{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }});
    return result;
  }

  static Vertex_set set_of(const Vertices& v) { return Vertex_set(v.begin(), v.end()); }

  // --- sectors ------------------------------------------------------------------------------------------------------

  // Cells are in the same sector iff facets at s that are in no fan connect them.
  void check_sectors()
  {
    m_sectors.label(m_star, m_fans);
    assert(m_sectors.size() == (m_fans.begin()->is_closed ? 2 : m_fans.size()));
    std::map<Cell_handle, std::size_t> component;
    for(std::size_t i = 0; i < m_star.cells().size(); ++i)
      component[m_star.cells()[i]] = i;
    for(bool is_changed = true; is_changed; )
    {
      is_changed = false;
      for(const Half_facet& h : m_star.half_facets())
      {
        const std::size_t other = component.at(h.cell->neighbor(h.cell->index(h.opposite)));
        if(! m_fans.contains(h.v, h.w) && other < component.at(h.cell))
        {
          component[h.cell] = other;
          is_changed = true;
        }
      }
    }
    std::map<std::size_t, std::size_t> sector_of_component;
    for(const Cell_handle c : m_star.cells())
    {
      const std::size_t i = m_sectors[c];
      assert(i < m_sectors.size() && sector_of_component.emplace(component.at(c), i).first->second == i);
      assert(m_sectors.is_infinite(i) == m_tr.is_infinite(c));
    }
    assert(sector_of_component.size() == m_sectors.size());
    for(const Fan& fan : m_fans)
      for(const Half_facet& h : fan.facets)
      {
        const auto sides = m_sectors.sides(fan);
        assert(sides[0] != sides[1] && sides[0] == m_sectors[h.cell]);
        assert(sides[1] == m_sectors[h.cell->neighbor(h.cell->index(h.opposite))]);
      }
    ++number_of[std::to_string(m_sectors.size()) + " sectors"];
  }

  // --- triangles of fans --------------------------------------------------------------------------------------------

  // All are seen from the same side as the facets, and together they are as large as these and have the same rim.
  void triangulate(Fan& fan)
  {
    assert(m_triangulate_fan(m_star, fan));
    const Vertices polygon = fan.polygon();
    assert(fan.triangles.size() == polygon.size() - 2);
    Exact_vector rest = CGAL::NULL_VECTOR;
    std::map<Vertex_set, int> edges;
    for(const Half_facet& h : fan.facets)
      rest = rest + normal(h.v, h.w);
    const Exact_vector n = rest;
    for(const auto& t : fan.triangles)
    {
      const Exact_vector area = CGAL::cross_product(point(t[1]) - point(t[0]), point(t[2]) - point(t[0]));
      assert(is_zero(CGAL::cross_product(n, area)) && n * area > 0);
      rest = rest - area;
      for(std::size_t k = 0; k < 3; ++k)
        ++edges[{ t[k], t[(k + 1) % 3] }];
    }
    assert(is_zero(rest));
    assert(edges.size() == 2 * polygon.size() - 3);
    for(std::size_t k = 0; k < polygon.size(); ++k)
      assert(edges.at({ polygon[k], polygon[(k + 1) % polygon.size()] }) == 1);
    assert(CGAL::to_double(n.x()) * fan.normal.x() + CGAL::to_double(n.y()) * fan.normal.y()
           + CGAL::to_double(n.z()) * fan.normal.z() > 0);
    number_of["fan of more than one triangle"] += fan.triangles.size() > 1;
  }

  // --- points of sectors --------------------------------------------------------------------------------------------

  // The new cells fill the star, so each point sees all of its sector. The triangles of fans are in the mesh then.
  void replace_star()
  {
    const std::size_t number_of_vertices = m_tr.number_of_vertices();
    const FT old_volume = volume_of_mesh();
    assert(m_sector_points(m_star, m_fans, m_sectors));
    std::size_t number_of_finite_sectors = 0;
    for(std::size_t i = 0; i < m_sectors.size(); ++i)
      number_of_finite_sectors += ! m_sectors.is_infinite(i);
    assert(m_sector_points.vertices().size() == number_of_finite_sectors);
    for(const auto& t : m_sector_points.tetrahedra())
    {
      const bool is_finite = std::none_of(t.begin(), t.end(), [&](const auto v) { return m_tr.is_infinite(v); });
      assert(! internal::contains(t, m_s) && (! is_finite || volume(t) > 0));
    }
    const Vertices dropped(1, m_s);
    m_editor.replace(m_star.cells(), m_sector_points.tetrahedra(), dropped);
    assert(m_tr.number_of_vertices() == number_of_vertices - 1 + number_of_finite_sectors);
    assert(m_scene.is_valid() && volume_of_mesh() == old_volume);
    for(const Fan& fan : m_fans)
      for(const auto& t : fan.triangles)
      {
        Cell_handle c;
        int i, j, k;
        assert(m_tr.is_facet(t[0], t[1], t[2], c, i, j, k));
      }
  }

  Scene& m_scene;
  const Tr& m_tr;
  Editor m_editor;
  internal::Steiner_mesh_3<Tr> m_mesh;
  Star m_star;
  Fans m_fans;
  Sectors m_sectors;
  internal::Triangulate_fan_3<Tr> m_triangulate_fan;
  internal::Insert_artificial_fan_3<Tr> m_insert_artificial_fan;
  internal::Place_sector_points_3<Tr> m_sector_points;
  Vertex_handle m_s;
};

void test(const br3_test::Plc& plc)
{
  Scene scene(plc);
  if(scene.tr.dimension() < 3)
    return;
  internal::Recover_by_points_3<Tr> recover(scene.state, scene.ledger);
  recover.look_up();
  recover.recover_conforming(0);
  assert(scene.state.is_nothing_lost() && scene.is_conforming());
  Splitter split(scene);
  split();
}

int main()
{
  for(std::size_t blades = 0; blades <= 4; ++blades)
    for(unsigned seed = 0; seed < 3; ++seed)
      test(br3_test::Random_constraints(seed).fan(blades, 14));
  for(unsigned diagonals = 0; diagonals < 64; diagonals += 9)
    test(br3_test::box(diagonals, diagonals % 2 == 0));
  for(unsigned seed = 0; seed < 4; ++seed)
    test(br3_test::flat_hull(seed, 12));
  for(unsigned seed = 0; seed < 8; ++seed)
    test(br3_test::Random_constraints(seed)(6 + static_cast<int>(seed) % 9, seed % 2 == 0 ? 4 : 40, 60, 40));
  test(br3_test::twisted_prism(5, .3, 1000, 1000));
  for(const auto& n : number_of)
    std::cout << n.second << " x " << n.first << std::endl;
  for(const char* kind : { "closed fan", "edge with 0 facets", "edge with 1 facets", "edge with 2 facets",
                           "edge with 3 facets", "edge with 4 facets", "hull with 0 new fans", "hull with 1 new fans",
                           "hull with 2 new fans", "artificial fan", "points in artificial fans", "2 sectors",
                           "3 sectors", "4 sectors", "fan of more than one triangle" })
    assert(number_of[kind] > 0);
  std::cout << "done" << std::endl;
}
