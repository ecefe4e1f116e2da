// What is written of a domain: MEDIT's files, read back here, with each triangle once, its patch and its orientation,
// and coordinates bit for bit; and the nodes of second order.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "grid_scene_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Medit_writer.h>
#include <CGAL/Boundary_recovery_3/number_edge_nodes.h>
#include <CGAL/Boundary_recovery_3/write_domain_MEDIT.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/File_medit.h> // whose function has another name
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/mark_domain.h>
#include <CGAL/tetrahedral_remeshing.h> // has what CGAL 5.5 needs to read MEDIT files

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel            K;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type       Triangulation;
typedef CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>      Remeshing_triangulation;
typedef Triangulation::Vertex_handle                                   Vertex_handle;
typedef CGAL::Boundary_recovery_result_3<Triangulation>                Recovery;
typedef br3_test::Grid_scene<Triangulation>                            Scene;
namespace BR3 = CGAL::Boundary_recovery_3;

// What a file has: numbers from 0.
struct File
{
  std::vector<K::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::vector<std::array<std::size_t, 4> > tetrahedra;
  std::vector<int> patches, regions;
};

template <std::size_t N>
void read_simplices(std::istream& is, const std::string& keyword, std::vector<std::array<std::size_t, N> >& simplices,
                    std::vector<int>& references)
{
  std::string word;
  std::size_t n = 0;
  assert(is >> word >> n && word == keyword);
  simplices.resize(n);
  references.resize(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    for(std::size_t& v : simplices[i])
    {
      is >> v;
      --v;
    }
    assert(is >> references[i]);
  }
}

File read_file(const std::string& text)
{
  std::istringstream is(text);
  File file;
  std::string word, version, dimension;
  std::size_t n = 0;
  assert(is >> word >> version && word == "MeshVersionFormatted" && version == "2");
  assert(is >> word >> dimension && word == "Dimension" && dimension == "3");
  assert(is >> word >> n && word == "Vertices");
  for(std::size_t i = 0; i < n; ++i)
  {
    double x = 0, y = 0, z = 0;
    int reference = 0;
    assert(is >> x >> y >> z >> reference);
    file.points.push_back(K::Point_3(x, y, z));
  }
  read_simplices(is, "Triangles", file.triangles, file.patches);
  read_simplices(is, "Tetrahedra", file.tetrahedra, file.regions);
  assert(is >> word && word == "End" && ! (is >> word));
  return file;
}

template <typename Tr>
File written(const Tr& tr, const CGAL::Boundary_recovery_result_3<Tr>& recovery = { })
{
  std::ostringstream os;
  os.precision(3);
  os << std::fixed;
  assert(CGAL::IO::write_domain_MEDIT(os, tr, recovery));
  assert(os.precision() == 3 && (os.flags() & std::ios_base::fixed) != 0);
  return read_file(os.str());
}

std::array<K::Point_3, 3> corners(const File& file, const std::size_t i)
{
  const auto& t = file.triangles[i];
  return {{ file.points[t[0]], file.points[t[1]], file.points[t[2]] }};
}

