// Regions and marked facets that cells carry, through a whole recover_boundary() that needs Steiner points: the
// region of every cell is that of the place where it is, and the marked facets are where they were.
#undef NDEBUG

#include "mesh_validity_br3.h"
#include "steiner_inputs_br3.h"

#include <CGAL/Boundary_recovery_3/Mesh_indices_keeper_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_cell_base_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_vertex_base_3.h>
#include <CGAL/recover_boundary.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <vector>

namespace params = CGAL::parameters;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Exact_predicates_exact_constructions_kernel   Exact;
typedef CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<
          CGAL::Tetrahedral_remeshing::Remeshing_vertex_base_3<Kernel>,
          CGAL::Tetrahedral_remeshing::Remeshing_cell_base_3<Kernel> > > Triangulation;
typedef Triangulation::Vertex_handle                        Vertex_handle;
typedef Triangulation::Cell_handle                          Cell_handle;
typedef CGAL::Boundary_recovery_3::Mesh_indices_keeper_3<Triangulation> Keeper;
typedef CGAL::Boundary_recovery_3::Recovery_mode            Mode;
typedef std::array<std::size_t, 3>                          Triangle;

// Two rooms, |x| < 4000, |y|, |z| < 2000, with a wall between them at x = 0; then a polyhedron in each that no
// tetrahedra fill without a Steiner point; and points outside that make the hull larger than the rooms.
class Two_rooms
{
public:
  explicit Two_rooms(const unsigned seed)
  {
    for(const double x : { -4000., 0., 4000. })
      for(const double y : { -2000., 2000. })
        for(const double z : { -2000., 2000. })
          add_point(x, y, z);
    for(const std::size_t i : { 0, 4 }) // the four sides of each room; 2 is the step in y, 1 in z
      for(const std::array<std::size_t, 4>& q : std::vector<std::array<std::size_t, 4> >{
            {{ i, i + 1, i + 5, i + 4 }}, {{ i + 2, i + 3, i + 7, i + 6 }}, {{ i, i + 2, i + 6, i + 4 }},
            {{ i + 1, i + 3, i + 7, i + 5 }} })
        add_quad(q);
    for(const std::size_t i : { 0, 4, 8 }) // across x
      add_quad({{ i, i + 1, i + 3, i + 2 }});
    number_of_walls = triangles.size();
    for(const int room : { 0, 1 })
    {
      const br3_test::Plc prism = br3_test::twisted_prism(3, room == 0 ? .3 : .4, 1000, 1000);
      const std::size_t first = points.size();
      for(const auto& p : prism.points)
        add_point(p[0] + (room == 0 ? -2000 : 2000), p[1] + 37 * room, p[2] - 500);
      for(const auto& t : prism.triangles)
        triangles.push_back({{ first + t[0], first + t[1], first + t[2] }});
    }
    std::mt19937 random(seed);
    for(int i = 0; i < 60; ++i)
    {
      const double x = static_cast<double>(random() % 12001) - 6000, y = static_cast<double>(random() % 8001) - 4000;
      add_point(x, y, (i % 2 == 0 ? 1 : -1) * static_cast<double>(2001 + random() % 1000));
    }
  }

  // By exact numbers; 0 is that of infinite cells.
  static int region(const Cell_handle c)
  {
    std::array<Exact::Point_3, 4> p;
    for(int i = 0; i < 4; ++i)
    {
      const Kernel::Point_3& q = c->vertex(i)->point();
      p[i] = Exact::Point_3(q.x(), q.y(), q.z());
    }
    const Exact::Point_3 q = CGAL::centroid(p[0], p[1], p[2], p[3]);
    if(CGAL::abs(q.x()) > 4000 || CGAL::abs(q.y()) > 2000 || CGAL::abs(q.z()) > 2000)
      return 3;
    return q.x() < 0 ? 1 : 2;
  }

  std::vector<Kernel::Point_3> points;
  std::vector<Triangle> triangles;
  std::size_t number_of_walls = 0; // these come first

private:
  void add_point(const double x, const double y, const double z) { points.emplace_back(x, y, z); }

  void add_quad(const std::array<std::size_t, 4>& q)
  {
    triangles.push_back({{ q[0], q[1], q[2] }});
    triangles.push_back({{ q[0], q[2], q[3] }});
  }
};

// The marks of facets, by their sorted vertices; each wall has its own.
typedef std::map<std::array<Vertex_handle, 3>, int> Marks;

std::array<Vertex_handle, 3> sorted(std::array<Vertex_handle, 3> f)
{
  std::sort(f.begin(), f.end());
  return f;
}

template <typename Result>
Marks mark_walls(Triangulation& tr, const Two_rooms& rooms, const Result& result)
{
  Marks marks;
  for(std::size_t f = 0; f < rooms.number_of_walls; ++f)
  {
    Cell_handle c;
    int i, j, k;
    assert(tr.is_facet(result.facets[f][0], result.facets[f][1], result.facets[f][2], c, i, j, k));
    const int l = 6 - i - j - k, mark = 10 + static_cast<int>(f);
    c->neighbor(l)->set_surface_patch_index(tr.mirror_index(c, l), mark);
    c->set_surface_patch_index(l, mark);
    marks[sorted(result.facets[f])] = mark;
  }
  return marks;
}

void check(const Triangulation& tr, const Marks& marks)
{
  std::map<int, std::size_t> cells_of_region;
  std::size_t number_of_marked_sides = 0;
  for(const Cell_handle c : tr.all_cell_handles())
  {
    assert(c->subdomain_index() == (tr.is_infinite(c) ? 0 : Two_rooms::region(c)));
    ++cells_of_region[c->subdomain_index()];
    for(int i = 0; i < 4; ++i)
    {
      const auto it = marks.find(sorted({{ c->vertex((i + 1) & 3), c->vertex((i + 2) & 3), c->vertex((i + 3) & 3) }}));
      assert(c->surface_patch_index(i) == (it == marks.end() ? 0 : it->second));
      number_of_marked_sides += it == marks.end() ? 0 : 1;
    }
  }
  assert(cells_of_region.size() == 4 && number_of_marked_sides == 2 * marks.size());
}

void test(const unsigned seed, const Mode mode)
{
  const Two_rooms rooms(seed);
  Triangulation tr;
  const std::vector<Triangle> walls(rooms.triangles.begin(),
                                    rooms.triangles.begin() + static_cast<std::ptrdiff_t>(rooms.number_of_walls));
  const auto before = CGAL::recover_boundary(tr, rooms.points, walls);
  assert(before && before.steiner_vertices.empty());
  for(const Cell_handle c : tr.finite_cell_handles())
    c->set_subdomain_index(Two_rooms::region(c));
  const Marks marks = mark_walls(tr, rooms, before);
  check(tr, marks);

  Keeper keeper(tr);
  const auto result = CGAL::recover_boundary(tr, rooms.points, rooms.triangles, params::recovery_mode(mode),
                                             params::visitor(std::ref(keeper)));
  assert(result && result.steiner_vertices.size() >= 2);
  std::cout << result.steiner_vertices.size() << " Steiner points, " << result.number_of_shell_transformations
            << " transformations" << std::endl;
  check(tr, marks);
  assert(keeper.number_of_ambiguous_cells() == 0);
  assert(mode == Mode::conforming || br3_test::is_valid_mesh(tr));
}

int main()
{
  for(unsigned seed = 0; seed < 8; ++seed)
    for(const Mode mode : { Mode::constrained, Mode::conforming })
      test(seed, mode);
  return EXIT_SUCCESS;
}
