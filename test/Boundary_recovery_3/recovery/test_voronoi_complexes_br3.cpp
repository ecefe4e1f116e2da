// Voronoi diagrams in a cube: their polygons, with vertices rounded to doubles and cut into fans, are a surface that is
// no manifold anywhere. All triangles of each are recovered, and it divides the cube into as many regions as there are
// sites. Since hardly any of their edges needs a point, also a surface with points on edges at which three triangles
// meet.
#undef NDEBUG

#include "exact_mesh_checker_br3.h"
#include "recovered_mesh_br3.h"
#include "recovery_of_oracles_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Boundary_recovery_3/label_regions.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/recover_boundary.h>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <unordered_map>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef CGAL::Delaunay_triangulation_3<Exact>               Delaunay;
typedef CGAL::Boundary_recovery_result_3<Triangulation>     Result;
typedef CGAL::Boundary_recovery_3::Recovery_mode            Mode;
typedef br3_test::Coordinates                               Coordinates;

// The diagram of sites in the unit cube. Each site is reflected in the sides, which makes them a part of the diagram;
// numbers of few bits have exact reflections. Vertices that coincide are merged by their exact coordinates.
class Voronoi_complex
{
public:
  Voronoi_complex(const std::size_t number_of_sites, const unsigned seed)
  {
    std::mt19937 random(seed);
    std::set<Coordinates> known;
    while(known.size() < number_of_sites)
    {
      Coordinates p;
      for(double& x : p)
        x = static_cast<double>(1 + random() % 4095) / 4096;
      if(known.insert(p).second)
        add_site(p);
    }
    for(const auto& e : m_delaunay.finite_edges())
      if(m_sites.count(e.first->vertex(e.second)) + m_sites.count(e.first->vertex(e.third)) > 0)
        add_polygon(e);
  }

  std::vector<Coordinates> sites, points;
  std::vector<br3_test::Indexed_mesh::Facet> triangles;

private:
  void add_site(const Coordinates& p)
  {
    sites.push_back(p);
    m_sites.insert(m_delaunay.insert(Exact::Point_3(p[0], p[1], p[2])));
    for(int k = 0; k < 3; ++k)
      for(const double side : { 0., 1. })
      {
        Coordinates q = p;
        q[k] = 2 * side - p[k];
        m_delaunay.insert(Exact::Point_3(q[0], q[1], q[2]));
      }
  }

  // The polygon between two sites is dual to their edge; it may be degenerate, where a site meets a foreign reflection.
  void add_polygon(const Delaunay::Edge& e)
  {
    std::vector<std::size_t> polygon;
    auto c = m_delaunay.incident_cells(e);
    const auto first = c;
    do {
      assert(! m_delaunay.is_infinite(c)); // sites are not on the hull
      const std::size_t v = vertex(c->circumcenter());
      if(polygon.empty() || polygon.back() != v)
        polygon.push_back(v);
    } while(++c != first);
    while(polygon.size() > 1 && polygon.front() == polygon.back())
      polygon.pop_back();
    for(std::size_t i = 2; i < polygon.size(); ++i)
      triangles.push_back({{ polygon[0], polygon[i - 1], polygon[i] }});
  }

  std::size_t vertex(const Exact::Point_3& p)
  {
    const auto inserted = m_vertices.emplace(p, points.size());
    if(inserted.second)
      points.push_back({{ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) }});
    return inserted.first->second;
  }

  Delaunay m_delaunay;
  std::set<Delaunay::Vertex_handle> m_sites;
  std::map<Exact::Point_3, std::size_t> m_vertices;
};

// The regions of cells, by their addresses.
struct Region_map
{
  typedef Triangulation::Cell_handle       key_type;
  typedef int                              value_type;
  typedef int                              reference;
  typedef boost::writable_property_map_tag category;

  friend void put(const Region_map& map, const key_type c, const int region) { (*map.regions)[&*c] = region; }

  std::unordered_map<const void*, int>* regions;
};

