// What others get: CGAL's remeshing keeps each triangle, sheets and isolated edges; complexes and files have what they
// should, from our triangulation as it is and from its copy.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "grid_scene_br3.h"
#include "mesh_validity_br3.h"

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/Constrained_edge_map_3.h>
#include <CGAL/Boundary_recovery_3/convert_to_remeshing_triangulation.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/File_medit.h>
#include <CGAL/IO/output_to_vtu.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/mark_domain.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel            K;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type       Triangulation;
typedef CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>      Remeshing_triangulation;
typedef Triangulation::Vertex_handle                                   Vertex_handle;
typedef std::array<Vertex_handle, 2>                                   Vertex_pair;
typedef br3_test::Grid_scene<Triangulation>                            Scene;
namespace BR3 = CGAL::Boundary_recovery_3;

// The triangles and edges that are facets and edges between the points where they were, in a mesh that was changed.
struct Constraint_positions
{
  Constraint_positions(const Scene& scene, const Vertex_pair& edge)
    : edge{{ edge[0]->point(), edge[1]->point() }}
  {
    for(const Scene::Triple& f : scene.facets)
      triangles.push_back({{ f[0]->point(), f[1]->point(), f[2]->point() }});
  }

  template <typename Tr>
  bool are_all_in(const Tr& tr) const
  {
    std::map<K::Point_3, typename Tr::Vertex_handle> vertex;
    for(const auto v : tr.finite_vertex_handles())
      vertex[v->point()] = v;
    typename Tr::Cell_handle c;
    int i, j, k;
    const auto there = [&](const K::Point_3& p) { return vertex.count(p) != 0; };
    for(const auto& t : triangles)
      if(! there(t[0]) || ! there(t[1]) || ! there(t[2])
         || ! tr.is_facet(vertex[t[0]], vertex[t[1]], vertex[t[2]], c, i, j, k))
        return false;
    return there(edge[0]) && there(edge[1]) && tr.is_edge(vertex[edge[0]], vertex[edge[1]], c, i, j);
  }

  std::vector<std::array<K::Point_3, 3> > triangles;
  std::array<K::Point_3, 2> edge;
};

// The volume of a region; sums are rounded.
template <typename Tr>
double volume(const Tr& tr, const int region)
{
  double sum = 0;
  for(const auto c : tr.finite_cell_handles())
    if(c->subdomain_index() == region)
      sum += tr.tetrahedron(c).volume();
  return sum;
}

// A copy has the same cells in the same order, and the same indices.
void test_copy(const Triangulation& tr, const Remeshing_triangulation& copy)
{
  assert(copy.is_valid() && copy.dimension() == 3);
  assert(copy.number_of_vertices() == tr.number_of_vertices());
  assert(copy.tds().number_of_cells() == tr.tds().number_of_cells());
  auto d = copy.all_cells_begin();
  for(const auto c : tr.all_cell_handles())
  {
    assert(c->subdomain_index() == d->subdomain_index());
    for(int i = 0; i < 4; ++i)
    {
      assert(c->surface_patch_index(i) == d->surface_patch_index(i));
      assert(tr.is_infinite(c->vertex(i)) == copy.is_infinite(d->vertex(i)));
      if(! tr.is_infinite(c->vertex(i)))
      {
        assert(c->vertex(i)->point() == d->vertex(i)->point());
        assert(c->vertex(i)->in_dimension() == d->vertex(i)->in_dimension());
      }
    }
    ++d;
  }
}

template <typename Tr>
void test_complex(const Tr& tr, const std::size_t number_of_triangles)
{
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr, int, int> Complex;
  std::size_t number_of_cells = 0;
  for(const auto c : tr.finite_cell_handles())
    number_of_cells += c->subdomain_index() != 0;
  Complex complex;
  complex.triangulation() = tr;
  complex.rescan_after_load_of_triangulation();
  assert(complex.number_of_cells_in_complex() == number_of_cells);
  assert(complex.number_of_facets_in_complex() == number_of_triangles);

  std::ostringstream vtu;
  CGAL::IO::output_to_vtu(vtu, complex, CGAL::IO::ASCII);
  assert(vtu.str().find("NumberOfCells=\"" + std::to_string(number_of_cells) + "\"") != std::string::npos);

  std::ostringstream medit;
  CGAL::IO::write_MEDIT(medit, tr);
  std::istringstream words(medit.str());
  std::size_t triangles = 0, tetrahedra = 0;
  for(std::string word; words >> word; )
    if(word == "Triangles")
      words >> triangles;
    else if(word == "Tetrahedra")
      words >> tetrahedra;
  assert(triangles == number_of_triangles || triangles == 2 * number_of_triangles); // CGAL 5.5 writes both sides
  assert(tetrahedra == number_of_cells);
}