// begins with the smallest corner, so that triangles are equal iff their orientations are, too
std::array<K::Point_3, 3> turned(std::array<K::Point_3, 3> t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// Two boxes with a wall between them, a sheet in one, and a triangle that bounds nothing.
struct Domain_scene
  : public Scene
{
  std::size_t number_of_outer_facets = 0;

  Domain_scene() : Scene(5)
  {
    add_box({{ 1, 1, 1 }}, {{ 2, 4, 4 }}, true);
    add_box({{ 2, 1, 1 }}, {{ 4, 4, 4 }}, true);
    std::set<std::set<K::Point_3> > known; // the wall is there twice
    std::vector<Triple> once;
    for(const Triple& f : facets)
      if(known.insert({ f[0]->point(), f[1]->point(), f[2]->point() }).second)
        once.push_back(f);
    facets = once;
    number_of_outer_facets = facets.size();
    add_rectangle(2, {{ 3, 2, 2 }}, {{ 4, 3, 2 }}, true);
    const std::size_t n = facets.size();
    add_rectangle(2, {{ 0, 0, 5 }}, {{ 1, 1, 5 }}, true); // on the convex hull
    assert(n == number_of_outer_facets + 2 && facets.size() == n + 2);
  }
};

void check_domain(const Domain_scene& scene, const File& file)
{
  const std::size_t n = scene.facets.size();
  assert(file.triangles.size() == n);
  std::array<double, 3> volumes = {{ 0, 0, 0 }};
  for(std::size_t i = 0; i < file.tetrahedra.size(); ++i)
  {
    const auto& t = file.tetrahedra[i];
    const double volume = CGAL::volume(file.points[t[0]], file.points[t[1]], file.points[t[2]], file.points[t[3]]);
    assert(volume > 0 && (file.regions[i] == 1 || file.regions[i] == 2));
    volumes[file.regions[i]] += 6 * volume;
  }
  assert(volumes[1] == 6 * 9 && volumes[2] == 6 * 18);
  std::set<K::Point_3> points(file.points.begin(), file.points.end());
  assert(points.size() == file.points.size());
  assert(points.size() == 4 * 4 * 4 + 4); // no others of the 6 * 6 * 6 points
}

void test_marked_domain(Domain_scene& scene)
{
  Triangulation& tr = scene.tr;
  assert(CGAL::mark_domain(tr, scene.facets) == 2);
  const std::size_t n = scene.facets.size();
  const File file = written(tr);
  check_domain(scene, file);
  for(std::size_t i = 0; i < n; ++i) // in the order of the patches
  {
    assert(file.patches[i] == int(i) + 1);
    const auto& f = scene.facets[i];
    const auto expected = turned({{ f[0]->point(), f[1]->point(), f[2]->point() }});
    const auto reversed = turned({{ f[0]->point(), f[2]->point(), f[1]->point() }});
    const auto found = turned(corners(file, i));
    const bool is_wall = f[0]->point().x() == 2 && f[1]->point().x() == 2 && f[2]->point().x() == 2;
    if(i < scene.number_of_outer_facets && ! is_wall) // outward
      assert(found == expected);
    else if(is_wall) // it was turned outward from region 1, and is from region 2
      assert(found == reversed);
    else
      assert(found == expected || found == reversed);
  }

  // the order of the input
  Recovery recovery;
  recovery.status = BR3::Recovery_status::recovered;
  std::vector<Vertex_handle> vertices(tr.finite_vertex_handles().begin(), tr.finite_vertex_handles().end());
  std::reverse(vertices.begin(), vertices.end());
  recovery.vertices = vertices;
  recovery.facets.assign(scene.facets.rbegin(), scene.facets.rend());
  const File ordered = written(tr, recovery);
  check_domain(scene, ordered);
  std::size_t next = 0;
  for(const Vertex_handle v : vertices)
    next += next < ordered.points.size() && ordered.points[next] == v->point();
  assert(next == ordered.points.size());
  for(std::size_t i = 0; i < n; ++i)
  {
    const auto& f = scene.facets[n - 1 - i];
    assert(corners(ordered, i) == (std::array<K::Point_3, 3>{{ f[0]->point(), f[1]->point(), f[2]->point() }}));
    assert(ordered.patches[i] == int(n - i));
  }
}

void test_patches(Domain_scene& scene)
{
  std::vector<int> patches;
  for(std::size_t i = 0; i < scene.facets.size(); ++i)
    patches.push_back(i % 3 == 0 ? 100 : 7);
  CGAL::mark_domain(scene.tr, scene.facets, CGAL::parameters::face_patch_map(CGAL::make_property_map(patches)));
  const File file = written(scene.tr);
  check_domain(scene, file);
  assert(std::is_sorted(file.patches.begin(), file.patches.end()));
  std::sort(patches.begin(), patches.end());
  assert(file.patches == patches);
}

// CGAL's own reader finds the triangles and the tetrahedra.
void test_reader_of_CGAL(Domain_scene& scene)
{
  CGAL::mark_domain(scene.tr, scene.facets);
  std::stringstream stream;
  assert(CGAL::IO::write_domain_MEDIT(stream, scene.tr));
  const File file = read_file(stream.str());
  Remeshing_triangulation tr;
  assert(CGAL::IO::read_MEDIT(stream, tr));
  std::vector<int> patches, regions;
  for(const auto c : tr.finite_cell_handles())
    if(c->subdomain_index() != 0)
      regions.push_back(c->subdomain_index());
  for(const auto& f : tr.finite_facets())
    if(f.first->surface_patch_index(f.second) != 0)
      patches.push_back(f.first->surface_patch_index(f.second));
  std::sort(patches.begin(), patches.end());
  std::sort(regions.begin(), regions.end());
  assert(regions.size() == file.regions.size());
  assert(std::count(regions.begin(), regions.end(), 1) == std::count(file.regions.begin(), file.regions.end(), 1));
  const std::size_t in_mesh = scene.facets.size() - 2; // it wants facets of cells
  assert(patches.size() == in_mesh && std::equal(patches.begin(), patches.end(), file.patches.begin()));
}

// Regions that only their cells tell of: the file has all points of these cells, and no others.
void test_regions_without_patches()
{
  Triangulation tr;
  for(int i = 0; i < 60; ++i)
    tr.insert(K::Point_3(i * 37 % 61, i * i % 59, i * 17 % 53));
  for(const Vertex_handle v : tr.finite_vertex_handles())
  {
    std::vector<Triangulation::Cell_handle> cells;
    tr.finite_incident_cells(v, std::back_inserter(cells));
    std::set<K::Point_3> points;
    for(const auto c : cells)
    {
      c->set_subdomain_index(2);
      for(int i = 0; i < 4; ++i)
        points.insert(c->vertex(i)->point());
    }
    const File file = written(tr);
    assert(file.triangles.empty() && file.regions == std::vector<int>(cells.size(), 2));
    assert(file.points.size() == points.size());
    assert(std::set<K::Point_3>(file.points.begin(), file.points.end()) == points);
    for(const auto& t : file.tetrahedra)
      assert(CGAL::orientation(file.points[t[0]], file.points[t[1]], file.points[t[2]], file.points[t[3]]) ==
             CGAL::POSITIVE);
    for(const auto c : cells)
      c->set_subdomain_index(0);
  }
}

void test_coordinates()
{
  const std::vector<K::Point_3> points = { { 0.1, 1. / 3, -2e-17 }, { 1e17 / 9, 0, 5e-324 }, { 0, 1e5 / 7, 1 },
                                           { 1. / 7, 2. / 7, 1e10 / 3 } };
  Triangulation tr(points.begin(), points.end());
  std::vector<std::array<Vertex_handle, 3> > facets;
  for(const auto& f : tr.finite_facets())
    facets.push_back({{ f.first->vertex(Triangulation::vertex_triple_index(f.second, 0)),
                        f.first->vertex(Triangulation::vertex_triple_index(f.second, 1)),
                        f.first->vertex(Triangulation::vertex_triple_index(f.second, 2)) }});
  CGAL::mark_domain(tr, facets);
  const std::string name = "test_domain_files_br3.mesh";
  assert(CGAL::IO::write_domain_MEDIT(name, tr));
  std::ifstream is(name);
  std::stringstream content;
  content << is.rdbuf();
  const File file = read_file(content.str());
  assert(std::set<K::Point_3>(file.points.begin(), file.points.end()) ==
         std::set<K::Point_3>(points.begin(), points.end()));
  assert(file.tetrahedra.size() == 1 && file.triangles.size() == 4);
  assert(! CGAL::IO::write_domain_MEDIT("no such folder/a.mesh", tr));

  const Triangulation empty;
  const File nothing = written(empty);
  assert(nothing.points.empty() && nothing.triangles.empty() && nothing.tetrahedra.empty());
}

// Exact constructions are rounded.
void test_exact_kernel()
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel                EK;
  typedef CGAL::Boundary_constrained_mesh_triangulation_3<EK>::type        Exact_triangulation;
  Exact_triangulation tr;
  std::vector<std::array<Exact_triangulation::Vertex_handle, 3> > facets;
  const EK::FT third = EK::FT(1) / EK::FT(3);
  for(const EK::Point_3& p : { EK::Point_3(0, 0, 0), EK::Point_3(1, 0, 0), EK::Point_3(0, 1, 0),
                               EK::Point_3(third, third, 1) })
    tr.insert(p);
  for(const auto& f : tr.finite_facets())
    facets.push_back({{ f.first->vertex((f.second + 1) % 4), f.first->vertex((f.second + 2) % 4),
                        f.first->vertex((f.second + 3) % 4) }});
  CGAL::mark_domain(tr, facets);
  const File file = written(tr);
  assert(file.tetrahedra.size() == 1 && file.triangles.size() == 4);
  assert(std::count_if(file.points.begin(), file.points.end(), [](const K::Point_3& p)
                       { return CGAL::squared_distance(p, K::Point_3(1. / 3, 1. / 3, 1)) < 1e-30; }) == 1);
}