// Every site is in a region of its own: in all the cells that contain it, on their boundary or not.
void check_regions(const Voronoi_complex& complex, const Triangulation& tr, const Result& result)
{
  std::unordered_map<const void*, int> regions;
  const int n = CGAL::Boundary_recovery_3::label_regions(tr, result.surface_facets(), Region_map{ &regions });
  assert(n == static_cast<int>(complex.sites.size()));

  std::set<int> regions_of_sites;
  for(const Coordinates& s : complex.sites)
  {
    const Kernel::Point_3 p(s[0], s[1], s[2]);
    std::set<int> here;
    for(const auto c : tr.finite_cell_handles())
    {
      bool is_inside = true;
      for(int i = 0; i < 4 && is_inside; ++i)
      {
        std::array<Kernel::Point_3, 4> q;
        for(int j = 0; j < 4; ++j)
          q[j] = j == i ? p : c->vertex(j)->point();
        is_inside = CGAL::orientation(q[0], q[1], q[2], q[3]) != CGAL::NEGATIVE;
      }
      if(is_inside)
        here.insert(regions.at(&*c));
    }
    assert(here.size() == 1 && *here.begin() > 0);
    assert(regions_of_sites.insert(*here.begin()).second);
  }
}

// Strictly in both modes. `check` looks at what was recovered.
template <typename Check>
void test_surface(const std::vector<Coordinates>& coordinates,
                  const std::vector<br3_test::Indexed_mesh::Facet>& triangles, const Check& check)
{
  std::vector<Kernel::Point_3> points;
  for(const Coordinates& c : coordinates)
    points.emplace_back(c[0], c[1], c[2]);
  for(const Mode mode : { Mode::constrained, Mode::conforming })
  {
    Triangulation tr;
    const Result result = CGAL::recover_boundary(tr, points, triangles, CGAL::parameters::recovery_mode(mode));
    if(! result)
      std::cout << result << std::endl;
    assert(result);
    typedef br3_test::Recovered_mesh<Triangulation, Result> Mesh;
    const Mesh mesh(tr, result, coordinates, triangles);
    br3_test::Exact_mesh_checker(mesh.mesh(), Mesh::kind(mode, result))();
    check(mode, tr, result);
    std::cout << triangles.size() << " triangles, " << result.steiner_vertices.size() << " Steiner points" << std::endl;
  }
}

void test_complex(const std::size_t number_of_sites, const unsigned seed)
{
  const Voronoi_complex complex(number_of_sites, seed);
  test_surface(complex.points, complex.triangles, [&](Mode, const Triangulation& tr, const Result& result)
  {
    check_regions(complex, tr, result);
  });
}

// The reflex edges of a twisted prism need points; each of them has a fin outside.
void test_points_on_edges_of_three_triangles(const std::size_t n)
{
  br3_test::Plc plc = br3_test::twisted_prism(n, .3, 1000, 1000);
  std::vector<std::array<std::size_t, 2> > edges;
  for(std::size_t i = 0; i < n; ++i)
  {
    edges.push_back({{ i, n + (i + 1) % n }});
    const Coordinates p = plc.points[edges[i][0]], q = plc.points[edges[i][1]];
    plc.triangles.push_back({ edges[i][0], edges[i][1], plc.points.size() });
    plc.points.push_back({{ 2 * (p[0] + q[0]), 2 * (p[1] + q[1]), 500 }});
  }
  std::vector<br3_test::Indexed_mesh::Facet> triangles;
  for(const br3_test::Simplex& t : plc.triangles)
    triangles.push_back({{ t[0], t[1], t[2] }});
  test_surface(plc.points, triangles, [&](const Mode mode, const Triangulation&, const Result& result)
  {
    assert(! result.steiner_vertices.empty());
    if(mode != Mode::conforming)
      return;
    std::size_t number_on_edges = 0;
    for(const auto v : result.steiner_vertices)
      for(const auto& e : edges)
      {
        const Kernel::Segment_3 s(result.vertices[e[0]]->point(), result.vertices[e[1]]->point());
        number_on_edges += CGAL::squared_distance(s, v->point()) < 1e-12 ? 1 : 0; // rounded points
      }
    assert(number_on_edges > 0);
  });
}

int main()
{
  test_complex(1, 1);
  test_complex(2, 2);
  for(unsigned seed = 0; seed < 6; ++seed)
    test_complex(5 + 5 * seed, seed);
  test_complex(200, 7);
  for(const std::size_t n : { 3, 5, 8 })
    test_points_on_edges_of_three_triangles(n);
  return EXIT_SUCCESS;
}