void test_edge_map(const std::vector<Vertex_handle>& v)
{
  typedef BR3::Constrained_edge_map_3<Triangulation> Map;
  const Map none, map(std::vector<std::array<Vertex_handle, 2> >{ {{ v[0], v[1] }}, {{ v[2], v[1] }} });
  const Map same = map;
  const auto edge = [&](const int i, const int j) { return std::make_pair(v[i], v[j]); };
  assert(get(map, edge(0, 1)) && get(map, edge(1, 0)) && get(map, edge(1, 2)));
  assert(! get(map, edge(0, 2)) && ! get(none, edge(0, 1)));
  put(map, edge(2, 0), true);
  put(map, edge(1, 0), false);
  assert(get(same, edge(0, 2)) && ! get(same, edge(0, 1)) && get(same, edge(2, 1)));
}

// The first edge inside of the second box that has no vertex on a facet.
Vertex_pair edge_inside(const Triangulation& tr)
{
  const auto is_inside = [](const Vertex_handle v)
  {
    const K::Point_3& p = v->point();
    return p.x() > 2 && p.x() < 5 && p.y() > 0 && p.y() < 5 && p.z() > 0 && p.z() < 5;
  };
  for(const auto& e : tr.finite_edges())
  {
    const Vertex_handle u = e.first->vertex(e.second), v = e.first->vertex(e.third);
    if(is_inside(u) && is_inside(v))
      return {{ u, v }};
  }
  return { };
}

int main()
{
  Scene scene(5); // two boxes with a wall between them, a sheet in one, and an isolated edge in the other
  scene.add_box({{ 0, 0, 0 }}, {{ 2, 5, 5 }}, true);
  const std::size_t number_of_left_facets = scene.facets.size();
  scene.add_box({{ 2, 0, 0 }}, {{ 5, 5, 5 }}, true);
  scene.facets.erase(std::remove_if(scene.facets.begin() + number_of_left_facets, scene.facets.end(),
    [](const auto& f) { return f[0]->point().x() == 2 && f[1]->point().x() == 2 && f[2]->point().x() == 2; }),
    scene.facets.end());
  scene.add_rectangle(2, {{ 1, 1, 2 }}, {{ 2, 4, 2 }}, true);
  const std::size_t n = scene.facets.size();
  const Vertex_pair edge = edge_inside(scene.tr);
  const std::vector<Vertex_pair> edges = { edge };
  const Constraint_positions constraints(scene, edge);

  Triangulation& tr = scene.tr;
  assert(CGAL::mark_domain(tr, scene.facets, CGAL::parameters::constrained_edges(edges)) == 2);
  assert(std::abs(volume(tr, 1) - 50) < 1e-9 && std::abs(volume(tr, 2) - 75) < 1e-9);
  test_complex(tr, n);
  test_edge_map({ scene.facets[0][0], scene.facets[0][1], scene.facets[0][2] });

  // the remeshing wants longer edges, and takes away what is not constrained
  Remeshing_triangulation remeshed;
  const auto map = BR3::convert_to_remeshing_triangulation(tr, remeshed, edges);
  test_copy(tr, remeshed);
  CGAL::tetrahedral_isotropic_remeshing(
    remeshed, 3., CGAL::parameters::remesh_boundaries(false).edge_is_constrained_map(map));
  assert(remeshed.number_of_vertices() < tr.number_of_vertices());
  assert(br3_test::is_valid_mesh(remeshed));
  assert(constraints.are_all_in(remeshed));
  assert(std::abs(volume(remeshed, 1) - 50) < 1e-9 && std::abs(volume(remeshed, 2) - 75) < 1e-9);
  test_complex(remeshed, n);

  // without the copy, too
  CGAL::tetrahedral_isotropic_remeshing(
    tr, 3., CGAL::parameters::remesh_boundaries(false)
              .edge_is_constrained_map(BR3::Constrained_edge_map_3<Triangulation>(edges)));
  assert(br3_test::is_valid_mesh(tr));
  assert(constraints.are_all_in(tr));
  std::cout << "the mesh was handed over" << std::endl;
}