void test_edge_nodes()
{
  const std::vector<std::array<std::uint32_t, 4> > tetrahedra = { {{ 4, 2, 1, 0 }}, {{ 1, 2, 4, 7 }} };
  const std::vector<std::array<std::uint32_t, 3> > triangles = { {{ 4, 1, 2 }}, {{ 9, 8, 4 }} };
  const auto nodes = BR3::number_edge_nodes(tetrahedra, triangles);
  typedef std::vector<std::array<std::uint32_t, 2> > Edges;
  const Edges expected = { {{ 1, 2 }}, {{ 1, 4 }}, {{ 2, 4 }}, {{ 4, 8 }}, {{ 4, 9 }}, {{ 8, 9 }}, // of triangles
                           {{ 0, 1 }}, {{ 0, 2 }}, {{ 0, 4 }}, {{ 1, 7 }}, {{ 2, 7 }}, {{ 4, 7 }} };
  assert(nodes.edges == expected);
  assert((nodes.tetrahedra[0] == std::array<std::uint32_t, 6>{{ 2, 0, 1, 8, 7, 6 }}));
  assert((nodes.tetrahedra[1] == std::array<std::uint32_t, 6>{{ 0, 2, 1, 9, 10, 11 }}));
  assert((nodes.triangles[0] == std::array<std::uint32_t, 3>{{ 1, 0, 2 }}));
  assert((nodes.triangles[1] == std::array<std::uint32_t, 3>{{ 5, 3, 4 }}));

  const auto none = BR3::number_edge_nodes(std::vector<std::array<int, 4> >(), std::vector<std::array<int, 3> >());
  assert(none.edges.empty() && none.tetrahedra.empty() && none.triangles.empty());
}

