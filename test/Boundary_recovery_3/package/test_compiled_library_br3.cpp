// What is compiled once, in Boundary_recovery_3::compiled, does what the headers do. This program is linked to it, by
// way of oracles_br3, where there is one.

#include <CGAL/Boundary_constrained_mesh_triangulation_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/standard_types.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/improve_mesh_quality.h>
#include <CGAL/insert_field_points.h>
#include <CGAL/make_boundary_constrained_mesh_3.h>
#include <CGAL/mark_domain.h>
#include <CGAL/recover_boundary.h>
#include <CGAL/remesh_holes.h>
#include <CGAL/tags.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <type_traits>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           K;
typedef K::Point_3                                                    Point_3;
typedef CGAL::Delaunay_triangulation_3<K>                             Delaunay;
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K>::type      Mesh;
typedef std::vector<std::array<std::size_t, 3> >                      Triangles;

namespace params = CGAL::parameters;

// Of another type, so that all of it is compiled here; its containers are the same.
typedef CGAL::Boundary_constrained_mesh_triangulation_3<K, CGAL::Parallel_tag>::type Other_mesh;

const std::vector<Point_3> points = {
  { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
const Triangles triangles = {
  {{ 0, 2, 1 }}, {{ 0, 3, 2 }}, {{ 4, 5, 6 }}, {{ 4, 6, 7 }}, {{ 0, 1, 5 }}, {{ 0, 5, 4 }},
  {{ 1, 2, 6 }}, {{ 1, 6, 5 }}, {{ 2, 3, 7 }}, {{ 2, 7, 6 }}, {{ 3, 0, 4 }}, {{ 3, 4, 7 }} };

// Their points, in their order.
template <typename Tr>
std::vector<Point_3> points_of(const Tr& tr)
{
  std::vector<Point_3> result;
  for(const auto v : tr.finite_vertex_handles())
    result.push_back(v->point());
  return result;
}

template <typename Tr>
std::vector<Point_3> mesh(const std::size_t number_of_subdomains)
{
  Tr tr;
  const auto result = CGAL::make_boundary_constrained_mesh_3(tr, points, triangles, 0.25,
                                                             params::number_of_subdomains(number_of_subdomains));
  assert(result && tr.tds().is_valid() && result.number_of_regions == 1);
  assert(result.filling.number_of_field_points > 20);
  return points_of(tr);
}

// Step by step.
template <typename Tr>
std::vector<Point_3> mesh_by_steps()
{
  Tr tr;
  const auto recovery = CGAL::recover_boundary(tr, points, triangles);
  assert(recovery);
  assert(CGAL::mark_domain(tr, recovery.facets) == 1);
  assert(CGAL::insert_field_points(tr, 0.3));
  assert(CGAL::improve_mesh_quality(tr));
  return points_of(tr);
}

void test_recovery_in_delaunay_triangulation()
{
  Delaunay tr;
  const auto result = CGAL::recover_boundary(tr, points, triangles);
  std::cout << result << std::endl;
  assert(result && result.number_of_facets == triangles.size());
  assert(tr.number_of_vertices() == points.size() + result.steiner_vertices.size());
}

void test_holes()
{
  const std::vector<Point_3> moved = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .3, .3, .001 } };
  const std::vector<std::array<std::size_t, 4> > tetrahedra = {
    {{ 0, 1, 2, 4 }}, {{ 0, 2, 3, 4 }}, {{ 0, 3, 1, 4 }}, {{ 1, 3, 2, 4 }} };
  const auto result = CGAL::remesh_holes(moved, tetrahedra);
  assert(result && result.number_of_holes == 1);
}

int main()
{
#ifdef CGAL_BOUNDARY_RECOVERY_3_COMPILED
  namespace internal = CGAL::Boundary_recovery_3::internal;
  static_assert(std::is_same<internal::Standard_kernel, K>::value, "the kernel in the library");
  static_assert(std::is_same<internal::Standard_delaunay, Delaunay>::value, "the triangulations in the library");
  static_assert(std::is_same<internal::Standard_mesh, Mesh>::value, "the triangulations in the library");
  std::cout << "with the compiled library\n";
#else
  std::cout << "with the headers alone\n";
#endif
  assert(mesh<Mesh>(1) == mesh<Other_mesh>(1));
  assert(mesh<Mesh>(2) == mesh<Other_mesh>(2));
  assert(mesh_by_steps<Mesh>() == mesh_by_steps<Other_mesh>());
  test_recovery_in_delaunay_triangulation();
  test_holes();
  std::cout << "done\n";
}
