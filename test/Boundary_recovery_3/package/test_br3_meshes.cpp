// The surfaces of data/meshes are what tests and examples take them for: free of intersections, closed, and
// lost in part by Delaunay insertion where they are meant to exercise the recovery.
#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3                                     Point_3;
typedef CGAL::Delaunay_triangulation_3<Kernel>              Triangulation;
typedef std::vector<std::size_t>                            Facet;

struct Surface
{
  std::vector<Point_3> points;
  std::vector<Facet> facets;
};

Surface read(const std::string& name)
{
  Surface s;
  const bool ok = CGAL::IO::read_OFF(CGAL::data_file_path("meshes/" + name), s.points, s.facets);
  assert(ok);
  assert(std::all_of(s.facets.begin(), s.facets.end(), [](const Facet& f) { return f.size() == 3; }));
  return s;
}

Kernel::Triangle_3 triangle(const Surface& s, const Facet& f)
{
  return Kernel::Triangle_3(s.points[f[0]], s.points[f[1]], s.points[f[2]]);
}

// The facet's vertices, those that `other` has too first; second: how many these are.
std::pair<Facet, std::size_t> shared_first(Facet f, const Facet& other)
{
  const auto it = std::stable_partition(f.begin(), f.end(), [&](const std::size_t v)
    { return std::find(other.begin(), other.end(), v) != other.end(); });
  return std::make_pair(f, std::size_t(it - f.begin()));
}

bool opposite_edge_hits(const Surface& s, const Facet& f, const Facet& g)
{
  const Facet o = shared_first(f, g).first;
  return CGAL::do_intersect(Kernel::Segment_3(s.points[o[1]], s.points[o[2]]), triangle(s, g));
}

// Whether two facets meet elsewhere than in a common vertex or edge.
bool is_conflict(const Surface& s, const Facet& f, const Facet& g)
{
  const auto [a, n] = shared_first(f, g);
  const Facet b = shared_first(g, f).first;
  const auto& p = s.points;
  switch(n)
  {
    case 0: return CGAL::do_intersect(triangle(s, f), triangle(s, g));
    case 1: return opposite_edge_hits(s, f, g) || opposite_edge_hits(s, g, f);
    case 2: return CGAL::coplanar(p[a[0]], p[a[1]], p[a[2]], p[b[2]])
                   && CGAL::coplanar_orientation(p[a[0]], p[a[1]], p[a[2]], p[b[2]]) == CGAL::POSITIVE;
    default: return true;
  }
}

std::map<std::pair<std::size_t, std::size_t>, int> edges(const Surface& s)
{
  std::map<std::pair<std::size_t, std::size_t>, int> count;
  for(const Facet& f : s.facets)
    for(int i = 0; i < 3; ++i)
      ++count[std::minmax(f[i], f[(i + 1) % 3])];
  return count;
}

std::size_t number_of_lost_edges(const Surface& s)
{
  Triangulation tr;
  std::vector<Triangulation::Vertex_handle> handles;
  for(const Point_3& p : s.points)
    handles.push_back(tr.insert(p));
  assert(tr.number_of_vertices() == s.points.size());

  std::size_t lost = 0;
  for(const auto& e : edges(s))
  {
    Triangulation::Cell_handle c;
    int i, j;
    lost += ! tr.is_edge(handles[e.first.first], handles[e.first.second], c, i, j);
  }
  return lost;
}

void test(const std::string& name, const std::size_t non_manifold_edges, const std::size_t least_lost_edges)
{
  const Surface s = read(name);
  std::size_t non_manifold = 0;
  for(const auto& e : edges(s))
  {
    assert(e.second >= 2);
    non_manifold += e.second > 2;
  }
  assert(non_manifold == non_manifold_edges);

  for(const Facet& f : s.facets)
    assert(! triangle(s, f).is_degenerate());
  for(std::size_t i = 0; i < s.facets.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      assert(! is_conflict(s, s.facets[i], s.facets[j]));

  const std::size_t lost = number_of_lost_edges(s);
  std::cout << name << ": " << s.facets.size() << " facets, " << lost << " edges lost by insertion" << std::endl;
  assert(lost >= least_lost_edges);
}

void test_conflicts_are_found()
{
  const Surface s = { { {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {5, 5, 0}, {1, 1, 0}, {4, 4, 0} }, {} };
  const Facet f = { 0, 1, 2 };
  assert(is_conflict(s, f, { 3, 4, 5 }));   // proper crossing
  assert(is_conflict(s, f, { 0, 3, 4 }));   // through a common vertex
  assert(is_conflict(s, f, { 0, 1, 6 }));   // coplanar overlap along a common edge
  assert(is_conflict(s, f, { 2, 1, 0 }));   // duplicate
  assert(! is_conflict(s, f, { 1, 2, 7 })); // coplanar neighbour
  assert(! is_conflict(s, f, { 4, 5, 7 })); // far away
}

int main()
{
  test_conflicts_are_found();
  test("cube_br3.off", 0, 0);
  test("nested_cubes_br3.off", 0, 0);
  test("two_cubes_br3.off", 4, 0);
  test("schoenhardt_br3.off", 0, 1);
  test("washer_br3.off", 0, 0);
  test("gear_br3.off", 0, 10);
  test("wing_br3.off", 0, 10);
  test("store_br3.off", 0, 10);
  return EXIT_SUCCESS;
}