// of a whole mesh: each edge once, whatever the order of the simplices is
void test_edge_nodes_of_mesh(const Scene& scene)
{
  File file = written(scene.tr);
  const auto nodes = BR3::number_edge_nodes(file.tetrahedra, file.triangles);
  typedef std::array<std::size_t, 2> Edge;
  std::set<Edge> edges;
  for(const auto& t : file.tetrahedra)
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = 0; j < 4; ++j)
        if(t[i] < t[j])
          edges.insert(Edge{{ t[i], t[j] }});
  std::size_t number_of_others = 0; // edges of triangles that bound nothing
  for(const auto& t : file.triangles)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t u = t[i], v = t[(i + 1) % 3];
      number_of_others += edges.insert(Edge{{ (std::min)(u, v), (std::max)(u, v) }}).second;
    }
  assert(number_of_others == 5);
  assert(nodes.edges.size() == edges.size());
  assert(std::all_of(nodes.edges.begin(), nodes.edges.end(), [&](const auto& e) { return edges.count(e) == 1; }));
  std::reverse(file.tetrahedra.begin(), file.tetrahedra.end());
  std::reverse(file.triangles.begin(), file.triangles.end());
  const auto reversed = BR3::number_edge_nodes(file.tetrahedra, file.triangles);
  assert(reversed.edges == nodes.edges);
  assert(std::equal(reversed.tetrahedra.begin(), reversed.tetrahedra.end(), nodes.tetrahedra.rbegin()));
  assert(std::equal(reversed.triangles.begin(), reversed.triangles.end(), nodes.triangles.rbegin()));
}

int main()
{
  Domain_scene scene;
  test_marked_domain(scene);
  test_reader_of_CGAL(scene);
  test_patches(scene);
  test_edge_nodes_of_mesh(scene);
  test_regions_without_patches();
  test_coordinates();
  test_exact_kernel();
  test_edge_nodes();
  std::cout << "OK" << std::endl;
}
