// remesh_cells() on a triangulation whose vertices were moved: the triangulation is valid again, and is what the arrays
// say; regions, patches and handles are where they were.

#undef NDEBUG // the checks are assertions, also in a Release build

#include "box_soup_br3.h"
#include "hole_judge_br3.h"
#include "random_numbers_br3.h"

#include <CGAL/Boundary_recovery_3/Hole_remeshing_result_3.h>
#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/remesh_cells.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace parameters = CGAL::parameters;
typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<Kernel>::type Tr;
typedef Kernel::Point_3                                               Point;
typedef Tr::Vertex_handle                                             Vertex_handle;
typedef Tr::Cell_handle                                               Cell_handle;
typedef CGAL::Cell_remeshing_result_3<Tr>                             Result;
typedef std::array<Vertex_handle, 3>                                  Vertex_triple;

// A box with a void and a second region in it; a vertex of each region in the middle of a cell of a coarse mesh.
struct Scene
{
  Scene()
  {
    br3_test::Box_soup soup;
    soup.add_box({ {{ 0, 0, 0 }}, {{ 12, 12, 12 }} });
    soup.add_box({ {{ 2, 2, 2 }}, {{ 5, 5, 5 }} }, false);
    soup.add_box({ {{ 7, 7, 7 }}, {{ 10, 10, 10 }} });
    std::vector<Point> points;
    for(const auto& p : soup.points)
      points.emplace_back(p[0], p[1], p[2]);
    const auto recovery = CGAL::recover_boundary(tr, points, soup.triangles);
    assert(recovery);
    assert(CGAL::mark_domain(tr, recovery.facets) == 2);
    // fill it: all cells of the domain are bad
    const Result result = CGAL::remesh_cells(tr, 1., parameters::min_dihedral_angle(60.));
    assert(result && result.points.size() > 300);
    check_valid(result);
  }

  void shake(std::mt19937& rng, const double distance)
  {
    for(const Vertex_handle v : tr.finite_vertex_handles())
      if(v->in_dimension() == 3)
      {
        std::array<double, 3> p;
        for(int i = 0; i < 3; ++i)
          p[std::size_t(i)] = v->point()[i] + distance * (br3_test::random_int(rng, 2001) - 1000) / 1000.;
        v->set_point(Point(p[0], p[1], p[2]));
      }
  }

  // The triangulation is valid, and has what the result says.
  void check_valid(const Result& result) const
  {
    assert(tr.Tr::Tr_Base::is_valid()); // as a `Triangulation_3`
    assert(result.vertices.size() == tr.number_of_vertices() && result.points.size() == tr.number_of_vertices());
    assert(result.cells.size() == tr.number_of_finite_cells() && result.tetrahedra.size() == result.cells.size());
    for(std::size_t v = 0; v < result.vertices.size(); ++v)
      assert(result.vertices[v]->point() == result.points[v]);
    for(std::size_t c = 0; c < result.cells.size(); ++c)
    {
      assert(tr.tds().is_cell(result.cells[c]));
      assert(result.cells[c]->subdomain_index() == result.regions[c]);
      for(int i = 0; i < 4; ++i)
        assert(result.cells[c]->vertex(i) == result.vertices[result.tetrahedra[c][std::size_t(i)]]);
    }
    for(const Cell_handle c : tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
        assert(c->surface_patch_index(i) == tr.mirror_facet({ c, i }).first->surface_patch_index(
                                              tr.mirror_facet({ c, i }).second));
    for(const Vertex_handle v : tr.finite_vertex_handles())
      assert(v->in_dimension() >= 2 && v->in_dimension() <= 3);
  }

  std::map<Vertex_triple, int> patches() const
  {
    std::map<Vertex_triple, int> result;
    for(const auto& f : tr.finite_facets())
    {
      Vertex_triple t;
      for(int k = 0; k < 3; ++k)
        t[std::size_t(k)] = f.first->vertex((f.second + 1 + k) % 4);
      std::sort(t.begin(), t.end());
      if(f.first->is_facet_on_surface(f.second))
        result[t] = f.first->surface_patch_index(f.second);
    }
    return result;
  }

  Tr tr;
};

// It does not know the triangulations of holes, and need not: their cells are not told.
struct Visitor_of_other_cells
  : public CGAL::Default_meshing_visitor_3
{
  template <typename CellRange>
  void before_cells_removal(const CellRange& cells)
  {
    for(const int c : cells)
      m_sum += c;
  }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { before_cells_removal(cells); }

private:
  int m_sum = 0;
};

int main()
{
  std::mt19937 rng(2);
  Scene scene;
  for(const double distance : { 0.1, 0.4, 0.7, 1.2 })
  {
    scene.shake(rng, distance);
    const std::map<Vertex_triple, int> patches = scene.patches();
    std::vector<Point> points;
    std::vector<std::array<std::size_t, 4> > tetrahedra;
    std::vector<int> regions;
    std::map<Vertex_handle, std::size_t> number;
    for(const Vertex_handle v : scene.tr.finite_vertex_handles())
    {
      number[v] = points.size();
      points.push_back(v->point());
    }
    for(const Cell_handle c : scene.tr.finite_cell_handles())
    {
      tetrahedra.push_back({{ number[c->vertex(0)], number[c->vertex(1)], number[c->vertex(2)],
                              number[c->vertex(3)] }});
      regions.push_back(c->subdomain_index());
    }
    const std::vector<Vertex_handle> vertices(scene.tr.finite_vertex_handles().begin(),
                                              scene.tr.finite_vertex_handles().end());
    const std::vector<Cell_handle> cells(scene.tr.finite_cell_handles().begin(), scene.tr.finite_cell_handles().end());

    const Result stopped = CGAL::remesh_cells(
      scene.tr, parameters::maximum_running_time(0).visitor(Visitor_of_other_cells()));
    assert(stopped.status == BR3::Meshing_status::stopped && stopped.vertices == vertices && stopped.cells == cells);
    assert(scene.tr.number_of_vertices() == points.size());

    const Result result = CGAL::remesh_cells(scene.tr, parameters::number_of_layers(1));
    std::cout << distance << ": " << result << "; inverted " << result.number_of_inverted_cells << std::endl;
    std::vector<std::array<std::size_t, 3> > old_facets = result.facets;
    for(auto& f : old_facets)
      for(std::size_t& v : f)
        v = result.old_vertices[v];
    br3_test::Hole_judge<Kernel, Result> judge_of_old(points, tetrahedra, regions, old_facets, result.edges, result);
    const std::string verdict = judge_of_old.verdict();
    std::cout << verdict << std::endl;
    assert(result && verdict.empty());
    scene.check_valid(result);
    assert(scene.patches() == patches && result.facets.size() == patches.size());
    for(std::size_t v = 0; v < result.number_of_kept_vertices; ++v)
      assert(result.vertices[v] == vertices[result.old_vertices[v]]);
    for(std::size_t c = 0; c < result.number_of_kept_cells; ++c)
      assert(result.cells[c] == cells[result.old_cells[c]]);
  }
  return EXIT_SUCCESS;
}
